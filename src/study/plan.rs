//! The tasks of a study and their keys.
//!
//! A task is a block of records of one tank and sample: mesh, modes and code periods are made once. Codes alone have tasks of several
//! tanks, so that no file holds few rows.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

use oscillator::record::Record;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::damage::{DamageState, default_set, states};
use super::key;
use super::rows::{kept, plain};
use super::rule::{self, RuleFound};
use crate::curves::runs::Method;
use crate::error::Error;
use crate::input::TankFile;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::study::{self, Shaking, StudyInput};
use files::code::Code;
use results::EngineId;
use tank::Shape;

/// Format of the files of a plan.
pub const FORMAT: &str = "tankcheck-study/2";
/// Most rows of a study.
const MOST_ROWS: usize = 10_000_000;
/// Fewest rows of a task of codes alone.
const FULL: usize = 200;

/// A tank of the plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlannedTank {
    /// Name.
    pub id: String,
    /// Its key, of every sample.
    pub keys: Vec<String>,
    /// Radius of a cylinder or length of a box, and fill height, without sampling [m]; none in plans of earlier versions.
    #[serde(default)]
    pub size: Option<[f64; 2]>,
    /// Whether the first of the size is a radius.
    #[serde(default)]
    pub round: bool,
    /// Volume of its liquid, without sampling [m³]; none in plans of earlier versions.
    #[serde(default)]
    pub volume: Option<f64>,
    /// Column → cell, of a tank of a table.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub given: Vec<(String, String)>,
}

/// A record of the plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlannedRecord {
    /// Name.
    pub id: String,
    /// Its key: hash of the samples.
    pub key: String,
    /// Samples along x.
    pub samples: usize,
    /// Time step [s].
    pub dt: f64,
    /// Peak acceleration along x [m/s²].
    pub pga: f64,
}

/// A plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// Format.
    pub format: String,
    /// The study file, relative to the folder of the plan.
    pub study: String,
    /// Title.
    pub name: String,
    /// Engine; none for the codes alone.
    pub engine: Option<EngineId>,
    /// Intensity measure.
    pub im: String,
    /// Unit of its levels.
    pub im_unit: String,
    /// Unit in which all levels are given; none of different units and of factors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub im_shown: Option<String>,
    /// Levels, SI; empty for factors.
    pub levels: Vec<f64>,
    /// Factors; empty for levels.
    pub factors: Vec<f64>,
    /// Samples of each tank.
    pub samples: u32,
    /// Number of rows.
    pub rows: usize,
    /// Number of tasks.
    pub tasks: usize,
    /// SHA-256 of their list.
    #[serde(default)]
    pub tasks_sha256: String,
    /// Damage states, in the order of severity.
    pub damage: Vec<DamageState>,
    /// Hazard curve: points (im, rate a year).
    pub hazard: Option<Vec<[f64; 2]>>,
    /// How curves are found.
    #[serde(default)]
    pub method: Method,
    /// Cover of the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub project: Option<tank::Project>,
    /// Whether the records keep the rule of the study.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<RuleFound>,
    /// Records.
    pub records: Vec<PlannedRecord>,
    /// Tanks.
    pub tanks: Vec<PlannedTank>,
}

/// A task of the plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Task {
    /// Number, from 1.
    pub task: usize,
    /// Tanks and samples.
    pub tanks: Vec<(usize, u32)>,
    /// Records, by number from 0: the first, and the one after the last.
    pub records: [usize; 2],
    /// Number of rows.
    pub rows: usize,
    /// Key of its result.
    pub key: String,
}

impl Task {
    /// Numbers of its records.
    pub fn records(&self) -> Range<usize> {
        self.records[0]..self.records[1]
    }
}

/// Makes the plan of a study: every tank, sample and record is read.
///
/// Errors: the faults of all tanks and records together; a study without rows or with too many.
pub fn make(study: &StudyInput, file: &Path, folder: &Path) -> Result<(Plan, Vec<Task>), Error> {
    let samples = study.sampling.as_ref().map_or(1, |s| s.n);
    let scales = study.scales.levels.len().max(study.scales.factors.len()).max(1);
    let per_tank = match study.records.len() {
        0 => 1,
        n => n * scales,
    };
    let rows = study.tanks.len() * samples as usize * per_tank;
    if rows == 0 || rows > MOST_ROWS {
        return Err(Error::input(
            Code::ItemCount,
            format!(
                "the study has {rows} rows, expected 1 to {MOST_ROWS}\n  help: rows are tanks × samples × records × scales"
            ),
        ));
    }
    let mut faults = Vec::new();
    let (tanks, nominal) = planned_tanks(study, samples, &mut faults);
    let (records, along) = planned_records(study, &mut faults);
    let hazard = study.hazard.as_ref().map(|path| crate::input::fragility::hazard(path));
    let hazard = match hazard {
        Some(Err(error)) => {
            faults.push(error);
            None
        }
        other => other.transpose().ok().flatten(),
    };
    if !faults.is_empty() {
        return Err(Error::Files(study::together(faults)));
    }
    let rule = match &study.rule {
        Some(rule) if !along.is_empty() => Some(rule::ask(rule, &nominal, &along)?),
        _ => None,
    };
    let damage = study.damage.as_ref().map_or_else(default_set, |given| states(given));
    let mut plan = Plan {
        format: FORMAT.into(),
        study: relative(file, folder),
        name: study.name.clone(),
        engine: study.engine,
        im: study.scales.name.clone(),
        im_unit: study.scales.axis.dimension().si_symbol().into(),
        im_shown: study.scales.unit.map(str::to_owned),
        levels: study.scales.levels.clone(),
        factors: study.scales.factors.clone(),
        samples,
        rows,
        tasks: 0,
        tasks_sha256: String::new(),
        damage,
        hazard,
        method: study.method,
        project: study.project.clone(),
        rule,
        records,
        tanks,
    };
    let tasks = tasks(study, &plan, scales);
    plan.tasks = tasks.len();
    plan.tasks_sha256 = key::hex(list(&tasks)?.as_bytes());
    Ok((plan, tasks))
}

