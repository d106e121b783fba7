//! A battery of hostile names in tank files, records, file names and arguments: no character that controls a terminal or the
//! order of text reaches standard output, standard error, a page or a figure unescaped.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use files::text::hostile;

/// Red, clear screen, C1 control sequence introducer, right-to-left override, isolate, mark, line separator.
const POISON: &str = "a\u{1b}[31m\u{1b}[2J\u{9b}2J\u{202e}b\u{2066}c\u{200f}\u{2028}\u{85}d";

struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    fn new() -> Home {
        Home { folder: tempfile::tempdir().expect("a temporary folder") }
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    fn write(&self, name: &str, text: &str) -> String {
        std::fs::write(self.path().join(name), text).expect("writable");
        name.to_owned()
    }

    /// Runs in this folder; whatever is printed must be harmless.
    fn run(&self, arguments: &[&str]) -> Output {
        let output = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(arguments)
            .current_dir(self.path())
            .output()
            .expect("tankcheck runs");
        for (name, bytes) in [("stdout", &output.stdout), ("stderr", &output.stderr)] {
            let text = std::str::from_utf8(bytes).expect("UTF-8");
            clean(&format!("{name} of {arguments:?}"), text);
        }
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(!message.contains("panicked"), "{message}");
        output
    }

    fn runs(&self, codes: &[i32], arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        let code = output.status.code().expect("an exit code");
        assert!(codes.contains(&code), "{arguments:?}: {code} {message}");
        String::from_utf8_lossy(&output.stdout).into_owned() + &message
    }
}

fn clean(what: &str, text: &str) {
    if let Some((at, c)) = text.char_indices().find(|(_, c)| hostile(*c)) {
        let around: String = text[..at].chars().rev().take(60).collect::<Vec<_>>().into_iter().rev().collect();
        panic!("{what}: U+{:04X} after {around:?}", c as u32);
    }
}

/// Every page and figure below a folder.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("readable") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|e| e == "html" || e == "svg") {
            found.push(path);
        }
    }
    found
}

fn clean_pages(folder: &Path) -> usize {
    let found = pages(folder);
    for page in &found {
        clean(&page.display().to_string(), &std::fs::read_to_string(page).expect("UTF-8"));
    }
    found.len()
}

/// A poisoned text as a JSON string.
fn quoted(text: &str) -> String {
    serde_json::to_string(text).expect("a string")
}

/// A sound tank whose every free text is poisoned.
fn tank() -> String {
    let poison = quoted(&format!("{POISON}\nerror: forged\t"));
    let material = quoted(POISON);
    format!(
        r#"{{
  "name": {poison}, "notes": {poison},
  "tank": {{ "shape": "cylinder", "radius": "4 m", "support": "anchored",
    "courses": [ {{ "height": "4 m", "thickness": "8 mm", "material": {material} }} ] }},
  "liquid": {{ "density": "1000 kg/m3", "fill_height": "3.6 m" }},
  "materials": {{
    {material}: {{ "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "235 MPa",
      "behaviour": {{ "steel": {{ "tangent_modulus": "2 GPa" }} }} }},
    {unused}: {{ "youngs_modulus": "3 GPa", "poisson_ratio": 0.3, "density": "1200 kg/m3", "yield_strength": "250 MPa" }}
  }},
  "measured": {{ "sloshing_height": {{ "value": "10 cm", "source": {poison}, "note": {poison} }} }},
  "published": [ {{ "quantity": "base_shear", "value": "1 kN", "source": {poison}, "note": {poison} }} ],
  "analysis": {{ "nonlinear": {{ "elements": {{ "height": 8, "circumference": 16 }}, "time_step": "5 ms" }} }}
}}"#,
        unused = quoted(&format!("unused{POISON}")),
    )
}

fn samples(separator: &str) -> String {
    (0..=30)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            format!("{t:.2}{separator}{:.5}\n", 0.5 * (60.0 * t).sin())
        })
        .collect()
}

