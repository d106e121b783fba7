//! Formulas of calculation sheets, set as MathML.
//!
//! A formula is read by [`tank::formula`], whose tree is set here: quotients as fractions, roots, raised exponents,
//! symbols with their subscripts. It is broken before `+` and `−` (and before `·` where it is long) into pieces that wrap
//! like words. Text that is not a formula is set as words with raised and lowered letters, without loss. [`line`] sets
//! the same formula on one line, quotients with a stroke.

mod flat;

pub use flat::line;

use tank::formula::{Bracket, Formula, Number, Operator, Power, Primary, Product, Sign, Sum};

use super::figure::svg::escape;

/// Longest piece that is not broken further, in characters.
const LONG: usize = 26;
/// Widest piece that fits its column, in characters.
const WIDEST: usize = 52;

/// The formula as HTML.
///
/// Its values with units stay in SI in every report: the constants of a code's formula may have a unit that is not written
/// (`C_c` in s/√m), and hold in SI alone.
pub fn formula(text: &str) -> String {
    let Ok(formula) = Formula::parse(text) else { return words(text) };
    let pieces = pieces(formula.tree());
    if pieces.iter().any(|p| p.width > WIDEST) {
        return words(text);
    }
    pieces.iter().map(|p| format!("<math displaystyle=\"true\">{}</math>", p.markup)).collect::<Vec<_>>().join(" ")
}

/// A symbol (`m_c`, `h_i′`) as HTML.
pub fn symbol(text: &str) -> String {
    formula(text)
}

/// A sentence as HTML: escaped, words in backquotes as code, short symbols (`S_e`, `T_c1`, `d_max`) with their subscripts; keys of the
/// input file (`zone_factor`) stay unchanged. A backquote without its partner stays as it is.
pub fn prose(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some((before, (code, after))) =
        rest.split_once('`').and_then(|(before, after)| after.split_once('`').map(|pair| (before, pair)))
    {
        out.push_str(&lowered(before));
        out.push_str(&format!("<code>{}</code>", escape(code)));
        rest = after;
    }
    out.push_str(&lowered(rest));
    out
}

/// Escaped text with short symbols lowered.
fn lowered(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some(at) = rest.find('_') {
        let (before, after) = (&rest[..at], &rest[at + 1..]);
        let base = before.chars().rev().take_while(|&c| in_symbol(c) || c == '.').count();
        let end = after.find(|c| !in_symbol(c)).unwrap_or(after.len());
        let sub = &after[..end];
        out.push_str(&escape(before));
        if (1..=2).contains(&base) && (1..=4).contains(&sub.chars().count()) && !sub.contains('_') {
            out.push_str(&format!("<sub>{}</sub>", escape(sub)));
            rest = &after[end..];
        } else {
            // The whole word stays, with all its underscores.
            out.push('_');
            out.push_str(&escape(sub));
            rest = &after[end..];
        }
    }
    out.push_str(&escape(rest));
    out
}

/// Words with subscripts, for text that is not a formula.
pub fn words(text: &str) -> String {
    let mut out = String::from("<span class=\"words\">");
    let chars: Vec<char> = text.chars().collect();
    let mut i = 0;
    while i < chars.len() {
        let c = chars[i];
        if c == '_' && i > 0 && chars[i - 1].is_alphanumeric() {
            let end = (i + 1..chars.len()).find(|&j| !in_symbol(chars[j])).unwrap_or(chars.len());
            if end > i + 1 {
                let sub: String = chars[i + 1..end].iter().collect();
                out.push_str(&format!("<sub>{}</sub>", escape(&sub)));
                i = end;
                continue;
            }
        }
        out.push_str(&escape(&c.to_string()));
        // Not behind a decimal comma.
        let digit = |at: Option<usize>| at.and_then(|j| chars.get(j)).is_some_and(char::is_ascii_digit);
        let decimal = c == ',' && digit(i.checked_sub(1)) && digit(Some(i + 1));
        if matches!(c, '·' | '/' | '+' | '=' | ',') && !decimal {
            out.push_str("<wbr>");
        }
        i += 1;
    }
    out.push_str("</span>");
    out
}

