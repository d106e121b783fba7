//! Vertical motion of a cylinder on the calculation sheet: A.2.2 (rigid) and A.3.3 (breathing wall).

use super::vertical;
use super::work::Work;
use crate::procedure::CodeError;
use tank::assessment::NotApplicable;
use tank::units::Dimension::*;

/// Vertical motion of the liquid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct VerticalMotion {
    /// A_v [m/s²].
    pub ground: f64,
    /// A_vf [m/s²].
    pub breathing: f64,
    /// f(γ).
    pub factor: f64,
}

/// Vertical motion, if considered.
pub(super) fn assess(work: &mut Work, gamma: f64) -> Result<Option<VerticalMotion>, CodeError> {
    if !work.demand.vertical {
        return Ok(None);
    }
    let case = work.case;
    let depth = case.liquid.fill_height;
    let clause = work.edition.clause("3.3");
    let Some(factor) = vertical::breathing_factor(gamma) else {
        return Err(CodeError::NotApplicable(NotApplicable {
            clause,
            reason: format!(
                "vertical motion with H/R = {gamma:.2}, where the pressure of the breathing wall is given for H/R < 4; `site.ec8.vertical: false` \
                 leaves vertical motion out"
            ),
        }));
    };
    work.sheet.section("Vertical motion");
    let third = case.tank.course_at(depth / 3.0);
    let material = &third.material;
    let name = "argument of the Bessel functions";
    let gamma_1 = work.sheet.calc("γ1", name, "π/(2·γ)", Dimensionless, &clause);
    work.sheet.given(&[
        ("E", material.youngs_modulus, Stress),
        ("s", third.thickness, Length),
        ("ν", material.poisson_ratio, Dimensionless),
    ]);
    let name = "frequency of the breathing mode, s at z = H/3";
    let formula = vertical::frequency(gamma_1);
    work.sheet.calc("f_vd", name, formula, Frequency, &clause);
    let period = work.sheet.calc("T_vd", "its period", "1/f_vd", Time, &clause);
    let name =
        if gamma < 0.8 { "factor of the breathing pressure, γ < 0.8" } else { "factor of the breathing pressure" };
    let factor = work.sheet.calc("f", name, factor, Dimensionless, &clause);
    let breathing = work.demand.breathing(&mut work.sheet, period);
    let ground = work.demand.vertical_ground();
    work.sheet.given(&[("A_v", ground, Acceleration), ("A_vf", breathing, Acceleration)]);
    let rigid_clause = work.edition.clause("2.2");
    let name = "rigid pressure at the base";
    work.sheet.calc("p_vr", name, "ρ·H·A_v", Stress, &rigid_clause);
    let (name, formula) = ("breathing pressure at the base", "0.815·f·ρ·H·A_vf");
    work.sheet.calc("p_vf", name, formula, Stress, &clause);
    let (name, formula) = ("vertical part at the base", "√(p_vr² + p_vf²)");
    work.sheet.calc("p_v", name, formula, Stress, &clause);
    Ok(Some(VerticalMotion { ground, breathing, factor }))
}
