//! Finds the texts of a page and replaces them.
//!
//! A text is what stands between two tags. Lowered letters, code and formulas are part of it: `S<sub>e</sub>` is read as
//! `S_e`, code as `` `code` ``, and set again as they were.

use tank::Language;
use tank::units::{System, converted};

use super::made::is_made;
use super::{DIGITS, german};
use crate::figure::svg::escape;
use crate::math;

/// First of the characters that stand for formulas; those of the private use area.
const FORMULA: u32 = 0xE000;

/// Elements whose content is not text.
const RAW: [&str; 2] = ["style", "script"];

/// Elements that hold a text of the user: it stays as it is.
const GIVEN: &str = "class=\"given\"";
/// Elements that hold a formula and what is put into it: their values stay in SI, as the constants beside them.
const CALCULATED: [&str; 2] = ["class=\"calc\"", "class=\"source\""];
/// Forms of the cover whose values, in these elements, are the user's.
const FORMS: [(&str, &str); 2] = [("class=\"cover\"", "dd"), ("class=\"signatures\"", "td")];

/// The page with its texts in `language` and its values of SI in `units`.
pub(super) fn rewritten(html: &str, language: Language, units: System) -> String {
    let mut page = Page {
        out: String::with_capacity(html.len() + html.len() / 8),
        text: Text::default(),
        language,
        units,
        open: Vec::new(),
        svg: 0,
    };
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        page.text.push(&unescaped(&rest[..at]));
        let end = rest[at..].find('>').map_or(rest.len(), |e| at + e + 1);
        let tag = &rest[at..end];
        rest = page.tag(tag, &rest[end..]);
    }
    page.text.push(&unescaped(rest));
    page.flush();
    page.out
}

/// A text under construction.
#[derive(Default)]
struct Text {
    plain: String,
    formulas: Vec<String>,
    /// Whether it had lowered letters or code.
    prose: bool,
    /// Whether it may be broken within words.
    breaks: bool,
}

impl Text {
    fn push(&mut self, text: &str) {
        self.plain.push_str(text);
    }
}

/// An open element.
#[derive(Clone, Default)]
struct Open {
    name: String,
    /// Clauses stand in it: their numbers stay.
    clause: bool,
    /// A text of the user stands in it: all of it stays.
    given: bool,
    /// A formula stands in it: values stay in SI.
    calculated: bool,
    /// The name of the user begins it: units and decimals stay.
    title: bool,
    /// Within a form: the element whose values are the user's.
    form: Option<&'static str>,
}

struct Page {
    out: String,
    text: Text,
    language: Language,
    units: System,
    /// Open elements.
    open: Vec<Open>,
    /// How many of them are drawings.
    svg: usize,
}

