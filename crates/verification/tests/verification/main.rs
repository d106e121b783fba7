//! Verification: every row of `verification` holds.
//!
//! One module a topic. The models are library functions, so that the verification manual shows the numbers tested here.

mod dynamics;
mod fluid;
mod materials;
mod potential;

use verification::Row;

/// Asserts that there are rows and that every one holds, and prints all that do not.
#[allow(dead_code, reason = "used by the modules of the topics")]
fn assert_rows(rows: &[Row]) {
    assert!(!rows.is_empty(), "no rows");
    let failed: Vec<String> = rows.iter().filter(|r| !r.holds()).map(Row::line).collect();
    assert!(
        failed.is_empty(),
        "{} of {} rows fail:\n{}",
        failed.len(),
        rows.len(),
        failed.join("\n")
    );
}

mod shell;
mod shell_element;
mod shell_parts;
mod solid;
mod strip;
