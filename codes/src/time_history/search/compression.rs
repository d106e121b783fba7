//! Axial compression against a capacity that depends on the interior pressure of the same instant and place.

use super::{Floors, Found, Pressed, ROUNDING, Search, ratio};
use crate::time_history::field::{Direction, Extremes, Span};

/// A capacity that depends on the interior pressure [Pa], monotonously: at no pressure of a range is it below both ends.
#[derive(Clone, Copy)]
pub(crate) struct Capacity<'a> {
    pub(crate) of: &'a dyn Fn(f64) -> f64,
    /// Its lower bounds.
    pub(crate) floors: &'a Floors,
}

/// What some instants are asked: whether compression over capacity can exceed a utilisation.
struct Exceeds<'a> {
    floors: &'a Floors,
    /// The row of the instants; none for all of them.
    row: Option<usize>,
    above: f64,
}

impl Exceeds<'_> {
    /// Whether it can with a compression and a lower bound of the capacity [Pa].
    fn by(&self, most: f64, least: f64) -> bool {
        ratio(most, least) * (1.0 + ROUNDING) > self.above
    }
}

/// How often a range of pressures is halved for closer bounds: to about the parts of the lower bounds of the capacity.
const HALVINGS: usize = 6;

impl Search<'_> {
    /// Bounds of the interior pressure at the place under this motion [Pa].
    pub(crate) fn pressures(&self) -> (f64, f64) {
        self.compression_bounds(Span::All).0
    }

    /// Bounds of the pressure, and of the compression the upper one [Pa].
    fn compression_bounds(&self, span: Span) -> ((f64, f64), f64) {
        let pressed = self.at.pressure.as_ref();
        let pressure = pressed.map_or((0.0, 0.0), |pressed| pressed.extremes.bounds(span, self.factor));
        (pressure, -self.at.axial.bounds(span, self.factor).0)
    }

    /// Whether compression over capacity can exceed a utilisation in some instants.
    fn compressed_above(&self, floors: &Floors, span: Span, above: f64) -> bool {
        let row = match span {
            Span::All => None,
            Span::Row(row) => Some(row),
            Span::Block(_) => return self.block_above(floors, span, above),
        };
        let (range, most) = self.compression_bounds(span);
        let exceeds = Exceeds { floors, row, above };
        self.pressed_above(&exceeds, range, most, HALVINGS)
    }

    /// The same with a pressure of a range.
    ///
    /// * `most`: bound of the compression [Pa]
    /// * `halvings`: how often the range may be halved for closer bounds
    fn pressed_above(&self, exceeds: &Exceeds<'_>, (low, high): (f64, f64), most: f64, halvings: usize) -> bool {
        let beside = |pressed: &Pressed| {
            let of = [&self.at.axial, &pressed.extremes];
            -pressed.axial.least(of, exceeds.row, self.factor, high)
        };
        let most = (self.at.pressure.as_ref()).map_or(most, |pressed| most.min(beside(pressed)));
        if !exceeds.by(most, exceeds.floors.between((low, high))) {
            return false;
        }
        let middle = 0.5 * (low + high);
        let half = |range: (f64, f64)| self.pressed_above(exceeds, range, most, halvings - 1);
        halvings == 0 || half((middle, high)) || half((low, middle))
    }

    /// The same of a block.
    fn block_above(&self, floors: &Floors, block: Span, above: f64) -> bool {
        let exceeds = Exceeds { floors, row: None, above };
        let (range, most) = self.compression_bounds(block);
        let least = floors.between(range);
        if !exceeds.by(most, least) {
            return false;
        }
        if !self.at.demands.transverse.is_empty() {
            return true;
        }
        // Direction by direction, with the pressure of those alone that are compressed enough.
        let fan = |of: &Extremes| of.fan(block, self.factor);
        let pressed = self.at.pressure.as_ref();
        let (axial, pressure) = (fan(&self.at.axial), pressed.map(|pressed| fan(&pressed.extremes)));
        self.directions.iter().any(|&(cosine, _)| {
            let most = -axial.at(cosine).0;
            let own = || pressure.as_ref().map_or((0.0, 0.0), |pressure| pressure.at(cosine));
            exceeds.by(most, least) && exceeds.by(most, floors.between(own()))
        })
    }

    /// Axial compression against its capacity.
    pub(crate) fn compression(&self, capacity: Capacity<'_>, above: f64) -> Option<Found> {
        if self.count() == 0 {
            return None;
        }
        let (range, most) = self.compression_bounds(Span::All);
        let mut best: Option<Found> = None;
        if self.block.is_none() {
            let lowest = (capacity.of)(range.0).min((capacity.of)(range.1));
            if ratio(most, lowest) <= above || !self.compressed_above(capacity.floors, Span::All, above) {
                return None;
            }
            // Where no capacity is left at some pressure, the first compression decides, not the largest.
            let first = match lowest > 0.0 {
                true => self.largest_compression(self.at.axial.lowest()),
                false => self.first_compression(),
            };
            self.compressed((super::block_of(first), Some(first)), capacity, above, &mut best);
        }
        // Capacity is dear: it is asked for where its lower bounds leave more than has been found.
        let may = |best: &Option<Found>, span: Span| {
            let above = best.map_or(above, |best| above.max(best.utilisation));
            self.compressed_above(capacity.floors, span, above)
        };
        self.blocks(&mut best, may, |best, block| {
            self.compressed((block, None), capacity, above, best);
        });
        best
    }

    /// The first instant of the largest compression of a block.
    fn largest_compression(&self, block: usize) -> usize {
        let axial = self.axial(block);
        let compression = |k: usize| axial.ends(k).map(|at| -axial.at(k, at)).into_iter().fold(0.0, f64::max);
        let larger = |best: usize, k: usize| if compression(k) > compression(best) { k } else { best };
        self.instants(block).start + (0..axial.len()).fold(0, larger)
    }

    /// The first instant of compression, or 0.
    fn first_compression(&self) -> usize {
        let mut found: Option<usize> = None;
        let may = |found: &Option<usize>, span: Span| found.is_none() && self.compression_bounds(span).1 > 0.0;
        self.blocks(&mut found, may, |found, block| {
            let (axial, start) = (self.axial(block), self.instants(block).start);
            let first = (0..axial.len()).find(|&k| axial.ends(k).iter().any(|&at| axial.at(k, at) < 0.0));
            *found = first.map(|k| start + k);
        });
        found.unwrap_or(0)
    }

    /// The largest compression against its capacity in a block or at one instant of it, where it is more than what was found.
    fn compressed(
        &self,
        (block, only): (usize, Option<usize>),
        capacity: Capacity<'_>,
        above: f64,
        best: &mut Option<Found>,
    ) {
        let (axial, pressure) = (self.axial(block), self.pressure(block));
        let all = self.instants(block);
        let (start, floors) = (all.start, capacity.floors);
        let state = |k: usize, direction: Direction| {
            let pressure = pressure.as_ref().map_or(0.0, |p| p.at(k, direction));
            ((-axial.at(k, direction)).max(0.0), pressure)
        };
        // Compression and pressure are linear in cos θ. Of each half of the circumference: the larger compression of its ends over the
        // lower bound of the capacity between their pressures. Both are large on the same half, small on the other.
        let halves = |k: usize| {
            let [front, middle, back] = [1.0, 0.0, -1.0].map(|cosine| {
                let (demand, pressure) = state(k, (cosine, 0.0));
                (demand, floors.at(pressure))
            });
            let half = |a: (f64, f64), b: (f64, f64)| ratio(a.0.max(b.0), a.1.min(b.1));
            half(front, middle).max(half(middle, back)) * (1.0 + ROUNDING)
        };
        for instant in only.map_or(all, |instant| instant..instant + 1) {
            let k = instant - start;
            let counts = |bound: f64, best: &Option<Found>| {
                best.map_or(only.is_some() || bound > above, |best| bound > best.utilisation)
            };
            if !axial.turns() && !counts(halves(k), best) {
                continue;
            }
            let own = axial.turns().then(|| axial.ends(k));
            for direction in self.directions.iter().copied().chain(own.into_iter().flatten()) {
                let (demand, pressure) = state(k, direction);
                if !counts(ratio(demand, floors.at(pressure)), best) {
                    continue;
                }
                let capacity = (capacity.of)(pressure);
                let utilisation = ratio(demand, capacity);
                if best.is_none_or(|best| utilisation > best.utilisation) {
                    *best =
                        Some(Found { utilisation, demand, rest: (-axial.rest).max(0.0), capacity, instant, direction });
                }
            }
        }
    }
}
