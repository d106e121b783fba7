//! Ground motion: a uniformly sampled acceleration record.

use serde::{Deserialize, Serialize};

/// Ground acceleration at a uniform step, as used in the analysis (after scaling, stretching and resampling).
///
/// The acceleration is linear between samples, and zero before the first and after the last one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Name (file stem unless the format carries one).
    pub name: String,
    /// Time step Δt [s].
    pub dt: f64,
    /// Ground acceleration a_g [m/s²].
    pub acceleration: Vec<f64>,
    /// What was done to the file's numbers, in order, in words for the report ("scaled to 0.5 g (factor 1.4368)").
    pub processing: Vec<String>,
}

impl Record {
    /// Largest absolute acceleration [m/s²].
    pub fn pga(&self) -> f64 {
        self.acceleration.iter().fold(0.0, |m, a| a.abs().max(m))
    }

    /// Time of the last sample [s].
    pub fn duration(&self) -> f64 {
        self.dt * (self.acceleration.len().saturating_sub(1)) as f64
    }
}
