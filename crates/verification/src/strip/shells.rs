//! C14: the strip of layered shells through an earthquake, beside the strip of fibres.
//!
//! Source:    dissertation 8.4: liner, normal-only layer, reinforced concrete, liquid between two walls
//! Model:     24 elements up the wall, one across; liner 6 mm and concrete 30 cm as shells, the layer between their faces; the liquid
//!            condensed onto the liner; two seconds of swelling sines, trapezoidal rule in 2.5 ms, wall 5 %, sloshing 0.5 %
//! Reference: the same tank of fibre beams under the same motion: other elements, other sections, a liquid on cubic deflections
//! Tolerance: set before the runs, but for three that were changed after the first: the reference of the moment at rest (less the weight of
//!            half the layer on both faces, 0.6 %, which the first left out), the first opening of the joint (now shown) and, in the test
//!            of the engine beside these rows, the moment at rest (1 %, for the same weight). Stiff in shear both are Bernoulli beams: 1 %, for linear deflections between 24 levels (1/24)² = 0.2 %
//!            and the liner's own 4e-5 of the stiffness. Shells as they are give way in shear: 1.5 % of the deflection at rest (C13), 0.7 % of
//!            the frequency (1 % asked), and at resonance at most δω/(2 ξ ω) = 7 %. The wave hardly feels the wall: 0.5 %.
//!            Walls that crack: at rest and until the first crack as above; beyond it shown, since cracks of shells and beams localise
//!            in other lengths (four Gauss points of an element with one curvature, two of a beam with a linear one) and a threshold
//!            is passed once more or less.
//!            First opening of the joint: within two steps of 2.5 ms. After the first impacts values are shown, not held: shears
//!            differ by up to 14 % at 0.9 g, which is not explained

use std::sync::Arc;

use materials::bar::Bar as BarLaw;
use materials::concrete::{CrackedConcrete, CrackedParameters, Tension};
use oscillator::record::Record;

use super::section::reinforced;
use super::{ATTACHED, CONCRETE, DEPTH, G, THICKNESS, elastic_section, law_error, tank};
use crate::solid::macro_wall::StiffShear;
use crate::{Answer, Benchmark, Failure, Part, Reference, Row};
use engines::strip::{
    Contact, Scalar, ShellRow, ShellWall, Side, StripDamping, StripModel, StripQuake, StripTank, WallHistory,
};
use fem::analysis::newton::Options as Newton;
use fem::analysis::scheme::TimeScheme;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::Options;
use fem::element::shell::layered::{Bar, LayeredSection, Ply};
use fem::element::shell::rule::Rule;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::solid8::{Elastic, Kinematics};
use fem::element::wall::place::{Build, Leaf};
use fem::element::wall::{Layer, LayerMass};
use fem::progress::Silent;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-shells",
    title: "Strip 8.4 of layered shells, in time",
    model: "Liner, normal-only layer and concrete as layered shells with the layer between their faces, the liquid condensed onto the \
            liner, beside the strip of fibres: at rest, through two seconds of swelling sines, with cracks. With contact that \
            opens the first opening is held, what follows the impacts is shown.",
    ids: &[("C14", "history of the strip of shells, beside the strip of fibres")],
    parts: &[Part::Tested(rows), Part::Record(recorded)],
};

/// Wet elements; the dry ones are a fifth of them.
const WET: usize = 20;
/// E [Pa], ν, thickness [m], density [kg/m³] of the concrete.
const WALL: [f64; 4] = [34e9, 0.2, THICKNESS, CONCRETE];
const LINER: [f64; 4] = [210e9, 0.3, 0.006, 8000.0];
/// E [Pa], thickness [m], density [kg/m³] of the layer.
const LAYER: [f64; 3] = [3e9, 0.05, 1500.0];
/// E_f of the concrete that cracks, and its layers.
const SOFTENING: f64 = 3e-4;
const LAYERS: usize = 20;
const DAMPING: StripDamping = StripDamping::ByGroup { wall: 0.05, sloshing: 0.005 };

/// The wall of concrete.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Wall {
    /// Elastic; with shear that gives way, or a hundred times stiffer.
    Elastic { stiff: bool },
    /// Cracking, with bars.
    Cracking,
}

fn elastic([e, nu, t, density]: [f64; 4], stiff: bool) -> Result<Leaf, Failure> {
    let section = ElasticSection::new(e, nu, t, density)?;
    let section: Arc<dyn Section> = if stiff { Arc::new(StiffShear::new(section, 100.0)) } else { Arc::new(section) };
    Ok(Leaf { section, face: 0.5 * t })
}

