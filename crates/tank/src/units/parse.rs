//! Text → SI.
//!
//! Decimal factors shift the exponent of the text, so `"2.03 mm"` is exactly `0.00203`, correctly rounded.

use std::collections::BTreeSet;

use super::fraction::fraction;
use super::table::{SPELLINGS, canonical};
use super::{Dimension, Unit};

/// Reason why a text is not a quantity of the expected dimension.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    /// Only blanks.
    #[error("no value")]
    Empty,
    /// The text does not begin with a decimal number, or the number continues where the unit should begin.
    #[error("`{found}` does not begin with a number")]
    NotANumber {
        /// The text.
        found: String,
        /// How to write it, if known.
        instead: Option<String>,
    },
    /// A fraction, or feet and inches with their marks (`5/16 in`, `15' 6"`).
    #[error("`{found}` is not a decimal number with a unit")]
    Fraction {
        /// The text.
        found: String,
        /// The same length as a decimal number with its unit.
        instead: String,
    },
    /// Infinite, not a number, or too large for one.
    #[error("`{found}` is not a finite number")]
    NotFinite {
        /// The text.
        found: String,
    },
    /// A bare number where a unit is needed.
    #[error("the unit is missing after `{number}`")]
    MissingUnit {
        /// The number.
        number: String,
        /// A suitable unit.
        example: &'static str,
    },
    /// Unknown unit.
    #[error("unknown unit `{unit}`")]
    UnknownUnit {
        /// The unit.
        unit: String,
        /// Nearest known unit of the expected dimension.
        nearest: Option<&'static str>,
    },
    /// A unit of another dimension.
    #[error("{}", other_dimension(.unit, .found, *.expected))]
    WrongDimension {
        /// The unit.
        unit: String,
        /// Dimensions it belongs to.
        found: Vec<Dimension>,
        /// The expected dimension.
        expected: Dimension,
    },
}

fn other_dimension(unit: &str, found: &[Dimension], expected: Dimension) -> String {
    let nouns: Vec<&str> = found.iter().map(|d| d.noun()).collect();
    match (found, expected) {
        ([Dimension::Dimensionless], expected) => format!("`{unit}` is not a unit of {}", expected.noun()),
        (_, Dimension::Dimensionless) => format!("`{unit}` is a unit of {}, expected none", nouns.join(" or ")),
        _ => format!("`{unit}` is a unit of {}, not of {}", nouns.join(" or "), expected.noun()),
    }
}

impl UnitError {
    /// How to fix it, if known.
    pub fn help(&self) -> Option<String> {
        match self {
            UnitError::NotANumber { instead, .. } => instead.as_ref().map(|i| format!("did you mean `{i}`?")),
            UnitError::Fraction { instead, .. } => Some(format!("write \"{instead}\"")),
            UnitError::MissingUnit { number, example } => Some(format!(
                "write the unit in which {number} is meant, for example \"{number} {example}\" if it is {example}"
            )),
            UnitError::UnknownUnit { nearest, .. } => nearest.map(|n| format!("did you mean `{n}`?")),
            UnitError::Empty | UnitError::NotFinite { .. } | UnitError::WrongDimension { .. } => None,
        }
    }
}

/// Reads a quantity of the given dimension and returns it in SI.
///
/// ```
/// use tank::units::{Dimension, parse};
/// assert_eq!(parse("2.03 mm", Dimension::Length), Ok(0.00203));
/// assert_eq!(parse("0.5 g", Dimension::Acceleration), Ok(4.903325));
/// assert!(parse("1.83 kg", Dimension::Length).is_err());
/// ```
/// Infinite values and NaN are rejected; the caller checks sign and magnitude.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, UnitError> {
    let trimmed = text.trim();
    if trimmed.is_empty() {
        return Err(UnitError::Empty);
    }
    let (number, rest) = split_number(trimmed);
    if number.is_empty() {
        let bare = trimmed.trim_start_matches(['+', '-']).to_ascii_lowercase();
        let word = bare.split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
        if ["nan", "inf", "infinity"].contains(&word) || bare.starts_with('∞') {
            return Err(UnitError::NotFinite { found: trimmed.into() });
        }
        return Err(UnitError::NotANumber { found: trimmed.into(), instead: None });
    }
    let spelling = rest.trim();
    // A double prime is a unit that is read.
    if Unit::find(spelling, dimension).is_none()
        && let Some(instead) = fraction(trimmed)
    {
        return Err(UnitError::Fraction { found: trimmed.into(), instead });
    }
    if let Some(instead) = misread_number(number, rest) {
        return Err(UnitError::NotANumber { found: trimmed.into(), instead });
    }
    let unit = if spelling.is_empty() {
        if dimension != Dimension::Dimensionless {
            return Err(UnitError::MissingUnit { number: number.into(), example: preferred(dimension).text });
        }
        dimension.si_unit()
    } else {
        find_or_explain(spelling, dimension)?
    };
    unit.to_si(number).ok_or_else(|| UnitError::NotFinite { found: trimmed.into() })
}

