//! Meshes of walls of one, two or three layers on their way into a model.
//!
//! ```text
//! Footprint: cylinder or plane strip        points with normals, cells row by row from below
//! Build::Shell      one shell                                        ●
//! Build::Bonded     two shells on one reference surface              ● ●   (one section eccentric)
//! Build::Layered    inner shell, layer, outer shell                  ● ░ ●
//! ```
//!
//! Every row of cells (course) may have its own sections. Reference surfaces lie at constant distances from the footprint
//! along its normals, so that a step of thickness moves the layer's faces and no node.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::Vector3;

use super::{Layer, Wall};
use crate::dofs::Dof;
use crate::element::ElementError;
use crate::element::shell::section::Section;
use crate::element::shell::surface::{
    DRILLING, Directors, NodeKind, Normals, ShellCell, ShellSurface, directors, rotation_frame,
};
use crate::element::shell4::{Axes, MassKind, MembraneShear, Shell4};
use crate::mesh::MeshError;
use crate::model::Builder;

/// Points, normals and cells of a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// Points [m].
    pub points: Vec<[f64; 3]>,
    /// Unit normals, from the inner to the outer side.
    pub normals: Vec<[f64; 3]>,
    /// Cells, row by row from below; counter-clockwise seen from outside.
    pub cells: Vec<[usize; 4]>,
    /// Row of each cell, from 0 at the base.
    pub rows: Vec<usize>,
    /// Points of each level, from the base; around or across.
    pub levels: Vec<Vec<usize>>,
    /// Frame of the resultants: e_1 around or across.
    pub axes: Axes,
}

impl Footprint {
    /// Part of a cylinder about z with outward normals: `sectors` cells from `from` over `angle` [rad]; closed if the angle
    /// is 2π.
    ///
    /// Errors: a radius or an angle out of range, fewer than 1 cell (closed: 3), heights that do not ascend.
    pub fn cylinder(
        radius: f64,
        sectors: usize,
        [from, angle]: [f64; 2],
        heights: &[f64],
    ) -> Result<Footprint, MeshError> {
        let closed = (angle - TAU).abs() < 1e-12;
        let range = |what, found: String, allowed| Err(MeshError::Range { what, found, allowed });
        if !(radius > 0.0 && radius.is_finite()) {
            return range("radius of the wall", radius.to_string(), "> 0");
        }
        if !(angle > 0.0 && (angle < TAU || closed)) {
            return range("angle of the wall", angle.to_string(), "above 0 to 2π");
        }
        if sectors < if closed { 3 } else { 1 } {
            return range("sectors of the wall", sectors.to_string(), "1 or more, 3 around");
        }
        let columns = if closed { sectors } else { sectors + 1 };
        let at = |column: usize| {
            let (s, c) = (from + angle * column as f64 / sectors as f64).sin_cos();
            ([radius * c, radius * s], [c, s, 0.0])
        };
        Footprint::new(columns, closed, heights, at, Axes::HOOP_Z)
    }

    /// Plane wall in y, z at x = `place`, normal along x: `across` are the places of the columns along y.
    ///
    /// Errors: places that do not ascend.
    pub fn strip(place: f64, across: &[f64], heights: &[f64]) -> Result<Footprint, MeshError> {
        crate::mesh::check_ascending("places across the wall", across, 2)?;
        let at = |column: usize| ([place, across[column]], [1.0, 0.0, 0.0]);
        Footprint::new(across.len(), false, heights, at, Axes::Along([0.0, 1.0, 0.0]))
    }

    fn new(
        columns: usize,
        closed: bool,
        heights: &[f64],
        at: impl Fn(usize) -> ([f64; 2], [f64; 3]),
        axes: Axes,
    ) -> Result<Footprint, MeshError> {
        crate::mesh::check_ascending("heights of the wall", heights, 2)?;
        let mut out = Footprint {
            points: Vec::new(),
            normals: Vec::new(),
            cells: Vec::new(),
            rows: Vec::new(),
            levels: Vec::new(),
            axes,
        };
        for &z in heights {
            let first = out.points.len();
            for column in 0..columns {
                let ([x, y], normal) = at(column);
                out.points.push([x, y, z]);
                out.normals.push(normal);
            }
            out.levels.push((first..first + columns).collect());
        }
        let cells = if closed { columns } else { columns - 1 };
        for row in 1..heights.len() {
            for column in 0..cells {
                let next = (column + 1) % columns;
                let (low, high) = (&out.levels[row - 1], &out.levels[row]);
                out.cells.push([low[column], low[next], high[next], high[column]]);
                out.rows.push(row - 1);
            }
        }
        Ok(out)
    }

