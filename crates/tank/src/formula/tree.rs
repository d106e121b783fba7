//! The tree of a formula, one type for each level of the grammar, so that every tree is a formula. Parentheses are part
//! of the tree: it is the formula as written.

use std::fmt;
use std::ops::Range;

use crate::units::Unit;

/// Terms added and subtracted. The first sign is printed only if it is a minus.
#[derive(Clone, Debug, PartialEq)]
pub struct Sum(
    /// The terms with their signs; at least one.
    pub Vec<(Sign, Product)>,
);

/// Sign of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// `+`
    Plus,
    /// `−`
    Minus,
}

/// Factors multiplied and divided, from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// The first factor.
    pub first: Power,
    /// The others.
    pub rest: Vec<(Operator, Power)>,
}

/// Operator between factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `·`
    Times,
    /// `/`
    Over,
}

/// A root, a power, or neither.
#[derive(Clone, Debug, PartialEq)]
pub enum Power {
    /// `a`
    Plain(Primary),
    /// `√a`
    Root(Box<Power>),
    /// `a²`, with a raised integer.
    Raised(Primary, i32),
    /// `a^b`
    To {
        /// The base of a power.
        base: Primary,
        /// Whether a minus stands before the exponent.
        minus: bool,
        /// The exponent without it.
        exponent: Primary,
    },
}

/// A factor without operator outside of its brackets.
#[derive(Clone, Debug, PartialEq)]
pub enum Primary {
    /// A number with its unit.
    Number(Number),
    /// A symbol.
    Symbol(String),
    /// A function of its arguments.
    Call(String, Vec<Sum>),
    /// A sum in brackets.
    Group(Bracket, Box<Sum>),
}

/// A number as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Its digits.
    pub digits: String,
    /// Its unit.
    pub unit: Option<&'static Unit>,
    /// Its value in SI.
    pub value: f64,
}

/// Kind of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `( … )`
    Round,
    /// `[ … ]`
    Square,
    /// `| … |`, the absolute value.
    Bar,
}

/// A symbol in the text of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    /// Bytes of the text.
    pub at: Range<usize>,
    /// Whether an exponent follows.
    pub raised: bool,
}

impl Bracket {
    /// Opening and closing character.
    pub fn pair(self) -> (char, char) {
        match self {
            Bracket::Round => ('(', ')'),
            Bracket::Square => ('[', ']'),
            Bracket::Bar => ('|', '|'),
        }
    }
}

impl Sign {
    /// The character.
    pub fn char(self) -> char {
        match self {
            Sign::Plus => '+',
            Sign::Minus => '−',
        }
    }
}

/// The digits of an exponent, raised.
fn raised(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '0' => '⁰',
            // The other digits are in a row.
            digit => char::from_u32('⁴' as u32 + digit as u32 - '4' as u32).unwrap_or(digit),
        })
        .collect()
}

impl fmt::Display for Sum {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, (sign, product)) in self.0.iter().enumerate() {
            match (i, sign) {
                (0, Sign::Plus) => {}
                (0, Sign::Minus) => f.write_str("−")?,
                _ => write!(f, " {} ", sign.char())?,
            }
            write!(f, "{product}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Product {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", self.first)?;
        for (operator, factor) in &self.rest {
            let sign = match operator {
                Operator::Times => '·',
                Operator::Over => '/',
            };
            write!(f, "{sign}{factor}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Power {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Power::Plain(primary) => write!(f, "{primary}"),
            Power::Root(under) => write!(f, "√{under}"),
            Power::Raised(base, exponent) => write!(f, "{base}{}", raised(*exponent)),
            Power::To { base, minus, exponent } => {
                write!(f, "{base}^{}{exponent}", if *minus { "−" } else { "" })
            }
        }
    }
}

impl fmt::Display for Primary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Primary::Number(number) => write!(f, "{number}"),
            Primary::Symbol(name) => f.write_str(name),
            Primary::Call(name, arguments) => {
                write!(f, "{name}(")?;
                for (i, argument) in arguments.iter().enumerate() {
                    let separator = if i == 0 { "" } else { ", " };
                    write!(f, "{separator}{argument}")?;
                }
                f.write_str(")")
            }
            Primary::Group(bracket, sum) => {
                let (open, close) = bracket.pair();
                write!(f, "{open}{sum}{close}")
            }
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.digits)?;
        match self.unit {
            Some(unit) => write!(f, " {}", unit.symbol),
            None => Ok(()),
        }
    }
}
