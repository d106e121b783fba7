//! Options of the frequency domain.

use serde::{Deserialize, Serialize};

/// Damping of transfer functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FrequencyDamping {
    /// Viscous, with the ratios of the time history.
    AsEngine,
    /// Hysteretic, of the same ratios: the loss factor 2 ξ at every frequency.
    Hysteretic,
}

/// Options of transfer functions under harmonic base motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FrequencyOptions {
    /// Lowest circular frequency [rad/s]; none: around the modes.
    pub from: Option<f64>,
    /// Highest circular frequency [rad/s]; none: around the modes.
    pub to: Option<f64>,
    /// Frequencies with equal ratios; those at peaks are added.
    pub points: usize,
    /// Damping.
    pub damping: FrequencyDamping,
}

impl FrequencyOptions {
    /// The defaults.
    pub const DEFAULT: FrequencyOptions = FrequencyOptions {
        from: None,
        to: None,
        points: 400,
        damping: FrequencyDamping::AsEngine,
    };
}
