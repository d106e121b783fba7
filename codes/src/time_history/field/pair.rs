//! What one quantity can be where another has a value at the same instant and in the same direction.
//!
//! ```text
//! a + λ b ≥ m(λ)        at all instants and in all directions, so that a ≥ m(λ) − λ b
//! ```
//!
//! Bounds of each alone put the largest compression of one side of a tank beside the smallest pressure of the other.

use super::{Extremes, Field, ROUNDING, rows};

/// The slopes λ, as multiples of the size of a over that of b.
const SLOPES: [f64; 4] = [0.05, 0.15, 0.4, 1.0];

/// Instants whose sums are compared side by side.
const LANES: usize = 8;

/// The slopes of a pair, and m of each, of what moves.
pub(crate) struct Pair {
    slopes: [f64; SLOPES.len()],
    rows: Vec<[f64; SLOPES.len()]>,
    all: [f64; SLOPES.len()],
}

impl Pair {
    /// That of no instants, with room for `count`.
    ///
    /// * ratio: about the size of what moves of a, over that of b; any that is not negative is right
    pub(crate) fn new(ratio: f64, count: usize) -> Pair {
        let ratio = if ratio.is_finite() { ratio } else { 0.0 };
        Pair {
            slopes: SLOPES.map(|slope| slope * ratio),
            rows: Vec::with_capacity(rows(count).len()),
            all: [f64::INFINITY; SLOPES.len()],
        }
    }

    /// Adds the next row of both.
    pub(crate) fn take(&mut self, a: &Field, b: &Field) {
        let row = self.slopes.map(|slope| least(a, b, slope));
        for (all, row) in self.all.iter_mut().zip(row) {
            *all = all.min(row);
        }
        self.rows.push(row);
    }

    /// A lower bound of a in a row or all of them under the motion times a factor, where b is not more than a value.
    ///
    /// * row: its number; none for all
    pub(crate) fn least(&self, [a, b]: [&Extremes; 2], row: Option<usize>, factor: f64, value: f64) -> f64 {
        let least = row.map_or(&self.all, |row| &self.rows[row]);
        let sizes = (a.size(factor), b.size(factor) + value.abs());
        let of = |(slope, least): (&f64, &f64)| {
            let slack = ROUNDING * (sizes.0 + slope * sizes.1);
            a.rest + factor * least - slope * (value - b.rest) - slack
        };
        self.slopes.iter().zip(least).map(of).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The smallest a + λ b of what moves.
fn least(a: &Field, b: &Field, slope: f64) -> f64 {
    if !a.turns() && a.even.is_empty() && b.even.is_empty() {
        return -largest(&a.odd, &b.odd, slope);
    }
    let of = |of: &[f64], k: usize| of.get(k).copied().unwrap_or(0.0);
    let sum = |p: &[f64], q: &[f64], k: usize| of(p, k) + slope * of(q, k);
    let [p, q] = [a, b].map(|of| of.transverse.as_deref());
    let at = |k: usize| {
        let odd = sum(&a.odd, &b.odd, k);
        let amplitude = p.zip(q).map_or(odd.abs(), |(p, q)| odd.hypot(sum(p, q, k)));
        sum(&a.even, &b.even, k) - amplitude
    };
    (0..a.len()).map(at).fold(f64::INFINITY, f64::min)
}

/// The largest |a + λ b|, several instants side by side.
fn largest(a: &[f64], b: &[f64], slope: f64) -> f64 {
    let size = |a: &f64, b: &f64| (a + slope * b).abs();
    let ((a, last_a), (b, last_b)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut lanes = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for k in 0..LANES {
            let size = size(&a[k], &b[k]);
            lanes[k] = if size > lanes[k] { size } else { lanes[k] };
        }
    }
    let last = last_a.iter().zip(last_b).map(|(a, b)| size(a, b));
    lanes.into_iter().chain(last).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::ops::Range;

    use super::*;

    /// Source:    every value of two fields, with and without an even part and a motion along y, at 13 angles
    /// Goal:      no value of a is below its bound at the value of b there, of all instants and of its row, and one reaches it
    /// Tolerance: none; for what is reached 1e-9 of values of about 10, above the slack for rounding
    #[test]
    fn bounds_hold_all_values() {
        let count = 300;
        let wave = |k: usize, a: f64, b: f64| (a * k as f64).sin() + 0.6 * (b * k as f64).cos();
        for (even, turns) in [(false, false), (true, false), (false, true), (true, true)] {
            let field = |instants: Range<usize>, rest: f64, size: f64, shift: f64| {
                let history = |a: f64, b: f64| instants.clone().map(|k| size * wave(k, a, b + shift)).collect();
                Field {
                    rest,
                    even: if even { history(0.05, 0.31) } else { Vec::new() },
                    odd: history(0.21, 0.013),
                    transverse: turns.then(|| history(0.17, 0.023)),
                }
            };
            let fields =
                |instants: Range<usize>| [field(instants.clone(), -3.0, 9.0, 0.02), field(instants, 0.7, 2.0, 0.0)];
            let mut extremes = [-3.0, 0.7].map(|rest| Extremes::new(rest, even, count));
            let mut pair = Pair::new(4.0, count);
            for row in rows(count) {
                let [a, b] = fields(row);
                extremes.iter_mut().zip([&a, &b]).for_each(|(extremes, field)| extremes.take(field));
                pair.take(&a, &b);
            }
            let [a, b] = fields(0..count);
            let of = [&extremes[0], &extremes[1]];
            let mut closest = f64::INFINITY;
            for (number, row) in rows(count).enumerate() {
                for (k, angle) in row.flat_map(|k| (0..13).map(move |i| (k, f64::from(i) * PI / 12.0))) {
                    let direction = if turns { (angle.cos(), angle.sin()) } else { (angle.cos(), 0.0) };
                    let [value, beside] = [&a, &b].map(|field| field.rest + 2.0 * field.moved(k, direction));
                    let bounds = [None, Some(number)].map(|row| pair.least(of, row, 2.0, beside));
                    assert!(bounds[0] <= bounds[1] && bounds[1] <= value, "{bounds:?} {value}");
                    closest = closest.min(value - bounds[0]);
                }
            }
            // Without a motion along y the extremes are at 0 and 180°, which are among the angles.
            assert!(turns || closest < 1e-9, "{closest}");
        }
    }
}
