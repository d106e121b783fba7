//! The one place that prints numbers.
//!
//! Values are stored in SI and printed with four significant digits and an engineer's unit. Within a table row or an
//! axis all values share one unit and one number of decimals ([`Scale`]), so that they can be compared by eye.

use std::cell::RefCell;
use std::collections::HashMap;

use tank::units::{Dimension, System, Unit, in_unit};

/// Narrow no-break space: groups digits.
const THIN: char = '\u{202f}';
/// No-break space: stands between number and unit.
const GAP: char = '\u{a0}';

/// Unit and decimals shared by a group of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    first: Part,
    /// The same in the system within brackets.
    second: Option<Part>,
}

/// A unit and its decimals.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    unit: &'static Unit,
    decimals: usize,
}

impl Part {
    fn of(system: System, dimension: Dimension, largest: f64) -> Part {
        let unit = system.column_unit([largest], dimension);
        Part { unit, decimals: decimals_for(in_unit(largest, unit), 4) }
    }

    fn text(&self, value: f64) -> String {
        if value == 0.0 {
            return "0".into();
        }
        fixed(in_unit(value, self.unit), self.decimals)
    }

    fn given(&self, value: f64) -> String {
        plain(in_unit(value, self.unit), self.decimals)
    }
}

/// The system within brackets, for values of this dimension.
fn second(dimension: Dimension) -> Option<System> {
    System::current().second().filter(|s| s.differs(dimension))
}

/// `a (b)`.
fn bracketed(first: String, second: Option<String>) -> String {
    match second {
        Some(second) => format!("{first} ({second})"),
        None => first,
    }
}

/// Symbols of both systems, `m (ft)`.
fn symbols(first: &'static str, second: Option<&'static str>) -> &'static str {
    thread_local! {
        // A few dozen pairs of the table of units.
        static PAIRS: RefCell<HashMap<(&'static str, &'static str), &'static str>> = RefCell::default();
    }
    let Some(second) = second else { return first };
    PAIRS.with_borrow_mut(|pairs| {
        *pairs.entry((first, second)).or_insert_with(|| Box::leak(format!("{first} ({second})").into_boxed_str()))
    })
}

impl Scale {
    /// The scale that prints the largest of `values` (SI) with four significant digits in an engineer's unit; where both
    /// systems are wanted, with the other one in brackets.
    pub fn of(dimension: Dimension, values: impl IntoIterator<Item = f64>) -> Scale {
        let largest = largest(values);
        Scale {
            first: Part::of(System::current().first(), dimension, largest),
            second: second(dimension).map(|s| Part::of(s, dimension, largest)),
        }
    }

    /// As [`Scale::of`], in the first system alone: for axes.
    pub fn single(dimension: Dimension, values: impl IntoIterator<Item = f64>) -> Scale {
        Scale { first: Part::of(System::current().first(), dimension, largest(values)), second: None }
    }

    /// As [`Scale::single`] for values up to `peak` (SI), in the unit of the largest of `all`.
    pub fn sharing(dimension: Dimension, all: impl IntoIterator<Item = f64>, peak: f64) -> Scale {
        let unit = System::current().first().column_unit(all, dimension);
        let decimals = decimals_for(in_unit(peak, unit), 4);
        Scale { first: Part { unit, decimals }, second: None }
    }

    /// Symbol of the unit, empty for a bare number.
    pub fn symbol(&self) -> &'static str {
        symbols(self.first.unit.symbol, self.second.map(|s| s.unit.symbol))
    }

    /// `value` (SI) in this unit.
    pub fn convert(&self, value: f64) -> f64 {
        in_unit(value, self.first.unit)
    }

    /// `value` (SI) as text without unit.
    pub fn text(&self, value: f64) -> String {
        bracketed(self.first.text(value), self.second.map(|s| s.text(value)))
    }

    /// `value` (SI) as text without unit and without idle zeros, for given values, not computed ones.
    pub fn given(&self, value: f64) -> String {
        bracketed(self.first.given(value), self.second.map(|s| s.given(value)))
    }
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()))
}

/// A computed value (SI) with four significant digits and its unit, `137.0 mm`.
pub fn with_unit(value: f64, dimension: Dimension) -> String {
    let of = |system| {
        let (number, symbol) = parts_in(system, value, dimension);
        joined(number, symbol)
    };
    bracketed(of(System::current().first()), second(dimension).map(of))
}

