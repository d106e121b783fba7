//! ESM and ITACA ASCII (DYNA 1.2), also of AFAD: 64 lines `KEY: value`, then a number a line.
//!
//! `SAMPLING_INTERVAL_S`, `NDATA` and `UNITS` are read; `DATA_TYPE` has to be an acceleration. `LOW_CUT_FREQUENCY_HZ` is the corner of the
//! filter, beyond whose period the record says nothing. Licence and citation are passed on.

use super::block::{Line, fields, line, lines, place, whole};
use super::draft::{Draft, choose, printable, settle_dt, settle_unit};
use super::header::unknown_unit;
use super::number::parse;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Lines of the header.
const HEADER: usize = 64;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.get(..11).is_some_and(|key| key.eq_ignore_ascii_case("EVENT_NAME:"))
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read<'t>(text: &'t str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let header = lines.get(..HEADER.min(lines.len())).unwrap_or_default();
    let find = |key: &str| {
        let of = |&(start, line): &(usize, &'t str)| -> Option<(Line<'t>, &'t str)> {
            let (found, value) = line.split_once(':')?;
            found.trim().eq_ignore_ascii_case(key).then_some(((start, line), value.trim()))
        };
        header.iter().find_map(of)
    };
    let number = |key: &str| -> Result<f64, Fault> {
        let (at, value) = find(key).ok_or_else(|| Fault::new(Code::CutOff, format!("the header has no `{key}`")))?;
        parse(value).map_err(|why| Fault::new(why.code(), why.message(key)).at(place(at)).found(value))
    };
    if let Some((at, kind)) = find("DATA_TYPE").filter(|(_, kind)| !kind.eq_ignore_ascii_case("ACCELERATION")) {
        let fault = Fault::new(Code::NotAcceleration, "this is not an acceleration record").at(place(at));
        return Err(fault.found(kind).allowed("DATA_TYPE: ACCELERATION").into());
    }
    let unit = match find("UNITS").filter(|(_, value)| !value.is_empty()) {
        None => None,
        Some((at, value)) => match AccelerationUnit::parse(value) {
            Some(unit) => Some((unit, format!("header, `UNITS: {}`", printable(value)))),
            None => return Err(unknown_unit(value).at(place(at)).into()),
        },
    };
    let (unit, unit_source) = settle_unit(unit, options, "a header line `UNITS: cm/s^2`")?;
    let dt = settle_dt(Some(number("SAMPLING_INTERVAL_S")?), options)?.unwrap_or_default();
    if dt <= 0.0 {
        return Err(Fault::new(Code::TimeStep, "the sampling interval must be greater than 0")
            .found(format!("{dt} s"))
            .into());
    }
    let said = number("NDATA")?;
    let count = whole(said, 2..=MAX_SAMPLES).ok_or_else(|| {
        let fault = Fault::new(Code::RecordLength, "NDATA is out of range").found(format!("{said}"));
        fault.allowed(format!("2 to {MAX_SAMPLES} samples"))
    })?;
    let (values, places, next) = fields(&lines, HEADER, (count, usize::MAX), "an acceleration")?;
    if let Ok(extra) = line(&lines, next, "") {
        let more = lines[next..].iter().filter(|l| !l.1.trim().is_empty()).count();
        if more > 0 {
            let fault = Fault::new(Code::RecordLength, "more numbers than NDATA says").at(place(extra));
            return Err(fault.found(format!("{} numbers", count + more)).allowed(format!("{count}")).into());
        }
    }
    let text_of = |key: &str| find(key).map(|(_, v)| printable(v)).filter(|v| !v.is_empty());
    choose(&[text_of("STREAM").unwrap_or_default()], options)?;
    let corner = number("LOW_CUT_FREQUENCY_HZ").ok().filter(|f| *f > 0.0);
    let notes = [("BASELINE_CORRECTION", "baseline"), ("DATA_LICENSE", "licence"), ("DATA_CITATION", "citation")];
    let notes = (notes.into_iter()).filter_map(|(key, words)| Some(format!("{words}: {}", text_of(key)?)));
    let station = [text_of("NETWORK"), text_of("STATION_CODE"), text_of("STREAM")];
    let station: Vec<String> = station.into_iter().flatten().collect();
    let title = text_of("EVENT_NAME").into_iter().chain([station.join(" ")]);
    let title = title.collect::<Vec<String>>().join(", ");
    Ok(Draft {
        title: Some(title).filter(|t| !t.trim().is_empty()),
        format: format!("ESM ASCII (NDATA = {count}, interval {dt} s)"),
        channel: None,
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: notes.collect(),
        low_cut: corner,
    })
}
