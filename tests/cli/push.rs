//! `tankcheck push`: files and rejected input.

use std::path::{Path, PathBuf};

use crate::compare::{stderr, tankcheck};
use results::FactKind;

/// A small squat tank of steel on a coarse mesh.
const TANK: &str = r#"{
  "name": "small",
  "tank": {
    "shape": "cylinder", "radius": "4 m", "support": "anchored",
    "courses": [ { "height": "4 m", "thickness": "5 mm", "material": "steel" } ],
    "roof": { "mass": "2 t" }
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "3.6 m" },
  "materials": { "steel": {
    "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "60 MPa",
    "behaviour": { "steel": { "tangent_modulus": "0 GPa", "kinematic_share": 1 } }
  } },
  "analysis": { "nonlinear": { "elements": { "height": 16, "circumference": 16 }, "integration": { "steel": "gauss 3" } } }
}
"#;

/// The same tank with other options of the nonlinear engine.
pub(crate) fn with_nonlinear(options: &str) -> String {
    let own = "\"elements\": { \"height\": 16, \"circumference\": 16 }, \"integration\": { \"steel\": \"gauss 3\" }";
    assert_eq!(TANK.matches(own).count(), 1, "`{own}` stands once");
    TANK.replace(own, options)
}

fn tank(folder: &Path, from: &str, to: &str) -> PathBuf {
    assert_eq!(TANK.matches(from).count(), 1, "`{from}` stands once");
    let path = folder.join("tank.json");
    std::fs::write(&path, TANK.replace(from, to)).expect("writable");
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a temporary path is text")
}

/// The state at rest carries the weight: axial force of wall and roof. Shear and moment are those of the masses. The perfect and
/// the imperfect shell are side by side.
#[test]
fn a_pushover_is_written() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (tank, out) = (tank(home.path(), "small", "small"), home.path().join("out"));
    let run = tankcheck(&["push", text(&tank), "--imperfection", "class-b", "--quiet", "-o", text(&out)]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let table = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
    for name in ["report.html", "figures/push_bulge.svg", "figures/push_meridian_1.svg"] {
        assert!(out.join(name).exists(), "{name}");
    }
    let push = results::read_push(&out.join("push.json")).expect("readable");
    assert_eq!(push.shells.len(), 2);
    let perfect = &push.shells[0];
    assert!(perfect.capacity.limit, "{}", perfect.end);
    let rest = &perfect.path[0];
    // ρ_s H g and the roof's weight over the perimeter; the lowest element stands 1 % of the height above the base, and the
    // edge bending of the pressure shifts the axial force of the coarse mesh little.
    let weight = (7850.0 * 4.0 + 2000.0 / (2.0 * std::f64::consts::PI * 4.0 * 0.005)) * 9.80665;
    assert!((rest.compression / weight - 1.0).abs() < 0.1, "{} {weight}", rest.compression);
    // The yield strength was chosen for the hoop: at rest p R/t = 28 MPa.
    let best = &perfect.capacity;
    assert!(best.hoop > 0.5 * 60e6 && best.hoop < 1.2 * 60e6, "{}", best.hoop);
    let fact = |kind: FactKind| push.model.iter().find(|f| f.kind == kind).expect("a fact of the model").value;
    let mass = fact(FactKind::ImpulsiveMass) + fact(FactKind::WallAndRoofMass);
    // Eight graded elements around the half take 2 % of the force of cos θ; at a tenth of g the liquid pulls only just below its
    // surface, where the wall fails it does on much of the other side.
    let first = &perfect.path[1];
    assert!((first.base_shear / first.acceleration / mass - 1.0).abs() < 0.03);
    // M/(π R² t) with the same 3 %, and weight; the lowest element stands 0.7 % of the height above the base.
    let beam = first.base_moment / (std::f64::consts::PI * 16.0 * 0.005) + weight;
    assert!((first.compression / beam - 1.0).abs() < 0.1, "{} {beam}", first.compression);
    assert!(best.state.base_shear < best.state.acceleration * mass);
    let imperfection = push.shells[1].imperfection.as_ref().expect("the second shell is imperfect");
    assert!((imperfection.amplitude - (4.0_f64 * 0.005).sqrt() / 25.0).abs() < 1e-9);
    assert!(push.shells[1].capacity.state.acceleration < 1.1 * best.state.acceleration);
    assert_eq!(push.limits.len(), 4);
}

