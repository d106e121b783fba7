//! Observed quantities: linear functionals of displacement, velocity and total acceleration.
//!
//! ```text
//! y = d·x + e·ẋ + c·(ẍ + Σ ι_k a_k) + Σ b_k a_k
//! ```
//!
//! A support reaction is one of them: by virtual work, the resultant of all reactions for a rigid motion w of the supports
//! is wᵀ (K x + C ẋ + M ẍ_total) over the held dofs, whose rows are summed from the elements.

use std::collections::BTreeMap;

use super::AnalysisError;
use super::damping::Rayleigh;
use super::system::unit;
use crate::dofs::{Dof, KINDS};
use crate::element::{Element, ElementError, LocalMatrix, Sample, local_size, reference_mass, reference_stiffness};
use crate::model::Model;

/// Sparse row: (equation, coefficient).
pub type SparseRow = Vec<(usize, f64)>;

/// A linear functional of the response.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observable {
    /// Name, for results.
    pub name: String,
    /// d, on displacements relative to the ground.
    pub displacement: SparseRow,
    /// e, on velocities relative to the ground.
    pub velocity: SparseRow,
    /// c, on total accelerations.
    pub acceleration: SparseRow,
    /// b, on the ground acceleration (of held dofs, which move with the ground).
    pub ground: [f64; 3],
}

impl Observable {
    /// Displacement (rotation, potential, elevation) of a node in a global component, relative to the ground.
    pub fn displacement(model: &Model, node: usize, dof: Dof) -> Observable {
        Observable {
            name: format!("{dof} of node {node}"),
            displacement: model.row(node, dof),
            ..Observable::default()
        }
    }

    /// Total acceleration of a node in a global component.
    pub fn acceleration(model: &Model, node: usize, dof: Dof) -> Observable {
        let mut ground = [0.0; 3];
        if dof.index() < 3 {
            // The held part of this component moves with the ground.
            for (k, b) in ground.iter_mut().enumerate() {
                let own = held_part(model, node, &unit(k));
                *b = own[dof.index()];
            }
        }
        Observable {
            name: format!("total acceleration {dof} of node {node}"),
            acceleration: model.row(node, dof),
            ground,
            ..Observable::default()
        }
    }

    /// A sample of an element: stress, resultant, pressure.
    pub fn sample(model: &Model, element: &dyn Element, sample: &Sample) -> Observable {
        let row: SparseRow = model.spread(element, &sample.row).into_iter().collect();
        let mut out = Observable { name: sample.name.to_owned(), ..Observable::default() };
        if sample.of_acceleration {
            for (k, b) in out.ground.iter_mut().enumerate() {
                *b = local_held(model, element, &|_| unit(k)).iter().zip(&sample.row).map(|(w, r)| w * r).sum();
            }
            out.acceleration = row;
        } else {
            out.displacement = row;
        }
        out
    }

    /// Resultant of all support reactions in the rigid motion `field` (global components at every node): (1, 0, 0, …) is
    /// the force along x that the ground exerts on the model, (0, −z, y, 1, 0, 0, …) the moment about x.
    ///
    /// `rayleigh(e)`: coefficients of element e, for the viscous part; the elements' own damping is included.
    ///
    /// Errors: those of the elements.
    pub fn reaction(
        model: &Model,
        name: &str,
        field: impl Fn(usize) -> [f64; KINDS],
        rayleigh: impl Fn(usize) -> Rayleigh,
    ) -> Result<Observable, AnalysisError> {
        Observable::reaction_parts(model, name, field, rayleigh, true)
    }

    /// The part of [`Observable::reaction`] that inertia and damping have, for models whose internal forces are not linear.
    ///
    /// Errors: those of the elements.
    pub fn reaction_of_motion(
        model: &Model,
        name: &str,
        field: impl Fn(usize) -> [f64; KINDS],
        rayleigh: impl Fn(usize) -> Rayleigh,
    ) -> Result<Observable, AnalysisError> {
        Observable::reaction_parts(model, name, field, rayleigh, false)
    }

