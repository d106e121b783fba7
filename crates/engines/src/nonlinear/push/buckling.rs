//! The lowest linear buckling mode of the loaded tank.
//!
//! ```text
//! (K_T(rest) + μ K_G(Δu)) φ = 0 ,   K_T(rest) Δu = load at a
//! ```
//!
//! K_T is the static tangent, under weight and liquid, whose pressure stiffens the wall; K_G follows from the stresses that
//! inertia and impulsive pressure at the acceleration a add in the linear response: elastic, small displacements before
//! buckling, suction of the liquid excluded as at a. μ a is not a capacity: it includes neither yielding nor prebuckling
//! bending. Its mode is
//! the shape in which the elastic wall is softest.

use fem::analysis::buckling::{Buckling, lowest};
use fem::analysis::continuation::Constraint;
use fem::element::Want;
use fem::linalg::{Kind, Symmetric};
use fem::state::State;
use nalgebra::Vector3;
use tank::units::Dimension;

use super::continuation::continuation;
use super::model::{Plan, PushModel};
use crate::FeError;
use results::WallMap;

/// A mode on the nodes of the wall.
#[derive(Clone, Debug)]
pub(super) struct Mode {
    /// μ.
    pub(super) factor: f64,
    /// Displacement and rotation of the nodes `[ring][angle]`, global components; 1 where the radial part is largest, outwards.
    pub(super) field: Vec<Vec<[Vector3<f64>; 2]>>,
    /// Height [m] and angle [rad] of that place.
    pub(super) place: (f64, f64),
}

fn failed(error: impl std::fmt::Display) -> FeError {
    FeError::Analysis(format!("buckling mode: {error}"))
}

/// The mode under the load of an acceleration [m/s²].
///
/// Errors: a wall that does not carry weight and liquid; the eigenvalue solver; a load no multiple of which buckles the wall.
pub(super) fn mode(plan: &Plan, acceleration: f64) -> Result<Mode, FeError> {
    let model = plan.build(None)?;
    let mut state = State::new(&model.model);
    let none = vec![0.0; model.weight.len()];
    continuation(&model, &model.weight, &none)?.step(&mut state, &Constraint::Load(0.0)).map_err(failed)?;
    let found = under(&model, &mut state, &model.load(acceleration).0)?;
    let found = found.ok_or_else(|| failed("no multiple of the load buckles the elastic wall"))?;
    Ok(on_the_wall(&model, &found))
}

/// The lowest mode under multiples of `load` added to a committed state; `None` if there is none.
pub(super) fn under(model: &PushModel, state: &mut State, load: &[f64]) -> Result<Option<Buckling>, FeError> {
    state.revert();
    let mut tangent = Symmetric::zeros(model.assembler.pattern().clone());
    model
        .assembler
        .respond(&model.model, state, Want::ALL, &mut tangent)
        .map_err(|(number, source)| failed(format!("element {number}: {source}")))?;
    let factor = model.symbolic.factor(&tangent, Kind::Definite).map_err(failed)?;
    let added = factor.solve_vector(load).map_err(failed)?;
    let geometric = model.assembler.geometric_stiffness(&model.model, &added).map_err(failed)?;
    lowest(&tangent, &geometric, &model.symbolic).map_err(failed)
}

fn on_the_wall(model: &PushModel, found: &Buckling) -> Mode {
    let (mut largest, mut place) = (0.0_f64, (0.0, 0.0));
    let mut field = Vec::with_capacity(model.rings.len());
    for (ring, &z) in model.rings.iter().zip(&model.levels) {
        let mut row = Vec::with_capacity(ring.len());
        for (&node, &angle) in ring.iter().zip(&model.angles) {
            let [ux, uy, uz, rx, ry, rz, ..] = model.model.at_node(&found.mode, node);
            let radial = ux * angle.cos() + uy * angle.sin();
            if radial.abs() > largest.abs() {
                (largest, place) = (radial, (z, angle));
            }
            row.push([Vector3::new(ux, uy, uz), Vector3::new(rx, ry, rz)]);
        }
        field.push(row);
    }
    // A wall cannot buckle without moving out of its surface.
    let scale = if largest == 0.0 { 0.0 } else { 1.0 / largest };
    field.iter_mut().flatten().flatten().for_each(|v| *v *= scale);
    Mode { factor: found.factor, field, place }
}

impl Mode {
    /// δ φ.
    pub(super) fn scaled(&self, amplitude: f64) -> Vec<Vec<[Vector3<f64>; 2]>> {
        let mut out = self.field.clone();
        out.iter_mut().flatten().flatten().for_each(|v| *v *= amplitude);
        out
    }

