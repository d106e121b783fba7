//! Escaping of user text, so that names, messages and files cannot control a terminal or hide parts of a page. A
//! hostile character is shown as its escape in Rust and JSON5, `\u{1b}`. All output for people goes through
//! [`visible`]: pages and figures in [`report::Report::new`], standard output and standard error in `cli` through [`printed`]. A name
//! inside a sentence goes through [`line`], so that it cannot forge lines. Files for programs keep the exact text;
//! JSON on standard output has the same values in the escapes of [`json`].
//!
//! | format | function |
//! |---|---|
//! | terminal, log of a runner | [`printed`] |
//! | commands of GitHub workflows | [`workflow_value`], [`workflow_property`] |
//! | JSON, SARIF | [`json`] |
//! | XML: SVG, JUnit, NRML | [`xml`] |
//! | CSV | [`cell`] |
//! | HTML | the templates escape, then [`visible`] |
//! | workbook | its writer escapes, after [`visible`] |

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character controls a terminal or the order of text instead of being visible.
///
/// * C0 but for tab and line feed, DEL, C1 (U+0080 to U+009F)
/// * direction: U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+206F
/// * line separators U+2028, U+2029; zero width U+200B to U+200D, U+2060 to U+2064, U+FEFF; interlinear marks U+FFF9 to U+FFFB
/// * U+FFFE and U+FFFF, which are not characters and not allowed in XML
/// * tags U+E0000 to U+E007F
pub fn hostile(c: char) -> bool {
    match c {
        '\n' | '\t' => false,
        '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' => true,
        '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' => true,
        '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{fffe}' | '\u{ffff}' => true,
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

/// [`visible`] without commands to a runner that reads the log: GitHub acts on a line that begins with `::`, and with Azure and TeamCity on
/// `##word[` anywhere. Their first sign becomes an escape.
///
/// ```
/// assert_eq!(files::text::printed("a\n ::error::b ##vso[c]"), "a\n \\u{3a}:error::b \\u{23}#vso[c]");
/// ```
pub fn printed(text: &str) -> Cow<'_, str> {
    match visible(text) {
        Cow::Borrowed(text) => without_commands(text),
        Cow::Owned(text) => Cow::Owned(without_commands(&text).into_owned()),
    }
}

/// [`printed`] of a text that has colours of ours: its hostile characters stay.
pub fn without_commands(text: &str) -> Cow<'_, str> {
    if !text.contains("::") && !text.contains("##") {
        return Cow::Borrowed(text);
    }
    let opens = |rest: &str| {
        let after = rest.strip_prefix("##");
        after.is_some_and(|word| word.trim_start_matches(|c: char| c.is_ascii_alphabetic()).starts_with('['))
    };
    let mut out = String::with_capacity(text.len() + 16);
    for line in text.split_inclusive('\n') {
        let start = line.len() - line.trim_start().len();
        let colons = line[start..].starts_with("::");
        for (at, c) in line.char_indices() {
            match c {
                ':' if colons && at == start => braces(c, &mut out),
                '#' if opens(&line[at..]) => braces(c, &mut out),
                c => out.push(c),
            }
        }
    }
    Cow::Owned(out)
}

/// The message of a command of GitHub workflows, escaped as its toolkit does, in one line.
///
/// ```
/// assert_eq!(files::text::workflow_value("50 %\n::stop"), "50 %25%0A::stop");
/// ```
pub fn workflow_value(text: &str) -> String {
    let text = text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A");
    visible(&text).into_owned()
}

/// A property of such a command.
///
/// ```
/// assert_eq!(files::text::workflow_property("a:b,c"), "a%3Ab%2Cc");
/// ```
pub fn workflow_property(text: &str) -> String {
    workflow_value(text).replace(':', "%3A").replace(',', "%2C")
}

/// A text within XML 1.0, element or attribute; what is not allowed there stands as its escape.
///
/// ```
/// assert_eq!(files::text::xml("a<\u{1}'"), "a&lt;\\u{1}&#39;");
/// ```
pub fn xml(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in visible(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// A cell of CSV (RFC 4180), in quotes where it has to be. A text that a spreadsheet takes as a formula follows an apostrophe, which
/// [`uncelled`] removes; a number stays a number.
///
/// ```
/// assert_eq!(files::text::cell("a,\"b\""), "\"a,\"\"b\"\"\"");
/// assert_eq!(files::text::cell("=1+1"), "'=1+1");
/// assert_eq!(files::text::cell("-1.5e3"), "-1.5e3");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    let text = match formula(text.trim_start_matches('\'')) && text.parse::<f64>().is_err() {
        true => Cow::Owned(format!("'{text}")),
        false => Cow::Borrowed(text),
    };
    match text.contains([',', ';', '"', '\n', '\r']) {
        true => Cow::Owned(format!("\"{}\"", text.replace('"', "\"\""))),
        false => text,
    }
}

