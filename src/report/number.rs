//! The one place that prints numbers.
//!
//! Values are stored in SI and printed with four significant digits and an engineer's unit. Within a table row or an
//! axis all values share one unit and one number of decimals ([`Scale`]), so that they can be compared by eye.

use codes::units::Dimension;

/// Narrow no-break space: groups digits, and stands between number and unit.
const THIN: char = '\u{202f}';

/// Unit and decimals shared by a group of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    factor: f64,
    symbol: &'static str,
    decimals: usize,
}

impl Scale {
    /// The scale that prints the largest of `values` (SI) with four significant digits.
    pub fn of(dimension: Dimension, values: impl IntoIterator<Item = f64>) -> Scale {
        let largest = values
            .into_iter()
            .filter(|v| v.is_finite())
            .fold(0.0_f64, |m, v| m.max(v.abs()));
        let (factor, symbol) = engineering_unit(dimension, largest);
        Scale {
            factor,
            symbol,
            decimals: decimals_for(largest / factor, 4),
        }
    }

    /// Symbol of the unit, empty for a bare number.
    pub fn symbol(&self) -> &'static str {
        self.symbol
    }

    /// `value` (SI) in this unit.
    pub fn convert(&self, value: f64) -> f64 {
        value / self.factor
    }

    /// `value` (SI) as text without unit.
    pub fn text(&self, value: f64) -> String {
        fixed(value / self.factor, self.decimals)
    }
}

/// A value (SI) with four significant digits and its unit, `13.70 mm`.
pub fn with_unit(value: f64, dimension: Dimension) -> String {
    let (number, symbol) = parts(value, dimension);
    if symbol.is_empty() {
        number
    } else {
        format!("{number}{THIN}{symbol}")
    }
}

/// A value (SI) as number and unit.
pub fn parts(value: f64, dimension: Dimension) -> (String, &'static str) {
    let (factor, symbol) = engineering_unit(dimension, value.abs());
    (significant(value / factor, 4), symbol)
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
        v if v < 1e-3 => return format!("{}{THIN}%", significant(value, 2)),
        _ => trim_decimals(value, decimals_for(value, 2)),
    };
    format!("{}{THIN}%", fixed(value, decimals))
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
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

/// The engineer's unit for values of about this size: its size in SI and its symbol.
pub fn engineering_unit(dimension: Dimension, size: f64) -> (f64, &'static str) {
    let zero = size == 0.0;
    match dimension {
        Dimension::Length if size < 0.1 && !zero => (1e-3, "mm"),
        Dimension::Length => (1.0, "m"),
        Dimension::Mass if size >= 1e3 => (1e3, "t"),
        Dimension::Mass => (1.0, "kg"),
        Dimension::Density => (1.0, "kg/m³"),
        Dimension::Acceleration => (1.0, "m/s²"),
        Dimension::Force if size >= 1e6 => (1e6, "MN"),
        Dimension::Force if size >= 100.0 || zero => (1e3, "kN"),
        Dimension::Moment if size >= 1e6 => (1e6, "MNm"),
        Dimension::Moment if size >= 100.0 || zero => (1e3, "kNm"),
        Dimension::Moment => (1.0, "Nm"),
        Dimension::Stress if size >= 1e10 => (1e9, "GPa"),
        Dimension::Stress if size >= 1e5 || zero => (1e6, "MPa"),
        Dimension::Stress => (1e3, "kPa"),
        Dimension::LineForce if size >= 100.0 || zero => (1e3, "kN/m"),
        Dimension::LineMoment if size >= 100.0 || zero => (1e3, "kNm/m"),
        Dimension::LineMoment => (1.0, "Nm/m"),
        Dimension::Energy if size >= 100.0 || zero => (1e3, "kJ"),
        Dimension::Dimensionless => (1.0, ""),
        other => (1.0, other.si_symbol()),
    }
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
        assert_eq!(scale.symbol(), "kNm");
        assert_eq!(scale.text(15_800.0), "15.80");
        assert_eq!(scale.text(910.0), "0.91");
        assert_eq!(scale.text(-3.0), "0.00");
    }

    #[test]
    fn percentages() {
        for (value, text) in [
            (0.005, "0.5\u{202f}%"),
            (0.02, "2\u{202f}%"),
            (0.634, "63\u{202f}%"),
            (0.0123, "1.2\u{202f}%"),
            (1.28, "128\u{202f}%"),
            (0.0, "0\u{202f}%"),
            (3e-9, "3.0·10⁻⁷\u{202f}%"),
        ] {
            assert_eq!(percent(value), text);
        }
    }

    #[test]
    fn values_carry_an_engineers_unit() {
        assert_eq!(with_unit(0.002_03, Dimension::Length), "2.030\u{202f}mm");
        assert_eq!(with_unit(1.525, Dimension::Length), "1.525\u{202f}m");
        assert_eq!(with_unit(16_044.0, Dimension::Mass), "16.04\u{202f}t");
        assert_eq!(with_unit(69e9, Dimension::Stress), "69.00\u{202f}GPa");
        assert_eq!(with_unit(0.5, Dimension::Dimensionless), "0.5000");
    }
}