/// Cracking concrete in `layers` that softens over the strain `softening`, with 7 cm²/m up the wall at each face.
fn cracking(layers: usize, softening: f64) -> Result<Leaf, Failure> {
    let [young, nu, thickness, density] = WALL;
    let tension =
        Tension { strength: 3.5e6, softening: super::section::softening(softening), stiffening: None, bond: None };
    let law = CrackedConcrete::new(&CrackedParameters::new(young, nu, 35e6, tension))?;
    let ply = Ply { law: Arc::new(law), thickness, density, rule: Rule::MidPoint(layers) };
    let mut bars = Vec::new();
    for depth in [-0.115, 0.115] {
        bars.push(Bar {
            law: Arc::new(BarLaw::new(210e9, 500e6, 2.1e9).map_err(law_error)?),
            area: 7e-4,
            depth,
            angle: std::f64::consts::FRAC_PI_2,
            density: 0.0,
        });
    }
    Ok(Leaf { section: Arc::new(LayeredSection::new(&[ply], &bars)?), face: 0.5 * thickness })
}

/// The tank with layered shells in place of its beams.
pub(super) fn of_shells(tank: StripTank, wall: Wall, layers: usize, softening: f64) -> Result<StripTank, Failure> {
    let stiff = wall == Wall::Elastic { stiff: true };
    let leaves = [
        elastic(LINER, stiff)?,
        match wall {
            Wall::Elastic { .. } => elastic(WALL, stiff)?,
            Wall::Cracking => cracking(layers, softening)?,
        },
    ];
    let [modulus, thickness, density] = LAYER;
    let layer = Layer {
        material: Elastic::normal_only(modulus, density),
        // As the fibres without second order.
        kinematics: Kinematics::Linear,
        mass: LayerMass::Halves,
    };
    let row = ShellRow { build: Build::Layered(leaves, layer), layers };
    let shells =
        ShellWall { rows: vec![row; tank.sections.len()], main: 1, gap: 0.5 * LINER[2] + thickness + 0.5 * THICKNESS };
    Ok(StripTank { shells: Some(shells), ..tank })
}

/// The tank of fibres, or of shells.
fn strip(wall: Wall, shells: bool, contact: Contact) -> Result<StripModel, Failure> {
    let options = Options { second_order: false, ..Options::default() };
    let section: FibreSection = match wall {
        Wall::Elastic { .. } => elastic_section()?,
        Wall::Cracking => reinforced(LAYERS, SOFTENING)?,
    };
    let mut tank: StripTank = tank(section, WET, 1.0, options)?;
    tank.contact = contact;
    if shells {
        tank = of_shells(tank, wall, LAYERS, SOFTENING)?;
    }
    Ok(StripModel::new(&tank, DAMPING)?)
}

/// Two seconds that excite sloshing and wall alike, begun and ended softly; largest acceleration about `peak` [m/s²].
fn swell(peak: f64) -> Record {
    let dt = 0.01;
    let acceleration = (0..=200).map(|i| {
        let t = f64::from(i) * dt;
        let swell = (std::f64::consts::PI * t / 2.0).sin().powi(2);
        peak * swell * (0.6 * (2.4 * t).sin() + 0.5 * (40.0 * t).sin() + 0.3 * (95.0 * t + 1.0).sin())
    });
    Record { name: "swell".into(), dt, acceleration: acceleration.collect(), processing: Vec::new() }
}

fn run(model: &StripModel, record: &Record, until: Option<f64>) -> Result<WallHistory, Failure> {
    let mut quake = StripQuake::new(record.clone(), 2.5e-3);
    quake.scheme = TimeScheme::GeneralizedAlpha { radius: 1.0 };
    quake.until = until;
    if model.joints.is_some() {
        quake.newton = Newton::for_contact();
    }
    Ok(model.single(&quake, Side::Front, &Silent)?.history)
}

/// Wave, deflection, shear and moment at the base: what is compared, with its unit and the factor to it.
const COMPARED: [(Scalar, &str, &str, f64); 4] = [
    (Scalar::Elevation, "largest wave", "m", 1.0),
    (Scalar::Deflection, "largest change of the deflection of the top", "mm", 1e3),
    (Scalar::Shear, "largest change of the base shear", "kN/m", 1e-3),
    (Scalar::Moment, "largest change of the base moment", "kNm/m", 1e-3),
];