/// The text of a cell that [`cell`] has written.
///
/// ```
/// assert_eq!(files::text::uncelled("'=1+1"), "=1+1");
/// assert_eq!(files::text::uncelled("'t"), "'t");
/// ```
pub fn uncelled(text: &str) -> &str {
    let bare = text.strip_prefix('\'');
    bare.filter(|rest| formula(rest.trim_start_matches('\''))).unwrap_or(text)
}

/// Whether a spreadsheet may take a cell as a formula: its first sign is one of those with which formulas begin, also in full width, or a
/// tab or line end before one.
fn formula(text: &str) -> bool {
    let signs = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];
    text.starts_with(['\t', '\r', '\n']) || text.trim_start().starts_with(signs)
}

/// The text of a JSON document with every hostile character as `\uXXXX`: another spelling of the same value, because
/// JSON has hostile characters only in its strings.
///
/// ```
/// assert_eq!(files::text::json("\"\u{85}\""), "\"\\u0085\"");
/// ```
pub fn json(text: &str) -> Cow<'_, str> {
    // A carriage return may be between the values of a document. Two hashes may open a command, see [`printed`].
    let hashes = text.contains("##");
    replaced(
        text,
        |c| (hostile(c) && c != '\r') || (hashes && c == '#'),
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
    // Controls, `#` and DEL; leading bytes of U+0080, U+061C, U+2000, U+FEFF, U+E0000 and their neighbours.
    let suspicious = |b: u8| b < 0x20 || matches!(b, b'#' | 0x7f | 0xc2 | 0xd8 | 0xe2 | 0xef | 0xf3);
    let starts = text.bytes().enumerate().filter(|&(_, b)| suspicious(b));
    let decoded = |at: usize| text.get(at..).and_then(|rest| rest.chars().next());
    starts.map(|(at, _)| at).find(|&at| decoded(at).is_some_and(&bad))
}

fn replaced(text: &str, bad: impl Fn(char) -> bool, put: impl Fn(char, &mut String)) -> Cow<'_, str> {
    let Some(first) = first(text, &bad) else { return Cow::Borrowed(text) };
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
        let value = serde_json::json!({ "n\u{9b}": "a\u{1b}\u{85}\u{202e}\u{e0041}\n\r\"\\##[stop]\u{fffe}" });
        let text = serde_json::to_string_pretty(&value).unwrap();
        let shown = json(&text);
        assert!(!shown.chars().any(hostile), "{shown}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&shown).unwrap(), value);
        // Nothing of it is changed where it is printed.
        assert_eq!(printed(&shown), shown);
    }

    #[test]
    fn no_line_is_a_command_to_a_runner() {
        for text in ["::a", "x\n::a", "\u{a0} ::a", "##[a]", "x ##[a]", "###vso[a]", "##teamcity[a]", "\t::a ##[b]"] {
            let shown = printed(text);
            for line in shown.lines() {
                assert!(!line.trim_start().starts_with("::"), "{text:?}: {shown}");
            }
            assert!(!shown.contains("##[") && !shown.contains("##vso[") && !shown.contains("##teamcity["), "{shown}");
        }
        for plain in ["a::b", "## Head [link]", "#1 [a]", "T ## x"] {
            assert!(matches!(printed(plain), Cow::Borrowed(_)) || printed(plain) == plain, "{plain}");
        }
    }

    #[test]
    fn cells_are_texts_and_come_back() {
        let texts = [
            "=1",
            "+a",
            "-cmd|' /C calc'!A0",
            "@SUM(1)",
            "\t=1",
            "\r=1",
            " =1",
            "＝1",
            "a",
            "'a",
            "'=1",
            "a\n=1",
            "-",
            "\"=1\"",
        ];
        for text in texts {
            let written = cell(text);
            let bare = match written.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
                Some(inner) => inner.replace("\"\"", "\""),
                None => written.clone().into_owned(),
            };
            assert!(!formula(&bare), "{text:?}: {written}");
            assert_eq!(uncelled(&bare), text);
        }
        for number in ["-1", "+2.5", "-1.5e-3", "0", "-.5"] {
            assert_eq!(cell(number), number);
        }
    }

    /// Every character of Unicode in XML, by another reader.
    #[test]
    fn xml_is_well_formed_with_every_character() {
        let all: String = ('\0'..=char::MAX).collect();
        let text = format!("<a b=\"{0}\">{0}</a>", xml(&all));
        let document = roxmltree::Document::parse(&text).unwrap();
        let root = document.root_element();
        assert_eq!(root.text(), Some(&*visible(&all)));
        // A reader makes a blank of line feed and tab in an attribute.
        assert_eq!(root.attribute("b"), Some(&*visible(&all).replace(['\n', '\t'], " ")));
    }
}
