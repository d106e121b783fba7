//! `fragility.json`: the curves of all tanks and states, and the losses of the farm.

use std::collections::{BTreeMap, BTreeSet};

use ::fragility::farm;
use ::fragility::stripes::Stripe;
use serde_json::{Value, json};

use super::damage::{Data, Gathered};
use super::plan::Plan;
use crate::curves::{Asked, Curve, FORMAT};

/// Resamples for the bands of a curve.
const RESAMPLES: usize = 500;

/// The contents of `fragility.json`.
pub(super) fn fragility(plan: &Plan, gathered: &Gathered, volumes: &BTreeMap<String, f64>, missing: usize) -> Value {
    let asked = Asked {
        im: plan.im.clone(),
        resamples: RESAMPLES,
        seed: 0,
        hazard: plan.hazard.clone(),
    };
    let mut curves: Vec<Curve> = Vec::new();
    for tank in &plan.tanks {
        let of = |state: usize| gathered.curves.get(&(tank.id.clone(), state));
        let data: Vec<&Data> = (0..plan.damage.len()).filter_map(of).collect();
        if data.len() == plan.damage.len() {
            curves.extend(of_tank(plan, &asked, &tank.id, &data));
        }
    }
    json!({
        "format": FORMAT,
        "study": plan.name,
        "im": plan.im,
        "im_unit": plan.im_unit,
        "missing_tasks": missing,
        "curves": curves,
        "farm": of_farm(plan, gathered, volumes),
    })
}

fn of_tank(plan: &Plan, asked: &Asked, tank: &str, data: &[&Data]) -> Vec<Curve> {
    let stripes = |data: &&Data| -> Vec<Stripe> {
        let stripe = |(im, count): (&u64, &super::damage::Count)| Stripe {
            im: f64::from_bits(*im),
            n: count.n as f64,
            exceed: count.exceed as f64,
        };
        data.counts.iter().map(stripe).collect()
    };
    let states: Vec<(String, Vec<Stripe>)> = plan
        .damage
        .iter()
        .zip(data)
        .map(|(state, data)| (state.state.clone(), stripes(data)))
        .collect();
    let curves = asked.of_stripes(&states);
    let with = |(curve, data): (Curve, &&Data)| Curve {
        tank: Some(tank.into()),
        unjudged: (data.unjudged > 0).then_some(data.unjudged),
        unchecked: data.unchecked.iter().cloned().collect(),
        ..curve
    };
    curves.into_iter().zip(data).map(with).collect()
}

/// Losses of contents at each intensity, over the earthquakes in which every tank was judged.
fn of_farm(plan: &Plan, gathered: &Gathered, volumes: &BTreeMap<String, f64>) -> Vec<Value> {
    if plan.levels.is_empty() || plan.tanks.len() < 2 {
        return Vec::new();
    }
    let ids: Vec<&str> = plan.tanks.iter().map(|t| t.id.as_str()).collect();
    let volumes: Vec<f64> = ids.iter().map(|id| volumes.get(*id).copied().unwrap_or(0.0)).collect();
    let levels: BTreeSet<u64> = gathered.losses.keys().map(|(_, _, im)| *im).collect();
    let mut found = Vec::new();
    for level in levels {
        let quakes: Vec<_> = gathered
            .losses
            .iter()
            .filter(|((_, _, im), _)| *im == level)
            .map(|(_, lost)| lost)
            .collect();
        let whole: Vec<_> = quakes.iter().filter(|lost| lost.judged == ids.len()).collect();
        let rows: Vec<Vec<bool>> = ids
            .iter()
            .map(|id| whole.iter().map(|lost| lost.tanks.iter().any(|t| t == id)).collect())
            .collect();
        if let Some(losses) = farm::losses(&rows, &volumes) {
            found.push(json!({
                "im": f64::from_bits(level),
                "earthquakes": losses.n,
                "not_judged": quakes.len() - whole.len(),
                "at_least": losses.at_least,
                "at_least_independent": losses.at_least_independent,
                "mean_volume_m3": losses.mean_volume,
                "largest_volume_m3": losses.largest_volume,
            }));
        }
    }
    found
}
