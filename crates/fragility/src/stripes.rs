//! Counts at intensities, by maximum likelihood.
//!
//! At the intensity im_j, z_j of n_j runs reached the state (Baker 2015, without the binomial constant):
//!
//! ```text
//! ln L = Σ z_j ln Φ(u_j) + (n_j − z_j) ln Φ(−u_j)        u_j = a + b ln im_j        θ = exp(−a/b)        β = 1/b
//! ```
//!
//! The function is concave in a and b, so Newton's method finds its maximum from any start. It has no maximum if one intensity separates the
//! runs that reached the state from the others.

use serde::{Deserialize, Serialize};

use crate::newton::{self, Local};
use crate::normal::{ln_cdf, ln_cdf_and_slope};
use crate::{Fit, Lognormal, NotIdentifiable};

/// Runs at one intensity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stripe {
    /// Intensity, positive.
    pub im: f64,
    /// Number of runs.
    pub n: f64,
    /// Those that reached the state.
    pub exceed: f64,
}

/// Negative logarithm of the likelihood of a curve, without the binomial constant.
pub fn negative_log_likelihood(stripes: &[Stripe], curve: &Lognormal) -> f64 {
    let of = |s: &Stripe| {
        let u = (s.im / curve.median).ln() / curve.dispersion;
        let part = |count: f64, u: f64| if count > 0.0 { count * ln_cdf(u) } else { 0.0 };
        part(s.exceed, u) + part(s.n - s.exceed, -u)
    };
    -stripes.iter().map(of).sum::<f64>()
}

/// Why stripes do not identify a curve; none if they do.
pub fn refusal(stripes: &[Stripe]) -> Option<NotIdentifiable> {
    let runs = || stripes.iter().filter(|s| s.n > 0.0);
    let reached = || runs().filter(|s| s.exceed > 0.0);
    let safe = || runs().filter(|s| s.exceed < s.n);
    let extreme = |all: &mut dyn Iterator<Item = &Stripe>, pick: fn(f64, f64) -> f64| all.map(|s| s.im).reduce(pick);
    if runs().next().is_none() {
        return Some(NotIdentifiable::because("the data have no runs"));
    }
    let lowest_reached = extreme(&mut reached(), f64::min);
    let highest_safe = extreme(&mut safe(), f64::max);
    let (Some(first), Some(last)) = (lowest_reached, highest_safe) else {
        let none = lowest_reached.is_none();
        let reason = if none { "no run reached the state" } else { "every run reached the state" };
        let bounds = if none { [highest_safe, None] } else { [None, lowest_reached] };
        return Some(NotIdentifiable { reason: reason.into(), bounds });
    };
    if last < first {
        let reason = "an intensity separates the runs that reached the state from those that did not: the dispersion is not identified";
        return Some(NotIdentifiable { reason: reason.into(), bounds: [Some(last), Some(first)] });
    }
    if last == first {
        // That intensity is near the median; the next ones, which no run and every run survived, bound it.
        let reason =
            "runs that reached the state and others share one intensity alone: the dispersion is not identified";
        return Some(NotIdentifiable {
            reason: reason.into(),
            bounds: [
                extreme(&mut runs().filter(|s| s.im < first), f64::max),
                extreme(&mut runs().filter(|s| s.im > last), f64::min),
            ],
        });
    }
    None
}

/// The curve with the largest likelihood.
///
/// Errors: stripes that do not identify one, or on which damage becomes rarer with intensity.
pub fn fit(stripes: &[Stripe]) -> Result<Fit, NotIdentifiable> {
    if let Some(refusal) = refusal(stripes) {
        return Err(refusal);
    }
    // Centred, so that the two unknowns are nearly independent.
    let total: f64 = stripes.iter().map(|s| s.n).sum();
    let centre = stripes.iter().map(|s| s.n * s.im.ln()).sum::<f64>() / total;
    let counts: Vec<(f64, f64, f64)> = stripes
        .iter()
        .flat_map(|stripe| {
            let x = stripe.im.ln() - centre;
            [(x, stripe.exceed, 1.0), (x, stripe.n - stripe.exceed, -1.0)]
        })
        .filter(|(_, count, _)| *count > 0.0)
        .collect();
    let found = newton::maximum([0.0, 1.0], |at| likelihood(&counts, at))
        .ok_or_else(|| NotIdentifiable::because("the likelihood has no maximum that was found"))?;
    if found[1] <= 0.0 {
        return Err(NotIdentifiable::because("damage does not become more frequent with intensity"));
    }
    let curve = Lognormal { median: (centre - found[0] / found[1]).exp(), dispersion: 1.0 / found[1] };
    Ok(Fit { curve, n: total.round() as usize, negative_log_likelihood: negative_log_likelihood(stripes, &curve) })
}

