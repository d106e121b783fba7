//! Source:    theory of plasticity (Simo & Taylor 1986; Drucker & Prager 1952; Karsan & Jirsa 1969)
//! Goal:      rows M1 to M9
//! Model:     one material point
//! Tolerance: at each row

use crate::assert_rows;

#[test]
fn steel() {
    assert_rows(&verification::materials::steel().unwrap());
}

#[test]
fn concrete_in_compression() {
    assert_rows(&verification::materials::drucker_prager().unwrap());
    assert_rows(&verification::materials::plastic_fracturing().unwrap());
}

#[test]
fn concrete() {
    assert_rows(&verification::materials::concrete().unwrap());
}
