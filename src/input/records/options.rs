//! Options and result of the reader, and the limits of a record.

use oscillator::record::Record;

use super::unit::AccelerationUnit;

/// Largest number of samples of a record: 5.5 hours at 100 Hz. Histories of longer records do not fit in memory.
pub const MAX_SAMPLES: usize = 2_000_000;
/// Largest file that is read [bytes].
pub const MAX_BYTES: u64 = 128 << 20;
/// Largest plausible peak ground acceleration, 5 g [m/s²]; the largest recorded are near 3 g.
pub const MAX_PLAUSIBLE: f64 = 5.0 * tank::STANDARD_GRAVITY;
/// Largest peak ground acceleration with `--allow-implausible`, 1000 g [m/s²]: beyond shaking tables in centrifuges.
pub const MAX_PEAK: f64 = 1000.0 * tank::STANDARD_GRAVITY;
/// Smallest peak ground acceleration of a record [m/s²]; instruments resolve 1e-6 m/s².
pub const MIN_PEAK: f64 = 1e-9;
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

/// Columns of a table, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// The column of the times, if there is one, and that of the accelerations.
    Table {
        /// Column of the times.
        time: Option<usize>,
        /// Column of the accelerations.
        acceleration: usize,
    },
    /// Values in reading order.
    All,
}

impl std::str::FromStr for Columns {
    type Err = String;

    /// `1,3` for time and acceleration, `3` for the acceleration alone, `all` for values in reading order.
    fn from_str(text: &str) -> Result<Columns, String> {
        let wrong = || {
            "expected the columns of time and acceleration such as `1,3`, that of the acceleration such as `3`, or `all`".to_string()
        };
        if text.eq_ignore_ascii_case("all") {
            return Ok(Columns::All);
        }
        let numbers: Option<Vec<usize>> =
            text.split(',').map(|n| n.trim().parse::<usize>().ok()?.checked_sub(1)).collect();
        match numbers.ok_or_else(wrong)?.as_slice() {
            [acceleration] => Ok(Columns::Table { time: None, acceleration: *acceleration }),
            [time, acceleration] if time != acceleration => {
                Ok(Columns::Table { time: Some(*time), acceleration: *acceleration })
            }
            _ => Err(wrong()),
        }
    }
}

/// Options for reading a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// Unit, needed if the format does not give it.
    pub unit: Option<AccelerationUnit>,
    /// Time step [s], needed for a single column without time.
    pub dt: Option<f64>,
    /// Accept peaks above 5 g.
    pub allow_implausible: bool,
    /// Channel of a file with several: its number, from 1, or a part of its name.
    pub channel: Option<String>,
    /// Lines at the beginning that are not read.
    pub skip_lines: usize,
    /// Columns of a table; those of its header without it.
    pub columns: Option<Columns>,
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
    /// Corner of the low-cut filter [Hz], where the file gives it.
    pub low_cut_frequency: Option<f64>,
    /// The channel that was read of several.
    pub channel: Option<String>,
    /// SHA-256 of the file.
    pub sha256: String,
}

impl ReadRecord {
    /// Longest period of which the record says something [s]: that of the corner of its low-cut filter.
    pub fn usable_period(&self) -> Option<f64> {
        self.low_cut_frequency.map(|corner| 1.0 / corner)
    }

    /// The same of the processed record [s]: a time axis that is stretched stretches its periods.
    pub fn usable_after(&self, processing: &Processing) -> Option<f64> {
        Some(self.usable_period()? * processing.time_factor.unwrap_or(1.0))
    }
}
