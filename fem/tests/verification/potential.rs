//! Potential liquid on hexahedra: see `fem::verify::potential`.

use fem::verify::potential;

#[test]
fn rows_hold() {
    super::assert_rows(&potential::potential().expect("the models have answers"));
}
