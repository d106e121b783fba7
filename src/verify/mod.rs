//! The benchmarks of the verification manual.
//!
//! A row holds a computed value beside a reference that nobody here invented, and says of which kind the reference is;
//! one that only repeats our own earlier output is a regression and verifies nothing. Rows of the element library come
//! from [`verification`], those of whole tanks from here. Rows that need an accelerogram which may not be redistributed
//! run where its file is given; those too slow for every day run with `--slow`, and the manual keeps their last result.
//!
//! ```text
//! topics ─ Row ─ Entry ─ rows.json ─ pages (Markdown + SVG), HTML, table
//! ```
//!
//! The pages are a function of `rows.json` alone ([`manual`]).

pub mod coupled;
pub mod dissertation;
pub mod entry;
pub mod html;
pub mod manual;
pub mod pages;
pub mod response;
pub mod rigid;
pub mod rigid_rows;
pub mod solid;

use std::path::Path;

pub use entry::{Entry, Pace};
pub use verification::{Reference, Row};

use crate::error::Error;

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
    pub rows: Vec<Entry>,
    /// Rows that did not.
    pub not_run: Vec<NotRun>,
}

/// A topic: its name, a function that gives its rows or its failure in words, and who runs it.
type Topic = (&'static str, fn() -> Result<Vec<Row>, String>, Pace);

/// All topics; [`Pace::Fast`] and [`Pace::Tested`] ones are asserted by `cargo test`.
const TOPICS: &[Topic] = &[
    (
        "liquid in a rigid tank",
        || rigid_rows::rows().map_err(words),
        Pace::Fast,
    ),
    ("coupled modes", || coupled::rows().map_err(words), Pace::Fast),
    (
        "published coupled modes",
        || coupled::published_rows().map_err(words),
        Pace::Fast,
    ),
    (
        "three-dimensional engine, coarse",
        || solid::rows().map_err(words),
        Pace::Fast,
    ),
    ("shell", || verification::shell::shell().map_err(words), Pace::Fast),
    (
        "stress laws",
        || verification::materials::materials().map_err(words),
        Pace::Fast,
    ),
    (
        "solid, joint, layered wall",
        || verification::solid::solid().map_err(words),
        Pace::Fast,
    ),
    (
        "potential liquid on hexahedra",
        || verification::potential::potential().map_err(words),
        Pace::Fast,
    ),
    (
        "displacement liquid",
        || verification::fluid::fluid().map_err(words),
        Pace::Fast,
    ),
    (
        "dynamics",
        || verification::dynamics::dynamics().map_err(words),
        Pace::Fast,
    ),
    ("strip", || verification::strip::strip().map_err(words), Pace::Fast),
    (
        "three-dimensional engine",
        || solid::slow_rows().map_err(words),
        Pace::Slow,
    ),
    ("shell", || verification::shell::shell_slow().map_err(words), Pace::Slow),
    (
        "shell, large displacements",
        || verification::shell::shell_large().map_err(words),
        Pace::Tested,
    ),
    (
        "shell, large displacements on fine meshes",
        || verification::shell::shell_large_slow().map_err(words),
        Pace::Slow,
    ),
    (
        "reinforced-concrete beams",
        || verification::shell::concrete_beams().map_err(words),
        Pace::Tested,
    ),
    (
        "nonlinear histories",
        || verification::dynamics::nonlinear().map_err(words),
        Pace::Tested,
    ),
    (
        "potential liquid on hexahedra",
        || verification::potential::potential_slow().map_err(words),
        Pace::Slow,
    ),
];

fn words(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// What to run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice<'a> {
    /// Folder with accelerograms.
    pub records: Option<&'a Path>,
    /// Whether the slow topics run.
    pub slow: bool,
}

/// Number of topics that [`run`] begins.
pub fn topics(choice: Choice) -> u64 {
    let records = if choice.records.is_some() { 2 } else { 0 };
    (chosen(choice).count() + records) as u64
}

/// The topics that run without a record.
fn chosen(choice: Choice) -> impl Iterator<Item = &'static Topic> {
    TOPICS.iter().filter(move |t| choice.slow || t.2 == Pace::Fast)
}

/// Computes the chosen rows; `begin` hears the name of each topic before it runs.
///
/// Errors: a failure of an engine; an unreadable record.
pub fn run(choice: Choice, begin: &dyn Fn(&str)) -> Result<Manual, Error> {
    let mut manual = Manual::default();
    for &(name, rows, pace) in chosen(choice) {
        begin(name);
        let rows = rows().map_err(|what| Error::Verification {
            topic: name.into(),
            what,
        })?;
        manual.rows.extend(rows.iter().map(|row| Entry::of(row, pace)));
    }
    match choice.records {
        Some(folder) => {
            begin("responses");
            let mut rows = response::rows(folder)?;
            begin("strip under a record");
            rows.extend(response::strip_rows(folder)?);
            manual.rows.extend(rows.iter().map(|row| Entry::of(row, Pace::Record)));
        }
        None => manual.not_run = response::not_run(),
    }
    Ok(manual)
}
