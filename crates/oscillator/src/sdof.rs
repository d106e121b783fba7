//! Response of the single-degree-of-freedom oscillator, three ways.
//!
//! ```text
//! ü + 2 ξ ω u̇ + ω² u = p(t)          at rest at t = 0
//! ```
//!
//! For ground motion u is the displacement relative to the ground and p = −a_g; the absolute acceleration is then
//! ü + a_g = −(ω² u + 2 ξ ω u̇).
//!
//! | function | method | use |
//! |---|---|---|
//! | [`exact`] | [`Recurrence`]: exact for a load that is linear between samples (Nigam & Jennings 1969) | default |
//! | [`duhamel`] | convolution integral, Simpson's rule | textbook reference |
//! | [`newmark`] | average acceleration | the integrator of direct time stepping |
//!
//! # The recurrence
//!
//! With g(t) the response to a unit impulse (g(0) = 0, ġ(0) = 1), G₁ = ∫₀ᵗ g and G₂ = ∫₀ᵗ G₁, one step h under
//! p(τ) = p₀ + (p₁ − p₀) τ/h is
//!
//! ```text
//! u₁ = (ġ + 2ξω g) u₀ + g v₀ + (G₁ − G₂/h) p₀ + (G₂/h) p₁
//! v₁ =      −ω² g  u₀ + ġ v₀ + (g  − G₁/h) p₀ + (G₁/h) p₁
//! ```
//!
//! and, from the equation of motion integrated once and twice,
//!
//! ```text
//! ω² G₁ = 1 − ġ − 2ξω g          ω² G₂ = t − g − 2ξω G₁
//! ```
//! which lose digits as ω h → 0; there the power series of g is used. This covers ω = 0 (free mass), ξ = 0,
//! the critical and the over-critical oscillator with one set of formulas.

use crate::newmark::Newmark;

/// g, ġ, G₁ and G₂ of the module's theory at one time.
#[derive(Clone, Copy, Debug)]
struct Impulse {
    g: f64,
    g_dot: f64,
    g1: f64,
    g2: f64,
}

/// Impulse response and its integrals at time `t` ≥ 0 [s] for ω ≥ 0 [rad/s], ξ ≥ 0.
fn impulse(omega: f64, damping: f64, t: f64) -> Impulse {
    // Below 1 the closed forms of G₁, G₂ lose (ωt)²/6 and more of their digits; the series needs 24 terms at 1.
    if omega * t * f64::max(1.0, 2.0 * damping) < 1.0 {
        return impulse_series(omega, damping, t);
    }
    if damping < 1.0 {
        let omega_d = omega * ((1.0 - damping) * (1.0 + damping)).sqrt();
        let e = (-damping * omega * t).exp();
        let (sin, cos) = (omega_d * t).sin_cos();
        // sin(ω_d t)/ω_d → t at the critical damping.
        let s = if omega_d * t < 1e-8 { t } else { sin / omega_d };
        from_impulse(omega, damping, t, e * s, e * (cos - damping * omega * s))
    } else {
        // Roots −λ₁ (slow) and −λ₂ of the characteristic equation; λ₁ λ₂ = ω² avoids the difference ξ − √(ξ² − 1).
        let root = ((damping - 1.0) * (damping + 1.0)).sqrt();
        let slow = omega / (damping + root);
        let gap = 2.0 * omega * root;
        let e = (-slow * t).exp();
        let s = if gap * t < 1e-8 { t } else { -(-gap * t).exp_m1() / gap };
        let (g, g_dot) = (e * s, e * (1.0 - (slow + gap) * s));
        if damping < 2.0 {
            return from_impulse(omega, damping, t, g, g_dot);
        }
        // Partial fractions: g = (e^{−λ₁t} − e^{−λ₂t})/(λ₂ − λ₁); digits are kept while the slow root has little
        // effect.
        let (a1, a2) = decay_integrals(slow, t);
        let (b1, b2) = decay_integrals(slow + gap, t);
        Impulse { g, g_dot, g1: (a1 - b1) / gap, g2: (a2 - b2) / gap }
    }
}

/// First and second integral of e^{−λt} from 0 to t.
fn decay_integrals(lambda: f64, t: f64) -> (f64, f64) {
    let x = lambda * t;
    let first = if x < 1e-300 { t } else { -(-x).exp_m1() / lambda };
    let second = if x < 0.5 {
        // t² Σ (−x)^k/(k+2)!
        let (mut term, mut sum) = (0.5, 0.5);
        for k in 1..20 {
            term *= -x / (k + 2) as f64;
            sum += term;
        }
        t * t * sum
    } else {
        (t - first) / lambda
    };
    (first, second)
}

