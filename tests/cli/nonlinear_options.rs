//! Options of the nonlinear engine: values as read, and messages for faults; arguments of `ida`.

use std::process::Command;

use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use super::bad_tank::{has, message};
use super::nonlinear_input::{GOOD, changed, read, spoiled};

#[test]
fn options() {
    has(
        &spoiled("\"circumference\": 192", "\"circumference\": 193"),
        &[
            "analysis.nonlinear.elements.circumference",
            "an even number of elements around",
            "found 193",
            "an even number",
            "write 194, or add \"symmetry\": false",
        ],
    );
    read(
        &changed("\"circumference\": 192", "\"circumference\": 193")
            .replace("\"contact\"", "\"symmetry\": false, \"contact\""),
    );
    has(&spoiled(", \"circumference\": 192", ""), &["the key `circumference` is missing"]);
    has(&spoiled("\"height\": 24", "\"height\": 0"), &["elements.height", "from 1 to 1000"]);
    let contact = "\"contact\": \"opening\"";
    let with = |more: &str| spoiled(contact, &format!("{contact}, {more}"));
    has(&with("\"spectral_radius\": 1.2"), &["analysis.nonlinear.spectral_radius", "at least 0, at most 1"]);
    has(&with("\"time_step\": \"0 s\""), &["analysis.nonlinear.time_step", "found \"0 s\""]);
    has(
        &with("\"damping\": { \"by_group\": {}, \"mass_proportional\": { \"ratio\": 0.02 } }"),
        &["one of by_group, rayleigh and mass_proportional"],
    );
    has(
        &with(
            "\"damping\": { \"rayleigh\": { \"first\": { \"at\": \"3 rad/s\", \"ratio\": 0.01 }, \"second\": { \"at\": \"4 rad/s\", \"ratio\": 0.02 } } }",
        ),
        &["require a negative coefficient"],
    );
    has(&with("\"integration\": { \"steel\": \"gaus 5\" }"), &["integration.steel", "\"gauss 5\"", "found \"gaus 5\""]);
    has(&with("\"integration\": { \"concrete\": \"simpson 8\" }"), &["integration.concrete", "odd number"]);
    has(&with("\"integration\": { \"concrete\": \"midpoint 2000\" }"), &["too few or too many points"]);
    has(&spoiled("\"opening\"", "\"open\""), &["analysis.nonlinear.contact", "\"bonded\" or \"opening\""]);
    has(&with("\"liquid\": \"displacement\""), &["analysis.nonlinear.liquid", "liquid applies to a strip alone"]);
    for key in ["\"contact_tangential\": \"1 MN/m3\"", "\"liquid_elements\": 10"] {
        has(&with(key), &["applies to a displacement liquid alone", "\"liquid\": \"displacement\" beside it"]);
    }
    has(&with("\"step\": \"coarse\""), &["analysis.nonlinear.step", "\"fixed\" or \"adaptive\""]);
    has(
        &with("\"step\": \"adaptive\""),
        &["analysis.nonlinear.step", "adaptive steps are for cylinders with bonded liquid"],
    );
    read(&changed(contact, "\"step\": \"adaptive\""));
    // A strip has neither circumference nor plane of symmetry.
    let strip = GOOD
        .replace("\"shape\": \"cylinder\"", "\"shape\": \"rectangle\"")
        .replace("\"radius\": \"10 m\"", "\"length\": \"20 m\", \"strip\": true")
        .replace(contact, "\"symmetry\": true");
    let source = Source::new("tank.json", strip);
    let text = parse(&source).expect_err("faults").render(&source, false);
    has(&text, &["circumference does not apply to a strip", "symmetry does not apply to a strip"]);
}

/// Through the program: exit code 2, everything at once, nothing written.
#[test]
fn all_faults_at_once() {
    let text = GOOD
        .replace("\"2.9 MPa\"", "\"39 MPa\"")
        .replace("\"S355\"", "\"S356\"")
        .replace("\"4 cm\"", "\"40 cm\"")
        .replace("\"height\": 24", "\"height\": 0");
    has(
        &message(text),
        &["weaker in tension", "unknown grade", "outside their shell", "elements.height", "4 faults in tank.json"],
    );
    // Contact needs something to touch.
    let dry = GOOD.replace("  \"liquid\": { \"density\": \"1000 kg/m3\", \"fill_height\": \"5.5 m\" },\n", "");
    has(&message(dry), &["the key `liquid` is missing"]);
}

/// Runs the program; returns its exit code and standard error.
fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("tank.json"), GOOD).unwrap();
    std::fs::write(
        folder.path().join("record.csv"),
        "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0.5\n0.06,-1\n0.08,0\n",
    )
    .unwrap();
    let output =
        Command::new(env!("CARGO_BIN_EXE_tankcheck")).current_dir(folder.path()).args(arguments).output().unwrap();
    assert!(output.stdout.is_empty());
    assert!(!folder.path().join("out").exists());
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn ida_arguments() {
    let ida = |more: &[&str]| {
        let common = ["ida", "tank.json", "--quake", "record.csv", "--out", "out"];
        run(&[&common[..], more].concat())
    };
    for (arguments, parts) in [
        (&["--scale", "1.1..0", "--steps", "12"][..], &["--scale", "reversed", "write 0..1.1"][..]),
        (&["--scale", "0.5..0.5", "--steps", "3"], &["empty range"]),
        (&["--scale", "-0.1..1", "--steps", "3"], &["found `-0.1`", "from 0 to 100"]),
        (&["--scale", "0..NaN", "--steps", "3"], &["found `NaN`"]),
        (&["--scale", "0..1", "--steps", "1"], &["--steps", "from 2 to 1000"]),
        (&["--scale", "0..1", "--steps", "-3"], &["--steps: found `-3`"]),
        (&["--scale", "0..1"], &["--steps is missing"]),
        (&["--scale", "0..1", "--steps", "3", "--jobs", "0"], &["--jobs"]),
        (&[], &["--scale"]),
    ] {
        let (code, text) = ida(arguments);
        assert_eq!(code, Some(2), "{text}");
        has(&text, parts);
    }
    let (code, text) = run(&["ida", "none.json", "--quake", "record.csv", "--scale", "0.5"]);
    assert_eq!(code, Some(2));
    has(&text, &["none.json", "no such file"]);
}
