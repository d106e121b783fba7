//! The design spectrum S_d(T) of EN 1998-1:2004 3.2.2.5 beside S_e(T, ξ)/q, for the impulsive part.
//!
//! ```text
//! 0 ≤ T ≤ T_B    S_d = a_g S [2/3 + T/T_B (2.5/q − 2/3)]
//! T_B…T_C        S_d = a_g S 2.5/q
//! T_C…T_D        S_d = a_g S 2.5/q T_C/T          ≥ β a_g
//! T_D…           S_d = a_g S 2.5/q T_C T_D/T²     ≥ β a_g        β = 0.2
//! ```
//!
//! S_d belongs to 5 % damping, whatever the structure's; EN 1998-4 lets the impulsive part have its own. Both are printed and the
//! larger one acts: S_d where the damping is above 5 % or the period so long that β a_g counts. For a table the branches are not known:
//! S_d = max(S_t(T, 5 %)/q, β a_g), which is not below the branches because q ≤ 1.5.

use super::spectrum::{Branch, ElasticSpectrum};
use super::tabulated::Tabulated;
use crate::sheet::{Sheet, number};
use tank::units::Dimension::{Acceleration, Dimensionless, Time};

/// Clause of the design spectrum.
pub(super) const CLAUSE: &str = "EN 1998-1:2004 3.2.2.5";

/// Lower bound factor β, recommended value.
const BETA: f64 = 0.2;

/// Line `symbol` of S_d [m/s²] for a period [s] and a behaviour factor.
pub(super) fn line(sheet: &mut Sheet, s: &ElasticSpectrum, symbol: &str, period: f64, q: f64) -> f64 {
    let (formula, piece) = match s.continued(period, 0.05).1 {
        Branch::Rising => ("a_g·S·(2/3 + T/T_B·(2.5/q - 2/3))", "T ≤ T_B"),
        Branch::Plateau => ("a_g·S·2.5/q", "T_B ≤ T ≤ T_C"),
        Branch::ConstantVelocity => ("max(a_g·S·2.5/q·T_C/T, β·a_g)", "T_C ≤ T ≤ T_D"),
        Branch::ConstantDisplacement | Branch::AnnexA | Branch::Continued => {
            ("max(a_g·S·2.5/q·T_C·T_D/T², β·a_g)", "T ≥ T_D")
        }
    };
    sheet.given(&[
        ("a_g", s.ag, Acceleration),
        ("S", s.soil, Dimensionless),
        ("T_B", s.corners[0], Time),
        ("T_C", s.corners[1], Time),
        ("T_D", s.corners[2], Time),
        ("T", period, Time),
        ("q", q, Dimensionless),
        ("β", BETA, Dimensionless),
    ]);
    let name = format!("impulsive part by the design spectrum (5 % damping), {piece}");
    sheet.calc(symbol, &name, formula, Acceleration, CLAUSE)
}

/// Line `symbol` of S_d [m/s²] of a table.
pub(super) fn table_line(sheet: &mut Sheet, s: &Tabulated, symbol: &str, period: f64) -> f64 {
    sheet.given(&[("S_5", s.horizontal(period, 0.05), Acceleration), ("β", BETA, Dimensionless)]);
    let name = "impulsive part by the design spectrum, S_5: the user's spectrum at 5 % damping";
    sheet.calc(symbol, name, "max(S_5/q, β·a_g)", Acceleration, CLAUSE)
}

/// Line of the larger one of S_e/q and S_d [m/s²]; names it.
///
/// * `damping`: of S_e
pub(super) fn governing(sheet: &mut Sheet, elastic: f64, design: f64, damping: f64) -> f64 {
    // Where both are the same, as at 5 % damping, rounding must not name the one or the other.
    let which = if design > elastic * (1.0 + 1e-9) {
        "S_d governs".to_string()
    } else {
        format!("S_e/q at ξ = {} % governs", number(100.0 * damping))
    };
    let name = format!("impulsive acceleration, larger of S_i = S_e/q and S_d: {which}");
    sheet.given(&[("S_i", elastic, Acceleration), ("S_d", design, Acceleration)]);
    sheet.calc("A_i", &name, "max(S_i, S_d)", Acceleration, CLAUSE)
}
