//! COSMOS v1.x: text lines, integers and reals whose numbers and formats the file states, comments, and a block of data under a line such as
//! `7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)`.
//!
//! Integer 2 is the physical parameter (1: acceleration), integer 3 its unit: 2 g, 4 cm/s², 7 in/s², 10 gal, 11 mg. Real 62 is the time
//! step in milliseconds; where it is not known, real 34, that of the recorder. −999 stands for what
//! is not known, and is a fault among the accelerations. A file of a station holds its channels one after the other, each with all of this;
//! `--channel` takes one of those of acceleration.

use super::block::{Line, after, fields, fortran, line, lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit, token_at};
use super::filter::corner;
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

/// Line with the name of the channel, from 0.
const CHANNEL: usize = 8;

/// Whether a line begins a channel.
fn begins(line: &str) -> bool {
    let upper = line.to_ascii_uppercase();
    upper.contains("(FORMAT V") && upper.contains("TEXT LINES)")
}

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.lines().next().is_some_and(begins)
}

/// The header of a channel.
struct Head {
    /// Number of the first line, and of the one behind the reals.
    start: usize,
    next: usize,
    /// Number of text lines.
    texts: usize,
    integers: Vec<f64>,
    reals: Vec<f64>,
}

impl Head {
    fn is_acceleration(&self) -> bool {
        self.integers.get(1).is_none_or(|kind| *kind == 1.0 || *kind == UNKNOWN)
    }
}

/// Reads the header of the channel that begins at a line.
fn head(lines: &[Line], start: usize) -> Result<Head, Faults> {
    let first = line(lines, start, "its first line")?;
    let texts = after(first.1, "WITH").filter(|n| *n >= 1.0 && *n <= 100.0).ok_or_else(|| {
        Fault::new(Code::RecordFormat, "the first line does not give the number of text lines")
            .at(place(first))
            .found(printable(first.1))
    })? as usize;
    let block = |number: usize, what: &str| -> Result<(Vec<f64>, usize), Faults> {
        let head = line(lines, number, what)?;
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
        let (values, _, next) = fields(lines, number + 1, (count, width), what)?;
        Ok((values, next))
    };
    let (integers, next) = block(start + texts, "the integers of the header")?;
    let (reals, next) = block(next, "the reals of the header")?;
    Ok(Head { start, next, texts, integers, reals })
}

/// The unit of integer 3.
///
/// Errors: a unit that is not one of acceleration.
fn unit_of(integers: &[f64]) -> Result<Option<(AccelerationUnit, String)>, Fault> {
    let unit = integers.get(2).copied().unwrap_or(UNKNOWN);
    let named = match unit as i64 {
        2 => AccelerationUnit::G,
        4 | 10 => AccelerationUnit::Gal,
        7 => AccelerationUnit::InchPerSecondSquared,
        11 => AccelerationUnit::MilliG,
        -999 => return Ok(None),
        other => {
            let fault =
                Fault::new(Code::RecordUnit, "a unit that is not read").found(format!("unit {other} of the header"));
            return Err(fault.allowed("2 (g), 4 (cm/s²), 7 (in/s²), 10 (gal) or 11 (mg)"));
        }
    };
    Ok(Some((named, format!("header, integer 3 ({unit})"))))
}

/// The line before the data of a channel: its number, and count and width of the data.
fn data_head(lines: &[Line], channel: &Head) -> Result<(usize, usize, usize), Fault> {
    let found = (channel.next..lines.len().min(channel.next + BEFORE_DATA)).find(|&i| fortran(lines[i].1).is_some());
    let number = found.ok_or_else(|| {
        Fault::new(Code::CutOff, "the file has no line before its data").help("the file may have been cut off")
    })?;
    let at = lines[number];
    let samples = at.1.split_whitespace().next().and_then(|n| n.parse::<usize>().ok());
    match (samples.filter(|n| *n <= MAX_SAMPLES), fortran(at.1)) {
        (Some(samples), Some((_, width))) => Ok((number, samples, width)),
        _ => {
            let fault = Fault::new(Code::RecordFormat, "the line before the data cannot be read")
                .at(place(at))
                .found(printable(at.1));
            Err(fault.allowed("`7000  acceleration pts, …, Format=(8F10.5)`"))
        }
    }
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let starts = (0..lines.len()).filter(|i| begins(lines[*i].1));
    let heads: Vec<Head> = starts.map(|start| head(&lines, start)).collect::<Result<_, Faults>>()?;
    if !heads.iter().any(Head::is_acceleration) {
        let kind = heads.first().and_then(|h| h.integers.get(1)).copied().unwrap_or_default();
        let fault = Fault::new(Code::NotAcceleration, "this is not an acceleration record")
            .found(format!("physical parameter {kind}"));
        return Err(fault.allowed("1, acceleration").into());
    }
    let heads: Vec<Head> = heads.into_iter().filter(Head::is_acceleration).collect();
    let name = |head: &Head| lines.get(head.start + CHANNEL).map(|l| printable(l.1)).unwrap_or_default();
    let names: Vec<String> = heads.iter().map(name).collect();
    let wanted = choose(&names, options)?;
    let channel = &heads[wanted];
    let reals = &channel.reals;
    let (head, samples, width) = data_head(&lines, channel)?;
    let named = unit_of(&channel.integers)?;
    let (unit, unit_source) = settle_unit(named, options, "integer 3 of the header")?;
    let positive =
        |place: usize, scale: f64| reals.get(place).map(|dt| dt * scale).filter(|dt| *dt > 0.0 && *dt < 10.0);
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
    let texts = &lines[channel.start..(channel.start + channel.texts).min(lines.len())];
    let filter = texts.iter().find(|l| corner(l.1).is_some());
    // The text, or real 54.
    let said = filter.and_then(|l| corner(l.1));
    let stored = reals.get(CORNER).copied().filter(|f| *f > 0.0 && *f < 0.5 / dt);
    let low_cut = said.or(stored);
    let contradiction = said
        .zip(filter.and_then(|l| after(l.1, "PERIODS OVER")))
        .filter(|(corner, period)| (corner * period - 1.0).abs() > ROUNDED)
        .map(|(corner, period)| {
            format!("the header says filtered below {corner} Hz, which is {:.3} s, and periods over {period} s; the corner counts", 1.0 / corner)
        });
    Ok(Draft {
        title: lines.get(channel.start + 4).map(|l| printable(l.1)).filter(|t| !t.is_empty()),
        format: format!("COSMOS (channel {} of {}, {samples} samples, interval {dt} s)", wanted + 1, names.len()),
        channel: (names.len() > 1).then(|| names[wanted].clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: contradiction.into_iter().collect(),
        low_cut,
    })
}
