//! Flexible impulsive part of an upright cylinder, EN 1998-4:2006 A.3.1, and the iteration for its mode shape.
//!
//! The wall moves outward by `f(ζ) cos θ` (f = 0 at the base). With γ = H/R, ν_n = (2n+1)π/2 and F_n = I₁(ν_n/γ)/I₁′(ν_n/γ)
//!
//! ```text
//! p_f  = ρ H ψ cos θ Σ d_n cos(ν_n ζ) A_f        d_n = 2 ∫₀¹ f cos(ν_n ζ) dζ F_n/ν_n      b_n = 2(−1)ⁿ F_n/ν_n²
//! ψ    = ∫ f [ρ_s s/(ρH) + Σ b_n cos ν_n ζ] dζ / ∫ f [ρ_s s f/(ρH) + Σ d_n cos ν_n ζ] dζ
//! m_f  = m ψ γ Σ (−1)ⁿ d_n/ν_n
//! h_f  = H Σ d_n ((−1)ⁿν_n − 1)/ν_n² / Σ (−1)ⁿ d_n/ν_n                                        wall only
//! h_f′ = H {γ Σ d_n ((−1)ⁿν_n − 2)/ν_n² + Σ d_n/(ν_n F_n)} / {γ Σ (−1)ⁿ d_n/ν_n}                wall and base
//! ```
//!
//! f = 1 gives the rigid tank with ψ = 1. The form of h_f printed in the annex is the one *with* base pressure (−2).
//!
//! **Iteration.** f is not known beforehand. Fischer and Rammerstorfer assume one, find p_f, load the dry shell with it and
//! take the deformation as the next f. Here the pressure is a radial load on a shell in harmonic
//! motion (inverse iteration with the pressure operator), which converges to the coupled first mode in a few rounds
//! ([`coupled_mode`]). The annex replaces the pressure by an equivalent density
//! `ρ_eq(ζ) = p_f(ζ)/(2 g s(ζ)) + ρ_s`, A_f = g, the 2 because the liquid loads the radial part of the motion only
//! ([`equivalent_density_period`]). That puts `p_f/g` where `p_f/(ψ f g)` belongs and half the mass on a tangential motion
//! that is not as large as the radial one: its period is 21 to 23 % short at H/R ≤ 0.7, 17 % at 1, right at 2 and 7 % long at 3
//! (tests). It is reported for information only.
//!
//! Sources: EN 1998-4:2006 A.3.1 (informative); Fischer, Rammerstorfer, Scharf 1991; formulas re-derived by integration of
//! the pressure.

use std::f64::consts::PI;

use super::shell_mode::{Base, DryShell, Inertia, Mode, Point};
use crate::bessel::i1_over_i1_prime;
use crate::mechanical::Lumped;
use crate::procedure::CodeError;
use tank::{Course, Liquid};

/// Terms of the series. The sums of masses converge like 1/n³ (1e-5 with 80 terms); the shape is known at some 160 points.
const TERMS: usize = 80;
/// Rounds after which the iteration is given up; 2 to 4 are usual.
const ROUNDS: usize = 20;

/// Factors of a tank's series at each point of the wetted wall.
struct Wetted {
    /// `ν_n` and `(−1)ⁿ` by term.
    nu: Vec<(f64, f64)>,
    /// `F_n` by term.
    ratio: Vec<f64>,
    /// Weights of integration over ζ.
    weights: Vec<f64>,
    /// `cos(ν_n ζ)` by point and term.
    cosines: Vec<Vec<f64>>,
}

impl Wetted {
    fn new(slenderness: f64, points: impl Iterator<Item = (f64, f64)>) -> Wetted {
        let nu: Vec<(f64, f64)> =
            (0..TERMS).map(|n| ((n as f64 + 0.5) * PI, if n % 2 == 0 { 1.0 } else { -1.0 })).collect();
        let (weights, cosines) =
            points.map(|(zeta, weight)| (weight, nu.iter().map(|(nu, _)| (nu * zeta).cos()).collect())).unzip();
        Wetted { ratio: nu.iter().map(|(nu, _)| i1_over_i1_prime(nu / slenderness)).collect(), nu, weights, cosines }
    }

