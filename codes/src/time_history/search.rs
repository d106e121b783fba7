//! The instant, height and angle at which a demand is largest against its capacity.

use std::cell::OnceCell;
use std::f64::consts::{PI, TAU};

use tank::demand::{Angles, Demands, OnWall, Place};

/// Steps of the angle from 0 to 180° where a utilisation is not linear in cos θ.
const STEPS: usize = 12;

/// Parts of the circumference where it is searched under motion along x and y: between two of them the amplitude of a harmonic
/// varies by 0.1 %.
const FAN: usize = 72;

/// The directions of a search around the circumference.
fn around() -> Vec<Direction> {
    let angle = |i: usize| TAU * i as f64 / FAN as f64;
    (0..FAN).map(|i| (angle(i).cos(), angle(i).sin())).collect()
}

/// cos θ and sin θ of a place on the circumference. Without a motion along y the sine has no effect and is 0.
pub(super) type Direction = (f64, f64);

/// θ = 0 and 180°.
const SIDES: [Direction; 2] = [(1.0, 0.0), (-1.0, 0.0)];

/// Angle of a direction [rad], from 0 to 2 π.
pub(super) fn angle((cosine, sine): Direction) -> f64 {
    match sine == 0.0 {
        true => cosine.clamp(-1.0, 1.0).acos(),
        false => sine.atan2(cosine).rem_euclid(TAU),
    }
}

/// A quantity of one place over time: rest + even(t) + odd(t) cos θ + transverse(t) sin θ.
pub(super) struct Field {
    pub(super) rest: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
    /// Part of the motion along y; none without one.
    transverse: Option<Vec<f64>>,
}

impl Field {
    pub(super) fn new(demands: &Demands, of: &OnWall) -> Field {
        Field {
            rest: of.rest,
            even: match of.even.is_empty() {
                true => Vec::new(),
                false => demands.history(&of.even),
            },
            odd: demands.history(&of.odd),
            transverse: demands.transverse(&of.odd),
        }
    }

    /// The field times a factor.
    fn times(mut self, factor: f64) -> Field {
        self.rest *= factor;
        scale(&mut self.even, factor);
        scale(&mut self.odd, factor);
        if let Some(transverse) = &mut self.transverse {
            scale(transverse, factor);
        }
        self
    }

    /// Value at instant `k` in the direction (`c`, `s`).
    pub(super) fn at(&self, k: usize, (c, s): Direction) -> f64 {
        let along = self.rest + self.even.get(k).copied().unwrap_or(0.0) + c * self.odd[k];
        match &self.transverse {
            Some(transverse) => along + s * transverse[k],
            None => along,
        }
    }

    /// The directions of the largest and the smallest value at instant `k`.
    fn ends(&self, k: usize) -> [Direction; 2] {
        let Some(transverse) = &self.transverse else {
            return SIDES;
        };
        let (x, y) = (self.odd[k], transverse[k]);
        match x.hypot(y) {
            size if size > 0.0 => [(x / size, y / size), (-x / size, -y / size)],
            _ => SIDES,
        }
    }

    /// Largest absolute value that it can have at instant `k`.
    fn bound(&self, k: usize) -> f64 {
        let ends = self.ends(k).map(|at| self.at(k, at).abs());
        ends[0].max(ends[1])
    }

    /// Smallest and largest value over time and circumference.
    fn range(&self) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..self.odd.len() {
            for direction in self.ends(k) {
                let value = self.at(k, direction);
                range = (range.0.min(value), range.1.max(value));
            }
        }
        range
    }
}

/// The histories of a place.
pub(super) struct Histories {
    /// Hoop membrane stress [Pa].
    pub(super) hoop: Field,
    /// Axial membrane stress [Pa].
    pub(super) axial: Field,
    /// Pressure of the liquid [Pa]; none above it.
    pub(super) pressure: Option<Field>,
    /// Amplitude of the shear stress at θ = 90° [Pa], where known.
    shear: Option<Vec<f64>>,
    /// The same of the motion along y, at θ = 180°.
    transverse_shear: Option<Vec<f64>>,
    /// Meridional bending stress at the outer face [Pa], at the base where known.
    pub(super) bending: Option<Field>,
    /// The angles.
    directions: Vec<Direction>,
    /// What the searches for compression share.
    compressed: OnceCell<Compressed>,
}