/// The leading decimal number and the rest of the text.
fn split_number(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let integer = digits(end);
    end += integer;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        if integer + fraction > 0 {
            end += 1 + fraction;
        }
    }
    if integer + fraction == 0 {
        return ("", text);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    text.split_at(end)
}

/// Decimal commas, grouped thousands, second points: the number does not end where the unit should begin.
/// `Some(None)` if it is wrong without a likely correction.
fn misread_number(number: &str, rest: &str) -> Option<Option<String>> {
    let after = rest.trim_start();
    let tail = after.strip_prefix([',', '.', '_', '\'']).unwrap_or(after).trim_start();
    if !tail.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let (more, unit) = tail.split_at(tail.bytes().take_while(u8::is_ascii_digit).count());
    let guess = match after.chars().next() {
        Some(',') if !number.contains(['.', 'e', 'E']) => Some(format!("{number}.{more}{unit}")),
        Some('_' | '\'' | '0'..='9') => Some(format!("{number}{more}{unit}")),
        _ => None,
    };
    Some(guess)
}

fn find_or_explain(spelling: &str, dimension: Dimension) -> Result<&'static Unit, UnitError> {
    if let Some(unit) = Unit::find(spelling, dimension) {
        return Ok(unit);
    }
    let wanted = canonical(spelling);
    let others = SPELLINGS.iter().filter(|s| s.text == wanted && s.unit.dimension != dimension);
    let others: BTreeSet<Dimension> = others.map(|s| s.unit.dimension).collect();
    let found: Vec<Dimension> = others.into_iter().collect();
    if found.is_empty() {
        Err(UnitError::UnknownUnit { unit: spelling.into(), nearest: nearest(spelling, dimension) })
    } else {
        Err(UnitError::WrongDimension { unit: spelling.into(), found, expected: dimension })
    }
}

/// The unit of this dimension with the nearest spelling, if one is close enough.
fn nearest(spelling: &str, dimension: Dimension) -> Option<&'static str> {
    let wanted = canonical(spelling);
    let folded = wanted.to_lowercase();
    let length = wanted.chars().count();
    SPELLINGS
        .iter()
        .filter(|s| s.unit.dimension == dimension && !s.unit.text.is_empty())
        // The distance is at least the difference of the lengths, so long texts are not compared.
        .filter(|s| s.text.chars().count().abs_diff(length) * 2 <= length)
        .map(|s| {
            let distance = strsim::osa_distance(&wanted, &s.text);
            // A difference in case only is the likeliest mistake.
            (if s.folded == folded { 0 } else { distance }, distance, s.unit)
        })
        .filter(|(slip, ..)| *slip * 2 <= length)
        .min_by_key(|(slip, distance, _)| (*slip, *distance))
        .map(|(_, _, u)| u.text)
}

