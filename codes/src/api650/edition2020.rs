//! Annex E of the 12th and 13th edition (2013, 2020).
//!
//! ```text
//! A_i = S_DS I/R_wi                          not below 0.007, on site classes E and F not below 0.5 S_1 I/R_wi
//! A_c = K S_D1 (1/T_c or T_L/T_c²) I/R_wc    not above A_i;  K = 1.5 takes 5 % to 0.5 % damping
//! A_v = 0.47 S_DS
//!
//! V    = √(V_i² + V_c²)        V_i = A_i (W_s + W_r + W_f + W_i)      V_c = A_c W_c
//! M_rw = √([A_i (W_i X_i  + W_s X_s + W_r X_r)]² + [A_c W_c X_c ]²)   ringwall: just above the bottom
//! M_s  = √([A_i (W_i X_is + W_s X_s + W_r X_r)]² + [A_c W_c X_cs]²)   slab: with base pressure
//! J    = M_rw/(D² [w_t (1 − 0.4 A_v) + w_a − F_p w_int])
//! δ_s  = 0.42 D A_f
//! ```
//!
//! * [`Excitation::Site`]: the annex with all its checks.
//! * [`Excitation::Record`]: A_i and A_c are the record's spectral accelerations at T_i and T_c with the damping of the
//!   case, unreduced (R_w = 1, I = 1, no K, no limit of A_c by A_i), so that they are comparable with a linear time
//!   history. The annex sizes tanks for reduced forces, so its checks are left out there; their terms are shown.
//!
//! Modules: [`accelerations`] (E.4), [`forces`] (E.6.1, E.7.2), `hoop_check` (E.6.1.4, E.6.2.4), `resistance` (E.6.2, E.7),
//! `anchors` (E.6.2.1.2, 5.12.2, 5.12.3), `foundation` (E.6.2.3), `details` (E.7.4, E.7.7, E.7.9),
//! `upper_courses` (E.6.2.2 above the bottom course), `piping` (E.7.3), `combinations` (the factors of the loads), `soil` (ASCE 7 chapter 19).

pub mod accelerations;
pub(crate) mod anchors;
mod combinations;
#[cfg(test)]
mod detail_tests;
mod details;
pub mod factors;
pub mod forces;
mod foundation;
pub(crate) mod hoop_check;
mod ingredients;
pub(crate) mod limit_states;
mod modal;
mod piping;
mod resistance;
#[cfg(test)]
mod rest_tests;
mod site_spectrum;
mod soil;
#[cfg(test)]
mod tests;
mod upper_courses;

use crate::api650::ground_motion::DesignSpectrum;
use crate::api650::site_specific::SiteSpecific;
use crate::base_state::BaseState;
use crate::hazard;
use crate::limit_state::LimitStateDef;
use crate::modal_action::ModalAction;
use crate::procedure::{CodeError, DesignCurve, Label, Procedure};
use crate::roof::SNOW_OF_API;
use crate::sheet::Sheet;
use tank::STANDARD_GRAVITY;
use tank::assessment::{Assessment, Check, CheckStatus, Excitation, LimitState, NotApplicable};
use tank::case::Site;
use tank::case::{Api650Site, Case};
use tank::quantity::Quantity;
use tank::units::Dimension;

use super::basis::Basis;

/// Edition as cited.
const EDITION: &str = "API 650:2020";

/// Least ratio F_p of operating to design pressure (E.2.2, recalled).
const LEAST_F_P: f64 = 0.4;

/// Annex E, 12th and 13th edition (`api650-2020`).
#[derive(Clone, Copy, Debug)]
pub struct Api6502020;

/// Width of the bottom plate that holds the shell down.
#[derive(Clone, Debug)]
enum HoldDown {
    /// That of the sheet's line L.
    Width,
    /// The weight alone holds the shell down.
    Needless,
    /// Why it is not known; the missing input.
    Unknown(String, Option<String>),
}

