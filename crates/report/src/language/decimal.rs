//! Decimal commas.

/// Names of standards: numbers behind them are clauses.
const STANDARDS: [&str; 9] = ["EN ", "ENV ", "DIN ", "API ", "ASCE ", "ISO ", "ACI ", "IS ", "IITK-GSDMA "];

/// `text` with decimal commas. Clauses (`4.3.2`, `A.3`), names of standards, code in backquotes, and everything behind
/// the name of a standard up to the next comma or semicolon stay.
pub(super) fn commas(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let digit = |i: usize| chars.get(i).is_some_and(char::is_ascii_digit);
    let mut out = String::with_capacity(text.len());
    let mut code = false;
    let mut standard = false;
    let mut at = 0;
    for (i, &c) in chars.iter().enumerate() {
        if c == '`' {
            code = !code;
        }
        if !standard && c.is_ascii_uppercase() {
            standard = STANDARDS.iter().any(|s| text[at..].starts_with(s));
        } else if matches!(c, ',' | ';' | ':') && !digit(i + 1) {
            standard = false;
        }
        at += c.len_utf8();
        let between = c == '.' && i > 0 && digit(i - 1) && digit(i + 1);
        if !between || code || standard {
            out.push(c);
            continue;
        }
        let start = (0..i).rev().take_while(|&j| digit(j) || chars[j] == '\u{202f}').last().unwrap_or(i);
        let end = (i + 1..chars.len()).take_while(|&j| digit(j)).last().unwrap_or(i) + 1;
        let before = start.checked_sub(1).map(|j| chars[j]);
        let part = before.is_some_and(|b| b == '.' || b == '_' || b.is_alphabetic());
        let more = chars.get(end) == Some(&'.') && digit(end + 1);
        out.push(if part || more { '.' } else { ',' });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::commas;

    #[test]
    fn numbers_but_not_clauses() {
        for (text, german) in [
            ("12.5 mm, −0.3", "12,5 mm, −0,3"),
            ("16\u{202f}312.5 kN", "16\u{202f}312,5 kN"),
            ("3.2.1 und A.3", "3.2.1 und A.3"),
            ("EN 1998-4:2006 4.4: 1.5", "EN 1998-4:2006 4.4: 1,5"),
            ("ACI 350.3-06 4.1: 1.5; IS 1893-1 6.4", "ACI 350.3-06 4.1: 1,5; IS 1893-1 6.4"),
            ("`a.1.5` 1.5", "`a.1.5` 1,5"),
            ("1.5·10⁻³", "1,5·10⁻³"),
            ("C30.37", "C30.37"),
        ] {
            assert_eq!(commas(text), german);
        }
    }
}
