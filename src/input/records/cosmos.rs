//! COSMOS v1.x: text lines, integers and reals whose numbers and formats the file states, comments, and a block of data under a line such as
//! `7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)`.
//!
//! Integer 2 is the physical parameter (1: acceleration), integer 3 its unit: 2 g, 4 cm/s², 10 gal. Real 62 is the time
//! step in milliseconds; where it is not known, real 34, that of the recorder. −999 stands for what
//! is not known, and is a fault among the accelerations. Files of several blocks begin with the acceleration, which is read.

use super::block::{after, fields, fortran, line, lines, place};
use super::draft::{Draft, printable, settle_dt, settle_unit, token_at};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Place of the time step [ms] among the reals, from 0, and of that of the recorder [s], of which the data may have been resampled.
const STEP: usize = 61;
const RECORDED: usize = 33;
/// Place of the corner of the low-cut filter among the reals, from 0.
const CORNER: usize = 53;
/// What is not known.
const UNKNOWN: f64 = -999.0;
/// How far corner × period may be from 1 by rounding to one digit.
const ROUNDED: f64 = 0.2;
/// Lines within which the data begin.
const BEFORE_DATA: usize = 200;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.lines()
        .next()
        .is_some_and(|line| line.contains("(Format v") && line.contains("text lines)"))
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let first = line(&lines, 0, "its first line")?;
    let texts = after(first.1, "WITH")
        .filter(|n| *n >= 1.0 && *n <= 100.0)
        .ok_or_else(|| {
            Fault::new(
                Code::RecordFormat,
                "the first line does not give the number of text lines",
            )
            .at(place(first))
            .found(printable(first.1))
        })? as usize;
    let block = |number: usize, what: &str| -> Result<(Vec<f64>, usize), Faults> {
        let head = line(&lines, number, what)?;
        let count = head.1.split_whitespace().next().and_then(|n| n.parse::<usize>().ok());
        let form = fortran(head.1);
        let (Some(count), Some((_, width))) = (count.filter(|n| *n <= 10_000), form) else {
            let fault =
                Fault::new(Code::RecordFormat, format!("the line before {what} cannot be read")).at(place(head));
            return Err(fault
                .found(printable(head.1))
                .allowed("`100 Integer-header values follow …, Format= (10I8)`")
                .into());
        };
        let (values, _, next) = fields(&lines, number + 1, (count, width), what)?;
        Ok((values, next))
    };
    let (integers, next) = block(texts, "the integers of the header")?;
    let (reals, next) = block(next, "the reals of the header")?;
    if let Some(kind) = integers.get(1).filter(|kind| **kind != 1.0 && **kind != -999.0) {
        let fault = Fault::new(Code::NotAcceleration, "this is not an acceleration record")
            .found(format!("physical parameter {kind}"));
        return Err(fault.allowed("1, acceleration").into());
    }
    let head = (next..lines.len().min(next + BEFORE_DATA)).find(|&i| fortran(lines[i].1).is_some());
    let head = head.ok_or_else(|| {
        Fault::new(Code::CutOff, "the file has no line before its data").help("the file may have been cut off")
    })?;
    let at = lines[head];
    let samples = at.1.split_whitespace().next().and_then(|n| n.parse::<usize>().ok());
    let (Some(samples), Some((_, width))) = (samples.filter(|n| *n <= MAX_SAMPLES), fortran(at.1)) else {
        let fault = Fault::new(Code::RecordFormat, "the line before the data cannot be read")
            .at(place(at))
            .found(printable(at.1));
        return Err(fault.allowed("`7000  acceleration pts, …, Format=(8F10.5)`").into());
    };
    let unit = integers.get(2).copied().unwrap_or(-999.0);
    let named = match unit as i64 {
        2 => Some(AccelerationUnit::G),
        4 | 10 => Some(AccelerationUnit::Gal),
        -999 => None,
        other => {
            let fault =
                Fault::new(Code::RecordUnit, "a unit that is not read").found(format!("unit {other} of the header"));
            return Err(fault.allowed("2 (g), 4 (cm/s²) or 10 (gal)").into());
        }
    };
    let named = named.map(|u| (u, format!("header, integer 3 ({unit})")));
    let (unit, unit_source) = settle_unit(named, options, "integer 3 of the header")?;
    let positive = |place: usize, scale: f64| {
        reals
            .get(place)
            .map(|dt| dt * scale)
            .filter(|dt| *dt > 0.0 && *dt < 10.0)
    };
    let step = positive(STEP, 1e-3).or_else(|| positive(RECORDED, 1.0));
    let dt = settle_dt(step, options)?.ok_or_else(|| {
        Fault::new(Code::TimeStep, "the header does not give a time step")
            .allowed("real 62 or 34 of the header, or --dt")
    })?;
    let (values, places, _) = fields(&lines, head + 1, (samples, width), "an acceleration")?;
    if let Some(k) = values.iter().position(|a| *a == UNKNOWN) {
        let fault =
            Fault::new(Code::NotFinite, "an acceleration that is not known").at(token_at(text, places[k] as usize));
        return Err(fault
            .found(format!("{UNKNOWN}, sample {} of {samples}", k + 1))
            .allowed("a number; −999 stands for what is not known")
            .into());
    }
    let filter = lines
        .iter()
        .take(texts)
        .find(|l| l.1.to_ascii_uppercase().contains("FILTERED BELOW"));
    // The text, or real 54.
    let said = filter.and_then(|l| after(l.1, "FILTERED BELOW")).filter(|f| *f > 0.0);
    let corner = reals.get(CORNER).copied().filter(|f| *f > 0.0 && *f < 0.5 / dt);
    let low_cut = said.or(corner.filter(|_| filter.is_none()));
    let contradiction = said
        .zip(filter.and_then(|l| after(l.1, "PERIODS OVER")))
        .filter(|(corner, period)| (corner * period - 1.0).abs() > ROUNDED)
        .map(|(corner, period)| {
            format!("the header says filtered below {corner} Hz, which is {:.3} s, and periods over {period} s; the corner counts", 1.0 / corner)
        });
    Ok(Draft {
        title: lines.get(4).map(|l| printable(l.1)).filter(|t| !t.is_empty()),
        format: format!("COSMOS ({samples} samples, interval {dt} s)"),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: contradiction.into_iter().collect(),
        low_cut,
    })
}
