//! Scatter of θ and β by resampling runs (Efron 1979).
//!
//! The same seed gives the same bands everywhere ([`Draw`]).

use serde::{Deserialize, Serialize};

use crate::draw::Draw;
use crate::stripes::Stripe;
use crate::{Lognormal, NotIdentifiable};

/// Percentiles of a resampled value: 5, 50, 95 %.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// 5 %.
    pub low: f64,
    /// 50 %.
    pub middle: f64,
    /// 95 %.
    pub high: f64,
}

/// Scatter of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scatter {
    /// Scatter of the median.
    pub median: Band,
    /// Scatter of the dispersion.
    pub dispersion: Band,
    /// Resamples.
    pub resamples: usize,
    /// Those that identified no curve; the bands are of the others.
    pub not_identified: usize,
}

/// The curves of `resamples` samples, in the order in which they are drawn; samples that identify none are left out.
///
/// * `sample`: the curve of a sample that it draws
pub fn curves(
    resamples: usize,
    seed: u64,
    sample: impl Fn(&mut Draw) -> Result<Lognormal, NotIdentifiable>,
) -> Vec<Lognormal> {
    let mut draw = Draw::new(seed);
    (0..resamples).filter_map(|_| sample(&mut draw).ok()).collect()
}

/// Scatter of `resamples` curves; none if fewer than half of the samples identify one.
///
/// * `sample`: the curve of a sample that it draws
pub fn scatter(
    resamples: usize,
    seed: u64,
    sample: impl Fn(&mut Draw) -> Result<Lognormal, NotIdentifiable>,
) -> Option<Scatter> {
    summary(&curves(resamples, seed, sample), resamples)
}

/// Scatter of the curves that `resamples` samples identified; none of fewer than half of them.
pub fn summary(found: &[Lognormal], resamples: usize) -> Option<Scatter> {
    if found.is_empty() || 2 * found.len() < resamples {
        return None;
    }
    Some(Scatter {
        median: band(found.iter().map(|c| c.median).collect()),
        dispersion: band(found.iter().map(|c| c.dispersion).collect()),
        resamples,
        not_identified: resamples - found.len(),
    })
}

/// Percentiles of the probability at an intensity over curves; none without curves.
pub fn envelope(found: &[Lognormal], im: f64) -> Option<Band> {
    (!found.is_empty()).then(|| band(found.iter().map(|c| c.probability(im)).collect()))
}

/// Items of a list with replacement, as many as there are.
pub fn resampled<T: Clone>(items: &[T], draw: &mut Draw) -> Vec<T> {
    items.iter().map(|_| items[draw.below(items.len())].clone()).collect()
}

/// Stripes whose runs are drawn with replacement: within each stripe, or whole stripes where each has one run.
pub fn resampled_stripes(stripes: &[Stripe], draw: &mut Draw) -> Vec<Stripe> {
    if stripes.iter().all(|s| s.n <= 1.0) {
        return resampled(stripes, draw);
    }
    let drawn = |s: &Stripe, draw: &mut Draw| {
        let n = s.n.round() as usize;
        let hits = (0..n).filter(|_| (draw.below(n) as f64) < s.exceed).count();
        Stripe { exceed: hits as f64, ..*s }
    };
    stripes.iter().map(|s| drawn(s, draw)).collect()
}

fn band(mut values: Vec<f64>) -> Band {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let place = share * (values.len() - 1) as f64;
        let (low, high) = (values[place.floor() as usize], values[place.ceil() as usize]);
        low + (high - low) * place.fract()
    };
    Band { low: at(0.05), middle: at(0.5), high: at(0.95) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The band of the probability at an intensity is that of the medians, seen through Φ, if curves differ in the median alone.
    #[test]
    fn the_band_of_the_probability_is_that_of_the_medians() {
        let curve = |k: i32| Lognormal { median: (0.01 * f64::from(k)).exp(), dispersion: 0.4 };
        let found: Vec<Lognormal> = (0..=100).map(curve).collect();
        let at = envelope(&found, 1.5).unwrap();
        // A larger median is a smaller probability: the 5 % percentile of P has the 95 % percentile of the median, exp 0.95.
        let wanted = |log: f64| crate::normal::cdf((1.5_f64.ln() - log) / 0.4);
        assert!((at.low - wanted(0.95)).abs() < 1e-12 && (at.high - wanted(0.05)).abs() < 1e-12);
        assert!((at.middle - wanted(0.5)).abs() < 1e-12);
        assert_eq!(envelope(&[], 1.0), None);
        // Half of 202 samples identified a curve, and fewer than half of 203.
        assert_eq!(summary(&found, 202).unwrap().not_identified, 101);
        assert_eq!(summary(&found, 203), None);
    }

    /// The mean of n logarithms has the standard error s/√n: the band of ln θ, 3.29 of them wide, within a tenth for 2000 resamples.
    #[test]
    fn the_band_of_the_median_is_that_of_a_mean() {
        let capacities: Vec<f64> = (1..=40).map(|k| 0.2 + 0.03 * f64::from(k)).collect();
        let sample = |draw: &mut Draw| crate::capacities::fit(&resampled(&capacities, draw)).map(|f| f.curve);
        let found = scatter(2000, 7, sample).unwrap();
        let whole = crate::capacities::fit(&capacities).unwrap().curve;
        let width = (found.median.high / found.median.low).ln();
        let expected = 2.0 * 1.645 * whole.dispersion / 40.0_f64.sqrt();
        assert!((width / expected - 1.0).abs() < 0.1, "{width} {expected}");
    }
}
