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
use fem::dofs::{Dof, KINDS};
use fem::element::{Fluid8, LiquidProperties, VolumePart, reference_mass, reference_stiffness};
use fem::linalg::{Cholesky, Matrix, transposed_product};
use fem::progress::Progress;
use tank::Case;

use super::around_probes::{self, What};
use super::coupling;
use super::model::{SURFACE, TankModel};
use super::poles::VECTORS;
use super::project::Projector;
use super::ritz::{Ritz, reduce, symmetric};
use super::rows::{Field, Observer, Row, sparse_dot, static_load, tilt};
use super::symmetry::Symmetry;
use super::system::{System, columns};
use super::wall::{ROOF, WALL};
use crate::FeError;
use crate::coupled::{Coupled, Part, SparseRow};
use crate::error::{failed, failure};
use crate::linear::soil::{Floor, Slab};
use crate::probe::Probe;
use results::Channel;
use results::Labelled;
use tank::options::LinearOptions as Options;
use tank::options::linear::WallDirection;
use tank::options::solid::Liquid;

/// Nodes nearer than this lie on one ring [m].
const RING: f64 = 1e-6;

/// Map from the reduced coordinates of one direction of motion to the model.
pub(super) struct Space {
    /// Basis over the unknowns of the model, potentials included.
    pub basis: Matrix,
    /// Unknowns under a unit rigid motion of the ground: displacements and potential.
    pub rigid: Vec<f64>,
    /// Potentials of a unit translation and rotation of a slab on soil, in the units of its unknowns; none on rigid ground.
    pub slab: Option<[Vec<f64>; 2]>,
    /// Static displacements of the wall.
    pub statics: Vec<f64>,
    /// Whether an unknown is a potential.
    pub potentials: Vec<bool>,
    /// Mean elevation of a potential liquid's surface over the unknowns.
    pub mean_elevation: SparseRow,
    /// Dashpots to the ground: rows over the unknowns and coefficients [N·s/m].
    pub dashpots: Vec<(SparseRow, f64)>,
    /// Probes of an imperfect wall around the tank.
    pub around: Vec<(What, Probe)>,
    /// Row of every probe over the unknowns, by [`crate::probe::Probe::key`].
    pub rows: BTreeMap<String, Row>,
}

