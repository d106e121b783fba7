//! Damage states, and the data of their fragility curves.
//!
//! A row reaches a state if one of its demands reaches its limit, or if it reaches a worse state, or if the run found no equilibrium. A
//! demand that the tank does not have (uplift of an anchored tank) or that was not checked does not count; what was not checked is
//! listed with the curve.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::rows::{Ending, Row, RowStatus};
use crate::input::study::{COLLAPSE, DamageLimit};
use results::FE;

/// A demand with the limit at which a state begins.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Limit state of the engine, or `collapse`.
    pub demand: String,
    /// Utilisation.
    pub limit: f64,
    /// Source.
    pub source: String,
}

/// A damage state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DamageState {
    /// Name.
    pub state: String,
    /// Ways into it.
    pub limits: Vec<Limit>,
}

/// The states of a study file, in the order in which their names first stand there.
pub fn states(given: &[DamageLimit]) -> Vec<DamageState> {
    let mut all: Vec<DamageState> = Vec::new();
    for entry in given {
        let limit = Limit {
            demand: entry.demand.clone(),
            limit: entry.limit,
            source: entry.source.clone(),
        };
        match all.iter_mut().find(|state| state.state == entry.state) {
            Some(state) => state.limits.push(limit),
            None => all.push(DamageState {
                state: entry.state.clone(),
                limits: vec![limit],
            }),
        }
    }
    all
}

/// The default set: capacities of the codes, and two limits from the literature that a user has to confirm.
pub fn default_set() -> Vec<DamageState> {
    let code = "capacity of the code, see the sheet of the limit state";
    let recalled = "after Bakalis et al. 2017; confirm it against the paper";
    let limit = |state: &str, demand: &str, limit: f64, source: &str| DamageLimit {
        state: state.into(),
        demand: demand.into(),
        limit,
        source: source.into(),
    };
    states(&[
        limit("DS1", "freeboard", 1.0, "the wave reaches the top of the wall"),
        limit("DS1", "anchorage", 1.0, code),
        limit("DS2", "freeboard", 1.4, recalled),
        limit("DS2", "sliding", 1.0, code),
        limit(
            "DS2",
            "uplift_tension",
            1.0,
            "EN 1998-4:2006 A.9: plastic rotation 0.20 rad",
        ),
        limit("DS2", "wall_strength", 1.0, code),
        limit("DS3", "buckling_elastic", 1.0, code),
        limit("DS3", "buckling_elastic_plastic", 1.0, code),
        limit("DS3", "shell_compression", 1.0, code),
        limit("DS3", "hoop_yield", 1.0, code),
        limit(
            "DS3",
            "uplift_tension",
            2.0,
            "plastic rotation 0.40 rad; after Bakalis et al. 2017; confirm it against the paper",
        ),
        limit("DS3", COLLAPSE, 1.0, "no equilibrium"),
    ])
}

/// What a row says about a demand.
enum Demand {
    Utilisation(f64),
    Fails,
    NotChecked,
    None,
}

fn demand(row: &Row, id: &str) -> Demand {
    if id == COLLAPSE {
        return match row.status {
            RowStatus::Collapsed => Demand::Fails,
            _ => Demand::Utilisation(0.0),
        };
    }
    match row.checks.get(&format!("{FE}.{id}")) {
        None => Demand::None,
        Some(Ending::Utilisation(value)) => Demand::Utilisation(*value),
        Some(Ending::Word(word)) if word == "fails" => Demand::Fails,
        Some(Ending::Word(_)) => Demand::NotChecked,
    }
}

/// How a row stands to a state by its own limits: reached or not, none where no demand of the state was judged; and what was not checked.
fn own(row: &Row, state: &DamageState, unchecked: &mut BTreeSet<String>) -> Option<bool> {
    let mut judged = false;
    let mut reached = false;
    for limit in &state.limits {
        match demand(row, &limit.demand) {
            Demand::Utilisation(value) => {
                judged |= limit.demand != COLLAPSE;
                reached |= value >= limit.limit;
            }
            Demand::Fails => (judged, reached) = (true, true),
            Demand::NotChecked => {
                unchecked.insert(limit.demand.clone());
            }
            Demand::None => {}
        }
    }
    judged.then_some(reached)
}

/// How many of the runs at an intensity reached a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Count {
    /// Runs.
    pub n: usize,
    /// Those that reached it.
    pub exceed: usize,
}

