//! The liquid over a floor that turns, under a surface that is held: its moment of inertia and its pressure on the wall.
//!
//! ```text
//! r = Σ c_n J₁(λ_n r/R) ,  J₁′(λ_n) = 0 ,  c_n J₁(λ_n) = 2R/(λ_n² − 1)
//! J_f  = 2π ρ R⁵ Σ coth(λ_n H/R)/(λ_n³ (λ_n² − 1))
//! p(z) = −ρ ψ̈ R² cos θ Σ 2/(λ_n (λ_n² − 1)) cosh(λ_n (H − z)/R)/sinh(λ_n H/R)
//! ```
//!
//! The free surface is an unknown of the engine, so that it is held here. Check: ∫ p gives the moment ρ π R⁴/4 that a translation exerts on
//! the floor, Σ 2/(λ_n² (λ_n² − 1)) = 1/4.
//!
//! Of a rectangle of length L and breadth B, with k_n = (2n + 1) π/L:
//!
//! ```text
//! x = Σ c_n sin k_n x ,  c_n sin(k_n L/2) = 4/(L k_n²)
//! J_f  = 8 ρ B/L Σ coth(k_n H)/k_n⁵
//! p(z) = −ρ ψ̈ Σ 4/(L k_n³) cosh k_n(H − z)/sinh k_n H
//! ```
//!
//! Check: the moment ρ B L³/12 of a translation.

use std::f64::consts::PI;

use fem::liquid::large_wave::bessel_j;
use tank::{Case, Shape};

/// Terms of the series.
const TERMS: usize = 400;
/// Terms of pictures.
const DRAWN: usize = 15;
/// First roots of J₁′ (Abramowitz & Stegun 1964, table 9.5, and by Newton's method).
const ROOTS: [f64; 6] = [
    1.841_183_781_340_659,
    5.331_442_773_525_033,
    8.536_316_366_346_286,
    11.706_004_902_592_063,
    14.863_588_633_909_034,
    18.015_527_862_681_804,
];

/// Root n (from 0) of J₁′; beyond the table McMahon's expansion, exact within 1e-8.
fn root(n: usize) -> f64 {
    if let Some(known) = ROOTS.get(n) {
        return *known;
    }
    let beta = (n as f64 + 0.75) * PI;
    let b8 = 8.0 * beta;
    // (μ + 3)/(8β) + 4 (7 μ² + 82 μ − 9)/(3 (8β)³) + 32 (83 μ³ + 2075 μ² − 3039 μ + 3537)/(15 (8β)⁵) with μ = 4
    beta - 7.0 / b8 - 4.0 * 431.0 / (3.0 * b8.powi(3)) - 32.0 * 29_893.0 / (15.0 * b8.powi(5))
}

/// Liquid in a cylinder, or in a rectangle that turns about the middle of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Floor {
    /// Density ρ [kg/m³].
    pub density: f64,
    /// Plan.
    pub shape: Shape,
    /// Depth H [m].
    pub depth: f64,
}

impl Floor {
    /// That of a case.
    pub(crate) fn of(case: &Case) -> Floor {
        Floor { density: case.liquid.density, shape: case.tank.shape, depth: case.liquid.fill_height }
    }

    /// Distance of the wall at θ = 0 from the axis of the rotation [m].
    pub(super) fn edge(&self) -> f64 {
        match self.shape {
            Shape::Cylinder { radius } => radius,
            Shape::Rectangle { length, .. } => 0.5 * length,
        }
    }

    /// Wave number k_n [1/m], and ∫F² over F² at the wall, of the term F of the lever r cos θ or x; the area integral [m²].
    fn wave(&self, n: usize) -> (f64, f64) {
        match self.shape {
            Shape::Cylinder { radius } => {
                let l = root(n);
                (l / radius, 0.5 * PI * radius * radius * (1.0 - 1.0 / (l * l)))
            }
            Shape::Rectangle { length, breadth, .. } => ((2 * n + 1) as f64 * PI / length, 0.5 * length * breadth),
        }
    }

    /// The lever's term n on the wall at θ = 0 [m].
    fn lever(&self, n: usize) -> f64 {
        match self.shape {
            Shape::Cylinder { radius } => 2.0 * radius / (root(n).powi(2) - 1.0),
            Shape::Rectangle { length, .. } => 4.0 / (length * self.wave(n).0.powi(2)),
        }
    }

    /// J_f [kg m²].
    pub(super) fn inertia(&self) -> f64 {
        let term = |n: usize| {
            let (k, area) = self.wave(n);
            self.lever(n).powi(2) * area / (k * (k * self.depth).tanh())
        };
        self.density * (0..TERMS).map(term).sum::<f64>()
    }

