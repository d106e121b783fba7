//! Shells: S1 to S22.
//!
//! Meshes, supports and loads are those of the sources. Where a row compares a coarse mesh, its reference is what an
//! independent prototype of the same formulation gave on that mesh ([`Reference::SecondFormulation`]); the finest mesh
//! is compared with the published value.

mod beams;
mod buckling;
mod cylinder_modes;
mod cylinder_wall;
mod element;
mod elephant;
mod finite;
mod large;
mod panel;
mod path;
mod plane;
mod plastic;
mod pressure;
mod pressurized;
mod roof;
mod shells;
mod tank;

pub use cylinder_wall::{CylinderWall, Piece, WallSolution};
pub use tank::{TankStrip, tank_pieces, wall_strip};

use std::sync::Arc;

use nalgebra::Vector3;

use super::{Reference, Row};
use fem::analysis::AnalysisError;
use fem::assembly::Assembler;
use fem::dofs::{Dof, KINDS};
use fem::element::ElementError;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::Section;
use fem::element::shell::surface::{PlacedShell, ShellCell, ShellSurface};
use fem::linalg::{Kind, LinalgError, Ordering, Symbolic};
use fem::model::{Builder, Model, ModelError};

/// Failure of a verification model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShellVerifyError {
    /// An element.
    #[error(transparent)]
    Element(#[from] ElementError),
    /// The model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A solver.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
    /// An analysis.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
    /// A path that ends early.
    #[error("the path ends at {reached:.3} of its length: {why}")]
    Path {
        /// Part that was followed.
        reached: f64,
        /// Why it ended.
        why: String,
    },
}

type Answer<T> = Result<T, ShellVerifyError>;

/// Rows that take seconds.
///
/// Errors: a model that cannot be solved.
pub fn shell() -> Answer<Vec<Row>> {
    let parts = [
        element::element()?,
        plane::patch()?,
        shells::scordelis_lo(&[4, 8, 16])?,
        shells::pinched_cylinder(&[4, 8, 16, 32])?,
        shells::hemisphere(&[4, 8, 16])?,
        shells::twisted_beam()?,
        plane::cook(&[2, 4, 8, 16, 32])?,
        plane::z_cantilever()?,
        plane::square_frame()?,
        plane::cantilever_plate(&[8, 12, 16])?,
        tank::static_tank()?,
        tank::sectors(&[16, 32, 64])?,
        buckling::buckling(&[(64, 8), (64, 12)])?,
        cylinder_modes::cylinder_modes(&[4, 8, 12, 16])?,
    ];
    Ok(parts.into_iter().flatten().collect())
}

/// Rows on fine meshes, and the table of membrane locking.
///
/// Errors: a model that cannot be solved.
pub fn shell_slow() -> Answer<Vec<Row>> {
    let parts = [
        shells::scordelis_lo(&[4, 8, 16, 32])?,
        shells::pinched_cylinder(&[4, 8, 16, 32, 48, 64])?,
        shells::hemisphere(&[4, 8, 16, 32])?,
        plane::drilling()?,
        plane::cantilever_plate(&[8, 12, 16, 24])?,
        tank::locking(&[16, 32, 64, 128, 256])?,
        tank::gradings()?,
        buckling::buckling(&[(32, 8), (64, 8), (64, 12), (64, 20)])?,
        buckling::plain_buckling()?,
    ];
    Ok(parts.into_iter().flatten().collect())
}

/// Reinforced-concrete beams of layers and bars: M10 to M12.
///
/// Errors: a model that cannot be solved.
pub fn concrete_beams() -> Answer<Vec<Row>> {
    Ok([
        beams::b3(16, 20)?,
        beams::b3_refined(&[8, 16, 32, 64], 20)?,
        beams::c3(16, 20)?,
    ]
    .concat())
}

/// Rows of large displacements that take seconds: S13 to S17, S19 to S22, and S12 under internal pressure.
///
/// Errors: a model that cannot be solved.
pub fn shell_large() -> Answer<Vec<Row>> {
    let parts = [
        finite::cantilever()?,
        finite::roll_up(&[20, 40])?,
        large::ring(false)?,
        large::hemisphere(false)?,
        large::pull_out(false)?,
        roof::roof(16)?,
        pressure::follower(&[2, 4])?,
        plastic::plates(&[4, 6])?,
        panel::panels(12, &[0.02])?,
        pressurized::pressurized(12, &[0.5], &[0.1])?,
        elephant::elephant(&[5, 10], &[(400.0, 0.5), (1000.0, 0.5)], false)?,
    ];
    Ok(parts.into_iter().flatten().collect())
}

/// The same on fine meshes, and S18.
///
/// Errors: a model that cannot be solved.
pub fn shell_large_slow() -> Answer<Vec<Row>> {
    let parts = [
        large::ring(true)?,
        large::hemisphere(true)?,
        large::pull_out(true)?,
        large::pinched(40)?,
        roof::snap_back(16)?,
        pressure::follower(&[2, 4, 8])?,
        plastic::plates(&[4, 8, 12])?,
        panel::panels(16, &[0.01, 0.03, 0.1, 0.3])?,
        pressurized::pressurized(16, &[0.0, 0.5, 1.0], &[0.03, 0.1, 0.3])?,
        elephant::elephant(
            &[5, 10, 20],
            &[
                (400.0, 0.3),
                (400.0, 0.8),
                (700.0, 0.5),
                (1000.0, 0.3),
                (1000.0, 0.5),
                (1000.0, 0.8),
            ],
            true,
        )?,
    ];
    Ok(parts.into_iter().flatten().collect())
}

