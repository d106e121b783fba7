//! Source:    `docs/verification/rows.json`, whose fast and tested rows `crates/verification/tests/benchmarks.rs` recomputes
//! Goal:      the pages of the committed manual are those of its rows
//! Model:     none
//! Expected:  every file, byte for byte
//! Tolerance: none

use std::path::Path;

use verification::manual;

#[test]
fn the_pages_are_those_of_the_rows() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification");
    let rows = manual::read(&folder).expect("docs/verification/rows.json");
    for (name, text) in manual::files(&rows).expect("the manual renders") {
        let committed = std::fs::read_to_string(folder.join(&name)).unwrap_or_default();
        assert!(
            committed == text,
            "{name} is out of date: cargo run --release -p verification -- shell-patch --write docs/verification"
        );
    }
}
