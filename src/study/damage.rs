//! Damage states, and the data of their fragility curves.
//!
//! A row reaches a state if one of its demands reaches its limit, or if it reaches a worse state, or if the run found no equilibrium. A
//! demand that the tank does not have (uplift of an anchored tank) does not count. One that is checked in some rows of a tank and not in this one leaves the
//! row unjudged, unless the state is reached all the same; one that no row of the tank has checked is listed with the curve.

use std::collections::{BTreeMap, BTreeSet};

use crate::curves::runs::Seen;
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
        let limit = Limit { demand: entry.demand.clone(), limit: entry.limit, source: entry.source.clone() };
        match all.iter_mut().find(|state| state.state == entry.state) {
            Some(state) => state.limits.push(limit),
            None => all.push(DamageState { state: entry.state.clone(), limits: vec![limit] }),
        }
    }
    all
}

/// The default set: capacities of the codes, and two limits from the literature that a user has to confirm.
pub fn default_set() -> Vec<DamageState> {
    let code = "capacity of the code, see the sheet of the limit state";
    let recalled = "after Bakalis et al. 2017; not a value of a code";
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
        limit("DS2", "uplift_tension", 1.0, "EN 1998-4:2006 A.9: plastic rotation 0.20 rad"),
        limit("DS2", "wall_strength", 1.0, code),
        limit("DS3", "buckling_elastic", 1.0, code),
        limit("DS3", "buckling_elastic_plastic", 1.0, code),
        limit("DS3", "shell_compression", 1.0, code),
        limit("DS3", "hoop_yield", 1.0, code),
        limit(
            "DS3",
            "uplift_tension",
            2.0,
            "plastic rotation 0.40 rad; after Bakalis et al. 2017; not a value of a code",
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

/// How a row stands to a state by its own limits.
#[derive(Clone, Debug, Default, PartialEq)]
struct Standing {
    /// Largest demand over its limit.
    ratio: f64,
    /// Whether it has a demand without a number that reaches the state.
    fell: bool,
    /// The demands that reach their limits.
    ways: Vec<String>,
}

impl Standing {
    fn reached(&self) -> bool {
        self.fell || !self.ways.is_empty()
    }
}

/// How a row stands to a state by its own limits, none where no demand of the state was judged; and what was not checked.
///
/// * `open`: set where a demand was not checked that other rows of the tank have checked
fn own(
    row: &Row,
    state: &DamageState,
    unchecked: &mut BTreeMap<String, usize>,
    (known, open): (&Judged, &mut bool),
) -> Option<Standing> {
    let mut judged = false;
    let mut found = Standing::default();
    for limit in &state.limits {
        match demand(row, &limit.demand) {
            Demand::Utilisation(value) => {
                judged |= limit.demand != COLLAPSE;
                found.ratio = found.ratio.max(value / limit.limit);
                if value >= limit.limit {
                    found.ways.push(limit.demand.clone());
                }
            }
            Demand::Fails => {
                judged = true;
                found.fell = true;
                found.ways.push(limit.demand.clone());
            }
            Demand::NotChecked => {
                *unchecked.entry(limit.demand.clone()).or_default() += 1;
                *open |= known.get(&row.tank).is_some_and(|demands| demands.contains(&limit.demand));
            }
            Demand::None => {}
        }
    }
    judged.then_some(found)
}

/// The ways of a run without equilibrium into a state: collapse, where the state has it.
fn collapse(state: &DamageState) -> Vec<String> {
    let named = |limit: &&Limit| limit.demand == COLLAPSE;
    state.limits.iter().filter(named).map(|limit| limit.demand.clone()).collect()
}

/// Tank → demands that at least one of its rows has checked.
pub type Judged = BTreeMap<String, BTreeSet<String>>;

/// Notes the demands that a row has checked.
pub fn judged(row: &Row, all: &mut Judged) {
    let checked = row.checks.iter().filter(|(_, ending)| match ending {
        Ending::Utilisation(_) => true,
        Ending::Word(word) => word == "fails",
    });
    let demands = checked.filter_map(|(id, _)| id.strip_prefix(FE)?.strip_prefix('.'));
    let own = all.entry(row.tank.clone()).or_default();
    for demand in demands {
        if !own.contains(demand) {
            own.insert(demand.to_owned());
        }
    }
}

/// Data of the curve of a tank and state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Data {
    /// The runs that were judged.
    pub runs: Vec<Seen>,
    /// Rows that could not be judged: refused, failed, or without any judged demand.
    pub unjudged: usize,
    /// Demands that were not checked → in how many rows.
    pub unchecked: BTreeMap<String, usize>,
    /// Demand of the state → runs in which it reached its limit; a run may have several.
    pub ways: BTreeMap<String, usize>,
    /// Runs that reached none of its limits and are in the state because they reached a worse one or found no equilibrium.
    pub by_worse: usize,
}

/// An earthquake of a study: record, sample, intensity (its bits, positive).
pub type Quake = (String, u32, u64);

/// The data of all curves, gathered row by row.
#[derive(Clone, Debug, Default)]
pub struct Gathered {
    /// (tank, number of the state) → data.
    pub curves: BTreeMap<(String, usize), Data>,
    /// Earthquake → tanks in the worst state, by name.
    pub losses: BTreeMap<Quake, Lost>,
    /// Earthquake → of each state, tanks that were judged, and those in it.
    pub counts: BTreeMap<Quake, Vec<[usize; 2]>>,
    /// Numbers of the records, in the order of their first row.
    pub records: BTreeMap<String, u32>,
    /// Record → of its first run: factor, and peaks of the scaled acceleration, velocity and displacement, SI.
    pub measures: BTreeMap<String, (f64, [f64; 3])>,
    /// (status, message) → rows, and the tank and record of the first.
    pub faults: BTreeMap<(&'static str, String), (usize, String, String)>,
    /// Tank → its worst row.
    pub worst: BTreeMap<String, Worst>,
    /// What the rows of each tank have checked, of all rows.
    pub judged: Judged,
}

/// A row of a tank with the largest demand over its limit; a run without a finite demand is worse than any number.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// Record.
    pub record: String,
    /// Sample.
    pub sample: u32,
    /// Factor on the record.
    pub factor: f64,
    /// Demand over the limit of the worst state; infinite without a finite demand.
    pub ratio: f64,
}

/// What is lost in one earthquake.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lost {
    /// Tanks in the worst state.
    pub tanks: Vec<String>,
    /// Tanks that were judged and are not in it.
    pub safe: Vec<String>,
}

