//! Rings of nodes that are stiff in themselves: stiffening rings and wind girders, and rims that a roof keeps round.
//!
//! ```text
//! 2 U = ∫ [E A ε² + E I κ²] R dθ         ε = (v_θ + w)/R         κ = (w_θθ + w)/R²
//! ```
//!
//! over all nodes of a ring, w outwards and v around. w and v are periodic cubic splines through the nodes, at any angles: ε is taken at
//! the nodes, where the slope of a spline is of fourth order, so that waves that bend the ring do not stretch it; κ² is integrated exactly,
//! too small by (n h)⁴/720 for n waves on nodes h apart. Translations in the plane are taken out of both, so that they cost nothing at all;
//! tilts have neither w nor v.
//!
//! A round rim is a disc that is rigid in its plane: 2 U = k ∫ |d − d_r|² dθ of the displacements d in the plane, with the translation and the
//! turn d_r next to them. It moves and tilts freely, and leaves the displacements along the axis alone.
//!
//! Linear and elastic: the turning of a ring as a whole must stay small (its ε is wrong by ψ²/2). Its axis lies in the surface of the
//! wall; torsion, bending out of the plane and eccentricity are left out.
//!
//! Source: Love 1927, §293; Timoshenko & Gere 1961, 7.1 (strains); de Boor 1978, chapter IV (splines).

use std::f64::consts::{PI, TAU};

use fem::dofs::Dof;
use fem::element::{Element, ElementError, Response, Trial};
use fem::linalg::{Cholesky, LinalgError, Matrix, product, transposed_product};
use fem::model::Builder;
use fem::shape::gauss;
use tank::Tank;

use super::roof::RoofRing;
use crate::FeError;
use crate::error::failure;
use crate::fittings::round_rim;

/// Nodes around the z axis with their angles, ascending from 0: the full circle, or the half of it up to π with motions that are
/// symmetric about that plane.
#[derive(Clone, Debug)]
pub(crate) struct Circle {
    pub(crate) nodes: Vec<usize>,
    pub(crate) angles: Vec<f64>,
    pub(crate) half: bool,
    pub(crate) radius: f64,
}

/// A ring with a stiffness over the displacements of its nodes, along the global axes.
#[derive(Clone, Debug)]
pub(crate) struct StiffRing {
    nodes: Vec<usize>,
    stiffness: Matrix,
}

/// Rows of strains of a field on a circle, times the root of their stiffness, over w of all nodes and then v.
type Strains = Matrix;

impl Circle {
    /// Angles of all nodes of the full circle.
    fn whole(&self) -> Vec<f64> {
        let mirrored = self.angles.iter().rev().filter(|a| self.half && **a > 0.0 && **a < PI * (1.0 - 1e-9));
        self.angles.iter().copied().chain(mirrored.map(|a| TAU - a)).collect()
    }

    /// √(weight) × strain over the global displacements of the nodes that are there; half of the energy of a full circle for a half.
    fn on_nodes(&self, whole: &[f64], strains: &Strains) -> Matrix {
        let (count, own) = (whole.len(), self.nodes.len());
        let scale = if self.half { 0.5_f64.sqrt() } else { 1.0 };
        let mut out = Matrix::zeros(strains.rows, 3 * own);
        for (j, angle) in whole.iter().enumerate() {
            // The image of a node in the half that is not there: w as it is, v the other way around.
            let (node, sign) = if j < own { (j, 1.0) } else { (count - j, -1.0) };
            let (s, c) = self.angles[node].sin_cos();
            for i in 0..strains.rows {
                let (w, v) = (strains.get(i, j), sign * strains.get(i, count + j));
                out.add(i, 3 * node, scale * (c * w - s * v));
                out.add(i, 3 * node + 1, scale * (s * w + c * v));
            }
            debug_assert!(j < own || (TAU - angle - self.angles[node]).abs() < 1e-9);
        }
        out
    }
}

/// Arcs after every node of a full circle.
fn arcs(angles: &[f64]) -> Vec<f64> {
    let next = angles.iter().skip(1).copied().chain(angles.first().map(|a| a + TAU));
    angles.iter().zip(next).map(|(a, b)| b - a).collect()
}

