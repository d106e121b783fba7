//! Transfer functions: the steady state under harmonic horizontal motion of the ground.

use serde::{Deserialize, Serialize};
use tank::options::frequency::FrequencyDamping;

/// Amplitudes per unit of ground acceleration a(t) = cos Ωt: y(t) = |H| cos(Ωt + φ).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Transfer {
    /// Damping.
    pub damping: FrequencyDamping,
    /// Frequencies Ω/2π [Hz], ascending.
    pub frequency: Vec<f64>,
    /// Modes of the engine.
    pub modes: Vec<TransferMode>,
    /// Wave, base shear and overturning moment.
    pub functions: Vec<TransferFunction>,
}

/// A mode of the engine that the transfer functions contain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TransferMode {
    /// Kind: `sloshing`, `structural`, `rotational`.
    pub kind: String,
    /// Number within its kind, from 1.
    pub number: usize,
    /// Frequency [Hz].
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
}

/// One transfer function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TransferFunction {
    /// Id, the beginning of its columns: `wave_height`, `base_shear`, `overturning_moment`.
    pub id: String,
    /// Title.
    pub title: String,
    /// Unit in words for the heads of columns: `m_per_m_s2`, `n_per_m_s2`, `nm_per_m_s2`.
    pub unit: String,
    /// Quasi-static response, Ω → 0, with its sign [unit].
    pub static_value: f64,
    /// |H| [unit].
    pub magnitude: Vec<f64>,
    /// φ [rad], −π to π.
    pub phase: Vec<f64>,
}

/// The table of transfer functions: frequency, then magnitude and phase of each function, 7 significant digits.
pub(crate) fn csv(transfer: &Transfer) -> String {
    use std::fmt::Write;
    let mut text = String::from("frequency_hz");
    for f in &transfer.functions {
        let _ = write!(text, ",{}_magnitude_{},{}_phase_rad", f.id, f.unit, f.id);
    }
    text.push('\n');
    for (i, frequency) in transfer.frequency.iter().enumerate() {
        let _ = write!(text, "{frequency:.8e}");
        for f in &transfer.functions {
            let _ = write!(text, ",{:.6e},{:.6e}", f.magnitude[i], f.phase[i]);
        }
        text.push('\n');
    }
    text
}
