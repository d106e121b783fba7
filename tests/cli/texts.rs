//! Texts of the user in files for other programs, read by other readers: no character breaks a form, no text is a command to the runner of
//! a workflow or a formula of a spreadsheet.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Output};

use files::text::{line, visible};

use crate::study::tankcheck;

/// Texts in the place of every name.
const TEXTS: [&str; 22] = [
    "=1+1",
    "+cmd|' /C calc'!A0",
    "-2+3",
    "@SUM(1)",
    "\t=1",
    "\r=1",
    "＝1",
    "a,b;c\"d\"",
    "\0\u{1}\u{b}\u{1f}\u{7f}\u{85}\u{9b}x",
    "a\u{200b}b\u{200d}\u{2060}\u{2062}\u{feff}",
    "\u{202e}a\u{2066}b\u{2028}c\u{2029}",
    "a\u{fffe}b\u{ffff}c\u{fffd}",
    "\u{e0041}\u{1f600}\u{10ffff}",
    "]]></x><!-- &amp; &#0; <b a='1'>\"",
    "</script><script>alert(1)</script></style></svg>",
    "a\n::error file=x::forged",
    "\r\n::stop-commands::t\r\n::add-mask::s",
    "::error::forged",
    "##[error]forged ##vso[task.complete]",
    "%0A::error::a%25",
    "_x0041_ {{ a }} {% b %} ${{ c }}",
    "a\u{2028}::error::b\u{a0}",
];

fn quoted(text: &str) -> String {
    serde_json::to_string(text).unwrap()
}