impl Gathered {
    /// Adds a row; rows of the design spectra have no intensity and do not count.
    pub fn add(&mut self, row: &Row, states: &[DamageState]) {
        self.note(row);
        // Levels are common to all records; factors give every record its own intensity.
        let axis = row.level.or(row.im).filter(|im| *im > 0.0 && im.is_finite());
        let Some(axis) = axis else { return };
        let next = self.records.len() as u32;
        let record = *self.records.entry(row.record.clone()).or_insert(next);
        let quake: Quake = (row.record.clone(), row.sample, axis.to_bits());
        let runs = !matches!(row.status, RowStatus::Refused | RowStatus::Error);
        let collapsed = row.status == RowStatus::Collapsed;
        let mut found: Vec<Option<Standing>> = vec![None; states.len()];
        let mut open = vec![false; states.len()];
        for (number, state) in states.iter().enumerate() {
            let data = self.curves.entry((row.tank.clone(), number)).or_default();
            if runs {
                found[number] = match collapsed {
                    true => Some(Standing { fell: true, ways: collapse(state), ..Standing::default() }),
                    false => own(row, state, &mut data.unchecked, (&self.judged, &mut open[number])),
                };
            }
        }
        for number in 0..states.len() {
            let worse = found[number..].iter().flatten().filter(|s| s.reached());
            let reached = worse.clone().next().is_some();
            // A demand that was not checked may have reached its limit, of this state or of a worse one.
            let judged = reached || (found[number].is_some() && !open[number..].contains(&true));
            let Some(data) = self.curves.get_mut(&(row.tank.clone(), number)) else { continue };
            if !judged {
                data.unjudged += 1;
                continue;
            }
            let fell = worse.clone().any(|s| s.fell);
            // Those of worse states below their limits count too: between two levels the tank may come into a worse state first.
            let largest = found[number..].iter().flatten().map(|s| s.ratio).fold(0.0, f64::max);
            data.runs.push(Seen { record, sample: row.sample, im: axis, ratio: (!fell).then_some(largest), reached });
            let own = found[number].as_ref().map_or(&[] as &[String], |s| &s.ways);
            data.by_worse += usize::from(reached && own.is_empty());
            for way in own {
                *data.ways.entry(way.clone()).or_default() += 1;
            }
            let counts = self.counts.entry(quake.clone()).or_insert_with(|| vec![[0; 2]; states.len()]);
            counts[number][0] += 1;
            counts[number][1] += usize::from(reached);
            if number + 1 == states.len() {
                let ratio = if fell { f64::INFINITY } else { largest };
                if self.worst.get(&row.tank).is_none_or(|known| ratio > known.ratio) {
                    let worst = Worst { record: row.record.clone(), sample: row.sample, factor: row.factor, ratio };
                    self.worst.insert(row.tank.clone(), worst);
                }
                let lost = self.losses.entry(quake.clone()).or_default();
                let names = if reached { &mut lost.tanks } else { &mut lost.safe };
                names.push(row.tank.clone());
            }
        }
    }

