//! Fragility curves of data, as in `fragility.json`.

pub mod runs;

use ::fragility::bootstrap::{self, Scatter};
use ::fragility::cloud::{self, Run};
use ::fragility::draw::Draw;
use ::fragility::risk::{Risk, risk};
use ::fragility::stripes::{self, Stripe};
use ::fragility::{Fit, Lognormal, NotIdentifiable, capacities, common};
use serde::Serialize;

/// Format of the file.
pub const FORMAT: &str = "tankcheck-fragility/1";

/// Whether the data identify a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveStatus {
    /// They do.
    Fitted,
    /// They do not.
    NotIdentifiable,
}

/// A curve, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// Tank; none of data alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tank: Option<String>,
    /// Damage state.
    pub damage_state: String,
    /// `stripes`, `capacities`, `truncated_capacities` or `cloud`.
    pub method: &'static str,
    /// Intensity measure.
    pub im: String,
    /// Median θ, in the unit of the measure.
    pub median: Option<f64>,
    /// Dispersion β.
    pub dispersion: Option<f64>,
    /// Points behind it: runs, or of capacities one of each record and sample.
    pub n: usize,
    /// Whether there is one.
    pub status: CurveStatus,
    /// Why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Bounds of the median where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounds: Option<[Option<f64>; 2]>,
    /// Negative logarithm of the likelihood, without constants of the data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub negative_log_likelihood: Option<f64>,
    /// Scatter by resampling: the runs of data alone, whole records of a study.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scatter: Option<Scatter>,
    /// The curve with one dispersion for all states, where the free ones cross within the data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub common: Option<Lognormal>,
    /// Risk under the hazard curve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub risk: Option<Risk>,
    /// Regression of a cloud.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cloud: Option<cloud::Cloud>,
    /// The data: counts at intensities.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Point>,
    /// The curve if every run without a result had been safe, and if every one had reached the state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub partial: Option<Partial>,
    /// What the method left out or took for, one sentence each without a full stop.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The curves of the resamples, for bands.
    #[serde(skip)]
    pub samples: Vec<Lognormal>,
    /// Runs that could not be judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unjudged: Option<usize>,
    /// Demands of the state and of worse ones that were not checked, at least in some runs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unchecked: Vec<String>,
    /// Those of them that no run has checked: they take no part.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub never_checked: Vec<String>,
}

/// Runs at an intensity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Point {
    /// Runs with a result, and those that reached the state.
    #[serde(flatten)]
    pub stripe: Stripe,
    /// Runs without a result: not computed, failed, refused or not judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub missing: Option<usize>,
    /// Bounds of the share that reached the state: if none of the missing runs did, and if all did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounds: Option<[f64; 2]>,
}

impl Point {
    /// A point of runs of which none is missing.
    pub fn whole(stripe: Stripe) -> Point {
        Point { stripe, missing: None, bounds: None }
    }
}

/// What missing runs can change of a curve: fits of the counts, whatever its method is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Partial {
    /// Runs without a result.
    pub missing: usize,
    /// The curve if all of them had been safe; none if that identifies none.
    pub if_safe: Option<Lognormal>,
    /// The curve if all of them had reached the state.
    pub if_reached: Option<Lognormal>,
}

/// What is asked of all curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Intensity measure.
    pub im: String,
    /// Resamples; 0 for none.
    pub resamples: usize,
    /// Their seed.
    pub seed: u64,
    /// Hazard curve.
    pub hazard: Option<Vec<[f64; 2]>>,
}

impl Asked {
    fn curve(&self, state: &str, method: &'static str, n: usize, found: Result<Fit, NotIdentifiable>) -> Curve {
        let (fit, refusal) = match found {
            Ok(fit) => (Some(fit), None),
            Err(refusal) => (None, Some(refusal)),
        };
        let hazard = self.hazard.as_deref();
        Curve {
            tank: None,
            damage_state: state.into(),
            method,
            im: self.im.clone(),
            median: fit.map(|f| f.curve.median),
            dispersion: fit.map(|f| f.curve.dispersion),
            n,
            status: match fit {
                Some(_) => CurveStatus::Fitted,
                None => CurveStatus::NotIdentifiable,
            },
            bounds: refusal.as_ref().map(|r| r.bounds).filter(|b| b.iter().any(Option::is_some)),
            reason: refusal.map(|r| r.reason),
            negative_log_likelihood: fit.map(|f| f.negative_log_likelihood),
            scatter: None,
            common: None,
            risk: fit.and_then(|f| risk(&f.curve, hazard?)),
            cloud: None,
            points: Vec::new(),
            partial: None,
            notes: Vec::new(),
            samples: Vec::new(),
            unjudged: None,
            unchecked: Vec::new(),
            never_checked: Vec::new(),
        }
    }

