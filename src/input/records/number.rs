//! Numbers as written by people and Fortran programs.

use files::code::Code;

/// Reason why a text is not a usable number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NotANumber {
    /// NaN, infinite, or beyond the range of a double.
    NotFinite,
    /// A row of stars: the value did not fit Fortran's field.
    Overflow,
    /// Anything else.
    Text,
}

impl NotANumber {
    /// The kind of fault.
    pub(crate) fn code(self) -> Code {
        match self {
            NotANumber::NotFinite => Code::NotFinite,
            NotANumber::Overflow | NotANumber::Text => Code::NotANumber,
        }
    }

    /// The message for a column called `what`.
    pub(crate) fn message(self, what: &str) -> String {
        match self {
            NotANumber::NotFinite => format!("{what} is not a finite number"),
            NotANumber::Overflow => format!("{what} did not fit the field of the program that wrote it"),
            NotANumber::Text => format!("{what} is not a number"),
        }
    }
}

/// Parses a number: `1.5`, `-.123E-01`, `1.D-3`, `+2.`, `.1234567-103` (Fortran's three-digit exponent), `−1` (Unicode
/// minus). The decimal mark is a point.
pub(crate) fn parse(text: &str) -> Result<f64, NotANumber> {
    let text = text.trim();
    if let Ok(value) = text.parse::<f64>() {
        return if value.is_finite() { Ok(value) } else { Err(NotANumber::NotFinite) };
    }
    if !text.is_empty() && text.chars().all(|c| c == '*') {
        return Err(NotANumber::Overflow);
    }
    let bare = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if bare.starts_with("nan") || bare.starts_with("inf") || bare.contains("#in") || bare.contains("#qnan") {
        return Err(NotANumber::NotFinite);
    }
    let mut plain: String = text
        .chars()
        .map(|c| match c {
            'd' | 'D' => 'E',
            '\u{2212}' => '-',
            c => c,
        })
        .collect();
    if let Some(sign) = exponent_sign(&plain) {
        plain.insert(sign, 'E');
    }
    match plain.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(NotANumber::NotFinite),
        Err(_) => Err(NotANumber::Text),
    }
}

/// Place of the sign of an exponent without `E`: exactly three digits follow it to the end.
fn exponent_sign(text: &str) -> Option<usize> {
    let sign = text.len().checked_sub(4)?;
    let bytes = text.as_bytes();
    let fits = sign > 0
        && matches!(bytes[sign], b'+' | b'-')
        && (bytes[sign - 1].is_ascii_digit() || bytes[sign - 1] == b'.')
        && bytes[sign + 1..].iter().all(u8::is_ascii_digit);
    fits.then_some(sign)
}

/// Whether a text begins like a number (NaN and infinity included), so that its line is data.
pub(crate) fn begins_like_number(text: &str) -> bool {
    let bare = text.trim_start_matches(['+', '-', '.', '\u{2212}', '"']);
    let lower: String = bare.chars().take(9).collect::<String>().to_ascii_lowercase();
    bare.starts_with(|c: char| c.is_ascii_digit())
        || bare.starts_with("***")
        || ["nan", "inf", "infinity"]
            .iter()
            .any(|w| lower.strip_prefix(w).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric())))
}

/// Splits Fortran fields that touch: a sign that follows a digit or a point begins the next number, unless it belongs to
/// an exponent (`E-02`, or three last digits without `E`); numbers of a fixed number of decimals end with them.
pub(crate) fn split_glued(token: &str) -> Vec<(usize, &str)> {
    let signed = split_signs(token);
    signed
        .into_iter()
        .flat_map(|(start, part)| split_decimals(part).into_iter().map(move |(at, number)| (start + at, number)))
        .collect()
}

/// The numbers of `613.648091920.41978`, each with as many decimals as the last one and a digit before its point; the part itself where it is
/// not such a row.
fn split_decimals(part: &str) -> Vec<(usize, &str)> {
    let whole = vec![(0, part)];
    let digits = part.trim_start_matches(['+', '-']).bytes().all(|b| b.is_ascii_digit() || b == b'.');
    let decimals = part.rfind('.').map_or(0, |point| part.len() - point - 1);
    if !digits || decimals == 0 || part.matches('.').count() < 2 {
        return whole;
    }
    let (mut numbers, mut start) = (Vec::new(), 0);
    while start < part.len() {
        let rest = &part[start..];
        let end = rest.find('.').map_or(usize::MAX, |point| point.saturating_add(decimals + 1));
        match rest.get(..end) {
            Some(number)
                if number.matches('.').count() == 1 && !number.trim_start_matches(['+', '-']).starts_with('.') =>
            {
                numbers.push((start, number));
                start += end;
            }
            _ => return whole,
        }
    }
    numbers
}

