//! `tankcheck check --table`: a table of tanks, one line of answers for each.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use crate::cli::inputs::{self, Inputs, shaken};
use crate::cli::terminal::{report_failure, say, warn};
use crate::cli::{compare, print, solve};
use crate::error::{EXIT_CHECK_FAILED, EXIT_COMPUTATION, EXIT_INPUT, EXIT_INTERRUPTED, EXIT_OK, Error};
use crate::input::csv::{self, Cell, Table};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::{self, TankFile};
use crate::job::Job;
use crate::pipeline;
use crate::solve::Variable;
use files::code::{Code, Warning};
use files::text;

/// Columns that name a tank without being a path, as in the table of a study; they are copied to the answer.
const NAMES: [&str; 2] = ["tag", "id"];

/// The table without the columns that only name its tanks.
fn values(table: &Table) -> Table {
    let kept: Vec<usize> = (0..table.head.len()).filter(|&i| !NAMES.contains(&table.head[i].text.as_str())).collect();
    let pick = |row: &Vec<Cell>| kept.iter().map(|&i| row[i].clone()).collect();
    Table { source: table.source.clone(), head: pick(&table.head), rows: table.rows.iter().map(pick).collect() }
}

/// Checks every tank of the table and prints the table with the answers; returns the exit code of the worst tank.
///
/// Errors: a bad tank file, table or column; a table of which every row is refused.
pub(crate) fn run(inputs: &Inputs, path: &Path, variable: Option<&str>) -> Result<u8, Error> {
    let variable = variable.map(Variable::parse).transpose()?;
    let base = input::read_tank(&inputs.tank)?;
    let table = csv::read(path)?;
    let tanks = tanks(&base, &values(&table))?;
    twins(&table);
    let mut head: Vec<String> = table.head.iter().map(|c| c.text.clone()).collect();
    head.extend(["status", "method", "check", "utilisation"].map(str::to_owned));
    if let Some(variable) = variable {
        let name = variable.name().replace(':', "_");
        let unit = variable.unit().replace('/', "_");
        head.extend([format!("solved_{name}_{unit}"), "solved_check".into(), "solved_status".into()]);
    }
    let mut text = line(&head);
    let mut codes = Vec::new();
    let (mut said, mut any) = (BTreeSet::new(), table.rows.is_empty());
    let resolve =
        |(tank, row): (Option<TankFile>, &Vec<Cell>)| tank.map(|tank| resolved(inputs, tank, &place(&table, row)));
    let jobs: Vec<_> = tanks.into_iter().zip(&table.rows).map(resolve).collect();
    let one = |job: Option<Result<Job, Error>>| job.map(|job| answer(&job?, inputs.strict, variable));
    for (answered, row) in side_by_side(jobs, one).into_iter().zip(&table.rows) {
        let mut cells: Vec<String> = row.iter().map(|c| c.text.clone()).collect();
        match answered {
            Some(Ok((code, answers))) => {
                codes.push(code);
                any = true;
                cells.extend(answers);
            }
            Some(Err(error)) if error.exit_code() == EXIT_INTERRUPTED => return Err(error),
            Some(Err(error)) => {
                codes.push(error.exit_code());
                // What is wrong with the tank file is wrong in every row.
                if said.insert(error.message()) {
                    report_failure(&error);
                }
                say!("note: the fault is in the tank of {}", place(&table, row));
                cells.push(REFUSED.into());
            }
            None => {
                codes.push(EXIT_INPUT);
                cells.push(REFUSED.into());
            }
        }
        cells.resize(head.len(), String::new());
        text.push_str(&line(&cells));
    }
    // Where no tank was computed there are the faults alone, which stand on standard error.
    if any {
        print(&text)?;
    }
    let first = [EXIT_INPUT, EXIT_COMPUTATION, EXIT_CHECK_FAILED];
    let first = first.into_iter().find(|code| codes.contains(code));
    Ok(first.or(codes.into_iter().max()).unwrap_or(EXIT_OK))
}

/// Status of a row whose tank is bad input or cannot be computed.
const REFUSED: &str = "refused";

/// Where a row stands: "tanks.csv:3".
fn place(table: &Table, row: &[Cell]) -> String {
    let (number, _) = table.source.line_column(csv::span(row).start);
    format!("{}:{number}", table.source.name)
}

/// The job of a tank; its warnings go to standard error.
///
/// Errors: options that do not fit it; no ground motion.
fn resolved(inputs: &Inputs, tank: TankFile, place: &str) -> Result<Job, Error> {
    let job = inputs.resolved(tank)?;
    inputs::warned(&job, &format!("{place}: "));
    shaken(&job)?;
    Ok(job)
}

