//! A wave that reaches the roof: a fixed roof above it, or one that floats on it.
//!
//! ```text
//! fixed     pressed from r = R (d_f + h)/(d + h)      p = ρ g (d − d_f)      share stopped s = 1 − d_f/d
//!           V = ω₁ d √(1 − (d_f/d)²)                  b = a + arctan d/R
//!           ½ ρ V² ≤ p_impact ≤ ½ ρ V² π²/(4 tan² b)
//! floating  ω_j² = g k tanh kH / (1 + (m/ρ) k tanh kH)      κ = (k² − 1/R²) η₂      ε = (η₂/R)² ½ ∫₀¹ (λ J₁′(λξ)/J₁(λ))² dξ
//! ```
//!
//! d crest at the wall, d_f freeboard, h rise of the roof and a its angle to the level at the wall, b angle between surface and roof. The surface is that of
//! the first mode, nearly a plane of the slope d/R; a cone has the slope h/R, a dome that of its cap. The stopped share of the convective mass
//! moves with the tank (Malhotra 2005). The upper bound of the impact is Wagner's wedge, whose angle is at least that below which air stays
//! under the roof and softens the blow; the lower bound is the pressure of a jet. Both are local and last milliseconds.
//!
//! A floating roof is taken as a mass m per area without stiffness: the surface carries its inertia, and the wave factors stay those of the
//! free surface. The second mode bends it: the slope of the surface is zero at the wall, so that its radial curvature there is κ, and a
//! membrane shortens in radius by ε R.

use std::f64::consts::PI;

use tank::{Case, RoofKind, Shape};

use crate::bessel::j;
use crate::mechanical::{Plan, eigenvalue, sloshing_omega};

/// Smallest angle of Wagner's wedge [rad]: below about 4° air stays under the roof (Chuang 1967).
pub const LEAST_ANGLE: f64 = 4.0 * PI / 180.0;

/// Where and how a wave meets a fixed roof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Distance from the axis from which the wave presses [m].
    pub from: f64,
    /// Pressure of the liquid at rest in the highest place [Pa], a lower bound.
    pub pressure: f64,
    /// Share of the convective mass that moves with the tank.
    pub share: f64,
    /// Velocity at which the surface meets the roof at the wall [m/s].
    pub speed: f64,
    /// Angle between surface and roof at the wall [rad].
    pub angle: f64,
    /// Range of the pressure of impact [Pa].
    pub impact: [f64; 2],
}

/// Whether a tank has a fixed roof above a free surface.
pub fn is_covered(case: &Case) -> bool {
    let roof = &case.tank.roof;
    roof.kind.is_fixed() && roof.mass > 0.0 && roof.afloat == 0.0
}

/// The contact of a wave with the crest `crest` [m] at the wall; none where it stays below a roof, or there is none.
pub fn contact(case: &Case, crest: f64) -> Option<Contact> {
    let freeboard = case.freeboard().max(0.0);
    if !is_covered(case) || crest <= freeboard {
        return None;
    }
    let (half, depth) = (case.tank.shape.half_length(), case.liquid.fill_height);
    let omega = sloshing_omega(Plan::from(case.tank.shape), 1, half, depth, case.gravity);
    let rise = case.tank.roof.rise.unwrap_or(0.0);
    let slope = match case.tank.roof.kind {
        // A cap of the radius (R² + h²)/2h.
        RoofKind::Dome => 2.0 * half * rise / (half * half - rise * rise).max(1e-6 * half * half),
        _ => rise / half,
    };
    let part = freeboard / crest;
    let speed = omega * crest * (1.0 - part * part).sqrt();
    let angle = slope.atan() + (crest / half).atan();
    let dynamic = 0.5 * case.liquid.density * speed * speed;
    let wedge = PI * PI / (4.0 * angle.max(LEAST_ANGLE).tan().powi(2));
    Some(Contact {
        from: half * (freeboard + rise) / (crest + rise),
        pressure: case.liquid.density * case.gravity * (crest - freeboard),
        share: 1.0 - part,
        speed,
        angle,
        impact: [dynamic, dynamic * wedge.max(1.0)],
    })
}

/// A sloshing mode under a floating roof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Afloat {
    /// Wave number k [1/m].
    pub wave_number: f64,
    /// Circular frequency of the free surface [rad/s].
    pub free: f64,
    /// The same with the mass of the roof [rad/s].
    pub loaded: f64,
}

/// The `n`-th mode, `n ≥ 1`, under the floating roof of a case; none without one.
pub fn afloat(case: &Case, n: usize) -> Option<Afloat> {
    let (shape, roof) = (case.tank.shape, case.tank.roof.afloat);
    if roof <= 0.0 {
        return None;
    }
    let (plan, half, depth) = (Plan::from(shape), shape.half_length(), case.liquid.fill_height);
    let wave_number = eigenvalue(plan, n) / half;
    let free = sloshing_omega(plan, n, half, depth, case.gravity);
    let carried = roof / shape.plan_area() / case.liquid.density * wave_number * (wave_number * depth).tanh();
    Some(Afloat { wave_number, free, loaded: free / (1.0 + carried).sqrt() })
}

/// What the second mode does to a floating roof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// Radial curvature at the wall [1/m].
    pub curvature: f64,
    /// Mean shortening of the radius of a membrane that stays on the surface.
    pub shortening: f64,
}

/// A floating roof on a second mode of the amplitude `wave` at the wall [m]; none of a rectangle.
pub fn bent(case: &Case, wave: f64) -> Option<Bent> {
    let Shape::Cylinder { radius } = case.tank.shape else { return None };
    let root = eigenvalue(Plan::Circle, 2);
    let curvature = (root * root - 1.0) / (radius * radius) * wave;
    // Midpoint rule; the integrand is smooth.
    let steps = 200;
    let slope = |x: f64| 0.5 * root * (j(0, root * x) - j(2, root * x)) / j(1, root);
    let sum: f64 = (0..steps).map(|i| slope((f64::from(i) + 0.5) / f64::from(steps)).powi(2)).sum();
    Some(Bent { curvature, shortening: 0.5 * sum / f64::from(steps) * (wave / radius).powi(2) })
}

#[cfg(test)]
mod tests;
