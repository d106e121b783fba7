//! Sets of records: whether one stands for a spectrum, and the design value of its responses.
//!
//! ```text
//!                                       EN 1998-1:2004 3.2.3.1.2(4)      ASCE/SEI 7-16 16.2 (recalled)
//! a   records                           3 or more                        11 or more
//! b   mean of the peaks                 ≥ a_g S, the target at T = 0     –
//! c   mean spectrum, 0.2 T₁ to 2 T₁     ≥ 90 % of the target             ≥ 90 % of the target
//!     of two horizontal components      each direction by itself         maximum over all directions
//! factor = max(0.9/min(mean/target), a_g S/mean PGA): one factor for the whole set, with which b and c just hold
//! ```
//!
//! A tank has two fundamental periods, the impulsive and the sloshing one. The rule is asked for each; at the sloshing period with the
//! damping of sloshing, which the clauses do not know. [`design`] has the design value.

pub mod design;
mod direction;
pub mod standard;

use oscillator::record::Record;
use oscillator::spectrum::{Method, spectrum};

use standard::Standard;

/// Periods from 0.2 T₁ to 2 T₁, evenly spaced in ln T, both ends included: 400 a decade see every peak of a 0.5 % spectrum.
const PERIODS: usize = 401;

/// The horizontal components of an earthquake.
#[derive(Clone, Copy, Debug)]
pub struct Horizontal<'a> {
    /// Along x.
    pub along: &'a Record,
    /// Along y.
    pub across: Option<&'a Record>,
}

/// A record along x alone.
impl<'a> From<&'a Record> for Horizontal<'a> {
    fn from(along: &'a Record) -> Horizontal<'a> {
        Horizontal { along, across: None }
    }
}

/// A period at which the rule is asked.
pub struct Asked<'a> {
    /// T₁ [s].
    pub period: f64,
    /// Damping ratio of both spectra.
    pub damping: f64,
    /// Elastic target spectrum [m/s²] over the period [s] at that damping.
    pub target: &'a dyn Fn(f64) -> f64,
}

/// Which component of a set its spectra are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// That along x.
    Along,
    /// That along y.
    Across,
    /// The maximum over all directions.
    Both,
}

/// Mean spectrum of the set against the target around a period.
#[derive(Clone, Debug, PartialEq)]
pub struct Ratios {
    /// Component of the ratios; where each is asked, the one with the smaller ratio.
    pub component: Component,
    /// Periods [s].
    pub periods: Vec<f64>,
    /// Pseudo-accelerations of each record [m/s²].
    pub records: Vec<Vec<f64>>,
    /// Their mean.
    pub mean: Vec<f64>,
    /// Target [m/s²].
    pub target: Vec<f64>,
    /// Smallest mean/target, and its period [s].
    pub smallest: (f64, f64),
}

