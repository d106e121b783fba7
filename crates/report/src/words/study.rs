//! The page of a study.

pub mod basis;
pub mod curves;

use crate::number::{count, fixed, utilisation, with_unit};
use files::code::{Code, Warning};
use results::{EngineId, Study, StudyRule, StudyTank, StudyTrace, VerdictStatus};

/// Below the title.
pub const SUBTITLE: &str = "Study of tanks under a set of records: checks, fragility and risk";
/// Axis of a fragility curve.
pub const PROBABILITY: &str = "probability";
/// Mean and largest volume.
pub const VOLUMES: [&str; 2] = ["mean of the earthquakes", "largest"];
/// Its description.
pub const VOLUME_DESCRIPTION: &str =
    "Mean and largest volume of the liquid of tanks in the worst state over the intensity.";
/// Title of a figure.
pub const AT_LEAST: &str = "Probability that a number of tanks or more lose their contents";
/// Its caption.
pub const AT_LEAST_CAPTION: &str =
    "Counted over the earthquakes, which shake all tanks at once; dotted: independent tanks with the same shares.";
/// Its description.
pub const AT_LEAST_DESCRIPTION: &str =
    "Probability that at least k tanks are in the worst state over the intensity, counted and for independent tanks.";
/// Legend of independent tanks.
pub const INDEPENDENT: &str = "independent";
/// Legend of a limit.
pub const LIMIT: &str = "limit";
/// Demand over its limit.
pub const RATIO: &str = "Demand over limit";
/// The farm as a system.
pub fn about_system(study: &Study) -> String {
    let counted = match study.method.as_str() {
        "stripes" => "",
        _ => {
            " The curves of the farm are fitted to the number of earthquakes at each level (stripes), whichever method its tanks use: other methods need a demand, which only a tank has."
        }
    };
    format!("The farm as a system: at least one tank is in the state in the same earthquake.{counted}")
}

/// What the codes require and was not checked, the tanks with the same gaps together.
pub fn open(study: &Study) -> Vec<String> {
    /// Tanks, and the methods with the limit states that are open of each of them.
    type Group<'a> = (Vec<&'a str>, &'a [(String, String)]);
    let mut groups: Vec<Group<'_>> = Vec::new();
    for tank in study.tanks.iter().filter(|tank| !tank.open.is_empty()) {
        match groups.iter_mut().find(|(_, open)| *open == tank.open) {
            Some((tanks, _)) => tanks.push(&tank.id),
            None => groups.push((vec![&tank.id], &tank.open)),
        }
    }
    let of = |(tanks, open): &Group<'_>| {
        let mut methods: Vec<(&str, Vec<String>)> = Vec::new();
        for (method, state) in *open {
            match methods.iter_mut().find(|(known, _)| known == method) {
                Some((_, states)) => states.push(id(state)),
                None => methods.push((method, vec![id(state)])),
            }
        }
        let lists = methods.iter().map(|(method, states)| format!("{} ({method})", states.join(", ")));
        format!("Not checked of {}: {}.", first_of(tanks), lists.collect::<Vec<_>>().join("; "))
    };
    groups.iter().map(of).collect()
}

/// The first of a list of names, and how many more.
fn first_of<T: AsRef<str>>(names: &[T]) -> String {
    let named: Vec<&str> = names.iter().take(NAMED).map(AsRef::as_ref).collect();
    let more = match names.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    named.join(", ") + &more
}

/// Most tanks that a list names.
const NAMED: usize = 12;
/// Text.
pub const ABOUT_LOSSES: &str = "Tanks in the worst state lose their contents. All tanks are shaken by the same earthquakes, so that losses are counted \
     earthquake by earthquake. Where a tank was not judged, an earthquake counts if the other tanks decide it, the mean loss takes each tank from the earthquakes \
     in which it was judged, and bounds say what the gaps can change.";
