//! Reports for print, text processors and spreadsheets, and test reports for CI, as other programs read them.
//!
//! Goal:     pages of A4, a clean text document, a workbook with the values of results.json, test reports that keep their schemas
//! Model:    examples 01 (two codes, an engine) and 05 (four grounds, two deciding codes, the longest sheets)
//! Expected: see each test

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, PoisonError};

use serde_json::Value;

const PROGRAM: &str = env!("CARGO_BIN_EXE_tankcheck");

/// The program in a folder, with the files of the repository at hand.
fn tankcheck(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).current_dir(folder);
    for (name, value) in variables {
        command.env(name, value);
    }
    command.output().expect("the program starts")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

fn root(file: &str) -> String {
    format!("{}/{file}", env!("CARGO_MANIFEST_DIR"))
}

/// Results of an example in `out` of a new folder; they are computed once.
fn compared(example: &str, options: &[&str]) -> tempfile::TempDir {
    /// Names and contents.
    type Files = Vec<(OsString, Vec<u8>)>;
    static DONE: Mutex<BTreeMap<String, Files>> = Mutex::new(BTreeMap::new());
    let mut done = DONE.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join("out");
    let files = done.entry(format!("{example} {options:?}")).or_insert_with(|| {
        let (tank, quake) = (root(&format!("examples/{example}/tank.json")), root("examples/records/elcentro.csv"));
        let arguments = [&["compare", &tank, "--quake", &quake, "--no-report", "--out", "out"][..], options].concat();
        let run = tankcheck(folder.path(), &arguments, &[]);
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", said(&run));
        let entries = fs::read_dir(&out).expect("results").map(|entry| entry.expect("readable"));
        entries.map(|entry| (entry.file_name(), fs::read(entry.path()).expect("a file"))).collect()
    });
    fs::create_dir_all(&out).expect("writable");
    for (name, bytes) in files {
        fs::write(out.join(name), bytes).expect("writable");
    }
    folder
}

/// Pages of a PDF as Chromium writes it.
fn pages(pdf: &Path) -> usize {
    let bytes = fs::read(pdf).expect("the PDF exists");
    assert!(bytes.starts_with(b"%PDF"));
    String::from_utf8_lossy(&bytes).matches("/MediaBox [").count()
}

/// Two pages of summary; at most 14 at the standard level, with one code at most 11.
pub(crate) fn pages_are_few(_chromium: &Path) {
    for (example, options, limits) in [
        ("01_broad_tank", &[][..], [2, 11]),
        ("01_broad_tank", &["--procedures", "ec8-2006"], [2, 11]),
        // Two codes decide, each with its whole sheet.
        ("05_oil_tank", &[], [2, 14]),
    ] {
        let folder = compared(example, options);
        for (level, most) in ["summary", "standard"].into_iter().zip(limits) {
            let file = format!("{level}.pdf");
            let run = tankcheck(folder.path(), &["report", "out", "--report", level, &format!("--pdf={file}")], &[]);
            assert!(run.status.success(), "{}", said(&run));
            let found = pages(&folder.path().join(file));
            assert!(found <= most, "{example} {options:?}: {found} pages of {level}, expected at most {most}");
            assert!(level == "standard" || found == most, "{example}: {found} pages of summary");
        }
    }
}

/// Contents of a printed report have the page of each section, as another program (poppler) reads them and finds the headings.
pub(crate) fn contents_have_the_pages_of_their_sections(pdftotext: &Path) {
    let folder = compared("01_broad_tank", &["--fe", "none"]);
    let home = folder.path();
    let run = tankcheck(home, &["report", "out", "--report", "full", "--pdf"], &[]);
    assert!(run.status.success(), "{}", said(&run));
    let read = Command::new(pdftotext)
        .args(["-raw", "out/report.pdf", "-"])
        .current_dir(home)
        .output()
        .expect("pdftotext starts");
    let text = String::from_utf8_lossy(&read.stdout);
    let pages: Vec<&str> = text.split('\u{c}').collect();
    let (_, contents) = text.split_once("Contents").expect("contents");
    // Entries run on: `1 Datasheet … 2 2 Checks … 3`.
    let contents = contents.split_whitespace().collect::<Vec<_>>().join(" ");
    let (mut entries, mut rest) = (Vec::new(), contents.as_str());
    while let Some((title, after)) = rest.split_once(" … ") {
        let (page, left) = after.split_once(' ').unwrap_or((after, ""));
        let Ok(page) = page.parse::<usize>() else { break };
        if !title.starts_with(&format!("{} ", entries.len() + 1)) {
            break;
        }
        entries.push((title.to_owned(), page));
        rest = left;
    }
    assert!(entries.len() > 5, "{entries:?}");
    for (title, page) in entries {
        let heading = |text: &str| text.replace('\n', " ").contains(&title);
        let found = pages.get(page - 1).is_some_and(|text| heading(text));
        assert!(found, "{title} is not on page {page}");
    }
}

