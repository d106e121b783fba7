//! SAC, binary of either byte order and alphanumeric: 70 reals, 40 integers, 24 words, then the samples.
//!
//! Real 1 is the step, integer 7 the version of the header, integer 10 the number of samples, integer 16 the kind of file (1: a time series),
//! integer 17 the dependent variable (6 displacement, 7 velocity) and integer 36 whether the steps are even. The format does not fix the unit:
//! `--units` gives it.

use super::block::{fields, lines};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{MAX_SAMPLES, ReadOptions};
use files::code::Code;

const REALS: usize = 70;
const INTEGERS: usize = 40;
/// Bytes of the header.
const HEADER: usize = 632;
/// Places among the integers, from 0.
const VERSION: usize = 6;
const SAMPLES: usize = 9;
const KIND: usize = 15;
const VARIABLE: usize = 16;
const EVEN: usize = 35;
/// What is not known.
const UNKNOWN: f64 = -12345.0;
/// Lines of reals, integers and words of the alphanumeric form.
const LINES: (usize, usize, usize) = (14, 8, 8);

/// A header.
struct Head {
    reals: Vec<f64>,
    integers: Vec<f64>,
    /// Station and component.
    names: (String, String),
}

/// Words of four bytes in an order.
fn words(bytes: &[u8], little: bool) -> impl Iterator<Item = [u8; 4]> {
    bytes.chunks_exact(4).map(move |word| {
        let word = [word[0], word[1], word[2], word[3]];
        if little { [word[3], word[2], word[1], word[0]] } else { word }
    })
}

/// The byte order of a binary file: that in which the version is 6 or 7.
fn order(bytes: &[u8]) -> Option<bool> {
    let at = 4 * (REALS + VERSION);
    let version = bytes.get(at..at + 4).filter(|_| bytes.len() >= HEADER)?;
    [true, false].into_iter().find(|little| words(version, *little).all(|w| matches!(i32::from_be_bytes(w), 6 | 7)))
}

/// Whether the bytes are a binary file.
pub(super) fn sniff_bytes(bytes: &[u8]) -> bool {
    order(bytes).is_some()
}

/// Whether the text is an alphanumeric file.
pub(super) fn sniff(text: &str) -> bool {
    let reals =
        |line: &str| line.split_whitespace().count() == 5 && line.split_whitespace().all(|w| w.parse::<f64>().is_ok());
    let mut first = text.lines().take(LINES.0);
    text.lines().take(5).any(|line| line.contains("-12345.00")) && first.by_ref().take(5).all(reals)
}

/// Reads the bytes; call [`sniff_bytes`] before.
pub(super) fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Draft, Faults> {
    let little = order(bytes).unwrap_or(true);
    let real = |w: [u8; 4]| f64::from(f32::from_be_bytes(w));
    let name = |from: usize, size: usize| {
        let text = String::from_utf8_lossy(bytes.get(from..from + size).unwrap_or_default()).replace('\0', " ");
        printable(text.replace("-12345", "").trim())
    };
    let integers = bytes.get(4 * REALS..4 * (REALS + INTEGERS)).unwrap_or_default();
    let head = Head {
        reals: words(bytes, little).take(REALS).map(real).collect(),
        integers: words(integers, little).map(|w| f64::from(i32::from_be_bytes(w))).collect(),
        // Word 1, and word 21 behind the long second one.
        names: (name(440, 8), name(600, 8)),
    };
    let values: Vec<f64> = words(bytes.get(HEADER..).unwrap_or_default(), little).map(real).collect();
    let places = vec![0; values.len()];
    record(&head, (values, places), options)
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let (reals, ..) = fields(&lines, 0, (REALS, 15), "a real of the header")?;
    let (integers, ..) = fields(&lines, LINES.0, (INTEGERS, 10), "an integer of the header")?;
    let word = |line: usize, from: usize| {
        let text = lines.get(LINES.0 + LINES.1 + line).and_then(|l| l.1.get(from..(from + 8).min(l.1.len())));
        printable(text.unwrap_or_default().replace("-12345", "").trim())
    };
    let head = Head { reals, integers, names: (word(0, 0), word(6, 16)) };
    let samples = head.integers[SAMPLES].clamp(0.0, MAX_SAMPLES as f64) as usize;
    let (values, places, _) = fields(&lines, LINES.0 + LINES.1 + LINES.2, (samples, 15), "a sample")?;
    record(&head, (values, places), options)
}

fn record(head: &Head, (mut values, mut places): (Vec<f64>, Vec<u32>), options: &ReadOptions) -> Result<Draft, Faults> {
    let samples = head.integers[SAMPLES];
    let step = head.reals[0];
    if head.integers[KIND] != 1.0 && head.integers[KIND] != UNKNOWN {
        let fault = Fault::new(Code::RecordFormat, "this SAC file is not a time series")
            .found(format!("kind {}", head.integers[KIND]));
        return Err(fault.allowed("1 (ITIME)").into());
    }
    if let Some(what) = [(6.0, "displacement"), (7.0, "velocity")].iter().find(|(k, _)| *k == head.integers[VARIABLE]) {
        let fault = Fault::new(Code::NotAcceleration, "this SAC file is not an acceleration record");
        return Err(fault.found(what.1).allowed("acceleration").into());
    }
    if head.integers[EVEN] == 0.0 {
        return Err(Fault::new(Code::TimeStep, "this SAC file has uneven steps, which are not read")
            .help("interpolate it to equal steps")
            .into());
    }
    if !(2.0..=MAX_SAMPLES as f64).contains(&samples) || (values.len() as f64) < samples {
        let message = "another number of samples than the header of this SAC file says";
        let fault = Fault::new(Code::RecordLength, message);
        let fault = fault.found(format!("{} samples, {samples} in the header", values.len()));
        return Err(fault.allowed(format!("2 to {MAX_SAMPLES}")).help("the file may have been cut off").into());
    }
    values.truncate(samples as usize);
    places.truncate(samples as usize);
    if let Some(k) = values.iter().position(|a| !a.is_finite()) {
        return Err(Fault::new(Code::NotFinite, "an acceleration is not a finite number")
            .found(format!("sample {}", k + 1))
            .into());
    }
    if !(step > 0.0 && step.is_finite()) {
        return Err(Fault::new(Code::TimeStep, "the step of this SAC file is out of range")
            .found(format!("{step} s"))
            .into());
    }
    // The step was stored in single precision.
    let exact = (step * 1e6).round() * 1e-6;
    let step = if (exact - step).abs() <= 1e-7 * step { exact } else { step };
    let dt = settle_dt(Some(step), options)?.unwrap_or(step);
    let (unit, unit_source) = settle_unit(None, options, "a text file with a header")?;
    choose(std::slice::from_ref(&head.names.1), options)?;
    Ok(Draft {
        title: Some(printable(&format!("{} {}", head.names.0, head.names.1))).filter(|t| !t.is_empty()),
        format: format!("SAC ({samples} samples, interval {dt} s)"),
        channel: None,
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: vec!["SAC does not fix the unit of the samples; the mean is not removed".into()],
        low_cut: None,
    })
}
