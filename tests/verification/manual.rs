//! Source:    see each row of the verification manual
//! Goal:      every row of `tankcheck verify` that needs no external record holds its tolerance
//! Model:     default mesh
//! Expected:  closed forms, published coefficients, independent assemblies: named in `src/verify`
//! Tolerance: per row, stated for the default mesh in the theory manual

use tankcheck::verify;

#[test]
fn every_row_holds() {
    let manual = verify::run(None).unwrap();
    let outside: Vec<String> = manual
        .rows
        .iter()
        .filter(|row| !row.measured.holds())
        .map(|row| format!("{:?}, error {:+.2e}", row.measured, row.measured.error()))
        .collect();
    assert!(outside.is_empty(), "{}", outside.join("\n"));
    for id in [
        "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F16", "F17",
    ] {
        assert!(manual.rows.iter().any(|row| row.measured.id == id), "{id} is missing");
    }
}
