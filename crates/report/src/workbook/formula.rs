//! Formulas of calculation sheets as formulas of a spreadsheet, over the cells of the lines above.

use tank::assessment::Step;
use tank::formula::{Bracket, Formula, Operator, Power, Primary, Product, Sign, Sum};
use tank::units::Dimension;

/// Largest relative difference between a value and that of its formula over the lines above.
const SAME: f64 = 1e-7;

/// The formula of the line at `place` over the cells that hold the values of the lines above in SI; none where the line has no formula, or one
/// with a symbol whose value is not that of a line above.
///
/// * `cell`: address of the cell of a line
pub(super) fn of_line(steps: &[Step], place: usize, cell: &dyn Fn(usize) -> String) -> Option<String> {
    let (above, step) = (&steps[..place], &steps[place]);
    let formula = Formula::parse(&step.formula).ok()?;
    let line = |symbol: &str| above.iter().rposition(|step| step.symbol == symbol);
    let terms: Vec<(&str, f64, Dimension)> = (formula.symbols())
        .filter_map(|symbol| line(symbol).map(|line| (symbol, above[line].value, above[line].dimension)))
        .collect();
    let value = formula.value(&terms).ok()?;
    if (value - step.value).abs() > SAME * step.value.abs() {
        return None;
    }
    let symbol = |name: &str| line(name).map(cell);
    sum(formula.tree(), &symbol)
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

    fn step(symbol: &str, formula: &str, value: f64) -> Step {
        Step { symbol: symbol.into(), formula: formula.into(), value, ..Step::default() }
    }

    #[test]
    fn a_formula_refers_to_the_nearest_line_above() {
        let steps = [
            step("t", "", 1.0),
            step("t", "", 2.0),
            step("p", "", 3.0),
            step("σ", "p·(t + 1)²/√(t²) - |p|", 3.0 * 9.0 / 2.0 - 3.0),
            step("m", "-min(t, π)^0.5", -(2.0_f64.sqrt())),
            step("x", "p·t", 7.0),
            step("y", "p·k", 3.0),
        ];
        let found = |place| of_line(&steps, place, &|line| format!("J{}", line + 2));
        assert_eq!(found(3).as_deref(), Some("J4*(J3+1)^(2)/SQRT((J3^(2)))-ABS(J4)"));
        assert_eq!(found(4).as_deref(), Some("0-MIN(J3,PI())^(0.5)"));
        // Computed with another value than that above; with a value that no line has; given.
        assert_eq!([found(5), found(6), found(0)], [None, None, None]);
    }
}
