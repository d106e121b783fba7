//! Analyses of a model. An analysis works on matrices, loads and histories, not on tanks; only [`statics`] looks at elements,
//! to find reactions.
//!
//! ```text
//! M ẍ + C ẋ + K x = −M ι a_g(t) + p(t)          x relative to the ground
//! ```
//!
//! | module | holds |
//! |---|---|
//! | [`system`] | matrices and influence vectors of a model |
//! | [`statics`] | linear static analysis, reactions at supports |
//! | [`contact`] | statics with joints that open: active sets, augmented Lagrangian; no engine yet, benchmarks only |
//! | [`damping`] | Rayleigh, by group, modal, dashpots |
//! | [`motion`] | time steps, and ground motion or the time function of a force on them |
//! | [`observer`] | histories of scalars, extremes of everything else; [`observable`] defines the scalars |
//! | [`scheme`] | generalised-α and its special cases: Newmark, Hilber-Hughes-Taylor, trapezoidal rule |
//! | [`transient`] | direct time integration, one factor for many records, with energy balance |
//! | [`rings`] | linear systems of a wall on rings of nodes with a liquid that is not assembled |
//! | [`newton`] | one nonlinear load or time step; static load paths |
//! | [`march`] | nonlinear time histories: static start, cut steps, energy balance, observers |
//! | [`checkpoint`] | files that a long march is resumed from |
//! | [`continuation`] | static paths beyond limit points: displacement control, arc length |
//! | [`buckling`] | linear buckling about a loaded state |
//! | [`modal`] | modal superposition with missing mass |
//! | [`spectrum`] | response-spectrum method: SRSS, CQC, missing mass, components |
//! | [`frequency`] | frequency domain, to check the time domain with |
//! | [`ida`] | one model under one record at rising scales |

pub mod border;
pub mod buckling;
pub mod caughey;
pub mod checkpoint;
pub mod contact;
pub mod continuation;
pub mod damping;
pub mod frequency;
pub mod ida;
pub mod march;
pub mod modal;
pub mod motion;
pub mod newton;
pub mod observable;
pub mod observer;
pub mod rings;
pub mod scheme;
pub mod spectrum;
pub mod statics;
pub mod sweep;
pub mod system;
pub mod transient;
pub mod zone;

use crate::element::ElementError;
use crate::linalg::LinalgError;

/// Failure of an analysis.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AnalysisError {
    /// A factorisation or an eigenvalue analysis failed.
    #[error("{what}: {source}")]
    Linalg {
        /// The matrix being factored, or the system being solved.
        what: &'static str,
        /// The failure.
        source: LinalgError,
    },
    /// An element failed.
    #[error("element {number}: {source}")]
    Element {
        /// Number of the element.
        number: usize,
        /// The failure.
        source: ElementError,
    },
    /// Damping without a meaning.
    #[error(transparent)]
    Damping(#[from] damping::DampingError),
    /// A checkpoint that cannot be written or used.
    #[error(transparent)]
    Checkpoint(#[from] checkpoint::CheckpointError),
    /// A parameter out of range.
    #[error("{option}: found {found}, allowed {allowed}")]
    Option {
        /// Name of the parameter.
        option: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: String,
    },
    /// A response that is not finite.
    #[error("the response is not finite at t = {time:.4} s: {cause}")]
    NotFinite {
        /// Time [s].
        time: f64,
        /// Likely cause.
        cause: &'static str,
    },
}

/// Names the failed step of linear algebra.
pub fn failed(what: &'static str) -> impl Fn(LinalgError) -> AnalysisError {
    move |source| AnalysisError::Linalg { what, source }
}

/// Checks the length of a vector.
pub(crate) fn check_length(option: &'static str, found: usize, expected: usize) -> Result<(), AnalysisError> {
    if found == expected {
        return Ok(());
    }
    Err(AnalysisError::option(option, format!("{found} entries"), format!("{expected}, one an equation")))
}

impl AnalysisError {
    /// A parameter out of range.
    pub(crate) fn option(option: &'static str, found: impl Into<String>, allowed: impl Into<String>) -> AnalysisError {
        AnalysisError::Option { option, found: found.into(), allowed: allowed.into() }
    }
}
