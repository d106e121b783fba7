//! The page of an incremental dynamic analysis and its summary on the terminal.

pub mod cover;

use super::outcome::{passed, place};
use super::verdict::LIQUID_PARTED;
use crate::number::{fixed, significant, with_unit};
use results::{Ida, IdaRun, Limit};

/// Abscissa of the curves, within a sentence.
pub const PGA: &str = "peak ground acceleration";
/// The same as the head of a column.
pub const PGA_HEAD: &str = "Peak ground acceleration";
/// Titles of the demands; where there are two: of a strip, of a cylinder.
pub const WAVE: &str = "Largest wave at the wall";
/// Displacement.
pub const DISPLACEMENT: [&str; 2] =
    ["Largest displacement of the top of the wall", "Largest radial displacement of the wall"];
/// Moment at the base.
pub const BASE_MOMENT: [&str; 2] = ["Largest moment at the base of a wall", "Largest moment at the base"];
/// Stress of a bar.
pub const BAR_STRESS: &str = "Largest stress of a bar";
/// Highest crack.
pub const CRACK_HEIGHT: &str = "Height of the highest crack";
/// Plastic strain.
pub const PLASTIC_STRAIN: &str = "Largest plastic strain of plates or concrete";
/// Energy.
pub const HYSTERETIC: [&str; 2] = ["Energy dissipated in a wall, per metre", "Energy dissipated in the wall"];

/// Heads of the table of runs.
pub mod heads {
    /// Moment of the lowest section.
    pub const SECTION: &str = "Moment of the section";
    /// First crack: time, moment at the base.
    pub const FIRST_CRACK: [&str; 2] = ["First crack at", "with base moment"];
    /// Separation: time where the liquid is kept at the wall, where it leaves it, height.
    pub const SEPARATION: [&str; 3] = ["Liquid separates (linear estimate) at", "Liquid separates at", "at the height"];
    /// Limits of validity that are exceeded.
    pub const OUTSIDE: &str = "Limits exceeded";
    /// Damping.
    pub const DAMPING: &str = "Damping of the wall mode";
}

/// Mark of a run at its point of a curve.
pub fn mark(run: &IdaRun) -> &'static str {
    match (&run.collapse, run.departures.is_empty()) {
        (Some(_), _) => "≥, collapse",
        (None, false) => "left the model",
        (None, true) if run.exceeded().next().is_some() => "limit",
        (None, true) => "",
    }
}

/// A value of a run in the table of a curve.
pub fn value(run: &IdaRun, value: &str) -> String {
    let bound = if run.collapse.is_some() { "≥ " } else { "" };
    let mark = if run.departures.is_empty() { "" } else { ", left the model" };
    format!("{bound}{value}{mark}")
}

/// Caption of a curve.
pub fn caption(ida: &Ida) -> String {
    let mut sentences = Vec::new();
    if ida.runs.iter().any(|r| r.collapse.is_some()) {
        sentences.push("Runs that lost equilibrium are lower bounds.");
    }
    if ida.runs.iter().any(|r| !r.departures.is_empty()) {
        sentences.push("Runs that left the model are not results; the table of runs lists when and why.");
    }
    if ida.runs.iter().any(|r| r.exceeded().next().is_some()) {
        sentences.push("Runs marked as limit exceed a limit of validity; the table of runs names it.");
    }
    if ida.runs.windows(3).any(|w| w.iter().all(|r| !mark(r).is_empty() && mark(r) == mark(&w[0]))) {
        sentences.push("Of neighbouring runs with the same mark the first and the last are labelled.");
    }
    sentences.join(" ")
}

/// Description of a curve.
pub fn description(title: &str, runs: usize) -> String {
    format!("{title} over the peak ground acceleration, {runs} runs.")
}

