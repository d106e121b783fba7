//! The trait of code procedures.

use tank::assessment::{Assessment, Excitation, LimitState, NotApplicable};
use tank::case::{Case, Site};
use tank::formula::FormulaError;

use crate::limit_state::LimitStateDef;
use crate::modal_action::ModalAction;

/// Failure of a computation inside a procedure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CodeError {
    /// Outside the procedure's scope.
    #[error(transparent)]
    NotApplicable(#[from] NotApplicable),
    /// An iteration did not converge.
    #[error("{clause}: {what} did not converge in {iterations} iterations (last change {change:.3e})")]
    NotConverged {
        /// Clause.
        clause: String,
        /// The iterated quantity.
        what: String,
        /// Number of iterations.
        iterations: usize,
        /// Last relative change.
        change: f64,
    },
    /// Data needed for this step is missing or inadmissible.
    #[error("{clause}: {reason}")]
    Data {
        /// Clause.
        clause: String,
        /// Missing or inadmissible datum, and the allowed values.
        reason: String,
    },
    /// A formula of the calculation sheet cannot be evaluated: a fault of the procedure, not of the data.
    #[error("calculation sheet: {0}")]
    Formula(#[from] FormulaError),
}

/// How a procedure is named and drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// Title with edition ("EN 1998-4:2006, annex A").
    pub title: &'static str,
    /// Short label for figures and tables ("EN 1998-4:2006").
    pub short: &'static str,
    /// Class of its colour and dash in `templates/figure.css` ("k-ec8-2006").
    pub figure_key: &'static str,
}

/// A design spectrum, drawn with the record's.
pub struct DesignCurve {
    /// Id of the curve, unique among the curves of a report.
    pub id: String,
    /// Title for the legend.
    pub title: String,
    /// Damping ratio.
    pub damping: f64,
    /// Longest period that it covers [s]; infinite for the spectra of the codes.
    pub longest: f64,
    /// Spectral acceleration [m/s²] at a period [s].
    pub acceleration: Box<dyn Fn(f64) -> f64>,
}

/// A code procedure of one edition. All that belongs to it stands in its folder; other crates find it in [`crate::ALL`].
pub trait Procedure: Sync {
    /// Id as in `results.json` and in `procedures` of the tank file.
    fn id(&self) -> &'static str;
    /// How it is named and drawn.
    fn label(&self) -> Label;
    /// Whether it is the edition in force of a code that the site names, so that it decides unless the user says otherwise.
    fn decides(&self, _site: &Site) -> bool {
        false
    }
    /// Whether it runs on this site where the tank file does not name it: a procedure that few tanks ask for does not.
    fn unasked(&self, _site: &Site) -> bool {
        true
    }
    /// Where its site data stand in the tank file, in words; empty where nothing is to be said.
    fn data(&self) -> &'static str {
        ""
    }
    /// The limit states that the code knows, in the order of its checks.
    fn table(&self) -> &'static [LimitStateDef] {
        &[]
    }
    /// The limit states that the code requires of a tank, and those that it does not require of this one. Each check of
    /// [`Procedure::assess`] belongs to one of them.
    fn limit_states(&self, _case: &Case) -> Vec<LimitState> {
        Vec::new()
    }
    /// Design spectra of the site at the damping ratios asked for; none where the site is not given or not covered.
    fn design_curves(&self, _site: &Site, _dampings: &[f64]) -> Vec<DesignCurve> {
        Vec::new()
    }
    /// Its design spectrum for the modes of an engine, as [`crate::modal_action`] describes; none where the site does not give its data.
    ///
    /// * `reduced`: whether by behaviour factor or response modification
    fn modal_action<'a>(&self, _case: &'a Case, _reduced: bool) -> Option<Result<ModalAction<'a>, CodeError>> {
        None
    }
    /// Share of the roof's snow load that it counts as mass. [`Procedure::assess`] puts this share in place of the one in the case.
    fn snow_share(&self, _case: &Case) -> f64 {
        0.0
    }
    /// Whether it has rules for a tank on a staging.
    fn covers_staging(&self) -> bool {
        false
    }
    /// Whether the procedure covers this case under this excitation, its staging apart; if not, the clause and the reason.
    fn covers(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable>;
    /// Runs the procedure on a tank whose staging it covers. Callers need not call [`Procedure::covers`] before.
    fn run(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError>;
    /// Whether the procedure covers this case under this excitation; if not, the clause and the reason.
    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
        standing(case, self.covers_staging())?;
        self.covers(case, excitation)
    }
    /// Runs the procedure. Callers need not call [`Procedure::applies`] before.
    fn assess(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError> {
        standing(case, self.covers_staging())?;
        self.run(case, excitation)
    }
}

/// Refuses a tank on a staging which a procedure does not cover.
fn standing(case: &Case, covered: bool) -> Result<(), NotApplicable> {
    if covered || case.tank.staging.is_none() {
        return Ok(());
    }
    let reason = "the tank stands on a staging; this procedure is for tanks on the ground";
    Err(NotApplicable { clause: "tank.staging".into(), reason: reason.into() })
}
