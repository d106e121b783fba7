//! Time integration, damping, modal, spectral and frequency-domain methods: rows D1 and D3 to D10;
//! with a record, C8 ([`separation()`]).

mod nonlinear;
mod schemes;
mod separation;
mod strip;

pub use nonlinear::nonlinear;
pub use schemes::schemes;
pub use separation::separation;
pub use strip::{Strip, strip};

use super::{Row, VerifyError};

/// All rows of this topic.
///
/// Errors: those of the analyses.
pub fn dynamics() -> Result<Vec<Row>, VerifyError> {
    let mut rows = schemes()?;
    rows.extend(strip()?);
    Ok(rows)
}