/// Second derivatives at the nodes of the periodic spline through values there, as a matrix.
///
/// Errors: nodes that coincide.
fn second_derivatives(arcs: &[f64]) -> Result<Matrix, LinalgError> {
    let n = arcs.len();
    let (mut left, mut right) = (Matrix::zeros(n, n), Matrix::zeros(n, n));
    for (j, h) in arcs.iter().enumerate() {
        let k = (j + 1) % n;
        for (a, b, share, slope) in [(j, j, 3.0, -1.0), (k, k, 3.0, -1.0), (j, k, 6.0, 1.0), (k, j, 6.0, 1.0)] {
            left.add(a, b, h / share);
            right.add(a, b, slope / h);
        }
    }
    Cholesky::factor(&left)?.solve(&mut right);
    Ok(right)
}

impl StiffRing {
    /// A ring of stiffness E A [N] and E I [N·m²].
    ///
    /// Errors: nodes that coincide.
    pub(crate) fn beam(circle: &Circle, [extension, bending]: [f64; 2]) -> Result<StiffRing, LinalgError> {
        let whole = circle.whole();
        let (arcs, n, radius) = (arcs(&whole), whole.len(), circle.radius);
        let second = second_derivatives(&arcs)?;
        let mut strains = Matrix::zeros(n + gauss::FOUR.len() * n, 2 * n);
        for (j, h) in arcs.iter().enumerate() {
            let (k, before) = ((j + 1) % n, arcs[(j + n - 1) % n]);
            // ε √(E A R Δθ), with the slope of v after the node.
            let root = (extension * 0.5 * (h + before) / radius).sqrt();
            strains.add(j, j, root);
            strains.add(j, n + j, -root / h);
            strains.add(j, n + k, root / h);
            for i in 0..n {
                let slope = -h / 6.0 * (2.0 * second.get(j, i) + second.get(k, i));
                strains.add(j, n + i, root * slope);
            }
            // κ √(E I R dθ).
            for (g, &(xi, weight)) in gauss::FOUR.iter().enumerate() {
                let row = n + gauss::FOUR.len() * j + g;
                let root = (bending * 0.5 * h * weight / radius.powi(3)).sqrt();
                let (a, b) = (0.5 * (1.0 - xi), 0.5 * (1.0 + xi));
                strains.add(row, j, root * a);
                strains.add(row, k, root * b);
                let part = |x: f64| x + h * h / 6.0 * (x.powi(3) - x);
                for i in 0..n {
                    strains.add(row, i, root * (part(a) * second.get(j, i) + part(b) * second.get(k, i)));
                }
            }
        }
        without_translations(&whole, &arcs, &mut strains);
        let rows = circle.on_nodes(&whole, &strains);
        Ok(StiffRing { nodes: circle.nodes.clone(), stiffness: transposed_product(&rows, &rows) })
    }
}

impl StiffRing {
    /// A rim that stays round, of stiffness k by angle [N/m].
    pub(crate) fn round(circle: &Circle, stiffness: f64) -> StiffRing {
        let whole = circle.whole();
        let (arcs, n) = (arcs(&whole), whole.len());
        let mut strains = Matrix::zeros(2 * n, 2 * n);
        for j in 0..n {
            let root = (0.5 * stiffness * (arcs[j] + arcs[(j + n - 1) % n])).sqrt();
            strains.add(j, j, root);
            strains.add(n + j, n + j, root);
        }
        without_translations(&whole, &arcs, &mut strains);
        let turn = Matrix { rows: 2 * n, cols: 1, data: (0..2 * n).map(|i| f64::from(i >= n)).collect() };
        let share = |j: usize| 0.5 * (arcs[j] + arcs[(j + n - 1) % n]) / TAU;
        let mean = (0..2 * n).map(|i| if i >= n { share(i - n) } else { 0.0 }).collect();
        let change = product(&product(&strains, &turn), &Matrix { rows: 1, cols: 2 * n, data: mean });
        strains.data.iter_mut().zip(&change.data).for_each(|(s, c)| *s -= c);
        let rows = circle.on_nodes(&whole, &strains);
        StiffRing { nodes: circle.nodes.clone(), stiffness: transposed_product(&rows, &rows) }
    }
}

