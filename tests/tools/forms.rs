//! Reports for print, text processors and spreadsheets, and test reports for CI, as other programs read them.
//!
//! Goal:     pages of A4, a clean text document with pictures, test reports that keep their schemas
//! Model:    examples 01 (two codes, an engine) and 05 (four grounds, two deciding codes, the longest sheets)
//! Expected: see each test

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::{Mutex, PoisonError};

use serde_json::Value;

const PROGRAM: &str = env!("CARGO_BIN_EXE_tankcheck");

/// The program in a folder, with the files of the repository at hand.
pub(crate) fn tankcheck(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).current_dir(folder);
    for (name, value) in variables {
        command.env(name, value);
    }
    command.output().expect("the program starts")
}

/// Another program in a folder.
pub(crate) fn other(program: &Path, folder: &Path, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).current_dir(folder).output().expect("the program starts")
}

pub(crate) fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

pub(crate) fn root(file: &str) -> String {
    format!("{}/{file}", env!("CARGO_MANIFEST_DIR"))
}

/// Results of an example in `out` of a new folder; they are computed once.
pub(crate) fn compared(example: &str, options: &[&str]) -> tempfile::TempDir {
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

/// What a script of Python prints about a file, as JSON.
pub(crate) fn read(python: &Path, folder: &Path, script: &str, file: &str) -> Value {
    let read = other(python, folder, &["-c", script, file]);
    assert!(read.status.success(), "{file}: {}", said(&read));
    serde_json::from_slice(&read.stdout).expect("JSON")
}

/// Pages of a PDF as Chromium writes it.
fn pages(pdf: &Path) -> usize {
    let bytes = fs::read(pdf).expect("the PDF exists");
    assert!(bytes.starts_with(b"%PDF"));
    String::from_utf8_lossy(&bytes).matches("/MediaBox [").count()
}

/// Two pages of summary; at most ten at the standard level.
pub(crate) fn pages_are_few(_chromium: &Path) {
    for (example, options, limits) in [
        ("01_broad_tank", &[][..], [2, 10]),
        ("01_broad_tank", &["--procedures", "ec8-2006"], [2, 10]),
        // Two codes decide, each with its whole sheet.
        ("05_oil_tank", &[], [2, 10]),
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
    let read = other(pdftotext, home, &["-raw", "out/report.pdf", "-"]);
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
    let direct = other(pandoc, home, &["out/report.html", "--output", "direct.docx"]);
    assert!(direct.status.success());
    for file in ["out/report.docx", "direct.docx"] {
        let read = other(pandoc, home, &[file, "--to", "json"]);
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

/// The parts of a document: each file of a picture, the kind that its ending has, and whether every relation leads to a part.
const PICTURES: &str = r#"
import json, posixpath, sys, zipfile
from xml.etree import ElementTree as E
z = zipfile.ZipFile(sys.argv[1])
assert z.testzip() is None
names = set(z.namelist())
parts = {n: E.fromstring(z.read(n)) for n in names if n.endswith((".xml", ".rels"))}
kinds = {d.get("Extension"): d.get("ContentType") for d in parts["[Content_Types].xml"] if d.get("Extension")}
own = {d.get("PartName").lstrip("/"): d.get("ContentType") for d in parts["[Content_Types].xml"] if d.get("PartName")}
relations = {r.get("Id"): r for r in parts["word/_rels/document.xml.rels"]}
lost = [r.get("Target") for r in relations.values()
        if r.get("TargetMode") != "External" and posixpath.normpath("word/" + r.get("Target")) not in names]
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}embed"
blips = [relations[b.get(R)].get("Target") for b in parts["word/document.xml"].iter() if b.tag.endswith("}blip")]
pictures = [[t, own.get("word/" + t) or kinds.get(t.rsplit(".")[-1]), z.read("word/" + t)[40:44].decode("latin1")] for t in blips]
print(json.dumps({"lost": lost, "pictures": pictures}))
"#;

/// The pictures of a document are metafiles, which Word shows without further programs; no relation leads nowhere.
pub(crate) fn pictures_are_metafiles(_pandoc: &Path) {
    let folder = compared("01_broad_tank", &["--fe", "none"]);
    let home = folder.path();
    let run = tankcheck(home, &["report", "out", "--format", "docx"], &[]);
    assert!(run.status.success() && !said(&run).contains("warning"), "{}", said(&run));
    let parts = read(Path::new("python3"), home, PICTURES, "out/report.docx");
    assert_eq!(parts["lost"], serde_json::json!([]));
    let pictures = parts["pictures"].as_array().expect("pictures");
    let html = fs::read_to_string(home.join("out/report.html")).expect("a page");
    assert_eq!(pictures.len(), html.matches("<svg ").count());
    for picture in pictures {
        assert!(picture[1].as_str().is_some_and(|kind| kind.contains("emf")), "{picture}");
        assert_eq!(picture[2], " EMF", "{picture}");
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

/// The test report of a tank whose checks hold, fail and are not made.
fn findings(format: &str) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let tank = root("examples/05_oil_tank/tank.json");
    let run = tankcheck(folder.path(), &["check", &tank, "--format", format], &[]);
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(text.contains("joint") && !run.status.success(), "{}", said(&run));
    text
}

/// Holds a test report against its schema, and the same with a fault in it, which the schema sees.
///
/// * `fault`: a text of the report, and what it becomes
fn keeps_its_schema(format: &str, fault: [&str; 2], validated: impl Fn(&Path) -> Output) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("report");
    let run = |text: &str| {
        fs::write(&file, text).expect("writable");
        validated(&file)
    };
    let text = findings(format);
    let valid = run(&text);
    assert!(valid.status.success(), "{}", said(&valid));
    let [right, wrong] = fault;
    assert!(text.contains(right), "{text}");
    assert!(!run(&text.replace(right, wrong)).status.success());
}

pub(crate) fn junit_keeps_its_schema(xmllint: &Path) {
    let schema = root("tests/tools/schema/junit.xsd");
    keeps_its_schema("junit", ["<failure ", "<fault "], |file| {
        Command::new(xmllint).args(["--noout", "--schema", &schema]).arg(file).output().expect("xmllint starts")
    });
}

pub(crate) fn sarif_keeps_its_schema(python: &Path) {
    let script = "import json, sys, jsonschema\nschema, document = (json.load(open(p)) for p in sys.argv[1:])\njsonschema.validate(document, schema)";
    let schema = root("tests/tools/schema/sarif.json");
    keeps_its_schema("sarif", ["\"level\": \"error\"", "\"level\": \"bad\""], |file| {
        Command::new(python).args(["-c", script, &schema]).arg(file).output().expect("python starts")
    });
}
