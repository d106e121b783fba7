//! Ground under a node of a plate: it pushes, and nothing pulls.
//!
//! ```text
//! g = u_z + g₀                     distance of plate and ground
//! r = −k A g          g ≤ 0        pressed: Winkler's ground of modulus k
//! r = −r₀ k A g       else         r₀ = 10⁻¹²
//! t = k A (u_t − s) ,  |t| ≤ μ r   friction: slip s grows as far as needed; r of the last committed state
//! ```
//!
//! One point a node with the area that belongs to it: the set of pressed points is then clear, which pressures inside of elements are
//! not. r never falls with −g, so that it has a convex potential and Newton's method on the set of pressed points ends. The limit of
//! friction is that of the last step, which keeps the tangent symmetric; in the first step, from a ground without pressure, nothing
//! holds. Time steps take the force at their end ([`Contact::acts_at_end`]).
//!
//! Source: Winkler 1867; Moreau 1999 (end of the step); Simo & Hughes 1998, chapter 2 (return mapping of the slip).

use super::{Contact, Element, ElementError, Inspect, Motion, Response, Trial, not_negative, positive, require};
use crate::dofs::Dof;

const KIND: &str = "ground";

/// Stiffness of an open point relative to the pressed one, as in [`super::liquid_joint`].
pub const RESIDUAL: f64 = super::liquid_joint::RESIDUAL;

/// Slots of the history.
const SLIP: usize = 0;
const REACTION: usize = 2;
const WORK: usize = 3;
const SLOTS: usize = 4;

/// The element.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    node: [usize; 1],
    stiffness: f64,
    gap: f64,
    friction: Option<f64>,
}

/// Forces of the ground on the plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundForce {
    /// r, upwards [N].
    pub reaction: f64,
    /// Friction on the plate along x and y [N].
    pub friction: [f64; 2],
    /// Whether the plate is off the ground.
    pub open: bool,
}

impl Ground {
    /// Ground below a node, level in x and y, z upwards.
    ///
    /// * `modulus` k [N/m³], `area` A that belongs to the node [m²]
    ///
    /// Errors: a parameter that is not positive.
    pub fn new(node: usize, modulus: f64, area: f64) -> Result<Ground, ElementError> {
        require(positive(modulus), KIND, "modulus", modulus, "> 0 N/m³")?;
        require(positive(area), KIND, "area", area, "> 0 m²")?;
        Ok(Ground { node: [node], stiffness: modulus * area, gap: 0.0, friction: None })
    }

    /// With a distance g₀ ≥ 0 in the reference state [m].
    ///
    /// Errors: a distance out of range.
    pub fn with_gap(mut self, gap: f64) -> Result<Ground, ElementError> {
        require(not_negative(gap), KIND, "gap", gap, "≥ 0 m")?;
        self.gap = gap;
        Ok(self)
    }

    /// With friction of coefficient μ > 0.
    ///
    /// Errors: a coefficient out of range.
    pub fn with_friction(mut self, coefficient: f64) -> Result<Ground, ElementError> {
        require(positive(coefficient), KIND, "friction", coefficient, "> 0")?;
        self.friction = Some(coefficient);
        Ok(self)
    }

    /// Forces on the plate at a committed motion of the node with its `history`.
    pub fn look(&self, values: &[f64], history: &[f64]) -> GroundForce {
        let (reaction, _, open) = self.press(values);
        let friction = match self.friction {
            Some(_) if !open => std::array::from_fn(|i| -self.stiffness * (values[i] - history[SLIP + i])),
            _ => [0.0; 2],
        };
        GroundForce { reaction, friction, open }
    }

    /// r, −dr/du_z, and whether the point is open.
    fn press(&self, values: &[f64]) -> (f64, f64, bool) {
        let gap = values[2] + self.gap;
        let open = gap > 0.0;
        let k = if open { RESIDUAL * self.stiffness } else { self.stiffness };
        (-k * gap, k, open)
    }
}

impl Element for Ground {
    crate::answers!(KIND, node, Dof::TRANSLATIONS; massless contact inspect);

