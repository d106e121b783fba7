//! USGS SMC: 11 lines of text, 48 integers (8I10), 50 reals (5E15.7), comments `|`, then accelerations in cm/s² (8E10.4, fields touch).
//!
//! Integer 16 is the number of comments and 17 that of the samples, real 2 the sampling rate; real 33 is the corner of the low-cut filter, where
//! it is not real 1, which stands for what is not known.

use super::block::{Line, fields, line, lines, place, whole};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Lines of text.
const TEXT: usize = 11;
/// Integers: number and width. Reals likewise.
const INTEGERS: (usize, usize) = (48, 10);
const REALS: (usize, usize) = (50, 15);
/// Places among them, from 0.
const COMMENTS: usize = 15;
const SAMPLES: usize = 16;
const RATE: usize = 1;
const UNKNOWN: usize = 0;
const LOW_CUT: usize = 32;

/// Rates from which the times are not even: volume 1 states 1.7e38, which stands for what is not known.
const NO_RATE: f64 = 1e6;

/// Whether the text is one: a digit with the kind of the file, and a star.
pub(super) fn sniff(text: &str) -> bool {
    let mut lines = text.lines();
    kind(lines.next().unwrap_or_default()).is_some() && lines.next().is_some_and(|l| l.trim() == "*")
}

/// The kind in the first line.
fn kind(line: &str) -> Option<&str> {
    let (digit, kind) = line.trim().split_once(' ')?;
    digit.parse::<u8>().ok()?;
    let upper = kind.to_ascii_uppercase();
    let known = ["ACCELEROGRAM", "VELOCITY", "DISPLACEMENT", "SPECTR"].iter().any(|word| upper.contains(word));
    known.then_some(kind.trim())
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let first = line(&lines, 0, "its first line")?;
    if let Some(kind) = kind(first.1).filter(|kind| !kind.to_ascii_uppercase().contains("ACCELEROGRAM")) {
        let fault = Fault::new(Code::NotAcceleration, "this SMC file is not an acceleration record").at(place(first));
        return Err(fault.found(printable(kind)).allowed("2 CORRECTED ACCELEROGRAM").into());
    }
    choose(&[component(&lines)], options)?;
    let (integers, _, next) = fields(&lines, TEXT, INTEGERS, "an integer of the header")?;
    let (reals, _, next) = fields(&lines, next, REALS, "a real of the header")?;
    let integer = |i: usize, what: &str, most: usize| -> Result<usize, Fault> {
        whole(integers[i], 0..=most).ok_or_else(|| {
            let message = format!("integer {} of the header, {what}, is out of range", i + 1);
            Fault::new(Code::RecordLength, message).found(format!("{}", integers[i])).allowed(format!("0 to {most}"))
        })
    };
    let comments = integer(COMMENTS, "the number of comments", 10_000)?;
    let samples = integer(SAMPLES, "the number of samples", MAX_SAMPLES)?;
    let rate = reals[RATE];
    if rate >= NO_RATE || rate == reals[UNKNOWN] {
        let message = "the record was digitised at uneven times, which is not read";
        let fault = Fault::new(Code::TimeStep, message).at(place(first));
        let fault = fault.found(printable(first.1)).allowed("a corrected record, which has a sampling rate");
        return Err(fault.help("take the corrected file of the same record, or interpolate it to equal steps").into());
    }
    if rate <= 0.0 || rate.is_nan() {
        let message = "real 2 of the header, the sampling rate, is out of range";
        let fault = Fault::new(Code::TimeStep, message);
        return Err(fault.found(format!("{rate}")).allowed("samples a second greater than 0").into());
    }
    let dt = settle_dt(Some(1.0 / rate), options)?.unwrap_or_default();
    for number in next..next + comments {
        let comment = line(&lines, number, "its last comment")?;
        if !comment.1.starts_with('|') {
            let fault = Fault::new(Code::RecordFormat, "a line that is no comment")
                .at(place(comment))
                .found(printable(comment.1));
            return Err(fault.allowed(format!("{comments} lines that begin with |")).into());
        }
    }
    let source = (AccelerationUnit::Gal, "format, cm/s²".to_owned());
    let (unit, unit_source) = settle_unit(Some(source), options, "")?;
    let (values, places, _) = fields(&lines, next + comments, (samples, 10), "an acceleration")?;
    let corner = reals[LOW_CUT];
    let told = corner > 0.0 && corner < 0.5 * rate && corner != reals[UNKNOWN];
    let title = lines.get(5).map(|l| printable(l.1)).filter(|t| !t.is_empty() && t != "*");
    Ok(Draft {
        title,
        format: format!("USGS SMC ({samples} samples at {rate} a second)"),
        channel: None,
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: Vec::new(),
        low_cut: told.then_some(corner),
    })
}

/// The component of the sixth line: `station = Somewhere    component=     65`.
fn component(lines: &[Line<'_>]) -> String {
    let told = lines.get(5).and_then(|l| l.1.split_once("component="));
    told.map(|(_, name)| printable(name)).unwrap_or_default()
}