/// A tank with this text wherever a user has a word.
fn tank(text: &str) -> String {
    // The name of a material has at most 100 characters.
    let short: String = text.chars().take(90).collect();
    let (material, unused) = (quoted(&short), quoted(&format!("{short}u")));
    let text = &quoted(text);
    format!(
        r#"{{
  "name": {text}, "notes": {text},
  "project": {{ "name": {text}, "client": {text}, "document": {text}, "revision": {text}, "author": {text}, "checker": {text}, "approver": {text} }},
  "tank": {{ "shape": "cylinder", "radius": "10 m", "support": "anchored",
    "courses": [ {{ "height": "8 m", "thickness": "10 mm", "material": {material} }} ] }},
  "liquid": {{ "density": "1000 kg/m3", "fill_height": "7 m" }},
  "materials": {{ {material}: {{ "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "235 MPa" }},
    {unused}: {{ "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "2.35 GPa" }} }},
  "site": {{ "ec8": {{ "ag": "0.2 g", "ground": "B", "importance": 1.0, "spectrum": 1 }} }},
  "measured": {{ "sloshing_height": {{ "value": "10 cm", "source": {text}, "note": {text} }} }},
  "published": [ {{ "quantity": "base_shear", "value": "1 kN", "source": {text}, "note": {text} }} ]
}}"#
    )
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let output = tankcheck(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{arguments:?}: {said}");
    output
}

fn printed(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

/// No line of a log is a command but those of the form of GitHub, each on its line.
fn no_commands(output: &Output, words: &[&str]) {
    for text in [&output.stdout, &output.stderr] {
        for line in std::str::from_utf8(text).unwrap().lines() {
            let own = words.iter().any(|word| line.starts_with(word));
            assert!(own || !line.trim_start().starts_with("::"), "{line}");
            assert!(own || !(line.contains("##[") || line.contains("##vso[")), "{line}");
        }
    }
}

/// Every cell of the tables on standard output, by another reader.
fn cells(text: &str) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
    let rows = reader.records().map(|row| row.unwrap());
    rows.flat_map(|row| row.iter().map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// Names of the elements of a page.
fn elements(page: &str) -> BTreeSet<&str> {
    let tags = page.split('<').skip(1);
    tags.map(|tag| tag.split([' ', '>', '\n']).next().unwrap_or_default()).collect()
}

#[test]
fn test_reports_are_well_formed_and_command_nothing() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    std::fs::write(folder.join("plain.json"), tank("plain")).unwrap();
    let count = printed(&run(folder, &["check", "plain.json", "--format", "github"])).lines().count();
    assert!(count > 3, "{count}");
    for (i, text) in TEXTS.iter().enumerate() {
        // A file name has no NUL and no slash.
        let name = format!("{}.json", text.replace(['\0', '/'], ""));
        let name = if i % 2 == 0 { name } else { format!("-{name}") };
        std::fs::write(folder.join(&name), tank(text)).unwrap();
        let check = |format: &str| run(folder, &["check", "--format", format, "--", &name]);
        let [human, json, junit, sarif, csv] = ["human", "json", "junit", "sarif", "csv"].map(check);
        let github = check("github");
        no_commands(&github, &["::error file=", "::warning file=", "::notice file="]);
        assert_eq!(printed(&github).lines().count(), count, "{}", printed(&github));
        assert!(printed(&github).lines().all(|line| line.starts_with("::")), "{}", printed(&github));
        let document = roxmltree::Document::parse(printed(&junit)).unwrap_or_else(|e| panic!("{text:?}: {e}"));
        let suites = document.root_element().attribute("name").unwrap();
        let shown = visible(text).replace("##[", "\\u{23}#[").replace("##vso", "\\u{23}#vso");
        assert_eq!(suites, shown, "{text:?}");
        let read: serde_json::Value = serde_json::from_slice(&sarif.stdout).unwrap();
        let place = &read["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
        assert!(place.as_str().unwrap().is_ascii(), "{place}");
        let read: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
        assert_eq!(read["name"], *text);
        for output in [&human, &json, &junit, &sarif, &csv] {
            no_commands(output, &[]);
        }
        for cell in cells(printed(&csv)) {
            let begins = cell.trim_start().starts_with(['=', '+', '-', '@']);
            assert!(!begins || cell.parse::<f64>().is_ok(), "{cell}");
        }
    }
}

/// Texts of a table come back in the table of results, as texts; numbers are numbers.
#[test]
fn tables_have_texts_and_numbers() {
    let home = tempfile::tempdir().unwrap();
    std::fs::write(home.path().join("tank.json"), tank("plain")).unwrap();
    let names = ["=1+1", "+cmd", "-2+3", "@SUM(1)", "a,\"b\"", "'=1", "-7"];
    let rows: String = names.iter().map(|name| format!("{},6 m\n", files::text::cell(name))).collect();
    std::fs::write(home.path().join("t.csv"), format!("name,liquid.fill_height\n{rows}")).unwrap();
    let output = run(home.path(), &["check", "tank.json", "--table", "t.csv"]);
    let found = cells(printed(&output));
    for (name, written) in names.iter().zip(["'=1+1", "'+cmd", "'-2+3", "'@SUM(1)", "a,\"b\"", "''=1", "-7"]) {
        assert!(found.iter().any(|cell| cell == written), "{name}: {found:?}");
        assert_eq!(files::text::uncelled(written), *name);
    }
    // What was written is read as what it was.
    std::fs::write(home.path().join("again.csv"), format!("name,liquid.fill_height\n{rows}")).unwrap();
    let again = run(home.path(), &["check", "tank.json", "--table", "again.csv"]);
    assert_eq!(output.stdout, again.stdout);
}

/// A page with hostile texts has no other elements than one with plain texts; its figures are XML; the workbook's parts: `tests/tools`.
#[test]
fn pages_and_figures_are_well_formed() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    let record: String =
        (0..=200).map(|i| format!("{:.2},{:.4}\n", 0.02 * f64::from(i), (0.3 * f64::from(i)).sin())).collect();
    std::fs::write(folder.join("r.csv"), format!("time_s,acceleration_m_s2\n{record}")).unwrap();
    let page = |name: &str, text: &str| {
        std::fs::write(folder.join(format!("{name}.json")), tank(text)).unwrap();
        run(folder, &["compare", &format!("{name}.json"), "--quake", "r.csv", "--out", name]);
        for file in std::fs::read_dir(folder.join(name).join("figures")).unwrap() {
            let svg = std::fs::read_to_string(file.unwrap().path()).unwrap();
            roxmltree::Document::parse(&svg).unwrap_or_else(|e| panic!("{e}: {svg}"));
        }
        std::fs::read_to_string(folder.join(name).join("report.html")).unwrap()
    };
    let plain = page("plain", "plain");
    let all: String = TEXTS.concat();
    let hostile = page("hostile", &all);
    assert_eq!(elements(&plain), elements(&hostile));
    assert!(hostile.contains(r"\u{fffe}") && !hostile.chars().any(files::text::hostile));
    let found: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("hostile/results.json")).unwrap()).unwrap();
    assert_eq!(found["name"], all);
}

/// States of a fragility model with hostile names, for OpenQuake and pelicun.
#[test]
fn models_of_other_programs_are_well_formed() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    let mut stripes = String::from("im,n,exceed,damage_state\n");
    for text in TEXTS {
        for (im, exceed) in [(0.1, 1), (0.3, 9), (0.5, 20), (1.0, 37)] {
            stripes.push_str(&format!("{im},40,{exceed},\"{}\"\n", text.replace('"', "\"\"")));
        }
    }
    std::fs::write(folder.join("s.csv"), stripes).unwrap();
    let options = ["--bootstrap", "0", "--im", "PGA", "--nrml", "m.xml", "--pelicun", "p.csv", "--format", "csv"];
    let output = run(folder, &[&["fragility", "--stripes", "s.csv"][..], &options].concat());
    no_commands(&output, &[]);
    let nrml = std::fs::read_to_string(folder.join("m.xml")).unwrap();
    let document = roxmltree::Document::parse(&nrml).unwrap();
    let states =
        document.descendants().find(|n| n.has_tag_name(("http://openquake.org/xmlns/nrml/0.5", "limitStates")));
    let count = states.and_then(|n| n.text()).map_or(0, |t| t.split(' ').count());
    assert_eq!(count, document.descendants().filter(|n| n.tag_name().name() == "params").count(), "{nrml}");
    for table in [printed(&output), &std::fs::read_to_string(folder.join("p.csv")).unwrap()] {
        for cell in cells(table) {
            let begins = cell.trim_start().starts_with(['=', '+', '-', '@']);
            assert!(!begins || cell.parse::<f64>().is_ok(), "{cell}");
        }
    }
}

/// Arguments and names in messages.
#[test]
fn messages_command_nothing() {
    let home = tempfile::tempdir().unwrap();
    for text in TEXTS.iter().filter(|text| !text.contains('\0')) {
        for arguments in [
            &["check", "--", text][..],
            &["check", "tank.json", "--procedures", text],
            &["compare", "tank.json", "--quake", text],
            &["report", "--", text],
            &["diff", "--", text, text],
            &["explain", "--", text],
            &[text],
        ] {
            let output = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
                .args(arguments)
                .current_dir(home.path())
                .output()
                .unwrap();
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            no_commands(&output, &[]);
        }
        assert_eq!(line(text).lines().count(), 1);
    }
}
