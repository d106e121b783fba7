//! Options of the three-dimensional engine on the command line, and Ctrl-C.

use crate::compare::{stderr, tankcheck};
use results::VerdictStatus;

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

#[test]
fn a_bad_mesh_is_refused_with_one_clear_message() {
    for mesh in ["0x16x20", "12x-16x20", "12x16", "abc", "12x16x20x1", "1e3x1x1", ""] {
        for command in [
            vec!["compare", TANK, "--quake", QUAKE, "--fe", "solid", "--mesh", mesh],
            vec!["modes", TANK, "--fe", "solid", "--mesh", mesh],
        ] {
            let run = tankcheck(&command);
            let text = stderr(&run);
            assert_eq!(run.status.code(), Some(2), "{mesh}: {text}");
            assert!(text.contains("12x16x20"), "{mesh}: {text}");
            assert_eq!(text.matches("error").count(), 1, "{mesh}: {text}");
            assert!(!std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("out").exists());
        }
    }
}

/// A mesh of 10⁹ cells is rejected before it is built, not after it has filled the memory.
#[test]
fn a_mesh_beyond_the_memory_is_refused_at_once() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let mesh = "1000x1000x1000";
    let command = ["compare", TANK, "--quake", QUAKE, "--fe", "solid", "--mesh", mesh];
    crate::limits::refused(&command, home.path(), &["more than the allowed", "--memory-limit"]);
}

#[test]
fn options_of_the_other_engine_are_refused() {
    for option in [&["--mesh", "4x8x4"][..], &["--liquid", "displacement"]] {
        let mut command = vec!["compare", TANK, "--quake", QUAKE];
        command.extend(option);
        let run = tankcheck(&command);
        assert_eq!(run.status.code(), Some(2), "{option:?}");
        let text = stderr(&run);
        assert!(text.contains(option[0]) && text.contains("--fe solid"), "{text}");
    }
    // The nonlinear liquid is one of the default engine.
    for command in [
        &["compare", TANK, "--quake", QUAKE, "--fe", "solid", "--liquid", "nonlinear"][..],
        &["compare", TANK, "--quake", QUAKE, "--fe", "none", "--liquid", "nonlinear"],
        &["compare", TANK, "--liquid", "nonlinear"],
        &["modes", TANK, "--liquid", "nonlinear"],
    ] {
        let run = tankcheck(command);
        assert_eq!(run.status.code(), Some(2), "{command:?}");
        assert!(stderr(&run).contains("--liquid nonlinear"), "{}", stderr(&run));
    }
    let run = tankcheck(&["modes", TANK, "--mesh", "4x8x4"]);
    assert_eq!(run.status.code(), Some(2));
    let run = tankcheck(&["compare", TANK, "--quake", QUAKE, "--fe", "solid", "--memory-limit", "0"]);
    assert_eq!(run.status.code(), Some(2), "{}", stderr(&run));
}

#[test]
fn a_foreign_folder_is_no_place_for_paraview_files() {
    let home = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(home.path().join("tank.pvd"), "x").expect("writable");
    let (out, vtu) = (home.path().join("out"), home.path());
    let run = tankcheck(&[
        "compare",
        TANK,
        "--quake",
        QUAKE,
        "--fe",
        "solid",
        "--mesh",
        "2x8x2",
        "--out",
        out.to_str().expect("text"),
        "--vtu",
        vtu.to_str().expect("text"),
    ]);
    assert!(matches!(run.status.code(), Some(2)), "{}", stderr(&run));
    assert!(!out.exists(), "no partial files");
}

/// ParaView files inside the output folder are not in the way of the next run.
#[test]
fn paraview_files_inside_the_output_folder_work_twice() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (quake, out) = (home.path().join("short.csv"), home.path().join("out"));
    let lines: String =
        (0..40).map(|i| format!("{:.2},{:.5}\n", 0.02 * f64::from(i), (0.6 * f64::from(i)).sin())).collect();
    std::fs::write(&quake, format!("time_s,acceleration_m_s2\n{lines}")).expect("writable");
    let vtu = out.join("paraview");
    let [quake, folder, vtu_folder] = [&quake, &out, &vtu].map(|p| p.to_str().expect("text"));
    for _ in 0..2 {
        let run = tankcheck(&[
            "compare",
            TANK,
            "--quake",
            quake,
            "--fe",
            "solid",
            "--mesh",
            "2x8x2",
            "--no-mesh-error",
            "--vtu",
            vtu_folder,
            "--out",
            folder,
        ]);
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
        assert!(vtu.join("tank.pvd").exists() && out.join("report.html").exists());
    }
}

/// Starts a run of both engines and waits for its first message.
#[cfg(unix)]
fn begin(out: &std::path::Path) -> (std::process::Child, impl std::io::BufRead) {
    use std::io::{BufRead, BufReader};

    let mut run = std::process::Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["compare", TANK, "--quake", QUAKE, "--fe", "both", "--mesh", "10x24x16", "--out"])
        .arg(out)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("tankcheck runs");
    let mut messages = BufReader::new(run.stderr.take().expect("standard error is a pipe"));
    let mut announced = String::new();
    while !announced.contains("unknowns") {
        assert!(messages.read_line(&mut announced).expect("text") > 0, "{announced}");
    }
    for word in ["10x24x16 elements", "MiB", "about"] {
        assert!(announced.contains(word), "{announced}");
    }
    (run, messages)
}

/// Ctrl-C.
#[cfg(unix)]
fn interrupt(run: &std::process::Child) {
    let sent = std::process::Command::new("kill").args(["-INT", &run.id().to_string()]).status().expect("kill exists");
    assert!(sent.success());
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_done_and_marks_it_incomplete() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let (mut run, _messages) = begin(&out);
    interrupt(&run);
    assert_eq!(run.wait().expect("ends").code(), Some(3));
    let report = std::fs::read_to_string(out.join("report.html")).expect("the harmonic engine was done");
    assert!(report.contains("Incomplete"));
    let results = results::read(&out).expect("results");
    assert!(results.verdict.unfinished && results.verdict.status != VerdictStatus::Holds && !results.runs.is_empty());
}

#[cfg(unix)]
#[test]
fn a_second_ctrl_c_leaves_nothing() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let (mut run, mut messages) = begin(&out);
    interrupt(&run);
    // Signals of one kind are not counted: the second is sent after the reply to the first.
    let mut reply = String::new();
    std::io::BufRead::read_line(&mut messages, &mut reply).expect("text");
    assert!(reply.contains("Ctrl-C again"), "{reply}");
    interrupt(&run);
    // On a busy machine the second may come after the results are in place: then they stay, with the exit code of a finished run.
    let code = run.wait().expect("ends").code();
    let left = std::fs::read_dir(home.path()).expect("readable").flatten();
    let left: Vec<_> = left.map(|entry| entry.file_name()).collect();
    match code {
        Some(130) => assert!(left.is_empty(), "{left:?}"),
        Some(3) => {
            assert_eq!(left, ["out"]);
            assert!(results::read(&out).expect("results").verdict.unfinished);
        }
        other => panic!("ended with {other:?}, left {left:?}"),
    }
}
