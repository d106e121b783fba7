//! Grades of plates in the tank file: strengths by the thickest plate, S_d of API 650, messages. Values: `crates/materials/tests/grades.rs`.

use tank::Behaviour;
use tankcheck::input::TankFile;
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

/// Two courses and a bottom plate, of the materials `lower`, `upper` and `floor`.
fn text(lower: &str, upper: &str, floor: &str, materials: &str) -> String {
    format!(
        r#"{{
  "name": "grades",
  "tank": {{
    "shape": "cylinder", "radius": "30 m", "support": "anchored",
    "courses": [
      {{ "height": "3 m", {lower} }},
      {{ "height": "3 m", {upper} }}
    ],
    "bottom": {{ {floor} }}
  }},
  "liquid": {{ "density": "1000 kg/m3", "fill_height": "5 m" }},
  "materials": {{ {materials} }}
}}"#
    )
}

fn read(text: &str) -> TankFile {
    let source = Source::new("tank.json", text);
    parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)))
}

/// The only fault.
fn fault(text: &str) -> String {
    let source = Source::new("tank.json", text);
    let found = parse(&source).expect_err("a fault").render(&source, false);
    assert!(found.contains("error: 1 fault in tank.json"), "{found}");
    found
}

const LOWER: &str = r#""thickness": "30 mm", "material": "steel""#;
const UPPER: &str = r#""thickness": "12 mm", "material": "steel""#;
const FLOOR: &str = r#""thickness": "10 mm", "material": "steel""#;

fn with(grade: &str) -> String {
    text(LOWER, UPPER, FLOOR, &format!(r#""steel": {{ {grade} }}"#))
}

/// EN 10025-2: 345 MPa from 16 to 40 mm, also for the course of 12 mm.
#[test]
fn the_thickest_plate_gives_the_strength() {
    let file = read(&with(r#""grade": "S355 J2""#));
    for course in &file.case.tank.courses {
        assert_eq!(course.material.yield_strength, Some(345e6));
        let Behaviour::Steel(steel) = course.material.behaviour else { panic!("{:?}", course.material.behaviour) };
        assert_eq!((steel.yield_strength, steel.ultimate_strength), (345e6, Some(470e6)));
        assert_eq!(course.material.allowable_stress, None);
    }
    let line = file.echo.iter().find(|l| l.path == "materials.steel.yield_strength").unwrap();
    assert_eq!(line.text, "345.0 MPa");
    assert!(line.default && line.source.starts_with("grade S355JR, t ≤ 40 mm: EN 10025-2:2004"), "{}", line.source);
}

/// 355 MPa up to 16 mm, for a material of its own.
#[test]
fn thinner_plates_may_have_their_own_material() {
    let upper = r#""thickness": "16 mm", "material": "thin""#;
    let materials = r#""steel": { "grade": "S355JR" }, "thin": { "grade": "S355JR" }"#;
    let courses = read(&text(LOWER, upper, FLOOR, materials)).case.tank.courses;
    let found: Vec<_> = courses.iter().map(|c| c.material.yield_strength).collect();
    assert_eq!(found, [Some(345e6), Some(355e6)]);
}

/// Bottom plate, annular plate, and each layer of a wall, in any unit.
#[test]
fn every_plate_counts() {
    let yields = |text: &str| read(text).case.tank.courses[0].material.yield_strength;
    let steel = r#""steel": { "grade": "S355JR" }"#;
    let thick = r#""thickness": "1.7 in", "material": "steel""#;
    assert_eq!(yields(&text(UPPER, UPPER, FLOOR, steel)), Some(355e6));
    assert_eq!(yields(&text(UPPER, UPPER, thick, steel)), Some(335e6));
    let annular = format!(r#"{FLOOR}, "annular_thickness": "20 mm", "annular_width": "1 m""#);
    assert_eq!(yields(&text(UPPER, UPPER, &annular, steel)), Some(345e6));
    let layers = r#""layers": [ { "kind": "shell", "thickness": "2 cm", "material": "steel" },
                                { "kind": "shell", "thickness": "8 mm", "material": "steel" } ]"#;
    let layered = read(&text(UPPER, layers, FLOOR, steel)).case.tank.courses;
    assert_eq!(layered[0].material.yield_strength, Some(345e6));
}

/// API 650 table 5-2a: A36 has S_d = 160 MPa; a value of the file goes before it.
#[test]
fn a_grade_of_api_650_has_its_allowable_stress() {
    let stress = |text: &str| read(text).case.tank.courses[0].material.allowable_stress;
    assert_eq!(stress(&with(r#""grade": "ASTM A36""#)), Some(160e6));
    assert_eq!(stress(&with(r#""grade": "A36", "allowable_stress": "150 MPa""#)), Some(150e6));
    assert_eq!(stress(&with(r#""grade": "1.4404""#)), None);
    // The same tank as with the numbers themselves.
    let numbers = r#""youngs_modulus": "200 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "250 MPa",
                     "allowable_stress": "160 MPa", "behaviour": { "steel": { "tangent_modulus": "2 GPa", "ultimate_strength": "400 MPa" } }"#;
    let by_name = read(&with(r#""grade": "A36""#)).case.tank;
    assert_eq!(by_name, read(&with(numbers)).case.tank);
}

#[test]
fn a_plate_beyond_the_standard_is_a_fault() {
    let found = fault(&with(r#""grade": "6061-T6""#));
    for part in [
        "materials.steel.grade",
        "the grade EN AW-6061-T6 has no strengths for plates so thick",
        "found \"6061-T6\" with a plate of 30 mm",
        "expected: plates of at most 12.5 mm",
    ] {
        assert!(found.contains(part), "{part}\n{found}");
    }
}

#[test]
fn an_unknown_grade_has_the_nearest_ones() {
    for (written, nearest) in [
        ("S355JX", "S355JR"),
        ("P355NL3", "P355NL1"),
        ("A516 Grade 75", "A516 55"),
        ("1.4464", "1.4404"),
        ("C30/38", "C30/37"),
        ("5082", "5083"),
    ] {
        let found = fault(&with(&format!(r#""grade": "{written}""#)));
        assert!(found.contains(&format!("unknown grade `{written}`")), "{found}");
        assert!(found.contains(&format!("did you mean \"{nearest}\"?")), "{found}");
    }
    let found = fault(&with(r#""grade": "A517""#));
    assert!(found.contains("a grade such as A516 70") && !found.contains("did you mean"), "{found}");
    let found = fault(&with(r#""grade": "unobtainium""#));
    assert!(!found.contains("did you mean"), "{found}");
    assert!(found.contains("a grade such as S355, S355JR, 1.4301, A36, C30/37 or BSt500"), "{found}");
}

/// The reference page names every grade.
#[test]
fn every_grade_is_in_the_reference() {
    let root = env!("CARGO_MANIFEST_DIR");
    let page = std::fs::read_to_string(format!("{root}/docs/input.md")).expect("docs/input.md");
    let line = page.lines().find(|l| l.starts_with("| `grade` |")).expect("a line for grade");
    let listed = |name: &str| {
        line.contains(&format!("{name},")) || line.contains(&format!("{name}.")) || line.contains(&format!("{name} ("))
    };
    let plates = materials::grades::steels().map(|g| g.name);
    let concretes = materials::grades::CONCRETES.iter().map(|g| g.name);
    let bars = materials::grades::BARS.iter().map(|g| g.name);
    let absent: Vec<&str> = plates.chain(concretes).chain(bars).filter(|name| !listed(name)).collect();
    assert!(absent.is_empty(), "{absent:?}\n{line}");
}
