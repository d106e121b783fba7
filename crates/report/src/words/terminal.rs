//! The summaries on the terminal: one line each, without the line break.

use std::collections::BTreeMap;

use tank::assessment::{Check, Excitation};
use tank::outside::Outside;
use tank::units::{self, Dimension, display};

use crate::message;
use crate::number::significant;
use results::compare::{Apart, Why};
use results::part::Block;
use results::{Directional, EngineId, Governing, IdaRun, Limit, MESH_ERROR_LIMIT, Method, PushShell, Results, Status};

/// Mark of a number that is not to be used.
pub const UNUSABLE: &str = "‡";

/// Mark of a number outside the model of its engine.
pub const OUTSIDE: &str = "§";

/// Corner of the table of `compare`, and of that of `check`, which has no run (`engine`) to compare with.
///
/// * `own`: whether the engine has a column under this excitation
pub fn corner(excitation: Excitation, engine: bool, own: bool) -> &'static str {
    match (excitation, engine) {
        (Excitation::Record, true) => "record spectrum / history (ratio to fe)",
        (Excitation::Site, true) if own => "design spectrum of the site (ratio to fe under it)",
        (Excitation::Site, true) => "design spectrum of the site (ratio to fe under the record)",
        (Excitation::Record, false) => "record spectrum, seismic part",
        (Excitation::Site, false) => "design spectrum of the site, seismic part",
    }
}

/// What the wave does to the roof, or the roof to the waves.
pub fn roof(results: &Results) -> Vec<String> {
    let blocks = results.parts.iter().filter(|part| part.id == "roof_wave").flat_map(|part| &part.blocks);
    let texts = blocks.filter_map(|block| match block {
        Block::Text(message) => Some(message::text(message)),
        _ => None,
    });
    texts.collect()
}

/// Legend of [`UNUSABLE`].
pub fn unusable() -> String {
    format!("{UNUSABLE} unusable: the estimated mesh error is above {:.0} %", 100.0 * MESH_ERROR_LIMIT)
}

/// Legend of [`OUTSIDE`].
pub fn outside(why: Outside) -> String {
    let why = match why {
        Outside::Uplift => "the wall lifts off, but the engine clamps it",
        Outside::Plates => "the walls of the box bend as plates held at three sides, but the engine models cantilevers",
    };
    format!("{OUTSIDE} outside the model: {why}")
}

/// Quantities that are said of both components together.
const TOGETHER: [&str; 5] = ["wave_height", "base_shear", "base_moment", "overturning_moment", "hoop_stress"];

/// What two horizontal components do together, beside the comparison along x; none with one component.
pub fn components(found: &[Directional]) -> Option<String> {
    let of = |id: &&str| found.iter().find(|d| d.id == **id);
    let said: Vec<String> = TOGETHER
        .iter()
        .filter_map(of)
        .map(|d| {
            format!("{} {} at {:.0}°", d.title.to_lowercase(), display(d.resultant, d.dimension), d.theta.to_degrees())
        })
        .collect();
    (!said.is_empty()).then(|| {
        format!(
            "The comparison has the component along x alone, as the procedures have. Both components together: {}.",
            said.join(", ")
        )
    })
}

/// Measured values that are not compared, a line for each reason.
pub fn apart(values: &[Apart]) -> Vec<String> {
    let mut reasons: Vec<(&Why, Vec<&str>)> = Vec::new();
    for found in values {
        let title = found.value.quantity.title();
        match reasons.iter_mut().find(|(reason, _)| **reason == found.reason) {
            Some((_, titles)) => titles.push(title),
            None => reasons.push((&found.reason, vec![title])),
        }
    }
    let line = |(reason, titles): (&Why, Vec<&str>)| {
        format!("measured, not compared: {}: {}", titles.join(", ").to_lowercase(), super::apart::why(reason))
    };
    reasons.into_iter().map(line).collect()
}

/// A procedure outside its scope; none for one that gave values.
pub fn not_applicable(method: &Method) -> Option<String> {
    match &method.status {
        Status::Computed => None,
        Status::NotApplicable { clause, reason } => Some(format!("{}: not applicable, {clause}: {reason}", method.id)),
    }
}

