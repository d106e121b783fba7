//! What a row keeps of methods and checks.

use std::collections::BTreeMap;

use tank::Quantity;
use tank::assessment::{Check, CheckStatus, Excitation};

use crate::study::rows::{Ending, kept};
use results::{FE, Method};

/// Adds a quantity that the ground motion changes; properties of the tank stand with the tank.
pub(super) fn put(method: &str, quantity: Quantity, value: f64, values: &mut BTreeMap<String, f64>) {
    if quantity.is_response() && value.is_finite() {
        values.insert(format!("{method}.{}", quantity.id()), kept(value));
    }
}

/// Adds the quantities of the methods under an excitation.
pub(super) fn values_of(methods: &[Method], excitation: Excitation, values: &mut BTreeMap<String, f64>) {
    for method in methods.iter().filter(|m| m.excitation == excitation) {
        for (id, value) in &method.quantities {
            if let Some(quantity) = Quantity::from_id(id) {
                put(&method.id, quantity, value.value, values);
            }
        }
    }
}

/// Adds the largest utilisation of each limit state.
pub(super) fn checks_of(checks: &[Check], endings: &mut BTreeMap<String, Ending>) {
    for check in checks {
        let key = format!("{FE}.{}", check.limit_state);
        let word = |word: &str| Ending::Word(word.into());
        let ending = match (check.status, check.utilisation) {
            (CheckStatus::NotApplicable, _) => continue,
            // A run outside its model gives no utilisation to go by.
            (CheckStatus::NotChecked, _) => word("not_checked"),
            (CheckStatus::Accepted, _) => word("accepted"),
            (_, Some(utilisation)) => Ending::Utilisation(kept(utilisation)),
            (CheckStatus::Fails, None) => word("fails"),
            (CheckStatus::Holds, None) => continue,
        };
        let worse = match (endings.get(&key), &ending) {
            (None, _) => true,
            (Some(Ending::Utilisation(old)), Ending::Utilisation(new)) => new > old,
            // A failure without a number is worse than any number, and an open comparison does not hide a number.
            (Some(Ending::Utilisation(_)), Ending::Word(word)) => word == "fails",
            (Some(Ending::Word(old)), Ending::Utilisation(_)) => old != "fails",
            (Some(Ending::Word(_)), Ending::Word(new)) => new == "fails",
        };
        if worse {
            endings.insert(key, ending);
        }
    }
}

/// Why the limit states were not checked that end so.
pub(super) fn gaps_of(checks: &[Check], endings: &BTreeMap<String, Ending>) -> BTreeMap<String, String> {
    let open = |check: &&Check| {
        let ending = endings.get(&format!("{FE}.{}", check.limit_state));
        let open = matches!(ending, Some(Ending::Word(word)) if word == "not_checked");
        open && check.status == CheckStatus::NotChecked
    };
    let mut gaps = BTreeMap::new();
    for check in checks.iter().filter(open) {
        gaps.entry(check.limit_state.clone()).or_insert_with(|| check.reason.clone());
    }
    gaps
}

/// Adds the largest utilisation of every procedure, of a row without an engine.
pub(super) fn utilisations(methods: &[Method], endings: &mut BTreeMap<String, Ending>) {
    for method in methods.iter().filter(|m| m.excitation == Excitation::Site) {
        let largest = method.checks.iter().filter_map(|c| c.utilisation).reduce(f64::max);
        if let Some(largest) = largest {
            endings.insert(format!("{}.utilisation", method.id), Ending::Utilisation(kept(largest)));
        }
    }
}
