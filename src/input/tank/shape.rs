//! Form of a field, without its Rust type: the source of the JSON Schema and the reference page.

use tank::units::Dimension;
use tank::words::Words;

use tank::keys::{Absent, Key, Limits, prose};

/// Form of a value.
#[derive(Clone, Debug)]
pub(in crate::input) enum Shape {
    /// An object of the book.
    Object(&'static str),
    /// A closed choice of words of the book.
    Choice(&'static str),
    /// A number with a unit; a bare number or a percentage where there is no dimension.
    Quantity(Dimension),
    /// A quantity that may also be a bare number in this unit.
    Conventional(Dimension, &'static str),
    /// A whole number.
    Whole,
    /// `true` or `false`.
    Bool,
    /// Free text.
    Text,
    /// A text of one of these patterns.
    Pattern {
        /// In words, with the article.
        noun: String,
        /// Regular expressions; none for any text.
        patterns: Vec<String>,
        /// Texts that match.
        examples: &'static [&'static str],
    },
    /// A list.
    List(Box<Shape>),
    /// Objects under names of the user's choice.
    Named(Box<Shape>),
    /// This word, or something else.
    Either(&'static str, Box<Shape>),
    /// An object of the book for each comparable quantity, whose `value` is of its dimension.
    Measured(&'static str),
}

/// An object with its keys.
#[derive(Clone, Debug)]
pub(in crate::input) struct Object {
    /// Name of its type.
    pub name: &'static str,
    /// Its meaning.
    pub help: String,
    /// Its keys in the order of their declaration.
    pub keys: Vec<KeyInfo>,
}

/// A key of an object.
#[derive(Clone, Debug)]
pub(in crate::input) struct KeyInfo {
    pub name: &'static str,
    /// Its meaning.
    pub help: String,
    pub required: bool,
    pub shape: Shape,
    pub limits: Limits,
    /// A value as a user writes it, without quotes; empty for lists and objects.
    pub example: String,
    /// The default as a user writes it, without quotes.
    pub default: Option<String>,
    /// The default in words, or empty.
    pub otherwise: String,
}

/// A closed choice of words.
#[derive(Clone, Debug)]
pub(in crate::input) struct Choice {
    /// Name of its type.
    pub name: &'static str,
    /// Meaning of the choice.
    pub help: String,
    /// Words, each with its meaning.
    pub words: Vec<(&'static str, String)>,
}

/// All objects and choices of a file, in the order in which they are met.
#[derive(Clone, Debug, Default)]
pub(in crate::input) struct Book {
    pub objects: Vec<Object>,
    pub choices: Vec<Choice>,
}

impl Book {
    /// The object of this name; `keys` declares them where it is met for the first time.
    pub(crate) fn object(
        &mut self,
        name: &'static str,
        help: &[&str],
        keys: impl FnOnce(&mut Book) -> Vec<KeyInfo>,
    ) -> Shape {
        if !self.objects.iter().any(|o| o.name == name) {
            let place = self.objects.len();
            self.objects.push(Object { name, help: prose(help), keys: Vec::new() });
            self.objects[place].keys = keys(self);
        }
        Shape::Object(name)
    }

    /// The choice of this name.
    pub(crate) fn choice(&mut self, name: &'static str, help: &[&str], words: Vec<(&'static str, String)>) -> Shape {
        match self.choices.iter().find(|c| c.name == name) {
            Some(known) => debug_assert_eq!(known.words, words, "two choices named {name}"),
            None => self.choices.push(Choice { name, help: prose(help), words }),
        }
        Shape::Choice(name)
    }

    /// The choice that is declared with these words.
    pub(crate) fn words_of<T: Words>(&mut self) -> Shape {
        let words = T::WORDS.iter().map(|(word, _, help)| (*word, prose(help)));
        self.choice(T::NAME, T::HELP, words.collect())
    }

    /// The words of a choice.
    pub(crate) fn words(&self, name: &str) -> &[(&'static str, String)] {
        let choice = self.choices.iter().find(|c| c.name == name);
        choice.map_or(&[], |c| &c.words)
    }
}

impl KeyInfo {
    /// The description of a declared key.
    ///
    /// * `example`: of its type
    /// * `write`: a value as a user writes it, without quotes
    pub(crate) fn new<T: 'static>(
        key: &Key<T>,
        required: bool,
        shape: Shape,
        example: String,
        write: impl Fn(&T) -> Option<String>,
    ) -> KeyInfo {
        let example = match key.example {
            "" => example,
            own => own.into(),
        };
        let (default, otherwise) = match &key.absent {
            Absent::Silent => (None, String::new()),
            Absent::Value { value, shown, why } => {
                let text = write(value);
                let shown = match *shown {
                    "" => text.clone().unwrap_or_default(),
                    shown => shown.into(),
                };
                let otherwise = match *why {
                    "" => shown,
                    why => format!("{shown} ({why})"),
                };
                (text, otherwise)
            }
            Absent::Without(meaning) | Absent::Follows(meaning) => (None, (*meaning).into()),
        };
        KeyInfo {
            name: key.name,
            help: prose(key.help),
            required,
            shape,
            limits: key.limits,
            example,
            default,
            otherwise,
        }
    }

    /// Its meaning, limits and default as one text.
    pub(crate) fn description(&self) -> String {
        let mut text = self.help.clone();
        let allowed = self.allowed();
        let mut letters = allowed.chars();
        if let Some(first) = letters.next() {
            text.push_str(&format!(" {}{}.", first.to_uppercase(), letters.as_str()));
        }
        if !self.otherwise.is_empty() {
            let word = if self.default.is_some() { "Default" } else { "If not given" };
            text.push_str(&format!(" {word}: {}.", self.otherwise));
        }
        text
    }

    /// The limits in words, such as "greater than 0, at most 10 m"; empty if there are none.
    pub(crate) fn allowed(&self) -> String {
        let (list, item) = match &self.shape {
            Shape::List(item) => (true, item.as_ref()),
            shape => (false, shape),
        };
        let dimension = match item {
            Shape::Quantity(dimension) => *dimension,
            _ => Dimension::Dimensionless,
        };
        let mut words = Vec::new();
        match self.limits.items {
            (0, usize::MAX) => {}
            (0, most) => words.push(format!("at most {most} items")),
            (fewest, most) => words.push(format!("{fewest} to {most} items")),
        }
        let values = match (self.limits.values, self.limits.bounded()) {
            ([], true) => self.limits.in_full(dimension),
            ([], false) => String::new(),
            _ => self.limits.words(),
        };
        match (values.is_empty(), list) {
            (true, _) => {}
            (false, true) => words.push(format!("each {values}")),
            (false, false) => words.push(values),
        }
        words.join(", ")
    }
}
