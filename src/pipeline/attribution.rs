//! The way from the engine's values to those of the procedures: ingredients of both, and the record's spectrum.

use std::cell::RefCell;
use std::collections::BTreeMap;

use oscillator::spectrum;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Recipe, Rung};

use crate::job::Job;
use engines::Simulation;
use results::compare::{Attribution, Engine, Held, Made};
use results::impulsive;
use results::modal::ModalPart;
use results::{Method, Run};

/// Attributions of all quantities that the procedures give ingredients for, of the first engine: none without one, or if it is
/// not linear. `made` are the ingredients of `methods`.
pub(super) fn attribute(
    job: &Job,
    methods: &[Method],
    made: &[Vec<Ingredients>],
    first: Option<&Simulation>,
) -> Vec<Attribution> {
    let (Some(motion), Some(simulation)) = (&job.case.ground_motion, first) else { return Vec::new() };
    let modal = &simulation.result.modal;
    // An interrupted history is not what the modes are the maxima of.
    if modal.is_empty() || simulation.result.incomplete {
        return Vec::new();
    }
    let known: RefCell<BTreeMap<(u64, u64), f64>> = RefCell::default();
    let of_record = |period: f64, damping: f64| {
        let key = (period.to_bits(), damping.to_bits());
        let found = known.borrow().get(&key).copied();
        found.unwrap_or_else(|| {
            let value = spectrum::ordinates(&motion.horizontal, period, damping).psa;
            known.borrow_mut().insert(key, value);
            value
        })
    };
    let engine = Engine {
        modal,
        liquid_mass: job.case.liquid_mass(),
        spectrum: &of_record,
        held: held(&simulation.result),
        hoop_height: simulation.result.hoop_height,
    };
    let mut found = Vec::new();
    for quantity in Quantity::ALL {
        let Some(&value) = simulation.values.get(&quantity) else { continue };
        for (method, ingredients) in methods.iter().zip(made) {
            let own = ingredients.iter().filter(|i| i.quantity == quantity);
            // Periods and masses are the same under both excitations.
            let once =
                |i: &&Ingredients| method.excitation == Excitation::Record || matches!(i.recipe, Recipe::Response(_));
            for ingredients in own.filter(once) {
                let resolved = resolved(job, ingredients);
                let made = Made { method: &method.id, excitation: method.excitation, ingredients: &resolved };
                found.extend(engine.attribute(&made, value));
            }
        }
    }
    found
}

/// The same run with its base held, of one whose base moves.
fn held(run: &Run) -> Option<Held> {
    let of = |factor, values: &BTreeMap<String, f64>| Held { factor, values: values.clone() };
    let lifts = run.base.as_ref().map(|base| of(Factor::Uplift, &base.held));
    let isolated = run.part("isolation").map(|part| of(Factor::Isolators, &part.held()));
    let on_soil = run.part("soil").map(|part| of(Factor::Soil, &part.held()));
    lifts.or(isolated).or(on_soil)
}

/// The uniform wall of a formula as a ladder; where a shell on the way has no mode, the formula alone.
fn resolved(job: &Job, ingredients: &Ingredients) -> Ingredients {
    let recipe = match ingredients.recipe {
        Recipe::UniformWall { thickness, modulus, period } => Recipe::Ladder(
            codes::wall_period::rungs(&job.case, thickness, modulus, period)
                .unwrap_or_else(|_| vec![Rung { factor: Factor::Formula, value: period }]),
        ),
        ref other => other.clone(),
    };
    Ingredients { quantity: ingredients.quantity, recipe }
}

/// Separates liquid, wall and roof in the impulsive mass of an engine, that of all modes of its group, as the procedures do; an engine
/// that cannot separate them gives no impulsive mass that could be compared.
pub(super) fn separate(job: &Job, simulation: &mut Simulation) {
    let values = &mut simulation.values;
    let group = impulsive::among(&simulation.result.modal).map(|(_, members)| members);
    let separated = |members: Vec<&ModalPart>| -> Option<[f64; 3]> {
        members.into_iter().try_fold([0.0; 3], |[liquid, wall, roof], mode| {
            let [own_wall, own_roof] = mode.structure?;
            Some([liquid + mode.liquid()?.shear, wall + own_wall.shear, roof + own_roof.shear])
        })
    };
    match group.and_then(separated) {
        Some([liquid, wall, roof]) => {
            values.insert(Quantity::ImpulsiveMass, liquid);
            values.insert(Quantity::WallMass, wall);
            if job.case.tank.roof.mass > 0.0 {
                values.insert(Quantity::RoofMass, roof);
            }
        }
        None => {
            values.remove(&Quantity::ImpulsiveMass);
        }
    }
}
