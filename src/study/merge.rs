//! Results to tables: `rows.csv`, `tanks.csv`, `farm.csv`, `fragility.json`.
//!
//! Results are read twice, once for the columns and once for the rows, so that memory does not grow with the study. Rows stand in the order
//! of the plan. The caller moves the files as a set. The files have no times, paths or names of machines in them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use fem::progress::Progress;
use tank::Quantity;

use super::curves::beside_each_other;
use super::damage::{Gathered, Judged, judged};
use super::merged::Merged;
use super::page::{Tanks, page};
use super::plan::{Plan, Task};
use super::rows::{Ending, Line, Row, RowStatus, TankRow};
use super::store::{self, Found, Rolling};
use crate::error::Error;
use files::code::Code;
use files::error::describe;
use files::write_whole;

/// Names of the merged files.
pub const FILES: &[&str] = &[
    "rows.csv",
    "rows.sha256",
    #[cfg(feature = "parquet")]
    super::parquet::FILE,
    "tanks.csv",
    "farm.csv",
    "fragility.json",
];

/// Whether a merge writes a file of this name, the report and those of programs with other features included.
pub fn writes(name: &str) -> bool {
    FILES.contains(&name) || ["rows.parquet", "report.html"].contains(&name)
}

/// Merges the results of a study.
///
/// * `partial`: whether missing tasks are admitted
/// * `out`: where the files are written
///
/// Errors: missing or damaged results, unless they are admitted; results that change meanwhile; files that cannot be written.
pub fn merge(
    folder: &Path,
    (plan, tasks): (&Plan, &[Task]),
    partial: bool,
    out: &Path,
    progress: &dyn Progress,
) -> Result<Merged, Error> {
    progress.stage("reading results", tasks.len() as u64);
    let (mut columns, missing) = survey(folder, (plan, tasks), progress)?;
    if !partial && !missing.is_empty() {
        return Err(Error::input(Code::StudyIncomplete, refusal(folder, tasks.len(), &missing)));
    }
    progress.stage("writing rows", tasks.len() as u64);
    let mut all = Gathering {
        plan,
        tanks: tank_head(&columns.tanks),
        gathered: Gathered { judged: std::mem::take(&mut columns.judged), ..Gathered::default() },
        columns,
        volumes: BTreeMap::new(),
        units: Tanks::default(),
        last: None,
        merged: Merged {
            missing: missing.len(),
            damaged: missing.iter().filter(|(_, damage)| damage.is_some()).count(),
            ..Merged::default()
        },
    };
    all.rows(folder, tasks, &missing, out, progress)?;
    #[cfg(feature = "parquet")]
    super::parquet::write(&out.join("rows.csv"), &out.join(super::parquet::FILE))?;
    all.write(out)
}

/// Columns of the tables.
#[derive(Default)]
struct Columns {
    values: BTreeSet<String>,
    checks: BTreeSet<String>,
    tanks: BTreeSet<String>,
    judged: Judged,
}

impl Columns {
    fn with(mut self, other: Columns) -> Columns {
        self.values.extend(other.values);
        self.checks.extend(other.checks);
        self.tanks.extend(other.tanks);
        for (tank, demands) in other.judged {
            self.judged.entry(tank).or_default().extend(demands);
        }
        self
    }
}

/// A task without a result, and what is damaged about the one that it has.
type Missing<'a> = (&'a Task, Option<String>);

/// Columns of a part of the tasks, and the tasks of it without a result.
type Part<'a> = (Columns, Vec<Missing<'a>>);

/// Reads all results once: their columns, and the tasks without one.
fn survey<'a>(folder: &Path, planned: (&Plan, &'a [Task]), progress: &dyn Progress) -> Result<Part<'a>, Error> {
    let (plan, tasks) = planned;
    let part = |tasks: &&'a [Task]| vec![survey_part(folder, (plan, tasks), progress)];
    let parts: Vec<&[Task]> = tasks.chunks(SURVEYED).collect();
    let mut found = Part::default();
    for (columns, missing) in beside_each_other(&parts, part) {
        found.0 = found.0.with(columns);
        found.1.extend(missing);
    }
    Ok(found)
}

