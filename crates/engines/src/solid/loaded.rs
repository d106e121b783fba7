//! The wall about its loaded state: what weight and hydrostatic pressure change in its stiffness.
//!
//! ```text
//! f_int(u_s) = weight + p(u_s)          K = K_T(u_s) − K_p(u_s) = K_0 + ΔK
//! ```
//!
//! u_s is the equilibrium in large rotations (the pressure turns with the wall), K_T the tangent of the shells there: it holds the
//! geometric stiffness of the static forces, above all N_θ n²/R² against waves around the tank, and the form that pressure has
//! pressed the imperfections into. ΔK is added as an element beside every shell. Rotations of the state are small, so that the frames of
//! the unloaded nodes serve; that a particle which sinks has more pressure is left out (ρ g against N_θ n²/R²).

use fem::analysis::continuation::{Constraint, Continuation};
use fem::analysis::newton::Criteria;
use fem::assembly::{Assembler, order};
use fem::dofs::{Dof, KINDS};
use fem::element::shell::load::FollowerPressure;
use fem::element::{Element, ElementError, LocalMatrix, Response, Trial, Want, local_size, reference_stiffness};
use fem::linalg::Symbolic;
use fem::model::{Builder, Model};
use fem::state::{Gather, State};
use tank::Case;

use super::form::Form;
use super::mesh::Division;
use super::wall::{LOADED, WallPart, add_wall};
use crate::FeError;
use crate::error::failed;

/// Group of the pressure.
const PRESSURE: &str = "pressure";
/// Convergence of the static state.
const CRITERIA: Criteria = Criteria { energy: 1e-12, force: 1e-6, iterations: 30 };

/// The loaded state of a wall.
#[derive(Clone, Debug)]
pub struct LoadedState {
    /// ΔK of the faces of the wall.
    changes: Vec<LocalMatrix>,
    /// Displacements and rotations of the wall's nodes, global components.
    nodes: Vec<[f64; KINDS]>,
}

impl LoadedState {
    /// The state of a wall of this form.
    ///
    /// Errors: an element that cannot be built; no equilibrium.
    pub(super) fn new(case: &Case, division: &Division, form: &Form<'_>) -> Result<LoadedState, FeError> {
        let mut builder = Builder::new();
        let plan = division.plan();
        let wall = add_wall(case, division, (plan.as_ref(), form), &mut builder)?;
        let weight = case.liquid.density * case.gravity;
        let pressures: Vec<usize> = wall
            .faces
            .iter()
            .map(|face| {
                let positions = face.nodes.map(|n| builder.position(n));
                let at = positions.map(|p| weight * (case.liquid.fill_height - p[2]).max(0.0));
                builder.element(PRESSURE, FollowerPressure::varying(face.nodes, positions, at))
            })
            .collect();
        let model = builder.build().map_err(failed)?;
        let state = equilibrium(&model, case.gravity)?;
        let pairs = wall.elements.iter().zip(&pressures);
        let changes = pairs
            .map(|(&shell, &pressure)| change(&model, &state, shell, pressure))
            .collect::<Result<Vec<LocalMatrix>, ElementError>>()
            .map_err(failed)?;
        let nodes = 0..wall.rows.len() * division.sectors;
        Ok(LoadedState { changes, nodes: nodes.map(|node| model.at_node(&state.committed.u, node)).collect() })
    }

    /// Adds ΔK beside every shell; numbers of its elements.
    pub(super) fn add_to(&self, wall: &WallPart, builder: &mut Builder) -> Vec<usize> {
        let pairs = wall.faces.iter().zip(&self.changes);
        pairs
            .map(|(face, change)| {
                let nodes = face.nodes;
                let change = change.clone();
                builder.element(LOADED, Change { nodes, change })
            })
            .collect()
    }

    /// u_s over the unknowns of a model whose first nodes are those of the wall.
    pub(super) fn displacement(&self, model: &Model) -> Vec<f64> {
        model.vector(|node| self.nodes.get(node).copied().unwrap_or([0.0; KINDS]))
    }
}

/// Equilibrium under weight and the pressures of the model.
///
/// Errors: no equilibrium.
fn equilibrium(model: &Model, gravity: f64) -> Result<State, FeError> {
    let assembler = Assembler::new(model);
    let ordering = order(model, assembler.pattern());
    let symbolic = Symbolic::new(assembler.pattern().clone(), &ordering).map_err(failed)?.into();
    let weight = assembler.body_force(model, [0.0, 0.0, -gravity]);
    let none = vec![0.0; weight.len()];
    let mut state = State::new(model);
    Continuation::new(model, &assembler, &symbolic, &weight, &none, CRITERIA)
        .map_err(failed)?
        .step(&mut state, &Constraint::Load(0.0))
        .map_err(|failure| {
            FeError::Analysis(format!("the wall does not carry its weight and the hydrostatic pressure: {failure}"))
        })?;
    Ok(state)
}

