//! Annual rate of a damage state from its curve and a hazard curve.
//!
//! ```text
//! λ_DS = ∫ P(DS | im) |dλ(im)|        ln λ linear in ln im between the points, and beyond them with the slope of the end
//! closed form for λ = k₀ im^(−k):     λ_DS = k₀ θ^(−k) exp(k² β²/2)        (Cornell et al. 2002)
//! ```
//!
//! A piece with λ = c im^(−k) has the closed integral c θ^(−k) exp(k²β²/2) [Φ(x₂) − Φ(x₁)] with x = (ln(im/θ) + k β²)/β, less the boundary
//! terms of the integration by parts, so that the pieces are summed without quadrature.

use serde::{Deserialize, Serialize};

use crate::Lognormal;
use crate::normal::cdf;

/// Rate of a state, and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Risk {
    /// Rate a year.
    pub annual_rate: f64,
    /// Probability of at least one in 50 years, 1 − exp(−50 λ).
    pub probability_50_years: f64,
    /// Share of the rate from beyond the last point of the hazard curve, which is extrapolated.
    pub share_beyond_last: f64,
    /// Share from below the first point.
    pub share_below_first: f64,
}

/// ∫ P |dλ| over a piece λ = c im^(−k) from `low` to `high`.
fn piece(curve: &Lognormal, c: f64, k: f64, low: f64, high: f64) -> f64 {
    let Lognormal { median, dispersion } = *curve;
    // By parts: −[P λ] + ∫ λ dP, and λ dP is a normal density again, shifted by −k β².
    let shifted = |im: f64| cdf(((im / median).ln() + k * dispersion.powi(2)) / dispersion);
    let boundary = |im: f64| if im > 0.0 && im.is_finite() { curve.probability(im) * c * im.powf(-k) } else { 0.0 };
    let upper = if high.is_finite() { shifted(high) } else { 1.0 };
    let lower = if low > 0.0 { shifted(low) } else { 0.0 };
    let whole = c * median.powf(-k) * (0.5 * (k * dispersion).powi(2)).exp();
    boundary(low) - boundary(high) + whole * (upper - lower)
}