/// Text.
pub const ABOUT_STATES: &str = "A tank is in a state if one of its demands reaches the utilisation at which the state begins, if it is in a worse state, or \
     if the run found no equilibrium. Runs: how many of all tanks reached this limit; a run that reached several counts at each. \
     A run in which a demand was not checked is not judged if other runs of the tank have it checked, unless it reaches the state all the same. A demand that \
     no run of a tank checks takes no part in its states.";
/// Text.
pub const NO_RULE: &str = "Whether the set stands for a spectrum was not asked: `rule` of the study file compares it with the spectrum of the site.";
/// Text.
pub const ABOUT_RECORDS: &str = "Peaks along x, of the record as the tank file processes it, before the scale of the study. Severity: demands over the \
     geometric mean of all records at the same level, mean of all tanks.";

/// A limit state or check by its id, in words.
pub use super::limit_state as id;

/// `0.41–0.52`.
pub fn range(low: &str, high: &str) -> String {
    format!("{low}–{high}")
}

/// A range of which either end may be unknown; none where both are.
pub fn between(low: Option<String>, high: Option<String>) -> Option<String> {
    Some(match (low, high) {
        (Some(low), Some(high)) => range(&low, &high),
        (Some(low), None) => format!("from {low}"),
        (None, Some(high)) => format!("up to {high}"),
        (None, None) => return None,
    })
}

/// Median and dispersion of a common fit.
pub fn common(median: &str, dispersion: &str) -> String {
    format!("{median}; {dispersion}")
}

/// `3 of 7`.
pub fn of(part: usize, whole: usize) -> String {
    format!("{} of {}", count(part), count(whole))
}

/// Whether the rule holds.
pub fn holds(holds: bool) -> &'static str {
    if holds { "holds" } else { "does not hold" }
}

/// Legend of at least k tanks.
pub fn at_least(k: usize) -> String {
    match k {
        1 => "1 tank or more".into(),
        k => format!("{k} or more"),
    }
}

/// Verdict of a tank.
pub fn verdict(tank: &StudyTank) -> String {
    match tank.verdict {
        Some(status) => status.id().replace('_', " "),
        None if tank.samples[0] > 0 => "not possible".into(),
        None => "no result".into(),
    }
}

/// How many samples have the verdict of the tank.
pub fn samples(tank: &StudyTank) -> String {
    match tank.verdict {
        Some(_) => of(tank.samples[1], tank.samples[0]),
        None => count(tank.samples[0]),
    }
}

/// Headline of the farm.
pub fn headline(study: &Study) -> String {
    let all = study.tanks.len();
    let with = |status: VerdictStatus| study.tanks.iter().filter(|t| t.verdict == Some(status)).count();
    let (holds, fails) = (with(VerdictStatus::Holds), with(VerdictStatus::Fails));
    let open = all - holds - fails;
    let mut parts = Vec::new();
    if fails > 0 {
        parts.push(format!("{} with a check that fails", of(fails, all)));
    }
    if open > 0 {
        parts.push(format!("{} not assessed completely", of(open, all)));
    }
    if holds > 0 {
        parts.push(format!("{} with every required check that holds", of(holds, all)));
    }
    format!("Tanks: {}", parts.join(", "))
}

/// A utilisation; infinite without any capacity.
pub fn utilised(value: f64) -> String {
    if value.is_finite() { utilisation(value) } else { "no capacity is left".into() }
}

