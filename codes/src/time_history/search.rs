//! The instant, height and angle at which a demand is largest against its capacity.
//!
//! A place keeps the extremes of its fields by blocks of instants ([`Extremes`]), not their histories. They bound what a block can hold
//! under the motion times any factor; the histories are combined again in the blocks that can govern. What is found is what a search
//! of all instants finds, to the last bit: the first instant and place of the largest utilisation.
//!
//! Sixteen blocks are a row, whose extremes pass over all of them at once.

mod at_base;
mod compression;
mod floors;
mod membrane;

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use tank::demand::{Angles, Demands, OnWall, Part, Place, Terms};

use super::field::{
    Direction, Extremes, Factors, Field, Pair, SIDES, Span, Wanted, block_of, blocks_of, factored, instants, rows,
};
use at_base::AtBase;
use membrane::Membrane;

pub(super) use compression::Capacity;
pub(super) use floors::{Floors, Shelf};

/// Steps of the angle from 0 to 180° where a utilisation is not linear in cos θ.
const STEPS: usize = 12;

/// Parts of the circumference where it is searched under motion along x and y: between two of them the amplitude of a harmonic
/// varies by 0.1 %.
const FAN: usize = 72;

/// The directions in which demands are searched where the sides do not suffice.
pub(super) fn directions(demands: &Demands) -> Vec<Direction> {
    let along = |i: usize| ((PI * i as f64 / STEPS as f64).cos(), 0.0);
    let around = |i: usize| {
        let angle = TAU * i as f64 / FAN as f64;
        (angle.cos(), angle.sin())
    };
    match demands.angles {
        Angles::All if !demands.transverse.is_empty() => (0..FAN).map(around).collect(),
        Angles::All => (0..=STEPS).map(along).collect(),
        Angles::Sides => SIDES.to_vec(),
    }
}

/// Where a demand is largest against its capacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Found {
    /// demand / capacity; infinite without a positive capacity.
    pub(super) utilisation: f64,
    /// Demand in SI.
    pub(super) demand: f64,
    /// The same in the static state.
    pub(super) rest: f64,
    /// Capacity in SI.
    pub(super) capacity: f64,
    /// Number of the instant.
    pub(super) instant: usize,
    /// Place on the circumference.
    pub(super) direction: Direction,
}

impl Found {
    /// The same with its direction turned by an angle [rad].
    pub(super) fn turned(self, angle: f64) -> Found {
        let ((c, s), (sine, cosine)) = (self.direction, angle.sin_cos());
        if angle == 0.0 { self } else { Found { direction: (c * cosine - s * sine, s * cosine + c * sine), ..self } }
    }
}

/// demand / capacity; infinite without a capacity.
fn ratio(demand: f64, capacity: f64) -> f64 {
    match (demand > 0.0, capacity > 0.0) {
        (false, _) => 0.0,
        (true, true) => demand / capacity,
        (true, false) => f64::INFINITY,
    }
}

/// What rounding may add to a bound of a square or a ratio, relative to it.
const ROUNDING: f64 = 1e-11;

/// σ² of von Mises in plane stress without shear.
fn mises_squared(a: f64, b: f64) -> f64 {
    a * a + b * b - a * b
}

/// Equivalent stress of von Mises of two normal stresses [Pa].
pub(super) fn mises(a: f64, b: f64) -> f64 {
    mises_squared(a, b).max(0.0).sqrt()
}

/// The largest σ² of von Mises of two normal stresses in ranges, with the square of a shear stress.
fn most_squared((a, b): (f64, f64), (c, d): (f64, f64), shear: f64) -> f64 {
    // Convex in both stresses: largest at a corner.
    let corners = [(a, c), (a, d), (b, c), (b, d)].map(|(hoop, axial)| mises_squared(hoop, axial));
    (corners.into_iter().fold(0.0, f64::max) + 3.0 * shear) * (1.0 + ROUNDING)
}

/// Ranges of cos θ whose equivalent stresses are bounded apart.
const PARTS: [(f64, f64); 5] = [(-1.0, -0.8), (-0.8, -0.4), (-0.4, 0.4), (0.4, 0.8), (0.8, 1.0)];

/// A place on the wall, ready to be searched under the motion times any factor.
pub(super) struct Searched<'a> {
    demands: &'a Demands,
    pub(super) place: &'a Place,
    /// Thickness as built, which the engine has, over what corrosion leaves: membrane stresses grow with it, bending with its square.
    lost: f64,
    hoop: Extremes,
    axial: Extremes,
    pressure: Option<Pressed>,
    shear: Option<Extremes>,
    base: Option<AtBase>,
}

