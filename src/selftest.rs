//! The self-test: a row or two for each code and each engine, whose answers are known from elsewhere. It shows that this program computes on
//! this machine what it should; the verification manual (`docs/verification`) has all rows, and the program `verification` runs them.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use base::{Bands, Lifted, Plan, Plate, Rim, Strip, closed};
use codes::Procedure;
use codes::api650::{edition1993::Api6501993, edition2020::Api6502020};
use codes::ec8::{En2006, Env1998};
use codes::en1992::crack::{LASTING, width};
use codes::en1992::section::{Bars, Section as ConcreteSection};
use codes::housner::Housner;
use engines::solid::{MeshSize, SolidOptions};
use engines::{Options, Simulation, Task};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::spectrum::correlation;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::beam_section::FibreSection;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{ShellCell, ShellSurface};
use fem::linalg::Cholesky;
use fem::model::Builder;
use fem::progress::Silent;
use fragility::stripes::{Stripe, fit};
use materials::Law;
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};
use materials::von_mises::VonMises;
use oscillator::record::Record;
use oscillator::sdof::Recurrence;
use results::EngineId;
use soil::disc::{Disc, Soil};
use soil::isolator::{Friction, Isolator};
use tank::assessment::Excitation;
use tank::case::{Api650Site, Ec8Site, GroundMotion, GroundType, SiteClass};
use tank::options::AfterRecord;
use tank::options::nonlinear::{NonlinearOptions, WallElements};
use tank::reference::{broad, case, material};
use tank::{Bottom, Case, Material, Quantity, Roof, Shape, Support};

/// A computed value, or why there is none.
pub type Answer = Result<f64, Box<dyn Error>>;

/// A value with its reference.
pub struct Row {
    /// The code or engine.
    pub id: &'static str,
    /// The quantity, in words.
    pub what: &'static str,
    /// Where the reference comes from.
    pub source: &'static str,
    /// Reference value, in `unit`; never 0.
    pub reference: f64,
    /// Allowed deviation, relative to the reference.
    pub tolerance: f64,
    /// Unit.
    pub unit: &'static str,
    /// Computes the value, in `unit`.
    pub compute: fn() -> Answer,
}

impl Row {
    /// Deviation of a value, relative to the reference.
    pub fn error(&self, value: f64) -> f64 {
        (value - self.reference) / self.reference.abs()
    }

    /// Whether a value is within the tolerance.
    pub fn holds(&self, value: f64) -> bool {
        self.error(value).abs() <= self.tolerance
    }
}

