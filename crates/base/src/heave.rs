//! The foot's centre in time: mass of wall and roof that a rocking foot lifts and drops.
//!
//! ```text
//! m ẅ₀ = P          P = L + τ L̇          L = −∫ F(w₀ + ψ R cos φ, p − p_b cos φ) R dφ − 2 π R w_t
//! M = M(ψ, p_b) + [∫ F cos φ R² dφ]_w₀ − [ … ]_L=0 + τ L̇ ∂w₀/∂ψ
//! ```
//!
//! L is what presses on the strips besides the weight at rest. A foot that turns about its toe lifts its centre by ψ R, and with it the moment of
//! inertia is J + m R², that of a rigid block (Housner 1963). Damping is in proportion to the stiffness of the strips as it is at that instant, and
//! acts on what the centre moves besides w₀(ψ, L).
//!
//! A table by bottom pressure, rotation and place of the centre, from where all of the rim is on the ground to where none is, and straight on beyond;
//! between its places straight lines.

use crate::error::BaseError;
use crate::law::Law;
use crate::response::Response;
use crate::rocking::Rocking;
use crate::warp::WAVES;

/// Places of the centre on either side of that at rest, without the last one, and where that is over the one before.
const PLACES: usize = 8;
const LAST: f64 = 1.5;
/// Places of a row.
const ROW: usize = 2 * PLACES + 3;
/// That at rest.
const REST: usize = PLACES + 1;
/// Panels of three Gauss points on the lifted arc, and as many on the rest: a quarter of those of M(ψ), for differences from it.
const PANELS: usize = 6;
/// Smallest way of the centre to the first place where nothing loads it, over the radius.
const LEAST: f64 = 1e-5;

/// A mass on the foot that moves up and down.
#[derive(Clone, Debug)]
pub struct Heave {
    /// Mass m [kg].
    mass: f64,
    /// Damping over stiffness τ [s].
    delay: f64,
    /// Displacement w₀ [m] at rest, and the stiffness of the closed foot there [N/m].
    rest: f64,
    stiffness: f64,
    /// Rows by bottom pressure, then rotation, with the deepest place first.
    rows: Vec<[Place; ROW]>,
    /// Waves of the foot at the same places [m]; empty of one that stays plane.
    waves: Vec<[[f64; WAVES]; ROW]>,
    rotations: usize,
}

/// The foot with its centre at a place, or a rate of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Place {
    /// w₀ [m].
    centre: f64,
    /// L [N].
    load: f64,
    /// Moment of the strips [N m].
    moment: f64,
}

impl Place {
    /// `share` of the way to another one.
    fn towards(self, other: Place, share: f64) -> Place {
        self.plus(other.plus(self, -1.0), share)
    }

    fn plus(self, other: Place, share: f64) -> Place {
        Place {
            centre: self.centre + share * other.centre,
            load: self.load + share * other.load,
            moment: self.moment + share * other.moment,
        }
    }
}

/// The foot at the end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Lift {
    /// What presses on the strips L [N].
    pub(crate) load: f64,
    /// The same with what damping takes P [N].
    pub(crate) press: f64,
    /// ∂w₀/∂ψ under a load that stays [m].
    pub(crate) sinks: f64,
    /// What heave adds to the moment of the base [N m], and to its derivative.
    pub(crate) response: Response,
}

/// A step of the foot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// Centre at its end without a force at its end [m].
    pub(crate) place: f64,
    /// What a force P at its end adds [m/N].
    pub(crate) give: f64,
    /// L at its beginning [N].
    pub(crate) before: f64,
    /// Its length [s].
    pub(crate) length: f64,
}

impl Heave {
    /// On a base whose law is `law`, of `rocking`.
    ///
    /// Without damping.
    ///
    /// * `mass` m [kg]
    ///
    /// Errors: no equilibrium of a foot that warps.
    pub fn new(mass: f64, rocking: &Rocking, law: &Law) -> Result<Heave, BaseError> {
        let rotations = law.rotations();
        let mut rows = Vec::with_capacity(rotations.len() * law.suctions().len());
        let mut forms = Vec::with_capacity(rows.capacity());
        for (k, &suction) in law.suctions().iter().enumerate() {
            for (j, &psi) in rotations.iter().enumerate() {
                let turn = law.tabled(k, j);
                let mut own = turn.waves;
                let (force, moment) = rocking.sums(PANELS, (psi, turn.centre), suction, &mut own)?;
                // To where the lifted side is on the ground, and to where the toe leaves it.
                let (high, low) = (turn.uplift, turn.rim(rocking.radius(), std::f64::consts::PI));
                let least = law.tabled(k, 0).centre.abs().max(LEAST * rocking.radius());
                let down = high.max(0.0) + least;
                let up = (-low).max(0.0) + least;
                let mut row = [Place { centre: turn.centre, load: 0.0, moment: turn.moment }; ROW];
                let mut waves = [turn.waves; ROW];
                // From rest outwards, so that the waves of a place are close to those of the next.
                for i in (0..REST).rev().chain(REST + 1..ROW) {
                    let way = if i < REST { -down } else { up };
                    let way = match i.abs_diff(REST) {
                        n if n > PLACES => LAST * way,
                        n => (n as f64 / PLACES as f64).powi(2) * way,
                    };
                    let mut there = if i < REST { waves[i + 1] } else { waves[i - 1] };
                    let now = rocking.sums(PANELS, (psi, turn.centre + way), suction, &mut there)?;
                    row[i] =
                        Place { centre: turn.centre + way, load: force - now.0, moment: turn.moment + now.1 - moment };
                    waves[i] = there;
                }
                rows.push(row);
                if rocking.warps() {
                    forms.push(waves);
                }
            }
        }
        let upright = &rows[law.suctions().partition_point(|s| *s < 0.0) * rotations.len()];
        let (below, rest) = (upright[REST - 1], upright[REST]);
        Ok(Heave {
            mass,
            delay: 0.0,
            rest: rest.centre,
            stiffness: (below.load - rest.load) / (rest.centre - below.centre),
            rows,
            waves: forms,
            rotations: rotations.len(),
        })
    }

