//! The pages of places in a PDF that Chromium wrote.
//!
//! Its objects stand in the file as they are, one after another, and only their streams are compressed (PDF 1.4, ISO 32000-1, 7.7.2 and 12.3.2.3):
//!
//! ```text
//! <</Type /Catalog /Pages 9 0 R /Dests 7 0 R …>>     <</Type /Pages /Kids [2 0 R 5 0 R]>>     <</checks [5 0 R /XYZ 0 771 0] …>>
//! ```

use std::collections::BTreeMap;

/// How deep a tree of pages may be.
const DEPTH: usize = 32;

/// Page of each named place, from 1; `None` of a file that is written in another way.
pub(crate) fn pages(pdf: &[u8]) -> Option<BTreeMap<String, usize>> {
    let text = String::from_utf8_lossy(pdf);
    let objects = objects(&text);
    let catalog = objects.values().find(|body| body.contains("/Type /Catalog"))?;
    let mut order = Vec::new();
    leaves(&objects, reference(catalog, "/Pages ")?, &mut order, 0)?;
    let places = objects.get(&reference(catalog, "/Dests ")?)?;
    let mut found = BTreeMap::new();
    for place in places.split('/').filter(|part| part.contains('[')) {
        let (name, page) = place.split_once('[')?;
        let page: u32 = page.split_whitespace().next()?.parse().ok()?;
        let number = order.iter().position(|leaf| *leaf == page)?;
        found.insert(name.trim().to_owned(), number + 1);
    }
    Some(found)
}

/// Dictionaries by the numbers of their objects.
fn objects(text: &str) -> BTreeMap<u32, &str> {
    let number = |head: &str| head.rsplit('\n').next().and_then(|line| line.trim().parse().ok());
    let mut found = BTreeMap::new();
    let mut rest = text;
    while let Some((head, after)) = rest.split_once(" 0 obj\n") {
        let body = after.split_once("endobj").map_or(after, |(body, _)| body);
        if let (Some(number), true) = (number(head), body.starts_with("<<")) {
            found.insert(number, body);
        }
        rest = after;
    }
    found
}

/// The object that an entry of a dictionary refers to.
fn reference(body: &str, entry: &str) -> Option<u32> {
    let (_, after) = body.split_once(entry)?;
    after.split_whitespace().next()?.parse().ok()
}

/// The pages of a tree in their order.
fn leaves(objects: &BTreeMap<u32, &str>, node: u32, order: &mut Vec<u32>, depth: usize) -> Option<()> {
    let body = objects.get(&node)?;
    let Some((_, kids)) = body.split_once("/Kids [") else {
        order.push(node);
        return Some(());
    };
    if depth > DEPTH {
        return None;
    }
    let (kids, _) = kids.split_once(']')?;
    for kid in kids.split('R') {
        if let Some(number) = kid.split_whitespace().next() {
            leaves(objects, number.parse().ok()?, order, depth + 1)?;
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::pages;

    /// Two levels of pages, and objects in another order than pages.
    #[test]
    fn places_have_the_pages_of_the_tree() {
        let pdf = "%PDF-1.4\n1 0 obj\n<</Length 3>> stream\n\u{fffd}\nendstream\nendobj\n\
             2 0 obj\n<</Type /Page\n/Parent 6 0 R>>\nendobj\n5 0 obj\n<</Type /Page\n/Parent 4 0 R>>\nendobj\n\
             3 0 obj\n<</Type /Page\n/Parent 4 0 R>>\nendobj\n4 0 obj\n<</Type /Pages\n/Kids [5 0 R 3 0 R]>>\nendobj\n\
             6 0 obj\n<</Type /Pages\n/Kids [2 0 R 4 0 R]>>\nendobj\n\
             7 0 obj\n<</tank [5 0 R /XYZ 0 376.2 0]\n/checks [3 0 R /XYZ 0 1 0]\n/top [2 0 R /XYZ 0 8 0]>>\nendobj\n\
             8 0 obj\n<</Type /Catalog\n/Pages 6 0 R\n/Dests 7 0 R>>\nendobj\n%%EOF\n";
        let found = pages(pdf.as_bytes()).unwrap();
        assert_eq!((found["top"], found["tank"], found["checks"]), (1, 2, 3));
        assert!(pages(b"%PDF-1.7\n1 0 obj\n<</Type /ObjStm>> stream\nendobj\n%%EOF").is_none());
    }

    /// A tree that refers to itself ends.
    #[test]
    fn a_circle_is_no_tree() {
        let pdf = "%PDF-1.4\n6 0 obj\n<</Type /Pages\n/Kids [6 0 R]>>\nendobj\n7 0 obj\n<</a [6 0 R /XYZ 0 0 0]>>\nendobj\n\
             8 0 obj\n<</Type /Catalog\n/Pages 6 0 R\n/Dests 7 0 R>>\nendobj\n";
        assert!(pages(pdf.as_bytes()).is_none());
    }
}
