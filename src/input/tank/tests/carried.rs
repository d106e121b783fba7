//! `tank.rings`, `tank.attachments` and `tank.insulation`.

use std::f64::consts::PI;

use super::{read, refused, small};

/// The smallest file with two courses and these members of the tank.
fn with(more: &str) -> String {
    small("")
        .replace("[ {", "[ { \"height\": \"2.4 m\", \"thickness\": \"12 mm\", \"material\": \"steel\" }, {")
        .replace("\"anchored\",", &format!("\"anchored\", {more},"))
}

#[test]
fn masses_by_hand() {
    let bare = read(&with("\"strip\": false").replace("\"strip\": false,", "")).case.tank;
    let tank = read(&with(
        r#""rings": [ { "height": "10.4 m", "area": "24 cm2", "inertia": "820 cm4", "material": "steel" },
                      { "height": "8 m", "width": "200 mm", "thickness": "10 mm", "material": "steel" } ],
           "attachments": [ { "name": "stairs", "mass": "1.2 t", "height": "5 m" },
                            { "name": "platform", "mass": "800 kg", "height": "10 m" } ]"#,
    ))
    .case
    .tank;
    let [angle, plate] = tank.rings.as_slice() else { panic!("{:?}", tank.rings) };
    assert_eq!((angle.area, angle.inertia, angle.height), (24e-4, 820e-8, 10.4));
    // b t and t b³/12.
    assert!((plate.area - 2e-3).abs() < 1e-18 && (plate.inertia - 0.01 * 0.008 / 12.0).abs() < 1e-18, "{plate:?}");
    let circumference = 20.0 * PI;
    let [angle, plate] = [24e-4, 2e-3].map(|area| area * 7850.0 * circumference);
    let shell = 7850.0 * circumference * (2.4 * 0.012 + 8.0 * 0.01);
    let mass = shell + angle + plate + 2000.0;
    assert!((tank.wall_mass() / mass - 1.0).abs() < 1e-12, "{} {mass}", tank.wall_mass());
    assert!((bare.wall_mass() / shell - 1.0).abs() < 1e-12);
    let courses = 7850.0 * circumference * (2.4 * 0.012 * 1.2 + 8.0 * 0.01 * 6.4);
    let moment = courses + 10.4 * angle + 8.0 * plate + 1200.0 * 5.0 + 800.0 * 10.0;
    assert!((tank.wall_centroid() / (moment / mass) - 1.0).abs() < 1e-12);
    // Above 9 m: 1.4 m of the upper course, the angle and the platform.
    let above = 7850.0 * circumference * 1.4 * 0.01 + angle + 800.0;
    assert!((tank.mass_above(9.0).0 / above - 1.0).abs() < 1e-12);
}

