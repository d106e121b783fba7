//! Anchors around the rim: elastic-plastic springs that pull only, with a gap, until they break.
//!
//! ```text
//! e_i = w_i − w_rest − g − e_i^p          N_i = min(k e_i, N_y) where e_i > 0, else 0          broken where w_i − w_rest − g > u_r
//! w_i = w₀ + ψ R s_i ,  s_i = −cos θ_i     Σ N_i = Q           M = M_strips(ψ, p_b; w_t + Q/2πR) + R Σ N_i s_i
//! ```
//!
//! The pull Q of all anchors presses the rim down as a weight does: moment and centre of the foot are those of the strips under the weight
//! w_t + Q/2πR, between five of them in straight lines, and the foot stays plane. Where all anchors yield and the toe is short, M = R (n N_y + W).
//!
//! An anchor is not pretensioned; what it has stretched beyond its yield stays as a gap.

use std::f64::consts::TAU;

use crate::error::{BaseError, positive};
use crate::law::Law;
use crate::response::Response;
use crate::rocking::{Rocking, Turn};

/// Steps between no pull and that of all anchors at their yield force.
const LEVELS: usize = 4;
/// Iterations on the pull.
const ITERATIONS: usize = 80;

/// Anchors of one kind, evenly spaced; the first stands at θ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchors {
    /// Number n.
    pub count: usize,
    /// Stiffness k of one, with its chair and embedment [N/m].
    pub stiffness: f64,
    /// Force N_y at which one yields [N].
    pub yield_force: f64,
    /// Play g of its nut [m].
    pub gap: f64,
    /// Elongation u_r at which one breaks [m]; none where it does not.
    pub rupture: Option<f64>,
}

/// State of the anchors, place by place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bolts {
    /// Plastic elongations e^p [m].
    pub plastic: Vec<f64>,
    /// Which are broken.
    pub broken: Vec<bool>,
}

/// Anchors on a base that turns.
#[derive(Clone, Debug)]
pub struct Ring {
    anchors: Anchors,
    radius: f64,
    /// Displacement of the rim at rest [m].
    rest: f64,
    /// s_i and the number of anchors there: one, or a pair at ± θ.
    places: Vec<(f64, f64)>,
    /// Strips under rising pulls.
    laws: Vec<Law>,
}

/// What anchors add to a base.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pull {
    /// Pull of all of them Q [N].
    pub total: f64,
    /// Their moment, and what their pull adds to that of the strips [N m]; its derivative.
    pub response: Response,
    /// Displacement w₀ of the centre of the foot [m].
    pub centre: f64,
}

/// What a step costs the anchors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Plastic work, and what broken ones had stored [J].
    pub lost: f64,
    /// Whether one breaks.
    pub breaks: bool,
}

impl Anchors {
    /// Errors: numbers without meaning.
    pub fn check(&self) -> Result<(), BaseError> {
        positive("number of anchors", self.count as f64)?;
        positive("stiffness of an anchor", self.stiffness)?;
        positive("yield force of an anchor", self.yield_force)?;
        if let Some(rupture) = self.rupture {
            positive("elongation of an anchor at rupture", rupture)?;
        }
        match self.gap >= 0.0 && self.gap.is_finite() {
            true => Ok(()),
            false => Err(BaseError::Parameter { name: "gap of an anchor", value: self.gap, allowed: "at least 0" }),
        }
    }

    /// Force [N] and stiffness [N/m] of one at an elongation from rest, gap included [m].
    pub fn force(&self, elongation: f64, plastic: f64, broken: bool) -> (f64, f64) {
        let e = elongation - self.gap - plastic;
        match (broken || e <= 0.0, self.stiffness * e) {
            (true, _) => (0.0, 0.0),
            (false, force) if force < self.yield_force => (force, self.stiffness),
            _ => (self.yield_force, 0.0),
        }
    }
}

