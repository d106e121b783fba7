//! Builder of calculation sheets: every line with symbol, formula, the numbers put in, value, dimension and clause.
//!
//! A line is an input, a formula or a look-up. The value of a formula is computed from its text ([`Formula`]) and from the
//! lines above it, so that the printed line is the computation: a symbol has the value of the last line that gives it.
//! What a formula uses and no line shows is told by [`Sheet::given`].
//!
//! ```
//! use codes::sheet::Sheet;
//! use tank::units::Dimension::{Acceleration, Force, Mass};
//!
//! let mut sheet = Sheet::new();
//! sheet.section("Impulsive part");
//! sheet.input("m_i", "impulsive mass", 7600.6, Mass, "table 1");
//! sheet.given(&[("a_B", 4.903, Acceleration)]);
//! let p_i = sheet.calc("P_i", "impulsive force", "a_B·m_i", Force, "Housner 1957");
//! assert_eq!(p_i, 4.903 * 7600.6);
//! let steps = sheet.into_steps().unwrap();
//! assert_eq!(steps[1].substitution, "4.903 m/s²·7600.6 kg");
//! ```

use std::cell::Cell;

use tank::assessment::Step;
use tank::formula::{Formula, FormulaError};
use tank::units::Dimension;

pub use tank::formula::{Term, number, with_unit};

/// End of a clause that is recalled: no source was compared with it.
pub const RECALLED: &str = ", recalled";

thread_local! {
    /// Whether the sheets of this thread keep their lines.
    static LINES: Cell<bool> = const { Cell::new(true) };
}

/// Runs procedures whose lines nobody reads: values are computed as always, sheets stay empty.
pub fn without_lines<T>(compute: impl FnOnce() -> T) -> T {
    let before = LINES.replace(false);
    let found = compute();
    LINES.set(before);
    found
}

