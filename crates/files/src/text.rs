//! Escaping of user text, so that names, messages and files cannot control a terminal or hide parts of a page. A
//! hostile character is shown as its escape in Rust and JSON5, `\u{1b}`. All output for people goes through
//! [`visible`]: standard output and standard error in `cli`, pages and figures in [`report::Report::new`]. A name
//! inside a sentence goes through [`line`], so that it cannot forge lines. Files for programs keep the exact text;
//! JSON on standard output has the same values in the escapes of [`json`].

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character controls a terminal or the order of text instead of being visible.
///
/// * C0 but for tab and line feed, DEL, C1 (U+0080 to U+009F)
/// * direction: U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+206F
/// * line separators U+2028, U+2029; zero width U+200B to U+200D, U+2060, U+FEFF; interlinear marks U+FFF9 to U+FFFB
/// * tags U+E0000 to U+E007F
pub fn hostile(c: char) -> bool {
    match c {
        '\n' | '\t' => false,
        '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' => true,
        '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' => true,
        '\u{2060}' | '\u{2066}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' => true,
        '\u{e0000}'..='\u{e007f}' => true,
        _ => false,
    }
}

/// The text with every hostile character as `\u{…}`; tabs and line breaks stay.
///
/// ```
/// assert_eq!(files::text::visible("a\u{1b}[31mb\n"), "a\\u{1b}[31mb\n");
/// ```
pub fn visible(text: &str) -> Cow<'_, str> {
    replaced(text, hostile, braces)
}

/// [`visible`] in one line: tabs and line breaks too become escapes.
///
/// ```
/// assert_eq!(files::text::line("a\nb"), "a\\u{a}b");
/// ```
pub fn line(text: &str) -> Cow<'_, str> {
    replaced(text, |c| hostile(c) || c == '\n' || c == '\t', braces)
}

/// A cell of CSV (RFC 4180), in quotes where it has to be.
///
/// ```
/// assert_eq!(files::text::cell("a,\"b\""), "\"a,\"\"b\"\"\"");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    match text.contains([',', ';', '"', '\n', '\r']) {
        true => Cow::Owned(format!("\"{}\"", text.replace('"', "\"\""))),
        false => Cow::Borrowed(text),
    }
}

/// The text of a JSON document with every hostile character as `\uXXXX`: another spelling of the same value, because
/// JSON has hostile characters only in its strings.
///
/// ```
/// assert_eq!(files::text::json("\"\u{85}\""), "\"\\u0085\"");
/// ```
pub fn json(text: &str) -> Cow<'_, str> {
    // A carriage return may be between the values of a document.
    replaced(
        text,
        |c| hostile(c) && c != '\r',
        |c, out| {
            for unit in c.encode_utf16(&mut [0; 2]) {
                let _ = write!(out, "\\u{unit:04x}");
            }
        },
    )
}

fn braces(c: char, out: &mut String) {
    let _ = write!(out, "\\u{{{:x}}}", c as u32);
}

/// Byte at which the first bad character begins. Pages are megabytes of harmless text: only bytes with which a hostile character
/// can begin are decoded.
fn first(text: &str, bad: impl Fn(char) -> bool) -> Option<usize> {
    // Controls and DEL; leading bytes of U+0080, U+061C, U+2000, U+FEFF, U+E0000 and their neighbours.
    let suspicious = |b: u8| b < 0x20 || matches!(b, 0x7f | 0xc2 | 0xd8 | 0xe2 | 0xef | 0xf3);
    let starts = text.bytes().enumerate().filter(|&(_, b)| suspicious(b));
    let decoded = |at: usize| text.get(at..).and_then(|rest| rest.chars().next());
    starts.map(|(at, _)| at).find(|&at| decoded(at).is_some_and(&bad))
}

fn replaced(text: &str, bad: impl Fn(char) -> bool, put: impl Fn(char, &mut String)) -> Cow<'_, str> {
    let Some(first) = first(text, &bad) else {
        return Cow::Borrowed(text);
    };
    let mut out = String::with_capacity(text.len() + 16);
    out.push_str(&text[..first]);
    for c in text[first..].chars() {
        if bad(c) {
            put(c, &mut out);
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_is_shown_and_what_is_read_stays() {
        let plain = "Behälter α·β  ²³ ✓ 日本 e\u{301}\u{a0}\u{202f}x\ty\n";
        assert!(matches!(visible(plain), Cow::Borrowed(_)));
        for c in [
            '\0',
            '\u{7}',
            '\u{8}',
            '\r',
            '\u{1b}',
            '\u{7f}',
            '\u{80}',
            '\u{9b}',
            '\u{9f}',
            '\u{61c}',
            '\u{200b}',
            '\u{200e}',
            '\u{200f}',
            '\u{2028}',
            '\u{2029}',
            '\u{202a}',
            '\u{202e}',
            '\u{2066}',
            '\u{2069}',
            '\u{feff}',
            '\u{e0041}',
        ] {
            let shown = visible(&format!("a{c}b")).into_owned();
            assert_eq!(shown, format!("a\\u{{{:x}}}b", c as u32));
            assert!(!shown.chars().any(hostile));
        }
        assert_eq!(line("a\tb\nc"), "a\\u{9}b\\u{a}c");
    }

    /// The search by leading bytes finds exactly the characters of the definition.
    #[test]
    fn every_hostile_character_is_found_by_its_first_byte() {
        for c in '\0'..=char::MAX {
            let found = first(&format!("\u{e9}{c}"), hostile);
            assert_eq!(found, hostile(c).then_some(2), "U+{:04X}", c as u32);
        }
    }

    #[test]
    fn json_keeps_its_value() {
        let value = serde_json::json!({ "n\u{9b}": "a\u{1b}\u{85}\u{202e}\u{e0041}\n\r\"\\" });
        let text = serde_json::to_string_pretty(&value).unwrap();
        let shown = json(&text);
        assert!(!shown.chars().any(hostile), "{shown}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&shown).unwrap(), value);
    }
}
