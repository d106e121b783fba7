//! The model of a strip: elements, loads, damping, modes.

use std::sync::Arc;

use fem::analysis::damping::{Damping, RatioRow, Rayleigh};
use fem::analysis::failed;
use fem::analysis::observable::{Observable, apply};
use fem::analysis::system::System;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::{Inspect, Response, Trial, Want, local_size};
use fem::linalg::{Eigen, Ordering, Symbolic, dot, generalized_eigen};
use fem::model::{Builder, Model};
use fem::state::{Gather, State};
use results::channel::Side;

use super::chain::{self, Chain};
use super::contact::{self, Joints};
use super::liquid::WallLiquid;
use super::parameters::{Contact, StripError, StripTank};
use super::parts::{
    BASE, StripDamping, base_rows, check, coefficients, dofs_of, first_wall_mode, liquid_element, wall_forces,
};
use super::placed::{PlacedWall, WALL};

/// Reaction of the ground on the base of a wall along x and z and about y [N/m, N/m, N], by origin. The parts add up
/// to the reaction; only the first is limited by the strength of the section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BaseReaction {
    /// Stresses of the lowest element, M(z) extrapolated linearly from its sections to the base.
    pub section: [f64; 3],
    /// Viscous damping.
    pub damping: [f64; 3],
    /// Inertia of the lowest element and dynamic pressure on it.
    pub inertia: [f64; 3],
    /// Weight and pressure at rest whose nodal loads act on the base itself.
    pub load: [f64; 3],
}

impl BaseReaction {
    /// Sum of the parts.
    pub fn total(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.section[i] + self.load[i] + self.damping[i] + self.inertia[i])
    }
}

/// The model, built once; runs only read it.
pub struct StripModel {
    /// Nodes and elements: the beams or shells from the bottom, the liquid, the spring if there is one.
    pub model: Model,
    /// Its assembler.
    pub assembler: Assembler,
    /// Order of elimination.
    pub symbolic: Arc<Symbolic>,
    /// Mass and initial stiffness of the strip, with the damping.
    pub system: System,
    /// Modes of the initial strip.
    pub modes: Eigen,
    /// Number of the first mode that is not sloshing.
    pub wall_mode: usize,
    /// Ratios of all modes.
    pub ratios: Vec<RatioRow>,
    /// Nodal forces of the wall's weight.
    pub weight: Vec<f64>,
    /// Nodal forces of the pressure at rest; of elements of the liquid, their weight.
    pub pressure: Vec<f64>,
    /// The wall, to which the condensed liquid of the antisymmetric motion belongs; both walls of a [`Chain`].
    pub walls: Vec<PlacedWall>,
    /// The liquid of elements between both walls, in place of the condensed one.
    pub chain: Option<Chain>,
    /// Nodes of the condensed liquid's face upwards, one a level: the wall's own with the unknowns of the trace, or, where the two are joined, others
    /// with Ux alone.
    pub face: Vec<usize>,
    /// Joints between them.
    pub joints: Option<Joints>,
    /// The condensed liquid on the wall.
    pub liquid: WallLiquid,
    /// Parameters.
    pub tank: StripTank,
    /// Equations of the sloshing amplitudes.
    pub amplitudes: Vec<usize>,
}

/// Group of the liquid.
pub(super) const LIQUID: &str = "liquid";

/// Rayleigh's coefficients of every group: those of the wall, and of the rest.
pub(super) fn by_group(model: &Model, [wall, rest]: [Rayleigh; 2]) -> Vec<Rayleigh> {
    let of = |name: &String| match name.as_str() {
        // A joint that is open must not pull by its rate either.
        contact::JOINT => Rayleigh::NONE,
        WALL => wall,
        _ => rest,
    };
    model.groups().iter().map(of).collect()
}

impl StripModel {
    /// Errors: parameters out of range, those of elements, model and eigenvalue solver.
    pub fn new(tank: &StripTank, damping: StripDamping) -> Result<StripModel, StripError> {
        check(tank, damping)?;
        match &tank.mesh {
            Some(mesh) => chain::model(tank, mesh, damping),
            None => StripModel::condensed(tank, damping),
        }
    }