    /// The points moved by `offset` [m] along their normals.
    pub fn at(&self, offset: f64) -> Vec<[f64; 3]> {
        let pairs = self.points.iter().zip(&self.normals);
        pairs.map(|(p, n)| std::array::from_fn(|i| p[i] + offset * n[i])).collect()
    }
}

/// One shell of a wall.
#[derive(Clone)]
pub struct Leaf {
    /// Section.
    pub section: Arc<dyn Section>,
    /// Distance from the reference surface to the face that touches the layer [m]: half the thickness of a centred section.
    /// Without meaning where there is no layer.
    pub face: f64,
}

/// Sections of a row of cells.
#[derive(Clone)]
pub enum Build {
    /// One shell on the inner reference surface.
    Shell(Leaf),
    /// Two shells on the inner reference surface, perfectly bonded; eccentricities are those of their sections.
    Bonded([Leaf; 2]),
    /// Inner shell, layer, outer shell.
    Layered([Leaf; 2], Layer),
}

/// How a wall goes into a model.
pub struct WallMesh<'a> {
    /// Where.
    pub footprint: &'a Footprint,
    /// Sections of each row of cells; either all rows have a layer or none.
    pub courses: &'a dyn Fn(usize) -> Build,
    /// Distances of the inner and the outer reference surface from the footprint along its normals [m].
    pub offsets: [f64; 2],
    /// Prefix of the groups: `NAME` of one shell; `NAME inner`, `NAME outer` of two bonded ones; `NAME` of walls with layer.
    pub name: &'a str,
    /// Distribution of the shells' mass.
    pub mass: MassKind,
}

/// Makes further cells from the nodes of a wall.
pub type MoreCells<'a> = dyn FnMut(&mut Builder, &[usize]) -> Result<Vec<ShellCell>, ElementError> + 'a;

/// Where a wall went.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedWall {
    /// Elements of each row of cells, from below. Loose layers follow after the last.
    pub rows: Vec<Vec<usize>>,
    /// Node of each point of the footprint on the inner reference surface.
    pub inner: Vec<usize>,
    /// The same on the outer one; empty without a layer.
    pub outer: Vec<usize>,
}

impl PlacedWall {
    /// Nodes of a cell of the footprint on the inner reference surface, for loads.
    pub fn inner_cell(&self, cell: [usize; 4]) -> [usize; 4] {
        cell.map(|p| self.inner[p])
    }

    /// Holds dofs of all nodes of a level (its points of the footprint) on both reference surfaces.
    pub fn hold(&self, builder: &mut Builder, level: &[usize], dofs: &[Dof]) {
        for nodes in [&self.inner, &self.outer] {
            for node in level.iter().filter_map(|&p| nodes.get(p)) {
                dofs.iter().for_each(|&d| builder.hold(*node, d));
            }
        }
    }
}

