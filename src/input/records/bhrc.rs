//! BHRC (Iran), `* VOL1DS`: components one after the other, each with 13 lines of text, seven of integers, seven of reals, and accelerations in
//! g/10 (10E13.6).
//!
//! The duration of the header is the number of samples times the step.

use super::block::{after, fields, lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::header::unknown_unit;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Lines before the data.
const HEADER: usize = 27;
/// Width of a number.
const WIDTH: usize = 13;
/// How far the step may be from a whole number of microseconds.
const MICRO: f64 = 1e-6;

fn begins(line: &str) -> bool {
    line.to_ascii_uppercase().starts_with("* VOL")
}

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    begins(text) && text.lines().nth(6).is_some_and(|line| line.to_ascii_uppercase().starts_with("COMP"))
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let first = lines.first().copied().unwrap_or((0, ""));
    if !first.1.to_ascii_uppercase().starts_with("* VOL1") {
        let message = "this is a BHRC file of another volume, which is not supported";
        let fault = Fault::new(Code::RecordFormat, message).at(place(first));
        return Err(fault.found(printable(first.1)).allowed("`* VOL1DS`").into());
    }
    let starts: Vec<usize> = (0..lines.len()).filter(|i| begins(lines[*i].1)).collect();
    let at = |start: usize, offset: usize| lines.get(start + offset).copied().unwrap_or((0, ""));
    let names: Vec<String> = starts.iter().map(|start| printable(at(*start, 4).1)).collect();
    let wanted = choose(&names, options)?;
    let start = starts.get(wanted).copied().unwrap_or_default();
    let counts = at(start, 10);
    let samples =
        after(counts.1, "NO. OF POINTS").filter(|n| *n >= 2.0 && n.fract() == 0.0 && *n <= MAX_SAMPLES as f64);
    let duration = after(counts.1, "DURATION").filter(|d| *d > 0.0);
    let (Some(samples), Some(duration)) = (samples, duration) else {
        let message = "number of points and duration of this BHRC file cannot be read";
        let fault = Fault::new(Code::RecordLength, message).at(place(counts));
        return Err(fault
            .found(printable(counts.1))
            .allowed("`NO. OF POINTS =  13056      DURATION =  65.280`")
            .into());
    };
    let whole = |dt: f64| ((dt * 1e6).round() * 1e-6 - dt).abs() < MICRO * dt;
    let step = [duration / samples, duration / (samples - 1.0)].into_iter().find(|dt| whole(*dt));
    let dt = settle_dt(step, options)?.ok_or_else(|| {
        Fault::new(Code::TimeStep, "the duration of this BHRC file is not a whole number of steps")
            .at(place(counts))
            .allowed("--dt")
    })?;
    let units = at(start, 11);
    let upper = units.1.to_ascii_uppercase();
    let text = upper.split_once(" AND ").map_or("", |(_, unit)| unit.trim());
    let unit = AccelerationUnit::parse(text).ok_or_else(|| unknown_unit(units.1).at(place(units)))?;
    let (unit, unit_source) = settle_unit(Some((unit, format!("header, `{}`", printable(units.1)))), options, "")?;
    let (values, places, _) = fields(&lines, start + HEADER, (samples as usize, WIDTH), "an acceleration")?;
    let station = at(start, 7).1.split("Station").next().map(printable).unwrap_or_default();
    Ok(Draft {
        title: Some(format!("{station} {}", names[wanted])),
        format: format!("BHRC volume 1 (channel {} of {}, {samples} samples)", wanted + 1, names.len()),
        channel: (names.len() > 1).then(|| names[wanted].clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: vec!["volume 1 is not corrected: its mean and drift are those of the instrument".into()],
        low_cut: None,
    })
}
