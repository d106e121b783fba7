//! Lists of limit states: those of a run under the codes that count.

use std::cmp::Ordering;

use tank::assessment::{Check, CheckStatus, LimitState, Requirement};
use tank::case::Case;

use super::limit_states::{GROUND_MOTION, TABLE};
use crate::CODES;
use crate::code::{Answer, Code, Placed};
use crate::limit_state::LimitStateDef;
use crate::record_set::standard::Standard;

/// The codes that judge a run.
pub struct Judges {
    /// At least one.
    pub codes: Vec<&'static dyn Code>,
    /// Whether the run decides and none of their procedures does: it then has to answer all that they ask of the tank.
    pub alone: bool,
}

/// The codes that count: those that the site names, and of them those whose procedures decide, if any.
///
/// * `decide`: ids of the methods that decide
pub fn counted(case: &Case, decide: &[String]) -> Judges {
    let named = CODES.iter().copied().filter(|code| code.named(&case.site));
    let decides = |code: &&dyn Code| {
        let mut procedures = code.procedures().iter();
        procedures.any(|procedure| decide.iter().any(|id| id == procedure.id()))
    };
    let deciding: Vec<_> = named.clone().filter(decides).collect();
    let alone = deciding.is_empty() && !decide.is_empty();
    let counted = if deciding.is_empty() { named.collect() } else { deciding };
    let codes = if counted.is_empty() { CODES[..1].to_vec() } else { counted };
    Judges { codes, alone }
}

/// Share of the snow load in the mass that an engine moves: the largest of the codes that count.
///
/// * `decide`: ids of the methods that decide
pub fn snow_share(case: &Case, decide: &[String]) -> f64 {
    let codes = counted(case, decide).codes;
    codes.iter().map(|code| code.in_force().snow_share(case)).fold(0.0, f64::max)
}

/// Those of all lists, for their meanings.
pub(crate) fn tables() -> impl Iterator<Item = LimitStateDef> {
    let of_codes = CODES.iter().flat_map(|code| code.of_run());
    let placed = TABLE.iter().chain(of_codes);
    let answers = CODES.iter().flat_map(|code| code.answers());
    let renamed = answers.filter_map(|(_, answer)| match answer {
        Answer::Open(state) => Some(*state),
        Answer::Run(_) | Answer::Code => None,
    });
    placed.map(|(_, state)| *state).chain(renamed).chain([GROUND_MOTION])
}

/// All limit states of a case under the codes that count, whose clauses stand side by side. A run that decides alone has every limit state
/// that they ask for: those that it does not check are open.
pub fn limit_states(case: &Case, judges: &Judges) -> Vec<LimitState> {
    let codes = &judges.codes;
    let of_codes = codes.iter().flat_map(|code| code.of_run());
    let listed = TABLE.iter().chain(of_codes).filter(|(_, state)| (state.exists)(case));
    let mut listed: Vec<&Placed> = listed.collect();
    listed.sort_by_key(|(place, _)| *place);
    let mut states: Vec<LimitState> = Vec::new();
    for (_, state) in listed {
        match states.iter_mut().find(|known| known.id == state.id) {
            Some(known) => known.clause = format!("{}, {}", known.clause, state.clause),
            None => states.push(state.under(state.clause.into(), case)),
        }
    }
    if judges.alone {
        let own: Vec<&str> = states.iter().map(|state| state.id).collect();
        for code in codes {
            for asked in code.in_force().limit_states(case) {
                answer(&mut states, &own, *code, asked, case);
            }
        }
    }
    states
}

/// Adds a limit state of a code as far as the run has none for it.
///
/// * `own`: ids of those of the run
fn answer(states: &mut Vec<LimitState>, own: &[&str], code: &dyn Code, asked: LimitState, case: &Case) {
    let open = |asked: LimitState| match asked.requirement {
        Requirement::Required => LimitState { requirement: Requirement::NotImplemented, ..asked },
        _ => asked,
    };
    let answer = code.answers().iter().find(|(id, _)| *id == asked.id);
    let state = match answer {
        Some((_, Answer::Run(id))) if own.contains(id) => return,
        Some((_, Answer::Open(state))) => {
            open(LimitState { requirement: asked.requirement, ..state.under(state.clause.into(), case) })
        }
        Some((_, Answer::Code)) => asked,
        // A run spares what another action decides only where the code decides beside it.
        None if own.contains(&asked.id) => match states.iter_mut().find(|state| state.id == asked.id) {
            Some(state)
                if asked.requirement == Requirement::Required
                    && matches!(state.requirement, Requirement::NotApplicable(_)) =>
            {
                state.requirement = Requirement::NotImplemented;
                return;
            }
            _ => return,
        },
        Some((_, Answer::Run(_))) | None => open(asked),
    };
    match states.iter_mut().find(|known| known.id == state.id) {
        Some(known) => join(known, state),
        None => states.push(state),
    }
}

/// The same limit state of two codes: the stricter counts, under its clause; of equals both clauses.
fn join(known: &mut LimitState, other: LimitState) {
    let strictness = |state: &LimitState| match state.requirement {
        Requirement::NotApplicable(_) => 0,
        Requirement::Required => 1,
        Requirement::Missing(_) => 2,
        Requirement::NotImplemented => 3,
    };
    match strictness(&other).cmp(&strictness(known)) {
        Ordering::Less => {}
        Ordering::Greater => *known = other,
        // Good practice of one code that is a clause of the other.
        Ordering::Equal if known.clause.ends_with(&other.clause) => known.clause = other.clause,
        Ordering::Equal => known.clause = format!("{}, {}", known.clause, other.clause),
    }
}

/// The limit state of the records of a run that decides where the site names no code: what they have to stand for is not known.
pub fn without_code(case: &Case) -> Option<Check> {
    if CODES.iter().any(|code| code.named(&case.site)) {
        return None;
    }
    let (code, site) = (CODES.first()?, &case.site);
    let state = GROUND_MOTION.under(code.record_rules().clause().into(), case);
    let reason = match site.is_given() {
        true => "`site` names no code: nothing says whether the record is strong enough",
        false => "`site` is not given: nothing says whether the record is strong enough",
    };
    Some(Check::without_comparison(&state, CheckStatus::NotChecked, reason, Some("site")))
}

/// What the code of a site asks of the records under which an engine decides, and the code whose rule that is; none without a site.
pub fn ground_motion(case: &Case) -> Option<(LimitState, Standard)> {
    let named = CODES.iter().find(|code| code.named(&case.site))?;
    let rules = named.record_rules();
    Some((GROUND_MOTION.under(rules.clause().into(), case), rules))
}