/// Completes g and ġ by the integrated equations of motion.
fn from_impulse(omega: f64, damping: f64, t: f64, g: f64, g_dot: f64) -> Impulse {
    let c = 2.0 * damping * omega;
    let g1 = (1.0 - g_dot - c * g) / (omega * omega);
    let g2 = (t - g - c * g1) / (omega * omega);
    Impulse { g, g_dot, g1, g2 }
}

/// 1/k! for k < 32.
const INVERSE_FACTORIAL: [f64; 32] = {
    let mut values = [1.0; 32];
    let mut k = 1;
    while k < 32 {
        values[k] = values[k - 1] / k as f64;
        k += 1;
    }
    values
};

/// Power series: g = Σ c_k tᵏ/k! with c₀ = 0, c₁ = 1, c_{k+2} = −2ξω c_{k+1} − ω² c_k.
fn impulse_series(omega: f64, damping: f64, t: f64) -> Impulse {
    // Scaled coefficients b_k = c_k tᵏ⁻¹; with ωt < 1 and 2ξωt < 1 they grow at most like Fibonacci numbers, so the
    // term k = 28 is below 1e-23.
    let (y, z) = (2.0 * damping * omega * t, (omega * t) * (omega * t));
    let (mut previous, mut b) = (0.0, 1.0);
    let [mut g, mut g_dot, mut g1, mut g2] = [0.0; 4];
    for k in 1..28 {
        g += b * INVERSE_FACTORIAL[k];
        g_dot += b * INVERSE_FACTORIAL[k - 1];
        g1 += b * INVERSE_FACTORIAL[k + 1];
        g2 += b * INVERSE_FACTORIAL[k + 2];
        (previous, b) = (b, -y * b - z * previous);
        // Two small terms in a row: one alone can vanish by chance.
        if f64::max(b.abs(), previous.abs()) * INVERSE_FACTORIAL[k] < 1e-18 {
            break;
        }
    }
    Impulse { g: t * g, g_dot, g1: t * t * g1, g2: t * t * t * g2 }
}

/// Coefficients of the exact step under a load that is linear within the step:
///
/// ```text
/// u₁ = a u₀ + b v₀ + c p₀ + d p₁
/// v₁ = a' u₀ + b' v₀ + c' p₀ + d' p₁
/// ```
///
/// p is the load per unit mass [m/s²]. Source: Nigam & Jennings 1969, BSSA 59(2) (there for p = −a_g and ξ < 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recurrence {
    /// ∂u₁/∂u₀.
    pub a: f64,
    /// ∂u₁/∂v₀ [s].
    pub b: f64,
    /// ∂u₁/∂p₀ [s²].
    pub c: f64,
    /// ∂u₁/∂p₁ [s²].
    pub d: f64,
    /// ∂v₁/∂u₀ [1/s].
    pub a_v: f64,
    /// ∂v₁/∂v₀.
    pub b_v: f64,
    /// ∂v₁/∂p₀ [s].
    pub c_v: f64,
    /// ∂v₁/∂p₁ [s].
    pub d_v: f64,
}

impl Recurrence {
    /// Coefficients for circular frequency `omega` ≥ 0 [rad/s], damping ratio `damping` ≥ 0 and step `h` > 0 [s].
    pub fn new(omega: f64, damping: f64, h: f64) -> Recurrence {
        let Impulse { g, g_dot, g1, g2 } = impulse(omega, damping, h);
        Recurrence {
            a: g_dot + 2.0 * damping * omega * g,
            b: g,
            c: g1 - g2 / h,
            d: g2 / h,
            a_v: -omega * omega * g,
            b_v: g_dot,
            c_v: g - g1 / h,
            d_v: g1 / h,
        }
    }

    /// One step from displacement `u` and velocity `v` under the loads `p0`, `p1` at its ends.
    #[inline(always)]
    pub fn step(&self, u: f64, v: f64, p0: f64, p1: f64) -> (f64, f64) {
        (
            self.a * u + self.b * v + self.c * p0 + self.d * p1,
            self.a_v * u + self.b_v * v + self.c_v * p0 + self.d_v * p1,
        )
    }
}

/// Displacement and velocity at the samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// u [m].
    pub u: Vec<f64>,
    /// u̇ [m/s].
    pub v: Vec<f64>,
}

/// Exact response at the samples to ground acceleration `ground` [m/s²] that is linear between samples `h` [s] apart.
///
/// Check: ξ = 1 %, ω = 3 rad/s, a_g = sin 2t, h = 0.01 s, 60 s: within 1.0e-5 m of the closed solution (which differs
/// only by the interpolation of a_g).
pub fn exact(ground: &[f64], h: f64, omega: f64, damping: f64) -> History {
    let step = Recurrence::new(omega, damping, h);
    march(ground, |u, v, a0, a1| step.step(u, v, -a0, -a1))
}

