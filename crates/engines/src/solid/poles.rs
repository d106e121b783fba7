//! Size of the reduced space: Ritz vectors, and the poles at which they are sought.

use tank::Case;
use tank::options::solid::{Liquid, SolidOptions};

/// Ritz vectors of one direction of motion.
pub(super) const VECTORS: usize = 80;

/// Poles of the reduction other than s = 0 [rad²/s²]: none with a potential; with a displacement liquid, ω² and (2.5 ω)² with ω
/// near the first mode of the wall,
///
/// ```text
/// ω = 2π/(C H) √(E t/(ρ R))     C = 6.5, t the mean thickness (Malhotra, Wenk & Wieland 2000: C = 6.1 … 9.3)
/// ```
pub(super) fn poles(case: &Case, solid: &SolidOptions) -> Vec<f64> {
    if solid.liquid == Liquid::Potential {
        return Vec::new();
    }
    let tank = &case.tank;
    let height = tank.wall_height();
    let stiffness: f64 = tank
        .courses
        .iter()
        .map(|c| c.material.youngs_modulus * c.thickness * c.height)
        .sum();
    let (depth, radius) = (case.liquid.fill_height, tank.shape.half_length());
    let omega = std::f64::consts::TAU / (6.5 * depth) * (stiffness / height / (case.liquid.density * radius)).sqrt();
    vec![omega * omega, 6.25 * omega * omega]
}
