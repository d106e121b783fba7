//! First `cos θ` mode of a dry cylindrical shell: held at the base, free at the top, thickness, material and density
//! varying over the height.
//!
//! The iteration of EN 1998-4:2006 A.3.1 works on such a shell, loaded by the pressure of the liquid. With the displacements
//! `u cos θ` (up), `v sin θ` (along the circumference), `w cos θ` (outward) Sanders' strains are
//!
//! ```text
//! ε_z = u′       ε_θ = (w + v)/R        γ   = v′ − u/R
//! κ_z = −w″      κ_θ = (w + v)/R²       κ_zθ = 2w′/R + 3v′/(2R) + u/(2R²)
//! U = ½ ∫ C (ε_z² + ε_θ² + 2ν ε_z ε_θ + ½(1−ν) γ²) + D (the same of κ) dz     C = E s/(1−ν²), D = C s²/12
//! T = ½ ∫ μ_z u̇² + μ_θ v̇² + μ_r ẇ² dz                                         μ mass per area and direction
//! ```
//!
//! They vanish for translation (w = −v = 1) and rotation (u = −R, w = −v = z). Each element has cubic `w` and quadratic
//! `u`, `v`; element ends lie on the joints of the courses and at the liquid surface. The factor of the stiffness matrix is
//! kept, so that one mode costs a few back substitutions.

use tank::Course;

/// Unknowns between two nodes: `u, v, w, w′` at the lower node and `u, v` at mid-element.
const STRIDE: usize = 6;
/// Unknowns of an element.
const SIZE: usize = 10;
/// Gauss points of an element; four integrate the squares of cubics exactly.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_7, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_9, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// How the wall is held at its base; `u = v = w = 0` in both cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// `w′ = 0`.
    Clamped,
    /// `w′` free.
    Hinged,
}

impl Base {
    /// Number of unknowns of the base node that are zero.
    fn held(self) -> usize {
        match self {
            Base::Clamped => 4,
            Base::Hinged => 3,
        }
    }
}

/// A point at which densities are asked for and mode shapes are given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Height z [m].
    pub z: f64,
    /// Weight of numerical integration over the height [m].
    pub weight: f64,
    /// Wall thickness s [m].
    pub thickness: f64,
    /// Density of the wall ρ_s [kg/m³].
    pub density: f64,
}

/// Mass per area [kg/m²] by direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Outward.
    pub radial: f64,
    /// Along the circumference.
    pub circumferential: f64,
    /// Upward.
    pub axial: f64,
}

impl Inertia {
    /// The same in all directions, as of a wall of density `ρ` and thickness `s`.
    pub fn isotropic(mass: f64) -> Inertia {
        Inertia { radial: mass, circumferential: mass, axial: mass }
    }
}

/// A mode of the shell.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Outward displacement at the [`DryShell::points`], largest absolute value 1.
    pub shape: Vec<f64>,
    /// Rounds of the iteration.
    pub rounds: usize,
    vector: Vec<f64>,
}

/// A dry shell with its factored stiffness.
#[derive(Clone, Debug)]
pub struct DryShell {
    /// Lengths of the elements from the base up [m].
    lengths: Vec<f64>,
    points: Vec<Point>,
    factor: Banded,
    base: Base,
    /// Number of unknowns without those held at the base.
    unknowns: usize,
}

impl DryShell {
    /// A shell of given radius [m] and courses from the base up; `break_at` [m] (the liquid surface) becomes an element end
    /// if it lies on the wall.
    pub fn new(radius: f64, courses: &[Course], break_at: f64, support: Base) -> DryShell {
        let height: f64 = courses.iter().map(|c| c.height).sum();
        let longest = height / 40.0;
        let mut lengths = Vec::new();
        let mut points = Vec::new();
        let mut blocks = Vec::new();
        let mut base = 0.0;
        for course in courses {
            let top = base + course.height;
            let inside = break_at > base + 1e-9 * height && break_at < top - 1e-9 * height;
            let ends = if inside { vec![base, break_at, top] } else { vec![base, top] };
            for part in ends.windows(2) {
                let count = ((part[1] - part[0]) / longest).ceil().max(1.0) as usize;
                let length = (part[1] - part[0]) / count as f64;
                let block = stiffness(radius, length, course);
                for i in 0..count {
                    for (at, weight) in GAUSS {
                        points.push(Point {
                            z: part[0] + (i as f64 + at) * length,
                            weight: weight * length,
                            thickness: course.thickness,
                            density: course.material.density,
                        });
                    }
                    lengths.push(length);
                    blocks.push(block);
                }
            }
            base = top;
        }
        let unknowns = STRIDE * lengths.len() + 4 - support.held();
        let mut matrix = Banded::zeros(unknowns);
        for (e, block) in blocks.iter().enumerate() {
            for (i, values) in block.iter().enumerate() {
                for (j, value) in values.iter().enumerate().take(i + 1) {
                    if let (Some(row), Some(column)) = (unknown(support, e, i), unknown(support, e, j)) {
                        matrix.add(row, column, *value);
                    }
                }
            }
        }
        matrix.factor();
        DryShell { lengths, points, factor: matrix, base: support, unknowns }
    }

