//! CWA (Taiwan, CWB before 2023): a header of lines `#Key: value`, then time and three components.
//!
//! ```text
//! #SampleRate(Hz): 50
//! #AmplitudeUnit:  gal. DCoffset(corr)
//! #DataSequence: Time U(+); N(+); E(+)
//! ```

use super::block::{lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::header::unknown_unit;
use super::keyed::Keyed;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, ReadOptions};
use files::code::Code;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    let begins = |line: &str| line.get(..15).is_some_and(|key| key.eq_ignore_ascii_case("#AmplitudeUnit:"));
    text.starts_with('#') && text.lines().take(40).any(begins)
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let header = Keyed { lines: &lines, what: "CWA" };
    let (at, sequence) = header.get("DataSequence")?;
    let names: Vec<String> = sequence.split([';', ' ']).map(printable).filter(|n| !n.is_empty()).collect();
    if names.first().is_none_or(|first| !first.eq_ignore_ascii_case("time")) || names.len() < 2 {
        let fault = Fault::new(Code::RecordFormat, "the columns of this CWA file are not read").at(place(at));
        return Err(fault.found(printable(sequence)).allowed("`Time U(+); N(+); E(+)`").into());
    }
    let wanted = choose(&names[1..], options)? + 1;
    let rate = header.positive("SampleRate(Hz)", |v| v)?;
    let length = header.positive("RecordLength(sec)", |v| v)?;
    let (at, amplitude) = header.get("AmplitudeUnit")?;
    let text = amplitude.split([' ', '.']).next().unwrap_or_default();
    let unit = AccelerationUnit::parse(text).ok_or_else(|| unknown_unit(amplitude).at(place(at)))?;
    let (unit, unit_source) = settle_unit(Some((unit, format!("header, `{}`", printable(at.1)))), options, "")?;
    let dt = settle_dt(Some(1.0 / rate), options)?.unwrap_or(1.0 / rate);
    let is_data = |line: &&(usize, &str)| !line.1.trim().is_empty() && !line.1.trim_start().starts_with('#');
    let first = lines.iter().position(|line| is_data(&line)).unwrap_or(lines.len());
    let rows = lines.iter().skip(first).filter(is_data).count() as f64;
    // A record of 120 s has 6000 samples at 50 Hz, or one more.
    let samples = (length * rate).round();
    let samples = if rows == samples + 1.0 { rows } else { samples };
    let (values, places) = header.column(first, (wanted, names.len()), samples)?;
    let of = |key: &str| header.get(key).map(|(_, v)| printable(v)).unwrap_or_default();
    Ok(Draft {
        title: Some(format!("{} {} {}", of("StationCode"), names[wanted], of("StartTime"))),
        format: format!("CWA text (channel {wanted} of {}, {samples} samples)", names.len() - 1),
        channel: Some(names[wanted].clone()),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: Vec::new(),
        low_cut: None,
    })
}
