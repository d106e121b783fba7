//! Lower bounds of a capacity over the pressure.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Lower bounds of a capacity that depends monotonously on the pressure: the smaller value at the ends of each of some parts of a range.
#[derive(Clone, Debug)]
pub(crate) struct Floors {
    /// Least and largest pressure [Pa].
    range: (f64, f64),
    /// Parts for each pascal; 0 for a single pressure.
    per_pascal: f64,
    parts: Vec<f64>,
}

/// Parts of the range of the pressure: many enough that a bound is within some per cent.
const PARTS: usize = 192;

/// What is added to either end of a range, as a part of it, so that it serves a motion that is somewhat stronger.
const MORE: f64 = 0.5;

impl Floors {
    /// * range: least and largest pressure [Pa]
    fn new(range: (f64, f64), capacity: &dyn Fn(f64) -> f64) -> Floors {
        let (low, high) = range;
        let width = high - low;
        if !(width > 0.0 && width.is_finite()) {
            return Floors { range, per_pascal: 0.0, parts: vec![capacity(low).min(capacity(high))] };
        }
        let mut before = capacity(low);
        let floor = |i: usize| {
            let after = capacity(low + width * (i + 1) as f64 / PARTS as f64);
            let floor = before.min(after);
            before = after;
            floor
        };
        Floors { range, per_pascal: PARTS as f64 / width, parts: (0..PARTS).map(floor).collect() }
    }

    fn covers(&self, (low, high): (f64, f64)) -> bool {
        self.range.0 <= low && high <= self.range.1
    }

    /// Between two pressures of the range.
    pub(super) fn between(&self, (low, high): (f64, f64)) -> f64 {
        self.at(low).min(self.at(high))
    }

    /// At a pressure of the range; next to an edge, where rounding decides, the smaller of both parts.
    pub(super) fn at(&self, pressure: f64) -> f64 {
        let place = (pressure - self.range.0) * self.per_pascal;
        let part = |place: f64| self.parts[(place.max(0.0) as usize).min(self.parts.len() - 1)];
        part(place - 1e-9).min(part(place + 1e-9))
    }
}

/// The lower bounds of capacities that depend on the pressure alone, by limit state and course.
#[derive(Default)]
pub(crate) struct Shelf(RefCell<BTreeMap<(&'static str, usize), Rc<Floors>>>);

impl Shelf {
    /// Those of a limit state and the number of a course, over a range of pressures [Pa] at least.
    pub(crate) fn floors(
        &self,
        (id, course): (&'static str, usize),
        range: (f64, f64),
        capacity: &dyn Fn(f64) -> f64,
    ) -> Rc<Floors> {
        let mut all = self.0.borrow_mut();
        let known = all.get(&(id, course));
        if let Some(known) = known.filter(|known| known.covers(range)) {
            return Rc::clone(known);
        }
        let (low, high) = known.map_or(range, |known| (known.range.0.min(range.0), known.range.1.max(range.1)));
        let more = MORE * (high - low);
        let floors = Rc::new(Floors::new((low - more, high + more), capacity));
        all.insert((id, course), Rc::clone(&floors));
        floors
    }
}
