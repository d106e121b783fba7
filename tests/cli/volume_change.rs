//! Temperature, shrinkage, creep and prestress at rest, from the file to the results.

use std::path::Path;
use std::process::Command;

use engines::nonlinear::push;
use engines::{Task, engine};
use results::{EngineId, Envelope, Results, read};
use tank::refusal::Refusal;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;
use tankcheck::job;

use super::bad_tank::has;
use super::nonlinear_input::read as read_file;

const RADIUS: f64 = 5.0;
const THICKNESS: f64 = 0.02;
const YOUNG: f64 = 210e9;

/// An elastic wall of steel without weight, R = 5 m, 20 mm.
const STEEL: &str = r#"{
  "name": "warm",
  "tank": {
    "shape": "cylinder", "radius": "5 m", "support": "anchored",
    "courses": [ { "height": "5 m", "thickness": "20 mm", "material": "steel" } ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "4.5 m" },
  "materials": {
    "steel": { "family": "carbon_steel", "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3" }
  },
  "analysis": { "nonlinear": {
    "elements": { "height": 80, "circumference": 40 }, "time_step": "5 ms", "after_record": "none",
    "self_weight": false, "follower_pressure": false
  } }
}
"#;

/// A wall of concrete with prestressed hoops.
const CONCRETE: &str = r#"{
  "name": "prestressed",
  "tank": {
    "shape": "cylinder", "radius": "5 m", "support": "anchored",
    "courses": [ { "height": "5 m", "thickness": "20 cm", "material": "concrete", "reinforcement": [
      { "direction": "hoop", "area": "10 cm2/m", "from_outer": "5 cm", "prestress": "400 MPa", "material": "bars" }
    ] } ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "4.5 m" },
  "materials": {
    "concrete": { "grade": "C30/37", "volume_change": { "shrinkage": 2e-4, "creep_coefficient": 1.5 },
      "behaviour": { "concrete": { "crack_spacing": "15 cm" } } },
    "bars": { "grade": "BSt500" }
  },
  "analysis": { "nonlinear": {
    "elements": { "height": 8, "circumference": 16 }, "time_step": "5 ms", "after_record": "none",
    "integration": { "concrete": "midpoint 8" }
  } }
}
"#;

const TEMPERATURE: &str =
    r#""temperature": { "inside": "60 degC", "outside": "60 degC", "stress_free": "10 degC" }, "self_weight""#;

/// The wall of steel 50 K warmer than without stress.
fn warm() -> String {
    STEEL.replace("\"self_weight\"", TEMPERATURE)
}

/// `compare --fe nonlinear` under a tenth of a second of shaking.
fn run(folder: &Path, name: &str, tank: &str) -> (Results, String) {
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("writable");
    write("tank.json", tank);
    let lines: String = (0..=5).map(|i| format!("{:.2},{:.4}\n", 0.02 * f64::from(i), f64::from(i % 2))).collect();
    write("record.csv", &format!("time_s,acceleration_m_s2\n{lines}"));
    let output = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["compare", "tank.json", "--quake", "record.csv", "--fe", "nonlinear", "--no-mesh-error", "--out", name])
        .current_dir(folder)
        .output()
        .expect("tankcheck runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{message}");
    let page = std::fs::read_to_string(folder.join(name).join("report.html")).expect("a page");
    (read(&folder.join(name)).expect("results"), page)
}

fn hoop(results: &Results) -> &Envelope {
    let run = results.beside(EngineId::Nonlinear).expect("a nonlinear run");
    run.envelopes.iter().find(|e| e.id.contains("hoop")).expect("hoop stresses")
}

