//! The elements under check: an entry for each way in which an element works.

use nalgebra::{UnitQuaternion, Vector3};

use crate::specimen::{Least, Specimen};

mod joints;
mod liquids;
mod solids;
mod thin;

/// All of them.
pub(crate) fn all() -> Vec<Specimen> {
    [solids::all(), thin::all(), joints::all(), liquids::all()].into_iter().flatten().collect()
}

/// Abilities among them.
pub(crate) fn least() -> Least {
    Least { dissipate: 2, mixed: 1, buckle: 4, change: 4 }
}

/// A point in turned axes.
fn turned(turn: &UnitQuaternion<f64>, x: [f64; 3]) -> [f64; 3] {
    (turn * Vector3::from(x)).into()
}

/// A point in cylindrical coordinates, in axes turned about z.
fn spun(turn: &UnitQuaternion<f64>, [r, theta, z]: [f64; 3]) -> [f64; 3] {
    [r, theta + turn.scaled_axis().z, z]
}

/// Gauss-Legendre points and weights on −1 … 1, by Newton's method on the polynomial: those of the elements are tables.
fn gauss(n: usize) -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut last, mut now) = (1.0, x);
        for k in 2..=n {
            let k = k as f64;
            (last, now) = (now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * last) / k);
        }
        (now, n as f64 * (x * now - last) / (x * x - 1.0))
    };
    let root = |i: usize| {
        let start = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        (0..50).fold(start, |x, _| {
            let (p, slope) = legendre(x);
            x - p / slope
        })
    };
    (0..n)
        .map(|i| {
            let x = root(i);
            let (_, slope) = legendre(x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// Volume of a hexahedron whose corners are interpolated in the coordinates given, with `factor` the volume of a unit box of
/// coordinates [m³]: by five points a direction, exact for the fifth and less degrees of its Jacobian.
fn volume(corners: &[[f64; 3]; 8], factor: impl Fn([f64; 3]) -> f64) -> f64 {
    const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let map = |at: [f64; 3]| {
        let mut x = Vector3::zeros();
        for (a, corner) in corners.iter().enumerate() {
            let up = if a < 4 { -1.0 } else { 1.0 };
            let [r, s] = SIGNS[a % 4];
            x += Vector3::from(*corner) * (0.125 * (1.0 + r * at[0]) * (1.0 + s * at[1]) * (1.0 + up * at[2]));
        }
        x
    };
    let mut sum = 0.0;
    for (r, a) in gauss(5) {
        for (s, b) in gauss(5) {
            for (t, c) in gauss(5) {
                // The map is linear along each parameter: differences are derivatives.
                let along = |step: [f64; 3]| {
                    let end = |sign: f64| map([r + sign * step[0], s + sign * step[1], t + sign * step[2]]);
                    (end(1.0) - end(-1.0)) * 0.5
                };
                let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(along);
                sum += a * b * c * x.cross(&y).dot(&z) * factor(map([r, s, t]).into());
            }
        }
    }
    sum
}

/// Area of a quadrilateral by `n` points a direction; a plane one is exact with one.
fn area(corners: &[[f64; 3]; 4], n: usize) -> f64 {
    let [a, b, c, d] = corners.map(Vector3::from);
    let mut sum = 0.0;
    for (r, wr) in gauss(n) {
        for (s, ws) in gauss(n) {
            let along_r = ((b - a) * (1.0 - s) + (c - d) * (1.0 + s)) * 0.25;
            let along_s = ((d - a) * (1.0 - r) + (c - b) * (1.0 + r)) * 0.25;
            sum += wr * ws * along_r.cross(&along_s).norm();
        }
    }
    sum
}
