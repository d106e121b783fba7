//! `fragility.json`: the curves of all tanks and states, and the losses of the farm.

use std::collections::{BTreeMap, BTreeSet};

use ::fragility::farm::{self, Fate};
use rayon::prelude::*;
use serde::Serialize;

use super::damage::{Data, Gathered, Lost};
use super::plan::Plan;
use super::rows::kept;
use crate::curves::runs::{Method, Planned, Seen};
use crate::curves::{Asked, Curve, FORMAT};
use crate::input::study::Axis;

/// Resamples for the bands of a curve.
pub(super) const RESAMPLES: usize = 500;
/// Seed of the resamples.
const SEED: u64 = 0;

/// The contents of `fragility.json`.
#[derive(Clone, Debug, Serialize)]
pub struct Fragility {
    /// Format.
    pub format: &'static str,
    /// Title of the study.
    pub study: String,
    /// Intensity measure.
    pub im: String,
    /// Its unit.
    pub im_unit: String,
    /// Tasks without a result.
    pub missing_tasks: usize,
    /// Tanks without a row.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without_rows: Vec<String>,
    /// Curves of every tank and state. A tank is in a state if any of the state's demands reaches its limit.
    pub curves: Vec<Curve>,
    /// Curves of the farm: the probability that at least one tank is in the state, in the same earthquake.
    pub system: Vec<Curve>,
    /// Losses of contents at each intensity.
    pub farm: Vec<Losses>,
    /// Why there are no losses of a farm of several tanks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_farm: Option<&'static str>,
}

/// Losses of contents at an intensity.
#[derive(Clone, Debug, Serialize)]
pub struct Losses {
    /// Intensity.
    pub im: f64,
    /// Earthquakes in which every tank was judged.
    pub earthquakes: usize,
    /// Earthquakes in which some were not, or that are missing.
    pub not_judged: usize,
    /// P(at least k tanks lost), k = 1, 2, …, counted over the earthquakes that the judged tanks decide; null where none does.
    pub at_least: Vec<Option<f64>>,
    /// Bounds of them where earthquakes or tanks are missing: if no tank without a result was lost, and if all were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_least_bounds: Option<Vec<[f64; 2]>>,
    /// The same of independent tanks with the same shares; null where a tank is judged in no earthquake.
    pub at_least_independent: Option<Vec<f64>>,
    /// Mean volume lost [m³]: each tank over the earthquakes in which it was judged; null where one is judged in none.
    pub mean_volume_m3: Option<f64>,
    /// Bounds of it, as of the shares.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_volume_bounds_m3: Option<[f64; 2]>,
    /// Largest volume that is known to be lost in one earthquake [m³].
    pub largest_volume_m3: Option<f64>,
}

/// Fits all curves.
pub(super) fn fragility(
    plan: &Plan,
    gathered: &Gathered,
    volumes: &BTreeMap<String, f64>,
    missing: usize,
) -> Fragility {
    let asked = Asked { im: plan.im.clone(), resamples: RESAMPLES, seed: SEED, hazard: plan.hazard.clone() };
    let tanks: Vec<&str> = plan.tanks.iter().map(|tank| tank.id.as_str()).collect();
    let seen = |tank: &&str| gathered.curves.contains_key(&((*tank).to_owned(), 0));
    let (with, without): (Vec<&str>, Vec<&str>) = tanks.iter().copied().partition(seen);
    let several = plan.tanks.len() > 1;
    let no_quake = no_farm(plan);
    let farm = if several && no_quake.is_none() { of_farm(plan, gathered, volumes) } else { Vec::new() };
    Fragility {
        format: FORMAT,
        study: plan.name.clone(),
        im: plan.im.clone(),
        im_unit: plan.im_unit.clone(),
        missing_tasks: missing,
        without_rows: match plan.records.is_empty() {
            true => Vec::new(),
            false => without.iter().map(|tank| (*tank).to_owned()).collect(),
        },
        curves: beside_each_other(&with, |tank| of_tank(plan, &asked, tank, gathered)),
        system: if several && no_quake.is_none() { of_system(plan, &asked, gathered) } else { Vec::new() },
        farm,
        no_farm: no_quake.filter(|_| several && !with.is_empty()),
    }
}

/// Why the rows of several tanks at one intensity are not one earthquake.
fn no_farm(plan: &Plan) -> Option<&'static str> {
    if plan.levels.is_empty() {
        return Some("factors give every record its own intensity: there are no levels that the earthquakes share");
    }
    Axis::parse(&plan.im).is_some_and(Axis::of_the_tank).then_some(
        "the measure is at a period of each tank: at one level the tanks are shaken by differently scaled records",
    )
}

/// A function of every item, side by side; results in the order of the items.
pub(super) fn beside_each_other<T: Sync, R: Send>(items: &[T], of: impl Fn(&T) -> Vec<R> + Sync) -> Vec<R> {
    items.par_iter().flat_map_iter(&of).collect()
}

/// Runs of one tank that are planned at levels. Records without a row have numbers beyond the others.
fn planned(plan: &Plan, gathered: &Gathered) -> Vec<Planned> {
    let mut next = gathered.records.len() as u32;
    let mut all = Vec::new();
    for record in &plan.records {
        let record = gathered.records.get(&record.id).copied().unwrap_or_else(|| {
            next += 1;
            next - 1
        });
        for sample in 0..plan.samples {
            all.extend(plan.levels.iter().map(|level| Planned { record, sample, im: kept(*level) }));
        }
    }
    all
}

