//! Whether the tank holds, and whether the results are complete.

use files::code::{Code, Warning};
use results::compare::{Incomplete, Unusable};
use results::{Aside, Counts, Deciding, MESH_ERROR_LIMIT, Method, Overruled, Results, Status, Verdict, VerdictStatus};
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::units::{Dimension, display};
use tank::{Shape, WallBase};

/// Why the values of a run with separation are not design values.
pub const LIQUID_PARTED: &str = "The liquid has separated from the wall and closed again. An incompressible liquid on a stiff joint \
                                 exaggerates the impact, and a liquid separates from a tight wall near -98 kPa, not at atmospheric \
                                 pressure: forces and stresses after the first separation are not design values.";

/// The verdict in one line, with the deciding methods that rest on recalled clauses.
pub fn headline(verdict: &Verdict) -> String {
    let outcome = outcome(verdict);
    match verdict.recalled.as_slice() {
        [] => outcome,
        methods => format!("{outcome}; on clauses recalled, not compared with the code: {}", methods.join(", ")),
    }
}

/// What the checks amount to.
fn outcome(verdict: &Verdict) -> String {
    if verdict.unfinished {
        return verdict.cause.as_ref().map_or_else(
            || "Incomplete: the finite-element run was interrupted, its extremes are not final".into(),
            incomplete,
        );
    }
    let counts = &verdict.counts;
    let compared = counts.compared();
    let open = match counts.not_checked {
        0 => String::new(),
        open => format!(", {open} not checked"),
    };
    let within = match counts.within_error {
        0 => String::new(),
        within => format!(", {within} within the discretisation error"),
    };
    match verdict.status {
        VerdictStatus::Holds => match (compared, counts.accepted) {
            (1, 0) => format!("Holds: the one required limit state was checked{within}"),
            (all, 0) => format!("Holds: all {all} required limit states were checked{within}"),
            (checked, accepted) => format!(
                "Holds, with {accepted} {} accepted: {checked} of {} required limit states {} checked{within}",
                plural(accepted, "gap", "gaps"),
                checked + accepted,
                plural(checked, "was", "were")
            ),
        },
        VerdictStatus::Fails => format!(
            "Fails: {} of {compared} {} {}{open}",
            counts.fails,
            plural(compared, "check", "checks"),
            plural(counts.fails, "fails", "fail")
        ),
        VerdictStatus::Incomplete if counts.not_checked == 0 => {
            let silent: Vec<&str> = verdict.silent.iter().map(|d| d.method.as_str()).collect();
            format!("Incomplete: {} decides and checks no limit state", silent.join(", "))
        }
        VerdictStatus::Incomplete => format!(
            "Incomplete: {} of {} required limit states {} not checked; no check fails",
            counts.not_checked,
            compared + counts.not_checked + counts.accepted,
            plural(counts.not_checked, "was", "were")
        ),
        VerdictStatus::NotAssessed => "Not assessed: no deciding procedure checked a limit state".into(),
    }
}

/// The word for one or for several.
fn plural<'a>(count: usize, one: &'a str, several: &'a str) -> &'a str {
    match count {
        1 => one,
        _ => several,
    }
}

/// The methods that decide.
pub fn deciding(results: &Results) -> String {
    let named = |d: &Deciding| format!("{} ({})", d.method, d.excitation.word());
    let of_site = |m: &&Method| m.excitation == Excitation::Site && m.status == Status::Computed;
    let computed: Vec<String> = results.methods.iter().filter(of_site).map(|m| format!("`{}`", m.id)).collect();
    match results.verdict.deciding.as_slice() {
        [] if !computed.is_empty() => {
            format!(
                "no method decides: name one in `procedures.decide`; computed for the site: {}",
                computed.join(", ")
            )
        }
        [] => "no method decides: give `site` with the data of a code, or name one in `procedures.decide`".into(),
        deciding => deciding.iter().map(named).collect::<Vec<_>>().join(", "),
    }
}

/// Clauses on which deciding methods rest and that no source was compared with, a sentence for each method.
pub fn recalled(results: &Results) -> Vec<String> {
    let methods = results.methods.iter().filter(|m| results.verdict.decides(m) && !m.recalled.is_empty());
    methods
        .map(|m| {
            format!(
                "recalled: {} has these clauses from memory, compared with no source: {}",
                m.id,
                m.recalled.join("; ")
            )
        })
        .collect()
}

