//! Joints of a liquid's face and the wall behind it that are open at some meridians only.
//!
//! ```text
//! P = P₀ − B_o diag(k̄ − k_i) B_oᵀ          P₀: all joints of a level closed, k̄;  B_o: closings of the open ones
//! P⁻¹ = P₀⁻¹ + P₀⁻¹ B_o Q⁻¹ B_oᵀ P₀⁻¹      Q = diag(1/(k̄ − k_i)) − B_oᵀ P₀⁻¹ B_o
//! ```
//!
//! P₀ is block-circulant, so that the compliances B_oᵀ P₀⁻¹ B_o of any two joints follow from one small matrix for each harmonic, C^(m) over
//! the levels:
//!
//! ```text
//! c(i, j; θ) = Σ_m s_m² C^(m)_ij cos mθ          full circle: c(θ_k − θ_l)          half: c(θ_k − θ_l) + c(θ_k + θ_l)
//! ```
//!
//! with s_m the norm of the harmonic ([`Ring::scale`]). Q is positive definite where P₀ and P are. A joint in the mean of its level instead
//! (half open, half as stiff) is as wrong for those that are closed as for those that are open; since k̄ is far above all other
//! stiffnesses, the iteration then takes a step for almost every open joint.
//!
//! Source: Woodbury 1950.

use super::layout::RingLayout;
use super::order::SectionFactor;
use crate::linalg::{Cholesky, LinalgError, Matrix, Symmetric};
use crate::ring::Weight;

/// Most joints that are open in the preconditioner: Q is dense. Levels beyond it, those with the largest open part first, stay in the mean.
pub const OPEN_AT_MOST: usize = 2000;

/// Open joints of a matrix.
pub(super) struct Open {
    /// Number of the pair, and meridian.
    joints: Vec<(usize, usize)>,
    /// k̄ − k_i of each.
    missing: Vec<f64>,
}

/// Q of the open joints.
pub(super) struct Update {
    /// Equations of face and wall.
    equations: Vec<[usize; 2]>,
    factor: Cholesky,
}

/// A level with open joints.
struct Level {
    /// k̄.
    closed: f64,
    /// Meridian and missing stiffness of the open ones.
    open: Vec<(usize, f64)>,
}

impl Open {
    /// The open joints of `sparse`; levels that have some are closed in `mean`.
    pub(super) fn close(layout: &RingLayout, sparse: &Symmetric, mean: &mut [f64]) -> Open {
        let ring = layout.ring();
        // On the plane half of a joint is there.
        let on_plane = |k: usize| ring.is_half() && (k == 0 || k + 1 == ring.meridians());
        let part = |k: usize| if on_plane(k) { 0.5 } else { 1.0 };
        let mut levels: Vec<(usize, Level)> = Vec::new();
        for (number, pair) in layout.pairs().iter().enumerate() {
            let slope: Vec<f64> = pair.places.iter().map(|&p| -sparse.values[p]).collect();
            let whole = slope.iter().enumerate().map(|(k, s)| s / part(k));
            let largest = whole.clone().fold(0.0, f64::max);
            let is_closed = |s: &f64| *s >= 0.5 * largest;
            let (sum, count) = whole.filter(is_closed).fold((0.0, 0.0), |(s, n), k| (s + k, n + 1.0));
            let closed: f64 = sum / count;
            let open: Vec<(usize, f64)> = slope
                .iter()
                .enumerate()
                .filter(|(k, s)| !is_closed(&(*s / part(*k))))
                .map(|(k, s)| (k, part(k) * closed - s))
                .collect();
            if !open.is_empty() {
                levels.push((number, Level { closed, open }));
            }
        }
        levels.sort_by_key(|(number, level)| (level.open.len(), *number));
        let (mut joints, mut missing) = (Vec::new(), Vec::new());
        for (number, level) in levels {
            if joints.len() + level.open.len() > OPEN_AT_MOST {
                break;
            }
            let [between, face, wall] = layout.pairs()[number].entries;
            let more = level.closed + mean[between];
            mean[between] -= more;
            mean[face] += more;
            mean[wall] += more;
            joints.extend(level.open.iter().map(|(k, _)| (number, *k)));
            missing.extend(level.open.iter().map(|(_, missing)| *missing));
        }
        Open { joints, missing }
    }

