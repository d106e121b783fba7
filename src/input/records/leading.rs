//! First lines of numbers that are not samples: the number of values, the time step, or both.

use super::block::Line;
use super::header::MILLISECONDS;
use super::number::parse;
use super::separator::Separator;
use crate::input::diagnostic::Fault;
use files::code::Code;

/// Lines among which numbers without a point are left to chance.
const FEW: usize = 20;

/// What the first lines of numbers give.
#[derive(Default)]
pub(super) struct Leading {
    /// Number of these lines.
    pub lines: usize,
    /// Number of values.
    pub count: Option<usize>,
    /// Time step [s].
    pub dt: Option<f64>,
}

impl Leading {
    /// Errors: another number of values than the first line gives.
    pub(super) fn fits(&self, values: usize, first: Line) -> Result<(), Fault> {
        match self.count.filter(|count| *count != values) {
            None => Ok(()),
            Some(count) => {
                Err(Fault::new(Code::RecordLength, "the first line of numbers gives another number of values")
                    .at(first.0..first.0 + first.1.len())
                    .found(format!("{values} values, {count} in the first line"))
                    .help("correct the first line, or skip it with --skip-lines and give --dt"))
            }
        }
    }
}

/// A count: digits alone, at least 2.
fn count(cell: &str) -> Option<usize> {
    let digits = cell.bytes().all(|b| b.is_ascii_digit());
    cell.parse().ok().filter(|n| digits && *n >= 2)
}

/// A time step in seconds.
fn step(cell: &str) -> Option<f64> {
    parse(cell).ok().filter(|dt| *dt > 0.0 && *dt < MILLISECONDS && count(cell).is_none())
}

/// Whether only the first number is written without a point.
fn stands_out(rows: &[Line]) -> bool {
    rows.len() > FEW && rows.iter().skip(1).all(|row| row.1.contains(['.', ',']))
}

/// Reads the first lines. A line that may as well be the first sample is one: only the number of lines that follow, or a time that
/// goes back, tells them apart.
pub(super) fn leading(rows: &[Line]) -> Leading {
    let cells = |row: usize| -> Vec<&str> {
        rows.get(row).map_or_else(Vec::new, |row| Separator::of(row.1).cells(row.1).iter().map(|c| c.1).collect())
    };
    let (first, second) = (cells(0), cells(1));
    let following = rows.len().saturating_sub(1);
    let next = second.first().and_then(|cell| parse(cell).ok());
    let found = |lines: usize, count: Option<usize>, dt: Option<f64>| Leading { lines, count, dt };
    match first.as_slice() {
        [one, two] => match (count(one).zip(step(two)), step(one).zip(count(two))) {
            // The time of the next line is before that of this one.
            (Some((n, dt)), _) if second.len() != 2 || next.is_some_and(|t| t < n as f64) => {
                found(1, Some(n), Some(dt))
            }
            (_, Some((dt, n))) if second.len() != 2 || (next.is_some_and(|t| t < dt) && n == following) => {
                found(1, Some(n), Some(dt))
            }
            _ => Leading::default(),
        },
        [one] => match (count(one), step(one), second.as_slice()) {
            (Some(n), _, [dt]) if n + 1 == following && step(dt).is_some() => found(2, Some(n), step(dt)),
            (_, Some(dt), [n]) if count(n).is_some_and(|n| n + 1 == following) => found(2, count(n), Some(dt)),
            (Some(n), _, [_]) if n == following || stands_out(rows) => found(1, Some(n), None),
            (Some(n), _, [_, _, ..]) => found(1, Some(n), None),
            (None, Some(dt), [_, _, ..]) => found(1, None, Some(dt)),
            _ => Leading::default(),
        },
        _ => Leading::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_steps_before_the_samples() {
        for (text, lines, count, dt) in [
            ("3 0.01\n0 .1\n0.01 .2\n0.02 .3", 1, Some(3), Some(0.01)),
            ("3 0.01\n.1\n.2\n.3", 1, Some(3), Some(0.01)),
            ("0.01 3\n.1\n.2\n.3", 1, Some(3), Some(0.01)),
            ("0.01, 3\n0,.1\n0.01,.2\n0.02,.3", 1, Some(3), Some(0.01)),
            ("3\n.1\n.2\n.3", 1, Some(3), None),
            ("3\n0.01\n.1\n.2\n.3", 2, Some(3), Some(0.01)),
            ("0.01\n3\n.1\n.2\n.3", 2, Some(3), Some(0.01)),
            ("0.01\n.1 .2 .3\n", 1, None, Some(0.01)),
            // Samples.
            ("2 0.01\n3 0.02\n4 0.03", 0, None, None),
            ("0.01 3\n0.02 4\n0.03 5", 0, None, None),
            ("3\n.1\n.2", 0, None, None),
            ("0.01\n.1\n.2", 0, None, None),
            (".1 .2 .3\n.4 .5 .6", 0, None, None),
        ] {
            let rows: Vec<Line> = text.lines().map(|line| (0, line)).collect();
            let found = leading(&rows);
            assert_eq!((found.lines, found.count, found.dt), (lines, count, dt), "{text}");
        }
    }
}
