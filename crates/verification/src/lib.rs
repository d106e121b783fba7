//! Verification: models whose answers are known from elsewhere, as functions that return rows of numbers.
//!
//! One module a topic. The tests assert that every row holds, the verification manual prints them. A row says what the
//! reference *is*: one that only repeats our own earlier output is a [`Reference::Regression`] and verifies nothing.

use fem::analysis::AnalysisError;
use fem::element::ElementError;
use fem::linalg::LinalgError;
use fem::mesh::MeshError;
use fem::model::ModelError;

pub mod dynamics;
pub mod fluid;
pub mod materials;
pub mod moreau;
pub mod potential;
pub mod shell;
pub mod solid;
pub mod strip;

/// A model that could not be made or solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum VerifyError {
    /// Of a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Of an element.
    #[error(transparent)]
    Element(#[from] ElementError),
    /// Of a model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Of a factorisation or an eigenvalue solver.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
    /// Of an analysis.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// Of a stress law.
    #[error(transparent)]
    Law(#[from] ::materials::LawError),
    /// A mode that was looked for is not among those computed.
    #[error("{what} is not among the {found} modes computed")]
    Mode {
        /// What was looked for.
        what: String,
        /// Number of modes computed.
        found: usize,
    },
}

/// What a reference value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A closed form or a convergent series.
    ClosedForm,
    /// A published benchmark.
    Published,
    /// A second, independent formulation of ours.
    SecondFormulation,
    /// A number printed in the dissertation.
    Dissertation,
    /// A measurement.
    Experiment,
    /// Our own earlier output: guards against change, verifies nothing.
    Regression,
}

/// One compared number.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Identifier: `K4`, `S3`, `table-5.3`, …; unique together with `what`.
    pub id: String,
    /// Page of the verification manual that shows the row; rows of one benchmark share it.
    pub page: &'static str,
    /// The quantity, in words.
    pub what: String,
    /// Reference value, in `unit`.
    pub reference: f64,
    /// Where the reference comes from: author, year, equation or table.
    pub source: &'static str,
    /// What the reference is.
    pub kind: Reference,
    /// Our value, in `unit`.
    pub computed: f64,
    /// Allowed deviation: relative to the reference, absolute (in `unit`) if the reference is 0. Infinite where the
    /// reference is shown for comparison only.
    pub tolerance: f64,
    /// Unit, as printed.
    pub unit: &'static str,
    /// Convergence study: (number of elements or mesh size, relative error).
    pub convergence: Vec<(f64, f64)>,
}

impl Row {
    /// Deviation: relative to the reference, absolute if the reference is 0.
    pub fn error(&self) -> f64 {
        if self.reference == 0.0 {
            self.computed
        } else {
            (self.computed - self.reference) / self.reference.abs()
        }
    }

    /// Whether the computed value is a number within the tolerance.
    pub fn holds(&self) -> bool {
        self.computed.is_finite() && self.error().abs() <= self.tolerance
    }

    /// One line for a failing test: what was found, what was expected.
    pub fn line(&self) -> String {
        format!(
            "{} {}: {:.6} {}, reference {:.6} ({}), error {:.2e}, allowed {:.1e}",
            self.id,
            self.what,
            self.computed,
            self.unit,
            self.reference,
            self.source,
            self.error(),
            self.tolerance
        )
    }
}

/// El Centro NS scaled to 0.348 g: the version of the dissertation from the folder `TANKCHECK_RECORDS`, if set, else the textbook
/// version that comes with the examples.
#[cfg(test)]
pub(crate) fn test_record() -> oscillator::record::Record {
    let path = match std::env::var("TANKCHECK_RECORDS") {
        Ok(folder) => format!("{folder}/imperial-valley-1940-el-centro-ns.csv"),
        Err(_) => concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/records/elcentro.csv").to_owned(),
    };
    let text = std::fs::read_to_string(path).unwrap();
    let pairs: Vec<[f64; 2]> = text
        .lines()
        .filter_map(|line| {
            let mut numbers = line.split(',').map(|c| c.trim().parse::<f64>());
            match (numbers.next(), numbers.next()) {
                (Some(Ok(t)), Some(Ok(a))) => Some([t, a]),
                _ => None,
            }
        })
        .collect();
    let peak = pairs.iter().fold(0.0, |m: f64, p| m.max(p[1].abs()));
    oscillator::record::Record {
        name: "El Centro".into(),
        dt: pairs[1][0] - pairs[0][0],
        acceleration: pairs.iter().map(|p| p[1] / peak * 0.348 * 9.81).collect(),
        processing: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(reference: f64, computed: f64, tolerance: f64) -> Row {
        Row {
            id: "example".to_owned(),
            page: "example",
            what: "example".to_owned(),
            reference,
            source: "by hand",
            kind: Reference::ClosedForm,
            computed,
            tolerance,
            unit: "m",
            convergence: Vec::new(),
        }
    }

    #[test]
    fn tolerance_is_relative_unless_the_reference_is_zero() {
        assert!(row(-200.0, -201.0, 0.006).holds());
        assert!(!row(-200.0, -201.0, 0.004).holds());
        assert!(row(0.0, 1e-9, 1e-8).holds());
        assert!(!row(0.0, 1e-7, 1e-8).holds());
        assert!(!row(1.0, f64::NAN, f64::INFINITY).holds());
    }
}
