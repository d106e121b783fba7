//! Source:    potential flow between the rigid bottom and a surface without pressure, to first order in the deviation w = a f(z) cos 3θ
//! Goal:      the coupling of harmonics by a liquid that follows an imperfect wall
//! Model:     the cylinder of 1.83 m with 1.5 m of water; wall motion z/L e_x, forces on cos kθ z/L along the radius and on
//!            sin kθ z/L along the circumference
//! Expected:  docs/theory/imperfections.md, section 4
//! Tolerance: 3 %: velocities have a logarithm where wall and surface meet, and the error there falls with the first power of an element's
//!            height over the depth, 1/48
//!
//! ```text
//! φ = P(r, z) cos θ + a Σ_k Q_k(r, z) cos kθ, k = 2, 4        P,r = G = z/L at r = R        P = Q = 0 at z = H
//! 2 Q_k,r = (f P,z),z + s_k (f G/R − f P/R²)                    s_2 = −2, s_4 = 4
//! ```

use fem::dofs::Dof;
use fem::linalg::{Kind, Ordering, Symbolic, dot};
use tank::{Case, Shape};

use super::*;
use crate::solid::form::Form;

const RADIUS: f64 = 1.83;
const HEIGHT: f64 = 1.8;
const DEPTH: f64 = 1.5;
const AMPLITUDE: f64 = 3e-5;
/// Terms of the series of P, and of Q, whose terms fall with the square.
const TERMS: [usize; 2] = [1500, 200];
/// Points over the depth.
const POINTS: usize = 6000;

/// I_k(x)/I_k'(x), by the ratios I_{k+1}/I_k downwards.
fn over_slope(k: u32, x: f64) -> f64 {
    let start = k + 60 + x as u32;
    let ratio = (k..start).rev().fold(0.0, |next, n| 1.0 / (2.0 * f64::from(n + 1) / x + next));
    1.0 / (ratio + f64::from(k) / x)
}

/// Forces over density on the radial and the tangential motion of harmonics 2 and 4, over the amplitude.
fn exact() -> [[f64; 2]; 2] {
    let lambda = |n: usize| (n as f64 + 0.5) * std::f64::consts::PI / DEPTH;
    let step = DEPTH / POINTS as f64;
    // Points in the middle of equal steps of s, z = H (1 − (1 − s)²): P,z has a logarithm at the surface.
    let points: Vec<(f64, f64)> = (0..POINTS)
        .map(|i| (i as f64 + 0.5) / POINTS as f64)
        .map(|s| (DEPTH * (1.0 - (1.0 - s) * (1.0 - s)), 2.0 * (1.0 - s) * step))
        .collect();
    let linear = |z: f64| z / HEIGHT;
    let integral = |of: &dyn Fn(usize) -> f64| -> f64 { (0..POINTS).map(|i| of(i) * points[i].1).sum() };
    let (mut p, mut slope) = (vec![0.0; POINTS], vec![0.0; POINTS]);
    for n in 0..TERMS[0] {
        let l = lambda(n);
        // 2/H ∫ z cos λz dz/L.
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let a = 2.0 / DEPTH * (DEPTH * sign / l - 1.0 / (l * l)) / HEIGHT * over_slope(1, l * RADIUS) / l;
        for (i, (z, _)) in points.iter().enumerate() {
            let (sine, cosine) = (l * z).sin_cos();
            p[i] += a * cosine;
            slope[i] -= a * l * sine;
        }
    }
    [(2_u32, -2.0), (4, 4.0)].map(|(k, s)| {
        let mut radial = 0.5 * integral(&|i| linear(points[i].0).powi(2) * (linear(points[i].0) + p[i] / RADIUS));
        let mut half = 0.0;
        for n in 0..TERMS[1] {
            if n == TERMS[1] / 2 {
                half = radial;
            }
            let l = lambda(n);
            let flux = integral(&|i| {
                let (z, g) = (points[i].0, linear(points[i].0));
                let (sine, cosine) = (l * z).sin_cos();
                0.5 * (l * g * slope[i] * sine + s * g * (g / RADIUS - p[i] / (RADIUS * RADIUS)) * cosine)
            });
            let shape = integral(&|i| linear(points[i].0) * (l * points[i].0).cos());
            radial += 2.0 / DEPTH * flux * over_slope(k, l * RADIUS) / l * shape;
        }
        // What is missing falls with the number of terms.
        radial += radial - half;
        let around = 1.5 * integral(&|i| linear(points[i].0).powi(2) * p[i]);
        // The area is R dθ dz; w,θ/R takes the radius of the tangential force away.
        [std::f64::consts::PI * RADIUS * radial, std::f64::consts::PI * around]
    })
}

