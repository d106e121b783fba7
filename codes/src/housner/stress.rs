//! Wall pressures over the height, and membrane and bending stresses from them.
//!
//! ```text
//! impulsive     p_i(y) = √3 ρ a_B H_b [y/H_b − ½ (y/H_b)²] tanh(√3 a/H_b)      y below the surface, y ≤ H_b
//!               below H_b (slender tanks) the value at y = H_b
//! convective    p_k(z) = P_k/(c) · (k/a) cosh(k z_b/a)/sinh(k H_b/a)           z_b above the sloshing part's bottom
//! hoop          σ_φ = p R/s
//! axial         σ_x(z) = M(z)/W(z),  W = π D² s/4,  D = 2R
//! rectangle     each wall across the motion carries half the moment: σ = (M/2)/(b s²/6)
//! ```
//!
//! `c` is the breadth that collects the pressure: πR (circle, pressure ∝ cos θ) or 2b (both walls of a rectangle), so
//! that the pressures integrate to P_i and P_k exactly. `M(z)` is the moment at height z of the forces above it.
//!
//! Sources: Housner 1957 (impulsive pressure); the cosh shape of the first mode scaled to P_k; dissertation Anhang D
//! (W) and 8.4.2 (rectangle).

use std::f64::consts::PI;

use super::model::Response;
use crate::mechanical::Plan;

/// Pressure field of one tank.
#[derive(Clone, Copy, Debug)]
pub struct Pressures<'a> {
    /// The model's values.
    pub response: &'a Response,
    /// Circle or rectangle.
    pub plan: Plan,
    /// a = R or L [m].
    pub half_length: f64,
    /// Breadth b of a rectangle across the motion [m]; ignored for a circle.
    pub breadth: f64,
}

impl Pressures<'_> {
    /// Breadth that collects the wall pressure [m]: πR, or 2b.
    pub fn collecting_breadth(&self) -> f64 {
        match self.plan {
            Plan::Circle => PI * self.half_length,
            Plan::Rectangle => 2.0 * self.breadth,
        }
    }

    /// Depth of the liquid H [m].
    fn depth(&self) -> f64 {
        self.response.sloshing_depth + self.response.rigid_depth
    }

    /// Depth below the surface at z, limited to the sloshing part, over H_b: 0 … 1.
    fn eta(&self, z: f64) -> f64 {
        ((self.depth() - z) / self.response.sloshing_depth).clamp(0.0, 1.0)
    }

    /// Impulsive pressure at height z, in the direction of motion [Pa]; zero above the liquid.
    ///
    /// `p_i = 3 P_i/(c H_b) (η − η²/2)` with η = y/H_b, the printed formula with its resultant for its constants.
    pub fn impulsive(&self, z: f64) -> f64 {
        let eta = self.eta(z);
        let r = self.response;
        3.0 * r.impulsive_force / (self.collecting_breadth() * r.sloshing_depth) * (eta - 0.5 * eta * eta)
    }

    /// Convective pressure at height z, in the direction of motion [Pa]; zero above the liquid and in the constrained
    /// lower part.
    pub fn convective(&self, z: f64) -> f64 {
        let r = self.response;
        let above = z - r.rigid_depth;
        if above < 0.0 || z > self.depth() {
            return 0.0;
        }
        // k/a = x/H_b; cosh(x ζ)/sinh(x) without overflow.
        let ratio = crate::mechanical::cosh_ratio(r.x, above / r.sloshing_depth) / r.x.tanh();
        r.convective_force / self.collecting_breadth() * r.x / r.sloshing_depth * ratio
    }

    /// Moment at height z of the impulsive forces above it [N·m]; the wall moment at z = 0.
    pub fn impulsive_moment_above(&self, z: f64) -> f64 {
        let r = self.response;
        let h = r.sloshing_depth;
        let eta = self.eta(z);
        // Upper part: ∫₀^y (s/H − s²/(2H²)) (y − s) ds = y²·η/6 − y² η²/24, with the resultant P_i = p₀ H/3.
        let own = 3.0 * r.impulsive_force * h * (eta.powi(3) / 6.0 - eta.powi(4) / 24.0);
        let below = (r.rigid_depth - z).max(0.0);
        let rigid = if r.rigid_depth > 0.0 { r.rigid_force / r.rigid_depth * below * below / 2.0 } else { 0.0 };
        own + r.impulsive_force * below + rigid
    }

    /// Moment at height z of the convective forces above it [N·m]; the wall moment at z = 0.
    pub fn convective_moment_above(&self, z: f64) -> f64 {
        let r = self.response;
        let h = r.sloshing_depth;
        let zeta = ((z - r.rigid_depth) / h).clamp(0.0, 1.0);
        let x = r.x;
        // P_k H_b [(1 − ζ) − (cosh x − cosh xζ)/(x sinh x)].
        let own = (1.0 - zeta) - (1.0 - crate::mechanical::cosh_ratio(x, zeta)) / (x * x.tanh());
        r.convective_force * (h * own + (r.rigid_depth - z).max(0.0))
    }
}

/// Section modulus of a thin circular cross-section, `W = π D² s/4` [m³].
///
/// Check: D = 3.66 m, s = 2 mm: 0.02104 m³ (dissertation Anhang D: 0.0211).
pub fn section_modulus_circle(diameter: f64, thickness: f64) -> f64 {
    PI * diameter * diameter * thickness / 4.0
}

/// Section modulus of one wall of a rectangle, `W = b s²/6` [m³].
pub fn section_modulus_wall(breadth: f64, thickness: f64) -> f64 {
    breadth * thickness * thickness / 6.0
}

/// Hoop stress `p R/s` [Pa].
pub fn hoop(pressure: f64, radius: f64, thickness: f64) -> f64 {
    pressure * radius / thickness
}