/// The unit of a dimension's example.
fn preferred(dimension: Dimension) -> &'static Unit {
    let (_, rest) = split_number(dimension.example());
    Unit::find(rest, dimension).unwrap_or_else(|| dimension.si_unit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::UNITS;
    use proptest::prelude::*;

    #[test]
    fn every_unit_engineers_write() {
        use Dimension::*;
        // Conversions from NIST SP 811 (2008), appendix B.8/B.9, to its seven significant digits
        // (half a last digit is at most 5e-7).
        let cases = [
            ("1.83 m", Length, 1.83),
            ("183 cm", Length, 1.83),
            ("2.03 mm", Length, 0.00203),
            ("10 in", Length, 0.254),
            ("10 ft", Length, 3.048),
            ("500 kg", Mass, 500.0),
            ("16.3 t", Mass, 16_300.0),
            ("250 g", Mass, 0.25),
            ("1 lb", Mass, 0.453_592_4),
            ("1000 kg/m3", Density, 1000.0),
            ("1 t/m³", Density, 1000.0),
            ("0.86 g/cm3", Density, 860.0),
            ("0.86 SG", Density, 860.0),
            ("1 lb/ft3", Density, 16.018_46),
            ("69 GPa", Stress, 69e9),
            ("235 N/mm2", Stress, 235e6),
            ("2.5 kN/m2", Stress, 2500.0),
            ("1.5 bar", Stress, 150_000.0),
            ("100 Pa", Stress, 100.0),
            ("3 kPa", Stress, 3000.0),
            ("7 MPa", Stress, 7e6),
            ("1 psi", Stress, 6894.757),
            ("36 ksi", Stress, 36.0 * 6_894_757.0),
            ("9.81 m/s2", Acceleration, 9.81),
            ("341.7 cm/s^2", Acceleration, 3.417),
            ("341.7 gal", Acceleration, 3.417),
            ("0.5 g", Acceleration, 0.5 * 9.806_65),
            ("0.02 s", Time, 0.02),
            ("5 ms", Time, 0.005),
            ("12 N", Force, 12.0),
            ("12 kN", Force, 12e3),
            ("1.2 MN", Force, 1.2e6),
            ("1 lbf", Force, 4.448_222),
            ("1 kip", Force, 4448.222),
            ("35 kNm", Moment, 35e3),
            ("35 kN·m", Moment, 35e3),
            ("35 kN*m", Moment, 35e3),
            ("35 kN m", Moment, 35e3),
            ("3 MNm", Moment, 3e6),
            ("1 ft·lbf", Moment, 1.355_818),
            ("1.2 Hz", Frequency, 1.2),
            ("3 rad/s", AngularFrequency, 3.0),
            ("25 kN/m", LineForce, 25e3),
            ("25 N/m", LineForce, 25.0),
            ("1 lbf/in", LineForce, 175.126_8),
            ("400 kip/in", LineForce, 400.0 * 175_126.8),
            ("3 kNm/m", LineMoment, 3e3),
            ("0.005", Dimensionless, 0.005),
            ("0.5 %", Dimensionless, 0.005),
            ("40 deg", Angle, 0.698_131_7),
            ("1.83m", Length, 1.83),
            (" +1.83e0\u{a0}m ", Length, 1.83),
            (".5 m", Length, 0.5),
            ("5. m", Length, 5.0),
            ("3″", Length, 0.0762),
            ("7 kg / m^3", Density, 7.0),
        ];
        for (text, dimension, expected) in cases {
            let value = parse(text, dimension).unwrap_or_else(|e| panic!("{text}: {e}"));
            assert!((value - expected).abs() <= 5e-7 * expected.abs(), "{text}: {value} instead of {expected}");
        }
    }

    #[test]
    fn decimal_units_round_once() {
        assert_eq!(parse("2.03 mm", Dimension::Length), Ok(0.00203));
        assert_eq!(parse("1.27 mm", Dimension::Length), Ok(0.00127));
        assert_eq!(parse("13.4 cm", Dimension::Length), Ok(0.134));
        assert_eq!(parse("0.1 g/cm3", Dimension::Density), Ok(100.0));
        assert_eq!(parse("1.5e-3 m", Dimension::Length), Ok(0.0015));
        assert_eq!(parse("2 %", Dimension::Dimensionless), Ok(0.02));
    }

    #[test]
    fn wrong_dimension_says_what_it_is() {
        let error = parse("1.83 kg", Dimension::Length).unwrap_err();
        assert_eq!(error.to_string(), "`kg` is a unit of a mass, not of a length");
        let error = parse("5 %", Dimension::Length).unwrap_err();
        assert_eq!(error.to_string(), "`%` is not a unit of a length");
        let error = parse("5 mm", Dimension::Dimensionless).unwrap_err();
        assert_eq!(error.to_string(), "`mm` is a unit of a length, expected none");
        let error = parse("0.5 g", Dimension::Length).unwrap_err();
        assert_eq!(error.to_string(), "`g` is a unit of a mass or an acceleration, not of a length");
        assert!(Dimension::Length.allowed().starts_with("a length such as \"1.83 m\" (units: mm, cm, m, in, ft)"));
    }

    #[test]
    fn missing_and_unknown_units() {
        let error = parse("69", Dimension::Stress).unwrap_err();
        assert_eq!(error, UnitError::MissingUnit { number: "69".into(), example: "GPa" });
        assert_eq!(
            error.help().as_deref(),
            Some("write the unit in which 69 is meant, for example \"69 GPa\" if it is GPa")
        );
        for (text, dimension, near) in [
            ("69 Gpa", Dimension::Stress, Some("GPa")),
            ("69 mpa", Dimension::Stress, Some("MPa")),
            ("69 MPAs", Dimension::Stress, Some("MPa")),
            ("10 kg/m", Dimension::Density, Some("kg/m3")),
            ("10 Mm", Dimension::Length, Some("mm")),
            ("10 parsec", Dimension::Length, None),
        ] {
            match parse(text, dimension).unwrap_err() {
                UnitError::UnknownUnit { nearest, .. } => assert_eq!(nearest, near, "{text}"),
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    #[test]
    fn numbers_that_are_none() {
        for text in ["NaN m", "inf m", "-Infinity m", "nan", "∞ m", "1e999 m", "-1e400 m"] {
            assert!(matches!(parse(text, Dimension::Length), Err(UnitError::NotFinite { .. })), "{text}");
        }
        for (text, instead) in [
            ("1,83 m", Some("1.83 m")),
            ("1 000 m", Some("1000 m")),
            ("1'000 m", Some("1000 m")),
            ("1.2.3 m", None),
            // A comma after a point is ambiguous.
            ("1.234,5 m", None),
            ("1e3,5 m", None),
            ("about 2 m", None),
            ("-", None),
            (".", None),
        ] {
            match parse(text, Dimension::Length).unwrap_err() {
                UnitError::NotANumber { instead: found, .. } => assert_eq!(found.as_deref(), instead, "{text}"),
                other => panic!("{text}: {other:?}"),
            }
        }
        for (text, instead) in [
            ("5/16 in", "0.3125 in"),
            ("3/16\"", "0.1875 in"),
            ("1 1/4 in", "1.25 in"),
            ("1-1/4\"", "1.25 in"),
            ("15'", "15 ft"),
            ("15' 6\"", "186 in"),
            ("15'-6 1/2″", "186.5 in"),
            ("1/3 ft", "0.333333 ft"),
        ] {
            let error = parse(text, Dimension::Length).unwrap_err();
            assert_eq!(error.help().as_deref(), Some(format!("write \"{instead}\"").as_str()), "{text}");
        }
        // No fraction: a unit with a stroke, a division by zero, a date.
        for text in ["5 N/m", "5/0 in", "1/2/3 in", "1'2'3 m"] {
            let found = parse(text, Dimension::Length);
            assert!(!matches!(found, Err(UnitError::Fraction { .. })), "{text}: {found:?}");
        }
        assert_eq!(parse("  ", Dimension::Length), Err(UnitError::Empty));
        assert_eq!(parse("5", Dimension::Dimensionless), Ok(5.0));
        assert!(parse("5 s m", Dimension::Time).is_err());
        assert!(parse("5 m s", Dimension::Time).is_err());
    }

    #[test]
    fn no_spelling_is_ambiguous_within_a_dimension() {
        for unit in UNITS {
            for spelling in unit.spellings() {
                assert_eq!(Unit::find(spelling, unit.dimension), Some(unit), "{spelling}");
            }
        }
        for dimension in Dimension::ALL {
            assert!(parse(dimension.example(), dimension).is_ok(), "{dimension:?}");
            assert_eq!(dimension.si_unit().factor(), 1.0);
            let symbol = dimension.si_symbol().trim_matches('1');
            assert_eq!(Unit::find(symbol, dimension).unwrap_or(dimension.si_unit()), dimension.si_unit());
            assert!(symbol.is_empty() || Unit::find(symbol, dimension).is_some(), "{dimension:?}");
        }
    }

    proptest! {
        #[test]
        fn never_panics(text in "\\PC{0,24}", index in 0..Dimension::ALL.len()) {
            let _ = parse(&text, Dimension::ALL[index]);
        }

        #[test]
        fn what_is_written_is_read(value in -1e6..1e6_f64, index in 0..UNITS.len(), blank in "[ \u{a0}]{0,2}") {
            let unit = &UNITS[index];
            let read = parse(&format!("{value}{blank}{}", unit.text), unit.dimension).unwrap();
            let expected = value * unit.factor() + unit.zero();
            let size = expected.abs().max(unit.zero().abs());
            prop_assert!((read - expected).abs() <= 4.0 * f64::EPSILON * size);
        }
    }
}
