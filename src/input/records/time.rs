//! From a printed time column to a uniform step.

use crate::input::diagnostic::Fault;
use crate::input::records::draft::token_at;
use files::code::Code;

/// A printed time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stamp {
    /// Time [s].
    pub time: f64,
    /// Half the last printed digit [s].
    pub rounding: f64,
    /// Byte of the text at which it is written.
    pub place: u32,
}

/// Relative error of a time that was stored in single precision.
const SINGLE: f64 = 6e-8;

/// Largest printed digit of a time, in steps, that can agree with a given step.
const COARSEST: f64 = 20.0;

/// Whether values increase in about equal steps, as times do.
pub(crate) fn looks_like_time(values: &[f64]) -> bool {
    let steps: Vec<f64> = values.windows(2).map(|p| p[1] - p[0]).collect();
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    steps.len() >= 2 && mean > 0.0 && steps.iter().all(|step| (step - mean).abs() < 0.2 * mean)
}

/// Whether every stamp agrees with a step within the rounding of its digits.
fn agrees(stamps: &[Stamp], dt: f64) -> bool {
    let (Some(first), Some(last)) = (stamps.first(), stamps.last()) else { return false };
    // Digits far above the step tell nothing of it.
    if last.time <= first.time || 2.0 * first.rounding.max(last.rounding) > COARSEST * dt {
        return false;
    }
    stamps.iter().enumerate().all(|(k, stamp)| {
        let rounding = (stamp.rounding + first.rounding) * (1.0 + 1e-6) + 2.0 * SINGLE * stamp.time.abs();
        (stamp.time - first.time - k as f64 * dt).abs() <= rounding
    })
}

/// The uniform step of the stamps [s]: the given one, where every stamp agrees with it within its rounding; else that of the stamps,
/// stored in double or in single precision.
///
/// # Errors
/// Those of stamps in double precision.
pub(crate) fn uniform_step(stamps: &[Stamp], text: &str, given: Option<f64>) -> Result<f64, Fault> {
    let stamps = &rounded(stamps);
    let agreed = given.filter(|dt| stamps.len() > 1 && agrees(stamps, *dt));
    match (step_within(stamps, text, 0.0), agreed) {
        (Ok((dt, true)), _) | (Ok((dt, false)), None) => Ok(dt),
        (_, Some(dt)) => Ok(dt),
        (Err(fault), None) => step_within(stamps, text, SINGLE).map_or(Err(fault), |(dt, _)| Ok(dt)),
    }
}

/// The stamps with the rounding of their file: where zeros at the end were left out, as in `0` or `0.1` among `0.12345`, the finest digit or the
/// most digits of another stamp tell it.
fn rounded(stamps: &[Stamp]) -> Vec<Stamp> {
    let written = |s: &&Stamp| s.rounding > 0.0;
    let finest = stamps.iter().filter(written).map(|s| s.rounding).fold(f64::INFINITY, f64::min);
    let magnitude = |time: f64| (time.abs() * (1.0 + 1e-12)).log10().floor() + 1.0;
    let digits = |s: &Stamp| magnitude(s.time) - (2.0 * s.rounding).log10().round();
    let most = stamps.iter().filter(written).filter(|s| s.time != 0.0).map(digits).fold(1.0, f64::max);
    let of = |s: &Stamp| if s.time == 0.0 { finest } else { finest.max(0.5 * 10f64.powf(magnitude(s.time) - most)) };
    stamps.iter().map(|s| Stamp { rounding: s.rounding.min(of(s)), ..*s }).collect()
}

/// The uniform step of the stamps [s], each with a relative error beside its rounding; and whether the printed digits hold it exactly.
///
/// Printed times are rounded. The step is the mean one, in as few decimals as the rounding of the first and the last
/// time permits. If these decimals are among the printed ones, every printed step must be equal to it; if not
/// (1/256 s printed as 0.0039, 0.0078, 0.0117, …), each may differ by the rounding of its two ends.
///
/// # Errors
/// Fewer than two times, times that do not increase, steps that differ.
fn step_within(stamps: &[Stamp], text: &str, relative: f64) -> Result<(f64, bool), Fault> {
    let (Some(first), Some(last)) = (stamps.first(), stamps.last()) else {
        return Err(Fault::new(Code::RecordLength, "a record needs at least two samples").found("0 samples"));
    };
    if stamps.len() < 2 {
        return Err(Fault::new(Code::RecordLength, "a record needs at least two samples")
            .at(token_at(text, first.place as usize))
            .found("1 sample"));
    }
    if let Some(pair) = stamps.windows(2).find(|p| p[1].time <= p[0].time) {
        let help = if pair[1].time == pair[0].time && pair[1].rounding >= pair[0].rounding {
            "if a comma is the decimal mark, separate the columns by `;`; if the times are rounded, give their step with --dt"
        } else if pair[1].time <= first.time {
            "where several records stand one after the other, write one a file"
        } else {
            "sort the samples by time"
        };
        return Err(Fault::new(Code::TimeStep, "time does not increase")
            .at(token_at(text, pair[1].place as usize))
            .found(format!("{} s after {} s", pair[1].time, pair[0].time))
            .allowed("times that increase in equal steps")
            .help(help));
    }
    let mut steps: Vec<f64> = stamps.windows(2).map(|p| p[1].time - p[0].time).collect();
    let middle = steps.len() / 2;
    let median = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let count = (stamps.len() - 1) as f64;
    let mean = (last.time - first.time) / count;
    let uncertainty = (first.rounding + last.rounding) / count * (1.0 + 1e-6)
        + 1e-12 * mean
        + 2.0 * relative * last.time.abs() / count;
    // The finest printed digit: trailing zeros may have been dropped, so that `0.1` appears between `0.08` and
    // `0.12`.
    let finest = stamps.iter().map(|s| s.rounding).filter(|r| *r > 0.0).fold(f64::INFINITY, f64::min);
    let digit = if finest.is_finite() { 2.0 * finest } else { 0.0 };
    let printable = |dt: f64| digit > 0.0 && ((dt / digit).round() * digit - dt).abs() < 1e-6 * dt;
    let close = if relative > 0.0 { uncertainty } else { 1e-9 * mean };
    let dt = match fewest_decimals(mean, close) {
        exact if printable(exact) => exact,
        _ => fewest_decimals(mean, uncertainty),
    };
    let printed_exactly = printable(dt);
    let allowed = |p: &[Stamp]| {
        let rounding = if printed_exactly { 0.0 } else { p[0].rounding + p[1].rounding };
        rounding * (1.0 + 1e-6) + (1e-9 + 2.0 * relative) * p[1].time.abs() + 1e-6 * median
    };
    let odd = |p: &&[Stamp]| ((p[1].time - p[0].time) - median).abs() > allowed(p);
    let mut strays = stamps.windows(2).filter(odd);
    if let Some(pair) = strays.next() {
        let more = strays.count();
        let others = if more == 0 { String::new() } else { format!(" (and {more} more such steps)") };
        return Err(Fault::new(Code::TimeStep, "the time step is not uniform")
            .at(token_at(text, pair[1].place as usize))
            .found(format!("a step of {:.6} s among steps of {median:.6} s{others}", pair[1].time - pair[0].time))
            .allowed("equal steps")
            .help("resample the record, or correct the missing or displaced samples"));
    }
    Ok((dt, printed_exactly))
}

