//! Numbers of figures and tables, in the order of the page.
//!
//! Templates leave the empty elements `<span class="fno"></span>` and `<span class="tno"></span>`; sections are rendered one by one and do
//! not know what stands before them.

use crate::words::labels::{FIGURE, TABLE};

const FIGURE_PLACE: &str = "<span class=\"fno\"></span>";
const TABLE_PLACE: &str = "<span class=\"tno\"></span>";

/// Fills the places.
pub fn number(html: &str) -> String {
    fill(&fill(html, FIGURE_PLACE, "fno", FIGURE), TABLE_PLACE, "tno", TABLE)
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
    fn figures_and_tables_are_counted_apart() {
        let page = "a<span class=\"fno\"></span>b<span class=\"tno\"></span>c<span class=\"fno\"></span>";
        let found = number(page);
        assert_eq!(
            found,
            "a<span class=\"fno\">Figure\u{a0}1.</span>b<span class=\"tno\">Table\u{a0}1.</span>c<span class=\"fno\">Figure\u{a0}2.</span>"
        );
    }
}
