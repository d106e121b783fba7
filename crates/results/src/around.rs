//! Response of an imperfect wall by waves around the tank.

use serde::{Deserialize, Serialize};

use crate::fields::WallMap;

/// An imperfect wall and what it answers, wave by wave: a perfect one answers horizontal motion in n = 1 and vertical motion in n = 0
/// alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Around {
    /// Largest deviation from the perfect cylinder [m], outwards positive.
    pub deviation: f64,
    /// Over the thickness of the wall there.
    pub over_thickness: f64,
    /// Its angle [rad].
    pub theta: f64,
    /// Its height [m].
    pub z: f64,
    /// The deviations [m].
    pub map: WallMap,
    /// Waves by ascending n.
    pub waves: Vec<WaveAround>,
    /// Around the base; none of an engine that does not give it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<BaseAround>,
}

impl Around {
    /// Largest displacement of the waves n ≥ 2 [m], with n.
    pub fn largest_beyond(&self) -> Option<(f64, u32)> {
        let beyond = self.waves.iter().filter(|w| w.n >= 2).map(|w| (w.displacement, w.n));
        beyond.reduce(|a, b| if b.0 > a.0 { b } else { a })
    }
}

/// A harmonic of the response: cos nθ, and sin nθ where the imperfections are not symmetric about the plane of shaking.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WaveAround {
    /// Number of waves n.
    pub n: u32,
    /// Its largest amplitude in the deviations over the height [m].
    pub deviation: f64,
    /// Largest amplitude of the radial displacement over height and time [m].
    pub displacement: f64,
    /// Height of that [m].
    pub z: f64,
    /// Its time [s].
    pub time: f64,
    /// Largest amplitude of the axial membrane stress at the base [Pa]; none of an engine that does not give it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stress: Option<f64>,
}

/// Seismic axial membrane stress around the base.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BaseAround {
    /// Angles [rad], ascending.
    pub theta: Vec<f64>,
    /// Smallest value over time [Pa].
    pub min: Vec<f64>,
    /// Largest value over time [Pa].
    pub max: Vec<f64>,
}

impl BaseAround {
    /// Largest absolute value [Pa], with its angle [rad].
    pub fn largest(&self) -> (f64, f64) {
        let values = self.min.iter().zip(&self.max).map(|(low, high)| high.max(-low));
        let pairs = values.zip(self.theta.iter().copied());
        pairs.fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
    }
}