/// The tanks of a plan and, where a rule asks for them, the tanks without sampling by name.
fn planned_tanks(
    study: &StudyInput,
    samples: u32,
    faults: &mut Vec<files::error::Error>,
) -> (Vec<PlannedTank>, Vec<(String, TankFile)>) {
    let mut tanks = Vec::new();
    let mut nominal = Vec::new();
    let mut tables = Vec::new();
    let mut sampled = Sampled::default();
    for entry in &study.tanks {
        // The tank of the file itself has to be right; a sample that is not possible is a row.
        let Some(tank) = entry.nominal(&mut tables) else { continue };
        let (half, round) = match tank.case.tank.shape {
            Shape::Cylinder { radius } => (radius, true),
            Shape::Rectangle { length, .. } => (length, false),
        };
        let size = [half, tank.case.liquid.fill_height];
        let volume = tank.case.liquid_mass() / tank.case.liquid.density;
        if study.rule.is_some() {
            nominal.push((entry.id.clone(), tank));
        }
        let mut keys = Vec::new();
        let mut refused = Vec::new();
        for sample in 0..samples {
            let tank = entry.tank(study.sampling.as_ref(), sample);
            keys.push(of_sample(&tank));
            refused.extend(tank.err());
        }
        sampled.take(&entry.id, &refused, refused.len() == keys.len());
        tanks.push(PlannedTank {
            id: entry.id.clone(),
            keys,
            size: Some(size),
            round,
            volume: Some(kept(volume)),
            given: entry.given(),
        });
    }
    faults.extend(tables.into_iter().map(|(source, found)| found.into_error(&source)));
    if !sampled.faults.is_empty() {
        faults.push(sampled.faults.into_error(&study.source));
    }
    (tanks, nominal)
}

