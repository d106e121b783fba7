//! The report for a converter to text documents (pandoc): figures are files of their own, and what is for the screen alone is left out.

use crate::Report;
use crate::figure::emf::emf;
use crate::figure::plain::plain;

/// A page whose figures are files in a folder next to it.
pub struct Document {
    /// The page.
    pub html: String,
    /// Figures: name within the folder of the page, and a metafile.
    pub figures: Vec<(String, Vec<u8>)>,
}

/// The document of a report; figures are named `figures/….emf`.
pub fn document(report: &Report) -> Document {
    let page = cut(&report.html, "<nav class=\"contents\"", "</nav>");
    let page = cut(&page, "<style>", "</style>");
    // Data of figures.
    let page = cut(&page, "<details>", "</details>");
    Document {
        html: spread(&linked(&page)),
        figures: report.figures.iter().map(|(name, svg)| (place(name.trim_end_matches(".svg")), file(svg))).collect(),
    }
}

/// The place of a figure.
fn place(name: &str) -> String {
    format!("figures/{name}.emf")
}

/// A figure's file.
fn file(svg: &str) -> Vec<u8> {
    let css = svg.split_once("<style>").and_then(|(_, rest)| rest.split_once("</style>")).map_or("", |(css, _)| css);
    emf(&plain(svg, css))
}

/// Without everything from `open` to `close`, each time.
fn cut(text: &str, open: &str, close: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        out.push_str(before);
        rest = after.split_once(close).map_or("", |(_, after)| after);
    }
    out.push_str(rest);
    out
}

/// The page with images for its drawings, as wide as their place.
fn linked(page: &str) -> String {
    let mut out = String::with_capacity(page.len());
    let mut rest = page;
    while let Some((before, after)) = rest.split_once("<svg ") {
        out.push_str(before);
        let (drawing, after) = after.split_once("</svg>").unwrap_or((after, ""));
        let id = drawing
            .split_once("aria-labelledby=\"")
            .and_then(|(_, rest)| rest.split_once("-t "))
            .map_or("", |(id, _)| id);
        let title = drawing
            .split_once("<title ")
            .and_then(|(_, rest)| rest.split_once('>'))
            .and_then(|(_, rest)| rest.split_once("</title>"))
            .map_or("", |(title, _)| title);
        let room = before.rsplit_once("<figure class=\"").map_or("", |(_, rest)| rest);
        let width = match room.split('"').next() {
            Some("half") => "8cm",
            Some("third") => "5.3cm",
            _ => "16cm",
        };
        out.push_str(&format!("<img src=\"{}\" alt=\"{title}\" width=\"{width}\">", place(&crate::file_name(id))));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Fewest and most characters that a column counts for.
const LETTERS: std::ops::RangeInclusive<usize> = 6..=48;

/// The page with a width for each column of its tables, by the longest text: converters else make all columns alike.
fn spread(page: &str) -> String {
    let mut out = String::with_capacity(page.len() + 4096);
    let mut rest = page;
    while let Some((before, after)) = rest.split_once("<table") {
        let Some((open, after)) = after.split_once('>') else { break };
        let (table, after) = after.split_once("</table>").unwrap_or((after, ""));
        out.push_str(&format!("{before}<table{open}>"));
        let widths = widths(table);
        let columns: String = widths.iter().map(|w| format!("<col style=\"width:{w:.1}%\">")).collect();
        let plain = cut(table, "<colgroup>", "</colgroup>");
        match plain.split_once("</caption>") {
            Some((caption, rows)) => out.push_str(&format!("{caption}</caption><colgroup>{columns}</colgroup>{rows}")),
            None => out.push_str(&format!("<colgroup>{columns}</colgroup>{plain}")),
        }
        out.push_str("</table>");
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Widths of the columns in percent.
fn widths(table: &str) -> Vec<f64> {
    let mut longest: Vec<usize> = Vec::new();
    for row in table.split("<tr").skip(1).filter(|row| !row.contains("colspan")) {
        let cells = row.replace("<th", "<td");
        for (column, cell) in cells.split("<td").skip(1).enumerate() {
            let text = cell.split_once('>').map_or("", |(_, text)| text);
            let letters = letters(text.split("</t").next().unwrap_or_default());
            match longest.get_mut(column) {
                Some(known) => *known = (*known).max(letters),
                None => longest.push(letters),
            }
        }
    }
    let bounded = longest.iter().map(|l| (*l).clamp(*LETTERS.start(), *LETTERS.end()) as f64);
    let total: f64 = bounded.clone().sum();
    bounded.map(|l| 100.0 * l / total).collect()
}

/// Characters of markup outside of its tags.
fn letters(markup: &str) -> usize {
    let mut inside = false;
    let mut count = 0;
    for c in markup.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            _ => count += usize::from(!inside),
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_texts() {
        let table = "<table><caption>t</caption><colgroup><col></colgroup><thead><tr><th>A</th><th class=\"n\">Number</th></tr></thead><tr \
                     class=\"g\"><th colspan=\"2\">a long group that does not count</th></tr><tr><td><b>twelve chars</b></td><td>1</td></tr></table>";
        let found = spread(table);
        assert!(
            found.contains(
                "</caption><colgroup><col style=\"width:66.7%\"><col style=\"width:33.3%\"></colgroup><thead>"
            ),
            "{found}"
        );
    }

    #[test]
    fn drawings_become_images_and_the_screen_is_left_out() {
        let report = Report {
            html: "<style>x</style><nav class=\"contents\">n</nav><figure class=\"half\" id=\"fig-a\"><div><svg class=\"fig\" \
                   aria-labelledby=\"a@1-t a@1-d\"><title id=\"a-t\">A &amp; B</title><path/></svg></div><details>data</details></figure><p>text</p>"
                .into(),
            figures: vec![("a_1.svg".into(), "<svg class=\"fig\"><style>.fig { fill: red; }</style></svg>".into())],
        };
        let found = document(&report);
        assert_eq!(
            found.html,
            "<figure class=\"half\" id=\"fig-a\"><div><img src=\"figures/a_1.emf\" alt=\"A &amp; B\" width=\"8cm\"></div></figure><p>text</p>"
        );
        let [(name, bytes)] = found.figures.as_slice() else { panic!("{} figures", found.figures.len()) };
        assert_eq!((name.as_str(), &bytes[40..44]), ("figures/a_1.emf", &b" EMF"[..]));
    }
}
