//! Numbers with units of SI within a sentence or a formula, in US customary units.

use std::borrow::Cow;

use super::table::{FOOT, INCH};
use super::{Dimension, System, UNITS, Unit, significant};

/// Units beside those of the table: symbol, in which the value is so many of, and at zero.
///
/// A US gallon is 231 in³ (NIST SP 811, appendix B).
const OTHERS: &[(&str, &str, f64, f64)] = &[
    ("m²", "ft²", FOOT * FOOT, 0.0),
    ("mm²", "in²", INCH * INCH * 1e6, 0.0),
    ("m³", "gal", 231.0 * INCH * INCH * INCH, 0.0),
    ("°C", "°F", 5.0 / 9.0, 32.0),
];

/// Words between two numbers of which only the second has a unit: `3 to 5 m`.
const JOINTS: [&str; 7] = [" to ", "–", " and ", " or ", " × ", "×", "…"];

/// A number in a text.
struct Found {
    /// Bytes of the number.
    start: usize,
    end: usize,
    value: f64,
    digits: usize,
}

/// `text` with its values of SI as `system` prints them, with at least `digits` significant digits. Everything else
/// stays as it is, also values that `system` prints in SI.
///
/// ```
/// use tank::units::{System, converted};
/// assert_eq!(converted("uplift of 0.3048 m at 3 to 5 m", System::Us, 3), "uplift of 12 in at 9.84 to 16.4 ft");
/// assert_eq!(converted("t = 5 s, 0.3 g", System::Us, 3), "t = 5 s, 0.3 g");
/// ```
pub fn converted(text: &str, system: System, digits: usize) -> Cow<'_, str> {
    if system == System::Si || !text.bytes().any(|b| b.is_ascii_digit()) {
        return Cow::Borrowed(text);
    }
    let mut out = String::new();
    let mut done = 0;
    let mut last: Option<Found> = None;
    let mut at = 0;
    while let Some(number) = next(text, at) {
        at = number.end;
        let Some((gap, symbol)) = unit_at(&text[number.end..]) else {
            last = Some(number);
            continue;
        };
        let end = number.end + gap.len() + symbol.len();
        let both = system == System::Both;
        // Brackets that are there already.
        if both && text[end..].starts_with(" (") {
            last = None;
            at = end;
            continue;
        }
        let Some((factor, zero, us)) = target(symbol, number.value) else {
            last = None;
            at = end;
            continue;
        };
        let shown = |n: &Found| print(n.value / factor + zero, n.digits.max(digits));
        let joined = last.take().filter(|l| l.start >= done && JOINTS.contains(&&text[l.end..number.start]));
        let start = joined.as_ref().map_or(number.start, |l| l.start);
        let mut here = String::new();
        if let Some(first) = &joined {
            here.push_str(&shown(first));
            here.push_str(&text[first.end..number.start]);
        }
        here.push_str(&shown(&number));
        here.push_str(gap);
        here.push_str(us);
        out.push_str(&text[done..if both { end } else { start }]);
        if both {
            out.push_str(" (");
            out.push_str(&here);
            out.push(')');
        } else {
            out.push_str(&here);
        }
        done = end;
        at = end;
    }
    if done == 0 {
        return Cow::Borrowed(text);
    }
    out.push_str(&text[done..]);
    Cow::Owned(out)
}

/// Factor, zero and symbol of the unit that a value of this unit gets; `None` if that is the same.
fn target(symbol: &str, value: f64) -> Option<(f64, f64, &'static str)> {
    if let Some((_, us, factor, zero)) = OTHERS.iter().find(|o| o.0 == symbol) {
        return Some((*factor, *zero, us));
    }
    let unit = si_units().find(|u| u.symbol == symbol)?;
    if !System::Us.differs(unit.dimension) {
        return None;
    }
    let si = value * unit.factor();
    let us = System::Us.unit_for(si, unit.dimension);
    Some((us.factor() / unit.factor(), 0.0, us.symbol))
}

/// The units that are converted: powers of ten, with their symbol. A gram is a `g` of gravity in sentences.
fn si_units() -> impl Iterator<Item = &'static Unit> {
    UNITS.iter().filter(|u| u.dimension != Dimension::Dimensionless && u.symbol != "g" && u.is_power_of_ten())
}

/// The blank and the symbol of a unit that a text begins with; the longest that fits.
fn unit_at(text: &str) -> Option<(&str, &'static str)> {
    let gap = text.chars().next().filter(|c| matches!(c, ' ' | '\u{a0}' | '\u{202f}'))?;
    let (gap, rest) = text.split_at(gap.len_utf8());
    let ends = |symbol: &&'static str| {
        let mut after = rest[symbol.len()..].chars();
        match (after.next(), after.next()) {
            (Some('/'), Some(next)) => !next.is_alphabetic(),
            (Some(c), _) => !c.is_alphanumeric() && !matches!(c, '²' | '³' | '_' | '′'),
            (None, _) => true,
        }
    };
    let known = si_units().map(|u| u.symbol).chain(OTHERS.iter().map(|o| o.0));
    let found = known.filter(|s| rest.starts_with(*s)).filter(ends).max_by_key(|s| s.len())?;
    Some((gap, found))
}

