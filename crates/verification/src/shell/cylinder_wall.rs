//! Closed form of a cylindrical wall under a pressure that is linear piece by piece.
//!
//! ```text
//! D w'''' + (E t/R²) w = p(z) ,   D = E t³/(12 (1 − ν²)) ,   b = (3 (1 − ν²))^¼ / √(R t)
//! w = e^{−b (z − z₀)} (A cos b(z − z₀) + B sin b(z − z₀)) + e^{−b (z₁ − z)} (C cos b(z₁ − z) + F sin b(z₁ − z)) + p R²/(E t)
//! n_φ = E t w/R ,   m_v = −D w'' ,   q = −D w'''
//! ```
//!
//! w is positive outwards. Clamped at the bottom, free at the top; w, w', D w'', D w''' are continuous between pieces. No
//! shear flexibility and no axial force.
//!
//! Source: Timoshenko & Woinowsky-Krieger 1959, art. 114-118.

use nalgebra::{DMatrix, DVector};

/// One piece of wall of one thickness and one linear pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Its upper end [m] above the bottom.
    pub top: f64,
    /// Thickness t [m].
    pub thickness: f64,
    /// Pressure [Pa] at its lower and its upper end.
    pub pressure: [f64; 2],
}

/// A wall.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CylinderWall {
    /// Radius R [m].
    pub radius: f64,
    /// Young's modulus E [Pa].
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Pieces from below; the first starts at 0.
    pub pieces: Vec<Piece>,
}

/// Solution of a [`CylinderWall`].
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WallSolution {
    wall: CylinderWall,
    coefficients: Vec<[f64; 4]>,
}

/// Values at one height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WallPoint {
    /// w [m], outwards.
    pub w: f64,
    /// w'.
    pub slope: f64,
    /// n_φ [N/m].
    pub n_phi: f64,
    /// m_v [N], negative where the inner face is stretched.
    pub m_v: f64,
    /// q [N/m].
    pub q: f64,
}

impl CylinderWall {
    fn bottom(&self, piece: usize) -> f64 {
        if piece == 0 { 0.0 } else { self.pieces[piece - 1].top }
    }

    fn decay(&self, t: f64) -> f64 {
        (3.0 * (1.0 - self.poisson_ratio * self.poisson_ratio)).powf(0.25) / (self.radius * t).sqrt()
    }

    fn rigidity(&self, t: f64) -> f64 {
        self.youngs_modulus * t.powi(3) / (12.0 * (1.0 - self.poisson_ratio * self.poisson_ratio))
    }

    /// Derivatives 0 to 3 of the four functions and of the particular solution at z in a piece.
    fn functions(&self, piece: usize, z: f64) -> [[f64; 5]; 4] {
        let p = &self.pieces[piece];
        let (z0, z1, b) = (self.bottom(piece), p.top, self.decay(p.thickness));
        // f = e^{−s} cos s, g = e^{−s} sin s: f' = −f − g, g' = f − g.
        let from = |s: f64| {
            let (e, (sin, cos)) = ((-s).exp(), s.sin_cos());
            let mut rows = [[e * cos, e * sin]; 4];
            for k in 1..4 {
                // d/ds of (αf + βg) = (−α + β) f... applied to the pair of functions.
                let [f, g] = rows[k - 1];
                rows[k] = [-f - g, f - g];
            }
            rows
        };
        let (lower, upper) = (from(b * (z - z0)), from(b * (z1 - z)));
        let flexibility = self.radius * self.radius / (self.youngs_modulus * p.thickness);
        let gradient = (p.pressure[1] - p.pressure[0]) / (z1 - z0);
        let particular = [flexibility * (p.pressure[0] + gradient * (z - z0)), flexibility * gradient, 0.0, 0.0];
        std::array::from_fn(|k| {
            let (up, down) = (b.powi(k as i32), (-b).powi(k as i32));
            [up * lower[k][0], up * lower[k][1], down * upper[k][0], down * upper[k][1], particular[k]]
        })
    }

