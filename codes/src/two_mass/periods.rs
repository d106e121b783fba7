//! Impulsive periods that several codes of the chain share.
//!
//! ```text
//! cylinder    T_i = C_i H √ρ/(√(t/D) √E)     C_i = 1/(√x (0.46 − 0.3 x + 0.067 x²)), x = H/D, t at a third of the depth
//! rectangle   T_i = 2π √(d/g)                d deflection of the wall at h̄ under q = (m_i/2 + m′_w) g/(B H), a plate clamped at base and sides
//!             h̄ = (h_i m_i/2 + m′_w H/2)/(m_i/2 + m′_w)
//! ```
//!
//! The polynomial is that of the Japanese fire rules and of IITK-GSDMA; it is within 6 % of the shell's own calculation for H/R from 0.5 to 3.

use tank::Shape;
use tank::units::Dimension::{Dimensionless, Length, Mass, Stress, Time};

use super::{Impulsive, Masses, Work};
use crate::ec8::plate::{Sides, deflection};

/// Lines of the impulsive period of any tank.
pub(crate) fn impulsive(work: &mut Work, masses: &Masses, clause: &str) -> Impulsive {
    match work.case.tank.shape {
        Shape::Cylinder { .. } => shell(work, clause),
        Shape::Rectangle { breadth, strip, .. } => plate(work, masses, (breadth, strip), clause),
    }
}

/// A cylinder, as thick as it is at a third of the depth.
fn shell(work: &mut Work, clause: &str) -> Impulsive {
    let case = work.case;
    let course = case.tank.course_at(case.liquid.fill_height / 3.0);
    let (thickness, modulus) = (course.thickness, course.material.youngs_modulus);
    let sheet = &mut work.sheet;
    sheet.input("t_⅓", "thickness of the wall at a third of the depth", thickness, Length, "input");
    sheet.input("E", "modulus of the wall there", modulus, Stress, "input");
    sheet.calc("x", "depth over diameter", "H/D", Dimensionless, clause);
    let formula = "1/(√(x)·(0.46 - 0.3·x + 0.067·x²))";
    sheet.calc("C_i", "coefficient of the impulsive period", formula, Dimensionless, clause);
    let formula = "C_i·H·√(ρ)/(√(t_⅓/D)·√(E))";
    let period = sheet.calc("T_i", "impulsive period", formula, Time, clause);
    Impulsive { period, uniform: Some((thickness, modulus)) }
}

/// The wall of a rectangle across the motion.
fn plate(work: &mut Work, masses: &Masses, (breadth, strip): (f64, bool), clause: &str) -> Impulsive {
    let case = work.case;
    let depth = case.liquid.fill_height;
    let per_length: f64 = case.tank.courses.iter().map(|c| c.height * c.thickness * c.material.density).sum();
    let sides = if strip { Sides::Strip } else { Sides::Clamped { half_width: 0.5 * breadth } };
    let sheet = &mut work.sheet;
    sheet.given(&[("m_i", masses.impulsive.mass, Mass)]);
    sheet.input("m′_w", "mass of one wall across the motion", per_length * breadth, Mass, "input");
    let name = "height of half the impulsive mass and the wall";
    let at = sheet.calc("h_q", name, "(h_i·m_i/2 + m′_w·H/2)/(m_i/2 + m′_w)", Length, clause);
    let name = "uniform load of both";
    let load = sheet.calc("q", name, "(m_i/2 + m′_w)·g/(B·H)", Stress, clause);
    let d = deflection(&case.tank.courses, sides, load, depth, at);
    let how = if strip { "cantilever in plane strain" } else { "plate clamped at base and sides, free at the top" };
    let source = format!("plate theory, {how}");
    sheet.look_up("d", "deflection of the wall there under q", &source, d, Length, clause);
    let period = sheet.calc("T_i", "impulsive period", "2·π·√(d/g)", Time, clause);
    Impulsive { period, uniform: None }
}
