//! Soil-structure interaction of a cylinder on a slab, for information.
//!
//! ```text
//! T_e = T_i √(1 + k/(α_x K_x) (1 + α_x K_x h²/(α_θ K_θ)))            α at T_e
//! ξ    = ξ_s + ξ_i/(T_e/T_i)³        ξ_s = ½ m (2π/T_e)² (β_x/(α_x² K_x) + β_θ h²/(α_θ² K_θ))
//! ```
//!
//! α + i β: impedance over static stiffness. The squares of β are left out in ξ_s, which is therefore high for soft soil: the complex
//! stiffness stands beside it.
//!
//! Source: EN 1998-4:2006 A.7, recalled.

use super::demand::Edition;
use super::work::{Masses, Work};
use crate::slab::{self, MOST_DAMPING};
use tank::units::Dimension::*;

/// Rounds for α at the period; each is a contraction by less than a half.
const ROUNDS: usize = 60;

/// Lines of period, damping and spectral acceleration.
pub(super) fn assess(work: &mut Work, masses: &Masses, period: f64) {
    let case = work.case;
    if work.edition != Edition::En2006 || !slab::is_on_soil(case) {
        return;
    }
    let clause = work.edition.clause("7");
    if !slab::is_anchored(case) {
        work.out.notes.push(format!(
            "{clause}: period and damping of the slab on the soil are left out, the tank is not anchored."
        ));
        return;
    }
    let tank = &case.tank;
    let impulsive = masses.impulsive;
    let parts = [
        [impulsive.mass, impulsive.lever_with_base],
        [tank.wall_mass(), tank.wall_centroid()],
        [tank.roof.mass, tank.roof_height()],
    ];
    let Some(slab) = slab::lines(&mut work.sheet, case, parts, period, &clause) else { return };
    let structure = slab.on.structure;
    let flexible = |[[x, _], [theta, _]]: [[f64; 2]; 2]| {
        let [k_x, k_theta] = slab.ground;
        period * (1.0 + slab.k / (x * k_x) + slab.k * structure.height.powi(2) / (theta * k_theta)).sqrt()
    };
    let mut found = slab.period;
    for _ in 0..ROUNDS {
        found = 0.5 * (found + flexible(slab.factors(found)));
    }
    let [[a_x, b_x], [a_theta, b_theta]] = slab.factors(found);
    work.sheet.given(&[("T_i", period, Time)]);
    let source = "impedance of a rigid disc (Veletsos and Verbic) over its static stiffness, iterated at T_e";
    for (symbol, name, value) in [
        ("α_x", "translation, real part", a_x),
        ("β_x", "translation, imaginary part", b_x),
        ("α_θ", "rocking, real part", a_theta),
        ("β_θ", "rocking, imaginary part", b_theta),
    ] {
        work.sheet.look_up(symbol, name, source, value, Dimensionless, &clause);
    }
    let mut line = |symbol, name, formula, dimension| work.sheet.calc(symbol, name, formula, dimension, &clause);
    let formula = "T_i·√(1 + k_e/(α_x·K_x)·(1 + α_x·K_x·h_e²/(α_θ·K_θ)))";
    let period = line("T_e", "impulsive period on the soil", formula, Time);
    let formula = "m_e/2·(2·π/T_e)²·(β_x/(α_x²·K_x) + β_θ·h_e²/(α_θ²·K_θ))";
    line("ξ_s", "damping ratio by radiation into the soil", formula, Dimensionless);
    let formula = "ξ_s + ξ_i/(T_e/T_i)³";
    let damping = line("ξ_e", "damping ratio on the soil", formula, Dimensionless);
    if let Some(effective) = slab.effective() {
        let source = "complex stiffness of wall and soil with the same impedance, Re S(ω) = m_e·ω²";
        for (symbol, name, value, dimension) in [
            ("T_ec", "the same period without leaving out squares of β", effective.period, Time),
            ("ξ_ec", "the same damping ratio", effective.damping, Dimensionless),
        ] {
            work.sheet.look_up(symbol, name, source, value, dimension, "Veletsos & Meek 1974");
        }
        let used = damping.min(effective.damping).min(MOST_DAMPING);
        work.demand.impulsive(&mut work.sheet, &mut work.out.notes, "S_e(T_e)", period, used);
    }
    work.out.notes.push(format!(
        "{clause}: period and damping of the impulsive mode on the soil are for information; forces and checks of this sheet are those of a \
         fixed base. S_e(T_e) has the lesser of both damping ratios, at most {MOST_DAMPING}."
    ));
}

#[cfg(test)]
mod tests;
