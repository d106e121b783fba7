//! Return to the cone in plane stress.
//!
//! η = σ − ρ has the components xx, yy, zz, xy, and η_zz = −ρ_zz stays in the step. J_2 is invariant under a
//! hydrostatic shift, so that with η' = η − η_zz (1, 1, 1), a plane state again,
//!
//! ```text
//! F = √J_2(η') + α (η'_x + η'_y) − (k − 3 α η_zz)
//! ```
//!
//! Along s = (x + y)/√2, d = (x − y)/√2, t = xy: J_2 = s²/6 + d²/2 + t², R = √J_2, and the closest point of the trial state
//! under multiplier λ is
//!
//! ```text
//! s = ŝ R/(R + λ c/6) ,  ŝ = s⁰ − √2 α c λ ,   (d, t) = (d⁰, t⁰) R/(R + λ G) ,   c = E/(1 − ν)
//! ŝ²/6/(R + λ c/6)² + (d⁰²/2 + t⁰²)/(R + λ G)² = 1        gives R(λ): its left side decreases in R
//! R + √2 α s = k(λ) − 3 α η_zz                           gives λ: its left side decreases in λ
//! ```
//!
//! Two monotone scalar equations, one inside the other: Newton inside a bracket finds both for any increment.

use crate::modes::Modes;

/// Solution of the return.
struct Returned {
    /// λ ≥ 0.
    multiplier: f64,
    /// s, d, t of η'.
    state: [f64; 3],
    /// R = √J_2.
    root: f64,
    /// dk/dλ at the end.
    slope: f64,
}

/// R of given λ, with dR/dλ; 0 where the closest point is the vertex of √J_2.
fn root(modes: &Modes<3>, alpha: f64, [s0, square]: [f64; 2], lambda: f64, guess: f64) -> (f64, f64) {
    let [c, _, g] = modes.c;
    let s_hat = s0 - 2f64.sqrt() * alpha * c * lambda;
    let (a, b) = (s_hat * s_hat / 6.0, square);
    let (u, v) = (lambda * c / 6.0, lambda * g);
    // ψ(R) = 1/√φ − 1, nearly linear in R and increasing.
    let phi = |r: f64| {
        let (x, y) = (r + u, r + v);
        (a / (x * x) + b / (y * y), 2.0 * (a / (x * x * x) + b / (y * y * y)))
    };
    if lambda > 0.0 && phi(0.0).0 <= 1.0 {
        return (0.0, 0.0);
    }
    // The norm of the trial state bounds R.
    let (mut low, mut high) = (0.0, (a + b).sqrt());
    let mut r = if guess > 0.0 && guess < high { guess } else { high };
    for _ in 0..60 {
        let (value, slope) = phi(r);
        let residual = 1.0 / value.sqrt() - 1.0;
        if residual.abs() < 1e-15 {
            break;
        }
        if residual < 0.0 {
            low = r;
        } else {
            high = r;
        }
        let mut next = r - 2.0 * residual * value * value.sqrt() / slope;
        if !(next >= low && next <= high) {
            next = 0.5 * (low + high);
        }
        if next == r {
            break;
        }
        r = next;
    }
    // dφ = 0 over R and λ, ŝ depending on λ.
    let (x, y) = (r + u, r + v);
    let by_r = -2.0 * (a / (x * x * x) + b / (y * y * y));
    let by_lambda = -2.0 * (a / (x * x * x) * c / 6.0 + b / (y * y * y) * g)
        - 2.0 * s_hat / 6.0 * 2f64.sqrt() * alpha * c / (x * x);
    (r, -by_lambda / by_r)
}

