//! Shells: S1 to S22.
//!
//! Meshes, supports and loads are those of the sources. Where a row compares a coarse mesh, its reference is the result that an
//! independent prototype of the same formulation gave on that mesh ([`Reference::SecondFormulation`]); the finest mesh
//! is compared with the published value.

use std::sync::Arc;

use nalgebra::Vector3;

use super::{Reference, Row};
use crate::Answer;
use fem::assembly::Assembler;
use fem::dofs::{Dof, KINDS};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::Section;
use fem::element::shell::surface::{PlacedShell, ShellCell, ShellSurface};
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::{Builder, Model};

pub(crate) mod axial_buckling;
mod barrel;
mod bent_strip;
pub(crate) mod cantilever;
pub(crate) mod cantilever_plate;
pub(crate) mod concrete_beams;
pub(crate) mod concrete_patch;
pub(crate) mod cook;
pub(crate) mod cylinder_modes;
mod cylinder_wall;
pub(crate) mod element;
pub(crate) mod elephant_foot;
pub(crate) mod follower_pressure;
pub(crate) mod hemisphere;
pub(crate) mod hemisphere_large;
pub(crate) mod hinged_roof;
mod panel;
pub(crate) mod patch;
mod path;
pub(crate) mod pinched_cylinder;
pub(crate) mod pinched_large;
pub(crate) mod plastic_plates;
pub(crate) mod pressurized_buckling;
pub(crate) mod pull_out;
pub(crate) mod roll_up;
pub(crate) mod scordelis_lo;
pub(crate) mod slit_ring;
pub(crate) mod square_frame;
mod tank;
pub(crate) mod tank_grading;
pub(crate) mod tank_locking;
pub(crate) mod tank_sectors;
pub(crate) mod tank_static;
pub(crate) mod twisted_beam;
pub(crate) mod volume_change;
pub(crate) mod z_cantilever;

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
    let cell = |&nodes: &[usize; 4]| ShellCell { nodes, section: section.clone(), group: "shell".to_owned() };
    ShellSurface::new(cells.iter().map(cell).collect())
}

pub(crate) fn hold(builder: &mut Builder, nodes: &[usize], dofs: &[Dof]) {
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
    let u = symbolic.factor(&assembler.stiffness(&model)?, Kind::Definite)?.solve_vector(&f)?;
    Ok(Solution { model, assembler, u, placed })
}

/// Id, source and unit of several rows.
struct Case {
    id: &'static str,
    source: &'static str,
    unit: &'static str,
}

impl Case {
    fn row(&self, what: impl Into<String>, kind: Reference, reference: f64, computed: f64, tolerance: f64) -> Row {
        let reference = (reference, self.source, kind);
        Row::new(self.id, what, reference, computed, (tolerance, self.unit))
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
            let mut row = self.row(format!("{what}, {n} elements"), Reference::Published, reference, value, tolerance);
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
