//! Formulas of calculation sheets, set as MathML.
//!
//! Sheets write formulas in Unicode (`2·π·√(R/(g·λ_1·tanh(λ_1·H/R)))`). The grammar, by falling precedence:
//!
//! ```text
//! primary   number [unit] | symbol | function( … ) | ( … ) | [ … ] | | … |
//! power     primary ² ³ ⁻¹ … | primary ^ primary | √ primary
//! product   power · power, power / power (set as a fraction), power power
//! sum       product ± product …
//! formula   sum = sum …, with commas and relations
//! ```
//!
//! A formula is broken before `=`, `+` and `−` (and before `·` where it is long) into pieces that wrap like words.
//! Text outside the grammar is set as words with raised and lowered letters: nothing is ever lost.

use super::figure::svg::escape;

/// Longest piece that is not broken further, in characters.
const LONG: usize = 26;
/// Widest piece that fits its column, in characters.
const WIDEST: usize = 52;

/// The formula as HTML.
pub fn formula(text: &str) -> String {
    let tokens = tokens(text);
    let mut parser = Parser { tokens: &tokens, at: 0 };
    match parser.formula() {
        Some(pieces) if parser.at == tokens.len() && pieces.iter().all(|p| p.width <= WIDEST) => pieces
            .iter()
            .map(|p| format!("<math displaystyle=\"true\">{}</math>", p.markup))
            .collect::<Vec<_>>()
            .join(" "),
        _ => words(text),
    }
}

/// A symbol (`m_c`, `h_i′`) as HTML.
pub fn symbol(text: &str) -> String {
    formula(text)
}

/// A sentence as HTML: escaped, short symbols (`S_e`, `T_c1`, `d_max`) with their subscripts; keys of the input file
/// (`zone_factor`) stay as they are.
pub fn prose(text: &str) -> String {
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

/// Text with subscripts, for what the grammar does not know.
fn words(text: &str) -> String {
    let mut out = String::from("<span class=\"words\">");
    let chars: Vec<char> = text.chars().collect();
    let mut i = 0;
    while i < chars.len() {
        let c = chars[i];
        if c == '_' && i > 0 && chars[i - 1].is_alphanumeric() {
            let end = (i + 1..chars.len())
                .find(|&j| !in_symbol(chars[j]))
                .unwrap_or(chars.len());
            if end > i + 1 {
                let sub: String = chars[i + 1..end].iter().collect();
                out.push_str(&format!("<sub>{}</sub>", escape(&sub)));
                i = end;
                continue;
            }
        }
        out.push_str(&escape(&c.to_string()));
        if matches!(c, '·' | '/' | '+' | '=' | ',') {
            out.push_str("<wbr>");
        }
        i += 1;
    }
    out.push_str("</span>");
    out
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(String),
    Unit(String),
    Symbol(String),
    Raised(String),
    Sign(char),
}

/// Units that may follow a number, longest first.
const UNITS: [&str; 44] = [
    "kNm/m", "N·m/m", "Nm/m", "kg/m³", "kg/m3", "rad/s", "kN/m", "MN/m", "m/s²", "m/s2", "mm/s", "cm/s", "N/m", "m/s",
    "1/s", "kNm", "MNm", "N·m", "N*m", "GPa", "MPa", "kPa", "rad", "kN", "MN", "Nm", "kJ", "Pa", "Hz", "kg", "cm²",
    "mm²", "mm", "cm", "km", "m²", "m³", "N", "J", "t", "m", "s", "g", "%",
];

fn in_symbol(c: char) -> bool {
    (c.is_alphanumeric() && !is_raised(c) && !('½'..='¾').contains(&c) && c != '¼')
        || matches!(c, '_' | '′' | '″' | '\u{304}' | '\u{307}' | '\u{308}')
}

fn is_raised(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | '⁰' | '⁴'..='⁹' | '⁺' | '⁻' | 'ⁿ')
}

fn tokens(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().collect();
    let mut out = Vec::new();
    let mut i = 0;
    while i < chars.len() {
        let c = chars[i];
        let run = |test: &dyn Fn(char) -> bool| (i..chars.len()).find(|&j| !test(chars[j])).unwrap_or(chars.len());
        if c.is_whitespace() {
            i += 1;
        } else if c.is_ascii_digit() {
            let mut end = run(&|c| c.is_ascii_digit() || c == '.');
            if chars[end - 1] == '.' {
                end -= 1;
            }
            out.push(Token::Number(chars[i..end].iter().collect()));
            i = end;
            // A unit stands behind a space (or a narrow one).
            if let Some(rest) = chars
                .get(i)
                .filter(|c| matches!(c, ' ' | '\u{202f}' | '\u{a0}'))
                .map(|_| i + 1)
            {
                let fits = |u: &&&str| {
                    let unit: Vec<char> = u.chars().collect();
                    chars[rest..].starts_with(&unit)
                        && !chars
                            .get(rest + unit.len())
                            .is_some_and(|&c| in_symbol(c) || is_raised(c) || c == '(')
                };
                if let Some(unit) = UNITS.iter().find(fits) {
                    out.push(Token::Unit((*unit).to_owned()));
                    i = rest + unit.chars().count();
                }
            }
        } else if matches!(c, '½' | '¼' | '¾' | '∞') {
            out.push(Token::Number(c.to_string()));
            i += 1;
        } else if is_raised(c) {
            let end = run(&is_raised);
            out.push(Token::Raised(chars[i..end].iter().map(|&c| lowered(c)).collect()));
            i = end;
        } else if c.is_alphabetic() {
            let end = run(&in_symbol);
            out.push(Token::Symbol(chars[i..end].iter().collect()));
            i = end;
        } else {
            out.push(Token::Sign(match c {
                '-' => '−',
                '*' => '·',
                other => other,
            }));
            i += 1;
        }
    }
    out
}

