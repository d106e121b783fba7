//! Areas of bars that a force and a moment need, for walls whose bars are not given.
//!
//! ```text
//! tension inside the bars, |M| ≤ N z/2:      A = (N/2 ± M/z)/f_yd                    z = h − 2 d_1
//! otherwise:                                 A = (M_s/z_i + N)/f_yd                  M_s = |M| − N (h/2 − d_1)
//!                                            z_i = d (1 + √(1 − 2 μ))/2              μ = M_s/(d² f_cd)
//! ```
//!
//! with d_1 the distance of the bars from their face and d = h − d_1. Both forms meet at |M| = N z/2, where the outer bars are idle,
//! to the lever arm of the concrete. The ultimate limit state only; crack widths usually need more.

use super::section::Face;

/// Area of the bars near a face [m²/m]; none where the concrete crushes (μ > 0.5).
///
/// * `h`, `d_1`: thickness and distance of the bars from their face [m]; `f_cd`, `f_yd`: [Pa]; `n`, `m`: [N/m], [N·m/m]
pub fn area(h: f64, d_1: f64, (f_cd, f_yd): (f64, f64), (n, m): (f64, f64), face: Face) -> Option<f64> {
    let m = match face {
        Face::Inner => m,
        Face::Outer => -m,
    };
    let (z, d) = (h - 2.0 * d_1, h - d_1);
    if n > 0.0 && m.abs() <= 0.5 * n * z {
        return Some((0.5 * n + m / z) / f_yd);
    }
    if m <= 0.0 {
        return Some(0.0);
    }
    let about = m - n * (0.5 * h - d_1);
    let mu = about / (d * d * f_cd);
    if mu > 0.5 {
        return None;
    }
    let lever = 0.5 * d * (1.0 + (1.0 - 2.0 * mu).max(0.0).sqrt());
    Some(((about / lever + n) / f_yd).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::en1992::section::{Bars, Section};

    /// A wall with just these areas has a utilisation of 1: pure tension, small eccentricity, pure bending, bending with compression.
    /// The block may use a little of the compressed bars, so that the utilisation is at most 1, and above 0.9.
    #[test]
    fn the_areas_are_just_enough() {
        for (n, m) in [(0.4e6, 0.0), (0.4e6, 10e3), (0.4e6, -20e3), (0.0, 60e3), (-0.1e6, 60e3), (0.1e6, 40e3)] {
            let of = |face| area(0.25, 0.05, (20e6, 500e6 / 1.15), (n, m), face).unwrap();
            let bars = |depth, area| Bars { depth, area, diameter: None, yield_strength: 500e6, modulus: 200e9 };
            let section = Section {
                thickness: 0.25,
                strength: 30e6,
                modulus: 33e9,
                bars: vec![bars(0.05, of(Face::Inner)), bars(0.2, of(Face::Outer))],
                factors: (1.5, 1.15),
            };
            let found = section.utilisation(n, m);
            assert!((0.9..1.0 + 1e-6).contains(&found), "{n} {m}: {found}");
        }
        assert_eq!(area(0.25, 0.05, (20e6, 435e6), (0.0, 1e6), Face::Inner), None);
    }
}
