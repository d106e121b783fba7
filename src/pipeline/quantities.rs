//! Comparable values as the results folder has them.

use std::collections::BTreeMap;

use results::Value;
use tank::large_wave::LargeWave;
use tank::{Case, Quantity};

/// Values by quantity id, with their dimensions.
pub(super) fn quantities(values: &BTreeMap<Quantity, f64>) -> BTreeMap<String, Value> {
    values.iter().map(|(q, &value)| (q.id().to_owned(), Value { value, dimension: q.dimension() })).collect()
}

/// The same of a method whose wave is that of linear theory: with crest and trough, where it does not give its own.
pub(super) fn with_crest(case: &Case, values: &BTreeMap<Quantity, f64>) -> BTreeMap<String, Value> {
    let mut all = values.clone();
    if let Some(&wave) = values.get(&Quantity::SloshingHeight) {
        for (quantity, value) in LargeWave::of(case).quantities(wave) {
            all.entry(quantity).or_insert(value);
        }
    }
    quantities(&all)
}