#[test]
fn what_cannot_be_pushed_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let small = tank(home.path(), "small", "small");
    let refused = |arguments: &[&str], words: &[&str]| {
        let mut all = vec!["push"];
        all.extend(arguments);
        all.extend(["-o", text(&out)]);
        let run = tankcheck(&all);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {}", stderr(&run));
        for word in words {
            assert!(stderr(&run).contains(word), "{arguments:?}: {}", stderr(&run));
        }
        assert!(!out.exists(), "{arguments:?}");
    };
    refused(&[text(&small), "--imperfection", "0"], &["--imperfection", "found `0`"]);
    refused(&[text(&small), "--imperfection", "class-x"], &["class-a, class-b or class-c"]);
    refused(&[text(&small), "--imperfection", "0.5t", "--imperfection-at", "-1m"], &["--imperfection-at"]);
    refused(
        &[text(&small), "--imperfection", "0.5t", "--imperfection-at", "9 m"],
        &["height of the imperfection", "0 to 4 m"],
    );
    refused(&[text(&small), "--imperfection-at", "1m"], &["--imperfection"]);
    refused(&[text(&small), "--imperfection-shape", "mode"], &["--imperfection <AMPLITUDE>"]);
    refused(
        &[text(&small), "--imperfection", "0.5t", "--imperfection-shape", "mode", "--imperfection-at", "1m"],
        &["--imperfection-at", "does not apply to a buckling mode"],
    );
    refused(&["examples/06_sandwich_strip/tank.json"], &["cylinders"]);
    refused(
        &["examples/08_concrete_cylinder/tank.json"],
        &["tank.json: materials.concrete.behaviour: found concrete", "allowed steel"],
    );
    let elastic =
        tank(home.path(), r#"{ "steel": { "tangent_modulus": "0 GPa", "kinematic_share": 1 } }"#, r#""elastic""#);
    refused(&[text(&elastic)], &["tank.json: materials.steel.behaviour: found elastic", "yield_strength"]);
    let odd = tank(home.path(), r#""circumference": 16 }"#, r#""circumference": 17 }, "symmetry": false"#);
    refused(&[text(&odd)], &["elements.circumference", "found 17", "an even number"]);
    let unanchored = tank(home.path(), "anchored", "unanchored");
    refused(&[text(&unanchored)], &["needs its bottom plate", "tank.bottom"]);
}

/// The shape of the buckling mode: weaker than the perfect shell, drawn.
#[test]
fn a_mode_is_an_imperfection() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (tank, out) = (tank(home.path(), "small", "small"), home.path().join("out"));
    let mode = ["--imperfection", "1t", "--imperfection-shape", "mode"];
    let mut command = vec!["push", text(&tank), "--quiet", "-o", text(&out)];
    command.extend(mode);
    let run = tankcheck(&command);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert!(out.join("figures/push_imperfection_1.svg").exists());
    let push = results::read_push(&out.join("push.json")).expect("readable");
    let [perfect, imperfect] = push.shells.as_slice() else {
        panic!("two shells");
    };
    let imperfection = imperfect.imperfection.as_ref().expect("the second shell is imperfect");
    // The elastic wall is far from buckling where the steel yields: R/t = 800, 60 MPa.
    assert!(imperfection.factor.expect("a mode has a factor") > 1.0);
    let map = imperfection.map.as_ref().expect("a mode has a map");
    let largest = map.values.iter().copied().fold(0.0, f64::max);
    assert!((largest - 0.005).abs() < 1e-9 && (imperfection.amplitude - 0.005).abs() < 1e-12);
    assert!(map.values.iter().all(|v| v.abs() < largest * (1.0 + 1e-9)));
    assert!(imperfect.capacity.state.acceleration < 1.02 * perfect.capacity.state.acceleration);
}
