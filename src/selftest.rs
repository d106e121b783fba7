//! The self-test: a row or two for each code and each engine, whose answers are known from elsewhere. It shows that this program computes on
//! this machine what it should; the verification manual (`docs/verification`) has all rows, and the program `verification` runs them.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::sync::Arc;

use base::{Bands, Lifted, Plan, Plate, Rim, Strip, closed};
use codes::Procedure;
use codes::aci350::Aci3502006;
use codes::api650::{edition1993::Api6501993, edition2020::Api6502020};
use codes::ec8::{En2006, Env1998};
use codes::en1992::crack::{LASTING, width};
use codes::en1992::section::{Bars, Section};
use codes::housner::Housner;
use codes::is1893::Is18932014;
use codes::national::National;
use engines::solid::{MeshSize, SolidOptions};
use engines::{Options, Task};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::spectrum::correlation;
use fem::element::beam_section::FibreSection;
use fem::progress::Silent;
use fragility::stripes::{Stripe, fit};
use materials::Law;
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};
use materials::von_mises::VonMises;
use oscillator::record::Record;
use oscillator::sdof::Recurrence;
use results::{EngineId, Part};
use soil::disc::{Disc, Soil};
use soil::isolator::{Friction, Isolator};
use tank::assessment::Excitation;
use tank::case::GroundMotion;
use tank::options::AfterRecord;
use tank::options::nonlinear::{NonlinearOptions, WallElements};
use tank::reference::{broad, case, material};
use tank::{Case, Quantity, Shape};

use crate::input::diagnostic::Source;
use crate::input::tank::parse;

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
    /// Unit, `1` for none.
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

macro_rules! rows {
    ($($id:literal, $what:literal: $reference:literal $unit:literal within $tolerance:literal of $source:expr => $compute:expr;)*) => {
        &[$(Row {
            id: $id,
            what: $what,
            source: $source,
            reference: $reference,
            tolerance: $tolerance,
            unit: $unit,
            compute: $compute,
        }),*]
    };
}

const EXAMPLE: &str = "worked example, R = 15 m, H = 12 m, by an independent script from the text of the code";

