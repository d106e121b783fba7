//! A quantity of one place over time and around the circumference, and the extremes by which a search passes over most of it.
//!
//! ```text
//! value(θ, t) = rest + f (even(t) + odd(t) cos θ + transverse(t) sin θ)        f: factor on the motion
//! ```
//!
//! The extremes of the bracket around the circumference hold for every factor.

mod pair;

use std::f64::consts::TAU;
use std::ops::Range;

pub(super) use pair::Pair;

use tank::demand::{Demands, OnWall, Part, Terms};

/// cos θ and sin θ of a place on the circumference. Without a motion along y the sine has no effect and is 0.
pub(super) type Direction = (f64, f64);

/// θ = 0 and 180°.
pub(super) const SIDES: [Direction; 2] = [(1.0, 0.0), (-1.0, 0.0)];

/// Instants that share their extremes: few enough that a shaken tank is not near its peak in many of them, many enough that the extremes
/// take a small part of the histories.
const BLOCK: usize = 8;

/// What rounding may add to a bound, relative to its size: a value has some ten operations.
const ROUNDING: f64 = 1e-12;

/// Angle of a direction [rad], from 0 to 2 π.
pub(super) fn angle((cosine, sine): Direction) -> f64 {
    if sine == 0.0 { cosine.clamp(-1.0, 1.0).acos() } else { sine.atan2(cosine).rem_euclid(TAU) }
}

/// Instants of a block among `count`.
pub(super) fn instants(block: usize, count: usize) -> Range<usize> {
    block * BLOCK..((block + 1) * BLOCK).min(count)
}

/// Instants in a row whose histories are combined for all places before the next ones: the states of these remain in the nearest cache.
const TOGETHER: usize = 16 * BLOCK;

/// Rows of instants, each a whole number of blocks but the last.
pub(super) fn rows(count: usize) -> impl ExactSizeIterator<Item = Range<usize>> {
    let start = (0..count).step_by(TOGETHER);
    start.map(move |start| start..(start + TOGETHER).min(count))
}

/// Number of blocks of `count` instants.
fn blocks(count: usize) -> usize {
    count.div_ceil(BLOCK)
}

/// Blocks of a row among `count` instants.
pub(super) fn blocks_of(row: usize, count: usize) -> Range<usize> {
    let each = TOGETHER / BLOCK;
    row * each..((row + 1) * each).min(blocks(count))
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

/// What a field is made of.
pub(super) struct Wanted<'a> {
    rest: f64,
    /// None where nothing is the same around the circumference.
    even: Option<&'a Terms>,
    odd: &'a Terms,
    factors: Factors,
}

impl<'a> Wanted<'a> {
    pub(super) fn on_wall(of: &'a OnWall, factors: Factors) -> Wanted<'a> {
        Wanted { rest: of.rest, even: (!of.even.is_empty()).then_some(&of.even), odd: &of.odd, factors }
    }

    /// A part of the motion alone.
    pub(super) fn amplitude(odd: &'a Terms, factors: Factors) -> Wanted<'a> {
        Wanted { rest: 0.0, even: None, odd, factors }
    }
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
        Field::part(&demands.part(0..demands.times.len()), of, factors)
    }

    pub(super) fn part(part: &Part<'_>, of: &OnWall, factors: Factors) -> Field {
        Field::parts(part, &[Wanted::on_wall(of, factors)]).swap_remove(0)
    }

    /// Several quantities at the same instants.
    pub(super) fn parts(part: &Part<'_>, wanted: &[Wanted<'_>]) -> Vec<Field> {
        let terms: Vec<&Terms> = wanted.iter().flat_map(|of| [of.odd].into_iter().chain(of.even)).collect();
        let odd: Vec<&Terms> = wanted.iter().map(|of| of.odd).collect();
        let mut along = part.histories(&terms).into_iter();
        let mut transverse = part.transverses(&odd).into_iter().flatten();
        let fields = wanted.iter().map(|of| {
            let mut next = || factored(along.next().unwrap_or_default(), of.factors);
            Field {
                rest: of.rest * of.factors.stress,
                odd: next(),
                even: of.even.map(|_| next()).unwrap_or_default(),
                transverse: transverse.next().map(|values| factored(values, of.factors)),
            }
        });
        fields.collect()
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
        let Some(transverse) = &self.transverse else { return SIDES };
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

    /// What moves in some instants.
    fn moved_in(&self, instants: Range<usize>) -> Moved {
        let even = self.even.get(instants.clone()).map_or((0.0, 0.0), range_of);
        let odd = &self.odd[instants.clone()];
        let Some(transverse) = &self.transverse else {
            let odd = range_of(odd);
            if self.even.is_empty() {
                return Moved::of_odd(odd);
            }
            let around = instants.map(|k| self.around(k, self.odd[k].abs())).fold(NOTHING, wider);
            return Moved { around, even, odd };
        };
        let size = |k: usize| self.odd[k].hypot(transverse[k]);
        let amplitude = instants.clone().map(size).fold(0.0, f64::max);
        Moved {
            around: instants.map(|k| self.around(k, size(k))).fold(NOTHING, wider),
            even,
            odd: (-amplitude, amplitude),
        }
    }

    /// The smallest and the largest of what moves at an instant, around the circumference.
    fn around(&self, k: usize, amplitude: f64) -> (f64, f64) {
        let even = self.even.get(k).copied().unwrap_or(0.0);
        (even - amplitude, even + amplitude)
    }
}

/// The range of no values.
const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// The range of two ranges.
fn wider((low, high): (f64, f64), (l, h): (f64, f64)) -> (f64, f64) {
    (if l < low { l } else { low }, if h > high { h } else { high })
}

/// The range of some values.
fn range_of(values: &[f64]) -> (f64, f64) {
    values.iter().map(|&value| (value, value)).fold(NOTHING, wider)
}

/// Ranges of what moves in some instants.
#[derive(Clone, Copy)]
struct Moved {
    /// Around the circumference.
    around: (f64, f64),
    /// Range of the part that is the same around the circumference.
    even: (f64, f64),
    /// Range of the part that goes with the cosine; with a motion along y that of its amplitude in any direction.
    odd: (f64, f64),
}

impl Moved {
    /// The ranges of no instants.
    const NONE: Moved = Moved { around: NOTHING, even: NOTHING, odd: NOTHING };

