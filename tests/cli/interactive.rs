//! `report --interactive` writes one file with the result, which the folder then owns.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

const RECORD: &str = "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0.5\n0.06,-1\n0.08,0\n0.10,0.2\n0.12,0\n0.14,0.1\n0.16,0\n0.18,0.1\n0.2,0\n";

fn tankcheck(folder: &Path, args: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tankcheck"));
    let Output { status, stdout, stderr } = command.current_dir(folder).args(args).output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

/// The JSON of a block of the file.
fn block(html: &str, id: &str) -> Value {
    let (_, rest) = html.split_once(&format!(r#"<script type="application/json" id="{id}">"#)).expect(id);
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn one_file_holds_the_result() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    std::fs::write(home.path().join("r.csv"), RECORD).unwrap();
    let (_, tank, _) = tankcheck(home.path(), &["init"]);
    let (before, rest) = tank.split_once(r#""name": ""#).unwrap();
    let hostile = "</script><script>alert(1)</script>";
    let tank = format!(r#"{before}"name": "{hostile}{rest}"#);
    std::fs::write(home.path().join("tank.json"), tank).unwrap();
    let (code, _, message) =
        tankcheck(home.path(), &["compare", "tank.json", "--quake", "r.csv", "--no-mesh-error", "--out", "out"]);
    assert!(matches!(code, Some(0 | 1 | 4)), "{message}");
    let (code, said, message) = tankcheck(home.path(), &["report", "out", "--interactive", "--lang", "de"]);
    assert_eq!(code, Some(0), "{message}");
    assert!(said.contains("interactive.html") && message.contains("no scene to play"), "{said}{message}");

    let html = std::fs::read_to_string(out.join("interactive.html")).unwrap();
    let results: Value = serde_json::from_str(&std::fs::read_to_string(out.join("results.json")).unwrap()).unwrap();
    let held = block(&html, "results");
    assert!(held["name"].as_str().unwrap().starts_with(hostile));
    assert_eq!(held["comparison"], results["comparison"]);
    assert_eq!(block(&html, "series")["time"][1], 0.02);
    assert_eq!(block(&html, "settings")["language"], "de");
    assert!(!html.contains("<script>alert"));
    // Nothing is fetched: no address but those of namespaces, licences and blobs.
    assert!(!html.contains("src=\"http") && !html.contains("href=\"http"));

    let manifest = || std::fs::read_to_string(out.join("manifest.json")).unwrap();
    assert!(manifest().contains("interactive.html"));
    // Another report keeps it and says that it is older; a change by hand is not overwritten.
    let (code, _, message) = tankcheck(home.path(), &["report", "out"]);
    assert_eq!(code, Some(0));
    assert!(message.contains("still of the earlier report: interactive.html"), "{message}");
    std::fs::write(out.join("interactive.html"), "mine").unwrap();
    let (code, _, message) = tankcheck(home.path(), &["report", "out", "--interactive"]);
    assert_eq!(code, Some(2), "{message}");
    assert_eq!(std::fs::read_to_string(out.join("interactive.html")).unwrap(), "mine");
}

#[test]
fn the_scene_of_a_result_is_in_its_file_and_stays_in_the_folder() {
    let home = tempfile::tempdir().unwrap();
    std::fs::write(home.path().join("r.csv"), RECORD).unwrap();
    let (_, tank, _) = tankcheck(home.path(), &["init"]);
    std::fs::write(home.path().join("tank.json"), tank).unwrap();
    let compare = ["compare", "tank.json", "--quake", "r.csv", "--no-mesh-error", "--scene", "--out", "out"];
    let (code, _, message) = tankcheck(home.path(), &compare);
    assert!(matches!(code, Some(0 | 1 | 4)), "{message}");
    let (code, _, message) = tankcheck(home.path(), &["report", "out", "--format", "interactive"]);
    assert_eq!(code, Some(0), "{message}");
    let read = |name: &str| std::fs::read_to_string(home.path().join("out").join(name)).unwrap();
    let kept: Value = serde_json::from_str(&read("scene.json")).unwrap();
    assert_eq!(block(&read("interactive.html"), "scene"), kept);
    assert!(read("manifest.json").contains("scene.json"));
}
