//! Potential liquid on hexahedra: see `fem::verify::potential`.

use fem::verify::potential;

#[test]
fn rows_hold() {
    super::assert_rows(&potential::potential().expect("the models have answers"));
}

#[test]
#[ignore = "slow: four tanks on two meshes each"]
fn slow_rows_hold() {
    super::assert_rows(&potential::potential_slow().expect("the models have answers"));
}
