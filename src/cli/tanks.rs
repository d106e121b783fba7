//! `tankcheck check --table`: a table of tanks, one line of answers for each.

use std::path::Path;

use crate::cli::inputs::{Inputs, shaken};
use crate::cli::terminal::say;
use crate::cli::{compare, print, solve};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::input::csv::{self, Cell, Table};
use crate::input::diagnostic::Faults;
use crate::input::{self, TankFile};
use crate::pipeline;
use crate::solve::Variable;
use files::text;

/// Columns that name a tank without being a path, as in the table of a study; they are copied to the answer.
const NAMES: [&str; 2] = ["tag", "id"];

/// The table without the columns that only name its tanks.
fn values(table: &Table) -> Table {
    let kept: Vec<usize> = (0..table.head.len())
        .filter(|&i| !NAMES.contains(&table.head[i].text.as_str()))
        .collect();
    let pick = |row: &Vec<Cell>| kept.iter().map(|&i| row[i].clone()).collect();
    Table {
        source: table.source.clone(),
        head: pick(&table.head),
        rows: table.rows.iter().map(pick).collect(),
    }
}

/// Checks every tank of the table and prints the table with the answers; returns the exit code of the worst tank.
pub(crate) fn run(inputs: &Inputs, path: &Path, variable: Option<&str>) -> Result<u8, Error> {
    let variable = variable.map(Variable::parse).transpose()?;
    let base = input::read_tank(&inputs.tank)?;
    let table = csv::read(path)?;
    let tanks = tanks(&base, &values(&table))?;
    let mut head: Vec<String> = table.head.iter().map(|c| c.text.clone()).collect();
    head.extend(["status", "method", "check", "utilisation"].map(str::to_owned));
    if let Some(variable) = variable {
        let name = variable.name().replace(':', "_");
        let unit = variable.unit().replace('/', "_");
        head.extend([
            format!("solved_{name}_{unit}"),
            "solved_check".into(),
            "solved_status".into(),
        ]);
    }
    let mut text = line(&head);
    let mut codes = Vec::new();
    for (tank, row) in tanks.into_iter().zip(&table.rows) {
        let (number, _) = table.source.line_column(csv::span(row).start);
        let place = format!("{}:{number}", table.source.name);
        let answered = inputs
            .resolved(tank, &format!("{place}: "))
            .and_then(|job| {
                shaken(&job)?;
                let (_, verdict) = pipeline::procedures::decide(&job)?;
                let solved = variable.map(|v| crate::solve::run(&job, v)).transpose()?;
                Ok((verdict, solved))
            })
            .inspect_err(|_| say!("note: the fault is in the tank of {place}"));
        let (verdict, solved) = answered?;
        codes.push(compare::exit_code(&verdict, inputs.strict));
        let mut cells: Vec<String> = row.iter().map(|c| c.text.clone()).collect();
        let governing = verdict.governing.as_ref();
        cells.push(solve::answer(&verdict).into());
        cells.push(governing.map_or(String::new(), |g| g.method.clone()));
        cells.push(governing.map_or(String::new(), |g| g.check.id.clone()));
        cells.push(
            governing
                .and_then(|g| g.check.utilisation)
                .map_or(String::new(), |u| format!("{u:.6}")),
        );
        if let Some(solution) = &solved {
            let (value, check) = match solution.value() {
                Some((value, at)) => (
                    value.to_string(),
                    at.governing.as_ref().map_or(String::new(), |g| g.check.id.clone()),
                ),
                None => (String::new(), String::new()),
            };
            cells.extend([value, check, solve::status(solution).into()]);
        }
        text.push_str(&line(&cells));
    }
    print(&text)?;
    let failed = codes.contains(&EXIT_CHECK_FAILED);
    let worst = codes.iter().copied().max().unwrap_or(EXIT_OK);
    Ok(if failed { EXIT_CHECK_FAILED } else { worst })
}

/// The tanks of all rows.
///
/// Errors: the faults of all rows, each once.
fn tanks(base: &TankFile, table: &Table) -> Result<Vec<TankFile>, Error> {
    let mut tanks = Vec::with_capacity(table.rows.len());
    let mut faults = Faults::new();
    for row in &table.rows {
        match input::tank::variant(base, table, row) {
            Ok(tank) => tanks.push(tank),
            Err(found) => {
                for fault in found.list() {
                    // A fault of a column is that of every row.
                    if !faults.list().contains(fault) {
                        faults.push(fault.clone());
                    }
                }
            }
        }
    }
    match faults.is_empty() {
        true => Ok(tanks),
        false => Err(faults.into_error(&table.source).into()),
    }
}

/// One line of CSV; cells are quoted where they have to be.
fn line(cells: &[String]) -> String {
    let cells: Vec<_> = cells.iter().map(|text| text::cell(text)).collect();
    format!("{}\n", cells.join(","))
}