/// Tasks that one core surveys at a time.
const SURVEYED: usize = 16;

fn survey_part<'a>(folder: &Path, (plan, tasks): (&Plan, &'a [Task]), progress: &dyn Progress) -> Part<'a> {
    let (mut columns, mut missing) = Part::default();
    for task in tasks {
        match store::find(folder, plan, task) {
            Found::Missing | Found::Failed => missing.push((task, None)),
            Found::Damaged(what) => missing.push((task, Some(what))),
            Found::Whole(lines) => {
                for line in &lines {
                    match line {
                        Line::Row(row) => {
                            add(&mut columns.values, row.values.keys());
                            add(&mut columns.checks, row.checks.keys());
                            judged(row, &mut columns.judged);
                        }
                        Line::Tank(tank) => add(&mut columns.tanks, tank.values.keys()),
                    }
                }
            }
        }
        progress.advance(1);
    }
    (columns, missing)
}

/// What is gathered line by line.
struct Gathering<'a> {
    plan: &'a Plan,
    columns: Columns,
    /// Text of `tanks.csv`.
    tanks: String,
    gathered: Gathered,
    volumes: BTreeMap<String, f64>,
    units: Tanks,
    last: Option<(String, u32)>,
    merged: Merged,
}

impl Gathering<'_> {
    /// Writes `rows.csv`.
    fn rows(
        &mut self,
        folder: &Path,
        tasks: &[Task],
        missing: &[Missing<'_>],
        out: &Path,
        progress: &dyn Progress,
    ) -> Result<(), Error> {
        let unwritten = |e: std::io::Error| {
            Error::Files(files::error::Error::Unwritten { path: folder.join("rows.csv"), what: describe(&e) })
        };
        let mut file = BufWriter::new(File::create(out.join("rows.csv")).map_err(unwritten)?);
        let mut hash = Rolling::new();
        let mut text = head(&self.columns.values, &self.columns.checks);
        let without: BTreeSet<usize> = missing.iter().map(|(task, _)| task.task).collect();
        let plan = self.plan;
        std::thread::scope(|scope| {
            // The next result is read while this one is written. A merge that fails takes no more, which ends the reader.
            let (send, results) = std::sync::mpsc::sync_channel(1);
            let with = tasks.iter().filter(|task| !without.contains(&task.task));
            scope.spawn(move || {
                for task in with {
                    if send.send((task, store::find(folder, plan, task))).is_err() {
                        return;
                    }
                }
            });
            for (task, found) in results {
                let Found::Whole(lines) = found else { return Err(changed(&task.key)) };
                for line in lines {
                    self.line(&line, &mut text);
                }
                hash.add(text.as_bytes());
                file.write_all(text.as_bytes()).map_err(unwritten)?;
                text.clear();
                progress.advance(1);
            }
            Ok(())
        })?;
        file.flush().map_err(unwritten)?;
        self.merged.sha256 = hash.hex();
        Ok(())
    }

    /// Takes a line; a row is added to the text of `rows.csv`.
    fn line(&mut self, line: &Line, text: &mut String) {
        match line {
            Line::Row(row) => {
                csv_row(text, row, &self.columns.values, &self.columns.checks);
                self.gathered.add(row, &self.plan.damage);
                self.merged.rows += 1;
                *self.merged.by_status.entry(row.status.word()).or_default() += 1;
            }
            // A tank stands in the result of each of its blocks.
            Line::Tank(tank) => {
                self.units.gaps(tank);
                let unit = (tank.tank.clone(), tank.sample);
                if self.last.as_ref() != Some(&unit) {
                    csv_tank(&mut self.tanks, tank, &self.columns.tanks);
                    self.units.add(tank);
                    if let Some(volume) = tank.volume {
                        self.volumes.entry(tank.tank.clone()).or_insert(volume);
                    }
                    self.last = Some(unit);
                }
            }
        }
    }

    /// Writes the tables beside `rows.csv`.
    fn write(mut self, out: &Path) -> Result<Merged, Error> {
        write_whole(&out.join("rows.sha256"), format!("{}  rows.csv\n", self.merged.sha256).as_bytes())?;
        write_whole(&out.join("tanks.csv"), self.tanks.as_bytes())?;
        write_whole(&out.join("farm.csv"), farm(&self.gathered, &self.volumes).as_bytes())?;
        let fragility = super::curves::fragility(self.plan, &self.gathered, &self.volumes, self.merged.missing);
        let text = serde_json::to_string_pretty(&fragility).map_err(|e| Error::report(e.to_string()))?;
        write_whole(&out.join("fragility.json"), format!("{text}\n").as_bytes())?;
        let study = page(self.plan, &self.merged, &self.gathered, &fragility, self.units);
        self.merged.study = Some(study);
        self.merged.worst = self.gathered.worst;
        Ok(self.merged)
    }
}

