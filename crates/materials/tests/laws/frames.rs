//! Rotating a strain path rotates its stresses. This includes laws with fixed crack axes, since the path determines
//! their axes.

use crate::path::{Noise, Point, norm, wander};
use crate::registry::{Case, plane, solid};

type Matrix = [[f64; 3]; 3];

/// Relative to the strength: rounding, and the tolerance of local iterations.
const TOLERANCE: f64 = 1e-8;

/// Symmetric tensor from components; `shear` 1 for stresses, 0.5 for strains.
fn tensor<const N: usize>(v: &[f64; N], shear: f64) -> Matrix {
    let mut t = [[0.0; 3]; 3];
    let mut put = |i: usize, j: usize, x: f64| {
        t[i][j] = x;
        t[j][i] = x;
    };
    put(0, 0, v[0]);
    put(1, 1, v[1]);
    if N == 3 {
        put(0, 1, shear * v[2]);
    } else {
        put(2, 2, v[2]);
        put(0, 1, shear * v[3]);
        put(1, 2, shear * v[4]);
        put(0, 2, shear * v[5]);
    }
    t
}

/// Inverse of [`tensor`].
fn components<const N: usize>(t: &Matrix, shear: f64) -> [f64; N] {
    let all = if N == 3 {
        [t[0][0], t[1][1], t[0][1] / shear, 0.0, 0.0, 0.0]
    } else {
        let [xy, yz, zx] = [t[0][1], t[1][2], t[0][2]].map(|x| x / shear);
        [t[0][0], t[1][1], t[2][2], xy, yz, zx]
    };
    std::array::from_fn(|i| all[i])
}

/// R T Rᵀ.
fn turned(r: &Matrix, t: &Matrix) -> Matrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let mut sum = 0.0;
            for k in 0..3 {
                for l in 0..3 {
                    sum += r[i][k] * t[k][l] * r[j][l];
                }
            }
            sum
        })
    })
}

/// Rotation by `b` about axis 1 after a rotation by `a` about axis 3.
fn rotation(a: f64, b: f64) -> Matrix {
    let ((sa, ca), (sb, cb)) = (a.sin_cos(), b.sin_cos());
    [[ca, -sa, 0.0], [cb * sa, cb * ca, -sb], [sb * sa, sb * ca, cb]]
}

fn check<const N: usize>(case: &Case<N>) {
    let mut noise = Noise::new(23);
    let mut worst = 0.0f64;
    for _ in 0..20 {
        let tilt = if N == 6 { 3.0 * noise.next() } else { 0.0 };
        let r = rotation(3.0 * noise.next(), tilt);
        let (mut straight, mut tilted) = (Point::new(&*case.law), Point::new(&*case.law));
        for strain in wander(&mut noise, case.strain, 4, 25) {
            let stress = straight.step(&strain).stress;
            let expected: [f64; N] = components(&turned(&r, &tensor(&stress, 1.0)), 1.0);
            let found = tilted.step(&components(&turned(&r, &tensor(&strain, 0.5)), 0.5)).stress;
            let gap: [f64; N] = std::array::from_fn(|i| found[i] - expected[i]);
            worst = worst.max(norm(&gap) / norm(&stress).max(case.strength));
        }
    }
    println!("{:30} N = {N}: {worst:.1e}", case.name);
    assert!(worst < TOLERANCE, "{}, N = {N}: {worst:e}", case.name);
}

#[test]
fn frames() {
    // A cell has directions of its own.
    plane().iter().filter(|case| case.name != "concrete, sides").for_each(check);
    solid().iter().for_each(check);
}