/// How a run ended, in a cell: a run that passed a limit of its model is never shown without its mark.
pub fn end(run: &IdaRun) -> String {
    let mut words = Vec::new();
    if let Some(collapse) = &run.collapse {
        words.push(format!("collapse at {} s", fixed(collapse.time, 2)));
    }
    if let Some(first) = run.departures.first() {
        words.push(format!("left the model at {} s", fixed(first.time, 2)));
    }
    if words.is_empty() { "completed".into() } else { words.join("; ") }
}

/// How runs left the model, and the parts of their moments at the base, one sentence each.
pub fn departures(ida: &Ida) -> Vec<String> {
    let marked = ida.runs.iter().filter(|run| !run.departures.is_empty());
    marked.map(|run| departure(ida, run)).collect()
}

fn departure(ida: &Ida, run: &IdaRun) -> String {
    let how = run.departures.iter();
    let how: Vec<String> = how.map(|d| format!("after {} s, {}: {}", fixed(d.time, 3), place(d), passed(d))).collect();
    let moment = |value: f64| with_unit(value, ida.moment);
    let parts = run.moment_parts.as_ref().map_or(String::new(), |m| {
        format!(
            " Largest moment at the base {}, of which the section {}, damping {}, inertia {}; largest moment of the lowest \
             section {}.",
            moment(m.reaction.abs()),
            moment(m.section * m.reaction.signum()),
            moment(m.damping * m.reaction.signum()),
            moment(m.inertia * m.reaction.signum()),
            moment(m.largest_section)
        )
    });
    format!("Scale {}: {}.{parts}", significant(run.scale, 4), how.join("; "))
}

/// Limits of validity that a run exceeds, in a cell.
pub fn exceeded(run: &IdaRun) -> String {
    let short: Vec<&str> = run
        .exceeded()
        .map(|limit| match limit.id.as_str() {
            "wave_against_radius" => "wave not small",
            "wave_against_freeboard" => "freeboard",
            "wall_displacement" => "displacement",
            "crack_width" => "crack width",
            "suction" => "suction",
            "compressibility" => "compressibility",
            "record_step" => "step of the record",
            _ => limit.name.as_str(),
        })
        .collect();
    if short.is_empty() { "–".into() } else { short.join(", ") }
}

/// Limits of validity that runs exceed, one sentence each.
pub fn outside(ida: &Ida) -> Vec<String> {
    let of = |run: &IdaRun, limit: &Limit| {
        format!(
            "Scale {}: {}: {}, limit {}. {}",
            significant(run.scale, 4),
            limit.name,
            with_unit(limit.value, limit.dimension),
            with_unit(limit.limit, limit.dimension),
            limit.note
        )
    };
    let runs = ida.runs.iter();
    runs.flat_map(|run| run.exceeded().map(move |limit| of(run, limit))).collect()
}

/// Remarks on runs in which the liquid separates from a wall, or does by the linear estimate, one sentence each.
pub fn partings(ida: &Ida) -> Vec<String> {
    let first = |open: bool| {
        let runs = ida.runs.iter().filter(|r| r.parting.is_some_and(|p| p.open == open));
        runs.min_by(|a, b| a.scale.total_cmp(&b.scale))
    };
    let from = |run: &IdaRun| format!("From the scale {} on", significant(run.scale, 4));
    let mut out = Vec::new();
    if let Some(run) = first(false) {
        out.push(format!(
            "{} the pressure of the liquid falls below that of the air under the surface: the liquid separates where air can enter \
             (linear estimate), and the model keeps it at the wall. Use contact \"opening\" to model the separation.",
            from(run)
        ));
    }
    if let Some(run) = first(true) {
        out.push(format!("{}: {LIQUID_PARTED}", from(run)));
    }
    out
}

/// Runs without equilibrium on the page, one sentence each.
pub fn collapses(ida: &Ida) -> Vec<String> {
    let found = ida.runs.iter().filter_map(|run| Some((run, run.collapse.as_ref()?)));
    found
        .map(|(run, collapse)| {
            format!(
                "Scale {}: no equilibrium after {} s. {}",
                significant(run.scale, 4),
                fixed(collapse.time, 3),
                collapse.reason
            )
        })
        .collect()
}
