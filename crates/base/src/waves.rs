//! Waves of the foot in time: the wall ovals with the liquid, which takes as long as its inertia lets it.
//!
//! ```text
//! m_n ä_n + c_n ȧ_n + Σ K_nm(p_b) a_m = f_n          f_n = (U_n − a_n)/H_n          ∫ F(w, p − p_b cos φ) cos nφ dφ + π f_n = 0
//! M = M(ψ, p_b; a)                                  c_n = 2 ξ √(K_n m_n)
//! ```
//!
//! a_n are the waves of a wall that ovals, U_n those of its foot, H_n the membrane between them ([`crate::Warping`]). A motion that is short beside the
//! periods of the waves leaves the wall round, and M is that of a round rim; a slow one finds the rim that warps.
//!
//! The waves move by central differences, whose limit is ω h = 2. In tanks their shortest period is a hundred and more steps of 1 ms long; in models a wave
//! may be faster, and has the mass then that makes it twelve steps long. The foot is in equilibrium at each end of a step.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use crate::error::BaseError;
use crate::foot::{Block, Foot, LANES, Standing, Strips, UNKNOWNS, places};
use crate::response::Response;
use crate::rocking::Rocking;
use crate::warp::{Top, WAVES, Wall, Warping};

/// Panels of three Gauss points from the lifted side to the toe: half of those of M(ψ), which changes the moment by less than 0.1 %.
const PANELS: usize = 16;
/// Largest ω h of a wave.
const FASTEST: f64 = 0.5;
/// Pressures on the plate of the table, over the range of the curves; straight lines between them.
const LEVELS: usize = 9;

/// A wall that ovals in time.
#[derive(Clone, Debug)]
pub struct Waves {
    radius: f64,
    weight: f64,
    warping: Warping,
    /// c_n [N s/m²].
    damping: [f64; WAVES],
    /// Displacement w₀ of the centre at rest [m].
    rest: f64,
    table: Table,
}

/// The waves in a run, from the side that a positive rotation lifts.
#[derive(Clone, Debug)]
pub(crate) struct Ovals {
    /// a_n, ȧ_n and ä_n.
    place: [f64; WAVES],
    velocity: [f64; WAVES],
    acceleration: [f64; WAVES],
    /// The foot, as last found, and where that was: rotation [rad] and bottom pressure [Pa], with the answer.
    foot: RefCell<Standing>,
    /// Its unknowns and ψ R a step before [m].
    before: ([f64; UNKNOWNS], f64),
    answered: Cell<Option<((f64, f64), Response)>>,
    places: Rc<[Block]>,
    /// Intervals of the table close to the places of each block, then to their mirrors.
    near: Rc<[Cell<[usize; LANES]>]>,
}

impl Waves {
    /// The rim of a base that is not kept round, with damping ratio ξ of the waves; the base is left with one that is, as short motions find it. None where
    /// nothing ovals.
    ///
    /// Errors: no equilibrium at rest.
    pub fn of(rocking: Rocking, damping: f64) -> Result<(Rocking, Option<Waves>), BaseError> {
        let Some(warping) = rocking.warped().filter(|w| w.top() != Top::Round).cloned() else {
            return Ok((rocking, None));
        };
        let round = rocking.warping(Some(warping.round()));
        let waves = Waves {
            radius: round.radius(),
            weight: round.weight(),
            damping: std::array::from_fn(|n| 2.0 * damping * (warping.ovalling(n) * warping.mass(n)).sqrt()),
            rest: round.at(0.0, 0.0)?.centre,
            table: Table::of(&round),
            warping,
        };
        Ok((round, Some(waves)))
    }

    /// Moment that lifts a rim which the plate does not hold, π R² w_t [N m].
    pub(crate) fn lifting(&self) -> f64 {
        std::f64::consts::PI * self.radius * self.radius * self.weight
    }

    pub(crate) fn at_rest(&self) -> Ovals {
        let still = [0.0; WAVES];
        let (place, velocity, acceleration) = (still, still, still);
        let (places, foot) = (places(PANELS), Standing::upright(self.rest));
        Ovals {
            place,
            velocity,
            acceleration,
            before: foot.place(),
            foot: RefCell::new(foot),
            answered: Cell::new(None),
            near: (0..2 * places.len()).map(|_| Cell::default()).collect(),
            places,
        }
    }

    /// Moves the waves to the end of a step [s].
    pub(crate) fn begin(&self, ovals: &mut Ovals, step: f64) {
        ovals.answered.set(None);
        ovals.before = ovals.foot.get_mut().go_on(ovals.before);
        for n in 0..WAVES {
            ovals.place[n] += step * (ovals.velocity[n] + 0.5 * step * ovals.acceleration[n]);
        }
    }

    /// Moment of the foot at a rotation [rad] and a bottom pressure [Pa], and its derivative.
    ///
    /// Errors: no equilibrium.
    pub(crate) fn response(&self, ovals: &Ovals, (psi, suction): (f64, f64)) -> Result<Response, BaseError> {
        if let Some((_, answer)) = ovals.answered.get().filter(|(place, _)| *place == (psi, suction)) {
            return Ok(answer);
        }
        let (mut stiffness, mut load) = ([[0.0; WAVES]; WAVES], [0.0; WAVES]);
        for n in 0..WAVES {
            stiffness[n][n] = 1.0 / self.warping.membrane(n);
            load[n] = ovals.place[n] / self.warping.membrane(n);
        }
        let strips = Under { table: &self.table, suction, near: &ovals.near };
        let (wall, places) = (Wall { stiffness, load }, Rc::clone(&ovals.places));
        let foot = Foot { radius: self.radius, weight: self.weight, wall, places, strips: &strips };
        let answer = foot.follow(psi, &mut ovals.foot.borrow_mut())?;
        ovals.answered.set(Some(((psi, suction), answer)));
        Ok(answer)
    }

