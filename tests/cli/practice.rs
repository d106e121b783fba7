//! Sound tanks of ordinary practice: each holds without an accepted gap, from a file that a datasheet fills.
//!
//! Source:    shells by the one-foot method of API 650 5.6.3.1, t = 4.9 D (H − 0.3) G/S, with S below the allowable stress, rounded up to
//!            whole millimetres and at least a usual thickness; roofs of 40 to 50 kg/m² of steel; walls of concrete 1/12 to 1/30 of a
//!            diameter with bars at both faces
//! Goal:      a tank that is sound and whose datasheet is complete is not held up by a question that nobody can answer: exit code 0,
//!            nothing accepted, fewer than 45 values in its file
//! Tolerance: none

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

/// Most values that a file may need.
const MOST: usize = 45;

/// A tank file.
#[derive(Clone)]
struct Tank {
    name: String,
    file: Value,
}

/// Number of values in a file: texts, numbers and truth values.
fn values(file: &Value) -> usize {
    match file {
        Value::Object(keys) => keys.values().map(values).sum(),
        Value::Array(items) => items.iter().map(values).sum(),
        _ => 1,
    }
}

/// Dimensions and liquid of a cylinder with courses of one height.
#[derive(Clone, Copy)]
struct Size {
    diameter: f64,
    courses: usize,
    /// Height of a course [m].
    height: f64,
    /// Level of the liquid [m].
    fill: f64,
    /// Density of the liquid [kg/m³].
    density: f64,
}

/// Plates of a shell.
#[derive(Clone, Copy)]
struct Plates {
    grade: &'static str,
    /// Stress of the one-foot method [MPa].
    stress: f64,
    /// Least thickness [mm].
    least: f64,
}

/// How a cylinder stands.
#[derive(Clone, Copy)]
enum Foot {
    /// On a slab: number of anchors, and design force of one [kN].
    Anchored(u32, f64),
    /// On a ring wall, with a plate under the wall of this width [m] and thickness [mm].
    Standing(f64, f64),
}

/// Ground accelerations [g] of the site: a_g, and S_S and S_1.
#[derive(Clone, Copy)]
struct Shaking {
    ec8: Option<f64>,
    api: Option<(f64, f64)>,
}

fn metal(kind: &str, size: Size, plates: Plates, roof: f64, foot: Foot, shaking: Shaking) -> Tank {
    let Size { diameter, height, fill, density, .. } = size;
    let course = |number: usize| {
        let head = fill - height * number as f64 - 0.3;
        let needed = 4.9 * diameter * head.max(0.0) * density / 1000.0 / plates.stress;
        let thickness = needed.max(plates.least).ceil();
        json!({ "height": format!("{height} m"), "thickness": format!("{thickness} mm"), "material": plates.grade })
    };
    let courses: Vec<Value> = (0..size.courses).map(course).collect();
    let area = std::f64::consts::FRAC_PI_4 * diameter * diameter;
    let mut tank = json!({
        "shape": "cylinder",
        "radius": format!("{} m", diameter / 2.0),
        "courses": courses,
        "roof": { "mass": format!("{:.1} t", roof * area / 1000.0), "snow": "none" },
        "pipes": {}
    });
    let pipes = |tank: &mut Value, key: &str, allowed: &str| tank["pipes"][key] = json!(allowed);
    let mut site = json!({});
    if let Some(ag) = shaking.ec8 {
        pipes(&mut tank, "support_distance", "10 m");
        pipes(&mut tank, "allowable_displacement", "100 mm");
        site["ec8"] = eurocode(ag, 0.4);
    }
    if let Some((ss, s1)) = shaking.api {
        for (key, allowed) in [("uplift", "100 mm"), ("settlement", "25 mm"), ("horizontal", "50 mm")] {
            pipes(&mut tank, key, allowed);
        }
        site["api650"] = json!({
            "ss": ss, "s1": s1, "site_class": "C", "sug": 1, "tl": 6.0, "foundation_weight": "1 MN", "bearing_capacity": "300 kPa"
        });
        tank["internals"] = json!("none");
        tank["adjacent_structures"] = json!("none");
    }
    match foot {
        Foot::Anchored(count, force) => {
            tank["support"] = json!("anchored");
            tank["foundation"] = json!({ "kind": "slab", "shell_support": "grouted" });
            tank["bottom"] = json!({ "thickness": "8 mm", "material": plates.grade });
            tank["anchors"] = json!({ "count": count, "capacity": format!("{force} kN") });
            if shaking.api.is_some() {
                tank["anchors"]["attachment_capacity"] = json!(format!("{} kN", 3.0 * force));
            }
        }
        Foot::Standing(width, thickness) => {
            tank["support"] = json!("unanchored");
            tank["foundation"] =
                json!({ "kind": "ring_wall", "width": "0.8 m", "thickness": "1 m", "shell_support": "grouted" });
            let thickness = format!("{thickness} mm");
            tank["bottom"] = json!({ "thickness": thickness, "width": format!("{width} m"), "material": plates.grade });
            if shaking.api.is_some() {
                tank["bottom"]["connections"] = json!("none");
            }
        }
    }
    Tank {
        name: format!("{kind}, {diameter} m"),
        file: json!({
            "name": kind,
            "tank": tank,
            "liquid": { "density": format!("{density} kg/m3"), "fill_height": format!("{fill} m") },
            "materials": { plates.grade: { "grade": plates.grade } },
            "site": site
        }),
    }
}