    /// Where nothing is the same around the circumference.
    fn of_odd(odd: (f64, f64)) -> Moved {
        let amplitude = (-odd.0).max(odd.1);
        Moved { around: (-amplitude, amplitude), even: (0.0, 0.0), odd }
    }

    /// What the absolute values of both parts add up to at most.
    fn size(&self) -> f64 {
        let Moved { even, odd, .. } = self;
        even.0.abs().max(even.1.abs()) + odd.0.abs().max(odd.1.abs())
    }

    /// The ranges of both.
    fn and(self, other: Moved) -> Moved {
        Moved {
            around: wider(self.around, other.around),
            even: wider(self.even, other.even),
            odd: wider(self.odd, other.odd),
        }
    }
}

/// Some of the instants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Span {
    /// All.
    All,
    /// Those of a row, by its number.
    Row(usize),
    /// Those of a block.
    Block(usize),
}

/// Ranges of what moves, one after the other. Where nothing is the same around the circumference, that of the odd part says all.
#[derive(Default)]
struct Ranges {
    odd: Vec<(f64, f64)>,
    even: Vec<(f64, f64)>,
    around: Vec<(f64, f64)>,
}

impl Ranges {
    /// None yet, with room for some.
    fn with_capacity(count: usize, even: bool) -> Ranges {
        let beside = if even { count } else { 0 };
        Ranges { odd: Vec::with_capacity(count), even: Vec::with_capacity(beside), around: Vec::with_capacity(beside) }
    }

    fn push(&mut self, moved: Moved, even: bool) {
        self.odd.push(moved.odd);
        if even {
            self.even.push(moved.even);
            self.around.push(moved.around);
        }
    }

    fn get(&self, i: usize) -> Moved {
        let odd = self.odd[i];
        match (self.even.get(i), self.around.get(i)) {
            (Some(&even), Some(&around)) => Moved { around, even, odd },
            _ => Moved::of_odd(odd),
        }
    }
}

/// The ranges of what moves of a field, by rows and blocks of instants.
pub(super) struct Extremes {
    /// Value in the static state.
    pub(super) rest: f64,
    /// Whether a part is the same around the circumference.
    even: bool,
    blocks: Ranges,
    rows: Ranges,
    all: Moved,
}

impl Extremes {
    /// Those of no instants, with room for `count`.
    ///
    /// * `rest`: value in the static state
    /// * `even`: whether a part is the same around the circumference
    pub(super) fn new(rest: f64, even: bool, count: usize) -> Extremes {
        Extremes {
            rest,
            even,
            blocks: Ranges::with_capacity(blocks(count), even),
            rows: Ranges::with_capacity(rows(count).len(), even),
            all: Moved::NONE,
        }
    }

    /// Adds the next row of the field under the motion as it is.
    pub(super) fn take(&mut self, field: &Field) {
        self.extend(field.len(), |instants| field.moved_in(instants));
    }

    /// Adds the next row of an amplitude.
    pub(super) fn take_amplitude(&mut self, of: &Field) {
        let size = |k: usize| of.transverse.as_ref().map_or(of.odd[k].abs(), |y| of.odd[k].hypot(y[k]));
        self.extend(of.len(), |instants| Moved::of_odd((0.0, instants.map(size).fold(0.0, f64::max))));
    }