const fn row(
    (id, what): (&'static str, &'static str),
    (reference, source): (f64, &'static str),
    (tolerance, unit): (f64, &'static str),
    compute: fn() -> Answer,
) -> Row {
    Row {
        id,
        what,
        source,
        reference,
        tolerance,
        unit,
        compute,
    }
}

const EXAMPLE: &str =
    "worked example of an oil tank, R = 15 m, H = 12 m, by an independent script from the text of the code";
const STATICS: &str = "statics";

/// All rows. Tolerances are half the last printed digit, rounding for closed forms, and those of the same rows in the manual for meshes.
pub const ROWS: &[Row] = &[
    row(
        ("housner", "impulsive mass over that of the liquid, R/H = 1.2"),
        (0.466_292_76, "tanh(√3 R/H)/(√3 R/H)"),
        (1e-6, "1"),
        || {
            let mut case = broad(1000.0);
            case.site.ec8 = Some(ec8(GroundType::A, 0.5, 1.0));
            let mass = value(&Housner, &case, Quantity::ImpulsiveMass)?;
            Ok(mass / case.liquid_mass())
        },
    ),
    row(
        (
            "ec8-env",
            "sloshing height of an aluminium tank, R = 1.83 m, H = 1.525 m",
        ),
        (0.560, "Brüggemann 2002, table D.3, with η unrounded"),
        (9e-4, "m"),
        || {
            let mut case = broad(1000.0);
            case.site.ec8 = Some(ec8(GroundType::A, 0.5, 1.0));
            (case.damping.sloshing, case.damping.impulsive) = (0.01, 0.01);
            value(&Env1998, &case, Quantity::SloshingHeight)
        },
    ),
    row(
        ("ec8-2006", "impulsive period"),
        (0.19050, EXAMPLE),
        (2.7e-5, "s"),
        || line(&En2006, "T_imp", 1.0),
    ),
    row(
        ("ec8-2006", "impulsive base shear"),
        (35_677.4, EXAMPLE),
        (1.5e-6, "kN"),
        || line(&En2006, "Q_i", 1e-3),
    ),
    row(
        ("api650-1993", "overturning moment"),
        (40.445, EXAMPLE),
        (1.3e-5, "MN m"),
        || line(&Api6501993, "M", 1e-6),
    ),
    row(
        ("api650-2020", "ringwall moment"),
        (43_696.6, EXAMPLE),
        (1.2e-6, "kN m"),
        || line(&Api6502020, "M_rw", 1e-3),
    ),
    row(
        ("api650-2020", "hoop stress of the lowest course"),
        (141.10, EXAMPLE),
        (3.6e-5, "MPa"),
        || line(&Api6502020, "σ_T", 1e-6),
    ),
    row(
        ("en1992", "stress of the bars of a cracked section, 50 kNm/m on 25 cm"),
        (269.564_832, "M/(A (d − x/3)), x by the quadratic"),
        (1e-8, "MPa"),
        cracked_section,
    ),
    row(
        (
            "oscillator",
            "sudden load on an undamped oscillator, after half a period",
        ),
        (2.0, "u = p/ω² (1 − cos ωt)"),
        (1e-12, "1"),
        || Ok(Recurrence::new(1.0, 0.0, PI).step(0.0, 0.0, 1.0, 1.0).0),
    ),
    row(
        ("time-steps", "period error of the trapezoidal rule, Δt/T = 0.1"),
        (3.207_491_062_3e-2, "x/(2 arctan(x/2)) − 1 (Hughes 1987)"),
        (1e-9, "1"),
        || Ok(TimeScheme::Trapezoidal.with_step(1.0)?.spectral_properties(TAU * 0.1).1),
    ),
    row(
        ("spectrum", "correlation of modes, ξ = 5 %, r = 0.9"),
        (0.4730, "Wilson, Der Kiureghian & Bayo 1981"),
        (1.1e-4, "1"),
        || Ok(correlation((1.0, 0.05), (0.9, 0.05))),
    ),
    row(
        ("harmonic", "sloshing in a rigid cylinder, R = 1.83 m, H = 1.525 m"),
        (2.998_852_3, "ω² = g λ/R tanh(λ H/R), J₁'(λ) = 0 (Lamb 1932)"),
        (5e-4, "rad/s"),
        || {
            let mut rigid = broad(1000.0);
            rigid
                .tank
                .courses
                .iter_mut()
                .for_each(|course| course.material.youngs_modulus = 3e13);
            first(&rigid, "sloshing")
        },
    ),
    row(
        ("harmonic", "wall and liquid of a steel tank, R = H = 10 m, 10 mm"),
        (45.272_283, "C_i of Malhotra, Wenk & Wieland 2000"),
        (0.02, "rad/s"),
        || {
            let steel = material(210e9, 0.3, 7850.0);
            first(
                &case(
                    Shape::Cylinder { radius: 10.0 },
                    &[(10.0, 0.01)],
                    &steel,
                    (1000.0, 10.0),
                ),
                "structural",
            )
        },
    ),
    row(
        ("harmonic", "moment of a tank on a tilted base"),
        (14_457.883_732, STATICS),
        (1e-8, "N m"),
        || {
            let options = Options {
                tilt: Some(TILT),
                ..options()
            };
            let run = engines::simulate(&at_rest(broad(1000.0)), &options)?;
            Ok(run.result.tilt.ok_or("no tilt test")?.base_moment)
        },
    ),
    row(
        ("solid", "the same with 24 sectors, three-dimensional"),
        (14_457.883_732, STATICS),
        // A polygon in a circle: (π/24)²/6.
        (3e-3, "N m"),
        || {
            let mesh = Some(MeshSize {
                radial: 4,
                sectors: 24,
                vertical: 12,
            });
            let solid = SolidOptions {
                mesh,
                ..SolidOptions::default()
            };
            Ok(engines::solid::tilted(&broad(1000.0), TILT, &options(), &solid, &Silent)?.base_moment)
        },
    ),
    row(
        ("nonlinear strip", "moment at the base of a wall at rest"),
        (-28_291.876_7, "cantilever under hydrostatic pressure, γ H³/6"),
        (1e-6, "N m/m"),
        || {
            let shape = Shape::Rectangle {
                length: 5.0,
                breadth: 1.0,
                strip: true,
            };
            let tank = case(shape, &[(3.0, 0.3)], &material(34e9, 0.2, 2950.0), (1019.4, 2.57));
            nonlinear(tank, [20, 1], "wall_moment_base_theta_0")
        },
    ),
    row(
        (
            "nonlinear cylinder",
            "rise of the surface in a cylinder at rest, R = 1.83 m, 3 mm",
        ),
        (
            -1.803_749e-4,
            "long cylinder under hydrostatic pressure, clamped (Timoshenko & Woinowsky-Krieger 1959)",
        ),
        (0.01, "m"),
        || {
            let aluminium = material(69e9, 0.32, 2750.0);
            let tank = case(
                Shape::Cylinder { radius: 1.83 },
                &[(1.8, 3e-3)],
                &aluminium,
                (1000.0, 1.5),
            );
            nonlinear(tank, [24, 32], "wave_height_theta_0")
        },
    ),
    row(
        ("shell", "Cook's membrane, 16 × 16 elements"),
        (
            23.61,
            "independent prototype of the same formulation; fine meshes 23.96 (Cook 1974)",
        ),
        (0.02, "m"),
        cook,
    ),
    row(
        ("steel", "stress after strains of 0.5 % and −0.5 %, isotropic hardening"),
        (-516.39, "bilinear law by hand"),
        (5e-4, "MPa"),
        steel_cycle,
    ),
    row(
        ("concrete", "cracking moment of a wall of 30 cm under 22.5 kN/m"),
        (53.625, "(f_t + N/A) h²/6"),
        (1e-3, "kN m/m"),
        cracking_moment,
    ),
    row(
        ("base", "force that holds a bottom plate down, 70 cm of it lifted"),
        (44_800.0, "beam on rigid ground, p l/2"),
        (1e-3, "N/m"),
        lifted_plate,
    ),
    row(
        (
            "soil",
            "horizontal stiffness of a disc of 10 m, G = 118.75 MPa, ν = 0.25",
        ),
        (9.5e9 / 1.75, "8 G R/(2 − ν)"),
        (1e-12, "N/m"),
        || {
            let soil = Soil {
                density: 1900.0,
                shear_wave_velocity: 250.0,
                poisson_ratio: 0.25,
                damping: 0.0,
                depth: None,
            };
            Ok(Disc::new(10.0, soil)?.stiffness().horizontal)
        },
    ),
    row(
        ("isolators", "period on friction pendulums, D = 0.2 m"),
        (2.403, "independent program"),
        (5e-3, "s"),
        || {
            let pendulum = Isolator::FrictionPendulum {
                radius: 2.2365,
                friction: Friction::constant(0.05),
                slip: 1e-3,
            };
            let (mass, gravity) = (1e6, 9.81);
            Ok(TAU * (mass / pendulum.effective(0.2, mass * gravity, 0.0, 0.0).stiffness).sqrt())
        },
    ),
    row(
        ("fragility", "median of 40 runs at each of eight intensities"),
        (0.519_144, "two optimisers outside this program"),
        (2e-6, "1"),
        || {
            let counts = [
                (0.1, 0.0),
                (0.2, 1.0),
                (0.3, 5.0),
                (0.4, 11.0),
                (0.5, 18.0),
                (0.6, 24.0),
                (0.8, 33.0),
                (1.0, 38.0),
            ];
            let stripes = counts.map(|(im, exceed)| Stripe { im, n: 40.0, exceed });
            Ok(fit(&stripes).map_err(|e| e.reason)?.curve.median)
        },
    ),
];

/// Tilt of the base [rad].
const TILT: f64 = 0.12;

fn ec8(ground: GroundType, ag: f64, importance: f64) -> Ec8Site {
    Ec8Site {
        ground,
        spectrum: 1,
        ag: ag * tank::reference::GRAVITY,
        importance,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    }
}

/// The oil tank of the worked examples of EN 1998-4 and API 650: six courses, fixed roof, self-anchored.
fn oil_tank() -> Case {
    let steel = Material {
        yield_strength: Some(235e6),
        allowable_stress: Some(157e6),
        ..material(210e9, 0.3, 7850.0)
    };
    let courses = [14e-3, 12e-3, 10e-3, 8e-3, 8e-3, 8e-3].map(|thickness| (2.4, thickness));
    let mut case = case(Shape::Cylinder { radius: 15.0 }, &courses, &steel, (900.0, 12.0));
    case.tank.roof = Roof {
        mass: 35e3,
        height: Some(15.2),
        ..Roof::default()
    };
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness: 0.010,
        sketch: None,
        projection: 0.0,
        corrosion: 0.0,
        width: None,
        subgrade_modulus: None,
        material: steel,
    });
    case.site.ec8 = Some(ec8(GroundType::C, 0.25, 1.2));
    case.site.api650 = Some(Api650Site {
        bearing_capacity: None,
        ss: 0.90,
        s1: 0.40,
        s0: None,
        site_class: SiteClass::D,
        asce7: 2010,
        fa: None,
        fv: None,
        q: 2.0 / 3.0,
        sug: 2,
        tl: 8.0,
        av: None,
        design_pressure: 0.0,
        joint_efficiency: 1.0,
        friction: 0.4,
        foundation_weight: None,
        zone_factor: Some(0.30),
        soil_factor: 1.5,
        importance_1993: 1.0,
    });
    case
}

