//! Accelerograms: load, recognise the format, read, process.
//!
//! | file | format |
//! |---|---|
//! | [`columns`] | CSV and plain text: a table, or values in reading order; `header`, `head`, `leading`, `separator` and `time` are its parts |
//! | [`at2`] | PEER `.AT2`, headers of 1999 and NGA |
//! | `esm` | ESM and ITACA ASCII |
//! | `knet` | K-NET and KiK-net ASCII |
//! | `smc` | USGS SMC |
//! | `cosmos` | COSMOS v1.x |
//! | `csmip` | CSMIP, CDMG, USC and Caltech, volumes 1 and 2 |
//! | `geonet` | GeoNet V1A and V2A |
//! | `afad`, `cwa`, `unam` | stations of Turkey, Taiwan and Mexico; `keyed` is what they share |
//! | `bhrc` | BHRC, Iran |
//! | `sac` | SAC, binary and alphanumeric |
//! | `harmonic` | no file: harmonic motion by its numbers |
//! | [`foreign`] | formats that are recognised but not supported |
//! | `process` | scaling, time stretching, resampling |
//!
//! The unit of acceleration comes from the format, the header or [`ReadOptions::unit`], never from the size of the
//! numbers. Every fault is an [`Error::Input`] with file, line, found and expected value.

mod afad;
pub mod at2;
mod bhrc;
mod block;
pub mod columns;
mod cosmos;
mod csmip;
mod cwa;
mod draft;
mod esm;
mod filter;
pub mod foreign;
mod geonet;
mod harmonic;
mod head;
mod header;
mod keyed;
mod knet;
mod leading;
pub(crate) mod load;
mod number;
mod options;
pub mod plausible;
mod process;
mod sac;
mod separator;
mod smc;
mod time;
mod unam;
mod unit;

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use oscillator::record::Record;

use crate::input::diagnostic::{Fault, Faults, Source};
use draft::{Draft, printable, token_at};
use files::code::Code;
use files::error::Error;

pub use columns::LOW_CUT;
pub use harmonic::Harmonic;
pub use options::{
    Columns, MAX_BYTES, MAX_PEAK, MAX_PLAUSIBLE, MAX_SAMPLES, MIN_PEAK, Processing, ReadOptions, ReadRecord,
};
pub use process::process;
pub use unit::AccelerationUnit;

/// Reads an accelerogram (`-` reads standard input). `FILE#CHANNEL` is a channel of a file, in place of that of the options;
/// `harmonic:KEY=VALUE,…` describes a harmonic motion instead of a file.
///
/// # Errors
/// A file that cannot be read or is too large, and every fault of its contents, up to a limit all at once.
pub fn read(path: &Path, options: &ReadOptions) -> Result<ReadRecord, Error> {
    if let Some(motion) = Harmonic::of(path)? {
        let options = ReadOptions { allow_implausible: options.allow_implausible, ..ReadOptions::default() };
        let mut read = read_bytes(motion.record()?.as_bytes(), path, &options)?;
        read.record.name = printable(&path.to_string_lossy());
        return Ok(read);
    }
    let (file, channel) = located(path);
    let options = ReadOptions { channel: channel.or_else(|| options.channel.clone()), ..options.clone() };
    read_bytes(&load::load(&file)?, &file, &options)
}

/// The file of a path, and the channel behind its `#`: `station.V2#2`. A file with that very name goes first.
pub fn located(path: &Path) -> (PathBuf, Option<String>) {
    let plain = || (path.to_path_buf(), None);
    if path.exists() {
        return plain();
    }
    let text = path.to_string_lossy();
    match text.rsplit_once('#') {
        Some((file, channel)) if !channel.is_empty() && Path::new(file).is_file() => {
            (file.into(), Some(channel.into()))
        }
        _ => plain(),
    }
}