fn of_tank(plan: &Plan, asked: &Asked, tank: &str, gathered: &Gathered) -> Vec<Curve> {
    let of = |state: usize| gathered.curves.get(&(tank.to_owned(), state));
    let data: Vec<&Data> = (0..plan.damage.len()).filter_map(of).collect();
    let states: Vec<(String, Vec<Seen>)> =
        plan.damage.iter().zip(&data).map(|(state, data)| (state.state.clone(), data.runs.clone())).collect();
    let planned = planned(plan, gathered);
    let judged = gathered.judged.get(tank);
    let with = |(number, (curve, state)): (usize, (Curve, &&Data))| {
        // A worse state is one way into this one.
        let unchecked: BTreeSet<&String> = data[number..].iter().flat_map(|d| d.unchecked.keys()).collect();
        let never = |demand: &&&String| !judged.is_some_and(|judged| judged.contains(**demand));
        let mut curve = Curve {
            tank: Some(tank.into()),
            unjudged: (state.unjudged > 0).then_some(state.unjudged),
            never_checked: unchecked.iter().filter(never).map(|d| (*d).clone()).collect(),
            unchecked: unchecked.into_iter().cloned().collect(),
            ..curve
        };
        asked.bound(&mut curve, plan.method, &state.runs, &planned);
        curve
    };
    asked.of_runs(plan.method, &states).into_iter().zip(&data).enumerate().map(with).collect()
}

/// Curves of "at least one tank in the state", of the earthquakes that the judged tanks decide: one is in the state, or all are judged.
fn of_system(plan: &Plan, asked: &Asked, gathered: &Gathered) -> Vec<Curve> {
    let tanks = plan.tanks.len();
    let of = |(number, state): (usize, &super::damage::DamageState)| {
        let seen = |((record, sample, im), counts): (&super::damage::Quake, &Vec<[usize; 2]>)| {
            let [judged, within] = counts[number];
            (within > 0 || judged == tanks).then(|| Seen {
                record: gathered.records.get(record).copied().unwrap_or_default(),
                sample: *sample,
                im: f64::from_bits(*im),
                ratio: None,
                reached: within > 0,
            })
        };
        (state.state.clone(), gathered.counts.iter().filter_map(seen).collect())
    };
    let states: Vec<(String, Vec<Seen>)> = plan.damage.iter().enumerate().map(of).collect();
    let planned = planned(plan, gathered);
    // Whether a state is reached has no demand: counts, whichever method the tanks use.
    let mut curves = asked.of_runs(Method::Stripes, &states);
    for (curve, (_, runs)) in curves.iter_mut().zip(&states) {
        asked.bound(curve, Method::Stripes, runs, &planned);
    }
    curves
}

/// Losses of contents at each level at which a row was judged.
fn of_farm(plan: &Plan, gathered: &Gathered, volumes: &BTreeMap<String, f64>) -> Vec<Losses> {
    let ids: Vec<&str> = plan.tanks.iter().map(|t| t.id.as_str()).collect();
    // A tank without a row has the volume of the plan.
    let volume = |tank: &super::plan::PlannedTank| volumes.get(&tank.id).copied().or(tank.volume);
    let known: Option<Vec<f64>> = plan.tanks.iter().map(volume).collect();
    let volumes = known.clone().unwrap_or_else(|| vec![0.0; ids.len()]);
    let numbers: BTreeMap<&str, usize> = ids.iter().enumerate().map(|(number, id)| (*id, number)).collect();
    let levels: BTreeSet<u64> = gathered.losses.keys().map(|(_, _, im)| *im).collect();
    let planned = plan.records.len() * plan.samples as usize;
    let mut found = Vec::new();
    for level in levels {
        let quakes: Vec<&Lost> =
            gathered.losses.iter().filter(|((_, _, im), _)| *im == level).map(|(_, lost)| lost).collect();
        let unseen = planned.saturating_sub(quakes.len());
        let mut fates: Vec<Vec<Fate>> = vec![vec![None; quakes.len() + unseen]; ids.len()];
        for (quake, lost) in quakes.iter().enumerate() {
            for (names, fate) in [(&lost.tanks, true), (&lost.safe, false)] {
                for tank in names.iter().filter_map(|name| numbers.get(name.as_str())) {
                    fates[*tank][quake] = Some(fate);
                }
            }
        }
        if let Some(losses) = farm::losses(&fates, &volumes) {
            let open = losses.whole < quakes.len() + unseen;
            found.push(Losses {
                im: f64::from_bits(level),
                earthquakes: losses.whole,
                not_judged: quakes.len() + unseen - losses.whole,
                at_least_bounds: open.then_some(losses.at_least_bounds),
                at_least: losses.at_least,
                at_least_independent: losses.at_least_independent,
                mean_volume_m3: losses.mean_volume.filter(|_| known.is_some()).map(kept),
                mean_volume_bounds_m3: (open && known.is_some()).then_some(losses.mean_volume_bounds.map(kept)),
                largest_volume_m3: known.is_some().then_some(kept(losses.largest_volume)),
            });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..37).collect();
        let found = beside_each_other(&items, |i| vec![*i, *i + 100]);
        let wanted: Vec<usize> = items.iter().flat_map(|i| [*i, *i + 100]).collect();
        assert_eq!(found, wanted);
    }
}
