//! Options of the frequency domain.

use crate::keys::{As, Opt, Or, Pitch, Whole, keys};
use crate::words;

words! {
    /// Damping of transfer functions.
    pub FrequencyDamping {
        /// Viscous, with the ratios of the time history.
        AsEngine = "as_engine",
        /// Hysteretic with the same ratios: a loss factor of twice the ratio at every frequency.
        Hysteretic = "hysteretic",
    }
}

keys! {
    /// Transfer functions of a linear engine: wave, base shear and overturning moment per unit of harmonic horizontal acceleration.
    pub FrequencyOptions as Frequency (Copy) {
        /// Lowest frequency.
        from ("0.05 Hz"): Opt<Pitch> = Absent::Follows("a fifth of the first sloshing frequency"),
        /// Highest frequency.
        to ("50 Hz"): Opt<Pitch> = Absent::Follows("twice the frequency of the impulsive mode"),
        /// Number of frequencies with equal ratios; those around the peaks of the modes are added.
        points (1000): As<Or<Whole>, usize> [Limits::count(2, 20_000)] = default(Whole(FrequencyOptions::DEFAULT.points as u32)),
        /// Damping.
        damping: Or<FrequencyDamping> = default(FrequencyOptions::DEFAULT.damping),
    }
}

impl FrequencyOptions {
    /// The defaults.
    pub const DEFAULT: FrequencyOptions =
        FrequencyOptions { from: None, to: None, points: 400, damping: FrequencyDamping::AsEngine };
}
