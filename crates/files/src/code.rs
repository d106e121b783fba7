//! Codes of errors and warnings: stable ids such as `T0206`, one a *kind* of fault, not one a message.
//!
//! A fault cannot be made without a code, and a code cannot be declared without title, explanation and example
//! (`catalogue`); `tankcheck explain T0206` prints them. An id is never used again for another kind.

use std::fmt::{Display, Formatter};

use serde::{Deserialize, Serialize};

mod catalogue;

pub use catalogue::Code;

/// Whether the run goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Severity {
    /// It ends, nothing is computed or written.
    Error,
    /// It goes on.
    Warning,
}

impl Severity {
    /// The word before the code on the terminal.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        }
    }
}

impl Code {
    /// The code of an id, in any case (`t0206`).
    pub fn find(id: &str) -> Option<Code> {
        Code::ALL.into_iter().find(|code| code.id().eq_ignore_ascii_case(id.trim()))
    }

    /// The part of the program or of the input that the code is about: the first two digits of its id.
    pub fn chapter(self) -> &'static str {
        match self.id().as_bytes()[2] {
            b'1' => "Command line",
            b'2' => "Keys and values of an input file",
            b'3' => "Values that do not fit together",
            b'4' => "Records of ground motion",
            b'5' => "Tables and studies",
            b'6' => "Files and folders",
            b'7' => "Computation",
            _ => "Warnings",
        }
    }

    /// `error[T0206]` or `warning[T0901]`, the head of a message.
    pub fn head(self) -> String {
        format!("{}[{}]", self.severity().word(), self.id())
    }
}

impl Display for Code {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}

/// A warning: its code and one sentence. In JSON a text `T0901: sentence`.
///
/// It reads as its sentence (`warning.contains("…")`).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "String", from = "String")]
pub struct Warning {
    /// `None` only in results that a version before the codes wrote.
    code: Option<Code>,
    text: String,
}

impl Warning {
    /// A warning of a kind.
    pub fn new(code: Code, text: impl Into<String>) -> Warning {
        Warning { code: Some(code), text: text.into() }
    }

    /// Its code; `None` only in results that a version before the codes wrote.
    pub fn code(&self) -> Option<Code> {
        self.code
    }

    /// The sentence.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The same warning about one of several: `subject: sentence`.
    #[must_use]
    pub fn about(self, subject: &str) -> Warning {
        Warning { text: format!("{subject}: {}", self.text), ..self }
    }

    /// `warning[T0901]`, or `warning` without a code.
    pub fn head(&self) -> String {
        self.code.map_or_else(|| Severity::Warning.word().into(), Code::head)
    }
}

impl std::ops::Deref for Warning {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl Display for Warning {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self.code {
            Some(code) => write!(f, "{code}: {}", self.text),
            None => f.write_str(&self.text),
        }
    }
}

impl From<Warning> for String {
    fn from(warning: Warning) -> String {
        warning.to_string()
    }
}

impl From<String> for Warning {
    fn from(written: String) -> Warning {
        let coded = written
            .split_once(": ")
            .and_then(|(id, text)| Some((Code::ALL.into_iter().find(|code| code.id() == id)?, text)));
        match coded {
            Some((code, text)) => Warning::new(code, text),
            None => Warning { code: None, text: written },
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn ids_are_unique_ascending_and_of_one_form() {
        let ids: Vec<&str> = Code::ALL.iter().map(|code| code.id()).collect();
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        assert!(ids.is_sorted(), "{ids:?}");
        for id in ids {
            let digits = id.strip_prefix('T').unwrap_or_default();
            assert!(digits.len() == 4 && digits.bytes().all(|b| b.is_ascii_digit()), "{id}");
        }
    }

    #[test]
    fn every_code_is_explained_and_warnings_have_their_own_hundred() {
        for code in Code::ALL {
            let text = [code.title(), code.explanation(), code.example()];
            assert!(text.iter().all(|t| !t.trim().is_empty()), "{code}: {text:?}");
            assert!(!code.title().ends_with('.') && code.explanation().ends_with('.'), "{code}");
            assert!(code.explanation().len() > code.title().len(), "{code}");
            let warns = code.id().starts_with("T09");
            assert_eq!(code.severity() == Severity::Warning, warns, "{code}");
        }
    }

    #[test]
    fn a_warning_keeps_its_code_in_json_and_an_old_text_has_none() {
        let warning = Warning::new(Code::UnusualRecord, "record `r`: 2 samples");
        let text = serde_json::to_string(&warning).unwrap();
        assert_eq!(text, "\"T0903: record `r`: 2 samples\"");
        assert_eq!(serde_json::from_str::<Warning>(&text).unwrap(), warning);
        let old: Warning = serde_json::from_str("\"record: 2 samples\"").unwrap();
        assert_eq!((old.code(), old.text()), (None, "record: 2 samples"));
        assert_eq!(old.head(), "warning");
    }

    #[test]
    fn codes_are_found_in_any_case() {
        assert_eq!(Code::find(" t0206 "), Some(Code::UnknownKey));
        assert_eq!(Code::find("T9999"), None);
        assert_eq!(Code::UnknownKey.head(), "error[T0206]");
    }
}