/// How the missing part of the verdict is supplied.
pub const SUPPLY: &str = "Supply the missing input, or accept a gap with its reason in `accepted` of the tank file.";
/// What can be done about gaps of which none is for want of input.
pub const ACCEPT: &str = "A gap can be accepted with its reason in `accepted` of the tank file.";

/// Parts of the tank of which nothing is said; empty if there are none.
pub fn unstated(verdict: &Verdict) -> String {
    let parts: Vec<String> = verdict.unstated.iter().map(|part| format!("no {}", part.key())).collect();
    match parts.as_slice() {
        [] => String::new(),
        parts => format!(
            "{} stated: none is assumed, and what needs to know is not checked",
            super::capital(&parts.join(", "))
        ),
    }
}

/// Title of the checks on the first page.
pub fn judged(fails: bool, open: bool) -> &'static str {
    match (fails, open) {
        (true, true) => "Checks that fail or are open",
        (true, false) => "Checks that fail",
        (false, true) => "The governing check, and checks that are open",
        (false, false) => "The governing check",
    }
}

/// Title of the list of accepted gaps.
pub const GAPS: &str = "Accepted without a check";

/// Who accepts a gap, and when; empty where nobody does.
///
/// * `created`: when the results were computed, empty where that is not known
pub fn approval(check: &Check, created: &str) -> String {
    let Some(accepted) = &check.accepted else { return String::new() };
    let text = format!("accepted by {} on {}", accepted.by, accepted.date);
    if ahead(&accepted.date, created) { format!("{text}, a date after that of these results") } else { text }
}

/// Who accepts a gap, and when, without words; empty where nobody does.
pub fn approver(check: &Check) -> String {
    check.accepted.as_ref().map_or_else(String::new, |accepted| format!("{}, {}", accepted.by, accepted.date))
}

/// Whether a day is after that of a time; both begin with year, month and day.
fn ahead(date: &str, created: &str) -> bool {
    created.get(..10).is_some_and(|day| date > day)
}

/// Acceptances that are dated after the results, a sentence each.
pub fn dated_ahead(results: &Results) -> Vec<String> {
    let created = &results.volatile.created;
    let accepted = results.verdict.accepted.iter().map(|gap| &gap.check);
    let dated = accepted.filter_map(|check| Some((check, &check.accepted.as_ref()?.date)));
    let mut lines: Vec<String> = dated
        .filter(|(_, date)| ahead(date, created))
        .map(|(check, date)| {
            let day = created.get(..10).unwrap_or_default();
            format!("accepted: `{}` is dated {date}, after the day of these results, {day}", check.limit_state)
        })
        .collect();
    lines.dedup();
    lines
}

/// What the tank needs and no method here verifies; empty if nothing.
pub fn outside(results: &Results) -> &'static str {
    let tank = &results.tank.tank;
    let clamps = match tank.shape {
        Shape::Rectangle { .. } => true,
        Shape::Cylinder { .. } => !tank.is_metal() && tank.wall_base == WallBase::Fixed,
    };
    match tank.staging {
        _ if !clamps || results.verdict.status == VerdictStatus::NotAssessed => "",
        Some(_) => FLOOR_ABOVE,
        None => FLOOR,
    }
}

/// The floor of a tank whose walls are clamped to it.
const FLOOR: &str = "The floor is not part of this verification: it takes the clamping moment and the tension of the walls at their foot, and bears \
                     on the ground (EN 1998-4:2006 4.5, EN 1992-1-1:2004 6.1, 7.3)";

/// The floor of such a tank on a staging.
const FLOOR_ABOVE: &str = "The floor is not part of this verification: it takes the clamping moment and the tension of the walls at their foot, and hands \
                           the liquid to the staging";

/// Whether a warning is about values that are unusual or contradict each other.
pub fn of_input(warning: &Warning) -> bool {
    matches!(warning.code(), Some(Code::UnusualInput | Code::UnusualTank | Code::Inconsistent))
}

/// A code of the site that fails and does not decide.
pub fn overruled(code: &Overruled) -> String {
    format!("Not deciding by `procedures.decide`: {} (site), {}", code.method, counted(&code.checks.counts))
}

