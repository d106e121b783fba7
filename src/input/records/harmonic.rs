//! A record of harmonic base motion, by its numbers instead of a file.
//!
//! ```text
//! a(t) = A r(t) sin 2πft        r rises from 0 to 1 within the ramp at the start and falls likewise at the end
//! x(t) = X sin 2πft             with the velocity 2πf X at the start, a pulse in the first step: the liquid feels it
//! ```

use std::f64::consts::TAU;
use std::path::Path;

use tank::units::{self, Dimension};

use files::code::Code;
use files::error::Error;

/// What a record without a file begins with.
const PREFIX: &str = "harmonic:";
/// Samples in a period by default; the line between them is (2π/200)²/12 = 0.01 % too low.
const SAMPLES_PER_PERIOD: f64 = 200.0;
/// Longest time step by default [s].
const LONGEST_STEP: f64 = 0.01;
/// Most samples.
const MOST: f64 = 2e6;

/// Harmonic base motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Harmonic {
    /// Amplitude with its unit: of the acceleration, or of the displacement if it is a length.
    pub amplitude: String,
    /// Frequency [Hz].
    pub frequency: f64,
    /// Duration [s].
    pub duration: f64,
    /// Time within which the amplitude of an acceleration grows at the start and falls at the end [s].
    pub ramp: f64,
    /// Time step [s]; by default a 200th of a period, at most 0.01 s.
    pub dt: Option<f64>,
}

impl Harmonic {
    /// The motion of `harmonic:amplitude=0.1g,period=1.3,cycles=10`; none of a path that does not begin so.
    ///
    /// Errors: a key that is unknown, missing or given twice in effect; a value that is not a number.
    pub(super) fn of(path: &Path) -> Result<Option<Harmonic>, Error> {
        match path.to_str().and_then(|text| text.strip_prefix(PREFIX)) {
            Some(text) => Harmonic::parse(text).map(Some),
            None => Ok(None),
        }
    }

    /// Whether a path is such a motion.
    pub fn is(path: &Path) -> bool {
        path.to_str().is_some_and(|text| text.starts_with(PREFIX))
    }

    fn parse(text: &str) -> Result<Harmonic, Error> {
        const KEYS: [&str; 7] = ["amplitude", "frequency", "period", "cycles", "duration", "ramp", "dt"];
        let mut given: [Option<&str>; 7] = [None; 7];
        for part in text.split(',') {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            let place = KEYS.iter().position(|own| *own == key.trim());
            let known = || format!("`KEY=VALUE` with a key of {}, each once", KEYS.join(", "));
            match place {
                Some(place) if given[place].is_none() && !value.trim().is_empty() => given[place] = Some(value.trim()),
                _ => return refuse("harmonic", &format!("`{part}`"), &known()),
            }
        }
        let number =
            |place: usize| match given[place].map(|text| (text, text.trim_end_matches(['s', ' ']).parse::<f64>())) {
                None => Ok(None),
                Some((_, Ok(value))) if value.is_finite() => Ok(Some(value)),
                Some((text, _)) => refuse(KEYS[place], &format!("`{text}`"), "a number"),
            };
        let one = |what: &str, a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(value), None) | (None, Some(value)) => Ok(value),
            (None, None) => refuse("harmonic", "neither", what),
            (Some(_), Some(_)) => refuse("harmonic", "both", what),
        };
        let Some(amplitude) = given[0] else {
            return refuse(
                "harmonic",
                "no amplitude",
                "amplitude=0.1g, or the amplitude of the displacement, amplitude=5mm",
            );
        };
        let of_period = number(2)?.map(|period| 1.0 / period);
        let frequency = one("either frequency or period", number(1)?, of_period)?;
        let of_cycles = number(3)?.map(|cycles| cycles / frequency);
        let duration = one("either cycles or duration", of_cycles, number(4)?)?;
        Ok(Harmonic {
            amplitude: amplitude.into(),
            frequency,
            duration,
            ramp: number(5)?.unwrap_or(0.0),
            dt: number(6)?,
        })
    }

    /// The record as a table with a header.
    ///
    /// Errors: values out of range.
    pub fn record(&self) -> Result<String, Error> {
        use std::fmt::Write;
        let within = |option: &str, value: f64, (low, high): (f64, f64)| {
            if value >= low && value <= high {
                return Ok(value);
            }
            refuse(option, &format!("`{value}`"), &format!("{low} to {high}"))
        };
        let frequency = within("--frequency", self.frequency, (1e-3, 1e3))?;
        let omega = TAU * frequency;
        let text = self.amplitude.trim();
        let displacement = units::parse(text, Dimension::Length).ok().filter(|value| *value > 0.0);
        let acceleration = match displacement {
            Some(displacement) => Ok(displacement * omega * omega),
            None => units::parse(text, Dimension::Acceleration),
        };
        let amplitude = match acceleration {
            Ok(value) if value > 0.0 && value <= 100.0 => value,
            _ => {
                let allowed =
                    "an acceleration or a displacement with its unit such as 0.1g, 1m/s2 or 5mm, of at most 100 m/s²";
                return refuse("--amplitude", &format!("`{}`", self.amplitude), allowed);
            }
        };
        let duration = within("--duration", self.duration, (1.0 / frequency, 1e5))?;
        let ramp = within("--ramp", self.ramp, (0.0, 0.5 * duration))?;
        if displacement.is_some() && ramp > 0.0 {
            return refuse(
                "--ramp",
                &format!("`{ramp}`"),
                "0 with the amplitude of a displacement, which starts with its velocity",
            );
        }
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
            let a = match displacement {
                // The triangle from here to the next sample has the momentum of the start.
                Some(displacement) if k == 0 => 2.0 * displacement * omega / dt,
                Some(_) => -amplitude * (omega * t).sin(),
                None => amplitude * share * (omega * t).sin(),
            };
            let _ = writeln!(text, "{t:.9},{a:.9e}");
        }
        Ok(text)
    }
}

