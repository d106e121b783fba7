//! Warping of the foot: strips side by side under a wall whose foot need not stay plane.
//!
//! ```text
//! w(φ) = w₀ + ψ R cos φ + Σ U_n cos nφ          ∫ F(w) cos nφ dφ + π K_n U_n = 0        n = 2 … 8
//! ```
//!
//! A wall that neither stretches nor shears follows its foot, which the plate keeps round, by ovalling: u = U cos nφ, v = n U z/R, w = −n² U z/R.
//! The hoop force of the liquid, rings and the bending of the courses around resist that,
//!
//! ```text
//! K_n = n⁴ (n² − 1) ρ g H⁴/(12 R³) + n⁴ (n² − 1)²/R⁶ [Σ E I z² + ∫ D z² dz]
//! ```
//!
//! per length of the circumference: ½ ∫ N_θ (n² − 1) w²/R² dz of the hoop force N_θ = ρ g (H − z) R that turns with the wall. In series with it is
//! the membrane between a foot and a rim that both stay round, without axial force at the rim, N_zθ constant and N_θ = 0,
//!
//! ```text
//! 1/K = 1/K_n + R² [∫ dz/(G t) + n²/R² ∫ (L − z)² dz/(E t)]/(n L)²          L: height of the wall
//! ```
//!
//! which alone is what a round rim leaves.

use tank::{Case, Shape};

use crate::element::GAUSS;
use crate::error::BaseError;
use crate::rocking::{PANELS, Rocking, Turn};
use std::f64::consts::PI;

/// Waves 2 to this number are free.
const MOST: usize = 8;
/// Iterations of Newton's method at one rotation.
const ITERATIONS: usize = 60;
/// Residual at which they end, over the weight.
const SETTLED: f64 = 1e-9;
/// Uplift by which the slope of F is measured [m].
const PROBE: f64 = 1e-7;

/// Stiffness of the wall against the waves of its foot.
#[derive(Clone, Debug, PartialEq)]
pub struct Warping {
    /// K of n = 2, 3, … [N/m²].
    stiffness: Vec<f64>,
}

impl Warping {
    /// That of a tank at its fill, `None` of one that is not a cylinder; with a rim that is held `round` or is free but for its rings.
    pub fn of(case: &Case, round: bool) -> Option<Warping> {
        let tank = &case.tank;
        let Shape::Cylinder { radius } = tank.shape else { return None };
        let (height, depth) = (tank.wall_height(), case.liquid.fill_height);
        let (mut bending, mut shearing, mut axial, mut base) = (0.0, 0.0, 0.0, 0.0);
        for course in &tank.courses {
            let (from, to) = (base, base + course.height);
            let (young, nu, t) = (course.material.youngs_modulus, course.material.poisson_ratio, course.thickness);
            let cubes = |a: f64, b: f64| (b.powi(3) - a.powi(3)) / 3.0;
            bending += young * t.powi(3) / (12.0 * (1.0 - nu * nu)) * cubes(from, to);
            shearing += 2.0 * (1.0 + nu) * course.height / (young * t);
            axial += cubes(height - to, height - from) / (young * t);
            base = to;
        }
        bending += tank.rings.iter().map(|r| r.material.youngs_modulus * r.inertia * r.height * r.height).sum::<f64>();
        let liquid = case.liquid.density * case.gravity * depth.powi(4) / (12.0 * radius.powi(3));
        let of = |n: usize| {
            let n = n as f64;
            let (waves, around) = (n.powi(4), n * n - 1.0);
            let free = waves * around * (liquid + around * bending / radius.powi(6));
            let held = radius * radius * (shearing + n * n / (radius * radius) * axial) / (n * height).powi(2);
            if round { 1.0 / held } else { 1.0 / (1.0 / free + held) }
        };
        Some(Warping { stiffness: (2..=MOST).map(of).collect() })
    }

    /// K of n = 2, 3, … [N/m²].
    pub fn stiffness(&self) -> &[f64] {
        &self.stiffness
    }
}

/// w at cosines of multiples of φ.
fn uplift(waves: &[f64], reach: f64, angle: f64) -> f64 {
    let own = waves.iter().enumerate().map(|(k, u)| u * (wave(k) * angle).cos()).sum::<f64>();
    own + reach * angle.cos()
}

/// n of an unknown: w₀, U₂, U₃, …
fn wave(unknown: usize) -> f64 {
    if unknown == 0 { 0.0 } else { unknown as f64 + 1.0 }
}

impl Rocking {
    /// [`Rocking::at`] with a foot that warps; with the amplitudes w₀, U₂, U₃, … [m].
    ///
    /// Errors: a rotation that moves the rim beyond the curve, or at which no equilibrium is found.
    pub fn warped(&self, rotation: f64, suction: f64, warping: &Warping) -> Result<(Turn, Vec<f64>), BaseError> {
        let plane = self.at(rotation, suction)?;
        let reach = rotation * self.radius();
        let mut waves = vec![plane.centre];
        waves.resize(1 + warping.stiffness.len(), 0.0);
        let scale = PI * self.line_weight();
        let mut found = self.balance(&waves, reach, suction, warping);
        for _ in 0..ITERATIONS {
            let size = norm(&found.0);
            if size <= SETTLED * scale {
                return self.turned_by(rotation, suction, waves);
            }
            let step = solve(found.1, found.0);
            // A law that stiffens and softens: half of the step where the whole one does not help.
            let mut share = 1.0;
            loop {
                let next: Vec<f64> = waves.iter().zip(&step).map(|(u, s)| u - share * s).collect();
                let there = self.balance(&next, reach, suction, warping);
                if norm(&there.0) < size || share < 1e-3 {
                    (waves, found) = (next, there);
                    break;
                }
                share *= 0.5;
            }
        }
        Err(BaseError::Parameter {
            name: "rotation of a foot that warps",
            value: rotation,
            allowed: "one with an equilibrium",
        })
    }