    /// Term n of the series on the wall at θ = 0 [m²].
    fn term(&self, n: usize, z: f64) -> f64 {
        let (k, _) = self.wave(n);
        let e = |x: f64| (-k * x).exp();
        let ratio = e(z) * (1.0 + e(2.0 * (self.depth - z))) / (1.0 - e(2.0 * self.depth));
        self.lever(n) / k * ratio
    }

    /// p(z)/ψ̈ on the wall at θ = 0 [Pa s²].
    pub(super) fn pressure(&self, z: f64) -> f64 {
        -self.density * (0..TERMS).map(|n| self.term(n, z)).sum::<f64>()
    }

    /// −p/(ρ ψ̈) at r and θ = 0 of a cylinder, at x = r of a rectangle [m²], for pictures: the terms left out are 3e-4 of it in the corner, and less
    /// elsewhere.
    pub(crate) fn potential(&self, r: f64, z: f64) -> f64 {
        let share = |n: usize| match self.shape {
            Shape::Cylinder { radius } => bessel_j(1, root(n) * r / radius) / bessel_j(1, root(n)),
            Shape::Rectangle { length, .. } => {
                let k = self.wave(n).0;
                (k * r).sin() / (0.5 * k * length).sin()
            }
        };
        (0..DRAWN).map(|n| self.term(n, z) * share(n)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ 2/(λ² (λ² − 1)) = 1/4: the terms fall as n⁻⁴, so that 400 leave (π⁻⁴/3) 400⁻³ · 2 = 1e-10.
    #[test]
    fn the_roots_are_those_of_the_floor() {
        let sum: f64 = (0..TERMS).map(|n| root(n).powi(2)).map(|q| 2.0 / (q * (q - 1.0))).sum();
        assert!((sum - 0.25).abs() < 1e-9, "{sum}");
    }

    /// The floor's own motion: ∂φ/∂z = −x at z = 0, by a central difference about a height at which the terms left out are below 1e-3; a tenth
    /// of the radius from the axis.
    #[test]
    fn the_potential_moves_with_the_floor() {
        let floor = Floor { density: 1000.0, shape: Shape::Cylinder { radius: 2.0 }, depth: 3.0 };
        let [z, h] = [0.3, 1e-4];
        let slope = (floor.potential(0.2, z + h) - floor.potential(0.2, z - h)) / (2.0 * h);
        // cosh and sinh of the same series, summed by themselves: Σ c_n J₁(λ r/R) sinh(λ (H − z)/R)/sinh(λ H/R).
        let rate = |n: usize| {
            let l = root(n);
            let ratio = (l * (floor.depth - z) / 2.0).sinh() / (l * floor.depth / 2.0).sinh();
            2.0 * 2.0 / (l * l - 1.0) * bessel_j(1, l * 0.1) / bessel_j(1, l) * ratio
        };
        let expected = -(0..DRAWN).map(rate).sum::<f64>();
        assert!((slope / expected - 1.0).abs() < 1e-6, "{slope} {expected}");
        assert!((floor.potential(2.0, 0.5) * -1000.0 / floor.pressure(0.5) - 1.0).abs() < 1e-3);
    }

    /// The pressure on the wall of a deep tank adds up to the shear −ρ π R⁴/4 ψ̈ of a cylinder, −ρ B L³/12 ψ̈ of a rectangle; midpoint rule with 2000
    /// strips.
    #[test]
    fn the_wall_carries_the_moment_of_the_floor() {
        let cylinder = (Shape::Cylinder { radius: 2.0 }, PI * 2.0, PI * 2.0_f64.powi(4) / 4.0);
        let rectangle = (Shape::Rectangle { length: 4.0, breadth: 3.0, strip: false }, 2.0 * 3.0, 3.0 * 64.0 / 12.0);
        for (shape, width, moment) in [cylinder, rectangle] {
            let floor = Floor { density: 1000.0, shape, depth: 8.0 };
            let n = 2_000;
            let h = floor.depth / f64::from(n);
            let sum: f64 = (0..n).map(|i| floor.pressure((f64::from(i) + 0.5) * h) * h).sum();
            let expected = -1000.0 * moment;
            assert!((width * sum / expected - 1.0).abs() < 1e-4, "{shape:?}: {} {expected}", width * sum);
        }
    }

    /// J_f of a shallow rectangle is that of its added mass in a lid's gap, ρ B L⁵/(120 H): Σ 1/(2n + 1)⁶ = π⁶/960.
    #[test]
    fn a_shallow_floor_moves_the_liquid_along_it() {
        let shape = Shape::Rectangle { length: 4.0, breadth: 3.0, strip: false };
        let floor = Floor { density: 1000.0, shape, depth: 0.01 };
        let expected = 1000.0 * 3.0 * 4.0_f64.powi(5) / (120.0 * 0.01);
        assert!((floor.inertia() / expected - 1.0).abs() < 1e-4, "{} {expected}", floor.inertia());
    }
}
