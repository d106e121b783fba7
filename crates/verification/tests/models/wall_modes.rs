//! Source:    closed-form solutions of the thin-shell equations (Novozhilov strains): freely supported cylinder
//!            (shear diaphragms), and the uniform motion of a free ring
//! Goal:      wall element alone, without liquid: all three displacement components and their coupling
//! Model:     the wall elements of a uniform cylinder, assembled here with the supports of the closed form
//! Expected:  freely supported: u = U cos kz, v = V sin kz, w = W sin kz with k = nπ/L satisfy the equations exactly, so
//!            ω² are the roots of a 3 × 3 eigenproblem; free ring with ν = 0: 2 × 2 in (V, W)
//! Tolerance: 1e-4: 46 elements over half a wave to three halves (the observed error is below 3e-5 and falls with h⁴)

use engines::harmonic::{NODAL, NODE, Wall};
use fem::linalg::{Matrix, generalized_eigen};

use crate::tanks::{assert_close, case, material};
use tank::{Material, Shape};

const RADIUS: f64 = 2.0;
const LENGTH: f64 = 3.0;
const THICKNESS: f64 = 0.02;

fn steel(poisson: f64) -> Material {
    material(210e9, poisson, 7850.0)
}

/// Frequencies of the wall with the given unknowns held at both ends.
fn frequencies(poisson: f64, harmonic: u32, held: [bool; NODE], count: usize, shift: f64) -> Vec<f64> {
    let case = case(Shape::Cylinder { radius: RADIUS }, &[(LENGTH, THICKNESS)], &steel(poisson), (1000.0, LENGTH));
    let wall = Wall::new(&case.tank, LENGTH, harmonic, 1.0);
    let last = wall.nodes.len() - 1;
    let mut next = 0;
    let index: Vec<[Option<usize>; NODE]> = (0..=last)
        .map(|n| {
            std::array::from_fn(|k| {
                let free = wall.active[k] && !(held[k] && (n == 0 || n == last));
                free.then(|| {
                    next += 1;
                    next - 1
                })
            })
        })
        .collect();
    let (mut k, mut m) = (Matrix::zeros(next, next), Matrix::zeros(next, next));
    for (e, element) in wall.elements.iter().enumerate() {
        let (ke, me) = (element.condensed(&element.stiffness), element.condensed(&element.mass));
        for i in 0..NODAL {
            for j in 0..NODAL {
                if let (Some(p), Some(q)) = (index[e + i / NODE][i % NODE], index[e + j / NODE][j % NODE]) {
                    // A shift makes the stiffness of a free body definite: (K + s M) x = (ω² + s) M x.
                    k.add(p, q, ke[i][j] + shift * me[i][j]);
                    m.add(p, q, me[i][j]);
                }
            }
        }
    }
    let eigen = generalized_eigen(&k, &m, Some(count)).unwrap();
    eigen.omega.iter().map(|w| (w * w - shift).max(0.0).sqrt()).collect()
}

/// Roots ω of the 3 × 3 problem of the freely supported cylinder.
fn freely_supported(poisson: f64, m: f64, n: f64) -> Vec<f64> {
    let (e, rho) = (210e9, 7850.0);
    let c = e * THICKNESS / (1.0 - poisson * poisson);
    let d = c * THICKNESS * THICKNESS / 12.0;
    let k = n * std::f64::consts::PI / LENGTH;
    let r = RADIUS;
    // Strains as rows of (U, V, W); each is times sin kz or cos kz, whose squares have the same mean.
    let ex = [-k, 0.0, 0.0];
    let et = [0.0, m / r, 1.0 / r];
    let g = [-m / r, k, 0.0];
    let kx = [0.0, 0.0, k * k];
    let kt = [0.0, m / (r * r), m * m / (r * r)];
    let twist = [0.0, 2.0 * k / r, 2.0 * m * k / r];
    let (mut stiffness, mut mass) = (Matrix::zeros(3, 3), Matrix::zeros(3, 3));
    for i in 0..3 {
        mass.add(i, i, rho * THICKNESS);
        for j in 0..3 {
            let membrane = ex[i] * ex[j]
                + et[i] * et[j]
                + poisson * (ex[i] * et[j] + et[i] * ex[j])
                + 0.5 * (1.0 - poisson) * g[i] * g[j];
            let bending = kx[i] * kx[j]
                + kt[i] * kt[j]
                + poisson * (kx[i] * kt[j] + kt[i] * kx[j])
                + 0.5 * (1.0 - poisson) * twist[i] * twist[j];
            stiffness.add(i, j, c * membrane + d * bending);
        }
    }
    generalized_eigen(&stiffness, &mass, None).unwrap().omega
}

#[test]
fn freely_supported_cylinder() {
    for harmonic in [0, 1, 2, 3, 5] {
        let m = f64::from(harmonic);
        let mut exact: Vec<f64> = (1..=6)
            .flat_map(|n| {
                let roots = freely_supported(0.3, m, f64::from(n));
                // m = 0: the torsional family (V alone) is not an unknown of the model.
                let torsion = n as f64 * std::f64::consts::PI / LENGTH * (210e9 / (2.6 * 7850.0_f64)).sqrt();
                roots.into_iter().filter(move |w| harmonic > 0 || (w / torsion - 1.0).abs() > 1e-9)
            })
            .collect();
        if harmonic > 0 {
            // n = 0: u = U alone, each ring slides along the axis against its neighbours in shear.
            exact.push(m / RADIUS * (210e9 / (2.6 * 7850.0_f64)).sqrt());
        }
        exact.sort_by(f64::total_cmp);
        let held = [false, true, true, false];
        // m = 0 leaves the wall free to slide along its axis.
        let shift = if harmonic == 0 { 1e6 } else { 0.0 };
        let mut found = frequencies(0.3, harmonic, held, 4, shift);
        if harmonic == 0 {
            assert!(found.remove(0) < 1.0, "sliding along the axis");
        }
        for (f, e) in found.iter().zip(&exact).take(3) {
            assert_close(&format!("m = {harmonic}"), *f, *e, 1e-4);
        }
    }
}

/// Without Poisson's effect a ring of any length moves uniformly: inextensional bending (Rayleigh) and extension.
#[test]
fn free_ring() {
    for harmonic in [2, 3, 4] {
        let m = f64::from(harmonic);
        let (e, rho, r, t) = (210e9, 7850.0, RADIUS, THICKNESS);
        let (c, d) = (e * t, e * t.powi(3) / 12.0);
        let (mut k, mut mass) = (Matrix::zeros(2, 2), Matrix::zeros(2, 2));
        let (extension, bending) = ([m / r, 1.0 / r], [m / (r * r), m * m / (r * r)]);
        for i in 0..2 {
            mass.add(i, i, rho * t);
            for j in 0..2 {
                k.add(i, j, c * extension[i] * extension[j] + d * bending[i] * bending[j]);
            }
        }
        let exact = generalized_eigen(&k, &mass, None).unwrap().omega[0];
        let rayleigh = (d * m * m * (m * m - 1.0).powi(2) / (rho * t * r.powi(4) * (m * m + 1.0))).sqrt();
        assert_close("2 × 2 against Rayleigh 1894", exact, rayleigh, 2e-4);
        let found = frequencies(0.0, harmonic, [false; NODE], 1, 100.0)[0];
        assert_close("ring", found, exact, 1e-6);
    }
}
