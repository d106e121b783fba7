//! Facts within sentences and tables.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

use crate::value::unit_symbol;

/// A sentence or a label by its id, with what is put into it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Message {
    /// Id of its text.
    pub id: String,
    /// Facts by the names under which the text has them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, Fact>,
}

/// What a sentence or a cell holds.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Fact {
    /// Nothing.
    #[default]
    None,
    /// A number in the unit of its column; a count in a sentence.
    Number(f64),
    /// An id: of a row's title in a cell, of a choice in a sentence.
    Word(String),
    /// A number with its unit.
    Amount(Amount),
    /// A sentence or a label.
    Message(Message),
}

/// A number with its unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Amount {
    /// Value in SI.
    pub value: f64,
    /// Dimension, written as the symbol of its unit in SI.
    #[serde(with = "unit_symbol")]
    pub unit: Dimension,
    /// How it is printed.
    #[serde(default, skip_serializing_if = "is_default")]
    pub form: Form,
}

/// How a number is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// Four significant digits in an engineer's unit; in a column with a unit, as many decimals as its largest value.
    #[default]
    Usual,
    /// A given value, without idle zeros.
    Given,
    /// With this many decimals, in the unit of SI.
    Fixed(u8),
    /// With this many significant digits.
    Significant(u8),
    /// As a percentage.
    Percent,
    /// An angle in degrees with this many decimals.
    Degrees(u8),
    /// Not a number: words, to the left in a column.
    Words,
}

/// Whether a field can be left out.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Message {
    /// A sentence without facts.
    pub fn new(id: &str) -> Message {
        Message { id: id.into(), args: BTreeMap::new() }
    }

    /// A text as it was written.
    pub fn verbatim(text: &str) -> Message {
        Message::new("verbatim").with("text", text)
    }

    /// The same with a fact.
    #[must_use]
    pub fn with(mut self, name: &str, fact: impl Into<Fact>) -> Message {
        self.args.insert(name.into(), fact.into());
        self
    }
}

impl Amount {
    /// A number in the usual form.
    pub fn new(value: f64, unit: Dimension) -> Amount {
        Amount { value, unit, form: Form::Usual }
    }

    /// The same in another form.
    #[must_use]
    pub fn form(self, form: Form) -> Amount {
        Amount { form, ..self }
    }

    /// A number without a unit.
    pub fn ratio(value: f64) -> Amount {
        Amount::new(value, Dimension::Dimensionless)
    }

    /// A share in percent.
    pub fn percent(value: f64) -> Amount {
        Amount::ratio(value).form(Form::Percent)
    }
}

impl Fact {
    pub(crate) fn is_none(&self) -> bool {
        *self == Fact::None
    }

    /// Its number, with or without a unit.
    pub fn value(&self) -> Option<f64> {
        match self {
            Fact::Number(value) => Some(*value),
            Fact::Amount(amount) => Some(amount.value),
            _ => None,
        }
    }
}

impl From<f64> for Fact {
    fn from(value: f64) -> Fact {
        Fact::Number(value)
    }
}

impl From<&str> for Fact {
    fn from(id: &str) -> Fact {
        Fact::Word(id.into())
    }
}

impl From<Amount> for Fact {
    fn from(amount: Amount) -> Fact {
        Fact::Amount(amount)
    }
}

impl From<Message> for Fact {
    fn from(message: Message) -> Fact {
        Fact::Message(message)
    }
}

impl<T: Into<Fact>> From<Option<T>> for Fact {
    fn from(fact: Option<T>) -> Fact {
        fact.map_or(Fact::None, Into::into)
    }
}
