//! Units of acceleration and time in headers.

use std::fmt;

/// Unit of the numbers in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccelerationUnit {
    /// m/s²
    MetrePerSecondSquared,
    /// cm/s² (gal)
    Gal,
    /// standard gravity
    G,
}

impl AccelerationUnit {
    /// Accepted names of the units.
    pub const ALLOWED: &'static str = "g, gal, cm/s2, m/s2";

    /// Size of the unit [m/s²].
    pub fn si(self) -> f64 {
        match self {
            AccelerationUnit::MetrePerSecondSquared => 1.0,
            AccelerationUnit::Gal => 0.01,
            AccelerationUnit::G => tank::STANDARD_GRAVITY,
        }
    }

    /// Parses a unit as headers write it: `g`, `m/s2`, `m/s²`, `m/s^2`, `m_s2`, `m/s/s`, `cm/sec**2`, `gal`, ….
    pub fn parse(text: &str) -> Option<AccelerationUnit> {
        let compact: String = text
            .trim()
            .to_lowercase()
            .replace("sec", "s")
            .replace("**", "")
            .replace("s/s", "s2")
            .chars()
            .filter(|c| !matches!(c, ' ' | '^' | '_' | '/' | '*' | '·' | '.'))
            .map(|c| if c == '²' { '2' } else { c })
            .collect();
        match compact.as_str() {
            "g" | "g's" | "gs" => Some(AccelerationUnit::G),
            "ms2" | "ms-2" | "mss" => Some(AccelerationUnit::MetrePerSecondSquared),
            "cms2" | "cms-2" | "cmss" | "gal" | "gals" => Some(AccelerationUnit::Gal),
            _ => None,
        }
    }
}

impl fmt::Display for AccelerationUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            AccelerationUnit::MetrePerSecondSquared => "m/s2",
            AccelerationUnit::Gal => "gal",
            AccelerationUnit::G => "g",
        })
    }
}

/// Longest cell that can name a column [bytes].
const MAX_HEAD: usize = 200;

/// Meaning of a header cell for its column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Head {
    /// Time, with the size of its unit [s] if it is named.
    Time(Option<f64>),
    /// Acceleration, with its unit if it is named.
    Acceleration(Option<AccelerationUnit>),
    /// Velocity or displacement, by name or unit.
    OtherMotion,
    /// Unknown.
    Unknown,
}

/// Reads a cell of a header: `time_s`, `Time [s]`, `t (sec)`, `t / s`, `acceleration_m_s2`, `a [g]`, `Accel[g]`, `g`.
///
/// `a_g` and `ag` are symbols of the ground acceleration, not a unit.
pub(crate) fn head(cell: &str) -> Head {
    // A unit may follow any separator of a cell.
    if cell.len() > MAX_HEAD {
        return Head::Unknown;
    }
    let cell = cell.trim().trim_matches(['"', '\'']).trim().to_lowercase();
    if let Some((name, unit)) = bracketed(&cell) {
        return classify(name, unit).unwrap_or(Head::Unknown);
    }
    if matches!(cell.as_str(), "a_g" | "ag") {
        return Head::Acceleration(None);
    }
    // The longest unit wins: `acceleration_m_s2` is `m_s2`, not `s2`.
    let separators = cell
        .char_indices()
        .filter(|(_, c)| matches!(c, '_' | ' ' | '/' | '-' | ':'));
    for (i, c) in separators {
        let (name, unit) = (&cell[..i], &cell[i + c.len_utf8()..]);
        if let Some(found) = classify(
            name.trim(),
            unit.trim().trim_start_matches("in ").trim_matches(['(', ')', ' ']),
        ) {
            return found;
        }
    }
    classify("", &cell)
        .or_else(|| classify(&cell, ""))
        .unwrap_or(Head::Unknown)
}

