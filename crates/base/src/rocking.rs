//! Moment against rotation of the base: strips side by side.
//!
//! ```text
//! w(φ) = w₀ + ψ R cos φ          ∫ F(w) R dφ + 2 π R w_t = 0  →  w₀          M = ∫ F(w) cos φ R² dφ          n_toe = −F(w₀ − ψ R)
//! ```
//!
//! The foot of the wall stays a plane, or warps as its wall lets it ([`crate::Warping`]): under a free top edge its uplift gathers on a shorter arc.
//! With a bottom pressure p − p_b cos φ the strip is read between curves at several pressures.
//!
//! Source: Malhotra & Veletsos 1994.

use crate::curve::Curve;
use crate::element::GAUSS;
use crate::error::BaseError;
use crate::foot::{Foot, Strips, places};
use crate::warp::{WAVES, Warping};
use std::f64::consts::PI;
use std::sync::OnceLock;

/// Panels of three Gauss points on the lifted arc, and as many on the rest.
const PANELS: usize = 24;
/// The same from the lifted side to the toe of a foot that warps.
const WARPED: usize = 48;
/// Places between the lifted side and the toe at which a foot that warps is seen to be off the ground.
const SEEN: usize = 180;

/// Cosines of their angles.
static COSINES: OnceLock<[f64; SEEN + 1]> = OnceLock::new();

/// First rotation that is tried for a moment, and the largest at which a tank is thought to stand [rad].
const FIRST: f64 = 2e-5;
const LARGEST: f64 = 0.1;
/// Way to the next rotation over that to where the secant has the moment.
const AHEAD: f64 = 1.2;
/// Largest way to it over the last one.
const FARTHER: f64 = 4.0;

/// The base of a tank.
#[derive(Clone, Debug)]
pub struct Rocking {
    radius: f64,
    weight: f64,
    /// Pressures on the plate [Pa], falling, and the strip's curve under each.
    curves: Vec<(f64, Curve)>,
    /// Factor 1/Π (p_i − p_j) of Lagrange's polynomial for each.
    factors: Vec<f64>,
    /// Which of them is that at rest.
    rest: usize,
    /// What resists the waves of the foot; none of one that stays plane.
    warping: Option<Warping>,
}

/// The base at a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Rotation ψ [rad].
    pub rotation: f64,
    /// Overturning moment M [N m].
    pub moment: f64,
    /// Displacement w₀ of the centre of the foot, upwards [m].
    pub centre: f64,
    /// Uplift at the lifted side [m].
    pub uplift: f64,
    /// Axial force of the wall at the toe, compression positive [N/m].
    pub toe_force: f64,
    /// Axial force of the wall at the lifted side, tension positive [N/m].
    pub pull: f64,
    /// Waves U₂, U₃, … of the foot, from the lifted side on [m]; 0 of one that stays plane.
    pub waves: [f64; WAVES],
}

impl Turn {
    /// w(φ) of a foot of this radius [m] at an angle φ from the lifted side [rad].
    pub fn rim(&self, radius: f64, angle: f64) -> f64 {
        let waves = self.waves.iter().enumerate().map(|(k, u)| u * ((k + 2) as f64 * angle).cos());
        self.centre + self.rotation * radius * angle.cos() + waves.sum::<f64>()
    }

    /// Half of the angle over which a rim of this radius [m] is off the ground [rad].
    pub fn lifted_angle(&self, radius: f64) -> f64 {
        match self.waves.iter().all(|wave| *wave == 0.0) {
            true => open(self.centre, self.rotation * radius),
            false => lifted(&self.around(radius)),
        }
    }

    /// w at even places from the lifted side to the toe.
    pub(crate) fn around(&self, radius: f64) -> [f64; SEEN + 1] {
        let cosines = COSINES.get_or_init(|| std::array::from_fn(|i| (PI * i as f64 / SEEN as f64).cos()));
        cosines.map(|cos| {
            let (mut before, mut last) = (1.0, cos);
            let mut w = self.centre + self.rotation * radius * cos;
            for wave in &self.waves {
                (before, last) = (last, 2.0 * cos * last - before);
                w += wave * last;
            }
            w
        })
    }

