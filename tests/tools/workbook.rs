//! The workbook of a report, as Python and LibreOffice read it.
//!
//! Goal:     the values of results.json and series.csv as numbers, utilisations and lines of sheets as formulas, every text of a user as a text
//! Model:    example 05 (two deciding codes, the longest sheets), 01 for LibreOffice
//! Expected: see each test

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::forms::{compared, other, read, root, said, tankcheck};

/// Reads the cells of a workbook: sheet → rows of text and numbers.
const CELLS: &str = r#"
import json, re, sys, zipfile
from xml.etree import ElementTree as E
N = {"m": "http://schemas.openxmlformats.org/spreadsheetml/2006/main"}
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"
z = zipfile.ZipFile(sys.argv[1])
texts = ["".join(t.text or "" for t in s.iter("{%s}t" % N["m"])) for s in E.fromstring(z.read("xl/sharedStrings.xml"))]
links = {r.get("Id"): r.get("Target") for r in E.fromstring(z.read("xl/_rels/workbook.xml.rels"))}
out = {}
for sheet in E.fromstring(z.read("xl/workbook.xml")).find("m:sheets", N):
    rows = []
    for row in E.fromstring(z.read("xl/" + links[sheet.get(R)])).iter("{%s}row" % N["m"]):
        cells = {}
        for c in row:
            f = c.find("m:f", N)
            if f is not None: out.setdefault("formulas", {})[sheet.get("name") + "!" + c.get("r")] = f.text
            v = c.find("m:v", N)
            if v is None: continue
            column = 0
            for letter in re.match("[A-Z]+", c.get("r")).group():
                column = 26 * column + ord(letter) - 64
            cells[column - 1] = texts[int(v.text)] if c.get("t") == "s" else float(v.text)
        rows.append([cells.get(i) for i in range(max(cells, default=-1) + 1)])
    out[sheet.get("name")] = rows
print(json.dumps(out))
"#;

/// Every value of results.json and series.csv is in the workbook as a number in the unit beside it, and the bytes are the same each time.
pub(crate) fn the_workbook_has_the_values(python: &Path) {
    let folder = compared("05_oil_tank", &[]);
    let home = folder.path();
    let mut bytes = Vec::new();
    for _ in 0..2 {
        let run = tankcheck(home, &["report", "out", "--format", "xlsx"], &[]);
        assert!(run.status.success(), "{}", said(&run));
        bytes.push(fs::read(home.join("out/report.xlsx")).expect("a workbook"));
    }
    assert!(bytes[0] == bytes[1], "the same results give the same bytes");
    let book = read(python, home, CELLS, "out/report.xlsx");
    let results: Value =
        serde_json::from_slice(&fs::read(home.join("out/results.json")).expect("results")).expect("JSON");
    let mut sheets = 0;
    for method in results["methods"].as_array().expect("methods") {
        let steps = method["steps"].as_array().expect("steps");
        if steps.is_empty() {
            continue;
        }
        sheets += 1;
        let name = format!("{} {}", method["id"].as_str().unwrap(), method["excitation"].as_str().unwrap());
        let rows = book[&name].as_array().unwrap_or_else(|| panic!("no sheet {name}"));
        assert_eq!(rows.len(), steps.len() + 1, "{name}");
        for (row, step) in rows[1..].iter().zip(steps) {
            assert_eq!(row[2], step["name"], "{name}");
            close(&row[6], row[7].as_str().unwrap_or_default(), step["value"].as_f64().unwrap());
            assert_eq!(row[8], step["clause"]);
        }
    }
    assert!(sheets > 8, "{sheets} sheets of methods");
    let checks: Vec<&Value> =
        results["methods"].as_array().unwrap().iter().flat_map(|m| m["checks"].as_array().unwrap()).collect();
    let rows = book["Checks"].as_array().expect("checks");
    assert_eq!(rows.len(), checks.len() + 1);
    let (mut compared, mut quotients) = (0, 0);
    for (line, (row, check)) in (2..).zip(rows[1..].iter().zip(checks)) {
        let unit = row.get(7).and_then(Value::as_str).unwrap_or_default();
        for (column, key) in [(5, "demand"), (6, "capacity")] {
            if let Some(value) = check[key].as_f64() {
                close(&row[column], unit, value);
                compared += 1;
            }
        }
        // The utilisation follows demand and capacity, where it is their quotient.
        if let Some(formula) = book["formulas"].get(format!("Checks!I{line}")) {
            assert_eq!(*formula, format!("F{line}/G{line}"));
            close(&row[8], "", check["demand"].as_f64().unwrap() / check["capacity"].as_f64().unwrap());
            quotients += 1;
        }
    }
    assert!(compared > 50 && quotients > 25, "{compared} values of checks, {quotients} quotients");
    let profile = &results["methods"][1]["profiles"][0];
    let rows = book["Profiles"].as_array().expect("profiles");
    let of: Vec<&Value> =
        rows.iter().filter(|r| r[0] == results["methods"][1]["title"] && r[2] == profile["title"]).collect();
    let values = profile["values"].as_array().expect("values");
    assert!(of.len() >= values.len() && !values.is_empty());
    for (row, value) in of.iter().zip(values) {
        close(&row[5], row[6].as_str().unwrap_or_default(), value.as_f64().unwrap());
    }
    // Histories: every column of series.csv, in the unit of its head.
    let series = fs::read_to_string(home.join("out/series.csv")).expect("series");
    let lines: Vec<&str> = series.lines().filter(|l| !l.starts_with('#')).collect();
    let rows = book["Histories"].as_array().expect("histories");
    let head = rows[0].as_array().expect("a head");
    assert_eq!(rows.len(), lines.len());
    assert_eq!(head.len(), lines[0].split(',').count());
    let row = rows.len() / 2;
    for (column, text) in lines[row].split(',').enumerate() {
        let title = head[column].as_str().expect("text");
        let unit = title.rsplit_once('[').map_or("", |(_, unit)| unit.trim_end_matches(']'));
        if let Ok(value) = text.parse::<f64>() {
            close(&rows[row][column], unit, value);
        }
    }
}