fn in_symbol(c: char) -> bool {
    let raised = matches!(c, '²' | '³' | '¹' | '⁰' | '⁴'..='⁹' | '⁺' | '⁻' | 'ⁿ');
    (c.is_alphanumeric() && !raised && !matches!(c, '¼'..='¾'))
        || matches!(c, '_' | '′' | '″' | '\u{304}' | '\u{307}' | '\u{308}')
}

/// Set markup and its width in characters.
#[derive(Clone, Debug, PartialEq)]
struct Set {
    markup: String,
    width: usize,
    /// The terms of a parenthesised group.
    terms: Vec<Set>,
}

impl Set {
    fn new(markup: String, width: usize) -> Set {
        Set { markup, width, terms: Vec::new() }
    }

    /// Without its parentheses, where a fraction bar or a root makes them idle.
    fn bare(self) -> Set {
        if self.terms.is_empty() {
            return self;
        }
        let inside: String = self.terms.iter().map(|t| t.markup.as_str()).collect();
        Set::new(format!("<mrow>{inside}</mrow>"), self.width.saturating_sub(2))
    }
}

/// The whole formula as pieces.
fn pieces(sum: &Sum) -> Vec<Set> {
    let mut pieces: Vec<Set> = Vec::new();
    for (i, (sign, product)) in sum.0.iter().enumerate() {
        let mut lead = if i == 0 { String::new() } else { leading(sign.char()) };
        let factors = factors(i == 0 && *sign == Sign::Minus, product);
        let width: usize = factors.iter().map(|f| f.width).sum();
        if width <= LONG {
            let product = join(factors);
            pieces.push(Set::new(lead + &product.markup, width + 1));
            continue;
        }
        for factor in factors {
            pieces.extend(broken(lead, factor));
            lead = leading('·');
        }
    }
    pieces
}

/// The terms of a sum within brackets, each with its sign.
fn terms(sum: &Sum) -> Vec<Set> {
    let term = |(i, (sign, product)): (usize, &(Sign, Product))| {
        let set = join(factors(i == 0 && *sign == Sign::Minus, product));
        if i == 0 {
            Set::new(set.markup, set.width)
        } else {
            Set::new(leading(sign.char()) + &set.markup, set.width + 2)
        }
    };
    sum.0.iter().enumerate().map(term).collect()
}

/// The factors of a product; quotients are already fractions.
fn factors(minus: bool, product: &Product) -> Vec<Set> {
    let mut first = power(&product.first);
    if minus {
        first = Set::new(format!("<mo form=\"prefix\">−</mo>{}", first.markup), first.width + 1);
    }
    let mut factors = vec![first];
    for (operator, factor) in &product.rest {
        let factor = power(factor);
        if *operator == Operator::Times {
            factors.push(factor);
            continue;
        }
        // a·b/c is (a·b)/c; long products keep their other factors outside the bar.
        let above = match factors.pop() {
            Some(last) if factors.len() == 1 => join(vec![factors.remove(0), last]),
            Some(last) => last.bare(),
            None => Set::new(String::new(), 0),
        };
        factors.push(fraction(&above, &factor.bare()));
    }
    factors
}

fn power(power: &Power) -> Set {
    match power {
        Power::Plain(primary) => set(primary),
        Power::Root(under) => {
            let under = self::power(under).bare();
            Set::new(format!("<msqrt>{}</msqrt>", under.markup), under.width + 2)
        }
        Power::Raised(base, exponent) => {
            let exponent = exponent.to_string().replace('-', "−");
            raised(&set(base), &format!("<mn>{exponent}</mn>"), 1)
        }
        Power::To { base, minus, exponent } => {
            let exponent = set(exponent).bare();
            let sign = if *minus { "<mo form=\"prefix\">−</mo>" } else { "" };
            let markup = format!("<mrow>{sign}{}</mrow>", exponent.markup);
            raised(&set(base), &markup, exponent.width)
        }
    }
}

fn set(primary: &Primary) -> Set {
    match primary {
        Primary::Number(number) => quantity(number),
        Primary::Symbol(name) => identifier(name),
        Primary::Call(name, arguments) => {
            let name = identifier(name);
            let mut inside = Vec::new();
            for (i, argument) in arguments.iter().enumerate() {
                let mut terms = terms(argument);
                if let Some(last) = terms.last_mut().filter(|_| i + 1 < arguments.len()) {
                    last.markup.push_str(&operator(','));
                }
                inside.extend(terms);
            }
            let argument = group(Bracket::Round, inside);
            Set::new(
                format!("<mrow>{}<mo>&#x2061;</mo>{}</mrow>", name.markup, argument.markup),
                name.width + argument.width,
            )
        }
        Primary::Group(bracket, sum) => group(*bracket, terms(sum)),
    }
}