fn peaks(history: &WallHistory) -> [f64; 4] {
    COMPARED.map(|(scalar, _, _, factor)| {
        let rest = history.at_rest(scalar);
        let change = history.scalar(scalar).iter().map(|v| (v - rest).abs());
        factor * change.fold(0.0, f64::max)
    })
}

const FIBRES: &str = "strip of fibres under the same motion";

/// Rows of the four peaks.
fn compare(what: &str, [fibre, shell]: [&WallHistory; 2], tolerance: [f64; 4]) -> Vec<Row> {
    let (reference, found) = (peaks(fibre), peaks(shell));
    let rows = COMPARED.iter().enumerate().map(|(k, (_, name, unit, _))| {
        Row::new(
            "C14",
            format!("{what}: {name}"),
            (reference[k], FIBRES, Reference::SecondFormulation),
            found[k],
            (tolerance[k], *unit),
        )
    });
    rows.collect()
}

const SHOWN: [f64; 4] = [f64::INFINITY; 4];

fn rows() -> Answer {
    let mut rows = Vec::new();
    let gentle = swell(0.5);
    for stiff in [true, false] {
        let wall = Wall::Elastic { stiff };
        let name = if stiff { "elastic, stiff in shear" } else { "elastic" };
        let models = [strip(wall, false, Contact::Bonded)?, strip(wall, true, Contact::Bonded)?];
        let [fibre, shell] = [run(&models[0], &gentle, None)?, run(&models[1], &gentle, None)?];
        if stiff {
            rows.extend(at_rest(&shell));
            rows.push(mass(&models[1]));
        }
        rows.push(Row::new(
            "C14",
            format!("{name}: frequency of the first mode of wall and liquid"),
            (models[0].wall_frequency(), "strip of fibres", Reference::SecondFormulation),
            models[1].wall_frequency(),
            // 5e-3 of a deflection linear between the levels, half of it in the frequency, and the liner; with shear see the head.
            (if stiff { 5e-3 } else { 1e-2 }, "rad/s"),
        ));
        let tolerance = if stiff { [2e-3, 1e-2, 1e-2, 1e-2] } else { [5e-3, 7e-2, 7e-2, 7e-2] };
        rows.extend(compare(name, [&fibre, &shell], tolerance));
    }
    rows.extend(opening()?);
    let strong = swell(6.0);
    rows.extend(cracks(&strong, None, "sines of 0.6 g")?);
    Ok(rows)
}

/// The moment and the shear of the hydrostatic pressure.
fn at_rest(shell: &WallHistory) -> Vec<Row> {
    let gamma = 1e4;
    // Half of the layer hangs on the inner face of the concrete, half on the outer one of the liner.
    let halves = 0.5 * LAYER[1] * LAYER[2] * G * 3.0 * 0.5 * (THICKNESS - LINER[2]);
    let held = |scalar, exact: f64, source, what: &str, (tolerance, unit): (f64, &'static str)| {
        Row::new(
            "C14",
            format!("shells at rest: {what}"),
            (exact, source, Reference::ClosedForm),
            1e-3 * shell.at_rest(scalar).abs(),
            (tolerance, unit),
        )
    };
    vec![
        held(
            Scalar::Moment,
            1e-3 * (gamma * DEPTH.powi(3) / 6.0 - halves),
            "γ H³/6 less the weight of half the layer on the faces of concrete and liner",
            "base moment",
            // Equilibrium on the deformed wall: its weight, 26 kN/m, on at most 0.55 mm.
            (5e-4, "kNm/m"),
        ),
        held(
            Scalar::Shear,
            1e-3 * gamma * DEPTH * DEPTH / 2.0,
            "γ H²/2",
            "base shear",
            // Equilibrium; Newton's method stops at 1e-8 of the forces.
            (1e-6, "kN/m"),
        ),
    ]
}

/// Mass of the shells by the weight that they put on their base.
fn mass(model: &StripModel) -> Row {
    let nodes = 0..model.model.nodes().len();
    let weight: f64 = nodes.map(|n| -model.model.at_node(&model.weight, n)[2]).sum();
    // The lowest half element stands on the ground.
    let levels = &model.tank.levels;
    let free = levels[levels.len() - 1] - 0.5 * levels[1];
    Row::new(
        "C14",
        "weight of liner, layer and concrete above the lowest half element",
        (1e-3 * (CONCRETE * THICKNESS + ATTACHED) * G * free, "ρ t g", Reference::ClosedForm),
        1e-3 * weight,
        (1e-9, "kN/m"),
    )
}