impl WallMesh<'_> {
    /// Adds nodes, rotation frames, supports of the rotation about directors ([`Dof::Rz`]) and elements. Directors are the
    /// normals of the footprint. At smooth nodes `Dof::Rx`, `Dof::Ry` are the rotations about the first two rows of
    /// [`rotation_frame`].
    ///
    /// Errors: those of [`Shell4::new`], [`directors`] and [`Wall::new`]; rows with and without a layer in one wall.
    pub fn place(&self, builder: &mut Builder) -> Result<PlacedWall, ElementError> {
        self.place_with(builder, &mut |_, _| Ok(Vec::new())).map(|found| found.0)
    }

    /// With level cells that are welded to a wall of one row of nodes, such as a bottom: `more` makes them from the nodes of the wall;
    /// nodes that both share are folds. Returns their elements, too.
    ///
    /// Errors: as [`WallMesh::place`], and those of `more`; level cells on a wall with a layer.
    pub fn place_with(
        &self,
        builder: &mut Builder,
        more: &mut MoreCells<'_>,
    ) -> Result<(PlacedWall, Vec<usize>), ElementError> {
        let builds: Vec<Build> = (0..self.footprint.levels.len() - 1).map(self.courses).collect();
        let layered = builds.iter().filter(|b| matches!(b, Build::Layered(..))).count();
        let add = |builder: &mut Builder, offset: f64| -> Vec<usize> {
            let points = self.footprint.at(offset);
            let first = builder.nodes(&points);
            (first..first + points.len()).collect()
        };
        if layered == 0 {
            let inner = add(builder, self.offsets[0]);
            let level = more(builder, &inner)?;
            return self.place_shells(builder, &builds, inner, level);
        }
        if layered < builds.len() {
            return Err(ElementError::NoAnswer {
                kind: "wall",
                reason: format!("{layered} of {} courses have a layer: all of them or none", builds.len()),
            });
        }
        let nodes = [add(builder, self.offsets[0]), add(builder, self.offsets[1])];
        let found = [self.directors(builder, &nodes[0])?, self.directors(builder, &nodes[1])?];
        let mut rows = vec![Vec::new(); builds.len()];
        let mut loose = Vec::new();
        for (c, (&cell, &row)) in self.footprint.cells.iter().zip(&self.footprint.rows).enumerate() {
            let Build::Layered(leaves, layer) = &builds[row] else { continue };
            let shell = |side: usize| -> Result<Shell4, ElementError> {
                let corners = cell.map(|p| nodes[side][p]);
                let positions = corners.map(|n| builder.position(n));
                let fold = corners.map(|n| found[side].nodes[&n] == NodeKind::Fold);
                Shell4::new(corners, positions, found[side].corners[c], leaves[side].section.clone())?
                    .with_mass(self.mass)
                    .with_axes(self.footprint.axes)
                    .with_drilling(fold, DRILLING)
            };
            let wall = Wall::new(shell(0)?, shell(1)?, [leaves[0].face, leaves[1].face], layer)?;
            let (wall, layer) = wall.part_loose();
            rows[row].push(builder.element(self.name, wall));
            loose.extend(layer);
        }
        for layer in loose {
            builder.element(self.name, layer);
        }
        for side in found {
            for (node, kind) in side.nodes {
                if let NodeKind::Smooth(director) = kind {
                    let frame = rotation_frame(&self.footprint.axes, builder.position(node), director);
                    builder.rotation_frame(node, frame);
                    builder.hold(node, Dof::Rz);
                }
            }
        }
        if !more(builder, &nodes[0])?.is_empty() {
            return Err(ElementError::NoAnswer {
                kind: "wall",
                reason: "level cells are welded to walls without a layer".into(),
            });
        }
        let [inner, outer] = nodes;
        Ok((PlacedWall { rows, inner, outer }, Vec::new()))
    }

    fn normal(&self, first: usize) -> impl Fn(usize, usize) -> Vector3<f64> + '_ {
        move |_, node| Vector3::from(self.footprint.normals[node - first])
    }

    fn directors(&self, builder: &Builder, nodes: &[usize]) -> Result<Directors, ElementError> {
        let cells: Vec<[usize; 4]> = self.footprint.cells.iter().map(|c| c.map(|p| nodes[p])).collect();
        directors(|n| builder.position(n), &cells, Normals::Exact(&self.normal(nodes[0])))
    }

    /// Shells of the wall and the row of each; the caller has sorted out rows of two layers.
    fn shells(&self, builds: &[Build], inner: &[usize]) -> (Vec<ShellCell>, Vec<usize>) {
        let (mut cells, mut row_of) = (Vec::new(), Vec::new());
        for (cell, &row) in self.footprint.cells.iter().zip(&self.footprint.rows) {
            let nodes = cell.map(|p| inner[p]);
            let mut add = |leaf: &Leaf, suffix: &str| {
                cells.push(ShellCell { nodes, section: leaf.section.clone(), group: format!("{}{suffix}", self.name) });
                row_of.push(row);
            };
            match &builds[row] {
                Build::Shell(leaf) => add(leaf, ""),
                Build::Bonded(leaves) => {
                    add(&leaves[0], " inner");
                    add(&leaves[1], " outer");
                }
                Build::Layered(..) => {}
            }
        }
        (cells, row_of)
    }

    fn place_shells(
        &self,
        builder: &mut Builder,
        builds: &[Build],
        inner: Vec<usize>,
        level: Vec<ShellCell>,
    ) -> Result<(PlacedWall, Vec<usize>), ElementError> {
        let (mut cells, row_of) = self.shells(builds, &inner);
        let of_wall = cells.len();
        cells.extend(level);
        let own = self.normal(inner[0]);
        let normal = |cell: usize, node: usize| if cell < of_wall { own(cell, node) } else { Vector3::z() };
        let surface = ShellSurface {
            cells,
            normals: Normals::Exact(&normal),
            axes: self.footprint.axes,
            membrane_shear: MembraneShear::default(),
            mass: self.mass,
            drilling: DRILLING,
        };
        let placed = surface.place(builder)?;
        let mut rows = vec![Vec::new(); builds.len()];
        for (&element, row) in placed.elements.iter().zip(row_of) {
            rows[row].push(element);
        }
        let wall = PlacedWall { rows, inner, outer: Vec::new() };
        Ok((wall, placed.elements[of_wall..].to_vec()))
    }
}
