//! Options of the three-dimensional engine on the command line, and Ctrl-C.

use crate::compare::{stderr, tankcheck};

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

#[test]
fn options_of_the_other_engine_are_refused() {
    for option in [
        &["--mesh", "4x8x4"][..],
        &["--liquid", "displacement"],
        &["--memory-limit", "100"],
        &["--vtu", "no_such_folder"],
    ] {
        let mut command = vec!["compare", TANK, "--quake", QUAKE];
        command.extend(option);
        let run = tankcheck(&command);
        assert_eq!(run.status.code(), Some(2), "{option:?}");
        let text = stderr(&run);
        assert!(text.contains(option[0]) && text.contains("--fe solid"), "{text}");
    }
    let run = tankcheck(&["modes", TANK, "--mesh", "4x8x4"]);
    assert_eq!(run.status.code(), Some(2));
    let run = tankcheck(&[
        "compare",
        TANK,
        "--quake",
        QUAKE,
        "--fe",
        "solid",
        "--memory-limit",
        "0",
    ]);
    assert_eq!(run.status.code(), Some(2), "{}", stderr(&run));
}

#[test]
fn a_foreign_folder_is_no_place_for_paraview_files() {
    let home = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(home.path().join("thesis.doc"), "x").expect("writable");
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
    assert!(!out.exists(), "nothing is half-written");
}