    /// Deviation of the radius over the wall at an amplitude [m].
    pub(super) fn map(&self, plan: &Plan, amplitude: f64) -> WallMap {
        let radial = |k: usize, row: &Vec<[Vector3<f64>; 2]>| {
            let (s, c) = plan.angles[k].sin_cos();
            amplitude * (c * row[k][0].x + s * row[k][0].y)
        };
        WallMap {
            id: "imperfection".into(),
            title: "Deviation of the radius, outwards positive".into(),
            time: None,
            dimension: Dimension::Length,
            theta: plan.angles.clone(),
            z: plan.levels.clone(),
            values: (0..plan.angles.len()).flat_map(|k| self.field.iter().map(move |row| radial(k, row))).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use fem::dofs::Dof;
    use tank::Case;
    use tank::{Behaviour, Shape, Steel};

    use super::super::imperfection::Dent;
    use super::*;
    use crate::nonlinear::arcs::{cosine_shares, shares};
    use tank::options::nonlinear::{NonlinearOptions, WallElements};
    use tank::reference::{case, material};

    const RADIUS: f64 = 1.0;
    const THICKNESS: f64 = 5e-3;
    const YOUNG: f64 = 2.1e11;

    /// R/t = 200, R high, below a ring that is five times as thick and passes the load of its edge on evenly; next to no liquid.
    fn tank() -> Case {
        let mut steel = material(YOUNG, 0.3, 7850.0);
        steel.behaviour = Behaviour::Steel(Steel {
            yield_strength: 1e12,
            tangent_modulus: 0.0,
            kinematic_share: 1.0,
            ultimate_strength: None,
        });
        let courses = [(1.0, THICKNESS), (0.2, 5.0 * THICKNESS)];
        case(Shape::Cylinder { radius: RADIUS }, &courses, &steel, (1.0, 0.6))
    }

    fn options(case: &Case, height: u32, circumference: u32) -> NonlinearOptions {
        NonlinearOptions {
            elements: Some(WallElements { height, circumference }),
            self_weight: false,
            ..NonlinearOptions::new(case.damping)
        }
    }

    /// Largest compression at buckling over E t/(R √(3 (1 − ν²))), under an edge load of `share` a node.
    fn critical(plan: &Plan, share: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
        let model = plan.build(None).unwrap();
        let mut state = State::new(&model.model);
        let mut load = vec![0.0; model.weight.len()];
        for (&node, part) in model.rings[model.rings.len() - 1].iter().zip(share(&model.angles)) {
            for (e, c) in model.model.row(node, Dof::Uz) {
                load[e] -= c * part * RADIUS;
            }
        }
        let found = under(&model, &mut state, &load).unwrap().unwrap();
        // 1 N/m on the edge is 1/t in the wall.
        found.factor / THICKNESS / (YOUNG * THICKNESS / (RADIUS * (3.0_f64 * 0.91).sqrt()))
    }

    /// Axial compression and bending: the classical stress. The waves grow from one clamped edge to the other, which adds
    /// 2 (1.72 √(R t)/L)² = 3 %; bending at the edges before buckling takes up to 7 % (Almroth 1966); eight elements a half-wave
    /// add
    /// π²/(12 · 8²)/2 = 0.6 %. In bending only a part of the circumference is compressed that much, which adds a few per cent more
    /// (Seide & Weingarten 1961).
    #[test]
    fn classical_stress() {
        let case = tank();
        let options = options(&case, 80, 96);
        let plan = Plan::new(&case, &options, false).unwrap();
        let axial = critical(&plan, shares);
        assert!((0.93..1.05).contains(&axial), "{axial}");
        let bending = critical(&plan, cosine_shares);
        assert!((0.93..1.10).contains(&bending) && bending > 0.999 * axial, "{bending} {axial}");
    }

    /// The normals of the imperfect surface are those of its facets, and its supports stay where they are.
    #[test]
    fn a_mode_bends_the_wall_smoothly() {
        let case = tank();
        let options = options(&case, 32, 64);
        let plan = Plan::new(&case, &options, false).unwrap();
        let mode = mode(&plan, 10.0).unwrap();
        let largest = |f: &dyn Fn(usize, usize) -> f64| {
            let places = (0..plan.levels.len()).flat_map(|l| (0..plan.angles.len()).map(move |k| (l, k)));
            places.map(|(l, k)| f(l, k)).fold(0.0, f64::max)
        };
        let delta = THICKNESS;
        let dent = Dent::Mode(mode.scaled(delta));
        let at = |l: usize, k: usize| {
            let (angle, z) = (plan.angles[k], plan.levels[l]);
            let (moved, normal) = dent.at((l, k), angle, z);
            let (s, c) = angle.sin_cos();
            (Vector3::new(RADIUS * c, RADIUS * s, z) + moved, normal.normalize(), moved.dot(&Vector3::new(c, s, 0.0)))
        };
        assert!((largest(&|l, k| at(l, k).2) / delta - 1.0).abs() < 1e-9);
        assert!((0..plan.angles.len()).all(|k| at(0, k).2 == 0.0));
        let last = plan.angles.len() - 1;
        assert!((0..plan.levels.len()).all(|l| at(l, 0).0.y.abs() < 1e-12 && at(l, last).0.y.abs() < 1e-12));
        // Slopes of the mode are of the order of δ over a quarter of a wave.
        let slope = largest(&|l, k| (at(l, k).1.z).abs());
        let mut error = 0.0_f64;
        for l in 1..plan.levels.len() - 1 {
            // Secant through the neighbours against the normal, where both intervals are alike.
            let (below, here, above) = (at(l - 1, 0), at(l, 0), at(l + 1, 0));
            let ratio = (plan.levels[l + 1] - plan.levels[l]) / (plan.levels[l] - plan.levels[l - 1]);
            if (ratio - 1.0).abs() < 0.2 {
                let secant = (above.0 - below.0).normalize();
                error = error.max(secant.dot(&here.1).abs());
            }
        }
        assert!(slope > 1e-3 && error < 0.25 * slope, "{error} of {slope}");
    }
}
