//! GeoNet (New Zealand) volumes 1 and 2, `.V1A` and `.V2A`: components one after the other, each with 16 lines of text, four of integers, six of
//! reals, and accelerations in mm/s² (10F8); in volume 2 velocities and displacements follow.
//!
//! Integer 31 is the number of raw samples, integer 34 that of the processed ones.

use super::block::{Line, after, fields, line, lines, place, whole};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::filter::corner;
use super::header::unknown_unit;
use super::unit::{Step, step};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Lines of text, and lines before the data.
const TEXT: usize = 16;
const HEADER: usize = 26;
/// Numbers of a line and their width.
const FIELDS: (usize, usize) = (10, 8);

fn begins(line: &str) -> bool {
    let lower = line.trim_start().to_ascii_lowercase();
    lower.starts_with("corrected accelerogram") || lower.starts_with("uncorrected accelerogram")
}

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    let mut lines = text.lines();
    begins(lines.next().unwrap_or_default())
        && lines.next().is_some_and(|l| l.to_ascii_lowercase().starts_with("site "))
}

/// The time step [s] of a line such as `… data at 0.010 sec intervals`.
fn time_step(said: Line<'_>) -> Result<f64, Fault> {
    let upper = said.1.to_ascii_uppercase();
    let behind = upper.split_once("INTERVALS OF").or_else(|| upper.split_once(" AT "));
    match behind.and_then(|(_, rest)| step(rest)) {
        Some(Step::Seconds(dt)) if dt > 0.0 => Ok(dt),
        _ => {
            let message = "the header of this GeoNet file does not give a time step";
            let fault = Fault::new(Code::TimeStep, message).at(place(said));
            Err(fault.found(printable(said.1)).allowed("`… data at 0.010 sec intervals`"))
        }
    }
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let starts: Vec<usize> = (0..lines.len()).filter(|i| begins(lines[*i].1)).collect();
    let component = |start: &usize| -> String {
        let text = lines.get(start + 12).map_or("", |l| l.1.trim());
        printable(text.get(9..).filter(|_| text.to_ascii_lowercase().starts_with("component")).unwrap_or(text))
    };
    let names: Vec<String> = starts.iter().map(component).collect();
    let wanted = choose(&names, options)?;
    let header = starts.get(wanted).copied().unwrap_or_default();
    let at = |offset: usize| line(&lines, header + offset, "its header");
    let volume = if lines[header].1.to_ascii_lowercase().contains("uncorrected") { 1 } else { 2 };
    let (counts, ..) = fields(&lines, header + TEXT + 3, FIELDS, "an integer of the header")?;
    let counted = counts[if volume == 1 { 0 } else { 3 }];
    let Some(samples) = whole(counted, 2..=MAX_SAMPLES) else {
        let message = "the number of samples in the header is out of range";
        let fault = Fault::new(Code::RecordLength, message).at(place(at(TEXT + 3)?));
        let allowed = format!("2 to {MAX_SAMPLES}");
        return Err(fault.found(format!("{counted}")).allowed(allowed).into());
    };
    let said = at(10)?;
    let dt = time_step(said)?;
    let dt = settle_dt(Some(dt), options)?.unwrap_or(dt);
    let peak = at(13)?;
    let unit = peak
        .1
        .split_whitespace()
        .find_map(AccelerationUnit::parse)
        .ok_or_else(|| unknown_unit(peak.1).at(place(peak)))?;
    let (unit, unit_source) = settle_unit(Some((unit, format!("header, `{}`", printable(peak.1)))), options, "")?;
    let factor = if volume == 1 { after(said.1, "UNITS OF").unwrap_or(1.0) } else { 1.0 };
    let (mut values, places, _) = fields(&lines, header + HEADER, (samples, FIELDS.1), "an acceleration")?;
    values.iter_mut().for_each(|v| *v *= factor);
    let filter: Option<f64> = lines[header..(header + TEXT).min(lines.len())].iter().find_map(|l: &Line| corner(l.1));
    Ok(Draft {
        title: Some(format!("{}, {}", printable(at(2)?.1), names[wanted])),
        format: format!("GeoNet volume {volume} (channel {} of {}, {samples} samples)", wanted + 1, names.len()),
        channel: (names.len() > 1).then(|| names[wanted].clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: Vec::new(),
        low_cut: filter,
    })
}
