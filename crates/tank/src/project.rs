//! Who a verification is for and who answers for it: the cover of the report.

use crate::keys::{Opt, keys};
use crate::units::System;
use crate::words;

words! {
    /// Language of a report.
    pub Language: English {
        /// English.
        English = "en",
        /// German.
        German = "de",
    }
}

keys! {
    /// Whom the verification is for and who answers for it: cover and running heads of the report. Nothing here changes a number.
    pub Project (Default, Eq) {
        /// Project.
        @"Option::is_none" name ("Terminal North, fire water"): Opt<String>,
        /// Client.
        @"Option::is_none" client ("Harbour Storage Ltd"): Opt<String>,
        /// Number of the document, on every page.
        @"Option::is_none" document ("TK-104-SV-001"): Opt<String>,
        /// Revision, on every page.
        @"Option::is_none" revision ("B"): Opt<String>,
        /// Date of the document, year-month-day.
        @"Option::is_none" date ("2026-03-14"): Opt<String>,
        /// Author.
        @"Option::is_none" author ("J. Doe"): Opt<String>,
        /// Checker.
        @"Option::is_none" checker ("A. Smith"): Opt<String>,
        /// Who approves it.
        @"Option::is_none" approver ("M. Jones"): Opt<String>,
        /// Language of the report; English if absent. Terminal and JSON are English. `--lang` overrides it.
        @"Option::is_none" language ("de"): Opt<Language>,
        /// Units of the report, of its tables and of the terminal; SI if absent. JSON is in SI. `--report-units` overrides it.
        @"Option::is_none" units ("us"): Opt<System>,
    }
}

impl Project {
    /// Whether nothing is given.
    pub fn is_empty(&self) -> bool {
        *self == Project::default()
    }

    /// Number and revision of the document for running heads: `TK-104 rev. B`; empty without a number.
    pub fn mark(&self) -> String {
        match (&self.document, &self.revision) {
            (Some(document), Some(revision)) => format!("{document} rev. {revision}"),
            (Some(document), None) => document.clone(),
            (None, _) => String::new(),
        }
    }
}
