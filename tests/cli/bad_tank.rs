//! Bad tank files: a message with file, place, found and expected value; through the command line exit code 2, empty standard output and
//! no output folder.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

/// A valid file; the cases below spoil it in one place.
const GOOD: &str = r#"{
  "name": "test tank",
  "tank": {
    "shape": "cylinder",
    "radius": "1.83 m",
    "support": "anchored",
    "courses": [
      { "height": "0.915 m", "thickness": "2.03 mm", "material": "aluminium" },
      { "height": "0.915 m", "thickness": "1.27 mm", "material": "aluminium" }
    ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "1.525 m" },
  "materials": {
    "aluminium": { "youngs_modulus": "69 GPa", "poisson_ratio": 0.32, "density": "2750 kg/m3" }
  },
  "record": { "scale_to": "0.5 g" }
}
"#;

const RECORD: &str = "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0.5\n0.06,-1\n0.08,0\n";

/// Runs `compare` on a tank file in a fresh folder and checks the common properties of a rejection; returns the message.
fn refused(folder: &Path, tank: &str, stdin: Option<&str>) -> String {
    std::fs::write(folder.join("record.csv"), RECORD).unwrap();
    let out = folder.join("out");
    let mut command = Command::new(env!("CARGO_BIN_EXE_tankcheck"));
    command
        .current_dir(folder)
        .args(["compare", tank, "--quake", "record.csv", "--out", "out"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    {
        use std::io::Write;
        let mut pipe = child.stdin.take().unwrap();
        // The program may refuse before it has read all.
        let _ = pipe.write_all(stdin.unwrap_or_default().as_bytes());
    }
    let Output { status, stdout, stderr } = child.wait_with_output().unwrap();
    let message = String::from_utf8(stderr).unwrap();
    assert_eq!(status.code(), Some(2), "{tank}: {message}");
    assert!(stdout.is_empty(), "{tank}: {}", String::from_utf8_lossy(&stdout));
    assert!(!out.exists(), "{tank}: output folder was made");
    assert!(!message.contains('\u{1b}'), "colour without a terminal: {message}");
    assert!(message.contains("error"), "{message}");
    message
}

/// The message for a file with this content.
pub(crate) fn message(content: impl AsRef<[u8]>) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("tank.json"), content).unwrap();
    refused(folder.path(), "tank.json", None)
}

/// The message for the good file with one passage replaced, without running the program.
fn spoiled(from: &str, to: &str) -> String {
    assert_eq!(GOOD.matches(from).count(), 1, "`{from}` must stand once in the good file");
    let source = Source::new("tank.json", GOOD.replace(from, to));
    parse(&source).expect_err("a fault").render(&source, false)
}

