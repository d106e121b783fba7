//! Scaling, stretching, resampling; every step is stated in words.

use oscillator::record::Record;
use tank::STANDARD_GRAVITY;

use crate::input::records::plausible::{self, number};
use crate::input::records::{MAX_SAMPLES, Processing};
use files::code::Code;
use files::error::Error;

/// Applies the processing: `scale_by`, `scale_to`, `time_factor`, `resample`, in this order; every step is stated in
/// [`Record::processing`].
///
/// * `scale_to` sets the peak, so `scale_by` before it has no effect on the result.
/// * `time_factor` multiplies the time step; the accelerations do not change.
/// * `resample` interpolates linearly at k Δt up to the last sample; a coarser step can cut peaks off, which is stated.
///
/// # Errors
/// A factor or step that is not finite, or not positive (`scale_by` may be negative to reverse the sign); a result of
/// more samples than a record may have, with a peak above 1000 g or with a step above 10 s.
pub fn process(record: &Record, processing: &Processing) -> Result<Record, Error> {
    let mut record = record.clone();
    if let Some(factor) = processing.scale_by {
        check("scale_by", factor, factor != 0.0, "a factor other than 0")?;
        scale(&mut record, factor);
        record.processing.push(format!("scaled by the factor {}", number(factor)));
    }
    if let Some(peak) = processing.scale_to {
        check("scale_to", peak, peak > 0.0, "an acceleration greater than 0")?;
        let factor = peak / record.pga();
        check("scale_to", factor, factor > 0.0, "a record with motion")?;
        scale(&mut record, factor);
        let g = peak / STANDARD_GRAVITY;
        let words = format!("scaled to a peak of {} g ({} m/s²), factor {}", number(g), number(peak), number(factor));
        record.processing.push(words);
    }
    if let Some(factor) = processing.time_factor {
        check("time_factor", factor, factor > 0.0, "a factor greater than 0")?;
        let before = record.dt;
        record.dt *= factor;
        let words = format!(
            "time axis multiplied by {} (step {} s to {} s)",
            number(factor),
            number(before),
            number(record.dt)
        );
        record.processing.push(words);
    }
    if let Some(dt) = processing.resample {
        check("resample", dt, dt > 0.0, "a time step greater than 0")?;
        resample(&mut record, dt)?;
    }
    // The caller checks peaks above 5 g; this checks only that the numbers are ground motion.
    plausible::check(&record, processing.scaled_by(), true)?;
    Ok(record)
}

fn check(name: &str, value: f64, holds: bool, allowed: &str) -> Result<(), Error> {
    if value.is_finite() && holds {
        return Ok(());
    }
    Err(Error::Input(Code::OutOfRange, format!("{name}: found {value}, expected {allowed}")))
}

fn scale(record: &mut Record, factor: f64) {
    for a in &mut record.acceleration {
        *a *= factor;
    }
}

fn resample(record: &mut Record, dt: f64) -> Result<(), Error> {
    let ratio = dt / record.dt;
    let last = record.acceleration.len().saturating_sub(1);
    // A rounding error beyond the last sample still counts as the last sample.
    let steps = (last as f64 / ratio * (1.0 + 1e-12)).floor();
    if !(1.0..MAX_SAMPLES as f64).contains(&steps) {
        let samples = steps + 1.0;
        return Err(Error::Input(
            Code::OutOfRange,
            format!(
                "resample: found a step of {dt} s, which makes {samples:.0} samples of a record of {} s; \
             expected 2 to {MAX_SAMPLES} samples",
                number(record.duration())
            ),
        ));
    }
    let (before, peak) = (record.dt, record.pga());
    record.acceleration = (0..=steps as usize)
        .map(|k| {
            let position = (k as f64 * ratio).min(last as f64);
            let i = (position.floor() as usize).min(last.saturating_sub(1));
            let fraction = position - i as f64;
            record.acceleration[i] + (record.acceleration[i + 1] - record.acceleration[i]) * fraction
        })
        .collect();
    record.dt = dt;
    let mut words = format!("resampled linearly from {} s to {} s", number(before), number(dt));
    let change = record.pga() / peak - 1.0;
    if change.abs() > 1e-9 {
        words.push_str(&format!(" (peak changed by {:.2} %)", 100.0 * change));
    }
    record.processing.push(words);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record() -> Record {
        Record { name: "r".into(), dt: 0.02, acceleration: vec![0.0, 1.0, -2.0, 0.5], processing: vec![] }
    }

    #[test]
    fn scaled_and_stretched() {
        let processing = Processing {
            scale_to: Some(0.5 * STANDARD_GRAVITY),
            scale_by: Some(-3.0),
            time_factor: Some(0.5),
            resample: None,
        };
        let r = process(&record(), &processing).unwrap();
        assert!((r.pga() - 4.903325).abs() < 1e-12 && r.acceleration[1] < 0.0);
        assert_eq!((r.dt, r.acceleration.len()), (0.01, 4));
        assert_eq!(r.processing.len(), 3);
        assert_eq!(r.processing[1], "scaled to a peak of 0.5 g (4.9033 m/s²), factor 0.81722");
    }

    #[test]
    fn resampled() {
        let finer = Processing { resample: Some(0.01), ..Processing::default() };
        let r = process(&record(), &finer).unwrap();
        assert_eq!(r.acceleration, [0.0, 0.5, 1.0, -0.5, -2.0, -0.75, 0.5]);
        assert_eq!(r.processing, ["resampled linearly from 0.02 s to 0.01 s"]);
        let coarser = Processing { resample: Some(0.025), ..Processing::default() };
        let r = process(&record(), &coarser).unwrap();
        // 0, 0.025, 0.05: between the samples 1 and −2, and −2 and 0.5.
        assert_eq!(r.acceleration.len(), 3);
        assert!((r.acceleration[1] - 0.25).abs() < 1e-12 && (r.acceleration[2] + 0.75).abs() < 1e-12);
        assert!(r.processing[0].contains("peak changed by -62.50 %"));
    }

    #[test]
    fn inadmissible_values_are_refused() {
        let bad = |p: Processing| process(&record(), &p).unwrap_err().to_string();
        assert!(bad(Processing { scale_to: Some(-1.0), ..Processing::default() }).contains("scale_to: found -1"));
        assert!(bad(Processing { scale_by: Some(0.0), ..Processing::default() }).contains("other than 0"));
        assert!(bad(Processing { scale_by: Some(f64::NAN), ..Processing::default() }).contains("found NaN"));
        assert!(bad(Processing { time_factor: Some(0.0), ..Processing::default() }).contains("greater than 0"));
        assert!(bad(Processing { resample: Some(1e-12), ..Processing::default() }).contains("samples"));
        assert!(bad(Processing { resample: Some(1.0), ..Processing::default() }).contains("samples"));
    }
}