/// What the assessments under the record amount to.
pub fn record(aside: &Aside, set: bool) -> String {
    let counts = &aside.counts;
    let of = counts.compared();
    let state = match counts.fails {
        0 => format!("{of} {}", plural(of, "check holds", "checks hold")),
        fails => format!("{fails} of {of} {} {}", plural(of, "check", "checks"), plural(fails, "fails", "fail")),
    };
    let open = match counts.not_checked {
        0 => String::new(),
        open => format!(", {open} not checked"),
    };
    let motion = if set { "the set of records" } else { "this record" };
    format!("Under {motion}, unreduced and not deciding: {state}{open}")
}

/// What the checks of one method amount to.
pub fn counted(counts: &Counts) -> String {
    let of = counts.compared();
    let compared = match (of, counts.fails) {
        (0, _) => "none compared".into(),
        (of, 0) => format!("{of} {}", plural(of, "holds", "hold")),
        (of, fails) => format!("{fails} of {of} {}", plural(of, "fails", "fail")),
    };
    match counts.not_checked {
        0 => compared,
        open => format!("{compared}, {open} not checked"),
    }
}

/// Limit states that do not apply, one sentence; empty if there are none.
pub fn without<'a>(checks: impl Iterator<Item = &'a Check>) -> String {
    let names: Vec<&str> = checks.map(|c| c.name.as_str()).collect();
    match names.as_slice() {
        [] => String::new(),
        names => format!("Not applicable to this tank: {}.", names.join("; ")),
    }
}

/// How a limit state ends, in a word or two.
pub fn status(status: CheckStatus) -> &'static str {
    match status {
        CheckStatus::Holds => "holds",
        CheckStatus::Fails => "fails",
        CheckStatus::NotChecked => "not checked",
        CheckStatus::NotApplicable => "not applicable",
        CheckStatus::Accepted => "accepted",
    }
}

/// How a check ends; one that holds by less than its discretisation error says so.
pub fn result(check: &Check) -> &'static str {
    if check.within_error { "holds (within error)" } else { status(check.status) }
}

/// Height, angle and time of a demand; empty where it has none.
pub fn place(check: &Check) -> String {
    let parts = [
        check.z.map(|z| format!("z = {}", display(z, Dimension::Length))),
        check.theta.map(|theta| format!("θ = {:.0}°", theta.to_degrees())),
        check.time_s.map(|time| format!("t = {time:.2} s")),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// That a check holds by less than its error, with the error; empty for others.
pub fn within_error(check: &Check) -> String {
    if check.within_error { format!("holds within the error only: {}", error(check)) } else { String::new() }
}

/// Estimated error of a demand, in words; empty where there is none.
pub fn error(check: &Check) -> String {
    match check.error {
        Some(error) if check.compared() => format!("estimated error of the demand {:.1} %", 100.0 * error),
        _ => String::new(),
    }
}

/// Why results are not those of the whole ground motion, a sentence without its full stop.
pub fn incomplete(cause: &Incomplete) -> String {
    match cause {
        Incomplete::Missing { engine, error } => {
            let engine = engine.name();
            match error {
                None => format!("Incomplete: the {engine} run was interrupted before it had a result"),
                Some(error) => format!("Incomplete: the {engine} run failed before it had a result ({error})"),
            }
        }
        Incomplete::NotCarriedAtRest => "Collapse: the wall does not carry weight and static pressure".into(),
        Incomplete::NoEquilibrium { time } => {
            format!(
                "Collapse: the nonlinear run did not find equilibrium after {time:.2} s; its extremes are lower bounds"
            )
        }
        Incomplete::LeftModel { time } => {
            format!("The nonlinear run left its model and was stopped at {time:.2} s; its extremes end there")
        }
        Incomplete::BeyondModel { time } => {
            format!("The nonlinear run left its model at {time:.2} s, later values are not results")
        }
        Incomplete::Interrupted { time } => {
            format!("Incomplete: the nonlinear run was interrupted at {time:.2} s, its extremes are not final")
        }
    }
}

/// A value that is not to be used.
pub fn unusable(found: &Unusable) -> String {
    format!(
        "{}: {} is unusable; found an estimated mesh error of {:.0} %, usual is below 5 %, allowed up to {:.0} %: refine the mesh",
        found.method,
        found.quantity.title(),
        100.0 * found.error,
        100.0 * MESH_ERROR_LIMIT
    )
}