/// A given value (SI) with its unit and without idle zeros, `2.03 mm`.
pub fn given(value: f64, dimension: Dimension) -> String {
    let of = |system: System| {
        let unit = system.column_unit([value], dimension);
        let converted = in_unit(value, unit);
        // Nobody gave the digits of a converted value.
        let digits = if system == System::Si { 6 } else { 4 };
        joined(plain(converted, decimals_for(converted, digits)), unit.symbol)
    };
    bracketed(of(System::current().first()), second(dimension).map(of))
}

/// A computed value (SI) as number and unit.
pub fn parts(value: f64, dimension: Dimension) -> (String, &'static str) {
    let (number, symbol) = parts_in(System::current().first(), value, dimension);
    match second(dimension).map(|system| parts_in(system, value, dimension)) {
        Some((other, unit)) => (bracketed(number, Some(other)), symbols(symbol, Some(unit))),
        None => (number, symbol),
    }
}

fn parts_in(system: System, value: f64, dimension: Dimension) -> (String, &'static str) {
    let unit = system.column_unit([value], dimension);
    (significant(in_unit(value, unit), 4), unit.symbol)
}

fn joined(number: String, symbol: &str) -> String {
    if symbol.is_empty() { number } else { format!("{number}{GAP}{symbol}") }
}

/// `value` with this many significant digits; a power of ten below 10⁻⁴ and from 10⁷.
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    if value == 0.0 {
        return "0".into();
    }
    let exponent = exponent_of(value, digits);
    if (-4..7).contains(&exponent) {
        return fixed(value, decimals_for(value, digits));
    }
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    let mantissa = text.split_once('e').map_or(text.as_str(), |(m, _)| m);
    format!("{}·10{}", mantissa.replace('-', "−"), superscript(exponent))
}

/// A ratio to a reference, `1.05`.
pub fn ratio(value: f64) -> String {
    fixed(value, if value.abs() < 9.995 { 2 } else { 1 })
}

/// A fraction in percent, `0.5 %`, `63 %`, `128 %`; two significant digits below 10 %.
pub fn percent(fraction: f64) -> String {
    let value = 100.0 * fraction;
    if !value.is_finite() {
        return not_finite(value);
    }
    let decimals = match value.abs() {
        v if v == 0.0 || v >= 9.95 => 0,
        v if v < 1e-3 => return format!("{}{GAP}%", significant(value, 2)),
        _ => trim_decimals(value, decimals_for(value, 2)),
    };
    format!("{}{GAP}%", fixed(value, decimals))
}

/// A utilisation in percent; above 1 with as many decimals as show that it is, `100.1 %`.
pub fn utilisation(ratio: f64) -> String {
    let value = 100.0 * ratio;
    if !(value > 100.0 && value < 100.5) {
        return percent(ratio);
    }
    let decimals = (1..=9).find(|&n| (value - 100.0) * 10_f64.powi(n) >= 0.5);
    match decimals {
        Some(n) => format!("{}{GAP}%", fixed(value, n as usize)),
        None => format!("above 100{GAP}%"),
    }
}

/// A share that is rounding, 0.
pub fn share(fraction: f64) -> String {
    const ROUNDING: f64 = 1e-6;
    percent(if fraction.abs() < ROUNDING { 0.0 } else { fraction })
}

/// A whole number with grouped digits.
pub fn count(value: usize) -> String {
    group(&value.to_string())
}

/// `value` with a fixed number of decimals, a true minus sign and grouped thousands (from 10 000 on).
pub fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    let text = format!("{:.decimals$}", value.abs());
    let negative = value < 0.0 && text.chars().any(|c| ('1'..='9').contains(&c));
    let (whole, fraction) = text.split_once('.').map_or((text.as_str(), ""), |(w, f)| (w, f));
    let mut out = String::with_capacity(text.len() + 4);
    if negative {
        out.push('−');
    }
    out.push_str(&group(whole));
    if !fraction.is_empty() {
        out.push('.');
        out.push_str(fraction);
    }
    out
}

