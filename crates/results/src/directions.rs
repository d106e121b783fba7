//! Response to two horizontal components of the ground motion at the same time.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// A quantity along x, along y, and in the direction in which both together are largest; without its static value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Directional {
    /// Id of the quantity (`base_shear`, `wave_height`, `hoop_stress`, …).
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Height above the base, of a quantity of the wall [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Largest absolute value under the component along x alone, at θ = 0 or 180°; with the vertical motion, if there is one.
    pub x: f64,
    /// The same along y, at θ = 90° or 270°.
    pub y: f64,
    /// Largest absolute value over time and circumference of both together.
    pub resultant: f64,
    /// Its time [s].
    pub time: f64,
    /// Its direction [rad], from 0 to 2 π.
    pub theta: f64,
}

impl Directional {
    /// The estimate of codes from the largest values of the components, √(x² + y²).
    pub fn srss(&self) -> f64 {
        self.x.hypot(self.y)
    }
}