/// The value within `uncertainty` of `x` with the fewest decimals.
fn fewest_decimals(x: f64, uncertainty: f64) -> f64 {
    (0..=9)
        .map(|decimals| {
            let power = 10f64.powi(decimals);
            (x * power).round() / power
        })
        .find(|rounded| *rounded > 0.0 && (rounded - x).abs() <= uncertainty)
        .unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::records::number::resolution;

    fn step(times: &[&str]) -> Result<f64, String> {
        let stamps: Vec<Stamp> =
            times.iter().map(|t| Stamp { time: t.parse().unwrap(), rounding: 0.5 * resolution(t), place: 0 }).collect();
        uniform_step(&stamps, "", None).map_err(|f| f.message)
    }

    #[test]
    fn printed_steps() {
        assert_eq!(step(&["0.00", "0.02", "0.04", "0.06"]), Ok(0.02));
        assert_eq!(step(&["0.020", "0.040", "0.060"]), Ok(0.02));
        assert_eq!(step(&["0", "1e-2", "2e-2"]), Ok(0.01));
        assert_eq!(step(&["0.000", "0.013"]), Ok(0.013));
        // 1/256 s printed with four digits.
        let times: Vec<String> = (0..2000).map(|k| format!("{:.4}", f64::from(k) / 256.0)).collect();
        let dt = step(&times.iter().map(String::as_str).collect::<Vec<_>>()).unwrap();
        assert!((dt - 1.0 / 256.0).abs() < 1e-4 / 2000.0, "{dt}");
    }

    /// 0.005 k in single precision, as a dump of SAC prints it; and times that were rounded to 0.01 s, for which the step is given.
    #[test]
    fn single_precision_and_rounded_times() {
        let times: Vec<String> = (0..80_000).map(|k| format!("{}", (f64::from(k) * 0.005) as f32)).collect();
        assert_eq!(step(&times.iter().map(String::as_str).collect::<Vec<_>>()), Ok(0.005));
        let printed = |decimals: usize, shift: f64| -> Vec<Stamp> {
            let text = |k: i32| format!("{:.decimals$}", f64::from(k) * 0.005 + shift);
            let stamp =
                |k: i32| Stamp { time: text(k).parse().unwrap(), rounding: 0.5 * resolution(&text(k)), place: 0 };
            (0..5000).map(stamp).collect()
        };
        assert_eq!(uniform_step(&printed(2, 0.0), "", Some(0.005)).unwrap(), 0.005);
        // Cut off instead of rounded.
        assert_eq!(uniform_step(&printed(2, -0.0049), "", Some(0.005)).unwrap(), 0.005);
        assert!(uniform_step(&printed(2, 0.0), "", None).is_err());
        assert!(uniform_step(&printed(2, 0.0), "", Some(0.0051)).is_err());
        assert_eq!(uniform_step(&printed(3, 0.0), "", Some(0.01)).unwrap(), 0.005);
    }

    #[test]
    fn faults() {
        assert!(step(&["0.00"]).unwrap_err().contains("two samples"));
        assert!(step(&["0.00", "0.02", "0.02"]).unwrap_err().contains("not increase"));
        assert!(step(&["0.00", "0.02", "0.01"]).unwrap_err().contains("not increase"));
        assert!(step(&["0.00", "0.02", "0.04", "0.08", "0.10"]).unwrap_err().contains("not uniform"));
        assert!(step(&["0.00", "0.01", "0.02", "0.04", "0.05", "0.06"]).unwrap_err().contains("not uniform"));
        assert!(step(&["0.000", "0.020", "0.040", "0.070", "0.080"]).unwrap_err().contains("not uniform"));
    }
}
