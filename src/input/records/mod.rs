//! Accelerograms: load, recognise the format, read, process.
//!
//! | file | format |
//! |---|---|
//! | [`columns`] | CSV and plain text: one column (acceleration) or two (time, acceleration) |
//! | [`at2`] | PEER `.AT2`, headers of 1999 and NGA |
//! | [`foreign`] | formats that are recognised but not supported |
//! | `process` | scaling, time stretching, resampling |
//!
//! The unit of acceleration comes from the format, the header or [`ReadOptions::unit`], never from the size of the
//! numbers. Every fault is an [`Error::Input`] with file, line, found and expected value.

pub mod at2;
pub mod columns;
pub mod foreign;
mod load;
mod number;
pub mod plausible;
mod process;
mod time;
mod unit;

use std::path::Path;

use oscillator::record::Record;

use crate::input::diagnostic::{Fault, Faults, Source};
use files::error::Error;

pub use process::process;
pub use unit::AccelerationUnit;

/// Largest number of samples of a record: 5.5 hours at 100 Hz. Histories of longer records do not fit in memory.
pub const MAX_SAMPLES: usize = 2_000_000;
/// Largest file that is read [bytes].
pub const MAX_BYTES: u64 = 128 << 20;
/// Largest plausible peak ground acceleration, 5 g [m/s²]; the largest recorded are near 3 g.
pub const MAX_PLAUSIBLE: f64 = 5.0 * tank::STANDARD_GRAVITY;
/// Largest peak ground acceleration of all, 1000 g [m/s²]: beyond shaking tables in centrifuges.
pub const MAX_PEAK: f64 = 1000.0 * tank::STANDARD_GRAVITY;
/// Smallest peak ground acceleration of a record [m/s²]; instruments resolve 1e-6 m/s².
pub const MIN_PEAK: f64 = 1e-9;
/// Reading stops after this many faults.
const MAX_FAULTS: usize = 20;

/// Processing of a record by `tank.json`, in the order of the fields.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Processing {
    /// Scale to this peak [m/s²].
    pub scale_to: Option<f64>,
    /// Multiply accelerations by this.
    pub scale_by: Option<f64>,
    /// Multiply the time axis by this.
    pub time_factor: Option<f64>,
    /// Resample (linear) to this time step [s].
    pub resample: Option<f64>,
}

impl Processing {
    /// The option that sets the peak, for messages.
    pub fn scaled_by(&self) -> &'static str {
        match (self.scale_to, self.scale_by) {
            (Some(_), _) => "scale_to",
            (None, Some(_)) => "scale_by",
            (None, None) => "record",
        }
    }
}

/// Options for reading a file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// Unit, needed if the format does not give it.
    pub unit: Option<AccelerationUnit>,
    /// Time step [s], needed for a single column without time.
    pub dt: Option<f64>,
    /// Accept peaks above 5 g.
    pub allow_implausible: bool,
}

/// A record as read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadRecord {
    /// The record, unprocessed.
    pub record: Record,
    /// Format, in words.
    pub format: String,
    /// Unit of the numbers in the file.
    pub unit: AccelerationUnit,
    /// Where the unit came from, in words.
    pub unit_source: String,
    /// Remarks: a time axis that does not begin at zero, a time column without a unit.
    pub notes: Vec<String>,
    /// SHA-256 of the file.
    pub sha256: String,
}

/// Result of the reader of a format: numbers in the unit of the file.
struct Draft {
    title: Option<String>,
    format: String,
    unit: AccelerationUnit,
    unit_source: String,
    dt: f64,
    values: Vec<f64>,
    /// Byte of the text at which each value begins.
    places: Vec<u32>,
    notes: Vec<String>,
}

/// Reads an accelerogram (`-` reads standard input).
///
/// # Errors
/// A file that cannot be read or is too large, and every fault of its contents, up to a limit all at once.
pub fn read(path: &Path, options: &ReadOptions) -> Result<ReadRecord, Error> {
    read_bytes(&load::load(path)?, path, options)
}

/// Reads an accelerogram from the bytes of the file at `path` (for its name only).
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], path: &Path, options: &ReadOptions) -> Result<ReadRecord, Error> {
    if let Some(dt) = options.dt.filter(|dt| !(*dt > 0.0 && *dt <= plausible::LONGEST_STEP)) {
        return Err(Error::Input(format!(
            "error: --dt: found {dt}, expected a time step in seconds greater than 0, at most {}",
            plausible::LONGEST_STEP
        )));
    }
    let text = load::decode(bytes).map_err(|fault| Faults::from(fault).into_error(&Source::at(path, "")))?;
    let source = Source::at(path, text);
    let draft = draft(&source.text, options).map_err(|faults| faults.into_error(&source))?;
    let scale = draft.unit.si();
    let record = Record {
        name: draft.title.unwrap_or_else(|| stem(path)),
        dt: draft.dt,
        acceleration: draft.values.iter().map(|a| a * scale).collect(),
        processing: Vec::new(),
    };
    Ok(ReadRecord {
        record,
        format: draft.format,
        unit: draft.unit,
        unit_source: draft.unit_source,
        notes: draft.notes,
        sha256: load::sha256(bytes),
    })
}

fn draft(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    if let Some(fault) = foreign::recognise(text) {
        return Err(fault.into());
    }
    let draft = if at2::sniff(text) {
        at2::read(text, options)
    } else {
        columns::read(text, options)
    }?;
    plausible(&draft, text, options)?;
    Ok(draft)
}