/// A value of a procedure under the spectrum of the site.
fn value(procedure: &dyn Procedure, case: &Case, quantity: Quantity) -> Answer {
    let sheet = procedure.assess(case, Excitation::Site)?;
    Ok(*sheet.values.get(&quantity).ok_or("no such value")?)
}

/// The first line with this symbol in the sheet of the oil tank, times `unit`.
fn line(procedure: &dyn Procedure, symbol: &str, unit: f64) -> Answer {
    let sheet = procedure.assess(&oil_tank(), Excitation::Site)?;
    let line = sheet.steps.iter().find(|step| step.symbol == symbol);
    Ok(line.ok_or("no such line")?.value * unit)
}

fn cracked_section() -> Answer {
    let bars = Bars {
        depth: 0.05,
        area: 1e-3,
        diameter: Some(0.016),
        yield_strength: 500e6,
        modulus: 200e9,
    };
    let section = ConcreteSection {
        thickness: 0.25,
        strength: 30e6,
        modulus: 33e9,
        bars: vec![bars],
        factors: (1.5, 1.15),
    };
    Ok(width(&section, 0.0, 50e3, 2.9e6, LASTING)
        .ok_or("nothing pulls")?
        .stress
        / 1e6)
}

fn options() -> Options {
    Options {
        mesh_error: false,
        ..Options::default()
    }
}

