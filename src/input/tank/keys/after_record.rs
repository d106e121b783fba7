//! `after_record`: how long a history goes on after its record.

use files::code::Code;
use tank::options::AfterRecord;
use tank::units::{self, Dimension};

use crate::input::diagnostic::Faults;
use crate::input::tank::read::{FromNode, text_of, wrong_value};
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::Node;
use crate::input::tank::values::pattern;

/// The word for a history that ends with its record.
const NONE: &str = "none";
/// Most periods of the first sloshing mode: lightly damped sloshing has then lost nine tenths of its height.
const MOST_PERIODS: f64 = 100.0;
/// Longest free vibration [s], that of all engines.
const LONGEST: f64 = 86_400.0;

/// `"2 periods"` of the first sloshing mode, a time `"20 s"`, or `"none"`.
impl FromNode for AfterRecord {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let text = text_of::<Self>(node, faults)?;
        let text = text.trim();
        if text == NONE {
            return Some(AfterRecord::NONE);
        }
        let count = text.strip_suffix("periods").or(text.strip_suffix("period"));
        let (value, most, found): (f64, f64, fn(f64) -> AfterRecord) = match count {
            Some(count) => match count.trim().parse::<f64>() {
                Ok(count) => (count, MOST_PERIODS, AfterRecord::Periods),
                Err(_) => (f64::NAN, MOST_PERIODS, AfterRecord::Periods),
            },
            None => match units::parse(text, Dimension::Time) {
                Ok(time) => (time, LONGEST, AfterRecord::Time),
                Err(_) => (f64::NAN, LONGEST, AfterRecord::Time),
            },
        };
        if (0.0..=most).contains(&value) {
            return Some(found(value));
        }
        let message = if value.is_nan() { "neither a time nor a number of sloshing periods" } else { "out of range" };
        faults.push(wrong_value(Code::OutOfRange, node, message, &Self::allowed()));
        None
    }
    fn allowed() -> String {
        format!(
            "periods of the first sloshing mode such as \"2 periods\" (0 to {MOST_PERIODS:.0}), a time such as \"20 s\" (0 to \
             {LONGEST:.0} s), or \"{NONE}\""
        )
    }
    fn example() -> String {
        "\"2 periods\"".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Pattern {
            noun: "periods of the first sloshing mode, a time, or none".into(),
            patterns: vec![
                format!("^{NONE}$"),
                "^([0-9]+\\.?[0-9]*|\\.[0-9]+) ?periods?$".into(),
                pattern(Dimension::Time),
            ],
            examples: &["2 periods", "20 s", NONE],
        }
    }
    fn written(&self) -> Option<String> {
        Some(match *self {
            AfterRecord::Periods(count) => format!("{count} periods"),
            AfterRecord::Time(0.0) => NONE.into(),
            AfterRecord::Time(time) => format!("{time} s"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_are_read_back() {
        for value in [AfterRecord::DEFAULT, AfterRecord::NONE, AfterRecord::Time(12.5), AfterRecord::Periods(0.5)] {
            assert!(AfterRecord::allowed().contains("periods") && value.written().is_some());
        }
        assert_eq!(AfterRecord::NONE.written().as_deref(), Some("none"));
        assert_eq!(AfterRecord::DEFAULT.written().as_deref(), Some("2 periods"));
    }
}
