//! The bottom plate under the moving base: its deflection, and the pressure of the ground on it.
//!
//! ```text
//! rim     w(θ) = w₀ − ψ R cos θ + Σ U_n cos nφ    φ = θ − 180° where ψ > 0, else θ
//! strip   δ(x) of the rim's uplift w, under p + P cos θ: straight through those of p and of the lowest pressure
//! ground  r = k <−δ> + (p + P cos θ p_b(r)/p_b(R)) − p_s    where δ < 0, with p_s of the strip ;   0 off the ground
//! ```
//!
//! The strips carry the pressure at the rim all the way inwards; what the bottom carries there instead goes into the ground below. p_b(r) has the
//! form of the impulsive pressure in a rigid tank. A strip stands in the state of its first way up, also where the rim comes down again.

use ::base::{Base, Stands, Turn};
use results::{GroundPlan, Snapshot, Snapshots};

/// Uplifts at which the plate is kept, from the lowest to the highest.
const UPLIFTS: usize = 64;
/// Rotation from which the strips are drawn further and further [rad], and how often.
const FIRST: (f64, usize) = (1e-4, 60);
/// Radii of the plan, and how they crowd at the rim.
const RADII: (usize, f64) = (25, 2.5);
/// Angles of the plan from 0 to 180°.
const ANGLES: usize = 25;
/// Sectors of the states for pictures, those of the wall.
const SECTORS: usize = 48;
/// Rings of the states for pictures are not closer than this part of the radius, or than this part of their distance from the wall.
const CLOSEST: [f64; 2] = [1.0 / 300.0, 0.15];

/// An instant of the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Now {
    /// The base.
    pub turn: Turn,
    /// ψ, positive where θ = 0 goes down [rad].
    pub rotation: f64,
    /// P, the bottom pressure at the rim at θ = 0 over that at rest [Pa].
    pub pressure: f64,
    /// Slip [m].
    pub slip: f64,
}

/// A point of the plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Under {
    /// Distance inwards from the wall [m]; negative outside.
    pub distance: f64,
    /// Deflection, upwards [m].
    pub deflection: f64,
    /// Pressure of the ground [Pa].
    pub pressure: f64,
    /// Pressure of the liquid [Pa].
    pub liquid: f64,
}

/// Strips at all uplifts of a run.
pub(super) struct Floor {
    radius: f64,
    modulus: f64,
    rest: f64,
    /// How far the pressure of the lower strips is below that at rest [Pa].
    suction: f64,
    /// From the axis outwards [m].
    distances: Vec<f64>,
    /// p_b(r)/p_b(R) there; 0 outside the wall.
    shape: Vec<f64>,
    uplifts: Vec<f64>,
    /// Deflections at rest and under the lower pressure, by uplift [m].
    deflections: [Vec<Vec<f64>>; 2],
}

impl Floor {
    /// Floor of a base whose rim moves between two heights [m].
    ///
    /// * `most`: largest |P| [Pa]
    /// * `shape`: p_b(r)/p_b(R) by radius [m]
    ///
    /// None where a strip has no equilibrium there.
    pub(super) fn of(base: &Base, [from, to]: [f64; 2], most: f64, shape: &dyn Fn(f64) -> f64) -> Option<Floor> {
        let suction = most.min(::base::FOLLOWED * base.pressure);
        // Close where the rim leaves the ground.
        let root = |w: f64| w.signum() * w.abs().sqrt();
        let (low, high) = (root(from), root(to));
        let place = |i: usize| low + (high - low) * i as f64 / (UPLIFTS - 1) as f64;
        let mut uplifts: Vec<f64> = (0..UPLIFTS).map(|i| place(i) * place(i).abs()).collect();
        (uplifts[0], uplifts[UPLIFTS - 1]) = (from, to);
        let [(distances, high), (inner, low)] = [0.0, suction].map(|less| {
            let mut own = base.clone();
            own.pressure -= less;
            plates(own, &uplifts)
        });
        let low = low.iter().map(|plate| distances.iter().map(|x| along(&inner, plate, *x)).collect()).collect();
        (high.len() == UPLIFTS).then_some(())?;
        let floor = Floor {
            radius: base.radius,
            modulus: base.modulus,
            rest: base.pressure,
            suction,
            shape: distances.iter().map(|x| if *x < -1e-9 { 0.0 } else { shape(base.radius - x) }).collect(),
            distances,
            uplifts,
            deflections: [high, low],
        };
        (floor.deflections[1].len() == UPLIFTS).then_some(floor)
    }

    /// The plate at an angle [rad], from the axis outwards.
    pub(super) fn at(&self, now: &Now, theta: f64) -> Vec<Under> {
        let cos = theta.cos();
        let rim = now.turn.rim_at(self.radius, now.rotation, theta);
        let swing = now.pressure * cos;
        let lower = if self.suction > 0.0 { (-swing / self.suction).clamp(-1.0, 1.0) } else { 0.0 };
        let strip = self.rest - lower * self.suction;
        let place = self.uplifts.partition_point(|w| *w < rim).clamp(1, UPLIFTS - 1);
        let (a, b) = (self.uplifts[place - 1], self.uplifts[place]);
        let t = if b > a { ((rim - a) / (b - a)).clamp(0.0, 1.0) } else { 0.0 };
        let of = |level: usize, i: usize| {
            let own = &self.deflections[level];
            own[place - 1][i] + t * (own[place][i] - own[place - 1][i])
        };
        let points = self.distances.iter().zip(&self.shape).enumerate();
        points
            .map(|(i, (&distance, shape))| {
                let deflection = of(0, i) + lower * (of(1, i) - of(0, i));
                let dry = distance < -1e-9;
                let liquid = if dry { 0.0 } else { self.rest + swing * shape };
                let more = if dry { 0.0 } else { liquid - strip };
                let pressure = if deflection < 0.0 { (more - self.modulus * deflection).max(0.0) } else { 0.0 };
                Under {
                    distance,
                    deflection: if pressure > 0.0 { -pressure / self.modulus } else { deflection.max(0.0) },
                    pressure,
                    liquid,
                }
            })
            .collect()
    }

