//! The load of a pushover: forces on the wall under a unit horizontal acceleration of ground and impulsive liquid.
//!
//! ```text
//! p(θ, z) = p_i(z) cos θ ,   q_l = ∫ p_i N_l dz = 2/(π R) (M_f ι)_l          impulsive pressure, levels l
//! f = −M_s ι                                                                   the wall's own mass, and the roof's
//! ```
//!
//! M_f is the added mass of the liquid with its surface free of pressure ([`HarmonicLiquid`], m = 1): the sloshing
//! amplitudes stay zero. The tank moves as a rigid body; a flexible wall makes the impulsive acceleration larger than
//! that of the ground and changes the pattern towards the first mode, which is for the user to judge. θ = 0 is the compressed
//! side: the inertia forces act along +x.

use std::f64::consts::PI;

use fem::linalg::Matrix;
use fem::liquid::{HarmonicLiquid, LiquidMesh};
use tank::Case;

use crate::FeError;

/// Least number of meridians that separates the harmonics 0 to 2.
const MERIDIANS: usize = 4;

/// Line loads at the levels of the wall, per unit of acceleration.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Impulsive {
    /// Levels [m].
    pub(super) levels: Vec<f64>,
    /// q at the levels [kg/m²], 0 above the liquid.
    pub(super) line: Vec<f64>,
    radius: f64,
}

impl Impulsive {
    /// For a cylinder with nodes at `levels`, one of them the surface.
    pub(super) fn new(case: &Case, radius: f64, levels: &[f64]) -> Result<Impulsive, FeError> {
        let depth = case.liquid.fill_height;
        let wetted: Vec<f64> = levels.iter().copied().filter(|z| *z < depth * (1.0 + 1e-9)).collect();
        let mesh = LiquidMesh::graded(radius, depth, 2.0);
        let liquid = HarmonicLiquid::new(radius, case.liquid.density, case.gravity, MERIDIANS, &wetted, &mesh, 0)
            .map_err(|e| FeError::Analysis(format!("impulsive pressure: {e}")))?;
        let mut translation = Matrix::zeros(liquid.wall() + liquid.elevations(), 1);
        for l in 0..wetted.len() {
            translation.add(l * MERIDIANS, 0, 1.0);
            translation.add(l * MERIDIANS + 2, 0, -1.0);
        }
        let force = liquid.mass(&translation);
        let mut line = vec![0.0; levels.len()];
        for (l, q) in line.iter_mut().enumerate().take(wetted.len()) {
            // Two of the four meridians carry the force P_l = π R q_l.
            *q = 2.0 * force.get(l * MERIDIANS, 0) / (PI * radius);
        }
        Ok(Impulsive { levels: levels.to_vec(), line, radius })
    }

    /// Horizontal force of the liquid above z, and its moment about z [kg, kg m].
    pub(super) fn above(&self, z: f64) -> (f64, f64) {
        let mut sum = (0.0, 0.0);
        for (at, q) in self.levels.iter().zip(&self.line).filter(|(at, _)| **at >= z - 1e-9) {
            sum.0 += PI * self.radius * q;
            sum.1 += PI * self.radius * q * (at - z);
        }
        sum
    }

    /// p_i at z [Pa per m/s²]: line load over the length of its level, between levels linear.
    pub(super) fn pressure(&self, z: f64) -> f64 {
        let n = self.levels.len();
        let wet = self.line.iter().take_while(|q| **q > 0.0).count().max(1);
        let at = |l: usize| {
            let below = if l == 0 { self.levels[0] } else { self.levels[l - 1] };
            let above = if l + 1 < wet.min(n) { self.levels[l + 1] } else { self.levels[l] };
            2.0 * self.line[l] / (above - below).max(f64::MIN_POSITIVE)
        };
        let i = self.levels.partition_point(|s| *s <= z).clamp(1, n - 1);
        let part = ((z - self.levels[i - 1]) / (self.levels[i] - self.levels[i - 1])).clamp(0.0, 1.0);
        if i >= wet {
            return if i - 1 < wet { (1.0 - part) * at(i - 1) } else { 0.0 };
        }
        (1.0 - part) * at(i - 1) + part * at(i)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The impulsive mass of a rigid cylinder, H/R = 1: 0.5478 of the liquid at 0.4042 of its depth (series of EN 1998-4 A.2.1).
    #[test]
    fn impulsive_mass() {
        let mut case = tank::reference::broad(1000.0);
        let radius = case.tank.shape.half_length();
        case.liquid.fill_height = radius;
        let levels: Vec<f64> = (0..=40).map(|k| radius * f64::from(k) / 40.0).collect();
        let load = Impulsive::new(&case, radius, &levels).unwrap();
        let (mass, moment) = load.above(0.0);
        let whole = case.liquid.mass(case.tank.shape);
        assert!((mass / whole - 0.5478).abs() < 0.002, "{}", mass / whole);
        assert!((moment / mass / radius - 0.4042).abs() < 0.002, "{}", moment / mass / radius);
        // The pressures carry the mass.
        let n = 4000;
        let integral: f64 = (0..n).map(|k| load.pressure(radius * (f64::from(k) + 0.5) / f64::from(n))).sum::<f64>()
            * radius
            / f64::from(n);
        assert!((integral * PI * radius / mass - 1.0).abs() < 0.01);
    }
}
