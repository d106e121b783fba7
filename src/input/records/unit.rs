//! Units of acceleration and of time, as headers and options write them.

use std::fmt;
use std::str::FromStr;

use super::number::parse;

/// Unit of the numbers in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationUnit {
    /// m/s²
    MetrePerSecondSquared,
    /// cm/s² (gal)
    Gal,
    /// mm/s²
    MillimetrePerSecondSquared,
    /// Standard gravity.
    G,
    /// Tenth of standard gravity, in files of the 1970s.
    TenthOfG,
    /// Hundredth of standard gravity.
    PercentOfG,
    /// Thousandth of standard gravity.
    MilliG,
    /// in/s²
    InchPerSecondSquared,
    /// ft/s²
    FootPerSecondSquared,
}

use AccelerationUnit::{
    FootPerSecondSquared, G, Gal, InchPerSecondSquared, MetrePerSecondSquared, MilliG, MillimetrePerSecondSquared,
    PercentOfG, TenthOfG,
};

/// Units with their name and their size [m/s²].
const UNITS: [(AccelerationUnit, &str, f64); 9] = [
    (G, "g", tank::STANDARD_GRAVITY),
    (PercentOfG, "%g", 0.01 * tank::STANDARD_GRAVITY),
    (MilliG, "mg", 1e-3 * tank::STANDARD_GRAVITY),
    (TenthOfG, "g/10", 0.1 * tank::STANDARD_GRAVITY),
    (MetrePerSecondSquared, "m/s2", 1.0),
    (Gal, "gal", 0.01),
    (MillimetrePerSecondSquared, "mm/s2", 1e-3),
    (InchPerSecondSquared, "in/s2", 0.0254),
    (FootPerSecondSquared, "ft/s2", 0.3048),
];

impl AccelerationUnit {
    /// Accepted names of the units.
    pub const ALLOWED: &'static str = "g, %g, mg, g/10, m/s2, gal (cm/s2), mm/s2, in/s2, ft/s2";

    fn row(self) -> (&'static str, f64) {
        let row = UNITS.iter().find(|(unit, ..)| *unit == self);
        row.map_or(("m/s2", 1.0), |(_, name, size)| (name, *size))
    }

    /// Size of the unit [m/s²].
    pub fn si(self) -> f64 {
        self.row().1
    }

    /// Parses a unit as headers write it: `g`, `% g`, `milli-g`, `m/s2`, `m/s²`, `m/s^2`, `m_s2`, `m/s/s`, `cm/sec**2`, `gal`, ….
    pub fn parse(text: &str) -> Option<AccelerationUnit> {
        let lower = text.trim().trim_matches(['(', ')', '[', ']']).to_lowercase();
        let compact: String = lower
            .replace("second", "s")
            .replace("sec", "s")
            .replace("**", "")
            .replace("s/s", "s2")
            .chars()
            .filter(|c| !matches!(c, ' ' | '^' | '_' | '/' | '*' | '·' | '.' | '-' | '−' | '⁻'))
            .map(|c| if c == '²' { '2' } else { c })
            .collect();
        Some(match compact.as_str() {
            "g" | "g's" | "gs" | "gravity" => G,
            "%g" | "g%" | "percentg" | "percentofg" | "pctg" | "gpercent" | "%ofg" => PercentOfG,
            "mg" | "millig" | "milig" => MilliG,
            // The mark of division, without which it is another unit.
            "g10" if lower.contains('/') => TenthOfG,
            "ms2" | "mss" | "mps2" | "meters2" | "metres2" => MetrePerSecondSquared,
            "cms2" | "cmss" | "cms2s" | "cmss2" | "cmps2" | "gal" | "gals" | "galileo" => Gal,
            "mms2" | "mmss" => MillimetrePerSecondSquared,
            "ins2" | "inss" | "inchs2" | "inches2" | "inchess2" => InchPerSecondSquared,
            "fts2" | "ftss" | "foots2" | "feets2" => FootPerSecondSquared,
            _ => return None,
        })
    }
}

impl fmt::Display for AccelerationUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().0)
    }
}

impl FromStr for AccelerationUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<AccelerationUnit, String> {
        AccelerationUnit::parse(text).ok_or_else(|| format!("expected one of {}", AccelerationUnit::ALLOWED))
    }
}

/// Size [s] of a unit of time.
pub(crate) fn seconds(unit: &str) -> Option<f64> {
    match unit.trim().trim_end_matches('.').to_lowercase().as_str() {
        "s" | "sec" | "secs" | "second" | "seconds" | "sek" | "sekunde" | "sekunden" | "seg" => Some(1.0),
        "ms" | "msec" | "msecs" | "millisecond" | "milliseconds" | "millisec" => Some(1e-3),
        "µs" | "μs" | "us" | "usec" | "microsecond" | "microseconds" => Some(1e-6),
        _ => None,
    }
}

