//! Solid, joint and layered wall: see `verification::solid`.

use verification::solid;

#[test]
fn rows_hold() {
    super::assert_rows(&solid::solid().expect("the models have answers"));
}