/// One run: the tank, the actions so far, the growing sheet and assessment.
struct Run<'a> {
    basis: Basis<'a>,
    /// Site data; present under [`Excitation::Site`], and under a record where the case has them.
    site: Option<&'a Api650Site>,
    excitation: Excitation,
    sheet: Sheet,
    out: Assessment,
    /// What the base does.
    base: BaseState,
    /// Compression of the bottom course σ_c [Pa], where it was computed.
    compression: Option<f64>,
    /// Width of the bottom plate that holds the shell down.
    hold_down: HoldDown,
}

impl<'a> Run<'a> {
    /// Before anything is computed.
    fn new(basis: Basis<'a>, excitation: Excitation) -> Run<'a> {
        Run {
            basis,
            site: basis.case.site.api650.as_ref(),
            excitation,
            sheet: Sheet::new(),
            out: Assessment::default(),
            base: BaseState::Bears,
            compression: None,
            hold_down: HoldDown::Needless,
        }
    }
}

/// Welds and support of the plates under the shell, which no action changes.
pub(super) fn details_of_base(case: &Case) -> Vec<Check> {
    let Ok(basis) = Basis::new(case, EDITION) else { return Vec::new() };
    let mut run = Run::new(basis, Excitation::Site);
    run.annular_weld();
    run.shell_support();
    run.out.checks
}

impl Run<'_> {
    /// Adds a check of the annex; none under a record's unreduced forces (module description).
    fn check(
        &mut self,
        id: &str,
        name: &str,
        demand: f64,
        capacity: f64,
        dimension: Dimension,
        clause: &str,
        note: &str,
    ) {
        if self.excitation == Excitation::Site {
            self.out.checks.push(Check::new(id, name, demand, capacity, dimension, clause, note));
        }
    }

    /// Ends a limit state of the annex without a comparison; nothing under a record.
    fn without_comparison(&mut self, id: &str, status: CheckStatus, reason: &str, input: Option<&str>) {
        let states = limit_states::all(self.basis.case);
        if let (Excitation::Site, Some(state)) = (self.excitation, states.iter().find(|state| state.id == id)) {
            self.out.checks.push(Check::without_comparison(state, status, reason, input));
        }
    }

    /// A limit state that was not checked because a value is missing.
    fn missing(&mut self, id: &str, input: &str) {
        let reason = format!("`{input}` is missing");
        self.without_comparison(id, CheckStatus::NotChecked, &reason, Some(input));
    }

    /// Ratio F_p of operating to design pressure, with which the pressure lifts beside the earthquake.
    fn f_p(&self) -> f64 {
        let design = self.pressure();
        if design > 0.0 { (self.basis.case.tank.pressure.internal / design).clamp(LEAST_F_P, 1.0) } else { LEAST_F_P }
    }

    /// Design pressure above the liquid [Pa], at least the overpressure in operation.
    fn pressure(&self) -> f64 {
        let design = self.site.map_or(0.0, |s| s.design_pressure);
        design.max(self.basis.case.tank.pressure.internal)
    }
}

