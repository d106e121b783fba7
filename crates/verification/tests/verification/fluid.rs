//! The displacement liquid: see [`verification::fluid`].

use super::assert_rows;
use verification::fluid;

#[test]
fn table_5_3() {
    assert_rows(&fluid::rank_table().unwrap());
}

#[test]
fn patch_tests() {
    assert_rows(&fluid::patch_tests().unwrap());
}

#[test]
fn self_weight() {
    assert_rows(&fluid::self_weight().unwrap());
}

#[test]
fn rectangles() {
    assert_rows(&fluid::rectangles().unwrap());
}

#[test]
fn degenerate_discs() {
    assert_rows(&fluid::degenerate_discs().unwrap());
}

#[test]
fn code_aster_box() {
    assert_rows(&fluid::sloshing_box().unwrap());
}

#[test]
fn impulsive_mass() {
    assert_rows(&fluid::impulsive_mass().unwrap());
}

#[test]
fn cylinders() {
    assert_rows(&fluid::cylinders().unwrap());
}

#[test]
fn cylinders_of_chapter_8() {
    assert_rows(&fluid::chapter_8().unwrap());
}