    /// `∫ f cos(ν_n ζ) dζ` by term.
    fn transform(&self, shape: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; TERMS];
        for ((f, weight), cosines) in shape.iter().zip(&self.weights).zip(&self.cosines) {
            for (sum, cosine) in out.iter_mut().zip(cosines) {
                *sum += weight * f * cosine;
            }
        }
        out
    }

    /// `d_n` by term.
    fn coefficients(&self, shape: &[f64]) -> Vec<f64> {
        let mut d = self.transform(shape);
        for ((d, ratio), (nu, _)) in d.iter_mut().zip(&self.ratio).zip(&self.nu) {
            *d *= 2.0 * ratio / nu;
        }
        d
    }

    /// `Σ c_n cos(ν_n ζ)` by point.
    fn sum(&self, coefficients: &[f64]) -> Vec<f64> {
        let dot = |cosines: &Vec<f64>| cosines.iter().zip(coefficients).map(|(a, b)| a * b).sum();
        self.cosines.iter().map(dot).collect()
    }

    /// The field of a shape; `wall_mass` is ρ_s s/(ρH) by point.
    fn field(&self, slenderness: f64, shape: &[f64], wall_mass: &[f64]) -> FlexibleField {
        let gamma = slenderness;
        let transform = self.transform(shape);
        let d = self.coefficients(shape);
        let (mut numerator, mut denominator) = (0.0, 0.0);
        for ((f, weight), mass) in shape.iter().zip(&self.weights).zip(wall_mass) {
            numerator += weight * f * mass;
            denominator += weight * f * f * mass;
        }
        let (mut force, mut wall, mut both) = (0.0, 0.0, 0.0);
        for n in 0..TERMS {
            let (nu, sign) = self.nu[n];
            numerator += transform[n] * 2.0 * sign * self.ratio[n] / (nu * nu);
            denominator += transform[n] * d[n];
            force += sign * d[n] / nu;
            wall += d[n] * (sign * nu - 1.0) / (nu * nu);
            both += gamma * d[n] * (sign * nu - 2.0) / (nu * nu) + d[n] / (nu * self.ratio[n]);
        }
        let participation = numerator / denominator;
        FlexibleField {
            participation,
            lumped: Lumped {
                mass: participation * gamma * force,
                lever: wall / force,
                lever_with_base: both / (gamma * force),
            },
            pressure: d.into_iter().map(|d_n| participation * d_n).collect(),
        }
    }
}

/// Pressure and resultants of the flexible impulsive part.
#[derive(Clone, Debug, PartialEq)]
pub struct FlexibleField {
    /// Participation factor ψ.
    pub participation: f64,
    /// m_f/m, h_f/H, h_f′/H.
    pub lumped: Lumped,
    /// ψ d_n.
    pressure: Vec<f64>,
}

impl FlexibleField {
    /// The field of a mode shape f(ζ) at slenderness γ = H/R; `wall_mass`: ρ_s s/(ρH) as a function of ζ.
    pub fn new(slenderness: f64, shape: impl Fn(f64) -> f64, wall_mass: impl Fn(f64) -> f64) -> FlexibleField {
        // Midpoint rule: the integrands are products of smooth functions; 400 points resolve the last of 80 terms.
        let count = 400;
        let zetas: Vec<f64> = (0..count).map(|i| (i as f64 + 0.5) / count as f64).collect();
        let wetted = Wetted::new(slenderness, zetas.iter().map(|z| (*z, 1.0 / count as f64)));
        let shape: Vec<f64> = zetas.iter().map(|z| shape(*z)).collect();
        let wall_mass: Vec<f64> = zetas.iter().map(|z| wall_mass(*z)).collect();
        wetted.field(slenderness, &shape, &wall_mass)
    }

    /// `p_f/(ρ H A_f)` at the wall, θ = 0.
    pub fn wall(&self, zeta: f64) -> f64 {
        let term = |(n, p): (usize, &f64)| p * ((n as f64 + 0.5) * PI * zeta).cos();
        self.pressure.iter().enumerate().map(term).sum()
    }
}

/// First impulsive mode of a tank.
#[derive(Clone, Debug, PartialEq)]
pub struct FlexibleMode {
    /// Period T_f [s].
    pub period: f64,
    /// Pressure and resultants.
    pub field: FlexibleField,
    /// Heights [m] and radial shape f, largest value 1, wetted part.
    pub shape: Vec<(f64, f64)>,
    /// Rounds of the iteration.
    pub rounds: usize,
}

/// A tank wall with its liquid, ready for iterations.
struct WetShell {
    shell: DryShell,
    wetted: Wetted,
    slenderness: f64,
    /// Number of points below the liquid surface.
    wet: usize,
    /// ρ H.
    scale: f64,
    wall_mass: Vec<f64>,
}