/// `--pdf` prints into the folder, which then owns it, leaves nothing behind, and says what is missing or failed.
pub(crate) fn the_program_prints(_chromium: &Path) {
    let folder = compared("01_broad_tank", &["--fe", "none"]);
    let home = folder.path();
    let temporary = home.join("tmp");
    fs::create_dir(&temporary).expect("a folder");
    let place = temporary.to_str().expect("text");
    for _ in 0..2 {
        let run = tankcheck(home, &["report", "out", "--pdf"], &[("TMPDIR", place)]);
        assert!(run.status.success(), "{}", said(&run));
        assert!(pages(&home.join("out/report.pdf")) > 2);
        let left: Vec<_> = fs::read_dir(&temporary).expect("readable").collect();
        assert!(left.is_empty(), "{left:?}");
    }
    // A file that exists, or that somebody has changed, is kept.
    fs::write(home.join("mine.pdf"), "mine").expect("writable");
    let run = tankcheck(home, &["report", "out", "--pdf=mine.pdf"], &[]);
    assert_eq!(run.status.code(), Some(2), "{}", said(&run));
    assert_eq!(fs::read(home.join("mine.pdf")).expect("there"), b"mine");
    fs::write(home.join("out/report.pdf"), "signed").expect("writable");
    let run = tankcheck(home, &["report", "out", "--pdf"], &[]);
    assert_eq!(run.status.code(), Some(2), "{}", said(&run));
    assert_eq!(fs::read(home.join("out/report.pdf")).expect("there"), b"signed");
    fs::remove_file(home.join("out/report.pdf")).expect("removable");

    let missing = tankcheck(home, &["report", "out", "--pdf"], &[("CHROME", "/nowhere/chrome")]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(said(&missing).contains("CHROME") && said(&missing).contains("/nowhere/chrome"), "{}", said(&missing));
    let none = tankcheck(home, &["report", "out", "--pdf"], &[("PATH", place)]);
    assert_eq!(none.status.code(), Some(2));
    assert!(said(&none).contains("apt install chromium"), "{}", said(&none));
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let broken = home.join("broken");
        fs::write(&broken, "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\necho 'no display today' >&2\nexit 7\n")
            .expect("writable");
        fs::set_permissions(&broken, fs::Permissions::from_mode(0o755)).expect("a script");
        let variables = [("CHROME", broken.to_str().expect("text")), ("TMPDIR", place)];
        let failed = tankcheck(home, &["report", "out", "--pdf"], &variables);
        assert_eq!(failed.status.code(), Some(3));
        assert!(said(&failed).contains("no display today"), "{}", said(&failed));
        assert!(fs::read_dir(&temporary).expect("readable").next().is_none(), "a folder is left");
        assert!(!home.join("out/report.pdf").exists());
    }
}

/// The document has the headings and tables of the page, formulas as formulas, and neither style nor markup as text; so has the page itself
/// through pandoc alone.
pub(crate) fn pandoc_makes_a_clean_document(pandoc: &Path) {
    let folder = compared("01_broad_tank", &[]);
    let home = folder.path();
    let run = tankcheck(home, &["report", "out", "--format", "docx"], &[]);
    assert!(run.status.success(), "{}", said(&run));
    let html = fs::read_to_string(home.join("out/report.html")).expect("a page");
    let direct = Command::new(pandoc)
        .args(["out/report.html", "--output", "direct.docx"])
        .current_dir(home)
        .output()
        .expect("pandoc starts");
    assert!(direct.status.success());
    for file in ["out/report.docx", "direct.docx"] {
        let read = Command::new(pandoc).args([file, "--to", "json"]).current_dir(home).output().expect("pandoc starts");
        let document: Value = serde_json::from_slice(&read.stdout).expect("JSON of pandoc");
        let mut counts = Counts::default();
        counts.add(&document["blocks"]);
        let headings = html.matches("<h2").count() - usize::from(file.starts_with("out"));
        assert!(counts.headings >= headings, "{file}: {} headings", counts.headings);
        assert!(counts.tables >= html.matches("<caption>").count(), "{file}: {} tables", counts.tables);
        assert!(counts.formulas > 20, "{file}: {} formulas", counts.formulas);
        // Drawings in a page have their looks from its style sheet, which pandoc does not read; those of the document have their own.
        let images = html.matches("<svg ").count();
        assert!(file == "direct.docx" || counts.images >= images, "{file}: {} images of {images}", counts.images);
        for raw in ["<svg", "<path", "@media", "font-family", "</", "base64", "var(--"] {
            assert!(!counts.text.contains(raw), "{file}: `{raw}` as text");
        }
    }
}

