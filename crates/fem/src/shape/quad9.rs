//! Nine-node quadrilateral with sides along the axes: products of quadratic functions.
//!
//! ```text
//! 6 -- 7 -- 8
//! |    |    |        node = i + 3 j,   N = N_i(ξ) N_j(η)
//! 3 -- 4 -- 5
//! |    |    |
//! 0 -- 1 -- 2
//! ```

use super::line::{quadratic, quadratic_slope};

/// Shape functions at one point.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// N.
    pub n: [f64; 9],
    /// ∂N/∂ξ.
    pub dxi: [f64; 9],
    /// ∂N/∂η.
    pub deta: [f64; 9],
}

/// Shape functions at (ξ, η).
pub fn shape(xi: f64, eta: f64) -> Shape {
    let (a, da, b, db) = (quadratic(xi), quadratic_slope(xi), quadratic(eta), quadratic_slope(eta));
    let product = |f: &[f64; 3], g: &[f64; 3]| std::array::from_fn(|k| f[k % 3] * g[k / 3]);
    Shape { n: product(&a, &b), dxi: product(&da, &b), deta: product(&a, &db) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn biquadratic_fields_are_exact() {
        let field = |x: f64, y: f64| (1.0 + x - 2.0 * x * x) * (3.0 - y + 0.5 * y * y);
        let nodes = [-1.0, 0.0, 1.0];
        let (x, y) = (0.3, -0.6);
        let s = shape(x, y);
        let value: f64 = (0..9).map(|k| s.n[k] * field(nodes[k % 3], nodes[k / 3])).sum();
        let slope: f64 = (0..9).map(|k| s.dxi[k] * field(nodes[k % 3], nodes[k / 3])).sum();
        assert!((value - field(x, y)).abs() < 1e-14);
        assert!((slope - (1.0 - 4.0 * x) * (3.0 - y + 0.5 * y * y)).abs() < 1e-14);
    }
}