/// All rows. Tolerances are half the last printed digit, rounding for closed forms, and those of the manual's rows for meshes; the polygon of 24
/// sides has (π/24)²/6.
pub const ROWS: &[Row] = rows! {
    "housner", "impulsive mass over that of the liquid, R/H = 1.2":
        0.466_292_76 "1" within 1e-6 of "tanh(√3 R/H)/(√3 R/H)" => || {
            let mass = value(&Housner, Quantity::ImpulsiveMass)?;
            Ok(mass / broad(1000.0).liquid_mass())
        };
    "ec8-env", "sloshing height, R = 1.83 m, H = 1.525 m":
        0.560 "m" within 9e-4 of "Brüggemann 2002, table D.3, with η unrounded" => || value(&Env1998, Quantity::SloshingHeight);
    "ec8-2006", "impulsive period": 0.19050 "s" within 2.7e-5 of EXAMPLE => || line(&En2006, "T_imp", 1.0);
    "ec8-2006", "impulsive base shear": 35_677.4 "kN" within 1.5e-6 of EXAMPLE => || line(&En2006, "Q_i", 1e-3);
    "api650-1993", "overturning moment": 40.445 "MN m" within 1.3e-5 of EXAMPLE => || line(&Api6501993, "M", 1e-6);
    "api650-2020", "ringwall moment": 43_696.6 "kN m" within 1.2e-6 of EXAMPLE => || line(&Api6502020, "M_rw", 1e-3);
    "api650-2020", "hoop stress of the lowest course": 141.10 "MPa" within 3.6e-5 of EXAMPLE => || line(&Api6502020, "σ_T", 1e-6);
    "aci350-2006", "impulsive period of a box": 0.0846 "s" within 6e-4 of "control values, by an independent script" => || {
            of_box(ACI_BOX, &Aci3502006, "T_i")
        };
    "is1893-2014", "convective coefficient of a box":
        0.04725 "g" within 1.1e-4 of "published calculation, scribd 549280385" => || of_box(IS_BOX, &Is18932014, "A_c");
    "national", "impulsive coefficient of a box": 0.375 "g" within 1e-9 of "0.75 g/2, by hand" => || {
            of_box(IS_BOX, &National, "A_i")
        };
    "en1992", "stress of the bars of a cracked section, 50 kNm/m on 25 cm":
        269.564_832 "MPa" within 1e-8 of "M/(A (d − x/3)), x by the quadratic" => cracked_section;
    "oscillator", "sudden load on an undamped oscillator, after half a period":
        2.0 "1" within 1e-12 of "u = p/ω² (1 − cos ωt)" => || Ok(Recurrence::new(1.0, 0.0, PI).step(0.0, 0.0, 1.0, 1.0).0);
    "time-steps", "period error of the trapezoidal rule, Δt/T = 0.1":
        3.207_491_062_3e-2 "1" within 1e-9 of "x/(2 arctan(x/2)) − 1 (Hughes 1987)" =>
        || Ok(TimeScheme::Trapezoidal.with_step(1.0)?.spectral_properties(TAU * 0.1).1);
    "spectrum", "correlation of modes, ξ = 5 %, r = 0.9":
        0.4730 "1" within 1.1e-4 of "Wilson, Der Kiureghian & Bayo 1981" => || Ok(correlation((1.0, 0.05), (0.9, 0.05)));
    "harmonic", "sloshing in a rigid cylinder, R = 1.83 m, H = 1.525 m":
        2.998_852_3 "rad/s" within 5e-4 of "ω² = g λ/R tanh(λ H/R), J₁'(λ) = 0 (Lamb 1932)" => || {
            first("sloshing", cylinder([1.83, 1.83, 2e-3], 3e13, 1.525))
        };
    "harmonic", "wall and liquid of a steel tank, R = H = 10 m, 10 mm":
        45.272_283 "rad/s" within 0.02 of "C_i of Malhotra, Wenk & Wieland 2000" => || first("structural", cylinder([10.0, 10.0, 0.01], 210e9, 10.0));
    "harmonic", "moment of a tank on a tilted base": 14_457.883_732 "N m" within 1e-8 of "statics" => || {
        let options = Options { tilt: Some(TILT), ..options() };
        let run = engines::simulate(&at_rest(broad(1000.0)), &options)?;
        moment(run.result.part("tilt"))
    };
    "solid", "the same, three-dimensional with 24 sectors": 14_457.883_732 "N m" within 3e-3 of "statics" => || {
        let mesh = Some(MeshSize { radial: 4, sectors: 24, vertical: 12 });
        let solid = SolidOptions { mesh, ..SolidOptions::default() };
        moment(Some(&engines::solid::tilted(&broad(1000.0), TILT, &options(), &solid, &Silent)?))
    };
    "nonlinear strip", "moment at the base of a wall at rest":
        -28_291.876_7 "N m/m" within 1e-6 of "cantilever under hydrostatic pressure, γ H³/6" => || {
            let shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
            let tank = case(shape, &[(3.0, 0.3)], &material(34e9, 0.2, 2950.0), (1019.4, 2.57));
            nonlinear(tank, [20, 1], "wall_moment_base_theta_0")
        };
    "nonlinear cylinder", "rise of the surface of a tank at rest, R = 1.83 m, 3 mm":
        -1.804_244e-4 "m" within 0.01 of "long cylinder under hydrostatic pressure, clamped (Timoshenko & Woinowsky-Krieger 1959)" =>
        || nonlinear(cylinder([1.83, 1.8, 3e-3], 69e9, 1.5), [24, 32], "wave_height_theta_0");
    "steel", "stress after strains of 0.5 % and −0.5 %, isotropic hardening":
        -516.39 "MPa" within 5e-4 of "bilinear law by hand" => steel_cycle;
    "concrete", "cracking moment of a wall of 30 cm under 22.5 kN/m":
        53.625 "kN m/m" within 1e-3 of "(f_t + N/A) h²/6" => cracking_moment;
    "base", "force that holds a bottom plate down, 70 cm of it lifted":
        44_800.0 "N/m" within 1e-3 of "beam on rigid ground, p l/2" => lifted_plate;
    "soil", "horizontal stiffness of a disc of 10 m, G = 118.75 MPa, ν = 0.25":
        5.428_571_428_571_429 "GN/m" within 1e-12 of "8 G R/(2 − ν)" => || {
            let soil = Soil { density: 1900.0, shear_wave_velocity: 250.0, poisson_ratio: 0.25, damping: 0.0, depth: None };
            Ok(Disc::new(10.0, soil)?.stiffness().horizontal / 1e9)
        };
    "isolators", "period on friction pendulums, D = 0.2 m": 2.403 "s" within 5e-3 of "independent program" => || {
        let pendulum = Isolator::FrictionPendulum { radius: 2.2365, friction: Friction::constant(0.05), slip: 1e-3 };
        Ok(TAU * (1.0 / pendulum.effective(0.2, 9.81, 0.0, 0.0).stiffness).sqrt())
    };
    "fragility", "median of 40 runs at each of eight intensities":
        0.519_144 "1" within 2e-6 of "two optimisers outside this program" => || {
            let counts = [(0.1, 0.0), (0.2, 1.0), (0.3, 5.0), (0.4, 11.0), (0.5, 18.0), (0.6, 24.0), (0.8, 33.0), (1.0, 38.0)];
            let stripes = counts.map(|(im, exceed)| Stripe { im, n: 40.0, exceed });
            Ok(fit(&stripes).map_err(|e| e.reason)?.curve.median)
        };
};