    /// Waves of the foot [m] at a rotation [rad] and a bottom pressure [Pa] with its centre at a place [m]; straight on beyond the table.
    pub fn waves(&self, law: &Law, (psi, centre): (f64, f64), suction: f64) -> [f64; WAVES] {
        if self.waves.is_empty() {
            return [0.0; WAVES];
        }
        let side = if psi < 0.0 { -1.0 } else { 1.0 };
        let (psi, suction) = (side * psi, side * suction);
        let (place, _) = self.row(law, psi, suction);
        let above = (1..ROW - 1).find(|i| place(*i).centre >= centre).unwrap_or(ROW - 1);
        let (low, high) = (place(above - 1).centre, place(above).centre);
        let part = (centre - low) / (high - low);
        let (j, k, share) = law.places(psi, suction);
        let turn = (psi - law.rotations()[j - 1]) / (law.rotations()[j] - law.rotations()[j - 1]);
        std::array::from_fn(|n| {
            let at = |k: usize, j: usize, i: usize| self.waves[k * self.rotations + j][i][n];
            let between = |a: f64, b: f64, share: f64| a + share * (b - a);
            let along = |k: usize, j: usize| between(at(k, j, above - 1), at(k, j, above), part);
            let turned = |k: usize| between(along(k, j - 1), along(k, j), turn);
            between(turned(k - 1), turned(k), share)
        })
    }

    /// The same with damping τ over the stiffness of the strips [s].
    #[must_use]
    pub fn damped(self, delay: f64) -> Heave {
        Heave { delay, ..self }
    }

    /// Stiffness of all of the rim on the ground against a foot that sinks [N/m].
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Damping ratio of the foot that bounces with all of its rim on the ground.
    pub fn damping_ratio(&self) -> f64 {
        0.5 * self.delay * (self.stiffness / self.mass).sqrt()
    }

    /// Mass m [kg].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Displacement w₀ at rest [m].
    pub(crate) fn rest(&self) -> f64 {
        self.rest
    }

    /// Places of the centre at a rotation [rad] ≥ 0 and a bottom pressure [Pa], and their derivatives by the rotation.
    fn row<'a>(
        &'a self,
        law: &Law,
        psi: f64,
        suction: f64,
    ) -> (impl Fn(usize) -> Place + 'a, impl Fn(usize) -> Place + 'a) {
        let (j, k, share) = law.places(psi, suction);
        let (from, to) = (law.rotations()[j - 1], law.rotations()[j]);
        let part = (psi - from) / (to - from);
        let at = move |j: usize, i: usize| {
            let own = |k: usize| self.rows[k * self.rotations + j][i];
            own(k - 1).towards(own(k), share)
        };
        let place = move |i: usize| at(j - 1, i).towards(at(j, i), part);
        let rate = move |i: usize| {
            let change = at(j, i).plus(at(j - 1, i), -1.0);
            Place::default().plus(change, 1.0 / (to - from))
        };
        (place, rate)
    }

    /// The foot at a rotation [rad] and a bottom pressure [Pa] at the end of a step.
    pub(crate) fn lift(&self, law: &Law, psi: f64, suction: f64, step: Step) -> Lift {
        let side = if psi < 0.0 { -1.0 } else { 1.0 };
        let (at, turned) = self.row(law, side * psi, side * suction);
        // P = L + τ (L − L₀)/h.
        let rate = self.delay / step.length;
        let (place, give) = (step.place - step.give * rate * step.before, step.give * (1.0 + rate));
        // The higher the centre, the less presses on the strips: one root.
        let over = |at: Place| at.centre - place - give * at.load;
        let (mut low, mut high) = (0, ROW - 1);
        while high - low > 1 {
            let middle = low.midpoint(high);
            if over(at(middle)) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (below, above) = (at(low), at(high));
        let share = over(below) / (over(below) - over(above));
        let found = below.towards(above, share);
        let by = above.plus(below, -1.0);
        let (steep, gain) = (by.centre / by.load, by.moment / by.load);
        let turning = turned(low).towards(turned(high), share);
        let sinks = turning.centre - steep * turning.load;
        let presses = sinks / (give - steep);
        let press = rate * (found.load - step.before);
        Lift {
            load: found.load,
            press: found.load + press,
            sinks: side * sinks,
            response: Response {
                moment: side * (found.moment - at(REST).moment + sinks * press),
                tangent: turning.moment - gain * turning.load - turned(REST).moment + (gain + sinks * rate) * presses,
            },
        }
    }
}

#[cfg(test)]
mod tests;
