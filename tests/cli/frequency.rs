//! `analysis.frequency` through the command line.

use crate::compare::{stderr, tankcheck};

/// The table beside the results is listed in the manifest, has a line a frequency and the promised heads, and the report draws it.
#[test]
fn transfer_functions_stand_in_results_table_and_report() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let text = std::fs::read_to_string("examples/01_broad_tank/tank.json").expect("an example");
    let mut tank: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    tank["analysis"] = serde_json::json!({ "frequency": { "points": 50 } });
    let (file, out) = (home.path().join("tank.json"), home.path().join("out"));
    std::fs::write(&file, tank.to_string()).expect("writable");
    let text = |path: &std::path::Path| path.to_str().expect("a temporary path is text").to_owned();
    let quake = "examples/records/elcentro.csv";
    let run = tankcheck(&["compare", &text(&file), "--quake", quake, "--out", &text(&out)]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect(name);
    assert!(read("manifest.json").contains("transfer.csv"));
    let table = read("transfer.csv");
    let head = "frequency_hz,wave_height_magnitude_m_per_m_s2,wave_height_phase_rad,base_shear_magnitude_n_per_m_s2,base_shear_phase_rad,\
                overturning_moment_magnitude_nm_per_m_s2,overturning_moment_phase_rad";
    assert_eq!(table.lines().next(), Some(head));
    let results: serde_json::Value = serde_json::from_str(&read("results.json")).expect("JSON");
    let parts = results["runs"][0]["parts"].as_array().expect("parts");
    let part = parts.iter().find(|part| part["id"] == "transfer").expect("the part");
    let blocks = part["blocks"].as_array().expect("blocks");
    let transfer = blocks.iter().find(|block| block["id"] == "transfer").expect("a series");
    let frequencies = transfer["rows"].as_array().expect("frequencies").len();
    assert_eq!(table.lines().count(), frequencies + 1);
    assert!(frequencies > 50, "peaks are added");
    assert!(out.join("figures/transfer_base_shear.svg").is_file());
    assert!(read("report.html").contains("Harmonic base motion"));
}

/// A record of harmonic motion is written once, reads as it was asked for, and is not replaced.
#[test]
fn harmonic_motion_is_a_record() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let file = home.path().join("harmonic.csv");
    let name = file.to_str().expect("a temporary path is text");
    let write = || {
        let motion = ["--amplitude", "0.1g", "--frequency", "0.5", "--duration", "60", "--ramp", "4"];
        tankcheck(&[&["quake", "harmonic"], &motion[..], &["-o", name]].concat())
    };
    let run = write();
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let info = tankcheck(&["quake", "info", name, "--format", "json"]);
    let facts: serde_json::Value = serde_json::from_slice(&info.stdout).expect("JSON");
    // The crest lies on a sample; numbers of the table have ten digits.
    let peak = facts["pga_g"].as_f64().expect("a number");
    assert!((peak - 0.1).abs() < 1e-9, "{peak}");
    assert_eq!(facts["samples"], 6001);
    assert_eq!(write().status.code(), Some(2), "an existing file is kept");
}
