//! Vertical motion of a cylinder on the calculation sheet: A.2.2 (rigid) and A.3.3 (breathing wall).

use std::f64::consts::PI;

use super::vertical;
use super::work::Work;
use crate::procedure::CodeError;
use crate::sheet::number;
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
pub(super) fn assess(work: &mut Work, radius: f64, gamma: f64) -> Result<Option<VerticalMotion>, CodeError> {
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
                "vertical motion with H/R = {} found, the pressure of the breathing wall is given for H/R < 4",
                number(gamma)
            ),
        }));
    };
    work.sheet.section("Vertical motion");
    let third = case.tank.course_at(depth / 3.0);
    let material = &third.material;
    let frequency = vertical::breathing_frequency(
        radius,
        depth,
        case.liquid.density,
        material.youngs_modulus,
        material.poisson_ratio,
        third.thickness,
    );
    let terms = [
        ("R", radius, Length),
        ("E", material.youngs_modulus, Stress),
        ("s", third.thickness, Length),
        ("ρ", case.liquid.density, Density),
        ("H", depth, Length),
        ("ν", material.poisson_ratio, Dimensionless),
        ("γ1", PI / (2.0 * gamma), Dimensionless),
        ("γ", gamma, Dimensionless),
        ("f_vd", frequency, Frequency),
    ];
    work.sheet.calc(
        "γ1",
        "argument of the Bessel functions",
        "π/(2·γ)",
        &terms,
        PI / (2.0 * gamma),
        Dimensionless,
        &clause,
    );
    work.sheet.calc(
        "f_vd",
        "frequency of the breathing mode, s at z = H/3",
        "1/(4·R)·√(2·E·I₁(γ1)·s/(π·ρ·H·(1 - ν²)·I₀(γ1)))",
        &terms,
        frequency,
        Frequency,
        &clause,
    );
    let period = work
        .sheet
        .calc("T_vd", "its period", "1/f_vd", &terms, 1.0 / frequency, Time, &clause);
    let formula = if gamma < 0.8 {
        "1 (γ < 0.8)"
    } else {
        "1.078 + 0.274·ln(γ)"
    };
    work.sheet.calc(
        "f",
        "factor of the breathing pressure",
        formula,
        &terms,
        factor,
        Dimensionless,
        &clause,
    );
    let breathing = work.demand.breathing(&mut work.sheet, period);
    let ground = work.demand.vertical_ground();
    let terms = [
        ("ρ", case.liquid.density, Density),
        ("H", depth, Length),
        ("A_v", ground, Acceleration),
        ("A_vf", breathing, Acceleration),
        ("f", factor, Dimensionless),
    ];
    let scale = case.liquid.density * depth;
    let rigid_clause = work.edition.clause("2.2");
    let rigid = work.sheet.calc(
        "p_vr",
        "rigid pressure at the base",
        "ρ·H·A_v",
        &terms,
        scale * ground,
        Stress,
        &rigid_clause,
    );
    let formula = "0.815·f·ρ·H·A_vf";
    let value = vertical::breathing_pressure(factor, 0.0) * scale * breathing;
    let flexible = work.sheet.calc(
        "p_vf",
        "breathing pressure at the base",
        formula,
        &terms,
        value,
        Stress,
        &clause,
    );
    let terms = [("p_vr", rigid, Stress), ("p_vf", flexible, Stress)];
    work.sheet.calc(
        "p_v",
        "vertical part at the base",
        "√(p_vr² + p_vf²)",
        &terms,
        rigid.hypot(flexible),
        Stress,
        &clause,
    );
    Ok(Some(VerticalMotion {
        ground,
        breathing,
        factor,
    }))
}
