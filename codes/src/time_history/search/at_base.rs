//! The faces of the wall at the base, which the bending of a clamped edge stresses.

use super::{Found, mises, ratio};
use crate::time_history::field::{Direction, Field};

/// What moves at an instant of a face at the base, and the direction.
#[derive(Clone, Copy)]
struct State {
    instant: usize,
    /// Axial stress [Pa].
    axial: f64,
    /// Hoop stress [Pa].
    hoop: f64,
}

/// The extremes of the meridional stress of a face at the base in a direction; the instants are the same for every factor on the motion.
struct Face {
    direction: Direction,
    low: State,
    high: State,
}

/// Histories of the meridional bending stress at the base.
pub(super) struct AtBase {
    /// Axial and hoop stress of the outer and the inner face in the static state [Pa].
    rest: [(f64, f64); 2],
    /// Outer and inner face in each direction.
    faces: Vec<[Face; 2]>,
}

impl AtBase {
    /// * fields: axial, hoop and bending
    pub(super) fn of([axial, hoop, bending]: [&Field; 3], poisson: f64, directions: &[Direction]) -> Option<AtBase> {
        if axial.len() == 0 {
            return None;
        }
        let face = |direction: Direction, side: f64| -> Face {
            let meridional = |k: usize| axial.at(k, direction) + side * bending.at(k, direction);
            // The first of the lowest and the last of the highest.
            let (mut low, mut high) = ((0, meridional(0)), (0, meridional(0)));
            for k in 1..axial.len() {
                let value = meridional(k);
                if value.total_cmp(&low.1).is_lt() {
                    low = (k, value);
                }
                if value.total_cmp(&high.1).is_ge() {
                    high = (k, value);
                }
            }
            let state = |instant: usize| {
                let bent = side * bending.moved(instant, direction);
                State {
                    instant,
                    axial: axial.moved(instant, direction) + bent,
                    hoop: hoop.moved(instant, direction) + poisson * bent,
                }
            };
            Face { direction, low: state(low.0), high: state(high.0) }
        };
        let both = |&direction: &Direction| [face(direction, 1.0), face(direction, -1.0)];
        let rest = [1.0, -1.0].map(|side| {
            let bent = side * bending.rest;
            (axial.rest + bent, hoop.rest + poisson * bent)
        });
        Some(AtBase { rest, faces: directions.iter().map(both).collect() })
    }

    /// Range of the equivalent stress of a face from the empty tank and between the extremes of its meridional stress, against a
    /// capacity [Pa].
    ///
    /// * `factor`: positive factor on the motion
    pub(super) fn range(&self, factor: f64, capacity: f64) -> Option<Found> {
        let mut worst: Option<Found> = None;
        for (face, rest) in self.faces.iter().flat_map(|faces| faces.iter().zip(self.rest)) {
            let [low, high] =
                [&face.low, &face.high].map(|state| (rest.0 + factor * state.axial, rest.1 + factor * state.hoop));
            let pairs = [
                (mises(low.0, low.1), face.low.instant),
                (mises(high.0, high.1), face.high.instant),
                (mises(high.0 - low.0, high.1 - low.1), face.high.instant),
            ];
            for (demand, instant) in pairs {
                if worst.is_none_or(|w| demand > w.demand) {
                    worst = Some(Found {
                        utilisation: ratio(demand, capacity),
                        demand,
                        // The bending at rest is of the same mesh: its error counts as well.
                        rest: 0.0,
                        capacity,
                        instant,
                        direction: face.direction,
                    });
                }
            }
        }
        worst
    }
}
