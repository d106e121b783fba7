//! Source:    theory of plasticity (Simo & Taylor 1986; Drucker & Prager 1952; Karsan & Jirsa 1969)
//! Goal:      rows M1 to M9
//! Model:     one material point
//! Tolerance: at each row

use crate::assert_rows;

#[test]
fn steel() {
    assert_rows(&fem::verify::materials::steel().unwrap());
}