/// Site of Eurocode 8 on ground B.
///
/// * `ag`: ground acceleration [g]
fn eurocode(ag: f64, friction: f64) -> Value {
    json!({
        "ground": "B", "spectrum": 1, "ag": format!("{ag} g"), "friction": friction, "reduction_factor": 0.5,
        "bearing_capacity": "300 kPa"
    })
}

/// Bars of a wall of concrete at one face.
fn bars(direction: &str, diameter: u32, face: &str) -> Value {
    let mut bars = json!({ "direction": direction, "diameter": format!("{diameter} mm"), "spacing": "125 mm", "material": "bars" });
    bars[face] = json!("5 cm");
    bars
}

/// A tank of concrete under Eurocode 8, which stands by its weight.
///
/// * `plan`: keys of its shape; `[height, fill]` in metres, `thickness` in millimetres, `ag` in g
fn concrete(kind: &str, plan: Value, [height, fill]: [f64; 2], thickness: u32, ag: f64, hoop: bool) -> Tank {
    let mut reinforcement = vec![bars("vertical", 20, "from_inner"), bars("vertical", 16, "from_outer")];
    if hoop {
        reinforcement.extend([bars("hoop", 16, "from_inner"), bars("hoop", 16, "from_outer")]);
    }
    let mut tank = json!({
        "support": "unanchored",
        "roof": "none",
        "foundation": { "kind": "slab" },
        "bottom": { "thickness": "400 mm", "material": "concrete" },
        "courses": [{
            "height": format!("{height} m"), "thickness": format!("{thickness} mm"), "material": "concrete", "reinforcement": reinforcement
        }],
        "pipes": { "support_distance": "10 m", "allowable_displacement": "60 mm" }
    });
    for (key, value) in plan.as_object().into_iter().flatten() {
        tank[key] = value.clone();
    }
    Tank {
        name: format!("{kind}, {plan}"),
        file: json!({
            "name": kind,
            "tank": tank,
            "liquid": { "density": "1000 kg/m3", "fill_height": format!("{fill} m") },
            "materials": { "concrete": { "grade": "C30/37" }, "bars": { "grade": "B500B" } },
            "site": { "ec8": eurocode(ag, 0.5) }
        }),
    }
}