/// Takes the mean translation of the nodes out of the field that strains are of.
fn without_translations(angles: &[f64], arcs: &[f64], strains: &mut Strains) {
    let n = angles.len();
    for along_y in [false, true] {
        // Translation along x: w = cos θ, v = −sin θ; along y: sin θ, cos θ.
        let field = |angle: f64| if along_y { [angle.sin(), angle.cos()] } else { [angle.cos(), -angle.sin()] };
        let mut motion = Matrix::zeros(2 * n, 1);
        let mut mean = Matrix::zeros(1, 2 * n);
        for (j, angle) in angles.iter().enumerate() {
            let share = 0.5 * (arcs[j] + arcs[(j + n - 1) % n]) / TAU;
            for (at, value) in [j, n + j].into_iter().zip(field(*angle)) {
                motion.add(at, 0, value);
                mean.add(0, at, share * value);
            }
        }
        let of_motion = product(strains, &motion);
        let change = product(&of_motion, &mean);
        strains.data.iter_mut().zip(&change.data).for_each(|(s, c)| *s -= c);
    }
}

impl Element for StiffRing {
    fem::answers!("ring", nodes, Dof::TRANSLATIONS; linear massless);

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if want.force {
            for (f, k) in out.force.iter_mut().zip(self.stiffness.times(motion.values)) {
                *f += k;
            }
        }
        if want.tangent {
            out.tangent.data.iter_mut().zip(&self.stiffness.data).for_each(|(t, k)| *t += k);
        }
        Ok(())
    }
}

