//! The data of a national code on the chain of `codes::two_mass` (`national`): spectrum, importance and reduction factors are the user's, so
//! that NCh 2369, NTC, RPA, the Turkish code and others need no code here.
//!
//! ```text
//! A_i = γ S_a(T_i)/(g R_i)     A_c = γ k S_a(T_c)/(g R_c)     A_w = R_c A_c     A_v = k_v γ S_a(0)/g
//! ```
//!
//! S_a is `site.spectrum` at the damping of its table; k is the given factor, or η of EN 1998-1 from that damping to the case's damping of
//! sloshing, as [`crate::hazard`] describes. Periods are those of `two_mass::periods`, pressures are straight lines.

#[cfg(test)]
mod tests;

use crate::hazard;
use crate::limit_state::{LimitStateDef, common};
use crate::procedure::{CodeError, Label, Procedure};
use crate::two_mass::limit_states::open;
use crate::two_mass::{self, Action, Clauses, Impulsive, Masses, Periods, PressureShape, Rules, Work, periods};
use tank::assessment::{Assessment, Excitation, LimitState, NotApplicable};
use tank::case::{Case, Site};
use tank::factor::Factor;
use tank::hazard::SpectrumForm;
use tank::ingredients::Ordinate;
use tank::units::Dimension::Dimensionless;

/// The user's data (`national`).
#[derive(Clone, Copy, Debug)]
pub struct National;

const HOUSNER: &str = "Housner 1963";
const DATA: &str = "site.national";

const CLAUSES: Clauses = Clauses {
    masses: HOUSNER,
    heights: HOUSNER,
    sloshing: HOUSNER,
    action: DATA,
    shear: HOUSNER,
    moments: HOUSNER,
    wave: HOUSNER,
    pressures: "line with force and moment of the mass",
    combination: "SRSS",
};

const TABLE: &[LimitStateDef] = &[FREEBOARD, STRENGTH, STABILITY];
const FREEBOARD: LimitStateDef = common::FREEBOARD.by(DATA);
const STRENGTH: LimitStateDef = crate::ec8::limit_states::WALL_BENDING.by(DATA).when(open);
const STABILITY: LimitStateDef = common::SLIDING.by(DATA).when(open);

impl Procedure for National {
    fn id(&self) -> &'static str {
        "national"
    }

    fn label(&self) -> Label {
        Label { title: "Housner's masses with SRSS, national data", short: "National data", figure_key: "k-other" }
    }

    fn unasked(&self, site: &Site) -> bool {
        site.national.is_some()
    }

    fn data(&self) -> &'static str {
        "`site.national` beside `site.spectrum`; it decides where `procedures.decide` names it"
    }

    fn table(&self) -> &'static [LimitStateDef] {
        TABLE
    }

    fn limit_states(&self, case: &Case) -> Vec<LimitState> {
        TABLE.iter().map(|state| state.under(state.clause.into(), case)).collect()
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        Rules::applies(self, case, excitation)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        two_mass::assess(self, case, excitation)
    }
}

impl Rules for National {
    fn clauses(&self) -> &'static Clauses {
        &CLAUSES
    }

    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        let given = case.site.national.is_some() && case.site.spectrum.is_some();
        let missing = "`site.national` with `site.spectrum` is not given";
        two_mass::available(case, excitation, DATA, (given, missing))
    }

    fn impulsive_period(&self, work: &mut Work, masses: &Masses) -> Result<Option<Impulsive>, CodeError> {
        Ok(Some(periods::impulsive(work, masses, "shell or plate, uniform wall")))
    }

    fn action(&self, work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
        action(work, periods)
    }

    fn pressures(&self) -> PressureShape {
        PressureShape::Linear
    }

    fn assumptions(&self, case: &Case, excitation: Excitation) -> Vec<String> {
        let site = case.site.national.iter().filter(|_| excitation == Excitation::Site);
        site.map(|site| {
            format!(
                "Spectrum, importance and reduction factors are those that the tank file gives for {}; nothing of that code is checked here.",
                site.code
            )
        })
        .collect()
    }
}

/// Lines of the accelerations.
fn action(work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
    let case = work.case;
    // `applies` has asked before.
    let (Some(site), Some(spectrum), Some(impulsive)) = (&case.site.national, &case.site.spectrum, periods.impulsive)
    else {
        return Err(CodeError::Data { clause: DATA.into(), reason: "`site.national` is not given".into() });
    };
    hazard::covers(Some(spectrum), "sloshing", periods.convective)?;
    hazard::covers(Some(spectrum), "impulsive", impulsive.period)?;
    let damping = match &spectrum.form {
        SpectrumForm::Table { damping, .. } => *damping,
        SpectrumForm::Parameters(_) => 0.05,
    };
    let (g, gamma) = (case.gravity, site.importance);
    let elastic = hazard::elastic(spectrum, 1.0, damping);
    let sloshing = elastic(periods.convective);
    let factor = site
        .sloshing_factor
        .unwrap_or_else(|| hazard::elastic(spectrum, 1.0, case.damping.sloshing)(periods.convective) / sloshing);
    let (r_i, r_c) = (site.impulsive_reduction, site.sloshing_reduction);
    let sheet = &mut work.sheet;
    for (symbol, name, value, source) in [
        ("γ", "importance factor", gamma, "site.national.importance"),
        ("R_i", "response reduction, impulsive", r_i, "site.national.impulsive_reduction"),
        ("R_c", "response reduction, sloshing", r_c, "site.national.sloshing_reduction"),
        (
            "k",
            "factor of the damping of sloshing",
            factor,
            "site.national.sloshing_factor, or η of EN 1998-1:2004 3.2.2.2",
        ),
        ("k_v", "vertical over horizontal ground acceleration", spectrum.vertical_ratio, hazard::CLAUSE),
    ] {
        sheet.input(symbol, name, value, Dimensionless, source);
    }
    let table = "the user's spectrum over g";
    for (symbol, name, value) in [
        ("S_i", "spectrum at T_i [g]", elastic(impulsive.period)),
        ("S_c", "spectrum at T_c [g]", sloshing),
        ("S_0", "spectrum at T = 0 [g]", elastic(0.0)),
    ] {
        sheet.look_up(symbol, name, table, value / g, Dimensionless, hazard::CLAUSE);
    }
    let a_i = sheet.calc("A_i", "impulsive acceleration [g]", "γ·S_i/R_i", Dimensionless, DATA);
    let a_c = sheet.calc("A_c", "convective acceleration [g]", "γ·k·S_c/R_c", Dimensionless, DATA);
    let name = "acceleration of the sloshing wave, not reduced [g]";
    let a_w = sheet.calc("A_w", name, "A_c·R_c", Dimensionless, DATA);
    let a_v = sheet.calc("A_v", "vertical acceleration [g]", "k_v·γ·S_0", Dimensionless, DATA);
    let importance = (Factor::Importance, gamma);
    let of =
        |period: f64, value: f64, factors: &[(Factor, f64)]| Ordinate::at(period, damping, value * g).split(factors);
    let damped = (Factor::DampingCorrection, factor);
    Ok(Action {
        impulsive: of(impulsive.period, a_i, &[importance, (Factor::BehaviourFactor, 1.0 / r_i)]),
        convective: of(periods.convective, a_c, &[damped, importance, (Factor::BehaviourFactor, 1.0 / r_c)]),
        wave: of(periods.convective, a_w, &[damped, importance]),
        vertical: a_v * g,
    })
}
