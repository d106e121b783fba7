//! Factors of annex E that depend on the use group and the anchorage alone.

use crate::procedure::CodeError;

/// Factor from 5 % to 0.5 % damping.
pub(super) const K: f64 = 1.5;
/// Response modification of the convective part.
pub(super) const R_WC: f64 = 2.0;

/// Importance factor of the seismic use group: 1.0, 1.25, 1.5. Errors: any other group.
pub fn importance(sug: u8) -> Result<f64, CodeError> {
    match sug {
        1 => Ok(1.0),
        2 => Ok(1.25),
        3 => Ok(1.5),
        _ => Err(CodeError::Data {
            clause: "API 650:2020 E.5.1.2 (site.api650.sug)".into(),
            reason: format!("seismic use group {sug}; allowed are 1, 2 and 3"),
        }),
    }
}

/// Response modification R_wi of the impulsive part: 4.0 mechanically anchored, 3.5 self-anchored.
pub fn response_modification(anchored: bool) -> f64 {
    if anchored { 4.0 } else { 3.5 }
}