/// The risk of a curve under a hazard curve: points (im, rate a year), im ascending, rates descending, two or more.
///
/// `None` for a hazard curve in another form.
pub fn risk(curve: &Lognormal, hazard: &[[f64; 2]]) -> Option<Risk> {
    let falls = hazard.windows(2).all(|w| w[1][0] > w[0][0] && w[1][1] < w[0][1]);
    let positive = hazard.iter().flatten().all(|v| *v > 0.0 && v.is_finite());
    if hazard.len() < 2 || !falls || !positive {
        return None;
    }
    let law = |a: [f64; 2], b: [f64; 2]| {
        let k = -(b[1] / a[1]).ln() / (b[0] / a[0]).ln();
        (a[1] * a[0].powf(k), k)
    };
    let (first, last) = (hazard[0], hazard[hazard.len() - 1]);
    let (c, k) = law(hazard[0], hazard[1]);
    let below = piece(curve, c, k, 0.0, first[0]);
    let (c, k) = law(hazard[hazard.len() - 2], last);
    let beyond = piece(curve, c, k, last[0], f64::INFINITY);
    let inside: f64 = hazard
        .windows(2)
        .map(|w| {
            let (c, k) = law(w[0], w[1]);
            piece(curve, c, k, w[0][0], w[1][0])
        })
        .sum();
    let rate = below + inside + beyond;
    (rate.is_finite() && rate > 0.0).then(|| Risk {
        annual_rate: rate,
        probability_50_years: -(-50.0 * rate).exp_m1(),
        share_beyond_last: beyond / rate,
        share_below_first: below / rate,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CURVE: Lognormal = Lognormal { median: 0.519_144, dispersion: 0.454_259 };

    fn power(k0: f64, k: f64, ims: &[f64]) -> Vec<[f64; 2]> {
        ims.iter().map(|&im| [im, k0 * im.powf(-k)]).collect()
    }

    /// k₀ θ^(−k) exp(k²β²/2): 1e-9 leaves room for the sum of pieces; the bar is 1e-6.
    #[test]
    fn one_power_law_is_the_closed_form() {
        let (k0, k) = (1e-4, 2.5);
        let exact = k0 * CURVE.median.powf(-k) * (0.5 * (k * CURVE.dispersion).powi(2)).exp();
        for ims in [&[0.1, 2.0][..], &[0.05, 0.1, 0.3, 0.7, 1.0, 3.0]] {
            let found = risk(&CURVE, &power(k0, k, ims)).unwrap();
            assert!((found.annual_rate / exact - 1.0).abs() < 1e-9);
            assert!((found.probability_50_years / (1.0 - (-50.0 * exact).exp()) - 1.0).abs() < 1e-9);
        }
    }

    /// Against Simpson's rule on ln im of ∫ λ(im) dP(im), of a curve with a bend; 2·10⁴ steps are exact to 1e-8 but for the bend.
    #[test]
    fn a_bent_hazard_curve_by_quadrature() {
        let hazard = [[0.1, 1e-2], [0.4, 1e-3], [1.0, 5e-5]];
        let rate = |im: f64| {
            let i = if im < 0.4 { 0 } else { 1 };
            let (a, b): ([f64; 2], [f64; 2]) = (hazard[i], hazard[i + 1]);
            let slope = (b[1] / a[1]).ln() / (b[0] / a[0]).ln();
            a[1] * (im / a[0]).powf(slope)
        };
        let density = |x: f64| {
            let u = (x - CURVE.median.ln()) / CURVE.dispersion;
            crate::normal::density(u) / CURVE.dispersion
        };
        let (start, end, n) = (1e-4_f64.ln(), 50.0_f64.ln(), 40_000);
        let h = (end - start) / f64::from(n);
        let at = |i: i32| {
            let x = start + h * f64::from(i);
            rate(x.exp()) * density(x)
        };
        let sum: f64 = (0..=n)
            .map(|i| {
                at(i)
                    * if i == 0 || i == n {
                        1.0
                    } else if i % 2 == 1 {
                        4.0
                    } else {
                        2.0
                    }
            })
            .sum();
        let exact = sum * h / 3.0;
        let found = risk(&CURVE, &hazard).unwrap();
        assert!((found.annual_rate / exact - 1.0).abs() < 1e-6, "{} {exact}", found.annual_rate);
        assert!(found.share_beyond_last > 0.0 && found.share_below_first > 0.0);
    }

    /// All of |dλ| beyond a step at θ counts: λ(θ) = k₀ θ^(−k), of which λ(last) lies beyond the last point, and λ(θ) − λ(first) below
    /// the first. A dispersion of 1e-3 adds exp(k²β²/2) − 1 = 2e-6.
    #[test]
    fn shares_of_a_step_are_those_of_the_hazard() {
        let hazard = power(1e-4, 2.0, &[0.2, 0.4, 0.8]);
        let step = |median: f64| {
            let curve = Lognormal { median, dispersion: 1e-3 };
            let found = risk(&curve, &hazard).unwrap();
            (found.share_below_first, found.share_beyond_last)
        };
        for (median, below, beyond) in
            [(0.1, 0.75, 1.0 / 64.0), (0.4, 0.0, 0.25), (0.5, 0.0, 25.0 / 64.0), (1.6, 0.0, 1.0)]
        {
            let found = step(median);
            assert!((found.0 - below).abs() < 1e-5 && (found.1 - beyond).abs() < 1e-5, "{median}: {found:?}");
        }
    }

    #[test]
    fn other_forms_are_refused() {
        for wrong in [
            &[[0.1, 1e-2]][..],
            &[[0.1, 1e-2], [0.2, 2e-2]],
            &[[0.1, 1e-2], [0.2, 1e-2]],
            &[[0.2, 1e-2], [0.1, 1e-3]],
            &[[0.1, 0.1], [0.2, 0.0]],
        ] {
            assert_eq!(risk(&CURVE, wrong), None);
        }
    }
}