    /// Points at which inertia is asked for, from the base up.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The lowest mode, by inverse iteration from `start` or from a rotation about the base.
    ///
    /// * `inertia`: mass per area at each of the [`DryShell::points`]
    /// * `added`: pressure [Pa] at the points that a radial acceleration [m/s²] given there causes, towards the wall's
    ///   inertia (a liquid); symmetric in the sense of work
    ///
    /// Stops when the frequency is exact to rounding. Error: the last relative change if that takes more than 200 rounds.
    pub fn first_mode(
        &self,
        inertia: &[Inertia],
        added: impl Fn(&[f64]) -> Vec<f64>,
        start: Option<&Mode>,
    ) -> Result<Mode, f64> {
        let mut vector = match start {
            Some(mode) => mode.vector.clone(),
            None => self.rotation(),
        };
        let load = |vector: &[f64]| self.times_mass(inertia, &added(&self.radial(vector)), vector);
        let (mut omega_squared, mut change) = (f64::NAN, f64::INFINITY);
        let mut force = load(&vector);
        for rounds in 1..=200 {
            let mut next = force.clone();
            self.factor.solve(&mut next);
            // Rayleigh's quotient of the new vector, whose error is the square of the vector's; next·K·next = next·force.
            let stiffness: f64 = next.iter().zip(&force).map(|(x, f)| x * f).sum();
            force = load(&next);
            let mass: f64 = next.iter().zip(&force).map(|(x, f)| x * f).sum();
            let scale = 1.0 / mass.sqrt();
            next.iter_mut().for_each(|x| *x *= scale);
            force.iter_mut().for_each(|x| *x *= scale);
            vector = next;
            let before = std::mem::replace(&mut omega_squared, stiffness / mass);
            change = (omega_squared / before - 1.0).abs();
            if change <= 1e-12 {
                let mut shape = self.radial(&vector);
                let largest = shape.iter().fold(0.0f64, |m, w| if w.abs() > m.abs() { *w } else { m });
                shape.iter_mut().for_each(|w| *w /= largest);
                vector.iter_mut().for_each(|x| *x /= largest);
                return Ok(Mode { omega: omega_squared.sqrt(), shape, rounds, vector });
            }
        }
        Err(change)
    }

    /// Outward displacement at the points.
    fn radial(&self, vector: &[f64]) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.points.len());
        for (e, length) in self.lengths.iter().enumerate() {
            let local = self.local(vector, e);
            for (at, _) in GAUSS {
                let w = hermite(at, *length);
                out.push((0..4).map(|k| w[k] * local[W[k]]).sum());
            }
        }
        out
    }

    fn local(&self, vector: &[f64], element: usize) -> [f64; SIZE] {
        std::array::from_fn(|i| unknown(self.base, element, i).map_or(0.0, |row| vector[row]))
    }

    /// Forces of unit acceleration `vector` of the wall, and of the pressure at the points.
    fn times_mass(&self, inertia: &[Inertia], pressure: &[f64], vector: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.unknowns];
        for (e, length) in self.lengths.iter().enumerate() {
            let local = self.local(vector, e);
            let mut force = [0.0; SIZE];
            for (k, (at, _)) in GAUSS.iter().enumerate() {
                let q = 4 * e + k;
                let (n, h) = (quadratic(*at), hermite(*at, *length));
                let u: f64 = (0..3).map(|i| n[i] * local[U[i]]).sum();
                let v: f64 = (0..3).map(|i| n[i] * local[V[i]]).sum();
                let w: f64 = (0..4).map(|i| h[i] * local[W[i]]).sum();
                let (mass, weight) = (inertia[q], self.points[q].weight);
                for i in 0..3 {
                    force[U[i]] += weight * mass.axial * u * n[i];
                    force[V[i]] += weight * mass.circumferential * v * n[i];
                }
                for i in 0..4 {
                    force[W[i]] += weight * (mass.radial * w + pressure[q]) * h[i];
                }
            }
            for (i, f) in force.iter().enumerate() {
                if let Some(row) = unknown(self.base, e, i) {
                    out[row] += f;
                }
            }
        }
        out
    }

    /// `w = −v = z`, the start of the iteration.
    fn rotation(&self) -> Vec<f64> {
        let mut vector = vec![0.0; self.unknowns];
        let mut base = 0.0;
        for (e, length) in self.lengths.iter().enumerate() {
            let top = base + length;
            let values = [0.0, -base, base, 1.0, 0.0, -0.5 * (base + top), 0.0, -top, top, 1.0];
            for (i, x) in values.into_iter().enumerate() {
                if let Some(row) = unknown(self.base, e, i) {
                    vector[row] = x;
                }
            }
            base = top;
        }
        vector
    }
}

/// Places of `u` (lower node, middle, upper node) in an element.
const U: [usize; 3] = [0, 4, 6];
/// Places of `v`.
const V: [usize; 3] = [1, 5, 7];
/// Places of `w, w′` at the lower and the upper node.
const W: [usize; 4] = [2, 3, 8, 9];