/// What the searches for compression share: they differ in their capacities alone.
struct Compressed {
    /// Largest compression around the circumference, instant by instant [Pa].
    largest: Vec<f64>,
    /// Number of the instant of the largest one.
    first: usize,
    /// Smallest and largest interior pressure [Pa].
    pressure: (f64, f64),
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
        match angle == 0.0 {
            true => self,
            false => Found {
                direction: (c * cosine - s * sine, s * cosine + c * sine),
                ..self
            },
        }
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

/// σ² of von Mises in plane stress without shear.
fn mises_squared(a: f64, b: f64) -> f64 {
    a * a + b * b - a * b
}

/// Equivalent stress of von Mises of two normal stresses [Pa].
pub(super) fn mises(a: f64, b: f64) -> f64 {
    mises_squared(a, b).max(0.0).sqrt()
}

fn scale(values: &mut [f64], factor: f64) {
    if factor != 1.0 {
        values.iter_mut().for_each(|value| *value *= factor);
    }
}

/// Lower bounds of a capacity that depends monotonously on the pressure: the smaller value at the ends of each of some parts of its range.
struct Floors {
    low: f64,
    /// Parts for each pascal; 0 for a single pressure.
    per_pascal: f64,
    parts: [f64; PARTS],
    lowest: f64,
}

/// Parts of the range of the pressure: few enough to fill for every place, many enough that a bound is within some per cent.
const PARTS: usize = 48;

impl Floors {
    fn new((low, high): (f64, f64), capacity: impl Fn(f64) -> f64) -> Floors {
        let width = high - low;
        let lowest = capacity(low).min(capacity(high));
        if !(width > 0.0 && width.is_finite()) {
            return Floors {
                low,
                per_pascal: 0.0,
                parts: [lowest; PARTS],
                lowest,
            };
        }
        let mut before = capacity(low);
        let parts = std::array::from_fn(|i| {
            let after = capacity(low + width * (i + 1) as f64 / PARTS as f64);
            let floor = before.min(after);
            before = after;
            floor
        });
        Floors {
            low,
            per_pascal: PARTS as f64 / width,
            parts,
            lowest,
        }
    }

    /// At a pressure; next to an edge, where rounding decides, the smaller of both parts.
    fn at(&self, pressure: f64) -> f64 {
        let place = (pressure - self.low) * self.per_pascal;
        let part = |place: f64| self.parts[(place.max(0.0) as usize).min(PARTS - 1)];
        part(place - 1e-9).min(part(place + 1e-9))
    }
}

impl Histories {
    /// The same forces in a corroded wall: membrane stresses grow with the thickness that is lost, bending with its square.
    ///
    /// * `lost`: thickness as built, which the engine has, over that left
    pub(super) fn corroded(mut self, lost: f64) -> Histories {
        self.hoop = self.hoop.times(lost);
        self.axial = self.axial.times(lost);
        self.bending = self.bending.map(|bending| bending.times(lost * lost));
        self.compressed = OnceCell::new();
        for shear in [&mut self.shear, &mut self.transverse_shear].into_iter().flatten() {
            scale(shear, lost);
        }
        self
    }

    pub(super) fn new(demands: &Demands, place: &Place) -> Histories {
        Histories {
            hoop: Field::new(demands, &place.hoop),
            axial: Field::new(demands, &place.axial),
            pressure: place.pressure.as_ref().map(|p| Field::new(demands, p)),
            shear: place.shear.as_ref().map(|terms| demands.history(terms)),
            transverse_shear: place.shear.as_ref().and_then(|terms| demands.transverse(terms)),
            bending: match (&place.bending, place.z == 0.0) {
                (Some(bending), true) => Some(Field::new(demands, bending)),
                _ => None,
            },
            directions: match demands.angles {
                Angles::All if !demands.transverse.is_empty() => around(),
                Angles::All => (0..=STEPS)
                    .map(|i| ((PI * i as f64 / STEPS as f64).cos(), 0.0))
                    .collect(),
                Angles::Sides => SIDES.to_vec(),
            },
            compressed: OnceCell::new(),
        }
    }

    fn len(&self) -> usize {
        self.hoop.odd.len()
    }

    /// Hoop tension against a capacity. It is linear in cos θ: the sides govern.
    pub(super) fn hoop_tension(&self, capacity: f64) -> Option<Found> {
        self.of_sides(&self.hoop, 1.0, capacity)
    }

