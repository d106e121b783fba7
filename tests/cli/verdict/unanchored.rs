//! Unanchored tanks, ground, pipes, and pressure above the liquid under EN 1998-4.

use results::VerdictStatus::{Fails, Holds, Incomplete};
use serde_json::json;

use super::*;

const EC8: &str = "ec8-2006";

fn tank(
    name: &'static str,
    why: &'static str,
    (status, first): (VerdictStatus, &'static str),
    changes: Vec<Value>,
) -> Tank {
    Tank::new(name, why, Expected::Verdict(status, EC8, first), changes)
}

/// Ground that carries a pressure [kPa].
fn ground(resistance: f64) -> Value {
    json!({ "site": { "ec8": { "bearing_capacity": format!("{resistance} kPa") } } })
}

/// Pipes with a support at a distance [m] that bear a displacement [mm].
fn pipes(distance: f64, allowed: f64) -> Value {
    json!({ "tank": { "pipes": {
        "support_distance": format!("{distance} m"), "allowable_displacement": format!("{allowed} mm")
    } } })
}

/// Gas above the liquid [kPa].
fn gas(internal: f64, vacuum: f64) -> Value {
    json!({ "tank": { "pressure": { "internal": format!("{internal} kPa"), "vacuum": format!("{vacuum} kPa") } } })
}

/// Those that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    let mut tanks = uplift();
    tanks.extend(ground_and_pipes());
    tanks.extend(pressure());
    tanks
}

