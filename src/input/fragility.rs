//! Tables of data for fragility curves, and hazard curves: CSV with named columns.

use std::collections::BTreeMap;
use std::path::Path;

use ::fragility::cloud::Run;
use ::fragility::stripes::Stripe;

use crate::input::csv::{self, Cell, Table};
use crate::input::diagnostic::{Fault, Faults};
use files::code::Code;
use files::error::Error;

/// Name of the state of a table without the column `damage_state`.
pub const STATE: &str = "damage";

/// Largest number of damage states of a table.
const MAX_STATES: usize = 100;

/// Data by damage state, in the order in which the states first stand in the table.
pub type ByState<T> = Vec<(String, Vec<T>)>;

/// A table with its faults so far.
struct Reader {
    table: Table,
    faults: Faults,
}

impl Reader {
    fn open(path: &Path, required: &[&str], optional: &[&str]) -> Result<Reader, Error> {
        let table = csv::read(path)?;
        let mut faults = Faults::new();
        let known: Vec<&str> = required.iter().chain(optional).copied().collect();
        for cell in table.head.iter().filter(|cell| !known.contains(&cell.text.as_str())) {
            let fault =
                Fault::new(Code::TableColumn, format!("unexpected column `{}`", cell.text)).at(cell.span.clone());
            faults.push(fault.allowed(known.join(", ")));
        }
        for name in required.iter().filter(|name| !table.head.iter().any(|cell| cell.text == **name)) {
            let found: Vec<&str> = table.head.iter().map(|cell| cell.text.as_str()).collect();
            let fault =
                Fault::new(Code::TableColumn, format!("the column `{name}` is missing")).found(found.join(", "));
            faults.push(fault.allowed(known.join(", ")));
        }
        if faults.is_empty() { Ok(Reader { table, faults }) } else { Err(faults.into_error(&table.source)) }
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.table.head.iter().position(|cell| cell.text == name)
    }

    /// A number of a cell for which `holds`; NaN if it is faulty.
    fn number(&mut self, cell: &Cell, allowed: &str, holds: impl Fn(f64) -> bool) -> f64 {
        match cell.text.parse::<f64>() {
            Ok(value) if value.is_finite() && holds(value) => value,
            _ => {
                let fault = Fault::new(Code::TableValue, "a number out of range, or none").at(cell.span.clone());
                self.faults.push(fault.found(cell.text.clone()).allowed(allowed));
                f64::NAN
            }
        }
    }

    fn fault(&mut self, row: &[Cell], message: &str, allowed: &str) {
        self.faults.push(Fault::new(Code::TableValue, message).at(csv::span(row)).allowed(allowed));
    }

    fn finish<T>(self, found: T) -> Result<T, Error> {
        if self.faults.is_empty() { Ok(found) } else { Err(self.faults.into_error(&self.table.source)) }
    }

    /// Every row as an item of its state.
    fn by_state<T>(mut self, mut item: impl FnMut(&mut Reader, &[Cell]) -> T) -> Result<ByState<T>, Error> {
        let state = self.column("damage_state");
        let rows = std::mem::take(&mut self.table.rows);
        let mut all: ByState<T> = Vec::new();
        let mut places: BTreeMap<&str, usize> = BTreeMap::new();
        for row in &rows {
            let name = state.map_or(STATE, |i| row[i].text.as_str());
            let found = item(&mut self, row);
            let place = *places.entry(name).or_insert(all.len());
            match all.get_mut(place) {
                Some((_, items)) => items.push(found),
                None => all.push((name.to_owned(), vec![found])),
            }
        }
        if all.len() > MAX_STATES {
            let fault = Fault::new(Code::TableShape, "too many damage states").found(format!("{} states", all.len()));
            self.faults.push(fault.allowed(format!("at most {MAX_STATES} states")));
        }
        self.finish(all)
    }
}

const POSITIVE: &str = "a number greater than 0";

