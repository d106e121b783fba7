//! Response-spectrum method.
//!
//! The peak of an observable in mode j under component k is R_jk = (d·φ_j − ω_j² c·φ_j) Γ_jk S_a(ω_j, ξ_j)/ω_j², with its
//! sign. Peaks of modes are combined for **each observable**, never for displacements of which observables are then taken:
//!
//! ```text
//! R_k² = Σ Σ ρ_ij R_ik R_jk + R_rk²
//! ρ_ij = 8 √(ξ_i ξ_j) (ξ_i + r ξ_j) r^{3/2} / [(1 − r²)² + 4 ξ_i ξ_j r (1 + r²) + 4 (ξ_i² + ξ_j²) r²]      r = ω_j/ω_i
//! ```
//!
//! (CQC; SRSS takes ρ_ij = δ_ij; the absolute sum is Σ |R_jk| + |R_rk|.) Modes that are not kept follow the ground: R_rk is their static response to the
//! zero-period acceleration, summed algebraically within a component (missing mass) and by squares with the rest.
//!
//! Source: Der Kiureghian 1981; Wilson, Der Kiureghian & Bayo 1981; missing mass after Kennedy 1984.

use super::AnalysisError;
use super::modal::ModalBasis;
use super::observable::Observable;

/// How peaks of modes are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModalRule {
    /// Square root of the sum of squares.
    Srss,
    /// Complete quadratic combination.
    Cqc,
    /// Sum of absolute values, an upper bound.
    Absolute,
}

/// How components of the ground motion are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectionRule {
    /// Square root of the sum of squares.
    Srss,
    /// The largest of |R_a| + 0.3 |R_b| + 0.3 |R_c| over all orders.
    HundredThirty,
}

/// Correlation of two modes (ω_i, ξ_i), (ω_j, ξ_j) under broad-band ground motion.
///
/// Undamped modes are uncorrelated unless their frequencies are equal.
pub fn correlation(first: (f64, f64), second: (f64, f64)) -> f64 {
    let ((wi, xi), (wj, xj)) = (first, second);
    let r = wj / wi;
    let denominator = (1.0 - r * r).powi(2) + 4.0 * xi * xj * r * (1.0 + r * r) + 4.0 * (xi * xi + xj * xj) * r * r;
    if denominator == 0.0 {
        return 1.0;
    }
    8.0 * (xi * xj).sqrt() * (xi + r * xj) * r.powf(1.5) / denominator
}

/// Signed peaks of modes and the missing mass as one peak.
///
/// * `modes`: (ω_j [rad/s], ξ_j), one for each of `own`
/// * `own`: signed peaks R_j
/// * `rest`: response of the missing mass R_r
pub fn combined(rule: ModalRule, modes: &[(f64, f64)], own: &[f64], rest: f64) -> f64 {
    let paired = || modes.iter().zip(own).enumerate();
    let square: f64 = match rule {
        ModalRule::Absolute => return own.iter().map(|r| r.abs()).sum::<f64>() + rest.abs(),
        ModalRule::Srss => own.iter().map(|r| r * r).sum(),
        ModalRule::Cqc => paired()
            .map(|(i, (first, a))| {
                let with = |(j, (second, b)): (usize, (&(f64, f64), &f64))| match i == j {
                    true => a * b,
                    false => correlation(*first, *second) * a * b,
                };
                paired().map(with).sum::<f64>()
            })
            .sum(),
    };
    // CQC is a covariance; rounding alone can make it negative.
    (square + rest * rest).max(0.0).sqrt()
}

/// Excitation of one component.
pub struct Component<'a> {
    /// Axis (0, 1, 2).
    pub axis: usize,
    /// Pseudo-acceleration S_a(mode, ω, ξ) [m/s²]. The number of the mode allows a separate spectrum for sloshing.
    pub spectrum: &'a dyn Fn(usize, f64, f64) -> f64,
    /// Zero-period acceleration for the missing mass [m/s²].
    pub zero_period: f64,
}

/// Peak of one observable.
#[derive(Clone, Debug, PartialEq)]
pub struct Peak {
    /// All components together.
    pub value: f64,
    /// Each component, in the order given.
    pub components: Vec<f64>,
    /// Signed peak of each mode, component by component.
    pub modes: Vec<Vec<f64>>,
    /// Static response of the missing mass, component by component.
    pub missing: Vec<f64>,
}

/// Peaks of `observables`.
///
/// Errors: a ratio a mode is missing, an axis that does not exist, an observable of velocities, for which spectra of
/// pseudo-acceleration do not apply.
// Long: modal parts, missing mass and components share their arrays.
pub fn peaks(
    basis: &ModalBasis,
    ratios: &[f64],
    components: &[Component<'_>],
    modal: ModalRule,
    direction: DirectionRule,
    observables: &[Observable],
) -> Result<Vec<Peak>, AnalysisError> {
    let refuse = |found: String, allowed: &str| AnalysisError::option("response-spectrum method", found, allowed);
    let m = basis.len();
    if ratios.len() != m {
        return Err(refuse(format!("{} damping ratios", ratios.len()), "one a mode"));
    }
    if let Some(c) = components.iter().find(|c| c.axis > 2) {
        return Err(refuse(format!("axis {}", c.axis), "0, 1, 2"));
    }
    // Peaks of Y_j.
    let coordinates: Vec<Vec<f64>> = components
        .iter()
        .map(|c| {
            (0..m)
                .map(|j| {
                    let w = basis.omega[j];
                    basis.participation[j][c.axis] * (c.spectrum)(j, w, ratios[j]) / (w * w)
                })
                .collect()
        })
        .collect();
    let keys: Vec<(f64, f64)> = basis.omega.iter().copied().zip(ratios.iter().copied()).collect();
    let peak = |observable: &Observable| {
        if !observable.velocity.is_empty() {
            return Err(refuse(format!("velocities in “{}”", observable.name), "displacements and accelerations"));
        }
        let p = basis.project(observable);
        let (mut totals, mut modes, mut missing) = (Vec::new(), Vec::new(), Vec::new());
        for (c, y) in components.iter().zip(&coordinates) {
            let own: Vec<f64> =
                (0..m).map(|j| (p.displacement[j] - basis.omega[j].powi(2) * p.acceleration[j]) * y[j]).collect();
            let followed: f64 = (0..m).map(|j| p.acceleration[j] * basis.participation[j][c.axis]).sum();
            let rest = (p.ground[c.axis] - followed) * c.zero_period;
            totals.push(combined(modal, &keys, &own, rest));
            modes.push(own);
            missing.push(rest);
        }
        let value = match direction {
            DirectionRule::Srss => totals.iter().map(|t| t * t).sum::<f64>().sqrt(),
            DirectionRule::HundredThirty => {
                let sum: f64 = totals.iter().sum();
                totals.iter().map(|t| 0.3 * sum + 0.7 * t).fold(0.0, f64::max)
            }
        };
        Ok(Peak { value, components: totals, modes, missing })
    };
    observables.iter().map(peak).collect()
}
