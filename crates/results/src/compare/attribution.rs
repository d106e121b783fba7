//! Finds where the methods differ, and attributes the differences to what was exchanged.
//!
//! A difference is reported where a procedure under the *record's* spectrum is more than 10 % off the finite-element history:
//! there both saw the same ground motion, so the difference is the procedure's. Its reasons are the largest factors of its
//! [`Attribution`]; where a quantity has none, no reason is given. The two engines are held to 1 %.

use tank::Quantity;
use tank::assessment::Excitation;

use super::difference::ratios;
use super::factors::Attribution;
use super::{Context, Difference, Estimated, MEASURED, Ratio, Reason, nonlinear};
use crate::{ComparisonRow, EngineId, Method};

/// Smaller differences are within the effect of record processing and damping assumptions (theory manual).
pub const THRESHOLD: f64 = 0.10;

/// The two engines solve one problem: more than this between them is reported.
const ENGINES: f64 = 0.01;

/// Factors that a difference names.
const NAMED: usize = 2;
/// Factors within this of 1 are not named.
const NAMED_FROM: f64 = 0.01;

/// Forces and stresses, which a test measures alike.
const FORCES: [Quantity; 7] = [
    Quantity::BaseShear,
    Quantity::BaseMoment,
    Quantity::OverturningMoment,
    Quantity::HoopStress,
    Quantity::RimHoopStress,
    Quantity::AxialMembraneStress,
    Quantity::BendingStress,
];

/// Engines first, then quantity by quantity.
pub(super) fn attribute(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Vec<Difference> {
    let mut found = Vec::new();
    found.extend(engines(methods, rows, context));
    found.extend(nonlinear::attribute(methods, rows, context));
    for quantity in Quantity::ALL {
        for (column, method) in methods.iter().enumerate() {
            if method.excitation != Excitation::Record || method.is_run() {
                continue;
            }
            let of_test = method.id == MEASURED;
            let group: &[Quantity] = match FORCES.contains(&quantity) && of_test {
                true if quantity == FORCES[0] => &FORCES,
                true => continue,
                false => std::slice::from_ref(&quantity),
            };
            let ratios = ratios(rows, column, THRESHOLD, group);
            if !ratios.is_empty() {
                let reasons = match of_test {
                    true if group.len() > 1 => vec![Reason::TestGauges],
                    true => vec![Reason::TestScatter],
                    false => factors(&context.attribution, method, quantity).into_iter().collect(),
                };
                found.push(Difference { method: method.id.clone(), ratios, reasons });
            }
        }
    }
    found
}

/// The largest factors of a quantity of a method.
fn factors(attribution: &[Attribution], method: &Method, quantity: Quantity) -> Option<Reason> {
    let own = attribution
        .iter()
        .find(|a| a.method == method.id && a.excitation == method.excitation && a.quantity == quantity)?;
    let steps = own.largest(NAMED, NAMED_FROM);
    (!steps.is_empty()).then_some(Reason::Factors { steps })
}

/// Where the three-dimensional engine differs from the harmonic one: their meshes.
fn engines(methods: &[Method], rows: &[ComparisonRow], context: &Context) -> Option<Difference> {
    let column = methods.iter().position(|m| m.id == EngineId::Solid.beside())?;
    let ratios = ratios(rows, column, ENGINES, &Quantity::ALL);
    ratios.first()?;
    let error =
        |r: &Ratio| Some(Estimated { quantity: r.quantity, error: *context.solid_mesh_error.get(r.quantity.id())? });
    Some(Difference {
        method: EngineId::Solid.beside().into(),
        reasons: vec![Reason::Discretisation { estimated: ratios.iter().filter_map(error).collect() }],
        ratios,
    })
}
