//! Source:    dissertation Anhang D.4 (tank 8.1); closed form of the long uniform wall
//! Goal:      displacement, hoop force and moment of the hydrostatic state with edge disturbances
//! Model:     R = 1.83 m, 2.03 mm below and 1.27 mm above 0.915 m, E = 69 GPa, ν = 0.32
//! Expected:  the printed values, met with H = 1.52 m and γ = 9.81 kN/m³ (the dissertation states neither in D.4; with
//!            1.525 m and 10 kN/m³ of Bild 8.1 they are not met)
//! Tolerance: values of an independent finite-element solution (7320 cubic elements, converged to all digits given):
//!            2e-6, from its condition number. Printed values: 1 % for w (0.0159 cm at 0.85 m is 0.8 % above the 0.01578 that any input
//!            near the stated one gives), 0.1 % for n_φ (0.97 m and 0.14 m are rounded places of extrema); these are
//!            regression bounds, set knowing the differences

use super::*;
use crate::samples::close as near;

const RADIUS: f64 = 1.83;

fn ring(height: f64, thickness: f64) -> Ring {
    Ring { height, thickness, youngs_modulus: 69e9, poisson_ratio: 0.32 }
}

fn broad_tank() -> Wall {
    let rings = [ring(0.915, 2.03e-3), ring(0.915, 1.27e-3)];
    Wall::solve(RADIUS, &rings, 9810.0, 1.52, Base::Clamped).expect("the wall of tank 8.1 is admissible")
}

#[test]
fn broad_tank_meets_the_computed_and_the_printed_values() {
    let wall = broad_tank();
    for (z, computed, printed) in
        [(0.97, 0.020_209_7, 0.0202), (0.85, 0.015_777_5, 0.0159), (0.14, 0.033_849_9, 0.0339)]
    {
        let cm = 100.0 * wall.at(z).displacement;
        near(cm, computed, 2e-7);
        near(cm, printed, 1e-2 * printed);
    }
    for (z, computed, printed) in [(0.97, 9677.47, 9680.0), (0.915, 8491.61, 8494.0), (0.14, 25909.02, 25930.0)] {
        let force = wall.at(z).hoop_force;
        near(force, computed, 2e-6 * computed);
        near(force, printed, 1e-3 * printed);
    }
    // Printed: 0.003 and -0.016 kNm/m.
    near(wall.at(0.07).moment, 3.4836, 0.001);
    near(wall.at(0.0).moment, -16.350, 0.001);
    let highest = (0..=9000).map(|i| wall.at(1e-4 * f64::from(i)).hoop_force).fold(0.0, f64::max);
    near(highest, 25925.40, 0.05);
}

/// Long uniform wall, four wave lengths: the closed form of the clamped base holds to e^{−2π·4}.
#[test]
fn long_wall_has_the_closed_form() {
    let r = ring(10.0, 3e-3);
    let (gamma, depth) = (9810.0, 10.0);
    let lambda = r.decay(RADIUS);
    let clamped = Wall::solve(RADIUS, &[r], gamma, depth, Base::Clamped).expect("admissible");
    let poisson = 12.0 * (1.0 - 0.32_f64 * 0.32);
    let closed = -gamma * RADIUS * 3e-3 * depth * (1.0 - 1.0 / (lambda * depth)) / poisson.sqrt();
    near(clamped.at(0.0).moment, closed, 1e-9 * closed.abs());
    near(clamped.at(0.0).rotation, 0.0, 1e-15);
    let hinged = Wall::solve(RADIUS, &[r], gamma, depth, Base::Hinged).expect("admissible");
    near(hinged.at(0.0).moment, 0.0, 1e-9);
    let (z, u) = (0.1, 0.1 * lambda);
    let membrane = gamma * RADIUS * RADIUS / (69e9 * 3e-3);
    near(hinged.at(z).displacement, membrane * (depth - z - depth * (-u).exp() * u.cos()), 1e-12);
}

/// Joints and free edge; and the differential equation `K w⁗ + E s w/R² = p` through a difference of the shear
/// (truncation h²/6 of its third derivative, about 1e-5 of λ³q).
#[test]
fn equilibrium_and_continuity_hold() {
    let wall = broad_tank();
    for z in [0.915, 1.52] {
        let (below, above) = (wall.below(z), wall.at(z));
        near(below.displacement, above.displacement, 1e-14);
        near(below.rotation, above.rotation, 1e-12);
        near(below.moment, above.moment, 1e-9);
        near(below.shear, above.shear, 1e-7);
    }
    near(wall.at(1.83).moment, 0.0, 1e-10);
    near(wall.at(1.83).shear, 0.0, 1e-8);
    for z in [0.05, 0.4, 0.88, 1.0, 1.45, 1.6] {
        let h = 1e-4;
        let load = if z < 1.52 { 9810.0 * (1.52 - z) } else { 0.0 };
        let bending = -(wall.at(z + h).shear - wall.at(z - h).shear) / (2.0 * h);
        near(bending + wall.at(z).hoop_force / RADIUS, load, 1.0);
    }
}

#[test]
fn decay_length_is_as_printed() {
    // Printed 29.6 (truncated from 29.67), for s = 2.0 mm although the wall has 2.03 mm (29.90).
    let length = |s: f64| 200.0 * std::f64::consts::PI / ring(1.0, s).decay(RADIUS);
    near(length(2.0e-3), 29.67, 0.005);
    near(length(2.03e-3), 29.90, 0.005);
}

#[test]
fn inadmissible_walls_are_refused() {
    let r = ring(1.0, 2e-3);
    assert!(Wall::solve(RADIUS, &[r], 9810.0, 1.5, Base::Clamped).is_none());
    assert!(Wall::solve(-1.0, &[r], 9810.0, 0.5, Base::Clamped).is_none());
    assert!(Wall::solve(RADIUS, &[], 9810.0, 0.5, Base::Clamped).is_none());
}
