//! Formulas of calculation sheets as formulas of a spreadsheet, over the cells of the lines above.
//!
//! The sheet may put a number for a symbol that no line above gives under that symbol: `A_i` is the spectral acceleration of a line above, `p_h` a
//! pressure at another height. The formula then contains the number, or the cell of the line with this value.

use tank::assessment::Step;
use tank::formula::{Bracket, Formula, Operator, Power, Primary, Product, Sign, Sum};
use tank::units::Dimension;

/// Largest relative difference between a value and that of its formula, some of whose numbers have five digits.
const SAME: f64 = 2e-4;
/// Largest relative difference of a number that is put in from the value of its line.
const PUT_IN: f64 = 2e-5;

/// A symbol of a formula: its value, and the line above that has it; none of a number alone.
struct Meaning<'a> {
    symbol: &'a str,
    value: f64,
    line: Option<usize>,
}

/// The formula of the line at `place` over the cells that hold the values of the lines above in SI, and over numbers that no line above has;
/// none where the line has no formula.
///
/// * `cell`: address of the cell of a line
pub(super) fn of_line(steps: &[Step], place: usize, cell: &dyn Fn(usize) -> String) -> Option<String> {
    let (above, step) = (&steps[..place], &steps[place]);
    let formula = Formula::parse(&step.formula).ok()?;
    let numbers = Formula::parse(&step.substitution).ok()?;
    let (mut symbols, mut put_in) = (Vec::new(), Vec::new());
    leaves(formula.tree(), &mut symbols);
    leaves(numbers.tree(), &mut put_in);
    if symbols.len() != put_in.len() {
        return None;
    }
    let mut meanings: Vec<Meaning> = Vec::new();
    for pair in symbols.into_iter().zip(put_in) {
        if let (Primary::Symbol(symbol), Primary::Number(number)) = pair {
            meanings.push(meaning(above, symbol, number.value));
        }
    }
    let terms: Vec<(&str, f64, Dimension)> =
        meanings.iter().map(|m| (m.symbol, m.value, Dimension::Dimensionless)).collect();
    let value = formula.value(&terms).ok()?;
    if (value - step.value).abs() > SAME * step.value.abs() {
        return None;
    }
    let written = |name: &str| {
        let own = meanings.iter().find(|meaning| meaning.symbol == name)?;
        Some(own.line.map_or_else(|| own.value.to_string(), cell))
    };
    sum(formula.tree(), &written)
}

/// What a symbol stands for that is put in as this number: the nearest line above of this symbol, else the nearest of this value, else the
/// number. A number of three digits may be that of many lines.
fn meaning<'a>(above: &[Step], symbol: &'a str, number: f64) -> Meaning<'a> {
    let close = |step: &Step| (step.value - number).abs() <= PUT_IN * number.abs();
    let named = above.iter().rposition(|step| step.symbol == symbol).filter(|line| close(&above[*line]));
    let three: f64 = format!("{number:.2e}").parse().unwrap_or(number);
    let telling = (three - number).abs() > PUT_IN * number.abs();
    let line = named.or_else(|| above.iter().rposition(close).filter(|_| telling));
    Meaning { symbol, value: line.map_or(number, |line| above[line].value), line }
}

/// Symbols and numbers of a formula in their order.
fn leaves<'t>(tree: &'t Sum, out: &mut Vec<&'t Primary>) {
    let primary = |leaf: &'t Primary, out: &mut Vec<&'t Primary>| match leaf {
        Primary::Group(_, inner) => leaves(inner, out),
        Primary::Call(_, arguments) => arguments.iter().for_each(|argument| leaves(argument, out)),
        leaf => out.push(leaf),
    };
    for (_, product) in &tree.0 {
        for mut power in std::iter::once(&product.first).chain(product.rest.iter().map(|(_, power)| power)) {
            while let Power::Root(under) = power {
                power = under.as_ref();
            }
            match power {
                Power::Plain(base) | Power::Raised(base, _) => primary(base, out),
                Power::To { base, exponent, .. } => {
                    primary(base, out);
                    primary(exponent, out);
                }
                Power::Root(_) => {}
            }
        }
    }
}