/// First coupled frequency of a kind, harmonic 1 [rad/s].
fn first(case: &Case, kind: &str) -> Answer {
    let modes = engines::modes(case, &options(), &[1], 1)?;
    Ok(modes.iter().find(|mode| mode.kind == kind).ok_or("no such mode")?.omega)
}

/// The case under a record that does nothing.
fn at_rest(case: Case) -> Case {
    let horizontal = Record {
        name: "rest".into(),
        dt: 0.01,
        acceleration: vec![0.0; 3],
        processing: Vec::new(),
    };
    Case {
        ground_motion: Some(GroundMotion {
            horizontal,
            transverse: None,
            vertical: None,
        }),
        ..case
    }
}

/// Static value of a history of the nonlinear engine, on as many elements over the height and around.
fn nonlinear(case: Case, [height, circumference]: [u32; 2], history: &str) -> Answer {
    let case = at_rest(case);
    let own = NonlinearOptions {
        elements: Some(WallElements { height, circumference }),
        after_record: AfterRecord::NONE,
        self_weight: false,
        ..NonlinearOptions::new(case.damping)
    };
    let (linear, solid) = (options(), SolidOptions::default());
    let task = Task {
        case: &case,
        linear: &linear,
        solid: &solid,
        nonlinear: &own,
        checkpoint: None,
        without: &[],
    };
    let run: Simulation = engines::engine(EngineId::Nonlinear).run(&task, &Silent)?;
    let found = run.result.histories.iter().find(|found| found.id == history);
    Ok(found.ok_or("no such history")?.static_value)
}