/// `name [unit]` or `name (unit)`.
fn bracketed(cell: &str) -> Option<(&str, &str)> {
    let open = cell.find(['[', '('])?;
    let close = cell.rfind([']', ')']).filter(|&c| c > open)?;
    Some((cell[..open].trim(), cell[open + 1..close].trim()))
}

fn classify(name: &str, unit: &str) -> Option<Head> {
    let starts = |words: &[&str]| words.iter().any(|w| name.starts_with(w));
    let motion = starts(&["vel", "disp", "geschw", "weg"]) || matches!(name, "v" | "u" | "d");
    if motion {
        return Some(Head::OtherMotion);
    }
    if let Some(seconds) = time_unit(unit) {
        // `s` after a name of acceleration is not its unit.
        return (!starts(&["acc", "besch"])).then_some(Head::Time(Some(seconds)));
    }
    if let Some(unit) = AccelerationUnit::parse(unit) {
        return (!starts(&["time", "zeit"])).then_some(Head::Acceleration(Some(unit)));
    }
    if matches!(
        unit,
        "m/s" | "cm/s" | "mm/s" | "m_s" | "cm_s" | "m" | "cm" | "mm" | "in" | "in/s"
    ) {
        return Some(Head::OtherMotion);
    }
    if !unit.is_empty() {
        return None;
    }
    if starts(&["time", "zeit"]) || name == "t" {
        Some(Head::Time(None))
    } else if starts(&["acc", "besch"]) || name == "a" {
        Some(Head::Acceleration(None))
    } else {
        None
    }
}

fn time_unit(unit: &str) -> Option<f64> {
    match unit {
        "s" | "sec" | "secs" | "second" | "seconds" => Some(1.0),
        "ms" | "msec" => Some(1e-3),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use AccelerationUnit::{G, Gal, MetrePerSecondSquared as Si};

    #[test]
    fn units_as_written() {
        for (text, unit) in [
            ("g", G),
            ("G.", G),
            ("m/s2", Si),
            ("m/s²", Si),
            ("m/s^2", Si),
            ("m_s2", Si),
            ("M/SEC/SEC", Si),
            ("m s-2", Si),
            ("cm/s2", Gal),
            ("CM/SEC**2", Gal),
            ("cm/sec2", Gal),
            ("Gal", Gal),
        ] {
            assert_eq!(AccelerationUnit::parse(text), Some(unit), "{text}");
        }
        for text in ["", "m/s", "mm/s2", "kg", "s", "m", "grad"] {
            assert_eq!(AccelerationUnit::parse(text), None, "{text}");
        }
    }

    #[test]
    fn heads_as_written() {
        let accel = |u| Head::Acceleration(Some(u));
        for (text, expected) in [
            ("time_s", Head::Time(Some(1.0))),
            ("Time [s]", Head::Time(Some(1.0))),
            ("t (sec)", Head::Time(Some(1.0))),
            ("t / s", Head::Time(Some(1.0))),
            ("time_ms", Head::Time(Some(1e-3))),
            ("Zeit", Head::Time(None)),
            ("s", Head::Time(Some(1.0))),
            ("acceleration_m_s2", accel(Si)),
            ("a [g]", accel(G)),
            ("Accel[g]", accel(G)),
            ("acc (g)", accel(G)),
            ("acc_g", accel(G)),
            ("ground acceleration cm/s2", accel(Gal)),
            ("a/(m/s²)", accel(Si)),
            ("g", accel(G)),
            ("Acceleration in m/s2", accel(Si)),
            ("a_g", Head::Acceleration(None)),
            ("ag", Head::Acceleration(None)),
            ("a_g [m/s2]", accel(Si)),
            ("acceleration", Head::Acceleration(None)),
            ("acceleration [furlong]", Head::Unknown),
            ("velocity_m_s", Head::OtherMotion),
            ("displacement [cm]", Head::OtherMotion),
            ("v [m/s]", Head::OtherMotion),
            ("El Centro", Head::Unknown),
            ("", Head::Unknown),
        ] {
            assert_eq!(head(text), expected, "{text}");
        }
    }
}
