//! Lengths as drawings in US customary units have them: fractions, feet and inches.

/// A number with a fraction, or feet and inches with their marks, as a decimal number with its unit; none for any other text.
pub(super) fn fraction(text: &str) -> Option<String> {
    // Prime and double prime stand for the units alone as well; these are read.
    let text = text.replace('″', "\"").replace('′', "'").replace("''", "\"");
    let (value, unit) = if let Some((feet, rest)) = text.split_once('\'') {
        match rest.trim().trim_start_matches('-') {
            "" => (mixed(feet)?, "ft"),
            inches => (12.0 * mixed(feet)? + mixed(inches.strip_suffix('"')?)?, "in"),
        }
    } else if let Some(inches) = text.strip_suffix('"') {
        (mixed(inches)?, "in")
    } else {
        let unit =
            text.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace() || matches!(c, '/' | '-' | '.'));
        let number = &text[..text.len() - unit.len()];
        if !number.contains('/') || !unit.chars().all(|c| c.is_alphabetic()) || unit.is_empty() {
            return None;
        }
        (mixed(number)?, unit)
    };
    // Six decimals of an inch are 25 nm.
    let decimal = format!("{value:.6}");
    let decimal = decimal.trim_end_matches('0').trim_end_matches('.');
    value.is_finite().then(|| format!("{decimal} {unit}"))
}

/// `3`, `3.5`, `5/16`, `1 1/4` or `1-1/4`.
fn mixed(text: &str) -> Option<f64> {
    let text = text.trim();
    let Some((head, denominator)) = text.split_once('/') else {
        let plain = !text.is_empty() && text.chars().all(|c| c.is_ascii_digit() || c == '.');
        return text.parse().ok().filter(|_| plain);
    };
    let whole = |text: &str| -> Option<f64> { text.trim().parse::<u32>().ok().map(f64::from) };
    let denominator = whole(denominator).filter(|d| *d > 0.0)?;
    match head.trim().rsplit_once([' ', '-']) {
        Some((units, numerator)) => Some(whole(units.trim_end_matches('-'))? + whole(numerator)? / denominator),
        None => Some(whole(head)? / denominator),
    }
}
