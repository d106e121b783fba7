//! `tankcheck quake harmonic`: a record of harmonic base motion.
//!
//! ```text
//! a(t) = A r(t) sin 2πft        r rises from 0 to 1 within the ramp at the start and falls likewise at the end
//! ```

use std::f64::consts::TAU;
use std::path::PathBuf;

use tank::units::{self, Dimension};

use crate::cli::print;
use crate::error::Error;
use files::write_whole;

/// Samples in a period by default; the line between them is (2π/200)²/12 = 0.01 % too low.
const SAMPLES_PER_PERIOD: f64 = 200.0;
/// Longest time step by default [s].
const LONGEST_STEP: f64 = 0.01;
/// Most samples.
const MOST: f64 = 2e6;

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake harmonic --amplitude 0.1g --frequency 0.5 --duration 60 --ramp 4 -o harmonic.csv
  tankcheck compare tank.json --quake harmonic.csv --out out/")]
pub(super) struct Harmonic {
    /// Amplitude of the acceleration with its unit.
    #[arg(long, value_name = "ACCELERATION")]
    amplitude: String,
    /// Frequency [Hz].
    #[arg(long, value_name = "FREQUENCY")]
    frequency: f64,
    /// Duration [s].
    #[arg(long, value_name = "SECONDS")]
    duration: f64,
    /// Time within which the amplitude grows at the start and falls at the end [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    ramp: f64,
    /// Time step [s] [default: a 200th of a period, at most 0.01 s].
    #[arg(long, value_name = "SECONDS")]
    dt: Option<f64>,
    /// File that is written; it must not exist. Standard output without it.
    #[arg(long, short, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Harmonic {
    /// Writes the record.
    ///
    /// Errors: values out of range, a file that exists or cannot be written.
    pub(super) fn run(&self) -> Result<(), Error> {
        let text = self.record()?;
        let Some(path) = &self.out else { return print(&text) };
        if path.exists() {
            return refuse("--out", &format!("`{}`, which exists", path.display()), "the name of a new file");
        }
        write_whole(path, text.as_bytes()).map_err(Error::Files)
    }

    /// The record as a table with a header.
    fn record(&self) -> Result<String, Error> {
        use std::fmt::Write;
        let amplitude = match units::parse(self.amplitude.trim(), Dimension::Acceleration) {
            Ok(value) if value > 0.0 && value <= 100.0 => value,
            _ => {
                let allowed = "an acceleration with its unit such as 0.1g or 1m/s2, at most 100 m/s²";
                return refuse("--amplitude", &format!("`{}`", self.amplitude), allowed);
            }
        };
        let within = |option: &str, value: f64, (low, high): (f64, f64)| {
            if value >= low && value <= high {
                return Ok(value);
            }
            refuse(option, &format!("`{value}`"), &format!("{low} to {high}"))
        };
        let frequency = within("--frequency", self.frequency, (1e-3, 1e3))?;
        let duration = within("--duration", self.duration, (1.0 / frequency, 1e5))?;
        let ramp = within("--ramp", self.ramp, (0.0, 0.5 * duration))?;
        let period = 1.0 / frequency;
        let usual = (period / SAMPLES_PER_PERIOD).min(LONGEST_STEP);
        let dt = within("--dt", self.dt.unwrap_or(usual), (1e-6, period / 8.0))?;
        let steps = (duration / dt).round();
        if steps > MOST {
            return refuse("--duration", &format!("{steps} time steps"), &format!("at most {MOST}"));
        }
        let mut text = String::from("time_s,acceleration_m_s2\n");
        for k in 0..=steps as usize {
            let t = k as f64 * dt;
            let nearest = t.min((steps * dt - t).max(0.0));
            let share = if nearest < ramp { nearest / ramp } else { 1.0 };
            let _ = writeln!(text, "{t:.9},{:.9e}", amplitude * share * (TAU * frequency * t).sin());
        }
        Ok(text)
    }
}

fn refuse<T>(option: &str, found: &str, allowed: &str) -> Result<T, Error> {
    Err(Error::value(format!("{option}: found {found}, expected {allowed}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn harmonic(amplitude: &str, ramp: f64) -> Harmonic {
        Harmonic { amplitude: amplitude.into(), frequency: 0.5, duration: 60.0, ramp, dt: None, out: None }
    }

    fn samples(text: &str) -> Vec<(f64, f64)> {
        let number = |cell: Option<&str>| cell.and_then(|c| c.parse::<f64>().ok()).expect("a number");
        let line = |line: &str| {
            let mut cells = line.split(',');
            (number(cells.next()), number(cells.next()))
        };
        text.lines().skip(1).map(line).collect()
    }

    /// 0.1 g at 0.5 Hz with ramps of two periods: zero at both ends, A/8 at the first crest, A at a crest in the middle; the ground
    /// comes to rest, because the ramps are whole periods (the trapezoidal rule is exact for the lines between samples: rounding).
    #[test]
    fn a_record_has_its_amplitude_and_comes_to_rest() {
        let text = harmonic("0.1g", 4.0).record().expect("valid");
        assert!(text.starts_with("time_s,acceleration_m_s2\n"));
        let found = samples(&text);
        let dt = found[1].0 - found[0].0;
        let at = |t: f64| found[(t / dt).round() as usize].1 / 0.980_665;
        assert_eq!(found.len(), 6001);
        assert!(at(0.0).abs() < 1e-9 && at(60.0).abs() < 1e-9);
        assert!((at(0.5) - 0.125).abs() < 1e-8 && (at(30.5) - 1.0).abs() < 1e-8 && (at(31.5) + 1.0).abs() < 1e-8);
        let velocity: f64 = found.windows(2).map(|w| 0.5 * dt * (w[0].1 + w[1].1)).sum();
        assert!(velocity.abs() < 1e-6, "{velocity}");
    }

    #[test]
    fn values_out_of_range_are_refused() {
        for wrong in [harmonic("0.1", 4.0), harmonic("-1g", 4.0), harmonic("0.1g", 31.0), harmonic("0.1g", f64::NAN)] {
            assert!(wrong.record().is_err());
        }
    }
}