/// Counts at intensities: `im,n,exceed`, and `damage_state` for several curves.
///
/// Errors: a file that cannot be read; the faults of all rows.
pub fn stripes(path: &Path) -> Result<ByState<Stripe>, Error> {
    let reader = Reader::open(path, &["im", "n", "exceed"], &["damage_state"])?;
    let columns = ["im", "n", "exceed"].map(|name| reader.column(name).unwrap_or_default());
    let whole = |v: f64| v >= 0.0 && v.fract() == 0.0 && v < 1e9;
    reader.by_state(|r, row| {
        let im = r.number(&row[columns[0]], POSITIVE, |v| v > 0.0);
        let n = r.number(&row[columns[1]], "a whole number of runs, at least 1", |v| whole(v) && v >= 1.0);
        let exceed = r.number(&row[columns[2]], "a whole number from 0 to n", whole);
        if exceed > n {
            r.fault(row, "more runs reached the state than there are", "exceed at most n");
        }
        Stripe { im, n, exceed }
    })
}

/// Capacities: `im`, and `damage_state` for several curves.
///
/// * `largest`: intensity at which scaling ended
///
/// Errors: a file that cannot be read; the faults of all rows.
pub fn capacities(path: &Path, largest: Option<f64>) -> Result<ByState<f64>, Error> {
    let reader = Reader::open(path, &["im"], &["damage_state"])?;
    let column = reader.column("im").unwrap_or_default();
    reader.by_state(|r, row| {
        let im = r.number(&row[column], POSITIVE, |v| v > 0.0);
        if largest.is_some_and(|largest| im > largest) {
            r.fault(row, "a capacity beyond the end of scaling", "at most --im-max");
        }
        im
    })
}

/// Demands against intensities: `im,edp`, and `collapsed` (0 or 1) beside them; the demand of a run that collapsed may be empty.
///
/// Errors: a file that cannot be read; the faults of all rows.
pub fn cloud(path: &Path) -> Result<Vec<Run>, Error> {
    let reader = Reader::open(path, &["im", "edp"], &["collapsed"])?;
    let (im, edp) = (reader.column("im").unwrap_or_default(), reader.column("edp").unwrap_or_default());
    let collapsed = reader.column("collapsed");
    let found = reader.by_state(|r, row| {
        let fell = collapsed.is_some_and(|i| match row[i].text.as_str() {
            "1" => true,
            "0" => false,
            _ => r.number(&row[i], "0 or 1", |v| v == 0.0 || v == 1.0) == 1.0,
        });
        Run {
            im: r.number(&row[im], POSITIVE, |v| v > 0.0),
            demand: (!fell).then(|| r.number(&row[edp], POSITIVE, |v| v > 0.0)),
        }
    })?;
    Ok(found.into_iter().flat_map(|(_, runs)| runs).collect())
}

/// Points (im, rate a year) of a hazard curve: `im,rate`, intensities ascending, rates descending.
///
/// Errors: a file that cannot be read; the faults of all rows; fewer than two points.
pub fn hazard(path: &Path) -> Result<Vec<[f64; 2]>, Error> {
    let reader = Reader::open(path, &["im", "rate"], &[])?;
    let (im, rate) = (reader.column("im").unwrap_or_default(), reader.column("rate").unwrap_or_default());
    let mut last: Option<[f64; 2]> = None;
    let found = reader.by_state(|r, row| {
        let point = [
            r.number(&row[im], POSITIVE, |v| v > 0.0),
            r.number(&row[rate], "a rate a year greater than 0", |v| v > 0.0),
        ];
        if last.is_some_and(|last| point[0] <= last[0] || point[1] >= last[1]) {
            r.fault(row, "the hazard curve does not fall", "ascending intensities with descending rates");
        }
        last = Some(point);
        point
    })?;
    let points: Vec<[f64; 2]> = found.into_iter().flat_map(|(_, points)| points).collect();
    match points.len() {
        0 | 1 => Err(Error::File {
            code: Code::ItemCount,
            path: path.into(),
            what: format!("found {} point(s) of a hazard curve, expected at least 2", points.len()),
        }),
        _ => Ok(points),
    }
}
