//! Anchor under a node: it pulls, and nothing pushes.
//!
//! ```text
//! e = u_z − g − e_p                elongation beyond the play g and the plastic part
//! N = k e          0 < e < N_y/k   elastic
//! N = N_y          e ≥ N_y/k       e_p grows, and stays as play
//! N = 0            e ≤ 0, or after u_z − g has passed the rupture
//! ```
//!
//! Open, broken and yielding points keep r₀ = 10⁻¹² of the stiffness. Time steps take the force at their end
//! ([`Contact::acts_at_end`]). An anchor that breaks does so at the end of a step; the energy it has stored is lost.

use super::{Contact, Element, ElementError, Inspect, Motion, Response, Trial, positive, require};
use crate::dofs::Dof;

const KIND: &str = "anchor";

/// Stiffness without resistance relative to the elastic one, as in [`super::liquid_joint`].
pub const RESIDUAL: f64 = super::liquid_joint::RESIDUAL;

/// Slots of the history.
const PLASTIC: usize = 0;
const WORK: usize = 1;
const BROKEN: usize = 2;
const SLOTS: usize = 3;

/// The element.
#[derive(Clone, Debug, PartialEq)]
pub struct Anchor {
    node: [usize; 1],
    stiffness: f64,
    strength: f64,
    gap: f64,
    rupture: Option<f64>,
}

/// An anchor in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnchorForce {
    /// N [N].
    pub force: f64,
    /// Plastic elongation e_p [m].
    pub plastic: f64,
    /// Whether it is broken.
    pub broken: bool,
}

impl Anchor {
    /// Between a node and the ground below it, z upwards.
    ///
    /// * `stiffness` k [N/m], `strength` N_y [N]
    ///
    /// Errors: a parameter that is not positive.
    pub fn new(node: usize, stiffness: f64, strength: f64) -> Result<Anchor, ElementError> {
        require(positive(stiffness), KIND, "stiffness", stiffness, "> 0 N/m")?;
        require(positive(strength), KIND, "strength", strength, "> 0 N")?;
        Ok(Anchor { node: [node], stiffness, strength, gap: 0.0, rupture: None })
    }

    /// With a play g ≥ 0 of its nut, or a pretension for g < 0 [m].
    ///
    /// Errors: a play that is not finite.
    pub fn with_gap(mut self, gap: f64) -> Result<Anchor, ElementError> {
        require(gap.is_finite(), KIND, "gap", gap, "a finite length")?;
        self.gap = gap;
        Ok(self)
    }

    /// With an elongation u_z − g > 0 at which it breaks [m].
    ///
    /// Errors: an elongation that is not positive.
    pub fn with_rupture(mut self, rupture: f64) -> Result<Anchor, ElementError> {
        require(positive(rupture), KIND, "rupture", rupture, "> 0 m")?;
        self.rupture = Some(rupture);
        Ok(self)
    }

    /// The anchor in a committed motion of its node with its `history`.
    pub fn look(&self, values: &[f64], history: &[f64]) -> AnchorForce {
        let broken = history[BROKEN] > 0.0;
        let e = values[2] - self.gap - history[PLASTIC];
        AnchorForce {
            force: if broken { 0.0 } else { (self.stiffness * e).clamp(0.0, self.strength) },
            plastic: history[PLASTIC],
            broken,
        }
    }
}

impl Element for Anchor {
    crate::answers!(KIND, node, Dof::TRANSLATIONS; massless contact inspect);

    /// Plastic elongation, energy dissipated, whether it is broken.
    fn history_len(&self) -> usize {
        SLOTS
    }

    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let k = self.stiffness;
        let elongation = motion.values[2] - self.gap;
        let e = elongation - old[PLASTIC];
        let (broken, limit) = (old[BROKEN] > 0.0, self.strength / k);
        let (force, slope) = match broken || e <= 0.0 {
            true => (RESIDUAL * k * e, RESIDUAL * k),
            false if e < limit => (k * e, k),
            false => (self.strength + RESIDUAL * k * (e - limit), RESIDUAL * k),
        };
        if want.force {
            out.force[2] += force;
        }
        if want.tangent {
            out.tangent.add(2, 2, slope);
        }
        let flow = if broken { 0.0 } else { (e - limit).max(0.0) };
        let breaks = !broken && self.rupture.is_some_and(|rupture| elongation > rupture);
        let stored = if breaks { 0.5 * force * force / k } else { 0.0 };
        new[PLASTIC] = old[PLASTIC] + flow;
        new[WORK] = old[WORK] + self.strength * flow + stored;
        new[BROKEN] = if broken || breaks { 1.0 } else { 0.0 };
        Ok(())
    }
}