/// Deflection of the middle of the free edge of a tapered panel under shear, E = 1, ν = 1/3.
fn cook() -> Answer {
    const N: usize = 16;
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, 1.0 / 3.0, 1.0, 0.0)?);
    let node = |i: usize, j: usize| i + (N + 1) * j;
    let mut builder = Builder::new();
    for k in 0..(N + 1) * (N + 1) {
        let [a, b] = [k % (N + 1), k / (N + 1)].map(|i| i as f64 / N as f64);
        builder.node([48.0 * a, 44.0 * (a + b) - 28.0 * a * b, 0.0]);
    }
    let cells = (0..N * N).map(|k| (k % N, k / N)).map(|(i, j)| ShellCell {
        nodes: [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)],
        section: section.clone(),
        group: "shell".into(),
    });
    ShellSurface::new(cells.collect()).place(&mut builder)?;
    for k in 0..(N + 1) * (N + 1) {
        [Dof::Uz, Dof::Rx, Dof::Ry]
            .into_iter()
            .for_each(|dof| builder.hold(k, dof));
    }
    let mut loads = NodalLoads::new();
    for j in 0..=N {
        Dof::TRANSLATIONS.iter().for_each(|&dof| builder.hold(node(0, j), dof));
        if j < N {
            let edge = [node(N, j), node(N, j + 1)];
            loads.edge_force(edge, edge.map(|e| builder.position(e)), |_| [0.0, 1.0 / 16.0, 0.0]);
        }
    }
    let model = builder.build()?;
    let stiffness = Assembler::new(&model).stiffness(&model)?.to_dense();
    let u = Cholesky::factor(&stiffness)?.solve_vector(&loads.vector(&model));
    Ok(model.at_node(&u, node(N, N / 2))[1])
}

/// E = 210 GPa, f_y = 500 MPa, E_T = 2.1 GPa.
fn steel_cycle() -> Answer {
    let law = VonMises::new(210e9, 0.3, 500e6, 2.1e9, 0.0)?;
    let law: &dyn Law<1> = &law;
    let mut history = vec![0.0; law.history_len()];
    law.init_history(&mut history);
    let mut stress = 0.0;
    for strain in (1..=100).chain((-100..100).rev()).map(|i| 5e-5 * f64::from(i)) {
        let mut trial = history.clone();
        stress = law.respond(&[strain], &history, &mut trial)?.stress[0];
        history = trial;
    }
    Ok(stress / 1e6)
}

/// The base of a wall 3 m high and 30 cm thick of 25 kN/m³, f_t = 3.5 MPa: the moment under which the strain of its edge reaches f_t/E.
fn cracking_moment() -> Answer {
    let (modulus, strength, thickness) = (34e9 / 0.96, 3.5e6, 0.3);
    let softening = Softening::Strain { softening_strain: 3e-4 };
    let tension = Tension {
        strength,
        softening,
        stiffening: None,
        bond: None,
    };
    let concrete = UniaxialConcrete::new(modulus, Compression::Plastic { strength: 35e6 }, Some(tension))?;
    let section = FibreSection::new(765.0)?.rectangle(Arc::new(concrete), [1.0, thickness], 0.0, 30)?;
    let curvatures: Vec<f64> = (0..400).map(|i| 5e-6 * f64::from(i)).collect();
    let points = section.moment_curvature(-22.5e3, &curvatures)?;
    let reached = |i: usize| (points[i].strain + 0.5 * thickness * points[i].curvature) * modulus / strength;
    let i = (1..points.len()).find(|&i| reached(i) >= 1.0).ok_or("no crack")?;
    let share = (1.0 - reached(i - 1)) / (reached(i) - reached(i - 1));
    Ok((points[i - 1].moment + share * (points[i].moment - points[i - 1].moment)) / 1e3)
}

/// 10 mm of steel under 128 kPa on nearly rigid ground, its rim free to turn.
fn lifted_plate() -> Answer {
    let plate = Plate {
        thickness: 0.01,
        young_modulus: 205e9,
        poisson_ratio: 0.3,
        yield_stress: None,
    };
    let (pressure, length) = (128e3, 0.7);
    let strip = Strip::new(Bands::uniform(plate), Rim::Hinged, 3.0, 1e12, pressure, Plan::Strip)?.refined(2.0);
    let mut state = Lifted::at_rest(&strip, 0.0)?;
    state.lift_to(closed::hinged(&plate, pressure, length).uplift)?;
    Ok(state.point().hold_down)
}
