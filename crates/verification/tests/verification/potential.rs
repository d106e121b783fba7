//! Potential liquid on hexahedra: see `verification::potential`. Its finer meshes run with `tankcheck verify --slow`.

use verification::potential;

#[test]
fn rows_hold() {
    super::assert_rows(&potential::potential().expect("the models have answers"));
}