/// Writes a symbol.
type Symbol<'a> = dyn Fn(&str) -> Option<String> + 'a;

fn sum(tree: &Sum, symbol: &Symbol<'_>) -> Option<String> {
    let mut out = String::new();
    for (i, (sign, term)) in tree.0.iter().enumerate() {
        match sign {
            Sign::Minus => out.push('-'),
            Sign::Plus if i > 0 => out.push('+'),
            Sign::Plus => {}
        }
        out.push_str(&product(term, symbol)?);
    }
    // A minus in front binds a spreadsheet's powers more tightly.
    Some(if out.starts_with('-') { format!("0{out}") } else { out })
}

fn product(tree: &Product, symbol: &Symbol<'_>) -> Option<String> {
    let mut out = power(&tree.first, symbol)?;
    for (operator, factor) in &tree.rest {
        out.push(match operator {
            Operator::Times => '*',
            Operator::Over => '/',
        });
        out.push_str(&power(factor, symbol)?);
    }
    Some(out)
}

fn power(tree: &Power, symbol: &Symbol<'_>) -> Option<String> {
    Some(match tree {
        Power::Plain(base) => primary(base, symbol)?,
        Power::Root(under) => format!("SQRT({})", power(under, symbol)?),
        Power::Raised(base, exponent) => format!("{}^({exponent})", primary(base, symbol)?),
        Power::To { base, minus, exponent } => {
            let sign = if *minus { "-" } else { "" };
            format!("{}^({sign}{})", primary(base, symbol)?, primary(exponent, symbol)?)
        }
    })
}

fn primary(tree: &Primary, symbol: &Symbol<'_>) -> Option<String> {
    Some(match tree {
        Primary::Number(number) => number.value.to_string(),
        Primary::Symbol(name) => match symbol(name) {
            None if name == "π" => "PI()".into(),
            cell => cell?,
        },
        Primary::Group(Bracket::Bar, inner) => format!("ABS({})", sum(inner, symbol)?),
        Primary::Group(_, inner) => format!("({})", sum(inner, symbol)?),
        Primary::Call(name, arguments) => {
            let arguments: Option<Vec<String>> = arguments.iter().map(|argument| sum(argument, symbol)).collect();
            let arguments = arguments?.join(",");
            match name.as_str() {
                "I₀" => format!("BESSELI({arguments},0)"),
                "I₁" => format!("BESSELI({arguments},1)"),
                name => format!("{}({arguments})", name.to_uppercase()),
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(symbol: &str, formula: &str, substitution: &str, value: f64) -> Step {
        Step {
            symbol: symbol.into(),
            formula: formula.into(),
            substitution: substitution.into(),
            value,
            ..Step::default()
        }
    }

    #[test]
    fn a_formula_refers_to_the_lines_above() {
        let steps = [
            step("t", "", "", 1.0),
            step("t", "", "", 2.0),
            step("p", "", "", 3.0),
            step("S", "", "", 4.1234567),
            step("σ", "p·(t + 1)²/√(t²) - |p|", "3·(2 + 1)²/√(2²) - |3|", 3.0 * 9.0 / 2.0 - 3.0),
            step("m", "-min(t, π)^0.5", "-min(2, π)^0.5", -(2.0_f64.sqrt())),
            step("Q", "p·A", "3·4.1235", 3.0 * 4.1234567),
            step("y", "p·k", "3·7.5", 22.5),
            step("z", "p·t", "3·2", 7.0),
        ];
        let found = |place| of_line(&steps, place, &|line| format!("J{}", line + 2));
        assert_eq!(found(4).as_deref(), Some("J4*(J3+1)^(2)/SQRT((J3^(2)))-ABS(J4)"));
        assert_eq!(found(5).as_deref(), Some("0-MIN(J3,PI())^(0.5)"));
        // A is the line of its value; k is a number that no line has.
        assert_eq!(found(6).as_deref(), Some("J4*J5"));
        assert_eq!(found(7).as_deref(), Some("J4*7.5"));
        // Another value than that of the formula; a given value.
        assert_eq!([found(8), found(0)], [None, None]);
    }
}