    /// Axial tension against a capacity.
    pub(super) fn axial_tension(&self, capacity: f64) -> Option<Found> {
        self.of_sides(&self.axial, 1.0, capacity)
    }

    fn of_sides(&self, field: &Field, sign: f64, capacity: f64) -> Option<Found> {
        let mut largest: Option<(usize, Direction, f64)> = None;
        for k in 0..self.len() {
            for direction in field.ends(k) {
                let value = sign * field.at(k, direction);
                if largest.is_none_or(|(_, _, most)| value.total_cmp(&most).is_gt()) {
                    largest = Some((k, direction, value));
                }
            }
        }
        let (instant, direction, demand) = largest?;
        let demand = demand.max(0.0);
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: (sign * field.rest).max(0.0),
            capacity,
            instant,
            direction,
        })
    }

    /// Equivalent membrane stress against a capacity.
    ///
    /// ```text
    /// σ²(c) = σ_θ² + σ_z² − σ_θ σ_z + 3 τ² (1 − c²)        σ_θ, σ_z linear in c = cos θ
    /// ```
    ///
    /// is a parabola in c: the largest value is at a side or at its vertex. With a motion along y it is searched around the
    /// circumference.
    pub(super) fn equivalent(&self, capacity: f64) -> Option<Found> {
        if self.hoop.transverse.is_some() {
            return self.equivalent_around(capacity);
        }
        let at = |k: usize| -> (f64, f64) {
            let [front, back] = SIDES.map(|side| mises_squared(self.hoop.at(k, side), self.axial.at(k, side)));
            let sides = if front >= back { (front, 1.0) } else { (back, -1.0) };
            let Some(shear) = &self.shear else { return sides };
            let across = (0.0, 0.0);
            let middle = mises_squared(self.hoop.at(k, across), self.axial.at(k, across)) + 3.0 * shear[k] * shear[k];
            let (curvature, slope) = (0.5 * (front + back) - middle, 0.5 * (front - back));
            let vertex = -0.5 * slope / curvature;
            if curvature < 0.0 && vertex.abs() < 1.0 {
                (middle - 0.25 * slope * slope / curvature, vertex)
            } else {
                sides
            }
        };
        let mut worst: Option<(usize, (f64, f64))> = None;
        for k in 0..self.len() {
            let found = at(k);
            if worst.is_none_or(|(_, w)| found.0 > w.0) {
                worst = Some((k, found));
            }
        }
        let (instant, (squared, cosine)) = worst?;
        let demand = squared.sqrt();
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: mises(self.hoop.rest, self.axial.rest),
            capacity,
            instant,
            direction: (cosine, 0.0),
        })
    }

    /// [`Histories::equivalent`] under motion along x and y: every [`FAN`]th part of the circumference at the instants that can
    /// govern, then finer around the largest.
    fn equivalent_around(&self, capacity: f64) -> Option<Found> {
        let of = |of: &Option<Vec<f64>>, k: usize| of.as_ref().map_or(0.0, |shear| shear[k]);
        let squared = |k: usize, direction: Direction| {
            let (c, s) = direction;
            // The shear of a motion along y is turned by 90°: sin(θ − 90°) = −cos θ.
            let shear = s * of(&self.shear, k) - c * of(&self.transverse_shear, k);
            mises_squared(self.hoop.at(k, direction), self.axial.at(k, direction)) + 3.0 * shear * shear
        };
        let bound = |k: usize| {
            let (a, b) = (self.hoop.bound(k), self.axial.bound(k));
            let shear = of(&self.shear, k).hypot(of(&self.transverse_shear, k));
            a * a + b * b + a * b + 3.0 * shear * shear
        };
        let mut worst = (0, (1.0, 0.0), f64::NEG_INFINITY);
        for k in 0..self.len() {
            if bound(k) <= worst.2 {
                continue;
            }
            for &direction in &self.directions {
                let found = squared(k, direction);
                if found > worst.2 {
                    worst = (k, direction, found);
                }
            }
        }
        let (instant, coarse, _) = worst;
        if self.len() == 0 {
            return None;
        }
        let step = TAU / FAN as f64 / 50.0;
        let finer = (-50..=50).map(|i| {
            let theta = coarse.1.atan2(coarse.0) + f64::from(i) * step;
            (theta.cos(), theta.sin())
        });
        let direction = finer.fold(coarse, |best, next| {
            match squared(instant, next) > squared(instant, best) {
                true => next,
                false => best,
            }
        });
        let demand = squared(instant, direction).sqrt();
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: mises(self.hoop.rest, self.axial.rest),
            capacity,
            instant,
            direction,
        })
    }

    /// Interior pressure at an instant and a place on the circumference [Pa].
    pub(super) fn pressure_at(&self, k: usize, direction: Direction) -> f64 {
        self.pressure.as_ref().map_or(0.0, |p| p.at(k, direction))
    }

    fn compressed(&self) -> Compressed {
        let of = |k: usize| {
            let [one, other] = self.axial.ends(k).map(|at| -self.axial.at(k, at));
            one.max(other)
        };
        let largest: Vec<f64> = (0..self.len()).map(of).collect();
        let first = (0..largest.len()).fold(0, |best, k| if largest[k] > largest[best] { k } else { best });
        Compressed {
            first,
            pressure: self.pressure.as_ref().map_or((0.0, 0.0), Field::range),
            largest,
        }
    }

    /// Axial compression against a capacity that depends on the interior pressure of the same instant and place, monotonously: at no
    /// pressure of the range is it below both ends.
    pub(super) fn compression(&self, capacity: impl Fn(f64) -> f64) -> Option<Found> {
        let Compressed {
            largest,
            first,
            pressure,
        } = self.compressed.get_or_init(|| self.compressed());
        let floors = Floors::new(*pressure, &capacity);
        let floor = floors.lowest;
        let compression = |k: usize, at: Direction| -self.axial.at(k, at);
        let at = |k: usize, direction: Direction| {
            let demand = compression(k, direction).max(0.0);
            let capacity = capacity(self.pressure_at(k, direction));
            Found {
                utilisation: ratio(demand, capacity),
                demand,
                rest: (-self.axial.rest).max(0.0),
                capacity,
                instant: k,
                direction,
            }
        };
        let places = |k: usize| {
            let own = self.axial.transverse.as_ref().map(|_| self.axial.ends(k));
            self.directions.iter().copied().chain(own.into_iter().flatten())
        };
        // Capacity is dear: it is asked for where its lower bound, of the run and then of the pressure, leaves more than has been found.
        if self.len() == 0 {
            return None;
        }
        // Where no capacity is left at some pressure, the first compression decides, not the largest.
        let first = match floor > 0.0 {
            true => *first,
            false => largest.iter().position(|c| *c > 0.0).unwrap_or(0),
        };
        let mut best = at(first, places(first).next()?);
        for k in std::iter::once(first).chain(0..self.len()) {
            if ratio(largest[k], floor) <= best.utilisation && k != first {
                continue;
            }
            for direction in places(k) {
                let floor = floors.at(self.pressure_at(k, direction));
                if ratio(compression(k, direction), floor) > best.utilisation {
                    let found = at(k, direction);
                    if found.utilisation > best.utilisation {
                        best = found;
                    }
                }
            }
        }
        Some(best)
    }

    /// Range of the equivalent stress of a face from the empty tank and between the extremes of its meridional stress, against a
    /// capacity; at the base.
    ///
    /// The bending of a clamped edge brings ν σ_b of hoop stress.
    pub(super) fn range_at_base(&self, poisson: f64, capacity: f64) -> Option<Found> {
        let bending = self.bending.as_ref()?;
        let mut worst: Option<Found> = None;
        let directions = match self.hoop.transverse {
            Some(_) => &self.directions[..],
            None => &SIDES,
        };
        for &direction in directions {
            for face in [1.0, -1.0] {
                let state = |k: usize| {
                    let b = face * bending.at(k, direction);
                    (
                        self.axial.at(k, direction) + b,
                        self.hoop.at(k, direction) + poisson * b,
                    )
                };
                let by_size = |i: &usize, j: &usize| state(*i).0.total_cmp(&state(*j).0);
                let (low, high) = ((0..self.len()).min_by(by_size)?, (0..self.len()).max_by(by_size)?);
                let (bottom, top) = (state(low), state(high));
                let range = mises(top.0 - bottom.0, top.1 - bottom.1);
                let pairs = [
                    (mises(bottom.0, bottom.1), low),
                    (mises(top.0, top.1), high),
                    (range, high),
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
                            direction,
                        });
                    }
                }
            }
        }
        worst
    }
}
