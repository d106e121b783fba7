//! Tanks that must not hold, and why.

use results::VerdictStatus::{Fails, Incomplete};
use serde_json::json;

use super::*;

const EC8: &str = "ec8-2006";
const API: &str = "api650-2020";

pub(super) fn fails(
    name: &'static str,
    why: &'static str,
    (method, first): (&'static str, &'static str),
    changes: Vec<Value>,
) -> Tank {
    Tank::new(name, why, Expected::Verdict(Fails, method, first), changes)
}

pub(super) fn incomplete(
    name: &'static str,
    why: &'static str,
    (method, first): (&'static str, &'static str),
    changes: Vec<Value>,
) -> Tank {
    Tank::new(name, why, Expected::Verdict(Incomplete, method, first), changes)
}

/// All of them.
pub(super) fn tanks() -> Vec<Tank> {
    [
        api_walls(),
        api_base(),
        api_missing(),
        ec8_walls(),
        ec8_base(),
        ec8_missing(),
        gaps::tanks(),
        api_rest::failing(),
        details::failing(),
        unanchored::failing(),
        spectra::failing(),
        concrete::tanks(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Hoop and compression under API 650: allowable hoop stress 1.333 x 137 MPa = 182.6 MPa, below 0.9 x 235 MPa.
fn api_walls() -> Vec<Tank> {
    let hoop = (API, "hoop_stress");
    vec![
        fails(
            "hoop-bottom-course",
            "static hoop stress 83.4 kPa x 10 m/4 mm = 208 MPa",
            hoop,
            vec![only_api(), wall(&[4.0, 12.0, 10.0, 10.0])],
        ),
        fails(
            "hoop-second-course",
            "at 2.5 m 58.8 kPa x 10 m/3 mm = 196 MPa",
            hoop,
            vec![only_api(), wall(&[14.0, 3.0, 10.0, 10.0])],
        ),
        fails(
            "hoop-joint-efficiency",
            "allowed 0.35 x 182.2 MPa = 63.8 MPa, static 83.4 kPa x 10 m/13 mm = 64.1 MPa",
            hoop,
            vec![
                only_api(),
                wall(&[13.0, 12.0, 10.0, 10.0]),
                json!({ "site": { "api650": { "joint_efficiency": 0.35 } } }),
            ],
        ),
        fails(
            "hoop-heavy-liquid",
            "4 x 59.6 MPa",
            hoop,
            vec![only_api(), json!({ "liquid": { "density": "4000 kg/m3" } })],
        ),
        fails(
            "hoop-soft-plate",
            "allowed 1.333 x 40 MPa = 53.3 MPa, static 59.6 MPa",
            hoop,
            vec![only_api(), json!({ "materials": { "steel": { "allowable_stress": "40 MPa" } } })],
        ),
        fails(
            "compression-heavy-roof",
            "5000 t: 49.0 MN/62.8 m/14 mm = 55.7 MPa; 83 x 14/(2.5 x 20) + 7.5 √8.5 = 45.1 MPa; more on the thinner courses above",
            (API, "upper_compression"),
            vec![only_api(), roof(5000.0)],
        ),
        fails(
            "compression-thin-bottom-course",
            "2500 t: 24.5 MN/62.8 m/8 mm = 48.8 MPa; 83 x 8/(2.5 x 20) + 7.5 √8.5 = 35.1 MPa; 28 of 41 MPa on the courses above",
            (API, "shell_compression"),
            vec![only_api(), wall(&[8.0, 14.0, 14.0, 14.0]), roof(2500.0)],
        ),
        fails(
            "anchor-spacing",
            "π 20 m/16 = 3.93 m, allowed 3 m",
            (API, "anchor_spacing"),
            vec![only_api(), anchors(9000.0), json!({ "tank": { "anchors": { "count": 16 } } })],
        ),
        incomplete(
            "concrete-under-api",
            "a standard for steel tanks, though strengths are given",
            (API, "wall_material"),
            vec![
                only_api(),
                concrete(),
                json!({ "materials": { "concrete": { "yield_strength": "20 MPa", "allowable_stress": "10 MPa" } } }),
            ],
        ),
    ]
}

/// Anchors, stability, sliding, freeboard under API 650.
fn api_base() -> Vec<Tank> {
    let freeboard = (API, "freeboard");
    vec![
        fails(
            "anchors-weak",
            "A_i = 1.0 x 1.5/4, W_i = 0.47 x 26.2 MN at 3.2 m: 14.8 MNm, 47 kN/m less 9 kN/m of weight, every 1.57 m: 60 kN > 20 kN",
            (API, "anchor_tension"),
            vec![api(1.5, 0.6), anchors(20.0)],
        ),
        fails(
            "anchors-design-pressure",
            "P D/4 = 90 kN/m, every 1.57 m: 141 kN less 14 kN of weight > 100 kN",
            (API, "anchor_tension"),
            vec![only_api(), anchors(100.0), json!({ "site": { "api650": { "design_pressure": "18 kPa" } } })],
        ),
        fails(
            "not-self-anchored",
            "A_i = 0.2, W_i = 2.0 MN at 3.7 m: 1.5 MNm/36 m² = 41 kN/m over 3.7 kN/m of weight and 10.3 kN/m of liquid: J = 2.9 > 1.54",
            (API, "anchorage_ratio"),
            vec![api(0.6, 0.2), slim(), unanchored()],
        ),
        fails(
            "sliding",
            "A_i = 1.67 x 1.5/3.5 = 0.71 on at least a fifth of the weight against a friction of 0.05",
            (API, "sliding"),
            vec![
                api(2.5, 0.1),
                wall(&[30.0, 25.0, 20.0, 10.0]),
                unanchored(),
                json!({ "tank": { "radius": "20 m" }, "site": { "api650": { "friction": 0.05 } } }),
            ],
        ),
        fails(
            "vertical-motion",
            "1 - 0.4 A_v = 0 for A_v = 2.5 g: nothing presses on the ground",
            (API, "sliding"),
            vec![only_api(), unanchored(), json!({ "site": { "api650": { "av": 2.5 } } })],
        ),
        fails(
            "freeboard-api",
            "A_f = 1.5 x 0.52 x 4/4.8² = 0.14: wave 0.42 x 20 m x 0.14 = 1.1 m > 0.2 m",
            freeboard,
            vec![api(1.0, 0.6), filled(9.8), anchors(9000.0)],
        ),
        fails("brim-api", "no freeboard at all in seismic use group III", freeboard, vec![only_api(), filled(10.0)]),
    ]
}

/// Inputs that API 650 needs.
fn api_missing() -> Vec<Tank> {
    let plain = json!({ "materials": { "plate": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3" } } });
    vec![
        incomplete(
            "allowable-stress-missing",
            "no allowable stress",
            (API, "hoop_stress"),
            vec![json!({ "materials": { "steel": { "allowable_stress": null } } })],
        ),
        incomplete(
            "yield-strength-missing-api",
            "no yield strength",
            (API, "hoop_stress"),
            vec![only_api(), json!({ "materials": { "steel": { "yield_strength": null } } })],
        ),
        incomplete(
            "anchors-missing-api",
            "anchored by nothing",
            (API, "anchor_tension"),
            vec![only_api(), json!({ "tank": { "anchors": null } })],
        ),
        incomplete(
            "anchor-capacity-missing-api",
            "anchors of unknown strength",
            (API, "anchor_tension"),
            vec![only_api(), json!({ "tank": { "anchors": { "capacity": null } } })],
        ),
        incomplete(
            "bottom-plate-missing",
            "J needs the annulus",
            (API, "anchorage_ratio"),
            vec![only_api(), unanchored(), json!({ "tank": { "bottom": null } })],
        ),
        incomplete(
            "bottom-plate-of-unknown-strength",
            "J needs its yield strength",
            (API, "anchorage_ratio"),
            vec![only_api(), unanchored(), plain, json!({ "tank": { "bottom": { "material": "plate" } } })],
        ),
    ]
}

/// Hoop and stability under EN 1998-4. Where the hoop stress reaches the yield strength the elastic-plastic collapse has no capacity
/// left, so it comes before the hoop stress.
fn ec8_walls() -> Vec<Tank> {
    let foot = (EC8, "buckling_elastic_plastic");
    let elastic = (EC8, "buckling_elastic");
    vec![
        fails(
            "yielding-bottom-course",
            "static hoop stress 83.4 kPa x 10 m/3 mm = 278 MPa > 235 MPa",
            foot,
            vec![only_ec8(), wall(&[3.0, 12.0, 10.0, 10.0])],
        ),
        fails(
            "yielding-third-course",
            "at 5 m 34.3 kPa x 10 m/1 mm = 343 MPa > 235 MPa",
            foot,
            vec![only_ec8(), wall(&[14.0, 12.0, 1.0, 10.0])],
        ),
        fails(
            "yielding-aluminium",
            "static hoop stress 59.6 MPa > 50 MPa",
            foot,
            vec![
                only_ec8(),
                json!({ "materials": { "steel": {
                    "youngs_modulus": "69 GPa", "density": "2700 kg/m3", "yield_strength": "50 MPa"
                } } }),
            ],
        ),
        fails(
            "elephant-foot",
            "static hoop stress 139 MPa = 0.59 f_y leaves at most 0.65 σ_c1 (1 - 1/(1.12 + 4.17^1.15)) = 41 MPa; 1500 t are 39 MPa, \
             and the earthquake adds more than 10 MPa",
            foot,
            vec![ec8(0.15), wall(&[6.0; 4]), roof(1500.0), anchors(9000.0)],
        ),
        fails(
            "axial-compression",
            "3000 t: 29.4 MN/62.8 m/6 mm = 78 MPa > 0.6 E s/R = 75.6 MPa",
            elastic,
            vec![only_ec8(), wall(&[6.0; 4]), roof(3000.0), filled(1.0)],
        ),
        fails(
            "axial-compression-upper-course",
            "2500 t on 5 mm: 78 MPa > 63 MPa, on the 14 mm below 28 MPa",
            elastic,
            vec![only_ec8(), wall(&[14.0, 12.0, 10.0, 5.0]), roof(2500.0)],
        ),
    ]
}

/// Anchors, overturning, freeboard under EN 1998-4.
fn ec8_base() -> Vec<Tank> {
    let overturning = (EC8, "overturning");
    let freeboard = (EC8, "freeboard");
    vec![
        fails(
            "anchors-weak-ec8",
            "0.6 g on 2 MN at 3.7 m are 4.4 MNm, 157 kN/m every 0.94 m (π R² n = M, 40 anchors every 0.47 m): 70 kN > 20 kN",
            (EC8, "anchorage"),
            vec![ec8(0.2), slim(), anchors(20.0)],
        ),
        fails(
            "overturning",
            "more than 4 MNm; π/2 D² = 57 m² times 14 kN/m of weight and bottom plate holds 0.8 MNm",
            overturning,
            vec![ec8(0.2), slim(), unanchored()],
        ),
        incomplete(
            "overturning-without-bottom-plate",
            "more than 628 m² times 9 kN/m of the weight alone holds; what the plate adds is not known",
            overturning,
            vec![only_ec8(), unanchored(), json!({ "tank": { "bottom": null } })],
        ),
        fails(
            "freeboard-ec8",
            "0.84 x 10 m x S_e/g = 0.58 m for the 0.069 g at 4.7 s of 0.4 g on ground B > 0.2 m",
            freeboard,
            vec![ec8(0.4), filled(9.8), anchors(9000.0)],
        ),
        fails("brim-ec8", "no freeboard at all", freeboard, vec![only_ec8(), filled(10.0)]),
        fails("brim-box", "no freeboard at all", freeboard, vec![only_ec8(), concrete_box(), filled(5.0)]),
    ]
}

/// Inputs that EN 1998-4 needs.
fn ec8_missing() -> Vec<Tank> {
    vec![
        incomplete(
            "yield-strength-missing",
            "no yield strength",
            (EC8, "hoop_yield"),
            vec![only_ec8(), json!({ "materials": { "steel": { "yield_strength": null } } })],
        ),
        incomplete(
            "anchors-missing",
            "anchored by nothing",
            (EC8, "anchorage"),
            vec![json!({ "tank": { "anchors": null } })],
        ),
        incomplete(
            "anchor-capacity-missing",
            "anchors of unknown strength",
            (EC8, "anchorage"),
            vec![only_ec8(), json!({ "tank": { "anchors": { "capacity": null } } })],
        ),
        incomplete(
            "too-slender-for-vertical-motion",
            "H/R = 4.25, the pressures of A.3.3 end at 4: API 650 alone must not hold in its place",
            (EC8, "freeboard"),
            vec![slim(), json!({ "tank": { "radius": "2 m" } })],
        ),
    ]
}