impl Procedure for Api6502020 {
    fn id(&self) -> &'static str {
        "api650-2020"
    }

    fn label(&self) -> Label {
        Label {
            title: "API 650, annex E (12th edition 2013, 13th edition 2020)",
            short: "API 650 annex E",
            figure_key: "k-api650-2020",
        }
    }

    fn decides(&self, site: &Site) -> bool {
        site.api650.is_some()
    }

    fn table(&self) -> &'static [LimitStateDef] {
        limit_states::TABLE
    }

    fn limit_states(&self, case: &Case) -> Vec<LimitState> {
        match Basis::new(case, EDITION) {
            Ok(_) => limit_states::all(case),
            Err(_) => Vec::new(),
        }
    }

    /// ASCE 7 has one shape for all damping ratios; API 650 E.4.6 raises its sloshing branch by K = 1.5.
    fn design_curves(&self, site: &Site, _dampings: &[f64]) -> Vec<DesignCurve> {
        let Some(annex) = &site.api650 else { return Vec::new() };
        let (title, acceleration): (_, Box<dyn Fn(f64) -> f64>) = match SiteSpecific::new(site, annex) {
            Ok(Some(own)) => {
                ("Own spectrum under API 650, ξ = 5 %", Box::new(move |t| own.acceleration(t) * STANDARD_GRAVITY))
            }
            Ok(None) => match DesignSpectrum::new(annex) {
                Ok(spectrum) => {
                    ("ASCE 7 design, ξ = 5 %", Box::new(move |t| spectrum.acceleration(t) * STANDARD_GRAVITY))
                }
                Err(_) => return Vec::new(),
            },
            Err(_) => return Vec::new(),
        };
        vec![DesignCurve {
            id: "asce7-0.05".into(),
            title: title.into(),
            damping: 0.05,
            longest: site.spectrum.as_ref().map_or(f64::INFINITY, hazard::longest),
            acceleration,
        }]
    }

    fn modal_action<'a>(&self, case: &'a Case, reduced: bool) -> Option<Result<ModalAction<'a>, CodeError>> {
        let annex = case.site.api650.as_ref()?;
        Some(modal::action(case, annex, reduced))
    }

    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        Basis::new(case, EDITION)?;
        let reason = match excitation {
            Excitation::Record if case.ground_motion.is_none() => "no record given",
            Excitation::Site if case.site.api650.is_none() => "`site.api650` is not given",
            _ => return Ok(()),
        };
        Err(NotApplicable { clause: "API 650:2020 E.4".into(), reason: reason.into() })
    }

    fn snow_share(&self, _case: &Case) -> f64 {
        SNOW_OF_API
    }

    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        self.covers(case, excitation)?;
        let case = &*case.with_snow(self.snow_share(case));
        let basis = Basis::new(case, EDITION)?;
        let mut run = Run::new(basis, excitation);
        basis.assumptions(&mut run.out, true);
        run.combinations();
        basis.inputs(&mut run.sheet, ("X_r", case.tank.roof_height()));
        let periods = run.periods();
        let a = run.accelerations(&periods)?;
        let forces = run.forces();
        let delta = run.sloshing();
        let hoop = run.hoop(&a);
        let axial = run.resistance(&a, &forces);
        run.upper_courses(&a, &forces);
        run.piping();
        run.annular_weld();
        run.shell_support();
        run.bottom_connections();
        run.foundation(&a, &forces);
        run.soil(&periods, &forces);
        run.base.follow(&mut run.out.checks);

        let g = case.gravity;
        run.out.ingredients = run.ingredients(&periods, &a, &forces);
        let values = &mut run.out.values;
        values.extend([
            (Quantity::SloshingPeriod, periods.convective),
            (Quantity::SloshingHeight, delta),
            (Quantity::ImpulsiveMass, forces.w_i / g),
            (Quantity::WallMass, run.basis.w_s / g),
            (Quantity::ConvectiveMass, forces.w_c / g),
            (Quantity::BaseShear, forces.v),
            (Quantity::BaseMoment, forces.m_rw),
            (Quantity::OverturningMoment, forces.m_s),
            (Quantity::HoopStress, hoop),
            (Quantity::AxialMembraneStress, axial),
        ]);
        if run.basis.w_r > 0.0 {
            values.insert(Quantity::RoofMass, run.basis.w_r / g);
        }
        if let Some(t_i) = periods.impulsive {
            values.insert(Quantity::ImpulsivePeriod, t_i);
        }
        if excitation == Excitation::Record {
            run.out.notes.push(
                "The annex sizes tanks for forces reduced by R_w; its checks are made under `site` only, with those forces.".into(),
            );
        }
        run.out.steps = run.sheet.into_steps()?;
        Ok(run.out)
    }
}
