//! Size and widths of texts.

use crate::language::say;

/// Font size of ticks, legend and labels in user units; `templates/figure.css` has the same.
pub const FONT: f64 = 11.0;

/// Rough width of a text in units of its font size: enough to place labels. Classes as wide as in the widest of the usual
/// fonts (DejaVu Sans), so that labels fit whatever is installed. The text is measured in the language of the page.
pub fn text_width(text: &str) -> f64 {
    say(text)
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '\'' | '|' | '\u{202f}' => 0.28,
            '.' | ',' | ':' | ';' | '!' | ' ' => 0.33,
            'f' | 't' | 'r' | '(' | ')' | '-' | '/' | '·' | '²' | '³' => 0.4,
            'm' | 'w' | 'M' | 'W' | '%' => 0.94,
            '0'..='9' => 0.64,
            '−' | '+' => 0.84,
            c if c.is_uppercase() => 0.72,
            _ => 0.61,
        })
        .sum()
}
