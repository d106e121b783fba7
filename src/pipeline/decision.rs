//! Who decides, which limit states are asked for, and which gaps the user accepts.

use codes::Procedure;
use results::{Deciding, Method, Status};
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::check;

use crate::job::Job;

/// Methods that decide: those that the user names, or the editions in force that the site names, under its design spectrum. A method
/// that gave no values does not decide.
pub(super) fn deciding(job: &Job, methods: &[Method]) -> Vec<Deciding> {
    let computed = |id: &str, excitation: Excitation| {
        methods
            .iter()
            .any(|m| m.id == id && m.excitation == excitation && m.status == Status::Computed)
    };
    let decides = |id: &str, excitation: Excitation| {
        computed(id, excitation).then(|| Deciding {
            method: id.to_owned(),
            excitation,
        })
    };
    match job.decision.decide.as_slice() {
        [] => codes::ALL
            .iter()
            .filter(|procedure| procedure.decides(&job.case.site))
            .filter_map(|procedure| decides(procedure.id(), Excitation::Site))
            .collect(),
        // Without a design spectrum a named method decides under the record.
        named => named
            .iter()
            .filter_map(|id| decides(id, Excitation::Site).or_else(|| decides(id, Excitation::Record)))
            .collect(),
    }
}

/// How the limit states of a procedure end, worst first. Under the record there are comparisons only: the codes ask for limit states
/// under their own spectrum.
pub(super) fn checks(procedure: &dyn Procedure, job: &Job, excitation: Excitation, checks: Vec<Check>) -> Vec<Check> {
    let mut checks = match excitation {
        Excitation::Site => check::complete(&procedure.limit_states(&job.case), checks),
        Excitation::Record => check::complete(&[], checks.into_iter().filter(Check::compared).collect()),
    };
    for check in checks.iter_mut().filter(|c| c.status == CheckStatus::NotChecked) {
        let accepted = &job.decision.accepted;
        if let Some(gap) = accepted.iter().find(|a| a.means(procedure.id(), &check.limit_state)) {
            check.status = CheckStatus::Accepted;
            check.note = std::mem::replace(&mut check.reason, gap.reason.clone());
        }
    }
    checks
}

/// Accepted gaps that are none: the limit state is checked, not required, or unknown.
pub(super) fn unused(job: &Job, methods: &[Method]) -> Vec<String> {
    let used = |gap: &check::Accepted| {
        methods.iter().any(|m| {
            let mut accepted = m.checks.iter().filter(|c| c.status == CheckStatus::Accepted);
            accepted.any(|c| gap.means(&m.id, &c.limit_state))
        })
    };
    let unused = job.decision.accepted.iter().filter(|gap| !used(gap));
    unused
        .map(|gap| {
            format!(
                "accepted: `{}` is not an open limit state of this tank; remove the entry",
                gap.check
            )
        })
        .collect()
}
