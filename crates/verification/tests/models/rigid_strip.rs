//! Source:    potential flow in a rigid rectangular tank (Lamb 1932, §190)
//! Goal:      the printed digits of the references of the rows F5; total mass of a translation
//! Model:     nine-node potential elements 5 × 8 on half the strip, antisymmetric (odd n) and symmetric (even n)
//! Expected:  ω² = (n π g/L₀) tanh(n π H/L₀), L₀ the full length
//! Tolerance: 0.05, 0.1, 0.3 % for n = 1, 2, 3, as for the cylinder

use engines::liquid::Domain;
use verification::tanks::rigid::RigidTank;

use crate::tanks::{GRAVITY, assert_close};

fn strip(length: f64, depth: f64, symmetric: bool) -> RigidTank {
    let domain = Domain::Strip { half_length: 0.5 * length, breadth: 1.5, symmetric };
    RigidTank::new(domain, depth, GRAVITY, 1.0).unwrap()
}

/// The closed form that the rows F5 are compared with gives the printed values of the sheet, half a last digit.
#[test]
fn references_have_the_printed_digits() {
    for (depth, printed) in [(2.57, [2.3863, 3.5056, 4.2999]), (5.0, [2.4781, 3.5111, 4.3002])] {
        for (n, printed) in printed.into_iter().enumerate() {
            let k = (n + 1) as f64 * std::f64::consts::PI / 5.0;
            let exact = (GRAVITY * k * (k * depth).tanh()).sqrt();
            assert!((exact - printed).abs() < 6e-5, "{exact} {printed}");
        }
    }
}

#[test]
fn f6_rigid_translation_carries_the_whole_liquid() {
    assert_close("mass", strip(5.0, 2.57, false).translated_mass(), 1000.0 * 5.0 * 1.5 * 2.57, 1e-9);
}
