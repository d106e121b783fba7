//! A quantity of one place over time and around the circumference, and the extremes by which a search passes over most of it.
//!
//! ```text
//! value(θ, t) = rest + f (even(t) + odd(t) cos θ + transverse(t) sin θ)        f: factor on the motion
//! ```
//!
//! The extremes of the bracket around the circumference hold for every factor.

use std::f64::consts::TAU;
use std::ops::Range;

use tank::demand::{Demands, OnWall, Terms};

/// cos θ and sin θ of a place on the circumference. Without a motion along y the sine has no effect and is 0.
pub(super) type Direction = (f64, f64);

/// θ = 0 and 180°.
pub(super) const SIDES: [Direction; 2] = [(1.0, 0.0), (-1.0, 0.0)];

/// Instants that share their extremes: few enough that a shaken tank is not near its peak in many of them, many enough that the extremes
/// take a small part of the histories.
const BLOCK: usize = 16;

/// What rounding may add to a bound, relative to its size: a value has some ten operations.
const ROUNDING: f64 = 1e-12;

/// Angle of a direction [rad], from 0 to 2 π.
pub(super) fn angle((cosine, sine): Direction) -> f64 {
    match sine == 0.0 {
        true => cosine.clamp(-1.0, 1.0).acos(),
        false => sine.atan2(cosine).rem_euclid(TAU),
    }
}

/// Instants of a block among `count`.
pub(super) fn instants(block: usize, count: usize) -> Range<usize> {
    block * BLOCK..((block + 1) * BLOCK).min(count)
}

/// Instants in a row whose histories are combined for all places before the next ones: the states of these remain in the nearest cache.
const TOGETHER: usize = 8 * BLOCK;

/// Rows of instants, each a whole number of blocks but the last.
pub(super) fn rows(count: usize) -> impl Iterator<Item = Range<usize>> {
    let start = (0..count).step_by(TOGETHER);
    start.map(move |start| start..(start + TOGETHER).min(count))
}

/// Number of blocks of `count` instants.
pub(super) fn blocks(count: usize) -> usize {
    count.div_ceil(BLOCK)
}

/// Block of an instant.
pub(super) fn block_of(instant: usize) -> usize {
    instant / BLOCK
}

/// Factors of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Factors {
    /// On static state and motion: stresses of a corroded wall.
    pub(super) stress: f64,
    /// On the motion.
    pub(super) motion: f64,
}

/// A history of factored terms.
pub(super) fn factored(mut values: Vec<f64>, factors: Factors) -> Vec<f64> {
    for factor in [factors.stress, factors.motion] {
        if factor != 1.0 {
            values.iter_mut().for_each(|value| *value *= factor);
        }
    }
    values
}

/// A quantity at some instants, counted from the first of them.
pub(super) struct Field {
    pub(super) rest: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
    /// Part of the motion along y; none without one.
    transverse: Option<Vec<f64>>,
}

impl Field {
    /// At all instants.
    pub(super) fn whole(demands: &Demands, of: &OnWall, factors: Factors) -> Field {
        Field::part(demands, of, 0..demands.times.len(), factors)
    }

    pub(super) fn part(demands: &Demands, of: &OnWall, instants: Range<usize>, factors: Factors) -> Field {
        let history = |terms: &Terms| factored(demands.part(terms, instants.clone()), factors);
        let transverse = demands.transverse_part(&of.odd, instants.clone());
        Field {
            rest: of.rest * factors.stress,
            even: match of.even.is_empty() {
                true => Vec::new(),
                false => history(&of.even),
            },
            odd: history(&of.odd),
            transverse: transverse.map(|values| factored(values, factors)),
        }
    }

    /// Number of instants.
    pub(super) fn len(&self) -> usize {
        self.odd.len()
    }

    /// Whether there is a motion along y.
    pub(super) fn turns(&self) -> bool {
        self.transverse.is_some()
    }

