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
        let allowed = format!("from {} to {}", digits(low), found(high, unit));
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
        let allowed = format!("at least {} and below {}", digits(low), found(high, unit));
        Err(refuse(law, parameter, found(value, unit), &allowed))
    }
}

/// A value with its unit.
pub(crate) fn found(value: f64, unit: &str) -> String {
    if unit.is_empty() { digits(value) } else { format!("{} {unit}", digits(value)) }
}

/// A number to four digits.
pub(crate) fn digits(value: f64) -> String {
    // Rust reads back its own format; NaN and infinities are unchanged.
    let rounded = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_have_four_digits() {
        for (value, text) in
            [(0.872_664_625_997_164_8, "0.8727 m"), (38e6, "38000000 m"), (2.0, "2 m"), (f64::NAN, "NaN m")]
        {
            assert_eq!(found(value, "m"), text);
        }
    }
}
