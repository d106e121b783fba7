//! Curves of the runs of a study, which share records.
//!
//! A record shakes a tank at several intensities, and every sample of it: its runs are not independent. Bands therefore come from resampling
//! whole records. Three methods:
//!
//! | method | data |
//! |---|---|
//! | [`Method::Stripes`] | how many runs reached the state at each intensity |
//! | [`Method::Cloud`] | Y, the largest demand over its limit (Jalayer et al. 2017), by regression; runs without a finite demand are collapses |
//! | [`Method::Capacities`] | the intensity at which Y of a record first is 1, between two levels linear in logarithms |

mod bracketed;

use std::collections::{BTreeMap, BTreeSet};

use ::fragility::bootstrap;
use ::fragility::cloud::{self, Cloud, Run};
use ::fragility::stripes::{self, Stripe};
use ::fragility::{Fit, Lognormal, NotIdentifiable, capacities};
use serde::{Deserialize, Serialize};

use super::{Asked, Curve, Partial, Point, refit};
use bracketed::Capacity;

/// Fewest records of which a resample says something of others.
const FEWEST_RECORDS: usize = 3;

/// How the curves of a study are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Counts at intensities.
    #[default]
    Stripes,
    /// Regression of demands.
    Cloud,
    /// Intensities at which records reach the state.
    Capacities,
}

/// What one run says of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Number of the record.
    pub record: u32,
    /// Sample.
    pub sample: u32,
    /// Intensity, positive.
    pub im: f64,
    /// Largest demand over its limit; none of a run without a finite demand.
    pub ratio: Option<f64>,
    /// Whether the state was reached.
    pub reached: bool,
}

/// Counts at intensities.
pub fn counted(runs: &[Seen]) -> Vec<Stripe> {
    let mut counts: BTreeMap<u64, [f64; 2]> = BTreeMap::new();
    for run in runs {
        // Positive numbers have the order of their bits.
        let count = counts.entry(run.im.to_bits()).or_default();
        count[0] += 1.0;
        count[1] += f64::from(u8::from(run.reached));
    }
    let stripe = |(im, [n, exceed]): (u64, [f64; 2])| Stripe { im: f64::from_bits(im), n, exceed };
    counts.into_iter().map(stripe).collect()
}

/// The runs of one state, record by record, as a method takes them.
enum Data {
    Stripes { ims: Vec<f64>, records: Vec<Vec<(usize, bool)>> },
    Cloud(Vec<Vec<Run>>),
    Capacities(Vec<Vec<Capacity>>),
}

/// A fit, and the regression behind it.
type Found = (Fit, Option<Cloud>);

impl Data {
    /// * `notes`: what the method left out or took for
    fn of(method: Method, runs: &[Seen], notes: &mut Vec<String>) -> Data {
        let mut records: BTreeMap<u32, Vec<Seen>> = BTreeMap::new();
        for run in runs {
            records.entry(run.record).or_default().push(*run);
        }
        let records: Vec<Vec<Seen>> = records.into_values().collect();
        match method {
            Method::Stripes => {
                let ims: Vec<f64> = counted(runs).iter().map(|s| s.im).collect();
                let place = |run: &Seen| ims.partition_point(|im| *im < run.im);
                let of = |runs: &Vec<Seen>| runs.iter().map(|run| (place(run), run.reached)).collect();
                Data::Stripes { records: records.iter().map(of).collect(), ims }
            }
            Method::Cloud => {
                let idle = |run: &Seen| run.ratio.is_some_and(|ratio| ratio <= 0.0);
                let left = runs.iter().filter(|run| idle(run)).count();
                if left > 0 {
                    notes.push(format!("{left} runs without a demand greater than 0 are left out of the regression"));
                }
                let of = |runs: &Vec<Seen>| {
                    let kept = runs.iter().filter(|run| !idle(run));
                    kept.map(|run| Run { im: run.im, demand: run.ratio }).collect()
                };
                Data::Cloud(records.iter().map(of).collect())
            }
            Method::Capacities => Data::Capacities(bracketed::capacities(&records, notes)),
        }
    }

    fn len(&self) -> usize {
        match self {
            Data::Stripes { records, .. } => records.len(),
            Data::Cloud(records) => records.len(),
            Data::Capacities(records) => records.len(),
        }
    }

    /// Points that the curve is fitted to: runs, or of capacities one of each record and sample.
    fn points(&self, runs: usize) -> usize {
        match self {
            Data::Capacities(records) => records.iter().map(Vec::len).sum(),
            Data::Stripes { .. } | Data::Cloud(_) => runs,
        }
    }

