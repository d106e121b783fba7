//! Who decides, which limit states are asked for, and which gaps the user accepts.

use codes::{Procedure, time_history};
use files::code::{Code, Warning};
use results::{Aside, Deciding, Method, Overruled, Status};
use tank::assessment::{Check, CheckStatus, Excitation, LimitState, Requirement};
use tank::check;
use tank::outside::Outside;

use super::unsaid;
use crate::job::Job;

/// Methods that decide: those that the user names, or the editions in force that the site names, under its design spectrum. A method
/// that gave neither values nor checks does not decide.
pub(super) fn deciding(job: &Job, methods: &[Method]) -> Vec<Deciding> {
    let computed = |id: &str, excitation: Excitation| {
        let of = |m: &&Method| m.id == id && m.excitation == excitation;
        let mut methods = methods.iter().filter(of);
        methods.any(|m| m.status == Status::Computed || !m.checks.is_empty())
    };
    let decides = |id: &str, excitation: Excitation| {
        computed(id, excitation).then(|| Deciding { method: id.to_owned(), excitation })
    };
    // What rests on a recalled clause decides only where the user names it.
    let compared = |id: &str| methods.iter().filter(|m| m.id == id).all(|m| m.recalled.is_empty());
    match job.decision.decide.as_slice() {
        [] => codes::ALL
            .iter()
            .filter(|procedure| procedure.decides(&job.case.site) && compared(procedure.id()))
            .filter_map(|procedure| decides(procedure.id(), Excitation::Site))
            .collect(),
        // Without a design spectrum a named method decides under the record; one that did not run decides all the same.
        named => named
            .iter()
            .map(|id| {
                // An engine is checked under the record alone.
                let code = codes::ALL.iter().any(|procedure| procedure.id() == id);
                let excitation = match code {
                    true if computed(id, Excitation::Site) => Excitation::Site,
                    // Under neither: it is missing where the code asks for it.
                    true if !computed(id, Excitation::Record) && job.case.site.is_given() => Excitation::Site,
                    _ => Excitation::Record,
                };
                Deciding { method: id.clone(), excitation }
            })
            .collect(),
    }
}

/// Procedures that the site names, in force or with data of their own there, of which a check fails and which do not decide: the user names others, or has to
/// name them.
pub(super) fn overruled(job: &Job, methods: &[Method]) -> Vec<Overruled> {
    let (site, deciding) = (&job.case.site, deciding(job, methods));
    let left_out = |m: &&Method| m.excitation == Excitation::Site && deciding.iter().all(|d| d.method != m.id);
    let named = |p: &&&dyn Procedure| p.decides(site) || (p.unasked(site) && !p.data().is_empty());
    let methods = methods.iter().filter(left_out).filter(|m| codes::ALL.iter().filter(named).any(|p| p.id() == m.id));
    let asides = methods.map(|method| Overruled { method: method.id.clone(), checks: Aside::of(method) });
    asides.filter(|o| o.checks.counts.fails > 0).collect()
}

/// The limit states asked of a procedure under an excitation. Under the record there are none, because the codes ask for them under
/// their own spectrum, unless the user lets the procedure decide there. A procedure that is to decide and declares none has one that
/// is open: its comparisons alone are no verdict.
fn asked(procedure: &dyn Procedure, job: &Job, excitation: Excitation) -> Vec<LimitState> {
    let named = job.decision.decide.iter().any(|id| id == procedure.id());
    let only_record = || procedure.applies(&job.case, Excitation::Site).is_err();
    if excitation == Excitation::Record && !(named && only_record()) {
        return Vec::new();
    }
    let mut states = procedure.limit_states(&job.case);
    unsaid::without(job, &mut states);
    if named && states.is_empty() {
        states.push(LimitState {
            id: "undeclared",
            name: "Other limit states of the code",
            clause: format!("the list of limit states of {}", procedure.label().title),
            requirement: Requirement::NotImplemented,
        });
    }
    states
}

/// How the limit states of a procedure end, worst first. Under the record there are comparisons, and what is missing only where the
/// procedure decides.
pub(super) fn checks(procedure: &dyn Procedure, job: &Job, excitation: Excitation, checks: Vec<Check>) -> Vec<Check> {
    let states = asked(procedure, job, excitation);
    let compared = |check: &Check| excitation == Excitation::Site || !states.is_empty() || check.compared();
    let isolated = job.case.tank.isolators.is_some();
    // The procedure assumes a base that does not move.
    let known = |check: Check| if isolated && check.compared() { check.left_open(ON_ISOLATORS.into()) } else { check };
    let checks: Vec<Check> = checks.into_iter().filter(compared).map(known).collect();
    let checks = if states.is_empty() { checks } else { unsaid::leave_open(job, unsaid::required(&states, checks)) };
    end(procedure.id(), job, &states, checks)
}

/// Why a code leaves a tank on isolators open.
const ON_ISOLATORS: &str = "the tank moves on its isolators, which this procedure does not know; `procedures.decide: [\"fe\"]` lets the time history decide";

/// How the limit states of an engine under the record end, worst first.
///
/// * `id`: its column
pub(super) fn checks_of_run(job: &Job, id: &str, checks: Vec<Check>) -> Vec<Check> {
    let judges = time_history::counted(&job.case, &job.decision.decide);
    let mut states = time_history::limit_states(&job.case, &judges);
    unsaid::without(job, &mut states);
    end(id, job, &states, unsaid::required(&states, checks))
}

