//! Housner's two masses with SRSS: the chain that ACI 350.3, IS 1893-2 and the data of other national codes have in common.
//!
//! ```text
//! r = D/H (circle), L/H (rectangle, L the full length along the motion)
//!                       circle                                   rectangle
//! m_i/m   tanh(0.866 r)/(0.866 r)                                the same
//! m_c/m   0.230 r tanh(3.68/r)                                   0.264 r tanh(3.16/r)
//! h_i/H   0.5 − 0.09375 r (r < 1.333), else 0.375                the same
//! h_i′/H  0.45 (r < 0.75), else 0.866 r/(2 tanh(0.866 r)) − 1/8  the same
//! h_c/H   1 − (cosh u − 1)/(u sinh u), u = 3.68/r                u = 3.16/r
//! h_c′/H  1 − (cosh u − 2.01)/(u sinh u)                         the same
//! T_c     2π √(D/(3.68 g tanh u))                                2π √(L/(3.16 g tanh u))
//!
//! Q = √(Q_i² + Q_c²)    Q_i = A_i g (m_i + ε m_w + m_r)    Q_c = A_c g m_c    moments with the arms, without (EBP) and with (IBP, ′) the base
//! d = A_w D/2 or A_w L/2
//! p = √((p_i + p_w)² + p_c² + p_v²)
//! ```
//!
//! A code gives the rest through [`Rules`]: the impulsive period, the accelerations A in g (spectrum, importance, reduction), the share ε of the
//! wall and the shape of its pressures. Under a record the accelerations are ordinates of its spectrum, unreduced, beside a linear history.
//!
//! | module | idea |
//! |---|---|
//! | `masses` | masses, arms, sloshing period |
//! | `periods` | impulsive periods that codes share |
//! | `action` | accelerations of the parts, of a record or of a site |
//! | `resultants` | base shear, moments, wave |
//! | `pressure` | pressures over the depth |
//! | `wall` | hoop force and bending of the wall under them |
//! | `ingredients` | what the quantities are made of |
//!
//! Sources: Housner 1963; ACI 350.3-06 chapter 9 and IITK-GSDMA 2007 have the formulas alike, and several public implementations agree. A clause
//! of a line says how it is known: without a mark two sources agree, `one source`, or `recalled`.

pub(crate) mod action;
mod ingredients;
pub(crate) mod limit_states;
mod masses;
pub(crate) mod periods;
pub(crate) mod pressure;
mod resultants;
#[cfg(test)]
pub(crate) mod tests;
mod wall;

pub(crate) use action::Action;
pub(crate) use masses::Masses;
pub(crate) use pressure::Shape as PressureShape;

use crate::mechanical::Plan;
use crate::procedure::CodeError;
use crate::sheet::Sheet;
use tank::Shape;
use tank::assessment::{Assessment, Excitation, NotApplicable};
use tank::case::Case;
use tank::quantity::Quantity;
use tank::units::Dimension::{Acceleration, Density, Dimensionless, Length, Mass};

/// What a code of the chain gives beside its masses.
pub(crate) trait Rules: Sync {
    /// Clauses of the lines that the chain writes.
    fn clauses(&self) -> &'static Clauses;
    /// Whether the tank is within its scope and the site gives its data.
    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable>;
    /// Lines of the impulsive period; none where the code gives none for the tank.
    fn impulsive_period(&self, work: &mut Work, masses: &Masses) -> Result<Option<Impulsive>, CodeError>;
    /// Lines of the accelerations of its site.
    fn action(&self, work: &mut Work, periods: &Periods) -> Result<Action, CodeError>;
    /// Lines of what carries the container, after those of base shear and moments; of a tank on the ground none.
    ///
    /// Errors: missing site data.
    fn beneath(&self, _work: &mut Work) -> Result<(), CodeError> {
        Ok(())
    }
    /// Line of the share ε of the wall that counts; none where all of it counts.
    fn wall_share(&self, _work: &mut Work) -> Option<f64> {
        None
    }
    /// Shape of its pressures.
    fn pressures(&self) -> PressureShape;
    /// What it assumes of a tank, one sentence each.
    fn assumptions(&self, case: &Case, excitation: Excitation) -> Vec<String>;
}

/// Clauses of the lines that the chain writes, with how they are known.
pub(crate) struct Clauses {
    /// Masses of the liquid.
    pub masses: &'static str,
    /// Their heights.
    pub heights: &'static str,
    /// Sloshing period.
    pub sloshing: &'static str,
    /// Accelerations.
    pub action: &'static str,
    /// Base shear.
    pub shear: &'static str,
    /// Moments.
    pub moments: &'static str,
    /// Wave.
    pub wave: &'static str,
    /// Pressures of the parts.
    pub pressures: &'static str,
    /// Their combination.
    pub combination: &'static str,
}

/// The impulsive period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Impulsive {
    /// Period [s].
    pub period: f64,
    /// Thickness [m] and modulus [Pa] of the uniform cylinder that its formula is for.
    pub uniform: Option<(f64, f64)>,
}

/// Periods of the parts.
pub(crate) struct Periods {
    /// Of the impulsive part, where the code gives one.
    pub impulsive: Option<Impulsive>,
    /// Of sloshing [s].
    pub convective: f64,
}

/// An assessment under way.
pub(crate) struct Work<'a> {
    /// The case.
    pub case: &'a Case,
    /// What shakes the tank.
    pub excitation: Excitation,
    /// The growing sheet.
    pub sheet: Sheet,
    /// The growing result.
    pub out: Assessment,
    /// Circle or rectangle.
    pub plan: Plan,
    /// D or L [m].
    pub length: f64,
    /// Why the masses are not for this tank, where they are not: its wave is not judged then.
    pub doubt: Option<String>,
}