fn add<'a>(set: &mut BTreeSet<String>, keys: impl Iterator<Item = &'a String> + Clone) {
    // Most rows have the keys of those before.
    if keys.clone().eq(set.iter()) {
        return;
    }
    for key in keys {
        if !set.contains(key) {
            set.insert(key.clone());
        }
    }
}

/// The error of a result that was whole when the columns were read.
fn changed(key: &str) -> Error {
    Error::input(
        Code::StudyIncomplete,
        format!("{} changed while it was merged\n  help: merge again", store::name(key)),
    )
}

/// Most damaged or failed results that a message names.
const NAMED: usize = 5;

fn refusal(folder: &Path, tasks: usize, missing: &[Missing<'_>]) -> String {
    let mut text = format!("{} of {tasks} tasks have no result", missing.len());
    let damaged = missing.iter().filter_map(|(task, what)| Some((task, what.as_ref()?)));
    for (task, what) in damaged.clone().take(NAMED) {
        let _ = write!(text, "\n  task {}: {} {what}", task.task, store::name(&task.key));
    }
    let failed: Vec<_> = missing.iter().filter_map(|(task, _)| store::failure(folder, &task.key)).collect();
    for failure in failed.iter().take(NAMED) {
        let _ = write!(text, "\n  task {}: {}", failure.task, failure.message);
    }
    for (what, count) in [("damaged results", damaged.count()), ("failed tasks", failed.len())] {
        if count > NAMED {
            let _ = write!(text, "\n  and {} more {what}", count - NAMED);
        }
    }
    text.push_str(
        "\n  help: `tankcheck study run` computes what is missing or damaged; `--partial` merges what there is",
    );
    text
}

/// Name of a column with its unit.
fn column(key: &str) -> String {
    let quantity = key.rsplit_once('.').and_then(|(_, id)| Quantity::from_id(id));
    match quantity {
        Some(quantity) => {
            let unit: String = quantity.dimension().si_symbol().chars().filter(char::is_ascii_alphanumeric).collect();
            format!("{key}_{unit}")
        }
        None => key.to_owned(),
    }
}

fn head(values: &BTreeSet<String>, checks: &BTreeSet<String>) -> String {
    let mut text = String::from(
        "tank,sample,record,level,factor,im,pga_m_s2,pgv_m_s,pgd_m,usable_period_s,sloshing_beyond_usable,status,time_s",
    );
    for key in values {
        let _ = write!(text, ",{}", column(key));
    }
    for key in checks {
        let _ = write!(text, ",{key}_utilisation");
    }
    text.push_str(",message\n");
    text
}

fn csv_row(text: &mut String, row: &Row, values: &BTreeSet<String>, checks: &BTreeSet<String>) {
    cell(text, &row.tank);
    let _ = write!(text, ",{},", row.sample);
    cell(text, &row.record);
    let peaks = row.peaks.map_or([None; 3], |p| p.map(Some));
    // The factor of a level is not known where there was no run.
    let factor = Some(row.factor).filter(|f| *f > 0.0);
    for value in [row.level, factor, row.im, peaks[0], peaks[1], peaks[2], row.usable_period] {
        text.push(',');
        number(text, value);
    }
    let beyond = match row.sloshing_beyond_usable {
        Some(true) => "yes",
        Some(false) => "no",
        None => "",
    };
    let _ = write!(text, ",{beyond},{},", row.status.word());
    number(text, row.time);
    cells(text, values, &row.values, |text, value| number(text, Some(*value)));
    cells(text, checks, &row.checks, |text, ending| match ending {
        Ending::Utilisation(value) => number(text, Some(*value)),
        Ending::Word(word) => text.push_str(word),
    });
    text.push(',');
    cell(text, row.message.as_deref().unwrap_or_default());
    text.push('\n');
}

fn tank_head(values: &BTreeSet<String>) -> String {
    let mut text = String::from(
        "tank,sample,verdict,governing_method,governing_check,utilisation,impulsive_period_s,sloshing_period_s,volume_m3",
    );
    for key in values {
        let _ = write!(text, ",{}", column(key));
    }
    text.push_str(",message\n");
    text
}

fn csv_tank(text: &mut String, tank: &TankRow, values: &BTreeSet<String>) {
    cell(text, &tank.tank);
    let _ = write!(text, ",{},{},", tank.sample, tank.verdict);
    match &tank.governing {
        Some((method, check, utilisation)) => {
            let _ = write!(text, "{method},{check},");
            number(text, *utilisation);
        }
        None => text.push_str(",,"),
    }
    for value in [tank.periods[0], tank.periods[1], tank.volume] {
        text.push(',');
        number(text, value);
    }
    cells(text, values, &tank.values, |text, value| number(text, Some(*value)));
    text.push(',');
    cell(text, tank.message.as_deref().unwrap_or_default());
    text.push('\n');
}

/// Tanks in the worst state and the volume of their liquid, earthquake by earthquake.
fn farm(gathered: &Gathered, volumes: &BTreeMap<String, f64>) -> String {
    let mut text = String::from("record,sample,im,tanks_judged,tanks_lost,volume_lost_m3,names\n");
    for ((record, sample, im), lost) in &gathered.losses {
        cell(&mut text, record);
        let _ = write!(text, ",{sample},");
        number(&mut text, Some(f64::from_bits(*im)));
        let volume = lost.tanks.iter().filter_map(|tank| volumes.get(tank)).fold(0.0, |sum, v| sum + v);
        let _ = write!(text, ",{},{},", lost.tanks.len() + lost.safe.len(), lost.tanks.len());
        number(&mut text, Some(super::rows::kept(volume)));
        text.push(',');
        cell(&mut text, &lost.tanks.join(" "));
        text.push('\n');
    }
    text
}

/// Cells of the columns, those that a row has not empty. The columns have all keys of every row; both are sorted.
fn cells<V>(text: &mut String, columns: &BTreeSet<String>, row: &BTreeMap<String, V>, write: impl Fn(&mut String, &V)) {
    let mut own = row.iter().peekable();
    for column in columns {
        text.push(',');
        if let Some((_, value)) = own.next_if(|(key, _)| *key == column) {
            write(text, value);
        }
    }
}

fn cell(text: &mut String, value: &str) {
    text.push_str(&files::text::cell(value));
}

/// A number with the digits that it has; empty without one.
fn number(text: &mut String, value: Option<f64>) {
    let Some(value) = value else { return };
    let size = value.abs();
    let _ = match size == 0.0 || (1e-4..1e15).contains(&size) {
        true => write!(text, "{value}"),
        false => write!(text, "{value:e}"),
    };
}

/// Rows by status, the first of which is `ok`.
pub fn failed(merged: &Merged) -> usize {
    let ok = merged.by_status.get(RowStatus::Ok.word()).copied().unwrap_or(0);
    merged.rows - ok
}
