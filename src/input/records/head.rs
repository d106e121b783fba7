//! What a cell of a header says of its column.

use super::unit::{AccelerationUnit, seconds};

/// Longest cell that can name a column [bytes].
const MAX_HEAD: usize = 200;

/// Meaning of a header cell for its column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Head {
    /// Time, with the size of its unit [s] if it is named.
    Time(Option<f64>),
    /// Acceleration, with its unit if it is named.
    Acceleration(Option<AccelerationUnit>),
    /// A component such as `N-S`, with its unit if it is named.
    Component(Option<AccelerationUnit>),
    /// Velocity or displacement, by name or unit.
    OtherMotion,
    /// Time or acceleration in a unit that is not known.
    UnknownUnit(String),
    /// Unknown.
    Unknown,
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Name {
    None,
    Time,
    Acceleration,
    Component,
    Motion,
    /// A peak, a range, a number: metadata, never a column.
    Fact,
    Other,
}

/// What a unit measures.
enum Unit {
    Time(f64),
    Acceleration(AccelerationUnit),
    Motion,
}

impl Unit {
    fn of(text: &str) -> Option<Unit> {
        if let Some(size) = seconds(text) {
            return Some(Unit::Time(size));
        }
        if let Some(unit) = AccelerationUnit::parse(text) {
            return Some(Unit::Acceleration(unit));
        }
        let compact = text.replace([' ', '_'], "/").replace("sec", "s");
        let motion = ["m/s", "cm/s", "mm/s", "in/s", "ft/s", "m", "cm", "mm", "in", "ft"].contains(&compact.as_str());
        motion.then_some(Unit::Motion)
    }
}

impl Head {
    /// Whether the cell alone tells that its line is a header: a name and not only a letter or a unit.
    pub(crate) fn is_named(&self, cell: &str) -> bool {
        match self {
            Head::Time(_) | Head::Acceleration(Some(_)) => {
                name_of(&folded(cell)) != Name::None && folded(cell).len() > 1
            }
            Head::UnknownUnit(_) => true,
            _ => false,
        }
    }

    /// Whether the cell names an acceleration in words.
    pub(crate) fn is_acceleration(cell: &str) -> bool {
        matches!(name_of(before_unit(&folded(cell))), Name::Acceleration)
    }

    /// Whether the cell names a motion in words.
    pub(crate) fn is_motion(cell: &str) -> bool {
        matches!(name_of(before_unit(&folded(cell))), Name::Motion)
    }
}

fn folded(cell: &str) -> String {
    cell.trim().trim_matches(['"', '\'']).trim().to_lowercase()
}

/// The part before a bracket.
fn before_unit(cell: &str) -> &str {
    cell.split(['[', '(']).next().unwrap_or_default()
}

/// Reads a cell of a header: `time_s`, `Time [s]`, `t (sec)`, `t / s`, `acceleration_m_s2`, `a [g]`, `Accel[g]`, `g`, `N-S`.
///
/// `a_g` and `ag` are symbols of the ground acceleration, not a unit.
pub(crate) fn head(cell: &str) -> Head {
    if cell.len() > MAX_HEAD {
        return Head::Unknown;
    }
    let cell = folded(cell);
    if let Some((name, unit)) = bracketed(&cell) {
        return with_bracket(name, unit);
    }
    match name_of(&cell) {
        // The symbols a_g and ag are no unit.
        Name::Acceleration if matches!(cell.as_str(), "a_g" | "ag") => return Head::Acceleration(None),
        Name::Component => return Head::Component(None),
        Name::Fact => return Head::Unknown,
        _ => {}
    }
    match Unit::of(&cell) {
        Some(Unit::Time(size)) => return Head::Time(Some(size)),
        Some(Unit::Acceleration(unit)) => return Head::Acceleration(Some(unit)),
        _ => {}
    }
    // The longest unit wins: `acceleration_m_s2` is `m_s2`, not `s2`.
    let separators = cell.char_indices().filter(|(_, c)| matches!(c, '_' | ' ' | '/' | '-' | ':' | ','));
    for (i, c) in separators {
        let (name, unit) = (cell[..i].trim(), cell[i + c.len_utf8()..].trim());
        let unit = unit.strip_prefix("in ").unwrap_or(unit).trim();
        let known = Unit::of(unit);
        match (name_of(name), known) {
            (Name::Time, Some(Unit::Time(size))) => return Head::Time(Some(size)),
            (Name::Acceleration, Some(Unit::Acceleration(unit))) => return Head::Acceleration(Some(unit)),
            (Name::Component, Some(Unit::Acceleration(unit))) => return Head::Component(Some(unit)),
            (Name::Motion, _) | (Name::Component, Some(Unit::Motion)) => return Head::OtherMotion,
            (Name::Acceleration, Some(Unit::Motion | Unit::Time(_))) | (Name::Time, Some(_)) => {
                return Head::UnknownUnit(unit.into());
            }
            _ => {}
        }
    }
    match name_of(&cell) {
        Name::Motion => Head::OtherMotion,
        name @ (Name::Time | Name::Acceleration) => match (left_over(&cell), name) {
            (Some(unit), _) => Head::UnknownUnit(unit),
            (None, Name::Time) => Head::Time(None),
            (None, _) => Head::Acceleration(None),
        },
        _ => Head::Unknown,
    }
}