/// `value` with as many of `decimals` as it needs (ticks of axes, inputs).
pub fn plain(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

fn exponent_of(value: f64, digits: usize) -> i32 {
    // Rounding first decides the decade: 9.9996 is 10.00.
    let text = format!("{:.*e}", digits.saturating_sub(1), value.abs());
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

fn decimals_for(value: f64, digits: usize) -> usize {
    if value == 0.0 || !value.is_finite() {
        return 0;
    }
    (digits as i32 - 1 - exponent_of(value, digits)).clamp(0, 9) as usize
}

fn trim_decimals(value: f64, decimals: usize) -> usize {
    let text = format!("{value:.decimals$}");
    let idle = text.chars().rev().take_while(|&c| c == '0').count();
    decimals.saturating_sub(idle)
}

fn group(digits: &str) -> String {
    if digits.len() < 5 {
        return digits.into();
    }
    let mut out = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(THIN);
        }
        out.push(c);
    }
    out
}

fn not_finite(value: f64) -> String {
    match value {
        v if v.is_nan() => "undefined",
        v if v > 0.0 => "∞",
        _ => "−∞",
    }
    .into()
}

fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => char::from_u32('⁰' as u32 + (digit as u32 - '0' as u32)).unwrap_or(digit),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_significant_digits_and_a_true_minus() {
        for (value, text) in [
            (0.137_02, "0.1370"),
            (2.996_3, "2.996"),
            (9.999_6, "10.00"),
            (-12.345, "−12.35"),
            (16_312.0, "16\u{202f}312"),
            (0.0, "0"),
            (3.2e-7, "3.200·10⁻⁷"),
            (6.9e10, "6.900·10¹⁰"),
            (f64::INFINITY, "∞"),
            (f64::NAN, "undefined"),
        ] {
            assert_eq!(significant(value, 4), text);
        }
        assert_eq!(fixed(-0.0004, 2), "0.00");
    }

    #[test]
    fn a_scale_prints_a_row_in_one_unit_with_one_number_of_decimals() {
        let scale = Scale::of(Dimension::Moment, [15_800.0, 910.0, -3.0]);
        assert_eq!(scale.symbol(), "kN·m");
        assert_eq!(scale.text(15_800.0), "15.80");
        assert_eq!(scale.text(910.0), "0.91");
        assert_eq!(scale.text(-3.0), "0.00");
        assert_eq!(scale.text(0.0), "0");
        assert_eq!(scale.given(15_800.0), "15.8");
    }

    #[test]
    fn percentages() {
        for (value, text) in [
            (0.005, "0.5\u{a0}%"),
            (0.02, "2\u{a0}%"),
            (0.634, "63\u{a0}%"),
            (0.0123, "1.2\u{a0}%"),
            (1.28, "128\u{a0}%"),
            (0.0, "0\u{a0}%"),
            (3e-9, "3.0·10⁻⁷\u{a0}%"),
        ] {
            assert_eq!(percent(value), text);
        }
    }

    #[test]
    fn a_utilisation_above_one_shows_it() {
        for (ratio, text) in [
            (0.998, "100\u{a0}%"),
            (1.0, "100\u{a0}%"),
            (1.001, "100.1\u{a0}%"),
            (1.000_04, "100.004\u{a0}%"),
            (1.004_9, "100.5\u{a0}%"),
            (1.006, "101\u{a0}%"),
            (1.2, "120\u{a0}%"),
        ] {
            assert_eq!(utilisation(ratio), text);
        }
        assert_eq!(share(3e-12), "0\u{a0}%");
        assert_eq!(share(0.05), percent(0.05));
    }

    #[test]
    fn values_carry_an_engineers_unit() {
        assert_eq!(with_unit(0.137, Dimension::Length), "137.0\u{a0}mm");
        assert_eq!(given(0.002_03, Dimension::Length), "2.03\u{a0}mm");
        assert_eq!(given(1.525, Dimension::Length), "1.525\u{a0}m");
        assert_eq!(given(9.806_65, Dimension::Acceleration), "9.80665\u{a0}m/s²");
        assert_eq!(with_unit(16_044.0, Dimension::Mass), "16.04\u{a0}t");
        assert_eq!(with_unit(0.5, Dimension::Dimensionless), "0.5000");
    }
}
