//! Faults of formulas.

/// A text that is not a formula, or a formula without value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FormulaError {
    /// The text departs from the grammar.
    #[error("`{formula}`: found {found} at character {at}, expected {expected}")]
    Unexpected {
        /// The text.
        formula: String,
        /// Number of the character, from 1.
        at: usize,
        /// The text found.
        found: String,
        /// The text expected by the grammar.
        expected: &'static str,
    },
    /// Parentheses, roots and exponents within each other, more than any formula has.
    #[error("`{formula}`: more than {limit} levels of parentheses")]
    TooDeep {
        /// The text.
        formula: String,
        /// The limit.
        limit: usize,
    },
    /// A symbol without a term.
    #[error("`{formula}`: no value given for `{symbol}`")]
    NoValue {
        /// The text.
        formula: String,
        /// The symbol.
        symbol: String,
    },
    /// A function that does not exist, or not with so many arguments.
    #[error("`{formula}`: no function `{name}` of {arguments} arguments")]
    NoFunction {
        /// The text.
        formula: String,
        /// Its name.
        name: String,
        /// Number of arguments.
        arguments: usize,
    },
}