/// Parts of a workbook as XML, its texts and its formulas.
const PARTS: &str = r#"
import json, sys, zipfile
from xml.etree import ElementTree as E
M = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
z = zipfile.ZipFile(sys.argv[1])
assert z.testzip() is None
parts = {n: E.fromstring(z.read(n)) for n in z.namelist() if n.endswith((".xml", ".rels"))}
formulas = [f.text for p in parts.values() for f in p.iter(M + "f")]
print(json.dumps({"formulas": formulas, "texts": ["".join(t.text or "" for t in s.iter(M + "t")) for s in parts["xl/sharedStrings.xml"]]}))
"#;

/// A workbook whose names are formulas, controls, marks that are not characters, or longer than a cell.
pub(crate) fn the_workbook_takes_every_text(python: &Path) {
    let tank = fs::read_to_string(root("examples/05_oil_tank/tank.json")).expect("a tank");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let home = folder.path();
    let long = "x".repeat(40_000);
    let texts = [
        "=1+1",
        "@SUM(A1)",
        "\0\u{1}\u{b}\u{1f}\u{85}",
        "\u{202e}\u{200b}\u{feff}",
        "a\u{fffe}\u{ffff}",
        "_x0041_<&>\"'",
        &long,
    ];
    for pair in texts.chunks(2) {
        let mut given: Value = serde_json::from_str(&tank).expect("plain JSON");
        given["name"] = pair[0].into();
        given["project"]["client"] = pair[pair.len() - 1].into();
        fs::write(home.join("tank.json"), given.to_string()).expect("writable");
        for arguments in [&["check", "tank.json", "--out", "out"][..], &["report", "out", "--format", "xlsx"]] {
            let run = tankcheck(home, arguments, &[]);
            assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", said(&run));
        }
        let parts = read(python, home, PARTS, "out/report.xlsx");
        // Those of the sheets alone: cells, numbers and functions.
        let formulas = parts["formulas"].as_array().expect("formulas");
        let plain = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || "()+-*/^.,".contains(c);
        assert!(formulas.len() > 100);
        for formula in formulas.iter().map(|formula| formula.as_str().unwrap_or_default()) {
            assert!(formula.chars().all(plain) && formula != "1+1" && !formula.contains("SUM"), "{formula}");
        }
        let cells = parts["texts"].as_array().expect("texts");
        for text in pair {
            let shown = files::text::visible(text);
            let own = |cell: &Value| match cell.as_str().unwrap_or_default() {
                // A cell holds 32 767 characters.
                cut if text.len() > 32_767 => {
                    cut.len() > 32_000 && cut.trim_end_matches('…').trim_matches('x').is_empty()
                }
                // The form writes `_x0041_`, which stands for a character there, with its first sign as such a code.
                cell => cell.replace("_x005F_", "_") == *shown,
            };
            assert!(cells.iter().any(own), "{text:?} is no cell");
        }
    }
}

