//! Intensities at which runs reach the state.
//!
//! Where every record was scaled until it did (incremental dynamic analysis), θ and β are median and standard deviation of the logarithms
//! (n − 1; Porter, Kennedy & Bachman 2007). Where scaling ended at im_k and a record had not reached it (Baker 2015), or began at im_j and it had:
//!
//! ```text
//! ln L = Σ [ln γ − (γ ln im_i − δ)²/2] + Σ ln Φ(δ − γ ln im_k) + Σ ln Φ(γ ln im_j − δ)        γ = 1/β        δ = ln θ/β
//! ```
//!
//! concave in δ and γ (Olsen 1978).

use crate::newton::{self, Local};
use crate::normal::ln_cdf_and_slope;
use crate::{Fit, Lognormal, NotIdentifiable};

/// The curve of complete capacities: n ≥ 2, not all equal.
///
/// Errors: data that do not identify one.
pub fn fit(capacities: &[f64]) -> Result<Fit, NotIdentifiable> {
    let n = capacities.len();
    if let Some(refusal) = refused(capacities, &[], &[]) {
        return Err(refusal);
    }
    let logs: Vec<f64> = capacities.iter().map(|c| c.ln()).collect();
    let mean = logs.iter().sum::<f64>() / n as f64;
    let square: f64 = logs.iter().map(|l| (l - mean).powi(2)).sum();
    let dispersion = (square / (n - 1) as f64).sqrt();
    let likelihood = n as f64 * dispersion.ln() + 0.5 * square / dispersion.powi(2);
    Ok(Fit { curve: Lognormal { median: mean.exp(), dispersion }, n, negative_log_likelihood: likelihood })
}

/// Errors: fewer than two capacities, or all equal.
fn spread(capacities: &[f64]) -> Result<(), NotIdentifiable> {
    let lowest = capacities.iter().copied().reduce(f64::min);
    let highest = capacities.iter().copied().reduce(f64::max);
    match (lowest, highest) {
        (Some(low), Some(high)) if high > low => Ok(()),
        (Some(low), Some(_)) => Err(NotIdentifiable {
            reason: "fewer than two different capacities: the dispersion is not identified".into(),
            bounds: [Some(low), Some(low)],
        }),
        _ => Err(NotIdentifiable::because("no run reached the state")),
    }
}

/// Why these capacities identify no curve, with bounds of the median.
fn refused(capacities: &[f64], below: &[f64], beyond: &[f64]) -> Option<NotIdentifiable> {
    let refusal = spread(capacities).err()?;
    let reason = match (capacities.is_empty(), below.is_empty(), beyond.is_empty()) {
        (true, false, true) => "every run reached the state at its lowest intensity",
        (true, false, false) => "no capacity lies between two intensities",
        (true, true, true) => "no run was judged",
        _ => &refusal.reason,
    };
    let ends = |others: &[f64], pick: fn(f64, f64) -> f64| capacities.iter().chain(others).copied().reduce(pick);
    Some(NotIdentifiable {
        reason: reason.into(),
        bounds: [
            ends(beyond, f64::min).filter(|_| below.is_empty()),
            ends(below, f64::max).filter(|_| beyond.is_empty()),
        ],
    })
}

/// The curve with the largest likelihood where `censored` runs had not reached the state at `im_max`.
///
/// Errors: data that do not identify one.
pub fn fit_truncated(capacities: &[f64], im_max: f64, censored: usize) -> Result<Fit, NotIdentifiable> {
    fit_censored(capacities, &[], &vec![im_max; censored])
}

/// The curve with the largest likelihood.
///
/// * `below`: intensities at which runs had reached the state, without one at which they had not
/// * `beyond`: intensities at which runs had not reached it, without one at which they had
///
/// Errors: data that do not identify one.
pub fn fit_censored(capacities: &[f64], below: &[f64], beyond: &[f64]) -> Result<Fit, NotIdentifiable> {
    if let Some(refusal) = refused(capacities, below, beyond) {
        return Err(refusal);
    }
    let logs: Vec<f64> = capacities.iter().map(|c| c.ln()).collect();
    let signed = |ims: &[f64], sign: f64| ims.iter().map(move |im| (im.ln(), sign)).collect::<Vec<_>>();
    let tails = [signed(beyond, 1.0), signed(below, -1.0)].concat();
    let n = logs.len() as f64;
    let mean = logs.iter().sum::<f64>() / n;
    let deviation = (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / n).sqrt();
    let start = [mean / deviation, 1.0 / deviation];
    let found = newton::maximum(start, |x| likelihood(&logs, &tails, x))
        .filter(|f| f[1] > 0.0)
        .ok_or_else(|| NotIdentifiable::because("the likelihood has no maximum that was found"))?;
    Ok(Fit {
        curve: Lognormal { median: (found[0] / found[1]).exp(), dispersion: 1.0 / found[1] },
        n: logs.len() + tails.len(),
        negative_log_likelihood: -likelihood(&logs, &tails, found).0,
    })
}

