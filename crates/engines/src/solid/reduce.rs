//! A tank in three dimensions as a [`Coupled`] system: the space that one direction of ground motion excites, and every
//! observation projected on it.
//!
//! ```text
//! x = V q          M_r = Vᵀ M V,  K_r = Vᵀ K V          ι_r = M_r⁻¹ Vᵀ f
//! ```
//!
//! f is the load of a unit ground acceleration. In terms of the whole motion, x + ι x_g with φ included (φ_ι: the
//! liquid's potential under a unit rigid motion of its boundary; z − H for vertical motion, whose pressure is
//! ρ a_g (H − z)),
//!
//! ```text
//! f = M_s ι + ρ Bᵀ φ_ι  (wall, clamped edge included)          ρ S φ_ι  (surface)
//! y = d·x + a·ẍ_total + b a_g  →  d_r = Vᵀ d,  a_r = Vᵀ a,  b_r = b + a·ι − a_r·ι_r
//! ```
//!
//! so that an observation of accelerations is exact for the rigid part whatever the basis. −ρ φ̈ has the mean ρ g η over
//! the surface, which adds to d under vertical motion.

use std::cell::RefCell;
use std::collections::BTreeMap;

use fem::assembly::local_values;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{Fluid8, LiquidProperties, reference_stiffness};
use fem::linalg::{Cholesky, Matrix, dot, transposed_product};
use fem::progress::Progress;
use tank::Case;

use super::Liquid;
use super::SolidOptions;
use super::model::{SURFACE, TankModel, WALL, displacement_liquid, element_error};
use super::ritz::{Ritz, reduce, symmetric};
use super::rows::{Observer, Resultant, Row, sparse_dot, static_load};
use super::symmetry::Harmonic;
use super::system::{System, columns};
use crate::coupled::{Coupled, Part, ShapeRows, SparseRow};
use crate::error::failure;
use crate::probe::{ModeSelection, Probe, ProbeLine};
use crate::{FeError, Options};
use results::Channel;
use results::Labelled;
use results::channel::{OnWall, Side};

/// Ritz vectors of one direction of motion.
pub const VECTORS: usize = 80;

/// Poles of the reduction beside s = 0 [rad²/s²]: none with a potential; with a displacement liquid, ω² and (2.5 ω)² with ω
/// near the first mode of the wall,
///
/// ```text
/// ω = 2π/(C H) √(E t/(ρ R))     C = 6.5, t the mean thickness (Malhotra, Wenk & Wieland 2000: C = 6.1 … 9.3)
/// ```
pub fn poles(case: &Case, solid: &SolidOptions) -> Vec<f64> {
    if solid.liquid == Liquid::Potential {
        return Vec::new();
    }
    let tank = &case.tank;
    let height = tank.wall_height();
    let stiffness: f64 = tank
        .courses
        .iter()
        .map(|c| c.material.youngs_modulus * c.thickness * c.height)
        .sum();
    let (depth, radius) = (case.liquid.fill_height, tank.shape.half_length());
    let omega = std::f64::consts::TAU / (6.5 * depth) * (stiffness / height / (case.liquid.density * radius)).sqrt();
    vec![omega * omega, 6.25 * omega * omega]
}

/// What leads from the reduced coordinates of one direction of motion back to the model.
pub struct Space {
    /// Basis over the unknowns of the model, potentials included.
    pub basis: Matrix,
    /// Unknowns under a unit rigid motion of the ground: displacements and potential.
    pub rigid: Vec<f64>,
    /// Static displacements of the wall.
    pub statics: Vec<f64>,
    /// Whether an unknown is a potential.
    pub potentials: Vec<bool>,
    /// Mean elevation of a potential liquid's surface over the unknowns.
    pub mean_elevation: SparseRow,
    /// Row of every probe over the unknowns, by [`Probe::key`].
    pub rows: BTreeMap<String, Row>,
}

/// Static displacements of the wall under hydrostatic pressure and weight.
///
/// Errors: a stiffness matrix that is not positive definite.
pub fn statics(tank: &TankModel) -> Result<Vec<f64>, FeError> {
    let dofs = tank.model.dofs();
    let wall_nodes = tank.wall.rows.len() * tank.division.sectors;
    let own: Vec<usize> = (0..dofs.len()).filter(|&e| dofs.unknown(e).0 < wall_nodes).collect();
    let stiffness = tank
        .assembler
        .stiffness_of(&tank.model, |e| tank.is_in(e, &[WALL]))
        .map_err(element_error)?
        .submatrix(&own);
    let load = static_load(tank, &tank.assembler);
    let right: Vec<f64> = own.iter().map(|&e| load[e]).collect();
    let solved = super::system::symbolic(&stiffness, &tank.model, &own)?
        .factor(&stiffness, fem::linalg::Kind::Definite)
        .and_then(|f| f.solve_vector(&right))
        .map_err(failure("the wall's static stiffness"))?;
    let mut x = vec![0.0; dofs.len()];
    for (&e, v) in own.iter().zip(solved) {
        x[e] = v;
    }
    Ok(x)
}

