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
    text.get(..11).is_some_and(|key| key.eq_ignore_ascii_case("Origin Time"))
}

/// The lines of the header.
struct Header<'t>(&'t [Line<'t>]);

impl<'t> Header<'t> {
    /// The line of a key and its value.
    fn get(&self, key: &str) -> Result<(Line<'t>, &'t str), Fault> {
        let is = |l: &&Line<'t>| l.1.get(..key.len()).is_some_and(|k| k.eq_ignore_ascii_case(key));
        let found = self.0.iter().find(is);
        let missing =
            || Fault::new(Code::CutOff, format!("the header has no `{key}`")).help("the file may have been cut off");
        found.map(|l| (*l, l.1.get(KEY..).unwrap_or_default().trim())).ok_or_else(missing)
    }

    /// A positive number with its unit.
    fn positive(&self, key: &str, unit: &str) -> Result<f64, Fault> {
        let (at, value) = self.get(key)?;
        let number = parse(value.to_lowercase().trim_end_matches(&unit.to_lowercase()));
        number.ok().filter(|number| *number > 0.0).ok_or_else(|| {
            let message = format!("`{key}` is not a positive number");
            Fault::new(Code::NotANumber, message).at(place(at)).found(value)
        })
    }
}

/// Values and places of the counts.
fn counts(lines: &[Line<'_>], scale: f64) -> Result<(Vec<f64>, Vec<u32>), Faults> {
    let mut faults = Collector::new();
    let (mut values, mut places) = (Vec::new(), Vec::new());
    'all: for &(start, line) in lines {
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
    Ok((values, places))
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let (header, data) = lines.split_at(HEADER.min(lines.len()));
    let header = Header(header);
    let rate = header.positive("Sampling Freq(Hz)", "Hz")?;
    let duration = header.positive("Duration Time(s)", "s")?;
    let dt = settle_dt(Some(1.0 / rate), options)?.unwrap_or_default();
    let (at, written) = header.get("Scale Factor")?;
    let scale = scale(written).ok_or_else(|| {
        Fault::new(Code::RecordFormat, "the scale factor cannot be read")
            .at(place(at))
            .found(written)
            .allowed("2000(gal)/8388608")
    })?;
    let source = (AccelerationUnit::Gal, format!("header, `Scale Factor {}`", printable(written)));
    let (unit, unit_source) = settle_unit(Some(source), options, "a scale factor in gal")?;
    let (mut values, places) = counts(data, scale)?;
    let expected = (duration * rate).round();
    if values.len() as f64 != expected || values.len() > MAX_SAMPLES {
        let message = "another number of samples than duration times frequency";
        let fault = Fault::new(Code::RecordLength, message);
        let fault = fault.found(format!("{} samples", values.len())).allowed(format!("{expected} samples"));
        return Err(at_end(fault, &lines).help("the file may have been cut off").into());
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter_mut().for_each(|v| *v -= mean);
    let of = |key: &str| header.get(key).map(|(_, v)| printable(v)).unwrap_or_default();
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