/// SI value of a unit, by its symbol; independent of the program's table.
fn factor(unit: &str) -> f64 {
    let of = |symbol: &str| -> f64 {
        match symbol {
            "" | "m" | "s" | "N" | "Pa" | "rad" | "J" | "Hz" => 1.0,
            "kg" => 1.0,
            "mm" => 1e-3,
            "µm" | "μm" => 1e-6,
            "ms" => 1e-3,
            "t" => 1e3,
            "kN" | "kPa" | "kJ" => 1e3,
            "MN" | "MPa" | "MJ" => 1e6,
            "GN" | "GPa" | "GJ" => 1e9,
            "mrad" => 1e-3,
            "%" => 0.01,
            other => panic!("unit {other}"),
        }
    };
    let power =
        |symbol: &str| match symbol.strip_suffix('²').map(|s| (s, 2)).or(symbol.strip_suffix('³').map(|s| (s, 3))) {
            Some((symbol, exponent)) => of(symbol).powi(exponent),
            None => of(symbol),
        };
    let product = |text: &str| text.split('·').map(power).product::<f64>();
    match unit.split_once('/') {
        Some((above, below)) => product(above) / product(below),
        None => product(unit),
    }
}

/// A cell is a value in SI, to the digits that the files keep (ten) and one rounding of the conversion.
fn close(cell: &Value, unit: &str, value: f64) {
    let found = cell.as_f64().unwrap_or_else(|| panic!("{cell} is no number, expected {value}")) * factor(unit);
    assert!((found - value).abs() <= 1e-9 * value.abs(), "{cell} {unit}: {found}, expected {value}");
}

/// LibreOffice opens the workbook and finds all its sheets.
pub(crate) fn libreoffice_opens_the_workbook(office: &Path) {
    let folder = compared("01_broad_tank", &["--fe", "none"]);
    let home = folder.path();
    let run = tankcheck(home, &["report", "out", "--format", "xlsx"], &[]);
    assert!(run.status.success(), "{}", said(&run));
    let profile = format!("-env:UserInstallation=file://{}/profile", home.display());
    // Every sheet as a CSV of its own (token 12: -1).
    let filter = "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,true,false,false,false,-1";
    let arguments = [&profile, "--headless", "--convert-to", filter, "--outdir", "csv", "out/report.xlsx"];
    let converted = other(office, home, &arguments);
    assert!(converted.status.success(), "{}", said(&converted));
    let csv: Vec<PathBuf> = fs::read_dir(home.join("csv")).expect("files").map(|e| e.expect("a file").path()).collect();
    let named = |name: &str| csv.iter().find(|p| p.to_string_lossy().contains(name));
    for name in ["Overview", "Quantities", "Checks", "ec8-2006 site", "Profiles"] {
        assert!(named(name).is_some(), "no sheet {name} in {csv:?}");
    }
    let checks = fs::read_to_string(named("Checks").expect("a sheet")).expect("text");
    assert!(checks.starts_with("Method,Excitation,Decides,Check,Clause") && checks.lines().count() > 10, "{checks}");
}
