//! Language and units of a report: those of `project` in `tank.json`, or those that the command line asks for.
//!
//! ```
//! use report::style::{self, Wish};
//! use tank::{Language, units::System};
//!
//! let _wish = style::wish(Wish { language: Some(Language::German), units: None });
//! let _scope = style::of(None);
//! assert_eq!(style::language(), Language::German);
//! assert_eq!(System::current(), System::Si);
//! ```

use std::cell::Cell;

use tank::units::{self, System};
use tank::{Language, Project};

/// What the command line asks for; absent parts are those of the project.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wish {
    /// Language.
    pub language: Option<Language>,
    /// Units.
    pub units: Option<System>,
}

thread_local! {
    static WISH: Cell<Wish> = const { Cell::new(Wish { language: None, units: None }) };
    static LANGUAGE: Cell<Language> = const { Cell::new(Language::English) };
}

/// While it lives, reports of this thread follow the wish.
#[derive(Debug)]
pub struct Wished(Wish);

impl Drop for Wished {
    fn drop(&mut self) {
        WISH.set(self.0);
    }
}

/// Reports of this thread follow `wish` from here on.
#[must_use]
pub fn wish(wish: Wish) -> Wished {
    Wished(WISH.replace(wish))
}

/// While it lives, pages of this thread are in its language and units.
#[derive(Debug)]
pub struct Scope {
    language: Language,
    _units: units::Scope,
}

impl Drop for Scope {
    fn drop(&mut self) {
        LANGUAGE.set(self.language);
    }
}

/// Units of the pages and tables for `project`.
pub fn units(project: Option<&Project>) -> System {
    WISH.get().units.or(project.and_then(|p| p.units)).unwrap_or_default()
}

/// Language and units of a page for `project`.
#[must_use]
pub fn of(project: Option<&Project>) -> Scope {
    let wish = WISH.get();
    let language = wish.language.or(project.and_then(|p| p.language)).unwrap_or_default();
    let units = self::units(project);
    Scope { language: LANGUAGE.replace(language), _units: units::Scope::of(units) }
}

/// The language of the page under construction.
pub fn language() -> Language {
    LANGUAGE.get()
}