    /// Forces on the unknowns over R, and their derivatives.
    fn balance(&self, waves: &[f64], reach: f64, suction: f64, warping: &Warping) -> (Vec<f64>, Vec<Vec<f64>>) {
        let n = waves.len();
        let (mut force, mut slope) = (vec![0.0; n], vec![vec![0.0; n]; n]);
        force[0] += PI * self.line_weight();
        for (k, stiffness) in warping.stiffness.iter().enumerate() {
            force[k + 1] += 0.5 * PI * stiffness * waves[k + 1];
            slope[k + 1][k + 1] += 0.5 * PI * stiffness;
        }
        let panels = 4 * PANELS;
        let width = PI / panels as f64;
        for panel in 0..panels {
            for (x, weight) in GAUSS {
                let angle = (panel as f64 + x) * width;
                let (w, cos) = (uplift(waves, reach, angle), angle.cos());
                let hold = |w: f64| self.hold_down_at(w, cos, suction);
                let (f, df) = (hold(w), (hold(w + PROBE) - hold(w - PROBE)) / (2.0 * PROBE));
                for i in 0..n {
                    let own = weight * width * (wave(i) * angle).cos();
                    force[i] += own * f;
                    for (j, to) in slope[i].iter_mut().enumerate() {
                        *to += own * df * (wave(j) * angle).cos();
                    }
                }
            }
        }
        (force, slope)
    }

    /// The turn with these waves.
    fn turned_by(&self, rotation: f64, suction: f64, waves: Vec<f64>) -> Result<(Turn, Vec<f64>), BaseError> {
        let reach = rotation * self.radius();
        let (from, to) = self.known();
        let panels = 4 * PANELS;
        let width = PI / panels as f64;
        let (mut moment, mut lifted) = (0.0, 0.0);
        for panel in 0..panels {
            for (x, weight) in GAUSS {
                let angle = (panel as f64 + x) * width;
                let (w, cos) = (uplift(&waves, reach, angle), angle.cos());
                if w < from || w > to {
                    return Err(BaseError::BeyondCurve { rotation, wanted: w, from, to });
                }
                moment += weight * width * cos * self.hold_down_at(w, cos, suction);
                lifted += if w > 0.0 { weight * width } else { 0.0 };
            }
        }
        let (high, low) = (uplift(&waves, reach, 0.0), uplift(&waves, reach, PI));
        let turn = Turn {
            rotation,
            moment: 2.0 * self.radius() * self.radius() * moment,
            centre: waves[0],
            uplift: high,
            toe_force: -self.hold_down_at(low, -1.0, suction),
            pull: self.hold_down_at(high, 1.0, suction),
            lifted_angle: lifted,
        };
        Ok((turn, waves))
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Solution of a small positive definite system by elimination.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;
    use crate::march::Point;

    /// Springs F = c w under the weight −c w₀: nothing warps, and M = π R³ c ψ.
    fn springs(slope: [f64; 2]) -> Rocking {
        let point = |uplift: f64| Point {
            uplift,
            hold_down: slope[usize::from(uplift > 0.0)] * uplift,
            axial_force: 0.0,
            rim_moment: 0.0,
            rotation: 0.0,
            plastic_rotation: 0.0,
            lifted_width: 0.0,
        };
        let points = [-1.0, -0.5, 0.0, 0.5, 1.0].map(point).to_vec();
        Rocking::new(10.0, 1000.0, vec![(1e5, Curve::through(points))]).unwrap()
    }

    #[test]
    fn even_springs_do_not_warp() {
        let warping = Warping { stiffness: vec![1e3; 7] };
        let (turn, waves) = springs([1e6, 1e6]).warped(1e-3, 0.0, &warping).unwrap();
        assert!((turn.moment / (PI * 1e3 * 1e6 * 1e-3) - 1.0).abs() < 1e-6, "{turn:?}");
        assert!(waves[1..].iter().all(|u| u.abs() < 1e-9), "{waves:?}");
    }

    /// A stiff wall stays plane; a soft one lifts farther and holds less.
    #[test]
    fn a_stiff_wall_stays_plane() {
        let rocking = springs([1e7, 1e6]);
        let plane = rocking.at(2e-3, 0.0).unwrap();
        let with = |k: f64| rocking.warped(2e-3, 0.0, &Warping { stiffness: vec![k; 7] }).unwrap().0;
        let stiff = with(1e14);
        assert!((stiff.moment / plane.moment - 1.0).abs() < 1e-3 && (stiff.uplift / plane.uplift - 1.0).abs() < 1e-3);
        let soft = with(1e5);
        assert!(soft.moment < plane.moment && soft.uplift > 1.02 * plane.uplift, "{soft:?} {plane:?}");
    }
}
