//! The benchmarks of the verification manual.
//!
//! A row holds a computed value beside a reference that nobody here invented, and says of which kind the reference is.
//! Rows that need an accelerogram which may not be redistributed run where its file is given, and are listed as not run
//! elsewhere. `tests/verification` asserts every row that can run.

pub mod cases;
pub mod coupled;
pub mod manual;
pub mod response;
pub mod rigid;
pub mod rigid_rows;

use std::path::Path;

use crate::error::Error;

/// One row: a computed value beside a reference that nobody here invented.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Id of the acceptance row ("F12").
    pub id: String,
    /// What is compared.
    pub what: String,
    /// Reference value, in `unit`.
    pub reference: f64,
    /// Where the reference comes from.
    pub reference_source: String,
    /// Allowed |computed − reference| / |reference|.
    pub tolerance: f64,
    /// Computed value, in `unit`.
    pub computed: f64,
    /// Unit of both values.
    pub unit: String,
}

impl Measured {
    /// computed / reference − 1.
    pub fn error(&self) -> f64 {
        self.computed / self.reference - 1.0
    }

    /// Whether the error is within the tolerance.
    pub fn holds(&self) -> bool {
        self.error().abs() <= self.tolerance
    }
}

/// What a reference is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// Closed form or series evaluated to machine precision.
    ClosedForm,
    /// Published numbers.
    Published,
    /// An independent second formulation.
    SecondFormulation,
    /// A measurement.
    Experiment,
}

impl Reference {
    /// In words.
    pub fn title(self) -> &'static str {
        match self {
            Reference::ClosedForm => "closed form",
            Reference::Published => "published",
            Reference::SecondFormulation => "second formulation",
            Reference::Experiment => "experiment",
        }
    }
}

/// A row and the kind of its reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Kind of the reference.
    pub kind: Reference,
    /// The numbers.
    pub measured: Measured,
}

/// A row that could not run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotRun {
    /// Id of the acceptance row.
    pub id: String,
    /// What is compared.
    pub what: String,
    /// What it needs.
    pub needs: String,
}

/// All rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Manual {
    /// Rows that ran.
    pub rows: Vec<Row>,
    /// Rows that did not.
    pub not_run: Vec<NotRun>,
    /// Relative error of the first three sloshing frequencies of tank 8.1 against the closed form, by refinement.
    pub convergence: Vec<(f64, [f64; 3])>,
}

/// Computes all rows; those that need records take them from `records`.
///
/// Errors: a failure of the engine; an unreadable record.
pub fn run(records: Option<&Path>) -> Result<Manual, Error> {
    let mut manual = Manual {
        convergence: rigid_rows::convergence()?,
        ..Manual::default()
    };
    let tagged = |kind: Reference| move |measured: Measured| Row { kind, measured };
    manual
        .rows
        .extend(rigid_rows::rows()?.into_iter().map(tagged(Reference::ClosedForm)));
    manual
        .rows
        .extend(coupled::rows()?.into_iter().map(tagged(Reference::SecondFormulation)));
    manual
        .rows
        .extend(coupled::published_rows()?.into_iter().map(tagged(Reference::Published)));
    match records {
        Some(folder) => manual.rows.extend(
            response::rows(folder)?
                .into_iter()
                .map(tagged(Reference::SecondFormulation)),
        ),
        None => manual.not_run.extend(response::not_run()),
    }
    Ok(manual)
}