/// Returns the trial state η' to the cone, F > 0 there.
///
/// * `trial`: s, d, t of η'
/// * `strength`: λ ↦ (k − 3 α η_zz, its derivative), not decreasing, > 0
///
/// `None`: not found.
fn return_to_cone(
    modes: &Modes<3>,
    alpha: f64,
    trial: [f64; 3],
    strength: impl Fn(f64) -> (f64, f64),
) -> Option<Returned> {
    let sqrt2 = 2f64.sqrt();
    let [c, _, g] = modes.c;
    let [s0, d0, t0] = trial;
    let square = 0.5 * d0 * d0 + t0 * t0;
    let size = (s0 * s0 / 6.0 + square).sqrt() + strength(0.0).0.abs();
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut lambda = 0.0;
    let mut guess = (s0 * s0 / 6.0 + square).sqrt();
    let mut best = None;
    for _ in 0..100 {
        let (r, r_slope) = root(modes, alpha, [s0, square], lambda, guess);
        guess = r;
        let s_hat = s0 - sqrt2 * alpha * c * lambda;
        let u = lambda * c / 6.0;
        let ratio = if r + u > 0.0 { r / (r + u) } else { 1.0 };
        let s = s_hat * ratio;
        let (k, slope) = strength(lambda);
        let residual = r + sqrt2 * alpha * s - k;
        if !residual.is_finite() {
            return None;
        }
        let shrink = r / (r + lambda * g);
        if r > 0.0 {
            best = Some((
                residual.abs(),
                Returned { multiplier: lambda, state: [s, d0 * shrink, t0 * shrink], root: r, slope },
            ));
        }
        if residual.abs() <= 2e-16 * size {
            break;
        }
        if residual > 0.0 {
            low = lambda;
        } else {
            high = lambda;
        }
        // ds/dλ, with d(r/(r + u)) = (u dr − r du)/(r + u)².
        let mut next = f64::NAN;
        if r > 0.0 {
            let ratio_slope = (u * r_slope - r * c / 6.0) / ((r + u) * (r + u));
            let s_slope = -sqrt2 * alpha * c * ratio + s_hat * ratio_slope;
            next = lambda - residual / (r_slope + sqrt2 * alpha * s_slope - slope);
        }
        if !(next > low && next < high) {
            next = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * low + size / c };
        }
        if next == lambda {
            break;
        }
        lambda = next;
    }
    best.filter(|(residual, _)| *residual <= 1e-11 * size).map(|(_, found)| found)
}

/// Plastic step of a point in plane stress, all along the modes (s, d, t).
pub(crate) struct Step {
    /// Stress σ [Pa].
    pub stress: [f64; 3],
    /// ∂σ/∂ε [Pa].
    pub tangent: [[f64; 3]; 3],
    /// λ > 0.
    pub multiplier: f64,
    /// n = ∂F/∂σ, with engineering shear.
    pub normal: [f64; 3],
    /// n_zz.
    pub normal_zz: f64,
    /// R = √J_2.
    pub root: f64,
    /// ∂λ/∂ε.
    pub pull: [f64; 3],
}

/// √J_2(η') + α I_1(η') of η' along the modes.
pub(crate) fn measure(alpha: f64, [s, d, t]: [f64; 3]) -> f64 {
    (s * s / 6.0 + 0.5 * d * d + t * t).sqrt() + 2f64.sqrt() * alpha * s
}

/// Returns the trial stress to the cone around `centre`.
///
/// * `trial`: C (ε − ε_p)
/// * `centre`: ρ − ρ_zz (1, 1), so that η' = σ − centre
/// * `strength`: λ ↦ (k + 3 α ρ_zz, its derivative)
///
/// `None`: not found.
pub(crate) fn plastic_step(
    modes: &Modes<3>,
    alpha: f64,
    trial: [f64; 3],
    centre: [f64; 3],
    strength: impl Fn(f64) -> (f64, f64),
) -> Option<Step> {
    let eta = std::array::from_fn(|i| trial[i] - centre[i]);
    let found = return_to_cone(modes, alpha, eta, strength)?;
    let (lambda, r) = (found.multiplier, found.root);
    let sqrt2 = 2f64.sqrt();
    // J_2 = ½ Σ q m² ,  v = ∂R/∂m ,  ∂²R = diag(q)/(2R) − v vᵀ/R
    let (mut a, mut v, mut n, mut stress) = ([0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]);
    for i in 0..3 {
        let q = modes.p[i];
        v[i] = 0.5 * q * found.state[i] / r;
        n[i] = v[i];
        a[i] = modes.c[i] / (1.0 + 0.5 * lambda * q * modes.c[i] / r);
        stress[i] = found.state[i] + centre[i];
    }
    n[0] += sqrt2 * alpha;
    // Ξ = (C⁻¹ + λ ∂²R)⁻¹ by Sherman and Morrison.
    let w: [f64; 3] = std::array::from_fn(|i| a[i] * v[i]);
    let factor = lambda / (r - lambda * dot(&w, &v));
    let wn = dot(&w, &n);
    let z: [f64; 3] = std::array::from_fn(|i| a[i] * n[i] + factor * wn * w[i]);
    let under = dot(&z, &n) + found.slope;
    let mut tangent = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            tangent[i][j] = factor * w[i] * w[j] - z[i] * z[j] / under;
        }
        tangent[i][i] += a[i];
    }
    Some(Step {
        stress,
        tangent,
        multiplier: lambda,
        normal: n,
        normal_zz: alpha - sqrt2 * found.state[0] / (6.0 * r),
        root: r,
        pull: z.map(|z| z / under),
    })
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A matrix given along the modes, in components.
pub(crate) fn join_matrix(m: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let rows = m.map(|row| Modes::join(&row));
    let columns: [[f64; 3]; 3] = std::array::from_fn(|j| Modes::join(&rows.map(|row| row[j])));
    std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]))
}
