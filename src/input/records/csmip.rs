//! CSMIP, CDMG, USC and Caltech: volume 2 of all years, and volume 1 where it has equal steps. Channels stand one after the other, each with
//! headers and its accelerations, in volume 2 also velocities and displacements.
//!
//! ```text
//!  3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)
//!    80 points of accel data equally spaced at  0.010 sec, in cm/sec2. (8f10.5)
//!  1887 POINTS OF ACC DATA EQUALLY SPACED AT   .020 SEC.  IN UNITS CM/SEC/SEC
//! 13200 Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)
//! ```
//!
//! A file of several channels needs `--channel`. Of the ramp of a filter the upper end counts. Volume 1 of the years of film has pairs of time and
//! acceleration at uneven times, and volume 3 response spectra; both are refused.

use super::block::{Line, fields, fortran, lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::filter::corner;
use super::header::unknown_unit;
use super::unit::{Step, step};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Width of a number where the line before the data does not give a format.
const WIDTH: usize = 10;
const KINDS: [&str; 2] = ["POINTS OF ACC", "ACCELEROGRAM POINTS AT"];

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    let first = text.lines().next().unwrap_or_default().to_ascii_uppercase();
    first.contains("CORRECTED ACCELEROGRAM") || (first.contains("RESPONSE") && first.contains("SPECTRA"))
}

/// A channel: the line of its data, its name, and the corner of its filter.
struct Channel<'a> {
    number: usize,
    head: Line<'a>,
    name: String,
    low_cut: Option<f64>,
}

fn channels<'a>(lines: &[Line<'a>]) -> Vec<Channel<'a>> {
    let (mut all, mut name, mut low_cut) = (Vec::new(), String::new(), None);
    for (number, &head) in lines.iter().enumerate() {
        // Lines of numbers need no look.
        if !head.1.contains(|c: char| c.is_ascii_alphabetic()) {
            continue;
        }
        let upper = head.1.to_ascii_uppercase();
        match upper.find("CHAN ") {
            Some(at) => name = printable(head.1.get(at..).unwrap_or_default()),
            None if upper.starts_with("COMP ") => name = printable(head.1.get(..72).unwrap_or(head.1)),
            None => {}
        }
        low_cut = corner(head.1).or(low_cut);
        if KINDS.iter().any(|kind| upper.contains(kind)) {
            all.push(Channel { number, head, name: name.clone(), low_cut: low_cut.take() });
        }
    }
    all
}

/// Rejects what has no record with equal steps.
fn other_volume(lines: &[Line]) -> Fault {
    let first = lines.first().copied().unwrap_or((0, ""));
    let upper = first.1.to_ascii_uppercase();
    if upper.contains("RESPONSE") {
        return Fault::new(
            Code::NotAcceleration,
            "this is a volume 3 file of CSMIP, USC or Caltech: response spectra, not a record",
        )
        .at(place(first))
        .allowed("volume 2, corrected accelerations");
    }
    if upper.contains("UNCORRECTED") {
        return Fault::new(
            Code::RecordFormat,
            "this is a volume 1 file of CSMIP, USC or Caltech, digitised at uneven times, which is not supported",
        )
        .at(place(first))
        .allowed("volume 1 with equal steps, or volume 2")
        .help("take the corrected file of the record, volume 2, or interpolate it to a CSV file with the header `time_s,acceleration_m_s2`");
    }
    Fault::new(Code::CutOff, "the file has no line before its accelerations")
        .at(place(lines.iter().rev().find(|l| !l.1.trim().is_empty()).copied().unwrap_or(first)))
        .allowed("`3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.`")
}

/// The unit after `UNITS OF`, `UNITS:`, `UNITS` or `in`.
fn unit_text(upper: &str) -> Option<&str> {
    let behind = |word: &str| upper.split_once(word).map(|(_, rest)| rest);
    let rest = behind("UNITS OF").or_else(|| behind("UNITS")).or_else(|| behind(" IN "))?;
    let rest = rest.trim_start_matches([':', ' ', '(']);
    let end = rest.split(['(', ')', ',']).next()?.split("FORMAT").next()?;
    Some(end.trim().trim_end_matches('.').trim()).filter(|unit| !unit.is_empty())
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let channels = channels(&lines);
    if channels.is_empty() {
        return Err(other_volume(&lines).into());
    }
    let names: Vec<String> = channels.iter().map(|c| c.name.clone()).collect();
    let wanted = choose(&names, options)?;
    let channel = &channels[wanted];
    let (at, upper) = (channel.head, channel.head.1.to_ascii_uppercase());
    let samples = upper.split_whitespace().next().and_then(|n| n.parse::<usize>().ok());
    let behind = upper.split_once("SPACED AT").or_else(|| upper.split_once(" AT "));
    let step = match behind.and_then(|(_, rest)| step(rest)) {
        Some(Step::Seconds(dt) | Step::Bare(dt)) if dt > 0.0 && dt < 10.0 => Some(dt),
        _ => None,
    };
    let (Some(samples), Some(step)) = (samples.filter(|n| *n <= MAX_SAMPLES), step) else {
        let fault = Fault::new(Code::RecordFormat, "the line before the data cannot be read").at(place(at));
        let form = "`3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC`";
        return Err(fault.found(printable(at.1)).allowed(form).into());
    };
    let named = match unit_text(&upper).map(|text| (text, AccelerationUnit::parse(text))) {
        None => None,
        Some((_, Some(unit))) => Some((unit, format!("`{}`", printable(at.1)))),
        Some((text, None)) => return Err(unknown_unit(text).at(place(at)).into()),
    };
    let (unit, unit_source) = settle_unit(named, options, "`(UNITS: CM/SEC/SEC)` before the data")?;
    let dt = settle_dt(Some(step), options)?.unwrap_or(step);
    let width = fortran(at.1).map_or(WIDTH, |(_, width)| width);
    let (values, places, _) = fields(&lines, channel.number + 1, (samples, width), "an acceleration")?;
    let uncorrected = upper.contains(KINDS[1]);
    let station = lines.get(if uncorrected { 5 } else { 6 }).map(|l| printable(l.1)).unwrap_or_default();
    let notes = match uncorrected {
        true => vec!["volume 1 is not corrected: its mean and drift are those of the instrument".into()],
        false => Vec::new(),
    };
    Ok(Draft {
        title: Some(format!("{station}, {}", channel.name)),
        format: format!(
            "{} volume {} (channel {} of {}, {samples} samples)",
            if channel.name.starts_with("COMP") { "USC" } else { "CSMIP" },
            if uncorrected { 1 } else { 2 },
            wanted + 1,
            channels.len()
        ),
        channel: (channels.len() > 1).then(|| channel.name.clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes,
        low_cut: channel.low_cut,
    })
}
