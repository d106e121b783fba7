//! K-NET and KiK-net ASCII: 17 lines of header, then counts, eight to a line.
//!
//! ```text
//! Sampling Freq(Hz) 100Hz
//! Duration Time(s)  59
//! Scale Factor      2000(gal)/8388608
//!   -18205   -17995 …
//! ```
//!
//! A count times the scale factor is an acceleration in gal. Counts have an offset, the zero of the instrument: their mean is removed. The number
//! of samples is duration times frequency.

use super::block::{Line, at_end, lines, place};
use super::draft::{Collector, Draft, choose, printable, settle_dt, settle_unit};
use super::number::parse;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Lines of the header.
const HEADER: usize = 17;
/// Width of the keys.
const KEY: usize = 18;

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.get(..11)
        .is_some_and(|key| key.eq_ignore_ascii_case("Origin Time"))
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let header = lines.get(..HEADER.min(lines.len())).unwrap_or_default();
    let find = |key: &str| -> Result<(Line<'_>, &str), Fault> {
        let found = header
            .iter()
            .find(|(_, l)| l.get(..key.len()).is_some_and(|k| k.eq_ignore_ascii_case(key)));
        let missing =
            || Fault::new(Code::CutOff, format!("the header has no `{key}`")).help("the file may have been cut off");
        found
            .map(|l| (*l, l.1.get(KEY..).unwrap_or_default().trim()))
            .ok_or_else(missing)
    };
    let positive = |key: &str, end: &str| -> Result<f64, Fault> {
        let (at, value) = find(key)?;
        let bare = value.to_lowercase();
        match parse(bare.trim_end_matches(&end.to_lowercase())) {
            Ok(number) if number > 0.0 => Ok(number),
            _ => Err(
                Fault::new(Code::NotANumber, format!("`{key}` is not a positive number"))
                    .at(place(at))
                    .found(value),
            ),
        }
    };
    let rate = positive("Sampling Freq(Hz)", "Hz")?;
    let duration = positive("Duration Time(s)", "s")?;
    let dt = settle_dt(Some(1.0 / rate), options)?.unwrap_or_default();
    let (at, written) = find("Scale Factor")?;
    let scale = scale(written).ok_or_else(|| {
        Fault::new(Code::RecordFormat, "the scale factor cannot be read")
            .at(place(at))
            .found(written)
            .allowed("2000(gal)/8388608")
    })?;
    let source = (
        AccelerationUnit::Gal,
        format!("header, `Scale Factor {}`", printable(written)),
    );
    let (unit, unit_source) = settle_unit(Some(source), options, "a scale factor in gal")?;
    let mut faults = Collector::new();
    let (mut values, mut places) = (Vec::new(), Vec::new());
    'all: for &(start, line) in lines.iter().skip(HEADER) {
        for token in line.split_whitespace() {
            // A token is a part of its line.
            let from = start + (token.as_ptr() as usize - line.as_ptr() as usize);
            match parse(token) {
                Ok(count) => {
                    values.push(count * scale);
                    places.push(from as u32);
                }
                Err(why) => {
                    let fault = Fault::new(why.code(), why.message("a count")).at(from..from + token.len());
                    if faults.push(fault.found(token)) {
                        break 'all;
                    }
                }
            }
        }
    }
    faults.finish()?;
    let expected = (duration * rate).round();
    if values.len() as f64 != expected || values.len() > MAX_SAMPLES {
        let fault = Fault::new(
            Code::RecordLength,
            "another number of samples than duration times frequency",
        );
        let fault = fault
            .found(format!("{} samples", values.len()))
            .allowed(format!("{expected} samples"));
        return Err(at_end(fault, &lines).help("the file may have been cut off").into());
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter_mut().for_each(|v| *v -= mean);
    let of = |key: &str| find(key).map(|(_, v)| printable(v)).unwrap_or_default();
    choose(&[of("Dir.")], options)?;
    Ok(Draft {
        title: Some(format!("{} {} {}", of("Station Code"), of("Dir."), of("Origin Time"))),
        format: format!("K-NET ASCII ({} counts at {rate} Hz)", values.len()),
        channel: None,
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: vec![
            format!("offset of {mean:.4} gal removed, the mean of the record"),
            "the `Record Time` of the header is 15 s later than the first sample".into(),
        ],
        low_cut: None,
    })
}

/// Gal of a count, from `2000(gal)/8388608`.
fn scale(text: &str) -> Option<f64> {
    let (gal, counts) = text.split_once(")/")?;
    let gal = gal.to_lowercase();
    let (gal, counts) = (gal.strip_suffix("(gal")?, counts);
    let (gal, counts) = (parse(gal).ok()?, parse(counts).ok()?);
    (gal > 0.0 && counts > 0.0).then_some(gal / counts)
}