/// Mean of the zero-period accelerations over that of the target, of the horizontal component where it is smaller; none where the code does not
/// ask for it.
pub fn zero_period(code: Standard, set: &[Horizontal<'_>], target: &dyn Fn(f64) -> f64) -> Option<f64> {
    let mean = |peaks: Vec<f64>| peaks.iter().sum::<f64>() / set.len() as f64 / target(0.0);
    let along = mean(set.iter().map(|h| h.along.pga()).collect());
    let across: Option<Vec<f64>> = set.iter().map(|h| h.across.map(Record::pga)).collect();
    let smaller = across.filter(|a| !a.is_empty()).map_or(along, |peaks| along.min(mean(peaks)));
    code.asks_for_peak().then_some(smaller)
}

/// The ratios around a period.
pub fn ratios(code: Standard, set: &[Horizontal<'_>], asked: &Asked<'_>) -> Ratios {
    let [low, high] = code.range().map(|r| r * asked.period);
    let step = (high / low).ln() / (PERIODS - 1) as f64;
    let periods: Vec<f64> = (0..PERIODS).map(|i| low * (step * i as f64).exp()).collect();
    let target: Vec<f64> = periods.iter().map(|&t| (asked.target)(t)).collect();
    let alone = |record: &Record| -> Vec<f64> {
        let found = spectrum(record, &periods, &[asked.damping], Method::Exact);
        found.ordinates[0].iter().map(|o| o.psa).collect()
    };
    let of = |component: Component, records: Vec<Vec<f64>>| {
        let mean: Vec<f64> =
            (0..PERIODS).map(|i| records.iter().map(|r| r[i]).sum::<f64>() / records.len() as f64).collect();
        let ratio = |i: usize| mean[i] / target[i];
        let least = (0..PERIODS).fold(0, |best, i| if ratio(i) < ratio(best) { i } else { best });
        Ratios {
            component,
            smallest: (ratio(least), periods[least]),
            periods: periods.clone(),
            records,
            mean,
            target: target.clone(),
        }
    };
    let along: Vec<Vec<f64>> = set.iter().map(|h| alone(h.along)).collect();
    let across: Option<Vec<&Record>> = set.iter().map(|h| h.across).collect();
    let Some(across) = across.filter(|a| !a.is_empty()) else { return of(Component::Along, along) };
    let other: Vec<Vec<f64>> = across.iter().map(|record| alone(record)).collect();
    if code == Standard::Asce716 {
        let pairs = set.iter().zip(&across).zip(along.iter().zip(&other));
        let largest = pairs.map(|((h, across), (x, y))| {
            let both = direction::maxima(h.along, across, &periods, asked.damping);
            let each = both.iter().zip(x.iter().zip(y));
            each.map(|(both, (x, y))| both.max(*x).max(*y)).collect()
        });
        return of(Component::Both, largest.collect());
    }
    let found = [of(Component::Along, along), of(Component::Across, other)];
    let [x, y] = found;
    if y.smallest.0 < x.smallest.0 { y } else { x }
}

/// The one factor for the set with which the rule just holds.
///
/// * `smallest`: smallest mean/target of all periods asked
/// * `zero`: mean over target at T = 0, where it is asked
pub fn factor(code: Standard, smallest: f64, zero: Option<f64>) -> f64 {
    (code.share() / smallest).max(zero.map_or(0.0, |zero| 1.0 / zero))
}

/// Whether the rule holds for the set as it is.
pub fn holds(code: Standard, count: usize, smallest: f64, zero: Option<f64>) -> bool {
    count >= code.fewest() && smallest >= code.share() && zero.is_none_or(|zero| zero >= 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use oscillator::spectrum::ordinates;

    const EN: Standard = Standard::En1998;

    fn record(factor: f64) -> Record {
        let acceleration = |k: i32| factor * ((0.31 * f64::from(k)).sin() + 0.7 * (0.07 * f64::from(k)).cos());
        Record {
            name: "two tones".into(),
            dt: 0.01,
            acceleration: (0..1500).map(acceleration).collect(),
            processing: Vec::new(),
        }
    }

    fn alone(set: &[Record]) -> Vec<Horizontal<'_>> {
        set.iter().map(Horizontal::from).collect()
    }

    /// Copies with the factors 0.5, 1 and 1.5 have the spectrum of the record as their mean. Against a target of 1.25 times that
    /// spectrum, each ratio is 0.8; the factor is 0.9/0.8, and with it the set just holds.
    #[test]
    fn scaled_copies_have_a_known_mean() {
        let set: Vec<Record> = [0.5, 1.0, 1.5].map(record).into();
        let own = record(1.0);
        let target = |t: f64| 1.25 * if t == 0.0 { 0.7 * own.pga() } else { ordinates(&own, t, 0.05).psa };
        let asked = Asked { period: 0.5, damping: 0.05, target: &target };
        let found = ratios(EN, &alone(&set), &asked);
        let zero = zero_period(EN, &alone(&set), &target);
        assert!((found.smallest.0 - 0.8).abs() < 1e-12);
        assert!((zero.unwrap() - 1.0 / (1.25 * 0.7)).abs() < 1e-12);
        assert!((found.periods[0] - 0.1).abs() < 1e-12 && (found.periods[PERIODS - 1] - 1.0).abs() < 1e-12);
        assert_eq!(found.records.len(), 3);
        assert!((found.records[2][7] / found.records[0][7] - 3.0).abs() < 1e-12);
        assert!(!holds(EN, 3, found.smallest.0, zero));
        let factor = factor(EN, found.smallest.0, zero);
        assert!((factor - 1.125).abs() < 1e-12);
        let scaled: Vec<Record> = [0.5, 1.0, 1.5].map(|f| record(1.000_000_001 * f * factor)).into();
        let again = ratios(EN, &alone(&scaled), &asked).smallest.0;
        assert!((again - 0.9).abs() < 1e-8 && holds(EN, 3, again, zero.map(|z| z * factor)));
        // Two records are too few, however strong they are; ten for ASCE 7-16, which asks nothing of the peaks.
        assert!(!holds(EN, 2, 5.0, Some(5.0)));
        assert!(!holds(Standard::Asce716, 10, 5.0, None) && holds(Standard::Asce716, 11, 0.9, None));
        assert_eq!(zero_period(Standard::Asce716, &alone(&set), &target), None);
    }

    /// Where the ground acceleration governs, the factor is its inverse ratio.
    #[test]
    fn the_ground_acceleration_may_govern() {
        assert!((factor(EN, 1.2, Some(0.8)) - 1.25).abs() < 1e-15);
        assert!((factor(Standard::Asce716, 1.2, None) - 0.75).abs() < 1e-15);
        assert!(!holds(EN, 3, 1.2, Some(0.8)) && holds(EN, 3, 0.9, Some(1.0)));
    }

    /// A weak component along y governs under EN 1998. Along the same line the two are one motion of √(1 + ¼) of its size, whatever the
    /// direction of the axes: the maximum over directions. The tones have periods down to 0.2 s, twenty points: 3e-5 at their peaks, and
    /// ten times that for sums of tones.
    #[test]
    fn two_components() {
        let (along, across) = (record(1.0), record(0.5));
        let set = [Horizontal { along: &along, across: Some(&across) }];
        let target = |t: f64| if t == 0.0 { 1.0 } else { ordinates(&along, t, 0.05).psa };
        let asked = Asked { period: 0.5, damping: 0.05, target: &target };
        let weaker = ratios(EN, &set, &asked);
        assert_eq!(weaker.component, Component::Across);
        assert!((weaker.smallest.0 - 0.5).abs() < 1e-12);
        assert!((zero_period(EN, &set, &target).unwrap() - across.pga()).abs() < 1e-12);
        let both = ratios(Standard::Asce716, &set, &asked);
        assert_eq!(both.component, Component::Both);
        let wanted = 1.25_f64.sqrt();
        for (mean, target) in both.mean.iter().zip(&both.target) {
            assert!((mean / target / wanted - 1.0).abs() < 3e-4, "{mean} {target}");
        }
    }

    /// 3 to 6 records: the worst; 7: the mean; of ASCE 7-16 from 11.
    #[test]
    fn how_many_make_a_mean() {
        use standard::Combine::{Mean, Worst};
        let of = |code: Standard| [3, 6, 7, 10, 11].map(|n| code.combine(n));
        assert_eq!(of(EN), [Worst, Worst, Mean, Mean, Mean]);
        assert_eq!(of(Standard::Asce716), [Worst, Worst, Worst, Worst, Mean]);
    }
}
