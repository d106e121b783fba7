//! `project`: the cover of the report.

use ::tank::Language;
use ::tank::units::System;

use crate::input::tank::read::{Opt, choice, object};
use crate::input::tank::resolver::Resolver;
use files::code::Code;

object! {
    /// Whom the verification is for and who answers for it: cover and running heads of the report. Nothing here changes a number.
    Project {
        /// Project.
        name ("Terminal North, fire water"): Opt<String>,
        /// Client.
        client ("Harbour Storage Ltd"): Opt<String>,
        /// Number of the document, on every page.
        document ("TK-104-SV-001"): Opt<String>,
        /// Revision, on every page.
        revision ("B"): Opt<String>,
        /// Date of the document, year-month-day.
        date ("2026-03-14"): Opt<String>,
        /// Author.
        author ("J. Doe"): Opt<String>,
        /// Checker.
        checker ("A. Smith"): Opt<String>,
        /// Who approves it.
        approver ("M. Jones"): Opt<String>,
        /// Language of the report; English if absent. Terminal and JSON are English. `--lang` overrides it.
        language ("de"): Opt<Language>,
        /// Units of the report, of its tables and of the terminal; SI if absent. JSON is in SI. `--report-units` overrides it.
        units ("us"): Opt<System>,
    }
}

choice!(Language, System);

/// Whether a text is a date, year-month-day.
pub(super) fn is_date(text: &str) -> bool {
    text.len() == 10 && humantime::parse_rfc3339(&format!("{text}T00:00:00Z")).is_ok()
}

/// The block, if given.
pub(in crate::input) fn project(r: &mut Resolver<'_>, option: &Opt<Project>) -> Option<::tank::Project> {
    let given = option.value()?;
    let mut text = |option: &Opt<String>| r.text(option.given.as_ref()?);
    let found = ::tank::Project {
        name: text(&given.name),
        client: text(&given.client),
        document: text(&given.document),
        revision: text(&given.revision),
        date: text(&given.date),
        author: text(&given.author),
        checker: text(&given.checker),
        approver: text(&given.approver),
        language: r.word(&given.language),
        units: r.word(&given.units),
    };
    if let (Some(field), Some(date)) = (&given.date.given, &found.date)
        && !is_date(date)
    {
        let message = format!("the date `{date}`");
        r.refuse(Code::BadForm, field, &message, "a date as 2026-03-14");
    }
    Some(found)
}