/// The same of the three-dimensional engine on a mesh of so many elements over the radius, around and over the height.
fn computed(case: &Case, [radial, sectors, vertical]: [usize; 3]) -> [[f64; 2]; 2] {
    let solid = SolidOptions { mesh: Some(MeshSize { radial, sectors, vertical }), ..solid(AMPLITUDE, 0.0) };
    let form = Form::of(case, &solid.imperfections);
    let tank = TankModel::formed(case, &options(), &solid, &form).unwrap();
    let (model, dofs) = (&tank.model, tank.model.dofs());
    let mass = tank.assembler.mass(model);
    // A motion along e_x, or a harmonic along radius or circumference.
    let motion = |of: &dyn Fn(f64) -> [f64; 2]| -> Vec<f64> {
        let mut x = vec![0.0; dofs.len()];
        for (row, z) in tank.wall.rows.iter().zip(&tank.wall.z) {
            for (sector, &node) in row.iter().enumerate() {
                let theta = std::f64::consts::TAU * sector as f64 / row.len() as f64;
                for (dof, value) in [Dof::Ux, Dof::Uy].into_iter().zip(of(theta)) {
                    if let Some(e) = dofs.equation(node, dof) {
                        x[e] = value * z / HEIGHT;
                    }
                }
            }
        }
        x
    };
    let surface: std::collections::HashSet<usize> = tank.volume.surface_nodes.iter().copied().collect();
    let free: Vec<usize> = (0..dofs.len())
        .filter(|&e| {
            let (node, dof) = dofs.unknown(e);
            dof == Dof::Phi && !surface.contains(&node)
        })
        .collect();
    let mut h = mass.submatrix(&free);
    h.values.iter_mut().for_each(|v| *v = -*v);
    let symbolic = std::sync::Arc::new(Symbolic::new(h.pattern.clone(), &Ordering::MinimumDegree).unwrap());
    let flow = mass.times(&motion(&|_| [1.0, 0.0]));
    let right: Vec<f64> = free.iter().map(|&e| flow[e]).collect();
    let solved = symbolic.factor(&h, Kind::Definite).unwrap().solve_vector(&right).unwrap();
    let mut phi = vec![0.0; dofs.len()];
    free.iter().zip(solved).for_each(|(&e, v)| phi[e] = v);
    let force = mass.times(&phi);
    [2.0, 4.0].map(|k: f64| {
        let along = |theta: f64| (k * theta).cos();
        let around = |theta: f64| (k * theta).sin();
        let radial = motion(&|t| [along(t) * t.cos(), along(t) * t.sin()]);
        let tangential = motion(&|t| [-around(t) * t.sin(), around(t) * t.cos()]);
        [radial, tangential].map(|m| dot(&force, &m) / (case.liquid.density * AMPLITUDE))
    })
}

#[test]
fn an_imperfect_liquid_couples_harmonics_as_potential_flow_does() {
    let material = tank::reference::material(69e9, 0.32, 2750.0);
    let shape = Shape::Cylinder { radius: RADIUS };
    let case = tank::reference::case(shape, &[(HEIGHT, 3e-3)], &material, (1000.0, DEPTH));
    let (expected, found) = (exact(), computed(&case, [24, 48, 48]));
    for (expected, found) in expected.iter().flatten().zip(found.iter().flatten()) {
        assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
    }
}