/// Contact that opens: closed like the bonded one, and open beside the fibres.
fn opening() -> Answer {
    let wall = Wall::Elastic { stiff: true };
    let contact = Contact::Joined { opens: true, penalty: None };
    let gentle = swell(0.5);
    let joined = [strip(wall, false, contact)?, strip(wall, true, contact)?];
    let closed = [run(&joined[0], &gentle, None)?, run(&joined[1], &gentle, None)?];
    // As the fibres: both faces are linear now, and the penalty is the same.
    let mut rows =
        compare("elastic, joint that may open and stays closed", [&closed[0], &closed[1]], [2e-3, 1e-2, 1e-2, 1e-2]);
    let hard = swell(12.0);
    let open = [run(&joined[0], &hard, None)?, run(&joined[1], &hard, None)?];
    let first = |history: &WallHistory| {
        let places = history.openings.as_ref().map(|o| o.places()).unwrap_or_default();
        places.iter().map(|p| p.first).fold(f64::INFINITY, f64::min)
    };
    rows.push(Row::new(
        "C14",
        "elastic, sines of 1.2 g: first opening of the joint",
        (first(&open[0]), FIBRES, Reference::SecondFormulation),
        first(&open[1]),
        // Two steps.
        (5e-3 / 0.335, "s"),
    ));
    // Shown: a difference grows with each impact.
    rows.extend(compare("elastic, sines of 1.2 g, joint that opens", [&open[0], &open[1]], SHOWN));
    Ok(rows)
}

/// Walls that crack.
fn cracks(record: &Record, until: Option<f64>, motion: &str) -> Answer {
    let models = [strip(Wall::Cracking, false, Contact::Bonded)?, strip(Wall::Cracking, true, Contact::Bonded)?];
    let histories = [run(&models[0], record, until)?, run(&models[1], record, until)?];
    let name = format!("cracking, {motion}");
    let mut rows = vec![Row::new(
        "C14",
        format!("{name}: deflection of the top at rest"),
        (1e3 * histories[0].at_rest(Scalar::Deflection), FIBRES, Reference::SecondFormulation),
        1e3 * histories[1].at_rest(Scalar::Deflection),
        // Uncracked: shear 1.5 %, mesh 0.2 %.
        (2e-2, "mm"),
    )];
    let tolerance = [5e-3, f64::INFINITY, f64::INFINITY, f64::INFINITY];
    rows.extend(compare(&name, [&histories[0], &histories[1]], tolerance));
    let most = |history: &WallHistory, of: &dyn Fn(&engines::strip::Cell) -> f64| {
        history.cells.iter().map(of).fold(0.0, f64::max)
    };
    let [fibre, shell] = [&histories[0], &histories[1]];
    for (what, of, factor, unit) in [
        (
            "largest stress of a bar",
            &(|c: &engines::strip::Cell| c.bar_stress) as &dyn Fn(&engines::strip::Cell) -> f64,
            1e-6,
            "MPa",
        ),
        ("highest crack", &|c: &engines::strip::Cell| c.highest_crack, 1.0, "m"),
    ] {
        rows.push(Row::new(
            "C14",
            format!("{name}: {what}"),
            (factor * most(fibre, of), FIBRES, Reference::SecondFormulation),
            factor * most(shell, of),
            (f64::INFINITY, unit),
        ));
    }
    Ok(rows)
}

/// Under El Centro as recorded, first 12 s: elastic, and with cracks at half and the whole of it.
fn recorded(record: &Record) -> Answer {
    let until = Some(12.0);
    let wall = Wall::Elastic { stiff: false };
    let models = [strip(wall, false, Contact::Bonded)?, strip(wall, true, Contact::Bonded)?];
    let found = [run(&models[0], record, until)?, run(&models[1], record, until)?];
    let mut rows = compare("elastic, El Centro", [&found[0], &found[1]], [5e-3, 7e-2, 7e-2, 7e-2]);
    for scale in [0.5, 1.0] {
        let mut scaled = record.clone();
        scaled.acceleration.iter_mut().for_each(|a| *a *= scale);
        rows.extend(cracks(&scaled, until, &format!("{scale} of El Centro"))?);
    }
    Ok(rows)
}
