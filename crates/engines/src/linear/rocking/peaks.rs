//! Largest values of a run on a free base.

use ::base::history::History;
use ::base::{Base, Turn};

use super::setup::Laws;

/// Largest values with their steps.
#[derive(Clone, Copy)]
pub(super) struct Peaks {
    pub uplift: (f64, usize),
    pub rotation: (f64, usize),
    pub plastic: f64,
    pub toe: (f64, usize),
    pub slip: (f64, usize),
    pub anchor: (f64, usize),
    pub shear: (f64, usize),
    pub moment: (f64, usize),
}

impl Peaks {
    /// * `turns`: the base at each step of the history
    pub(super) fn of(base: &Base, turns: impl Iterator<Item = Turn>, laws: &Laws, history: &History) -> Peaks {
        let (mut uplift, mut toe) = ((0.0, 0), (0.0, 0));
        for (i, turn) in turns.enumerate() {
            if turn.uplift > uplift.0 {
                uplift = (turn.uplift, i);
            }
            let stress = turn.toe_force / base.wall_thickness();
            if stress.abs() > f64::abs(toe.0) {
                toe = (stress, i);
            }
        }
        Peaks {
            plastic: laws.rocking.curve().at(uplift.0).plastic_rotation,
            uplift,
            rotation: largest(&history.rotation),
            toe,
            slip: largest(&history.slip),
            anchor: largest(&history.anchor_force),
            shear: largest(&history.shear),
            moment: largest(&history.moment),
        }
    }
}

/// Largest |value| with its step.
pub(super) fn largest(values: &[f64]) -> (f64, usize) {
    let mut found = (0.0, 0);
    for (i, &value) in values.iter().enumerate() {
        if value.abs() > f64::abs(found.0) {
            found = (value, i);
        }
    }
    found
}

/// The base at each step.
pub(super) fn turns(laws: &Laws, history: &History) -> impl Iterator<Item = Turn> {
    let places = history.rotation.iter().zip(&history.pressure).enumerate();
    places.map(|(i, (psi, suction))| match (&laws.ring, history.pull.get(i)) {
        (Some(ring), Some(pull)) => ring.turn(*psi, *suction, *pull),
        _ => match history.centre.get(i) {
            Some(centre) => {
                let heave = || Some(laws.heave.as_ref()?.waves(&laws.law, (*psi, *centre), *suction));
                let waves = history.waves.get(i).copied().or_else(heave).unwrap_or_default();
                laws.rocking.moved((*psi, *centre), waves, history.moment[i], *suction)
            }
            None => laws.law.turn(*psi, *suction),
        },
    })
}
