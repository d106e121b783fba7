//! `check --solve` and `check --table` against derivations by hand, and their bad input.
//!
//! Source:    EN 1998-4:2006 A.2.1.4 with the elastic spectrum of EN 1998-1:2004 3.2.2.2; API 650:2020 E.6.1.4
//! Goal:      the largest fill height with freeboard, the smallest thickness with hoop tension, each the only check near its limit
//! Tolerance: 1e-4, that of the search, on the side that holds; 1e-5 more for the digits of the printed factors

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::process::Output;

use crate::compare::{stderr, tankcheck};

/// Relative tolerance of the search.
const SEARCH: f64 = 1e-4;
/// Relative rounding of the factors in the codes.
const FACTORS: f64 = 1e-5;
const GRAVITY: f64 = 9.80665;
const OIL_TANK: &str = "examples/05_oil_tank/tank.json";

/// A steel cylinder with a wall of one course, anchored more than enough.
fn tank(radius: &str, wall: &str, thickness: &str, fill: &str, stress: &str, site: &str) -> String {
    format!(
        r#"{{
  "name": "steel cylinder",
  "tank": {{
    "shape": "cylinder", "radius": "{radius}", "support": "anchored", "roof": "none", "foundation": "none",
    "courses": [ {{ "height": "{wall}", "thickness": "{thickness}", "material": "steel" }} ],
    "bottom": {{ "thickness": "10 mm", "material": "steel" }},
    "anchors": {{ "count": 60, "capacity": "100 MN" }}
  }},
  "liquid": {{ "density": "1000 kg/m3", "fill_height": "{fill}" }},
  "materials": {{
    "steel": {{
      "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "355 MPa",
      "allowable_stress": "{stress}"
    }}
  }},
  "damping": {{ "sloshing": 0.005 }},
  "site": {{ {site} }}
}}"#
    )
}

const EC8: &str = r#""ec8": { "ground": "B", "spectrum": 1, "ag": "0.3 g" }"#;
const API: &str = r#""api650": { "ss": 1.0, "s1": 0.4, "site_class": "B", "sug": 1, "tl": 6.0, "av": 0.0 }"#;

/// Thick wall: only the wave decides.
fn basin() -> String {
    tank("5 m", "10 m", "40 mm", "8 m", "160 MPa", EC8)
}

fn written(home: &Path, name: &str, text: &str) -> PathBuf {
    let path = home.join(name);
    std::fs::write(&path, text).expect("writable");
    path
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a temporary path is text")
}

fn stdout(run: &Output) -> String {
    String::from_utf8_lossy(&run.stdout).into_owned()
}

/// The answer in JSON, and the exit code.
fn solved(tank: &Path, variable: &str) -> (serde_json::Value, Option<i32>) {
    let run = tankcheck(&["check", text(tank), "--solve", variable, "--format", "json"]);
    let json = serde_json::from_str(&stdout(&run)).unwrap_or_else(|e| panic!("{e}: {}", stderr(&run)));
    (json, run.status.code())
}

/// Wave height that the freeboard of a tank of 5 m radius has to hold [m], at 0.5 % damping, 0.3 g, ground B, type 1: the larger of 0.84 R
/// S_e(T_1)/g (EN 1998-4 A.2.1.4) and R S_e(T_con)/g (A.3.2.2), T_con = 1.48 √R from H/R = 1.5 on.
fn wave(fill: f64) -> f64 {
    let (radius, lambda) = (5.0_f64, 1.841_183_78);
    assert!(fill >= 1.5 * radius, "{fill}");
    let first = 2.0 * PI / (GRAVITY * lambda / radius * f64::tanh(lambda * fill / radius)).sqrt();
    let ordinate = |period: f64| {
        // S = 1.2, T_C = 0.5 s, T_D = 2 s; the period is between T_D and 4 s.
        assert!((2.0..4.0).contains(&period), "{period}");
        let eta = (10.0_f64 / 5.5).sqrt();
        0.3 * 1.2 * eta * 2.5 * 0.5 * 2.0 / (period * period)
    };
    let simplified = 1.48 * radius.sqrt();
    radius * (0.84 * ordinate(first)).max(ordinate(simplified))
}

