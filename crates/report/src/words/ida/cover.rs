//! The first page of an incremental dynamic analysis.

use tank::units::Dimension;

use crate::number::{count, significant, with_unit};
use results::{Ida, IdaRun};

/// In the running head.
pub const RUNNING: &str = "incremental dynamic analysis";
/// Parts of the page: id and title.
pub const PARTS: [(&str, &str); 4] = [
    ("model", "Model and assumptions"),
    ("curves", "Curves"),
    ("runs", "Runs"),
    ("extremes", "Extremes of both signs"),
];

/// `0.45 (1.54 m/s²)`: scale and peak of the ground.
fn motion(run: &IdaRun) -> String {
    format!("scale {} ({})", significant(run.scale, 4), with_unit(run.pga, Dimension::Acceleration))
}

/// Whether the tank collapses, and when.
pub fn headline(ida: &Ida) -> String {
    let Some(last) = ida.runs.last() else { return "Incomplete: no run has ended".into() };
    match ida.runs.iter().find(|run| run.collapse.is_some()) {
        _ if ida.incomplete => "Incomplete: runs are missing".into(),
        Some(run) => format!("Collapse at {}", motion(run)),
        None => format!("No collapse up to {}", motion(last)),
    }
}

/// What bounds the result, and what the page is not.
pub fn lines(ida: &Ida) -> Vec<String> {
    let mut lines = Vec::new();
    let collapse = ida.runs.iter().position(|run| run.collapse.is_some());
    if let Some(below) = collapse.and_then(|at| at.checked_sub(1)) {
        lines.push(format!("Strongest motion with equilibrium before it: {}.", motion(&ida.runs[below])));
    }
    if let Some(run) = ida.runs.iter().find(|run| !run.departures.is_empty()) {
        lines.push(format!("A run leaves its model from {} on.", motion(run)));
    }
    match ida.runs.iter().find(|run| run.exceeded().next().is_some()) {
        Some(run) => lines.push(format!("Limits of validity are exceeded from {} on.", motion(run))),
        None => lines.push("No run exceeds a limit of validity.".into()),
    }
    lines.push("The runs find demands and collapse; `tankcheck compare` checks the limit states of the codes.".into());
    lines
}

/// Key figures.
pub fn facts(ida: &Ida) -> Vec<(&'static str, String)> {
    let largest = |value: fn(&IdaRun) -> f64| ida.runs.iter().map(value).fold(0.0, f64::max);
    vec![
        ("Runs", count(ida.runs.len())),
        ("Largest scale", significant(largest(|r| r.scale), 4)),
        ("Largest ground acceleration", with_unit(largest(|r| r.pga), Dimension::Acceleration)),
    ]
}
