//! Fragility curves from data, and the risk that follows from a hazard curve.
//!
//! ```text
//! P(damage | im) = Φ(ln(im/θ)/β)          θ median, β dispersion
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`curve`] | the lognormal curve |
//! | [`stripes`] | counts at intensities, by maximum likelihood (Baker 2015) |
//! | [`capacities`] | intensities at which runs reach the state, all or some of them |
//! | [`cloud`] | demands against intensities by regression, collapses apart |
//! | [`common`] | curves of several states that cross |
//! | [`beta`] | the beta distribution of sampled parameters |
//! | [`draw`] | random numbers |
//! | [`bootstrap`] | scatter of θ and β by resampling |
//! | [`risk`] | annual rate and probability in 50 years |
//! | [`farm`] | several tanks in the same earthquakes |
//! | [`export`] | files for other programs |
//!
//! Data that do not identify a curve give [`NotIdentifiable`] with the reason, and bounds of the median where there are any: no curve is
//! drawn through nothing.

pub mod beta;
pub mod bootstrap;
pub mod capacities;
pub mod cloud;
pub mod common;
pub mod curve;
pub mod draw;
pub mod export;
pub mod farm;
mod newton;
pub mod normal;
pub mod risk;
pub mod stripes;

pub use curve::Lognormal;

use serde::{Deserialize, Serialize};

/// Why data do not identify a curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotIdentifiable {
    /// Reason, one sentence without a full stop.
    pub reason: String,
    /// Bounds of the median, where the data give them: below the first no run reached the state, above the second all did.
    pub bounds: [Option<f64>; 2],
}

impl NotIdentifiable {
    /// Without bounds.
    pub fn because(reason: impl Into<String>) -> NotIdentifiable {
        NotIdentifiable { reason: reason.into(), bounds: [None, None] }
    }
}

/// A curve with the number of data behind it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// The curve.
    pub curve: Lognormal,
    /// Number of runs.
    pub n: usize,
    /// Negative logarithm of the likelihood, without constants of the data.
    pub negative_log_likelihood: f64,
}