/// Nodes and cells of an m × n grid; node (i, j) at i + (m + 1) j, normal along (∂x/∂i) × (∂x/∂j).
struct Grid {
    m: usize,
    n: usize,
    cells: Vec<[usize; 4]>,
}

impl Grid {
    fn new(m: usize, n: usize) -> Grid {
        let at = |i, j| i + (m + 1) * j;
        let cells = (0..n)
            .flat_map(|j| (0..m).map(move |i| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
            .collect();
        Grid { m, n, cells }
    }

    fn node(&self, i: usize, j: usize) -> usize {
        i + (self.m + 1) * j
    }

    /// Adds the nodes at `position(i/m, j/n)`.
    fn nodes(&self, builder: &mut Builder, position: impl Fn(f64, f64) -> [f64; 3]) {
        for j in 0..=self.n {
            for i in 0..=self.m {
                builder.node(position(i as f64 / self.m as f64, j as f64 / self.n as f64));
            }
        }
    }

    /// Nodes with i = `i`.
    fn line_i(&self, i: usize) -> Vec<usize> {
        (0..=self.n).map(|j| self.node(i, j)).collect()
    }

    /// Nodes with j = `j`.
    fn line_j(&self, j: usize) -> Vec<usize> {
        (0..=self.m).map(|i| self.node(i, j)).collect()
    }

    fn surface<'a>(&self, section: &Arc<dyn Section>) -> ShellSurface<'a> {
        surface(&self.cells, section)
    }
}

fn surface<'a>(cells: &[[usize; 4]], section: &Arc<dyn Section>) -> ShellSurface<'a> {
    let cell = |&nodes: &[usize; 4]| ShellCell {
        nodes,
        section: section.clone(),
        group: "shell".to_owned(),
    };
    ShellSurface::new(cells.iter().map(cell).collect())
}

fn hold(builder: &mut Builder, nodes: &[usize], dofs: &[Dof]) {
    for &node in nodes {
        dofs.iter().for_each(|&d| builder.hold(node, d));
    }
}

/// A linear solution.
struct Solution {
    model: Model,
    assembler: Assembler,
    u: Vec<f64>,
    placed: PlacedShell,
}

impl Solution {
    /// Global components at a node.
    fn at(&self, node: usize) -> [f64; KINDS] {
        self.model.at_node(&self.u, node)
    }

    /// Displacement of a node.
    fn displacement(&self, node: usize) -> Vector3<f64> {
        let u = self.at(node);
        Vector3::new(u[0], u[1], u[2])
    }
}

/// Solves K u = f with the nodal `loads` and a uniform acceleration.
fn solve(builder: Builder, placed: PlacedShell, loads: &NodalLoads, acceleration: [f64; 3]) -> Answer<Solution> {
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let mut f = loads.vector(&model);
    for (f, b) in f.iter_mut().zip(assembler.body_force(&model, acceleration)) {
        *f += b;
    }
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let u = symbolic
        .factor(&assembler.stiffness(&model)?, Kind::Definite)?
        .solve_vector(&f)?;
    Ok(Solution {
        model,
        assembler,
        u,
        placed,
    })
}

/// A benchmark with its page, reference and unit.
struct Case {
    id: &'static str,
    page: &'static str,
    source: &'static str,
    unit: &'static str,
}

impl Case {
    fn row(&self, what: impl Into<String>, kind: Reference, reference: f64, computed: f64, tolerance: f64) -> Row {
        Row {
            id: self.id.to_owned(),
            page: self.page,
            what: what.into(),
            reference,
            source: self.source,
            kind,
            computed,
            tolerance,
            unit: self.unit,
            convergence: Vec::new(),
        }
    }

    /// The finest mesh against the published value with the convergence study, and every mesh that the prototype ran
    /// against the prototype.
    ///
    /// `values`: (number of elements along a side, computed); `prototype`: (number, value/reference).
    #[allow(clippy::too_many_arguments, reason = "a table with its caption")]
    fn study(
        &self,
        what: &str,
        reference: f64,
        tolerance: f64,
        values: &[(usize, f64)],
        prototype: &[(usize, f64)],
        prototype_tolerance: f64,
    ) -> Vec<Row> {
        let mut rows = Vec::new();
        if let Some(&(n, value)) = values.last() {
            let mut row = self.row(
                format!("{what}, {n} elements"),
                Reference::Published,
                reference,
                value,
                tolerance,
            );
            row.convergence = values.iter().map(|&(n, v)| (n as f64, v / reference - 1.0)).collect();
            rows.push(row);
        }
        for &(n, value) in values {
            if let Some(&(_, ratio)) = prototype.iter().find(|(m, _)| *m == n) {
                let mut row = self.row(
                    format!("{what}, {n} elements against a prototype"),
                    Reference::SecondFormulation,
                    ratio * reference,
                    value,
                    prototype_tolerance,
                );
                row.source = "independent prototype of the same formulation on the same mesh";
                rows.push(row);
            }
        }
        rows
    }
}