    fn scatter(&self, sample: impl Fn(&mut Draw) -> Result<Lognormal, NotIdentifiable>) -> Option<Scatter> {
        (self.resamples > 0).then(|| bootstrap::scatter(self.resamples, self.seed, sample)).flatten()
    }

    /// Curves of counts at intensities, state by state from mild to severe.
    pub fn of_stripes(&self, states: &[(String, Vec<Stripe>)]) -> Vec<Curve> {
        let mut curves: Vec<Curve> = Vec::new();
        for (state, data) in states {
            let n = data.iter().map(|s| s.n).sum::<f64>().round() as usize;
            let found = stripes::fit(data);
            let scatter = match &found {
                Ok(_) => self.scatter(|draw| stripes::fit(&bootstrap::resampled_stripes(data, draw)).map(|f| f.curve)),
                Err(_) => None,
            };
            curves.push(Curve {
                scatter,
                points: data.iter().copied().map(Point::whole).collect(),
                ..self.curve(state, "stripes", n, found)
            });
        }
        let data: Vec<&[Stripe]> = states.iter().map(|(_, data)| data.as_slice()).collect();
        refit(&mut curves, &data);
        curves
    }

    /// Curves of capacities; with `largest` and `censored` of a scaling that ended.
    pub fn of_capacities(&self, states: &[(String, Vec<f64>)], ended: Option<(f64, usize)>) -> Vec<Curve> {
        let fit = |data: &[f64]| match ended {
            Some((largest, censored)) => capacities::fit_truncated(data, largest, censored),
            None => capacities::fit(data),
        };
        let curve = |(state, data): &(String, Vec<f64>)| {
            let n = data.len() + ended.map_or(0, |(_, censored)| censored);
            let found = fit(data);
            // The runs that never reached the state are runs too.
            let runs: Vec<Option<f64>> = data.iter().copied().map(Some).chain(vec![None; n - data.len()]).collect();
            let sample = |draw: &mut Draw| {
                let drawn = bootstrap::resampled(&runs, draw);
                let seen: Vec<f64> = drawn.iter().copied().flatten().collect();
                match ended {
                    Some((largest, _)) => capacities::fit_truncated(&seen, largest, drawn.len() - seen.len()),
                    None => capacities::fit(&seen),
                }
                .map(|f| f.curve)
            };
            let method = if ended.is_some() { "truncated_capacities" } else { "capacities" };
            Curve {
                scatter: found.as_ref().ok().and_then(|_| self.scatter(sample)),
                ..self.curve(state, method, n, found)
            }
        };
        states.iter().map(curve).collect()
    }

    /// Curves of limits of a demand.
    pub fn of_cloud(&self, runs: &[Run], limits: &[(String, f64)]) -> Vec<Curve> {
        let regression = cloud::fit(runs);
        let curve = |(state, limit): &(String, f64)| {
            let found = regression.clone().and_then(|cloud| {
                Ok(Fit { curve: cloud.curve(*limit)?, n: cloud.n, negative_log_likelihood: f64::NAN })
            });
            let sample = |draw: &mut Draw| cloud::fit(&bootstrap::resampled(runs, draw))?.curve(*limit);
            Curve {
                scatter: found.as_ref().ok().and_then(|_| self.scatter(sample)),
                cloud: regression.as_ref().ok().copied(),
                negative_log_likelihood: None,
                ..self.curve(state, "cloud", runs.len(), found)
            }
        };
        limits.iter().map(curve).collect()
    }
}

/// Gives curves that cross within the data a fit with one dispersion beside them.
///
/// * `data`: counts of each curve
fn refit(curves: &mut [Curve], data: &[&[Stripe]]) {
    let fitted: Vec<usize> =
        (0..curves.len()).filter(|&i| curves[i].curve().is_some() && stripes::fit(data[i]).is_ok()).collect();
    let free: Vec<Lognormal> = fitted.iter().filter_map(|&i| curves[i].curve()).collect();
    let ims = || data.iter().flat_map(|data| data.iter().map(|s| s.im));
    let range = [ims().fold(f64::INFINITY, f64::min), ims().fold(0.0, f64::max)];
    let counts: Vec<Vec<Stripe>> = fitted.iter().map(|&i| data[i].to_vec()).collect();
    if free.len() > 1
        && common::cross(&free, range)
        && let Ok(refit) = common::fit(&counts)
    {
        for (&i, curve) in fitted.iter().zip(refit) {
            curves[i].common = Some(curve);
        }
    }
}

impl Curve {
    /// The lognormal curve; none where the data do not identify it.
    pub fn curve(&self) -> Option<Lognormal> {
        Some(Lognormal { median: self.median?, dispersion: self.dispersion? })
    }
}