    fn reaction_parts(
        model: &Model,
        name: &str,
        field: impl Fn(usize) -> [f64; KINDS],
        rayleigh: impl Fn(usize) -> Rayleigh,
        with_stiffness: bool,
    ) -> Result<Observable, AnalysisError> {
        let (mut d, mut e, mut c) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        let mut ground = [0.0; 3];
        for (number, element) in model.elements().iter().enumerate() {
            let element = &**element;
            let virtual_motion = local_held(model, element, &field);
            if virtual_motion.iter().all(|w| *w == 0.0) {
                continue;
            }
            let r = rayleigh(number);
            let [on_k, on_m, own] =
                all_rows(element, &virtual_motion).map_err(|source| AnalysisError::Element { number, source })?;
            let on_c: Vec<f64> =
                own.iter().zip(on_k.iter().zip(&on_m)).map(|(c, (k, m))| c + r.stiffness * k + r.mass * m).collect();
            for (out, local) in [(&mut d, &on_k), (&mut e, &on_c), (&mut c, &on_m)] {
                for (equation, value) in model.spread(element, local) {
                    *out.entry(equation).or_insert(0.0) += value;
                }
            }
            for (axis, b) in ground.iter_mut().enumerate() {
                let carried = local_held(model, element, &|_| unit(axis));
                *b += carried.iter().zip(&on_m).map(|(x, m)| x * m).sum::<f64>();
            }
        }
        let sparse = |map: BTreeMap<usize, f64>| map.into_iter().filter(|&(_, v)| v != 0.0).collect();
        Ok(Observable {
            name: name.to_owned(),
            displacement: if with_stiffness { sparse(d) } else { Vec::new() },
            velocity: sparse(e),
            acceleration: sparse(c),
            ground,
        })
    }

    /// Coefficients of the ground acceleration with c·ι_k a_k taken in.
    pub fn total_ground(&self, influence: &[Vec<f64>; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.ground[k] + apply(&self.acceleration, &influence[k]))
    }
}

/// Σ c_i x_i.
pub fn apply(row: &[(usize, f64)], x: &[f64]) -> f64 {
    row.iter().map(|&(i, c)| c * x[i]).sum()
}

/// K w, M w and C w of an element.
fn all_rows(element: &dyn Element, w: &[f64]) -> Result<[Vec<f64>; 3], ElementError> {
    if let Some(operator) = element.operator() {
        let zeros = || vec![0.0; w.len()];
        let (mut on_k, mut on_m, mut own) = (zeros(), zeros(), zeros());
        operator.add_stiffness(1.0, w, &mut on_k);
        operator.add_mass(1.0, w, &mut on_m);
        for (k, c) in operator.damping().iter().enumerate() {
            own[operator.wall() + k] = c * w[operator.wall() + k];
        }
        return Ok([on_k, on_m, own]);
    }
    let mut damper = LocalMatrix::zeros(local_size(element));
    if !element.damping(&mut damper) {
        damper = LocalMatrix::zeros(local_size(element));
    }
    let (k, m) = (reference_stiffness(element)?, reference_mass(element));
    Ok([&k, &m, &damper].map(|a| rows(a, w)))
}

/// Aᵀ w of a symmetric local matrix.
fn rows(a: &LocalMatrix, w: &[f64]) -> Vec<f64> {
    let column = |j: usize| (0..a.n).map(|i| a.get(i, j) * w[i]).sum();
    (0..a.n).map(column).collect()
}

/// The part of a vector of global components at a node that lies along held dofs.
fn held_part(model: &Model, node: usize, global: &[f64; KINDS]) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    for dof in Dof::ALL {
        if !model.is_held(node, dof) {
            continue;
        }
        let i = dof.index();
        let (frame, first) = match i {
            0..3 => (model.frame(node), 0),
            3..6 => (model.rotation_frame(node), 3),
            _ => (None, 0),
        };
        match frame {
            Some(f) => {
                let along: f64 = (0..3).map(|j| f[(i - first, j)] * global[first + j]).sum();
                for j in 0..3 {
                    out[first + j] += f[(i - first, j)] * along;
                }
            }
            None => out[i] += global[i],
        }
    }
    out
}

