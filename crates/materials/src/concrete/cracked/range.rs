//! Strains in which concrete without cracks is elastic.
//!
//! ```text
//! σ_1 ≤ f_t (1 + 0.8 min(σ_2, 0)/f_c)   and   F(σ) ≤ 0
//! ```
//!
//! Convex: σ_1 is a convex and σ_2 a concave function of the stress, so that the right side is concave; the surface of
//! compression is convex. The strength of [`CrackedConcrete`] under lateral compression is bounded below and cracks need tension:
//! its range is larger.

use super::{CrackedConcrete, PARTS, SLOTS, STRAIN};
use crate::ElasticRange;

/// Share of the strength that rounding may take.
const ROUNDING: f64 = 1e-12;

impl ElasticRange<3> for CrackedConcrete {
    fn holds(&self, strain: &[f64; 3]) -> bool {
        let (c, nu) = (self.plane_modulus, self.poisson_ratio);
        let stress =
            [c * (strain[0] + nu * strain[1]), c * (strain[1] + nu * strain[0]), self.shear_modulus * strain[2]];
        let (mean, half) = (0.5 * (stress[0] + stress[1]), 0.5 * (stress[0] - stress[1]));
        let radius = (half * half + stress[2] * stress[2]).sqrt();
        let (most, least) = (mean + radius, mean - radius);
        let strength = self.traction.strength * (1.0 + 0.8 * least.min(0.0) / self.strength);
        most <= (1.0 - ROUNDING) * strength && self.surface.at(&stress).1 <= 0.0
    }

    fn moduli(&self) -> [[f64; 3]; 3] {
        self.elastic_moduli()
    }

    fn history(&self, strain: &[f64; 3], slots: &mut [f64]) {
        slots[..SLOTS].fill(0.0);
        slots[STRAIN..STRAIN + 3].copy_from_slice(strain);
        slots[PARTS] = 1.0;
    }
}
