//! Tanks for corrosion, design pressure, pipes, floating roofs and aluminium under API 650.

use results::VerdictStatus::{Fails, Holds};
use serde_json::json;

use super::failing::incomplete;
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

fn aluminium() -> Value {
    json!({ "materials": { "steel": { "youngs_modulus": "69 GPa", "density": "2700 kg/m3" } } })
}

/// Displacements that the pipes allow [mm]: up, down, horizontally.
fn pipes([up, down, horizontal]: [f64; 3]) -> Value {
    let mm = |value: f64| format!("{value} mm");
    json!({ "tank": { "pipes": { "uplift": mm(up), "settlement": mm(down), "horizontal": mm(horizontal) } } })
}

/// A floating roof [t] with a rim [m].
fn floating(tonnes: f64, rim: f64) -> Value {
    let roof = json!({ "type": "floating", "mass": format!("{tonnes} t"), "rim": format!("{rim} m") });
    json!({ "tank": { "roof": roof } })
}

fn pressure(kpa: f64) -> Value {
    json!({ "site": { "api650": { "design_pressure": format!("{kpa} kPa") } } })
}

/// Joint efficiency.
fn joints(efficiency: f64) -> Value {
    json!({ "site": { "api650": { "joint_efficiency": efficiency } } })
}

/// Those that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    vec![
        fails(
            "corroded-bottom-course",
            "5 mm left: 83.4 kPa x 10 m/5 mm = 167 MPa static, the earthquake more than the rest to 182.6 MPa; 14 mm hold",
            (API, "hoop_stress"),
            vec![only_api(), corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "10 mm")],
        ),
        fails(
            "measured-bottom-course",
            "4 mm measured: 83.4 kPa x 10 m/4 mm = 208 MPa",
            (API, "hoop_stress"),
            vec![only_api(), corroded(&[14.0, 12.0, 10.0, 10.0], "measured_thickness", "4 mm")],
        ),
        fails(
            "corroded-under-eurocode",
            "3 mm left: 83.4 kPa x 10 m/3 mm = 278 MPa > 235 MPa",
            (EC8, "buckling_elastic_plastic"),
            vec![only_ec8(), corroded(&[14.0, 12.0, 10.0, 10.0], "corrosion_allowance", "11 mm")],
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
        fails(
            "corroded-compression",
            "2000 t on 8 mm of 14 mm: 19.6 MN/62.8 m/8 mm = 39 MPa; 83 x 8/(2.5 x 20) + 7.5 √8.5 = 35 MPa; 45 MPa for 14 mm",
            (API, "shell_compression"),
            vec![only_api(), corroded(&[14.0; 4], "corrosion_allowance", "6 mm"), roof(2000.0)],
        ),
        fails(
            "pressure-above-the-liquid",
            "(83.4 + 18) kPa x 10 m/12 mm = 84.5 MPa > 0.45 x 182.2 MPa",
            (API, "pressure_hoop"),
            vec![only_api(), wall(&[12.0; 4]), anchors(9000.0), pressure(18.0), joints(0.45)],
        ),
        fails(
            "pressure-on-the-dry-wall",
            "18 kPa x 10 m/2 mm = 90 MPa > 0.45 x 182.2 MPa on a course that the liquid does not reach",
            (API, "pressure_hoop"),
            vec![
                only_api(),
                filled(4.0),
                wall(&[14.0, 12.0, 12.0, 2.0]),
                anchors(9000.0),
                pressure(18.0),
                joints(0.45),
            ],
        ),
        fails(
            "pipes-too-stiff",
            "an anchored tank moves its pipes by 25 mm upwards",
            (API, "piping"),
            vec![only_api(), pipes([20.0, 20.0, 20.0])],
        )
        .open(&["piping"]),
        fails(
            "pipes-too-stiff-sideways",
            "a tank on the ground moves its pipes by 50 mm",
            (API, "piping"),
            vec![only_api(), unanchored(), pipes([500.0, 30.0, 20.0])],
        )
        .open(&["piping"]),
        incomplete(
            "pipes-of-unknown-settlement",
            "one of three displacements is missing",
            (API, "piping"),
            vec![only_api(), json!({ "tank": { "pipes": { "uplift": "30 mm", "horizontal": "30 mm" } } })],
        )
        .open(&["piping"]),
        fails(
            "aluminium-under-api",
            "1700 t: 16.7 MN/62.8 m/14 mm = 19 MPa; 69/200 (83 x 14/(2.5 x 20) + 7.5 √8.5) = 15.6 MPa, of steel 45 MPa; more above",
            (API, "upper_compression"),
            vec![only_api(), aluminium(), roof(1700.0)],
        ),
        Tank::new(
            "pressure-beyond-annex-f",
            "annex F ends at 18 kPa",
            Expected::Input("site.api650.design_pressure"),
            vec![pressure(19.0)],
        ),
        incomplete(
            "titanium-under-api",
            "neither steel nor aluminium",
            (API, "wall_material"),
            vec![
                only_api(),
                json!({ "materials": { "steel": { "youngs_modulus": "110 GPa", "density": "4500 kg/m3", "family": "other_metal" } } }),
            ],
        ),
        fails(
            "floating-roof-at-the-top",
            "freeboard of 1.5 m less 1.4 m of rim = 0.1 m; 0.42 x 20 m x 1.5 x 0.113 x 4/4.8² = 0.25 m",
            (API, "freeboard"),
            vec![only_api(), floating(30.0, 1.4)],
        ),
        fails(
            "floating-roof-under-eurocode",
            "the rim is above the wall",
            (EC8, "freeboard"),
            vec![only_ec8(), floating(30.0, 1.6)],
        ),
        Tank::new(
            "floating-roof-sinks",
            "3000 t on 2670 t of water",
            Expected::Input("tank.roof.mass"),
            vec![floating(3000.0, 0.0)],
        ),
        Tank::new(
            "rim-of-a-fixed-roof",
            "a fixed roof has no rim on the liquid",
            Expected::Input("tank.roof.rim"),
            vec![json!({ "tank": { "roof": { "mass": "30 t", "rim": "1 m" } } })],
        ),
        incomplete(
            "weight-alone-is-not-enough",
            "J without the plate is above 0.785 on 9 kN/m of wall, so the plate is needed",
            (API, "anchorage_ratio"),
            vec![api(1.0, 0.2), unanchored(), json!({ "tank": { "bottom": null } })],
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
        sound(
            "sound-under-pressure",
            "(83.4 + 18) kPa x 10 m/14 mm = 72 MPa; anchors for 18 kPa x 5 m = 90 kN/m",
            API,
            vec![only_api(), pressure(18.0)],
        ),
        sound("sound-pipes", "25, 13 and 13 mm", API, vec![only_api(), pipes([25.0, 13.0, 13.0])]).open(&["piping"]),
        sound(
            "sound-aluminium-under-api",
            "below 1 MPa of 15.6 MPa; static hoop stress 59.6 MPa",
            API,
            vec![only_api(), aluminium()],
        ),
        sound(
            "sound-floating-roof",
            "2500 t, which the wall of `compression-thin-bottom-course` does not carry, on the liquid",
            API,
            vec![only_api(), wall(&[8.0, 14.0, 14.0, 14.0]), floating(2500.0, 0.5)],
        ),
        sound("sound-floating-roof-under-eurocode", "the same", EC8, vec![only_ec8(), floating(100.0, 0.3)]),
        sound(
            "sound-without-plate",
            "2000 t of roof: 312 kN/m keep the shell down without the plate; 28 of 45 MPa",
            API,
            vec![only_api(), unanchored(), roof(2000.0), wall(&[14.0; 4]), json!({ "tank": { "bottom": null } })],
        ),
    ]
}