    /// The same at θ [rad] of a base that turns by ψ [rad]: a positive one lifts θ = 180°.
    pub fn rim_at(&self, radius: f64, rotation: f64, theta: f64) -> f64 {
        self.rim(radius, if rotation > 0.0 { PI - theta } else { theta })
    }
}

impl Rocking {
    /// * `radius` R [m]
    /// * `weight` w_t of wall and roof [N/m]
    /// * `curves` of the strip under pressures on the plate [Pa]; the first is the pressure at rest
    ///
    /// Errors: no curve.
    pub fn new(radius: f64, weight: f64, mut curves: Vec<(f64, Curve)>) -> Result<Rocking, BaseError> {
        let Some(pressure) = curves.first().map(|c| c.0) else {
            return Err(BaseError::Parameter { name: "number of curves", value: 0.0, allowed: "at least one" });
        };
        curves.sort_by(|a, b| b.0.total_cmp(&a.0));
        let rest = curves.iter().position(|c| c.0 == pressure).unwrap_or(0);
        let factor = |i: usize| {
            let others = curves.iter().enumerate().filter(|(j, _)| *j != i);
            1.0 / others.map(|(_, other)| curves[i].0 - other.0).product::<f64>()
        };
        Ok(Rocking { factors: (0..curves.len()).map(factor).collect(), radius, weight, curves, rest, warping: None })
    }

    /// The same with a foot that warps, or one that stays plane.
    #[must_use]
    pub fn warping(self, warping: Option<Warping>) -> Rocking {
        Rocking { warping, ..self }
    }

    /// What resists the waves of the foot; none of one that stays plane.
    pub(crate) fn warped(&self) -> Option<&Warping> {
        self.warping.as_ref()
    }

    /// Whether the foot warps.
    pub(crate) fn warps(&self) -> bool {
        self.warping.is_some()
    }

    /// The strip's curve at rest.
    pub fn curve(&self) -> &Curve {
        &self.curves[self.rest].1
    }

    /// Pressure on the plate at rest [Pa].
    pub fn pressure(&self) -> f64 {
        self.curves[self.rest].0
    }

    /// Radius R [m].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Weight w_t of wall and roof [N/m].
    pub(crate) fn weight(&self) -> f64 {
        self.weight
    }

    /// Smallest and largest suction that the curves hold [Pa].
    pub(crate) fn suctions(&self) -> (f64, f64) {
        (self.pressure() - self.curves[0].0, self.pressure() - self.curves[self.curves.len() - 1].0)
    }

    /// The same base under more weight on its rim [N/m].
    #[must_use]
    pub fn heavier(&self, more: f64) -> Rocking {
        Rocking { weight: self.weight + more, ..self.clone() }
    }

    /// F(w) under a pressure.
    fn hold_down(&self, uplift: f64, pressure: f64) -> f64 {
        self.hold(uplift, pressure)[0]
    }

    /// F(w) under a pressure, and its slope; between the curves Lagrange's polynomial, none beyond them.
    pub(crate) fn hold(&self, uplift: f64, pressure: f64) -> [f64; 2] {
        if self.curves.len() == 1 {
            return self.curves[0].1.hold(uplift);
        }
        let (highest, lowest) = (self.curves[0].0, self.curves[self.curves.len() - 1].0);
        let p = pressure.clamp(lowest, highest);
        let mut sum = [0.0; 2];
        for (i, (_, curve)) in self.curves.iter().enumerate() {
            let others = self.curves.iter().enumerate().filter(|(j, _)| *j != i);
            let away = others.map(|(_, (other, _))| p - other).product::<f64>();
            // At the pressure of another curve there is nothing of this one.
            if away != 0.0 {
                let share = self.factors[i] * away;
                sum.iter_mut().zip(curve.hold(uplift)).for_each(|(sum, own)| *sum += share * own);
            }
        }
        sum
    }