/// The next number that is not part of a word, from byte `from` on.
fn next(text: &str, from: usize) -> Option<Found> {
    let bytes = text.as_bytes();
    let mut start = from;
    loop {
        start += bytes[start..].iter().position(u8::is_ascii_digit)?;
        let end = end_of(text, start);
        let mut before = text[..start].chars().rev();
        // Within a word, a clause (`4.3.2`) or the name of a standard (`1998-4`).
        let part = match (before.next(), before.next()) {
            (Some('-'), Some(c)) => c.is_ascii_digit(),
            (Some(c), _) => c.is_alphanumeric() || matches!(c, '.' | '_'),
            (None, _) => false,
        };
        let digits: String = text[start..end].chars().filter(|c| *c != '\u{202f}').collect();
        let plain = digits.replace("·10", "e");
        let plain: String = plain.chars().filter_map(lowered).collect();
        match plain.parse::<f64>() {
            Ok(value) if !part => {
                let mantissa = plain.split('e').next().unwrap_or_default();
                let significant = mantissa.chars().filter(char::is_ascii_digit).collect::<String>();
                return Some(Found { start, end, value, digits: significant.trim_start_matches('0').len() });
            }
            _ => start = end,
        }
        if start >= bytes.len() {
            return None;
        }
    }
}

/// A raised digit as a digit, a true minus as a hyphen.
fn lowered(c: char) -> Option<char> {
    Some(match c {
        '⁻' | '−' => '-',
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10)?,
        c => c,
    })
}

/// Where the number that begins at `start` ends: digits in groups, one point, an exponent.
fn end_of(text: &str, start: usize) -> usize {
    let rest = &text[start..];
    let digit = |i: usize| rest.as_bytes().get(i).is_some_and(u8::is_ascii_digit);
    let mut i = 0;
    let mut point = false;
    loop {
        if digit(i) {
            i += 1;
        } else if rest[i..].starts_with('\u{202f}') && digit(i + '\u{202f}'.len_utf8()) && !point {
            i += '\u{202f}'.len_utf8();
        } else if rest[i..].starts_with('.') && digit(i + 1) && !point {
            point = true;
            i += 1;
        } else {
            break;
        }
    }
    if let Some(power) = rest[i..].strip_prefix("·10") {
        let raised = power.chars().take_while(|c| matches!(c, '⁻' | '⁰' | '¹' | '²' | '³' | '⁴'..='⁹'));
        let length: usize = raised.map(char::len_utf8).sum();
        if length > 0 {
            i += "·10".len() + length;
        }
    } else if rest[i..].starts_with('e') {
        let sign = usize::from(rest[i + 1..].starts_with(['-', '+']));
        let exponent = rest[i + 1 + sign..].bytes().take_while(u8::is_ascii_digit).count();
        if exponent > 0 {
            i += 1 + sign + exponent;
        }
    }
    start + i
}

/// A number without idle zeros.
fn print(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
    match mantissa.contains('.') {
        true => format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.')),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_within_sentences_and_formulas() {
        for (text, us) in [
            ("wall 25.4 mm thick", "wall 1 in thick"),
            ("4.903 m/s²·7600.6 kg", "16.086 ft/s²·16756 klb"),
            ("83 GPa·t_s/(2.5·60 m)", "12038 ksi·t_s/(2.5·196.85 ft)"),
            ("k = 100\u{a0}MN/m³", "k = 368.4\u{a0}lb/in³"),
            // Units of several factors are converted as a whole: N·m/rad to lbf·ft/rad, not the newton alone.
            ("2 MN·s/m, 1 kN·m·s/rad", "137.04 kip·s/ft, 737.56 lbf·ft·s/rad"),
            ("1 GN·m/rad, 1 t·m²", "737562 kip·ft/rad, 23.73 klb·ft²"),
            ("(2 mm)²", "(0.07874 in)²"),
            ("m = 3 modes, EN 1998-4 m", "m = 3 modes, EN 1998-4 m"),
            ("16\u{202f}312 kN", "3667.1 kip"),
            ("1.5·10⁻⁵ m", "0.00059055 in"),
            ("1 m³, 0 °C", "264.17 gal, 32 °F"),
            ("0.3 g, 2 %, 5 s, 30°", "0.3 g, 2 %, 5 s, 30°"),
        ] {
            let us = us.replace("16756 klb", "16.756 klb");
            assert_eq!(converted(text, System::Us, 5), us);
        }
    }

    #[test]
    fn both() {
        assert_eq!(converted("at 0.5 m or more", System::Both, 3), "at 0.5 m (19.7 in) or more");
        assert_eq!(converted("at 0.5 m (19.7 in)", System::Both, 3), "at 0.5 m (19.7 in)");
        assert_eq!(converted("3 to 5 m", System::Both, 3), "3 to 5 m (9.84 to 16.4 ft)");
    }
}
