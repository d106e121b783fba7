//! Tanks for number and spacing of anchors, details of the base, answers about the construction, and families of materials.

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

/// Anchors in number, of a capacity that holds whatever pulls.
fn count(number: u32) -> Value {
    json!({ "tank": { "anchors": { "count": number, "capacity": "90 MN" } } })
}

/// 1.5 m of radius, 4.5 m of water: it pulls at its anchors, five of which are one every 1.9 m.
fn post() -> Value {
    let mut tank = slim();
    merge(&mut tank, &json!({ "tank": { "radius": "1.5 m" } }));
    merge(&mut tank, &filled(4.5));
    tank
}

fn foundation(value: Value) -> Value {
    json!({ "tank": { "foundation": value } })
}

/// Allowable pressure on the ground under API 650 [kPa].
fn ground(kpa: f64) -> Value {
    json!({ "site": { "api650": { "bearing_capacity": format!("{kpa} kPa") } } })
}

/// A material in place of the steel.
fn material(value: Value) -> Value {
    json!({ "materials": { "steel": value } })
}

fn polymer() -> Value {
    material(
        json!({ "family": "polymer", "youngs_modulus": "12 GPa", "density": "1800 kg/m3", "yield_strength": "200 MPa" }),
    )
}

/// Those that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    [anchors_in_number(), base(), answers(), materials()].into_iter().flatten().collect()
}

fn anchors_in_number() -> Vec<Tank> {
    let few = "six anchors where the earthquake pulls at them, and five are one every 1.9 m";
    let one = "a single anchor on 62.8 m of wall carries no moment";
    vec![
        fails("five-anchors-api", few, (API, "anchor_count"), vec![api(1.0, 0.4), post(), count(5)]),
        fails("five-anchors-ec8", few, (EC8, "anchor_count"), vec![ec8(0.3), post(), count(5)]),
        fails("one-anchor-api", one, (API, "anchor_spacing"), vec![only_api(), count(1)]),
        fails("one-anchor-ec8", one, (EC8, "anchor_spacing"), vec![only_ec8(), count(1)]),
        fails("four-anchors-ec8", "62.8 m/4 = 15.7 m > 3.05 m", (EC8, "anchor_spacing"), vec![ec8(0.3), count(4)]),
    ]
}

fn base() -> Vec<Tank> {
    let thick = json!({ "tank": { "bottom": { "thickness": "12 mm", "annular_weld": "lap" } } });
    vec![
        fails(
            "lapped-annular-plates",
            "annular plates thicker than 10 mm are butt-welded",
            (API, "annular_weld"),
            vec![only_api(), unanchored(), thick],
        ),
        incomplete(
            "important-without-annular-weld",
            "seismic use group III with S_DS = 2/3 x 1.0 x 1.0 = 0.67 g asks for butt welds, self-anchored",
            (API, "annular_weld"),
            vec![api(1.0, 0.1), unanchored(), filled(3.0)],
        ),
        fails(
            "no-weld-between-shell-and-bottom",
            "A_i = 0.24 x 1.5/4 = 0.09: 1.6 MN of 18 MN, 2 x 1.6 MN/(31.4 x 20 m)... = 50 kN/m on 0.14 mm of throat = 360 MPa > 188 MPa",
            (API, "shear_transfer"),
            vec![only_api(), json!({ "tank": { "bottom": { "shell_weld": "0.1 mm" } } })],
        ),
        fails(
            "soft-ground-under-api",
            "83.4 kPa of water on ground for 80 kPa",
            (API, "bearing"),
            vec![only_api(), foundation(json!({ "kind": "slab" })), ground(80.0)],
        )
        .open(&["bearing"]),
        fails(
            "narrow-ring-wall",
            "9 kN/m of wall and more of the earthquake on 3 cm: above 300 kPa",
            (API, "bearing"),
            vec![only_api(), foundation(json!({ "kind": "ring_wall", "width": "3 cm" })), ground(300.0)],
        )
        .open(&["bearing"]),
        incomplete(
            "ground-of-unknown-strength-api",
            "the annex asks for the pressure on the ground",
            (API, "bearing"),
            vec![only_api()],
        )
        .open(&["bearing"]),
        fails(
            "anchored-on-a-pad",
            "a mechanically anchored tank stands on shims and grout",
            (API, "shell_support"),
            vec![only_api(), foundation(json!({ "kind": "slab", "shell_support": "padding" }))],
        ),
        incomplete(
            "shell-support-not-accepted",
            "what the shell stands on is not known",
            (API, "shell_support"),
            vec![only_api()],
        )
        .open(&["shell_support"]),
        fails(
            "outlet-in-the-lifted-plate",
            "L is at least 0.45 m: 0.75 m to the reinforcement",
            (API, "connections"),
            vec![only_api(), unanchored(), json!({ "tank": { "bottom": { "connections": "0.5 m" } } })],
        ),
        incomplete(
            "connections-not-accepted",
            "the attachment of the anchors is not known",
            (API, "connections"),
            vec![only_api()],
        )
        .open(&["connections"]),
    ]
}

