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
//! assert_eq!(steps[0].substitution, "4.903 m/s²·7.6006 t");
//! ```

use crate::procedure::Step;
use crate::units::Dimension;

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

/// A number with five significant digits without trailing zeros, `2.9976`, `0.25475`, `37281`; beyond 10⁻⁴ … 10⁷ with
/// a power of ten, `6.9·10¹⁰`.
pub fn number(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() {
            "undefined".into()
        } else if value > 0.0 {
            "∞".into()
        } else {
            "-∞".into()
        };
    }
    if value == 0.0 {
        return "0".into();
    }
    // Rounding to five digits first decides the decade (9.99999 is 10).
    let scientific = format!("{value:.4e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..7).contains(&exponent) {
        let decimals = (4 - exponent).max(0) as usize;
        trimmed(&format!("{value:.decimals$}"))
    } else {
        let power: String = exponent.to_string().chars().map(superscript).collect();
        format!("{}·10{power}", trimmed(mantissa))
    }
}

fn trimmed(text: &str) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text.into()
    }
}

fn superscript(c: char) -> char {
    match c {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁻',
    }
}

/// A value in SI as [`number`] with an engineer's unit: `1.27 mm`, `16.3 t`, `37.281 kN`, `69 GPa`.
pub fn with_unit(value: f64, dimension: Dimension) -> String {
    let (factor, unit) = engineering_unit(value, dimension);
    if unit.is_empty() {
        number(value)
    } else {
        format!("{} {unit}", number(value / factor))
    }
}

/// The engineer's unit for a value: its size in SI and its symbol.
fn engineering_unit(value: f64, dimension: Dimension) -> (f64, &'static str) {
    let size = value.abs();
    let zero = size == 0.0;
    match dimension {
        Dimension::Dimensionless => (1.0, ""),
        Dimension::Length if size < 0.1 && !zero => (1e-3, "mm"),
        Dimension::Length => (1.0, "m"),
        Dimension::Time => (1.0, "s"),
        Dimension::Mass if size >= 1000.0 => (1e3, "t"),
        Dimension::Mass => (1.0, "kg"),
        Dimension::Density => (1.0, "kg/m³"),
        Dimension::Velocity => (1.0, "m/s"),
        Dimension::Acceleration => (1.0, "m/s²"),
        Dimension::Frequency => (1.0, "Hz"),
        Dimension::AngularFrequency => (1.0, "rad/s"),
        Dimension::Angle => (1.0, "rad"),
        Dimension::Force if size >= 100.0 || zero => (1e3, "kN"),
        Dimension::Force => (1.0, "N"),
        Dimension::Moment if size >= 100.0 || zero => (1e3, "kNm"),
        Dimension::Moment => (1.0, "Nm"),
        Dimension::Stress if size >= 1e10 => (1e9, "GPa"),
        Dimension::Stress if size >= 1e5 || zero => (1e6, "MPa"),
        Dimension::Stress => (1e3, "kPa"),
        Dimension::LineForce if size >= 100.0 || zero => (1e3, "kN/m"),
        Dimension::LineForce => (1.0, "N/m"),
        Dimension::LineMoment if size >= 100.0 || zero => (1e3, "kNm/m"),
        Dimension::LineMoment => (1.0, "Nm/m"),
        Dimension::Energy if size >= 100.0 || zero => (1e3, "kJ"),
        Dimension::Energy => (1.0, "J"),
        #[allow(unreachable_patterns)]
        other => (1.0, other.si_symbol()),
    }
}

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
            (6.9e10, "6.9·10¹⁰"),
            (3.2e-7, "3.2·10⁻⁷"),
            (f64::INFINITY, "∞"),
            (f64::NAN, "undefined"),
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
            ("h_i + h_i′", "0.572 m + 1.4446 m"),
            ("3/8·H", "3/8·1.525 m"),
            ("n·R", "(-2)·1.83 m"),
        ] {
            assert_eq!(substitute(formula, &terms), text);
        }
    }
}
