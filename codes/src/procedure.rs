//! What a code procedure is.

use tank::assessment::{Assessment, Excitation, NotApplicable};
use tank::case::Case;

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
        /// What was iterated.
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
        /// What is missing, what is allowed.
        reason: String,
    },
}

/// A code procedure of one edition.
pub trait Procedure: Sync {
    /// Id as in `results.json` (`housner`, `ec8-env`, `ec8-2006`, `api650-1993`, `api650-2020`).
    fn id(&self) -> &'static str;
    /// Title with edition ("EN 1998-4:2006, annex A").
    fn title(&self) -> &'static str;
    /// Whether the procedure covers this case under this excitation; if not, the clause and the reason.
    fn applies(&self, case: &Case, excitation: Excitation) -> Result<(), NotApplicable>;
    /// Runs the procedure. Callers need not call [`Procedure::applies`] before.
    fn assess(&self, case: &Case, excitation: Excitation) -> Result<Assessment, CodeError>;
}

/// All procedures in report order.
pub const ALL: &[&dyn Procedure] = &[
    &crate::housner::Housner,
    &crate::ec8::Env1998,
    &crate::ec8::En2006,
    &crate::api650::edition1993::Api6501993,
    &crate::api650::edition2020::Api6502020,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The order of the report, each id once; every id leads to a title of its own that names the edition.
    #[test]
    fn procedures_in_report_order() {
        let ids: Vec<_> = ALL.iter().map(|p| p.id()).collect();
        assert_eq!(ids, ["housner", "ec8-env", "ec8-2006", "api650-1993", "api650-2020"]);
        for (procedure, part) in ALL
            .iter()
            .zip(["Housner", "ENV 1998-4:1998", "EN 1998-4:2006", "1993", "2020"])
        {
            assert!(procedure.title().contains(part), "{}", procedure.title());
        }
    }
}
