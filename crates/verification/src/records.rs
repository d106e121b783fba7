//! Accelerograms that may not be redistributed, from a folder of the user.

use std::collections::BTreeMap;
use std::path::Path;

use files::code::Code;
use files::error::Error;
use oscillator::known::{self, Known};
use oscillator::record::Record;

use crate::Failure;

/// El Centro NS, 18 May 1940, Caltech version (0.348 g).
pub const EL_CENTRO: &str = "imperial-valley-1940-el-centro-ns.csv";
/// Cholame-Shandon 5 N85E, Parkfield 1966.
pub const PARKFIELD: &str = "parkfield-1966-cholame-5-n85e.csv";
/// Pacoima Dam S16E, San Fernando 1971.
pub const PACOIMA: &str = "san-fernando-1971-pacoima-dam-164.csv";
/// El Centro, component 180, of the NGA-West2 database (0.281 g).
pub const EL_CENTRO_NGA: &str = "imperial-valley-1940-el-centro-180-nga.csv";
/// What these files have to be.
const NEEDED: [(&str, Known); 4] = [
    (EL_CENTRO, known::EL_CENTRO),
    (PARKFIELD, known::PARKFIELD),
    (PACOIMA, known::PACOIMA),
    (EL_CENTRO_NGA, known::EL_CENTRO_NGA),
];
/// Columns of these files.
const HEAD: &str = "time_s,acceleration_m_s2";

/// Accelerograms as recorded, by the name of their file.
#[derive(Clone, Debug, Default)]
pub struct Records(BTreeMap<String, Record>);

impl Records {
    /// Reads these files of a folder, with the columns `time_s,acceleration_m_s2`.
    ///
    /// Errors: a file that cannot be read, is not such a table with equal steps of time, or holds another processing than its name says.
    pub fn read(folder: &Path, names: &[&str]) -> Result<Records, Error> {
        let each = |name: &&str| {
            let path = folder.join(name);
            let text = files::read_text(&path).map_err(|e| Error::unreadable(&path, &e))?;
            let record = record(name, &text).ok_or_else(|| Error::File {
                code: Code::TimeStep,
                path: path.clone(),
                what: format!("found another table, expected lines in equal steps of time under `{HEAD}`"),
            })?;
            processed(name, &path, &record)?;
            Ok(((*name).to_owned(), record))
        };
        names.iter().map(each).collect::<Result<_, Error>>().map(Records)
    }

    /// These and the files of `names` that the folder has.
    ///
    /// Errors: those of [`Records::read`].
    pub fn and(mut self, folder: &Path, names: &[&str]) -> Result<Records, Error> {
        let there: Vec<&str> = names.iter().copied().filter(|name| folder.join(name).exists()).collect();
        self.0.extend(Records::read(folder, &there)?.0);
        Ok(self)
    }

    /// The record of a file.
    ///
    /// Errors: a file that was not read.
    pub fn get(&self, file: &str) -> Result<&Record, Failure> {
        let found = self.0.get(file);
        found.ok_or_else(|| format!("the record {file} was not read").into())
    }
}

/// Errors: a record that is not the processing that the name of its file stands for.
fn processed(name: &str, path: &Path, record: &Record) -> Result<(), Error> {
    let Some((_, needed)) = NEEDED.iter().find(|(file, known)| *file == name && !known.is(record)) else {
        return Ok(());
    };
    let found = known::known(record).map_or_else(
        || format!("{} samples of {} s with a peak of {:.3} m/s²", record.acceleration.len(), record.dt, record.pga()),
        |known| known.name.to_owned(),
    );
    let what = format!("found {found}, expected {} ({} samples, {} m/s²)", needed.name, needed.samples, needed.peak);
    Err(Error::File { code: Code::NotResults, path: path.to_owned(), what })
}

/// The record of a table; lines that begin with `#` are comments.
fn record(name: &str, text: &str) -> Option<Record> {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let head: String = lines.next()?.chars().filter(|c| !c.is_whitespace()).collect();
    let mut samples = Vec::new();
    for line in lines {
        let (time, acceleration) = line.split_once(',')?;
        samples.push((time.trim().parse::<f64>().ok()?, acceleration.trim().parse::<f64>().ok()?));
    }
    let (first, last) = (samples.first()?.0, samples.last()?.0);
    // Times are printed with three decimals or so; their mean step has no more than nine.
    let dt = (1e9 * (last - first) / (samples.len() - 1) as f64).round() / 1e9;
    let even = |(i, sample): (usize, &(f64, f64))| (sample.0 - first - i as f64 * dt).abs() < 0.1 * dt;
    let sound = head == HEAD && dt > 0.0 && samples.iter().enumerate().all(even);
    sound.then(|| Record {
        name: name.trim_end_matches(".csv").to_owned(),
        dt,
        acceleration: samples.iter().map(|sample| sample.1).collect(),
        processing: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_equal_steps_is_a_record_and_no_other_is() {
        let found =
            record("a.csv", "# Caltech\ntime_s, acceleration_m_s2\n0,0\n0.02,-1.5\n0.04,2\n").expect("a record");
        assert_eq!((found.name.as_str(), found.dt), ("a", 0.02));
        assert_eq!(found.acceleration, [0.0, -1.5, 2.0]);
        let wrong = processed(EL_CENTRO, Path::new(EL_CENTRO), &found).expect_err("three samples").to_string();
        assert!(
            wrong.contains("found 3 samples of 0.02 s with a peak of 2.000 m/s²") && wrong.contains("Caltech"),
            "{wrong}"
        );
        for other in [
            "time_s,acceleration_g\n0,0\n0.02,1\n",
            "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.05,2\n",
            "time_s,acceleration_m_s2\n0,0\n0.02,x\n",
            "time_s,acceleration_m_s2\n0,0\n",
            "",
        ] {
            assert_eq!(record("a.csv", other), None, "{other}");
        }
    }
}
