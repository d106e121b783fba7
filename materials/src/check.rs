//! Ranges of parameters.

use crate::{LawError, refuse};

/// `value` > 0 and finite.
pub(crate) fn positive(law: &'static str, parameter: &'static str, value: f64, unit: &str) -> Result<f64, LawError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(refuse(law, parameter, found(value, unit), "> 0 and finite"))
    }
}

/// `low` ≤ `value` ≤ `high`.
pub(crate) fn within(
    law: &'static str,
    parameter: &'static str,
    value: f64,
    [low, high]: [f64; 2],
    unit: &str,
) -> Result<f64, LawError> {
    if value >= low && value <= high {
        Ok(value)
    } else {
        let allowed = format!("from {} to {}", low, found(high, unit));
        Err(refuse(law, parameter, found(value, unit), &allowed))
    }
}

/// `low` ≤ `value` < `high`.
pub(crate) fn below(
    law: &'static str,
    parameter: &'static str,
    value: f64,
    [low, high]: [f64; 2],
    unit: &str,
) -> Result<f64, LawError> {
    if value >= low && value < high {
        Ok(value)
    } else {
        let allowed = format!("at least {} and below {}", low, found(high, unit));
        Err(refuse(law, parameter, found(value, unit), &allowed))
    }
}

/// A value with its unit.
fn found(value: f64, unit: &str) -> String {
    if unit.is_empty() {
        value.to_string()
    } else {
        format!("{value} {unit}")
    }
}
