//! Places of a wall with the forces to be resisted there.

use tank::case::Combination;
use tank::{BarDirection, Course};

use crate::ec8::work::combined;
use crate::sheet::{number, with_unit};
use tank::units::Dimension::Length;

/// What acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Situation {
    /// Hydrostatic and seismic, ultimate limit state.
    Seismic,
    /// Hydrostatic, serviceability.
    Service,
    /// Hydrostatic and the reduced earthquake.
    Damage,
}

/// Factors of the loads in one case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Factors {
    pub situation: Situation,
    /// Factor on the horizontal motion, with its sign.
    pub x: f64,
    /// Factor on the vertical motion, with its sign.
    pub v: f64,
    /// Whether this is the side of the tank, where the horizontal motion shears the wall instead of pressing on it.
    pub aside: bool,
}

/// A section of 1 m width and its forces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    pub course: &'a Course,
    /// Number of the course from the base, from 0.
    pub index: usize,
    /// Wall of a box and part of it, in words; empty of a cylinder.
    pub wall: (&'static str, &'static str),
    /// Height [m].
    pub z: f64,
    /// Depth of the liquid above it [m].
    pub head: f64,
    pub factors: Factors,
    /// Direction of the bars that resist.
    pub direction: BarDirection,
    /// Axial force [N/m], tension positive.
    pub n: f64,
    /// Moment [N·m/m], positive where it pulls on the inner face.
    pub m: f64,
    /// Shear across the wall [N/m], where it is largest.
    pub shear: Option<f64>,
}

impl Place<'_> {
    /// Course, height and combination in words.
    pub(super) fn describe(&self) -> String {
        let mut text = format!("course {} at z = {}", self.index + 1, with_unit(self.z, Length));
        let (wall, part) = self.wall;
        if !wall.is_empty() {
            text = format!("{wall}, {part}, {text}");
        }
        let f = self.factors;
        match f.situation {
            Situation::Service => format!("{text}, hydrostatic"),
            _ if f.aside => format!("{text}, side of the tank, {} E_x, {} E_z", number(f.x), number(f.v)),
            _ => format!("{text}, {} E_x, {} E_z", number(f.x), number(f.v)),
        }
    }
}

/// All cases.
///
/// * `vertical`: whether vertical motion is considered; `reduction`: factor ν of damage limitation
pub(super) fn cases(vertical: bool, reduction: Option<f64>) -> Vec<Factors> {
    let mut out = vec![Factors { situation: Situation::Service, x: 0.0, v: 0.0, aside: false }];
    let combinations: &[(f64, f64)] = if vertical { &[(1.0, 0.3), (0.3, 1.0)] } else { &[(1.0, 0.0)] };
    let situations = [Some((Situation::Seismic, 1.0)), reduction.map(|nu| (Situation::Damage, nu))];
    for (situation, scale) in situations.into_iter().flatten() {
        for (x, v) in combinations {
            let signs: &[f64] = if *v > 0.0 { &[1.0, -1.0] } else { &[1.0] };
            for sign in signs {
                let mut add = |x: f64, aside| {
                    out.push(Factors { situation, x: scale * x, v: scale * v * sign, aside });
                };
                add(*x, false);
                add(-*x, false);
                add(*x, true);
            }
        }
    }
    out
}

/// Pressures of the horizontal motion at heights up to the surface, tabulated; linear between.
pub(super) struct Horizontal<'a> {
    pub depth: f64,
    pub combination: Combination,
    pub courses: &'a [Course],
    /// Acceleration of the impulsive part [m/s²].
    pub a_i: f64,
    /// Behaviour factor q in `a_i`.
    pub q: f64,
    impulsive: Vec<f64>,
    convective: Vec<f64>,
}

/// Intervals of the table: the chord of the cosine-like pressures errs by less than 1e-4 of the largest.
const INTERVALS: usize = 80;

impl<'a> Horizontal<'a> {
    /// * `fields`: impulsive and convective pressure [Pa] at a height [m]
    pub(super) fn new(
        (depth, courses): (f64, &'a [Course]),
        combination: Combination,
        (a_i, q): (f64, f64),
        fields: impl Fn(f64) -> (f64, f64),
    ) -> Horizontal<'a> {
        let heights = (0..=INTERVALS).map(|i| depth * i as f64 / INTERVALS as f64);
        let (impulsive, convective) = heights.map(fields).unzip();
        Horizontal { depth, combination, courses, a_i, q, impulsive, convective }
    }

    fn between(&self, table: &[f64], z: f64) -> f64 {
        let t = z / self.depth * INTERVALS as f64;
        if !(0.0..=INTERVALS as f64).contains(&t) {
            return 0.0;
        }
        let i = (t as usize).min(INTERVALS - 1);
        let [low, high] = [i, i + 1].map(|i| table.get(i).copied().unwrap_or_default());
        low + (t - i as f64) * (high - low)
    }

    /// Pressure of liquid and wall [Pa]; in the damage limitation state with q = 1.
    pub(super) fn pressure(&self, z: f64, situation: Situation) -> f64 {
        let scale = self.scale(situation);
        let (mut top, mut inertia) = (0.0, 0.0);
        for course in self.courses {
            inertia = course.thickness * course.material.density * self.a_i;
            top += course.height;
            if z < top {
                break;
            }
        }
        let impulsive = scale * (self.between(&self.impulsive, z) + inertia);
        combined(self.combination, impulsive, self.between(&self.convective, z))
    }

    /// Factor of the impulsive part: q in the damage limitation state.
    pub(super) fn scale(&self, situation: Situation) -> f64 {
        if situation == Situation::Damage { self.q } else { 1.0 }
    }
}

/// Number of the course at a height, from 0 (the upper one at a joint).
pub(super) fn course_index(courses: &[Course], z: f64) -> usize {
    let mut top = 0.0;
    for (index, course) in courses.iter().enumerate() {
        top += course.height;
        if z < top {
            return index;
        }
    }
    courses.len() - 1
}
