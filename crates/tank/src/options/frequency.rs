//! Options of the frequency domain.

use crate::words;
use serde::{Deserialize, Serialize};

words! {
    /// Damping of transfer functions.
    pub FrequencyDamping {
        /// Viscous, with the ratios of the time history.
        AsEngine = "as_engine",
        /// Hysteretic with the same ratios: a loss factor of twice the ratio at every frequency.
        Hysteretic = "hysteretic",
    }
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