/// Plates of carbon steel; S_d of table 5-2 is 160 MPa.
const STEEL: Plates = Plates { grade: "A36", stress: 125.0, least: 6.0 };
/// Thick enough for a tank that lifts.
const STIFF: Plates = Plates { grade: "S355", stress: 130.0, least: 8.0 };
/// Stainless plates of both standards.
const STAINLESS: [Plates; 2] =
    [Plates { grade: "1.4301", stress: 120.0, least: 5.0 }, Plates { grade: "A240 304L", stress: 110.0, least: 5.0 }];
/// Aluminium.
const ALUMINIUM: Plates = Plates { grade: "EN AW-5083", stress: 75.0, least: 6.0 };

fn size(diameter: f64, courses: usize, height: f64, fill: f64, density: f64) -> Size {
    Size { diameter, courses, height, fill, density }
}

fn both(ag: f64) -> Shaking {
    Shaking { ec8: Some(ag), api: Some((3.0 * ag, ag)) }
}

fn ec8(ag: f64) -> Shaking {
    Shaking { ec8: Some(ag), api: None }
}

fn api(s1: f64) -> Shaking {
    Shaking { ec8: None, api: Some((3.0 * s1, s1)) }
}

/// Water tanks on anchors.
fn on_anchors() -> Vec<Tank> {
    let mut all = Vec::new();
    for (d, h, fill, count, force, ag) in [
        (4.0, 2.5, 4.3, 12, 100.0, 0.15),
        (5.0, 2.5, 4.2, 12, 100.0, 0.15),
        (6.0, 3.0, 5.2, 16, 120.0, 0.15),
        (8.0, 3.0, 5.2, 20, 120.0, 0.2),
        (10.0, 3.0, 5.2, 24, 150.0, 0.15),
        (14.0, 3.0, 5.2, 36, 150.0, 0.1),
    ] {
        let foot = Foot::Anchored(count, force);
        all.push(metal("steel on anchors, both codes", size(d, 2, h, fill, 1000.0), STEEL, 50.0, foot, both(ag)));
    }
    for (d, n, h, fill, ag) in [(12.0, 3, 2.4, 6.0, 0.15), (15.0, 4, 2.0, 7.0, 0.12), (18.0, 4, 2.4, 8.6, 0.12)] {
        let foot = Foot::Anchored(3 * d as u32, 200.0);
        for shaking in [ec8(ag), api(ag)] {
            let plates = Plates { stress: 110.0, ..STEEL };
            all.push(metal("steel on anchors", size(d, n, h, fill, 1000.0), plates, 50.0, foot, shaking));
        }
    }
    for (d, count) in [(4.0, 12), (6.0, 16)] {
        let foot = Foot::Anchored(count, 80.0);
        let size = size(d, 2, 2.5, 4.3, 1000.0);
        all.push(metal("stainless on anchors, both codes", size, STAINLESS[1], 40.0, foot, both(0.12)));
    }
    for (d, n, fill, count, force) in [(6.0, 3, 5.4, 16, 80.0), (8.0, 3, 5.4, 20, 80.0), (10.0, 4, 7.2, 24, 120.0)] {
        let foot = Foot::Anchored(count, force);
        all.push(metal("stainless on anchors", size(d, n, 2.0, fill, 1000.0), STAINLESS[0], 40.0, foot, ec8(0.12)));
    }
    for (d, count, force) in [(4.0, 12, 80.0), (5.0, 16, 80.0), (7.0, 20, 80.0), (8.0, 24, 120.0)] {
        let foot = Foot::Anchored(count, force);
        all.push(metal("aluminium on anchors", size(d, 3, 2.0, 5.4, 900.0), ALUMINIUM, 20.0, foot, ec8(0.1)));
    }
    all
}

/// Name of the tanks that lift under Eurocode 8.
const LIFTS: &str = "steel that lifts";