/// Peaks of the linear run after the end of the nonlinear one.
///
/// * `peaks`: time of the linear peak by quantity [s]
/// * `end`: end of the nonlinear run [s], `completed` where it is that of the record
pub fn later(peaks: &BTreeMap<String, f64>, end: f64, completed: bool) -> String {
    let mut times: Vec<f64> = peaks.values().copied().collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut times: Vec<String> = times.iter().map(|t| format!("{t:.2} s")).collect();
    times.dedup();
    let after = if completed { " with free vibration after the record" } else { "" };
    format!(
        "* the linear peak is later ({}): {} ends at {end:.2} s, fe continues{after}",
        times.join(", "),
        EngineId::Nonlinear.beside()
    )
}

/// The check with the largest utilisation.
pub fn governing(governing: &Governing) -> String {
    let place = super::verdict::place(&governing.check);
    format!(
        "{} ({}, {}){}, {}{}",
        governing.check.name,
        governing.method,
        governing.excitation.word(),
        if place.is_empty() { place } else { format!(", {place}") },
        match governing.check.utilisation {
            Some(_) => format!("utilisation {}", utilisation(&governing.check)),
            None => "no capacity is left".into(),
        },
        if governing.check.within_error { " (within error)" } else { "" }
    )
}

/// Utilisation with two decimals; a dash without a comparison.
pub fn utilisation(check: &Check) -> String {
    match check.ratio() {
        None => "–".into(),
        Some(ratio) if ratio > 1.0 && ratio < 1.005 => {
            // As many decimals as show that it is above 1.
            let decimals = (3..=9).find(|&n| (ratio - 1.0) * 10_f64.powi(n) >= 0.5);
            decimals.map_or("above 1".into(), |n| format!("{ratio:.*}", n as usize))
        }
        Some(ratio) if ratio.is_finite() => format!("{ratio:.2}"),
        Some(_) => "no capacity".into(),
    }
}

/// A limit of the theory that is exceeded.
pub fn exceeded(limit: &Limit) -> String {
    format!("{} ({}): {}", limit.name, super::summary::exceeded(limit), limit.note)
}

/// A run of `ida` without equilibrium; none of one that has it.
pub fn collapse(run: &IdaRun) -> Option<String> {
    let collapse = run.collapse.as_ref()?;
    Some(format!(
        "scale {}: no equilibrium after {:.3} s: {}",
        significant(run.scale, 4),
        collapse.time,
        collapse.reason
    ))
}

/// How the path of a shell of `push` ends, one line each.
pub fn path(shell: &PushShell) -> Vec<String> {
    let name = super::push::shell_name(shell);
    let mut lines = vec![format!("{name}: {}", shell.end)];
    if !shell.capacity.limit {
        lines.push(format!("{name}: the maximum was not reached; the capacity is a lower bound"));
    }
    lines
}

/// How to continue an interrupted analysis.
pub const RESUME: &str = "incomplete: repeat the command with --resume to continue";

/// How far the three-dimensional engine searches modes: `most` waves around the circumference.
pub fn wave_numbers(most: u32) -> String {
    format!(
        "wave numbers up to n = {most} are searched (a wave needs six sectors); modes with more waves may be lower and need a mesh \
         with more sectors"
    )
}

/// How the three-dimensional engine numbers the motions of a box.
pub const PARTS_OF_A_BOX: &str = "part 0 is even about both middle planes (vertical motion), 1 odd along the length, 2 odd along the breadth, \
                                  3 odd along both";

/// A layered course, from 1; `layers` are already in words, lengths in metres, the modulus in Pa.
pub fn course(number: usize, layers: &[String], thickness: f64, modulus: f64) -> String {
    format!(
        "course {number}: {} (inside to outside; codes and linear engines: {} of {} GPa)",
        layers.join(" | "),
        units::display(thickness, Dimension::Length),
        units::significant(modulus / 1e9, 3)
    )
}

/// Kind of an interlayer that passes no shear.
pub const NO_SHEAR: &str = "interlayer without shear";
