//! Declaration of a key of `tank.json`: name, help, example, limits and default.
//!
//! The reader, range checks, defaults with their echo in the report, the JSON Schema and the reference page use it. An object whose keys
//! are what the tank has of it is declared once, as keys and as domain type, with [`keys!`](crate::keys).

mod declared;
mod values;

pub(crate) use declared::keys;
pub use declared::{As, ByHand, Declared, Field, Form, Needed, Opt, Or, Reader, Reads, Within};
pub use values::{
    Acceleration, Angle, Area, AreaMass, Density, Force, InG, Length, LineArea, LineForce, Mass, Number, Pitch,
    SecondMoment, Seconds, Stress, Subgrade, Temperature, Time, Velocity, Whole,
};

use crate::units::{Dimension, Unit, in_unit, unit_for};

/// A key whose value is a `T`.
#[derive(Debug)]
pub struct Key<T: 'static> {
    /// Name as in the file.
    pub name: &'static str,
    /// Its meaning, line by line.
    pub help: &'static [&'static str],
    /// A value as a user writes it, without quotes; that of its type if empty.
    pub example: &'static str,
    /// Admissible values.
    pub limits: Limits,
    /// Its default.
    pub absent: Absent<T>,
}

/// Default of an optional key.
#[derive(Clone, Copy, Debug)]
pub enum Absent<T> {
    /// No default that the report lists.
    Silent,
    /// A value.
    Value {
        /// The value.
        value: T,
        /// The value as the report shows it; if empty, as a user writes it.
        shown: &'static str,
        /// Reason or source; the report lists the default unless this is empty.
        why: &'static str,
    },
    /// No value; the meaning of its absence, for the report.
    Without(&'static str),
    /// A value that depends on other keys, in words.
    Follows(&'static str),
}

/// A default that the report does not list.
pub const fn default<T: Copy>(value: T) -> Absent<T> {
    Absent::Value { value, shown: "", why: "" }
}

/// No value; the report states the meaning of its absence.
pub const fn without<T: Copy>(meaning: &'static str) -> Absent<T> {
    Absent::Without(meaning)
}

impl<T: Copy> Absent<T> {
    /// Adds the reason for the default, so that the report lists it.
    pub const fn because(self, why: &'static str) -> Absent<T> {
        match self {
            Absent::Value { value, shown, .. } => Absent::Value { value, shown, why },
            other => other,
        }
    }

    /// Sets the text that the report shows.
    pub const fn shown(self, shown: &'static str) -> Absent<T> {
        match self {
            Absent::Value { value, why, .. } => Absent::Value { value, shown, why },
            other => other,
        }
    }
}

/// Admissible values: a range of numbers in SI, or a few numbers; the length of a list.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Lower end.
    pub low: f64,
    /// Whether the lower end belongs to the range.
    pub low_allowed: bool,
    /// Upper end.
    pub high: f64,
    /// Whether the upper end belongs to the range.
    pub high_allowed: bool,
    /// The only numbers, if there are any.
    pub values: &'static [f64],
    /// Fewest and most items of a list; the other limits are those of each item.
    pub items: (usize, usize),
    /// Least and largest usual value: one outside is used, with a warning.
    pub usual: (f64, f64),
    /// Clause or reason of the range; empty without one.
    pub clause: &'static str,
}

impl Limits {
    /// Everything.
    pub const ANY: Limits = Limits {
        low: f64::NEG_INFINITY,
        low_allowed: true,
        high: f64::INFINITY,
        high_allowed: true,
        values: &[],
        items: (0, usize::MAX),
        usual: (f64::NEG_INFINITY, f64::INFINITY),
        clause: "",
    };

    /// Greater than this.
    pub const fn above(low: f64) -> Limits {
        Limits { low, low_allowed: false, ..Limits::ANY }
    }

    /// This or greater.
    pub const fn from(low: f64) -> Limits {
        Limits { low, ..Limits::ANY }
    }

    /// And at most this.
    pub const fn to(self, high: f64) -> Limits {
        Limits { high, ..self }
    }

    /// And less than this.
    pub const fn below(self, high: f64) -> Limits {
        Limits { high, high_allowed: false, ..self }
    }

    /// Usual from this to this.
    pub const fn usual(self, least: f64, most: f64) -> Limits {
        Limits { usual: (least, most), ..self }
    }

    /// With the clause or reason of the range.
    pub const fn clause(self, clause: &'static str) -> Limits {
        Limits { clause, ..self }
    }

    /// The usual range in words, where a value is outside of it; for a value that is allowed.
    pub fn unusual(self, value: f64, dimension: Dimension) -> Option<String> {
        let (least, most) = self.usual;
        // Slack for quotients of decimal fractions.
        let slack = 1e-9 * value.abs();
        if value.is_nan() || (value >= least - slack && value <= most + slack) {
            return None;
        }
        Some(format!("usual is {}{}", self.usually(dimension), self.source()))
    }