/// ln L at a and b.
///
/// * `counts`: centred ln im, runs, and the sign of u = sign (a + b ln im)
fn likelihood(counts: &[(f64, f64, f64)], [a, b]: [f64; 2]) -> Local {
    let (mut value, mut g, mut h) = (0.0, [0.0; 2], [0.0; 3]);
    for &(x, count, sign) in counts {
        let u = sign * (a + b * x);
        let (tail, slope) = ln_cdf_and_slope(u);
        let curvature = -slope * (slope + u);
        value += count * tail;
        let d = count * sign * slope;
        g = [g[0] + d, g[1] + d * x];
        let c = count * curvature;
        h = [h[0] + c, h[1] + c * x, h[2] + c * x * x];
    }
    (value, g, h)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stripes(all: &[(f64, f64, f64)]) -> Vec<Stripe> {
        all.iter().map(|&(im, n, exceed)| Stripe { im, n, exceed }).collect()
    }

    fn example() -> Vec<Stripe> {
        let im = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0];
        let exceed = [0.0, 1.0, 5.0, 11.0, 18.0, 24.0, 33.0, 38.0];
        im.iter().zip(exceed).map(|(&im, exceed)| Stripe { im, n: 40.0, exceed }).collect()
    }

    /// Values of two optimisers outside this program: 0.519144, 0.454259, 124.572; the digits are those given.
    #[test]
    fn forty_runs_at_eight_intensities() {
        let found = fit(&example()).unwrap();
        assert!((found.curve.median - 0.519_144).abs() < 1e-6, "{found:?}");
        assert!((found.curve.dispersion - 0.454_259).abs() < 1e-6);
        assert!((found.negative_log_likelihood - 124.572).abs() < 1e-3);
        assert_eq!(found.n, 320);
    }

    #[test]
    fn derivatives_of_the_likelihood() {
        let counts = [(-0.7, 3.0, 1.0), (-0.7, 37.0, -1.0), (0.4, 22.0, 1.0), (0.9, 5.0, -1.0)];
        newton::derivatives_agree([-0.3, 1.6], |at| likelihood(&counts, at));
    }

    /// A grid search does not use gradients.
    #[test]
    fn no_other_curve_of_a_grid_is_likelier() {
        let found = fit(&example()).unwrap();
        for i in -20..=20 {
            for k in -20..=20 {
                let other = Lognormal {
                    median: found.curve.median * (1.0 + 0.01 * f64::from(i)),
                    dispersion: found.curve.dispersion * (1.0 + 0.01 * f64::from(k)),
                };
                assert!(negative_log_likelihood(&example(), &other) >= found.negative_log_likelihood - 1e-9);
            }
        }
    }

    #[test]
    fn another_unit_scales_the_median_alone() {
        let scaled: Vec<Stripe> = example().iter().map(|s| Stripe { im: 9.80665 * s.im, ..*s }).collect();
        let (a, b) = (fit(&example()).unwrap().curve, fit(&scaled).unwrap().curve);
        assert!((b.median / a.median / 9.80665 - 1.0).abs() < 1e-12);
        assert!((b.dispersion / a.dispersion - 1.0).abs() < 1e-12);
    }

    #[test]
    fn data_without_a_curve_are_refused() {
        let reason = |all: &[(f64, f64, f64)]| fit(&stripes(all)).unwrap_err();
        assert!(reason(&[]).reason.contains("no runs"));
        let none = reason(&[(0.1, 5.0, 0.0), (0.2, 5.0, 0.0)]);
        assert!(none.reason.contains("no run reached") && none.bounds == [Some(0.2), None]);
        let all = reason(&[(0.1, 5.0, 5.0)]);
        assert!(all.reason.contains("every run") && all.bounds == [None, Some(0.1)]);
        let parted = reason(&[(0.1, 5.0, 0.0), (0.2, 5.0, 0.0), (0.3, 5.0, 5.0)]);
        assert!(parted.reason.contains("separates") && parted.bounds == [Some(0.2), Some(0.3)]);
        // Two of five at 0.2: the median is between the intensities beside it, where no run and every run reached the state.
        let shared = reason(&[(0.1, 5.0, 0.0), (0.2, 5.0, 2.0), (0.3, 5.0, 5.0)]);
        assert!(shared.reason.contains("share one") && shared.bounds == [Some(0.1), Some(0.3)]);
        let lowest = reason(&[(0.2, 5.0, 2.0), (0.3, 5.0, 5.0)]);
        assert!(lowest.reason.contains("share one") && lowest.bounds == [None, Some(0.3)]);
        assert!(reason(&[(0.1, 10.0, 8.0), (0.5, 10.0, 2.0)]).reason.contains("more frequent"));
    }
}
