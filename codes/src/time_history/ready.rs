//! Demands of a run, ready to be compared with capacities under the record times any factor.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;

use rayon::prelude::*;
use tank::case::Case;
use tank::demand::{Demands, Place, Terms};

use super::field::{Direction, rows};
use super::search::{Searched, Shelf, directions};

/// Numbers of a place and of an instant.
type PlaceAndInstant = (usize, usize);

/// What the checks of a run need of its demands, computed once: a linear model under the same record times a factor needs nothing else.
pub struct Ready<'a> {
    pub(super) demands: &'a Demands,
    pub(super) directions: Vec<Direction>,
    /// For each limit state of the wall and each course the number of the place and of the instant that governed last, where a search
    /// begins.
    pub(super) governing: RefCell<BTreeMap<(&'static str, usize), PlaceAndInstant>>,
    /// Lower bounds of capacities, which the motion does not change.
    pub(super) shelf: Shelf,
    /// Places on the wall of a metal cylinder as corrosion leaves it, by course and height.
    pub(super) wall: Vec<Searched<'a>>,
    /// Places at the base of a cylinder as the engine has them.
    pub(super) base: Vec<Searched<'a>>,
    /// Horizontal force on the foundation [N]; of a tank that slides, that of the tank held in place.
    pub(super) shear: Option<History>,
    /// Moment below the base plate [N·m].
    pub(super) moment: Option<History>,
    /// Vertical acceleration of the ground, upwards [m/s²].
    pub(super) vertical: Option<Vec<f64>>,
    /// The least of it in each of [`rows`]; none without one.
    least_upwards: Vec<f64>,
    /// The same with scaled properties of isolators, and their factor.
    pub(super) bounds: Vec<(f64, Ready<'a>)>,
}

impl Ready<'_> {
    /// Vertical acceleration of the ground at an instant, upwards [m/s²].
    pub(super) fn upwards(&self, k: usize) -> f64 {
        self.vertical.as_ref().map_or(0.0, |a| a[k])
    }

    /// The least of it in a row of instants.
    pub(super) fn least_upwards(&self, row: usize) -> f64 {
        self.least_upwards.get(row).copied().unwrap_or(0.0)
    }
}

/// A history under the motion along x, and along y where there is one.
pub(super) struct History {
    along: Vec<f64>,
    transverse: Option<Vec<f64>>,
    /// Largest size in each of [`rows`].
    largest: Vec<f64>,
}

impl History {
    fn of(demands: &Demands, terms: &Terms) -> History {
        let mut history =
            History { along: demands.history(terms), transverse: demands.transverse(terms), largest: Vec::new() };
        let largest = |row: Range<usize>| row.map(|k| history.size(k)).fold(0.0, f64::max);
        history.largest = rows(history.len()).map(largest).collect();
        history
    }

    /// Rows of instants with the largest size in each.
    pub(super) fn rows(&self) -> impl Iterator<Item = (Range<usize>, f64)> {
        rows(self.len()).zip(self.largest.iter().copied())
    }

    pub(super) fn len(&self) -> usize {
        self.along.len()
    }

    /// Parts along x and y at an instant; the second none without a motion along y.
    pub(super) fn at(&self, k: usize) -> (f64, Option<f64>) {
        (self.along[k], self.transverse.as_ref().map(|y| y[k]))
    }

    /// Size at an instant, of both parts together.
    pub(super) fn size(&self, k: usize) -> f64 {
        match self.at(k) {
            (x, Some(y)) => x.hypot(y),
            (x, None) => x.abs(),
        }
    }
}

impl<'a> Ready<'a> {
    /// Those of a case.
    pub fn new(case: &Case, demands: &'a Demands) -> Ready<'a> {
        let directions = directions(demands);
        let (mut wall, mut at_base) = (Vec::new(), Vec::new());
        if case.tank.shape.radius().is_some() {
            let size = |most: f64, value: &f64| most.max(value.abs());
            let peaks: Vec<f64> = (demands.states.iter()).map(|state| state.iter().fold(0.0, size)).collect();
            let bottom = demands.places.iter().filter(|place| place.z == 0.0);
            at_base = bottom.map(|place| Searched::new(demands, place, 1.0, &peaks)).collect();
            if case.tank.is_metal() {
                let searched = |place: &'a Place| {
                    let course = case.tank.courses.get(place.course)?;
                    let lost = course.thickness / course.net_thickness();
                    Some(Searched::new(demands, place, lost, &peaks).bent(course.material.poisson_ratio, &directions))
                };
                wall = demands.places.iter().filter_map(searched).collect();
            }
        }
        side_by_side([&mut wall, &mut at_base], demands);
        let held = demands.base.as_ref().and_then(|base| base.held_shear.as_ref());
        let history = |terms: &Terms| History::of(demands, terms);
        let vertical = demands.vertical.as_ref().map(|terms| demands.history(terms));
        let least = |a: &Vec<f64>| {
            let of = |row: Range<usize>| a[row].iter().copied().fold(f64::INFINITY, f64::min);
            rows(a.len()).map(of).collect()
        };
        let bounds = demands.isolation.iter().flat_map(|isolation| &isolation.bounds);
        Ready {
            bounds: bounds.map(|(scale, demands)| (*scale, Ready::new(case, demands))).collect(),
            least_upwards: vertical.as_ref().map(least).unwrap_or_default(),
            shear: held.or(demands.base_shear.as_ref()).map(history),
            moment: demands.overturning_moment.as_ref().map(history),
            vertical,
            base: at_base,
            governing: RefCell::default(),
            shelf: Shelf::default(),
            wall,
            directions,
            demands,
        }
    }
}

/// Every place takes all instants, side by side.
fn side_by_side(places: [&mut [Searched<'_>]; 2], demands: &Demands) {
    let instants = demands.times.len();
    let take = |mut part: Vec<&mut Searched<'_>>| {
        for row in rows(instants) {
            let states = demands.part(row).gathered();
            part.iter_mut().for_each(|place| place.take(&states));
        }
    };
    let cores = rayon::current_num_threads();
    let [wall, base] = places;
    take(base.iter_mut().collect());
    // In turn: those under the liquid have a pressure and take longer.
    let mut shares: Vec<Vec<_>> = (0..cores.min(wall.len())).map(|_| Vec::new()).collect();
    for (i, place) in wall.iter_mut().enumerate() {
        shares[i % cores].push(place);
    }
    shares.into_par_iter().for_each(take);
}