    /// Width of the plate that is off the ground where the rim is lifted by `uplift` [m], at the angle from the lifted side whose cosine is given, under
    /// a bottom pressure that is lower by `suction` times it [Pa]; straight between the curves.
    pub fn lifted_width(&self, uplift: f64, cosine: f64, suction: f64) -> f64 {
        let pressure = self.pressure() - suction * cosine;
        let width = |i: usize| self.curves[i].1.at(uplift).lifted_width;
        let below = self.curves.partition_point(|c| c.0 > pressure);
        match (below.checked_sub(1), self.curves.get(below)) {
            (Some(above), Some((low, _))) => {
                let share = (pressure - low) / (self.curves[above].0 - low);
                width(below) + share * (width(above) - width(below))
            }
            (above, _) => width(above.unwrap_or(below)),
        }
    }

    fn range(&self) -> (f64, f64) {
        self.curves.iter().fold((f64::NEG_INFINITY, f64::INFINITY), |range, (_, curve)| {
            let (from, to) = curve.range();
            (range.0.max(from), range.1.min(to))
        })
    }

    /// The base at `rotation` ψ [rad] ≥ 0, with a bottom pressure that is lower by `suction` cos φ [Pa].
    ///
    /// Errors: a rotation that moves the rim beyond the curve, or at which a foot that warps has no equilibrium.
    pub fn at(&self, rotation: f64, suction: f64) -> Result<Turn, BaseError> {
        self.near(rotation, suction, None)
    }

    /// The same, found from a turn that is close to it.
    ///
    /// Errors: as [`Rocking::at`].
    pub(crate) fn near(&self, rotation: f64, suction: f64, last: Option<&Turn>) -> Result<Turn, BaseError> {
        let p = self.pressure();
        let plane = || {
            let hold = |w: f64, cos: f64| self.hold_down(w, p - suction * cos);
            plane_section(self.radius, self.weight, self.range(), rotation, &hold)
        };
        let Some(warping) = &self.warping else { return plane() };
        let start = match last {
            Some(turn) => *turn,
            None => plane()?,
        };
        let hold = |w: f64, cos: f64| self.hold(w, p - suction * cos);
        self.foot((warping, suction), WARPED, &hold).at(rotation, &start, self.range())
    }

    fn foot<'a, S: Strips>(&self, (warping, suction): (&Warping, f64), panels: usize, strips: &'a S) -> Foot<'a, S> {
        let wall = warping.under(suction);
        Foot { radius: self.radius, weight: self.weight, wall, places: places(panels), strips }
    }

    /// Force [N] and moment [N m] of the strips at a rotation ψ [rad] ≥ 0 with the centre of the foot at w₀ [m], and a bottom pressure that is
    /// lower by `suction` cos φ [Pa]; straight on beyond the curve. `waves` of the foot are those of a state close to it, and become those of the
    /// equilibrium there.
    ///
    /// Errors: no equilibrium of a foot that warps.
    pub(crate) fn sums(
        &self,
        panels: usize,
        (rotation, centre): (f64, f64),
        suction: f64,
        waves: &mut [f64; WAVES],
    ) -> Result<(f64, f64), BaseError> {
        let p = self.pressure();
        let Some(warping) = &self.warping else {
            let hold = |w: f64, cos: f64| self.hold_down(w, p - suction * cos);
            return Ok(sums(panels, self.radius, centre, rotation * self.radius, &hold));
        };
        let hold = |w: f64, cos: f64| self.hold(w, p - suction * cos);
        // As many panels as there are on both arcs of a foot that stays plane.
        self.foot((warping, suction), 2 * panels, &hold).held(rotation, centre, waves)
    }

    /// The foot at a rotation ψ [rad] with its centre at w₀ [m] and its waves [m], under a moment that is known [N m] and with a bottom pressure that
    /// is lower by `suction` cos φ [Pa]: sides belong to those that ψ lifts and presses.
    pub fn moved(&self, (rotation, centre): (f64, f64), waves: [f64; WAVES], moment: f64, suction: f64) -> Turn {
        let side = if rotation < 0.0 { -1.0 } else { 1.0 };
        let (rotation, suction) = (side * rotation, side * suction);
        let p = self.pressure();
        let mut turn = Turn { rotation, moment: side * moment, centre, uplift: 0.0, toe_force: 0.0, pull: 0.0, waves };
        turn.uplift = turn.rim(self.radius, 0.0);
        turn.toe_force = -self.hold_down(turn.rim(self.radius, PI), p + suction);
        turn.pull = self.hold_down(turn.uplift, p - suction);
        turn
    }

    /// The base under a moment [N m], with a bottom pressure that is lower by `suction` cos φ [Pa]; none where it does not hold the moment
    /// up to a rotation of 0.1 rad, or not within the curve.
    pub fn under(&self, moment: f64, suction: f64) -> Option<Turn> {
        let goal = |turn: &Turn| turn.moment - moment;
        turned(&|rotation| self.at(rotation, suction), &goal, 1e-10 * moment.abs())
    }
}