fn quantity(number: &Number) -> Set {
    let width = number.digits.chars().count();
    let markup = match number.digits.split_once('e') {
        Some((digits, exponent)) => {
            let exponent = exponent.replace('-', "−");
            format!("<mrow><mn>{digits}</mn>{}<msup><mn>10</mn><mn>{exponent}</mn></msup></mrow>", operator('·'))
        }
        None => format!("<mn>{}</mn>", escape(&number.digits)),
    };
    let Some(unit) = number.unit else { return Set::new(markup, width) };
    Set::new(
        format!("<mrow>{markup}<mspace width=\"0.17em\"/><mtext>{}</mtext></mrow>", escape(unit.symbol)),
        width + 1 + unit.symbol.chars().count(),
    )
}

/// Terms in brackets.
fn group(bracket: Bracket, terms: Vec<Set>) -> Set {
    let (open, close) = bracket.pair();
    let inside: String = terms.iter().map(|t| t.markup.as_str()).collect();
    Set {
        markup: format!("<mrow><mo>{open}</mo>{inside}<mo>{close}</mo></mrow>"),
        width: terms.iter().map(|t| t.width).sum::<usize>() + 2,
        terms: if bracket == Bracket::Round { terms } else { Vec::new() },
    }
}

/// A factor as pieces: a long group in parentheses is broken between its terms.
fn broken(lead: String, factor: Set) -> Vec<Set> {
    if factor.width <= LONG || factor.terms.len() < 2 {
        let width = factor.width + 1;
        return vec![Set::new(lead + &factor.markup, width)];
    }
    let last = factor.terms.len() - 1;
    let mut lead = Some(lead);
    let terms = factor.terms.into_iter().enumerate();
    terms
        .map(|(i, term)| {
            let open = lead.take().map_or(String::new(), |l| l + "<mo stretchy=\"false\">(</mo>");
            let close = if i == last { "<mo stretchy=\"false\">)</mo>" } else { "" };
            Set::new(open + &term.markup + close, term.width + 1)
        })
        .collect()
}

fn raised(base: &Set, exponent: &str, width: usize) -> Set {
    Set::new(format!("<msup>{}{exponent}</msup>", base.markup), base.width + width)
}

fn fraction(above: &Set, below: &Set) -> Set {
    Set::new(
        format!("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>", above.markup, below.markup),
        above.width.max(below.width) + 1,
    )
}

fn join(mut factors: Vec<Set>) -> Set {
    if factors.len() == 1 {
        return factors.remove(0);
    }
    let width = factors.iter().map(|f| f.width).sum::<usize>() + factors.len();
    let mut markup = String::from("<mrow>");
    for (i, factor) in factors.iter().enumerate() {
        if i > 0 {
            markup.push_str(&operator('·'));
        }
        markup.push_str(&factor.markup);
    }
    markup.push_str("</mrow>");
    Set::new(markup, width)
}

fn operator(c: char) -> String {
    format!("<mo>{}</mo>", escape(&c.to_string()))
}

/// An operator that begins a piece: still one between two terms, so that it keeps its space.
fn leading(c: char) -> String {
    format!("<mo form=\"infix\">{}</mo>", escape(&c.to_string()))
}