#[test]
fn insulation_counts_with_the_courses_that_it_covers() {
    let whole = read(&with(r#""insulation": { "mass": "15 kg/m2" }"#));
    let area = 20.0 * PI * 10.4;
    assert!((whole.case.tank.insulation_mass() / (15.0 * area) - 1.0).abs() < 1e-12);
    let bare = 7850.0 * 20.0 * PI * (2.4 * 0.012 + 8.0 * 0.01);
    assert!((whole.case.tank.wall_mass() / (bare + 15.0 * area) - 1.0).abs() < 1e-12);
    assert!(whole.remarks.iter().any(|remark| remark.contains("tank.insulation")), "{:?}", whole.remarks);
    let lower = read(&with(r#""insulation": { "mass": "15 kg/m2", "height": "2.4 m" }"#)).case.tank;
    let covered = 15.0 * 20.0 * PI * 2.4;
    assert!((lower.wall_mass() / (bare + covered) - 1.0).abs() < 1e-12);
    assert!((lower.insulation_mass() / covered - 1.0).abs() < 1e-12);
    assert_eq!(lower.courses[1].material.density, 7850.0);
    // Bars make a course one of layers: its outermost layer carries the insulation.
    let layers =
        small("").replace("\"anchored\",", "\"anchored\", \"insulation\": { \"mass\": \"30 kg/m2\" },").replace(
            "\"thickness\": \"10 mm\", \"material\": \"steel\"",
            "\"layers\": [ { \"kind\": \"shell\", \"thickness\": \"10 mm\", \"material\": \"steel\" },
                           { \"kind\": \"shell\", \"thickness\": \"20 mm\", \"material\": \"steel\" } ]",
        );
    let layered = read(&layers).case.tank;
    let mass = 20.0 * PI * 8.0 * (0.03 * 7850.0 + 30.0);
    assert!((layered.wall_mass() / mass - 1.0).abs() < 1e-12);
    assert_eq!(layered.courses[0].layers[0].material.density, 7850.0);
    assert!((layered.courses[0].layers[1].material.density - 9350.0).abs() < 1e-9);
}

#[test]
fn bad_input_has_a_message() {
    let said = |more: &str, parts: &[&str]| {
        let text = refused(&with(more));
        for part in parts {
            assert!(text.contains(part), "`{part}` is missing in {text}");
        }
        assert!(text.contains("1 fault in tank.json"), "{text}");
    };
    let ring = |keys: &str| format!(r#""rings": [ {{ "height": "8 m", "material": "steel", {keys} }} ]"#);
    let high = r#""rings": [ { "height": "11 m", "area": "24 cm2", "inertia": "8 cm4", "material": "steel" } ]"#;
    said(high, &["tank.rings[0].height", "above the wall", "at most 10.40 m"]);
    said(&ring(r#""area": "24 cm2""#), &["tank.rings[0].inertia", "missing", "820 cm4"]);
    said(&ring(r#""inertia": "24 cm4""#), &["tank.rings[0].area", "missing"]);
    said(&ring(r#""width": "0.2 m""#), &["tank.rings[0].thickness", "of a flat plate"]);
    said(&ring(r#""name": "x""#).replace(", \"name\": \"x\"", ""), &["tank.rings[0].area", "width and thickness"]);
    let both = r#""area": "24 cm2", "inertia": "8 cm4", "width": "0.2 m", "thickness": "1 cm""#;
    said(&ring(both), &["tank.rings[0]", "given twice"]);
    said(
        &ring(r#""area": "24 cm4", "inertia": "8 cm4""#),
        &["`cm4` is a unit of a second moment of area, not of an area"],
    );
    said(&ring(r#""area": "0 cm2", "inertia": "8 cm4""#), &["tank.rings[0].area", "must be positive"]);
    said(&ring(r#""area": "3 cm2", "inertia": "8 cm4""#).replace("steel", "brass"), &["unknown material `brass`"]);
    let attachment = |keys: &str| format!(r#""attachments": [ {{ "name": "ladder", {keys} }} ]"#);
    said(&attachment(r#""mass": "1 t", "height": "12 m""#), &["tank.attachments[0].height", "above the wall"]);
    said(&attachment(r#""mass": "-1 t", "height": "2 m""#), &["tank.attachments[0].mass", "must not be negative"]);
    said(&attachment(r#""mass": "1 t""#), &["tank.attachments[0].height", "missing"]);
    let within = r#""insulation": { "mass": "15 kg/m2", "height": "4 m" }"#;
    said(within, &["tank.insulation.height", "ends within a course", "2.400 m or 10.40 m"]);
    said(r#""insulation": { "mass": "15 kg" }"#, &["tank.insulation.mass", "not of a mass per area"]);
    let box_of = small("")
        .replace("\"cylinder\", \"radius\": \"10 m\"", "\"rectangle\", \"length\": \"10 m\", \"breadth\": \"8 m\"")
        .replace("\"anchored\",", &format!("\"anchored\", {},", ring(r#""area": "3 cm2", "inertia": "8 cm4""#)));
    let text = refused(&box_of);
    assert!(text.contains("rings do not apply to a rectangle") && text.contains("1 fault in"), "{text}");
}
