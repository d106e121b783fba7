//! SI → text.

use super::table::{Scale, power_of_ten};
use super::{Dimension, System, Unit};

/// The value in a unit of the same dimension.
///
/// ```
/// use tank::units::{Dimension, Unit, in_unit};
/// let mm = Unit::find("mm", Dimension::Length).unwrap();
/// assert_eq!(in_unit(0.137, mm), 137.0);
/// ```
pub fn in_unit(value: f64, unit: &Unit) -> f64 {
    match unit.scale {
        // The factor of a positive power is exact, of a negative one its reciprocal is: both round once.
        Scale::Ten(exponent) if exponent < 0 => value * power_of_ten(-exponent),
        _ => (value - unit.zero()) / unit.factor(),
    }
}

/// The usual engineering unit of this value: in SI the largest of mm, m; kg, t; Pa, kPa, MPa, GPa; N, kN, MN; … that
/// keeps the number at 1 or above (kg up to 10 t). Zero and non-finite values get the SI unit. Within a [`Scope`] of
/// US customary units, that of [`System::unit_for`].
///
/// [`Scope`]: super::Scope
pub fn unit_for(value: f64, dimension: Dimension) -> &'static Unit {
    System::current().first().unit_for(value, dimension)
}

/// [`unit_for`] in SI.
pub(super) fn si_unit_for(value: f64, dimension: Dimension) -> &'static Unit {
    let magnitude = value.abs();
    if magnitude == 0.0 || !magnitude.is_finite() {
        return dimension.si_unit();
    }
    let mut chosen = None;
    for unit in dimension.units().filter(|u| u.shown) {
        let threshold = if unit.text == "t" { 10.0 * unit.factor() } else { unit.factor() };
        if chosen.is_none() || magnitude >= threshold {
            chosen = Some(unit);
        }
    }
    chosen.unwrap_or_else(|| dimension.si_unit())
}

/// One unit for a whole table column: that of its largest absolute value.
pub fn column_unit(values: impl IntoIterator<Item = f64>, dimension: Dimension) -> &'static Unit {
    System::current().first().column_unit(values, dimension)
}

/// Prints with three significant digits and an engineer's unit: `137 mm`, `2.03 mm`, `36.7 kN·m`, `2750 kg/m³`.
///
/// Within a scope of both systems, the US customary one follows in brackets: `137 mm (5.39 in)`.
pub fn display(value: f64, dimension: Dimension) -> String {
    let first = display_in(value, unit_for(value, dimension), 3);
    match System::current().second() {
        Some(second) if second.differs(dimension) => {
            let second = display_in(value, second.unit_for(value, dimension), 3);
            format!("{first} ({second})")
        }
        _ => first,
    }
}

/// Prints in a given unit with a number of significant digits.
pub fn display_in(value: f64, unit: &Unit, digits: usize) -> String {
    let number = significant(in_unit(value, unit), digits);
    match unit.symbol {
        "" => number,
        "°" => format!("{number}°"),
        symbol => format!("{number} {symbol}"),
    }
}

/// A number with the given significant digits: the integer part is never cut, trailing zeros stay (they are
/// significant), powers of ten from 10⁷ and below 10⁻⁴. Zero is `0`; a non-finite value is `∞`, `−∞` or `not a
/// number`.
pub fn significant(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "not a number".into();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.clamp(1, 17);
    // The exponent after rounding to the given digits (9.996 with 3 digits is 10.0).
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent: i32 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    if !(-4..7).contains(&exponent) {
        return scientific;
    }
    let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::parse;
    use proptest::prelude::*;

    #[test]
    fn engineers_units() {
        use Dimension::*;
        let cases = [
            (0.137, Length, "137 mm"),
            (0.00203, Length, "2.03 mm"),
            (1.83, Length, "1.83 m"),
            (36_700.0, Moment, "36.7 kN·m"),
            (15_714.0, Mass, "15.7 t"),
            (9_714.0, Mass, "9714 kg"),
            (2750.0, Density, "2750 kg/m³"),
            (69e9, Stress, "69.0 GPa"),
            (1.58e6, Stress, "1.58 MPa"),
            (-13_590.0, Force, "-13.6 kN"),
            (4.903325, Acceleration, "4.90 m/s²"),
            (2.094, Time, "2.09 s"),
            (0.02, Dimensionless, "0.0200"),
            (0.0, Length, "0 m"),
            (999.96, Force, "1000 N"),
            (f64::INFINITY, Force, "∞ N"),
        ];
        for (value, dimension, text) in cases {
            assert_eq!(display(value, dimension), text);
        }
        assert_eq!(display_in(0.5, Unit::find("deg", Angle).unwrap(), 3), "28.6°");
    }

    #[test]
    fn one_unit_a_column() {
        let unit = column_unit([0.002, -0.9, 0.3], Dimension::Length);
        assert_eq!(unit.text, "mm");
        assert_eq!(column_unit([0.002, 1.9, f64::NAN], Dimension::Length).text, "m");
        assert_eq!(column_unit([], Dimension::Force).text, "N");
    }

    #[test]
    fn significant_digits() {
        for (value, digits, text) in [
            (9.996, 3, "10.0"),
            (0.0009996, 3, "0.00100"),
            (12345.6, 3, "12346"),
            (1.5e-5, 3, "1.50e-5"),
            (2.5e7, 3, "2.50e7"),
            (9_999_999.6, 3, "1.00e7"),
            (-0.5, 1, "-0.5"),
            (1.0, 0, "1"),
        ] {
            assert_eq!(significant(value, digits), text);
        }
    }

    proptest! {
        #[test]
        fn what_is_printed_is_read(exponent in -9.0..12.0_f64, sign in any::<bool>(), index in 0..Dimension::ALL.len()) {
            let dimension = Dimension::ALL[index];
            let value = if sign { 10_f64.powf(exponent) } else { -10_f64.powf(exponent) };
            let read = parse(&display(value, dimension), dimension).unwrap();
            // Half a unit of the third significant digit.
            prop_assert!((read - value).abs() <= 0.005 * value.abs() * (1.0 + 1e-12), "{value} {read}");
        }
    }
}
