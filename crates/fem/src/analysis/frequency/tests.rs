//! Lengths of transforms; transfer functions against closed forms of one mass.

use std::sync::Arc;

use super::*;
use crate::linalg::{Pattern, Symmetric};

#[test]
fn lengths_are_smooth() {
    assert_eq!([1, 7, 31, 1001, 4097].map(smooth), [2, 8, 32, 1024, 4320]);
}

/// A mass m = 2 kg on a spring of ω = 5 rad/s that moves along x.
fn mass_on_spring(viscous: f64, hysteretic: f64) -> Reduced {
    let one = |value: f64| Symmetric {
        values: vec![value],
        pattern: Arc::new(Pattern::from_cliques(1, std::iter::once([0].as_slice()))),
    };
    let (m, w) = (2.0, 5.0);
    let system = System::from_matrices(one(m), one(m * w * w), [vec![1.0], vec![0.0], vec![0.0]]);
    let phi = 1.0 / m.sqrt();
    let mut vectors = Matrix::zeros(1, 1);
    vectors.add(0, 0, phi);
    let basis = ModalBasis::new(&system, &[w], &vectors, [None; 3]).unwrap();
    Reduced::modal(&basis, &[viscous], &[hysteretic]).unwrap()
}

fn rows() -> [Observable; 2] {
    [
        Observable { displacement: vec![(0, 1.0)], ..Observable::default() },
        Observable { acceleration: vec![(0, 1.0)], ..Observable::default() },
    ]
}

/// Relative displacement 1/ω² at rest, 1/(2 ξ ω²) a quarter of a period later at resonance; total acceleration 1 − i/(2 ξ) there,
/// with viscous and with hysteretic damping; elsewhere they differ by Ω/ω in the damping. Closed forms: rounding, 1e-12.
#[test]
fn a_mass_on_a_spring_is_a_closed_form() {
    let (w, ratio) = (5.0, 0.03);
    for (viscous, hysteretic) in [(ratio, 0.0), (0.0, ratio)] {
        let reduced = mass_on_spring(viscous, hysteretic);
        let found = reduced.transfer(&rows(), 0, &[0.0, w, 1.7 * w]).unwrap();
        let close = |found: Complex<f64>, expected: Complex<f64>| {
            assert!((found - expected).norm() < 1e-12 * expected.norm(), "{found} {expected}");
        };
        close(found[0][0], Complex::new(-1.0 / (w * w), 0.0));
        close(found[1][0], Complex::new(1.0, 0.0));
        close(found[0][1], Complex::new(0.0, 1.0 / (2.0 * ratio * w * w)));
        close(found[1][1], Complex::new(1.0, -1.0 / (2.0 * ratio)));
        let damping = 2.0 * ratio * if hysteretic > 0.0 { 1.0 } else { 1.7 };
        let dynamic = Complex::new(1.0 - 1.7 * 1.7, damping);
        close(found[0][2], -1.0 / (w * w) / dynamic);
        close(found[1][2], Complex::new(1.0, damping) / dynamic);
    }
}

/// Without damping there is no steady state at resonance.
#[test]
fn an_undamped_resonance_is_refused() {
    assert!(mass_on_spring(0.0, 0.0).transfer(&rows(), 0, &[5.0]).is_err());
    assert!(mass_on_spring(0.0, 0.0).transfer(&rows(), 0, &[4.9]).is_ok());
}
