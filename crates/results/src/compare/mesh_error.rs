//! Values that are unusable because their estimated mesh error is too large.

use std::collections::BTreeMap;

use tank::Quantity;
use tank::assessment::Excitation;

use crate::{Comparison, MESH_ERROR_LIMIT, Method, Results};

impl Comparison {
    /// Marks the values of a method whose estimated mesh error is above [`MESH_ERROR_LIMIT`]; [`unusable`] lists them.
    ///
    /// * `method`: id of the method, and its excitation
    /// * `errors`: its relative errors by quantity id
    pub fn mark_unusable(
        &mut self,
        methods: &[Method],
        (method, excitation): (&str, Excitation),
        errors: &BTreeMap<String, f64>,
    ) {
        let Some(column) = methods.iter().position(|m| m.id == method && m.excitation == excitation) else { return };
        for row in &mut self.rows {
            let error = errors.get(&row.quantity).copied().unwrap_or(0.0);
            if let (true, Some(Some(cell))) = (error > MESH_ERROR_LIMIT, row.cells.get_mut(column)) {
                cell.unusable = true;
            }
        }
    }
}

/// A value whose estimated mesh error is above [`MESH_ERROR_LIMIT`].
#[derive(Clone, Debug, PartialEq)]
pub struct Unusable {
    /// Id of the method.
    pub method: String,
    /// The quantity.
    pub quantity: Quantity,
    /// Estimated relative error.
    pub error: f64,
}

/// All unusable values, by method and quantity.
pub fn unusable(results: &Results) -> Vec<Unusable> {
    let mut found = Vec::new();
    for (number, run) in results.runs.iter().enumerate() {
        let id = run.engine.column(number);
        let Some(column) = results.methods.iter().position(|m| m.id == id) else { continue };
        for row in &results.comparison.rows {
            let marked = row.cells.get(column).copied().flatten().is_some_and(|c| c.unusable);
            if let (true, Some(quantity)) = (marked, Quantity::from_id(&row.quantity)) {
                found.push(Unusable {
                    method: id.into(),
                    quantity,
                    error: run.mesh_error.get(&row.quantity).copied().unwrap_or(f64::NAN),
                });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::Cell;

    #[test]
    fn a_mesh_error_above_a_fifth_makes_a_number_unusable() {
        let methods = ["housner", "fe"].map(|id| Method::new(id, id, Excitation::Record));
        // Results of an earlier version lack the flag and read as usable.
        let old = json!({ "value": 30.0, "ratio": 0.75 });
        let cell: Cell = serde_json::from_value(old.clone()).unwrap();
        let row = json!({ "quantity": "base_shear", "title": "", "dimension": "force", "cells": [old, old] });
        let mut comparison = Comparison { rows: vec![serde_json::from_value(row).unwrap()], ..Comparison::default() };
        for (error, unusable) in [(0.0, false), (0.2, false), (0.2001, true)] {
            let errors = BTreeMap::from([("base_shear".to_owned(), error)]);
            comparison.mark_unusable(&methods, ("fe", Excitation::Record), &errors);
            let marked = Cell { unusable, ..cell };
            assert_eq!(comparison.rows[0].cells, [Some(cell), Some(marked)], "{error}");
        }
        assert_eq!(serde_json::to_value(cell).unwrap(), old);
    }
}
