//! Curves of several states that cross.
//!
//! A worse state cannot be likelier than a milder one. Free fits with different dispersions cross somewhere; where that is within the range
//! of the data, a fit with one dispersion for all states is given beside them.

use crate::stripes::{self, Stripe};
use crate::{Lognormal, NotIdentifiable};

/// The intensity at which two curves cross; none for equal dispersions.
pub fn crossing(a: &Lognormal, b: &Lognormal) -> Option<f64> {
    let slope = 1.0 / a.dispersion - 1.0 / b.dispersion;
    let level = a.median.ln() / a.dispersion - b.median.ln() / b.dispersion;
    (slope.abs() > 1e-12).then(|| (level / slope).exp()).filter(|im| im.is_finite() && *im > 0.0)
}

/// Whether any curves, from mild to severe, cross between two intensities, or are out of order there.
pub fn cross(curves: &[Lognormal], [low, high]: [f64; 2]) -> bool {
    let disordered = |a: &Lognormal, b: &Lognormal| {
        let wrong = |im: f64| a.probability(im) < b.probability(im) - 1e-12;
        wrong(low) || wrong(high) || wrong((low * high).sqrt())
    };
    let pairs = || (0..curves.len()).flat_map(|i| (i + 1..curves.len()).map(move |j| (i, j)));
    let within = |im: f64| im > low && im < high;
    pairs().any(|(i, j)| crossing(&curves[i], &curves[j]).is_some_and(within) || disordered(&curves[i], &curves[j]))
}

/// The curves with the largest common likelihood and one dispersion.
///
/// Errors: a state whose data alone do not identify a curve.
pub fn fit(states: &[Vec<Stripe>]) -> Result<Vec<Lognormal>, NotIdentifiable> {
    let free: Vec<f64> =
        states.iter().map(|s| stripes::fit(s).map(|f| f.curve.dispersion)).collect::<Result<_, _>>()?;
    let (Some(low), Some(high)) = (free.iter().copied().reduce(f64::min), free.iter().copied().reduce(f64::max)) else {
        return Err(NotIdentifiable::because("no state has data"));
    };
    // The best common dispersion lies between the free ones; each median is best for itself.
    let medians = |beta: f64| -> Vec<Lognormal> { states.iter().map(|s| median(s, beta)).collect() };
    let cost = |beta: f64| -> f64 {
        let curves = medians(beta);
        states.iter().zip(&curves).map(|(s, c)| stripes::negative_log_likelihood(s, c)).sum()
    };
    let beta = least(low.ln(), high.ln(), |log| cost(log.exp())).exp();
    Ok(medians(beta))
}

/// The best median for a dispersion.
fn median(state: &[Stripe], dispersion: f64) -> Lognormal {
    let ims = || state.iter().map(|s| s.im);
    let (low, high) = (ims().fold(f64::INFINITY, f64::min), ims().fold(0.0, f64::max));
    let curve = |log: f64| Lognormal { median: log.exp(), dispersion };
    let margin = 6.0 * dispersion;
    let best = least(low.ln() - margin, high.ln() + margin, |log| stripes::negative_log_likelihood(state, &curve(log)));
    curve(best)
}

/// The place of the least value of a function with one minimum, by golden sections.
fn least(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut fa, mut fb) = (function(a), function(b));
    for _ in 0..100 {
        if high - low < 1e-11 {
            break;
        }
        if fa < fb {
            (high, b, fb) = (b, a, fa);
            a = high - golden * (high - low);
            fa = function(a);
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + golden * (high - low);
            fb = function(b);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(median: f64, dispersion: f64) -> Lognormal {
        Lognormal { median, dispersion }
    }

    /// At the crossing both probabilities are equal.
    #[test]
    fn where_two_curves_cross() {
        let (a, b) = (curve(0.4, 0.6), curve(0.6, 0.3));
        let im = crossing(&a, &b).unwrap();
        assert!((a.probability(im) - b.probability(im)).abs() < 1e-12);
        assert!(cross(&[a, b], [0.1, 2.0]) && !cross(&[a, b], [0.1, 0.5]));
        assert_eq!(crossing(&a, &curve(0.8, 0.6)), None);
    }

    /// Exact shares of two curves of one dispersion: they are found again, in any unit of the intensity (1e-6: the shares are rounded to no
    /// whole numbers).
    #[test]
    fn a_common_dispersion_is_found_again() {
        for unit in [1.0, 0.01, 9.80665] {
            let ims = [0.2, 0.4, 0.6, 0.9, 1.4];
            let given = [curve(0.5 * unit, 0.45), curve(0.8 * unit, 0.45)];
            let state = |c: &Lognormal| -> Vec<Stripe> {
                let stripe = |im: &f64| Stripe { im: im * unit, n: 40.0, exceed: 40.0 * c.probability(im * unit) };
                ims.iter().map(stripe).collect()
            };
            let found = fit(&given.iter().map(state).collect::<Vec<_>>()).unwrap();
            for (a, b) in found.iter().zip(&given) {
                assert!((a.median / b.median - 1.0).abs() < 1e-6 && (a.dispersion / b.dispersion - 1.0).abs() < 1e-6);
            }
        }
    }
}