/// Moment above the base plate of a tilt test [N m].
fn moment(tilt: Option<&Part>) -> Answer {
    let moment = tilt.and_then(|part| part.value("base_moment")).ok_or("no tilt test")?;
    Ok(moment.value.value)
}

/// Tilt of the base [rad].
const TILT: f64 = 0.12;

/// The oil tank of the worked examples of EN 1998-4 and API 650.
const OIL_TANK: &str = r#"{
  "name": "worked example", "gravity": "9.81 m/s2",
  "tank": {
    "shape": "cylinder", "radius": "15 m", "support": "unanchored",
    "courses": [
      { "height": "2.4 m", "thickness": "14 mm", "material": "steel" }, { "height": "2.4 m", "thickness": "12 mm", "material": "steel" },
      { "height": "2.4 m", "thickness": "10 mm", "material": "steel" }, { "height": "7.2 m", "thickness": "8 mm", "material": "steel" }
    ],
    "roof": { "mass": "35 t", "height": "15.2 m" }, "bottom": { "thickness": "10 mm", "material": "steel" }
  },
  "liquid": { "density": "900 kg/m3", "fill_height": "12 m" },
  "materials": { "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "235 MPa",
    "allowable_stress": "157 MPa" } },
  "damping": { "sloshing": 0.005, "impulsive": 0.02 },
  "site": {
    "ec8": { "ground": "C", "spectrum": 1, "ag": "2.4525 m/s2", "importance": 1.2 },
    "api650": { "ss": 0.90, "s1": 0.40, "site_class": "D", "sug": 2, "tl": 8.0, "zone_factor": 0.30, "soil_factor": 1.5 }
  }
}"#;

/// The aluminium tank of the dissertation's table D.3.
const ALUMINIUM_TANK: &str = r#"{
  "name": "Manos & Clough, broad", "gravity": "9.81 m/s2",
  "tank": {
    "shape": "cylinder", "radius": "1.83 m", "support": "anchored", "roof": "none",
    "courses": [
      { "height": "0.915 m", "thickness": "2.03 mm", "material": "aluminium" }, { "height": "0.915 m", "thickness": "1.27 mm", "material": "aluminium" }
    ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "1.525 m" },
  "materials": { "aluminium": { "youngs_modulus": "69 GPa", "poisson_ratio": 0.32, "density": "2750 kg/m3" } },
  "damping": { "sloshing": 0.01, "impulsive": 0.01 },
  "site": { "ec8": { "ground": "A", "spectrum": 1, "ag": "4.905 m/s2", "importance": 1.0 } }
}"#;

/// The box of the control values of ACI 350.3-06.
const ACI_BOX: &str = r#"{
  "name": "control values",
  "tank": {
    "shape": "rectangle", "length": "18 m", "breadth": "9 m", "support": "anchored", "roof": "none",
    "courses": [{ "height": "4.5 m", "thickness": "40 cm", "material": "concrete" }]
  },
  "liquid": { "density": "1000.342 kg/m3", "fill_height": "4 m" },
  "materials": { "concrete": { "family": "concrete", "youngs_modulus": "24.87 GPa", "poisson_ratio": 0.2, "density": "2447.32 kg/m3" } },
  "site": { "api650": { "ss": 0.90, "s1": 0.40, "site_class": "D", "sug": 2, "tl": 8.0 } }
}"#;