/// A time step as written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    /// With its unit, in seconds.
    Seconds(f64),
    /// Without a unit.
    Bare(f64),
    /// With a unit that is not known.
    Unknown(String),
}

/// Words behind a step that are not its unit.
const OTHER_WORDS: [&str; 9] = ["npts", "file", "format", "points", "pts", "and", "units", "acceleration", "dt"];

/// The step at the beginning of a text: `.0100SEC`, `5.0 MSEC`, `200 HZ`, `.01`.
pub(crate) fn step(text: &str) -> Option<Step> {
    let text = text.trim_start();
    let end = number_end(text);
    let value = parse(text.get(..end)?.trim_end_matches(['.', ',']).trim())
        .or_else(|_| parse(text.get(..end).unwrap_or("")))
        .ok()?;
    let rest = text.get(end..)?.trim_start_matches([' ', '\t', '(', '[']);
    let stop = rest.find(|c: char| !(c.is_alphabetic() || matches!(c, '/' | 'µ'))).unwrap_or(rest.len());
    Some(with_unit(value, rest.get(..stop)?))
}

/// A step and the word behind it.
pub(crate) fn with_unit(value: f64, unit: &str) -> Step {
    let unit = unit.to_lowercase();
    if let Some(size) = seconds(&unit) {
        return Step::Seconds(value * size);
    }
    match unit.as_str() {
        "" => Step::Bare(value),
        "hz" | "hertz" | "sps" | "samples/s" | "samples/sec" | "pts/sec" | "pts/s" => Step::Seconds(1.0 / value),
        word if OTHER_WORDS.contains(&word) => Step::Bare(value),
        _ => Step::Unknown(unit),
    }
}

/// Bytes of the number at the beginning of a text.
fn number_end(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'.') {
            at += 1;
        }
        at
    };
    let sign = |at: usize| at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let end = digits(sign(0));
    if !matches!(bytes.get(end), Some(b'e' | b'E' | b'd' | b'D')) {
        return end;
    }
    let exponent = digits(sign(end + 1));
    let written = bytes.get(exponent.wrapping_sub(1)).is_some_and(u8::is_ascii_digit) && exponent > end + 1;
    if written { exponent } else { end }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_as_written() {
        for (text, unit) in [
            ("g", G),
            ("G.", G),
            ("(g)", G),
            ("% g", PercentOfG),
            ("percent of g", PercentOfG),
            ("mg", MilliG),
            ("milli-g", MilliG),
            ("G/10", TenthOfG),
            ("m/s2", MetrePerSecondSquared),
            ("m/s²", MetrePerSecondSquared),
            ("m/s^2", MetrePerSecondSquared),
            ("m_s2", MetrePerSecondSquared),
            ("M/SEC/SEC", MetrePerSecondSquared),
            ("m s-2", MetrePerSecondSquared),
            ("m·s⁻²", MetrePerSecondSquared),
            ("cm/s2", Gal),
            ("CM/SEC**2", Gal),
            ("CMS/SEC/SEC", Gal),
            ("cm/sec2", Gal),
            ("Gal", Gal),
            ("mm/s/s", MillimetrePerSecondSquared),
            ("in/sec2", InchPerSecondSquared),
            ("ft/s^2", FootPerSecondSquared),
        ] {
            assert_eq!(AccelerationUnit::parse(text), Some(unit), "{text}");
            assert_eq!(AccelerationUnit::parse(&unit.to_string()), Some(unit), "{unit}");
        }
        for text in ["", "m/s", "mm/s", "kg", "s", "m", "grad", "counts", "mgal", "g10", "km/s2"] {
            assert_eq!(AccelerationUnit::parse(text), None, "{text}");
        }
        // 1 in = 25.4 mm and 1 ft = 0.3048 m by definition; g by the third CGPM.
        assert_eq!((InchPerSecondSquared.si(), FootPerSecondSquared.si()), (0.0254, 0.3048));
        assert_eq!(MilliG.si(), 0.00980665);
    }

    #[test]
    fn steps_as_written() {
        for (text, expected) in [
            (".0100SEC", Step::Seconds(0.01)),
            (" 5.0 MSEC", Step::Seconds(0.005)),
            ("200 HZ", Step::Seconds(0.005)),
            ("1.0E-02 sec.", Step::Seconds(0.01)),
            ("5.D-3S", Step::Seconds(0.005)),
            ("0.01", Step::Bare(0.01)),
            ("0.01,", Step::Bare(0.01)),
            (".01000 , NPTS", Step::Bare(0.01)),
            ("0.01 NPTS", Step::Bare(0.01)),
            ("0.01 min", Step::Unknown("min".into())),
            ("5 MILLI", Step::Unknown("milli".into())),
        ] {
            assert_eq!(step(text), Some(expected), "{text}");
        }
        assert_eq!(step("SEC"), None);
    }
}
