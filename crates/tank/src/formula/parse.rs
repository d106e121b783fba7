//! Tokens → tree: one function for each level of the grammar.

use std::ops::Range;

use super::error::FormulaError;
use super::lex::{Token, tokens};
use super::tree::{Bracket, Operator, Place, Power, Primary, Product, Sign, Sum};

/// Parses a text: its tree, and where its symbols stand.
pub(super) fn formula(text: &str) -> Result<(Sum, Vec<Place>), FormulaError> {
    let tokens = tokens(text);
    let mut parser = Parser { text, tokens: &tokens, at: 0, depth: 0, symbols: Vec::new() };
    let tree = parser.sum()?;
    if parser.at < tokens.len() {
        return Err(parser.unexpected("an operator or the end"));
    }
    Ok((tree, parser.symbols))
}

/// Levels of parentheses, roots and exponents; the deepest formula of the sheets has seven.
const DEEPEST: usize = 60;

struct Parser<'a> {
    text: &'a str,
    tokens: &'a [(Token, Range<usize>)],
    at: usize,
    depth: usize,
    symbols: Vec<Place>,
}

impl Parser<'_> {
    fn unexpected(&self, expected: &'static str) -> FormulaError {
        let (found, byte) = match self.tokens.get(self.at) {
            Some((_, at)) => (format!("`{}`", &self.text[at.clone()]), at.start),
            None => ("the end".into(), self.text.len()),
        };
        FormulaError::Unexpected {
            formula: self.text.into(),
            at: self.text[..byte].chars().count() + 1,
            found,
            expected,
        }
    }

    fn sign(&self) -> Option<char> {
        match self.tokens.get(self.at) {
            Some((Token::Sign(c), _)) => Some(*c),
            _ => None,
        }
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.sign() == Some(c);
        self.at += usize::from(found);
        found
    }

    /// Runs a part of the grammar that may hold itself.
    fn deeper<T>(&mut self, part: impl FnOnce(&mut Self) -> Result<T, FormulaError>) -> Result<T, FormulaError> {
        if self.depth == DEEPEST {
            return Err(FormulaError::TooDeep { formula: self.text.into(), limit: DEEPEST });
        }
        self.depth += 1;
        let out = part(self);
        self.depth -= 1;
        out
    }

    fn sum(&mut self) -> Result<Sum, FormulaError> {
        let mut sign = if self.eat('−') { Sign::Minus } else { Sign::Plus };
        let mut terms = Vec::new();
        loop {
            terms.push((sign, self.product()?));
            sign = if self.eat('+') {
                Sign::Plus
            } else if self.eat('−') {
                Sign::Minus
            } else {
                return Ok(Sum(terms));
            };
        }
    }

    fn product(&mut self) -> Result<Product, FormulaError> {
        let first = self.power()?;
        let mut rest = Vec::new();
        loop {
            let operator = if self.eat('·') {
                Operator::Times
            } else if self.eat('/') {
                Operator::Over
            } else {
                return Ok(Product { first, rest });
            };
            rest.push((operator, self.power()?));
        }
    }

    fn power(&mut self) -> Result<Power, FormulaError> {
        if self.eat('√') {
            return Ok(Power::Root(Box::new(self.deeper(Self::power)?)));
        }
        let base = self.primary()?;
        if let Some((Token::Raised(exponent), _)) = self.tokens.get(self.at) {
            self.at += 1;
            self.mark_raised();
            return Ok(Power::Raised(base, *exponent));
        }
        if self.eat('^') {
            self.mark_raised();
            let minus = self.eat('−');
            let exponent = self.primary()?;
            return Ok(Power::To { base, minus, exponent });
        }
        Ok(Power::Plain(base))
    }

    /// Notes that the exponent just read belongs to the symbol before it, if it was one.
    fn mark_raised(&mut self) {
        let end = self.tokens[self.at - 1].1.start;
        if let Some(place) = self.symbols.last_mut().filter(|p| p.at.end == end) {
            place.raised = true;
        }
    }

    fn primary(&mut self) -> Result<Primary, FormulaError> {
        const EXPECTED: &str = "a number, a symbol, a function or an opening bracket";
        let Some((token, at)) = self.tokens.get(self.at) else { return Err(self.unexpected(EXPECTED)) };
        let bracket = match token {
            Token::Number(number) => {
                self.at += 1;
                return Ok(Primary::Number(number.clone()));
            }
            Token::Symbol(name) => {
                self.at += 1;
                if self.eat('(') {
                    return self.deeper(|p| p.arguments(name));
                }
                self.symbols.push(Place { at: at.clone(), raised: false });
                return Ok(Primary::Symbol(name.clone()));
            }
            Token::Sign('(') => Bracket::Round,
            Token::Sign('[') => Bracket::Square,
            Token::Sign('|') => Bracket::Bar,
            _ => return Err(self.unexpected(EXPECTED)),
        };
        self.at += 1;
        let sum = self.deeper(Self::sum)?;
        if !self.eat(bracket.pair().1) {
            return Err(self.unexpected("an operator or the closing bracket"));
        }
        Ok(Primary::Group(bracket, Box::new(sum)))
    }

    /// The arguments of a function behind its opening parenthesis, and the closing one.
    fn arguments(&mut self, name: &str) -> Result<Primary, FormulaError> {
        let mut arguments = vec![self.sum()?];
        while self.eat(',') || self.eat(';') {
            arguments.push(self.sum()?);
        }
        if !self.eat(')') {
            return Err(self.unexpected("an operator, a comma or the closing parenthesis"));
        }
        Ok(Primary::Call(name.into(), arguments))
    }
}