/// The governing tank, and the tank that is lost first.
pub fn governing(study: &Study) -> Vec<String> {
    let mut lines =
        vec!["Verdicts are those of the deciding codes of each tank under its own design spectra.".to_owned()];
    let worst = study
        .tanks
        .iter()
        .filter_map(|tank| Some((tank, tank.governing.as_ref()?)))
        .max_by(|a, b| a.1.2.total_cmp(&b.1.2));
    if let Some((tank, (method, check, value))) = worst {
        lines.push(match value.is_finite() {
            true => format!("Governing: {}, {} ({method}), {} utilised.", tank.id, id(check), utilised(*value)),
            false => format!("Governing: {}, {} ({method}), {}.", tank.id, id(check), utilised(*value)),
        });
    }
    let worst = study.states.last().map(|s| s.name.as_str());
    let first = study
        .curves
        .iter()
        .filter(|c| Some(c.state.as_str()) == worst)
        .filter_map(|c| Some((c, c.fit?)))
        .min_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    if let Some((curve, [median, dispersion])) = first {
        lines.push(format!(
            "Most fragile of the fitted curves: {}, {} at a median {} of {} (dispersion {}).",
            curve.tank.clone().unwrap_or_default(),
            curve.state,
            study.im,
            with_unit(median, study.dimension),
            fixed(dispersion, 2)
        ));
    }
    lines.extend(unfitted(study, first.and_then(|(curve, _)| curve.fit).map(|[median, _]| median)));
    lines
}

/// Tanks that may be lost earlier than the most fragile one with a curve of the worst state: without a curve, or with runs that are missing.
///
/// * `fitted`: the lowest median
fn unfitted(study: &Study, fitted: Option<f64>) -> Option<String> {
    let worst = study.states.last()?.name.as_str();
    let of = |tank: &str| {
        let mut curves = study.curves.iter();
        curves.find(|c| c.state == worst && c.tank.as_deref() == Some(tank))
    };
    let earlier = |tank: &&StudyTank| {
        let Some(curve) = of(&tank.id) else { return !study.curves.is_empty() };
        let least = match (curve.fit, curve.partial) {
            (None, _) => curve.bounds[0],
            (Some(_), Some([_, reached])) => reached,
            (Some([median, _]), None) => Some(median),
        };
        fitted.is_none_or(|median| least.is_none_or(|least| least < median))
    };
    let first = |tank: &StudyTank| of(&tank.id).and_then(|c| c.fit).map(|fit| fit[0]) == fitted && fitted.is_some();
    let tanks: Vec<&str> =
        study.tanks.iter().filter(|tank| !first(tank) && earlier(tank)).map(|tank| tank.id.as_str()).collect();
    let names = first_of(&tanks);
    (!tanks.is_empty()).then(|| match fitted {
        Some(_) => format!("Perhaps lost earlier, without a curve of {worst} or with runs that are missing: {names}."),
        None => format!("Without a curve of {worst}: {names}."),
    })
}

/// Columns of the table of tanks that the report does not show.
pub fn not_given(columns: &[&str]) -> Vec<String> {
    match columns {
        [] => Vec::new(),
        _ => vec![format!("Not shown: the columns {}.", columns.join(", "))],
    }
}

/// Tanks that no earthquake judges in the worst state.
pub fn never_judged(study: &Study) -> Vec<String> {
    let Some(worst) = study.states.last() else { return Vec::new() };
    let judged = |tank: &&StudyTank| {
        let mut curves = study.curves.iter();
        curves
            .any(|c| c.state == worst.name && c.tank.as_deref() == Some(&tank.id) && c.points.iter().any(|p| p.1 > 0.0))
    };
    let never: Vec<&str> = study.tanks.iter().filter(|tank| !judged(tank)).map(|tank| tank.id.as_str()).collect();
    match never.is_empty() || study.losses.is_empty() {
        true => Vec::new(),
        false => vec![format!(
            "No run judges {} of {}: the mean loss is therefore unknown, and every earthquake has a gap.",
            worst.name,
            first_of(&never)
        )],
    }
}

