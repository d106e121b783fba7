//! A row of the manual as stored in `rows.json`.

use serde::{Deserialize, Serialize};

use crate::{Reference, Row};

/// Pace of a row: the command that computes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pace {
    /// The program and `cargo test`.
    Fast,
    /// `cargo test`, and the program with `--slow`.
    Tested,
    /// The program with `--slow` alone.
    Slow,
    /// The program with `--records` alone.
    Record,
}

impl Pace {
    /// Its word in files and tables.
    pub fn id(self) -> &'static str {
        match self {
            Pace::Fast => "fast",
            Pace::Tested => "tested",
            Pace::Slow => "slow",
            Pace::Record => "record",
        }
    }

    /// Whether `cargo test` runs it.
    pub fn is_tested(self) -> bool {
        matches!(self, Pace::Fast | Pace::Tested)
    }

    /// The command that computes the row again.
    pub fn command(self) -> &'static str {
        match self {
            Pace::Fast | Pace::Tested => "`cargo test`",
            Pace::Slow => "`verification --slow`",
            Pace::Record => "`verification --records`",
        }
    }
}

/// A row of the manual. Numbers are kept with 8 significant digits, fewer than processors differ in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// Identifier.
    pub id: String,
    /// Page of the manual: id of the benchmark.
    pub page: String,
    /// The compared quantity.
    pub what: String,
    /// Kind of the reference, in words: closed form, published, second formulation, dissertation, experiment, regression.
    pub kind: String,
    /// Where the reference comes from.
    pub source: String,
    /// Unit of the values, `1` for none.
    pub unit: String,
    /// Reference value.
    pub reference: f64,
    /// Our value; absent if it is not a number.
    pub computed: Option<f64>,
    /// Allowed deviation, relative (absolute if the reference is 0); absent if the reference is shown for comparison
    /// only.
    pub tolerance: Option<f64>,
    /// Its pace.
    pub pace: Pace,
    /// Convergence study: (number of elements or mesh size, relative error).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub convergence: Vec<(f64, f64)>,
    /// What the reader is told beside the numbers.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub remark: String,
    /// The number that the dissertation prints, where the reference is another.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub printed: Option<f64>,
}

/// Kinds of references in the order of the index, with their meaning.
pub(crate) const KINDS: [(&str, &str); 6] = [
    ("closed form", "a formula or a convergent series"),
    ("published", "numbers of a published benchmark"),
    ("second formulation", "another formulation or program of this project, written independently"),
    ("dissertation", "numbers printed in the dissertation"),
    ("experiment", "a measurement"),
    ("regression", "earlier output of this program: guards against change, does not verify"),
];

/// A kind in words.
fn title(kind: Reference) -> &'static str {
    match kind {
        Reference::ClosedForm => KINDS[0].0,
        Reference::Published => KINDS[1].0,
        Reference::SecondFormulation => KINDS[2].0,
        Reference::Dissertation => KINDS[3].0,
        Reference::Experiment => KINDS[4].0,
        Reference::Regression => KINDS[5].0,
    }
}

/// A number with 8 significant digits, `None` if it is not finite.
fn rounded(value: f64) -> Option<f64> {
    format!("{value:.7e}").parse().ok().filter(|v: &f64| v.is_finite())
}

impl Entry {
    /// A row of a page that has run.
    pub fn of(row: &Row, page: &str, pace: Pace) -> Entry {
        let finite = |(n, error): &(f64, f64)| Some((rounded(*n)?, rounded(*error)?));
        Entry {
            id: row.id.clone(),
            page: page.into(),
            what: row.what.clone(),
            kind: title(row.kind).into(),
            source: row.source.into(),
            unit: row.unit.into(),
            reference: rounded(row.reference).unwrap_or(0.0),
            computed: rounded(row.computed),
            tolerance: rounded(row.tolerance),
            pace,
            convergence: row.convergence.iter().filter_map(finite).collect(),
            remark: row.remark.clone(),
            printed: row.printed.and_then(rounded),
        }
    }

    /// Deviation: relative to the reference, absolute if the reference is 0; not a number without a value.
    pub fn error(&self) -> f64 {
        let difference = self.computed.map_or(f64::NAN, |c| c - self.reference);
        if self.reference == 0.0 { difference } else { difference / self.reference.abs() }
    }

    /// The number that the dissertation prints; none of a row that has nothing to do with it.
    pub fn of_dissertation(&self) -> Option<f64> {
        self.printed.or_else(|| (self.kind == KINDS[3].0).then_some(self.reference))
    }

    /// Whether the row is for comparison only: it has no tolerance and cannot fail.
    pub fn compares(&self) -> bool {
        self.tolerance.is_none()
    }

    /// Whether the value is within the tolerance; a row without one never is.
    pub fn holds(&self) -> bool {
        self.tolerance.is_some_and(|t| self.error().abs() <= t)
    }

    /// Whether the row has failed: outside its tolerance, or without a value.
    pub fn fails(&self) -> bool {
        self.computed.is_none() || !(self.compares() || self.holds())
    }

    /// Whether the row counts as verification: it has a tolerance and a reference of another origin.
    pub fn counts(&self) -> bool {
        self.tolerance.is_some() && self.kind != KINDS[5].0
    }

    /// Whether a fresh value is the same: within a thousandth of the tolerance, and at least 1e-6 relative, by which
    /// processors may differ.
    pub fn same_as(&self, fresh: &Entry) -> bool {
        let (Some(old), Some(new)) = (self.computed, fresh.computed) else { return self.computed == fresh.computed };
        let size = if self.reference == 0.0 { 1.0 } else { self.reference.abs() };
        // Residuals of patch tests are rounding: only their tolerance applies.
        let slack = self.tolerance.map_or(1e-3, |t| if t < 1e-5 { t } else { 1e-3 * t });
        (old - new).abs() <= size * slack.max(1e-6)
    }
}