/// Local vector of the held part of a field.
fn local_held(model: &Model, element: &dyn Element, field: &impl Fn(usize) -> [f64; KINDS]) -> Vec<f64> {
    let mut out = Vec::new();
    for (a, &node) in element.nodes().iter().enumerate() {
        let field = field(node);
        let held = held_part(model, node, &field);
        out.extend(element.dofs(a).iter().map(|&d| match element.own_axes() {
            true if model.is_held(node, d) => model.component(node, d, &field),
            true => 0.0,
            false => held[d.index()],
        }));
    }
    out
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{Rotation3, Vector3};

    use super::*;
    use crate::analysis::damping::Damping;
    use crate::analysis::motion::{Grid, Motion};
    use crate::analysis::system::System;
    use crate::analysis::transient::{Load, Settings, integrate};
    use crate::assembly::Assembler;
    use crate::element::solid8::{Elastic, Kinematics, Solid8};
    use crate::linalg::{Ordering, Symbolic};
    use crate::model::Builder;
    use crate::progress::Silent;

    /// A shaken tower of bricks: the reaction of its supports, some of them in oblique frames, is the inertia of all its mass,
    /// and the reaction moment about the base that of all its mass times height and offset.
    #[test]
    fn reactions_balance_inertia() {
        let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let (levels, density) = (4, 2.5);
        let mut builder = Builder::new();
        for node in 0..4 * (levels + 1) {
            let [x, y] = corner[node % 4];
            builder.node([x, y, (node / 4) as f64]);
            if node < 4 {
                // All three held: the frame must not matter.
                let turn = Rotation3::from_scaled_axis(Vector3::new(0.3, 0.1 * node as f64, -0.7));
                builder.frame(node, turn.into_inner());
                Dof::TRANSLATIONS.iter().for_each(|&dof| builder.hold(node, dof));
            }
        }
        for level in 0..levels {
            let nodes: [usize; 8] = std::array::from_fn(|a| 4 * level + a);
            let corners = nodes.map(|n| [corner[n % 4][0], corner[n % 4][1], (n / 4) as f64]);
            let brick = Solid8::new(nodes, corners, Elastic::isotropic(4e3, 0.3, density), Kinematics::Linear);
            builder.element("tower", brick.unwrap());
        }
        let model = builder.build().unwrap();
        let assembler = Assembler::new(&model);
        let stiffness = Rayleigh::stiffness_proportional(10.0, 0.05);
        let system = System::new(&model, &assembler).unwrap().with_damping(Damping::rayleigh(stiffness));
        let lever = |node: usize| {
            let [x, _, z] = model.nodes()[node];
            // Rotation about y: u_x = z, u_z = −x.
            [z, 0.0, -x, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]
        };
        let grid = Grid::new(0.02, 2.0, 0.0, 0.02);
        let record = |f: f64| -> Vec<f64> { (0..grid.samples).map(|k| (f * k as f64).sin()).collect() };
        let mut load = Load::ground(0, Motion::sampled(0.02, &record(0.3), &grid));
        load.ground[2] = Some(Motion::sampled(0.02, &record(0.5), &grid));
        let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap();
        let mut rows = Vec::new();
        for (name, field) in [("shear", None), ("moment", Some(lever))] {
            let rigid = |node: usize| field.map_or(unit(0), |f| f(node));
            rows.push(Observable::reaction(&model, name, rigid, |_| stiffness).unwrap());
            // wᵀ M ẍ_total over all nodes: free ones by their row, held ones with the ground.
            let carried = assembler.inertia(&model, rigid);
            let mut ground = [0.0; 3];
            for (k, g) in ground.iter_mut().enumerate() {
                // Closed form: ∫ ρ w_k dV of the tower 1 × 1 × 4, less the part of the free nodes.
                let whole = density
                    * match (field.is_some(), k) {
                        (false, 0) => 4.0,
                        (true, 0) => 8.0,
                        (true, 2) => -2.0,
                        _ => 0.0,
                    };
                *g = whole - carried.iter().zip(&system.influence[k]).map(|(m, i)| m * i).sum::<f64>();
            }
            rows.push(Observable {
                name: format!("{name} of inertia"),
                acceleration: carried.into_iter().enumerate().collect(),
                ground,
                ..Observable::default()
            });
        }
        let settings = Settings::new(grid);
        let found = integrate(&system, &Arc::new(symbolic), &[load], &settings, &rows, &[], &Silent).unwrap();
        for pair in found[0].observed.scalars.chunks(2) {
            let peak = pair[0].extreme.peak().0;
            assert!(peak > 1.0);
            for (reaction, inertia) in pair[0].values.iter().zip(&pair[1].values) {
                assert!((reaction - inertia).abs() < 1e-10 * peak, "{reaction} {inertia}");
            }
        }
    }
}