#[test]
fn the_largest_fill_height_leaves_the_wave_its_freeboard() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path(), "tank.json", &basin());
    let (json, code) = solved(&path, "fill_height");
    // H + d(H) = 10 m by fixed-point iteration; d hardly depends on H.
    let expected = (0..50).fold(9.0, |fill, _| 10.0 - wave(fill));
    let value = json["value"].as_f64().expect("a value");
    assert!(value <= expected * (1.0 + FACTORS), "{value} above {expected}");
    assert!(value >= expected * (1.0 - SEARCH - FACTORS), "{value} below {expected}");
    assert_eq!((json["variable"].as_str(), json["unit"].as_str()), (Some("fill_height"), Some("m")));
    assert_eq!(json["governing"]["method"], "ec8-2006");
    assert_eq!(json["governing"]["check"], "freeboard");
    let utilisation = json["governing"]["utilisation"].as_f64().expect("a utilisation");
    assert!((0.99..=1.0).contains(&utilisation), "{utilisation}");
    assert!(json["evaluations"].as_u64().is_some_and(|n| (27..60).contains(&n)), "{json}");
    // The exit code is that of the verdict there.
    let expected = match json["status"].as_str() {
        Some("holds") => 0,
        Some("incomplete") => 4,
        other => panic!("{other:?}"),
    };
    assert_eq!(code, Some(expected));
    let keys: Vec<&str> = json.as_object().expect("an object").keys().map(String::as_str).collect();
    for key in ["variable", "value", "unit", "governing", "evaluations", "status"] {
        assert!(keys.contains(&key), "{key}");
    }
    assert_eq!(keys.len(), 6);
}

/// `check` at the value holds, and fails 1.1 tolerances above it.
#[test]
fn the_value_holds_and_a_little_more_fails() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path(), "tank.json", &basin());
    let value = solved(&path, "ag").0["value"].as_f64().expect("a value");
    for (factor, fails) in [(1.0, false), (1.0 + 1.1 * SEARCH, true)] {
        let site = EC8.replace("0.3 g", &format!("{} m/s2", value * factor));
        let at = basin().replace(EC8, &site);
        let run = tankcheck(&["check", text(&written(home.path(), "at.json", &at))]);
        assert_eq!(run.status.code() == Some(1), fails, "{factor}: {}{}", stdout(&run), stderr(&run));
    }
}

#[test]
fn the_smallest_thickness_carries_the_hoop_tension() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path(), "tank.json", &tank("10 m", "12 m", "20 mm", "9 m", "80 MPa", API));
    let (json, _) = solved(&path, "thickness:1");
    // E.6.1.4 at the base, Y = H, D/H ≥ 1.333: N_h + √(N_i² + N_c²) [N/m] with its printed constants; S_DS = 2/3, R_wi = 4, R_wc = 2.
    let (d, h) = (20.0_f64, 9.0_f64);
    let hydrostatic = 4900.0 * h * d;
    let a_i: f64 = 2.0 / 3.0 / 4.0;
    let impulsive = 8480.0 * a_i * d * h * 0.5 * (0.866 * d / h).tanh();
    let period = 1.8 * 0.578 / (3.68 * h / d).tanh().sqrt() * d.sqrt();
    let a_c = 1.5 * (2.0 / 3.0 * 0.4) / period / 2.0;
    let convective = 1850.0 * a_c * d * d / (3.68 * h / d).cosh();
    let force = hydrostatic + impulsive.hypot(convective);
    let expected = force / (1.33 * 80e6);
    let value = json["value"].as_f64().expect("a value");
    assert!(value >= expected * (1.0 - FACTORS), "{value} below {expected}");
    assert!(value <= expected * (1.0 + SEARCH + FACTORS), "{value} above {expected}");
    assert_eq!(json["governing"]["check"], "hoop_stress");
    let utilisation = json["governing"]["utilisation"].as_f64().expect("a utilisation");
    // An allowance comes on top, to the tolerance of the search and of the six digits.
    let corroded = tank("10 m", "12 m", "20 mm", "9 m", "80 MPa", API)
        .replace("\"20 mm\"", "\"20 mm\", \"corrosion_allowance\": \"3 mm\"");
    let (json, _) = solved(&written(home.path(), "corroded.json", &corroded), "thickness:1");
    let (more, expected) = (json["value"].as_f64().expect("a value"), expected + 0.003);
    assert!(more >= expected * (1.0 - FACTORS), "{more} below {expected}");
    assert!(more <= expected * (1.0 + SEARCH + FACTORS), "{more} above {expected}");
    // The stress is N/t: at twice the thickness the utilisation is half.
    let double = format!("\"{} m\"", 2.0 * value);
    let at = tank("10 m", "12 m", "20 mm", "9 m", "80 MPa", API).replace("\"20 mm\"", &double);
    let out = home.path().join("out");
    tankcheck(&["check", text(&written(home.path(), "at.json", &at)), "--out", text(&out)]);
    let results: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(out.join("results.json")).expect("results")).expect("JSON");
    let methods = results["methods"].as_array().expect("methods");
    let api = methods.iter().find(|m| m["id"] == "api650-2020").expect("API 650");
    let checks = api["checks"].as_array().expect("checks");
    let hoop = checks.iter().find(|c| c["id"] == "hoop_stress").expect("hoop");
    let half = hoop["utilisation"].as_f64().expect("a utilisation");
    assert!((2.0 * half / utilisation - 1.0).abs() < 1e-9, "{half} and {utilisation}");
}

