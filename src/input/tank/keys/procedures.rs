//! `procedures`: which procedures run, and their options.

use files::code::Code;
use tank::case::{Combination, ConcreteOptions, ConvectiveCoefficient, FlexibleImpulsive, ProcedureOptions};

use super::ids::{DecidingId, ProcedureId};
use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;
use tank::keys::{Absent, default};

/// Defaults.
const DEFAULT: ProcedureOptions = ProcedureOptions::DEFAULT;

object! {
    /// Choices within the code procedures.
    Procedures {
        /// Procedures to run.
        run: Opt<Vec<Field<ProcedureId>>> = Absent::Follows("all that apply"),
        /// Methods that decide whether the tank holds: procedures, or engines under the record.
        decide: Opt<Vec<Field<DecidingId>>> = Absent::Follows("the editions in force that `site` names"),
        /// Housner's procedure.
        housner: Opt<HousnerOptions>,
        /// Eurocode 8.
        ec8: Opt<Ec8Options>,
        /// Walls of concrete, EN 1992.
        concrete: Opt<Given<ConcreteOptions>>,
    }

    /// Choices within Housner's procedure.
    HousnerOptions {
        /// Coefficients of the convective part.
        convective: Opt<ConvectiveCoefficient>
            = default(DEFAULT.housner_convective).because("the coefficients of 1957 are up to 30 % low"),
        /// How impulsive and convective maxima are added.
        combination: Opt<Combination> = default(DEFAULT.housner_combination).because("Housner 1963: the maxima are added"),
    }

    /// Choices within the Eurocode procedures.
    Ec8Options {
        /// How impulsive and convective maxima are added.
        combination: Opt<Combination>
            = default(DEFAULT.ec8_combination).because("EN 1998-4:2006 A.3.2.1: absolute values are added"),
        /// How the flexible impulsive part is found.
        impulsive: Opt<FlexibleImpulsive> = default(DEFAULT.ec8_impulsive).because("EN 1998-4:2006 A.3.2.2"),
    }
}

choice!(ConvectiveCoefficient, Combination, FlexibleImpulsive);

/// Ids of the methods that decide (empty: the editions in force that the site names).
pub(super) fn deciding(r: &mut Resolver<'_>, option: &Opt<Procedures>) -> Vec<String> {
    let Some(list) = option.value().and_then(|p| p.decide.given.as_ref()) else {
        r.echo_default("procedures.decide", "current", "the editions in force that `site` names");
        return Vec::new();
    };
    let allowed = "at least one id; remove `decide` for the editions in force";
    ids(r, list, "method", ("deciding methods", allowed))
}

/// The ids of a list, each once.
///
/// * `one`: an item in words
/// * `(all, allowed)`: the items, and what is allowed in place of an empty list
fn ids<T>(r: &mut Resolver<'_>, list: &Field<Vec<Field<T>>>, one: &str, (all, allowed): (&str, &str)) -> Vec<String> {
    let mut ids: Vec<String> = Vec::new();
    for id in list.value.iter().flatten().filter(|id| id.value.is_some()) {
        r.echo_given(id);
        if ids.contains(&id.text) {
            let message = format!("duplicate {one}");
            r.refuse(Code::Repeated, id, &message, &format!("each {one} once"));
        }
        ids.push(id.text.clone());
    }
    if list.value.as_ref().is_some_and(Vec::is_empty) {
        let message = format!("the list of {all} is empty");
        r.refuse(Code::ItemCount, list, &message, allowed);
    }
    ids
}

/// Choices within the procedures, and the ids of those to run (empty: all).
pub(super) fn procedures(r: &mut Resolver<'_>, option: &Opt<Procedures>) -> (ProcedureOptions, Vec<String>) {
    let run = match option.value().and_then(|p| p.run.given.as_ref()) {
        Some(list) => {
            let allowed = "at least one id; remove `run` to run all";
            ids(r, list, "procedure", ("procedures", allowed))
        }
        None => {
            r.echo_default("procedures.run", "all", "every procedure that applies");
            Vec::new()
        }
    };
    let given = option.or_absent();
    let mut options = DEFAULT;
    // Defaults replace faulty values.
    if let Some(housner) = given.as_ref().and_then(|p| p.housner.or_absent()) {
        options.housner_convective = r.or_default(&housner.convective);
        options.housner_combination = r.or_default(&housner.combination);
    }
    if let Some(ec8) = given.as_ref().and_then(|p| p.ec8.or_absent()) {
        options.ec8_combination = r.or_default(&ec8.combination);
        options.ec8_impulsive = r.or_default(&ec8.impulsive);
    }
    if let Some(concrete) = given.as_ref().and_then(|p| p.concrete.value()) {
        options.concrete = concrete.resolve(r).unwrap_or_default();
    }
    (options, run)
}