impl Ring {
    /// On a base whose law without anchors is `law`, of `rocking`.
    ///
    /// Errors: numbers without meaning; rotations that move the rim beyond the strips' curve.
    pub fn new(anchors: Anchors, rocking: &Rocking, law: &Law) -> Result<Ring, BaseError> {
        anchors.check()?;
        let radius = rocking.radius();
        let n = anchors.count;
        let places = (0..=n / 2).map(|i| {
            let alone = i == 0 || 2 * i == n;
            (-(TAU * i as f64 / n as f64).cos(), if alone { 1.0 } else { 2.0 })
        });
        let full = n as f64 * anchors.yield_force;
        let mut laws = vec![law.clone()];
        for level in 1..=LEVELS {
            let pull = full * level as f64 / LEVELS as f64;
            let heavier = rocking.heavier(pull / (TAU * radius));
            laws.push(Law::new(&heavier, law.largest())?);
        }
        Ok(Ring { anchors, radius, rest: law.turn(0.0, 0.0).centre, places: places.collect(), laws })
    }

    /// Anchors that nothing has stretched.
    pub fn unstretched(&self) -> Bolts {
        Bolts { plastic: vec![0.0; self.places.len()], broken: vec![false; self.places.len()] }
    }

    /// The anchors.
    pub fn anchors(&self) -> &Anchors {
        &self.anchors
    }

    /// s_i and the number of anchors there.
    pub fn places(&self) -> &[(f64, f64)] {
        &self.places
    }

    fn level(&self, total: f64) -> (usize, f64) {
        let full = self.anchors.count as f64 * self.anchors.yield_force;
        let x = (total / full).clamp(0.0, 1.0) * LEVELS as f64;
        let low = (x as usize).min(LEVELS - 1);
        (low, x - low as f64)
    }

