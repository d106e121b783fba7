//! Numbers of figures and tables, in the order of the page.
//!
//! Templates leave the empty elements `<span class="fno"></span>` and `<span class="tno"></span>`; sections are rendered one by one and do
//! not know what stands before them. A table that has no title is called what its section is called.

use crate::words::labels::{FIGURE, TABLE};

const FIGURE_PLACE: &str = "<span class=\"fno\"></span>";
const TABLE_PLACE: &str = "<span class=\"tno\"></span>";

/// The place of a table without a title.
const UNTITLED: &str = "<span class=\"tno\"></span></caption>";

/// Fills the places.
pub fn number(html: &str) -> String {
    let titled = title(html);
    fill(&fill(&titled, FIGURE_PLACE, "fno", FIGURE), TABLE_PLACE, "tno", TABLE)
}

/// Titles of tables that have none: the heading above.
fn title(html: &str) -> String {
    let mut parts = html.split(UNTITLED).peekable();
    let mut out = String::with_capacity(html.len() + 1024);
    while let Some(part) = parts.next() {
        out.push_str(part);
        if parts.peek().is_some() {
            let heading = heading(&out).unwrap_or_default();
            out.push_str(TABLE_PLACE);
            if !heading.is_empty() {
                out.push(' ');
                out.push_str(&heading);
            }
            out.push_str("</caption>");
        }
    }
    out
}

/// Text of the last heading, without the number of the section.
fn heading(html: &str) -> Option<String> {
    let end = ["</h2>", "</h3>", "</h4>"].iter().filter_map(|tag| html.rfind(tag)).max()?;
    let start = html[..end].rfind("<h")?;
    let mut text = &html[start + html[start..].find('>')? + 1..end];
    if let Some(numbered) = text.strip_prefix("<span class=\"no\">") {
        text = &numbered[numbered.find("</span>")? + "</span>".len()..];
    }
    let mut out = String::new();
    for (i, part) in text.split('<').enumerate() {
        out.push_str(if i == 0 { part } else { part.split_once('>')?.1 });
    }
    Some(out.trim().to_string())
}

fn fill(html: &str, place: &str, class: &str, word: &str) -> String {
    let mut parts = html.split(place);
    let mut out = String::with_capacity(html.len() + 1024);
    out.push_str(parts.next().unwrap_or_default());
    for (i, part) in parts.enumerate() {
        out.push_str(&format!("<span class=\"{class}\">{word}\u{a0}{}.</span>", i + 1));
        out.push_str(part);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn a_table_without_a_title_has_that_of_its_section() {
        let place = "<span class=\"tno\"></span>";
        let page = format!(
            "<h2><span class=\"no\">4</span> Ground <em>motion</em></h2><caption>{place}</caption><h3>Set</h3><caption>{place} Own</caption>"
        );
        let found = number(&page);
        assert!(found.contains("Table\u{a0}1.</span> Ground motion</caption>"), "{found}");
        assert!(found.contains("Table\u{a0}2.</span> Own</caption>"), "{found}");
    }

    #[test]
    fn figures_and_tables_are_counted_apart() {
        let page = "a<span class=\"fno\"></span>b<span class=\"tno\"></span>c<span class=\"fno\"></span>";
        let found = number(page);
        assert_eq!(
            found,
            "a<span class=\"fno\">Figure\u{a0}1.</span>b<span class=\"tno\">Table\u{a0}1.</span>c<span class=\"fno\">Figure\u{a0}2.</span>"
        );
    }
}
