//! `tank.isolators`.

use serde_json::{Value, json};
use tank::{Bearing, Isolators};

use super::{read, refused, small};

/// The smallest file on a slab with these isolators.
fn with(isolators: Value) -> Value {
    let mut file: Value = serde_json::from_str(&small("")).expect("a document");
    file["tank"]["foundation"] = json!({ "kind": "slab", "thickness": "0.6 m" });
    file["tank"]["isolators"] = isolators;
    file
}

fn pendulum() -> Value {
    json!({ "kind": "friction_pendulum", "radius": "2.2 m", "friction": 0.05 })
}

#[test]
fn properties_and_defaults() {
    let found = |isolators: Value| -> Isolators {
        let file = read(&with(isolators).to_string());
        assert!(file.warnings.iter().any(|w| w.contains("`tank.isolators`")));
        assert!(file.warnings.iter().all(|w| !w.contains("foundation.thickness")));
        file.case.tank.isolators.expect("isolators")
    };
    let sliding = found(pendulum());
    let expected = Bearing::FrictionPendulum { radius: 2.2, friction: 0.05, slow: 0.05, rate: 0.0, slip: 1e-3 };
    assert_eq!(sliding.bearing, expected);
    assert_eq!((sliding.bounds, sliding.damper), ([0.6, 1.8], None));
    // 2500 kg/m³ × 0.6 m × π (10 m)².
    assert!((sliding.slab_mass / (1500.0 * std::f64::consts::PI * 100.0) - 1.0).abs() < 1e-12);
    let rubber =
        found(json!({ "kind": "lead_rubber", "strength": "5 MN", "stiffness": "60 MN/m", "slab_mass": "900 t" }));
    let expected = Bearing::LeadRubber { strength: 5e6, initial: 6e8, yielded: 6e7 };
    assert_eq!((rubber.bearing, rubber.slab_mass), (expected, 9e5));
    let damper =
        found(json!({ "kind": "damper", "stiffness": "60 MN/m", "damper_coefficient": 5e6, "damper_exponent": 0.5 }));
    assert_eq!(damper.damper, Some([5e6, 0.5]));
    let beside =
        found(json!({ "kind": "elastomer", "stiffness": "60 MN/m", "damping": 0.12, "damper_coefficient": 5e6 }));
    assert_eq!(beside.damper, Some([5e6, 1.0]));
}

#[test]
fn bad_input_has_a_message() {
    let said = |file: Value, parts: &[&str]| {
        let text = refused(&file.to_string());
        for part in parts {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
        assert!(text.contains("1 fault in tank.json"), "{text}");
    };
    let mut bare = with(pendulum());
    bare["tank"]["foundation"] = Value::Null;
    bare["tank"].as_object_mut().expect("an object").remove("foundation");
    said(bare, &["tank.isolators", "isolators without a slab", "\"kind\": \"slab\""]);
    let mut soil = with(pendulum());
    soil["tank"]["foundation"] = json!({ "kind": "soil" });
    said(soil, &["tank.isolators", "isolators without a slab"]);
    let mut waves = with(pendulum());
    waves["tank"]["foundation"]["shear_wave_velocity"] = json!("200 m/s");
    said(waves, &["tank.foundation.shear_wave_velocity", "no engine follows both"]);
    let mut free = with(pendulum());
    free["tank"]["support"] = json!("unanchored");
    said(free, &["tank.isolators", "unanchored", "no engine follows uplift and isolators together"]);
    let missing = |isolators: Value, key: &str| {
        said(with(isolators), &[&format!("tank.isolators.{key}"), &format!("the key `{key}` is missing")]);
    };
    missing(json!({ "kind": "friction_pendulum", "friction": 0.05 }), "radius");
    missing(json!({ "kind": "friction_pendulum", "radius": "2 m" }), "friction");
    missing(json!({ "kind": "lead_rubber", "stiffness": "60 MN/m" }), "strength");
    missing(json!({ "kind": "elastomer", "stiffness": "60 MN/m" }), "damping");
    missing(json!({ "kind": "damper", "damper_coefficient": 1e6 }), "stiffness");
    let mut foreign = pendulum();
    foreign["strength"] = json!("5 MN");
    said(with(foreign), &["tank.isolators.strength", "does not apply to a friction pendulum", "lead_rubber"]);
    let mut slow = pendulum();
    slow["friction_slow"] = json!(0.06);
    said(with(slow), &["tank.isolators.friction_slow", "above that of fast sliding"]);
    let mut exponent = pendulum();
    exponent["damper_exponent"] = json!(0.5);
    said(with(exponent), &["tank.isolators.damper_exponent", "without dampers"]);
    let soft =
        json!({ "kind": "lead_rubber", "strength": "5 MN", "stiffness": "60 MN/m", "initial_stiffness": "50 MN/m" });
    said(with(soft), &["tank.isolators.initial_stiffness", "not above that after it"]);
    let heavy = json!({ "kind": "friction_pendulum", "radius": "2 m", "friction": 0.9 });
    said(with(heavy), &["tank.isolators.friction"]);
}