    /// Force [N], moment over R [N], stiffness [N/m] with s_i and with s_i² of all anchors, the foot's centre at `centre` [m].
    fn sums(&self, psi: f64, centre: f64, bolts: &Bolts) -> [f64; 5] {
        let mut sums = [0.0; 5];
        for (i, &(s, number)) in self.places.iter().enumerate() {
            let elongation = centre + psi * self.radius * s - self.rest;
            let (force, stiffness) = self.anchors.force(elongation, bolts.plastic[i], bolts.broken[i]);
            let (n, k) = (number * force, number * stiffness);
            let parts = [n, n * s, k, k * s, k * s * s];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        sums
    }

    /// What the anchors add at a rotation [rad] and a bottom pressure [Pa].
    pub fn pull(&self, psi: f64, suction: f64, bolts: &Bolts) -> Pull {
        let (sign, full) = (if psi < 0.0 { -1.0 } else { 1.0 }, self.anchors.count as f64 * self.anchors.yield_force);
        let mut centres = [0.0; LEVELS + 1];
        for (centre, law) in centres.iter_mut().zip(&self.laws) {
            *centre = law.turn(psi, suction).centre;
        }
        let span = full / LEVELS as f64;
        let centre = |total: f64| {
            let (low, share) = self.level(total);
            let sinks = centres[low + 1] - centres[low];
            (centres[low] + share * sinks, sinks / span)
        };
        // The more they pull, the less they stretch: one root.
        let (mut low, mut high) = (0.0, full);
        let mut total = 0.0;
        for _ in 0..ITERATIONS {
            let (at, slope) = centre(total);
            let [force, _, stiffness, ..] = self.sums(psi, at, bolts);
            let over = force - total;
            if over.abs() <= 1e-12 * full {
                break;
            }
            if over > 0.0 {
                low = total
            } else {
                high = total
            }
            let next = total - over / (stiffness * slope - 1.0);
            total = if next > low && next < high { next } else { 0.5 * (low + high) };
        }
        let (at, slope) = centre(total);
        let [force, turned, k0, k1, k2] = self.sums(psi, at, bolts);
        if force == 0.0 {
            return Pull { centre: at, ..Pull::default() };
        }
        let (level, share) = self.level(total);
        let [bare, below, above] = [0, level, level + 1].map(|i| self.laws[i].respond(psi, suction, 0.0, &[]));
        let moment = below.moment + share * (above.moment - below.moment);
        let tangent = below.tangent + share * (above.tangent - below.tangent);
        // dw_i = dw₀ + R s_i dψ with dw₀ = w₀' dψ + slope dQ and dQ = Σ k_i dw_i.
        let [slow, fast] = [level, level + 1].map(|i| self.laws[i].sinks(psi, suction));
        let sinks = (slow + share * (fast - slow)) * sign;
        let gain = (k0 * sinks + k1 * self.radius) / (1.0 - k0 * slope);
        let drop = sinks + slope * gain;
        let own = self.radius * (k1 * drop + k2 * self.radius);
        Pull {
            total,
            centre: at,
            response: Response {
                moment: moment - bare.moment + self.radius * turned,
                tangent: tangent - bare.tangent + own + (above.moment - below.moment) / span * gain,
            },
        }
    }

    /// The base at a rotation, a bottom pressure and a pull of the anchors; force and uplift of the wall's side are those of the strips.
    pub fn turn(&self, psi: f64, suction: f64, total: f64) -> Turn {
        let (level, share) = self.level(total);
        let [below, above] = [level, level + 1].map(|i| self.laws[i].turn(psi, suction));
        let mix = |f: fn(&Turn) -> f64| f(&below) + share * (f(&above) - f(&below));
        Turn {
            rotation: below.rotation,
            moment: mix(|t| t.moment),
            centre: mix(|t| t.centre),
            uplift: mix(|t| t.uplift),
            toe_force: mix(|t| t.toe_force),
            pull: mix(|t| t.pull),
            waves: below.waves,
        }
    }

    /// Forces at each place [N], the foot's centre at `centre` [m].
    pub fn forces<'a>(&'a self, psi: f64, centre: f64, bolts: &'a Bolts) -> impl Iterator<Item = f64> + 'a {
        self.places.iter().enumerate().map(move |(i, (s, _))| {
            let elongation = centre + psi * self.radius * s - self.rest;
            self.anchors.force(elongation, bolts.plastic[i], bolts.broken[i]).0
        })
    }

    /// Largest elongation that an anchor has, or would have were it not broken, play not counted, the foot's centre at `centre` [m].
    pub fn stretch(&self, psi: f64, centre: f64) -> f64 {
        let elongations =
            (self.places.iter()).map(|(s, _)| centre + psi * self.radius * s - self.rest - self.anchors.gap);
        elongations.fold(0.0, f64::max)
    }

    /// Energy that the anchors store [J].
    pub fn stored(&self, psi: f64, centre: f64, bolts: &Bolts) -> f64 {
        let numbers = self.places.iter().map(|(_, number)| number);
        let forces = self.forces(psi, centre, bolts);
        forces.zip(numbers).map(|(force, number)| number * 0.5 * force * force / self.anchors.stiffness).sum()
    }

    /// Stretches the anchors to where the foot is.
    pub fn commit(&self, psi: f64, centre: f64, bolts: &mut Bolts) -> Cost {
        let Anchors { stiffness, yield_force, gap, rupture, .. } = self.anchors;
        let mut cost = Cost::default();
        for (i, &(s, number)) in self.places.iter().enumerate() {
            if bolts.broken[i] {
                continue;
            }
            let e = centre + psi * self.radius * s - self.rest - gap;
            let over = e - bolts.plastic[i] - yield_force / stiffness;
            if over > 0.0 {
                bolts.plastic[i] += over;
                cost.lost += number * yield_force * over;
            }
            if rupture.is_some_and(|rupture| e > rupture) {
                let (force, _) = self.anchors.force(e + gap, bolts.plastic[i], false);
                cost.lost += number * 0.5 * force * force / stiffness;
                cost.breaks = true;
                bolts.broken[i] = true;
            }
        }
        cost
    }
}

#[cfg(test)]
mod tests;