    fn name(&self) -> &'static str {
        match self {
            Data::Stripes { .. } => "stripes",
            Data::Cloud(_) => "cloud",
            Data::Capacities(records) => {
                let at = |capacity: &Capacity| matches!(capacity, Capacity::At(_));
                if records.iter().flatten().all(at) { "capacities" } else { "truncated_capacities" }
            }
        }
    }

    /// The curve of the records with these numbers.
    ///
    /// Errors: runs that identify none.
    fn fit(&self, picked: &[usize]) -> Result<Found, NotIdentifiable> {
        match self {
            Data::Stripes { ims, records } => {
                let mut counts = vec![[0.0; 2]; ims.len()];
                for &(place, reached) in picked.iter().flat_map(|&i| &records[i]) {
                    counts[place][0] += 1.0;
                    counts[place][1] += f64::from(u8::from(reached));
                }
                let all: Vec<Stripe> = ims
                    .iter()
                    .zip(&counts)
                    .filter(|(_, count)| count[0] > 0.0)
                    .map(|(&im, &[n, exceed])| Stripe { im, n, exceed })
                    .collect();
                Ok((stripes::fit(&all)?, None))
            }
            Data::Cloud(records) => {
                let runs: Vec<Run> = picked.iter().flat_map(|&i| &records[i]).copied().collect();
                let regression = cloud::fit(&runs)?;
                let fit = Fit { curve: regression.total(1.0)?, n: runs.len(), negative_log_likelihood: f64::NAN };
                Ok((fit, Some(regression)))
            }
            Data::Capacities(records) => {
                let (mut at, mut below, mut beyond) = (Vec::new(), Vec::new(), Vec::new());
                for capacity in picked.iter().flat_map(|&i| &records[i]) {
                    match capacity {
                        Capacity::At(im) => at.push(*im),
                        Capacity::Below(im) => below.push(*im),
                        Capacity::Beyond(im) => beyond.push(*im),
                    }
                }
                // Resamples without a run beyond the levels are fitted as the others are.
                let fit = match self.name() {
                    "capacities" => capacities::fit(&at)?,
                    _ => capacities::fit_censored(&at, &below, &beyond)?,
                };
                Ok((fit, None))
            }
        }
    }
}

/// Records, each with each sample, that are in the state at one intensity and not at a higher one.
fn left_again(runs: &[Seen]) -> usize {
    let mut lowest: BTreeMap<(u32, u32), f64> = BTreeMap::new();
    for run in runs.iter().filter(|run| run.reached) {
        let im = lowest.entry((run.record, run.sample)).or_insert(run.im);
        *im = im.min(run.im);
    }
    let left = |run: &&Seen| {
        let reached = lowest.get(&(run.record, run.sample));
        !run.reached && reached.is_some_and(|im| *im < run.im)
    };
    let found: BTreeSet<(u32, u32)> = runs.iter().filter(left).map(|run| (run.record, run.sample)).collect();
    found.len()
}

impl Asked {
    /// Curves of the runs of a study, state by state from mild to severe.
    pub fn of_runs(&self, method: Method, states: &[(String, Vec<Seen>)]) -> Vec<Curve> {
        let counts: Vec<Vec<Stripe>> = states.iter().map(|(_, runs)| counted(runs)).collect();
        let of = |((state, runs), counts): (&(String, Vec<Seen>), &Vec<Stripe>)| {
            let mut notes = Vec::new();
            let left = left_again(runs);
            if left > 0 {
                let records = if left == 1 { "1 record is" } else { &format!("{left} records are") };
                let counts = if method == Method::Capacities { "; the first level counts" } else { "" };
                notes.push(format!("{records} in the state at one level and not at a higher one{counts}"));
            }
            let data = Data::of(method, runs, &mut notes);
            let curve = self.of_data(state, data.points(runs.len()), &data);
            Curve { points: counts.iter().copied().map(Point::whole).collect(), notes, ..curve }
        };
        let mut curves: Vec<Curve> = states.iter().zip(&counts).map(of).collect();
        let data: Vec<&[Stripe]> = counts.iter().map(Vec::as_slice).collect();
        refit(&mut curves, &data);
        curves
    }