    /// Solves for the coefficients; `None` if there is no piece or the heights do not ascend.
    pub(crate) fn solve(self) -> Option<WallSolution> {
        let n = self.pieces.len();
        if n == 0 || (0..n).any(|i| self.pieces[i].top <= self.bottom(i)) {
            return None;
        }
        let mut a = DMatrix::<f64>::zeros(4 * n, 4 * n);
        let mut rhs = DVector::<f64>::zeros(4 * n);
        let mut row = 0;
        let mut condition = |terms: &[(usize, f64, [f64; 5])], a: &mut DMatrix<f64>, rhs: &mut DVector<f64>| {
            let scale =
                terms.iter().flat_map(|(_, f, v)| v[..4].iter().map(move |x| (f * x).abs())).fold(0.0, f64::max);
            for &(piece, factor, values) in terms {
                (0..4).for_each(|k| a[(row, 4 * piece + k)] += factor * values[k] / scale);
                rhs[row] -= factor * values[4] / scale;
            }
            row += 1;
        };
        let base = self.functions(0, 0.0);
        let head = self.functions(n - 1, self.pieces[n - 1].top);
        condition(&[(0, 1.0, base[0])], &mut a, &mut rhs);
        condition(&[(0, 1.0, base[1])], &mut a, &mut rhs);
        condition(&[(n - 1, 1.0, head[2])], &mut a, &mut rhs);
        condition(&[(n - 1, 1.0, head[3])], &mut a, &mut rhs);
        for i in 1..n {
            let z = self.bottom(i);
            let (below, above) = (self.functions(i - 1, z), self.functions(i, z));
            for k in 0..4 {
                let weight = |piece: usize| match k {
                    0 | 1 => 1.0,
                    _ => self.rigidity(self.pieces[piece].thickness),
                };
                let terms = [(i - 1, weight(i - 1), below[k]), (i, -weight(i), above[k])];
                condition(&terms, &mut a, &mut rhs);
            }
        }
        let x = a.lu().solve(&rhs)?;
        let coefficients = (0..n).map(|i| std::array::from_fn(|k| x[4 * i + k])).collect();
        Some(WallSolution { wall: self, coefficients })
    }
}

impl WallSolution {
    /// Values at height z [m]; at a step those of the piece above.
    pub(crate) fn at(&self, z: f64) -> WallPoint {
        let last = self.wall.pieces.len() - 1;
        let piece = self.wall.pieces.iter().position(|p| z < p.top).unwrap_or(last);
        let t = self.wall.pieces[piece].thickness;
        let values = self.wall.functions(piece, z).map(|row| {
            let own: f64 = (0..4).map(|k| self.coefficients[piece][k] * row[k]).sum();
            own + row[4]
        });
        let rigidity = self.wall.rigidity(t);
        WallPoint {
            w: values[0],
            slope: values[1],
            n_phi: self.wall.youngs_modulus * t * values[0] / self.wall.radius,
            m_v: -rigidity * values[2],
            q: -rigidity * values[3],
        }
    }

    /// Height and value of the largest `quantity` in [0, `to`], to 10⁻⁵ of the height.
    pub(crate) fn largest(&self, to: f64, quantity: impl Fn(&WallPoint) -> f64) -> (f64, f64) {
        (0..=100_000)
            .map(|i| to * f64::from(i) / 1e5)
            .map(|z| (z, quantity(&self.at(z))))
            .fold((0.0, f64::NEG_INFINITY), |best, at| if at.1 > best.1 { at } else { best })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One course, full: m_v(0) = −γ R t H (1 − 1/(b H))/√(12 (1 − ν²)) (Timoshenko, eq. 284) up to e^{−bH}; and the
    /// equation itself by differences.
    #[test]
    fn clamped_moment_and_differential_equation() {
        let (gamma, height, t, radius, nu, young) = (9810.0, 2.0, 0.002, 1.83, 0.32, 69e9);
        let wall = CylinderWall {
            radius,
            youngs_modulus: young,
            poisson_ratio: nu,
            pieces: vec![Piece { top: height, thickness: t, pressure: [gamma * height, 0.0] }],
        };
        let b = wall.decay(t);
        let rigidity = wall.rigidity(t);
        let solution = wall.solve().unwrap();
        let exact = -gamma * radius * t * height * (1.0 - 1.0 / (b * height)) / (12.0_f64 * (1.0 - nu * nu)).sqrt();
        assert!((solution.at(0.0).m_v / exact - 1.0).abs() < 1e-9);
        assert!(solution.at(0.0).w.abs() < 1e-15 && solution.at(0.0).slope.abs() < 1e-12);
        let (z, h) = (0.11, 1e-4);
        // D w'''' = −q'.
        let fourth = -(solution.at(z + h).q - solution.at(z - h).q) / (2.0 * h) / rigidity * rigidity;
        let left = fourth + young * t / (radius * radius) * solution.at(z).w;
        assert!((left / (gamma * (height - z)) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn heights_must_ascend() {
        let wall = CylinderWall {
            radius: 1.0,
            youngs_modulus: 1.0,
            poisson_ratio: 0.3,
            pieces: vec![Piece { top: 0.0, thickness: 0.1, pressure: [0.0; 2] }],
        };
        assert_eq!(wall.solve(), None);
    }
}