/// What a clamped foot holds of the growth of a warm wall: σ_φ(z) = −E α ΔT e^(−β z) (cos β z + sin β z), Timoshenko &
/// Woinowsky-Krieger 1959, art. 115.
///
/// Tolerance: 2 % of E α ΔT: polygon ½ (π/40)² = 0.3 %, shear flexibility t/R = 0.4 %, rows of at most 0.2 √(R t), linear within a row whose mean is
/// compared, 2 (0.2·1.285)²/12 = 1.1 %; the pressure at rest is in both runs, and turns with nothing.
#[test]
fn warm_wall_has_the_hoop_stress_of_the_closed_form() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (cold, _) = run(home.path(), "cold", STEEL);
    let (warm, page) = run(home.path(), "warm", &warm());
    let beta = (3.0 * (1.0 - 0.09_f64)).powf(0.25) / (RADIUS * THICKNESS).sqrt();
    let thermal = YOUNG * 12e-6 * 50.0;
    let mut largest = 0.0_f64;
    for ((z, cold), warm) in hoop(&cold).z.iter().zip(&hoop(&cold).static_).zip(&hoop(&warm).static_) {
        let x = beta * z;
        let expected = -thermal * (-x).exp() * (x.cos() + x.sin());
        largest = largest.max(expected.abs());
        assert!((warm - cold - expected).abs() < 0.02 * thermal, "{z}: {} {expected}", warm - cold);
    }
    assert!(largest > 0.8 * thermal, "a row next to the foot");
    // The change of the motion is that of the cold wall.
    let moved = |r: &Results| hoop(r).max.iter().fold(0.0_f64, |a, b| a.max(*b));
    assert!((moved(&warm) / moved(&cold) - 1.0).abs() < 0.01, "{} {}", moved(&warm), moved(&cold));
    has(&page, &["At rest the wall has 60.0 °C at its wet and 60.0 °C at its dry face", "steel 1.20e-5/K", "10.0 °C"]);
}

/// The report says what acted at rest.
#[test]
fn prestressed_wall_that_creeps() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (_, page) = run(home.path(), "out", CONCRETE);
    has(
        &page,
        &[
            "concrete has shrunk by 2.00e-4 before the record.",
            "concrete creeps at rest with the coefficient 1.5",
            "Prestress of hoop bars where the wall has no strain: 400 MPa",
            "Code procedures and linear engines leave this state out.",
        ],
    );
}

/// The only fault of a file.
fn fault(text: &str) -> String {
    let source = Source::new("tank.json", text);
    let text = parse(&source).expect_err("a fault").render(&source, false);
    assert!(text.contains("error: 1 fault in tank.json"), "{text}");
    text
}

fn refused(text: &str, refuses: fn(&Task<'_>) -> Vec<Refusal>) -> String {
    let file = read_file(text);
    let text = job::refused(&file, refuses).render(&file.source, false);
    assert!(text.contains("nothing was computed"), "{text}");
    text
}

fn history(task: &Task<'_>) -> Vec<Refusal> {
    engine(EngineId::Nonlinear).refuses(task)
}

#[test]
fn values_that_do_not_apply() {
    has(
        &fault(&CONCRETE.replace("400 MPa", "500 MPa")),
        &[
            "tank.courses[0].reinforcement[0].prestress",
            "the bars yield under their prestress",
            "less than the yield strength",
        ],
    );
    let creeping = "\"grade\": \"BSt500\", \"volume_change\": { \"creep_coefficient\": 1.0 }";
    has(
        &fault(&CONCRETE.replace("\"grade\": \"BSt500\"", creeping)),
        &["materials.bars.volume_change.creep_coefficient", "bars and interlayers neither shrink nor creep"],
    );
}

#[test]
fn analyses_without_a_state_at_rest_refuse_it() {
    let strip = |text: &str| {
        text.replace(
            "\"shape\": \"cylinder\", \"radius\": \"5 m\"",
            "\"shape\": \"rectangle\", \"length\": \"10 m\", \"strip\": true",
        )
        .replace(", \"circumference\": 40", "")
        .replace(", \"circumference\": 16", "")
    };
    let only = "a wall of fibres has neither temperature, shrinkage, creep nor prestress at rest";
    has(&refused(&strip(&warm()), history), &["analysis.nonlinear.temperature", only, "1 fault"]);
    has(
        &refused(&strip(CONCRETE), history),
        &["materials.concrete.volume_change", "tank.courses[0]", only, "2 faults"],
    );
    has(&refused(&warm(), push::refuses), &["analysis.nonlinear.temperature", "a pushover has neither temperature"]);
    let titanium = warm().replace("carbon_steel", "other_metal");
    has(
        &refused(&titanium, history),
        &["materials.steel", "has no coefficient of thermal expansion", "\"thermal_expansion\": 1.2e-5"],
    );
}
