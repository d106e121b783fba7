//! Values → text.

use super::tree::Place;
use super::value::Term;
use crate::units::{Dimension, in_unit, significant, unit_for};

/// The text of a formula with numbers for symbols.
pub(super) fn substitution(text: &str, symbols: &[Place], terms: &[Term]) -> String {
    let mut out = String::with_capacity(2 * text.len());
    let mut done = 0;
    for place in symbols {
        out.push_str(&text[done..place.at.start]);
        done = place.at.end;
        let symbol = &text[place.at.clone()];
        let Some(&(_, value, dimension)) = terms.iter().find(|(name, _, _)| *name == symbol) else {
            out.push_str(symbol);
            continue;
        };
        let number = with_unit(value, dimension);
        let bare = number.chars().all(|c| c.is_ascii_digit() || c == '.');
        if value < 0.0 || (place.raised && !bare) {
            out.push('(');
            out.push_str(&number);
            out.push(')');
        } else {
            out.push_str(&number);
        }
    }
    out.push_str(&text[done..]);
    out
}

/// A number with five significant digits without trailing zeros: `2.9976`, `0.25475`, `37281`, `1.83`.
pub fn number(value: f64) -> String {
    let text = significant(value, DIGITS);
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    if mantissa.contains('.') {
        format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
    } else {
        text
    }
}

/// Significant digits of the numbers put into formulas.
const DIGITS: usize = 5;

/// A value in SI as [`number`] with an engineer's unit ([`unit_for`]): `1.27 mm`, `16.3 t`, `37.281 kN`, `69 GPa`.
pub fn with_unit(value: f64, dimension: Dimension) -> String {
    let unit = unit_for(value, dimension);
    let number = number(in_unit(value, unit));
    if unit.symbol.is_empty() { number } else { format!("{number} {}", unit.symbol) }
}
