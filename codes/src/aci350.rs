//! ACI 350.3-06, seismic design of liquid-containing concrete structures (`aci350-2006`): the chain of `codes::two_mass` with
//!
//! ```text
//! ε    = min(1, 0.0151 r² − 0.1908 r + 1.021)
//! T_i    circle, fixed or hinged   2π H/(C_l √(E/ρ_w))     C_l = 10 C_w √(t/R)     C_w polynomial of x = H/D, 0.1 to 3
//!        circle, flexible          √(8π (m_w + m_r + m_i)/(D k_a))                 k_a stiffness of the joint per length
//!        rectangle                 2π √((m′_w + m′_i)/k)   k = E/4 (t/h)³          cantilever, per length of wall
//! C_i  = S_DS (T_i ≤ T_S), else S_D1/T_i
//! C_c  = 1.5 S_D1/T_c ≤ 1.5 S_DS (T_c ≤ 1.6/T_S), else 2.4 S_DS/T_c²
//! A_i  = C_i I/R_i      A_c = C_c I/R_c      A_w = C_c I
//! A_v  = C_t I b/R_i ≥ 0.2 S_DS      b = 2/3      C_t = S_DS (T_v ≤ T_S), else S_D1/T_v; 0.4 S_DS in a rectangle
//! T_v  = 2π √(ρ D H²/(2 t E))
//! ```
//!
//! S_DS and S_D1 are those of `site.api650` (ASCE 7). Often ε is found with 0.051 for 0.0151: the edition has 0.0151. T_v is also printed with
//! 24 for the 2, which is the form with t in inches and D in feet.
//!
//! R_i by kind, table 4.1.1(b): anchored flexible base 3.25, fixed or hinged 2.0, unanchored 1.5; R_c = 1. The edition of 2001 has other values.
//! `docs/theory/two-masses.md` says how each coefficient is known.

mod limit_states;
mod periods;
mod site;
#[cfg(test)]
mod tests;

use crate::limit_state::LimitStateDef;
use crate::procedure::{CodeError, DesignCurve, Label, Procedure};
use crate::two_mass::{self, Action, Clauses, Impulsive, Masses, Periods, PressureShape, Rules, Work};
use tank::assessment::{Assessment, Excitation, LimitState, NotApplicable};
use tank::case::{Case, Site};
use tank::units::Dimension::Dimensionless;
use tank::{Family, Shape, Support, WallBase};

/// ACI 350.3-06 (`aci350-2006`).
#[derive(Clone, Copy, Debug)]
pub struct Aci3502006;

const SCOPE: &str = "ACI 350.3-06 1.1";
const SHARE: &str = "ACI 350.3-06 9.5";

const CLAUSES: Clauses = Clauses {
    masses: "ACI 350.3-06 9.2.1, 9.3.1",
    heights: "ACI 350.3-06 9.2.2 to 9.2.3, 9.3.2 to 9.3.3",
    sloshing: "ACI 350.3-06 9.2.4, 9.3.4",
    action: "ACI 350.3-06 9.4",
    shear: "ACI 350.3-06 4.1.1, 4.1.2",
    moments: "ACI 350.3-06 4.1.3",
    wave: "ACI 350.3-06 7.1",
    pressures: "ACI 350.3-06 5.3, R5.3",
    combination: "ACI 350.3-06 4.1.2/5.3, recalled",
};

impl Procedure for Aci3502006 {
    fn id(&self) -> &'static str {
        "aci350-2006"
    }

    fn label(&self) -> Label {
        Label { title: "ACI 350.3-06", short: "ACI 350.3-06", figure_key: "k-other" }
    }

    /// Its site data are those of API 650, which most tanks that give them do not want judged by it.
    fn unasked(&self, _site: &Site) -> bool {
        false
    }

    fn data(&self) -> &'static str {
        "`site.api650`, whose data of ASCE 7 it takes; `procedures.run` or `procedures.decide` names it"
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
        site::curves(site)
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        Rules::applies(self, case, excitation)
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        two_mass::assess(self, case, excitation)
    }
}

/// The tank is of concrete.
fn scope(case: &Case) -> Result<(), NotApplicable> {
    let foreign = case.tank.wall_materials().find(|material| material.family != Some(Family::Concrete));
    let Some(material) = foreign else { return Ok(()) };
    let found = material.family.map_or("of a material without a family", Family::name);
    let reason = format!("the code is for walls of concrete; `{}` is {found}", material.name);
    Err(NotApplicable { clause: SCOPE.into(), reason })
}

/// What holds the wall, which R_i and the period follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Fixed or hinged base.
    Fixed,
    /// Anchored flexible base.
    Flexible,
    /// Base that is not anchored.
    Unanchored,
}

impl Kind {
    fn of(case: &Case) -> Kind {
        match (case.tank.support, case.tank.wall_base) {
            (Support::Unanchored, _) => Kind::Unanchored,
            (Support::Anchored, WallBase::Sliding { .. }) => Kind::Flexible,
            (Support::Anchored, WallBase::Fixed | WallBase::Hinged) => Kind::Fixed,
        }
    }
}

impl Rules for Aci3502006 {
    fn clauses(&self) -> &'static Clauses {
        &CLAUSES
    }

    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        scope(case)?;
        let given = (case.site.api650.is_some(), "`site.api650` is not given, whose data of ASCE 7 it takes");
        two_mass::available(case, excitation, CLAUSES.action, given)
    }

    fn impulsive_period(&self, work: &mut Work, masses: &Masses) -> Result<Option<Impulsive>, CodeError> {
        match work.case.tank.shape {
            Shape::Cylinder { radius } if Kind::of(work.case) == Kind::Fixed => Ok(periods::shell(work, radius)),
            Shape::Cylinder { .. } => periods::flexible(work).map(Some),
            Shape::Rectangle { .. } => Ok(Some(periods::cantilever(work, masses))),
        }
    }

    fn action(&self, work: &mut Work, periods: &Periods) -> Result<Action, CodeError> {
        site::action(work, periods)
    }

    fn wall_share(&self, work: &mut Work) -> Option<f64> {
        let (name, formula) = ("share of the wall's inertia", "min(1, 0.0151·r² - 0.1908·r + 1.021)");
        Some(work.sheet.calc("ε", name, formula, Dimensionless, SHARE))
    }

    fn pressures(&self) -> PressureShape {
        PressureShape::Linear
    }

    fn assumptions(&self, case: &Case, excitation: Excitation) -> Vec<String> {
        let mut all = vec!["The modulus of the concrete is that of the tank file.".to_string()];
        if excitation == Excitation::Site {
            all.push(
                "Site data of ASCE 7 as in `site.api650`; importance factor of table 4.1.1(a) by its seismic use group: 1.0, 1.25, 1.5.".into(),
            );
        }
        if Kind::of(case) == Kind::Flexible {
            all.push(
                "The joint of the flexible base is as stiff along the circumference as along the radius (`tank.wall_base.stiffness`).".into(),
            );
        }
        all
    }
}