/// Unknowns and load of a unit rigid motion of the ground.
///
/// Errors: not enough memory.
pub fn rigid_motion(tank: &TankModel, system: &System, harmonic: u32) -> Result<(Vec<f64>, Vec<f64>), FeError> {
    let observer = Observer { tank, harmonic };
    let ground = observer.ground();
    let model = &tank.model;
    let inertia = tank.assembler.inertia(model, |_| ground);
    let dofs = model.dofs();
    let mut rigid = model.vector(|_| ground);
    let potential = match harmonic {
        1 => system.potential_of(&inertia)?,
        _ => (0..dofs.len())
            .map(|e| {
                let (node, dof) = dofs.unknown(e);
                (dof == Dof::Phi).then(|| model.nodes()[node][2] - tank.depth)
            })
            .collect(),
    };
    for (e, value) in rigid.iter_mut().enumerate() {
        match (dofs.unknown(e).1, potential[e]) {
            (Dof::Phi, Some(phi)) => *value = phi,
            (Dof::Phi | Dof::Eta, _) => *value = 0.0,
            _ => {}
        }
    }
    // Inertia of the wall, held edge included, and the liquid's pressure under rigid motion.
    let mut only_potential = rigid.clone();
    for (e, value) in only_potential.iter_mut().enumerate() {
        if dofs.unknown(e).1 != Dof::Phi {
            *value = 0.0;
        }
    }
    let pressure = system.mass_times(&only_potential);
    let mut load = inertia;
    for (e, value) in load.iter_mut().enumerate() {
        *value = match dofs.unknown(e).1 {
            Dof::Phi => 0.0,
            _ => *value + pressure[e],
        };
    }
    Ok((rigid, load))
}

/// Reduces a tank for the motion of one harmonic: 1 along x, 0 along z.
///
/// Errors: a matrix that is not positive definite; not enough memory.
pub fn new(
    case: &Case,
    options: &Options,
    tank: &TankModel,
    system: &System,
    harmonic: u32,
    progress: &dyn Progress,
) -> Result<(Coupled, Space), FeError> {
    let (rigid, load) = rigid_motion(tank, system, harmonic)?;
    let symmetry = Harmonic::new(tank, harmonic);
    let Ritz { basis, mass, stiffness } = reduce(system, &load, VECTORS, &|x| symmetry.project(x), progress)?;
    let factor = Cholesky::factor(&mass).map_err(failure("the reduced mass matrix"))?;
    let influence = factor.solve_vector(&basis.transposed_times(&load));
    let statics = statics(tank)?;
    let projector = Projector {
        tank,
        system,
        basis: &basis,
        rigid: &rigid,
        influence: &influence,
        statics: &statics,
        observer: Observer { tank, harmonic },
        rows: RefCell::new(BTreeMap::new()),
    };
    let probes = projector.probes(case, options)?;
    let lines = projector.lines(case, &probes);
    let moment_arm = match probes.iter().find(|p| p.channel == Channel::BaseMoment) {
        // In free vibration q = −K⁻¹ M q̈, so that d·q + a·q̈ = (M κ)·q̈ with κ = M⁻¹ a − K⁻¹ d.
        Some(moment) if harmonic == 1 => {
            let mut arm = factor.solve_vector(&moment.absolute_acceleration);
            if !moment.displacement.is_empty() {
                let elastic = Cholesky::factor(&stiffness).map_err(failure("the reduced stiffness matrix"))?;
                for (a, d) in arm.iter_mut().zip(elastic.solve_vector(&moment.displacement)) {
                    *a -= d;
                }
            }
            arm
        }
        _ => vec![0.0; influence.len()],
    };
    let shape_rows = projector.shape_rows();
    let rows = projector.rows.into_inner();
    let surface = surface_part(tank, &basis)?;
    let coupled = Coupled {
        harmonic,
        surface,
        rotation: rotation_part(case, tank, &basis)?,
        probes,
        lines,
        liquid_mass: case.liquid_mass(),
        wall_mass: case.tank.wall_mass() + case.tank.roof.mass,
        moment_arm,
        mesh: describe(tank, system, basis.cols),
        shape_rows,
        mass,
        stiffness,
        influence,
    };
    let dofs = tank.model.dofs();
    let space = Space {
        rows,
        basis,
        rigid,
        statics,
        potentials: (0..dofs.len()).map(|e| dofs.unknown(e).1 == Dof::Phi).collect(),
        mean_elevation: system.mean_elevation.clone(),
    };
    Ok((coupled, space))
}

