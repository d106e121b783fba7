//! Soil-structure interaction of ASCE 7-16 chapter 19 for an anchored tank on a slab, for information.
//!
//! ```text
//! T̃/T                 static springs of a rigid disc
//! β_f = ξ̃ − β/(T̃/T)³    complex stiffness of disc and wall, in place of the rectangles of 19.3.3
//! β_0 = β_f + β/(T̃/T)²   not above 0.20                                  B_SSI = 4/(5.6 − ln(100 β_0))
//! factor of A_i = max(1/B_SSI, 0.80)                                     on the plateau of the spectrum
//! ```
//!
//! The annex lets the interaction reduce the impulsive forces of an anchored tank on a mat to 80 % at most, with a damping of 20 % at most.
//! The period moves A_i only beyond T_s, which is left out. ASCE 7-10 limits the reduction to 30 %, 7-16 by R. Recalled, not compared
//! with the printed standards.

use super::Run;
use super::accelerations::Periods;
use super::forces::Forces;
use crate::slab;
use tank::units::Dimension::Dimensionless;

const ASCE: &str = "ASCE 7-16 19.2, 19.3";
const E6_1_6: &str = "API 650:2020 E.6.1.6";
/// Damping ratio of the spectrum.
const BETA: f64 = 0.05;

impl Run<'_> {
    /// Lines of period, damping and reduction.
    pub(super) fn soil(&mut self, periods: &Periods, forces: &Forces) {
        let (b, case) = (self.basis, self.basis.case);
        let (Some(period), true) = (periods.impulsive, slab::is_on_soil(case)) else { return };
        if !b.anchored() {
            self.out.notes.push(format!(
                "{E6_1_6}: soil-structure interaction is left out, the tank is not mechanically anchored."
            ));
            return;
        }
        let g = case.gravity;
        let parts = [[forces.w_i / g, forces.x_is], [b.w_s / g, b.x_s], [b.w_r / g, case.tank.roof_height()]];
        let sheet = &mut self.sheet;
        let Some(mut slab) = slab::lines(sheet, case, parts, period, ASCE) else { return };
        slab.on.structure.damping = BETA;
        let Some(effective) = slab.effective() else { return };
        sheet.given(&[("β", BETA, Dimensionless)]);
        let name = "ratio of the periods";
        sheet.calc("κ", name, "T_e0/T_i", Dimensionless, ASCE);
        let name = "damping ratio by radiation into the soil";
        let source = "complex stiffness of a rigid disc (Veletsos and Verbic) and the wall, less the share of the wall";
        let radiated = slab.on.foundation_damping(effective).max(0.0);
        sheet.look_up("β_f", name, source, radiated, Dimensionless, ASCE);
        let name = "damping ratio of tank and soil, not above 0.20";
        sheet.calc("β_0", name, "min(β_f + β/κ², 0.2)", Dimensionless, ASCE);
        let name = "factor of damping";
        sheet.calc("B_SSI", name, "4/(5.6 - ln(100·β_0))", Dimensionless, ASCE);
        let name = "factor by which A_i might be reduced, not below 0.80";
        sheet.calc("f_SSI", name, "max(1/B_SSI, 0.8)", Dimensionless, E6_1_6);
        self.out.notes.push(format!(
            "{E6_1_6}: the interaction with the soil is for information, forces and checks of this sheet do not contain it."
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::example::case;
    use super::super::Api6502020;
    use crate::procedure::Procedure;
    use tank::assessment::{Assessment, Excitation};
    use tank::{Foundation, FoundationKind, Support};

    fn assess(velocity: Option<f64>, support: Support) -> Assessment {
        let mut case = case();
        case.tank.support = support;
        case.tank.foundation = velocity.map(|v| Foundation {
            width: None,
            kind: FoundationKind::Slab,
            stiffness: None,
            shear_wave_velocity: Some(v),
            soil_density: 1900.0,
            soil_poisson_ratio: 1.0 / 3.0,
            thickness: None,
            friction: None,
        });
        Api6502020.assess(&case, Excitation::Site).unwrap()
    }

    fn value(a: &Assessment, symbol: &str) -> f64 {
        let step = a.steps.iter().find(|s| s.symbol == symbol);
        step.unwrap_or_else(|| panic!("no line {symbol}: {:?}", a.notes)).value
    }

    /// By hand from the numbers of the sheet, 1e-9; the reduction ends at 0.80 on soft soil and vanishes on hard soil,
    /// where 4/(5.6 − ln 5) = 1.0024 is left.
    #[test]
    fn period_damping_and_reduction() {
        let soft = assess(Some(200.0), Support::Anchored);
        let [kx, kt, m, h, k, t] = ["K_x", "K_θ", "m_e", "h_e", "k_e", "T_i"].map(|s| value(&soft, s));
        assert!((k / (m * (std::f64::consts::TAU / t).powi(2)) - 1.0).abs() < 1e-9);
        let ratio = (1.0 + k / kx + k * h * h / kt).sqrt();
        assert!((value(&soft, "κ") / ratio - 1.0).abs() < 1e-9);
        let damping = (value(&soft, "β_f") + 0.05 / ratio.powi(2)).min(0.2);
        assert!((value(&soft, "β_0") / damping - 1.0).abs() < 1e-9);
        let factor = 4.0 / (5.6 - (100.0 * damping).ln());
        assert!((value(&soft, "f_SSI") - (1.0 / factor).max(0.8)).abs() < 1e-9);
        assert!(value(&soft, "f_SSI") < 0.95);
        let hard = assess(Some(1e5), Support::Anchored);
        assert!((value(&hard, "κ") - 1.0).abs() < 1e-5);
        assert!((value(&hard, "f_SSI") - 1.0).abs() < 3e-3);
    }

    #[test]
    fn nothing_else_changes() {
        let with = assess(Some(200.0), Support::Anchored);
        let without = assess(None, Support::Anchored);
        assert_eq!(with.values, without.values);
        assert_eq!(with.checks, without.checks);
        let free = assess(Some(200.0), Support::Unanchored);
        assert!(free.steps.iter().all(|s| s.symbol != "κ"));
        assert!(free.notes.iter().any(|n| n.contains("E.6.1.6")));
    }
}
