//! Impulsive periods of ACI 350.3-06.

use tank::units::Dimension::{Density, Dimensionless, Length, Mass, Stress, Time};
use tank::{Shape, WallBase};

use crate::ec8::simplified::mean_thickness;
use crate::procedure::CodeError;
use crate::two_mass::{Impulsive, Masses, Work};

const SHELL: &str = "ACI 350.3-06 9.3.4, figure 9.3.4(a)";
const FLEXIBLE: &str = "ACI 350.3-06 9.3.4, recalled";
const CANTILEVER: &str = "ACI 350.3-06 9.2.4";
/// Proportions H/D that the polynomial of C_w covers.
const RANGE: (f64, f64) = (0.1, 3.0);
/// C_w of x = H/D.
const C_W: &str = "0.09375 + 0.2039·x - 0.1034·x² - 0.1253·x³ + 0.1267·x^4 - 0.03186·x^5";

/// Line of the mean thickness of the wetted wall, and its modulus and density at the base.
fn wall(work: &mut Work, clause: &str) -> (f64, f64) {
    let case = work.case;
    let material = &case.tank.course_at(0.0).material;
    let name = "mean thickness of the wetted wall";
    let t = mean_thickness(&mut work.sheet, "t_w", name, &case.tank, case.liquid.fill_height, clause);
    work.sheet.input("E", "modulus of the wall", material.youngs_modulus, Stress, "input");
    work.sheet.input("ρ_w", "density of the wall", material.density, Density, "input");
    (t, material.youngs_modulus)
}

/// Cylinder on a fixed or hinged base; none outside the polynomial.
pub(super) fn shell(work: &mut Work, radius: f64) -> Option<Impulsive> {
    let x = work.case.liquid.fill_height / work.length;
    if !(RANGE.0..=RANGE.1).contains(&x) {
        work.out.notes.push(format!("{SHELL}: no impulsive period, H/D = {x:.3} lies outside the figure (0.1 to 3)."));
        return None;
    }
    let uniform = wall(work, SHELL);
    let sheet = &mut work.sheet;
    sheet.given(&[("R", radius, Length)]);
    sheet.calc("x", "depth over diameter", "H/D", Dimensionless, SHELL);
    sheet.calc("C_w", "coefficient of the figure", C_W, Dimensionless, SHELL);
    sheet.calc("C_l", "coefficient of the wall", "10·C_w·√(t_w/R)", Dimensionless, SHELL);
    let period = sheet.calc("T_i", "impulsive period", "2·π·H/(C_l·√(E/ρ_w))", Time, SHELL);
    Some(Impulsive { period, uniform: Some(uniform) })
}

/// Cylinder on a flexible base, anchored or not: the tank as one mass on its joint.
///
/// Errors: a joint without a stiffness.
pub(super) fn flexible(work: &mut Work) -> Result<Impulsive, CodeError> {
    let stiffness = match work.case.tank.wall_base {
        WallBase::Sliding { stiffness: Some(stiffness), .. } => stiffness,
        _ => {
            return Err(CodeError::Data {
                clause: FLEXIBLE.into(),
                reason:
                    "`tank.wall_base.stiffness` is missing: the period of a flexible or unanchored base follows from it"
                        .into(),
            });
        }
    };
    let sheet = &mut work.sheet;
    // Force per length and displacement has the dimension of a pressure.
    sheet.input("k_a", "stiffness of the joint per length and displacement", stiffness, Stress, "tank.wall_base");
    let formula = "√(8·π·(m_w + m_r + m_i)/(D·k_a))";
    let period = sheet.calc("T_i", "impulsive period, one mass on the joint", formula, Time, FLEXIBLE);
    Ok(Impulsive { period, uniform: None })
}

/// Wall of a rectangle across the motion, a cantilever per length.
pub(super) fn cantilever(work: &mut Work, masses: &Masses) -> Impulsive {
    let case = work.case;
    let Shape::Rectangle { breadth, .. } = case.tank.shape else { return Impulsive { period: 0.0, uniform: None } };
    wall(work, CANTILEVER);
    let tank = &case.tank;
    let area: f64 = tank.courses.iter().map(|c| c.height * c.thickness * c.material.density).sum();
    let sheet = &mut work.sheet;
    sheet.given(&[("m_i", masses.impulsive.mass, Mass), ("B", breadth, Length)]);
    sheet.input("m′_w", "mass of the wall per length [kg/m]", area, Dimensionless, "input");
    let name = "impulsive mass of one half per length [kg/m]";
    sheet.calc("m′_i", name, "m_i/(2·B)", Dimensionless, CANTILEVER);
    let name = "height of both masses";
    sheet.calc("h", name, "(h_w·m′_w + h_i·m′_i)/(m′_w + m′_i)", Length, CANTILEVER);
    sheet.calc("k", "stiffness of the cantilever at h per length", "E/4·(t_w/h)³", Stress, CANTILEVER);
    let period = sheet.calc("T_i", "impulsive period", "2·π·√((m′_w + m′_i)/k)", Time, CANTILEVER);
    Impulsive { period, uniform: None }
}
