//! Anchors as springs.

use super::{read, refused, small};

fn with(anchors: &str) -> String {
    small("").replace(
        "\"support\": \"anchored\",",
        &format!("\"support\": \"anchored\", \"anchors\": {{ \"count\": 36, {anchors} }},"),
    )
}

/// Each number in SI.
#[test]
fn anchors_have_a_stiffness() {
    let file = read(&with(
        r#""capacity": "120 kN", "stiffness": "80 MN/m", "yield_force": "150 kN", "gap": "1 mm", "rupture_elongation": "40 mm""#,
    ));
    let anchors = file.case.tank.anchors.unwrap();
    assert_eq!(anchors.stiffness, Some(80e6));
    assert_eq!(anchors.yield_force, Some(150e3));
    assert_eq!((anchors.gap, anchors.rupture_elongation), (Some(1e-3), Some(0.04)));
}

/// A spring without strength, one weaker than its design value, play without a spring, and rupture before yielding: each with its place.
#[test]
fn anchors_that_are_no_springs_are_refused() {
    for (anchors, place, allowed) in [
        (r#""stiffness": "80 MN/m""#, "tank.anchors.stiffness", "tank.anchors.capacity"),
        (
            r#""capacity": "120 kN", "stiffness": "80 MN/m", "yield_force": "100 kN""#,
            "tank.anchors.yield_force",
            "at least tank.anchors.capacity",
        ),
        (r#""capacity": "120 kN", "gap": "1 mm""#, "tank.anchors.gap", "together with tank.anchors.stiffness"),
        (
            r#""capacity": "120 kN", "stiffness": "80 MN/m", "rupture_elongation": "1 mm""#,
            "tank.anchors.rupture_elongation",
            "at least 1.50 mm",
        ),
    ] {
        let text = refused(&with(anchors));
        for part in [place, allowed] {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
    }
}
