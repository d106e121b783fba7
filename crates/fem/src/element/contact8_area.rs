//! Integration over the closed part of a face whose gap is bilinear.
//!
//! The gap g = Σ N_a g_a on the square [−1, 1]² vanishes on a hyperbola. A point rule on the whole square sees the closed
//! part g < 0 only through its points and misses small corners; so the square is cut.
//!
//! ```text
//! clipped   on a line s = const, g is linear in r: the closed part is known and two points integrate N_a N_b exactly.
//!           Along s the square is cut where g vanishes on the edges r = ±1; five points on each piece, where the zero
//!           r(s) is a smooth rational function
//! strips    zeros of g on two opposite edges cut three strips: closed, mixed, open; 2 × 2 points each, those with g > 0
//!           left out (Heinen; the dissertation's way, kept for parity)
//! ```
//!
//! The clip follows the hyperbola itself; a polygon through its ends and a fan of triangles does not, and needs to decide
//! at the saddle point whether two opposite closed corners hang together.

use crate::shape::{gauss, quad4};

/// How a partly closed face is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integration {
    /// The closed part itself.
    Clipped,
    /// Three strips.
    Strips,
}

/// A bilinear gap by its corner values (order of [`crate::shape::quad4`]).
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap(pub [f64; 4]);

impl Gap {
    /// g at (r, s).
    fn at(&self, r: f64, s: f64) -> f64 {
        quad4::value(r, s).iter().zip(&self.0).map(|(n, g)| n * g).sum()
    }

    /// Calls `point(r, s, weight)` for the points of the 2 × 2 rule.
    pub(crate) fn whole(mut point: impl FnMut(f64, f64, f64)) {
        for &(r, wr) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                point(r, s, wr * ws);
            }
        }
    }

    /// Calls `point(r, s, weight)` for the points of the closed part g < 0 of the square.
    pub(crate) fn closed(&self, integration: Integration, mut point: impl FnMut(f64, f64, f64)) {
        let closed = self.0.iter().filter(|&&g| g < 0.0).count();
        let touching = self.0.iter().filter(|&&g| g <= 0.0).count();
        if closed == 0 {
            return;
        }
        if touching == 4 {
            return Gap::whole(point);
        }
        match integration {
            Integration::Clipped => self.clipped(&mut point),
            Integration::Strips => self.strips(&mut point),
        }
    }

    fn clipped(&self, point: &mut impl FnMut(f64, f64, f64)) {
        let [a, b, c, d] = self.0;
        // Places along s where g changes sign on the edges r = −1 and r = 1.
        let mut cuts = [-1.0, crossing(a, d).unwrap_or(1.0), crossing(b, c).unwrap_or(1.0), 1.0];
        cuts.sort_by(f64::total_cmp);
        for ends in cuts.windows(2) {
            let (half, middle) = (0.5 * (ends[1] - ends[0]), 0.5 * (ends[1] + ends[0]));
            if half <= 0.0 {
                continue;
            }
            for &(y, wy) in gauss::FIVE {
                let s = middle + half * y;
                let (left, right) = (self.at(-1.0, s), self.at(1.0, s));
                let zero = crossing(left, right);
                let (from, to) = match (left < 0.0, zero) {
                    (true, zero) => (-1.0, zero.unwrap_or(1.0)),
                    (false, Some(zero)) => (zero, 1.0),
                    (false, None) => continue,
                };
                let (half_line, middle_line) = (0.5 * (to - from), 0.5 * (to + from));
                for &(x, wx) in gauss::TWO {
                    point(middle_line + half_line * x, s, wx * half_line * wy * half);
                }
            }
        }
    }

    fn strips(&self, point: &mut impl FnMut(f64, f64, f64)) {
        let [a, b, c, d] = self.0;
        // Along r if the edges s = ±1 are crossed, along s if the edges r = ±1 are.
        let end = |closed: bool| if closed { 1.0 } else { -1.0 };
        let (zeros, along_r) = match (crossing(a, b), crossing(d, c), crossing(a, d), crossing(b, c)) {
            (Some(lower), Some(upper), ..) => ([lower, upper], true),
            (.., Some(left), Some(right)) => ([left, right], false),
            // One corner: the second zero lies at the end of the edge that is not crossed.
            (Some(lower), None, ..) => ([lower, end((d < 0.0) == (a < 0.0))], true),
            (None, Some(upper), ..) => ([end((a < 0.0) == (d < 0.0)), upper], true),
            (None, None, ..) => return Gap::whole(point),
        };
        let (low, high) = (zeros[0].min(zeros[1]), zeros[0].max(zeros[1]));
        for (from, to) in [(-1.0, low), (low, high), (high, 1.0)] {
            let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
            if half <= 0.0 {
                continue;
            }
            Gap::whole(|x, y, w| {
                let x = middle + half * x;
                let (r, s) = if along_r { (x, y) } else { (y, x) };
                if self.at(r, s) < 0.0 {
                    point(r, s, w * half);
                }
            });
        }
    }
}

/// Place in (−1, 1) where a linear function with the end values `from`, `to` changes sign.
fn crossing(from: f64, to: f64) -> Option<f64> {
    ((from < 0.0) != (to < 0.0)).then(|| (from + to) / (from - to))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(gap: Gap, integration: Integration) -> f64 {
        let mut sum = 0.0;
        gap.closed(integration, |_, _, w| sum += w);
        sum
    }

    #[test]
    fn closed_areas_of_plain_cases() {
        for rule in [Integration::Clipped, Integration::Strips] {
            assert_eq!(area(Gap([1.0; 4]), rule), 0.0);
            assert!((area(Gap([-1.0; 4]), rule) - 4.0).abs() < 1e-15);
            // g = r: half of the square; g = s − ½: three quarters.
            assert!((area(Gap([-1.0, 1.0, 1.0, -1.0]), rule) - 2.0).abs() < 1e-14);
            assert!((area(Gap([-1.5, -1.5, 0.5, 0.5]), rule) - 3.0).abs() < 1e-14);
        }
        // g = r + s + 1: a corner triangle with legs 1 + … : r + s < −1 has legs 1.
        assert!((area(Gap([-1.0, 1.0, 3.0, 1.0]), Integration::Clipped) - 0.5).abs() < 1e-14);
        // Zero along an edge and closed elsewhere is closed.
        assert!((area(Gap([-1.0, 0.0, 0.0, -1.0]), Integration::Clipped) - 4.0).abs() < 1e-15);
    }

    /// g = r s + c: {r s < −c} consists of two corner pieces for c > 0 and of one band for c < 0; areas in closed form:
    /// the piece r s < −c, r < 0 < s, has area ∫_c^1 (1 − c/x) dx = 1 − c + c ln c.
    #[test]
    fn opposite_corners() {
        let gap = |c: f64| Gap([1.0 + c, -1.0 + c, 1.0 + c, -1.0 + c]);
        for c in [0.1, 0.3, 0.7] {
            let piece = 1.0 - c + c * f64::ln(c);
            // Five points for a logarithm.
            assert!((area(gap(c), Integration::Clipped) - 2.0 * piece).abs() < 1e-3, "{c}");
            assert!((area(gap(-c), Integration::Clipped) - (4.0 - 2.0 * piece)).abs() < 1e-3, "{c}");
        }
    }
}
