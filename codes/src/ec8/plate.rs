//! Deflection of a rectangular wall of varying thickness under uniform load, for the flexible-wall period of
//! EN 1998-4:2006 A.4.
//!
//! A wall of a box is a plate clamped at the base and at both sides, free at the top; a strip of a long tank is a cantilever
//! in plane strain. Ritz' method minimises
//!
//! ```text
//! Π = ½ ∫∫ D(z) [(w_xx + w_zz)² − 2(1−ν)(w_xx w_zz − w_xz²)] dx dz − q ∫∫_(z ≤ H) w dx dz       D = E s³/(12(1−ν²))
//! w = Σ a_ij X_i(x/B) Z_j(z)       X_i = (1−ξ²)² ξ^(2i)  (box)   1  (strip)       Z_j cubic splines of Hermite
//! ```
//!
//! with 2B the width of the wall. The splines end at every joint of courses, so that steps of D cost no accuracy; a strip is
//! exact. A box wall converges to four digits with six functions X.

use tank::Course;

/// Number of functions X of a box wall.
const HORIZONTAL: usize = 6;
/// Elements over the height of the wall, at least.
const ELEMENTS: f64 = 8.0;

/// Sides of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sides {
    /// Clamped to the neighbouring walls, width 2B [m].
    Clamped {
        /// Half width B [m].
        half_width: f64,
    },
    /// Strip of a long wall: no deflection varies along it.
    Strip,
}

/// Deflection [m] on the vertical centre line at height `at` [m] under a uniform load [Pa] from the base up to `loaded` [m].
///
/// * `courses`: thickness and material from the base up
pub fn deflection(courses: &[Course], sides: Sides, load: f64, loaded: f64, at: f64) -> f64 {
    let (columns, half_width) = match sides {
        Sides::Clamped { half_width } => (HORIZONTAL, half_width),
        Sides::Strip => (1, 1.0),
    };
    let elements = elements(courses, &[loaded, at], ELEMENTS);
    // Deflection and slope of each node above the clamped base, for each X.
    let n = 2 * columns * elements.len();
    let mut stiffness = vec![vec![0.0; n]; n];
    let mut force = vec![0.0; n];
    let points = gauss();
    let across: Vec<Vec<[f64; 3]>> =
        points.iter().map(|(x, _)| (0..columns).map(|i| horizontal(sides, i, *x, half_width)).collect()).collect();
    let mut last: Option<(Element, Piece)> = None;
    for (e, element) in elements.iter().enumerate() {
        let known = last.take().filter(|(known, _)| known.is_like(element));
        let (_, piece) = last.insert(known.unwrap_or_else(|| (*element, Piece::new(element, &across, half_width))));
        let q = if element.base < loaded { load } else { 0.0 };
        // The deflection and slope of the first node are held.
        let held = 2 * columns;
        let first = 2 * e * columns;
        for (row, line) in piece.stiffness.iter().enumerate() {
            let Some(i) = (first + row).checked_sub(held) else { continue };
            force[i] += q * piece.load[row];
            for (column, value) in line.iter().enumerate() {
                if let Some(j) = (first + column).checked_sub(held) {
                    stiffness[i][j] += value;
                }
            }
        }
    }
    solve(stiffness, &mut force);
    // `at` is an element end (or the top): the deflection there is a nodal unknown. X_i(0) = 0 but for i = 0.
    elements
        .iter()
        .position(|e| at <= (e.base + e.length) * (1.0 + 1e-12))
        .or(elements.len().checked_sub(1))
        .map_or(0.0, |e| force[2 * e * columns])
}

/// Stiffness and forces under a unit load of one element, deflection and slope of its nodes for each X.
struct Piece {
    stiffness: Vec<Vec<f64>>,
    load: Vec<f64>,
}

