//! Plausibility of ground motion: limits that reject a record, and warnings.

use std::fmt::Display;

use oscillator::record::Record;
use tank::STANDARD_GRAVITY;

use crate::input::records::{MAX_PEAK, MAX_PLAUSIBLE, MIN_PEAK, Processing};
use files::code::{Code, Warning};
use files::error::Error;

/// Longest usual time step of ground motion [s]: at 0.1 s the record ends at 5 Hz.
const LONG_STEP: f64 = 0.1;
/// Longest time step of a record [s].
pub const LONGEST_STEP: f64 = 10.0;
/// Shortest time step of a record [s]: instruments take up to some thousand samples a second.
pub const SHORTEST_STEP: f64 = 1e-5;
/// Smallest usual number of samples.
const FEW_SAMPLES: usize = 10;

/// Rejects a processed record that is not ground motion: a peak above 5 g (with `allow_implausible` above
/// [`MAX_PEAK`]), numbers that are not finite, a time step below 1e-5 s or beyond 10 s.
/// * `origin`: option that sets the peak, for the message (`record.scale_by`)
///
/// Errors: [`Error::Input`] with the value and the range.
pub fn check(record: &Record, origin: &str, allow_implausible: bool) -> Result<(), Error> {
    if !(SHORTEST_STEP..=LONGEST_STEP).contains(&record.dt) {
        return Err(Error::Input(
            Code::TimeStep,
            format!(
                "the time step of the record is out of range; found {} s after processing, expected at least {SHORTEST_STEP} s, at most {LONGEST_STEP} s\n  \
             help: correct the time factor or the unit of the time column",
                record.dt
            ),
        ));
    }
    let peak = record.acceleration.iter().fold(0.0, |most: f64, a| match a.is_finite() {
        true => most.max(a.abs()),
        false => f64::INFINITY,
    });
    check_peak(peak, origin, allow_implausible)
}

/// Rejects a peak ground acceleration [m/s²] out of range; see [`check`].
///
/// Errors: [`Error::Input`] with the value and the range.
pub fn check_peak(peak: f64, origin: impl Display, allow_implausible: bool) -> Result<(), Error> {
    let g = |a: f64| a / STANDARD_GRAVITY;
    // A factor of 0 is asked for; a peak that is nearly 0 is a slip of the unit.
    if peak.is_nan() || peak > MAX_PEAK || (peak > 0.0 && peak < MIN_PEAK) {
        return Err(Error::Input(
            Code::PeakAcceleration,
            format!(
                "{origin}: the peak ground acceleration is out of range; found {} g, expected at most {} g and at least {MIN_PEAK:e} m/s2\n  \
                 help: correct the factor or the unit",
                number(g(peak)),
                g(MAX_PEAK)
            ),
        ));
    }
    if peak > MAX_PLAUSIBLE && !allow_implausible {
        return Err(Error::Input(
            Code::PeakAcceleration,
            format!(
                "{origin}: implausible peak ground acceleration; found {} g, expected up to {} g (the largest recorded are near \
             3 g)\n  help: correct the factor or the unit, or add --allow-implausible",
                number(g(peak)),
                g(MAX_PLAUSIBLE)
            ),
        ));
    }
    Ok(())
}

/// Unusual values of a processed record, one sentence each with the usual range.
pub fn doubts(record: &Record, processing: &Processing) -> Vec<Warning> {
    let mut all = Vec::new();
    let name = &record.name;
    if let Some(factor) = processing.scale_by.filter(|f| *f < 0.0) {
        all.push(Warning::new(Code::UnusualRecord, format!(
            "record `{name}`: scale_by is negative, which reverses the shaking; found {factor}, usual values are above 0"
        )));
    }
    if record.acceleration.len() < FEW_SAMPLES {
        all.push(Warning::new(
            Code::UnusualRecord,
            format!(
                "record `{name}`: found {} samples, usual numbers are hundreds to thousands",
                record.acceleration.len()
            ),
        ));
    }
    if record.dt > LONG_STEP {
        all.push(Warning::new(Code::UnusualRecord, format!(
            "record `{name}`: found a time step of {} s, usual values are 0.002 to 0.02 s; above {LONG_STEP} s the record lacks \
             the periods of stiff walls",
            number(record.dt)
        )));
    }
    all
}

/// Five significant digits, without trailing zeros.
pub(super) fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(dt: f64, peak: f64, samples: usize) -> Record {
        let mut acceleration = vec![0.0; samples];
        acceleration[samples / 2] = -peak;
        Record { name: "r".into(), dt, acceleration, processing: vec![] }
    }

    #[test]
    fn peaks_beyond_5_g_need_the_option_and_beyond_1000_g_none_helps() {
        let g = STANDARD_GRAVITY;
        let refused = |peak: f64, allow| check(&record(0.01, peak, 20), "record.scale_by", allow).err();
        assert!(refused(5.0 * g, false).is_none());
        let text = refused(5.001 * g, false).unwrap().to_string();
        for part in ["record.scale_by", "5.001 g", "up to 5 g", "--allow-implausible"] {
            assert!(text.contains(part), "{text}");
        }
        assert!(refused(5.001 * g, true).is_none() && refused(1000.0 * g, true).is_none());
        for peak in [1001.0 * g, 1e300, f64::INFINITY, f64::NAN] {
            let text = refused(peak, true).unwrap().to_string();
            assert!(text.contains("at most 1000 g") && !text.contains("implausible"), "{text}");
        }
        assert!(
            check(&record(10.1, 1.0, 20), "", true).is_err() && check(&record(f64::NAN, 1.0, 20), "", true).is_err()
        );
    }

    #[test]
    fn unusual_records_are_named_with_the_usual_range() {
        let plain = Processing::default();
        assert!(doubts(&record(0.1, 1.0, 10), &plain).is_empty());
        let two = doubts(&record(0.02, 1.0, 2), &plain);
        assert!(two.len() == 1 && two[0].contains("2 samples") && two[0].contains("usual"), "{two:?}");
        let slow = doubts(&record(0.11, 1.0, 10), &plain);
        assert!(slow.len() == 1 && slow[0].contains("0.11 s"), "{slow:?}");
        let reversed = Processing { scale_by: Some(-1.0), ..plain };
        assert!(doubts(&record(0.02, 1.0, 10), &reversed)[0].contains("negative"));
    }
}
