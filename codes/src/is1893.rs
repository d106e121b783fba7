//! IS 1893-2:2014 and the IITK-GSDMA guidelines of 2007 (`is1893-2014`): the chain of `codes::two_mass` with
//!
//! ```text
//! A_i = Z/2 I/R k_i S_a(T_i)/g      A_c = Z/2 I/R k_c S_a(T_c)/g      A_w = R A_c      A_v = 2/3 Z/2 I/R 2.5
//! S_a/g   hard 1/T, medium 1.36/T, soft 1.67/T, at most 2.5; 0.25, 0.34, 0.42 beyond 4 s
//! k       1.40 at 2 % (steel), 1.0 at 5 % (concrete), 1.75 at 0.5 % (sloshing)
//! p_i     0.866 [1 − (y/H)²] tanh(0.866 r), the other pressures as `two_mass::pressure` has them
//! ```
//!
//! The guideline has the plateau of S_a/g from T = 0 on; the rising branch up to 0.1 s of part 1 is not used, on the safe side.
//!
//! A tank on a staging (`tank.staging`) has its impulsive period, R and resultants from `staging`.

mod limit_states;
mod site;
mod staging;
#[cfg(test)]
mod tests;

use crate::limit_state::LimitStateDef;
use crate::procedure::{CodeError, DesignCurve, Label, Procedure};
use crate::two_mass::{self, Action, Clauses, Impulsive, Masses, Periods, PressureShape, Rules, Work, periods};
use tank::Family;
use tank::assessment::{Assessment, Excitation, LimitState, NotApplicable};
use tank::case::{Case, Site};

/// IS 1893-2:2014 (`is1893-2014`).
#[derive(Clone, Copy, Debug)]
pub struct Is18932014;

const SCOPE: &str = "IS 1893-2:2014 1.1";
const PERIOD: &str = "IITK-GSDMA 2007 4.3.1";

const CLAUSES: Clauses = Clauses {
    masses: "IITK-GSDMA 2007 4.2.1, table 1",
    heights: "IITK-GSDMA 2007 4.2.1, table 1",
    sloshing: "IITK-GSDMA 2007 4.3.2",
    action: "IITK-GSDMA 2007 4.5",
    shear: "IITK-GSDMA 2007 4.6",
    moments: "IITK-GSDMA 2007 4.7",
    wave: "IITK-GSDMA 2007 4.11",
    pressures: "IITK-GSDMA 2007 4.9",
    combination: "IITK-GSDMA 2007 4.9/4.10",
};

impl Procedure for Is18932014 {
    fn id(&self) -> &'static str {
        "is1893-2014"
    }

    fn label(&self) -> Label {
        Label { title: "IS 1893-2:2014, IITK-GSDMA guidelines", short: "IS 1893-2:2014", figure_key: "k-other" }
    }

    fn unasked(&self, site: &Site) -> bool {
        site.is1893.is_some()
    }

    fn data(&self) -> &'static str {
        "`site.is1893`; it decides where `procedures.decide` names it"
    }

    fn table(&self) -> &'static [LimitStateDef] {
        limit_states::TABLE
    }

    fn limit_states(&self, case: &Case) -> Vec<LimitState> {
        match scope(case) {
            Ok(()) => limit_states::all(case),
            Err(_) => Vec::new(),
        }
    }

    fn design_curves(&self, site: &Site, _dampings: &[f64]) -> Vec<DesignCurve> {
        site.is1893.map_or_else(Vec::new, |site| site::curves(&site))
    }

    fn covers_staging(&self) -> bool {
        true
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        Rules::applies(self, case, excitation)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        two_mass::assess(self, case, excitation)
    }
}

/// The tank is of concrete or steel.
fn scope(case: &Case) -> Result<(), NotApplicable> {
    let covered =
        |family: Option<Family>| matches!(family, Some(Family::Concrete | Family::CarbonSteel | Family::Stainless));
    let foreign = case.tank.wall_materials().find(|material| !covered(material.family));
    let Some(material) = foreign else { return Ok(()) };
    let found = material.family.map_or("of a material without a family", Family::name);
    let reason = format!("the code is for walls of concrete or steel; `{}` is {found}", material.name);
    Err(NotApplicable { clause: SCOPE.into(), reason })
}

impl Rules for Is18932014 {
    fn clauses(&self) -> &'static Clauses {
        &CLAUSES
    }

    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        scope(case)?;
        let given = (case.site.is1893.is_some(), "`site.is1893` is not given");
        two_mass::available(case, excitation, CLAUSES.action, given)
    }

    fn impulsive_period(&self, work: &mut Work, masses: &Masses) -> Result<Option<Impulsive>, CodeError> {
        Ok(Some(match work.case.tank.staging {
            Some(staging) => staging::period(work, &staging),
            None => periods::impulsive(work, masses, PERIOD),
        }))
    }

    fn beneath(&self, work: &mut Work) -> Result<(), CodeError> {
        work.case.tank.staging.map_or(Ok(()), |staging| staging::resultants(work, &staging))
    }

    fn action(&self, work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
        site::action(work, periods)
    }

    fn pressures(&self) -> PressureShape {
        PressureShape::Housner
    }

    fn assumptions(&self, case: &Case, excitation: Excitation) -> Vec<String> {
        let mut all = vec![match case.tank.staging {
            Some(_) => "The staging is a spring without inertia of rotation; sloshing and staging are two masses that do not feel each other.",
            None => "The base slab is left out of shear and moments.",
        }
        .to_string()];
        if excitation == Excitation::Site {
            all.push(
                "Spectrum of IS 1893-1 with its plateau from T = 0 on and its last value beyond 4 s, on the safe side."
                    .into(),
            );
        }
        all
    }
}
