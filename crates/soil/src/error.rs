//! Failures.

/// A quantity outside its range, or an iteration without end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SoilError {
    /// A value outside its range.
    #[error("{what}: found {found}, expected {expected}")]
    Value {
        /// The quantity.
        what: &'static str,
        /// Value found.
        found: f64,
        /// Range.
        expected: &'static str,
    },
    /// An iteration without convergence.
    #[error("{what} did not converge in {steps} iterations; last relative change {change:.1e}")]
    Iteration {
        /// What was sought.
        what: &'static str,
        /// Iterations done.
        steps: usize,
        /// Last relative change.
        change: f64,
    },
}

/// A value that must be finite and above 0.
pub(crate) fn positive(what: &'static str, found: f64) -> Result<(), SoilError> {
    if found.is_finite() && found > 0.0 {
        return Ok(());
    }
    let expected = "a number above 0";
    Err(SoilError::Value { what, found, expected })
}

/// A value that must be finite and at least 0.
pub(crate) fn not_negative(what: &'static str, found: f64) -> Result<(), SoilError> {
    if found.is_finite() && found >= 0.0 {
        return Ok(());
    }
    let expected = "a number from 0";
    Err(SoilError::Value { what, found, expected })
}
