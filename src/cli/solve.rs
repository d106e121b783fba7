//! `tankcheck check --solve`: the solution as a paragraph, JSON or one line of CSV.

use std::fmt::Write;

use serde::Serialize;
use tank::STANDARD_GRAVITY;
use tank::units::{self, Dimension};

use crate::cli::terminal::say;
use crate::cli::{Format, Global, compare, show, style};
use crate::error::{EXIT_CHECK_FAILED, EXIT_NOT_CHECKED, Error};
use crate::job::Job;
use crate::solve::{self, Answer, Found, Solution, Variable, rounded};
use report::words;
use results::{Governing, Verdict, VerdictStatus};

/// Significant digits of a printed value; it is rounded to the side that holds.
const DIGITS: i32 = 5;

/// The solution as JSON.
#[derive(Serialize)]
struct Answered {
    variable: String,
    value: Option<f64>,
    unit: &'static str,
    governing: Option<Governs>,
    evaluations: usize,
    status: &'static str,
}

/// The check with the largest utilisation.
#[derive(Serialize)]
struct Governs {
    method: String,
    check: String,
    utilisation: Option<f64>,
}

impl Governs {
    fn of(governing: &Governing) -> Governs {
        Governs {
            method: governing.method.clone(),
            check: governing.check.id.clone(),
            utilisation: governing.check.utilisation,
        }
    }
}

/// Solves and prints; returns the exit code.
pub(crate) fn run(job: &Job, variable: &str, (format, strict): (Format, bool), global: &Global) -> Result<u8, Error> {
    let variable = Variable::parse(variable)?;
    let solution = solve::run(job, variable)?;
    let sentence = || {
        let _units = style::terminal(job.project.as_ref());
        style::sentence(&paragraph(&solution))
    };
    let answer = answered(&solution);
    show(format, || format!("{}\n", sentence()), || &answer, || Ok(csv(&answer)))?;
    if format != Format::Human && !global.quiet && !matches!(solution.found, Found::Edge { .. }) {
        say!("note: {}", sentence());
    }
    Ok(exit_code(&solution, strict))
}

/// That of the verdict at the solution; 1 where a check fails at every value, 4 where there is no single answer.
fn exit_code(solution: &Solution, strict: bool) -> u8 {
    match (&solution.found, solution.value()) {
        (_, Some((_, verdict))) => compare::exit_code(verdict, strict),
        (Found::Nowhere { .. }, None) => EXIT_CHECK_FAILED,
        (_, None) => EXIT_NOT_CHECKED,
    }
}

/// The verdict at the solution in a word, or why there is none.
pub(crate) fn status(solution: &Solution) -> &'static str {
    match &solution.found {
        Found::Edge { at, .. } | Found::Everywhere { at, .. } | Found::Nowhere { at, .. } => answer(at),
        Found::Several(_) => "not_monotone",
        Found::Unanswered(_) => VerdictStatus::NotAssessed.id(),
    }
}

/// A verdict in a word; one that holds with accepted gaps has its own.
pub(crate) fn answer(verdict: &Verdict) -> &'static str {
    match verdict.status {
        VerdictStatus::Holds if !verdict.complete() => "holds_with_gaps",
        status => status.id(),
    }
}

fn answered(solution: &Solution) -> Answered {
    let at = match &solution.found {
        Found::Edge { at, .. } | Found::Everywhere { at, .. } | Found::Nowhere { at, .. } => Some(at),
        Found::Several(_) | Found::Unanswered(_) => None,
    };
    Answered {
        variable: solution.variable.name(),
        value: solution.value().map(|(value, _)| value),
        unit: solution.variable.unit(),
        governing: at.and_then(|v| v.governing.as_ref()).map(Governs::of),
        evaluations: solution.evaluations,
        status: status(solution),
    }
}

fn csv(answered: &Answered) -> String {
    let governing = answered.governing.as_ref();
    format!(
        "variable,value,unit,method,check,utilisation,status,evaluations\n{},{},{},{},{},{},{},{}\n",
        answered.variable,
        answered.value.map_or(String::new(), |v| v.to_string()),
        answered.unit,
        governing.map_or("", |g| &g.method),
        governing.map_or("", |g| &g.check),
        governing.and_then(|g| g.utilisation).map_or(String::new(), |u| format!("{u:.6}")),
        answered.status,
        answered.evaluations,
    )
}

/// A value with an engineer's unit, rounded down or up.
fn shown(variable: Variable, value: f64, up: bool) -> String {
    let (number, symbol) = match variable {
        Variable::Ag => (value / STANDARD_GRAVITY, "g"),
        Variable::Ss => (value, "g"),
        Variable::FillHeight | Variable::Thickness(_) => {
            let unit = units::unit_for(value, Dimension::Length);
            (units::in_unit(value, unit), unit.symbol)
        }
    };
    format!("{} {symbol}", units::significant(rounded(number, DIGITS, up), DIGITS as usize))
}