/// What may be a unit behind a name: one word, or words with a mark of units; other words only say more of the column.
fn left_over(cell: &str) -> Option<String> {
    let rest: Vec<&str> = cell.split([' ', '_']).skip(1).filter(|word| !is_plain_word(word)).collect();
    let marked = rest.iter().any(|word| word.contains(['/', '^', '²', '%', '*']));
    (rest.len() == 1 || marked).then(|| rest.join(" "))
}

fn with_bracket(name: &str, unit: &str) -> Head {
    let kind = name_of(name);
    match (kind, Unit::of(unit)) {
        (Name::Fact, _) => Head::Unknown,
        (Name::Motion, _) => Head::OtherMotion,
        (Name::Time, Some(Unit::Time(size))) | (Name::None | Name::Other, Some(Unit::Time(size))) => {
            Head::Time(Some(size))
        }
        (Name::Component, Some(Unit::Acceleration(unit))) => Head::Component(Some(unit)),
        (Name::Acceleration | Name::None | Name::Other, Some(Unit::Acceleration(unit))) => {
            Head::Acceleration(Some(unit))
        }
        (Name::Component | Name::None | Name::Other, Some(Unit::Motion)) => Head::OtherMotion,
        (Name::Acceleration, None) if unit.split([' ', ',', '_']).all(is_plain_word) => Head::Acceleration(None),
        (Name::Component, None) if unit.split([' ', ',', '_']).all(is_plain_word) => Head::Component(None),
        (Name::Time, None) if unit.is_empty() => Head::Time(None),
        (Name::Time | Name::Acceleration | Name::Component, _) => Head::UnknownUnit(unit.into()),
        (Name::None | Name::Other, None) => Head::Unknown,
    }
}

/// `name [unit]` or `name (unit)`; a bracket within the unit belongs to it.
fn bracketed(cell: &str) -> Option<(&str, &str)> {
    let close = cell.rfind([']', ')'])?;
    // The last bracket, `a(t) (g)`, where it holds a unit.
    let within = |open: &usize| *open < close && Unit::of(cell[open + 1..close].trim()).is_some();
    let open = cell.rfind(['[', '(']).filter(within).or_else(|| cell.find(['[', '(']).filter(|open| *open < close))?;
    let name = cell[..open].trim().trim_end_matches(['/', ',', '_', ':']);
    let unit = cell[open + 1..close].trim();
    // `a/(m/s²)` and `acc. in [g]`.
    Some((name.strip_suffix(" in").unwrap_or(name).trim(), unit))
}

const TIME: [&str; 6] = ["time", "zeit", "temps", "tiempo", "tempo", "zaman"];
const ACCELERATION: [&str; 5] = ["acc", "besch", "acel", "ivme", "bodenbeschl"];
const MOTION: [&str; 8] = ["vel", "disp", "geschw", "weg", "despl", "depl", "vitesse", "versch"];
/// Words of spectra, whose columns are not those of a record.
const SPECTRUM: [&str; 11] =
    ["period", "frequency", "freq", "sa", "psa", "sd", "sv", "psv", "spectral", "spectrum", "hz"];
/// Words of values that are not columns.
const FACTS: [&str; 17] = [
    "peak",
    "pga",
    "pgv",
    "pgd",
    "max",
    "maximum",
    "min",
    "minimum",
    "rms",
    "scale",
    "scaled",
    "factor",
    "range",
    "threshold",
    "trigger",
    "sensitivity",
    "resolution",
];

fn name_of(name: &str) -> Name {
    let words: Vec<&str> = name.split(|c: char| !(c.is_alphanumeric() || c == '.')).filter(|w| !w.is_empty()).collect();
    let Some(first) = words.first() else { return Name::None };
    let starts = |word: &str, list: &[&str]| list.iter().any(|w| word.starts_with(w));
    if starts(first, &TIME) || name == "t" {
        return Name::Time;
    }
    if words.iter().any(|w| FACTS.contains(w) || (w.contains('.') && w.parse::<f64>().is_ok())) {
        return Name::Fact;
    }
    if is_component(name) {
        return Name::Component;
    }
    if words.iter().any(|w| SPECTRUM.contains(w)) {
        return Name::Motion;
    }
    if words.iter().any(|w| starts(w, &ACCELERATION))
        || matches!(name, "a" | "ag" | "a_g" | "ax" | "ay" | "az" | "a(t)")
    {
        return Name::Acceleration;
    }
    if starts(first, &MOTION) {
        return Name::Motion;
    }
    Name::Other
}

