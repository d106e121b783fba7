//! Codes of errors and warnings: every one is explained on a page that is fresh, used, and reached by a run of the program.

use std::path::{Path, PathBuf};
use std::process::Output;

use files::code::{Code, Severity};

use crate::study::tankcheck;

/// A good tank; triggers spoil it in one place.
const TANK: &str = r#"{
  "name": "test tank",
  "tank": {
    "shape": "cylinder",
    "radius": "7.5 m",
    "support": "anchored",
    "courses": [
      { "height": "4 m", "thickness": "8 mm", "material": "steel" },
      { "height": "4 m", "thickness": "6 mm", "material": "steel" }
    ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "6.5 m" },
  "materials": {
    "steel": { "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "235 MPa" }
  },
  "site": { "ec8": { "ground": "B", "spectrum": 1, "ag": "0.25 g", "importance": 1.0 } }
}
"#;

const RECORD: &str = "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0.5\n0.06,-1\n0.08,0\n0.10,0.2\n0.12,0\n0.14,0.1\n0.16,0\n0.18,0.1\n0.2,0\n";

/// How a code comes up.
enum Trigger {
    /// A command, with `tank.json` spoiled in one place.
    Tank(&'static str, &'static str),
    /// A command with a record or table `r.csv` of this content.
    File(&'static [&'static str], &'static str),
    /// A command on the good files.
    Run(&'static [&'static str]),
    /// Not to be had in a test, for this reason; the sources use it.
    Sources(&'static str),
}

/// Exhaustive: a new code does not compile without its trigger.
fn trigger(code: Code) -> Trigger {
    use Trigger::{File, Run, Sources, Tank};
    const INFO: &[&str] = &["quake", "info", "r.csv"];
    match code {
        Code::Usage => Run(&["check", "tank.json", "--quakes", "r"]),
        Code::OptionValue => Run(&["spectrum", "good.csv", "--damping", "120%"]),
        Code::OptionConflict => Run(&["check", "tank.json", "--select", "checks"]),
        Code::MissingInput => Tank(
            "\"site\": { \"ec8\": { \"ground\": \"B\", \"spectrum\": 1, \"ag\": \"0.25 g\", \"importance\": 1.0 } }",
            "\"damping\": {}",
        ),
        Code::UnknownId => Run(&["check", "tank.json", "--procedures", "ec9"]),
        Code::Syntax => Tank("\"radius\": \"7.5 m\",", "\"radius\": \"7.5 m\""),
        Code::CutOff => Tank("\"importance\": 1.0 } }\n}", "\"importance\": 1.0 } }"),
        Code::EmptyFile => File(INFO, "# nothing\n"),
        Code::TooLarge => Tank(
            "\"name\": \"test tank\"",
            "\"name\": [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]",
        ),
        Code::DuplicateKey => Tank("\"radius\": \"7.5 m\"", "\"radius\": \"7.5 m\", \"radius\": \"7 m\""),
        Code::UnknownKey => Tank("\"radius\"", "\"diameter\""),
        Code::MissingKey => Tank(", \"fill_height\": \"6.5 m\"", ""),
        Code::WrongKind => Tank("\"courses\": [", "\"roof\": [], \"courses\": ["),
        Code::UnknownChoice => Tank("\"anchored\"", "\"anchord\""),
        Code::NotANumber => Tank("\"7.5 m\"", "\"seven m\""),
        Code::NotFinite => File(INFO, "time_s,acceleration_m_s2\n0,0\n0.02,nan\n0.04,1\n"),
        Code::UnitMissing => Tank("\"7.5 m\"", "\"7.5\""),
        Code::UnitUnknown => Tank("\"7.5 m\"", "\"7.5 meters\""),
        Code::UnitOfOther => Tank("\"7.5 m\"", "\"7.5 kg\""),
        Code::OutOfRange => Tank("0.3,", "0.7,"),
        Code::ItemCount => Tank("\"site\"", "\"procedures\": { \"run\": [] }, \"site\""),
        Code::BadForm => Tank("\"site\"", "\"project\": { \"date\": \"14.3.2026\" }, \"site\""),
        Code::Repeated => Tank("\"site\"", "\"procedures\": { \"run\": [\"ec8-2006\", \"ec8-2006\"] }, \"site\""),
        Code::Contradiction => Tank(
            "\"courses\"",
            "\"bottom\": { \"thickness\": \"8 mm\", \"material\": \"steel\", \"annular_thickness\": \"6 mm\", \"annular_width\": \"1 m\" }, \"courses\"",
        ),
        Code::LiquidAboveWall => Tank("\"6.5 m\"", "\"8.5 m\""),
        Code::DoesNotApply => Tank("\"anchored\"", "\"unanchored\", \"anchors\": { \"count\": 8 }"),
        Code::Exclusive => Tank("\"site\"", "\"record\": { \"scale_to\": \"0.3 g\", \"scale_by\": 2 }, \"site\""),
        Code::Incomplete => Tank(
            "\"courses\"",
            "\"bottom\": { \"thickness\": \"8 mm\", \"material\": \"steel\", \"annular_thickness\": \"9 mm\" }, \"courses\"",
        ),
        Code::Unsupported => Run(&["push", "tank.json", "--out", "push"]),
        Code::RecordFormat => File(INFO, "0 1\n0.1 2 3\n0.2 1\n"),
        Code::NotAcceleration => File(INFO, "time_s,velocity_m_s\n0,0\n0.02,1\n"),
        Code::RecordUnit => File(INFO, "0 0\n0.02 1\n0.04 0\n"),
        Code::TimeStep => File(INFO, "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.05,1\n0.07,0\n0.09,0\n"),
        Code::RecordLength => File(INFO, "time_s,acceleration_m_s2\n0,1\n"),
        Code::RecordChannel => File(&["quake", "info", "r.csv", "--channel", "2"], RECORD),
        Code::PeakAcceleration => File(INFO, "time_s,acceleration_m_s2\n0,0\n0.02,0\n0.04,0\n"),
        Code::TableShape => File(&["check", "tank.json", "--table", "r.csv"], "name,tank.radius\nT1\n"),
        Code::TableColumn => File(&["check", "tank.json", "--table", "r.csv"], "name,name\nT1,T2\n"),
        Code::TableValue => File(&["fragility", "--stripes", "r.csv"], "im,n,exceed\n0.3,10,12\n0.4,10,13\n"),
        Code::StudyChanged => Sources("needs a planned study; tests/cli/study.rs has one"),
        Code::StudyIncomplete => Sources("needs a planned study; tests/cli/study.rs has one"),
        Code::FileUnreadable => Run(&["check", "absent.json"]),
        Code::FileTaken => Run(&["check", "tank.json", "--out", "tank.json"]),
        Code::NotWritten => Sources("needs a full disk"),
        Code::Output => Sources("needs a full device; tests/cli/streams.rs has one"),
        Code::NotResults => Run(&["report", "broken"]),
        Code::Report => Sources("needs a faulty template"),
        Code::Checkpoint => Sources("needs a damaged checkpoint; tests/cli/nonlinear_run.rs has one"),
        Code::Procedure | Code::NotPositiveDefinite | Code::Eigenvalues | Code::Analysis | Code::ResultNotFinite => {
            Sources("a computation that fails is a fault wherever one is known")
        }
        Code::Memory => Run(&["modes", "tank.json", "--fe", "solid", "--memory-limit", "1"]),
        Code::TooLong => Sources("tests/cli/estimates.rs"),
        Code::Interrupted => Sources("needs Ctrl-C; tests/cli/interrupt.rs"),
        Code::Base => Sources("no input is known"),
        Code::Benchmark => Sources("a fault wherever one is known"),
        Code::Internal => Sources("a fault wherever one is known; src/cli/fault.rs provokes it"),
        Code::UnusualTank => Tank("\"7850 kg/m3\"", "\"78.5 kg/m3\""),
        Code::UnusualInput => Tank("\"importance\": 1.0", "\"importance\": 0.7"),
        Code::Inconsistent => Tank("\"235 MPa\"", "\"235 MPa\", \"allowable_stress\": \"300 MPa\""),
        Code::NotUsed => Tank("\"courses\"", "\"pressure\": { \"internal\": \"2 kPa\" }, \"courses\""),
        Code::UnusualRecord => File(INFO, "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0\n"),
        Code::UnusedAcceptance => Tank(
            "\"site\"",
            "\"accepted\": [ { \"check\": \"slidding\", \"reason\": \"checked by others\", \"by\": \"J. Doe\", \"date\": \"2026-03-14\" } ], \"site\"",
        ),
        Code::LimitExceeded => Sources("needs a run; tests/cli/limits.rs"),
        Code::Unusable => Sources("needs a run; tests/cli/plausible.rs"),
        Code::LiquidParted => Sources("needs a run"),
        Code::PartlyKept => Sources("needs a full disk; tests/cli/push_resume.rs"),
        Code::PushAssumption => Sources("needs a pushover"),
        Code::ProgramMissing => Sources("needs a results folder and a machine without the program"),
        Code::ChangedResults => Sources("needs a results folder"),
        Code::BaseModel => Sources("needs an unanchored tank; tests/cli/base.rs"),
        Code::Replaced => Sources("needs a results folder; tests/cli/overwrite.rs"),
        Code::StudyRemark => Sources("needs a merged study"),
    }
}

#[test]
fn every_code_comes_up_where_it_says() {
    let mut missed = Vec::new();
    for code in Code::ALL {
        let home = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(home.path().join(name), text).unwrap();
        write("tank.json", TANK);
        write("good.csv", RECORD);
        std::fs::create_dir(home.path().join("broken")).unwrap();
        write("broken/results.json", "{}");
        let (args, file): (&[&str], String) = match trigger(code) {
            Trigger::Sources(why) => {
                println!("{code}: not run: {why}");
                continue;
            }
            Trigger::Tank(from, to) => {
                assert_eq!(TANK.matches(from).count(), 1, "{code}: `{from}` must stand once in the good file");
                write("tank.json", &TANK.replace(from, to));
                (&["check", "tank.json"], to.to_owned())
            }
            Trigger::File(args, text) => {
                write("r.csv", text);
                (args, text.to_owned())
            }
            Trigger::Run(args) => (args, String::new()),
        };
        let Output { stderr, status, .. } = tankcheck(home.path(), args);
        let message = String::from_utf8_lossy(&stderr);
        // An error stops the run, a warning does not.
        let stopped = status.code() == Some(2);
        if !message.contains(&format!("{}: ", code.head())) || stopped != (code.severity() == Severity::Error) {
            missed.push(format!("{code} {args:?} {file}\n{message}"));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn every_code_is_used_by_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = String::new();
    let mut open: Vec<PathBuf> = ["src", "crates"].map(|folder| root.join(folder)).into();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("catalogue.rs") {
                sources.push_str(&std::fs::read_to_string(path).unwrap());
            }
        }
    }
    for code in Code::ALL {
        let name = format!("Code::{}", code.name());
        let whole = |(at, _): (usize, &str)| !sources[at + name.len()..].starts_with(|c: char| c.is_alphanumeric());
        assert!(sources.match_indices(&name).any(whole), "{name}");
    }
}

#[test]
fn the_page_is_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let done = tankcheck(root, &["explain", "--format", "markdown"]);
    let page = String::from_utf8(done.stdout).unwrap();
    for code in Code::ALL {
        assert!(page.contains(&format!("### `{code}` ")), "{code}");
    }
    let kept = std::fs::read_to_string(root.join("docs/codes.md")).unwrap();
    assert!(kept == page, "write it with `tankcheck explain --format markdown > docs/codes.md`");
}

