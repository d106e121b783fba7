//! The tasks of a study and their keys.
//!
//! A task is a block of records of one tank and sample: mesh, modes and code periods are made once. Codes alone have tasks of several
//! tanks, so that no file holds few rows.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use oscillator::record::Record;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::damage::{DamageState, default_set, states};
use super::key;
use super::rows::kept;
use super::rule::{self, RuleFound};
use crate::curves::runs::Method;
use crate::error::Error;
use crate::input::TankFile;
use crate::input::study::{self, Shaking, StudyInput};
use files::code::Code;
use files::error::describe;
use files::write_whole;
use results::EngineId;
use tank::Shape;

/// Format of the files of a plan.
pub const FORMAT: &str = "tankcheck-study/1";
/// Name of the plan.
pub const PLAN: &str = "plan.json";
/// Name of the list of tasks.
pub const TASKS: &str = "tasks.jsonl";
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
    let scales = study.scales.levels.len().max(study.scales.factors.len()).max(1);
    let per_tank = match records.len() {
        0 => 1,
        n => n * scales,
    };
    let rows = tanks.len() * samples as usize * per_tank;
    if rows == 0 || rows > MOST_ROWS {
        return Err(Error::input(
            Code::ItemCount,
            format!(
                "the study has {rows} rows, expected 1 to {MOST_ROWS}\n  help: rows are tanks × samples × records × scales"
            ),
        ));
    }
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
    for entry in &study.tanks {
        // The tank of the file itself has to be right; a sample that is not possible is a row.
        let Some(tank) = entry.nominal(&mut tables) else {
            continue;
        };
        let (half, round) = match tank.case.tank.shape {
            Shape::Cylinder { radius } => (radius, true),
            Shape::Rectangle { length, .. } => (length, false),
        };
        let size = [half, tank.case.liquid.fill_height];
        let volume = tank.case.liquid_mass() / tank.case.liquid.density;
        if study.rule.is_some() {
            nominal.push((entry.id.clone(), tank));
        }
        let key = |sample| of_sample(&entry.tank(study.sampling.as_ref(), sample));
        tanks.push(PlannedTank {
            id: entry.id.clone(),
            keys: (0..samples).map(key).collect(),
            size: Some(size),
            round,
            volume: Some(kept(volume)),
            given: entry.given(),
        });
    }
    faults.extend(tables.into_iter().map(|(source, found)| found.into_error(&source)));
    (tanks, nominal)
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
pub(super) fn of_sample(tank: &Result<TankFile, files::error::Error>) -> String {
    match tank {
        Ok(tank) => key::of_tank(tank),
        Err(error) => key::hash(json!({ "refused": super::task::plain(&error.to_string()) })),
    }
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
    let units: Vec<(usize, u32)> = (0..plan.tanks.len())
        .flat_map(|tank| (0..plan.samples).map(move |sample| (tank, sample)))
        .collect();
    let records = plan.records.len();
    let mut tasks = Vec::new();
    let mut add = |tanks: &[(usize, u32)], range: Range<usize>| {
        let rows = tanks.len() * (range.len() * scales).max(1);
        let key = key_of(study, plan, tanks, range.clone());
        tasks.push(Task {
            task: tasks.len() + 1,
            tanks: tanks.to_vec(),
            records: [range.start, range.end],
            rows,
            key,
        });
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

/// Writes a plan into its folder. Results there are kept: those whose keys are unchanged count.
///
/// Errors: a folder with files of something else; those of the file system.
pub fn write(folder: &Path, plan: &Plan, tasks: &[Task]) -> Result<(), Error> {
    let file = folder.join(PLAN);
    let taken = |what: &str| {
        Error::Files(files::error::Error::Taken {
            path: folder.into(),
            what: what.into(),
            help: "name another folder with --out".into(),
        })
    };
    if file.is_file() {
        let earlier = read(folder).map(|(plan, _)| plan);
        match earlier {
            Ok(earlier) if earlier.name != plan.name => {
                return Err(taken(&format!("has the study `{}`", earlier.name)));
            }
            _ => {}
        }
    } else if folder.is_dir() && std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some()) {
        return Err(taken("is not empty and has no study"));
    }
    std::fs::create_dir_all(folder).map_err(|e| {
        Error::Files(files::error::Error::Unwritten {
            path: folder.into(),
            what: describe(&e),
        })
    })?;
    let mut text = String::new();
    for task in tasks {
        text.push_str(&serde_json::to_string(task).map_err(|e| Error::report(e.to_string()))?);
        text.push('\n');
    }
    write_whole(&folder.join(TASKS), text.as_bytes())?;
    let text = serde_json::to_string_pretty(plan).map_err(|e| Error::report(e.to_string()))?;
    write_whole(&file, format!("{text}\n").as_bytes())?;
    Ok(())
}

/// Reads a plan and its tasks.
///
/// Errors: a folder without a plan; files that are not a plan, or do not belong together.
pub fn read(folder: &Path) -> Result<(Plan, Vec<Task>), Error> {
    let fault = |path: PathBuf, what: String| {
        let code = Code::NotResults;
        Error::Files(files::error::Error::File { code, path, what })
    };
    let load = |name: &str| {
        let path = folder.join(name);
        files::read_text(&path).map_err(|e| {
            let what = match e.kind() {
                std::io::ErrorKind::NotFound => {
                    "no plan here; `tankcheck study plan STUDY --out FOLDER` makes one".into()
                }
                _ => describe(&e),
            };
            fault(path, what)
        })
    };
    let broken =
        |name: &str, e: serde_json::Error| fault(folder.join(name), format!("not a plan of this program: {e}"));
    let plan: Plan = serde_json::from_str(&load(PLAN)?).map_err(|e| broken(PLAN, e))?;
    if plan.format != FORMAT {
        return Err(fault(
            folder.join(PLAN),
            format!("found the format `{}`, expected `{FORMAT}`", plan.format),
        ));
    }
    let lines = load(TASKS)?;
    let tasks: Vec<Task> = lines
        .lines()
        .map(|line| serde_json::from_str(line).map_err(|e| broken(TASKS, e)))
        .collect::<Result<_, _>>()?;
    if tasks.len() != plan.tasks {
        let what = format!("{} tasks, {} in {PLAN}; plan again", tasks.len(), plan.tasks);
        return Err(fault(folder.join(TASKS), what));
    }
    Ok((plan, tasks))
}

/// What changed since the plan, of a task: the tanks and records whose keys are others now.
pub(super) fn changed(
    plan: &Plan,
    tanks: &BTreeMap<(usize, u32), String>,
    records: &BTreeMap<usize, String>,
) -> Option<String> {
    for (&(tank, sample), key) in tanks {
        if plan.tanks[tank].keys.get(sample as usize) != Some(key) {
            return named("tank", &[&plan.tanks[tank].id]);
        }
    }
    for (&record, key) in records {
        if &plan.records[record].key != key {
            return named("record", &[&plan.records[record].id]);
        }
    }
    None
}

/// What the input of a study has that its plan has not: another tank, record or study file. None where nothing changed.
///
/// Errors: as [`make`].
pub fn departure(study: &StudyInput, (plan, tasks): (&Plan, &[Task]), folder: &Path) -> Result<Option<String>, Error> {
    let (now, tasks_now) = make(study, &folder.join(&plan.study), folder)?;
    if tasks
        .iter()
        .map(|task| &task.key)
        .eq(tasks_now.iter().map(|task| &task.key))
    {
        return Ok(None);
    }
    let tank = |before: &PlannedTank| {
        now.tanks
            .iter()
            .any(|tank| tank.id == before.id && tank.keys != before.keys)
    };
    let record = |before: &PlannedRecord| {
        now.records
            .iter()
            .any(|record| record.id == before.id && record.key != before.key)
    };
    let tanks: Vec<&str> = plan.tanks.iter().filter(|t| tank(t)).map(|t| t.id.as_str()).collect();
    let records: Vec<&str> = plan
        .records
        .iter()
        .filter(|r| record(r))
        .map(|r| r.id.as_str())
        .collect();
    let same_tanks = plan
        .tanks
        .iter()
        .map(|tank| &tank.id)
        .eq(now.tanks.iter().map(|tank| &tank.id));
    let same_records = (plan.records.iter().map(|record| &record.id)).eq(now.records.iter().map(|record| &record.id));
    let parts = [named("tank", &tanks), named("record", &records)];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    Ok(Some(match parts.is_empty() {
        false => parts.join(" and "),
        true if !same_tanks => "the list of tanks".into(),
        true if !same_records => "the list of records".into(),
        true => "the study file, or the program's methods,".into(),
    }))
}

/// Most tanks or records that a message names.
const NAMED: usize = 5;

/// "the tank `a`", "the tanks `a`, `b` and 3 more"; none without ids.
fn named(what: &str, ids: &[&str]) -> Option<String> {
    let names: Vec<String> = ids.iter().take(NAMED).map(|id| format!("`{id}`")).collect();
    let names = names.join(", ");
    match ids.len() {
        0 => None,
        1 => Some(format!("the {what} {names}")),
        n if n > NAMED => Some(format!("the {what}s {names} and {} more", n - NAMED)),
        _ => Some(format!("the {what}s {names}")),
    }
}

/// The error of input that is not as it was when the plan was made.
///
/// * `what`: as [`departure`] says it
pub fn changed_since(what: &str) -> Error {
    Error::input(
        Code::StudyChanged,
        format!(
            "{}\n  help: plan again with `tankcheck study plan`; results whose input is unchanged are kept",
            since(what)
        ),
    )
}

/// The same as a clause.
pub fn since(what: &str) -> String {
    format!("{what} changed since the plan")
}
