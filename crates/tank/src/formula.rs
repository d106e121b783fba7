//! Formulas of calculation sheets: one text is parsed once and gives the value, the text with the numbers put in, and
//! the tree that a report sets as mathematics.
//!
//! ```
//! use tank::formula::Formula;
//! use tank::units::Dimension::{Acceleration, Mass};
//!
//! let formula = Formula::parse("a_B·m_i").unwrap();
//! let terms = [("a_B", 4.903, Acceleration), ("m_i", 7600.6, Mass)];
//! assert_eq!(formula.value(&terms), Ok(4.903 * 7600.6));
//! assert_eq!(formula.substitution(&terms), "4.903 m/s²·7600.6 kg");
//! ```
//!
//! # Grammar
//!
//! ```text
//! sum       [ − ] product { ( + | − ) product }
//! product   power { ( · | / ) power }                       from left to right: a·b/c·d is ((a·b)/c)·d
//! power     √ power                                         √R is √(R), √3·R is (√3)·R, √x² is √(x²)
//!           primary [ ² | ³ | ⁻¹² … | ^ [ − ] primary ]     exponents: raised digits, or a number, symbol or (…)
//! primary   number [ unit ] | symbol | name( sum { , sum } ) | ( sum ) | [ sum ] | | sum |
//! number    digits [ . digits ] [ e [ - ] digits ] | ½ | ¼ | ¾ | ∞
//! unit      a symbol of `units::UNITS` after one blank; of two that fit, the longer
//! symbol    a letter, then letters, digits (also ₁ ⅓), _ ′ ″; after an _ also a comma before a letter (σ_θ,max)
//! ```
//!
//! A number with a unit is raised in parentheses, `(2 mm)²`. `-` is `−`, `*` and `×` are `·`, `;` separates arguments like `,`. There is no product without its sign. `π` is a
//! constant unless a term has its name. Functions: `tanh cosh sinh tan cos sin exp ln I₀ I₁` of one argument (`I₀`, `I₁`:
//! modified Bessel functions), `min max` of one or more.
//!
//! # Units
//!
//! Values are in SI: a term is given in SI with its dimension, and a number with a unit (`83 GPa`, `0.3048 m`) is
//! converted where it stands. A number without a unit is used unchanged, so the constant of a formula that a code prints
//! for other units has to be written for SI, or with its unit.

mod error;
mod lex;
mod parse;
mod text;
mod tree;
mod value;

#[cfg(test)]
mod tests;

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

pub use error::FormulaError;
pub use text::{number, with_unit};
pub use tree::{Bracket, Number, Operator, Power, Primary, Product, Sign, Sum};
pub use value::Term;

use crate::units::Dimension;
use tree::Place;

/// A parsed formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    text: String,
    tree: Sum,
    symbols: Vec<Place>,
}

impl Formula {
    /// Parses a text.
    ///
    /// Errors: [`FormulaError::Unexpected`] and [`FormulaError::TooDeep`].
    pub fn parse(text: &str) -> Result<Formula, FormulaError> {
        let (tree, symbols) = parse::formula(text)?;
        Ok(Formula { text: text.into(), tree, symbols })
    }

    /// The formula of a text, parsed at the first call in each thread: sheets evaluate the same few hundred texts for
    /// every tank.
    ///
    /// Errors: as [`Formula::parse`].
    pub fn cached(text: &str) -> Result<Rc<Formula>, FormulaError> {
        thread_local! {
            static PARSED: RefCell<HashMap<String, Rc<Formula>>> = RefCell::default();
        }
        PARSED.with_borrow_mut(|parsed| {
            if let Some(formula) = parsed.get(text) {
                return Ok(Rc::clone(formula));
            }
            let formula = Rc::new(Formula::parse(text)?);
            // Some formulas have a term for every course: many different tanks must not fill the memory.
            if parsed.len() >= CACHED {
                parsed.clear();
            }
            parsed.insert(text.into(), Rc::clone(&formula));
            Ok(formula)
        })
    }

    /// The text as it was given.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The formula as a tree, for those that set it.
    pub fn tree(&self) -> &Sum {
        &self.tree
    }

    /// The symbols in the order of the text, each as often as it stands there.
    pub fn symbols(&self) -> impl Iterator<Item = &str> {
        self.symbols.iter().map(|place| &self.text[place.at.clone()])
    }

    /// The value in SI.
    ///
    /// Errors: [`FormulaError::NoValue`] and [`FormulaError::NoFunction`].
    pub fn value(&self, terms: &[Term]) -> Result<f64, FormulaError> {
        value::of(&self.text, &self.tree, terms)
    }

    /// The text with numbers for symbols: five significant digits and an engineer's unit ([`with_unit`]). A value under
    /// an exponent (`R²`, `x^2`) or a negative one is put into parentheses; symbols without a term stay.
    pub fn substitution(&self, terms: &[Term]) -> String {
        text::substitution(&self.text, &self.symbols, terms)
    }
}

/// Formulas that a thread keeps.
const CACHED: usize = 2000;

/// The value of a formula for plain numbers in SI; NaN if the text is not a formula or a symbol lacks a number.
pub fn evaluate(text: &str, numbers: &[(&str, f64)]) -> f64 {
    let terms: Vec<Term> = numbers.iter().map(|&(symbol, value)| (symbol, value, Dimension::Dimensionless)).collect();
    let value = Formula::cached(text).and_then(|formula| formula.value(&terms));
    debug_assert!(value.is_ok(), "{value:?}");
    value.unwrap_or(f64::NAN)
}