/// Vᵀ (ρ g S) V.
fn surface_part(tank: &TankModel, basis: &Matrix) -> Result<Part, FeError> {
    let gravity = tank
        .assembler
        .stiffness_of(&tank.model, |e| tank.is_in(e, &[SURFACE]))
        .map_err(element_error)?;
    let images: Vec<Vec<f64>> = (0..basis.cols).map(|j| gravity.times(basis.column(j))).collect();
    Ok(Part {
        unknowns: 0..basis.cols,
        stiffness: symmetric(transposed_product(basis, &columns(&images))),
    })
}

/// Vᵀ R V of the rotation penalty of a displacement liquid.
fn rotation_part(case: &Case, tank: &TankModel, basis: &Matrix) -> Result<Option<Part>, FeError> {
    if tank.liquid == Liquid::Potential {
        return Ok(None);
    }
    // The same elements with a bulk modulus of nothing beside the penalty.
    let own = displacement_liquid(case);
    let rotation_only = LiquidProperties {
        bulk_modulus: 1e-9 * own.density * case.gravity * tank.radius,
        ..own
    };
    let n = basis.cols;
    let mut sum = Matrix::zeros(n, n);
    for cell in &tank.volume.cells {
        let element = Fluid8::new(cell, Chart::Cylindrical, rotation_only).map_err(element_error)?;
        let stiffness = reference_stiffness(&element).map_err(element_error)?.to_matrix();
        let values: Vec<Vec<f64>> = (0..n)
            .map(|j| local_values(&tank.model, &element, basis.column(j)))
            .collect();
        let local = columns(&values);
        let energy = transposed_product(&local, &fem::linalg::product(&stiffness, &local));
        for (s, e) in sum.data.iter_mut().zip(&energy.data) {
            *s += e;
        }
    }
    Ok(Some(Part {
        unknowns: 0..n,
        stiffness: symmetric(sum),
    }))
}

fn describe(tank: &TankModel, system: &System, vectors: usize) -> Vec<Labelled> {
    let division = &tank.division;
    let label = |label: &str, text: String| Labelled {
        label: label.into(),
        text,
    };
    let shortest = division.wall.windows(2).fold(f64::INFINITY, |m, z| m.min(z[1] - z[0]));
    vec![
        label(
            "liquid elements",
            format!(
                "{} × {} × {} (radius, circumference, depth), eight nodes, {}",
                division.radii.len() - 1,
                division.sectors,
                division.liquid.len() - 1,
                match tank.liquid {
                    Liquid::Potential => "displacement potential",
                    Liquid::Displacement => "displacements, mean dilatation, split rotation penalty",
                }
            ),
        ),
        label(
            "wall elements",
            format!(
                "{} × {} (circumference, height), four-node shells, shortest {shortest:.2e} m",
                division.sectors,
                division.wall.len() - 1
            ),
        ),
        label(
            "unknowns",
            format!("{} in {} nodes", system.size(), tank.model.nodes().len()),
        ),
        label(
            "memory",
            format!("about {} MiB for matrices and factors", system.bytes.div_ceil(1 << 20)),
        ),
        label(
            "reduction",
            format!("{vectors} load-dependent Ritz vectors, the static response among them"),
        ),
    ]
}

/// Turns rows over the model into probes over the reduced coordinates.
struct Projector<'a> {
    tank: &'a TankModel,
    system: &'a System,
    basis: &'a Matrix,
    rigid: &'a [f64],
    influence: &'a [f64],
    statics: &'a [f64],
    observer: Observer<'a>,
    /// The rows that have been made into probes, by [`Probe::key`].
    rows: RefCell<BTreeMap<String, Row>>,
}