/// The pressure at a place.
struct Pressed {
    extremes: Extremes,
    /// The axial stress by the pressure.
    axial: Pair,
}

/// About how large a combination becomes.
///
/// * `peaks`: largest absolute value of each state
fn size(terms: &Terms, peaks: &[f64]) -> f64 {
    let of = |&(state, factor): &(usize, f64)| factor.abs() * peaks.get(state).copied().unwrap_or(0.0);
    terms.iter().map(of).sum()
}

impl<'a> Searched<'a> {
    /// Places without any instant of the wall as corrosion leaves it, or as the engine has it without.
    ///
    /// * `lost`: thickness as built over that left
    /// * `peaks`: largest absolute value of each state
    pub(super) fn new(demands: &'a Demands, place: &'a Place, lost: f64, peaks: &[f64]) -> Searched<'a> {
        let of = |field: &OnWall, stress: f64| {
            Extremes::new(field.rest * stress, !field.even.is_empty(), demands.times.len())
        };
        Searched {
            hoop: of(&place.hoop, lost),
            axial: of(&place.axial, lost),
            pressure: place.pressure.as_ref().map(|pressure| Pressed {
                extremes: of(pressure, 1.0),
                axial: Pair::new(
                    lost * size(&place.axial.odd, peaks) / size(&pressure.odd, peaks),
                    demands.times.len(),
                ),
            }),
            shear: { place.shear.as_ref() }.map(|_| Extremes::new(0.0, false, demands.times.len())),
            base: None,
            demands,
            place,
            lost,
        }
    }

    /// Adds the next instants, one of [`super::field::rows`].
    pub(super) fn take(&mut self, states: &Part<'_>) {
        let place = self.place;
        let factors = |stress: f64| Factors { stress, motion: 1.0 };
        let on_wall = |of, stress: f64| Wanted::on_wall(of, factors(stress));
        let mut wanted = vec![on_wall(&place.hoop, self.lost), on_wall(&place.axial, self.lost)];
        wanted.extend(place.pressure.as_ref().map(|of| on_wall(of, 1.0)));
        wanted.extend({ place.shear.as_ref() }.map(|terms| Wanted::amplitude(terms, factors(self.lost))));
        let fields = Field::parts(states, &wanted);
        let [hoop, axial, rest @ ..] = fields.as_slice() else { return };
        let mut rest = rest.iter();
        self.hoop.take(hoop);
        self.axial.take(axial);
        if let Some((pressed, pressure)) = self.pressure.as_mut().and_then(|pressed| Some((pressed, rest.next()?))) {
            pressed.extremes.take(pressure);
            pressed.axial.take(axial, pressure);
        }
        if let Some((shear, of)) = self.shear.as_mut().zip(rest.next()) {
            shear.take_amplitude(of);
        }
    }

    /// Adds what the range of the stress with bending at the base needs, where the engine gives it.
    ///
    /// * `poisson`: Poisson's ratio of the wall
    /// * `directions`: those of [`directions`]
    #[must_use]
    pub(super) fn bent(self, poisson: f64, directions: &[Direction]) -> Searched<'a> {
        let (demands, place, lost) = (self.demands, self.place, self.lost);
        let Some(bending) = place.bending.as_ref().filter(|_| place.z == 0.0) else { return self };
        let whole = |of: &OnWall, stress: f64| Field::whole(demands, of, Factors { stress, motion: 1.0 });
        let (axial, hoop) = (whole(&place.axial, lost), whole(&place.hoop, lost));
        let bending = whole(bending, lost * lost);
        let directions = if hoop.turns() { directions } else { &SIDES };
        Searched { base: AtBase::of([&axial, &hoop, &bending], poisson, directions), ..self }
    }

    /// The place under the motion times a positive factor.
    pub(super) fn under<'b>(&'b self, factor: f64, directions: &'b [Direction]) -> Search<'b> {
        Search { at: self, factor, directions, block: None }
    }
}

/// A search at one place under the motion times a factor.
///
/// Every search takes the utilisation `above` which alone its result counts: blocks that cannot exceed it are passed over, and what is
/// found below it need not be the largest.
pub(super) struct Search<'a> {
    at: &'a Searched<'a>,
    factor: f64,
    directions: &'a [Direction],
    /// The one block that is searched; none searches all.
    block: Option<usize>,
}