#[test]
fn explain_finds_lists_and_suggests() {
    let home = tempfile::tempdir().unwrap();
    let text = |args: &[&str]| String::from_utf8(tankcheck(home.path(), args).stdout).unwrap();
    assert!(text(&["explain", "t0206"]).starts_with("error[T0206]: an unknown key\n"));
    assert!(text(&["explain", "overturning_moment"]).contains("N*m"));
    assert!(text(&["explain", "freeboard"]).contains("EN 1998-4:2006 A.2.1.4 (ec8-2006)"));
    let list = text(&["explain"]);
    for id in ["T0101", "T0901", "base_shear", "buckling_elastic", "api650-2020"] {
        assert!(list.contains(&format!("  {id} ")), "{id}");
    }
    let one: serde_json::Value = serde_json::from_str(&text(&["explain", "T0901", "--format", "json"])).unwrap();
    assert_eq!((one["kind"].as_str(), one["id"].as_str()), (Some("warning"), Some("T0901")));
    let all: serde_json::Value = serde_json::from_str(&text(&["explain", "--format", "json"])).unwrap();
    assert!(all.as_array().is_some_and(|all| all.len() > Code::ALL.len()));
    let done = tankcheck(home.path(), &["explain", "bukling_elastic"]);
    let message = String::from_utf8(done.stderr).unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(message.starts_with("error[T0105]: ID: found `bukling_elastic`"), "{message}");
    assert!(message.contains("did you mean `buckling_elastic`"), "{message}");
}

