//! The condensed liquid of a cylinder in one of two forms.

use super::circular::CircularLiquid;
use super::super_liquid::{CondensedLiquid, Rim};

/// Liquid over wall displacements and sloshing amplitudes: dense matrices, or an operator.
#[derive(Clone, Debug)]
pub enum WallLiquid {
    /// Dense.
    Dense(CondensedLiquid),
    /// By circumferential harmonics.
    Circular(CircularLiquid),
}

impl WallLiquid {
    /// Number of wall displacements.
    pub fn wall(&self) -> usize {
        match self {
            WallLiquid::Dense(liquid) => liquid.wall,
            WallLiquid::Circular(liquid) => liquid.operator.wall(),
        }
    }

    /// Circular frequencies of the sloshing modes [rad/s].
    pub fn omega(&self) -> &[f64] {
        match self {
            WallLiquid::Dense(liquid) => &liquid.omega,
            WallLiquid::Circular(liquid) => &liquid.omega,
        }
    }

    /// Elevation at the wall, its cosines.
    pub fn rim(&self) -> &[Rim] {
        match self {
            WallLiquid::Dense(liquid) => &liquid.rim,
            WallLiquid::Circular(liquid) => &liquid.rim,
        }
    }

    /// M a + K u [N].
    pub fn forces(&self, a: &[f64], u: &[f64]) -> Vec<f64> {
        match self {
            WallLiquid::Dense(liquid) => {
                let mut force = liquid.mass.times(a);
                for (f, k) in force.iter_mut().zip(liquid.stiffness.times(u)) {
                    *f += k;
                }
                force
            }
            WallLiquid::Circular(liquid) => {
                let mut force = vec![0.0; liquid.operator.size()];
                liquid.operator.add_mass(1.0, a, &mut force);
                liquid.operator.add_stiffness(1.0, u, &mut force);
                force
            }
        }
    }
}
