//! Tree → value.

use std::f64::consts::PI;

use spec_math::cephes64;

use super::error::FormulaError;
use super::tree::{Bracket, Operator, Power, Primary, Product, Sign, Sum};
use crate::units::Dimension;

/// A value that stands in a formula: symbol, value in SI, dimension.
pub type Term<'a> = (&'a str, f64, Dimension);

/// Value of the tree of a formula.
pub(super) fn of(formula: &str, tree: &Sum, terms: &[Term]) -> Result<f64, FormulaError> {
    Reader { formula, terms }.sum(tree)
}

struct Reader<'a> {
    formula: &'a str,
    terms: &'a [Term<'a>],
}

impl Reader<'_> {
    fn sum(&self, sum: &Sum) -> Result<f64, FormulaError> {
        let mut value = None;
        for (sign, product) in &sum.0 {
            let next = match sign {
                Sign::Plus => self.product(product)?,
                Sign::Minus => -self.product(product)?,
            };
            value = Some(value.map_or(next, |before: f64| before + next));
        }
        Ok(value.unwrap_or(0.0))
    }

    fn product(&self, product: &Product) -> Result<f64, FormulaError> {
        let mut value = self.power(&product.first)?;
        for (operator, factor) in &product.rest {
            let factor = self.power(factor)?;
            match operator {
                Operator::Times => value *= factor,
                Operator::Over => value /= factor,
            }
        }
        Ok(value)
    }

    fn power(&self, power: &Power) -> Result<f64, FormulaError> {
        Ok(match power {
            Power::Plain(primary) => self.primary(primary)?,
            Power::Root(under) => self.power(under)?.sqrt(),
            Power::Raised(base, exponent) => self.primary(base)?.powi(*exponent),
            Power::To { base, minus, exponent } => {
                let exponent = self.primary(exponent)?;
                self.primary(base)?.powf(if *minus { -exponent } else { exponent })
            }
        })
    }

    fn primary(&self, primary: &Primary) -> Result<f64, FormulaError> {
        match primary {
            Primary::Number(number) => Ok(number.value),
            Primary::Symbol(name) => self.symbol(name),
            Primary::Call(name, arguments) => self.call(name, arguments),
            Primary::Group(Bracket::Bar, sum) => Ok(self.sum(sum)?.abs()),
            Primary::Group(_, sum) => self.sum(sum),
        }
    }

    fn symbol(&self, name: &str) -> Result<f64, FormulaError> {
        match self.terms.iter().find(|(symbol, _, _)| *symbol == name) {
            Some((_, value, _)) => Ok(*value),
            None if name == "π" => Ok(PI),
            None => Err(FormulaError::NoValue { formula: self.formula.into(), symbol: name.into() }),
        }
    }

    fn call(&self, name: &str, arguments: &[Sum]) -> Result<f64, FormulaError> {
        let missing =
            || FormulaError::NoFunction { formula: self.formula.into(), name: name.into(), arguments: arguments.len() };
        let values = || arguments.iter().map(|a| self.sum(a));
        let fold = |choose: fn(f64, f64) -> f64, start: f64| {
            values().try_fold(start, |chosen, value| Ok(choose(chosen, value?)))
        };
        let function: fn(f64) -> f64 = match name {
            "min" => return fold(f64::min, f64::INFINITY),
            "max" => return fold(f64::max, f64::NEG_INFINITY),
            "tanh" => f64::tanh,
            "cosh" => f64::cosh,
            "sinh" => f64::sinh,
            "tan" => f64::tan,
            "cos" => f64::cos,
            "sin" => f64::sin,
            "exp" => f64::exp,
            "ln" => f64::ln,
            "I₀" => cephes64::i0,
            "I₁" => cephes64::i1,
            _ => return Err(missing()),
        };
        match arguments {
            [argument] => Ok(function(self.sum(argument)?)),
            _ => Err(missing()),
        }
    }
}