/// K_T(u_s) − K_p(u_s) − K_0 of a shell and the pressure on it.
fn change(model: &Model, state: &State, shell: usize, pressure: usize) -> Result<LocalMatrix, ElementError> {
    let tangent = |e: usize| -> Result<LocalMatrix, ElementError> {
        let element = &*model.elements()[e];
        let (mut gather, mut response) = (Gather::default(), Response::sized(local_size(element)));
        let old = &state.old[state.history(e)];
        let mut new = old.to_vec();
        let motion = gather.motion(model, &state.committed, element);
        element.respond(Trial { motion, old, new: &mut new, want: Want::TANGENT }, &mut response)?;
        Ok(response.tangent)
    };
    let mut out = tangent(shell)?;
    let unloaded = reference_stiffness(&*model.elements()[shell])?;
    for (k, k0) in out.data.iter_mut().zip(&unloaded.data) {
        *k -= k0;
    }
    let load = tangent(pressure)?;
    // Three displacements a node among six unknowns.
    let place = |i: usize| 6 * (i / 3) + i % 3;
    for j in 0..load.n {
        for i in 0..load.n {
            out.add(place(i), place(j), load.get(i, j));
        }
    }
    Ok(out)
}

/// ΔK of one face.
struct Change {
    nodes: [usize; 4],
    change: LocalMatrix,
}

impl Element for Change {
    fem::answers!("loaded_state", nodes, Dof::SHELL; massless);

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        for (j, u) in motion.values.iter().enumerate() {
            for i in 0..self.change.n {
                let k = self.change.get(i, j);
                if want.force {
                    out.force[i] += k * u;
                }
                if want.tangent {
                    out.tangent.add(i, j, k);
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;
    use std::sync::Arc;

    use fem::element::shell::section::ElasticSection;
    use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
    use fem::element::shell4::Axes;
    use fem::mesh::Cylinder;
    use tank::imperfection::{Imperfection, Imperfections, Profile, Wave};

    use super::*;

    /// Source:    ring under internal pressure that turns with it, stability theory (Timoshenko & Gere 1961, 7.3): the deviation
    ///            w_0 cos nθ becomes w_0 cos nθ/(1 + p/p_n), p_n = (n² − 1) E I/R³; so w = −w_0/(1 + (n² − 1) E I/(p R³))
    /// Model:     ring of one row of shells, ν = 0, without axial displacement, 64 sectors, w_0 = R/10⁴
    /// Expected:  −½ w_0 at p = p_n and −¾ w_0 at p = 3 p_n
    /// Tolerance: 2 %: sixteen cells a wave (their bending is about 1.5 % too stiff, half of which counts)
    #[test]
    fn pressure_straightens_a_ring() {
        let (radius, t, young, n, sectors) = (1.0, 0.01, 210e9, 4, 64);
        let critical = f64::from(n * n - 1) * young * t * t * t / 12.0;
        for (factor, expected) in [(1.0, -0.5), (3.0, -0.75)] {
            let imperfections = Imperfections {
                parts: vec![Imperfection::Wave(Wave { n, amplitude: 1e-4, profile: Profile::Constant, phase: 0.0 })],
            };
            let form = Form { radius, height: 0.1, imperfections: &imperfections, wet: true };
            let mesh = Cylinder { radii: vec![0.0, radius], sectors, heights: vec![0.0, 0.1] };
            let wall = mesh.wall().unwrap();
            let mut builder = Builder::new();
            let places: Vec<[f64; 3]> = wall.nodes.iter().map(|p| form.moved(*p)).collect();
            builder.nodes(&places);
            let section: Arc<dyn fem::element::shell::section::Section> =
                Arc::new(ElasticSection::new(young, 0.0, t, 0.0).unwrap());
            let cells = wall.cells.iter().map(|face| ShellCell {
                nodes: face.nodes,
                section: section.clone(),
                group: "wall".into(),
            });
            let normal = |_: usize, node: usize| form.normal(wall.nodes[node]);
            let surface = ShellSurface {
                normals: Normals::Exact(&normal),
                axes: Axes::HOOP_Z,
                ..ShellSurface::new(cells.collect())
            };
            surface.place(&mut builder).unwrap();
            for row in &wall.rows {
                for &node in row {
                    builder.hold(node, Dof::Uz);
                    builder.hold(node, Dof::Rx);
                }
                // Crests do not move around the ring.
                builder.hold(row[0], Dof::Uy);
                builder.hold(row[sectors / 2], Dof::Uy);
                builder.hold(row[sectors / 4], Dof::Ux);
            }
            for face in &wall.cells {
                let positions = face.nodes.map(|k| builder.position(k));
                builder.element(PRESSURE, FollowerPressure::new(face.nodes, positions, factor * critical));
            }
            let model = builder.build().unwrap();
            let state = equilibrium(&model, 0.0).unwrap();
            let row = &wall.rows[0];
            let amplitude: f64 = row
                .iter()
                .enumerate()
                .map(|(s, &node)| {
                    let theta = TAU * s as f64 / sectors as f64;
                    let u = model.at_node(&state.committed.u, node);
                    let radial = u[0] * theta.cos() + u[1] * theta.sin();
                    2.0 / sectors as f64 * radial * (f64::from(n) * theta).cos()
                })
                .sum();
            let found = amplitude / 1e-4;
            assert!((found / expected - 1.0).abs() < 0.02, "{factor}: {found} for {expected}");
        }
    }
}