/// Response by Duhamel's integral, the textbook reference:
///
/// ```text
/// u(t) = −(1/ω_d) ∫₀ᵗ a_g(s) e^{−ξω(t−s)} sin ω_d(t−s) ds,    ω_d = ω √(1 − ξ²)
/// ```
///
/// by Simpson's rule over `sub_steps` ≥ 1 parts of each record step, a_g linear between samples. The integral up to
/// the last sample is kept as S = ∫ a_g e^{(−ξω + iω_d)(t−s)} ds and carried on by the factor of one step, so that the
/// work is proportional to the length of the record. Error per part: Simpson's, (ω h/sub_steps)⁴/2880.
///
/// Needs ω > 0 and 0 ≤ ξ < 1.
pub fn duhamel(ground: &[f64], h: f64, omega: f64, damping: f64, sub_steps: usize) -> History {
    let omega_d = omega * ((1.0 - damping) * (1.0 + damping)).sqrt();
    let n = sub_steps.max(1);
    let part = h / n as f64;
    let kernel = |t: f64| {
        let (sin, cos) = (omega_d * t).sin_cos();
        let e = (-damping * omega * t).exp();
        (e * cos, e * sin)
    };
    // Weights of Simpson's rule times the kernel at the distance from the end of the step.
    let nodes: Vec<(f64, f64, f64)> = (0..=2 * n)
        .map(|j| {
            let weight = match j % 2 {
                1 => 4.0,
                _ if j == 0 || j == 2 * n => 1.0,
                _ => 2.0,
            };
            let fraction = j as f64 / (2 * n) as f64;
            let (re, im) = kernel(h * (1.0 - fraction));
            (fraction, weight * part / 6.0 * re, weight * part / 6.0 * im)
        })
        .collect();
    let (step_re, step_im) = kernel(h);
    let mut history = History { u: Vec::with_capacity(ground.len()), v: Vec::with_capacity(ground.len()) };
    let (mut re, mut im) = (0.0, 0.0);
    for k in 0..ground.len() {
        if k > 0 {
            (re, im) = (re * step_re - im * step_im, re * step_im + im * step_re);
            for &(fraction, w_re, w_im) in &nodes {
                let a = ground[k - 1] + (ground[k] - ground[k - 1]) * fraction;
                re += w_re * a;
                im += w_im * a;
            }
        }
        history.u.push(-im / omega_d);
        history.v.push(-re + damping * omega / omega_d * im);
    }
    history
}

/// Response by Newmark's average acceleration (β = 1/4, γ = 1/2), `sub_steps` ≥ 1 steps to a record step.
/// The period is too long by the relative amount (ωh)²/12; steps of T/20 or less are usual.
pub fn newmark(ground: &[f64], h: f64, omega: f64, damping: f64, sub_steps: usize) -> History {
    let n = sub_steps.max(1);
    let h = h / n as f64;
    let k = Newmark::new(h, 0.25, 0.5);
    let (c, stiffness) = (2.0 * damping * omega, omega * omega);
    march(ground, |mut u, mut v, a0, a1| {
        // The acceleration follows from the equation of motion at the start of the step, which the method satisfies.
        let mut acc = -a0 - c * v - stiffness * u;
        for j in 1..=n {
            let load = -(a0 + (a1 - a0) * (j as f64 / n as f64));
            let rhs = load + (k.a0 * u + k.a2 * v + k.a3 * acc) + c * (k.a1 * u + k.a4 * v + k.a5 * acc);
            let u1 = rhs / (stiffness + k.a0 + k.a1 * c);
            let acc1 = k.a0 * (u1 - u) - k.a2 * v - k.a3 * acc;
            (u, v, acc) = (u1, v + k.a6 * acc + k.a7 * acc1, acc1);
        }
        (u, v)
    })
}

/// Marches from rest at the first sample.
fn march(ground: &[f64], mut step: impl FnMut(f64, f64, f64, f64) -> (f64, f64)) -> History {
    let mut history = History { u: Vec::with_capacity(ground.len()), v: Vec::with_capacity(ground.len()) };
    let (mut u, mut v) = (0.0, 0.0);
    for k in 0..ground.len() {
        if k > 0 {
            (u, v) = step(u, v, ground[k - 1], ground[k]);
        }
        history.u.push(u);
        history.v.push(v);
    }
    history
}

#[cfg(test)]
mod tests;