    /// With friction: slip along x and y, r, energy dissipated.
    fn history_len(&self) -> usize {
        if self.friction.is_some() { SLOTS } else { 0 }
    }

    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let (reaction, slope, open) = self.press(motion.values);
        if want.force {
            out.force[2] -= reaction;
        }
        if want.tangent {
            out.tangent.add(2, 2, slope);
        }
        let Some(coefficient) = self.friction else { return Ok(()) };
        let k = self.stiffness;
        let limit = if open { 0.0 } else { coefficient * old[REACTION] };
        let trial: [f64; 2] = std::array::from_fn(|i| k * (motion.values[i] - old[SLIP + i]));
        let size = trial[0].hypot(trial[1]);
        let slides = size >= limit;
        let share = match slides {
            true if size > 0.0 => limit / size,
            true => 0.0,
            false => 1.0,
        };
        let mut work = old[WORK];
        for i in 0..2 {
            let force = share * trial[i];
            new[SLIP + i] = motion.values[i] - force / k;
            work += force * (new[SLIP + i] - old[SLIP + i]);
            if want.force {
                out.force[i] += force;
            }
            if want.tangent {
                for (j, other) in trial.iter().enumerate() {
                    let along = if slides && size > 0.0 { trial[i] * other / (size * size) } else { 0.0 };
                    let unit = if i == j { 1.0 } else { 0.0 };
                    out.tangent.add(i, j, share * k * (unit - along));
                }
            }
        }
        new[REACTION] = reaction.max(0.0);
        new[WORK] = work;
        Ok(())
    }
}

impl Contact for Ground {
    fn acts_at_end(&self) -> bool {
        true
    }

    fn switches(&self, motion: Motion<'_>, _history: &[f64], see: &mut dyn FnMut(bool)) {
        see(!self.press(motion.values).2);
    }
}

impl Inspect for Ground {
    fn dissipated(&self, history: &[f64]) -> f64 {
        history.get(WORK).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitQuaternion;

    use super::*;
    use crate::element::Want;

    fn answer(ground: &Ground, values: [f64; 3], old: &[f64]) -> (Response, Vec<f64>) {
        let (mut out, mut new) = (Response::sized(3), old.to_vec());
        let motion = Motion { values: &values, rotations: &[UnitQuaternion::identity()] };
        ground.respond(Trial { motion, old, new: &mut new, want: Want::ALL }, &mut out).unwrap();
        (out, new)
    }

    /// 2 mm deep, on the ground after a gap, 1 mm above it.
    #[test]
    fn pushes_and_does_not_pull() {
        let ground = Ground::new(0, 1e8, 0.25).unwrap();
        assert_eq!(answer(&ground, [0.1, 0.0, -2e-3], &[]).0.force, vec![0.0, 0.0, -5e4]);
        let settled = ground.clone().with_gap(2e-3).unwrap();
        assert_eq!(answer(&settled, [0.0, 0.0, -2e-3], &[]).0.force[2], 0.0);
        let (out, _) = answer(&ground, [0.0, 0.0, 1e-3], &[]);
        assert!((0.0..1e-7).contains(&out.force[2]) && out.tangent.get(2, 2) < 1e-4);
        assert!(ground.look(&[0.0, 0.0, 1e-3], &[]).open);
    }

    /// 50 kN on the ground and μ = 0.4: it sticks up to 20 kN, then slides with that, and the energy is that of the way.
    #[test]
    fn slides_at_its_limit() {
        let ground = Ground::new(0, 1e8, 0.25).unwrap().with_friction(0.4).unwrap();
        let (_, pressed) = answer(&ground, [0.0, 0.0, -2e-3], &[0.0; SLOTS]);
        let (stuck, held) = answer(&ground, [3e-4, 4e-4, -2e-3], &pressed);
        assert!((stuck.force[0] - 7.5e3).abs() < 1e-6 && (stuck.force[1] - 1e4).abs() < 1e-6);
        assert_eq!(ground.dissipated(&held), 0.0);
        let (slid, after) = answer(&ground, [6e-3, 8e-3, -2e-3], &pressed);
        assert!((slid.force[0] - 1.2e4).abs() < 1e-6 && (slid.force[1] - 1.6e4).abs() < 1e-6);
        // 10 mm less the 0.8 mm of the spring, at 20 kN.
        assert!((ground.dissipated(&after) - 20e3 * 9.2e-3).abs() < 1e-6);
        let seen = ground.look(&[6e-3, 8e-3, -2e-3], &after);
        assert!((seen.friction[0] + 1.2e4).abs() < 1e-6 && !seen.open);
    }

    #[test]
    fn bad_parameters_are_rejected() {
        assert!(Ground::new(0, 0.0, 1.0).is_err() && Ground::new(0, 1e8, f64::NAN).is_err());
        let ground = Ground::new(0, 1e8, 1.0).unwrap();
        assert!(ground.clone().with_gap(-1e-3).is_err() && ground.with_friction(0.0).is_err());
    }
}