    fn extend(&mut self, count: usize, moved: impl Fn(Range<usize>) -> Moved) {
        let mut row = Moved::NONE;
        for block in 0..blocks(count) {
            let found = moved(instants(block, count));
            row = row.and(found);
            self.blocks.push(found, self.even);
        }
        self.all = self.all.and(row);
        self.rows.push(row, self.even);
    }

    /// The first block of the smallest value.
    pub(super) fn lowest(&self) -> usize {
        let mut all = 0..self.blocks.odd.len();
        let lowest = all.find(|&block| self.blocks.get(block).around.0 == self.all.around.0);
        lowest.unwrap_or(0)
    }

    fn moved(&self, span: Span) -> Moved {
        match span {
            Span::All => self.all,
            Span::Row(row) => self.rows.get(row),
            Span::Block(block) => self.blocks.get(block),
        }
    }

    /// Bounds of the field under the motion times a factor.
    pub(super) fn bounds(&self, span: Span, factor: f64) -> (f64, f64) {
        let (low, high) = self.moved(span).around;
        self.at_rest_and((low, high), low.abs().max(high.abs()), factor)
    }

    /// The field by directions, without a motion along y.
    pub(super) fn fan(&self, span: Span, factor: f64) -> Fan {
        let moved = self.moved(span);
        let Moved { even, odd, .. } = moved;
        let (low, high) = self.at_rest_and(even, moved.size(), factor);
        Fan { low, high, odd: (factor * odd.0, factor * odd.1) }
    }

    /// What the absolute values of all terms add up to at most.
    fn size(&self, factor: f64) -> f64 {
        self.rest.abs() + factor * self.all.size()
    }

    /// * `size`: that of the terms of the range
    fn at_rest_and(&self, (low, high): (f64, f64), size: f64, factor: f64) -> (f64, f64) {
        let slack = ROUNDING * (self.rest.abs() + factor * size);
        (self.rest + factor * low - slack, self.rest + factor * high + slack)
    }
}

/// Bounds of a field in some instants by the cosine of the direction.
pub(super) struct Fan {
    /// Bounds without the part that goes with the cosine, with what rounding may add to both.
    low: f64,
    high: f64,
    odd: (f64, f64),
}

impl Fan {
    /// In a direction.
    pub(super) fn at(&self, cosine: f64) -> (f64, f64) {
        let (a, b) = (cosine * self.odd.0, cosine * self.odd.1);
        (self.low + a.min(b), self.high + a.max(b))
    }

    /// Between two directions.
    pub(super) fn within(&self, (from, to): (f64, f64)) -> (f64, f64) {
        wider(self.at(from), self.at(to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source:    every value of the instants of a span, at three angles of a part of the circumference
    /// Goal:      all lie in the bounds, and the bounds of one direction without an even part are reached
    /// Tolerance: none; for what is reached 1e-9 of the largest value, above the slack for rounding
    #[test]
    fn bounds_hold_all_values() {
        let count = 2 * TOGETHER + 21;
        let wave = |k: usize, a: f64, b: f64| (a * k as f64).sin() + 0.6 * (b * k as f64).cos();
        for even in [false, true] {
            let field = |instants: Range<usize>| Field {
                rest: 0.4,
                even: if even { instants.clone().map(|k| wave(k, 0.05, 0.31)).collect() } else { Vec::new() },
                odd: instants.map(|k| wave(k, 0.21, 0.013)).collect(),
                transverse: None,
            };
            let mut extremes = Extremes::new(0.4, even, count);
            rows(count).for_each(|row| extremes.take(&field(row)));
            let all = field(0..count);
            let mut spans = vec![(Span::All, 0..count)];
            spans.extend(rows(count).enumerate().map(|(i, row)| (Span::Row(i), row)));
            spans.extend((0..blocks(count)).map(|i| (Span::Block(i), instants(i, count))));
            for (span, instants) in spans {
                for part in [(-1.0, -0.8), (-0.4, 0.4), (0.3, 0.3), (0.8, 1.0)] {
                    let (low, high) = extremes.fan(span, 2.0).within(part);
                    let (least, most) = extremes.bounds(span, 2.0);
                    let mut reached = NOTHING;
                    for k in instants.clone() {
                        for cosine in [part.0, 0.5 * (part.0 + part.1), part.1] {
                            let value = 0.4 + 2.0 * all.moved(k, (cosine, 0.0));
                            assert!(low <= value && value <= high && least <= value && value <= most);
                            reached = wider(reached, (value, value));
                        }
                    }
                    let close = |a: f64, b: f64| (a - b).abs() < 1e-9;
                    assert!(even || part.0 != part.1 || close(reached.0, low) && close(reached.1, high));
                }
            }
        }
    }
}