fn split_signs(token: &str) -> Vec<(usize, &str)> {
    let bytes = token.as_bytes();
    let mut parts = Vec::new();
    let mut start = 0;
    for i in 1..bytes.len() {
        let sign = matches!(bytes[i], b'+' | b'-');
        if !sign || !(bytes[i - 1].is_ascii_digit() || bytes[i - 1] == b'.') {
            continue;
        }
        // The next number of a Fortran field contains a point; an exponent of three digits does not.
        let end = bytes[i + 1..].iter().position(|b| matches!(b, b'+' | b'-')).map_or(bytes.len(), |n| i + 1 + n);
        let digits = &bytes[i + 1..end];
        if digits.len() == 3 && digits.iter().all(u8::is_ascii_digit) && token[start..i].contains('.') {
            continue;
        }
        parts.push((start, &token[start..i]));
        start = i;
    }
    parts.push((start, &token[start..]));
    parts
}

/// The last printed digit of a number as a length: 0.01 for `12.34`, 1e-9 for `2.0000000e-002`.
pub(crate) fn resolution(text: &str) -> f64 {
    let text = text.trim();
    let split = text.find(['e', 'E', 'd', 'D']);
    let (mantissa, exponent) = split.map_or((text, ""), |i| (&text[..i], &text[i + 1..]));
    let decimals = mantissa.find('.').map_or(0, |i| mantissa.len() - i - 1);
    let exponent: i32 = exponent.parse().unwrap_or(0);
    10f64.powi(exponent.clamp(-400, 400) - i32::try_from(decimals.min(400)).unwrap_or(400))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_that_touch() {
        for (token, numbers) in [
            ("613.648091920.419783227.25209", &["613.64809", "1920.41978", "3227.25209"][..]),
            ("-123.45678-123.45678", &["-123.45678", "-123.45678"]),
            ("-1.5E-02-.25E-01", &["-1.5E-02", "-.25E-01"]),
            ("1.2.3", &["1.2.3"]),
            ("19.05.1940", &["19.05.1940"]),
            ("12.34", &["12.34"]),
        ] {
            let found: Vec<&str> = split_glued(token).iter().map(|(_, number)| *number).collect();
            assert_eq!(found, numbers, "{token}");
        }
    }

    #[test]
    fn fortran_and_others() {
        for (text, value) in [
            ("1.5", 1.5),
            (" -.123E-01 ", -0.0123),
            ("1.D-3", 1e-3),
            ("+2.", 2.0),
            ("1d2", 100.0),
            (".1234567-103", 0.1234567e-103),
            ("\u{2212}4", -4.0),
            ("-1.4275799e-003", -1.4275799e-3),
        ] {
            assert_eq!(parse(text), Ok(value), "{text}");
        }
        for text in ["nan", "NaN", "-inf", "Infinity", "1e999", "1.#INF", "-1.#IND", "nan(0x8)"] {
            assert_eq!(parse(text), Err(NotANumber::NotFinite), "{text}");
        }
        assert_eq!(parse("*******"), Err(NotANumber::Overflow));
        for text in ["", "-", "1.2.3", "1,5", "0x10", "1_000", "abc", "1e", "12-34"] {
            assert_eq!(parse(text), Err(NotANumber::Text), "{text}");
        }
    }

    #[test]
    fn glued_fields() {
        let split = |t| split_glued(t).iter().map(|p| p.1).collect::<Vec<_>>();
        assert_eq!(split("-.123E-01-.456E-02"), ["-.123E-01", "-.456E-02"]);
        assert_eq!(split("0.1234-0.5678-1.2"), ["0.1234", "-0.5678", "-1.2"]);
        assert_eq!(split(".1234567-103"), [".1234567-103"]);
        assert_eq!(split("1.5"), ["1.5"]);
        assert_eq!(split("-"), ["-"]);
        assert_eq!(split(""), [""]);
    }

    #[test]
    fn printed_resolution() {
        for (text, expected) in [("12.34", 0.01), ("2.0000000e-002", 1e-9), ("5", 1.0), ("1.", 1.0), ("1e3", 1000.0)] {
            assert!((resolution(text) / expected - 1.0).abs() < 1e-12, "{text}");
        }
    }
}
