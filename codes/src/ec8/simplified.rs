//! Simplified procedure of EN 1998-4:2006 A.3.2.2 for fixed-base cylinders (Malhotra, Wenk and Wieland 2000).
//!
//! ```text
//! T_imp = C_i √ρ H/(√(s/R) √E)      T_con = C_c √R
//! Q  = (m_i + m_w + m_r) S_e(T_imp) + m_c S_e(T_con)
//! M  = (m_i h_i  + m_w h_w + m_r h_r) S_e(T_imp) + m_c h_c  S_e(T_con)      just above the base plate
//! M′ = (m_i h_i′ + m_w h_w + m_r h_r) S_e(T_imp) + m_c h_c′ S_e(T_con)      below it
//! ```
//!
//! s is the wetted wall's thickness averaged with the distance from the liquid surface as weight. In the table, m_i and
//! h_i′ are those of a rigid tank, m_c = m − m_i lumps all sloshing modes, h_i is raised for the flexible wall above H/R = 0.7.

use crate::sheet::{Sheet, Term};
use tank::Tank;
use tank::units::Dimension::Length;

/// Smallest and largest H/R of table A.2.
pub const LIMITS: (f64, f64) = (0.3, 3.0);

/// A row of table A.2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Impulsive period coefficient C_i [-].
    pub impulsive_period: f64,
    /// Convective period coefficient C_c [s/√m].
    pub convective_period: f64,
    /// m_i/m.
    pub impulsive_mass: f64,
    /// m_c/m.
    pub convective_mass: f64,
    /// h_i/H.
    pub impulsive_lever: f64,
    /// h_c/H.
    pub convective_lever: f64,
    /// h_i′/H.
    pub impulsive_lever_with_base: f64,
    /// h_c′/H.
    pub convective_lever_with_base: f64,
}

/// Table A.2: H/R, C_i, C_c, m_i/m, m_c/m, h_i/H, h_c/H, h_i′/H, h_c′/H.
const TABLE: [[f64; 9]; 8] = [
    [0.3, 9.28, 2.09, 0.176, 0.824, 0.400, 0.521, 2.640, 3.414],
    [0.5, 7.74, 1.74, 0.300, 0.700, 0.400, 0.543, 1.460, 1.517],
    [0.7, 6.97, 1.60, 0.414, 0.586, 0.401, 0.571, 1.009, 1.011],
    [1.0, 6.36, 1.52, 0.548, 0.452, 0.419, 0.616, 0.721, 0.785],
    [1.5, 6.06, 1.48, 0.686, 0.314, 0.439, 0.690, 0.555, 0.734],
    [2.0, 6.21, 1.48, 0.763, 0.237, 0.448, 0.751, 0.500, 0.764],
    [2.5, 6.56, 1.48, 0.810, 0.190, 0.452, 0.794, 0.480, 0.796],
    [3.0, 7.03, 1.48, 0.842, 0.158, 0.453, 0.825, 0.472, 0.825],
];

/// Table A.2 at H/R, linear between its rows; none outside 0.3 … 3.0.
pub fn table(slenderness: f64) -> Option<Row> {
    let pair = TABLE.windows(2).find(|pair| pair[0][0] <= slenderness && slenderness <= pair[1][0])?;
    let t = (slenderness - pair[0][0]) / (pair[1][0] - pair[0][0]);
    let v: [f64; 9] = std::array::from_fn(|i| (1.0 - t) * pair[0][i] + t * pair[1][i]);
    Some(Row {
        impulsive_period: v[1],
        convective_period: v[2],
        impulsive_mass: v[3],
        convective_mass: v[4],
        impulsive_lever: v[5],
        convective_lever: v[6],
        impulsive_lever_with_base: v[7],
        convective_lever_with_base: v[8],
    })
}

/// `T_imp` [s]; with C_i, ρ, H, s, R and Young's modulus E.
pub(super) const PERIOD: &str = "C_i·√(ρ)·H/(√(s/R)·√(E))";

/// Line for the thickness averaged over the wetted height with the distance from the surface as weight; returns it [m].
///
/// ```text
/// 2/H² ∫₀ᴴ (H − z) s dz = Σ s_k (y_k² − y_{k+1}²)/H²      y_k depth of the lower edge of course k below the surface
/// ```
///
/// Check: 14, 12, 10, 8, 8 mm to 2.4 m each, H = 12 m: 11.680 mm.
pub(crate) fn mean_thickness(
    sheet: &mut Sheet,
    symbol: &str,
    name: &str,
    tank: &Tank,
    depth: f64,
    clause: &str,
) -> f64 {
    let thickness = symbol.split('_').next().unwrap_or(symbol);
    let mut values = vec![("H".to_string(), depth), ("y_1".into(), depth)];
    let (mut top, mut parts) = (0.0, Vec::new());
    for (k, course) in (1..).zip(&tank.courses) {
        if top >= depth {
            break;
        }
        top += course.height;
        values.push((format!("{thickness}_{k}"), course.thickness));
        values.push((format!("y_{}", k + 1), depth - f64::min(top, depth)));
        parts.push(format!("{thickness}_{k}·(y_{k}² - y_{}²)", k + 1));
    }
    sheet.given(&values.iter().map(|(s, v)| (s.as_str(), *v, Length)).collect::<Vec<Term>>());
    let formula = format!("({})/H²", parts.join(" + "));
    sheet.calc(symbol, name, &formula, Length, clause)
}

/// Mean over the wetted height, weighted with the distance H − z from the surface, of a value that is constant in each
/// course: `2/H² ∫₀ᴴ (H − z) value dz`.
pub fn weighted_mean(tank: &Tank, depth: f64, value: impl Fn(&tank::Course) -> f64) -> f64 {
    let (mut base, mut sum) = (0.0, 0.0);
    for course in &tank.courses {
        let top = (base + course.height).min(depth);
        if base >= depth {
            break;
        }
        sum += value(course) * ((depth - base).powi(2) - (depth - top).powi(2));
        base += course.height;
    }
    sum / (depth * depth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanical::{Plan, impulsive, sloshing_omega};
    use std::f64::consts::PI;

    #[test]
    fn no_row_without_a_number() {
        assert!(table(f64::NAN).is_none());
    }

    /// Meaning of the table: m_i and h_i′ of a rigid tank, m_i + m_c = m, T_con of the first mode (0.5 %; h_i′ 1 %).
    #[test]
    fn table_is_the_rigid_tank() {
        for row in TABLE {
            let exact = impulsive(Plan::Circle, row[0]);
            assert!((row[3] - exact.mass).abs() < 6e-4, "{row:?}");
            assert!((row[7] / exact.lever_with_base - 1.0).abs() < 4e-3, "{row:?}");
            assert!((row[3] + row[4] - 1.0).abs() < 1e-12);
            let c_c = 2.0 * PI / sloshing_omega(Plan::Circle, 1, 1.0, row[0], 9.81);
            assert!((row[2] / c_c - 1.0).abs() < 5e-3, "{} {c_c}", row[2]);
        }
    }
}