/// What is found for each item, in their order, by as many threads as the program may use. They are not those of the pool, whose threads take
/// other work while they wait: procedures read what is set for their thread.
fn side_by_side<T: Send, R: Send>(items: Vec<T>, one: impl Fn(T) -> R + Sync) -> Vec<R> {
    let threads = fem::cores::available().min(items.len());
    let queue = Mutex::new(items.into_iter().enumerate());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        let mut found = Vec::new();
        while let Some((i, item)) = next() {
            found.push((i, one(item)));
        }
        found
    };
    let mut all = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
            .collect::<Vec<_>>()
    });
    all.sort_by_key(|(i, _)| *i);
    all.into_iter().map(|(_, found)| found).collect()
}

/// Exit code and answers of one tank.
fn answer(job: &Job, strict: bool, variable: Option<Variable>) -> Result<(u8, Vec<String>), Error> {
    let (_, verdict) = pipeline::procedures::decide_without_sheets(job)?;
    let governing = verdict.governing.as_ref();
    let utilisation = governing.and_then(|g| g.check.utilisation);
    let mut cells = vec![
        solve::answer(&verdict).into(),
        governing.map_or(String::new(), |g| g.method.clone()),
        governing.map_or(String::new(), |g| g.check.id.clone()),
        utilisation.map_or(String::new(), |u| format!("{u:.6}")),
    ];
    if let Some(variable) = variable {
        let solution = crate::solve::run(job, variable)?;
        let (value, check) = match solution.value() {
            Some((value, at)) => {
                (value.to_string(), at.governing.as_ref().map_or(String::new(), |g| g.check.id.clone()))
            }
            None => (String::new(), String::new()),
        };
        cells.extend([value, check, solve::status(&solution).into()]);
    }
    Ok((compare::exit_code(&verdict, strict), cells))
}

/// Warns of rows with the same name: their answers cannot be told apart.
fn twins(table: &Table) {
    let names = (0..table.head.len()).filter(|&i| NAMES.contains(&table.head[i].text.as_str()));
    for column in names {
        let mut first: BTreeMap<&str, &Vec<Cell>> = BTreeMap::new();
        for row in table.rows.iter().filter(|row| !row[column].text.is_empty()) {
            let name = row[column].text.as_str();
            match first.get(name) {
                Some(other) => {
                    let text = format!(
                        "the same {} `{name}` as in {}; their answers cannot be told apart",
                        table.head[column].text,
                        place(table, other)
                    );
                    warn(&format!("{}: ", place(table, row)), &Warning::new(Code::Inconsistent, text));
                }
                None => {
                    first.insert(name, row);
                }
            }
        }
    }
}

/// The tanks of all rows; none of a row that is refused, whose faults go to standard error.
///
/// Errors: the faults of columns, which are those of every row, each once; those of all rows where no row is good.
fn tanks(base: &TankFile, table: &Table) -> Result<Vec<Option<TankFile>>, Error> {
    let mut faults = Faults::new();
    let mut columns = false;
    let mut tanks = Vec::with_capacity(table.rows.len());
    for row in &table.rows {
        match input::tank::variant(base, table, row) {
            Ok(tank) => tanks.push(Some(tank)),
            Err(found) => {
                for fault in found.list() {
                    columns |= of_column(table, fault);
                    // A fault of a column is that of every row.
                    if !faults.list().contains(fault) {
                        faults.push(fault.clone());
                    }
                }
                tanks.push(None);
            }
        }
    }
    if faults.is_empty() {
        return Ok(tanks);
    }
    let refused = tanks.iter().filter(|tank| tank.is_none()).count();
    let error = Error::from(faults.into_error(&table.source));
    if columns || refused == tanks.len() {
        return Err(error);
    }
    report_failure(&error);
    let (are, of) = (if refused == 1 { "is" } else { "are" }, tanks.len());
    say!("note: {refused} of {of} rows {are} refused, the others are computed");
    Ok(tanks)
}

/// Whether a fault stands in the head of the table.
fn of_column(table: &Table, fault: &Fault) -> bool {
    let head = csv::span(&table.head);
    fault.span.as_ref().is_some_and(|span| span.end <= head.end)
}

/// One line of CSV; cells are quoted where they have to be.
fn line(cells: &[String]) -> String {
    let cells: Vec<_> = cells.iter().map(|text| text::cell(text)).collect();
    format!("{}\n", cells.join(","))
}