impl Contact for Anchor {
    fn acts_at_end(&self) -> bool {
        true
    }

    fn switches(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(bool)) {
        see(motion.values[2] - self.gap > history.get(PLASTIC).copied().unwrap_or(0.0));
    }
}

impl Inspect for Anchor {
    fn dissipated(&self, history: &[f64]) -> f64 {
        history.get(WORK).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitQuaternion;

    use super::*;
    use crate::element::Want;

    fn step(anchor: &Anchor, up: f64, old: &[f64]) -> (f64, Vec<f64>) {
        let (mut out, mut new) = (Response::sized(3), old.to_vec());
        let motion = Motion { values: &[0.0, 0.0, up], rotations: &[UnitQuaternion::identity()] };
        anchor.respond(Trial { motion, old, new: &mut new, want: Want::ALL }, &mut out).unwrap();
        (out.force[2], new)
    }

    /// 200 kN at 100 kN/mm after 1 mm of play: it yields 2 mm further, and keeps what it has stretched as play.
    #[test]
    fn pulls_yields_and_keeps_its_play() {
        let anchor = Anchor::new(0, 1e8, 2e5).unwrap().with_gap(1e-3).unwrap();
        let fresh = [0.0; SLOTS];
        assert!(step(&anchor, -5e-3, &fresh).0.abs() < 1e-6 && step(&anchor, 1e-3, &fresh).0.abs() < 1e-9);
        assert!((step(&anchor, 2e-3, &fresh).0 - 1e5).abs() < 1e-6);
        let (force, stretched) = step(&anchor, 8e-3, &fresh);
        assert!((force - 2e5).abs() < 1e-6 && (stretched[PLASTIC] - 5e-3).abs() < 1e-12);
        // 5 mm at 200 kN.
        assert!((anchor.dissipated(&stretched) - 1e3).abs() < 1e-9);
        assert!(step(&anchor, 6e-3, &stretched).0.abs() < 1e-9);
        assert!((step(&anchor, 7e-3, &stretched).0 - 1e5).abs() < 1e-4);
        let seen = anchor.look(&[0.0, 0.0, 7e-3], &stretched);
        assert!((seen.force - 1e5).abs() < 1e-4 && seen.plastic == stretched[PLASTIC] && !seen.broken);
    }

    /// Broken at 4 mm beyond its play it never pulls again; what it had stored, 200 J, is lost besides the plastic work.
    #[test]
    fn breaks() {
        let anchor = Anchor::new(0, 1e8, 2e5).unwrap().with_rupture(4e-3).unwrap();
        let (force, broken) = step(&anchor, 5e-3, &[0.0; SLOTS]);
        assert!((force - 2e5).abs() < 1e-6 && broken[BROKEN] == 1.0);
        assert!((anchor.dissipated(&broken) - 2e5 * 3e-3 - 200.0).abs() < 1e-6);
        assert!(step(&anchor, 9e-3, &broken).0.abs() < 1e-5);
        assert_eq!(anchor.look(&[0.0, 0.0, 9e-3], &broken).force, 0.0);
    }

    #[test]
    fn bad_parameters_are_rejected() {
        assert!(Anchor::new(0, 0.0, 1.0).is_err() && Anchor::new(0, 1e8, f64::NAN).is_err());
        let anchor = Anchor::new(0, 1e8, 1e5).unwrap();
        assert!(anchor.clone().with_gap(f64::INFINITY).is_err() && anchor.with_rupture(0.0).is_err());
    }
}
