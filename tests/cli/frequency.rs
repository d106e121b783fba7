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
    let transfer = &results["runs"][0]["transfer"];
    let frequencies = transfer["frequency"].as_array().expect("frequencies").len();
    assert_eq!(table.lines().count(), frequencies + 1);
    assert!(frequencies > 50, "peaks are added");
    assert!(out.join("figures/transfer_base_shear.svg").is_file());
    assert!(read("report.html").contains("Harmonic base motion"));
}
