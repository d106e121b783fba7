//! `project`: the cover of the report.

use ::tank::units::System;
use ::tank::{Language, Project};

use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::Opt;
use crate::input::tank::resolver::Resolver;
use files::code::Code;

choice!(Language, System);

/// Whether a text is a date, year-month-day.
pub(super) fn is_date(text: &str) -> bool {
    text.len() == 10 && humantime::parse_rfc3339(&format!("{text}T00:00:00Z")).is_ok()
}

/// The block, if given.
pub(in crate::input) fn project(r: &mut Resolver<'_>, option: &Opt<Given<Project>>) -> Option<Project> {
    let given = option.value()?;
    let found = given.resolve(r)?;
    if let (Some(field), Some(date)) = (&given.date.given, &found.date)
        && !is_date(date)
    {
        let message = format!("the date `{date}`");
        r.refuse(Code::BadForm, field, &message, "a date as 2026-03-14");
    }
    Some(found)
}
