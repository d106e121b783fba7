//! Standard output and standard error on a full device: a result that cannot be written gives exit code 3 with one message; a
//! message that cannot be written is ignored.

#![cfg(target_os = "linux")]

use std::fs::OpenOptions;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";
const STRIP: &str = "examples/06_sandwich_strip/tank.json";
const STEEL: &str = "examples/07_steel_cylinder/tank.json";

/// A device that is always full.
fn full() -> Stdio {
    let device = OpenOptions::new().write(true).open("/dev/full");
    device.expect("Linux has one").into()
}

fn run(arguments: &[&str], stdout: Stdio, stderr: Stdio) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(stdout)
        .stderr(stderr)
        .output()
        .expect("tankcheck runs")
}

/// The steel cylinder on a mesh of few elements.
fn coarse(home: &Path) -> String {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(STEEL);
    let text = std::fs::read_to_string(source).expect("an example");
    let (fine, few) = ("\"height\": 48, \"circumference\": 96", "\"height\": 8, \"circumference\": 8");
    assert!(text.contains(fine));
    let path = home.join("coarse.json");
    std::fs::write(&path, text.replace(fine, few)).expect("writable");
    path.to_str().expect("text").into()
}

/// Commands that print a result in a second or so, whatever their exit code is.
fn commands(home: &Path) -> Vec<Vec<String>> {
    let path = |name: &str| home.join(name).to_str().expect("text").to_owned();
    let short = home.join("short.csv");
    std::fs::write(&short, "time_s,acceleration_g\n0,0\n0.02,0.1\n0.04,-0.1\n0.06,0\n").expect("writable");
    let short = short.to_str().expect("text").to_owned();
    let steel = coarse(home);
    let words = |line: &str| -> Vec<String> {
        line.split_whitespace()
            .map(|word| match word {
                "TANK" => TANK.into(),
                "QUAKE" => QUAKE.into(),
                "STRIP" => STRIP.into(),
                "STEEL" => steel.clone(),
                "SHORT" => short.clone(),
                _ => match word.strip_prefix('@') {
                    Some(name) => path(name),
                    None => word.into(),
                },
            })
            .collect()
    };
    [
        "check TANK",
        "compare TANK --quake QUAKE --no-mesh-error --out @compare",
        "check TANK --format json --out @json",
        "check TANK --format csv --out @csv",
        "modes TANK",
        "spectrum QUAKE --points 20",
        "quake info QUAKE",
        "diff reports/01_broad_tank reports/01_broad_tank",
        "diff reports/01_broad_tank reports/01_broad_tank --format csv",
        "diff reports/01_broad_tank reports/01_broad_tank --format json",
        "ida STRIP --quake SHORT --scale 0.1 --out @ida",
        "push STEEL --out @push",
        "report @compare",
        "init",
        "schema",
        "completions bash",
        "completions --man",
        "--help",
        "--version",
        "help compare",
        "check --help",
    ]
    .into_iter()
    .map(words)
    .collect()
}

#[test]
fn a_full_device_is_one_message_and_never_a_panic() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for command in commands(home.path()) {
        let command: Vec<&str> = command.iter().map(String::as_str).collect();
        let out = run(&command, full(), Stdio::piped());
        let message = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(3), "{command:?}: {message}");
        assert_eq!(message.matches("error").count(), 1, "{command:?}: {message}");
        assert!(
            message.contains("error[T0604]: cannot write to standard output: no space left on the device"),
            "{command:?}: {message}"
        );

        // Nonlinear runs write their messages as the others do.
        if ["ida", "push"].contains(&command[0]) {
            continue;
        }
        let whole = run(&command, Stdio::piped(), Stdio::piped());
        assert!(matches!(whole.status.code(), Some(0 | 1 | 4)), "{command:?}: {whole:?}");
        assert!(!whole.stdout.is_empty(), "{command:?}");
        let err = run(&command, Stdio::piped(), full());
        assert_eq!(err.status.code(), whole.status.code(), "{command:?}");
        if !command.contains(&"--format") || !command.contains(&"json") {
            assert_eq!(err.stdout, whole.stdout, "{command:?}");
        }
    }
    // The writable part was written.
    for folder in ["compare", "json", "csv", "ida", "push"] {
        assert!(home.path().join(folder).join("report.html").is_file(), "{folder}");
    }
}

/// Bad usage and bad input keep their exit code where nobody reads the message.
#[test]
fn messages_that_cannot_be_written_change_no_exit_code() {
    for command in
        [&["check", "no_such_file.json"][..], &["chek"], &["compare", TANK, "--fe", "nonlinear"], &["--nonsense"]]
    {
        let run = run(command, Stdio::piped(), full());
        assert_eq!(run.status.code(), Some(2), "{command:?}");
    }
}

/// A reader that has seen enough.
#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_failure() {
    let mut run = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["schema"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tankcheck runs");
    drop(run.stdout.take());
    let output = run.wait_with_output().expect("ends");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
}