/// Runs the chain with the rules of a code.
pub(crate) fn assess(rules: &dyn Rules, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
    rules.applies(case, excitation)?;
    let mut work = Work {
        case,
        excitation,
        sheet: Sheet::new(),
        out: Assessment::default(),
        plan: Plan::from(case.tank.shape),
        length: 2.0 * case.tank.shape.half_length(),
        doubt: None,
    };
    work.assumptions(rules);
    work.inputs();
    let clauses = rules.clauses();
    let masses = work.masses(clauses);
    work.sheet.section("Periods");
    let convective = work.sloshing_period(clauses);
    let impulsive = rules.impulsive_period(&mut work, &masses)?;
    work.out.values.extend(impulsive.map(|part| (Quantity::ImpulsivePeriod, part.period)));
    let periods = Periods { impulsive, convective };
    work.sheet.section("Accelerations");
    let action = match excitation {
        Excitation::Record => work.of_record(&periods, clauses)?,
        Excitation::Site => rules.action(&mut work, &periods)?,
    };
    let share = rules.wall_share(&mut work);
    work.resultants(share, clauses);
    rules.beneath(&mut work)?;
    work.wave(clauses);
    let stresses = work.wall(rules, &masses, &action, share.unwrap_or(1.0));
    // No other method covers a tank on a staging, with which it would be compared.
    if case.tank.staging.is_none() {
        work.ingredients(&masses, &periods, &action, share.unwrap_or(1.0), stresses);
    }
    let Work { sheet, mut out, .. } = work;
    out.recalled = sheet.recalled().to_vec();
    if !out.recalled.is_empty() {
        out.notes.push(format!("Recalled, not compared with the code: {}.", out.recalled.join("; ")));
    }
    out.steps = sheet.into_steps()?;
    Ok(out)
}

/// Why a chain does not run: the data of the excitation are not there.
///
/// * `given`: whether the site gives the data of the code
/// * `missing`: the reason where it does not
pub(crate) fn available(
    case: &Case,
    excitation: Excitation,
    clause: &str,
    (given, missing): (bool, &str),
) -> Result<(), NotApplicable> {
    let reason = match excitation {
        Excitation::Record if case.ground_motion.is_none() => "no record given",
        Excitation::Site if !given => missing,
        _ => return Ok(()),
    };
    Err(NotApplicable { clause: clause.into(), reason: reason.into() })
}

impl Work<'_> {
    /// Symbol of the length along the motion.
    pub(crate) fn symbol(&self) -> &'static str {
        match self.plan {
            Plan::Circle => "D",
            Plan::Rectangle => "L",
        }
    }

    /// Breadth of a rectangle across the motion [m]; 0 of a circle.
    pub(crate) fn breadth(&self) -> f64 {
        match self.case.tank.shape {
            Shape::Rectangle { breadth, .. } => breadth,
            Shape::Cylinder { .. } => 0.0,
        }
    }

    fn assumptions(&mut self, rules: &dyn Rules) {
        let out = &mut self.out.assumptions;
        out.push(
            "Rigid wall for the masses, small waves, rigid ground; impulsive and convective maxima by SRSS.".into(),
        );
        out.push(
            "Crest and trough beside d_max are those of a wave of finite height; the code asks for d_max alone.".into(),
        );
        out.extend(rules.assumptions(self.case, self.excitation));
        if self.excitation == Excitation::Record {
            out.push(
                "Accelerations are ordinates of the record's spectrum at the damping of the case, without importance factor and reduction.".into(),
            );
        }
        out.push(
            "Forces of the wall: the shell of the cylinder on its joint with the base, or the wall across the motion as a plate clamped at base and \
             sides, under the pressures of the code."
                .into(),
        );
    }

    fn inputs(&mut self) {
        let case = self.case;
        let symbol = self.symbol();
        let (length, breadth) = (self.length, self.breadth());
        let sheet = &mut self.sheet;
        sheet.section("Tank and liquid");
        let name = match self.plan {
            Plan::Circle => "inner diameter",
            Plan::Rectangle => "inner length along the motion",
        };
        sheet.input(symbol, name, length, Length, "input");
        if breadth > 0.0 {
            sheet.input("B", "inner breadth across the motion", breadth, Length, "input");
        }
        sheet.input("H", "depth of the liquid", case.liquid.fill_height, Length, "input");
        sheet.calc("r", "its proportion", &format!("{symbol}/H"), Dimensionless, "definition");
        sheet.input("ρ", "density of the liquid", case.liquid.density, Density, "input");
        let formula = if breadth > 0.0 { "ρ·L·B·H" } else { "ρ·π·D²/4·H" };
        sheet.calc("m", "mass of the liquid", formula, Mass, "definition");
        let (wall, centre) = case.tank.thick_wall();
        let source = "courses at the middle of their thickness, with corners and what they carry";
        sheet.look_up("m_w", "mass of the wall", source, wall, Mass, "definition");
        sheet.look_up("h_w", "height of its centre", source, centre, Length, "definition");
        sheet.input("m_r", "mass of the roof", case.tank.roof.mass, Mass, "input");
        sheet.input("h_r", "height of its centre", case.tank.roof_height(), Length, "input");
        sheet.input("g", "acceleration of free fall", case.gravity, Acceleration, "input");
    }
}