impl Page {
    /// Reads a tag and, for some, the content behind it; returns what follows.
    fn tag<'a>(&mut self, tag: &str, after: &'a str) -> &'a str {
        let closing = tag.starts_with("</");
        let name = tag.trim_start_matches(['<', '/']).split([' ', '>', '/', '\n']).next().unwrap_or_default();
        let given = self.open.last().is_some_and(|o| o.given);
        match name {
            _ if given => {}
            "wbr" => {
                self.text.breaks = true;
                return after;
            }
            "sub" if self.svg == 0 && !closing => {
                if let Some((inside, rest)) = after.split_once("</sub>") {
                    self.text.push("_");
                    self.text.push(&unescaped(inside));
                    self.text.prose = true;
                    return rest;
                }
            }
            "code" if !closing && !after.starts_with('`') => {
                if let Some((inside, rest)) = after.split_once("</code>")
                    && !inside.contains(['<', '`'])
                {
                    self.text.push("`");
                    self.text.push(&unescaped(inside));
                    self.text.push("`");
                    self.text.prose = true;
                    return rest;
                }
            }
            "math" if !closing => {
                if let Some((inside, rest)) = after.split_once("</math>") {
                    self.formula(&format!("{tag}{inside}</math>"));
                    return rest;
                }
            }
            _ => {}
        }
        self.flush();
        if RAW.contains(&name) && !closing {
            let end = after.find(&format!("</{name}>")).unwrap_or(after.len());
            self.out.push_str(tag);
            let style = &after[..end];
            self.out.push_str(&match self.language {
                Language::English => style.to_owned(),
                Language::German => running_heads(style),
            });
            return &after[end..];
        }
        self.nest(name, tag, closing);
        let tag = self.attributes(tag);
        self.out.push_str(&tag);
        after
    }

    fn nest(&mut self, name: &str, tag: &str, closing: bool) {
        let void =
            tag.ends_with("/>") || tag.starts_with("<!") || matches!(name, "meta" | "br" | "col" | "img" | "input");
        if void {
            return;
        }
        if closing {
            if let Some(at) = self.open.iter().rposition(|o| o.name == name) {
                self.svg -= self.open[at..].iter().filter(|o| o.name == "svg").count();
                self.open.truncate(at);
            }
            return;
        }
        let mut element = self.open.last().cloned().unwrap_or_default();
        name.clone_into(&mut element.name);
        element.clause |= tag.contains("class=\"clause\"");
        element.calculated |= CALCULATED.iter().any(|c| tag.contains(c));
        element.title |= name == "h1" || (name == "title" && self.svg == 0);
        if let Some((_, inside)) = FORMS.iter().find(|f| tag.contains(f.0)) {
            element.form = Some(inside);
        }
        element.given |= tag.contains(GIVEN) || element.form == Some(name);
        self.svg += usize::from(name == "svg");
        self.open.push(element);
    }

    /// The tag with its labels for readers of the screen and its language.
    fn attributes(&self, tag: &str) -> String {
        if self.language == Language::English {
            return tag.to_owned();
        }
        if tag.starts_with("<html") {
            return tag.replace("lang=\"en\"", "lang=\"de\"");
        }
        for label in [" aria-label=\"", " title=\"", " alt=\""] {
            if let Some((before, rest)) = tag.split_once(label)
                && let Some((text, after)) = rest.split_once('"')
            {
                return format!("{before}{label}{}\"{after}", escape(&german(&unescaped(text))));
            }
        }
        tag.to_owned()
    }

    /// A formula as one character of the text.
    fn formula(&mut self, markup: &str) {
        let number = self.text.formulas.len() as u32;
        let Some(sign) = char::from_u32(FORMULA + number).filter(|_| number < 0x1000) else {
            self.text.push(markup);
            return;
        };
        let markup = match self.language {
            Language::English => markup.to_owned(),
            Language::German => commas(markup),
        };
        self.text.formulas.push(markup);
        self.text.plain.push(sign);
    }

    /// Writes the text.
    fn flush(&mut self) {
        let text = std::mem::take(&mut self.text);
        let words: String = text.plain.split([' ', '\n', '\t']).filter(|w| !w.is_empty()).collect::<Vec<_>>().join(" ");
        if words.is_empty() {
            self.out.push_str(&text.plain);
            return;
        }
        let place = self.open.last().cloned().unwrap_or_default();
        if place.given {
            self.out.push_str(&escape(&text.plain));
            return;
        }
        let blank = |c: char| matches!(c, ' ' | '\n' | '\t');
        let lead = &text.plain[..text.plain.len() - text.plain.trim_start_matches(blank).len()];
        let trail = &text.plain[text.plain.trim_end_matches(blank).len()..];
        let units = match self.units {
            // Labels with two values do not fit.
            System::Both if self.svg > 0 => System::Si,
            _ if place.clause || place.title || place.calculated => System::Si,
            units => units,
        };
        let made = is_made(&words);
        let words = if made { words.into() } else { converted(&words, units, DIGITS) };
        let shown = match self.language {
            _ if made => words.into_owned(),
            Language::English => words.into_owned(),
            Language::German if place.clause => super::clause(&words),
            // A name alone, or before a dash.
            Language::German if place.title => match words.rsplit_once(" – ") {
                Some((name, what)) => format!("{name} – {}", german(what)),
                None => words.into_owned(),
            },
            Language::German => german(&words),
        };
        let set = match (text.prose, text.breaks) {
            (_, true) => {
                math::words(&shown).replacen("<span class=\"words\">", "", 1).trim_end_matches("</span>").to_owned()
            }
            (true, false) => math::prose(&shown),
            (false, false) => escape(&shown),
        };
        self.out.push_str(lead);
        for c in set.chars() {
            let formula = (c as u32).checked_sub(FORMULA).and_then(|i| text.formulas.get(i as usize));
            match formula {
                Some(markup) => self.out.push_str(markup),
                None => self.out.push(c),
            }
        }
        self.out.push_str(trail);
    }
}

/// A formula with decimal commas; its arguments are then separated by semicolons.
fn commas(markup: &str) -> String {
    let mut out = String::with_capacity(markup.len());
    let mut parts = markup.replace("<mo>,</mo>", "<mo>;</mo>");
    while let Some(at) = parts.find("<mn>") {
        let inside = at + "<mn>".len();
        let end = parts[inside..].find('<').map_or(parts.len(), |e| inside + e);
        out.push_str(&parts[..inside]);
        out.push_str(&parts[inside..end].replace('.', ","));
        parts = parts.split_off(end);
    }
    out.push_str(&parts);
    out
}

/// Words in the running heads of printed pages.
const HEADS: [&str; 4] = ["seismic verification", "seismic study", "incremental dynamic analysis", "pushover"];

/// The style with its running heads.
fn running_heads(style: &str) -> String {
    let mut out = style.replace("\"page \"", "\"Seite \"").replace("\" of \"", "\" von \"");
    for head in HEADS {
        out = out.replace(&format!("{head}\";"), &format!("{}\";", german(head)));
    }
    out
}

/// Text without the escapes of XML.
fn unescaped(text: &str) -> String {
    if !text.contains('&') {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        out.push_str(&rest[..at]);
        let known = [
            ("&amp;", '&'),
            ("&lt;", '<'),
            ("&gt;", '>'),
            ("&quot;", '"'),
            ("&#39;", '\''),
            ("&#x27;", '\''),
            ("&#x2F;", '/'),
            ("&#x2f;", '/'),
        ];
        match known.iter().find(|(name, _)| rest[at..].starts_with(name)) {
            Some((name, c)) => {
                out.push(*c);
                rest = &rest[at + name.len()..];
            }
            None => {
                out.push('&');
                rest = &rest[at + 1..];
            }
        }
    }
    out.push_str(rest);
    out
}
