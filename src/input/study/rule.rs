//! `rule`: what the set of records has to keep.

use std::path::Path;

use tank::hazard::SpectrumTable;
use tank::units::{self, Dimension};

use super::keys;
use crate::input::tank::read::Field;
use crate::input::tank::resolver::Resolver;
use crate::input::target;
use files::code::Code;
use files::error::Error;

/// Periods at which a rule is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RulePeriods {
    /// Impulsive and sloshing period of each tank.
    Both,
    /// Impulsive period.
    Impulsive,
    /// Sloshing period.
    Sloshing,
    /// The same for all tanks [s].
    Given(f64),
}

/// EN 1998-1:2004 3.2.3.1.2(4) for the records of the study.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Target; none for the elastic spectrum of each tank's site.
    pub table: Option<SpectrumTable>,
    /// Name of the target.
    pub target: String,
    /// Periods.
    pub periods: RulePeriods,
}

/// The rule of the file; a table that cannot be read is added to `broken`.
pub(super) fn rule(
    r: &mut Resolver<'_>,
    field: &Field<keys::Rule>,
    folder: &Path,
    broken: &mut Vec<Error>,
) -> Option<Rule> {
    let given = field.value.as_ref()?;
    r.or_default(&given.code);
    let mut text = |option: &crate::input::tank::read::Opt<String>, usual: &str| match &option.given {
        Some(field) => r.text(field),
        None => Some(usual.to_owned()),
    };
    let target = text(&given.target, "site")?;
    let periods = text(&given.periods, "both")?;
    let table = match target.as_str() {
        "site" => None,
        name => match target::read(&folder.join(name), None) {
            Ok(table) => Some(table),
            Err(error) => {
                broken.push(error);
                return None;
            }
        },
    };
    let periods = match periods.trim() {
        "both" => RulePeriods::Both,
        "impulsive" => RulePeriods::Impulsive,
        "sloshing" => RulePeriods::Sloshing,
        given => match units::parse(given, Dimension::Time) {
            Ok(period) if period > 0.0 && period <= 100.0 => RulePeriods::Given(period),
            _ => {
                let field = field.value.as_ref().and_then(|rule| rule.periods.given.as_ref())?;
                let allowed = "both, impulsive, sloshing, or a time such as 0.3 s";
                r.refuse(Code::UnknownChoice, field, "unknown periods", allowed);
                return None;
            }
        },
    };
    Some(Rule { table, target, periods })
}
