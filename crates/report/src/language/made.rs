//! Texts of the page under construction that are in its language and units already.

use std::cell::RefCell;
use std::collections::HashSet;

thread_local! {
    static MADE: RefCell<HashSet<String>> = RefCell::default();
}

/// Blanks as the pages are read.
fn plain(text: &str) -> String {
    text.replace('\u{a0}', " ")
}

/// Begins a page: no text of it is made yet.
pub(crate) fn begin() {
    MADE.take();
}

/// A text that nothing changes any more.
pub(crate) fn made(text: String) -> String {
    MADE.with_borrow_mut(|made| made.insert(plain(&text)));
    text
}

/// Whether a text is one of them.
pub(crate) fn is_made(text: &str) -> bool {
    MADE.with_borrow(|made| !made.is_empty() && made.contains(&plain(text)))
}
