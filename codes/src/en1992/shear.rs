//! Shear resistance of a wall without links.
//!
//! ```text
//! V_Rd,c = max(0.18/γ_c k (100 ρ_l f_ck)^⅓, v_min) d + 0.15 σ_cp d      v_min = 0.035 k^1.5 f_ck^½      (MPa, mm)
//! k = min(1 + √(200 mm/d), 2)      ρ_l = min(A_sl/d, 0.02)      σ_cp = min(−N/h, 0.2 f_cd)
//! ```
//!
//! N is positive in tension, which lowers the resistance.
//!
//! Source: EN 1992-1-1:2004 6.2.2(1), recalled.

use super::section::{Face, Section};

/// Terms of the resistance, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shear {
    /// Effective depth d of the bars in tension [m].
    pub depth: f64,
    /// Area of these bars [m²/m].
    pub area: f64,
    /// Axial stress σ_cp [Pa], compression positive.
    pub axial: f64,
}

/// Formula of V_Rd,c [N/m] in the terms d, A_sl, f_ck, γ_c, σ_cp (SI), and p = 1 MPa, l = 1 m.
///
/// k = 1 + √(0.2 m/d); powers of MPa are taken of ratios to p.
pub const RESISTANCE: &str = "max(p·0.18/γ_c·min(1 + √(0.2·l/d), 2)·(100·min(A_sl/d, 0.02)·f_ck/p)^(1/3), \
                              p·0.035·min(1 + √(0.2·l/d), 2)^1.5·√(f_ck/p))·d + 0.15·σ_cp·d";

/// Terms of a section whose `tension` face pulls, with an axial force N [N/m], tension positive. None without bars there.
///
/// Bars count as in tension if they are in the half of the wall at that face; d is that of their centre.
pub fn terms(section: &Section, n: f64, tension: Face) -> Option<Shear> {
    let half = 0.5 * section.thickness;
    let (mut area, mut moment) = (0.0, 0.0);
    for bars in &section.bars {
        let d = section.effective_depth(bars, tension);
        if d > half {
            area += bars.area;
            moment += bars.area * d;
        }
    }
    (area > 0.0).then(|| Shear {
        depth: moment / area,
        area,
        axial: (-n / section.thickness).min(0.2 * section.design_strength()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::formula::evaluate;

    fn resistance(d: f64, area: f64, f_ck: f64, axial: f64) -> f64 {
        let terms = [("d", d), ("A_sl", area), ("f_ck", f_ck), ("γ_c", 1.5), ("σ_cp", axial), ("p", 1e6), ("l", 1.0)];
        evaluate(RESISTANCE, &terms)
    }

    /// v_Rd,c [MPa] of members without shear reinforcement, f_ck = 30 MPa, as tabulated for slabs by The Concrete Centre ("How to
    /// design concrete structures using Eurocode 2", recalled); half the last digit.
    #[test]
    fn published_table() {
        for (rho, row) in [
            (0.0025, [0.54, 0.52, 0.50, 0.48, 0.47]),
            (0.005, [0.59, 0.57, 0.56, 0.55, 0.54]),
            (0.01, [0.75, 0.72, 0.71, 0.69, 0.68]),
            (0.02, [0.94, 0.91, 0.89, 0.87, 0.85]),
        ] {
            for (d, v) in [0.2, 0.225, 0.25, 0.275, 0.3].into_iter().zip(row) {
                let found = resistance(d, rho * d, 30e6, 0.0) / d / 1e6;
                assert!((found - v).abs() <= 0.0051, "{rho} {d}: {found} {v}");
            }
        }
    }

    /// Tension of 1 MPa takes 0.15 MPa off; more than 2 % of steel adds nothing.
    #[test]
    fn axial_force_and_limits() {
        let v = resistance(0.2, 1e-3, 30e6, 0.0);
        assert!((resistance(0.2, 1e-3, 30e6, -1e6) - (v - 0.15e6 * 0.2)).abs() < 1e-6);
        assert!((resistance(0.2, 8e-3, 30e6, 0.0) - resistance(0.2, 4e-3, 30e6, 0.0)).abs() < 1e-6);
    }
}
