//! Potential liquid on hexahedra: see `fem::verify::potential`. Its finer meshes run with `tankcheck verify --slow`.

use fem::verify::potential;

#[test]
fn rows_hold() {
    super::assert_rows(&potential::potential().expect("the models have answers"));
}