/// ln L at δ and γ.
///
/// * `tails`: ln im of the runs without a capacity, and the sign of u = sign (δ − γ ln im)
fn likelihood(logs: &[f64], tails: &[(f64, f64)], [delta, gamma]: [f64; 2]) -> Local {
    if gamma <= 0.0 {
        return (f64::NEG_INFINITY, [0.0; 2], [0.0; 3]);
    }
    let n = logs.len() as f64;
    let (mut value, mut gradient) = (n * gamma.ln(), [0.0, n / gamma]);
    let mut hessian = [0.0, 0.0, -n / gamma.powi(2)];
    for log in logs {
        let residual = gamma * log - delta;
        value -= 0.5 * residual * residual;
        gradient[0] += residual;
        gradient[1] -= residual * log;
        hessian[0] -= 1.0;
        hessian[1] += log;
        hessian[2] -= log * log;
    }
    for &(end, sign) in tails {
        let u = sign * (delta - gamma * end);
        let (tail, slope) = ln_cdf_and_slope(u);
        let curvature = -slope * (slope + u);
        value += tail;
        gradient[0] += sign * slope;
        gradient[1] -= sign * slope * end;
        hessian[0] += curvature;
        hessian[1] -= curvature * end;
        hessian[2] += curvature * end * end;
    }
    (value, gradient, hessian)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAPACITIES: [f64; 10] = [0.31, 0.38, 0.42, 0.47, 0.55, 0.58, 0.66, 0.74, 0.9, 1.1];

    /// Computed outside this program: 0.569468, 0.394104.
    #[test]
    fn ten_capacities() {
        let Fit { curve: found, negative_log_likelihood: least, .. } = fit(&CAPACITIES).unwrap();
        assert!((found.median - 0.569_468).abs() < 1e-6);
        assert!((found.dispersion - 0.394_104).abs() < 1e-6);
        // n ln β + Σ u²/2, in which Σ u² is n − 1.
        assert!((least - (10.0 * found.dispersion.ln() + 4.5)).abs() < 1e-12);
    }

    /// Without censored runs the maximum is known in closed form: the mean of the logarithms and their deviation with n.
    #[test]
    fn nothing_censored_is_the_closed_form() {
        let (free, whole) = (fit_truncated(&CAPACITIES, 2.0, 0).unwrap().curve, fit(&CAPACITIES).unwrap().curve);
        assert!((free.median / whole.median - 1.0).abs() < 1e-10);
        assert!((free.dispersion / whole.dispersion - (9.0_f64 / 10.0).sqrt()).abs() < 1e-10);
    }

    /// No curve of a grid of ±30 % has a smaller negative likelihood of θ and β.
    fn is_likeliest(found: &Fit, negative: &dyn Fn(f64, f64) -> f64) {
        let least = negative(found.curve.median, found.curve.dispersion);
        assert!((least - found.negative_log_likelihood).abs() < 1e-9);
        for i in -30..=30 {
            for k in -30..=30 {
                let place = |x: f64, i: i32| x * (1.0 + 0.01 * f64::from(i));
                assert!(negative(place(found.curve.median, i), place(found.curve.dispersion, k)) >= least - 1e-9);
            }
        }
    }

    /// A grid search of the likelihood in θ and β, with the density of each capacity.
    #[test]
    fn no_other_truncated_curve_of_a_grid_is_likelier() {
        let (seen, end, censored) = (&CAPACITIES[..7], 0.7, 3);
        let negative = |theta: f64, beta: f64| -> f64 {
            let density = |c: &f64| {
                let u = (c / theta).ln() / beta;
                -beta.ln() - 0.5 * u * u
            };
            let tail = crate::normal::cdf(-(end / theta).ln() / beta).ln();
            -seen.iter().map(density).sum::<f64>() - censored as f64 * tail
        };
        let found = fit_truncated(seen, end, censored).unwrap();
        is_likeliest(&found, &negative);
        // The runs that never reached the state raise the median.
        assert!(found.curve.median > fit(seen).unwrap().curve.median);
    }

    /// The same with two runs below 0.4, one of which was not judged at lower intensities, and ends at two intensities.
    #[test]
    fn no_other_censored_curve_of_a_grid_is_likelier() {
        let (seen, below, beyond) = (&CAPACITIES[2..7], [0.4, 0.4], [0.7, 0.7, 1.0]);
        let negative = |theta: f64, beta: f64| -> f64 {
            let u = |c: &f64| (c / theta).ln() / beta;
            let density = |c: &f64| -beta.ln() - 0.5 * u(c) * u(c);
            let left = below.iter().map(|c| crate::normal::cdf(u(c)).ln()).sum::<f64>();
            let right = beyond.iter().map(|c| crate::normal::cdf(-u(c)).ln()).sum::<f64>();
            -seen.iter().map(density).sum::<f64>() - left - right
        };
        let found = fit_censored(seen, &below, &beyond).unwrap();
        is_likeliest(&found, &negative);
        assert_eq!(found.n, 10);
    }

    #[test]
    fn derivatives_of_the_likelihood() {
        let logs: Vec<f64> = CAPACITIES.iter().map(|c| c.ln()).collect();
        let tails = [(0.7_f64.ln(), 1.0), (1.3_f64.ln(), 1.0), (0.4_f64.ln(), -1.0)];
        newton::derivatives_agree([-1.1, 2.3], |x| likelihood(&logs, &tails, x));
    }

    /// Bounds of the median are those of all runs: one below 0.2 leaves no lower one, one beyond 0.9 no upper one.
    #[test]
    fn bounds_are_of_all_runs() {
        let bounds =
            |seen: &[f64], below: &[f64], beyond: &[f64]| fit_censored(seen, below, beyond).unwrap_err().bounds;
        assert_eq!(bounds(&[0.4], &[], &[0.9]), [Some(0.4), None]);
        assert_eq!(bounds(&[0.4], &[0.2], &[]), [None, Some(0.4)]);
        assert_eq!(bounds(&[0.4], &[0.2], &[0.9]), [None, None]);
        assert_eq!(bounds(&[], &[0.2, 0.3], &[]), [None, Some(0.3)]);
    }

    #[test]
    fn refusals() {
        assert_eq!(fit(&[]).unwrap_err().reason, "no run was judged");
        assert!(fit(&[]).is_err() && fit(&[0.4]).is_err() && fit(&[0.4, 0.4]).is_err());
        assert_eq!(fit_truncated(&[], 0.7, 3).unwrap_err().bounds, [Some(0.7), None]);
    }
}