/// What a document of pandoc holds.
#[derive(Default)]
struct Counts {
    headings: usize,
    tables: usize,
    formulas: usize,
    images: usize,
    text: String,
}

impl Counts {
    fn add(&mut self, value: &Value) {
        match value {
            Value::Array(items) => items.iter().for_each(|item| self.add(item)),
            Value::Object(map) => {
                let kind = map.get("t").and_then(Value::as_str).unwrap_or_default();
                match kind {
                    "Header" => self.headings += 1,
                    "Table" => self.tables += 1,
                    "Math" => self.formulas += 1,
                    "Image" => self.images += 1,
                    "Str" => {
                        self.text.push_str(map.get("c").and_then(Value::as_str).unwrap_or_default());
                        self.text.push(' ');
                    }
                    _ => {}
                }
                if kind != "Math" {
                    map.values().for_each(|item| self.add(item));
                }
            }
            _ => {}
        }
    }
}

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
    let read =
        Command::new(python).args(["-c", CELLS, "out/report.xlsx"]).current_dir(home).output().expect("python starts");
    assert!(read.status.success(), "{}", said(&read));
    let book: Value = serde_json::from_slice(&read.stdout).expect("JSON");
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
    let mut compared = 0;
    for (row, check) in rows[1..].iter().zip(checks) {
        let unit = row.get(7).and_then(Value::as_str).unwrap_or_default();
        for (column, key) in [(5, "demand"), (6, "capacity")] {
            if let Some(value) = check[key].as_f64() {
                close(&row[column], unit, value);
                compared += 1;
            }
        }
    }
    assert!(compared > 50, "{compared} values of checks");
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
        let read = Command::new(python)
            .args(["-c", PARTS, "out/report.xlsx"])
            .current_dir(home)
            .output()
            .expect("python starts");
        assert!(read.status.success(), "{pair:?}: {}", said(&read));
        let parts: Value = serde_json::from_slice(&read.stdout).expect("JSON");
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
    let converted = Command::new(office)
        .args([&profile, "--headless", "--convert-to", filter, "--outdir", "csv", "out/report.xlsx"])
        .current_dir(home)
        .output()
        .expect("LibreOffice starts");
    assert!(converted.status.success(), "{}", said(&converted));
    let csv: Vec<PathBuf> = fs::read_dir(home.join("csv")).expect("files").map(|e| e.expect("a file").path()).collect();
    let named = |name: &str| csv.iter().find(|p| p.to_string_lossy().contains(name));
    for name in ["Overview", "Quantities", "Checks", "ec8-2006 site", "Profiles"] {
        assert!(named(name).is_some(), "no sheet {name} in {csv:?}");
    }
    let checks = fs::read_to_string(named("Checks").expect("a sheet")).expect("text");
    assert!(checks.starts_with("Method,Excitation,Decides,Check,Clause") && checks.lines().count() > 10, "{checks}");
}

/// The test report of a tank whose checks hold, fail and are not made.
fn findings(format: &str) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let tank = root("examples/05_oil_tank/tank.json");
    let run = tankcheck(folder.path(), &["check", &tank, "--format", format], &[]);
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(text.contains("joint") && !run.status.success(), "{}", said(&run));
    text
}

pub(crate) fn junit_keeps_its_schema(xmllint: &Path) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("junit.xml");
    let schema = root("tests/tools/schema/junit.xsd");
    let valid = |text: &str| {
        fs::write(&file, text).expect("writable");
        let run =
            Command::new(xmllint).args(["--noout", "--schema", &schema]).arg(&file).output().expect("xmllint starts");
        (run.status.success(), said(&run))
    };
    let text = findings("junit");
    let (holds, message) = valid(&text);
    assert!(holds, "{message}");
    assert!(text.contains("<failure "), "{text}");
    // The schema sees a fault.
    assert!(!valid(&text.replace("<failure ", "<fault ")).0);
}

pub(crate) fn sarif_keeps_its_schema(python: &Path) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("tank.sarif");
    let script = "import json, sys, jsonschema\nschema, document = (json.load(open(p)) for p in sys.argv[1:])\njsonschema.validate(document, schema)";
    let schema = root("tests/tools/schema/sarif.json");
    let valid = |text: &str| {
        fs::write(&file, text).expect("writable");
        let run = Command::new(python).args(["-c", script, &schema]).arg(&file).output().expect("python starts");
        (run.status.success(), said(&run))
    };
    let text = findings("sarif");
    let (holds, message) = valid(&text);
    assert!(holds, "{message}");
    let levels = text.matches("\"level\"").count();
    assert!(levels > 0, "{text}");
    assert!(!valid(&text.replace("\"level\": \"error\"", "\"level\": \"bad\"")).0);
}