/// Records whose title, header and file name are poisoned: a CSV file, and a PEER file with its title.
fn records(home: &Home) -> [String; 2] {
    // The reader rejects every C0 control character in a record.
    let poison: String = POISON.chars().filter(|c| !c.is_ascii_control()).collect();
    let csv = home.write(&format!("r{POISON}.csv"), &format!("# {poison}\ntime_s,acceleration_m_s2\n{}", samples(",")));
    let values: String = samples(" ").lines().map(|l| format!("{}\n", l.split(' ').nth(1).unwrap())).collect();
    let at2 = home.write(
        &format!("p{POISON}.at2"),
        &format!("PEER NGA {poison}\n{poison}\nACCELERATION TIME SERIES IN UNITS OF G {poison}\nNPTS= 31, DT= .01 SEC\n{values}"),
    );
    [csv, at2]
}

#[test]
fn results_and_reports_show_hostile_text_as_escapes() {
    let home = Home::new();
    let tank = home.write(&format!("t{POISON}.json"), &tank());
    let [csv, at2] = records(&home);
    let out = format!("o{POISON}");
    let text = home.runs(&[0, 1, 4], &["compare", &tank, "--quake", &csv, "--out", &out]);
    assert!(text.contains(r"\u{1b}"), "the folder is named: {text}");
    assert!(clean_pages(&home.path().join(&out)) > 5);
    // The file for programs has the exact text.
    let results: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(home.path().join(&out).join("results.json")).unwrap()).unwrap();
    assert!(results["name"].as_str().unwrap().starts_with(POISON));
    let page = std::fs::read_to_string(home.path().join(&out).join("report.html")).unwrap();
    assert!(page.contains(r"\u{1b}[31m") && page.contains(r"\u{202e}b"));
    for format in ["human", "json", "csv"] {
        let text = home.runs(
            &[0, 1, 4],
            &["compare", &tank, "--quake", &at2, "--out", "again", "--no-mesh-error", "--format", format],
        );
        if format == "json" {
            let end = text.rfind("\n}").unwrap() + 2;
            let value: serde_json::Value = serde_json::from_str(&text[..end]).expect("JSON");
            assert!(value["name"].as_str().unwrap().starts_with(POISON), "the value is the exact text");
        }
        home.runs(&[0, 1, 4], &["check", &tank, "--quake", &csv, "--format", format]);
        home.runs(&[0], &["modes", &tank, "--format", format]);
        home.runs(&[0, 1], &["diff", &out, "again", "--format", format]);
        home.runs(&[0], &["spectrum", &at2, "--format", format]);
        home.runs(&[0, 2], &["quake", "info", &csv, "--format", format]);
        home.runs(&[0, 2], &["quake", "info", &at2, "--format", format]);
    }
    let shown = home.runs(&[0], &["modes", &tank]);
    assert!(!shown.contains("\nerror: forged"), "a name forges no line: {shown}");
    home.runs(&[0], &["report", &out]);
    assert!(clean_pages(home.path()) > 10);
}

#[test]
fn analyses_show_hostile_text_as_escapes() {
    let home = Home::new();
    let tank = home.write(&format!("t{POISON}.json"), &tank());
    let [csv, _] = records(&home);
    for format in ["human", "json", "csv"] {
        let out = format!("{format}{POISON}");
        home.runs(&[0], &["ida", &tank, "--quake", &csv, "--scale", "0.1", "--out", &out, "--format", format]);
        assert!(clean_pages(&home.path().join(&out)) > 1);
    }
    // A place that does not exist ends a pushover after the tank was read.
    home.runs(&[2], &["push", &tank, "--out", &tank]);
}