fn refuse<T>(option: &str, found: &str, allowed: &str) -> Result<T, Error> {
    Err(Error::Input(Code::OptionValue, format!("{option}: found {found}, expected {allowed}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn harmonic(amplitude: &str, ramp: f64) -> Harmonic {
        Harmonic { amplitude: amplitude.into(), frequency: 0.5, duration: 60.0, ramp, dt: None }
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

    /// 5 mm at 0.5 Hz: the displacement from rest is X sin ωt within the error of lines between 200 samples a period.
    #[test]
    fn a_displacement_starts_with_its_velocity() {
        let found = samples(&Harmonic { duration: 6.0, ..harmonic("5mm", 0.0) }.record().expect("valid"));
        let dt = found[1].0;
        let (mut velocity, mut displacement, mut worst) = (0.0, 0.0, 0.0_f64);
        for (k, pair) in found.windows(2).enumerate() {
            displacement += dt * velocity + dt * dt * (2.0 * pair[0].1 + pair[1].1) / 6.0;
            velocity += 0.5 * dt * (pair[0].1 + pair[1].1);
            worst = worst.max((displacement - 0.005 * (TAU * 0.5 * (k + 1) as f64 * dt).sin()).abs());
        }
        // The pulse is a third of a step early: 0.005 · π · dt/3.
        assert!(worst < 1e-4, "{worst}");
    }

    #[test]
    fn a_motion_is_written_as_its_numbers() {
        let of = |text: &str| Harmonic::of(Path::new(text));
        let found = of("harmonic:amplitude=0.1g,period=2,cycles=30,ramp=4").expect("valid");
        assert_eq!(found, Some(harmonic("0.1g", 4.0)));
        assert_eq!(of("harmonic.csv").expect("a file"), None);
        for wrong in [
            "harmonic:",
            "harmonic:amplitude=0.1g",
            "harmonic:amplitude=0.1g,period=2",
            "harmonic:amplitude=0.1g,period=2,frequency=0.5,cycles=3",
            "harmonic:amplitude=0.1g,period=two,cycles=3",
            "harmonic:amplitude=0.1g,amplitude=1g,period=2,cycles=3",
            "harmonic:amplitude=0.1g,speed=2,period=2,cycles=3",
        ] {
            assert!(of(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn values_out_of_range_are_refused() {
        for wrong in [
            harmonic("0.1", 4.0),
            harmonic("-1g", 4.0),
            harmonic("0.1g", 31.0),
            harmonic("0.1g", f64::NAN),
            harmonic("5mm", 1.0),
            harmonic("50m", 0.0),
        ] {
            assert!(wrong.record().is_err());
        }
    }
}
