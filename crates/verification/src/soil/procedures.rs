//! Soil-structure interaction in the codes, formulas only.

use ::soil::structure::OnSoil;

/// EN 1998-4:2006 A.7: period of the impulsive mode with factors α of the impedance at its frequency [s].
///
/// ```text
/// T* = T √(1 + k/(K_x α_x) (1 + K_x α_x h²/(K_θ α_θ)))
/// ```
///
/// With α = 1 it is the static period of Veletsos & Meek.
pub(crate) fn eurocode_period(on: &OnSoil, [alpha_x, alpha_theta]: [f64; 2]) -> f64 {
    let s = on.disc.stiffness();
    let (k, h) = (on.structure.stiffness(), on.structure.height);
    let (kx, kt) = (s.horizontal * alpha_x, s.rocking * alpha_theta);
    on.structure.period * (1.0 + k / kx * (1.0 + kx * h * h / kt)).sqrt()
}

/// EN 1998-4:2006 A.7: vertical period T_v √(1 + k_l/(α_v K_v)) [s].
///
/// * `period`: T_v of the breathing of the wall under vertical motion [s]
/// * `stiffness`: k_l = 4π² m_l/T_v² [N/m]
pub(crate) fn eurocode_vertical_period(period: f64, stiffness: f64, alpha_v: f64, soil: f64) -> f64 {
    period * (1.0 + stiffness / (alpha_v * soil)).sqrt()
}

/// ASCE 7-10 chapter 19: effective damping β̃ = β₀ + 0.05/(T̃/T)³, not below 0.05, not above 0.20.
///
/// * `foundation`: foundation damping factor β₀, read from figure 19.2-1
pub(crate) fn asce_damping(foundation: f64, ratio: f64) -> f64 {
    (foundation + 0.05 / ratio.powi(3)).clamp(0.05, 0.20)
}

/// ASCE 7-10 chapter 19: reduction of the base shear over the effective weight, C_s − C̃_s (0.05/β̃)^0.4, from 0 to 0.3 C_s.
///
/// * `fixed`, `flexible`: C_s at T, C̃_s at T̃
pub(crate) fn asce_reduction(fixed: f64, flexible: f64, damping: f64) -> f64 {
    (fixed - flexible * (0.05 / damping).powf(0.4)).clamp(0.0, 0.3 * fixed)
}