impl Projector<'_> {
    fn project(&self, row: &[(usize, f64)]) -> Vec<f64> {
        if row.is_empty() {
            return Vec::new();
        }
        (0..self.basis.cols)
            .map(|j| sparse_dot(row, self.basis.column(j)))
            .collect()
    }

    /// Completes `probe` from its row.
    fn probe(&self, probe: Probe, row: &Row) -> Probe {
        self.rows.borrow_mut().insert(probe.key(), row.clone());
        let dofs = self.tank.model.dofs();
        let mut displacement = row.displacement.clone();
        // The mean of φ̈ over the surface is −g times the mean elevation.
        let potential: f64 = row
            .acceleration
            .iter()
            .filter(|(e, _)| dofs.unknown(*e).1 == Dof::Phi)
            .map(|(_, c)| c)
            .sum();
        if self.observer.harmonic == 0 && potential != 0.0 {
            let factor = -self.tank.gravity * potential;
            displacement.extend(self.system.mean_elevation.iter().map(|&(e, w)| (e, factor * w)));
        }
        let acceleration = self.project(&row.acceleration);
        let rigid = row.held + sparse_dot(&row.acceleration, self.rigid);
        Probe {
            displacement: self.project(&displacement),
            ground_acceleration: rigid - dot(&acceleration, self.influence),
            absolute_acceleration: acceleration,
            ..probe
        }
    }

    fn gauge(&self, r: f64, channel: Channel, options: &Options) -> Probe {
        let probe = Probe {
            modes: ModeSelection::FirstSloshing(options.wave_modes),
            ..Probe::new(channel)
        };
        self.probe(probe, &self.observer.elevation(r))
    }

    /// Scalar outputs, as of the harmonic engine.
    fn probes(&self, case: &Case, options: &Options) -> Result<Vec<Probe>, FeError> {
        let mut probes = vec![self.gauge(self.tank.radius, Channel::Wave(Side::Front), options)];
        for &r in &options.gauges {
            probes.push(self.gauge(r, Channel::WaveAt { r }, options));
        }
        probes.extend(self.reactions()?);
        probes.extend(self.base(case)?);
        for &z in &options.stations {
            let level = self.level_of(z);
            let courses = self.tank.wall.courses();
            let Some(course) = courses.iter().find(|c| c.contains(&level)) else {
                continue;
            };
            for line in STRESSES {
                let probe = Probe::new(Channel::At { what: line.0, z });
                probes.push(self.wall_probe(probe, line.1, course, z));
            }
            let nodes = &self.tank.wall.z;
            let share = (z - nodes[level]) / (nodes[level + 1] - nodes[level]);
            let mut row = self.observer.radial_displacement(level).scaled(1.0 - share);
            let above = self.observer.radial_displacement(level + 1).scaled(share);
            row.displacement.extend(above.displacement);
            let what = OnWall::Displacement;
            probes.push(self.displacement(Probe::new(Channel::At { what, z }), &row));
        }
        Ok(probes)
    }

    /// Level of elements that holds the height z, the upper one at a node.
    fn level_of(&self, z: f64) -> usize {
        let nodes = &self.tank.wall.z;
        nodes.partition_point(|x| *x <= z).clamp(1, nodes.len() - 1) - 1
    }

    /// Base shear, moment above and below the bottom plate.
    fn reactions(&self) -> Result<Vec<Probe>, FeError> {
        let (shear, moment, below) = if self.observer.harmonic == 1 {
            let ground = self.observer.ground();
            let moment = self.observer.base_moment()?;
            let bottom = self.observer.bottom_moment()?;
            let mut below = moment.clone();
            below.acceleration.extend(bottom.acceleration);
            below.displacement.extend(bottom.displacement);
            (self.observer.inertia(&|_| ground), moment, below)
        } else {
            (Row::default(), Row::default(), Row::default())
        };
        Ok(vec![
            self.probe(Probe::new(Channel::BaseShear), &shear),
            self.probe(Probe::new(Channel::BaseMoment), &moment),
            self.probe(Probe::new(Channel::OverturningMoment), &below),
        ])
    }

    /// Stresses of the clamped edge from its reactions.
    fn base(&self, case: &Case) -> Result<Vec<Probe>, FeError> {
        let t = self.tank.wall.thickness[0];
        let moment = self.observer.edge_reaction(Dof::Ry)?;
        let axial = self.observer.edge_reaction(Dof::Uz)?.scaled(-1.0);
        let of_moment = sparse_dot(&moment.displacement, self.statics);
        // The weight that the lowest elements bring onto the edge itself is no displacement's.
        let (tank, roof) = (&case.tank, case.tank.roof.mass);
        let weight = case.gravity * (tank.wall_mass() + roof) / (std::f64::consts::TAU * self.tank.radius);
        let probe = |what, row: Row, static_value| {
            let empty = Probe {
                static_value,
                ..Probe::new(Channel::Base(what))
            };
            self.probe(empty, &row)
        };
        let bending = moment.clone().scaled(6.0 / (t * t));
        Ok(vec![
            probe(OnWall::Axial, axial.scaled(1.0 / t), -weight / t),
            probe(OnWall::Bending, bending, 6.0 / (t * t) * of_moment),
            probe(OnWall::Moment, moment, of_moment),
        ])
    }

    /// A stress at the height z of a course.
    fn wall_probe(&self, probe: Probe, resultant: Resultant, course: &std::ops::Range<usize>, z: f64) -> Probe {
        let wall = &self.tank.wall;
        let t = wall.thickness[course.start];
        let factor = match resultant {
            Resultant::Moment => 6.0 / (t * t),
            _ => 1.0 / t,
        };
        let poisson = wall.poisson_ratio[course.start];
        let row = self.observer.resultant(course, z, resultant, poisson).scaled(factor);
        let probe = Probe {
            static_value: sparse_dot(&row.displacement, self.statics) * self.static_factor(),
            ..probe
        };
        self.probe(probe, &row)
    }

    /// Rows of wall resultants under horizontal motion hold 1/cos(π/N), which the static state does not need.
    fn static_factor(&self) -> f64 {
        match self.observer.harmonic {
            0 => 1.0,
            _ => (std::f64::consts::PI / self.tank.division.sectors as f64).cos(),
        }
    }

    fn displacement(&self, probe: Probe, row: &Row) -> Probe {
        let probe = Probe {
            static_value: sparse_dot(&row.displacement, self.statics),
            ..probe
        };
        self.probe(probe, row)
    }

    /// Outputs over the height; the stresses of the base are those of `base`, from reactions.
    fn lines(&self, case: &Case, base: &[Probe]) -> Vec<ProbeLine> {
        let wetted = &self.tank.division.liquid;
        let weight = case.liquid.density * case.gravity;
        let pressure = wetted.iter().enumerate().map(|(i, z)| {
            let probe = Probe {
                static_value: weight * (self.tank.depth - z).max(0.0),
                ..ProbeLine::probe(OnWall::Pressure, i, *z)
            };
            self.probe(probe, &self.observer.pressure(i))
        });
        let mut lines = vec![ProbeLine {
            what: OnWall::Pressure,
            z: wetted.clone(),
            probes: pressure.collect(),
        }];
        let z = &self.tank.wall.z;
        // Both sides of a joint of courses.
        let places: Vec<(f64, std::ops::Range<usize>)> = (self.tank.wall.courses().into_iter())
            .flat_map(|course| (course.start..=course.end).map(move |level| (z[level], course.clone())))
            .collect();
        for (what, resultant) in STRESSES {
            let edge = base.iter().find(|p| p.channel == Channel::Base(what));
            let probes = places.iter().enumerate().map(|(i, (z, course))| {
                let probe = ProbeLine::probe(what, i, *z);
                match (i, edge) {
                    (0, Some(edge)) => {
                        let row = self.rows.borrow().get(&edge.key()).cloned().unwrap_or_default();
                        self.rows.borrow_mut().insert(probe.key(), row);
                        Probe {
                            channel: probe.channel,
                            place: probe.place,
                            ..edge.clone()
                        }
                    }
                    _ => self.wall_probe(probe, resultant, course, *z),
                }
            });
            lines.push(ProbeLine {
                what,
                z: places.iter().map(|p| p.0).collect(),
                probes: probes.collect(),
            });
        }
        let what = OnWall::Displacement;
        lines.push(ProbeLine {
            what,
            z: z.clone(),
            probes: (z.iter().enumerate())
                .map(|(level, z)| {
                    let row = self.observer.radial_displacement(level);
                    self.displacement(ProbeLine::probe(what, level, *z), &row)
                })
                .collect(),
        });
        lines
    }

    fn shape_rows(&self) -> ShapeRows {
        let dense = |row: SparseRow| -> SparseRow { self.project(&row).into_iter().enumerate().collect() };
        let radii = &self.tank.division.radii;
        ShapeRows {
            z: self.tank.wall.z.clone(),
            wall: (0..self.tank.wall.z.len())
                .map(|level| dense(self.observer.radial_displacement(level).displacement))
                .collect(),
            r: radii.clone(),
            surface: radii
                .iter()
                .map(|&r| dense(self.observer.elevation(r).displacement))
                .collect(),
        }
    }
}

/// Stresses over the height.
const STRESSES: [(OnWall, Resultant); 3] = [
    (OnWall::Hoop, Resultant::Hoop),
    (OnWall::Axial, Resultant::Axial),
    (OnWall::Bending, Resultant::Moment),
];