/// Static displacements of the wall under hydrostatic pressure and weight.
///
/// Errors: a stiffness matrix that is not positive definite.
pub(super) fn statics(tank: &TankModel) -> Result<Vec<f64>, FeError> {
    if let Some(state) = &tank.loaded {
        return Ok(state.displacement(&tank.model));
    }
    let dofs = tank.model.dofs();
    let wall_nodes = tank.wall.rows.len() * tank.division.sectors;
    let own: Vec<usize> = (0..dofs.len()).filter(|&e| dofs.unknown(e).0 < wall_nodes).collect();
    let stiffness =
        tank.assembler.stiffness_of(&tank.model, |e| tank.is_in(e, &[WALL])).map_err(failed)?.submatrix(&own);
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
pub(super) fn rigid_motion(tank: &TankModel, system: &System, harmonic: u32) -> Result<(Vec<f64>, Vec<f64>), FeError> {
    let observer = Observer { tank, harmonic };
    let ground = observer.ground();
    let model = &tank.model;
    let inertia = tank.assembler.inertia(model, |_| ground);
    let dofs = model.dofs();
    let mut rigid = model.vector(|_| ground);
    let potential = match harmonic {
        1.. => system.potential_of(&inertia)?,
        0 => (0..dofs.len())
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

/// Potential of the liquid in a tank that turns with its slab, per unit rotation about the underside; −p/(ρ ψ̈).
///
/// Errors: not enough memory.
pub(super) fn turning(case: &Case, tank: &TankModel, system: &System, slab: &Slab) -> Result<Vec<f64>, FeError> {
    let (model, dofs, nodes) = (&tank.model, tank.model.dofs(), tank.model.nodes());
    let inertia = tank.assembler.inertia(model, |node| {
        let [x, y, z] = nodes[node];
        tilt([x, y, z + slab.thickness])
    });
    let walls = system.potential_of(&inertia)?;
    let floor = Floor::of(case);
    // Nodes lie on rings: a value for every ring.
    let mut rings: BTreeMap<[i64; 2], f64> = BTreeMap::new();
    let mut whole = vec![0.0; dofs.len()];
    for (e, value) in whole.iter_mut().enumerate() {
        let (Some(of_walls), (node, Dof::Phi)) = (walls[e], dofs.unknown(e)) else { continue };
        let [x, y, z] = nodes[node];
        let r = x.hypot(y);
        let key = [r, z].map(|v| (v / RING).round() as i64);
        let below = *rings.entry(key).or_insert_with(|| floor.potential(r, z));
        *value = of_walls + if r > 0.0 { below * x / r } else { 0.0 };
    }
    Ok(whole)
}

/// Basis and reduced matrices for a load.
///
/// Errors: a matrix that is not positive definite; not enough memory.
fn ritz(
    tank: &TankModel,
    system: &System,
    load: &[f64],
    harmonic: u32,
    progress: &dyn Progress,
) -> Result<Ritz, FeError> {
    if !tank.imperfections.is_empty() {
        return coupling::reduce(tank, system, load, harmonic, progress);
    }
    let symmetry = Symmetry::new(tank, harmonic);
    let loads: Vec<(usize, &[f64])> = (0..system.poles()).map(|pole| (pole, load)).collect();
    reduce(system, &loads, VECTORS, &|x| symmetry.project(x), progress)
}

/// Reduces a tank for the motion of one harmonic: 1 along x, 0 along z.
///
/// Errors: a matrix that is not positive definite; not enough memory.
pub(super) fn new(
    case: &Case,
    options: &Options,
    tank: &TankModel,
    system: &System,
    harmonic: u32,
    progress: &dyn Progress,
) -> Result<(Coupled, Space), FeError> {
    let (rigid, load) = rigid_motion(tank, system, harmonic)?;
    let Ritz { basis, mass, stiffness } = ritz(tank, system, &load, harmonic, progress)?;
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
    let shape_rows = projector.shape_rows();
    let around = if tank.imperfections.is_empty() { Vec::new() } else { around_probes::probes(&projector)? };
    let dashpots = dashpots(&projector.observer, options);
    let rows = projector.rows.into_inner();
    let on_basis = |row: &SparseRow| (0..basis.cols).map(|j| sparse_dot(row, basis.column(j))).collect();
    let coupled = Coupled {
        harmonic,
        surface: surface_part(tank, &basis)?,
        rotation: rotation_part(case, tank, &basis)?,
        lines,
        level: case.liquid.fill_height,
        shear: None,
        liquid_mass: case.liquid_mass(),
        wall_mass: case.tank.wall_mass() + case.tank.roof.mass,
        moment_arm: match harmonic {
            1 => moment_arm(&probes, &factor, &stiffness)?,
            _ => vec![0.0; influence.len()],
        },
        structure: (!tank.is_round() && harmonic == 1).then(|| structure(tank, &basis)),
        dashpots: dashpots.iter().map(|(row, c)| (on_basis(row), *c)).collect(),
        mesh: describe(tank, system, basis.cols),
        shape_rows,
        probes,
        mass,
        stiffness,
        influence,
    };
    let dofs = tank.model.dofs();
    let space = Space {
        dashpots,
        rows,
        around,
        basis,
        rigid,
        slab: None,
        statics,
        potentials: (0..dofs.len()).map(|e| dofs.unknown(e).1 == Dof::Phi).collect(),
        mean_elevation: system.mean_elevation.clone(),
    };
    Ok((coupled, space))
}

/// κ of the base moment in free vibration: with q = −K⁻¹ M q̈, d·q + a·q̈ = (M κ)·q̈ with κ = M⁻¹ a − K⁻¹ d.
///
/// * `mass`: factor of M
///
/// Errors: a stiffness matrix that is not positive definite.
fn moment_arm(probes: &[Probe], mass: &Cholesky, stiffness: &Matrix) -> Result<Vec<f64>, FeError> {
    let Some(moment) = probes.iter().find(|p| p.channel == Channel::BaseMoment) else {
        return Ok(vec![0.0; stiffness.rows]);
    };
    let mut arm = mass.solve_vector(&moment.absolute_acceleration);
    if !moment.displacement.is_empty() {
        let elastic = Cholesky::factor(stiffness).map_err(failure("the reduced stiffness matrix"))?;
        for (a, d) in arm.iter_mut().zip(elastic.solve_vector(&moment.displacement)) {
            *a -= d;
        }
    }
    Ok(arm)
}

/// Rings of dashpots, one at every sector.
fn dashpots(observer: &Observer<'_>, options: &Options) -> Vec<(SparseRow, f64)> {
    let tank = observer.tank;
    let (nodes, sectors) = (&tank.wall.z, tank.division.sectors);
    let mut all = Vec::new();
    for ring in options.dashpots.iter().filter(|_| tank.is_round()) {
        let upper = nodes.partition_point(|z| *z < ring.z).clamp(1, nodes.len() - 1);
        let share = ((ring.z - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1])).min(1.0);
        for sector in 0..sectors {
            let (sine, cosine) = (std::f64::consts::TAU * sector as f64 / sectors as f64).sin_cos();
            let direction = match ring.direction {
                WallDirection::Radial => [cosine, sine, 0.0],
                WallDirection::Tangential => [-sine, cosine, 0.0],
                WallDirection::Vertical => [0.0, 0.0, 1.0],
            };
            let mut row = SparseRow::new();
            for (level, weight) in [(upper - 1, 1.0 - share), (upper, share)] {
                for (dof, part) in [Dof::Ux, Dof::Uy, Dof::Uz].into_iter().zip(direction) {
                    let own = tank.model.row(tank.wall.rows[level][sector], dof);
                    row.extend(own.into_iter().map(|(i, c)| (i, weight * part * c)));
                }
            }
            all.push((row, ring.coefficient / sectors as f64));
        }
    }
    all
}

/// Rows of base shear and base moment of the walls alone and of the roof alone over the reduced accelerations, κᵀ M_group V.
fn structure(tank: &TankModel, basis: &Matrix) -> [[Vec<f64>; 2]; 2] {
    let nodes = tank.model.nodes();
    let mut along = [0.0; KINDS];
    along[0] = 1.0;
    let fields: [Field; 2] = [&|_| along, &|node| tilt(nodes[node])];
    [WALL, ROOF].map(|group| {
        fields.map(|field| {
            let mut row = vec![0.0; tank.model.dofs().len()];
            for (e, element) in tank.model.elements().iter().enumerate() {
                if !tank.is_in(e, &[group]) {
                    continue;
                }
                let own = element.nodes().iter().enumerate();
                let values: Vec<f64> = own
                    .flat_map(|(k, &node)| {
                        let global = field(node);
                        element.dofs(k).iter().map(move |d| global[d.index()])
                    })
                    .collect();
                let momentum = reference_mass(&**element).to_matrix().times(&values);
                for (i, c) in tank.model.spread(&**element, &momentum) {
                    row[i] += c;
                }
            }
            basis.transposed_times(&row)
        })
    })
}

/// Vᵀ (ρ g S) V.
fn surface_part(tank: &TankModel, basis: &Matrix) -> Result<Part, FeError> {
    let gravity = tank.assembler.stiffness_of(&tank.model, |e| tank.is_in(e, &[SURFACE])).map_err(failed)?;
    let images: Vec<Vec<f64>> = (0..basis.cols).map(|j| gravity.times(basis.column(j))).collect();
    Ok(Part { unknowns: 0..basis.cols, stiffness: symmetric(transposed_product(basis, &columns(&images))) })
}

/// Vᵀ R V of the rotation penalty of a displacement liquid.
fn rotation_part(case: &Case, tank: &TankModel, basis: &Matrix) -> Result<Option<Part>, FeError> {
    if tank.liquid == Liquid::Potential {
        return Ok(None);
    }
    // The same elements with a negligible bulk modulus, so that the penalty remains.
    let own = tank.properties;
    let rotation_only = LiquidProperties { bulk_modulus: 1e-9 * own.density * case.gravity * tank.radius, ..own };
    let n = basis.cols;
    let mut sum = Matrix::zeros(n, n);
    for cell in &tank.volume.cells {
        let element = Fluid8::new(cell, Chart::Cylindrical, rotation_only).map_err(failed)?;
        let stiffness = reference_stiffness(&element).map_err(failed)?.to_matrix();
        let values: Vec<Vec<f64>> = (0..n).map(|j| local_values(&tank.model, &element, basis.column(j))).collect();
        let local = columns(&values);
        let energy = transposed_product(&local, &fem::linalg::product(&stiffness, &local));
        for (s, e) in sum.data.iter_mut().zip(&energy.data) {
            *s += e;
        }
    }
    Ok(Some(Part { unknowns: 0..n, stiffness: symmetric(sum) }))
}

fn describe(tank: &TankModel, system: &System, vectors: usize) -> Vec<Labelled> {
    let division = &tank.division;
    let label = |label: &str, text: String| Labelled { label: label.into(), text };
    let shortest = division.wall.windows(2).fold(f64::INFINITY, |m, z| m.min(z[1] - z[0]));
    vec![
        label(
            "liquid elements",
            format!(
                "{} × {} × {} (radius, circumference, depth), eight nodes, {}",
                division.radii.len() - 1,
                division.sectors,
                division.liquid.len() - 1,
                match (tank.liquid, tank.properties.volume) {
                    (Liquid::Potential, _) => "displacement potential",
                    (Liquid::Displacement, VolumePart::OnePoint) =>
                        "displacements, volume part at one point, full rotation part",
                    (Liquid::Displacement, _) => "displacements, mean dilatation, split rotation penalty",
                }
            ),
        ),
        label(
            "wall elements",
            format!(
                "{} × {} (circumference, height), four-node shells, shortest {}",
                division.sectors,
                division.wall.len() - 1,
                tank::units::display(shortest, tank::units::Dimension::Length)
            ),
        ),
        label("unknowns", format!("{} in {} nodes", system.size(), tank.model.nodes().len())),
        label("memory", format!("about {} MiB for matrices and factors", system.bytes.div_ceil(1 << 20))),
        label("reduction", format!("{vectors} load-dependent Ritz vectors, the static response among them")),
    ]
}
