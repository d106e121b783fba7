//! Failures of a strip.

use fem::analysis::AnalysisError;
use fem::strip::StripError;

use crate::FeError;

/// An error of the strip as one of the engine.
pub(super) fn failed(error: impl Into<StripError>) -> FeError {
    match error.into() {
        StripError::Analysis(AnalysisError::Checkpoint(fault)) => FeError::Checkpoint(fault),
        other => FeError::Analysis(other.to_string()),
    }
}