    /// Q, with the factors of P₀; `None` without open joints.
    ///
    /// Errors: a Q that is not positive definite.
    pub(super) fn update(&self, layout: &RingLayout, factors: &[SectionFactor]) -> Result<Option<Update>, LinalgError> {
        if self.joints.is_empty() {
            return Ok(None);
        }
        let mut numbers: Vec<usize> = self.joints.iter().map(|j| j.0).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let between = compliances(layout, factors, &numbers);
        let (sectors, half) = (layout.ring().sectors(), layout.ring().is_half());
        let level = |pair: usize| numbers.binary_search(&pair).unwrap_or(0);
        let places: Vec<(usize, usize)> = self.joints.iter().map(|&(pair, k)| (level(pair), k)).collect();
        let mut q = Matrix::zeros(places.len(), places.len());
        for (j, &(b, l)) in places.iter().enumerate() {
            for (i, &(a, k)) in places.iter().enumerate().skip(j) {
                let row = &between[triangle(a.max(b), a.min(b))];
                let mut sum = row[(k + sectors - l) % sectors];
                if half {
                    sum += row[(k + l) % sectors];
                }
                q.add(i, j, -sum);
            }
            q.add(j, j, 1.0 / self.missing[j]);
        }
        let equation = |&(pair, k): &(usize, usize)| {
            let rows = layout.pairs()[pair].rows;
            rows.map(|row| layout.equations(row)[k] as usize)
        };
        Ok(Some(Update { equations: self.joints.iter().map(equation).collect(), factor: Cholesky::factor(&q)? }))
    }
}

/// Place of the pair (i, j), i ≥ j, in a triangle.
fn triangle(i: usize, j: usize) -> usize {
    i * (i + 1) / 2 + j
}

/// c at the angles of all meridians of the circle, for the levels i ≥ j of these pairs.
fn compliances(layout: &RingLayout, factors: &[SectionFactor], numbers: &[usize]) -> Vec<Vec<f64>> {
    let count = numbers.len();
    let circle = layout.circle();
    let mut by_harmonic: Vec<Vec<f64>> = Vec::with_capacity(factors.len());
    for (m, factor) in factors.iter().enumerate() {
        let mut x = Matrix::zeros(layout.symbolic(m).pattern().size(), count);
        for (j, &number) in numbers.iter().enumerate() {
            let [face, wall] = layout.pairs()[number].rows;
            x.add(face, j, 1.0);
            x.add(wall, j, -1.0);
        }
        factor.solve(&mut x);
        let of = |i: usize, j: usize| {
            let [face, wall] = layout.pairs()[numbers[i]].rows;
            x.get(face, j) - x.get(wall, j)
        };
        let pairs = (0..count).flat_map(|i| (0..=i).map(move |j| (i, j)));
        by_harmonic.push(pairs.map(|(i, j)| 0.5 * (of(i, j) + of(j, i))).collect());
    }
    let mut room = circle.room();
    let mut row = vec![0.0; circle.sectors()];
    let of = |place: usize| {
        let get = |m: usize, family: usize| match family {
            0 => circle.scale(m) * by_harmonic[m][place],
            _ => 0.0,
        };
        circle.synthesise(false, Weight::Forces, &mut room, get, &mut row);
        row.clone()
    };
    (0..triangle(count, 0)).map(of).collect()
}

impl Update {
    /// r ← r + B_o Q⁻¹ B_oᵀ z.
    pub(super) fn add(&self, z: &[f64], r: &mut [f64]) {
        let closing: Vec<f64> = self.equations.iter().map(|[face, wall]| z[*face] - z[*wall]).collect();
        for (force, [face, wall]) in self.factor.solve_vector(&closing).iter().zip(&self.equations) {
            r[*face] += force;
            r[*wall] -= force;
        }
    }
}
