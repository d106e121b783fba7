//! `tanks`: tank files, or a template with a table.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::keys::Tanks;
use super::{Sampling, matching, name_of};
use crate::input::csv::{self, Cell, Table};
use crate::input::diagnostic::{Fault, Faults, Source};
use crate::input::tank::read::Field;
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::variant::variant;
use crate::input::{TankFile, read_tank};
use files::code::Code;
use files::error::Error;

/// A tank of a study: a file, and the row of a table with values over those of the file.
#[derive(Clone, Debug)]
pub struct TankEntry {
    /// Its name in the rows, unique in the study.
    pub id: String,
    /// The tank file.
    base: Arc<TankFile>,
    /// Table whose head are paths, and the row.
    row: Option<(Arc<Table>, usize)>,
    /// Where its row begins in the table [bytes].
    start: usize,
}

impl TankEntry {
    /// The tank of a sample; without sampling that of the file.
    ///
    /// Errors: the faults of the tank with these values. The place of one that comes from a drawn value is in the study file, of any other none.
    pub fn tank(&self, sampling: Option<&Sampling>, sample: u32) -> Result<TankFile, Faults> {
        self.variant(sampling, sample).map_err(|refused| {
            let (found, source) = *refused;
            let mut faults = Faults::new();
            for fault in found.list() {
                let place = fault.span.as_ref().filter(|span| span.start > source.text.len());
                faults.push(Fault {
                    span: place.map(|span| moved(span, |at| at - source.text.len() - 1)),
                    ..fault.clone()
                });
            }
            faults
        })
    }

    /// As [`TankEntry::tank`] without sampling. The faults are added to those of the tanks before it, so that a table has one list of them; those of
    /// a column once.
    pub fn nominal(&self, faults: &mut Vec<(Source, Faults)>) -> Option<TankFile> {
        match self.variant(None, 0) {
            Ok(tank) => Some(tank),
            Err(refused) => {
                let (own, source) = *refused;
                let known = faults.iter().position(|(other, _)| *other == source);
                let place = known.unwrap_or_else(|| {
                    faults.push((source, Faults::new()));
                    faults.len() - 1
                });
                let all = &mut faults[place].1;
                for fault in own.list() {
                    if !all.list().contains(fault) {
                        all.push(fault.clone());
                    }
                }
                None
            }
        }
    }

    /// Column → cell of its row, without empty cells; none for a file.
    pub fn given(&self) -> Vec<(String, String)> {
        let Some((table, row)) = &self.row else { return Vec::new() };
        let cells = table.head.iter().zip(&table.rows[*row]);
        let filled = cells.filter(|(_, cell)| !cell.text.is_empty());
        filled.map(|(head, cell)| (head.text.clone(), cell.text.clone())).collect()
    }

    /// Where it is in its table: `farm.csv:3`; none for a file.
    fn place(&self) -> Option<String> {
        let (table, row) = self.row.as_ref()?;
        let (line, _) = table.source.line_column(self.start);
        (*row < table.rows.len()).then(|| format!("{}:{line}", table.source.name))
    }

    fn variant(&self, sampling: Option<&Sampling>, sample: u32) -> Result<TankFile, Box<(Faults, Source)>> {
        let drawn = sampling.map_or_else(Vec::new, |sampling| sampling.draw(sample));
        if self.row.is_none() && drawn.is_empty() {
            return Ok((*self.base).clone());
        }
        let (source, mut head, mut row) = match &self.row {
            Some((table, row)) => (table.source.clone(), table.head.clone(), table.rows[*row].clone()),
            None => (Source::new(self.id.as_str(), ""), Vec::new(), Vec::new()),
        };
        // A sampled value takes the place of one of the table. Its own place, in the study file, is counted from the end of the table.
        for (parameter, text) in drawn {
            let span = moved(&parameter.place, |at| at + source.text.len() + 1);
            let known = head.iter().position(|cell| cell.text == parameter.path);
            let cell = |text: String| Cell { text, span: span.clone() };
            match known {
                Some(column) => {
                    head[column] = cell(parameter.path.clone());
                    row[column] = cell(text);
                }
                None => {
                    head.push(cell(parameter.path.clone()));
                    row.push(cell(text));
                }
            }
        }
        let table = Table { source, head, rows: Vec::new() };
        variant(&self.base, &table, &row).map_err(|faults| Box::new((faults, table.source)))
    }
}

/// Longest name of a tank [characters]: it is part of the name of a folder.
const LONGEST_NAME: usize = 200;

/// Why a name is not one of a tank.
fn unfit(name: &str) -> Option<String> {
    match name.chars().count() {
        0 => Some("is empty".into()),
        n if n > LONGEST_NAME => Some(format!("has {n} characters")),
        _ => None,
    }
}

fn moved(span: &Range<usize>, by: impl Fn(usize) -> usize) -> Range<usize> {
    by(span.start)..by(span.end)
}