impl Piece {
    /// * `across`: value, first and second derivative of each X at the points of Gauss
    fn new(element: &Element, across: &[Vec<[f64; 3]>], half_width: f64) -> Piece {
        let points = gauss();
        let columns = across.first().map_or(0, Vec::len);
        let n = 4 * columns;
        let mut piece = Piece { stiffness: vec![vec![0.0; n]; n], load: vec![0.0; n] };
        let Element { length, rigidity, nu, .. } = *element;
        // w, w_xx, w_zz, w_xz of each unknown.
        let mut b = vec![[0.0; 4]; n];
        for (t, weight_z) in &points {
            let along = hermite(*t, length);
            for (functions, (_, weight_x)) in across.iter().zip(&points) {
                let weight = weight_z * length * weight_x * half_width;
                for (j, [g, dg, ddg]) in along.iter().enumerate() {
                    for (i, [f, df, ddf]) in functions.iter().enumerate() {
                        b[j * columns + i] = [f * g, ddf * g, f * ddg, df * dg];
                    }
                }
                for ((line, load), p) in piece.stiffness.iter_mut().zip(&mut piece.load).zip(&b) {
                    *load += weight * p[0];
                    for (value, r) in line.iter_mut().zip(&b) {
                        *value += weight
                            * rigidity
                            * (p[1] * r[1]
                                + p[2] * r[2]
                                + nu * (p[1] * r[2] + p[2] * r[1])
                                + 2.0 * (1.0 - nu) * p[3] * r[3]);
                    }
                }
            }
        }
        piece
    }
}

/// A piece of the wall of constant rigidity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    /// Height of its lower end [m].
    pub base: f64,
    /// Length [m].
    pub length: f64,
    /// D [N·m].
    pub rigidity: f64,
    /// ν.
    pub nu: f64,
    /// E s [N/m].
    pub membrane: f64,
}

impl Element {
    /// Whether another element has the same stiffness: all of one course are alike.
    pub(super) fn is_like(&self, other: &Element) -> bool {
        let of = |e: &Element| [e.length, e.rigidity, e.nu, e.membrane].map(f64::to_bits);
        of(self) == of(other)
    }
}

/// Elements from the base up, `least` over the height or more; every joint and every one of `breaks` that lies on the wall is an end.
pub(super) fn elements(courses: &[Course], breaks: &[f64], least: f64) -> Vec<Element> {
    let height: f64 = courses.iter().map(|c| c.height).sum();
    let mut out = Vec::new();
    let mut base = 0.0;
    for course in courses {
        let top = base + course.height;
        let mut ends = vec![base, top];
        let inside = |z: &f64| *z > base + 1e-9 * height && *z < top - 1e-9 * height;
        ends.extend(breaks.iter().copied().filter(inside));
        ends.sort_by(f64::total_cmp);
        // Two breaks at one height count once: an element of zero length is singular.
        ends.dedup_by(|above, below| *above - *below < 1e-9 * height);
        let (e, nu, s) = (course.material.youngs_modulus, course.material.poisson_ratio, course.thickness);
        for part in ends.windows(2) {
            let count = ((part[1] - part[0]) / height * least).ceil().max(1.0);
            let length = (part[1] - part[0]) / count;
            for i in 0..count as usize {
                out.push(Element {
                    base: part[0] + i as f64 * length,
                    length,
                    rigidity: e * s.powi(3) / (12.0 * (1.0 - nu * nu)),
                    nu,
                    membrane: e * s,
                });
            }
        }
        base = top;
    }
    out
}

