//! `site.spectrum`: tables in the file and beside it, parameters, and the zone factor alone.

use tank::STANDARD_GRAVITY;
use tank::hazard::{SpectrumForm, SpectrumParameters};

use super::{read, refused, small};
use crate::input::read_tank;

fn site(site: &str) -> String {
    small(&format!(", \"site\": {{ {site} }}"))
}

#[test]
fn a_table_in_the_file() {
    let file = read(&site(
        r#""spectrum": { "table": [[0, 0.1], [0.5, 0.2]], "vertical": [[0, 0.05], [0.5, 0.1]], "unit": "g", "damping": 0.02 },
           "ec8": {}"#,
    ));
    let spectrum = file.case.site.spectrum.expect("a spectrum");
    let SpectrumForm::Table { damping, horizontal, vertical } = spectrum.form else { panic!("a table") };
    assert_eq!((damping, spectrum.vertical_ratio), (0.02, 0.9));
    assert_eq!(horizontal.rows()[1], [0.5, 0.2 * STANDARD_GRAVITY]);
    assert_eq!(vertical.expect("vertical rows").peak(), 0.05 * STANDARD_GRAVITY);
    assert!(file.case.site.ec8.is_some_and(|ec8| ec8.importance == 1.0));
    let echoed = file.echo.iter().find(|e| e.path == "site.spectrum.table").expect("an echo");
    assert!(echoed.text.contains("2 rows up to 0.5 s"), "{}", echoed.text);
    assert!(file.echo.iter().all(|e| e.path != "site.spectrum"), "not absent");
}

#[test]
fn parameters() {
    let text =
        r#""spectrum": { "ag": "0.2 g", "soil_factor": 1.4, "tb": 0.1, "tc": "0.4 s", "td": 3.0, "te": 5, "tf": 10 }"#;
    let file = read(&site(text));
    let spectrum = file.case.site.spectrum.expect("a spectrum");
    let expected = SpectrumParameters {
        ag: 0.2 * STANDARD_GRAVITY,
        soil: 1.4,
        corners: [0.1, 0.4, 3.0],
        long_corners: Some([5.0, 10.0]),
    };
    assert_eq!(spectrum.form, SpectrumForm::Parameters(expected));
    for (from, to, part) in [
        ("\"te\": 5, ", "", "one control period without the other"),
        ("\"te\": 5", "\"te\": 2", "control periods out of order"),
        ("\"td\": 3.0, ", "", "no td"),
        ("\"tb\": 0.1", "\"tb\": 0.1, \"damping\": 0.02", "exclude each other"),
        ("\"tb\": 0.1", "\"tb\": 0.1, \"unit\": \"g\"", "belongs to a table"),
        ("0.2 g", "0.2 m", "a length"),
    ] {
        let found = refused(&site(&text.replace(from, to)));
        assert!(found.contains(part), "{part}: {found}");
    }
}

/// The zone method needs the zone factor alone; a key of annex E asks for the others of annex E.
#[test]
fn zone_alone() {
    let file = read(&site(r#""api650": { "zone_factor": 0.3, "soil_factor": 1.2 }"#));
    assert!(file.case.site.api650.is_none());
    let zone = file.case.site.zone().expect("a zone");
    assert_eq!((zone.zone_factor, zone.soil_factor, zone.importance), (0.3, 1.2, 1.0));
    for text in [r#""zone_factor": 0.3, "ss": 1.0"#, r#""friction": 0.3"#, ""] {
        let found = refused(&site(&format!("\"api650\": {{ {text} }}")));
        assert!(found.contains("the key `sug` is missing"), "{found}");
    }
    let own = r#""spectrum": { "table": [[0, 0.1], [9, 0.2]], "unit": "g" }, "api650": { "sug": 1 }"#;
    let file = read(&site(own));
    assert!(file.case.site.api650.is_some_and(|site| site.ss == 0.0 && site.s1 == 0.0));
    let found = refused(&site(&own.replace("\"sug\": 1", "\"sug\": 1, \"ss\": 1")));
    assert!(found.contains("the key `s1` is missing for the lower limit"), "{found}");
}

#[test]
fn a_file_beside_the_tank_file() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    std::fs::write(&path, site(r#""spectrum": { "file": "spectrum.csv" }"#)).expect("writable");
    let with = |csv: &str| {
        std::fs::write(home.path().join("spectrum.csv"), csv).expect("writable");
        read_tank(&path)
    };
    let file = with("period_s,acceleration_m_s2,vertical_g\n0,1,0.05\n0.5, 2 ,0.1\n").expect("a good table");
    let SpectrumForm::Table { horizontal, vertical, .. } = file.case.site.spectrum.expect("a spectrum").form else {
        panic!("a table")
    };
    assert_eq!(horizontal.rows(), [[0.0, 1.0], [0.5, 2.0]]);
    assert_eq!(vertical.expect("a column").rows()[1], [0.5, 0.1 * STANDARD_GRAVITY]);
    for (csv, parts) in [
        ("", ["empty file", "site.spectrum.file"]),
        ("period_s,acceleration_g\n0,1\n", ["found 1 rows", "site.spectrum.file"]),
        ("period_s,acceleration_g\n0,1\n0.5,nan\n", ["spectrum.csv:3", "not finite"]),
        ("period_s,acceleration_g\n0,1\n0.5,-2\n", ["spectrum.csv:3", "not positive"]),
        ("period_s,acceleration_g\n0,1\n0.5,2\n0.4,2\n", ["spectrum.csv:4", "not larger"]),
        ("period_s,acceleration_g\n0,1\n0.5,x\n", ["spectrum.csv:3", "`x` is not a number"]),
        ("period_s,acceleration_g\n0,1\n0.5\n", ["spectrum.csv:3", "another number of cells"]),
        ("period_s,pressure_kpa\n0,1\n0.5,2\n", ["spectrum.csv:1", "unexpected column `pressure_kpa`"]),
        ("period_s\n0\n0.5\n", ["spectrum.csv:1", "fewer than two columns"]),
        ("period_s,acceleration_g\n0,\"1\n", ["quote is not closed", "site.spectrum.file"]),
    ] {
        let message = with(csv).expect_err("a fault").to_string();
        for part in parts {
            assert!(message.contains(part), "`{part}` is missing in {message}");
        }
    }
}
