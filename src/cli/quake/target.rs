//! The spectrum that records are compared with: that of a tank's site, or a table.

use std::path::Path;

use codes::record_set::standard::Standard;
use tank::case::Site;
use tank::hazard::SpectrumTable;

use crate::cli::inputs::Reading;
use crate::error::Error;
use crate::input::{self, TankFile, target};
use crate::study::rule;

/// A target spectrum.
pub(super) enum Target {
    Tank(Box<TankFile>),
    Table(SpectrumTable),
}

impl Target {
    /// Reads a CSV table (by its extension) or a tank file.
    ///
    /// Errors: those of the readers.
    pub(super) fn read(path: &Path, reading: &Reading) -> Result<Target, Error> {
        let end = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        if matches!(end.as_deref(), Some("csv" | "txt")) {
            return Ok(Target::Table(target::read(path, reading.options().unit)?));
        }
        Ok(Target::Tank(Box::new(input::read_tank(path)?)))
    }

    /// Longest period that it covers [s].
    pub(super) fn longest(&self) -> f64 {
        match self {
            Target::Table(table) => table.longest(),
            Target::Tank(tank) => rule::longest(&tank.case.site),
        }
    }

    /// The elastic spectrum at a damping.
    ///
    /// Errors: a tank without the site of EN 1998.
    pub(super) fn curve(&self, damping: f64) -> Result<rule::Curve, Error> {
        match self {
            Target::Table(table) => {
                let table = table.clone();
                // Beyond the last row nothing is asked.
                Ok(Box::new(move |period| table.at(period).unwrap_or(f64::NAN)))
            }
            Target::Tank(tank) => rule::elastic(&tank.case.site, Standard::En1998, damping),
        }
    }

    /// The table, where it is one.
    pub(super) fn table(&self) -> Option<&SpectrumTable> {
        match self {
            Target::Table(table) => Some(table),
            Target::Tank(_) => None,
        }
    }

    /// The site, of a tank.
    pub(super) fn site(&self) -> Option<&Site> {
        match self {
            Target::Table(_) => None,
            Target::Tank(tank) => Some(&tank.case.site),
        }
    }
}
