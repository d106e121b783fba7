//! Transfer functions.

use tank::options::frequency::FrequencyDamping;

use crate::number::significant;

/// Title of the horizontal axis.
pub const FREQUENCY: &str = "Frequency";
/// Beginning of the title of the vertical axis; the quantity follows.
pub const RATIO: &str = "over its quasi-static value";

/// Unit of a transfer function, by its words in the table.
pub fn unit(id: &str) -> &'static str {
    match id {
        "m_per_m_s2" => "m per m/s²",
        "n_per_m_s2" => "N per m/s²",
        _ => "N·m per m/s²",
    }
}

/// A mode at its vertical line.
pub fn mode(sloshing: bool, number: usize) -> String {
    format!("f_{}{number}", if sloshing { 'c' } else { 'i' })
}

/// Damping of an engine's transfer functions.
pub fn damping(damping: FrequencyDamping) -> &'static str {
    match damping {
        FrequencyDamping::AsEngine => "viscous damping with the ratios of the time history",
        FrequencyDamping::Hysteretic => "hysteretic damping with the ratios of the time history",
    }
}

/// Caption: quasi-static value with its unit, damping.
pub fn caption(at_rest: f64, unit: &str, damping: &str) -> String {
    format!(
        "Quasi-static value {} {unit}; {damping}.",
        significant(at_rest.abs(), 4)
    )
}

/// Description: largest amplification and its frequency [Hz], within a range [Hz].
pub fn description(title: &str, largest: (f64, f64), range: (f64, f64)) -> String {
    format!(
        "{title} over its quasi-static value from {} to {} Hz on logarithmic axes; the largest is {} at {} Hz.",
        significant(range.0, 3),
        significant(range.1, 3),
        significant(largest.0, 4),
        significant(largest.1, 4)
    )
}
