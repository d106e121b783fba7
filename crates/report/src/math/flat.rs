//! Formulas on one line: quotients with a stroke, roots with parentheses, as they are written in the results.

use tank::formula::{Bracket, Formula, Operator, Power, Primary, Product, Sign, Sum};

use super::{Set, identifier, leading, operator, quantity, words};

/// Characters from which a piece may end.
const PIECE: usize = 9;

/// The formula as HTML that wraps between its pieces; text that is not a formula is set as words.
///
/// ```
/// let html = report::math::line("a/(b + c)");
/// assert_eq!(html.matches("<math>").count(), 1);
/// assert!(html.contains("<mi>a</mi><mtext>/</mtext>"));
/// ```
pub fn line(text: &str) -> String {
    let Ok(formula) = Formula::parse(text) else { return words(text) };
    let mut tokens = Vec::new();
    sum(&mut tokens, formula.tree());
    let mut pieces: Vec<Set> = Vec::new();
    for Token { set, breaks } in tokens {
        match pieces.last_mut() {
            Some(piece) if !breaks || piece.width < PIECE => {
                piece.markup.push_str(&set.markup);
                piece.width += set.width;
            }
            _ => pieces.push(set),
        }
    }
    pieces.iter().map(|piece| format!("<math>{}</math>", piece.markup)).collect()
}

/// A piece of a formula.
struct Token {
    set: Set,
    /// Whether a line may be broken before it.
    breaks: bool,
}

/// Puts a token that stays on the line of the one before it.
fn put(tokens: &mut Vec<Token>, set: Set) {
    tokens.push(Token { set, breaks: false });
}

/// The sign between two factors, as text: an operator has blanks on both sides, which a line has no room for.
fn tight(sign: char) -> Set {
    Set::new(format!("<mtext>{sign}</mtext>"), 1)
}

fn sum(tokens: &mut Vec<Token>, sum: &Sum) {
    for (i, (sign, product)) in sum.0.iter().enumerate() {
        match (i, sign) {
            (0, Sign::Minus) => put(tokens, Set::new("<mo form=\"prefix\">−</mo>".into(), 1)),
            (0, _) => {}
            _ => tokens.push(Token { set: Set::new(leading(sign.char()), 3), breaks: true }),
        }
        self::product(tokens, product);
    }
}

fn product(tokens: &mut Vec<Token>, product: &Product) {
    power(tokens, &product.first);
    for (sign, factor) in &product.rest {
        match sign {
            Operator::Times => tokens.push(Token { set: tight('·'), breaks: true }),
            Operator::Over => put(tokens, tight('/')),
        }
        power(tokens, factor);
    }
}

fn power(tokens: &mut Vec<Token>, power: &Power) {
    match power {
        Power::Plain(primary) => self::primary(tokens, primary),
        Power::Root(under) => {
            put(tokens, Set::new("<mo form=\"prefix\">√</mo>".into(), 1));
            self::power(tokens, under);
        }
        Power::Raised(base, exponent) => {
            primary(tokens, base);
            raise(tokens, &format!("<mn>{}</mn>", exponent.to_string().replace('-', "−")), 1);
        }
        Power::To { base, minus, exponent } => {
            primary(tokens, base);
            let mut above = Vec::new();
            match exponent {
                Primary::Group(Bracket::Round, inside) => sum(&mut above, inside),
                exponent => primary(&mut above, exponent),
            }
            let width = above.iter().map(|token| token.set.width).sum();
            let above: String = above.into_iter().map(|token| token.set.markup).collect();
            let sign = if *minus { "<mo form=\"prefix\">−</mo>" } else { "" };
            raise(tokens, &format!("<mrow>{sign}{above}</mrow>"), width);
        }
    }
}

/// Sets an exponent on the last token: a symbol, a number, or the parenthesis that closes a group.
fn raise(tokens: &mut [Token], exponent: &str, width: usize) {
    if let Some(last) = tokens.last_mut() {
        last.set.markup = format!("<msup>{}{exponent}</msup>", last.set.markup);
        last.set.width += width;
    }
}

fn primary(tokens: &mut Vec<Token>, primary: &Primary) {
    match primary {
        Primary::Number(number) => put(tokens, quantity(number)),
        Primary::Symbol(name) => put(tokens, identifier(name)),
        Primary::Call(name, arguments) => {
            put(tokens, identifier(name));
            bracket(tokens, Bracket::Round.pair().0);
            for (i, argument) in arguments.iter().enumerate() {
                if i > 0 {
                    put(tokens, Set::new(operator(','), 1));
                }
                sum(tokens, argument);
            }
            bracket(tokens, Bracket::Round.pair().1);
        }
        Primary::Group(kind, inside) => {
            bracket(tokens, kind.pair().0);
            sum(tokens, inside);
            bracket(tokens, kind.pair().1);
        }
    }
}

fn bracket(tokens: &mut Vec<Token>, sign: char) {
    put(tokens, Set::new(format!("<mo stretchy=\"false\">{sign}</mo>"), 1));
}

#[cfg(test)]
mod tests {
    use super::line;

    /// The characters between the tags.
    fn plain(html: &str) -> String {
        let parts = html.split('<').map(|part| part.split_once('>').map_or(part, |(_, text)| text));
        parts.collect()
    }

    #[test]
    fn a_line_reads_as_the_formula_is_written() {
        for text in ["2·R/(q·√(ρ·H/(E·s)))", "max(a, b) + c", "−a·[b + c]/d", "cosh(x·(1 − y))"] {
            assert_eq!(plain(&line(text)), text.replace(' ', ""));
        }
    }

    #[test]
    fn exponents_stand_on_what_they_raise() {
        let html = line("(a + b)²/c^1.15");
        assert!(html.contains("<msup><mo stretchy=\"false\">)</mo><mn>2</mn></msup>"), "{html}");
        assert!(html.contains("<msup><mi>c</mi><mrow><mn>1.15</mn></mrow></msup>"), "{html}");
        assert!(
            line("e^(−x/2)").contains("<mrow><mo form=\"prefix\">−</mo><mi>x</mi><mtext>/</mtext><mn>2</mn></mrow>")
        );
    }

    #[test]
    fn a_line_may_be_broken_before_a_sign_and_never_before_a_stroke() {
        let html = line("1.4122 m/s²·1.2·2.5·1.3484·0.5 s·2 s/(3.8874 s)²");
        assert!(html.matches("<math>").count() > 2, "{html}");
        for piece in html.split("<math>").skip(2) {
            assert!(piece.starts_with("<mtext>·</mtext>"), "{piece}");
        }
    }

    #[test]
    fn what_is_not_a_formula_is_set_as_words() {
        assert!(line("a by table").starts_with("<span"));
    }
}