/// Gauss points and weights of order 15 on [0, 1], exact to degree 29: the squares of X_5 have degree 28.
pub(super) fn gauss() -> Vec<(f64, f64)> {
    const N: usize = 15;
    (0..N)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (N as f64 + 0.5)).cos();
            let mut slope = 1.0;
            // Newton's method on the Legendre polynomial; converges in five rounds.
            for _ in 0..10 {
                let (mut before, mut p) = (1.0, x);
                for k in 2..=N {
                    let k = k as f64;
                    (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
                }
                slope = N as f64 * (x * p - before) / (x * x - 1.0);
                x -= p / slope;
            }
            (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// Value, first and second derivative of Hermite's cubics (deflection and slope at the lower and the upper end).
pub(super) fn hermite(t: f64, length: f64) -> [[f64; 3]; 4] {
    let l = length;
    [
        [1.0 - 3.0 * t * t + 2.0 * t.powi(3), 6.0 * (t * t - t) / l, (12.0 * t - 6.0) / (l * l)],
        [l * (t - 2.0 * t * t + t.powi(3)), 1.0 - 4.0 * t + 3.0 * t * t, (6.0 * t - 4.0) / l],
        [3.0 * t * t - 2.0 * t.powi(3), 6.0 * (t - t * t) / l, (6.0 - 12.0 * t) / (l * l)],
        [l * (t.powi(3) - t * t), 3.0 * t * t - 2.0 * t, (6.0 * t - 2.0) / l],
    ]
}

/// Value, first and second derivative by x of X_i at ξ = x/B.
fn horizontal(sides: Sides, i: usize, xi: f64, half_width: f64) -> [f64; 3] {
    if sides == Sides::Strip {
        return [1.0, 0.0, 0.0];
    }
    // (1 − ξ²)² ξ^2i = ξ^2i − 2 ξ^(2i+2) + ξ^(2i+4).
    let mut jet = [0.0; 3];
    for (k, c) in [1.0, -2.0, 1.0].into_iter().enumerate() {
        let p = 2 * (i + k) as i32;
        let exponent = f64::from(p);
        jet[0] += c * xi.powi(p);
        if p > 0 {
            jet[1] += c * exponent * xi.powi(p - 1);
            jet[2] += c * exponent * (exponent - 1.0) * xi.powi(p - 2);
        }
    }
    [jet[0], jet[1] / half_width, jet[2] / half_width.powi(2)]
}

/// Solves the symmetric positive definite system in place by Cholesky's method.
fn solve(mut a: Vec<Vec<f64>>, x: &mut [f64]) {
    let n = x.len();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| a[i][k] * a[j][k]).sum();
            let value = a[i][j] - sum;
            a[i][j] = if i == j { value.sqrt() } else { value / a[j][j] };
        }
        let sum: f64 = (0..i).map(|k| a[i][k] * x[k]).sum();
        x[i] = (x[i] - sum) / a[i][i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| a[k][i] * x[k]).sum();
        x[i] = (x[i] - sum) / a[i][i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{self, material};

    fn course(height: f64, thickness: f64, nu: f64) -> Course {
        samples::course(height, thickness, material("concrete", 30e9, nu, 2500.0))
    }

    fn rigidity(s: f64, nu: f64) -> f64 {
        30e9 * s.powi(3) / (12.0 * (1.0 - nu * nu))
    }

    /// Cantilever under uniform load on its whole height: w = q (z⁴ − 4 h z³ + 6 h² z²)/(24 D), a polynomial of the basis.
    #[test]
    fn strip_is_a_cantilever() {
        let d = rigidity(0.3, 0.2);
        for z in [1.0, 2.5, 4.0] {
            let w = deflection(&[course(4.0, 0.3, 0.2)], Sides::Strip, 5e3, 4.0, z);
            let expected = 5e3 * (z.powi(4) - 16.0 * z.powi(3) + 96.0 * z * z) / (24.0 * d);
            assert!((w / expected - 1.0).abs() < 1e-9, "{w} {expected}");
        }
    }

    /// Load on the lower part a only: below it the cantilever of length a, above a straight line; tip w = q a³ (4h − a)/(24 D).
    #[test]
    fn load_may_end_below_the_top() {
        let w = deflection(&[course(4.0, 0.3, 0.2)], Sides::Strip, 5e3, 3.0, 4.0);
        let expected = 5e3 * 27.0 * 13.0 / (24.0 * rigidity(0.3, 0.2));
        assert!((w / expected - 1.0).abs() < 1e-9, "{w} {expected}");
    }

    /// Two thicknesses, by the unit-load integral ∫ M m/D dz (midpoint rule with 20 000 points: 1e-8).
    #[test]
    fn stepped_cantilever() {
        let courses = [course(2.0, 0.4, 0.2), course(2.0, 0.3, 0.2)];
        let n = 20_000;
        let expected: f64 = (0..n)
            .map(|i| {
                let z = 4.0 * (i as f64 + 0.5) / n as f64;
                let d = if z < 2.0 { rigidity(0.4, 0.2) } else { rigidity(0.3, 0.2) };
                5e3 * (4.0 - z).powi(2) / 2.0 * (4.0 - z) / d * 4.0 / n as f64
            })
            .sum();
        let w = deflection(&courses, Sides::Strip, 5e3, 4.0, 4.0);
        assert!((w / expected - 1.0).abs() < 1e-7, "{w} {expected}");
    }

    /// Observed in the lower of two courses, where the load ends too: EI w(z) = q (z⁴ − 4 a z³ + 6 a² z²)/24 for z ≤ a.
    #[test]
    fn heights_in_the_lower_course() {
        let courses = [course(2.0, 0.4, 0.2), course(2.0, 0.3, 0.2)];
        for (z, a) in [(0.7, 1.6), (1.6, 1.6), (1.6, 1.9), (2.0, 2.0)] {
            let w = deflection(&courses, Sides::Strip, 5e3, a, z);
            let shape = z.powi(4) - 4.0 * a * z.powi(3) + 6.0 * a * a * z * z;
            let expected = 5e3 * shape / (24.0 * rigidity(0.4, 0.2));
            assert!((w / expected - 1.0).abs() < 1e-9, "{z} {a}: {w} {expected}");
        }
        // Ends of elements: joints and breaks once each, none outside the course it belongs to.
        let ends: Vec<f64> = elements(&courses, &[0.7, 1.6, 2.0, 5.0], ELEMENTS).iter().map(|e| e.base).collect();
        assert!(ends.windows(2).all(|z| z[0] < z[1]), "{ends:?}");
        let total: f64 = elements(&courses, &[0.7, 1.6, 2.0, 5.0], ELEMENTS).iter().map(|e| e.length).sum();
        assert!((total - 4.0).abs() < 1e-12, "{total}");
        for z in [0.7, 1.6, 2.0] {
            assert!(ends.iter().any(|e| (e - z).abs() < 1e-12), "{z}: {ends:?}");
        }
    }

    /// A very wide wall bends as the cantilever in its middle; a very tall one as a beam clamped at both sides, q (2B)⁴/(384 D).
    #[test]
    fn box_wall_limits() {
        let d = rigidity(0.3, 0.2);
        let wide = deflection(&[course(4.0, 0.3, 0.2)], Sides::Clamped { half_width: 40.0 }, 5e3, 4.0, 4.0);
        assert!((wide / (5e3 * 256.0 / (8.0 * d)) - 1.0).abs() < 0.03, "{}", wide / (5e3 * 256.0 / (8.0 * d)));
        let tall = deflection(&[course(12.0, 0.3, 0.2)], Sides::Clamped { half_width: 1.0 }, 5e3, 12.0, 6.0);
        assert!((tall / (5e3 * 16.0 / (384.0 * d)) - 1.0).abs() < 0.01, "{}", tall / (5e3 * 16.0 / (384.0 * d)));
    }

    /// Free edge of a wall with uniform load on its whole height, w D/(q (2B)⁴), ν = 1/6: an independent Ritz solution with
    /// Legendre polynomials over the whole wall, 6 × 10 terms, converged to five digits.
    #[test]
    fn box_wall_against_legendre_polynomials() {
        for (ratio, expected) in [(0.6, 0.002_224_0), (1.0, 0.002_766_6), (1.5, 0.002_763_5)] {
            let (width, nu) = (2.0, 1.0 / 6.0);
            let sides = Sides::Clamped { half_width: width / 2.0 };
            let w = deflection(&[course(ratio * width, 0.3, nu)], sides, 5e3, ratio * width, ratio * width);
            let found = w * rigidity(0.3, nu) / (5e3 * width.powi(4));
            assert!((found / expected - 1.0).abs() < 5e-4, "{found} {expected}");
        }
    }
}
