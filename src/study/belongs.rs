//! Whether the lines of a result are those that the plan has for its task.

use std::fmt::{Display, Formatter};

use super::plan::{Plan, Task};
use super::rows::{Line, Row, SITE, kept};

/// What a line is about.
#[derive(Clone, Copy, PartialEq)]
struct Place<'a> {
    tank: &'a str,
    sample: u32,
    /// Record and scale; none for the line of the tank itself.
    row: Option<(&'a str, Scale)>,
}

#[derive(Clone, Copy, PartialEq)]
enum Scale {
    Level(f64),
    Factor(f64),
}

impl Display for Place<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "the tank `{}`, sample {}", self.tank, self.sample)?;
        match self.row {
            Some((record, Scale::Level(level))) => write!(f, ", under `{record}` at the level {level}"),
            Some((record, Scale::Factor(factor))) => write!(f, ", under `{record}` times {factor}"),
            None => Ok(()),
        }
    }
}

/// The first line that is not the planned one, in words.
pub(super) fn stranger(plan: &Plan, task: &Task, lines: &[Line]) -> Option<String> {
    let mut found = lines.iter().map(place);
    for (number, wanted) in planned(plan, task).enumerate() {
        match found.next() {
            Some(found) if found == wanted => {}
            Some(found) => return Some(format!("line {} is of {found}; expected {wanted}", number + 1)),
            None => return Some(format!("ends at line {number}, expected {wanted}")),
        }
    }
    found.next().map(|more| format!("has a line too many, of {more}"))
}

/// The lines of a task.
fn planned<'a>(plan: &'a Plan, task: &'a Task) -> impl Iterator<Item = Place<'a>> {
    let scales: Vec<Scale> = match plan.levels.is_empty() {
        true => plan.factors.iter().map(|factor| Scale::Factor(kept(*factor))).collect(),
        false => plan.levels.iter().map(|level| Scale::Level(kept(*level))).collect(),
    };
    let mut rows = Vec::new();
    for record in &plan.records[task.records()] {
        rows.extend(scales.iter().map(|scale| Some((record.id.as_str(), *scale))));
    }
    if plan.records.is_empty() {
        rows.push(Some((SITE, Scale::Factor(1.0))));
    }
    task.tanks.iter().flat_map(move |&(tank, sample)| {
        let tank = plan.tanks[tank].id.as_str();
        let lines: Vec<_> = std::iter::once(None).chain(rows.iter().copied()).collect();
        lines.into_iter().map(move |row| Place { tank, sample, row })
    })
}

fn place(line: &Line) -> Place<'_> {
    match line {
        Line::Tank(tank) => Place { tank: &tank.tank, sample: tank.sample, row: None },
        Line::Row(row) => Place { tank: &row.tank, sample: row.sample, row: Some((&row.record, scale(row))) },
    }
}

fn scale(row: &Row) -> Scale {
    match row.level {
        Some(level) => Scale::Level(kept(level)),
        None => Scale::Factor(kept(row.factor)),
    }
}
