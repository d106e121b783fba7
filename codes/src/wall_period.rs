//! From the wall as it is to the uniform wall of the formulas for the impulsive period, for the attribution of differences.
//!
//! The periods are those of the first mode of the clamped shell with its liquid ([`coupled_mode`]): of the courses as they are, of
//! the same courses without mass, and of a wall of one thickness and modulus without mass.

use tank::case::Case;
use tank::factor::Factor;
use tank::ingredients::Rung;
use tank::{Course, Shape};

use crate::ec8::flexible::coupled_mode;
use crate::ec8::shell_mode::Base;
use crate::procedure::CodeError;

/// Density of a wall without mass over its own: small enough to move no period by 1e-6, large enough for the iteration.
const WEIGHTLESS: f64 = 1e-6;

/// The rungs from the shell to the formula.
///
/// * `thickness` [m], `modulus` [Pa]: of the uniform wall; `period` [s]: by the formula
///
/// Errors: an iteration that does not converge.
pub fn rungs(case: &Case, thickness: f64, modulus: f64, period: f64) -> Result<Vec<Rung>, CodeError> {
    let formula = Rung { factor: Factor::Formula, value: period };
    let Shape::Cylinder { radius } = case.tank.shape else { return Ok(vec![formula]) };
    let courses = &case.tank.courses;
    let mut weightless = courses.clone();
    for course in &mut weightless {
        course.material.density *= WEIGHTLESS;
    }
    let mut uniform = weightless[0].clone();
    uniform.height = case.tank.wall_height();
    uniform.thickness = thickness;
    uniform.material.youngs_modulus = modulus;
    let rung = |factor, courses: &[Course]| -> Result<Rung, CodeError> {
        Ok(Rung { factor, value: coupled_mode(radius, courses, case.liquid, Base::Clamped)?.period })
    };
    Ok(vec![
        rung(Factor::ShellModel, courses)?,
        rung(Factor::WeightlessWall, &weightless)?,
        rung(Factor::UniformWall, &[uniform])?,
        formula,
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{case, course, near, steel};

    /// A wall that is uniform and nearly weightless has no factor but that of the formula: all shells are one.
    #[test]
    fn a_uniform_light_wall_is_the_formulas_wall() {
        let mut light = steel();
        light.density = 1e-3;
        let c = case(Shape::Cylinder { radius: 5.0 }, vec![course(6.0, 0.01, light)], 5.0, None);
        let found = rungs(&c, 0.01, 210e9, 0.1).unwrap();
        // 1e-3 kg/m³ of wall against 1000 kg/m³ of liquid 5 m deep: the period moves by less than 1e-6.
        near(found[1].value / found[0].value, 1.0, 1e-6, "weight");
        near(found[2].value / found[1].value, 1.0, 1e-9, "uniform");
    }

    /// A heavier wall is slower; a wall of twice the stiffness everywhere is faster by √2, if it has no mass.
    #[test]
    fn mass_and_stiffness_have_their_factors() {
        let c = case(Shape::Cylinder { radius: 5.0 }, vec![course(6.0, 0.01, steel())], 5.0, None);
        let found = rungs(&c, 0.01, 420e9, 0.1).unwrap();
        assert!(found[1].value < found[0].value);
        // Both weightless; the iteration stops at changes of 1e-6 or less.
        near(found[2].value / found[1].value, 0.5_f64.sqrt(), 1e-5, "stiffness");
    }
}
