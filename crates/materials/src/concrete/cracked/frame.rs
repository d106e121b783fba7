//! Crack axes n, s in the plane.

/// Axes n = (c, s), s = (−s, c).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub c: f64,
    pub s: f64,
}

impl Frame {
    /// Principal axes of a strain, n the larger.
    pub(crate) fn principal(e: &[f64; 3]) -> Frame {
        let (x, y) = (e[0] - e[1], e[2]);
        let r = (x * x + y * y).sqrt();
        if r == 0.0 {
            return Frame { c: 1.0, s: 0.0 };
        }
        // Half angles from the larger of the two, to avoid cancellation.
        if x >= 0.0 {
            let c = (0.5 * (1.0 + x / r)).sqrt();
            Frame { c, s: 0.5 * y / (r * c) }
        } else {
            let s = (0.5 * (1.0 - x / r)).sqrt();
            Frame { c: 0.5 * y / (r * s), s }
        }
    }

    /// Principal axes of a strain, n the one next to the old n.
    pub(crate) fn principal_near(e: &[f64; 3], old: Frame) -> Frame {
        let f = Frame::principal(e);
        if (f.c * old.c + f.s * old.s).abs() >= (f.c * old.s - f.s * old.c).abs() {
            f
        } else {
            Frame { c: -f.s, s: f.c }
        }
    }

    /// Strain in the axes.
    #[inline]
    pub(crate) fn strain(&self, e: &[f64; 3]) -> [f64; 3] {
        let (cc, ss, cs) = (self.c * self.c, self.s * self.s, self.c * self.s);
        [
            cc * e[0] + ss * e[1] + cs * e[2],
            ss * e[0] + cc * e[1] - cs * e[2],
            2.0 * cs * (e[1] - e[0]) + (cc - ss) * e[2],
        ]
    }

    /// Strain from the axes back to the plane.
    #[inline]
    pub(crate) fn strain_back(&self, e: &[f64; 3]) -> [f64; 3] {
        Frame { c: self.c, s: -self.s }.strain(e)
    }

    /// Stress from the axes back to the plane.
    #[inline]
    pub(crate) fn stress_back(&self, t: &[f64; 3]) -> [f64; 3] {
        let (cc, ss, cs) = (self.c * self.c, self.s * self.s, self.c * self.s);
        [
            cc * t[0] + ss * t[1] - 2.0 * cs * t[2],
            ss * t[0] + cc * t[1] + 2.0 * cs * t[2],
            cs * (t[0] - t[1]) + (cc - ss) * t[2],
        ]
    }

    /// Moduli from the axes back to the plane, Tᵀ D T.
    #[inline]
    pub(crate) fn moduli_back(&self, d: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
        // Rows of D T: a stress for a strain of the plane.
        let (cc, ss, cs) = (self.c * self.c, self.s * self.s, self.c * self.s);
        let t = [[cc, ss, cs], [ss, cc, -cs], [-2.0 * cs, 2.0 * cs, cc - ss]];
        let mut out = [[0.0; 3]; 3];
        for j in 0..3 {
            let column: [f64; 3] = std::array::from_fn(|i| d[i][0] * t[0][j] + d[i][1] * t[1][j] + d[i][2] * t[2][j]);
            let back = self.stress_back(&column);
            for i in 0..3 {
                out[i][j] = back[i];
            }
        }
        out
    }

    /// Angle of n from axis 1 [rad], in −π/2 … π/2.
    pub(crate) fn angle(&self) -> f64 {
        if self.c < 0.0 { (-self.s).atan2(-self.c) } else { self.s.atan2(self.c) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Work σ·ε and D do not depend on the axes; principal axes have zero shear and the larger strain first.
    #[test]
    fn turning_keeps_work() {
        for (e, t) in [
            ([1.0, -0.3, 0.8], [0.2, 0.5, -0.7]),
            ([-0.4, 0.9, -0.1], [1.0, 0.0, 0.3]),
            ([-0.4, 0.9, 0.0], [1.0, 0.0, 0.3]),
        ] {
            let f = Frame::principal(&e);
            let local = f.strain(&e);
            assert!(local[2].abs() < 1e-15 && local[0] >= local[1]);
            let again = f.strain_back(&local);
            let back = f.stress_back(&t);
            let work = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            assert!((work(&back, &e) - work(&t, &local)).abs() < 1e-14);
            assert!((0..3).all(|i| (again[i] - e[i]).abs() < 1e-15));
            let d = [[3.0, 1.0, 0.2], [0.7, 2.0, 0.1], [0.4, 0.3, 1.0]];
            let turned = f.moduli_back(&d);
            let stress: [f64; 3] = std::array::from_fn(|i| work(&d[i], &local));
            let expected = f.stress_back(&stress);
            assert!((0..3).all(|i| (work(&turned[i], &e) - expected[i]).abs() < 1e-14));
        }
    }
}