    fn of_data(&self, state: &str, n: usize, data: &Data) -> Curve {
        let all: Vec<usize> = (0..data.len()).collect();
        let found = data.fit(&all);
        let regression = found.as_ref().ok().and_then(|(_, regression)| *regression);
        let samples = match found.is_ok() && data.len() >= FEWEST_RECORDS {
            true => bootstrap::curves(self.resamples, self.seed, |draw| {
                let picked: Vec<usize> = all.iter().map(|_| draw.below(all.len())).collect();
                data.fit(&picked).map(|(fit, _)| fit.curve)
            }),
            false => Vec::new(),
        };
        let scatter = bootstrap::summary(&samples, self.resamples);
        let curve = self.curve(state, data.name(), n, found.map(|(fit, _)| fit));
        Curve {
            cloud: regression,
            negative_log_likelihood: curve.negative_log_likelihood.filter(|l| l.is_finite()),
            samples: if scatter.is_some() { samples } else { Vec::new() },
            scatter,
            ..curve
        }
    }
}

/// A run that is planned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planned {
    /// Number of the record.
    pub record: u32,
    /// Sample.
    pub sample: u32,
    /// Intensity, positive.
    pub im: f64,
}

/// A missing run as one that reached the state, or did not, without telling how closely.
fn supposed(run: &Planned, reached: bool) -> Seen {
    Seen {
        record: run.record,
        sample: run.sample,
        im: run.im,
        // The smallest demand puts a capacity above it at the next intensity, none at the one before: the ends of what is possible.
        ratio: (!reached).then_some(f64::MIN_POSITIVE),
        reached,
    }
}