pub(crate) fn has(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{part}` is missing in\n{message}");
    }
}

#[test]
fn files_that_are_none() {
    let folder = tempfile::tempdir().unwrap();
    has(&refused(folder.path(), "none.json", None), &["none.json", "no such file", "tankcheck init"]);
    has(&refused(folder.path(), ".", None), &["folder"]);
    has(&message(""), &["tank.json", "empty"]);
    has(&message(" \n"), &["tank.json", "empty"]);
    has(&message("// nothing\n"), &["tank.json", "only comments"]);
    has(&message(b"{ \"name\": \"M\xFCnchen\" }"), &["tank.json", "line 1", "0xfc", "UTF-8"]);
    has(&message([0xFF, 0xFE, b'{', 0]), &["tank.json", "UTF-16"]);
    has(&message([0x1F, 0x8B, 0, 0xFF, 0, 0x80]), &["tank.json", "UTF-8"]);
    has(&message(vec![b' '; 2 << 20]), &["tank.json", "1 MiB"]);
    has(&message("[".repeat(100_000)), &["tank.json", "nested too deeply", "at most 32"]);
    has(&message("[1, 2]"), &["tank.json:1:1", "a list is not allowed here", "an object"]);
}

#[test]
fn standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let text = GOOD.replace("1.83 m", "1.83 kg");
    has(&refused(folder.path(), "-", Some(&text)), &["<stdin>:5:15", "tank.radius"]);
    has(&refused(folder.path(), "-", None), &["<stdin>", "empty"]);
}

#[test]
fn truncated_anywhere() {
    // Every character boundary but the end: no prefix is a document, and none may panic.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tank.json");
    let end = GOOD.trim_end().len();
    for cut in (1..end).filter(|i| GOOD.is_char_boundary(*i)) {
        let source = Source::new("tank.json", &GOOD[..cut]);
        let faults = parse(&source).expect_err("a prefix is not a document");
        assert!(faults.render(&source, false).contains("tank.json"));
    }
    std::fs::write(&path, &GOOD[..end / 2]).unwrap();
    has(&refused(folder.path(), "tank.json", None), &["tank.json:", "cut off"]);
}

#[test]
fn syntax() {
    has(&spoiled("\"1.83 m\"", "1.83 m"), &["tank.json:5:15", "must be in quotes", "write \"1.83 m\""]);
    has(&spoiled("\"1.83 m\"", "1.83m"), &["tank.json:5:15", "1.83m", "\"1.83 m\""]);
    has(&spoiled("0.32", "NaN"), &["tank.json:14:", "NaN", "finite"]);
    has(&spoiled("0.32", "Infinity"), &["Infinity", "finite"]);
    has(&spoiled("0.32", "-inf"), &["inf", "finite"]);
    has(&spoiled("0.32", "1e999"), &["1e999", "materials.aluminium.poisson_ratio", "finite"]);
    has(&spoiled("0.32", "0,32"), &["tank.json:14:"]);
    has(&spoiled("0.32", "032"), &["032", "not a number"]);
    has(&spoiled("\"anchored\",", "\"anchored\""), &["tank.json:6:", "comma"]);
    has(&spoiled("\"radius\":", "\"radius\""), &["tank.json:5:", "colon"]);
    has(&spoiled("\"radius\":", "radius:"), &["tank.json:5:5", "radius", "quotes"]);
    has(&spoiled("\"anchored\"", "'anchored'"), &["tank.json:6:", "quotes"]);
    has(&message(format!("{GOOD}{{}}")), &["tank.json:18:1", "after the end of the document"]);
}

#[test]
fn keys() {
    has(
        &spoiled("\"radius\"", "\"radios\""),
        &["tank.json:5:5", "unknown key `radios`", "tank.radios", "did you mean `radius`?", "1 fault"],
    );
    for (key, hint) in [
        ("diameter", "half of the diameter"),
        ("piles", "not modelled"),
        ("isolated", "`tank.isolators`"),
        ("Floating-roof", "\"type\": \"floating\""),
        ("legs", "stand on the ground"),
        ("Support-Columns", "stand on the ground"),
        ("skirt", "stand on the ground"),
        ("wind_girder", "`tank.rings`"),
        ("stiffeners", "`tank.rings`"),
        ("cladding", "`tank.insulation`"),
        ("snow", "`tank.roof.snow`"),
        ("live_load", "`tank.roof.live_load`"),
        ("ladder", "`tank.attachments`"),
        ("nozzles", "`tank.pipes`"),
        ("manhole", "`tank.pipes`"),
        ("temperature", "`liquid.density`"),
        ("columns", "on legs, columns"),
        ("corrosion", "`tank.corrosion_allowance`"),
        ("design_pressure", "`tank.pressure`"),
        ("wind_speed", "not checked"),
    ] {
        has(&spoiled("\"radius\"", &format!("\"{key}\"")), &["unknown key", hint]);
    }
    // The key that is meant is not missing as well.
    for (from, to, hint) in [
        ("\"radius\"", "\"diameter\"", "half of the diameter"),
        ("\"youngs_modulus\"", "\"E\"", "give `youngs_modulus`"),
        ("\"fill_height\"", "\"level\"", "give `liquid.fill_height`"),
    ] {
        has(&spoiled(from, to), &[hint, "1 fault in"]);
    }
    has(&spoiled("2750 kg/m3", "25 kN/m3"), &["a unit of", "2549 kg/m3"]);
    has(
        &spoiled("\"density\": \"1000 kg/m3\"", "\"specific_gravity\": 0.87"),
        &["unknown key `specific_gravity`", "870 kg/m3", "1 fault in"],
    );
    for (written, density) in
        [("0.99", "990 kg/m3"), ("\"0.99\"", "990 kg/m3"), ("1.025", "1025 kg/m3"), ("13.6", "13600 kg/m3")]
    {
        has(&spoiled("\"1000 kg/m3\"", written), &["liquid.density", "a specific gravity", density, "1 fault in"]);
    }
    let site = "\"site\": { \"api650\": { \"ss\": 1, \"s1\": 0.4, \"site_class\": \"D\", \"tl\": 4, \"importance\": 1.25 } }, \"record\"";
    has(&spoiled("\"record\"", site), &["unknown key `importance`", "give `sug`", "1 fault in"]);
    // Open is a tank without `roof`.
    has(
        &spoiled("\"courses\"", "\"roof\": { \"type\": \"open\" }, \"courses\""),
        &["the key `mass` is missing", "remove `roof`"],
    );
    has(&spoiled("\"record\"", "\"colour\""), &["unknown key `colour`", "name, project, notes, gravity, tank, liquid"]);
    has(
        &spoiled("\"poisson_ratio\": 0.32,", "\"poisson_ratio\": 0.32, \"poisson_ratio\": 0.3,"),
        &["tank.json:14:", "duplicate key `poisson_ratio`", "materials.aluminium.poisson_ratio", "line 14"],
    );
    has(
        &spoiled("\"fill_height\": \"1.525 m\"", "\"density \": 3"),
        &["the key `fill_height` is missing", "liquid.fill_height", "\"fill_height\": \"1.83 m\""],
    );
    has(&spoiled("\"radius\": \"1.83 m\",", ""), &["the key `radius` is missing", "tank.radius", "tank.json:3:11"]);
    has(
        &spoiled("\"cylinder\"", "\"rectangle\""),
        &["radius does not apply to a rectangle", "`length`", "`breadth`", "strip"],
    );
}

#[test]
fn units() {
    has(
        &spoiled("\"1.83 m\"", "\"1.83 kg\""),
        &["tank.json:5:15", "tank.radius", "a mass", "a length such as \"1.83 m\"", "found \"1.83 kg\""],
    );
    has(&spoiled("\"1.83 m\"", "1.83"), &["tank.radius", "unit is missing", "found 1.83", "for example \"1.83 m\""]);
    has(&spoiled("\"1.83 m\"", "\"1.83\""), &["tank.radius", "unit is missing"]);
    // The unit of the example of the key: plates are in mm.
    has(&spoiled("\"2.03 mm\"", "\"2.03\""), &["unit is missing", "for example \"2.03 mm\" if it is mm"]);
    has(&spoiled("\"2.03 mm\"", "\"5/16 in\""), &["not a decimal number", "write \"0.3125 in\""]);
    has(&spoiled("\"69 GPa\"", "\"69 Gpa\""), &["youngs_modulus", "unknown unit `Gpa`", "did you mean `GPa`?"]);
    has(&spoiled("\"1.83 m\"", "\"1,83 m\""), &["tank.radius", "did you mean `1.83 m`?"]);
    for text in ["NaN m", "inf m", "-inf m", "1e999 m"] {
        has(&spoiled("\"1.83 m\"", &format!("\"{text}\"")), &["tank.radius", text, "not a finite number"]);
    }
    has(&spoiled("\"1.83 m\"", "null"), &["tank.radius", "null is not allowed here"]);
    has(&spoiled("\"1.83 m\"", "[\"1.83 m\"]"), &["tank.radius", "a list is not allowed here"]);
}

#[test]
fn ranges() {
    for (text, say) in [("-2.03 mm", "positive"), ("0 mm", "positive"), ("11 m", "too large")] {
        has(
            &spoiled("\"2.03 mm\"", &format!("\"{text}\"")),
            &["tank.json:8:43", "tank.courses[0].thickness", say, text, "at least 0.001 mm, at most 10 m"],
        );
    }
    has(&spoiled("\"1.83 m\"", "\"-1.83 m\""), &["tank.radius", "positive", "-1.83 m"]);
    has(&spoiled("\"1000 kg/m3\"", "\"0 kg/m3\""), &["liquid.density", "too small"]);
    has(&spoiled("\"1000 kg/m3\"", "\"870 t/m3\""), &["liquid.density", "too large", "did you mean \"870 kg/m3\"?"]);
    has(
        &spoiled("0.32", "0.5"),
        &["tank.json:14:", "materials.aluminium.poisson_ratio", "found 0.5", "at least 0, less than 0.5"],
    );
    has(&spoiled("0.32", "-0.1"), &["poisson_ratio", "found -0.1"]);
    has(&spoiled("\"0.5 g\"", "\"0 g\""), &["record.scale_to", "positive"]);
    has(&spoiled("\"0.5 g\"", "\"0.5 g\", \"scale_by\": 2"), &["record.scale_by", "exclude each other"]);
    has(
        &spoiled("\"record\": {", "\"damping\": { \"impulsive\": 1 }, \"record\": {"),
        &["damping.impulsive", "at most 0.28"],
    );
}

#[test]
fn cross_checks() {
    has(
        &spoiled("\"1.525 m\"", "\"1.9 m\""),
        &["tank.json:12:", "liquid.fill_height", "higher than the wall", "found \"1.9 m\"", "at most 1.830 m"],
    );
    // Courses that end below the liquid.
    let courses = spoiled(
        "\"height\": \"0.915 m\", \"thickness\": \"1.27 mm\"",
        "\"height\": \"0.6 m\", \"thickness\": \"1.27 mm\"",
    );
    has(&courses, &["the sum of the heights of tank.courses", "at most 1.515 m"]);
    has(
        &spoiled("\"2.03 mm\", \"material\": \"aluminium\"", "\"2.03 mm\", \"material\": \"aluminum\""),
        &["tank.courses[0].material", "unknown material `aluminum`", "did you mean \"aluminium\"?"],
    );
    has(
        &spoiled("\"2.03 mm\"", "\"2.03 m\""),
        &["tank.courses[0].thickness", "thicker", "a fifth of the radius", "did you mean \"2.03 mm\"?"],
    );
    has(&spoiled("\"2.03 mm\"", "\"0.00203 mm\""), &["tank.courses[0].thickness", "thinner"]);
    // A radius that no plate fits is one fault, not one of each plate.
    let small = spoiled("\"1.83 m\"", "\"1.83 mm\"");
    has(
        &small,
        &["tank.json:5:15", "too small for the thickness of the wall", "did you mean \"1.83 m\"?", "1 fault in"],
    );
}

#[test]
fn all_faults_at_once() {
    let text = GOOD.replace("1.83 m", "1.83 kg").replace("0.32", "0.5").replace("\"record\"", "\"rekord\"");
    let text = message(text);
    has(&text, &["tank.radius", "poisson_ratio", "did you mean `record`?", "3 faults in tank.json"]);
}

#[test]
fn the_good_file_is_good() {
    let source = Source::new("tank.json", GOOD);
    assert!(parse(&source).is_ok());
    assert!(PathBuf::from(env!("CARGO_BIN_EXE_tankcheck")).exists());
}
