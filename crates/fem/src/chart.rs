//! Charts: the coordinates an element integrates in.
//!
//! ```text
//! Cartesian      x¹ = x, x² = y, x³ = z      metric 1, 1, 1          √g = 1
//! cylindrical    x¹ = r, x² = θ, x³ = z      metric 1, r², 1         √g = r
//! ```
//!
//! (The dissertation counts θ, r, z, which is left-handed; here a right-handed element has a positive Jacobian in both.)
//!
//! An element in the cylindrical chart stores the chart coordinates of its corners, so the tank's axis (r = 0, any
//! θ) and the seam at 2π need no special node.

use nalgebra::{Matrix3, Vector3};

/// Kind of coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chart {
    /// (x, y, z).
    Cartesian,
    /// (r, θ, z) about the z axis.
    Cylindrical,
}

impl Chart {
    /// Global Cartesian position of the point with chart coordinates `x`.
    pub fn position(self, x: [f64; 3]) -> [f64; 3] {
        match self {
            Chart::Cartesian => x,
            Chart::Cylindrical => [x[0] * x[1].cos(), x[0] * x[1].sin(), x[2]],
        }
    }

    /// √g: volume element dV = √g dx¹ dx² dx³.
    pub fn volume_factor(self, x: [f64; 3]) -> f64 {
        match self {
            Chart::Cartesian => 1.0,
            Chart::Cylindrical => x[0],
        }
    }

    /// Contravariant metric g¹¹, g²², g³³ (the charts are orthogonal). Singular on the axis of the cylindrical chart.
    pub fn inverse_metric(self, x: [f64; 3]) -> [f64; 3] {
        match self {
            Chart::Cartesian => [1.0; 3],
            Chart::Cylindrical => [1.0, 1.0 / (x[0] * x[0]), 1.0],
        }
    }

    /// Γᵐ_ij: `christoffel[m][i][j]`. Cylindrical: Γʳ_θθ = −r, Γ^θ_rθ = Γ^θ_θr = 1/r.
    pub fn christoffel(self, x: [f64; 3]) -> [[[f64; 3]; 3]; 3] {
        let mut gamma = [[[0.0; 3]; 3]; 3];
        if self == Chart::Cylindrical {
            gamma[0][1][1] = -x[0];
            gamma[1][0][1] = 1.0 / x[0];
            gamma[1][1][0] = 1.0 / x[0];
        }
        gamma
    }

    /// Covariant components of a Cartesian vector at `x`: u_i = base_i · u. Row i is the covariant base vector.
    /// Cylindrical: base_r = e_r, base_θ = r e_θ, base_z = e_z.
    pub fn covariant_base(self, x: [f64; 3]) -> Matrix3<f64> {
        match self {
            Chart::Cartesian => Matrix3::identity(),
            Chart::Cylindrical => {
                let (s, c) = x[1].sin_cos();
                Matrix3::new(c, s, 0.0, -x[0] * s, x[0] * c, 0.0, 0.0, 0.0, 1.0)
            }
        }
    }

    /// Orthonormal base (rows) at `x`: Cartesian axes, or e_r, e_θ, e_z.
    pub fn orthonormal_base(self, x: [f64; 3]) -> [Vector3<f64>; 3] {
        match self {
            Chart::Cartesian => [Vector3::x(), Vector3::y(), Vector3::z()],
            Chart::Cylindrical => {
                let (s, c) = x[1].sin_cos();
                [Vector3::new(c, s, 0.0), Vector3::new(-s, c, 0.0), Vector3::z()]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Γᵐ_ij = aᵐ · ∂a_i/∂xʲ by central differences of the covariant base.
    #[test]
    fn christoffel_symbols_are_derivatives_of_the_base() {
        let x = [1.7, 0.6, -0.4];
        let gamma = Chart::Cylindrical.christoffel(x);
        let base = Chart::Cylindrical.covariant_base(x);
        let metric = Chart::Cylindrical.inverse_metric(x);
        for j in 0..3 {
            let h = 1e-6;
            let (mut lower, mut upper) = (x, x);
            lower[j] -= h;
            upper[j] += h;
            let slope =
                (Chart::Cylindrical.covariant_base(upper) - Chart::Cylindrical.covariant_base(lower)) / (2.0 * h);
            for i in 0..3 {
                for m in 0..3 {
                    let expected = metric[m] * base.row(m).dot(&slope.row(i));
                    assert!((gamma[m][i][j] - expected).abs() < 1e-9, "{m}{i}{j}");
                }
            }
        }
    }
}
