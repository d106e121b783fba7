//! Text → tokens.

use std::ops::Range;

use super::tree::Number;
use crate::units::{self, UNITS, Unit};

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Number(Number),
    Symbol(String),
    /// A raised integer.
    Raised(i32),
    /// Any other character; `-` is `−`, `*` and `×` are `·`.
    Sign(char),
}

/// Tokens with the bytes of the text that they come from.
pub(super) fn tokens(text: &str) -> Vec<(Token, Range<usize>)> {
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        if c.is_whitespace() {
            at += c.len_utf8();
            continue;
        }
        let rest = &text[at..];
        let (token, length) = if c.is_ascii_digit() {
            number(rest)
        } else if let Some(value) = fraction(c) {
            let number = Number { digits: c.to_string(), unit: None, value };
            (Token::Number(number), c.len_utf8())
        } else if is_raised(c) {
            raised(rest)
        } else if c.is_alphabetic() {
            let length = symbol(rest);
            (Token::Symbol(rest[..length].into()), length)
        } else {
            let sign = match c {
                '-' => '−',
                '*' | '×' => '·',
                other => other,
            };
            (Token::Sign(sign), c.len_utf8())
        };
        out.push((token, at..at + length));
        at += length;
    }
    out
}

/// A number and the unit behind it, and their length.
fn number(text: &str) -> (Token, usize) {
    let digits = |from: usize| {
        let rest = &text[from..];
        from + rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len())
    };
    let mut end = digits(0);
    // A point belongs to the number only before a digit.
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    if text[end..].starts_with('e') {
        let sign = usize::from(text[end + 1..].starts_with('-'));
        if digits(end + 1 + sign) > end + 1 + sign {
            end = digits(end + 1 + sign);
        }
    }
    let written = &text[..end];
    let plain = written.parse().unwrap_or(f64::NAN);
    let unit = unit(&text[end..]);
    let (value, length) = match unit {
        None => (plain, end),
        Some((unit, length)) => {
            // The reader of quantities rounds once; percentages it reads as bare numbers only.
            let value = units::parse(&format!("{written} {}", unit.text), unit.dimension);
            (value.unwrap_or(plain * unit.factor()), end + length)
        }
    };
    let number = Number { digits: written.into(), unit: unit.map(|u| u.0), value };
    (Token::Number(number), length)
}

/// The longest unit behind a blank that ends where a word ends, and its length with the blank. `g` is not a unit
/// here: it is the symbol of the acceleration of free fall, or the gram.
fn unit(text: &str) -> Option<(&'static Unit, usize)> {
    let blank = text.chars().next().filter(|c| matches!(c, ' ' | '\u{202f}' | '\u{a0}'))?;
    let rest = &text[blank.len_utf8()..];
    UNITS
        .iter()
        .filter(|u| !matches!(u.symbol, "" | "g") && rest.starts_with(u.symbol))
        .filter(|u| !rest[u.symbol.len()..].starts_with(|c| in_symbol(c) || is_raised(c) || c == '('))
        .max_by_key(|u| u.symbol.len())
        .map(|u| (u, blank.len_utf8() + u.symbol.len()))
}

/// Value of a fraction or of infinity written as one character.
fn fraction(c: char) -> Option<f64> {
    match c {
        '½' => Some(0.5),
        '¼' => Some(0.25),
        '¾' => Some(0.75),
        '∞' => Some(f64::INFINITY),
        _ => None,
    }
}

/// A run of raised digits with its sign; one that is not an integer is a sign of its own, which the grammar rejects.
fn raised(text: &str) -> (Token, usize) {
    let length = text.find(|c| !is_raised(c)).unwrap_or(text.len());
    let plain: String = text[..length].chars().map(lowered).collect();
    match plain.parse() {
        Ok(exponent) => (Token::Raised(exponent), length),
        Err(_) => {
            let c = text.chars().next().unwrap_or(' ');
            (Token::Sign(c), c.len_utf8())
        }
    }
}

fn lowered(c: char) -> char {
    match c {
        '²' => '2',
        '³' => '3',
        '¹' => '1',
        '⁺' => '+',
        '⁻' => '-',
        '⁰' => '0',
        '⁴'..='⁹' => char::from_u32(c as u32 - '⁴' as u32 + '4' as u32).unwrap_or(c),
        other => other,
    }
}

/// Length of the symbol at the beginning of the text.
fn symbol(text: &str) -> usize {
    let mut lowered = false;
    let mut characters = text.char_indices().peekable();
    while let Some((at, c)) = characters.next() {
        let next = characters.peek().map(|p| p.1);
        let comma = c == ',' && lowered && next.is_some_and(char::is_alphabetic);
        if !in_symbol(c) && !comma {
            return at;
        }
        lowered |= c == '_';
    }
    text.len()
}

fn in_symbol(c: char) -> bool {
    (c.is_alphanumeric() && !is_raised(c) && fraction(c).is_none())
        || matches!(c, '_' | '′' | '″' | '\u{304}' | '\u{307}' | '\u{308}')
}

fn is_raised(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | '⁰' | '⁴'..='⁹' | '⁺' | '⁻')
}
