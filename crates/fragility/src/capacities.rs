//! Intensities at which runs reach the state.
//!
//! Where every record was scaled until it did (incremental dynamic analysis), θ and β are median and standard deviation of the logarithms
//! (n − 1; Porter, Kennedy & Bachman 2007). Where scaling ended at im_max and some had not reached it (Baker 2015):
//!
//! ```text
//! ln L = Σ [ln γ − (γ ln im_i − δ)²/2] + N ln Φ(δ − γ ln im_max)        γ = 1/β        δ = ln θ/β
//! ```
//!
//! concave in δ and γ (Olsen 1978).

use crate::newton::{self, Local};
use crate::normal::{hazard, ln_cdf};
use crate::{Fit, Lognormal, NotIdentifiable};

/// The curve of complete capacities: n ≥ 2, not all equal.
///
/// Errors: data that do not identify one.
pub fn fit(capacities: &[f64]) -> Result<Fit, NotIdentifiable> {
    let n = capacities.len();
    spread(capacities)?;
    let logs: Vec<f64> = capacities.iter().map(|c| c.ln()).collect();
    let mean = logs.iter().sum::<f64>() / n as f64;
    let square: f64 = logs.iter().map(|l| (l - mean).powi(2)).sum();
    let dispersion = (square / (n - 1) as f64).sqrt();
    let likelihood = n as f64 * dispersion.ln() + 0.5 * square / dispersion.powi(2);
    Ok(Fit {
        curve: Lognormal {
            median: mean.exp(),
            dispersion,
        },
        n,
        negative_log_likelihood: likelihood,
    })
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

/// The curve with the largest likelihood where `censored` runs had not reached the state at `im_max`.
///
/// Errors: data that do not identify one.
pub fn fit_truncated(capacities: &[f64], im_max: f64, censored: usize) -> Result<Fit, NotIdentifiable> {
    spread(capacities).map_err(|mut refusal| {
        if capacities.is_empty() && censored > 0 {
            refusal.bounds = [Some(im_max), None];
        }
        refusal
    })?;
    let logs: Vec<f64> = capacities.iter().map(|c| c.ln()).collect();
    let (n, censored_runs, end) = (logs.len() as f64, censored as f64, im_max.ln());
    let mean = logs.iter().sum::<f64>() / n;
    let deviation = (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / n).sqrt();
    let likelihood = |[delta, gamma]: [f64; 2]| -> Local {
        if gamma <= 0.0 {
            return (f64::NEG_INFINITY, [0.0; 2], [0.0; 3]);
        }
        let residuals = logs.iter().map(|l| gamma * l - delta);
        let (mut sum, mut square, mut product) = (0.0, 0.0, 0.0);
        for (residual, log) in residuals.zip(&logs) {
            sum += residual;
            square += residual * residual;
            product += residual * log;
        }
        let logs_square: f64 = logs.iter().map(|l| l * l).sum();
        let logs_sum: f64 = logs.iter().sum();
        let u = delta - gamma * end;
        let (slope, tail) = (hazard(u), ln_cdf(u));
        let curvature = -slope * (slope + u);
        let value = n * gamma.ln() - 0.5 * square + censored_runs * tail;
        let gradient = [
            sum + censored_runs * slope,
            n / gamma - product - censored_runs * slope * end,
        ];
        let hessian = [
            -n + censored_runs * curvature,
            logs_sum - censored_runs * curvature * end,
            -n / gamma.powi(2) - logs_square + censored_runs * curvature * end * end,
        ];
        (value, gradient, hessian)
    };
    let start = [mean / deviation, 1.0 / deviation];
    let found = newton::maximum(start, likelihood)
        .filter(|f| f[1] > 0.0)
        .ok_or_else(|| NotIdentifiable::because("the likelihood has no maximum that was found"))?;
    Ok(Fit {
        curve: Lognormal {
            median: (found[0] / found[1]).exp(),
            dispersion: 1.0 / found[1],
        },
        n: logs.len() + censored,
        negative_log_likelihood: -likelihood(found).0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAPACITIES: [f64; 10] = [0.31, 0.38, 0.42, 0.47, 0.55, 0.58, 0.66, 0.74, 0.9, 1.1];

    /// Computed outside this program: 0.569468, 0.394104.
    #[test]
    fn ten_capacities() {
        let found = fit(&CAPACITIES).unwrap().curve;
        assert!((found.median - 0.569_468).abs() < 1e-6);
        assert!((found.dispersion - 0.394_104).abs() < 1e-6);
    }

    /// Without censored runs the maximum is known in closed form: the mean of the logarithms and their deviation with n.
    #[test]
    fn nothing_censored_is_the_closed_form() {
        let (free, whole) = (
            fit_truncated(&CAPACITIES, 2.0, 0).unwrap().curve,
            fit(&CAPACITIES).unwrap().curve,
        );
        assert!((free.median / whole.median - 1.0).abs() < 1e-10);
        assert!((free.dispersion / whole.dispersion - (9.0_f64 / 10.0).sqrt()).abs() < 1e-10);
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
        let least = negative(found.curve.median, found.curve.dispersion);
        assert!((least - found.negative_log_likelihood).abs() < 1e-9);
        for i in -30..=30 {
            for k in -30..=30 {
                let place = |x: f64, i: i32| x * (1.0 + 0.01 * f64::from(i));
                assert!(negative(place(found.curve.median, i), place(found.curve.dispersion, k)) >= least - 1e-9);
            }
        }
        // The runs that never reached the state raise the median.
        assert!(found.curve.median > fit(seen).unwrap().curve.median);
    }

    #[test]
    fn refusals() {
        assert!(fit(&[]).is_err() && fit(&[0.4]).is_err() && fit(&[0.4, 0.4]).is_err());
        assert_eq!(fit_truncated(&[], 0.7, 3).unwrap_err().bounds, [Some(0.7), None]);
    }
}