    /// Measures of the record, and why a row is not a finished run.
    fn note(&mut self, row: &Row) {
        if let Some(peaks) = row.peaks
            && row.factor > 0.0
            && !self.measures.contains_key(&row.record)
        {
            self.measures.insert(row.record.clone(), (row.factor, peaks));
        }
        if row.status != RowStatus::Ok {
            let message = row.message.clone().unwrap_or_default();
            let entry = self.faults.entry((row.status.word(), message));
            let count = entry.or_insert_with(|| (0, row.tank.clone(), row.record.clone()));
            count.0 += 1;
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

    /// Runs, and those that reached the state.
    fn counts(gathered: &Gathered, state: usize) -> (usize, usize) {
        let runs = &gathered.curves[&("a".to_owned(), state)].runs;
        (runs.len(), runs.iter().filter(|run| run.reached).count())
    }

    #[test]
    fn a_worse_state_is_in_the_milder_ones_and_collapse_in_all() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let use_of = Ending::Utilisation;
        gathered.add(&row(1.0, &[("freeboard", use_of(0.2)), ("buckling_elastic", use_of(1.3))]), &states);
        gathered.add(&row(1.0, &[("freeboard", use_of(1.2)), ("buckling_elastic", use_of(0.3))]), &states);
        let collapsed = Row { status: RowStatus::Collapsed, ..row(1.0, &[]) };
        gathered.add(&collapsed, &states);
        assert_eq!(counts(&gathered, 0), (3, 3));
        assert_eq!(counts(&gathered, 1), (3, 2));
        assert_eq!(counts(&gathered, 2), (3, 2));
        // Y of the mildest state has the worse demands; a collapse has none.
        let ratios: Vec<Option<f64>> = gathered.curves[&("a".to_owned(), 0)].runs.iter().map(|r| r.ratio).collect();
        assert_eq!(ratios, [Some(1.3), Some(1.2), None]);
        let of = |state: usize| &gathered.curves[&("a".to_owned(), state)];
        assert_eq!(of(2).ways, [("buckling_elastic".into(), 1), (COLLAPSE.into(), 1)].into());
        assert_eq!((of(0).ways["freeboard"], of(0).by_worse), (1, 2));
        assert_eq!((of(1).ways.len(), of(1).by_worse, of(2).by_worse), (0, 2, 0));
        assert_eq!(gathered.counts.values().next().unwrap(), &[[3, 3], [3, 2], [3, 2]]);
    }

    /// Plastic rotation beyond 0.40 rad beside a wall that buckles by more: the run counts for both.
    #[test]
    fn a_run_counts_for_each_of_its_ways() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let use_of = Ending::Utilisation;
        let checks = [("uplift_tension", use_of(2.09)), ("buckling_elastic", use_of(3.0))];
        gathered.add(&row(1.0, &checks), &states);
        let of = |state: usize| &gathered.curves[&("a".to_owned(), state)];
        assert_eq!((of(1).ways["uplift_tension"], of(1).by_worse), (1, 0));
        assert_eq!((of(2).ways["uplift_tension"], of(2).ways["buckling_elastic"]), (1, 1));
    }

    /// Buckling at 0.95 of its limit and a wave at 0.2: the mildest state is as near as the worst one, whose capacity is then not below its own.
    #[test]
    fn a_worse_state_that_is_near_is_near_for_the_milder_ones() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let use_of = Ending::Utilisation;
        let near = row(1.0, &[("freeboard", use_of(0.2)), ("buckling_elastic", use_of(0.95))]);
        gathered.add(&near, &states);
        for state in 0..states.len() {
            let run = gathered.curves[&("a".to_owned(), state)].runs[0];
            assert_eq!((run.ratio, run.reached), (Some(0.95), false), "{state}");
        }
    }

    /// Freeboard holds, buckling is open: the row is judged where no row of the tank has buckling checked, and not where another has.
    #[test]
    fn a_demand_that_other_rows_have_checked_leaves_a_row_open() {
        let states = default_set();
        let use_of = Ending::Utilisation;
        let open = row(1.0, &[("freeboard", use_of(0.2)), ("buckling_elastic", Ending::Word("not_checked".into()))]);
        let reached = row(2.0, &[("freeboard", use_of(1.1)), ("buckling_elastic", Ending::Word("not_checked".into()))]);
        let whole = row(3.0, &[("freeboard", use_of(0.2)), ("buckling_elastic", use_of(0.4))]);
        let of = |rows: &[&Row]| {
            let mut gathered = Gathered::default();
            rows.iter().for_each(|row| judged(row, &mut gathered.judged));
            rows.iter().for_each(|row| gathered.add(row, &states));
            (counts(&gathered, 0), gathered.curves[&("a".to_owned(), 0)].unjudged)
        };
        assert_eq!(of(&[&open, &reached]), ((2, 1), 0));
        assert_eq!(of(&[&open, &reached, &whole]), ((2, 1), 1));
    }

    #[test]
    fn what_was_not_checked_is_said_and_never_counted_as_safe() {
        let states = default_set();
        let mut gathered = Gathered::default();
        let open = Ending::Word("not_checked".into());
        gathered.add(&row(1.0, &[("buckling_elastic", open.clone()), ("freeboard", open)]), &states);
        let data = &gathered.curves[&("a".to_owned(), 2)];
        assert!(data.runs.is_empty());
        assert_eq!(data.unjudged, 1);
        assert_eq!(data.unchecked.get("buckling_elastic"), Some(&1));
    }
}