/// What a reader has to know before the numbers.
pub fn warnings(study: &Study) -> Vec<Warning> {
    let mut all = Vec::new();
    if study.missing_tasks > 0 {
        all.push(Warning::new(Code::StudyRemark, format!(
            "Incomplete: {} tasks have no result. Counts and curves are those of the others, with bounds for what is missing.",
            of(study.missing_tasks, study.tasks)
        )));
    }
    if let Some(rule) = study.rule.as_ref().filter(|rule| !rule.holds) {
        all.push(Warning::new(Code::StudyRemark, format!("The records do not keep {} as they are.", rule.clause)));
    }
    let mut weaker: Vec<&str> = Vec::new();
    for curve in study.curves.iter().filter(|c| !c.never_checked.is_empty()) {
        let tank = curve.tank.as_deref().unwrap_or_default();
        if !weaker.contains(&tank) {
            weaker.push(tank);
        }
    }
    if !weaker.is_empty() {
        all.push(Warning::new(
            Code::StudyRemark,
            format!(
                "Curves of {} leave out demands that no run checks: these tanks may be more fragile than their curves.",
                first_of(&weaker)
            ),
        ));
    }
    let unjudged: usize = study.curves.iter().map(|c| c.unjudged).sum();
    if unjudged > 0 {
        all.push(Warning::new(Code::StudyRemark, format!(
            "{} times a row could not be judged for a damage state; such rows bound the shares and are never counted as safe.",
            count(unjudged)
        )));
    }
    all
}

/// Key figures.
pub fn facts(study: &Study) -> Vec<(&'static str, String)> {
    let mut all = vec![("Tanks", count(study.tanks.len()))];
    if study.samples > 1 {
        all.push(("Samples of each", count(study.samples as usize)));
    }
    all.push(("Records", count(study.records.len())));
    if !study.records.is_empty() {
        all.push(("Measure", study.im.clone()));
        if !study.levels.is_empty() {
            all.push(("Levels", count(study.levels.len())));
        }
    }
    all.push(("Rows", count(study.rows[1])));
    all.push(("Engine", study.engine.map_or("none: codes alone", EngineId::id).into()));
    all
}

/// Over the table of tanks.
pub fn tanks(study: &Study) -> String {
    let sampled = match study.samples {
        0 | 1 => "",
        _ => {
            " Of the samples of a tank the worst verdict and the largest utilisation; periods and volume of the first."
        }
    };
    format!("Verdict and governing check under the design spectra of each tank.{sampled}")
}

/// Why there are no losses.
pub fn no_losses(reason: &str) -> String {
    format!("Not counted: {reason}.")
}

/// Whether the records keep the rule.
pub fn rule(rule: &StudyRule) -> String {
    let target = match rule.target.as_str() {
        "site" => "the elastic spectrum of the site of each tank".to_owned(),
        name => format!("the spectrum `{name}`"),
    };
    format!(
        "{} against {target}: {} for the records as they are along x, {} of at least {}. The mean of the peaks reaches the target at T = 0, and the mean \
         spectrum 90 % of it from 0.2 T to 2 T.",
        rule.clause,
        holds(rule.holds),
        count(rule.records[0]),
        count(rule.records[1])
    )
}

/// Title of a figure of single records.
pub fn trace(trace: &StudyTrace) -> String {
    format!("{}, {}, record by record", trace.tank, trace.state)
}

/// Its caption.
///
/// * `logarithmic`: whether the demands are on a logarithmic axis
pub fn trace_caption(trace: &StudyTrace, logarithmic: bool) -> String {
    let mut parts = Vec::new();
    if let Some(deviation) = trace.deviation {
        parts.push(format!(
            "From record to record ln of the demand has the standard deviation {} at a level.",
            fixed(deviation, 2)
        ));
    }
    if logarithmic {
        parts.push(
            "Logarithmic axis: where the capacity falls towards zero at some instant, the ratio becomes large."
                .to_owned(),
        );
    }
    parts.join(" ")
}

/// Its description.
pub fn trace_description(trace: &StudyTrace) -> String {
    format!(
        "Largest demand over its limit of {} over the intensity, a line for each of {} records.",
        trace.tank,
        trace.records.len()
    )
}
