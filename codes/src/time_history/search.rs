//! The instant, height and angle at which a demand is largest against its capacity.

use std::f64::consts::PI;

use tank::demand::{Angles, Demands, OnWall, Place};

/// Steps of the angle from 0 to 180° where a utilisation is not linear in cos θ.
const STEPS: usize = 12;

/// A quantity of one place over time: rest + even(t) + odd(t) cos θ.
pub(super) struct Field {
    pub(super) rest: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
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
        }
    }

    /// The field times a factor.
    fn times(mut self, factor: f64) -> Field {
        self.rest *= factor;
        scale(&mut self.even, factor);
        scale(&mut self.odd, factor);
        self
    }

    /// Value at instant `k` and cos θ = `c`.
    pub(super) fn at(&self, k: usize, c: f64) -> f64 {
        self.rest + self.even.get(k).copied().unwrap_or(0.0) + c * self.odd[k]
    }

    /// Smallest and largest value over time and circumference.
    fn range(&self) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..self.odd.len() {
            for value in [self.at(k, 1.0), self.at(k, -1.0)] {
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
    /// Meridional bending stress at the outer face [Pa], at the base where known.
    pub(super) bending: Option<Field>,
    /// cos θ of the angles.
    cosines: Vec<f64>,
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
    /// cos θ.
    pub(super) cosine: f64,
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

impl Histories {
    /// The same forces in a corroded wall: membrane stresses grow with the thickness that is lost, bending with its square.
    ///
    /// * `lost`: thickness as built, which the engine has, over that left
    pub(super) fn corroded(mut self, lost: f64) -> Histories {
        self.hoop = self.hoop.times(lost);
        self.axial = self.axial.times(lost);
        self.bending = self.bending.map(|bending| bending.times(lost * lost));
        if let Some(shear) = &mut self.shear {
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
            bending: match (&place.bending, place.z == 0.0) {
                (Some(bending), true) => Some(Field::new(demands, bending)),
                _ => None,
            },
            cosines: match demands.angles {
                Angles::All => (0..=STEPS).map(|i| (PI * i as f64 / STEPS as f64).cos()).collect(),
                Angles::Sides => vec![1.0, -1.0],
            },
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
        let largest = |k: usize| (sign * field.at(k, 1.0)).max(sign * field.at(k, -1.0));
        let instant = (0..self.len()).max_by(|&i, &j| largest(i).total_cmp(&largest(j)).then(j.cmp(&i)))?;
        let cosine = match sign * field.at(instant, 1.0) >= sign * field.at(instant, -1.0) {
            true => 1.0,
            false => -1.0,
        };
        let demand = largest(instant).max(0.0);
        Some(Found {
            utilisation: ratio(demand, capacity),
            demand,
            rest: (sign * field.rest).max(0.0),
            capacity,
            instant,
            cosine,
        })
    }

    /// Equivalent membrane stress against a capacity.
    ///
    /// ```text
    /// σ²(c) = σ_θ² + σ_z² − σ_θ σ_z + 3 τ² (1 − c²)        σ_θ, σ_z linear in c = cos θ
    /// ```
    ///
    /// is a parabola in c: the largest value is at a side or at its vertex.
    pub(super) fn equivalent(&self, capacity: f64) -> Option<Found> {
        let at = |k: usize| -> (f64, f64) {
            let [front, back] = [1.0, -1.0].map(|c| mises_squared(self.hoop.at(k, c), self.axial.at(k, c)));
            let sides = if front >= back { (front, 1.0) } else { (back, -1.0) };
            let Some(shear) = &self.shear else { return sides };
            let middle = mises_squared(self.hoop.at(k, 0.0), self.axial.at(k, 0.0)) + 3.0 * shear[k] * shear[k];
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
            cosine,
        })
    }

    /// Interior pressure at an instant and cos θ [Pa].
    pub(super) fn pressure_at(&self, k: usize, c: f64) -> f64 {
        self.pressure.as_ref().map_or(0.0, |p| p.at(k, c))
    }

    /// Axial compression against a capacity that depends on the interior pressure of the same instant and place, monotonously: at no
    /// pressure of the range is it below both ends.
    pub(super) fn compression(&self, capacity: impl Fn(f64) -> f64) -> Option<Found> {
        let (low, high) = self.pressure.as_ref().map_or((0.0, 0.0), Field::range);
        let floor = capacity(low).min(capacity(high));
        let compression = |k: usize, c: f64| -self.axial.at(k, c);
        let bound = |k: usize| ratio(compression(k, 1.0).max(compression(k, -1.0)), floor);
        let exact = |k: usize| -> Option<Found> {
            let all = self.cosines.iter().map(|&cosine| {
                let demand = compression(k, cosine).max(0.0);
                let capacity = capacity(self.pressure_at(k, cosine));
                Found {
                    utilisation: ratio(demand, capacity),
                    demand,
                    rest: (-self.axial.rest).max(0.0),
                    capacity,
                    instant: k,
                    cosine,
                }
            });
            all.reduce(|best, found| {
                if found.utilisation > best.utilisation {
                    found
                } else {
                    best
                }
            })
        };
        let first = (0..self.len()).max_by(|&i, &j| bound(i).total_cmp(&bound(j)).then(j.cmp(&i)))?;
        let mut best = exact(first)?;
        for k in 0..self.len() {
            if bound(k) <= best.utilisation {
                continue;
            }
            best = exact(k)
                .filter(|found| found.utilisation > best.utilisation)
                .unwrap_or(best);
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
        for cosine in [1.0, -1.0] {
            for face in [1.0, -1.0] {
                let state = |k: usize| {
                    let b = face * bending.at(k, cosine);
                    (self.axial.at(k, cosine) + b, self.hoop.at(k, cosine) + poisson * b)
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
                            cosine,
                        });
                    }
                }
            }
        }
        worst
    }
}
