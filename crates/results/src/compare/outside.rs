//! Values outside the model of their engine: a wall that it clamps pulls, and the tank has no anchors.

use tank::Quantity;

use crate::{Comparison, Method};

/// Whether a quantity depends on how the wall is held. Periods and masses are those of the tank at rest, and the wave hardly depends on
/// the base.
fn depends(quantity: &str) -> bool {
    let held = [
        Quantity::BaseShear,
        Quantity::BaseMoment,
        Quantity::OverturningMoment,
        Quantity::HoopStress,
        Quantity::AxialMembraneStress,
        Quantity::BendingStress,
    ];
    held.iter().any(|q| q.id() == quantity)
}

impl Comparison {
    /// Marks the values of a method that depend on the base of the wall as outside its model.
    ///
    /// * `method`: id of the method
    pub fn mark_outside(&mut self, methods: &[Method], method: &str) {
        let Some(column) = methods.iter().position(|m| m.id == method) else {
            return;
        };
        for row in self.rows.iter_mut().filter(|row| depends(&row.quantity)) {
            if let Some(Some(cell)) = row.cells.get_mut(column) {
                cell.outside = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use tank::assessment::Excitation;

    use super::*;

    #[test]
    fn forces_and_stresses_are_marked_and_the_wave_is_not() {
        let methods = ["ec8-2006", "fe"].map(|id| Method::new(id, id, Excitation::Record));
        let row = |quantity: &str| {
            let cell = json!({ "value": 1.0, "ratio": 1.0 });
            let row = json!({ "quantity": quantity, "title": "", "dimension": "force", "cells": [cell, cell] });
            serde_json::from_value(row).unwrap()
        };
        let mut comparison = Comparison {
            rows: vec![row("base_shear"), row("sloshing_height")],
            ..Comparison::default()
        };
        comparison.mark_outside(&methods, "fe");
        let marked = |i: usize| {
            comparison.rows[i]
                .cells
                .iter()
                .map(|c| c.unwrap().outside)
                .collect::<Vec<_>>()
        };
        assert_eq!(marked(0), [false, true]);
        assert_eq!(marked(1), [false, false]);
        let old = json!({ "value": 1.0, "ratio": 1.0 });
        assert_eq!(serde_json::to_value(comparison.rows[1].cells[0]).unwrap(), old);
    }
}
