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
    /// Of the median.
    pub median: Band,
    /// Of the dispersion.
    pub dispersion: Band,
    /// Resamples.
    pub resamples: usize,
    /// Those that identified no curve; the bands are of the others.
    pub not_identified: usize,
}

/// Scatter of `resamples` curves; none if fewer than half of the samples identify one.
///
/// * `sample`: the curve of a sample that it draws
pub fn scatter(
    resamples: usize,
    seed: u64,
    sample: impl Fn(&mut Draw) -> Result<Lognormal, NotIdentifiable>,
) -> Option<Scatter> {
    let mut draw = Draw::new(seed);
    let found: Vec<Lognormal> = (0..resamples).filter_map(|_| sample(&mut draw).ok()).collect();
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
        Stripe {
            exceed: hits as f64,
            ..*s
        }
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
    Band {
        low: at(0.05),
        middle: at(0.5),
        high: at(0.95),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