    /// What moves at an instant in a direction.
    pub(super) fn moved(&self, k: usize, (c, s): Direction) -> f64 {
        self.even.get(k).copied().unwrap_or(0.0)
            + c * self.odd[k]
            + self.transverse.as_ref().map_or(0.0, |transverse| s * transverse[k])
    }

    /// Value at an instant in a direction.
    pub(super) fn at(&self, k: usize, (c, s): Direction) -> f64 {
        let along = self.rest + self.even.get(k).copied().unwrap_or(0.0) + c * self.odd[k];
        match &self.transverse {
            Some(transverse) => along + s * transverse[k],
            None => along,
        }
    }

    /// The directions of the largest and the smallest value at an instant.
    pub(super) fn ends(&self, k: usize) -> [Direction; 2] {
        let Some(transverse) = &self.transverse else {
            return SIDES;
        };
        let (x, y) = (self.odd[k], transverse[k]);
        match x.hypot(y) {
            size if size > 0.0 => [(x / size, y / size), (-x / size, -y / size)],
            _ => SIDES,
        }
    }

    /// Largest absolute value that it can have at an instant.
    pub(super) fn bound(&self, k: usize) -> f64 {
        let ends = self.ends(k).map(|at| self.at(k, at).abs());
        ends[0].max(ends[1])
    }

    /// Amplitude around the circumference at an instant.
    fn amplitude(&self, k: usize) -> f64 {
        match &self.transverse {
            Some(transverse) => self.odd[k].hypot(transverse[k]),
            None => self.odd[k].abs(),
        }
    }

    /// The smallest and the largest of what moves, around the circumference.
    fn extremes(&self, k: usize) -> (f64, f64) {
        let (even, amplitude) = (self.even.get(k).copied().unwrap_or(0.0), self.amplitude(k));
        (even - amplitude, even + amplitude)
    }
}

/// The range of no values.
const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// The range of two ranges.
fn wider((low, high): (f64, f64), (l, h): (f64, f64)) -> (f64, f64) {
    (if l < low { l } else { low }, if h > high { h } else { high })
}

/// The extremes of what moves of a field, by blocks of instants.
pub(super) struct Extremes {
    /// Value in the static state.
    pub(super) rest: f64,
    blocks: Vec<(f64, f64)>,
    whole: (f64, f64),
}

impl Extremes {
    /// Those of no instants.
    ///
    /// * `rest`: value in the static state
    pub(super) fn new(rest: f64) -> Extremes {
        Extremes {
            rest,
            blocks: Vec::new(),
            whole: NOTHING,
        }
    }

    /// Adds the next instants of the field under the motion as it is; a whole number of blocks, or the last ones.
    pub(super) fn take(&mut self, field: &Field) {
        self.extend(field.len(), |k| field.extremes(k));
    }

    /// Adds the next instants of an amplitude, which moves from 0 to its size.
    pub(super) fn take_amplitude(&mut self, along: &[f64], transverse: Option<&Vec<f64>>) {
        let size = |k: usize| transverse.map_or(along[k].abs(), |y| along[k].hypot(y[k]));
        self.extend(along.len(), |k| (0.0, size(k)));
    }

    fn extend(&mut self, count: usize, extremes: impl Fn(usize) -> (f64, f64)) {
        for block in 0..blocks(count) {
            let found = instants(block, count).map(&extremes).fold(NOTHING, wider);
            self.whole = wider(self.whole, found);
            self.blocks.push(found);
        }
    }

    /// The first block of the smallest value.
    pub(super) fn lowest(&self) -> usize {
        let lowest = self.blocks.iter().position(|(low, _)| *low == self.whole.0);
        lowest.unwrap_or(0)
    }

    /// Bounds of the field under the motion times a factor, in a block or over all.
    pub(super) fn bounds(&self, block: Option<usize>, factor: f64) -> (f64, f64) {
        let (low, high) = match block {
            Some(block) => self.blocks[block],
            None => self.whole,
        };
        let (low, high) = (factor * low, factor * high);
        let slack = ROUNDING * (self.rest.abs() + low.abs().max(high.abs()));
        (self.rest + low - slack, self.rest + high + slack)
    }
}