/// The level of nodes next to a height [m].
pub(crate) fn level_at(levels: &[f64], z: f64) -> usize {
    let distance = |level: &usize| (levels[*level] - z).abs();
    (0..levels.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// Adds rings and attachments of a round tank to the levels of nodes next to them, evenly spaced, whose lever holds the moment and the rotational inertia of
/// their mass; `circle` makes the nodes of a level.
///
/// Errors: nodes that coincide.
pub(crate) fn add_fittings(
    tank: &Tank,
    levels: &[f64],
    circle: impl Fn(usize) -> Circle,
    group: &str,
    builder: &mut Builder,
) -> Result<(), FeError> {
    for (mass, height) in tank.carried().filter(|(mass, _)| *mass > 0.0) {
        let level = level_at(levels, height);
        let at = circle(level);
        let positions: Vec<[f64; 3]> =
            at.angles.iter().map(|a| [at.radius * a.cos(), at.radius * a.sin(), levels[level]]).collect();
        let lever = height - levels[level];
        builder.element(
            group,
            match at.half {
                true => RoofRing::half(at.nodes, &positions, mass, lever),
                false => RoofRing::new(at.nodes, &positions, mass, lever),
            },
        );
    }
    add_beams(tank, levels, circle, group, builder)
}

/// Adds the stiffness of the rings of a round tank, and of a rim that its roof keeps round.
///
/// Errors: nodes that coincide.
pub(crate) fn add_beams(
    tank: &Tank,
    levels: &[f64],
    circle: impl Fn(usize) -> Circle,
    group: &str,
    builder: &mut Builder,
) -> Result<(), FeError> {
    if let Some(stiffness) = round_rim(tank) {
        builder.element(group, StiffRing::round(&circle(levels.len() - 1), stiffness));
    }
    for ring in &tank.rings {
        let young = ring.material.youngs_modulus;
        let beam = StiffRing::beam(&circle(level_at(levels, ring.height)), [young * ring.area, young * ring.inertia]);
        builder.element(group, beam.map_err(failure("the spline of a ring"))?);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADIUS: f64 = 3.0;
    const STIFFNESS: [f64; 2] = [8e8, 4e5];

    fn circle(count: usize, half: bool, grading: f64) -> Circle {
        let span = if half { PI } else { TAU };
        let parts = if half { count - 1 } else { count };
        let angles = (0..count).map(|k| span * (k as f64 / parts as f64).powf(grading)).collect();
        Circle { nodes: (0..count).collect(), angles, half, radius: RADIUS }
    }

    /// Twice the energy of a field (w, v) of θ.
    fn energy(circle: &Circle, field: impl Fn(f64) -> [f64; 2]) -> f64 {
        let ring = StiffRing::beam(circle, STIFFNESS).unwrap();
        let x: Vec<f64> = circle
            .angles
            .iter()
            .flat_map(|a| {
                let (s, c) = a.sin_cos();
                let [w, v] = field(*a);
                // The tilt about y lifts the nodes and does nothing else.
                [c * w - s * v, s * w + c * v, 0.3 * c]
            })
            .collect();
        fem::linalg::dot(&x, &ring.stiffness.times(&x))
    }

    /// π R [E A ((n v + w)/R)² + E I ((1 − n²) w/R²)²] of the field w cos nθ, v sin nθ.
    fn exact(n: f64, w: f64, v: f64) -> f64 {
        let turn = if n == 0.0 { TAU } else { PI };
        let (strain, curvature) = ((n * v + w) / RADIUS, (1.0 - n * n) * w / (RADIUS * RADIUS));
        turn * RADIUS * (STIFFNESS[0] * strain * strain + STIFFNESS[1] * curvature * curvature)
    }

    /// Full and half circles, even and graded: expansion, extension and inextensional waves.
    #[test]
    fn waves_have_the_energy_of_a_ring() {
        for (circle, whole) in
            [(circle(72, false, 1.0), 1.0), (circle(37, true, 1.0), 0.5), (circle(49, true, 1.3), 0.5)]
        {
            let of = |n: f64, w: f64, v: f64| {
                energy(&circle, |a| [w * (n * a).cos(), v * (n * a).sin()]) / (whole * exact(n, w, v)) - 1.0
            };
            // What the translation of a graded spline strains is of the order h⁴.
            let expansion = of(0.0, 1.0, 0.0);
            assert!(expansion.abs() < 1e-5, "{expansion:e}");
            assert!(of(3.0, 1.0, 0.4).abs() < 2e-3);
            for n in 2..7 {
                let n = f64::from(n);
                let found = of(n, 1.0, -1.0 / n);
                assert!(found.abs() < 1e-2, "n = {n}: {found} of {} nodes", circle.nodes.len());
            }
            assert!(of(2.0, 1.0, -0.5).abs() < 1e-3, "{}", of(2.0, 1.0, -0.5));
        }
    }

    #[test]
    fn rigid_motions_cost_nothing() {
        for (circle, half) in [(circle(56, false, 1.0), false), (circle(49, true, 1.3), true)] {
            let stretched = energy(&circle, |a| [a.cos(), 0.0]);
            let along = energy(&circle, |a| [a.cos(), -a.sin()]);
            let mut all = vec![along];
            if !half {
                all.push(energy(&circle, |a| [a.sin(), a.cos()]));
                all.push(energy(&circle, |_| [0.0, 1.0]));
            }
            assert!(all.iter().all(|e| e.abs() < 1e-9 * stretched), "{all:?} {stretched}");
        }
    }

    /// A round rim has k π (w² + v²) of every wave beyond the first, and of expansion; of w cos θ half, the rest of which is a translation.
    #[test]
    fn a_round_rim_moves_as_a_disc() {
        for (circle, whole) in [(circle(56, false, 1.0), 1.0), (circle(49, true, 1.3), 0.5)] {
            let ring = StiffRing::round(&circle, 2e6);
            let energy = |field: &dyn Fn(f64) -> [f64; 2]| {
                let x: Vec<f64> = circle
                    .angles
                    .iter()
                    .flat_map(|a| {
                        let (s, c) = a.sin_cos();
                        let [w, v] = field(*a);
                        [c * w - s * v, s * w + c * v, 0.3 * c]
                    })
                    .collect();
                fem::linalg::dot(&x, &ring.stiffness.times(&x))
            };
            let scale = whole * PI * 2e6;
            assert!(energy(&|a| [a.cos(), -a.sin()]).abs() < 1e-9 * scale);
            assert!(energy(&|a| [a.sin(), a.cos()]).abs() < 1e-9 * scale || circle.half);
            assert!(energy(&|_| [0.0, 1.0]).abs() < 1e-9 * scale || circle.half);
            let expansion = energy(&|_| [1.0, 0.0]) / (2.0 * scale) - 1.0;
            assert!(expansion.abs() < 1e-5, "{expansion:e}");
            assert!((energy(&|a| [a.cos(), 0.0]) / (0.5 * scale) - 1.0).abs() < 1e-2);
            let wave = energy(&|a| [(3.0 * a).cos(), -(3.0 * a).sin() / 3.0]);
            assert!((wave / (scale * (1.0 + 1.0 / 9.0)) - 1.0).abs() < 2e-2, "{wave}");
        }
    }

    /// The sine twin of a wave has the same energy on even nodes.
    #[test]
    fn twins_are_equal() {
        let circle = circle(40, false, 1.0);
        let cosine = energy(&circle, |a| [(3.0 * a).cos(), -(3.0 * a).sin() / 3.0]);
        let sine = energy(&circle, |a| [(3.0 * a).sin(), (3.0 * a).cos() / 3.0]);
        assert!((sine / cosine - 1.0).abs() < 1e-9);
    }
}