/// A calculation sheet under construction.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    section: String,
    steps: Vec<Step>,
    /// Symbols with their values, the latest last.
    known: Vec<(String, f64, Dimension)>,
    /// The first formula that could not be evaluated.
    fault: Option<FormulaError>,
    /// Clauses that are recalled, each once.
    recalled: Vec<String>,
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

    /// Tells values that formulas below use and no line shows.
    pub fn given(&mut self, terms: &[Term]) {
        self.known.extend(terms.iter().map(|&(symbol, value, dimension)| (symbol.into(), value, dimension)));
    }

    /// Adds an input: a value of the tank file, of another sheet or of a table of the report. Returns the value.
    pub fn input(&mut self, symbol: &str, name: &str, value: f64, dimension: Dimension, source: &str) -> f64 {
        self.push(symbol, name, value, dimension, source, Step::default)
    }

    /// Adds a line with a formula of the symbols above. Returns its value, in SI; NaN if the formula is faulty, which
    /// [`Sheet::into_steps`] then reports.
    pub fn calc(&mut self, symbol: &str, name: &str, formula: &str, dimension: Dimension, clause: &str) -> f64 {
        let evaluated = Formula::cached(formula).and_then(|parsed| {
            let latest = |symbol: &str| self.known.iter().rev().find(|known| known.0 == symbol);
            let terms: Vec<Term> = parsed.symbols().filter_map(latest).map(|(s, v, d)| (s.as_str(), *v, *d)).collect();
            let value = parsed.value(&terms)?;
            Ok((value, if LINES.get() { parsed.substitution(&terms) } else { String::new() }))
        });
        let (value, substitution) = evaluated.unwrap_or_else(|error| {
            self.fault.get_or_insert(error);
            (f64::NAN, String::new())
        });
        let line = || Step { formula: formula.into(), substitution, ..Step::default() };
        self.push(symbol, name, value, dimension, clause, line)
    }

    /// Adds a value that no formula of the sheet gives: one from a table, a figure, a spectrum, a series, an iteration or
    /// an integral. `source` names it in words. Returns the value.
    pub fn look_up(
        &mut self,
        symbol: &str,
        name: &str,
        source: &str,
        value: f64,
        dimension: Dimension,
        clause: &str,
    ) -> f64 {
        let line = || Step { look_up: source.into(), ..Step::default() };
        self.push(symbol, name, value, dimension, clause, line)
    }

    /// Adds the rest of a line, where lines are kept. Returns the value.
    fn push(
        &mut self,
        symbol: &str,
        name: &str,
        value: f64,
        dimension: Dimension,
        clause: &str,
        line: impl FnOnce() -> Step,
    ) -> f64 {
        self.given(&[(symbol, value, dimension)]);
        if let Some(recalled) = clause.strip_suffix(RECALLED)
            && self.recalled.iter().all(|known| known != recalled)
        {
            self.recalled.push(recalled.into());
        }
        if LINES.get() {
            let (symbol, name, clause, section) = (symbol.into(), name.into(), clause.into(), self.section.clone());
            self.steps.push(Step { section, symbol, name, value, dimension, clause, ..line() });
        }
        value
    }

    /// Clauses of the lines that are recalled, each once: printed as such, they count as such.
    pub fn recalled(&self) -> &[String] {
        &self.recalled
    }

    /// The lines.
    ///
    /// Errors: the first formula that does not parse or names a symbol without a value. No input leads there: each
    /// formula is part of a procedure, and the tests run them all.
    pub fn into_steps(self) -> Result<Vec<Step>, FormulaError> {
        match self.fault {
            Some(fault) => Err(fault),
            None => Ok(self.steps),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_faulty_formula_is_an_error() {
        for (formula, fault) in [
            ("a·", "`a·`: found the end at character 3"),
            ("a·b", "`a·b`: no value given for `b`"),
            ("f(a)", "`f(a)`: no function `f` of 1 arguments"),
        ] {
            let mut sheet = Sheet::new();
            sheet.given(&[("a", 1.0, Dimension::Length)]);
            let value = sheet.calc("x", "", formula, Dimension::Length, "");
            assert!(value.is_nan());
            let error = sheet.into_steps().unwrap_err().to_string();
            assert!(error.starts_with(fault), "{error}");
        }
    }

    /// Without lines: the same values, and a faulty formula still is an error.
    #[test]
    fn without_lines_the_values_are_the_same() {
        let compute = |formula: &str| {
            let mut sheet = Sheet::new();
            sheet.input("a", "", 2.0, Dimension::Length, "tank");
            sheet.look_up("b", "", "table 1", 3.0, Dimension::Length, "");
            let c = sheet.calc("c", "", formula, Dimension::Length, "");
            (c, sheet.into_steps())
        };
        let (with, lines) = compute("a·b");
        let (without, none) = without_lines(|| compute("a·b"));
        assert_eq!((with, lines.unwrap().len()), (without, 3));
        assert!(none.unwrap().is_empty());
        assert!(without_lines(|| compute("a·d")).1.is_err());
        assert_eq!(compute("a·b").1.unwrap().len(), 3);
    }

    /// A line printed as recalled counts as recalled, once, also where no lines are kept.
    #[test]
    fn recalled_lines_are_known() {
        let compute = || {
            let mut sheet = Sheet::new();
            sheet.input("R", "", 2.0, Dimension::Dimensionless, "code 4.1, recalled");
            sheet.look_up("I", "", "table", 1.0, Dimension::Dimensionless, "code 4.1, recalled");
            sheet.calc("A", "", "I/R", Dimension::Dimensionless, "code 4.2");
            sheet.recalled().to_vec()
        };
        assert_eq!(compute(), ["code 4.1"]);
        assert_eq!(without_lines(compute), ["code 4.1"]);
    }

    /// The last line that gives a symbol counts, and a given value like a line.
    #[test]
    fn the_latest_value_counts() {
        let mut sheet = Sheet::new();
        sheet.input("t", "", 2.0, Dimension::Length, "course 1");
        let first = sheet.calc("d", "", "2·t", Dimension::Length, "");
        sheet.given(&[("t", 3.0, Dimension::Length)]);
        let second = sheet.calc("d", "", "2·t", Dimension::Length, "");
        let third = sheet.calc("e", "", "d/t", Dimension::Dimensionless, "");
        assert_eq!((first, second, third), (4.0, 6.0, 2.0));
    }

    #[test]
    fn kinds_of_lines() {
        let mut sheet = Sheet::new();
        sheet.section("first");
        let a = sheet.input("a", "", 2.0, Dimension::Length, "tank");
        sheet.section("second");
        let b = sheet.look_up("b", "", "table 1", 3.0, Dimension::Length, "");
        let c = sheet.calc("c", "", "a + b", Dimension::Length, "");
        let steps = sheet.into_steps().unwrap();
        assert_eq!((a, b, c), (2.0, 3.0, 5.0));
        let kinds: Vec<_> = steps
            .iter()
            .map(|s| (s.section.as_str(), s.formula.as_str(), s.substitution.as_str(), s.look_up.as_str()))
            .collect();
        assert_eq!(kinds, [("first", "", "", ""), ("second", "", "", "table 1"), ("second", "a + b", "2 m + 3 m", "")]);
    }
}