/// Reads an accelerogram from the bytes of the file at `path` (for its name only).
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], path: &Path, options: &ReadOptions) -> Result<ReadRecord, Error> {
    let steps = plausible::SHORTEST_STEP..=plausible::LONGEST_STEP;
    if let Some(dt) = options.dt.filter(|dt| !steps.contains(dt)) {
        return Err(Error::Input(
            Code::OptionValue,
            format!(
                "--dt: found {dt}, expected a time step in seconds of at least {}, at most {}",
                plausible::SHORTEST_STEP,
                plausible::LONGEST_STEP
            ),
        ));
    }
    let at = |fault: Fault| Faults::from(fault).into_error(&Source::at(path, ""));
    let (draft, text) = if sac::sniff_bytes(bytes) {
        (sac::read_bytes(bytes, options), String::new())
    } else if let Some(fault) = foreign::recognise(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)) {
        return Err(at(fault));
    } else {
        let text = load::decode(bytes).map_err(at)?;
        (draft(&text, options), text)
    };
    let source = Source::at(path, text);
    let sound = draft.and_then(|draft| plausible(&draft, &source.text, options).map(|()| draft));
    let draft = sound.map_err(|faults| faults.into_error(&source))?;
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
        channel: draft.channel,
        sha256: load::sha256(bytes),
    })
}

/// Whether a text is in a format.
type Sniff = fn(&str) -> bool;
/// The reader of a format.
type Reader = fn(&str, &ReadOptions) -> Result<Draft, Faults>;

fn draft(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let formats: [(Sniff, Reader); 12] = [
        (esm::sniff, esm::read),
        (knet::sniff, knet::read),
        (smc::sniff, smc::read),
        (cosmos::sniff, cosmos::read),
        (geonet::sniff, geonet::read),
        (csmip::sniff, csmip::read),
        (afad::sniff, afad::read),
        (cwa::sniff, cwa::read),
        (unam::sniff, unam::read),
        (bhrc::sniff, bhrc::read),
        (sac::sniff, sac::read),
        (at2::sniff, at2::read),
    ];
    // Columns are those of a table.
    let formats = if options.columns.is_some() { &[][..] } else { &formats[..] };
    let text = without(text, options.skip_lines);
    match formats.iter().find(|(sniff, _)| sniff(&text)) {
        Some((_, read)) => read(&text, options),
        None => columns::read(&text, options),
    }
}

/// The text without its first lines, which are blank, so that places stay valid.
fn without(text: &str, lines: usize) -> Cow<'_, str> {
    let skipped: usize = text.split_inclusive('\n').take(lines).map(str::len).sum();
    match text.split_at_checked(skipped) {
        Some((first, rest)) if skipped > 0 => {
            let blank = |b: u8| if matches!(b, b'\n' | b'\r') { char::from(b) } else { ' ' };
            Cow::Owned(first.bytes().map(blank).collect::<String>() + rest)
        }
        _ => Cow::Borrowed(text),
    }
}

/// Rejects files that are not accelerograms: fewer than two samples, zero motion, peaks above 5 g (with the option:
/// above 1000 g).
fn plausible(draft: &Draft, text: &str, options: &ReadOptions) -> Result<(), Faults> {
    if draft.values.len() < 2 {
        return Err(Fault::new(Code::RecordLength, "a record needs at least two samples")
            .found(format!("{} sample(s)", draft.values.len()))
            .into());
    }
    let (place, peak) = draft
        .places
        .iter()
        .zip(&draft.values)
        .fold((0, 0.0), |best: (u32, f64), (&place, a)| if a.abs() > best.1 { (place, a.abs()) } else { best });
    if !(plausible::SHORTEST_STEP..=plausible::LONGEST_STEP).contains(&draft.dt) {
        return Err(Fault::new(Code::TimeStep, "the time step is out of range")
            .found(format!("a step of {} s", draft.dt))
            .allowed(format!(
                "at least {} s, at most {} s; usual values are 0.002 to 0.02 s",
                plausible::SHORTEST_STEP,
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
        return Err(Fault::new(Code::PeakAcceleration, "the peak ground acceleration is out of range")
            .at(token_at(text, place as usize))
            .found(format!("{peak:e} {}, unit from {}", draft.unit, draft.unit_source))
            .allowed("1e-9 m/s2 to 1000 g")
            .help("correct the number, or the unit in the header or --units")
            .into());
    }
    if peak_si > MAX_PLAUSIBLE && !options.allow_implausible {
        let g = peak_si / tank::STANDARD_GRAVITY;
        let message = format!("implausible peak ground acceleration of {g:.4} g");
        return Err(Fault::new(Code::PeakAcceleration, message)
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
    path.file_stem().map_or_else(|| "record".into(), |s| printable(&s.to_string_lossy()))
}

#[cfg(test)]
mod agencies;
#[cfg(test)]
mod tests;
