//! The end of a nonlinear history: the record and free vibration after it.

use tank::case::GroundMotion;
use tank::options::AfterRecord;
use tank::units::significant;

use crate::FeError;
use crate::estimate::{LONGEST_TAIL, check_steps};

/// End of the record and of the history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    /// End of the longer record [s].
    pub record: f64,
    /// Free vibration after it [s].
    pub tail: f64,
    /// What was asked for.
    after: AfterRecord,
}

impl Span {
    /// Ends of the records and of the history, with the first sloshing mode at the circular frequency `sloshing` [rad/s], 0 without one.
    ///
    /// Errors: free vibration of more than [`LONGEST_TAIL`]; more samples than a response may have.
    pub(crate) fn new(motion: &GroundMotion, after: AfterRecord, sloshing: f64) -> Result<Span, FeError> {
        let period = if sloshing > 0.0 { std::f64::consts::TAU / sloshing } else { 0.0 };
        let span = Span { record: motion.duration(), tail: after.duration(period), after };
        if span.tail > LONGEST_TAIL {
            return Err(FeError::TooLong {
                what: format!("the free vibration after the record takes {:.3e} s", span.tail),
                allowed: format!("at most {LONGEST_TAIL:.0} s, a day"),
                help: "give `analysis.nonlinear.after_record` as a time".into(),
            });
        }
        check_steps("nonlinear run", span.end() / motion.horizontal.dt, 0.0)?;
        Ok(span)
    }

    /// End of the history [s].
    pub(crate) fn end(&self) -> f64 {
        self.record + self.tail
    }

    /// End of the record where the history goes on after it [s].
    pub(crate) fn record_end(&self) -> Option<f64> {
        (self.tail > 0.0).then_some(self.record)
    }

    /// `35.40 s: the record of 31.20 s and 2 periods of the first sloshing mode of free vibration`.
    pub(crate) fn text(&self) -> String {
        let record = format!("{:.2} s: the record", self.end());
        match self.after {
            _ if self.tail == 0.0 => format!("{record} without free vibration after it"),
            AfterRecord::Periods(count) => format!(
                "{record} of {:.2} s and {} periods of the first sloshing mode of free vibration",
                self.record,
                significant(count, 3)
            ),
            AfterRecord::Time(time) => {
                format!("{record} of {:.2} s and {} s of free vibration", self.record, significant(time, 4))
            }
        }
    }

    /// The same as an assumption.
    pub(crate) fn assumption(&self) -> String {
        match self.tail > 0.0 {
            true => format!(
                "The record ends at {:.2} s; the history goes on for {:.2} s of free vibration, and its maxima are those of both.",
                self.record, self.tail
            ),
            false => format!(
                "The history ends with the record at {:.2} s; a long wave may rise further after it.",
                self.record
            ),
        }
    }
}
