//! Pressures over the depth at θ = 0, or on the wall across the motion.
//!
//! ```text
//! linear      P_y = P/2 [4 H − 6 h − (6 H − 12 h) y/H]/H²     per height of one half, so that force and moment are those of the mass
//!             circle p_i = 2 P_y/(π R), p_c = 16 P_y/(9 π R)  rectangle p = P_y/B
//!             h_c > 2/3 H: 0 at the base and P/H per height at the surface
//! Housner     p_i = 0.866 [1 − (y/H)²] tanh(0.866 r) ρ H a
//!             circle p_c = 0.5625 (1 − 1/3) cosh(3.674 y/D)/cosh(3.674 H/D) ρ D a
//!             rectangle p_c = 0.4165 cosh(3.162 y/L)/cosh(3.162 H/L) ρ L a
//! ```
//!
//! The factors of the circle follow from p_i ∝ cos θ and p_c ∝ (1 − cos²θ/3) cos θ: ∫ p cos θ R dθ = 2 P_y.
//!
//! Sources: ACI 350.3-06 chapter 5 with R5.3, and IITK-GSDMA 2007 4.9; both agree with public implementations. Where the convective line falls
//! below zero at the base, a triangle has the same force and acts at 2/3 H.

use std::f64::consts::PI;

use super::{Masses, Work};
use crate::mechanical::{Lumped, Plan, cosh_ratio};

/// Shape of the pressures of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A straight line with force and moment of the mass.
    Linear,
    /// Housner's parabola and the cosh of the sloshing mode.
    Housner,
}

/// Pressures of a tank per acceleration [Pa·s²/m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Field {
    shape: Shape,
    plan: Plan,
    length: f64,
    breadth: f64,
    depth: f64,
    density: f64,
    masses: Masses,
}

impl Field {
    /// Those of a tank.
    pub(crate) fn new(work: &Work, shape: Shape, masses: &Masses) -> Field {
        let liquid = work.case.liquid;
        Field {
            shape,
            plan: work.plan,
            length: work.length,
            breadth: work.breadth(),
            depth: liquid.fill_height,
            density: liquid.density,
            masses: *masses,
        }
    }

    /// Impulsive pressure at a height [m]; zero above the liquid.
    pub(crate) fn impulsive(&self, z: f64) -> f64 {
        if z > self.depth {
            return 0.0;
        }
        match self.shape {
            Shape::Linear => self.spread(2.0) * self.line(&self.masses.impulsive, z),
            Shape::Housner => {
                let zeta = z / self.depth;
                let r = self.length / self.depth;
                0.866 * (1.0 - zeta * zeta) * (0.866 * r).tanh() * self.density * self.depth
            }
        }
    }

    /// Convective pressure at a height [m]; zero above the liquid.
    pub(crate) fn convective(&self, z: f64) -> f64 {
        if z > self.depth {
            return 0.0;
        }
        let zeta = z / self.depth;
        let proportion = self.depth / self.length;
        match (self.shape, self.plan) {
            (Shape::Linear, _) => self.spread(16.0 / 9.0) * self.line(&self.masses.convective, z),
            (Shape::Housner, Plan::Circle) => {
                0.5625 * (1.0 - 1.0 / 3.0) * cosh_ratio(3.674 * proportion, zeta) * self.density * self.length
            }
            (Shape::Housner, Plan::Rectangle) => {
                0.4165 * cosh_ratio(3.162 * proportion, zeta) * self.density * self.length
            }
        }
    }

    /// Pressure over the force per height of one half [1/m]: that of a circle is `factor`/(π R).
    fn spread(&self, factor: f64) -> f64 {
        match self.plan {
            Plan::Circle => factor / (0.5 * PI * self.length),
            Plan::Rectangle => 1.0 / self.breadth,
        }
    }

    /// Force per height of one half over the acceleration [kg/m].
    fn line(&self, part: &Lumped, z: f64) -> f64 {
        let (depth, h) = (self.depth, part.lever);
        if falls_below_zero(part, depth) {
            return part.mass * z / (depth * depth);
        }
        0.5 * part.mass * (4.0 * depth - 6.0 * h - (6.0 * depth - 12.0 * h) * z / depth) / (depth * depth)
    }
}

/// Whether the line of a part is negative at the base.
pub(super) fn falls_below_zero(part: &Lumped, depth: f64) -> bool {
    part.lever > 2.0 / 3.0 * depth
}