/// Data of the curve of a tank and state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Data {
    /// Intensity (its bits, positive) → counts.
    pub counts: BTreeMap<u64, Count>,
    /// Rows that could not be judged: refused, failed, or without any judged demand.
    pub unjudged: usize,
    /// Demands that were not checked.
    pub unchecked: BTreeSet<String>,
}

/// The data of all curves, gathered row by row.
#[derive(Clone, Debug, Default)]
pub struct Gathered {
    /// (tank, number of the state) → data.
    pub curves: BTreeMap<(String, usize), Data>,
    /// (record, sample, intensity) → tanks in the worst state, by name.
    pub losses: BTreeMap<(String, u32, u64), Lost>,
}

/// What is lost in one earthquake.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lost {
    /// Tanks that were judged.
    pub judged: usize,
    /// Tanks in the worst state.
    pub tanks: Vec<String>,
}

impl Gathered {
    /// Adds a row; rows of the design spectra have no intensity and do not count.
    pub fn add(&mut self, row: &Row, states: &[DamageState]) {
        // Levels are common to all records; factors give every record its own intensity.
        let axis = row.level.or(row.im).filter(|im| *im > 0.0 && im.is_finite());
        let Some(axis) = axis else { return };
        let runs = !matches!(row.status, RowStatus::Refused | RowStatus::Error);
        let mut reached = vec![None; states.len()];
        for (number, state) in states.iter().enumerate() {
            let data = self.curves.entry((row.tank.clone(), number)).or_default();
            if runs {
                reached[number] = match row.status {
                    RowStatus::Collapsed => Some(true),
                    _ => own(row, state, &mut data.unchecked),
                };
            }
        }
        for number in 0..states.len() {
            let worse = reached[number..].contains(&Some(true));
            let judged = if worse { Some(true) } else { reached[number] };
            let data = self.curves.entry((row.tank.clone(), number)).or_default();
            match judged {
                Some(hit) => {
                    let count = data.counts.entry(axis.to_bits()).or_default();
                    count.n += 1;
                    count.exceed += usize::from(hit);
                }
                None => data.unjudged += 1,
            }
            if number + 1 == states.len()
                && let Some(hit) = judged
            {
                let place = (row.record.clone(), row.sample, axis.to_bits());
                let lost = self.losses.entry(place).or_default();
                lost.judged += 1;
                if hit {
                    lost.tanks.push(row.tank.clone());
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(level: f64, checks: &[(&str, Ending)]) -> Row {
        Row {
            level: Some(level),
            checks: checks.iter().map(|(id, e)| (format!("{FE}.{id}"), e.clone())).collect(),
            ..Row::blank("a", 0, "r", RowStatus::Ok)
        }
    }

    fn counts(gathered: &Gathered, state: usize) -> Count {
        gathered.curves[&("a".to_owned(), state)].counts[&1.0_f64.to_bits()]
    }

    #[test]
    fn a_worse_state_is_in_the_milder_ones_and_collapse_in_all() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let use_of = Ending::Utilisation;
        gathered.add(
            &row(1.0, &[("freeboard", use_of(0.2)), ("buckling_elastic", use_of(1.3))]),
            &states,
        );
        gathered.add(
            &row(1.0, &[("freeboard", use_of(1.2)), ("buckling_elastic", use_of(0.3))]),
            &states,
        );
        let collapsed = Row {
            status: RowStatus::Collapsed,
            ..row(1.0, &[])
        };
        gathered.add(&collapsed, &states);
        assert_eq!(counts(&gathered, 0), Count { n: 3, exceed: 3 });
        assert_eq!(counts(&gathered, 1), Count { n: 3, exceed: 2 });
        assert_eq!(counts(&gathered, 2), Count { n: 3, exceed: 2 });
    }

    #[test]
    fn what_was_not_checked_is_said_and_never_counted_as_safe() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let open = Ending::Word("not_checked".into());
        gathered.add(
            &row(1.0, &[("buckling_elastic", open.clone()), ("freeboard", open)]),
            &states,
        );
        let data = &gathered.curves[&("a".to_owned(), 2)];
        assert!(data.counts.is_empty());
        assert_eq!(data.unjudged, 1);
        assert!(data.unchecked.contains("buckling_elastic"));
    }
}
