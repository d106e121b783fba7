//! The minimal-residual method of Paige and Saunders with a preconditioner.
//!
//! ```text
//! A x = b        A symmetric, also indefinite        P symmetric positive definite, close to A
//! ```
//!
//! minimises √(rᵀ P⁻¹ r) over the Krylov space of P⁻¹ A: it never rises. Conjugate gradients need a definite A; the price of
//! doing without are two more vectors.
//!
//! Source: Paige & Saunders 1975; the recurrences as in Choi, Paige & Saunders 2011.

use super::{LinalgError, dot};

/// Result of [`minres`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterations {
    /// Products with A.
    pub count: usize,
    /// √(rᵀ P⁻¹ r) relative to that of x = 0.
    pub residual: f64,
}

/// z = P⁻¹ r.
pub type Precondition<'a> = dyn FnMut(&[f64], &mut [f64]) -> Result<(), LinalgError> + 'a;

/// Solves A x = b from x = 0 until √(rᵀ P⁻¹ r) has fallen to `tolerance` of its first value.
///
/// * `product(x, y)`: y = A x
/// * `precondition(r, z)`: z = P⁻¹ r
/// * `limit`: products at most
///
/// Without convergence `x` is the best so far, and the residual says so.
///
/// Errors: a preconditioner that is not positive definite ([`LinalgError::NotPositiveDefinite`]), numbers that are not finite.
pub fn minres(
    product: &mut dyn FnMut(&[f64], &mut [f64]),
    precondition: &mut Precondition<'_>,
    b: &[f64],
    x: &mut [f64],
    tolerance: f64,
    limit: usize,
) -> Result<Iterations, LinalgError> {
    let n = b.len();
    x.fill(0.0);
    let norm = |r: &[f64], z: &[f64]| -> Result<f64, LinalgError> {
        let square = dot(r, z);
        match square >= 0.0 && square.is_finite() {
            true => Ok(square.sqrt()),
            false => Err(LinalgError::NotPositiveDefinite { pivot: 0, size: n }),
        }
    };
    let mut before = vec![0.0; n];
    let mut now = b.to_vec();
    let mut z = vec![0.0; n];
    precondition(&now, &mut z)?;
    let first = norm(&now, &z)?;
    if first == 0.0 {
        return Ok(Iterations { count: 0, residual: 0.0 });
    }
    let (mut beta, mut beta_before) = (first, 0.0);
    let (mut cosine, mut sine) = (-1.0, 0.0);
    let (mut delta_bar, mut epsilon) = (0.0, 0.0);
    let mut phi = first;
    let mut direction = [vec![0.0; n], vec![0.0; n]];
    let (mut v, mut image) = (vec![0.0; n], vec![0.0; n]);
    for count in 1..=limit {
        for (v, z) in v.iter_mut().zip(&z) {
            *v = z / beta;
        }
        product(&v, &mut image);
        if count > 1 {
            let part = beta / beta_before;
            image.iter_mut().zip(&before).for_each(|(y, r)| *y -= part * r);
        }
        let alpha = dot(&v, &image);
        let part = alpha / beta;
        image.iter_mut().zip(&now).for_each(|(y, r)| *y -= part * r);
        std::mem::swap(&mut before, &mut now);
        std::mem::swap(&mut now, &mut image);
        precondition(&now, &mut z)?;
        (beta_before, beta) = (beta, norm(&now, &z)?);
        let epsilon_before = epsilon;
        let delta = cosine * delta_bar + sine * alpha;
        let gamma_bar = sine * delta_bar - cosine * alpha;
        epsilon = sine * beta;
        delta_bar = -cosine * beta;
        let gamma = gamma_bar.hypot(beta);
        if !(gamma > 0.0 && gamma.is_finite()) {
            return Err(LinalgError::Singular { size: n });
        }
        cosine = gamma_bar / gamma;
        sine = beta / gamma;
        let step = cosine * phi;
        phi *= sine;
        let [last, previous] = &mut direction;
        for i in 0..n {
            let next = (v[i] - epsilon_before * previous[i] - delta * last[i]) / gamma;
            previous[i] = next;
            x[i] += step * next;
        }
        direction.swap(0, 1);
        let residual = phi.abs() / first;
        if residual <= tolerance || beta == 0.0 || count == limit {
            return Ok(Iterations { count, residual });
        }
    }
    Ok(Iterations { count: 0, residual: 1.0 })
}
