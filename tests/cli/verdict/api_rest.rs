//! Tanks for corrosion, design pressure, pipes, floating roofs and aluminium under API 650.

use results::VerdictStatus::{Fails, Holds};
use serde_json::json;

use super::*;

const EC8: &str = "ec8-2006";
const API: &str = "api650-2020";

fn fails(
    name: &'static str,
    why: &'static str,
    (method, first): (&'static str, &'static str),
    changes: Vec<Value>,
) -> Tank {
    Tank::new(name, why, Expected::Verdict(Fails, method, first), changes)
}

fn sound(name: &'static str, why: &'static str, method: &'static str, changes: Vec<Value>) -> Tank {
    Tank::new(name, why, Expected::Verdict(Holds, method, ANY), changes)
}

/// Courses 2.5 m high of steel [mm], the lowest with a further key.
fn corroded(thicknesses: &[f64], key: &str, value: &str) -> Value {
    let mut tank = wall(thicknesses);
    tank["tank"]["courses"][0][key] = json!(value);
    tank
}

/// Those that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    vec![
        fails(
            "corroded-bottom-course",
            "5 mm left: 83.4 kPa x 10 m/5 mm = 167 MPa static, the earthquake more than the rest to 182.6 MPa; 14 mm hold",
            (API, "hoop_stress"),
            vec![
                only_api(),
                corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "10 mm"),
            ],
        ),
        fails(
            "measured-bottom-course",
            "4 mm measured: 83.4 kPa x 10 m/4 mm = 208 MPa",
            (API, "hoop_stress"),
            vec![
                only_api(),
                corroded(&[14.0, 12.0, 10.0, 10.0], "measured_thickness", "4 mm"),
            ],
        ),
        fails(
            "corroded-under-eurocode",
            "3 mm left: 83.4 kPa x 10 m/3 mm = 278 MPa > 235 MPa",
            (EC8, "buckling_elastic_plastic"),
            vec![
                only_ec8(),
                corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "11 mm"),
            ],
        ),
        Tank::new(
            "corroded-through",
            "nothing is left",
            Expected::Input("tank.courses[0].corrosion_allowance"),
            vec![corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "14 mm")],
        ),
        Tank::new(
            "measured-thicker-than-built",
            "corrosion takes",
            Expected::Input("tank.courses[0].measured_thickness"),
            vec![corroded(&[14.0, 12.0, 10.0, 10.0], "measured_thickness", "15 mm")],
        ),
    ]
}

/// Those that hold.
pub(super) fn sound_tanks() -> Vec<Tank> {
    vec![
        sound(
            "sound-corroded",
            "12 mm left: 83.4 kPa x 10 m/12 mm = 69.5 MPa",
            API,
            vec![corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "2 mm")],
        ),
        sound(
            "sound-measured",
            "12 mm left",
            EC8,
            vec![corroded(&[14.0, 12.0, 10.0, 10.0], "measured_thickness", "12 mm")],
        ),
    ]
}
