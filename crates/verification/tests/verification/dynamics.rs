//! Source:    theory of dynamics (Chung & Hulbert 1993; Nigam & Jennings 1969; Der Kiureghian 1981); strip 8.4
//! Goal:      rows D1 to D11; four methods on one model; nonlinear histories
//! Model:     amplification matrices, and strip 8.4 with the liquid condensed in closed form
//! Tolerance: at each row

use crate::assert_rows;

#[test]
fn schemes_and_coefficients() {
    assert_rows(&verification::dynamics::schemes().unwrap());
}

#[test]
fn strip_of_chapter_8_4() {
    assert_rows(&verification::dynamics::strip().unwrap());
}

#[test]
fn nonlinear_histories() {
    assert_rows(&verification::dynamics::nonlinear().unwrap());
}
