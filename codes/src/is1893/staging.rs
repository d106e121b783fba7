//! An elevated tank as two masses: container and impulsive liquid on the spring of the staging, and the sloshing mass on its own spring.
//!
//! ```text
//! m_s  = m_w + m_r + m_b + m_st/3       h_cg  centre of the empty container above the top of the footing, h_s that of the bottom of the wall
//! T_i  = 2π √((m_i + m_s)/K_s)          T_e = 2π √(m_s/K_s), empty
//! Q    = √((A_i g (m_i + m_s))² + (A_c g m_c)²)                                  Q_e = A_e g m_s
//! M    = √((A_i g (m_i (h_i′ + h_s) + m_s h_cg))² + (A_c g m_c (h_c′ + h_s))²)   M_e = A_e g m_s h_cg
//! ```
//!
//! The full or the empty tank governs. Coupled, the masses m_i + m_s and m_c on K_s and K_c = m_c ω_c² have the periods T_1 and T_2, which the
//! sheet has beside T_c and T_i; with T_c/T_i ≥ 2.5 both agree to a few percent (`crates/verification`, page `two-masses`). A third of a mass
//! that is spread evenly moves with the top where the displacement is linear over the height.

use tank::assessment::Excitation;
use tank::case::Case;
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Mass, Moment, Time};
use tank::{Staging, StagingKind};

#[cfg(test)]
mod tests;

use super::site;
use crate::ordinates::psa;
use crate::procedure::CodeError;
use crate::two_mass::{Impulsive, Work};

const MASS: &str = "IITK-GSDMA 2007 4.2.2, recalled";
const PERIOD: &str = "IITK-GSDMA 2007 4.3.1.3, one source";
const SHEAR: &str = "IITK-GSDMA 2007 4.6.2, one source";
const MOMENT: &str = "IITK-GSDMA 2007 4.7.2, one source";
const EMPTY: &str = "IITK-GSDMA 2007 4.6, 4.7, recalled";
const DIRECTIONS: &str = "IITK-GSDMA 2007 4.8, recalled";
const COUPLED: &str = "two coupled masses, derived";
/// Number of columns from which a frame has no weak direction.
const ROUND: u32 = 8;
/// Ratio of the periods from which they are taken apart.
const APART: f64 = 2.5;

/// Lines of the masses on the staging and of their periods.
pub(super) fn period(work: &mut Work, staging: &Staging) -> Impulsive {
    let sheet = &mut work.sheet;
    sheet.section("Staging");
    for (symbol, name, value, dimension, key) in [
        ("K_s", "lateral stiffness at the centre of the empty container", staging.stiffness, LineForce, "stiffness"),
        ("m_st", "mass of the staging", staging.mass, Mass, "mass"),
        ("h_s", "height of the bottom of the wall above the top of the footing", staging.height, Length, "height"),
        ("m_b", "mass of the container besides wall and roof", staging.floor_mass, Mass, "floor_mass"),
        ("h_b", "height of its centre above the bottom of the wall", staging.floor_centre, Length, "floor_centre"),
    ] {
        sheet.input(symbol, name, value, dimension, &format!("tank.staging.{key}"));
    }
    let name = "container with a third of the staging";
    sheet.calc("m_s", name, "m_w + m_r + m_b + m_st/3", Mass, MASS);
    let name = "height of the centre of the empty container above the top of the footing";
    let formula = "h_s + (m_w·h_w + m_r·h_r + m_b·h_b)/(m_w + m_r + m_b)";
    sheet.calc("h_cg", name, formula, Length, "definition");
    let name = "impulsive period, full";
    let period = sheet.calc("T_i", name, "2·π·√((m_i + m_s)/K_s)", Time, PERIOD);
    sheet.calc("τ", "square of T_i over T_c", "(T_i/T_c)²", Dimensionless, COUPLED);
    let name = "sum of the squared frequencies of the coupled masses over that of T_i";
    sheet.calc("β", name, "1 + τ·(1 + m_c/(m_i + m_s))", Dimensionless, COUPLED);
    let first = sheet.calc("T_1", "first period, coupled", "T_i/√((β - √(β² - 4·τ))/2)", Time, COUPLED);
    let second = sheet.calc("T_2", "second period, coupled", "T_i/√((β + √(β² - 4·τ))/2)", Time, COUPLED);
    let sloshing = work.out.values.get(&Quantity::SloshingPeriod).copied().unwrap_or(f64::NAN);
    if sloshing < APART * period {
        let ratio = crate::sheet::number(sloshing / period);
        work.doubt = Some(format!("T_c is {ratio} times T_i; uncoupled masses are for a ratio of at least {APART}"));
        work.out.notes.push(format!(
            "Sloshing and staging are not far apart: T_c is {ratio} times T_i, and the coupled masses have the periods {} and {}. Uncoupled masses are \
             for a ratio of at least {APART}.",
            crate::sheet::with_unit(first, Time),
            crate::sheet::with_unit(second, Time)
        ));
    }
    Impulsive { period, uniform: None }
}