/// `N-S`, `ew`, `UP`, `V`, `N00E`, `HNE`, `Chan 2`, `comp1`.
fn is_component(name: &str) -> bool {
    let compact: String = name.chars().filter(|c| c.is_alphanumeric()).collect();
    const NAMES: [&str; 32] = [
        "ns",
        "sn",
        "ew",
        "we",
        "ud",
        "du",
        "n",
        "e",
        "z",
        "x",
        "y",
        "v",
        "u",
        "d",
        "h",
        "l",
        "h1",
        "h2",
        "north",
        "south",
        "east",
        "west",
        "up",
        "down",
        "vert",
        "vertical",
        "horizontal",
        "long",
        "longitudinal",
        "tran",
        "trans",
        "transverse",
    ];
    let numbered = ["chan", "channel", "canal", "ch", "comp", "component", "komponente"].iter().any(|word| {
        let rest = compact.strip_prefix(word);
        rest.is_some_and(|rest| rest.is_empty() || NAMES.contains(&rest) || rest.bytes().all(|b| b.is_ascii_digit()))
    });
    let bytes = compact.as_bytes();
    let azimuth = bytes.len() > 2
        && matches!(bytes[0], b'n' | b's')
        && matches!(bytes[bytes.len() - 1], b'e' | b'w')
        && bytes[1..bytes.len() - 1].iter().all(u8::is_ascii_digit);
    let code = matches!(
        bytes,
        [b'b' | b'e' | b'h' | b's' | b'l', b'n' | b'h' | b'l' | b'g', b'e' | b'n' | b'z' | b'1' | b'2' | b'3']
    );
    NAMES.contains(&compact.as_str()) || numbered || azimuth || code
}

/// Words that say more of an acceleration or a time and are not a unit.
fn is_plain_word(word: &str) -> bool {
    const WORDS: [&str; 22] = [
        "",
        "corrected",
        "uncorrected",
        "raw",
        "filtered",
        "processed",
        "ground",
        "base",
        "input",
        "record",
        "history",
        "series",
        "time",
        "acceleration",
        "accel",
        "values",
        "data",
        "of",
        "in",
        "total",
        "absolute",
        "motion",
    ];
    WORDS.contains(&word) || is_component(word) || word.bytes().all(|b| b.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use AccelerationUnit::{G, Gal, MetrePerSecondSquared as Si, MilliG, PercentOfG};

    #[test]
    fn heads_as_written() {
        let accel = |u| Head::Acceleration(Some(u));
        let unknown = |u: &str| Head::UnknownUnit(u.into());
        for (text, expected) in [
            ("time_s", Head::Time(Some(1.0))),
            ("Time [s]", Head::Time(Some(1.0))),
            ("t (sec)", Head::Time(Some(1.0))),
            ("t / s", Head::Time(Some(1.0))),
            ("time_ms", Head::Time(Some(1e-3))),
            ("Zeit", Head::Time(None)),
            ("s", Head::Time(Some(1.0))),
            ("time (min)", unknown("min")),
            ("time_min", unknown("min")),
            ("acceleration_m_s2", accel(Si)),
            ("a [g]", accel(G)),
            ("Accel[g]", accel(G)),
            ("acc (g)", accel(G)),
            ("acc_g", accel(G)),
            ("ground acceleration cm/s2", accel(Gal)),
            ("a/(m/s²)", accel(Si)),
            ("g", accel(G)),
            ("Acceleration in m/s2", accel(Si)),
            ("acc percent g", accel(PercentOfG)),
            ("acc % g", accel(PercentOfG)),
            ("acc milli-g", accel(MilliG)),
            ("El Centro [g]", accel(G)),
            ("a_g", Head::Acceleration(None)),
            ("ag", Head::Acceleration(None)),
            ("a_g [m/s2]", accel(Si)),
            ("acceleration", Head::Acceleration(None)),
            ("acceleration time history", Head::Acceleration(None)),
            ("Acc (N-S)", Head::Acceleration(None)),
            ("acceleration [furlong]", unknown("furlong")),
            ("acceleration (counts)", unknown("counts")),
            ("acc mgal", unknown("mgal")),
            ("acc (m/s)", unknown("m/s")),
            ("velocity_m_s", Head::OtherMotion),
            ("displacement [cm]", Head::OtherMotion),
            ("v [m/s]", Head::OtherMotion),
            ("N-S", Head::Component(None)),
            ("U-D", Head::Component(None)),
            ("V", Head::Component(None)),
            ("N00E", Head::Component(None)),
            ("HNE", Head::Component(None)),
            ("NS [gal]", Head::Component(Some(Gal))),
            ("Chan 2 (g)", Head::Component(Some(G))),
            ("a(t) (g)", accel(G)),
            ("Period (s)", Head::OtherMotion),
            ("Sa (g)", Head::OtherMotion),
            ("PGA 0.25 g", Head::Unknown),
            ("PGA (g)", Head::Unknown),
            ("Vs30 310 m/s", Head::Unknown),
            ("Station G", Head::Unknown),
            ("El Centro", Head::Unknown),
            ("", Head::Unknown),
        ] {
            assert_eq!(head(text), expected, "{text}");
        }
    }
}
