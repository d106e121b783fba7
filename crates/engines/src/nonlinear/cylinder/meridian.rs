//! Stresses of a meridian of cells over a run.

use serde::{Deserialize, Serialize};

/// Smallest and largest value with their times.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Extremes {
    /// In the static state.
    pub rest: f64,
    /// Smallest.
    pub min: f64,
    /// Its time [s].
    pub min_time: f64,
    /// Largest.
    pub max: f64,
    /// Its time [s].
    pub max_time: f64,
}

impl Extremes {
    pub(super) fn start(value: f64) -> Extremes {
        Extremes { rest: value, min: value, min_time: 0.0, max: value, max_time: 0.0 }
    }

    pub(super) fn include(&mut self, value: f64, time: f64) {
        if value < self.min {
            (self.min, self.min_time) = (value, time);
        }
        if value > self.max {
            (self.max, self.max_time) = (value, time);
        }
    }

    /// Largest distance from the static state, and its time.
    pub(crate) fn swing(&self) -> (f64, f64) {
        let (down, up) = (self.rest - self.min, self.max - self.rest);
        if up >= down { (up, self.max_time) } else { (down, self.min_time) }
    }
}

/// A meridian of cells.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Meridian {
    /// Hoop force over the thickness of the shells, by row [Pa].
    pub hoop: Vec<Extremes>,
    /// Axial force over it [Pa].
    pub axial: Vec<Extremes>,
    /// Hoop stress at the samples, by row [Pa].
    pub hoop_history: Vec<Vec<f64>>,
    /// Axial stress at the samples, by row [Pa].
    pub axial_history: Vec<Vec<f64>>,
    /// Meridional curvature of the lowest cell at the samples [1/m].
    pub curvature: Vec<f64>,
    /// Meridional moment there [N].
    pub moment: Vec<f64>,
    /// Axial force there over the thickness [Pa].
    pub base_axial: Vec<f64>,
}