/// Warnings have their code in every form of the output.
#[test]
fn warnings_carry_their_code_in_json_and_test_reports() {
    let home = tempfile::tempdir().unwrap();
    let tank = TANK.replace("\"7850 kg/m3\"", "\"78.5 kg/m3\"");
    std::fs::write(home.path().join("tank.json"), tank).unwrap();
    let text = |form: &str, more: &[&str]| {
        let args = [&["check", "tank.json", "--format", form], more].concat();
        String::from_utf8(tankcheck(home.path(), &args).stdout).unwrap()
    };
    let json: serde_json::Value = serde_json::from_str(&text("json", &["--select", "warnings"])).unwrap();
    assert!(json["warnings"][0].as_str().is_some_and(|w| w.starts_with("T0901: ")), "{json}");
    let sarif: serde_json::Value = serde_json::from_str(&text("sarif", &[])).unwrap();
    let run = &sarif["runs"][0];
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    let rule = rules.iter().find(|rule| rule["id"] == "T0901").unwrap();
    assert_eq!(rule["shortDescription"]["text"], Code::UnusualTank.title());
    assert!(run["results"].as_array().unwrap().iter().any(|r| r["ruleId"] == "T0901" && r["level"] == "note"));
    assert!(text("junit", &[]).contains("classname=\"warnings\" name=\"T0901\""));
    assert!(text("github", &[]).contains("::notice file=tank.json,title=warnings T0901::"));
}