#[test]
fn messages_show_hostile_text_as_escapes() {
    let home = Home::new();
    let poison = quoted(POISON);
    let sound = tank();
    let good = home.write("good.json", &sound);
    let [csv, _] = records(&home);
    let faults = [
        sound.replace("\"notes\"", &poison),
        sound.replace("\"anchored\"", &poison),
        sound.replace("\"4 m\", \"support\"", &format!("{poison}, \"support\"")),
        sound.replace("\"8 mm\", \"material\": ", "\"8 mm\", \"material\": \"x\", \"y\": "),
        sound.replace("\"sloshing_height\"", &poison),
        // Raw characters, not escapes: the line itself is shown.
        sound.replace("\"anchored\"", "\"x\u{9b}2J\u{202e}\u{2028}\""),
        sound.replace("\"anchored\"", "\"x\u{1b}[31m\""),
        sound.replace("\"anchored\"", "x\u{1b}[31m\u{9b}"),
        format!("{{ \"a\" \u{1b}[2J : {sound}"),
        format!("{sound} \u{202e}\u{1b}"),
    ];
    for (i, text) in faults.iter().enumerate() {
        assert_ne!(text, &sound, "case {i}");
        let name = home.write(&format!("f{i}{POISON}.json"), text);
        for command in ["check", "modes", "push"] {
            let shown = home.runs(&[2], &[command, &name]);
            assert!(shown.contains(r"\u{1b}"), "case {i}: {shown}");
        }
    }
    for (name, text) in [
        ("empty", ""),
        ("words", "\u{9b}2J\u{202e} words\nmore\u{85} words\n"),
        ("cells", "time_s,acceleration_m_s2\n0,1\u{9b}\u{202e}\n0.1,2\n"),
        ("control", "0,1\n\u{1b}[2J,2\n"),
        ("heads", "time\u{202e}_s,velocity\u{9b}_m_s\n0,1\n0.1,2\n"),
        ("npts", "PEER\n\u{9b}\nUNITS OF \u{202e}\nNPTS= \u{9b}x, DT= .01\n1 2 3\n"),
    ] {
        let name = home.write(&format!("{name}{POISON}.csv"), text);
        home.runs(&[2], &["quake", "info", &name]);
        home.runs(&[2], &["compare", &good, "--quake", &name]);
    }
    let missing = format!("none{POISON}");
    for command in [
        &["check", &missing][..],
        &["check", &good, "--out", &good],
        &["check", &good, "--procedures", POISON],
        &["check", &good, "--format", POISON],
        &["compare", &good, "--quake", &missing],
        &["compare", &good, "--quake", &csv, "--templates", &missing],
        &["compare", &good, "--quake", &csv, "--fe", "nonlinear", "--checkpoint", &format!("{missing}/x")],
        &["compare", &good, "--quake", &csv, "--fe", "both", "--mesh", POISON],
        &["ida", &good, "--quake", &csv, "--scale", POISON],
        &["ida", &good, "--quake", &csv, "--scale", "0..1", "--steps", POISON],
        &["push", &good, "--imperfection", POISON],
        &["spectrum", &csv, "--damping", POISON],
        &["spectrum", &csv, "--periods", POISON],
        &["spectrum", &csv, "--scale-to", POISON],
        &["report", &missing],
        &["diff", &missing, &missing],
        &["verify", POISON],
        &["completions", POISON],
        &["completions", "--man", POISON],
        &[POISON],
        &["--color", POISON],
        &["check", &good, &format!("--{POISON}")],
    ] {
        home.runs(&[2], command);
    }
    // Without a checkpoint the run starts from the beginning and reports it.
    home.runs(&[0, 1, 2, 4], &["compare", &good, "--quake", &csv, "--fe", "nonlinear", "--resume", "--out", &missing]);
}

/// With colours asked for, the only escape sequences are our own: select graphic rendition.
#[test]
fn colours_are_ours_alone() {
    let home = Home::new();
    let name = home.write("t.json", &tank().replace("\"anchored\"", &quoted(POISON)));
    let output = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["check", &name, "--color", "always"])
        .current_dir(home.path())
        .output()
        .expect("tankcheck runs");
    let text = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(text.contains("\u{1b}["), "{text}");
    assert!(text.contains(r"\u{1b}[31m"), "{text}");
    let mut rest = text.as_str();
    let mut bare = String::new();
    while let Some(at) = rest.find("\u{1b}[") {
        bare.push_str(&rest[..at]);
        let sequence = &rest[at + 2..];
        let end = sequence.find(|c: char| !c.is_ascii_digit() && c != ';').expect("an end");
        assert_eq!(&sequence[end..=end], "m", "{sequence}");
        rest = &sequence[end + 1..];
    }
    bare.push_str(rest);
    clean("without its colours", &bare);
}