/// The variable in words.
fn name(variable: Variable) -> String {
    match variable {
        Variable::FillHeight => "fill height".into(),
        Variable::Thickness(course) => format!("thickness of course {course}"),
        Variable::Ag => "ground acceleration ag on rock (site.ec8.ag)".into(),
        Variable::Ss => "mapped acceleration S_s (site.api650.ss; S_1 as given)".into(),
    }
}

/// What fails beyond the edge, if it is not what governs at it, or why there is no verdict.
fn past(text: &mut String, at: &Verdict, beyond: &Answer<Verdict>) {
    let found = match beyond {
        Answer::Fails(verdict) | Answer::Holds(verdict) => {
            let other = |g: &&Governing| {
                let here = at.governing.as_ref();
                here.is_none_or(|h| (&h.method, &h.check.id) != (&g.method, &g.check.id))
            };
            let next = verdict.governing.as_ref().filter(other);
            next.map(|next| format!(" Beyond it fails: {}.", words::terminal::governing(next)))
        }
        Answer::Outside(reason) => Some(format!(" Beyond it there is no verdict: {reason}.")),
    };
    text.extend(found);
}

/// The value of a solution as a tank file has it, with its unit.
pub(crate) fn stated(solution: &Solution) -> Option<String> {
    let up = !solution.variable.largest();
    solution.value().map(|(value, _)| shown(solution.variable, value, up))
}

/// The solution in one paragraph.
pub(crate) fn paragraph(solution: &Solution) -> String {
    let variable = solution.variable;
    let up = !variable.largest();
    let shown = |value: f64| shown(variable, value, up);
    let (from, to) = solution.range;
    let tried = format!("{} evaluations from {} to {}", solution.evaluations, shown(from), shown(to));
    let name = name(variable);
    let extreme = if up { "Smallest" } else { "Largest" };
    let mut text = String::new();
    match &solution.found {
        Found::Edge { value, at, beyond } => {
            let _ = write!(
                text,
                "{extreme} {name} at which no check fails: {} (given: {}).",
                shown(*value),
                shown(solution.given)
            );
            governs(&mut text, at);
            past(&mut text, at, beyond);
            judged(&mut text, at);
        }
        Found::Everywhere { value, at } => {
            let _ = write!(
                text,
                "No check fails at any {name} in the admissible range; its end is {} (given: {}).",
                shown(*value),
                shown(solution.given)
            );
            governs(&mut text, at);
            judged(&mut text, at);
        }
        Found::Nowhere { value, at } => {
            let _ = write!(text, "A check fails at every {name} that was tried; at {}:", shown(*value));
            match &at.governing {
                Some(governing) => {
                    let _ = write!(text, " {}.", words::terminal::governing(governing));
                }
                None => text.push_str(" no utilisation."),
            }
        }
        Found::Several(samples) => {
            let _ = write!(text, "No single answer: whether checks fail changes more than once with the {name}:");
            let part = |run: &[(f64, bool)]| {
                let (first, last) = (run.first()?, run.last()?);
                let word = if first.1 { "no check fails" } else { "a check fails" };
                Some(match run {
                    [one] => format!(" {word} at {}", shown(one.0)),
                    _ => format!(" {word} from {} to {}", shown(first.0), shown(last.0)),
                })
            };
            let parts: Vec<String> = samples.chunk_by(|a, b| a.1 == b.1).filter_map(part).collect();
            let _ = write!(text, "{}.", parts.join(","));
        }
        Found::Unanswered(reason) => {
            let _ = write!(text, "Not assessed: {reason}; the {name} cannot be solved for.");
        }
    }
    if let Variable::Thickness(_) = variable {
        text.push_str(
            " The other courses keep theirs; the thickness of the static design (API 650 5.6) is not searched.",
        );
    }
    let _ = write!(text, " ({tried})");
    text
}

/// The governing check of a verdict that does not fail.
fn governs(text: &mut String, verdict: &Verdict) {
    if let Some(governing) = &verdict.governing {
        let _ = write!(text, " Governing there: {}.", words::terminal::governing(governing));
    }
}

/// The verdict at the value, with the limit states that it leaves open.
fn judged(text: &mut String, verdict: &Verdict) {
    let _ = write!(text, " Verdict there: {}", words::verdict::headline(verdict));
    if !verdict.missing.is_empty() {
        let open: Vec<String> =
            (verdict.missing.iter()).map(|gap| format!("{}/{}", gap.method, gap.check.limit_state)).collect();
        let _ = write!(text, " ({})", open.join(", "));
    }
    text.push('.');
}
