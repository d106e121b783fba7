//! CSMIP and CDMG volume 2: channels one after the other, each with headers, acceleration, velocity and displacement.
//!
//! ```text
//!  3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)
//!     -3.038     -.787 …                                                            8F10.3
//! ```
//!
//! The accelerations of one channel are read. A file of several channels needs `--channel`. The corner of the filter is the upper end of the ramp of
//! the line `BANDPASS FILTERED WITH RAMPS AT .050- .100`.

use super::block::{Line, after, fields, lines, place};
use super::draft::{Draft, printable, settle_dt, settle_unit};
use super::number::parse;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Width of a number.
const WIDTH: usize = 10;
const DATA: &str = "POINTS OF ACCEL DATA EQUALLY SPACED AT";
const RAMPS: &str = "FILTERED WITH RAMPS AT";

/// Whether the text is one.
pub(super) fn sniff(text: &str) -> bool {
    text.starts_with("CORRECTED ACCELEROGRAM") && text.to_ascii_uppercase().contains(DATA)
}

/// A channel: the line of its data, its name, and the corner of its filter.
struct Channel<'a> {
    number: usize,
    head: Line<'a>,
    name: String,
    low_cut: Option<f64>,
}

fn channels<'a>(lines: &[Line<'a>]) -> Vec<Channel<'a>> {
    let (mut all, mut name, mut low_cut) = (Vec::new(), String::new(), None);
    for (number, &head) in lines.iter().enumerate() {
        let upper = head.1.to_ascii_uppercase();
        if let Some(at) = upper.find("CHAN ") {
            name = printable(head.1.get(at..).unwrap_or_default());
        }
        if let Some(at) = upper.find(RAMPS) {
            let ramp = upper.get(at + RAMPS.len()..).unwrap_or_default();
            let ends = ramp.split("AND").next().and_then(|low| low.split_once('-'));
            low_cut = ends.and_then(|(_, high)| parse(high).ok()).filter(|f| *f > 0.0);
        }
        if upper.contains(DATA) {
            all.push(Channel {
                number,
                head,
                name: name.clone(),
                low_cut,
            });
        }
    }
    all
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let channels = channels(&lines);
    let names: Vec<String> = channels
        .iter()
        .enumerate()
        .map(|(i, c)| format!("{}: {}", i + 1, c.name))
        .collect();
    let wanted = match (options.channel, channels.len()) {
        (None, 1) => 1,
        (None, _) => {
            let fault = Fault::new(Code::RecordChannel, "the file has several channels").found(names.join("; "));
            return Err(fault.allowed("--channel with one of them").into());
        }
        (Some(channel), _) => channel as usize,
    };
    let Some(channel) = wanted.checked_sub(1).and_then(|i| channels.get(i)) else {
        let fault =
            Fault::new(Code::RecordChannel, "the file has no such channel").found(format!("--channel {wanted}"));
        return Err(fault.allowed(names.join("; ")).into());
    };
    let (at, upper) = (channel.head, channel.head.1.to_ascii_uppercase());
    let samples = upper.split_whitespace().next().and_then(|n| n.parse::<usize>().ok());
    let step = after(at.1, DATA).filter(|dt| *dt > 0.0 && *dt < 10.0);
    let (Some(samples), Some(step)) = (samples.filter(|n| *n <= MAX_SAMPLES), step) else {
        let fault = Fault::new(Code::RecordFormat, "the line before the data cannot be read").at(place(at));
        return Err(fault
            .found(printable(at.1))
            .allowed(format!("`3251 {DATA} .020 SEC`"))
            .into());
    };
    let unit = upper
        .split_once("UNITS:")
        .and_then(|(_, u)| AccelerationUnit::parse(u.split(')').next()?));
    let named = unit.map(|unit| (unit, format!("`{}`", printable(at.1))));
    let (unit, unit_source) = settle_unit(named, options, "`(UNITS: CM/SEC/SEC)` before the data")?;
    let dt = settle_dt(Some(step), options)?.unwrap_or(step);
    let (values, places, _) = fields(&lines, channel.number + 1, (samples, WIDTH), "an acceleration")?;
    let station = lines.get(6).map(|l| printable(l.1)).unwrap_or_default();
    Ok(Draft {
        title: Some(format!("{station}, {}", channel.name)),
        format: format!(
            "CSMIP volume 2 (channel {wanted} of {}, {samples} samples)",
            channels.len()
        ),
        unit,
        unit_source,
        dt,
        values,
        places,
        notes: Vec::new(),
        low_cut: channel.low_cut,
    })
}
