//! Lists of limit states: those of a run under the codes that count.

use tank::assessment::LimitState;
use tank::case::Case;

use super::limit_states::{GROUND_MOTION, TABLE};
use crate::CODES;
use crate::code::{Code, Placed};
use crate::limit_state::LimitStateDef;
use crate::record_set::standard::Standard;

/// The codes that count, at least one: those that the site names, and of them those whose procedures decide, if any.
///
/// * `decide`: ids of the methods that decide
pub fn counted(case: &Case, decide: &[String]) -> Vec<&'static dyn Code> {
    let named = CODES.iter().copied().filter(|code| code.named(&case.site));
    let decides = |code: &&dyn Code| {
        let mut procedures = code.procedures().iter();
        procedures.any(|procedure| decide.iter().any(|id| id == procedure.id()))
    };
    let deciding: Vec<_> = named.clone().filter(decides).collect();
    let counted = if deciding.is_empty() { named.collect() } else { deciding };
    match counted.is_empty() {
        true => CODES[..1].to_vec(),
        false => counted,
    }
}

/// Those of all lists, for their meanings.
pub(crate) fn tables() -> impl Iterator<Item = LimitStateDef> {
    let of_codes = CODES.iter().flat_map(|code| code.of_run());
    let placed = TABLE.iter().chain(of_codes);
    placed.map(|(_, state)| *state).chain([GROUND_MOTION])
}

/// All limit states of a case under the codes that count, whose clauses stand side by side.
pub fn limit_states(case: &Case, codes: &[&dyn Code]) -> Vec<LimitState> {
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
    states
}

/// What the code of a site asks of the records under which an engine decides, and the code whose rule that is; none without a site.
pub fn ground_motion(case: &Case) -> Option<(LimitState, Standard)> {
    let named = CODES.iter().find(|code| code.named(&case.site))?;
    let rules = named.record_rules();
    Some((GROUND_MOTION.under(rules.clause().into(), case), rules))
}