    /// The pressure of the ground in plan, symmetric about the direction of the motion.
    pub(super) fn plan(&self, now: &Now, time: f64) -> GroundPlan {
        let (radii, crowd) = RADII;
        let inwards: Vec<f64> =
            (0..radii).rev().map(|j| self.radius * (j as f64 / (radii - 1) as f64).powf(crowd)).collect();
        let degrees: Vec<f64> = (0..ANGLES).map(|i| 180.0 * i as f64 / (ANGLES - 1) as f64).collect();
        let row = |angle: &f64| {
            let points = self.at(now, angle.to_radians());
            let (x, r): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.distance, p.pressure)).unzip();
            inwards.iter().map(|d| along(&x, &r, *d)).collect()
        };
        GroundPlan {
            time,
            rest: self.rest,
            pressure: degrees.iter().map(row).collect(),
            radii: inwards.iter().map(|d| self.radius - d).collect(),
            degrees,
        }
    }

    /// Places that are drawn, from the axis outwards.
    fn drawn(&self) -> Vec<usize> {
        let mut out = vec![0];
        let last = self.distances.len() - 1;
        for (i, x) in self.distances.iter().enumerate().skip(1) {
            let before = out.last().map_or(f64::INFINITY, |k| self.distances[*k]);
            let apart = (CLOSEST[0] * self.radius).max(CLOSEST[1] * x.abs());
            if i == last || x.abs() < 1e-9 || before - x >= apart {
                out.push(i);
            }
        }
        out
    }

    /// Pictures at instants, the plate all around.
    ///
    /// * `joint`: plastic rotation of the joint at an uplift [rad]
    pub(super) fn states(&self, instants: &[(f64, Now)], joint: &dyn Fn(f64) -> f64) -> Snapshots {
        let kept = self.drawn();
        let rings = kept.len();
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / SECTORS as f64;
        let mut nodes = Vec::with_capacity(SECTORS * rings);
        for k in 0..SECTORS {
            let (s, c) = angle(k).sin_cos();
            // The node at the axis is that of all sectors.
            let out = kept.iter().map(|i| (self.radius - self.distances[*i]).max(0.0));
            nodes.extend(out.map(|r| [r * c, r * s, 0.0]));
        }
        let node = |k: usize, i: usize| if i == 0 { 0 } else { (k % SECTORS) * rings + i };
        let cell = |k: usize, i: usize| [node(k, i), node(k, i + 1), node(k + 1, i + 1), node(k + 1, i)];
        let bottom = (0..SECTORS).flat_map(|k| (0..rings - 1).map(move |i| cell(k, i))).collect();
        // The cell inside the wall has the whole of the joint.
        let foot = kept.iter().position(|i| self.distances[*i] < 1e-9).unwrap_or(rings - 1);
        let state = |(time, now): &(f64, Now)| {
            let mut out = Snapshot { time: *time, ..Snapshot::default() };
            for k in 0..SECTORS {
                let points = self.at(now, angle(k));
                let drawn = || kept.iter().map(|i| &points[*i]);
                out.displacement.extend(drawn().map(|p| [now.slip, 0.0, p.deflection]));
                out.ground.extend(drawn().map(|p| p.pressure));
                let middle = angle(k) + 0.5 * angle(1);
                let turned = joint(now.turn.rim_at(self.radius, now.rotation, middle));
                out.plastic.extend((0..rings - 1).map(|i| if i + 1 == foot { turned } else { 0.0 }));
            }
            out
        };
        Snapshots { states: instants.iter().map(state).collect(), nodes, bottom, ..Snapshots::default() }
    }
}

/// Distances inwards [m] and the deflections at uplifts [m], as many as there are.
fn plates(base: Base, uplifts: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (weight, ends) = (base.weight, [uplifts[0], uplifts[uplifts.len() - 1]]);
    let mut stands = Stands::of(base);
    let mut rotation = FIRST.0;
    // The curves grow with the rotations that are asked for.
    for _ in 0..FIRST.1 {
        if ends.iter().all(|w| stands.plate(*w).is_some()) || stands.at(&[rotation], weight).is_empty() {
            break;
        }
        rotation *= 1.2;
    }
    let mut distances = Vec::new();
    let mut out = Vec::new();
    for plate in uplifts.iter().map_while(|w| stands.plate(*w)) {
        distances = plate.iter().map(|p| p.distance).collect();
        out.push(plate.iter().map(|p| p.deflection).collect());
    }
    (distances, out)
}

/// Straight between places that fall.
fn along(places: &[f64], values: &[f64], at: f64) -> f64 {
    let (Some(last), true) = (values.last(), values.len() == places.len()) else { return 0.0 };
    let i = places.partition_point(|x| *x > at);
    match i {
        0 => values[0],
        i if i >= places.len() => *last,
        i => {
            let t = (places[i - 1] - at) / (places[i - 1] - places[i]);
            values[i - 1] + t * (values[i] - values[i - 1])
        }
    }
}