/// The tanks of the file; those that cannot be read are added to `broken`.
pub(super) fn tanks(
    r: &mut Resolver<'_>,
    field: &Field<Vec<Field<Tanks>>>,
    folder: &Path,
    broken: &mut Vec<Error>,
) -> Vec<TankEntry> {
    r.sized(field, "items");
    let mut all: Vec<TankEntry> = Vec::new();
    for item in field.value.iter().flatten() {
        let Some(given) = &item.value else { continue };
        let found = match (&given.files.given, &given.template.given, &given.table.given) {
            (Some(files), None, None) => from_files(r, files, folder, broken),
            (None, Some(template), Some(table)) => from_table(r, given, (template, table), folder, broken),
            _ => {
                let message = "tanks without files";
                let allowed = "`files`, or `template` with `table`";
                let fault = range_fault(Code::Incomplete, item, message, allowed);
                r.faults.push(fault.found("{ … }"));
                Vec::new()
            }
        };
        for tank in found {
            if let Some(what) = unfit(&tank.id) {
                let place = tank.place().map_or_else(String::new, |place| format!(" at {place}"));
                let message = format!("the name of a tank{place} {what}");
                let allowed = format!("1 to {LONGEST_NAME} characters");
                let fault = range_fault(Code::BadForm, item, &message, &allowed);
                r.faults.push(fault.found(tank.id.chars().take(40).collect::<String>()));
                continue;
            }
            if let Some(other) = all.iter().find(|other| other.id == tank.id) {
                let places = match (other.place(), tank.place()) {
                    (Some(first), Some(second)) => format!(": {first} and {second}"),
                    (first, second) => first.or(second).map_or_else(String::new, |place| format!(", one at {place}")),
                };
                let message = format!("two tanks are named `{}`{places}", tank.id);
                let fault = range_fault(Code::Repeated, item, &message, "a different name for each tank");
                r.faults.push(match given.id.value() {
                    Some(column) => fault.help(format!("give each row a different name in the column `{column}`")),
                    None => fault.help("name the tanks of a table by a column: \"id\": \"tag\""),
                });
                continue;
            }
            all.push(tank);
        }
    }
    all
}

fn from_files(r: &mut Resolver<'_>, files: &Field<String>, folder: &Path, broken: &mut Vec<Error>) -> Vec<TankEntry> {
    let mut all = Vec::new();
    for path in matching(r, files, folder) {
        match read_tank(&path) {
            Ok(base) => all.push(TankEntry { id: name_of(&path, folder), base: Arc::new(base), row: None, start: 0 }),
            Err(error) => broken.push(error),
        }
    }
    all
}

/// The first of the files that is not a regular one. A pipe is a file for a command that reads it once, and none for a study, whose tasks
/// read it again.
fn irregular(files: &[PathBuf]) -> Option<Error> {
    let found = files.iter().find(|file| file.exists() && !file.is_file())?;
    Some(Error::File { code: Code::FileUnreadable, path: found.clone(), what: "is not a regular file".into() })
}

fn from_table(
    r: &mut Resolver<'_>,
    given: &Tanks,
    (template, table): (&Field<String>, &Field<String>),
    folder: &Path,
    broken: &mut Vec<Error>,
) -> Vec<TankEntry> {
    let (Some(template), Some(name)) = (r.text(template), r.text(table)) else { return Vec::new() };
    let path: PathBuf = folder.join(&name);
    if let Some(error) = irregular(&[folder.join(&template), path.clone()]) {
        broken.push(error);
        return Vec::new();
    }
    let read = read_tank(&folder.join(template)).and_then(|base| Ok((base, csv::read(&path)?)));
    let (base, raw) = match read {
        Ok(found) => found,
        Err(error) => {
            broken.push(error);
            return Vec::new();
        }
    };
    let names: Vec<&str> = raw.head.iter().map(|cell| cell.text.as_str()).collect();
    let mut column = |field: &Field<String>, name: &str| {
        let found = names.iter().position(|n| *n == name);
        if found.is_none() {
            let message = format!("the table has no column `{name}`");
            r.refuse(Code::UnknownChoice, field, &message, &names.join(", "));
        }
        found
    };
    let id = given.id.given.as_ref().and_then(|field| column(field, field.value.as_ref()?));
    // The columns that are used, each with its path.
    let used: Vec<(usize, String)> = match given.columns.value() {
        Some(columns) => {
            let path_of = |(name, field): &(String, Field<String>)| Some((column(field, name)?, field.value.clone()?));
            columns.0.iter().filter_map(path_of).collect()
        }
        None => (0..names.len()).filter(|&i| Some(i) != id).map(|i| (i, names[i].to_owned())).collect(),
    };
    let pick = |row: &[Cell]| -> Vec<Cell> { used.iter().map(|(i, _)| row[*i].clone()).collect() };
    let head = used.iter().map(|(i, path)| Cell { text: path.clone(), span: raw.head[*i].span.clone() }).collect();
    let table =
        Arc::new(Table { source: raw.source.clone(), head, rows: raw.rows.iter().map(|row| pick(row)).collect() });
    let base = Arc::new(base);
    let entry = |(number, row): (usize, &Vec<Cell>)| TankEntry {
        id: id.map_or_else(|| format!("{}-{}", name_of(&path, folder), number + 1), |i| row[i].text.clone()),
        base: Arc::clone(&base),
        row: Some((Arc::clone(&table), number)),
        start: csv::span(row).start,
    };
    raw.rows.iter().enumerate().map(entry).collect()
}