    /// Ends a step [s] with the foot where [`Waves::response`] found it last, under a bottom pressure [Pa].
    pub(crate) fn end(&self, ovals: &mut Ovals, suction: f64, step: f64) {
        let foot = ovals.foot.borrow().unknowns;
        let own = self.warping.forces(&ovals.place, suction);
        for n in 0..WAVES {
            let pull = (foot[n + 1] - ovals.place[n]) / self.warping.membrane(n);
            let half = ovals.velocity[n] + 0.5 * step * ovals.acceleration[n];
            let stiffness = self.warping.ovalling(n) + 1.0 / self.warping.membrane(n);
            let mass = self.warping.mass(n).max(stiffness * (step / FASTEST).powi(2));
            let inertia = mass + 0.5 * step * self.damping[n];
            ovals.acceleration[n] = (pull - own[n] - self.damping[n] * half) / inertia;
            ovals.velocity[n] = half + 0.5 * step * ovals.acceleration[n];
        }
    }
}

impl Ovals {
    /// Centre and waves of the foot [m], the waves from the side that a rotation lifts.
    pub(crate) fn foot(&self, psi: f64) -> (f64, [f64; WAVES]) {
        let foot = self.foot.borrow().unknowns;
        let side = |n: usize| if psi < 0.0 && n % 2 == 1 { -1.0 } else { 1.0 };
        (foot[0], std::array::from_fn(|n| side(n) * foot[n + 1]))
    }
}

/// Pull of a strip [N/m] by uplift and pressure, a table: cubics between uplifts.
#[derive(Clone, Debug)]
struct Table {
    uplifts: Vec<f64>,
    /// Suction of the first level [Pa], and levels of a pascal.
    first: f64,
    levels: f64,
    /// Coefficients by interval of uplifts, then level, and how much more they are at the next level.
    cubics: Vec<[[[f64; 4]; 2]; LEVELS - 1]>,
}

impl Table {
    fn of(rocking: &Rocking) -> Table {
        let (low, high) = rocking.suctions();
        let apart = ((high - low) / (LEVELS - 1) as f64).max(f64::MIN_POSITIVE);
        let uplifts: Vec<f64> = rocking.curve().points().iter().map(|p| p.uplift).collect();
        let between = |pair: &[f64], k: usize| {
            let at = |w: f64| rocking.hold(w, rocking.pressure() - low - apart * k as f64);
            let (h, [a, m], [b, n]) = (pair[1] - pair[0], at(pair[0]), at(pair[1]));
            let secant = (b - a) / h;
            [a, m, (3.0 * secant - 2.0 * m - n) / h, (m + n - 2.0 * secant) / (h * h)]
        };
        let interval = |pair: &[f64]| {
            let own: [[f64; 4]; LEVELS] = std::array::from_fn(|k| between(pair, k));
            std::array::from_fn(|k| [own[k], std::array::from_fn(|j| own[k + 1][j] - own[k][j])])
        };
        let cubics = uplifts.windows(2).map(interval).collect();
        Table { first: low, levels: 1.0 / apart, cubics, uplifts }
    }

    /// F and dF/dw; straight on beyond the uplifts.
    ///
    /// * `near`: an interval of uplifts close to that one, which it becomes
    #[inline(always)]
    fn pull(&self, near: &mut usize, uplift: f64, suction: f64) -> [f64; 2] {
        let mut i = *near;
        while i > 0 && uplift < self.uplifts[i] {
            i -= 1;
        }
        while i + 1 < self.cubics.len() && uplift > self.uplifts[i + 1] {
            i += 1;
        }
        *near = i;
        let level = ((suction - self.first) * self.levels).clamp(0.0, (LEVELS - 1) as f64);
        let k = (level as i32 as usize).min(LEVELS - 2);
        let share = level - k as f64;
        let [own, more] = &self.cubics[i][k];
        let mut mixed = *own;
        for j in 0..4 {
            mixed[j] += share * more[j];
        }
        let [a, b, c, d] = mixed;
        let at = |x: f64| [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * 3.0 * d)];
        let (from, to) = (self.uplifts[i], self.uplifts[i + 1]);
        let beyond = uplift - uplift.max(from).min(to);
        let [force, slope] = at(uplift - beyond - from);
        [force + slope * beyond, slope]
    }
}

/// The table under a suction at the lifted side [Pa], with intervals close to those of each place.
struct Under<'a> {
    table: &'a Table,
    suction: f64,
    near: &'a [Cell<[usize; LANES]>],
}

impl Strips for Under<'_> {
    #[inline(always)]
    fn pull(&self, uplift: f64, cos: f64) -> [f64; 2] {
        self.table.pull(&mut 0, uplift, self.suction * cos)
    }

    #[inline(always)]
    fn pulls(&self, block: usize, uplifts: [f64; LANES], cosines: [f64; LANES]) -> [[f64; LANES]; 2] {
        let mut near = self.near[block].get();
        let mut pulls = [[0.0; LANES]; 2];
        for i in 0..LANES {
            [pulls[0][i], pulls[1][i]] = self.table.pull(&mut near[i], uplifts[i], self.suction * cosines[i]);
        }
        self.near[block].set(near);
        pulls
    }
}

#[cfg(test)]
mod tests;