/// The turn at which `goal`, which grows with the rotation, is zero up to `settled`; that at rest where it is positive there. None where it
/// is not reached.
pub(crate) fn turned(
    at: &dyn Fn(f64) -> Result<Turn, BaseError>,
    goal: &dyn Fn(&Turn) -> f64,
    settled: f64,
) -> Option<Turn> {
    let rest = at(0.0).ok()?;
    let mut low = (0.0, goal(&rest));
    if low.1 >= -settled {
        return Some(rest);
    }
    let (mut rotation, mut beyond) = (FIRST, None);
    let high = loop {
        match at(rotation) {
            Ok(turn) => {
                let value = goal(&turn);
                if value >= 0.0 {
                    break (rotation, value);
                }
                let (step, gain) = (rotation - low.0, value - low.1);
                low = (rotation, value);
                rotation = match beyond {
                    Some(edge) => 0.5 * (rotation + edge),
                    // Not much beyond the answer, as a curve may have to be drawn for it: the moment grows slower and slower.
                    None => (rotation - AHEAD * value * step / gain.max(1e-300))
                        .clamp(1.02 * rotation, FARTHER * rotation)
                        .min(LARGEST),
                };
            }
            Err(_) => {
                beyond = Some(rotation);
                rotation = 0.5 * (low.0 + rotation);
            }
        }
        if rotation - low.0 <= 1e-9 * rotation {
            return None;
        }
    };
    let value = |rotation: f64| at(rotation).map_or(-low.1, |turn| goal(&turn));
    at(root(&value, low, high, settled)).ok()
}

/// A foot that stays plane, on any law of its rim: `hold` gives the pull on the wall [N/m] for an uplift [m] at the angle whose cosine
/// it gets, 1 at the lifted side. It may jump where the rim leaves the ground, at an uplift of 0.
///
/// * `range` of uplifts for which the law is known [m]
///
/// Errors: a rotation that moves the rim beyond the range.
pub fn plane_section(
    radius: f64,
    weight: f64,
    (from, to): (f64, f64),
    rotation: f64,
    hold: &dyn Fn(f64, f64) -> f64,
) -> Result<Turn, BaseError> {
    plane_section_by(PANELS, radius, weight, (from, to), rotation, hold)
}

