//! Size of the reduced space: Ritz vectors, and the poles at which they are sought.

use tank::options::solid::{Liquid, SolidOptions};
use tank::{Case, Shape};

/// Ritz vectors of one direction of motion.
pub(super) const VECTORS: usize = 80;

/// Poles of the reduction other than s = 0 [rad²/s²].
///
/// None with a potential in a cylinder, where the load excites a dozen waves before the first mode of the wall. In a rectangle it excites
/// waves in both directions, hundreds before that mode: ω² and (2.5 ω)² with ω near the first mode of the longer wall
/// ([`crate::estimate::first_plate_frequency`]). With a displacement liquid in a cylinder, the same with ω near the first mode of the wall,
///
/// ```text
/// ω = 2π/(C H) √(E t/(ρ R))     C = 6.5, t the mean thickness (Malhotra, Wenk & Wieland 2000: C = 6.1 … 9.3)
/// ```
pub(super) fn poles(case: &Case, solid: &SolidOptions) -> Vec<f64> {
    let tank = &case.tank;
    if let Shape::Rectangle { length, breadth, .. } = tank.shape {
        let omega = crate::estimate::first_plate_frequency(case, length.max(breadth));
        return vec![omega * omega, 6.25 * omega * omega];
    }
    if solid.liquid == Liquid::Potential {
        return Vec::new();
    }
    let height = tank.wall_height();
    let stiffness: f64 = tank.courses.iter().map(|c| c.material.youngs_modulus * c.thickness * c.height).sum();
    let (depth, radius) = (case.liquid.fill_height, tank.shape.half_length());
    let omega = std::f64::consts::TAU / (6.5 * depth) * (stiffness / height / (case.liquid.density * radius)).sqrt();
    vec![omega * omega, 6.25 * omega * omega]
}
