//! Input of the bond of bars and of the biaxial envelope of concrete.

use tank::Behaviour;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use super::bad_tank::has;
use super::nonlinear_input::{changed, read, spoiled};

/// A bond law needs the diameter of the bars; cracks then have the mean spacing of the Model Code: 16 mm · 10 cm/(5.4 · 15 cm²/m).
#[test]
fn bond_of_bars() {
    let bonded = changed("\"2.9 MPa\"", "\"2.9 MPa\", \"bond\": \"good\", \"envelope\": \"kupfer\"");
    let sized = bonded.replace("\"15 cm2/m\"", "\"15 cm2/m\", \"diameter\": \"16 mm\"");
    let file = read(&sized);
    let Behaviour::Concrete(concrete) = file.case.tank.courses[0].layers[2].material.behaviour else {
        panic!("concrete")
    };
    assert_eq!((concrete.bond, concrete.envelope), (tank::BarBond::Good, tank::BiaxialEnvelope::Kupfer));
    assert!((concrete.crack_spacing.unwrap() - 0.016 * 0.1 / (5.4 * 15e-4)).abs() < 1e-9);
    assert!(file.remarks.iter().any(|r| r.contains("materials.concrete: crack_spacing 198 mm")), "{:?}", file.remarks);
    has(
        &spoiled("\"2.9 MPa\"", "\"2.9 MPa\", \"bond\": \"good\""),
        &["layers[2].reinforcement[0]", "the bond of `concrete` needs the diameter of the bars"],
    );
    let source = Source::new("tank.json", sized.replace("\"bond\"", "\"tension_stiffening\": 0.3, \"bond\""));
    let text = parse(&source).expect_err("a fault").render(&source, false);
    has(&text, &["behaviour.concrete.bond", "this concrete cannot take a bond law"]);
}