/// The same with a number of panels on either arc.
pub(crate) fn plane_section_by(
    panels: usize,
    radius: f64,
    weight: f64,
    (from, to): (f64, f64),
    rotation: f64,
    hold: &dyn Fn(f64, f64) -> f64,
) -> Result<Turn, BaseError> {
    let reach = rotation * radius;
    let (low, high) = (from + reach, to - reach);
    let beyond = |wanted| BaseError::BeyondCurve { rotation, wanted, from, to };
    if low.partial_cmp(&high) != Some(std::cmp::Ordering::Less) {
        return Err(beyond(2.0 * reach + from));
    }
    let total = std::f64::consts::TAU * radius * weight;
    let over = |centre: f64| sums(panels, radius, centre, reach, hold).0 + total;
    let (below, above) = (over(low), over(high));
    if below > 0.0 {
        return Err(beyond(low - reach));
    }
    if above < 0.0 {
        return Err(beyond(high + reach));
    }
    let centre = root(&over, (low, below), (high, above), 1e-12 * total.abs());
    Ok(Turn {
        rotation,
        moment: sums(panels, radius, centre, reach, hold).1,
        centre,
        uplift: centre + reach,
        toe_force: -hold(centre - reach, -1.0),
        pull: hold(centre + reach, 1.0),
        waves: [0.0; WAVES],
    })
}

/// Root of an increasing function in a bracket of (place, value): false position with halved ends (Dowell & Jarratt 1971), and the middle where two
/// steps have not halved the value.
fn root(f: &dyn Fn(f64) -> f64, mut low: (f64, f64), mut high: (f64, f64), settled: f64) -> f64 {
    let mut last = 0_i8;
    let mut sizes = [f64::INFINITY; 3];
    for _ in 0..200 {
        let width = high.0 - low.0;
        let slow = sizes[2] > 0.5 * sizes[0];
        let share = if slow { 0.5 } else { low.1 / (low.1 - high.1) };
        let x = low.0 + share.clamp(0.0, 1.0) * width;
        let value = f(x);
        if value.abs() <= settled || width <= 1e-15 {
            return x;
        }
        sizes = if slow { [f64::INFINITY; 3] } else { [sizes[1], sizes[2], value.abs()] };
        let side = if value < 0.0 { -1 } else { 1 };
        let (own, other) = if side < 0 { (&mut low, &mut high) } else { (&mut high, &mut low) };
        *own = (x, value);
        if last == side {
            other.1 *= 0.5;
        }
        last = side;
    }
    0.5 * (low.0 + high.0)
}

/// Half of the angle over which the rim is off the ground [rad].
fn open(centre: f64, reach: f64) -> f64 {
    match (reach > 0.0, centre > 0.0) {
        (true, _) => (-centre / reach).clamp(-1.0, 1.0).acos(),
        (false, true) => PI,
        (false, false) => 0.0,
    }
}

/// Part of the half circumference over which a rim with these uplifts at even places is off the ground [rad], straight between them.
pub(crate) fn lifted(rim: &[f64]) -> f64 {
    let share = |pair: &[f64]| {
        let (high, low) = (pair[0].max(pair[1]), pair[0].min(pair[1]));
        if low >= 0.0 && high > 0.0 { 1.0 } else { high.max(0.0) / (high - low).max(f64::MIN_POSITIVE) }
    };
    PI / (rim.len() - 1) as f64 * rim.windows(2).map(share).sum::<f64>()
}

/// Force [N] and moment [N m] around the circumference; panels end where the rim leaves the ground.
fn sums(panels: usize, radius: f64, centre: f64, reach: f64, hold: &dyn Fn(f64, f64) -> f64) -> (f64, f64) {
    let edge = open(centre, reach);
    let (mut force, mut moment) = (0.0, 0.0);
    for (from, to) in [(0.0, edge), (edge, PI)] {
        if to <= from {
            continue;
        }
        let width = (to - from) / panels as f64;
        for i in 0..panels {
            for (x, weight) in GAUSS {
                let cos = (from + (i as f64 + x) * width).cos();
                let f = weight * width * hold(centre + reach * cos, cos);
                force += f;
                moment += f * cos;
            }
        }
    }
    (2.0 * radius * force, 2.0 * radius * radius * moment)
}
