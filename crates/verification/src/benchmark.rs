//! A benchmark and its parts.

use oscillator::record::Record;

use crate::records::EL_CENTRO;
use crate::{Answer, Pace, Records};

/// A benchmark: a page of the manual.
#[derive(Clone, Copy, Debug)]
pub struct Benchmark {
    /// Id and name of the page's file: lower-case letters, digits and hyphens.
    pub id: &'static str,
    /// Title.
    pub title: &'static str,
    /// The model in a few sentences: geometry, mesh, material, loads.
    pub model: &'static str,
    /// Ids of its rows with their meaning.
    pub ids: &'static [(&'static str, &'static str)],
    /// Functions that compute its rows, in the order of the page.
    pub parts: &'static [Part],
}

/// A function that computes rows, by the command that runs it.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    /// Takes seconds: the program and `cargo test`.
    Fast(fn() -> Answer),
    /// Takes longer: `cargo test` and the program with `--slow`.
    Tested(fn() -> Answer),
    /// Takes minutes: the program with `--slow`.
    Slow(fn() -> Answer),
    /// Takes the El Centro record of 1940 (Caltech, 0.348 g): the program with `--records`.
    Record(fn(&Record) -> Answer),
    /// Takes the records of these names: the program with `--records`.
    Records(&'static [&'static str], fn(&Records) -> Answer),
}

impl Part {
    /// Pace of its rows.
    pub fn pace(&self) -> Pace {
        match self {
            Part::Fast(_) => Pace::Fast,
            Part::Tested(_) => Pace::Tested,
            Part::Slow(_) => Pace::Slow,
            Part::Record(_) | Part::Records(..) => Pace::Record,
        }
    }

    /// Names of the records that it takes.
    pub fn records(&self) -> &'static [&'static str] {
        match self {
            Part::Record(_) => &[EL_CENTRO],
            Part::Records(names, _) => names,
            Part::Fast(_) | Part::Tested(_) | Part::Slow(_) => &[],
        }
    }
}

impl Benchmark {
    /// The paces of its parts, each once.
    pub fn paces(&self) -> Vec<Pace> {
        let mut paces: Vec<Pace> = Vec::new();
        for part in self.parts {
            if !paces.contains(&part.pace()) {
                paces.push(part.pace());
            }
        }
        paces
    }
}

#[cfg(test)]
mod tests {
    use crate::ALL;

    #[test]
    fn ids_are_names_of_files_and_unique() {
        for (i, benchmark) in ALL.iter().enumerate() {
            let name = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
            assert!(benchmark.id.chars().all(name), "{}", benchmark.id);
            assert!(ALL[..i].iter().all(|other| other.id != benchmark.id), "{}", benchmark.id);
            let described = [benchmark.title, benchmark.model].iter().all(|text| !text.is_empty());
            assert!(described && !benchmark.parts.is_empty(), "{}", benchmark.id);
        }
    }
}
