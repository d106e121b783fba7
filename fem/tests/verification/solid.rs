//! Solid, joint and layered wall: see `fem::verify::solid`.

use fem::verify::solid;

#[test]
fn rows_hold() {
    super::assert_rows(&solid::solid().expect("the models have answers"));
}