impl Search<'_> {
    /// The same in the block of an instant alone.
    pub(super) fn near(self, instant: usize) -> Self {
        Search { block: Some(block_of(instant)), ..self }
    }

    /// Height above the base [m].
    pub(super) fn height(&self) -> f64 {
        self.at.place.z
    }

    /// Number of the course, from 0.
    pub(super) fn course(&self) -> usize {
        self.at.place.course
    }

    fn count(&self) -> usize {
        self.at.demands.times.len()
    }

    /// Takes each block that is searched, in the order of time, where its row and it may hold more than what is found.
    fn blocks<T>(&self, found: &mut T, may: impl Fn(&T, Span) -> bool, take: impl Fn(&mut T, usize)) {
        let count = self.count();
        let one = |found: &mut T, block: usize| {
            if may(found, Span::Block(block)) {
                take(found, block);
            }
        };
        if let Some(block) = self.block {
            return one(found, block);
        }
        for row in 0..rows(count).len() {
            if may(found, Span::Row(row)) {
                blocks_of(row, count).for_each(|block| one(found, block));
            }
        }
    }

    /// Instants of a block.
    fn instants(&self, block: usize) -> Range<usize> {
        instants(block, self.count())
    }

    fn part(&self, of: &OnWall, stress: f64, block: usize) -> Field {
        let factors = Factors { stress, motion: self.factor };
        Field::part(&self.at.demands.part(self.instants(block)), of, factors)
    }

    fn hoop(&self, block: usize) -> Field {
        self.part(&self.at.place.hoop, self.at.lost, block)
    }

    fn axial(&self, block: usize) -> Field {
        self.part(&self.at.place.axial, self.at.lost, block)
    }

    fn pressure(&self, block: usize) -> Option<Field> {
        let pressure = self.at.place.pressure.as_ref();
        pressure.map(|of| self.part(of, 1.0, block))
    }

    fn membrane(&self, block: usize) -> Membrane {
        let (demands, shear) = (self.at.demands, self.at.place.shear.as_ref());
        let factors = Factors { stress: self.at.lost, motion: self.factor };
        let part = demands.part(self.instants(block));
        let transverse = shear.and_then(|terms| part.transverse(terms));
        Membrane {
            hoop: self.hoop(block),
            axial: self.axial(block),
            shear: shear.map(|terms| factored(part.history(terms), factors)),
            transverse_shear: transverse.map(|values| factored(values, factors)),
        }
    }

    /// Hoop tension against a capacity. It is linear in cos θ: the sides govern.
    pub(super) fn hoop_tension(&self, capacity: f64, above: f64) -> Option<Found> {
        let field = |block: usize| self.hoop(block);
        self.tension((&self.at.hoop, &field), capacity, above)
    }

    /// Axial tension against a capacity.
    pub(super) fn axial_tension(&self, capacity: f64, above: f64) -> Option<Found> {
        let field = |block: usize| self.axial(block);
        self.tension((&self.at.axial, &field), capacity, above)
    }

    fn tension(
        &self,
        (extremes, field): (&Extremes, &dyn Fn(usize) -> Field),
        capacity: f64,
        above: f64,
    ) -> Option<Found> {
        let bound = |span: Span| extremes.bounds(span, self.factor).1;
        let counts = |bound: f64| ratio(bound, capacity) > above;
        if !counts(bound(Span::All)) {
            return None;
        }
        let mut largest: Option<(usize, Direction, f64)> = None;
        let may = |largest: &Option<(usize, Direction, f64)>, span: Span| {
            let bound = bound(span);
            largest.is_none_or(|(_, _, most)| bound > most) && counts(bound)
        };
        self.blocks(&mut largest, may, |largest, block| {
            let (field, start) = (field(block), self.instants(block).start);
            for k in 0..field.len() {
                for direction in field.ends(k) {
                    let value = field.at(k, direction);
                    if largest.is_none_or(|(_, _, most)| value.total_cmp(&most).is_gt()) {
                        *largest = Some((start + k, direction, value));
                    }
                }
            }
        });
        let (instant, direction, demand) = largest?;
        let demand = demand.max(0.0);
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: extremes.rest.max(0.0),
            capacity,
            instant,
            direction,
        })
    }

    /// What σ² of von Mises can be at most in some instants.
    fn equivalent_bound(&self, span: Span) -> f64 {
        let bounds = |of: &Extremes| of.bounds(span, self.factor);
        let shear = self.at.shear.as_ref().map_or(0.0, |shear| bounds(shear).1);
        most_squared(bounds(&self.at.hoop), bounds(&self.at.axial), shear * shear)
    }

    /// The same part by part of the circumference, without a motion along y: closer, and dearer.
    fn closer_bound(&self, span: Span) -> f64 {
        let shear = self.at.shear.as_ref();
        let shear = shear.map_or(0.0, |shear| shear.bounds(span, self.factor).1);
        let [hoop, axial] = [&self.at.hoop, &self.at.axial].map(|of| of.fan(span, self.factor));
        let of = |part: (f64, f64)| {
            // The shear goes with the sine.
            let nearest = if part.0 * part.1 < 0.0 { 0.0 } else { part.0.abs().min(part.1.abs()) };
            let squared = shear * shear * (1.0 - nearest * nearest);
            most_squared(hoop.within(part), axial.within(part), squared)
        };
        PARTS.into_iter().map(of).fold(0.0, f64::max)
    }

    /// Equivalent membrane stress against a capacity. With a motion along y it is searched around the circumference.
    pub(super) fn equivalent(&self, capacity: f64, above: f64) -> Option<Found> {
        let turns = !self.at.demands.transverse.is_empty();
        let counts = |most: f64, bound: f64| bound > most && ratio(bound.sqrt(), capacity) > above;
        let may = |worst: &Option<(usize, Direction, f64)>, span: Span| {
            let most = worst.map_or(f64::NEG_INFINITY, |w| w.2);
            counts(most, self.equivalent_bound(span)) && (turns || counts(most, self.closer_bound(span)))
        };
        let mut worst: Option<(usize, Direction, f64)> = None;
        if !may(&worst, Span::All) {
            return None;
        }
        self.blocks(&mut worst, may, |worst, block| {
            let (membrane, start) = (self.membrane(block), self.instants(block).start);
            for k in 0..membrane.hoop.len() {
                let most = worst.map_or(f64::NEG_INFINITY, |w| w.2);
                if !turns {
                    let (squared, cosine) = membrane.largest(k);
                    if squared > most {
                        *worst = Some((start + k, (cosine, 0.0), squared));
                    }
                } else if membrane.bound(k) > most {
                    for &direction in self.directions {
                        let squared = membrane.squared(k, direction);
                        if worst.is_none_or(|w| squared > w.2) {
                            *worst = Some((start + k, direction, squared));
                        }
                    }
                }
            }
        });
        let (instant, direction, squared) = worst?;
        // Near a hint the coarse one is reached in any case.
        let (direction, squared) = match turns && self.block.is_none() {
            true => self.finer(instant, direction),
            false => (direction, squared),
        };
        let demand = squared.sqrt();
        let (place, lost) = (self.at.place, self.at.lost);
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: mises(place.hoop.rest * lost, place.axial.rest * lost),
            capacity,
            instant,
            direction,
        })
    }

    /// The direction of the largest equivalent stress near a coarse one, and its square.
    fn finer(&self, instant: usize, coarse: Direction) -> (Direction, f64) {
        let block = block_of(instant);
        let (membrane, k) = (self.membrane(block), instant - self.instants(block).start);
        let step = TAU / FAN as f64 / 50.0;
        let finer = (-50..=50).map(|i| {
            let theta = coarse.1.atan2(coarse.0) + f64::from(i) * step;
            (theta.cos(), theta.sin())
        });
        let of = |direction: Direction| (direction, membrane.squared(k, direction));
        finer.map(of).fold(of(coarse), |best, next| if next.1 > best.1 { next } else { best })
    }

    /// Interior pressure at an instant and a place on the circumference [Pa].
    pub(super) fn pressure_at(&self, instant: usize, direction: Direction) -> f64 {
        let block = block_of(instant);
        let start = self.instants(block).start;
        self.pressure(block).map_or(0.0, |p| p.at(instant - start, direction))
    }

    /// Range of the equivalent stress of a face from the empty tank and between the extremes of its meridional stress, against a
    /// capacity; at the base.
    ///
    /// The bending of a clamped edge brings ν σ_b of hoop stress.
    pub(super) fn range_at_base(&self, capacity: f64) -> Option<Found> {
        self.at.base.as_ref()?.range(self.factor, capacity)
    }
}
