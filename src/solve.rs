//! The whole flow of `check --solve`: the largest (of a thickness: smallest) value of one variable at which no check of the deciding
//! procedures fails.
//!
//! The procedures that decide at the given value are asked at every other one; engines do not run. A value at which one of them
//! does not apply, or leaves open a limit state that it checks at the given value, does not count as one that holds.

mod search;
mod variable;

pub use search::{Answer, Found, Search, TOLERANCE, rounded, search};
pub use variable::Variable;

use tank::assessment::Excitation;

use crate::error::Error;
use crate::job::Job;
use crate::pipeline;
use results::{Method, Status, Verdict, VerdictStatus};

/// Solution for one variable.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The variable.
    pub variable: Variable,
    /// Its value in the tank file, in the unit of the variable.
    pub given: f64,
    /// Range that was searched, favourable end first.
    pub range: (f64, f64),
    /// End of the search, with the verdicts.
    pub found: Found<Verdict>,
    /// Number of evaluations of all deciding procedures.
    pub evaluations: usize,
}

impl Solution {
    /// The value and the verdict there; none where no value holds, or the answer is not unique.
    pub fn value(&self) -> Option<(f64, &Verdict)> {
        match &self.found {
            Found::Edge { value, at, .. } | Found::Everywhere { value, at } => Some((*value, at)),
            Found::Nowhere { .. } | Found::Several(_) | Found::Unanswered(_) => None,
        }
    }
}

/// Solves for a variable of a job.
///
/// Errors: a variable that the case does not have; a failure of a procedure at the given value.
pub fn run(job: &Job, variable: Variable) -> Result<Solution, Error> {
    let given = variable.given(&job.case)?;
    let range = variable.range(&job.case);
    let (methods, reference) = pipeline::procedures::decide_without_sheets(job)?;
    let solution = |found, evaluations| Solution { variable, given, range, found, evaluations };
    if reference.status == VerdictStatus::NotAssessed {
        let reason = inapplicable(&methods).unwrap_or_else(|| "no deciding procedure checked a limit state".into());
        return Ok(solution(Found::Unanswered(reason), 1));
    }
    let samples = variable.samples(&job.case, given);
    let mut job = reduced(job, &reference);
    let answer = |value: f64| {
        variable.set(&mut job.case, value);
        match pipeline::procedures::decide_without_sheets(&job) {
            Ok((methods, verdict)) => classify(&reference, &methods, verdict),
            // A procedure that does not converge at a remote value.
            Err(error) => Answer::Outside(error.to_string()),
        }
    };
    let search = search(&samples, answer);
    Ok(solution(search.found, search.evaluations + 1))
}

/// The job with the deciding procedures alone; without the record where they do not use it.
fn reduced(job: &Job, reference: &Verdict) -> Job {
    let mut job = job.clone();
    let decides = |id: &String| reference.deciding.iter().any(|d| d.method == *id);
    job.procedures.retain(decides);
    if reference.deciding.iter().all(|d| d.excitation == Excitation::Site) {
        job.case.ground_motion = None;
    }
    job
}

/// The answer by a verdict; `reference` is that of the given value.
fn classify(reference: &Verdict, methods: &[Method], verdict: Verdict) -> Answer<Verdict> {
    if verdict.deciding != reference.deciding || verdict.status == VerdictStatus::NotAssessed {
        return Answer::Outside(inapplicable(methods).unwrap_or_else(|| "other procedures decide".into()));
    }
    if verdict.status == VerdictStatus::Fails {
        return Answer::Fails(verdict);
    }
    let opened = verdict.missing.iter().find(|gap| {
        let mut known = reference.missing.iter();
        !known.any(|k| k.method == gap.method && k.check.limit_state == gap.check.limit_state)
    });
    match opened {
        Some(gap) => Answer::Outside(format!("{} ({}): {}", gap.check.name, gap.method, gap.check.reason)),
        None => Answer::Holds(verdict),
    }
}

/// Why a procedure does not apply, of the first one that does not.
fn inapplicable(methods: &[Method]) -> Option<String> {
    methods.iter().find_map(|m| match &m.status {
        Status::Computed => None,
        Status::NotApplicable { clause, reason } => Some(format!("{} is not applicable, {clause}: {reason}", m.id)),
    })
}

#[cfg(test)]
mod tests {
    use tank::assessment::{Check, CheckStatus, LimitState, Requirement};
    use tank::units::Dimension;

    use super::*;
    use results::{Deciding, verdict};

    fn method(checks: Vec<Check>) -> Method {
        Method { checks, ..Method::new("code", "code", Excitation::Site) }
    }

    fn judged(methods: &[Method]) -> Verdict {
        let deciding = Deciding { method: "code".into(), excitation: Excitation::Site };
        verdict(methods, vec![deciding], false, None)
    }

    fn check(id: &str, utilisation: f64) -> Check {
        Check::new(id, id, utilisation, 1.0, Dimension::Force, "", "")
    }

    fn gap(id: &'static str) -> Check {
        let state = LimitState { id, name: id, clause: String::new(), requirement: Requirement::Required };
        Check::without_comparison(&state, CheckStatus::NotChecked, "no data", None)
    }

    #[test]
    fn known_gaps_hold_and_new_ones_do_not() {
        let reference = judged(&[method(vec![check("hoop", 0.5), gap("sliding")])]);
        let answer = |methods: &[Method]| classify(&reference, methods, judged(methods));
        let same = [method(vec![check("hoop", 0.9), gap("sliding")])];
        assert!(matches!(answer(&same), Answer::Holds(v) if v.status == VerdictStatus::Incomplete));
        let failed = [method(vec![check("hoop", 1.1), gap("sliding")])];
        assert!(matches!(answer(&failed), Answer::Fails(_)));
        let opened = [method(vec![check("freeboard", 0.1), gap("hoop"), gap("sliding")])];
        assert_eq!(answer(&opened), Answer::Outside("hoop (code): no data".into()));
        // Another procedure, or none, decides.
        let none = [method(Vec::new())];
        assert!(matches!(answer(&none), Answer::Outside(_)));
    }
}
