//! `analysis.damping.dashpots`.

use tank::options::linear::{DampingModel, Dashpots, WallDirection};

use super::{read, refused, small};

/// Alone with the modal ratios, or beside a damping model; faulty values are named with their path.
#[test]
fn dashpots() {
    let of = |given: &str| small(&format!(r#", "analysis": {{ "damping": {given} }}"#));
    let one = r#""dashpots": [{ "z": "2 m", "coefficient": 2e5 }]"#;
    let found = read(&of(&format!("{{ {one} }}")));
    let ring = |z, direction| Dashpots { z, direction, coefficient: 2e5 };
    assert_eq!(found.fe.dashpots, [ring(2.0, WallDirection::Radial)]);
    assert_eq!(found.fe.damping, DampingModel::Modal);
    let beside = r#"{ "coefficients": { "mass": 0.1, "stiffness": "0.001 s" },
        "dashpots": [{ "z": "1 m", "direction": "vertical", "coefficient": 2e5 }] }"#;
    let found = read(&of(beside));
    assert_eq!(found.fe.dashpots, [ring(1.0, WallDirection::Vertical)]);
    assert!(matches!(found.fe.damping, DampingModel::Coefficients { .. }));
    for (given, path, message) in [
        (r#"{ "z": "8.1 m", "coefficient": 1 }"#, "dashpots[0].z", "the height of the wall"),
        (r#"{ "z": "0 m", "coefficient": 1 }"#, "dashpots[0].z", "0"),
        (r#"{ "z": "1 m", "coefficient": -1 }"#, "dashpots[0].coefficient", "0"),
        (r#"{ "z": "1 m" }"#, "dashpots[0]", "coefficient"),
        (r#"{ "z": "1 m", "coefficient": 1, "direction": "up" }"#, "dashpots[0].direction", "vertical"),
    ] {
        let text = refused(&of(&format!(r#"{{ "dashpots": [{given}] }}"#)));
        assert!(text.contains(path) && text.contains(message), "{text}");
    }
}
