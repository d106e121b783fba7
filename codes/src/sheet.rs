//! Builder of calculation sheets: every line with symbol, formula, the numbers put in, value, dimension and clause.
//!
//! The substitution of a [`Step`] is made from its formula by [`substitute`], so that formula and numbers cannot part:
//!
//! ```
//! use codes::sheet::{Sheet, substitute, with_unit};
//! use codes::units::Dimension::{Acceleration, Force, Mass};
//!
//! let (a_b, m_i) = (4.903, 7600.6);
//! let mut sheet = Sheet::new();
//! sheet.section("Impulsive part");
//! let p_i = sheet.calc(
//!     "P_i",
//!     "impulsive force",
//!     "a_B·m_i",
//!     &[("a_B", a_b, Acceleration), ("m_i", m_i, Mass)],
//!     a_b * m_i,
//!     Force,
//!     "Housner 1957",
//! );
//! let steps = sheet.into_steps();
//! assert_eq!(p_i, a_b * m_i);
//! assert_eq!(steps[0].substitution, "4.903 m/s²·7600.6 kg");
//! ```

use tank::assessment::Step;
use tank::units::{Dimension, in_unit, significant, unit_for};

/// A value that stands in a formula: symbol, value in SI, dimension.
pub type Term<'a> = (&'a str, f64, Dimension);

/// A calculation sheet under construction.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    section: String,
    steps: Vec<Step>,
}

impl Sheet {
    /// An empty sheet.
    pub fn new() -> Sheet {
        Sheet::default()
    }

    /// Begins a section; all following lines stand under this heading.
    pub fn section(&mut self, title: &str) {
        self.section = title.into();
    }

    /// Adds an input: a value without formula. Returns the value.
    pub fn input(&mut self, symbol: &str, name: &str, value: f64, dimension: Dimension, source: &str) -> f64 {
        self.step(symbol, name, "", "", value, dimension, source)
    }

    /// Adds a line whose substitution is made from the formula by [`substitute`]. Returns the value.
    pub fn calc(
        &mut self,
        symbol: &str,
        name: &str,
        formula: &str,
        terms: &[Term],
        value: f64,
        dimension: Dimension,
        clause: &str,
    ) -> f64 {
        let substitution = substitute(formula, terms);
        self.step(symbol, name, formula, &substitution, value, dimension, clause)
    }

    /// Adds a line as given; for formulas that cannot be substituted symbol by symbol. Returns the value.
    pub fn step(
        &mut self,
        symbol: &str,
        name: &str,
        formula: &str,
        substitution: &str,
        value: f64,
        dimension: Dimension,
        clause: &str,
    ) -> f64 {
        self.steps.push(Step {
            section: self.section.clone(),
            symbol: symbol.into(),
            name: name.into(),
            formula: formula.into(),
            substitution: substitution.into(),
            value,
            dimension,
            clause: clause.into(),
        });
        value
    }

    /// The lines.
    pub fn into_steps(self) -> Vec<Step> {
        self.steps
    }
}

/// The formula with numbers for symbols.
///
/// A symbol is a maximal run of letters, digits, `_` and `′` that starts with a letter (`a_B`, `h_i′`, `λ1`); runs that
/// are not among `terms` stay (`tanh`, `cosh`). Write products with `·`. A value under an exponent (`R²`, `x^2`) or a
/// negative one is put into parentheses.
pub fn substitute(formula: &str, terms: &[Term]) -> String {
    let chars: Vec<char> = formula.chars().collect();
    let mut out = String::with_capacity(2 * formula.len());
    let mut i = 0;
    while i < chars.len() {
        if !chars[i].is_alphabetic() {
            out.push(chars[i]);
            i += 1;
            continue;
        }
        let start = i;
        while i < chars.len() && belongs_to_symbol(chars[i]) {
            i += 1;
        }
        let symbol: String = chars[start..i].iter().collect();
        match terms.iter().find(|(s, _, _)| *s == symbol) {
            None => out.push_str(&symbol),
            Some(&(_, value, dimension)) => {
                let text = with_unit(value, dimension);
                let raised = chars.get(i).is_some_and(|&c| c == '^' || is_superscript(c));
                if value < 0.0 || (raised && !text.chars().all(|c| c.is_ascii_digit() || c == '.')) {
                    out.push('(');
                    out.push_str(&text);
                    out.push(')');
                } else {
                    out.push_str(&text);
                }
            }
        }
    }
    out
}

fn belongs_to_symbol(c: char) -> bool {
    (c.is_alphanumeric() && !is_superscript(c) && !('½'..='¾').contains(&c)) || c == '_' || c == '′'
}

fn is_superscript(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | '⁰' | '⁴'..='⁹' | '⁺' | '⁻')
}

/// A number with five significant digits without trailing zeros: `2.9976`, `0.25475`, `37281`, `1.83`.
pub fn number(value: f64) -> String {
    let text = significant(value, DIGITS);
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    if mantissa.contains('.') {
        format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
    } else {
        text
    }
}

/// Significant digits of the numbers put into formulas.
const DIGITS: usize = 5;

/// A value in SI as [`number`] with an engineer's unit ([`unit_for`]): `1.27 mm`, `16.3 t`, `37.281 kN`, `69 GPa`.
pub fn with_unit(value: f64, dimension: Dimension) -> String {
    let unit = unit_for(value, dimension);
    let number = number(in_unit(value, unit));
    if unit.symbol.is_empty() {
        number
    } else {
        format!("{number} {}", unit.symbol)
    }
}

#[cfg(test)]
pub(crate) mod arithmetic;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_five_digits_and_no_idle_zeros() {
        for (value, text) in [
            (0.0, "0"),
            (1.83, "1.83"),
            (2.99763, "2.9976"),
            (0.254_749, "0.25475"),
            (37281.4, "37281"),
            (9.999_996, "10"),
            (-0.5, "-0.5"),
            (1234567.0, "1234567"),
            (6.9e10, "6.9e10"),
            (3.2e-7, "3.2e-7"),
            (f64::INFINITY, "∞"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn units_are_those_of_engineers() {
        for (value, dimension, text) in [
            (0.00203, Dimension::Length, "2.03 mm"),
            (1.525, Dimension::Length, "1.525 m"),
            (16300.0, Dimension::Mass, "16.3 t"),
            (37281.0, Dimension::Force, "37.281 kN"),
            (69e9, Dimension::Stress, "69 GPa"),
            (1.58e6, Dimension::Stress, "1.58 MPa"),
            (14960.0, Dimension::Stress, "14.96 kPa"),
            (0.46629, Dimension::Dimensionless, "0.46629"),
        ] {
            assert_eq!(with_unit(value, dimension), text);
        }
    }

    #[test]
    fn substitution_replaces_whole_symbols_only() {
        let terms = [
            ("k", 1.8412, Dimension::Dimensionless),
            ("R", 1.83, Dimension::Length),
            ("H", 1.525, Dimension::Length),
            ("h_i", 0.572, Dimension::Length),
            ("h_i′", 1.4446, Dimension::Length),
            ("n", -2.0, Dimension::Dimensionless),
        ];
        for (formula, text) in [
            ("tanh(k·H/R)", "tanh(1.8412·1.525 m/1.83 m)"),
            ("π·R²", "π·(1.83 m)²"),
            ("k²", "1.8412²"),
            ("√(H/R)", "√(1.525 m/1.83 m)"),
            ("h_i + h_i′", "572 mm + 1.4446 m"),
            ("3/8·H", "3/8·1.525 m"),
            ("n·R", "(-2)·1.83 m"),
        ] {
            assert_eq!(substitute(formula, &terms), text);
        }
    }
}
