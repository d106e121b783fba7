//! AFAD (Turkey), text of the years to 2020: a header of lines `KEY : value`, the names of three components, and their accelerations in gal.

use super::block::{lines, place};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::header::unknown_unit;
use super::keyed::Keyed;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, ReadOptions};
use files::code::Code;

/// Lines within which the names of the components stand.
const HEADER: usize = 40;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    let first = text.lines().next().unwrap_or_default().to_ascii_uppercase();
    first.contains("STRONG GROUND MOTION RECORDS OF TUR")
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let header = Keyed { lines: &lines, what: "AFAD" };
    let is_names = |line: &str| line.contains("N-S") && line.contains("E-W") && !line.contains(':');
    let head = lines.iter().take(HEADER).position(|line| is_names(line.1)).ok_or_else(|| {
        Fault::new(Code::CutOff, "this AFAD file does not name its components")
            .allowed("a line `N-S  E-W  U-D` before the numbers")
    })?;
    let names: Vec<String> = lines[head].1.split_whitespace().map(String::from).collect();
    let wanted = choose(&names, options)?;
    let step = header.positive("SAMPLING INTERVAL (sec)", |v| v)?;
    let samples = header.positive("NUMBER OF DATA", |v| v)?;
    let (at, _) = header.get("RAW PGA VALUES")?;
    let text = at.1.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map_or("", |(unit, _)| unit);
    let unit = AccelerationUnit::parse(text).ok_or_else(|| unknown_unit(text).at(place(at)))?;
    let (unit, unit_source) = settle_unit(Some((unit, format!("header, `{}`", printable(at.1)))), options, "")?;
    let dt = settle_dt(Some(step), options)?.unwrap_or(step);
    let (values, places) = header.column(head + 1, (wanted, names.len()), samples)?;
    let of = |key: &str| header.get(key).map(|(_, v)| printable(v)).unwrap_or_default();
    Ok(Draft {
        title: Some(format!("AFAD {} {} {}", of("STATION ID"), names[wanted], of("EARTHQUAKE DATE"))),
        format: format!("AFAD text (channel {} of {}, {samples} samples)", wanted + 1, names.len()),
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