fn answers() -> Vec<Tank> {
    let not = "the tank file does not say";
    let silent = |key: &str| json!({ "tank": { key: null } });
    let soft = json!({ "site": { "ec8": { "ground": "D" } } });
    let roof_alone = json!({ "tank": { "roof": { "mass": "30 t" } } });
    let study = json!({ "site": { "api650": { "asce7": 2016, "site_class": "D", "s1": 0.25, "ss": 0.5 } } });
    vec![
        incomplete("internals-unknown", not, (API, "internals"), vec![only_api(), silent("internals")]),
        incomplete(
            "internals-present",
            "their loads are not computed",
            (API, "internals"),
            vec![only_api(), json!({ "tank": { "internals": "present" } })],
        ),
        incomplete(
            "neighbours-unknown",
            not,
            (API, "adjacent_structures"),
            vec![only_api(), silent("adjacent_structures")],
        ),
        incomplete("snow-unknown-api", not, (API, "snow"), vec![only_api(), roof_alone.clone()]),
        incomplete("snow-unknown-ec8", not, (EC8, "snow"), vec![only_ec8(), roof_alone]),
        incomplete(
            "soft-site-without-study",
            "ASCE 7-16 11.4.8 asks for a study on site class D from S_1 = 0.2 g on",
            (API, "site_study"),
            vec![only_api(), study],
        ),
        incomplete(
            "vacuum-under-api",
            "annex V is not implemented",
            (API, "vacuum"),
            vec![only_api(), json!({ "tank": { "pressure": { "vacuum": "0.1 kPa" } } })],
        ),
        incomplete(
            "ground-type-d",
            "shear waves slower than 100 m/s are possible",
            (EC8, "soil_structure_interaction"),
            vec![only_ec8(), soft.clone()],
        ),
        incomplete(
            "peat",
            "80 m/s",
            (EC8, "soil_structure_interaction"),
            vec![only_ec8(), soft, foundation(json!({ "kind": "soil", "shear_wave_velocity": "80 m/s" }))],
        ),
        fails(
            "wave-along-the-breadth",
            "0.1 m of freeboard: T = 2.0 s and 0.811 x 1.5 m x 0.103 = 0.125 m along 3 m, T = 6.3 s and 0.08 m along 20 m",
            (EC8, "other_direction"),
            vec![
                only_ec8(),
                concrete_box(),
                json!({ "tank": { "breadth": "3 m" } }),
                filled(4.9),
                accept(&["overturning", "anchorage"]),
            ],
        ),
    ]
}

fn materials() -> Vec<Tank> {
    let open = "no clause is for such a wall";
    let doubtful = || material(json!({ "youngs_modulus": "200 GPa", "density": "7800 kg/m3" }));
    let unknown = "200 GPa and 7800 kg/m³ are those of carbon steel and of duplex steel";
    vec![
        incomplete("polymer-under-eurocode", open, (EC8, "wall_material"), vec![only_ec8(), polymer()]),
        incomplete("polymer-under-api", open, (API, "wall_material"), vec![only_api(), polymer()]),
        incomplete("doubtful-steel-ec8", unknown, (EC8, "wall_material"), vec![only_ec8(), doubtful()]),
        incomplete("doubtful-steel-api", unknown, (API, "wall_material"), vec![only_api(), doubtful()]),
        Tank::new(
            "grade-of-another-family",
            "A240 304L is stainless steel",
            Expected::Input("materials.steel.family"),
            vec![material(json!({ "grade": "A240 304L", "family": "carbon_steel" }))],
        ),
    ]
}

/// Those that hold.
pub(super) fn sound_tanks() -> Vec<Tank> {
    let stainless = || {
        let mut change = material(Value::Null);
        change["materials"]["steel"] = Value::Null;
        let grade = json!({ "materials": { "steel": { "grade": "A240 304L" } } });
        [change, grade]
    };
    let [removed, stainless] = stainless();
    let slab = |support: &str| foundation(json!({ "kind": "slab", "shell_support": support }));
    vec![
        sound(
            "sound-stainless-api",
            "S_d = 145 MPa and 0.9 x 170 MPa; 0.975 x 45 MPa of compression",
            API,
            vec![only_api(), removed.clone(), stainless.clone()],
        ),
        sound("sound-stainless-ec8", "f_y = 170 MPa", EC8, vec![only_ec8(), removed, stainless]),
        sound(
            "sound-doubtful-steel-named",
            "the family is given",
            API,
            vec![
                only_api(),
                material(json!({ "youngs_modulus": "200 GPa", "density": "7800 kg/m3", "family": "carbon_steel" })),
            ],
        ),
        sound(
            "sound-slab-under-api",
            "83.4 kPa and some of the earthquake on ground for 250 kPa",
            API,
            vec![only_api(), slab("grouted"), ground(250.0)],
        )
        .open(&["bearing", "shell_support"]),
        sound(
            "sound-ring-wall-under-api",
            "60 cm of ring wall",
            API,
            vec![
                only_api(),
                unanchored(),
                foundation(json!({ "kind": "ring_wall", "width": "60 cm", "shell_support": "padding" })),
                ground(250.0),
                json!({ "tank": { "bottom": { "connections": "none" } } }),
            ],
        )
        .open(&["bearing", "shell_support", "connections"]),
        sound(
            "sound-butt-welded-on-concrete",
            "butt-welded plates may lie on the concrete",
            API,
            vec![
                only_api(),
                unanchored(),
                slab("butt_welded"),
                json!({ "tank": { "bottom": { "annular_weld": "butt", "connections": "3 m" } } }),
            ],
        )
        .open(&["shell_support", "connections"]),
        sound("sound-six-anchors", "six anchors on 9.4 m of wall", EC8, vec![ec8(0.3), post(), count(6)]),
        sound(
            "sound-firm-clay",
            "150 m/s on ground type D",
            EC8,
            vec![
                only_ec8(),
                json!({ "site": { "ec8": { "ground": "D" } } }),
                foundation(json!({ "kind": "soil", "shear_wave_velocity": "150 m/s" })),
            ],
        ),
        sound(
            "sound-snow-included",
            "the roof has its snow",
            API,
            vec![json!({ "tank": { "roof": { "mass": "30 t", "snow": "included" } } })],
        ),
    ]
}
