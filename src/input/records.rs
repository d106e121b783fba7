//! Accelerograms: load, recognise the format, read, process.
//!
//! | file | format |
//! |---|---|
//! | [`columns`] | CSV and plain text: one column (acceleration) or two (time, acceleration) |
//! | [`at2`] | PEER `.AT2`, headers of 1999 and NGA |
//! | `esm` | ESM and ITACA ASCII |
//! | `knet` | K-NET and KiK-net ASCII |
//! | `smc` | USGS SMC |
//! | `cosmos` | COSMOS v1.x |
//! | `csmip` | CSMIP and CDMG volume 2 |
//! | [`foreign`] | formats that are recognised but not supported |
//! | `process` | scaling, time stretching, resampling |
//!
//! The unit of acceleration comes from the format, the header or [`ReadOptions::unit`], never from the size of the
//! numbers. Every fault is an [`Error::Input`] with file, line, found and expected value.

pub mod at2;
mod block;
pub mod columns;
mod cosmos;
mod csmip;
mod draft;
mod esm;
pub mod foreign;
mod knet;
mod load;
mod number;
mod options;
pub mod plausible;
mod process;
mod smc;
mod time;
mod unit;

use std::path::Path;

use oscillator::record::Record;

use crate::input::diagnostic::{Fault, Faults, Source};
use draft::{Draft, printable, token_at};
use files::code::Code;
use files::error::Error;

pub use columns::LOW_CUT;
pub use options::{MAX_BYTES, MAX_PEAK, MAX_PLAUSIBLE, MAX_SAMPLES, MIN_PEAK, Processing, ReadOptions, ReadRecord};
pub use process::process;
pub use unit::AccelerationUnit;

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
        return Err(Error::Input(
            Code::OptionValue,
            format!(
                "--dt: found {dt}, expected a time step in seconds greater than 0, at most {}",
                plausible::LONGEST_STEP
            ),
        ));
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
        low_cut_frequency: draft.low_cut,
        sha256: load::sha256(bytes),
    })
}

/// Whether a text is in a format.
type Sniff = fn(&str) -> bool;
/// The reader of a format.
type Reader = fn(&str, &ReadOptions) -> Result<Draft, Faults>;

fn draft(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let agencies: [(Sniff, Reader); 5] = [
        (esm::sniff, esm::read),
        (knet::sniff, knet::read),
        (smc::sniff, smc::read),
        (cosmos::sniff, cosmos::read),
        (csmip::sniff, csmip::read),
    ];
    let agency = agencies.into_iter().find(|(sniff, _)| sniff(text));
    if let (Some(channel), true) = (options.channel, !csmip::sniff(text)) {
        let fault = Fault::new(Code::RecordChannel, "--channel is for files with several channels")
            .found(format!("--channel {channel}"));
        return Err(fault.allowed("a CSMIP volume 2 file").into());
    }
    let draft = match agency {
        Some((_, read)) => read(text, options),
        None => {
            if let Some(fault) = foreign::recognise(text) {
                return Err(fault.into());
            }
            match at2::sniff(text) {
                true => at2::read(text, options),
                false => columns::read(text, options),
            }
        }
    }?;
    plausible(&draft, text, options)?;
    Ok(draft)
}

/// Rejects files that are not accelerograms: fewer than two samples, zero motion, peaks above 5 g (with the option:
/// above 1000 g).
fn plausible(draft: &Draft, text: &str, options: &ReadOptions) -> Result<(), Faults> {
    if draft.values.len() < 2 {
        return Err(Fault::new(Code::RecordLength, "a record needs at least two samples")
            .found(format!("{} sample(s)", draft.values.len()))
            .into());
    }
    let (place, peak) =
        draft.places.iter().zip(&draft.values).fold(
            (0, 0.0),
            |best: (u32, f64), (&place, a)| if a.abs() > best.1 { (place, a.abs()) } else { best },
        );
    if draft.dt > plausible::LONGEST_STEP {
        return Err(Fault::new(Code::TimeStep, "the time step is out of range")
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
        return Err(Fault::new(Code::PeakAcceleration, "all accelerations are zero")
            .allowed("a record with motion")
            .into());
    }
    let peak_si = peak * draft.unit.si();
    if !(MIN_PEAK..=MAX_PEAK).contains(&peak_si) {
        return Err(
            Fault::new(Code::PeakAcceleration, "the peak ground acceleration is out of range")
                .at(token_at(text, place as usize))
                .found(format!("{peak:e} {}, unit from {}", draft.unit, draft.unit_source))
                .allowed("1e-9 m/s2 to 1000 g")
                .help("correct the number, or the unit in the header or --units")
                .into(),
        );
    }
    if peak_si > MAX_PLAUSIBLE && !options.allow_implausible {
        let g = peak_si / tank::STANDARD_GRAVITY;
        return Err(Fault::new(
            Code::PeakAcceleration,
            format!("implausible peak ground acceleration of {g:.4} g"),
        )
        .at(token_at(text, place as usize))
        .found(format!("{peak} {}, unit from {}", draft.unit, draft.unit_source))
        .allowed("up to 5 g (the largest recorded are near 3 g)")
        .help("correct the unit in the header or --units; if the peak is right, add --allow-implausible")
        .into());
    }
    Ok(())
}

/// File name without folders and extension.
fn stem(path: &Path) -> String {
    if path == Path::new("-") {
        return "stdin".into();
    }
    path.file_stem()
        .map_or_else(|| "record".into(), |s| printable(&s.to_string_lossy()))
}

#[cfg(test)]
mod agencies;
#[cfg(test)]
mod tests;