/// The box of a published calculation by IITK-GSDMA, and a spectrum by hand.
const IS_BOX: &str = r#"{
  "name": "published calculation", "gravity": "9.81 m/s2",
  "tank": {
    "shape": "rectangle", "length": "9.9 m", "breadth": "3.3 m", "support": "anchored", "roof": "none",
    "courses": [{ "height": "3.3 m", "thickness": "30 cm", "material": "concrete" }]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "3 m" },
  "materials": { "concrete": { "family": "concrete", "youngs_modulus": "27.38613 GPa", "poisson_ratio": 0.2, "density": "2500 kg/m3" } },
  "site": {
    "is1893": { "zone": "V", "soil": "hard", "importance": 1.5, "response_reduction": 2.5 },
    "spectrum": { "table": [[0, 7.3575], [0.6, 7.3575], [10, 0.5]], "unit": "m/s2", "damping": "5 %" },
    "national": { "code": "by hand", "impulsive_reduction": 2.0 }
  }
}"#;

/// The last line with this symbol in the sheet of a box.
fn of_box(text: &str, procedure: &dyn Procedure, symbol: &str) -> Answer {
    let sheet = procedure.assess(&read(text)?, Excitation::Site)?;
    let line = sheet.steps.iter().rev().find(|step| step.symbol == symbol);
    Ok(line.ok_or("no such line")?.value)
}

/// The case of a tank file.
fn read(text: &str) -> Result<Case, Box<dyn Error>> {
    let source = Source::at(Path::new("self-test"), text);
    Ok(parse(&source).map_err(|faults| faults.into_error(&source))?.case)
}

/// A value of a procedure for the aluminium tank, under the spectrum of its site.
fn value(procedure: &dyn Procedure, quantity: Quantity) -> Answer {
    let sheet = procedure.assess(&read(ALUMINIUM_TANK)?, Excitation::Site)?;
    Ok(*sheet.values.get(&quantity).ok_or("no such value")?)
}

/// The first line with this symbol in the sheet of the oil tank, times `unit`.
fn line(procedure: &dyn Procedure, symbol: &str, unit: f64) -> Answer {
    let sheet = procedure.assess(&read(OIL_TANK)?, Excitation::Site)?;
    let line = sheet.steps.iter().find(|step| step.symbol == symbol);
    Ok(line.ok_or("no such line")?.value * unit)
}

fn cracked_section() -> Answer {
    let bars = Bars { depth: 0.05, area: 1e-3, diameter: Some(0.016), yield_strength: 500e6, modulus: 200e9 };
    let section = Section { thickness: 0.25, strength: 30e6, modulus: 33e9, bars: vec![bars], factors: (1.5, 1.15) };
    let found = width(&section, 0.0, 50e3, 2.9e6, LASTING);
    Ok(found.ok_or("nothing pulls")?.stress / 1e6)
}

fn options() -> Options {
    Options { mesh_error: false, ..Options::default() }
}

/// A uniform cylinder of radius, height and thickness [m], Young's modulus [Pa], water to a depth [m].
fn cylinder([radius, height, thickness]: [f64; 3], modulus: f64, depth: f64) -> Case {
    let wall = material(modulus, 0.3, 7850.0);
    case(Shape::Cylinder { radius }, &[(height, thickness)], &wall, (1000.0, depth))
}

/// First coupled frequency of a kind, harmonic 1 [rad/s].
fn first(kind: &str, case: Case) -> Answer {
    let modes = engines::modes(&case, &options(), &[1], 1)?;
    let found = modes.iter().find(|mode| mode.kind == kind);
    Ok(found.ok_or("no such mode")?.omega)
}

/// The case under a record that does nothing.
fn at_rest(mut case: Case) -> Case {
    let horizontal = Record { name: "rest".into(), dt: 0.01, acceleration: vec![0.0; 3], processing: Vec::new() };
    case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
    case
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
    let task = Task {
        case: &case,
        linear: &options(),
        solid: &SolidOptions::default(),
        nonlinear: &own,
        checkpoint: None,
        without: &[],
    };
    let run = engines::engine(EngineId::Nonlinear).run(&task, &Silent)?;
    let found = run.result.histories.iter().find(|found| found.id == history);
    Ok(found.ok_or("no such history")?.static_value)
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
    let tension =
        Tension { strength, softening: Softening::Strain { softening_strain: 3e-4 }, stiffening: None, bond: None };
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
    let plate = Plate { thickness: 0.01, young_modulus: 205e9, poisson_ratio: 0.3, yield_stress: None };
    let strip = Strip::new(Bands::uniform(plate), Rim::Hinged, 3.0, 1e12, 128e3, Plan::Strip)?.refined(2.0);
    let mut state = Lifted::at_rest(&strip, 0.0)?;
    state.lift_to(closed::hinged(&plate, 128e3, 0.7).uplift)?;
    Ok(state.point().hold_down)
}