/// Faults of the sampling itself.
#[derive(Default)]
struct Sampled {
    faults: Faults,
    /// Kind and place of those that were found.
    known: BTreeSet<(&'static str, Option<usize>)>,
}

impl Sampled {
    /// Takes the faults of a tank's samples that no other draw mends: those of a path, a unit or a form, and all where no sample is possible.
    ///
    /// * `none`: whether no sample is possible
    fn take(&mut self, tank: &str, refused: &[Faults], none: bool) {
        for fault in refused.iter().flat_map(Faults::list) {
            let place = fault.span.as_ref().map(|span| span.start);
            if (none || !of_the_value(fault.code)) && self.known.insert((fault.code.id(), place)) {
                self.faults.push(Fault {
                    message: match none {
                        true => format!("no sample of the tank `{tank}` is possible: {}", fault.message),
                        false => format!("the tank `{tank}`: {}", fault.message),
                    },
                    ..fault.clone()
                });
            }
        }
    }
}

/// Whether another value in the same place may be right.
fn of_the_value(code: Code) -> bool {
    use Code::{Contradiction, LiquidAboveWall, NotFinite, OutOfRange, Unsupported};
    matches!(code, OutOfRange | NotFinite | Contradiction | LiquidAboveWall | Unsupported)
}

/// The records of a plan and, where a rule asks for them, the records along x.
fn planned_records(study: &StudyInput, faults: &mut Vec<files::error::Error>) -> (Vec<PlannedRecord>, Vec<Record>) {
    let mut records = Vec::new();
    let mut along = Vec::new();
    for entry in &study.records {
        match entry.read() {
            Ok(shaking) => {
                records.push(planned(&entry.id, &shaking));
                if study.rule.is_some() {
                    along.push(shaking.along);
                }
            }
            Err(error) => faults.push(error),
        }
    }
    (records, along)
}

/// The key of a tank with the values of a sample: that of the tank, or of the faults of an impossible one.
pub(super) fn of_sample(tank: &Result<TankFile, Faults>) -> String {
    match tank {
        Ok(tank) => key::of_tank(tank),
        Err(faults) => key::hash(json!({ "refused": refusal(faults) })),
    }
}

/// Why a sample is not possible: its faults without their places, which are no part of the tank.
pub(super) fn refusal(faults: &Faults) -> String {
    let one = |fault: &Fault| match &*fault.found {
        "" => fault.message.clone(),
        found => format!("{}; found {found}, expected {}", fault.message, fault.allowed),
    };
    plain(&faults.list().iter().map(one).collect::<Vec<_>>().join("; "))
}

fn planned(id: &str, shaking: &Shaking) -> PlannedRecord {
    PlannedRecord {
        id: id.into(),
        key: key::of_shaking(shaking),
        samples: shaking.along.acceleration.len(),
        dt: shaking.along.dt,
        pga: shaking.along.pga(),
    }
}

/// The tasks of a plan: tank by tank, sample by sample, block by block.
fn tasks(study: &StudyInput, plan: &Plan, scales: usize) -> Vec<Task> {
    let units: Vec<(usize, u32)> =
        (0..plan.tanks.len()).flat_map(|tank| (0..plan.samples).map(move |sample| (tank, sample))).collect();
    let records = plan.records.len();
    let mut tasks = Vec::new();
    let mut add = |tanks: &[(usize, u32)], range: Range<usize>| {
        let rows = tanks.len() * (range.len() * scales).max(1);
        let key = key_of(study, plan, tanks, range.clone());
        tasks.push(Task { task: tasks.len() + 1, tanks: tanks.to_vec(), records: [range.start, range.end], rows, key });
    };
    if study.engine.is_none() || records == 0 {
        let each = (records * scales).max(1);
        for together in units.chunks(FULL.div_ceil(each)) {
            add(together, 0..records);
        }
    } else {
        for unit in &units {
            for start in (0..records).step_by(study.block) {
                add(&[*unit], start..(start + study.block).min(records));
            }
        }
    }
    tasks
}

/// The key of a task.
fn key_of(study: &StudyInput, plan: &Plan, tanks: &[(usize, u32)], records: Range<usize>) -> String {
    let tanks: Vec<_> = tanks
        .iter()
        .map(|&(tank, sample)| {
            let planned = &plan.tanks[tank];
            json!([planned.id, sample, planned.keys[sample as usize]])
        })
        .collect();
    let records: Vec<_> = plan.records[records].iter().map(|r| json!([r.id, r.key])).collect();
    key::hash(json!({ "study": key::of_study(study), "tanks": tanks, "records": records }))
}

/// The list of the tasks as text.
pub(super) fn list(tasks: &[Task]) -> Result<String, Error> {
    let mut text = String::new();
    for task in tasks {
        text.push_str(&serde_json::to_string(task).map_err(|e| Error::report(e.to_string()))?);
        text.push('\n');
    }
    Ok(text)
}

/// Path of the study file from the folder of the plan.
fn relative(file: &Path, folder: &Path) -> String {
    let absolute = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let (file, folder) = (absolute(file), absolute(folder));
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let mut path = PathBuf::new();
    for _ in common..from.len() {
        path.push("..");
    }
    for part in &to[common..] {
        path.push(part);
    }
    path.to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::study::rows::{Line, Row, RowStatus, TankRow};

    /// Two tanks under two records at one factor, a task each.
    pub(crate) fn plan() -> Plan {
        let records = ["r", "s"].map(|id| json!({ "id": id, "key": id, "samples": 2, "dt": 0.01, "pga": 1.0 }));
        let tanks = ["a", "b"].map(|id| json!({ "id": id, "keys": [id] }));
        let plan = json!({
            "format": FORMAT, "study": "study.json", "name": "two", "engine": null, "im": "PGA", "im_unit": "m/s2", "levels": [],
            "factors": [0.3], "samples": 1, "rows": 4, "tasks": 2, "damage": [], "hazard": null,
            "records": records, "tanks": tanks,
        });
        serde_json::from_value(plan).unwrap()
    }

    /// The task of a tank by its number from 1.
    pub(crate) fn task(number: usize) -> Task {
        Task { task: number, tanks: vec![(number - 1, 0)], records: [0, 2], rows: 2, key: format!("{number}bcd") }
    }

    /// Its result.
    pub(crate) fn lines(plan: &Plan, task: &Task) -> Vec<Line> {
        let tank = &plan.tanks[task.tanks[0].0].id;
        let head = TankRow {
            tank: tank.clone(),
            sample: 0,
            periods: [None, None],
            volume: None,
            verdict: "holds".into(),
            governing: None,
            open: Vec::new(),
            gaps: Default::default(),
            message: None,
            values: Default::default(),
        };
        let row = |record: &PlannedRecord| {
            Line::Row(Box::new(Row { factor: 0.3, ..Row::blank(tank, 0, &record.id, RowStatus::Ok) }))
        };
        let rows = plan.records.iter().map(row);
        std::iter::once(Line::Tank(Box::new(head))).chain(rows).collect()
    }
}