impl WetShell {
    fn new(radius: f64, courses: &[Course], liquid: Liquid, base: Base) -> WetShell {
        let depth = liquid.fill_height;
        let shell = DryShell::new(radius, courses, depth, base);
        let wet = shell.points().iter().take_while(|p| p.z < depth).count();
        let points = shell.points()[..wet].iter();
        let scale = liquid.density * depth;
        WetShell {
            wetted: Wetted::new(depth / radius, points.clone().map(|p| (p.z / depth, p.weight / depth))),
            slenderness: depth / radius,
            wet,
            scale,
            wall_mass: points.map(|p| p.density * p.thickness / scale).collect(),
            shell,
        }
    }

    fn field(&self, shape: &[f64]) -> FlexibleField {
        self.wetted.field(self.slenderness, &shape[..self.wet], &self.wall_mass)
    }

    fn inertia(&self, of: impl Fn(usize, &Point) -> Inertia) -> Vec<Inertia> {
        self.shell.points().iter().enumerate().map(|(q, p)| of(q, p)).collect()
    }

    fn not_converged(what: &str, iterations: usize, change: f64) -> CodeError {
        CodeError::NotConverged { clause: "EN 1998-4:2006 A.3.1".into(), what: what.into(), iterations, change }
    }
}

/// First impulsive mode of a cylindrical tank whose wall is held at its base.
///
/// * `radius`: R [m]; `courses` from the base up; `liquid`: ρ, H (at most the height of the wall)
///
/// Error: not converged in 200 rounds.
pub fn coupled_mode(radius: f64, courses: &[Course], liquid: Liquid, base: Base) -> Result<FlexibleMode, CodeError> {
    let tank = WetShell::new(radius, courses, liquid, base);
    let inertia = tank.inertia(|_, p| Inertia::isotropic(p.density * p.thickness));
    let pressure = |acceleration: &[f64]| {
        let d = tank.wetted.coefficients(&acceleration[..tank.wet]);
        let mut p = tank.wetted.sum(&d);
        p.iter_mut().for_each(|p| *p *= tank.scale);
        p.resize(acceleration.len(), 0.0);
        p
    };
    let mode: Mode = tank
        .shell
        .first_mode(&inertia, pressure, None)
        .map_err(|change| WetShell::not_converged("the mode shape of the wall with liquid", 200, change))?;
    let points = tank.shell.points()[..tank.wet].iter();
    Ok(FlexibleMode {
        period: 2.0 * PI / mode.omega,
        field: tank.field(&mode.shape),
        shape: points.zip(&mode.shape).map(|(p, f)| (p.z, *f)).collect(),
        rounds: mode.rounds,
    })
}

/// Period [s] by the annex's equivalent density, as printed; see the head of this module for its errors.
///
/// Error: f still changes by more than 1 % after 20 rounds.
pub fn equivalent_density_period(radius: f64, courses: &[Course], liquid: Liquid) -> Result<f64, CodeError> {
    let what = "the equivalent density";
    let tank = WetShell::new(radius, courses, liquid, Base::Clamped);
    let depth = liquid.fill_height;
    let mut shape: Vec<f64> = tank.shell.points().iter().map(|p| p.z / depth).collect();
    let mut change = f64::INFINITY;
    for _ in 0..ROUNDS {
        let field = tank.field(&shape);
        let added = tank.wetted.sum(&field.pressure);
        let inertia = tank.inertia(|q, p| {
            // Truncation of the series may leave a tiny suction at the surface.
            let liquid = added.get(q).map_or(0.0, |p_f| 0.5 * tank.scale * p_f.max(0.0));
            Inertia::isotropic(p.density * p.thickness + liquid)
        });
        let next = tank
            .shell
            .first_mode(&inertia, |w| vec![0.0; w.len()], None)
            .map_err(|change| WetShell::not_converged(what, 200, change))?;
        change = next.shape.iter().zip(&shape).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
        if change < 0.01 {
            return Ok(2.0 * PI / next.omega);
        }
        shape = next.shape;
    }
    Err(WetShell::not_converged(what, ROUNDS, change))
}

/// Impulsive period T_f [s] by the approximate formula of A.3.1; E and s_⅓ at z = H/3.
///
/// In some reproductions g_γ stands in the denominator of the frequency; only this form agrees with shell theory.
pub(super) const PERIOD: &str = "2·R/g_γ·√(ρ·H/(E·s_⅓))";
/// Its coefficient g_γ.
pub(super) const COEFFICIENT: &str = "0.01675·γ² - 0.15·γ + 0.46";

#[cfg(test)]
mod tests;