/// A symbol: base, subscript, primes. `m_c`, `λ1`, `h_i′`, `tanh`, `PGA`.
fn identifier(name: &str) -> Set {
    let primes: String = name.chars().filter(|c| matches!(c, '′' | '″')).collect();
    let rest: String = name.chars().filter(|c| !matches!(c, '′' | '″')).collect();
    let (base, mut sub) = rest.split_once('_').map_or((rest.as_str(), ""), |(b, s)| (b, s));
    let digits = base.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut head = base;
    // One letter with a number: λ1 is λ with subscript 1.
    if sub.is_empty() && digits.len() < base.len() && digits.chars().count() == 1 {
        head = digits;
        sub = &base[digits.len()..];
    }
    let width = head.chars().count() + sub.chars().count() + primes.chars().count();
    let base = format!("<mi>{}</mi>", escape(head));
    let sub = sub.replace('_', ",");
    let sub = if sub.chars().all(|c| c.is_ascii_digit()) {
        format!("<mn>{}</mn>", escape(&sub))
    } else {
        format!("<mtext>{}</mtext>", escape(&sub))
    };
    let markup = match (sub.len() > "<mn></mn>".len(), primes.is_empty()) {
        (false, true) => base,
        (true, true) => format!("<msub>{base}{sub}</msub>"),
        (false, false) => format!("<msup>{base}<mo>{primes}</mo></msup>"),
        (true, false) => format!("<msubsup>{base}{sub}<mo>{primes}</mo></msubsup>"),
    };
    Set::new(markup, width)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_roots_and_functions() {
        assert_eq!(
            formula("√(R/g)"),
            "<math displaystyle=\"true\"><msqrt><mrow><mfrac><mrow><mi>R</mi></mrow><mrow><mi>g</mi></mrow></mfrac></mrow></msqrt></math>"
        );
        let html = formula("2·π·√(R/(g·λ_1·tanh(λ_1·H/R)))");
        assert!(html.contains("<msqrt>") && html.matches("<mfrac>").count() == 2, "{html}");
        assert!(html.contains("<mi>tanh</mi><mo>&#x2061;</mo>"), "{html}");
    }

    #[test]
    fn sums_break_into_pieces() {
        let html = formula("a + b − c");
        assert_eq!(html.matches("<math ").count(), 3);
        assert!(html.contains("<math displaystyle=\"true\"><mo form=\"infix\">+</mo><mi>b</mi></math>"));
    }

    #[test]
    fn long_groups_break_between_their_terms() {
        let html = formula("(m_i·h_i + m_w·h_w + m_r·h_r + m_s·h_s)·S_e(T_imp)");
        assert_eq!(html.matches("<math ").count(), 5, "{html}");
        assert!(html.contains("<mo stretchy=\"false\">(</mo>"), "{html}");
    }

    #[test]
    fn numbers_keep_their_units() {
        let html = formula("tanh(1.8412·1.525 m/1.83 m)·4.903 m/s²");
        assert!(html.contains("<mn>1.525</mn><mspace width=\"0.17em\"/><mtext>m</mtext>"), "{html}");
        assert!(html.contains("<mtext>m/s²</mtext>"), "{html}");
        for text in ["6.9·10¹⁰", "6.9e10"] {
            let html = formula(text);
            assert!(html.contains("<msup><mn>10</mn><mn>10</mn></msup>"), "{html}");
        }
    }

    #[test]
    fn symbols_have_subscripts_and_primes() {
        assert!(symbol("h_i′").contains("<msubsup><mi>h</mi><mtext>i</mtext><mo>′</mo></msubsup>"));
        assert!(symbol("λ1").contains("<msub><mi>λ</mi><mn>1</mn></msub>"));
        assert!(symbol("K_rw2").contains("<mtext>rw2</mtext>"));
        assert!(symbol("σ_θ,max").contains("<mtext>θ,max</mtext>"));
    }

    #[test]
    fn prose_lowers_short_symbols_and_keeps_keys() {
        assert_eq!(prose("S_e(T_c1) < 2"), "S<sub>e</sub>(T<sub>c1</sub>) &lt; 2");
        assert_eq!(prose("`site.api650.zone_factor` and a_b_c"), "<code>site.api650.zone_factor</code> and a_b_c");
        assert_eq!(prose("`a < S_e` and S_e"), "<code>a &lt; S_e</code> and S<sub>e</sub>");
        assert_eq!(prose("one ` alone"), "one ` alone");
        assert_eq!(prose("plain & simple"), "plain &amp; simple");
        assert_eq!(prose("_"), "_");
    }

    #[test]
    fn what_is_no_formula_is_set_as_words_and_escaped() {
        let html = formula("m_c by table A.2, see <b> \"x\"");
        assert!(html.starts_with("<span"), "{html}");
        assert!(html.contains("m<sub>c</sub>") && html.contains("&lt;b&gt;"), "{html}");
        for text in ["", "(", "a)", "a +", "3 +", "^", "√", "a//b"] {
            let html = formula(text);
            assert!(html.starts_with("<span"), "{text}: {html}");
        }
    }
}