/// Equation of local unknown `i` of an element; none for those held at the base.
fn unknown(base: Base, element: usize, i: usize) -> Option<usize> {
    (STRIDE * element + i).checked_sub(base.held())
}

/// Quadratic shape functions (lower, middle, upper) at 0 ≤ t ≤ 1.
fn quadratic(t: f64) -> [f64; 3] {
    [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)]
}

/// Cubic shape functions of Hermite for values and slopes at both ends.
fn hermite(t: f64, length: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [1.0 - 3.0 * t2 + 2.0 * t3, length * (t - 2.0 * t2 + t3), 3.0 * t2 - 2.0 * t3, length * (t3 - t2)]
}

/// Stiffness of an element per `π R` of circumference.
fn stiffness(radius: f64, length: f64, course: &Course) -> [[f64; SIZE]; SIZE] {
    let (e, nu, s) = (course.material.youngs_modulus, course.material.poisson_ratio, course.thickness);
    let membrane = e * s / (1.0 - nu * nu);
    let bending = membrane * s * s / 12.0;
    let (r, l) = (radius, length);
    let mut k = [[0.0; SIZE]; SIZE];
    for (t, weight) in GAUSS {
        let n = quadratic(t);
        let dn = [(4.0 * t - 3.0) / l, (4.0 - 8.0 * t) / l, (4.0 * t - 1.0) / l];
        let h = hermite(t, l);
        let dh = [6.0 * (t * t - t) / l, 1.0 - 4.0 * t + 3.0 * t * t, 6.0 * (t - t * t) / l, 3.0 * t * t - 2.0 * t];
        let ddh = [(12.0 * t - 6.0) / (l * l), (6.0 * t - 4.0) / l, (6.0 - 12.0 * t) / (l * l), (6.0 * t - 2.0) / l];
        // Rows ε_z, ε_θ, γ, κ_z, κ_θ, κ_zθ.
        let mut b = [[0.0; SIZE]; 6];
        for i in 0..3 {
            b[0][U[i]] = dn[i];
            b[1][V[i]] = n[i] / r;
            b[2][V[i]] = dn[i];
            b[2][U[i]] = -n[i] / r;
            b[4][V[i]] = n[i] / (r * r);
            b[5][V[i]] = 1.5 * dn[i] / r;
            b[5][U[i]] = 0.5 * n[i] / (r * r);
        }
        for i in 0..4 {
            b[1][W[i]] = h[i] / r;
            b[3][W[i]] = -ddh[i];
            b[4][W[i]] = h[i] / (r * r);
            b[5][W[i]] = 2.0 * dh[i] / r;
        }
        for (first, modulus) in [(0, membrane), (3, bending)] {
            let (x, y, xy) = (&b[first], &b[first + 1], &b[first + 2]);
            for i in 0..SIZE {
                for j in 0..SIZE {
                    k[i][j] += weight
                        * l
                        * modulus
                        * (x[i] * x[j]
                            + y[i] * y[j]
                            + nu * (x[i] * y[j] + y[i] * x[j])
                            + 0.5 * (1.0 - nu) * xy[i] * xy[j]);
                }
            }
        }
    }
    k
}

/// Symmetric positive definite band matrix, lower half, and its Cholesky factor in the same place.
#[derive(Clone, Debug)]
struct Banded {
    size: usize,
    /// Row `i` holds columns `i − SIZE + 1 … i`.
    rows: Vec<[f64; SIZE]>,
}

impl Banded {
    fn zeros(size: usize) -> Banded {
        Banded { size, rows: vec![[0.0; SIZE]; size] }
    }

    /// Adds to the entry at `row ≥ column`.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.rows[row][column + SIZE - 1 - row] += value;
    }

    fn get(&self, row: usize, column: usize) -> f64 {
        self.rows[row][column + SIZE - 1 - row]
    }

    /// Replaces the matrix by its Cholesky factor.
    fn factor(&mut self) {
        for i in 0..self.size {
            let first = (i + 1).saturating_sub(SIZE);
            for j in first..=i {
                let from = first.max((j + 1).saturating_sub(SIZE));
                let sum: f64 = (from..j).map(|k| self.get(i, k) * self.get(j, k)).sum();
                let value = self.get(i, j) - sum;
                self.rows[i][j + SIZE - 1 - i] = if i == j { value.sqrt() } else { value / self.get(j, j) };
            }
        }
    }

    /// Solves with the factored matrix in place.
    fn solve(&self, x: &mut [f64]) {
        for i in 0..self.size {
            let first = (i + 1).saturating_sub(SIZE);
            let sum: f64 = (first..i).map(|k| self.get(i, k) * x[k]).sum();
            x[i] = (x[i] - sum) / self.get(i, i);
        }
        for i in (0..self.size).rev() {
            x[i] /= self.get(i, i);
            let value = x[i];
            let first = (i + 1).saturating_sub(SIZE);
            for (k, x) in x[first..i].iter_mut().enumerate() {
                *x -= self.get(i, first + k) * value;
            }
        }
    }
}

#[cfg(test)]
mod tests;
