//! Tanks that the harmonic engine decides under a record: a sine of 2 s at 2.2 Hz, of 0.1 m/s² unless said otherwise.

use results::VerdictStatus::{Fails, Holds, Incomplete};
use serde_json::json;

use super::*;

const FE: &str = "fe";
/// A motion so weak that the static state decides [m/s²].
const WEAK: f64 = 0.1;

fn decides() -> Value {
    json!({ "procedures": { "decide": ["fe"] } })
}

fn tank(
    name: &'static str,
    why: &'static str,
    (status, first): (VerdictStatus, &'static str),
    changes: Vec<Value>,
) -> Tank {
    let changes = [vec![decides()], changes].concat();
    Tank::new(name, why, Expected::Verdict(status, FE, first), changes).run(WEAK)
}

/// Tanks that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    [walls(), base(), gaps()].into_iter().flatten().collect()
}

fn walls() -> Vec<Tank> {
    vec![
        tank(
            "engine-hoop-yields",
            "static 83.4 kPa x 10 m/3 mm = 278 MPa > 235 MPa at the bottom; the clamped edge takes little of it",
            (Fails, ANY),
            vec![only_ec8(), wall(&[3.0; 4])],
        ),
        tank(
            "engine-hoop-allowable",
            "static 58.8 kPa x 10 m/2.8 mm = 210 MPa at 2.5 m: above 182 MPa, below 235 MPa",
            (Fails, "hoop_stress"),
            vec![only_api(), wall(&[14.0, 2.8, 10.0, 10.0])],
        ),
        tank(
            "engine-axial-compression",
            "6000 t: 58.8 MN/62.8 m/10 mm = 94 MPa in the dry top course; σ_c1 = 126 MPa, σ_p = 67 MPa: 0.19 x 126 + 0.81 x 67 = 78 MPa",
            (Fails, "buckling_elastic"),
            vec![only_ec8(), roof(6000.0)],
        ),
        tank(
            "engine-axial-compression-api",
            "4000 t: 62 MPa in the top course, 83 x 10/(2.5 x 20) MPa + little",
            (Fails, "shell_compression"),
            vec![only_api(), roof(4000.0)],
        ),
        tank(
            "engine-elephant-foot",
            "83.4 kPa x 10 m/4 mm = 208 MPa of 235 MPa leaves 1 - 0.79 of σ_c1 = 50 MPa at the bottom: 500 t press with 20 MPa",
            (Fails, "buckling_elastic_plastic"),
            vec![only_ec8(), wall(&[4.0, 6.0, 6.0, 6.0]), roof(500.0)],
        ),
    ]
}

fn base() -> Vec<Tank> {
    vec![
        tank(
            "engine-freeboard",
            "filled to the brim",
            (Fails, "freeboard"),
            vec![filled(10.0)],
        ),
        tank(
            "engine-sliding",
            "5 m/s² on a liquid that moves with it by half, friction 0.1",
            (Fails, "sliding"),
            vec![
                only_ec8(),
                anchors(90000.0),
                wall(&[28.0, 24.0, 20.0, 20.0]),
                json!({ "site": { "ec8": { "friction": 0.1 } } }),
            ],
        )
        .open(&["sliding"])
        .run(3.0),
        tank(
            "engine-anchors-weak",
            "anchors of 1 kN every 1.57 m; 1.5 m/s² pull more than the weight of 9 kN/m",
            (Fails, "anchorage"),
            vec![anchors(1.0)],
        )
        .run(1.5),
    ]
}

fn gaps() -> Vec<Tank> {
    vec![
        tank(
            "engine-anchors-missing",
            "the wall pulls, and the anchors are not given",
            (Incomplete, "anchorage"),
            vec![json!({ "tank": { "anchors": null } })],
        )
        .run(1.5),
        tank(
            "engine-unanchored-pulls",
            "a clamped base stands for an unanchored tank; that cannot be accepted",
            (Incomplete, "uplift_tension"),
            vec![
                unanchored(),
                accept(&["uplift_tension", "hoop_yield", "hoop_stress", "shell_compression"]),
            ],
        )
        .run(1.5),
        tank(
            "engine-friction-missing",
            "no friction is given",
            (Incomplete, "sliding"),
            vec![only_ec8()],
        )
        .open(&["sliding"]),
        tank(
            "engine-yield-missing",
            "no yield strength is given",
            (Incomplete, ANY),
            vec![
                only_ec8(),
                json!({ "materials": { "steel": { "yield_strength": null } } }),
            ],
        ),
        tank(
            "engine-concrete",
            "the strength of concrete is not implemented",
            (Incomplete, "wall_strength"),
            vec![only_ec8(), concrete(), anchors(90000.0)],
        ),
        tank(
            "engine-box",
            "the strength of a box is not implemented",
            (Incomplete, "wall_strength"),
            vec![only_ec8(), concrete_box(), accept(&["anchorage"])],
        ),
        tank(
            "engine-roof-impact",
            "the wave rises above the wall, under a roof",
            (Fails, "freeboard"),
            vec![filled(9.99), roof(10.0)],
        )
        .run(3.0),
    ]
}

/// Tanks that hold.
pub(super) fn sound() -> Vec<Tank> {
    vec![
        tank("engine-sound", "the base tank", (Holds, ANY), vec![]),
        tank(
            "engine-sound-ec8",
            "one code, stronger motion",
            (Holds, ANY),
            vec![only_ec8()],
        )
        .run(0.5),
        tank("engine-sound-api", "one code", (Holds, ANY), vec![only_api()]),
        tank(
            "engine-sound-unanchored",
            "so weak a motion that the wall does not pull",
            (Holds, ANY),
            vec![unanchored()],
        ),
        tank(
            "engine-sound-friction",
            "friction 0.4",
            (Holds, ANY),
            vec![only_ec8(), json!({ "site": { "ec8": { "friction": 0.4 } } })],
        )
        .open(&["sliding"]),
    ]
}
