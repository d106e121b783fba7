//! `procedures`: which procedures run, and their options.

use codes::ALL;
use files::code::Code;
use results::EngineId;
use tank::case::{Combination, ConvectiveCoefficient, FlexibleImpulsive, ProcedureOptions};

use crate::input::diagnostic::Faults;
use crate::input::tank::key::{Absent, Limits, default};
use crate::input::tank::read::{Field, FromNode, Opt, choice, object, one_of_words, quoted};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::Node;
use crate::input::tank::values::{Number, Whole};

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
        concrete: Opt<ConcreteOptions>,
    }

    /// Choices for walls of concrete in the Eurocode procedures.
    ConcreteOptions {
        /// Partial factor of concrete.
        gamma_c (1.2): Opt<Number> [Limits::from(1.0).to(2.0)]
            = default(Number(DEFAULT.concrete.gamma_c)).because("EN 1992-1-1 table 2.1N, EN 1998-1 5.2.4"),
        /// Partial factor of reinforcement.
        gamma_s (1.0): Opt<Number> [Limits::from(1.0).to(2.0)]
            = default(Number(DEFAULT.concrete.gamma_s)).because("EN 1992-1-1 table 2.1N, EN 1998-1 5.2.4"),
        /// Tightness class, EN 1992-3 table 7.105. Classes 2 and 3 are not checked.
        tightness_class (1): Opt<Whole> [Limits::one_of(&[0.0, 1.0, 2.0, 3.0])]
            = default(Whole(DEFAULT.concrete.tightness_class as u32)).because("EN 1992-3 7.3.1: leakage limited to a small amount"),
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

/// Id of a code procedure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProcedureId(&'static str);

/// Ids of all procedures.
fn ids() -> Vec<(&'static str, ProcedureId)> {
    ALL.iter().map(|p| (p.id(), ProcedureId(p.id()))).collect()
}

impl FromNode for ProcedureId {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        one_of_words(node, &ids(), faults)
    }
    fn allowed() -> String {
        quoted(&ids().iter().map(|(id, _)| *id).collect::<Vec<_>>())
    }
    fn example() -> String {
        format!("\"{}\"", ALL[0].id())
    }
    fn shape(book: &mut Book) -> Shape {
        let words = ALL.iter().map(|p| (p.id(), format!("{}.", p.label().title))).collect();
        book.choice("ProcedureId", &["A code procedure."], words)
    }
    fn written(&self) -> Option<String> {
        Some(self.0.into())
    }
}

/// Id of a method that can decide: a code procedure or a column of an engine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DecidingId(&'static str);

/// Ids of all methods that can decide, with their meaning.
fn deciding_ids() -> Vec<(&'static str, String)> {
    let procedures = ALL.iter().map(|p| (p.id(), format!("{}.", p.label().title)));
    let engines = EngineId::ALL.map(|e| (e.beside(), format!("The {} engine, as a second run.", e.name())));
    let first = (results::FE, "The first engine that runs.".to_owned());
    procedures.chain([first]).chain(engines).collect()
}

impl FromNode for DecidingId {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let words: Vec<_> = deciding_ids().iter().map(|(id, _)| (*id, DecidingId(id))).collect();
        one_of_words(node, &words, faults)
    }
    fn allowed() -> String {
        quoted(&deciding_ids().iter().map(|(id, _)| *id).collect::<Vec<_>>())
    }
    fn example() -> String {
        ProcedureId::example()
    }
    fn shape(book: &mut Book) -> Shape {
        book.choice("DecidingId", &["A method that can decide."], deciding_ids())
    }
    fn written(&self) -> Option<String> {
        Some(self.0.into())
    }
}

/// Ids of the methods that decide (empty: the editions in force that the site names).
pub(super) fn deciding(r: &mut Resolver<'_>, option: &Opt<Procedures>) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let Some(list) = option.value().and_then(|p| p.decide.given.as_ref()) else {
        r.echo_default(
            "procedures.decide",
            "current",
            "the editions in force that `site` names",
        );
        return all;
    };
    for id in list.value.iter().flatten().filter(|id| id.value.is_some()) {
        r.echo_given(id);
        if all.contains(&id.text) {
            r.refuse(Code::Repeated, id, "duplicate method", "each method once");
        }
        all.push(id.text.clone());
    }
    if list.value.as_ref().is_some_and(Vec::is_empty) {
        let message = "the list of deciding methods is empty";
        let allowed = "at least one id; remove `decide` for the editions in force";
        r.refuse(Code::ItemCount, list, message, allowed);
    }
    all
}

/// Choices within the procedures, and the ids of those to run (empty: all).
pub(super) fn procedures(r: &mut Resolver<'_>, option: &Opt<Procedures>) -> (ProcedureOptions, Vec<String>) {
    let mut run: Vec<String> = Vec::new();
    match option.value().and_then(|p| p.run.given.as_ref()) {
        Some(list) => {
            for id in list.value.iter().flatten().filter(|id| id.value.is_some()) {
                r.echo_given(id);
                if run.contains(&id.text) {
                    r.refuse(Code::Repeated, id, "duplicate procedure", "each procedure once");
                }
                run.push(id.text.clone());
            }
            if list.value.as_ref().is_some_and(Vec::is_empty) {
                let message = "the list of procedures is empty";
                let allowed = "at least one id; remove `run` to run all";
                r.refuse(Code::ItemCount, list, message, allowed);
            }
        }
        None => r.echo_default("procedures.run", "all", "every procedure that applies"),
    }
    let given = option.or_absent();
    let mut options = DEFAULT;
    // Defaults replace faulty values.
    if let Some(housner) = given.as_ref().and_then(|p| p.housner.or_absent()) {
        options.housner_convective = r.choice(&housner.convective);
        options.housner_combination = r.choice(&housner.combination);
    }
    if let Some(ec8) = given.as_ref().and_then(|p| p.ec8.or_absent()) {
        options.ec8_combination = r.choice(&ec8.combination);
        options.ec8_impulsive = r.choice(&ec8.impulsive);
    }
    if let Some(concrete) = given.as_ref().and_then(|p| p.concrete.value()) {
        options.concrete.gamma_c = r.or_default(&concrete.gamma_c);
        options.concrete.gamma_s = r.or_default(&concrete.gamma_s);
        options.concrete.tightness_class = r.count_or_default(&concrete.tightness_class) as u8;
    }
    (options, run)
}