    /// The usual range: "0.8 to 1.6".
    fn usually(self, dimension: Dimension) -> String {
        match self.usual {
            (least, most) if most.is_infinite() => format!("at least {}", shown(least, dimension)),
            (least, most) if least.is_infinite() => format!("up to {}", shown(most, dimension)),
            (least, most) => format!("{} to {}", shown(least, dimension), shown(most, dimension)),
        }
    }

    /// The clause behind a range, with its separator.
    fn source(self) -> String {
        match self.clause {
            "" => String::new(),
            clause => format!(", {clause}"),
        }
    }

    /// A whole number between these.
    pub const fn count(least: u32, most: u32) -> Limits {
        Limits::from(least as f64).to(most as f64)
    }

    /// One of these numbers.
    pub const fn one_of(values: &'static [f64]) -> Limits {
        Limits { values, ..Limits::ANY }
    }

    /// A list with so many items.
    pub const fn items(self, fewest: usize, most: usize) -> Limits {
        Limits { items: (fewest, most), ..self }
    }

    /// Whether a value lies in the range.
    pub fn hold(self, value: f64) -> bool {
        let low = if self.low_allowed { value >= self.low } else { value > self.low };
        let high = if self.high_allowed { value <= self.high } else { value < self.high };
        low && high
    }

    /// Whether the range has an end.
    pub fn bounded(self) -> bool {
        self.low.is_finite() || self.high.is_finite()
    }

    /// The message for a value outside the range.
    pub fn message(self, value: f64) -> &'static str {
        match (value <= self.low, self.low == 0.0) {
            (true, true) if self.low_allowed => "this must not be negative",
            (true, true) => "this must be positive",
            (true, false) if self.low_allowed && self.low > 0.0 && value <= 0.0 => "this must be positive",
            (true, false) => "too small",
            (false, _) => "too large",
        }
    }

    /// The range in words: "a length greater than 0, at most 1000 m".
    pub fn describe(self, dimension: Dimension) -> String {
        let noun = match dimension {
            Dimension::Dimensionless => "a number",
            dimension => dimension.noun(),
        };
        format!("{noun} {}{}", self.range(dimension), self.source())
    }

    /// The range without the noun, with what is usual and the clause.
    pub fn in_full(self, dimension: Dimension) -> String {
        let usual = match self.usual {
            (f64::NEG_INFINITY, f64::INFINITY) => String::new(),
            _ => format!(", usually {}", self.usually(dimension)),
        };
        format!("{}{usual}{}", self.range(dimension), self.source())
    }

    /// The range without the noun: "greater than 0, at most 1000 m".
    pub fn range(self, dimension: Dimension) -> String {
        let low = if self.low_allowed { "at least" } else { "greater than" };
        let high = if self.high_allowed { "at most" } else { "less than" };
        let ends = [(low, self.low), (high, self.high)];
        let ends: Vec<String> = ends
            .into_iter()
            .filter(|(_, limit)| limit.is_finite())
            .map(|(word, limit)| format!("{word} {}", shown(limit, dimension)))
            .collect();
        ends.join(", ")
    }

    /// The few numbers: "1, 1.5 or 2.5".
    pub fn words(self) -> String {
        let words: Vec<String> = self.values.iter().map(f64::to_string).collect();
        list(&words.iter().map(String::as_str).collect::<Vec<_>>(), "or")
    }
}

/// A value in SI as short as possible, with an engineer's unit; zero without a unit.
fn shown(value: f64, dimension: Dimension) -> String {
    match value {
        0.0 => "0".into(),
        value => written(value, dimension),
    }
}

/// A value in SI as a user writes it: as short as possible, with an engineer's unit.
pub fn written(value: f64, dimension: Dimension) -> String {
    // Angles are written in degrees.
    let degrees = (dimension == Dimension::Angle).then(|| Unit::find("deg", dimension)).flatten();
    let unit = degrees.unwrap_or_else(|| unit_for(value, dimension));
    let number = in_unit(value, unit);
    let number = match degrees {
        Some(_) => (1e9 * number).round() / 1e9,
        None => number,
    };
    match unit.text {
        "" => format!("{number}"),
        unit => format!("{number} {unit}"),
    }
}

/// `a, b or c`.
pub fn list(words: &[&str], conjunction: &str) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).into(),
        [all @ .., last] => format!("{} {conjunction} {last}", all.join(", ")),
    }
}

/// Lines of a documentation comment as one text: lines joined, paragraphs kept.
pub fn prose(lines: &[&str]) -> String {
    let paragraphs: Vec<String> = lines
        .split(|l| l.trim().is_empty())
        .map(|p| p.iter().map(|l| l.trim()).collect::<Vec<_>>().join(" "))
        .filter(|p| !p.is_empty())
        .collect();
    paragraphs.join("\n\n")
}
