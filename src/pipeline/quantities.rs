//! Comparable values as the results folder has them.

use std::collections::BTreeMap;

use results::Value;
use tank::Quantity;

/// Values by quantity id, with their dimensions.
pub(super) fn quantities(values: &BTreeMap<Quantity, f64>) -> BTreeMap<String, Value> {
    values.iter().map(|(q, &value)| (q.id().to_owned(), Value { value, dimension: q.dimension() })).collect()
}
