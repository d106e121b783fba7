//! One compared number.

/// Kind of a reference value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A closed form or a convergent series.
    ClosedForm,
    /// A published benchmark.
    Published,
    /// A second, independent formulation of this project.
    SecondFormulation,
    /// A number printed in the dissertation.
    Dissertation,
    /// A measurement.
    Experiment,
    /// Earlier output of this program: guards against change, does not verify.
    Regression,
}

/// One compared number.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Identifier: `K4`, `S3`, `table-5.3`, …; unique together with `what`.
    pub id: String,
    /// The quantity, in words.
    pub what: String,
    /// Reference value, in `unit`.
    pub reference: f64,
    /// Where the reference comes from: author, year, equation or table.
    pub source: &'static str,
    /// Kind of the reference.
    pub kind: Reference,
    /// Computed value, in `unit`.
    pub computed: f64,
    /// Allowed deviation: relative to the reference, absolute (in `unit`) if the reference is 0. Infinite where the
    /// reference is shown for comparison only.
    pub tolerance: f64,
    /// Unit, as printed.
    pub unit: &'static str,
    /// Convergence study: (number of elements or mesh size, relative error).
    pub convergence: Vec<(f64, f64)>,
    /// What the reader is told beside the numbers; mostly empty.
    pub remark: String,
    /// The number that the dissertation prints, in `unit`, where the reference is another; the remark says why.
    pub printed: Option<f64>,
}

impl Row {
    /// A row without a convergence study: the reference with its source and kind, the tolerance with the unit.
    pub fn new(
        id: &str,
        what: impl Into<String>,
        (reference, source, kind): (f64, &'static str, Reference),
        computed: f64,
        (tolerance, unit): (f64, &'static str),
    ) -> Row {
        Row {
            id: id.to_owned(),
            what: what.into(),
            reference,
            source,
            kind,
            computed,
            tolerance,
            unit,
            convergence: Vec::new(),
            remark: String::new(),
            printed: None,
        }
    }

    /// The row with a remark.
    pub fn remarked(self, remark: impl Into<String>) -> Row {
        Row { remark: remark.into(), ..self }
    }

    /// The row with the number that the dissertation prints, and why its reference is another.
    pub fn printed(self, printed: f64, reason: impl Into<String>) -> Row {
        Row { printed: Some(printed), ..self.remarked(reason) }
    }

    /// Deviation: relative to the reference, absolute if the reference is 0.
    pub fn error(&self) -> f64 {
        if self.reference == 0.0 { self.computed } else { (self.computed - self.reference) / self.reference.abs() }
    }

    /// Whether the computed value is a number within the tolerance.
    pub fn holds(&self) -> bool {
        self.computed.is_finite() && self.error().abs() <= self.tolerance
    }

    /// One line for a failing test: the computed value and the reference.
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

/// Asserts that all rows hold, and prints them.
#[cfg(test)]
pub(crate) fn assert_held(rows: &[Row]) {
    rows.iter().for_each(|row| println!("{} {:?}", row.line(), row.convergence));
    assert!(rows.iter().all(Row::holds), "run with --nocapture");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(reference: f64, computed: f64, tolerance: f64) -> Row {
        let reference = (reference, "by hand", Reference::ClosedForm);
        Row::new("example", "example", reference, computed, (tolerance, "m"))
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
