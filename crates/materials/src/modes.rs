//! Common eigenvectors of the elastic moduli C and of the deviator matrix P.
//!
//! ```text
//! J_2 = ½ σᵀ P σ ,   P gives the direction of plastic strain, with engineering shear
//!
//! N = 1   (1)                                                p = 2/3        c = E
//! N = 3   (1, 1, 0)/√2   (1, −1, 0)/√2   (0, 0, 1)           p = 1/3, 1, 2  c = E/(1 − ν), 2G, G
//! N = 6   (1, 1, 1)/√3   (1, −1, 0)/√2   (1, 1, −2)/√6       p = 0, 1, 1    c = 3K, 2G, 2G
//!         three shears                                       p = 2          c = G
//! ```
//!
//! C P has the eigenvalue 2G except for the first vector (E/(3(1 − ν)) in the plane, 0 in the solid): a return map needs
//! only scalars.

use std::f64::consts::FRAC_1_SQRT_2;

use crate::elastic::Elastic;

/// Eigenvalues of C and P; see the module.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Modes<const N: usize> {
    /// Eigenvalues of C [Pa].
    pub c: [f64; N],
    /// Eigenvalues of P.
    pub p: [f64; N],
    /// C in components [Pa].
    pub moduli: [[f64; N]; N],
}

impl Modes<1> {
    pub(crate) fn bar(elastic: &Elastic) -> Self {
        Modes { c: [elastic.young_modulus()], p: [2.0 / 3.0], moduli: [[elastic.young_modulus()]] }
    }
}

impl Modes<3> {
    pub(crate) fn plane(elastic: &Elastic) -> Self {
        let g = elastic.shear_modulus();
        Modes {
            c: [elastic.young_modulus() / (1.0 - elastic.poisson_ratio()), 2.0 * g, g],
            p: [1.0 / 3.0, 1.0, 2.0],
            moduli: elastic.plane(),
        }
    }
}

impl Modes<6> {
    pub(crate) fn solid(elastic: &Elastic) -> Self {
        let g = elastic.shear_modulus();
        let bulk = elastic.young_modulus() / (1.0 - 2.0 * elastic.poisson_ratio());
        Modes { c: [bulk, 2.0 * g, 2.0 * g, g, g, g], p: [0.0, 1.0, 1.0, 2.0, 2.0, 2.0], moduli: elastic.solid() }
    }
}

impl<const N: usize> Modes<N> {
    /// Components along the modes.
    pub(crate) fn split(v: &[f64; N]) -> [f64; N] {
        let mut m = *v;
        if N == 3 {
            m[0] = FRAC_1_SQRT_2 * (v[0] + v[1]);
            m[1] = FRAC_1_SQRT_2 * (v[0] - v[1]);
        } else if N == 6 {
            m[0] = (v[0] + v[1] + v[2]) / 3f64.sqrt();
            m[1] = FRAC_1_SQRT_2 * (v[0] - v[1]);
            m[2] = (v[0] + v[1] - 2.0 * v[2]) / 6f64.sqrt();
        }
        m
    }

    /// Back from [`Modes::split`].
    pub(crate) fn join(m: &[f64; N]) -> [f64; N] {
        let mut v = *m;
        if N == 3 {
            v[0] = FRAC_1_SQRT_2 * (m[0] + m[1]);
            v[1] = FRAC_1_SQRT_2 * (m[0] - m[1]);
        } else if N == 6 {
            let (a, b, c) = (m[0] / 3f64.sqrt(), FRAC_1_SQRT_2 * m[1], m[2] / 6f64.sqrt());
            v[0] = a + b + c;
            v[1] = a - b + c;
            v[2] = a - 2.0 * c;
        }
        v
    }

    /// A matrix given along the modes, diag(d) + l rᵀ, in components.
    pub(crate) fn matrix(d: &[f64; N], l: &[f64; N], r: &[f64; N]) -> [[f64; N]; N] {
        let (l, r) = (Self::join(l), Self::join(r));
        let mut m = [[0.0; N]; N];
        for j in 0..N {
            let mut unit = [0.0; N];
            unit[j] = 1.0;
            let mut column = Self::split(&unit);
            for (x, d) in column.iter_mut().zip(d) {
                *x *= d;
            }
            let column = Self::join(&column);
            for i in 0..N {
                m[i][j] = column[i] + l[i] * r[j];
            }
        }
        m
    }

    /// von Mises' equivalent stress √(3 J_2) of a stress given along the modes.
    pub(crate) fn equivalent(&self, xi: &[f64; N]) -> f64 {
        (1.5 * self.p.iter().zip(xi).map(|(p, x)| p * x * x).sum::<f64>()).sqrt()
    }
}
