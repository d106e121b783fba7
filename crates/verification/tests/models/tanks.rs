//! Cases of the verification tests; those of the dissertation are shared with the verification manual.

use engines::Simulation;

pub(crate) use tank::reference::{GRAVITY, broad, case, material, slender};

/// |value/reference − 1| ≤ tolerance, with a message that shows both.
pub(crate) fn assert_close(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = value / reference - 1.0;
    assert!(
        error.abs() <= tolerance,
        "{what}: found {value}, expected {reference}, error {:+.3} %, allowed {:.3} %",
        100.0 * error,
        100.0 * tolerance
    );
}

/// The history of this id.
pub(crate) fn column<'a>(simulation: &'a Simulation, id: &str) -> &'a [f64] {
    let series = &simulation.series;
    let i = series.ids.iter().position(|c| c == id).unwrap_or_else(|| panic!("no column {id}"));
    &series.columns[i]
}
