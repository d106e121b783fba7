//! Values outside the model of their engine: it clamps a wall that pulls, or has cantilevers for the plates of a box.

use tank::Quantity;
use tank::assessment::Excitation;
use tank::outside::Outside;

use crate::{Comparison, Method};

/// Whether a quantity depends on what the engine leaves out. An unanchored wall that pulls changes forces and stresses: periods and masses
/// are those of the tank at rest. Plates have another impulsive period and mass as well. The wave hardly depends on the wall.
pub fn depends(quantity: Quantity, why: Outside) -> bool {
    let held = [
        Quantity::BaseShear,
        Quantity::BaseMoment,
        Quantity::OverturningMoment,
        Quantity::HoopStress,
        Quantity::RimHoopStress,
        Quantity::AxialMembraneStress,
        Quantity::BendingStress,
        Quantity::Uplift,
        Quantity::BaseRotation,
        Quantity::PlasticRotation,
        Quantity::ToeAxialStress,
        Quantity::Slip,
    ];
    let impulsive = [Quantity::ImpulsivePeriod, Quantity::ImpulsiveMass];
    let of_plates = impulsive.iter().filter(|_| why == Outside::Plates);
    held.iter().chain(of_plates).any(|q| *q == quantity)
}

impl Comparison {
    /// Marks the values of a method that are outside its model.
    ///
    /// * `method`: id of the method, and its excitation
    pub fn mark_outside(&mut self, methods: &[Method], (method, excitation): (&str, Excitation), why: Outside) {
        let Some(column) = methods.iter().position(|m| m.id == method && m.excitation == excitation) else { return };
        for row in self.rows.iter_mut().filter(|row| Quantity::from_id(&row.quantity).is_some_and(|q| depends(q, why)))
        {
            if let Some(Some(cell)) = row.cells.get_mut(column) {
                cell.outside = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

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
            rows: vec![row("base_shear"), row("sloshing_height"), row("impulsive_period")],
            ..Comparison::default()
        };
        comparison.mark_outside(&methods, ("fe", Excitation::Record), Outside::Uplift);
        let marked = |comparison: &Comparison, i: usize| {
            comparison.rows[i].cells.iter().map(|c| c.unwrap().outside).collect::<Vec<_>>()
        };
        assert_eq!(marked(&comparison, 0), [false, true]);
        assert_eq!(marked(&comparison, 1), [false, false]);
        assert_eq!(marked(&comparison, 2), [false, false]);
        let old = json!({ "value": 1.0, "ratio": 1.0 });
        assert_eq!(serde_json::to_value(comparison.rows[1].cells[0]).unwrap(), old);
        comparison.mark_outside(&methods, ("fe", Excitation::Record), Outside::Plates);
        assert_eq!(marked(&comparison, 1), [false, false]);
        assert_eq!(marked(&comparison, 2), [false, true]);
    }
}