/// Oil tanks on their bottom plates; the last lift under Eurocode 8.
fn standing() -> Vec<Tank> {
    let mut all = Vec::new();
    for d in [12.0, 16.0, 20.0] {
        let size = size(d, 2, 3.0, 5.2, 860.0);
        all.push(metal("steel on its bottom, both codes", size, STEEL, 55.0, Foot::Standing(1.0, 7.0), both(0.08)));
    }
    for (d, n, fill, ag) in [(20.0, 4, 8.6, 0.1), (24.0, 4, 8.6, 0.1), (30.0, 5, 10.8, 0.08)] {
        let (size, foot) = (size(d, n, 2.4, fill, 860.0), Foot::Standing(1.0, 8.0));
        all.push(metal("steel on its bottom", size, STIFF, 55.0, foot, ec8(ag)));
        all.push(metal("steel on its bottom", size, STEEL, 55.0, Foot::Standing(1.0, 7.0), api(ag)));
    }
    for (d, ag) in [(12.0, 0.12), (14.0, 0.13), (16.0, 0.13), (20.0, 0.16)] {
        let size = size(d, 3, 2.4, 6.4, 860.0);
        all.push(metal(LIFTS, size, STIFF, 55.0, Foot::Standing(1.2, 8.0), ec8(ag)));
    }
    all
}

fn of_concrete() -> Vec<Tank> {
    let mut all = Vec::new();
    for (d, height, fill, thickness) in
        [(10.0, 4.0, 3.4, 300), (14.0, 4.0, 3.4, 300), (20.0, 5.0, 4.2, 350), (25.0, 5.0, 4.2, 400)]
    {
        let plan = json!({ "shape": "cylinder", "radius": format!("{} m", d / 2.0) });
        all.push(concrete("concrete cylinder", plan, [height, fill], thickness, 0.15, true));
    }
    for (length, height, fill, thickness) in
        [(8, 3.0, 2.4, 250), (10, 4.0, 3.2, 300), (12, 5.0, 4.0, 450), (15, 4.0, 3.2, 350)]
    {
        let plan = json!({ "shape": "rectangle", "length": format!("{length} m"), "strip": true });
        all.push(concrete("long basin", plan, [height, fill], thickness, 0.2, false));
    }
    for (length, breadth, height, fill, thickness) in
        [(8, 6, 3.0, 2.4, 250), (10, 8, 4.0, 3.2, 300), (12, 10, 4.0, 3.2, 350), (20, 10, 4.0, 3.2, 350)]
    {
        let plan = json!({ "shape": "rectangle", "length": format!("{length} m"), "breadth": format!("{breadth} m") });
        all.push(concrete("basin", plan, [height, fill], thickness, 0.15, true));
    }
    all
}

/// Whether the checks of EN 1998-4 found a rotation of the plate that lifts.
fn lifts(check: &Value) -> bool {
    let rows = check["checks"]["ec8-2006/site"].as_array().expect("checks of EN 1998-4");
    let rotation = rows.iter().find(|row| row["id"] == "uplift_rotation");
    rotation.is_some_and(|row| row["utilisation"].as_f64().is_some_and(|u| u > 1e-3))
}

#[test]
fn sound_tanks_of_ordinary_practice_hold() {
    let tanks = [on_anchors(), standing(), of_concrete()].concat();
    assert!(tanks.len() >= 40, "{}", tanks.len());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tank.json");
    let mut faults = Vec::new();
    for Tank { name, file } in &tanks {
        std::fs::write(&path, file.to_string()).unwrap();
        let output = tankcheck(&["check", path.to_str().unwrap(), "--format", "json"]);
        let needed = values(file);
        println!("{needed:3} values: {name}");
        let found = match output.status.code() {
            Some(0) => {
                let found: Value = serde_json::from_slice(&output.stdout).unwrap();
                if name.starts_with(LIFTS) && !lifts(&found) {
                    faults.push(format!("{name}: no uplift"));
                }
                found["verdict"]["counts"]["accepted"].clone()
            }
            _ => json!(format!("{}{}", String::from_utf8_lossy(&output.stdout), stderr(&output))),
        };
        if found != 0 || needed >= MOST {
            faults.push(format!("{name}, {needed} values: {found}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
