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

/// The uniform step of the stamps [s].
///
/// Printed times are rounded. The step is the mean one, in as few decimals as the rounding of the first and the last
/// time permits. If these decimals are among the printed ones, every printed step must be equal to it; if not
/// (1/256 s printed as 0.0039, 0.0078, 0.0117, …), each may differ by the rounding of its two ends.
///
/// # Errors
/// Fewer than two times, times that do not increase, steps that differ.
pub(crate) fn uniform_step(stamps: &[Stamp], text: &str) -> Result<f64, Fault> {
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
            "if a comma is the decimal mark, separate the columns by `;`; if the times are rounded, print more digits"
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
    let uncertainty = (first.rounding + last.rounding) / count * (1.0 + 1e-6) + 1e-12 * mean;
    // The finest printed digit: trailing zeros may have been dropped, so that `0.1` appears between `0.08` and
    // `0.12`.
    let finest = stamps
        .iter()
        .map(|s| s.rounding)
        .filter(|r| *r > 0.0)
        .fold(f64::INFINITY, f64::min);
    let digit = if finest.is_finite() { 2.0 * finest } else { 0.0 };
    let printable = |dt: f64| digit > 0.0 && ((dt / digit).round() * digit - dt).abs() < 1e-6 * dt;
    let dt = match fewest_decimals(mean, 1e-9 * mean) {
        exact if printable(exact) => exact,
        _ => fewest_decimals(mean, uncertainty),
    };
    let printed_exactly = printable(dt);
    let allowed = |p: &[Stamp]| {
        let rounding = if printed_exactly {
            0.0
        } else {
            p[0].rounding + p[1].rounding
        };
        rounding * (1.0 + 1e-6) + 1e-9 * p[1].time.abs() + 1e-6 * median
    };
    let odd = |p: &&[Stamp]| ((p[1].time - p[0].time) - median).abs() > allowed(p);
    let mut strays = stamps.windows(2).filter(odd);
    if let Some(pair) = strays.next() {
        let more = strays.count();
        let others = if more == 0 {
            String::new()
        } else {
            format!(" (and {more} more such steps)")
        };
        return Err(Fault::new(Code::TimeStep, "the time step is not uniform")
            .at(token_at(text, pair[1].place as usize))
            .found(format!(
                "a step of {:.6} s among steps of {median:.6} s{others}",
                pair[1].time - pair[0].time
            ))
            .allowed("equal steps")
            .help("resample the record, or correct the missing or displaced samples"));
    }
    Ok(dt)
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
        let stamps: Vec<Stamp> = times
            .iter()
            .map(|t| Stamp {
                time: t.parse().unwrap(),
                rounding: 0.5 * resolution(t),
                place: 0,
            })
            .collect();
        uniform_step(&stamps, "").map_err(|f| f.message)
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

    #[test]
    fn faults() {
        assert!(step(&["0.00"]).unwrap_err().contains("two samples"));
        assert!(step(&["0.00", "0.02", "0.02"]).unwrap_err().contains("not increase"));
        assert!(step(&["0.00", "0.02", "0.01"]).unwrap_err().contains("not increase"));
        assert!(
            step(&["0.00", "0.02", "0.04", "0.08", "0.10"])
                .unwrap_err()
                .contains("not uniform")
        );
        assert!(
            step(&["0.00", "0.01", "0.02", "0.04", "0.05", "0.06"])
                .unwrap_err()
                .contains("not uniform")
        );
        assert!(
            step(&["0.000", "0.020", "0.040", "0.070", "0.080"])
                .unwrap_err()
                .contains("not uniform")
        );
    }
}
