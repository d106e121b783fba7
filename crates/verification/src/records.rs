//! Accelerograms that may not be redistributed: the caller reads them.

use std::collections::BTreeMap;

use oscillator::record::Record;

use crate::Failure;

/// El Centro NS, 18 May 1940, Caltech version (0.348 g).
pub const EL_CENTRO: &str = "imperial-valley-1940-el-centro-ns.csv";
/// Cholame-Shandon 5 N85E, Parkfield 1966.
pub const PARKFIELD: &str = "parkfield-1966-cholame-5-n85e.csv";
/// Pacoima Dam S16E, San Fernando 1971.
pub const PACOIMA: &str = "san-fernando-1971-pacoima-dam-164.csv";

/// Accelerograms as recorded, by the name of their file.
#[derive(Clone, Debug, Default)]
pub struct Records(BTreeMap<String, Record>);

impl Records {
    /// The records that `read` gives for the names of files.
    ///
    /// Errors: those of `read`.
    pub fn read<E>(files: &[&str], read: impl Fn(&str) -> Result<Record, E>) -> Result<Records, E> {
        let each = |file: &&str| Ok(((*file).to_owned(), read(file)?));
        files.iter().map(each).collect::<Result<_, E>>().map(Records)
    }

    /// The record of a file.
    ///
    /// Errors: a file that was not read.
    pub fn get(&self, file: &str) -> Result<&Record, Failure> {
        let found = self.0.get(file);
        found.ok_or_else(|| format!("the record {file} was not read").into())
    }
}
