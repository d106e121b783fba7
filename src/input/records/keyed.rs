//! Files of one station: a header of lines `KEY : value`, then a table with a column for every component.

use super::block::{Line, place};
use super::draft::{Collector, printable};
use super::number::parse;
use super::separator::Separator;
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::MAX_SAMPLES;
use files::code::Code;

/// The header and the lines behind it.
pub(super) struct Keyed<'a, 't> {
    pub lines: &'t [Line<'a>],
    /// Format, for messages.
    pub what: &'static str,
}

impl<'a> Keyed<'a, '_> {
    /// The line of a key, by its beginning without regard to case, and its value.
    ///
    /// Errors: no such line.
    pub(super) fn get(&self, key: &str) -> Result<(Line<'a>, &'a str), Fault> {
        let found = self.lines.iter().find_map(|line| {
            let bare = line.1.trim_start().trim_start_matches('#');
            let is = bare.get(..key.len()).is_some_and(|k| k.eq_ignore_ascii_case(key));
            let (_, value) = is.then(|| bare.split_once(':'))??;
            Some((*line, value.trim()))
        });
        found.ok_or_else(|| {
            Fault::new(Code::CutOff, format!("the header of this {} file has no `{key}`", self.what))
                .help("the file may have been cut off")
        })
    }

    /// A positive number behind a key.
    pub(super) fn positive(&self, key: &str, value: impl Fn(&'a str) -> &'a str) -> Result<f64, Fault> {
        let (line, text) = self.get(key)?;
        let fault = || {
            Fault::new(Code::NotANumber, format!("`{key}` is not a positive number"))
                .at(place(line))
                .found(printable(text))
        };
        parse(value(text)).ok().filter(|n| *n > 0.0).ok_or_else(fault)
    }

    /// A column of the table that begins at a line, from 0; blank lines end it.
    ///
    /// * `of`: number of its columns
    /// * `samples`: how many the header says
    ///
    /// Errors: lines of other columns, cells that are not numbers, another number of samples.
    pub(super) fn column(
        &self,
        first: usize,
        (column, of): (usize, usize),
        samples: f64,
    ) -> Result<(Vec<f64>, Vec<u32>), Faults> {
        let (mut values, mut places) = (Vec::new(), Vec::new());
        let mut faults = Collector::new();
        for &(start, line) in self.lines.iter().skip(first).filter(|line| !line.1.trim().is_empty()) {
            let cells = Separator::Spaces.cells(line);
            let fault = match cells.get(column).filter(|_| cells.len() == of) {
                None => Fault::new(Code::RecordFormat, "the line does not match the header")
                    .found(format!("{} column(s)", cells.len()))
                    .allowed(format!("{of} columns")),
                Some((at, cell)) => match parse(cell) {
                    Ok(value) => {
                        values.push(value);
                        places.push((start + at) as u32);
                        continue;
                    }
                    Err(why) => Fault::new(why.code(), why.message("an acceleration")).found(*cell),
                },
            };
            if faults.push(fault.at(start..start + line.len())) {
                break;
            }
        }
        faults.finish()?;
        if values.len() as f64 != samples || values.len() > MAX_SAMPLES {
            let fault = Fault::new(
                Code::RecordLength,
                format!("another number of samples than the header of this {} file says", self.what),
            );
            let fault =
                fault.found(format!("{} samples", values.len())).allowed(format!("{samples}, at most {MAX_SAMPLES}"));
            return Err(fault.help("the file may have been cut off").into());
        }
        Ok((values, places))
    }
}