#[test]
fn what_fails_everywhere_and_what_holds_everywhere() {
    let home = tempfile::tempdir().expect("a temporary folder");
    // The wave does not depend on the wall.
    let brim = written(home.path(), "brim.json", &basin().replace("\"8 m\"", "\"9.9 m\""));
    let (json, code) = solved(&brim, "thickness:1");
    assert_eq!((json["status"].as_str(), code), (Some("fails"), Some(1)));
    assert!(json["value"].is_null(), "{json}");
    assert_eq!(json["governing"]["check"], "freeboard");
    let run = tankcheck(&["check", text(&brim), "--solve", "thickness:1"]);
    assert!(stdout(&run).contains("fails at every thickness of course 1"), "{}", stdout(&run));
    // An acceleration of a code that does not run changes nothing.
    let both = basin().replace(EC8, &format!("{EC8}, {API}"));
    let both = written(home.path(), "both.json", &both);
    let run = tankcheck(&["check", text(&both), "--solve", "ss", "--procedures", "ec8-2006"]);
    assert!(stdout(&run).contains("No check fails at any"), "{}", stdout(&run));
    assert!(matches!(run.status.code(), Some(0 | 4)));
}

#[test]
fn the_forms_of_the_answer() {
    let run = tankcheck(&["check", OIL_TANK, "--solve", "fill_height"]);
    let paragraph = stdout(&run);
    for words in ["Largest fill height", " m (given: 15.000 m)", "Governing there", "Verdict there", "(ec8-2006, site)"]
    {
        assert!(paragraph.contains(words), "`{words}` is missing in {paragraph}");
    }
    assert_eq!(paragraph.lines().count(), 1);
    let run = tankcheck(&["check", OIL_TANK, "--solve", "fill_height", "--format", "csv"]);
    let lines: Vec<String> = stdout(&run).lines().map(str::to_owned).collect();
    assert_eq!(lines[0], "variable,value,unit,method,check,utilisation,status,evaluations");
    assert!(lines[1].starts_with("fill_height,1") && lines.len() == 2, "{lines:?}");
}