    // Long: the order in which parts join the builder numbers the unknowns; the rest fills a struct of 14 fields.
    fn condensed(tank: &StripTank, damping: StripDamping) -> Result<StripModel, StripError> {
        let mut builder = Builder::new();
        let mut wall = PlacedWall::add_to(&mut builder, tank, 1.0)?;
        let wet = &wall.wet;
        let amplitude_nodes: Vec<usize> =
            (0..tank.sloshing).map(|_| builder.node([0.0, 0.0, tank.liquid.depth])).collect();
        let touched: Vec<Vec<usize>> = match tank.contact {
            Contact::Bonded => wet.clone(),
            Contact::Joined { .. } => contact::face(&mut builder, tank).into_iter().map(|n| vec![n]).collect(),
        };
        let face: Vec<usize> = touched.iter().map(|level| level[0]).collect();
        let levels = &tank.levels[..face.len()];
        let trace = tank.trace();
        let liquid = tank.liquid.on(trace, levels, tank.sloshing);
        builder.element(LIQUID, liquid_element(tank, damping, &liquid, &touched, &amplitude_nodes)?);
        let joints = match tank.contact {
            Contact::Bonded => None,
            Contact::Joined { opens, penalty } => {
                let penalty = match penalty {
                    Some(given) => given,
                    None => contact::penalty(tank)?,
                };
                Some(Joints::add_to(&mut builder, tank, wet, [&face, &amplitude_nodes], penalty, opens)?)
            }
        };
        wall.stand(&mut builder, tank)?;
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree);
        let symbolic = Arc::new(symbolic.map_err(failed("the strip"))?);
        let mut system = System::new(&model, &assembler)?;
        let (k, m) = (system.stiffness.to_dense(), system.mass.to_dense());
        let modes = generalized_eigen(&k, &m, None).map_err(failed("modes of the strip"))?;
        let amplitudes: Vec<usize> =
            amplitude_nodes.iter().filter_map(|&n| model.dofs().equation(n, Dof::Amplitude)).collect();
        let wall_mode = first_wall_mode(tank, &modes, &amplitudes);
        let groups = by_group(&model, coefficients(damping, modes.omega[wall_mode]));
        system.damping = match damping {
            StripDamping::Rayleigh(all) if joints.is_none() => Damping::rayleigh(all),
            _ => Damping::by_group(&assembler, &model, &groups, false)?,
        };
        let ratios = system.damping.ratios(&system.mass, &system.stiffness, &modes);
        wall.feet.push(face[0]);
        wall.base = base_rows(&model, &wall.feet, tank, &groups)?;
        wall.carried = wall.base.each_ref().map(|row| row.total_ground(&system.influence));
        let weight = assembler.body_force(&model, [0.0, 0.0, -tank.liquid.gravity]);
        let pressure = wall_forces(&model, &touched, dofs_of(trace), &liquid.hydrostatic);
        Ok(StripModel {
            model,
            assembler,
            symbolic,
            system,
            modes,
            wall_mode,
            ratios,
            weight,
            pressure,
            walls: vec![wall],
            chain: None,
            face,
            joints,
            liquid,
            tank: tank.clone(),
            amplitudes,
        })
    }

    /// Marches that both walls take: one through the same record with either sign for each, one where both stand in the model.
    pub fn marches(&self) -> usize {
        3 - self.walls.len()
    }

    /// The wall of a side, which in a model of one wall is that wall.
    pub fn wall(&self, side: Side) -> &PlacedWall {
        self.walls.get(side as usize).unwrap_or(&self.walls[0])
    }

    /// The strip with the condensed liquid, of which the modes are.
    pub fn closed(&self) -> &StripModel {
        self.chain.as_ref().map_or(self, |chain| &chain.closed)
    }

    /// Equation of the top of a wall along x.
    pub fn top(&self, wall: &PlacedWall) -> usize {
        let node = wall.nodes[wall.nodes.len() - 1];
        self.model.dofs().equation(node, Dof::Ux).expect("the top is free")
    }

    /// Unknowns of the liquid's face in `field`, level by level.
    pub fn face_unknowns<'a>(&'a self, field: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let dofs = dofs_of(self.tank.trace());
        self.face.iter().flat_map(move |&node| {
            let own = self.model.at_node(field, node);
            dofs.iter().map(move |dof| own[dof.index()])
        })
    }

    /// Levels of the liquid's face [m].
    pub fn face_levels(&self) -> &[f64] {
        &self.tank.levels[..self.face.len()]
    }

    /// Mass of the condensed liquid on a wall in a translation [kg/m].
    pub(super) fn condensed_mass(&self) -> f64 {
        let each = self.tank.trace().unknowns();
        let (wall, size) = (each * self.face.len(), self.liquid.mass.rows);
        let translation: Vec<f64> = (0..size).map(|i| f64::from(i < wall && i % each == 0)).collect();
        let moved = self.liquid.mass.times(&translation);
        moved.iter().zip(&translation).map(|(a, b)| a * b).sum()
    }

    /// Height of the wall [m].
    pub fn height(&self) -> f64 {
        self.tank.levels[self.tank.levels.len() - 1]
    }

    /// ω of the first wall mode with the liquid [rad/s].
    pub fn wall_frequency(&self) -> f64 {
        self.modes.omega[self.wall_mode]
    }

    /// Ratio of the first wall mode.
    pub fn wall_ratio(&self) -> f64 {
        self.ratios[self.wall_mode].ratio
    }

    /// Elevation of the surface of the condensed liquid at the wall for the unknowns `u` [m].
    pub fn elevation(&self, u: &[f64]) -> f64 {
        let own: Vec<f64> = self.amplitudes.iter().map(|&e| u[e]).collect();
        dot(&own, &self.liquid.elevation)
    }

    /// Settlement of the mean surface while both walls give way by the deflection in `u` [m]: ∫ w dz/L, the liquid being
    /// incompressible.
    pub fn settlement(&self, u: &[f64]) -> f64 {
        if let Some(chain) = &self.chain {
            return chain.settlement(self, u);
        }
        let area: f64 = self.face_unknowns(u).zip(&self.liquid.area).map(|(x, a)| x * a).sum();
        area / self.tank.liquid.half_width
    }

    /// Reaction of the ground on the base of `wall`, part by part, at the committed `state`; `ground`: acceleration of the
    /// ground [m/s²] in the wall's own axes.
    ///
    /// Errors: those of the elements.
    pub fn base_reaction(
        &self,
        wall: &PlacedWall,
        state: &State,
        ground: [f64; 3],
    ) -> Result<BaseReaction, StripError> {
        let mut out = BaseReaction::default();
        let base = &wall.feet;
        let (mut gather, mut response) = (Gather::default(), Response::default());
        let held = |dof: &Dof| self.model.is_held(base[0], *dof);
        // The pressure of a liquid of elements on the foot itself.
        let pressed = |e: usize| self.chain.is_some() && self.model.groups()[self.model.group_of(e)] == contact::JOINT;
        for (e, element) in self.model.elements().iter().enumerate() {
            if !base.iter().any(|node| element.nodes().contains(node)) {
                continue;
            }
            let history = &state.old[state.history(e)];
            response.reset(local_size(&**element));
            let motion = gather.motion(&self.model, &state.committed, &**element);
            element.respond(
                Trial { motion, old: history, new: &mut history.to_vec(), want: Want::FORCE },
                &mut response,
            )?;
            let mut weight = vec![0.0; response.force.len()];
            element.body_force([0.0, 0.0, -self.tank.liquid.gravity], &mut weight);
            // A super-element has a local node for every dof: the base may be there more than once.
            let mut k = 0;
            for (local, &node) in element.nodes().iter().enumerate() {
                for dof in element.dofs(local) {
                    if let Some(i) = BASE.iter().position(|d| base.contains(&node) && d == dof && held(d)) {
                        let part = if pressed(e) { &mut out.load } else { &mut out.section };
                        part[i] += response.force[k];
                        out.load[i] -= weight[k];
                    }
                    k += 1;
                }
            }
        }
        // Pressure at rest and of the vertical motion are nodal loads; their share at the base goes straight into the ground.
        let loads = if self.chain.is_some() { 0 } else { self.tank.trace().unknowns() };
        for (k, i) in [0, 2].into_iter().enumerate().take(loads) {
            out.load[i] -= self.liquid.hydrostatic[k] * (1.0 + ground[2] / self.tank.liquid.gravity);
        }
        let fields = &state.committed;
        if self.tank.base_spring.is_some() {
            out.section[2] = apply(&wall.base[2].displacement, &fields.u);
            out.load[2] = 0.0;
        }
        for (i, (row, total)) in wall.base.iter().zip(&wall.carried).enumerate() {
            out.damping[i] = apply(&row.velocity, &fields.v);
            let carried: f64 = total.iter().zip(ground).map(|(b, a)| b * a).sum();
            out.inertia[i] = apply(&row.acceleration, &fields.a) + carried;
        }
        Ok(out)
    }

    /// Curvature [1/m] and moment [N] of the lowest section of `wall` at a committed `state`.
    ///
    /// Errors: those of the element.
    pub fn lowest_section(&self, wall: &PlacedWall, state: &State) -> Result<[f64; 2], StripError> {
        let lowest = wall.elements.start;
        let element = &*self.model.elements()[lowest];
        let mut gather = Gather::default();
        let motion = gather.motion(&self.model, &state.committed, element);
        let found = element.sections(motion, &state.old[state.history(lowest)])?;
        if let Some(shells) = &self.tank.shells {
            return Ok(shells.lowest(&found));
        }
        Ok(found.first().map_or([0.0; 2], |s| [s.strain[3], s.resultants[3]]))
    }

    /// Largest total acceleration of a node of `wall` along x, absolute [m/s²], with the height of the node [m]; `a`:
    /// accelerations relative to the ground, `ground`: that of the ground along the wall's own x [m/s²].
    pub fn largest_acceleration(&self, wall: &PlacedWall, a: &[f64], ground: f64) -> (f64, f64) {
        let along = |&node: &usize| self.model.at_node(a, node)[Dof::Ux.index()] + ground;
        let all = wall.nodes.iter().map(along).zip(&self.tank.levels);
        all.fold((0.0, 0.0), |worst, (a, &z)| if a.abs() > worst.0 { (a.abs(), z) } else { worst })
    }

    /// Moment that the ground exerts on the base of the first wall [N], of the linear strip, relative to the state at rest.
    pub fn base_moment(&self) -> Observable {
        self.walls[0].base[2].clone()
    }

    /// Loads at rest: weight and pressure.
    pub fn at_rest(&self) -> Vec<f64> {
        self.weight.iter().zip(&self.pressure).map(|(w, p)| w + p).collect()
    }

    /// Nodal forces of the pressure ρ (H − z) of a unit vertical acceleration of the ground, upwards.
    pub fn vertical_pressure(&self) -> Vec<f64> {
        self.pressure.iter().map(|p| p / self.tank.liquid.gravity).collect()
    }

    /// Observables of the linear strip, relative to the state at rest: deflection of the top [m], elevation of the surface
    /// at the wall [m].
    pub fn observables(&self) -> Vec<Observable> {
        let observable =
            |name: &str, displacement| Observable { name: name.into(), displacement, ..Observable::default() };
        vec![
            observable("deflection of the top", vec![(self.top(&self.walls[0]), 1.0)]),
            observable(
                "elevation at the wall",
                match &self.chain {
                    Some(chain) => chain.elevation(&self.model),
                    None => self.amplitudes.iter().copied().zip(self.liquid.elevation.iter().copied()).collect(),
                },
            ),
        ]
    }
}
