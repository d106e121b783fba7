//! All limit states of all tables, for `tankcheck explain` and `docs/codes.md`.

use crate::limit_state::{LimitStateDef, Part};
use crate::time_history;

/// Every limit state, each once, with the checks in which it ends: in the order of a report.
pub fn all() -> Vec<(LimitStateDef, Vec<Part>)> {
    let mut all: Vec<(LimitStateDef, Vec<Part>)> = Vec::new();
    let of_procedures = crate::ALL.iter().flat_map(|procedure| procedure.table());
    for state in of_procedures.copied().chain(time_history::tables()) {
        match all.iter_mut().find(|(known, _)| known.id == state.id) {
            Some((_, parts)) => {
                let new = |part: &&Part| parts.iter().all(|known| known.id != part.id);
                let new: Vec<Part> = state.parts.iter().filter(new).copied().collect();
                parts.extend(new);
            }
            None => all.push((state, state.parts.to_vec())),
        }
    }
    all.sort_by_key(|(state, _)| state.page);
    all
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Ids of limit states and checks, and places on the page, are unique; every limit state is in words.
    #[test]
    fn tables_agree() {
        let all = all();
        let parts = all.iter().flat_map(|(_, parts)| parts);
        let ids: Vec<&str> = (all.iter().map(|(state, _)| state.id)).chain(parts.clone().map(|part| part.id)).collect();
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len(), "{ids:?}");
        let pages: BTreeSet<u16> = all.iter().map(|(state, _)| state.page).collect();
        assert_eq!(pages.len(), all.len());
        for (state, _) in &all {
            let words = [state.id, state.name, state.demand, state.capacity];
            assert!(words.iter().all(|word| !word.is_empty()), "{state:?}");
        }
    }
}