impl Asked {
    /// States what missing runs can change of a curve, by its own method; of a cloud by counts, as a run that is missing has no demand.
    ///
    /// * `runs`: those with a result
    /// * `planned`: all
    pub fn bound(&self, curve: &mut Curve, method: Method, runs: &[Seen], planned: &[Planned]) {
        let key = |record: u32, sample: u32, im: f64| (record, sample, im.to_bits());
        let seen: BTreeSet<_> = runs.iter().map(|run| key(run.record, run.sample, run.im)).collect();
        let open = |run: &&Planned| !seen.contains(&key(run.record, run.sample, run.im));
        let missing: Vec<Planned> = planned.iter().filter(open).copied().collect();
        if missing.is_empty() {
            return;
        }
        let method = match method {
            Method::Cloud => Method::Stripes,
            Method::Stripes | Method::Capacities => method,
        };
        let with = |reached: bool| -> Result<Lognormal, NotIdentifiable> {
            let all: Vec<Seen> = runs.iter().copied().chain(missing.iter().map(|run| supposed(run, reached))).collect();
            let data = Data::of(method, &all, &mut Vec::new());
            let every: Vec<usize> = (0..data.len()).collect();
            data.fit(&every).map(|(fit, _)| fit.curve)
        };
        let (safe, reached) = (with(false), with(true));
        if let Some(reason) = &mut curve.reason {
            // Bounds of the runs with a result are not those of all.
            let end = |found: &Result<Lognormal, NotIdentifiable>, end: usize| match found {
                Ok(curve) => Some(curve.median),
                Err(refusal) => refusal.bounds[end],
            };
            let bounds = [end(&reached, 0), end(&safe, 1)];
            curve.bounds = Some(bounds).filter(|b| b.iter().any(Option::is_some));
            *reason = format!("{reason}; {} of {} runs have no result", missing.len(), planned.len());
        }
        curve.partial = Some(Partial { missing: missing.len(), if_safe: safe.ok(), if_reached: reached.ok() });
        let mut open: BTreeMap<u64, usize> = BTreeMap::new();
        for run in &missing {
            *open.entry(run.im.to_bits()).or_default() += 1;
        }
        let ims: BTreeSet<u64> = planned.iter().map(|run| run.im.to_bits()).collect();
        let point = |bits: &u64| {
            let im = f64::from_bits(*bits);
            let stripe = curve.points.iter().find(|p| p.stripe.im == im).map(|p| p.stripe);
            let stripe = stripe.unwrap_or(Stripe { im, n: 0.0, exceed: 0.0 });
            let Some(&missing) = open.get(bits) else { return Point::whole(stripe) };
            let all = stripe.n + missing as f64;
            Point {
                stripe,
                missing: Some(missing),
                bounds: Some([stripe.exceed, stripe.exceed + missing as f64].map(|m| m / all)),
            }
        };
        curve.points = ims.iter().map(point).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked() -> Asked {
        Asked { im: "PGA".into(), resamples: 200, seed: 0, hazard: None }
    }

    /// A record of capacity c under levels: Y = im/c, so the ratio at a level is known.
    fn runs(capacities: &[f64], levels: &[f64]) -> Vec<Seen> {
        let mut all = Vec::new();
        for (record, capacity) in capacities.iter().enumerate() {
            for &im in levels {
                all.push(Seen {
                    record: record as u32,
                    sample: 0,
                    im,
                    ratio: Some(im / capacity),
                    reached: im >= *capacity,
                });
            }
        }
        all
    }

    const CAPACITIES: [f64; 10] = [0.31, 0.38, 0.42, 0.47, 0.55, 0.58, 0.66, 0.74, 0.9, 1.1];

    fn curve(method: Method, runs: Vec<Seen>) -> Curve {
        asked().of_runs(method, &[("DS1".into(), runs)]).remove(0)
    }

    /// A demand proportional to intensity is a line in logarithms: interpolation finds every capacity, and the fit is that of the worked
    /// capacities (computed outside this program: 0.569468, 0.394104).
    #[test]
    fn capacities_between_levels() {
        let found = curve(Method::Capacities, runs(&CAPACITIES, &[0.2, 0.4, 0.6, 0.8, 1.2]));
        assert_eq!(found.method, "capacities");
        assert!((found.median.unwrap() - 0.569_468).abs() < 1e-6);
        assert!((found.dispersion.unwrap() - 0.394_104).abs() < 1e-6);
        assert!(found.scatter.is_some());
    }

    /// Capacities between 0.4 and 0.45 alone, and one record that is out of the state again at 0.6: both are said.
    #[test]
    fn what_weakens_capacities_is_said() {
        let mut all = runs(&[0.41, 0.42, 0.44], &[0.2, 0.4, 0.6]);
        let found = curve(Method::Capacities, all.clone());
        assert!(found.median.is_some());
        assert_eq!(found.notes.len(), 1, "{:?}", found.notes);
        assert!(found.notes[0].contains("between the same two levels"));
        let last = Seen { im: 0.8, ratio: Some(0.9), reached: false, ..all[0] };
        all.push(last);
        let found = curve(Method::Capacities, all);
        assert!(
            found.notes[0].contains("1 record is in the state at one level and not at a higher one"),
            "{:?}",
            found.notes
        );
    }

    /// Scaling that ends at 0.7 is the truncated likelihood of the seven capacities below.
    #[test]
    fn capacities_beyond_the_last_level() {
        let found = curve(Method::Capacities, runs(&CAPACITIES, &[0.2, 0.4, 0.6, 0.7]));
        let wanted = capacities::fit_truncated(&CAPACITIES[..7], 0.7, 3).unwrap().curve;
        assert_eq!(found.method, "truncated_capacities");
        assert!((found.median.unwrap() / wanted.median - 1.0).abs() < 1e-9);
        assert!((found.dispersion.unwrap() / wanted.dispersion - 1.0).abs() < 1e-9);
    }

    /// The first record (0.31) is in the state at the lowest level, the third was not judged below 0.6: their capacities are below these, and the
    /// others are found.
    #[test]
    fn capacities_below_the_first_level() {
        let mut all = runs(&CAPACITIES, &[0.35, 0.6, 1.2]);
        all.retain(|run| !(run.record == 2 && run.im < 0.5));
        let found = curve(Method::Capacities, all);
        let others: Vec<f64> = [&CAPACITIES[1..2], &CAPACITIES[3..]].concat();
        let wanted = capacities::fit_censored(&others, &[0.35, 0.6], &[]).unwrap().curve;
        assert_eq!((found.method, found.n), ("truncated_capacities", 10));
        assert!((found.median.unwrap() / wanted.median - 1.0).abs() < 1e-9);
        // The third one is also the only one of which a level is missing.
        assert_eq!(found.notes.len(), 2, "{:?}", found.notes);
        assert!(found.notes[0].starts_with("1 record reaches the state at the lowest intensity:"));
        assert!(
            found.notes[1].starts_with("1 record reaches the state at the lowest intensity at which it was judged")
        );
    }

    /// The counts of the same runs; resampling records keeps the runs of a record together, so the band of ten records of one capacity each
    /// is that of ten independent capacities (standard error of the mean of their logarithms), not that of fifty runs. A third leaves room for the
    /// coarse levels.
    #[test]
    fn bands_of_stripes_are_over_records() {
        let levels: Vec<f64> = (0..30).map(|k| 0.25 * 1.06_f64.powi(k)).collect();
        let found = curve(Method::Stripes, runs(&CAPACITIES, &levels));
        let scatter = found.scatter.unwrap();
        let width = (scatter.median.high / scatter.median.low).ln();
        let expected = 2.0 * 1.645 * 0.394_104 / 10.0_f64.sqrt();
        assert!((width / expected - 1.0).abs() < 0.33, "{width} {expected}");
        let again = curve(Method::Stripes, runs(&CAPACITIES, &levels));
        assert_eq!(again.scatter, Some(scatter), "the same seed, the same band");
    }

    /// ln Y = ln im − ln c: slope 1, and the scatter is that of ln c about its mean at every level: n − 2 degrees of freedom of five equal
    /// groups, so σ² = 5 · 9 s²/48 with the worked s = 0.394104, and the median is the worked one.
    #[test]
    fn a_cloud_of_ratios() {
        let found = curve(Method::Cloud, runs(&CAPACITIES, &[0.2, 0.4, 0.6, 0.8, 1.2]));
        assert_eq!(found.method, "cloud");
        assert!((found.median.unwrap() - 0.569_468).abs() < 1e-6);
        let wanted = 0.394_104 * (45.0_f64 / 48.0).sqrt();
        assert!((found.dispersion.unwrap() - wanted).abs() < 1e-6);
        assert!((found.cloud.unwrap().slope - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_collapse_is_a_step_and_is_said() {
        let mut all = runs(&CAPACITIES, &[0.2, 0.4, 0.6, 0.8, 1.2]);
        for run in all.iter_mut().filter(|run| run.im > 1.0) {
            run.ratio = None;
        }
        let found = curve(Method::Capacities, all);
        assert_eq!(found.notes.len(), 1, "{:?}", found.notes);
        assert!(found.notes[0].starts_with("2 capacities"));
    }

    fn planned(levels: &[f64]) -> Vec<Planned> {
        let of = |record: u32| levels.iter().map(move |&im| Planned { record, sample: 0, im });
        (0..CAPACITIES.len() as u32).flat_map(of).collect()
    }

    /// The run at 0.5 of the fourth record (0.47) is missing: its capacity is between 0.4 and 0.6, found at the ends of these if the run was in the
    /// state and if it was not.
    #[test]
    fn a_missing_run_bounds_a_capacity_by_the_levels_beside_it() {
        let levels = [0.2, 0.4, 0.5, 0.6, 1.2];
        let mut all = runs(&CAPACITIES, &levels);
        all.retain(|run| !(run.record == 3 && run.im == 0.5));
        let mut found = curve(Method::Capacities, all.clone());
        asked().bound(&mut found, Method::Capacities, &all, &planned(&levels));
        let partial = found.partial.unwrap();
        let median = |capacity: f64| {
            let mut all = CAPACITIES;
            all[3] = capacity;
            capacities::fit(&all).unwrap().curve.median
        };
        assert!((partial.if_reached.unwrap().median / median(0.4) - 1.0).abs() < 1e-9);
        // ln of the smallest number is −708: the capacity is at 0.6 but for some thousandth of the interval.
        assert!((partial.if_safe.unwrap().median / median(0.6) - 1.0).abs() < 1e-4);
        let between = median(0.4)..median(0.6);
        assert!(between.contains(&found.median.unwrap()));
    }

    /// 8 of 10 runs known, 3 of them reached: 3/10 … 5/10.
    #[test]
    fn missing_runs_bound_shares_and_curves() {
        let mut found = curve(Method::Stripes, runs(&CAPACITIES[..8], &[0.2, 0.4, 0.45, 0.8]));
        let eight = runs(&CAPACITIES[..8], &[0.2, 0.4, 0.45, 0.8]);
        asked().bound(&mut found, Method::Stripes, &eight, &planned(&[0.2, 0.4, 0.45, 0.8]));
        let at = |im: f64| found.points.iter().find(|p| p.stripe.im == im).unwrap();
        assert_eq!((at(0.45).stripe.exceed, at(0.45).missing), (3.0, Some(2)));
        let [low, high] = at(0.45).bounds.unwrap();
        assert!((low - 0.3).abs() < 1e-15 && (high - 0.5).abs() < 1e-15);
        let partial = found.partial.unwrap();
        assert_eq!(partial.missing, 8);
        assert!(partial.if_safe.unwrap().median > partial.if_reached.unwrap().median);
        let whole = curve(Method::Stripes, runs(&CAPACITIES, &[0.4, 0.8]));
        let mut same = whole.clone();
        asked().bound(&mut same, Method::Stripes, &runs(&CAPACITIES, &[0.4, 0.8]), &planned(&[0.4, 0.8]));
        assert_eq!(same, whole);
    }

    #[test]
    fn two_records_have_no_band() {
        let found = curve(Method::Capacities, runs(&CAPACITIES[..2], &[0.2, 0.4, 0.6]));
        assert!(found.median.is_some() && found.scatter.is_none());
    }
}
