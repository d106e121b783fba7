//! Whether a set of records stands for an elastic spectrum: EN 1998-1:2004 3.2.3.1.2(4).
//!
//! ```text
//! a   at least 3 records
//! b   mean of their zero-period accelerations ≥ a_g S, the ordinate of the target at T = 0
//! c   mean 5 % spectrum ≥ 90 % of the target from 0.2 T₁ to 2 T₁
//! factor = max(0.9/min(mean/target), a_g S/mean PGA): one factor for the whole set, with which b and c just hold
//! ```
//!
//! A tank has two fundamental periods, the impulsive and the sloshing one. The rule is asked for each; at the sloshing period with the
//! damping of sloshing, which the clause does not know.

use oscillator::record::Record;
use oscillator::spectrum::{Method, spectrum};

/// The clause.
pub const CLAUSE: &str = "EN 1998-1:2004 3.2.3.1.2(4)";
/// Fewest records.
pub const FEWEST: usize = 3;
/// Part of the target that the mean may fall to.
pub const SHARE: f64 = 0.9;
/// The range of periods over T₁.
pub const RANGE: [f64; 2] = [0.2, 2.0];
/// Periods from 0.2 T₁ to 2 T₁, evenly spaced in ln T, both ends included: 400 a decade see every peak of a 0.5 % spectrum.
const PERIODS: usize = 401;

/// A period at which the rule is asked.
pub struct Asked<'a> {
    /// T₁ [s].
    pub period: f64,
    /// Damping ratio of both spectra.
    pub damping: f64,
    /// Elastic target spectrum [m/s²] over the period [s] at that damping.
    pub target: &'a dyn Fn(f64) -> f64,
}

/// Mean spectrum of the set against the target around a period.
#[derive(Clone, Debug, PartialEq)]
pub struct Ratios {
    /// Periods [s].
    pub periods: Vec<f64>,
    /// Mean of the pseudo-accelerations of the records [m/s²].
    pub mean: Vec<f64>,
    /// Target [m/s²].
    pub target: Vec<f64>,
    /// Smallest mean/target, and its period [s].
    pub smallest: (f64, f64),
}

/// Mean of the zero-period accelerations over that of the target.
pub fn zero_period(records: &[Record], target: &dyn Fn(f64) -> f64) -> f64 {
    let mean = records.iter().map(Record::pga).sum::<f64>() / records.len() as f64;
    mean / target(0.0)
}

/// The ratios around a period.
pub fn ratios(records: &[Record], asked: &Asked<'_>) -> Ratios {
    let [low, high] = RANGE.map(|r| r * asked.period);
    let step = (high / low).ln() / (PERIODS - 1) as f64;
    let periods: Vec<f64> = (0..PERIODS).map(|i| low * (step * i as f64).exp()).collect();
    let mut mean = vec![0.0; PERIODS];
    for record in records {
        let found = spectrum(record, &periods, &[asked.damping], Method::Exact);
        for (sum, ordinates) in mean.iter_mut().zip(&found.ordinates[0]) {
            *sum += ordinates.psa / records.len() as f64;
        }
    }
    let target: Vec<f64> = periods.iter().map(|&t| (asked.target)(t)).collect();
    let ratio = |i: usize| mean[i] / target[i];
    let least = (0..PERIODS).fold(0, |best, i| if ratio(i) < ratio(best) { i } else { best });
    Ratios {
        smallest: (ratio(least), periods[least]),
        periods,
        mean,
        target,
    }
}

/// The one factor for the set with which the rule just holds.
///
/// * `smallest`: smallest mean/target of all periods asked
/// * `zero`: mean over target at T = 0
pub fn factor(smallest: f64, zero: f64) -> f64 {
    (SHARE / smallest).max(1.0 / zero)
}

/// Whether the rule holds for the set as it is.
pub fn holds(count: usize, smallest: f64, zero: f64) -> bool {
    count >= FEWEST && smallest >= SHARE && zero >= 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use oscillator::spectrum::ordinates;

    fn record(factor: f64) -> Record {
        let acceleration = |k: i32| factor * ((0.31 * f64::from(k)).sin() + 0.7 * (0.07 * f64::from(k)).cos());
        Record {
            name: "two tones".into(),
            dt: 0.01,
            acceleration: (0..1500).map(acceleration).collect(),
            processing: Vec::new(),
        }
    }

    /// Copies with the factors 0.5, 1 and 1.5 have the spectrum of the record as their mean. Against a target of 1.25 times that
    /// spectrum, each ratio is 0.8; the factor is 0.9/0.8, and with it the set just holds.
    #[test]
    fn scaled_copies_have_a_known_mean() {
        let set: Vec<Record> = [0.5, 1.0, 1.5].map(record).into();
        let own = record(1.0);
        let target = |t: f64| {
            1.25 * if t == 0.0 {
                0.7 * own.pga()
            } else {
                ordinates(&own, t, 0.05).psa
            }
        };
        let asked = Asked {
            period: 0.5,
            damping: 0.05,
            target: &target,
        };
        let found = ratios(&set, &asked);
        let zero = zero_period(&set, &target);
        assert!((found.smallest.0 - 0.8).abs() < 1e-12);
        assert!((zero - 1.0 / (1.25 * 0.7)).abs() < 1e-12);
        assert!((found.periods[0] - 0.1).abs() < 1e-12 && (found.periods[PERIODS - 1] - 1.0).abs() < 1e-12);
        assert!(!holds(3, found.smallest.0, zero));
        let factor = factor(found.smallest.0, zero);
        assert!((factor - 1.125).abs() < 1e-12);
        let scaled: Vec<Record> = [0.5, 1.0, 1.5].map(|f| record(1.000_000_001 * f * factor)).into();
        let again = ratios(&scaled, &asked).smallest.0;
        assert!((again - 0.9).abs() < 1e-8 && holds(3, again, zero * factor));
        // Two records are too few, however strong they are.
        assert!(!holds(2, 5.0, 5.0));
    }

    /// Where the ground acceleration governs, the factor is its inverse ratio.
    #[test]
    fn the_ground_acceleration_may_govern() {
        assert!((factor(1.2, 0.8) - 1.25).abs() < 1e-15);
        assert!(!holds(3, 1.2, 0.8) && holds(3, 0.9, 1.0));
    }
}