fn lowered(c: char) -> char {
    match c {
        '²' => '2',
        '³' => '3',
        '¹' => '1',
        '⁺' => '+',
        '⁻' => '−',
        'ⁿ' => 'n',
        '⁰' => '0',
        '⁴'..='⁹' => char::from_u32(c as u32 - '⁴' as u32 + '4' as u32).unwrap_or(c),
        other => other,
    }
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
        Set {
            markup,
            width,
            terms: Vec::new(),
        }
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

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
}

impl Parser<'_> {
    fn sign(&self) -> Option<char> {
        match self.tokens.get(self.at) {
            Some(Token::Sign(c)) => Some(*c),
            _ => None,
        }
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.sign() == Some(c);
        self.at += usize::from(found);
        found
    }

    /// The whole formula as pieces.
    fn formula(&mut self) -> Option<Vec<Set>> {
        let mut pieces: Vec<Set> = Vec::new();
        let mut lead = String::new();
        loop {
            let factors = self.factors()?;
            let width: usize = factors.iter().map(|f| f.width).sum();
            if width > LONG && factors.len() > 1 {
                for (i, factor) in factors.into_iter().enumerate() {
                    let before = if i == 0 {
                        std::mem::take(&mut lead)
                    } else {
                        leading('·')
                    };
                    pieces.extend(broken(before, factor));
                }
            } else if width > LONG {
                for factor in factors {
                    pieces.extend(broken(std::mem::take(&mut lead), factor));
                }
            } else {
                let product = join(factors);
                pieces.push(Set::new(std::mem::take(&mut lead) + &product.markup, width + 1));
            }
            match self.sign() {
                Some(c) if is_relation(c) || matches!(c, '+' | '−' | '±' | ',' | ';') => {
                    self.at += 1;
                    if matches!(c, ',' | ';') {
                        if let Some(last) = pieces.last_mut() {
                            last.markup.push_str(&operator(c));
                        }
                    } else {
                        lead = leading(c);
                    }
                }
                None if self.at == self.tokens.len() => return Some(pieces),
                _ => return None,
            }
        }
    }

    /// The terms of a sum within parentheses, each with its sign.
    fn sum(&mut self) -> Option<Vec<Set>> {
        let mut terms: Vec<Set> = Vec::new();
        let mut lead = String::new();
        loop {
            let product = join(self.factors()?);
            let width = product.width + if lead.is_empty() { 0 } else { 2 };
            terms.push(Set::new(std::mem::take(&mut lead) + &product.markup, width));
            match self.sign() {
                Some(c @ (',' | ';')) => {
                    self.at += 1;
                    if let Some(last) = terms.last_mut() {
                        last.markup.push_str(&operator(c));
                    }
                }
                Some(c) if is_relation(c) || matches!(c, '+' | '−' | '±') => {
                    self.at += 1;
                    lead = leading(c);
                }
                _ => return Some(terms),
            }
        }
    }

    /// The factors of a product; quotients are already fractions.
    fn factors(&mut self) -> Option<Vec<Set>> {
        let mut factors = Vec::new();
        let minus = self.eat('−');
        let mut first = self.power()?;
        if minus {
            first = Set::new(format!("<mo form=\"prefix\">−</mo>{}", first.markup), first.width + 1);
        }
        factors.push(first);
        loop {
            match self.sign() {
                Some('·' | '×') => {
                    self.at += 1;
                    factors.push(self.power()?);
                }
                Some('/') => {
                    self.at += 1;
                    let below = self.power()?.bare();
                    // a·b/c is (a·b)/c; long products keep their other factors outside the bar.
                    let above = if factors.len() == 2 {
                        join(std::mem::take(&mut factors))
                    } else {
                        factors.pop()?.bare()
                    };
                    factors.push(fraction(&above, &below));
                }
                Some('(' | '[' | '√') => factors.push(self.power()?),
                _ => match self.tokens.get(self.at) {
                    Some(Token::Symbol(_) | Token::Number(_)) => {
                        let next = self.power()?;
                        factors.push(Set::new(
                            format!("<mspace width=\"0.17em\"/>{}", next.markup),
                            next.width,
                        ));
                    }
                    _ => return Some(factors),
                },
            }
        }
    }

    fn power(&mut self) -> Option<Set> {
        if self.eat('√') {
            let under = self.power()?.bare();
            return Some(Set::new(format!("<msqrt>{}</msqrt>", under.markup), under.width + 2));
        }
        let base = self.primary()?;
        if let Some(Token::Raised(exponent)) = self.tokens.get(self.at) {
            self.at += 1;
            let exponent = format!("<mn>{}</mn>", escape(exponent));
            return Some(raised(&base, &exponent, 1));
        }
        if self.eat('^') {
            let minus = self.eat('−');
            let exponent = self.primary()?.bare();
            let sign = if minus { "<mo form=\"prefix\">−</mo>" } else { "" };
            return Some(raised(
                &base,
                &format!("<mrow>{sign}{}</mrow>", exponent.markup),
                exponent.width,
            ));
        }
        Some(base)
    }

    fn primary(&mut self) -> Option<Set> {
        let token = self.tokens.get(self.at)?.clone();
        self.at += 1;
        match token {
            Token::Number(digits) => {
                let mut markup = format!("<mn>{}</mn>", escape(&digits));
                let mut width = digits.chars().count();
                if let Some(Token::Unit(unit)) = self.tokens.get(self.at) {
                    self.at += 1;
                    width += 1 + unit.chars().count();
                    markup = format!(
                        "<mrow>{markup}<mspace width=\"0.17em\"/><mtext>{}</mtext></mrow>",
                        escape(unit)
                    );
                }
                Some(Set::new(markup, width))
            }
            Token::Symbol(name) => {
                let name = identifier(&name);
                if self.sign() != Some('(') {
                    return Some(name);
                }
                let argument = self.primary()?;
                Some(Set::new(
                    format!("<mrow>{}<mo>&#x2061;</mo>{}</mrow>", name.markup, argument.markup),
                    name.width + argument.width,
                ))
            }
            Token::Sign(open @ ('(' | '[' | '{' | '|')) => {
                let close = match open {
                    '(' => ')',
                    '[' => ']',
                    '{' => '}',
                    _ => '|',
                };
                let terms = self.sum()?;
                if !self.eat(close) {
                    return None;
                }
                let inside: String = terms.iter().map(|t| t.markup.as_str()).collect();
                Some(Set {
                    markup: format!("<mrow><mo>{open}</mo>{inside}<mo>{close}</mo></mrow>"),
                    width: terms.iter().map(|t| t.width).sum::<usize>() + 2,
                    terms: if open == '(' { terms } else { Vec::new() },
                })
            }
            Token::Sign('Σ' | '∑') => Some(Set::new("<mo>∑</mo>".into(), 1)),
            Token::Sign('∫') => Some(Set::new("<mo>∫</mo>".into(), 1)),
            Token::Sign('…') => Some(Set::new("<mo>…</mo>".into(), 1)),
            _ => None,
        }
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
            let open = lead
                .take()
                .map_or(String::new(), |l| l + "<mo stretchy=\"false\">(</mo>");
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
        format!(
            "<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
            above.markup, below.markup
        ),
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
        if i > 0 && !factor.markup.starts_with("<mspace") {
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

fn is_relation(c: char) -> bool {
    matches!(c, '=' | '<' | '>' | '≤' | '≥' | '≈' | '≠' | '≪' | '≫' | '→')
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
        assert!(
            html.contains("<msqrt>") && html.matches("<mfrac>").count() == 2,
            "{html}"
        );
        assert!(html.contains("<mi>tanh</mi><mo>&#x2061;</mo>"), "{html}");
    }

    #[test]
    fn sums_break_into_pieces() {
        let html = formula("Q = a + b − c");
        assert_eq!(html.matches("<math ").count(), 4);
        assert!(html.contains("<math displaystyle=\"true\"><mo form=\"infix\">=</mo><mi>a</mi></math>"));
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
        assert!(
            html.contains("<mn>1.525</mn><mspace width=\"0.17em\"/><mtext>m</mtext>"),
            "{html}"
        );
        assert!(html.contains("<mtext>m/s²</mtext>"), "{html}");
        let html = formula("6.9·10¹⁰");
        assert!(html.contains("<msup><mn>10</mn><mn>10</mn></msup>"), "{html}");
    }

    #[test]
    fn symbols_have_subscripts_and_primes() {
        assert!(symbol("h_i′").contains("<msubsup><mi>h</mi><mtext>i</mtext><mo>′</mo></msubsup>"));
        assert!(symbol("λ1").contains("<msub><mi>λ</mi><mn>1</mn></msub>"));
        assert!(symbol("K_rw2").contains("<mtext>rw2</mtext>"));
    }

    #[test]
    fn prose_lowers_short_symbols_and_keeps_keys() {
        assert_eq!(prose("S_e(T_c1) < 2"), "S<sub>e</sub>(T<sub>c1</sub>) &lt; 2");
        assert_eq!(
            prose("`site.api650.zone_factor` and a_b_c"),
            "`site.api650.zone_factor` and a_b_c"
        );
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
