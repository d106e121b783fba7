//! Time integration, damping, modal, spectral and frequency-domain methods; with a record, C8.

use crate::{Reference, Row};

mod bar;
pub(crate) mod condensed_liquid;
pub(crate) mod dashpots;
pub(crate) mod energy_balance;
pub(crate) mod four_methods;
pub(crate) mod missing_mass;
pub(crate) mod nonlinear;
pub(crate) mod rayleigh_damping;
pub(crate) mod response_spectrum_method;
pub(crate) mod separation;
mod strip;
pub(crate) mod time_integration;

const SHEET: &str = "amplification matrix worked out apart (after Chung & Hulbert 1993, Hughes 1987)";

/// A row whose tolerance is given in the unit of its value.
fn row(id: &str, what: String, reference: f64, computed: f64, absolute: f64) -> Row {
    let tolerance = if reference == 0.0 { absolute } else { absolute / reference.abs() };
    let reference = (reference, SHEET, Reference::SecondFormulation);
    Row::new(id, what, reference, computed, (tolerance, ""))
}