/// Runs a command that must be rejected: exit code 2, empty standard output, all of `words`.
fn rejected(arguments: &[&str], words: &[&str]) {
    let run = tankcheck(arguments);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(run.stdout.is_empty(), "{arguments:?}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
}

#[test]
fn bad_variables() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let solve = |variable: &str, words: &[&str]| rejected(&["check", OIL_TANK, "--solve", variable], words);
    solve("depth", &["--solve", "found `depth`", "fill_height, thickness:N, ag or ss"]);
    solve("thickness", &["found `thickness`"]);
    solve("thickness:x", &["found `thickness:x`"]);
    for course in ["thickness:0", "thickness:8"] {
        solve(course, &["expected 1 to 7"]);
    }
    let path = written(home.path(), "tank.json", &basin());
    rejected(&["check", text(&path), "--solve", "ss"], &["does not have site.api650"]);
    let layered = "examples/08_concrete_cylinder/tank.json";
    let quake = "examples/records/elcentro.csv";
    rejected(&["check", layered, "--quake", quake, "--solve", "thickness:1"], &["has layers"]);
    // Without a site and a record there is nothing to solve, nor to check in a table.
    let still = written(home.path(), "still.json", &basin().replace(EC8, ""));
    rejected(&["check", text(&still), "--solve", "fill_height"], &["the ground motion is missing"]);
    let table = written(home.path(), "tanks.csv", "name\na\n");
    rejected(&["check", text(&still), "--table", text(&table)], &["the ground motion is missing", "tanks.csv:2"]);
}

#[test]
fn a_table_of_tanks() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let base = written(home.path(), "tank.json", &basin());
    let rows = "name,liquid.fill_height,tank.courses[0].thickness,site.ec8.importance\n\
                \"low, thick\",8 m,,1.0\nto the brim,9.9 m,40 mm,\n";
    let table = written(home.path(), "tanks.csv", rows);
    let run = tankcheck(&["check", text(&base), "--table", text(&table), "--solve", "fill_height"]);
    assert_eq!(run.status.code(), Some(1), "{}", stderr(&run));
    let lines: Vec<String> = stdout(&run).lines().map(str::to_owned).collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(
        lines[0],
        "name,liquid.fill_height,tank.courses[0].thickness,site.ec8.importance,status,method,check,utilisation,\
         solved_fill_height_m,solved_check,solved_status"
    );
    assert!(lines[1].starts_with("\"low, thick\",8 m,,1.0,"), "{}", lines[1]);
    assert!(lines[2].starts_with("to the brim,9.9 m,40 mm,,fails,ec8-2006,freeboard,"), "{}", lines[2]);
    // Both rows are the same tank but for its contents.
    let value = |line: &str| line.split(',').rev().nth(2).map(str::to_owned);
    assert_eq!(value(&lines[1]), value(&lines[2]));
    let single = solved(&base, "fill_height").0["value"].as_f64();
    assert_eq!(value(&lines[1]).and_then(|v| v.parse().ok()), single);
}

#[test]
fn bad_tables_name_line_and_column() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let base = written(home.path(), "tank.json", &basin());
    let check = |rows: &str, words: &[&str]| {
        let table = written(home.path(), "tanks.csv", rows);
        rejected(&["check", text(&base), "--table", text(&table)], words);
    };
    check("name,tank.radios\na,5 m\nb,6 m\n", &["tanks.csv:1:6", "unknown key `radios`", "1 fault"]);
    check("name,tank.courses[3].thickness\na,5 mm\n", &["tanks.csv:1:6", "found index 3, expected 0 to 0"]);
    check("name,tank..radius\na,5 m\n", &["tanks.csv:1:6", "not a path"]);
    check("name,tank.courses\na,5 m\n", &["tanks.csv:1:6", "a list, expected one value"]);
    check("name,tank.radius\na,5 t\nb,5 kg\n", &["tanks.csv:3:3", "5 kg", "tank.radius", "tanks.csv:2:3", "5 t"]);
    check("name,tank.radius\na,5\n", &["tanks.csv:2:3", "unit"]);
    check("name,liquid.fill_height\na,11 m\n", &["tanks.csv:2:3", "higher than the wall"]);
    // The fill height of the tank file, above the wall of the row.
    check("name,tank.courses[0].height\na,7 m\n", &["tanks.csv:2:1", "liquid.fill_height"]);
    check("name,tank.radius\na\n", &["tanks.csv:2:1", "found 1 cells"]);
    let none = home.path().join("none.csv");
    rejected(&["check", text(&base), "--table", text(&none)], &["none.csv", "cannot read the table"]);
    let out = home.path().join("out");
    rejected(&["check", text(&base), "--solve", "ag", "--out", text(&out)], &["cannot be used with"]);
}

