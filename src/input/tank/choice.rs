//! Closed choices of words as values of the file.

use files::code::Code;
use tank::keys::list;
use tank::words::Words;

use super::read::{nearest, wrong_kind, wrong_value};
use super::syntax::{Kind, Node};
use crate::input::diagnostic::Faults;

/// The item that a word names; reports an unknown word with the nearest known one as a suggestion.
pub(in crate::input) fn one_of_words<T: Copy>(
    node: &Node,
    words: &[(&'static str, T)],
    faults: &mut Faults,
) -> Option<T> {
    let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
    let allowed = quoted(&known);
    let Kind::Text(text) = &node.kind else {
        faults.push(wrong_kind(node, &allowed));
        return None;
    };
    let found = words.iter().find(|(word, _)| word == text);
    if found.is_none() {
        let mut fault = wrong_value(Code::UnknownChoice, node, &format!("unknown choice `{text}`"), &allowed);
        if let Some(near) = nearest(text, known) {
            fault = fault.help(format!("did you mean \"{near}\"?"));
        }
        faults.push(fault);
    }
    found.map(|(_, item)| *item)
}

/// `"a", "b" or "c"`.
pub(in crate::input) fn quoted(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|w| format!("\"{w}\"")).collect();
    list(&quoted.iter().map(String::as_str).collect::<Vec<_>>(), "or")
}

/// Makes choices of words that [`tank::words!`] declares values of the file.
macro_rules! choice {
    ($($name:ty),+ $(,)?) => {$(
        impl $crate::input::tank::read::FromNode for $name {
            fn from_node(node: &$crate::input::tank::syntax::Node, faults: &mut $crate::input::diagnostic::Faults) -> Option<Self> {
                $crate::input::tank::choice::one_of_words(node, &$crate::input::tank::choice::words(), faults)
            }
            fn allowed() -> String {
                $crate::input::tank::choice::allowed_words::<$name>()
            }
            fn example() -> String {
                format!("\"{}\"", <$name as ::tank::words::Words>::WORDS[0].0)
            }
            fn shape(book: &mut $crate::input::tank::shape::Book) -> $crate::input::tank::shape::Shape {
                book.words_of::<$name>()
            }
            fn written(&self) -> Option<String> {
                Some(::tank::words::Words::word(*self).into())
            }
        }

        $crate::input::tank::values::echoed!($name);
    )+};
}

/// The words of a choice, each with its value.
pub(in crate::input) fn words<T: Words>() -> Vec<(&'static str, T)> {
    T::WORDS.iter().map(|(word, value, _)| (*word, *value)).collect()
}

/// The words of a choice for messages.
pub(in crate::input) fn allowed_words<T: Words>() -> String {
    quoted(&T::WORDS.iter().map(|(word, ..)| *word).collect::<Vec<_>>())
}

pub(in crate::input) use choice;
