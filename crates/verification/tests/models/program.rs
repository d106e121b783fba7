//! The program: choosing benchmarks by name, listing them, forms of output.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

fn verify(arguments: &[&str]) -> Output {
    program().args(arguments).output().expect("the program runs")
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_verification"))
}

/// The committed manual.
fn manual() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification")
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).expect("UTF-8")
}

fn json(arguments: &[&str]) -> Value {
    let output = verify(&[arguments, &["--format", "json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(stdout(&output)).expect("JSON")
}

fn texts<'v>(list: &'v Value, key: &str) -> Vec<&'v str> {
    let all = list.as_array().expect("a list").iter();
    all.map(|entry| entry[key].as_str().expect("text")).collect()
}

#[test]
fn a_page_and_an_id_select_their_rows() {
    let page = json(&["shell-patch"]);
    assert!(texts(&page["rows"], "page").iter().all(|page| *page == "shell-patch"));
    assert_eq!(page["rows"].as_array().map(Vec::len), Some(6));
    // The page has D4, too.
    let id = json(&["d5"]);
    assert_eq!(texts(&id["rows"], "id"), ["D5"]);
}

#[test]
fn globs_and_parts_of_names() {
    let glob = json(&["--list", "M1?"]);
    assert_eq!(
        texts(&glob["benchmarks"], "page"),
        [
            "materials-concrete",
            "materials-bond",
            "materials-solid-concrete",
            "shell-concrete-beams",
            "shell-concrete-patch"
        ]
    );
    let part = json(&["--list", "elephant"]);
    assert_eq!(texts(&part["benchmarks"], "page"), ["shell-elephant-foot"]);
    // An id is meant as a whole: F10 to F17 are other ids.
    let whole = json(&["--list", "F1"]);
    assert_eq!(texts(&whole["benchmarks"], "page"), ["rigid-tank-sloshing", "potential-liquid"]);
}

#[test]
fn the_list_names_page_ids_and_paces_in_every_form() {
    let all = json(&["--list"]);
    for page in texts(&all["benchmarks"], "page") {
        assert!(manual().join(format!("{page}.md")).exists(), "{page} is without a page");
    }
    let human = verify(&["--list", "S22"]);
    let human = stdout(&human);
    assert!(human.contains("shell-elephant-foot (tested slow): "), "{human}");
    assert!(human.contains("S22") && human.contains("1 benchmarks, 1 ids"), "{human}");
    let csv = verify(&["--list", "S22", "--format", "csv"]);
    let csv = stdout(&csv);
    assert!(csv.starts_with("id,page,pace,what\nS22,shell-elephant-foot,tested slow,"), "{csv}");
    assert_eq!(csv.lines().count(), 2);
    let html = verify(&["--list", "--format", "html"]);
    assert_eq!(html.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&html.stderr).contains("expected human, json or csv"));
}

#[test]
fn what_needs_an_option_is_named() {
    let found = json(&["C8"]);
    assert_eq!(found["rows"].as_array().map(Vec::len), Some(0));
    assert_eq!(texts(&found["not_run"], "id"), ["liquid-separation"]);
    let output = verify(&["shell-elephant-foot"]);
    let text = stdout(&output);
    assert!(text.contains("not run without --slow: shell-elephant-foot"), "{text}");
}

#[test]
fn a_pattern_without_match_is_an_error_with_suggestions() {
    for (pattern, near) in [("elefant", "`shell-elephant-foot`"), ("S77", "`S7`"), ("shel-cook", "`shell-cook`")] {
        let output = verify(&[pattern]);
        assert_eq!(output.status.code(), Some(2));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains(&format!("error[T0105]: PATTERN: found `{pattern}`")), "{message}");
        assert!(message.contains("did you mean") && message.contains(near), "{message}");
        assert!(message.contains("list them with --list"), "{message}");
    }
    let far = verify(&["no-benchmark-is-called-so"]);
    let message = String::from_utf8_lossy(&far.stderr);
    assert!(!message.contains("did you mean") && message.contains("--list"), "{message}");
}

#[test]
fn one_page_is_written_beside_the_kept_ones() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let manual = home.path().join("manual");
    let manual = manual.to_str().expect("text");
    for page in ["shell-patch", "fluid-rank"] {
        assert_eq!(verify(&[page, "--write", manual]).status.code(), Some(0));
    }
    for file in ["shell-patch.md", "fluid-rank.md", "README.md", "rows.json"] {
        assert!(Path::new(manual).join(file).exists(), "{file}");
    }
}

#[test]
fn records_that_cannot_be_read_are_bad_input() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let file = home.path().join("imperial-valley-1940-el-centro-ns.csv");
    let folder = home.path().to_str().expect("text");
    for (text, code) in [(None, "T0601"), (Some("time_s,velocity_m_s\n0,0\n0.02,1\n"), "T0404")] {
        text.into_iter().for_each(|text| std::fs::write(&file, text).expect("writable"));
        let output = verify(&["C8", "--records", folder]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(&format!("error[{code}]")) && message.contains("el-centro"), "{message}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_one_message() {
    let device = std::fs::OpenOptions::new().write(true).open("/dev/full");
    let output = program().arg("--list").stdout(Stdio::from(device.expect("Linux has one"))).output();
    let output = output.expect("the program runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{message}");
    assert!(message.starts_with("error[T0604]: cannot write to standard output"), "{message}");
}

/// Ctrl-C while benchmarks run: the manual is that of before.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_the_old_manual() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let mut before = Vec::new();
    for entry in std::fs::read_dir(manual()).expect("the manual").flatten() {
        let bytes = std::fs::read(entry.path()).expect("readable");
        std::fs::write(home.path().join(entry.file_name()), &bytes).expect("writable");
        before.push((entry.file_name(), bytes));
    }
    let mut run = program();
    run.args(["--write", home.path().to_str().expect("text")]);
    let child = run.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program runs");
    // It listens once it has a second thread, the one that waits for signals; its benchmarks take much longer.
    let pid = child.id().to_string();
    let tasks = || std::fs::read_dir(format!("/proc/{pid}/task")).map_or(2, Iterator::count);
    while tasks() < 2 {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    std::thread::sleep(std::time::Duration::from_millis(300));
    let sent = Command::new("kill").args(["-s", "INT", &pid]).status().expect("kill runs");
    let output = child.wait_with_output().expect("it ends");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(sent.success());
    assert_eq!(output.status.code(), Some(130), "{message}");
    assert_eq!(std::fs::read_dir(home.path()).expect("readable").count(), before.len());
    for (name, bytes) in before {
        assert_eq!(std::fs::read(home.path().join(&name)).expect("readable"), bytes, "{name:?}");
    }
}
