//! Page numbers in the contents of a page that is printed.
//!
//! Browsers number pages, but no style sheet of theirs gives the page of a place (`target-counter` of CSS Generated Content). Who prints a page can:
//! once to learn the pages, then with their numbers.

/// Looks of the numbers, of the printed page alone.
const STYLE: &str = "<style>.contents .page { font-weight: 600; } .contents .page::before { content: \" … \"; white-space: pre; font-weight: 400; }</style>";

/// The page with a number after each line of its contents; `None` of a page without contents.
///
/// * `page`: the page number of a section by its id; without one a line stays as it is
pub fn numbered(html: &str, page: impl Fn(&str) -> Option<usize>) -> Option<String> {
    let (before, rest) = html.split_once("<nav class=\"contents\"")?;
    let (list, after) = rest.split_once("</nav>")?;
    let mut lines = String::with_capacity(list.len());
    for (i, part) in list.split("<a href=\"#").enumerate() {
        if i == 0 {
            lines.push_str(part);
            continue;
        }
        lines.push_str("<a href=\"#");
        let number = part.split_once('"').and_then(|(id, _)| page(id));
        match (number, part.split_once("</a>")) {
            (Some(number), Some((line, end))) => {
                lines.push_str(&format!("{line}<span class=\"page\">{number}</span></a>{end}"));
            }
            _ => lines.push_str(part),
        }
    }
    Some(format!("{before}{STYLE}<nav class=\"contents\"{lines}</nav>{after}"))
}

#[cfg(test)]
mod tests {
    use super::numbered;

    #[test]
    fn lines_get_the_number_of_their_place() {
        let html = "<p>a</p><nav class=\"contents\" x><ol><li><a href=\"#one\">1 One</a></li><li><a href=\"#two\">2 Two</a></li></ol></nav><a href=\"#one\">b</a>";
        let found = numbered(html, |id| (id == "two").then_some(7)).unwrap();
        assert!(found.contains("<a href=\"#one\">1 One</a></li>"));
        assert!(found.contains("<a href=\"#two\">2 Two<span class=\"page\">7</span></a></li></ol></nav>"));
        assert!(found.ends_with("<a href=\"#one\">b</a>"));
        assert!(numbered("<p>a</p>", |_| Some(1)).is_none());
    }
}