/// The limit states of a procedure that does not cover the tank although the site gives its data: what its code requires was not
/// checked, so no other code may hold in its place. None for a procedure that does not decide.
///
/// * `refusal`: why it does not cover the tank
pub(super) fn not_covered(procedure: &dyn Procedure, job: &Job, excitation: Excitation, refusal: &str) -> Vec<Check> {
    let decide = &job.decision.decide;
    let decides =
        procedure.decides(&job.case.site) && (decide.is_empty() || decide.iter().any(|id| id == procedure.id()));
    if excitation == Excitation::Record || !decides {
        return Vec::new();
    }
    let states = procedure.limit_states(&job.case);
    let required = states.iter().filter(|s| !matches!(s.requirement, Requirement::NotApplicable(_)));
    let open = |state: &LimitState| Check::without_comparison(state, CheckStatus::NotChecked, refusal, None);
    let checks = check::complete(&states, required.map(open).collect());
    accept(procedure.id(), job, checks)
}

/// Why a procedure in force of a code that the site names is not there: `procedures.run` leaves it out. None for a procedure that runs,
/// or that the user leaves out of those that decide.
pub(super) fn left_out(procedure: &dyn Procedure, job: &Job) -> Option<Method> {
    let runs = job.procedures.iter().any(|id| id == procedure.id());
    let decide = &job.decision.decide;
    let excluded = !decide.is_empty() && !decide.iter().any(|id| id == procedure.id());
    if runs || excluded || !procedure.decides(&job.case.site) {
        return None;
    }
    let reason =
        format!("`procedures.run` leaves out `{}`, the edition in force of a code that `site` names", procedure.id());
    let state = LimitState {
        id: "not_run",
        name: "All limit states of the code",
        clause: procedure.label().title.into(),
        requirement: Requirement::Required,
    };
    let open = Check::without_comparison(&state, CheckStatus::NotChecked, &reason, Some("procedures.run"));
    let label = procedure.label();
    Some(Method {
        label: label.short.into(),
        figure_key: label.figure_key.into(),
        status: Status::NotApplicable { clause: "procedures.run".into(), reason },
        checks: accept(procedure.id(), job, vec![open]),
        ..Method::new(procedure.id(), label.title, Excitation::Site)
    })
}

/// How all limit states end: those without a check with the reason, accepted gaps marked.
fn end(id: &str, job: &Job, states: &[LimitState], checks: Vec<Check>) -> Vec<Check> {
    accept(id, job, unsaid::contradicted(job, check::complete(states, checks)))
}

/// The same checks, those marked that the user accepts; worst first, so that an accepted gap does not stand before an open one. A run
/// outside its model cannot be accepted.
fn accept(id: &str, job: &Job, mut checks: Vec<Check>) -> Vec<Check> {
    let outside = |c: &Check| Outside::ALL.iter().any(|why| why.limit_state() == c.limit_state);
    let open = |c: &&mut Check| c.status == CheckStatus::NotChecked && !outside(c);
    for check in checks.iter_mut().filter(open) {
        let accepted = &job.decision.accepted;
        if let Some(gap) = accepted.iter().find(|a| a.means(id, &check.limit_state)) {
            check.status = CheckStatus::Accepted;
            check.note = std::mem::replace(&mut check.reason, gap.reason.clone());
            check.accepted = Some(gap.approval.clone());
        }
    }
    check::complete(&[], checks)
}

/// Accepted gaps that are none: the limit state is checked, not required, or unknown.
pub(super) fn unused(job: &Job, methods: &[Method]) -> Vec<Warning> {
    let used = |gap: &check::Accepted| {
        methods.iter().any(|m| {
            let mut accepted = m.checks.iter().filter(|c| c.status == CheckStatus::Accepted);
            accepted.any(|c| gap.means(&m.id, &c.limit_state))
        })
    };
    let unused = job.decision.accepted.iter().filter(|gap| !used(gap));
    let text = |gap: &check::Accepted| {
        let why = Outside::ALL.iter().find(|why| gap.check.ends_with(why.limit_state()));
        if let Some(why) = why {
            let run = match why {
                Outside::Uplift => "a run that clamps a wall that lifts",
                Outside::Plates => "a run whose cantilevers stand for plates",
            };
            return format!("accepted: `{}` cannot be accepted: {run} is outside its model", gap.check);
        }
        let fails = |m: &Method| {
            let mut failing = m.checks.iter().filter(|c| c.status == CheckStatus::Fails);
            failing.any(|c| gap.means(&m.id, &c.limit_state))
        };
        if methods.iter().any(fails) {
            return format!("accepted: `{}` fails; only what was not checked can be accepted", gap.check);
        }
        let open = methods.iter().flat_map(|m| &m.checks).filter(|c| c.status == CheckStatus::NotChecked);
        let own = gap.check.rsplit('/').next().unwrap_or_default();
        let near = open
            .map(|c| (strsim::damerau_levenshtein(own, &c.limit_state), &c.limit_state))
            .filter(|(distance, id)| distance * 3 <= own.len().max(id.len()))
            .min_by_key(|(distance, _)| *distance);
        match near {
            Some((_, near)) => format!(
                "accepted: `{}` is not a limit state of this tank; did you mean `{near}`, which is open?",
                gap.check
            ),
            None => format!("accepted: `{}` is not an open limit state of this tank; remove the entry", gap.check),
        }
    };
    unused.map(|gap| Warning::new(Code::UnusedAcceptance, text(gap))).collect()
}