/// Lines of base shear and moment at the top of the footing, full and empty; the larger is the value.
///
/// Errors: no site data.
pub(super) fn resultants(work: &mut Work, staging: &Staging) -> Result<(), CodeError> {
    work.sheet.section("Base shear and moment at the top of the footing, full");
    for (symbol, name, dimension, clause, [impulsive, sloshing]) in [
        ("Q", "base shear", Force, SHEAR, ["m_i + m_s", "m_c"]),
        ("M′", "moment", Moment, MOMENT, ["m_i·(h_i′ + h_s) + m_s·h_cg", "m_c·(h_c′ + h_s)"]),
    ] {
        let sheet = &mut work.sheet;
        let [i, c] = ["i", "c"].map(|index| format!("{symbol}_{index}"));
        sheet.calc(&i, &format!("{name}, impulsive"), &format!("A_i·g·({impulsive})"), dimension, clause);
        sheet.calc(&c, &format!("{name}, convective"), &format!("A_c·g·{sloshing}"), dimension, clause);
        sheet.calc(symbol, name, &format!("√({i}² + {c}²)"), dimension, clause);
    }
    empty(work)?;
    let sheet = &mut work.sheet;
    sheet.section("Governing values at the top of the footing");
    let shear = sheet.calc("Q_max", "base shear, full or empty", "max(Q, Q_e)", Force, SHEAR);
    let moment = sheet.calc("M_max", "moment, full or empty", "max(M′, M_e)", Moment, MOMENT);
    if staging.kind == StagingKind::RcShaft || staging.columns.is_none_or(|columns| columns < ROUND) {
        let what = "100 % along one direction with 30 % across, of a shaft or fewer than eight columns";
        sheet.calc("Q_xy", &format!("base shear, {what}"), "√(1 + 0.3²)·Q_max", Force, DIRECTIONS);
        sheet.calc("M_xy", &format!("moment, {what}"), "√(1 + 0.3²)·M_max", Moment, DIRECTIONS);
    }
    work.out.values.extend([(Quantity::BaseShear, shear), (Quantity::OverturningMoment, moment)]);
    work.out.notes.push(
        "Base shear and overturning moment are those at the top of the footing, the larger of full and empty tank."
            .into(),
    );
    Ok(())
}

/// Lines of the empty tank.
fn empty(work: &mut Work) -> Result<(), CodeError> {
    let (case, excitation) = (work.case, work.excitation);
    let sheet = &mut work.sheet;
    sheet.section("Empty tank");
    let period = sheet.calc("T_e", "period, empty", "2·π·√(m_s/K_s)", Time, EMPTY);
    match (excitation, &case.ground_motion) {
        (Excitation::Record, Some(motion)) => {
            let (record, damping) = (&motion.horizontal, case.damping.impulsive);
            let name =
                "acceleration of the empty tank: spectral acceleration at T_e, damping of the impulsive part [g]";
            let source = format!("spectrum of `{}`", record.name);
            let value = psa(record, period, damping) / case.gravity;
            sheet.look_up("A_e", name, "spectrum of the record over g", value, Dimensionless, &source);
        }
        _ => site::empty(sheet, case, period)?,
    }
    sheet.calc("Q_e", "base shear, empty", "A_e·g·m_s", Force, EMPTY);
    sheet.calc("M_e", "moment, empty", "A_e·g·m_s·h_cg", Moment, EMPTY);
    Ok(())
}

/// Whether the staging, or the wall of a tank on the ground, is of steel.
pub(super) fn is_steel(case: &Case) -> bool {
    case.tank.staging.map_or_else(|| case.tank.is_metal(), |staging| staging.kind == StagingKind::SteelFrame)
}