/// Rejects files that are not accelerograms: fewer than two samples, zero motion, peaks above 5 g (with the option:
/// above 1000 g).
fn plausible(draft: &Draft, text: &str, options: &ReadOptions) -> Result<(), Faults> {
    if draft.values.len() < 2 {
        return Err(Fault::new("a record needs at least two samples")
            .found(format!("{} sample(s)", draft.values.len()))
            .into());
    }
    let (place, peak) =
        draft.places.iter().zip(&draft.values).fold(
            (0, 0.0),
            |best: (u32, f64), (&place, a)| if a.abs() > best.1 { (place, a.abs()) } else { best },
        );
    if draft.dt > plausible::LONGEST_STEP {
        return Err(Fault::new("the time step is out of range")
            .found(format!("a step of {} s", draft.dt))
            .allowed(format!(
                "at most {} s; usual values are 0.002 to 0.02 s",
                plausible::LONGEST_STEP
            ))
            .help("correct the unit of the time column, or DT")
            .into());
    }
    // In SI, where the smallest numbers of a file vanish.
    if peak * draft.unit.si() == 0.0 {
        return Err(Fault::new("all accelerations are zero")
            .allowed("a record with motion")
            .into());
    }
    let peak_si = peak * draft.unit.si();
    if !(MIN_PEAK..=MAX_PEAK).contains(&peak_si) {
        return Err(Fault::new("the peak ground acceleration is out of range")
            .at(token_at(text, place as usize))
            .found(format!("{peak:e} {}, unit from {}", draft.unit, draft.unit_source))
            .allowed("1e-9 m/s2 to 1000 g")
            .help("correct the number, or the unit in the header or --units")
            .into());
    }
    if peak_si > MAX_PLAUSIBLE && !options.allow_implausible {
        let g = peak_si / tank::STANDARD_GRAVITY;
        return Err(Fault::new(format!("implausible peak ground acceleration of {g:.4} g"))
            .at(token_at(text, place as usize))
            .found(format!("{peak} {}, unit from {}", draft.unit, draft.unit_source))
            .allowed("up to 5 g (the largest recorded are near 3 g)")
            .help("correct the unit in the header or --units; if the peak is right, add --allow-implausible")
            .into());
    }
    Ok(())
}

/// Bytes of the number or word that begins at `start`.
fn token_at(text: &str, start: usize) -> std::ops::Range<usize> {
    let rest = text.get(start..).unwrap_or_default();
    let end = rest
        .find(|c: char| c.is_whitespace() || c == ',' || c == ';')
        .unwrap_or(rest.len());
    start..start + end
}

/// Collects faults up to the limit.
struct Collector {
    faults: Faults,
}

impl Collector {
    fn new() -> Collector {
        Collector { faults: Faults::new() }
    }

    /// Adds a fault; returns true at the limit.
    #[must_use]
    fn push(&mut self, fault: Fault) -> bool {
        self.faults.push(fault);
        if self.faults.list().len() < MAX_FAULTS {
            return false;
        }
        self.faults
            .push(Fault::new(format!("reading stopped after {MAX_FAULTS} faults")));
        true
    }

    fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    fn finish(self) -> Result<(), Faults> {
        if self.faults.is_empty() {
            Ok(())
        } else {
            Err(self.faults)
        }
    }
}

/// The unit of the numbers: that of the file, that of the options, or a fault. `named` is the unit in the file with
/// its source in words.
fn settle_unit(
    named: Option<(AccelerationUnit, String)>,
    options: &ReadOptions,
    example: &str,
) -> Result<(AccelerationUnit, String), Fault> {
    match (named, options.unit) {
        (Some((unit, source)), None) => Ok((unit, source)),
        (Some((unit, source)), Some(given)) if unit == given => Ok((unit, source)),
        (Some((unit, source)), Some(given)) => Err(Fault::new("the file and --units disagree")
            .found(format!("{unit} in the {source}, --units {given}"))
            .allowed("one unit")
            .help("remove --units, or correct the header")),
        (None, Some(given)) => Ok((given, format!("--units {given}"))),
        (None, None) => Err(Fault::new("the file does not give the unit of acceleration")
            .allowed(format!(
                "{example}, or --units with one of {}",
                AccelerationUnit::ALLOWED
            ))
            .help("give the unit; it is never guessed from the size of the numbers")),
    }
}

/// The time step: that of the file, that of the options, or `None`.
fn settle_dt(named: Option<f64>, options: &ReadOptions) -> Result<Option<f64>, Fault> {
    match (named, options.dt) {
        (Some(dt), Some(given)) if (dt - given).abs() > 1e-6 * dt => Err(Fault::new("the file and --dt disagree")
            .found(format!("a step of {dt} s in the file, --dt {given}"))
            .help("remove --dt; to stretch the time axis use the time factor")),
        (Some(dt), _) => Ok(Some(dt)),
        (None, given) => Ok(given),
    }
}

/// File name without folders and extension.
fn stem(path: &Path) -> String {
    if path == Path::new("-") {
        return "stdin".into();
    }
    path.file_stem()
        .map_or_else(|| "record".into(), |s| printable(&s.to_string_lossy()))
}

/// Without control characters and surplus spaces.
fn printable(text: &str) -> String {
    let words: Vec<&str> = text
        .split(|c: char| c.is_whitespace() || c.is_control())
        .filter(|w| !w.is_empty())
        .collect();
    words.join(" ")
}

#[cfg(test)]
mod tests;