fn uplift() -> Vec<Tank> {
    let fails = (Fails, "uplift");
    let soft = json!({ "materials": { "plate": {
        "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "50 MPa"
    } } });
    vec![
        tank(
            "plate-membrane",
            "76 % of the overturning moment lift the plate over some 0.4 m, near √(6·2450/83 400) m = 0.42 m where the joint yields: \
             210 GPa x (83.4 kPa x 0.4 m/14 mm)²/(6 x 0.91) = (60 MPa)³ > (50 MPa)³",
            fails,
            vec![
                ec8(0.12),
                unanchored(),
                soft,
                json!({ "tank": { "bottom": { "material": "plate", "thickness": "14 mm" } } }),
            ],
        )
        .open(&["uplift"]),
        tank(
            "plate-rotation",
            "on ground of 10 MN/m³ 90 % of the overturning moment turn the joint by more than 0.20 rad",
            fails,
            vec![
                ec8(0.16),
                unanchored(),
                json!({ "tank": { "bottom": { "subgrade_modulus": 10 } } }),
            ],
        )
        .open(&["uplift"]),
        tank(
            "plate-narrow",
            "the plate lifts over some 3.41 √(3760/83 400) m = 0.72 m, at least √(6·3760/83 400) m = 0.52 m once the joint yields",
            fails,
            vec![
                ec8(0.1),
                unanchored(),
                json!({ "tank": { "bottom": { "width": "0.3 m" } } }),
            ],
        )
        .open(&["uplift"]),
        tank(
            "plate-of-unknown-strength",
            "the hinges need the yield strength of the plate",
            (Incomplete, "uplift"),
            vec![
                ec8(0.02),
                unanchored(),
                json!({ "materials": { "plate": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3" } } }),
                json!({ "tank": { "bottom": { "material": "plate" } } }),
                accept(&["overturning", "buckling_elastic", "buckling_elastic_plastic"]),
            ],
        )
        .open(&["uplift"]),
        tank(
            "overturning-box",
            "2 g on 20 m x 10 m x 4 m of water: more than half of 10 MN at 2 m against less than 10 MN x (1 - 0.3 x 1.8) x 10 m",
            (Fails, "overturning"),
            vec![
                ec8(2.9),
                concrete_box(),
                unanchored(),
                json!({ "tank": { "length": "3 m" }, "liquid": { "fill_height": "3.5 m" } }),
                accept(&["freeboard"]),
            ],
        ),
    ]
}

fn ground_and_pipes() -> Vec<Tank> {
    vec![
        tank(
            "bearing",
            "8.5 m of water alone press with 83 kPa",
            (Fails, "bearing"),
            vec![only_ec8(), ground(80.0)],
        )
        .open(&["bearing"]),
        tank(
            "bearing-edge",
            "83 kPa of water and 5 kPa of steel; the moment adds 4 e/R of it: 12 MN x 0.25 g x 5 m = 15 MNm and more, 4 x 15/(27.6 x 10) = 22 %",
            (Fails, "bearing"),
            vec![only_ec8(), ground(95.0)],
        )
        .open(&["bearing"]),
        tank(
            "bearing-box",
            "4 m of water and walls on 100 m²: more than 39 kPa; a square box has one direction",
            (Fails, "bearing"),
            vec![
                only_ec8(),
                concrete_box(),
                json!({ "tank": { "length": "10 m" } }),
                ground(30.0),
                accept(&["anchorage"]),
            ],
        )
        .open(&["bearing"]),
        tank(
            "pipe-displacement",
            "d_g = 0.025 x 0.98 x 1.2 x 0.5 x 2 m = 29 mm over 500 m: 5.9 mm over 100 m > 1 mm",
            (Fails, "pipes"),
            vec![only_ec8(), pipes(100.0, 1.0)],
        )
        .open(&["pipes"]),
        tank(
            "pipe-torn-by-uplift",
            "the joint of the plate has yielded, so that the wall lifts by more than 3760²/(2 x 83 400 x 9846) m = 8.6 mm",
            (Fails, "pipes"),
            vec![ec8(0.1), unanchored(), pipes(5.0, 5.0)],
        )
        .open(&["pipes"]),
        tank(
            "pipes-without-support",
            "the distance of the support is not known",
            (Incomplete, "pipes"),
            vec![only_ec8(), json!({ "tank": { "pipes": { "allowable_displacement": "50 mm" } } })],
        )
        .open(&["pipes"]),
    ]
}

fn pressure() -> Vec<Tank> {
    vec![
        tank(
            "overpressure-foot",
            "83.4 + 250 kPa: static hoop stress 333 kPa x 10 m/14 mm = 238 MPa > f_y",
            (Fails, "buckling_elastic_plastic"),
            vec![only_ec8(), gas(250.0, 0.0), anchors(9000.0)],
        ),
        tank(
            "overpressure-anchors",
            "20 kPa x 10 m/2 = 100 kN/m every 1.57 m: 157 kN less 13 kN of weight, and more than 60 kN of the earthquake > 200 kN",
            (Fails, "anchorage"),
            vec![ec8(0.15), gas(20.0, 0.0)],
        ),
        tank(
            "overpressure-lifts",
            "20 kPa x 10 m/2 = 100 kN/m against 9 kN/m of weight and 44 kN/m of the plate",
            (Fails, "overturning"),
            vec![only_ec8(), unanchored(), gas(20.0, 0.0)],
        ),
        tank(
            "vacuum",
            "90 kPa x 10 m/2/4 mm = 112 MPa > 0.6 E s/R = 50 MPa",
            (Fails, "buckling_elastic"),
            vec![only_ec8(), gas(0.0, 90.0), wall(&[14.0, 12.0, 10.0, 4.0]), filled(4.0)],
        ),
        Tank::new(
            "vacuum-beyond-the-atmosphere",
            "there is no vacuum of 2 bar",
            Expected::Input("tank.pressure.vacuum"),
            vec![gas(0.0, 200.0)],
        ),
    ]
}

/// Those that hold.
pub(super) fn sound() -> Vec<Tank> {
    let holds = (Holds, ANY);
    vec![
        tank(
            "sound-unanchored-checked",
            "0.05 g: 12 MN x 0.15 g x 3.5 m = 6 MNm, π/4 D² x 53 kN/m = 17 MNm hold without uplift of more than millimetres",
            holds,
            vec![ec8(0.05), unanchored(), pipes(10.0, 50.0), ground(300.0)],
        )
        .open(&["uplift", "bearing", "pipes"]),
        tank(
            "sound-ground-and-pipes",
            "88 kPa and a fifth more on ground of 300 kPa; 6 mm of 50 mm",
            holds,
            vec![only_ec8(), pipes(100.0, 50.0), ground(300.0)],
        )
        .open(&["bearing", "pipes"]),
        tank(
            "sound-pressure",
            "2 kPa are 1.4 MPa of hoop stress and 10 kN/m at the anchors, 0.5 kPa of vacuum 0.2 MPa",
            holds,
            vec![only_ec8(), gas(2.0, 0.5)],
        ),
        tank(
            "sound-strip-unanchored",
            "4 m of water 20 m long do not overturn at 0.1 g",
            holds,
            vec![
                only_ec8(),
                concrete_box(),
                unanchored(),
                json!({ "tank": { "breadth": null, "strip": true } }),
                ground(200.0),
            ],
        )
        .open(&["bearing"]),
    ]
}