/// A bad row is refused with its fault, the others are computed as without it; the exit code is that of bad input, whatever the others are.
#[test]
fn a_bad_row_does_not_refuse_the_table() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let base = written(home.path(), "tank.json", &basin());
    let check = |rows: &str, more: &[&str]| {
        let table = written(home.path(), "tanks.csv", &format!("tag,liquid.fill_height\n{rows}"));
        tankcheck(&[&["check", text(&base), "--table", text(&table)], more].concat())
    };
    let lines = |run: &std::process::Output| stdout(run).lines().map(str::to_owned).collect::<Vec<_>>();
    let good = lines(&check("a,8 m\nc,9.9 m\n", &[]));
    for bad in ["8 kg", "80 m", "0 m"] {
        let run = check(&format!("a,8 m\nb,{bad}\nc,9.9 m\n"), &[]);
        assert_eq!(run.status.code(), Some(2), "{bad}: {}", stderr(&run));
        let found = lines(&run);
        assert_eq!(found[2], format!("b,{bad},refused,,,"));
        assert_eq!([&found[0], &found[1], &found[3]], [&good[0], &good[1], &good[2]]);
        let said = stderr(&run);
        assert!(said.contains("tanks.csv:3") && said.contains("1 of 3 rows is refused"), "{said}");
    }
    let solved = check("a,8 m\nb,8 kg\n", &["--solve", "fill_height"]);
    assert_eq!(lines(&solved)[2], "b,8 kg,refused,,,,,,");
    assert_eq!(solved.status.code(), Some(2));
}

/// Names in two rows are warned of with both lines; both rows are computed.
#[test]
fn rows_with_one_tag_are_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let base = written(home.path(), "tank.json", &basin());
    for head in ["tag", "id"] {
        let rows = format!("{head},liquid.fill_height\nT1,8 m\nT2,8 m\nT1,7 m\n,6 m\n,5 m\n");
        let table = written(home.path(), "tanks.csv", &rows);
        let run = tankcheck(&["check", text(&base), "--table", text(&table)]);
        let said = stderr(&run);
        let named: Vec<&str> = said.lines().filter(|line| line.contains("the same")).collect();
        assert_eq!(named.len(), 1, "{said}");
        for part in ["tanks.csv:4", "tanks.csv:2", head, "`T1`"] {
            assert!(named[0].contains(part), "{said}");
        }
        assert_eq!(stdout(&run).lines().count(), 6);
    }
}

/// 8 m = 26.2467 ft, whose five digits are rounded down, to the side that holds. The terminal follows `--report-units` and `project.units`; JSON stays in SI.
#[test]
fn the_terminal_is_in_the_units_that_are_asked_for() {
    let home = tempfile::tempdir().expect("temporary folder");
    let file = written(home.path(), "tank.json", &basin());
    let us = basin().replacen('{', r#"{ "project": { "units": "us" },"#, 1);
    let us = written(home.path(), "us.json", &us);
    for arguments in [vec![text(&file), "--report-units", "us"], vec![text(&us)]] {
        let run = |more: &[&str]| {
            let all: Vec<&str> = ["check"].iter().chain(&arguments).chain(more).copied().collect();
            String::from_utf8(tankcheck(&all).stdout).expect("text")
        };
        let solved = run(&["--solve", "fill_height"]);
        assert!(solved.contains("(given: 26.246 ft)") && !solved.contains(" m "), "{solved}");
        let checked = run(&[]);
        assert!(checked.contains("[ksi]") && !checked.contains("[MPa]") && !checked.contains("[m]"), "{checked}");
        let json = run(&["--solve", "fill_height", "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        assert_eq!((json["unit"].as_str(), json["value"].as_f64() < Some(10.0)), (Some("m"), true), "{json}");
    }
}
