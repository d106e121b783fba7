//! Directors of a mesh of shells, and the way of such a mesh into a model.
//!
//! Every corner of every cell has a normal: the exact one of the geometry, if the caller provides it, else that of the
//! bilinear cell. Around a node, normals that differ by less than 15 degrees belong together (chains of them, too) and
//! are averaged by the angle the cells span there. A node with one group is **smooth**: all its cells share one director, its
//! rotation frame has the director as third axis, and the rotation about it is held; five unknowns remain. A node with
//! several groups is a **fold**: each group keeps its director, all rotate with the node, six unknowns and the drilling
//! energy of every adjacent corner.
//!
//! Cells that share nodes must be added together. Curved shells on coarse meshes (more than 15 degrees from cell to
//! cell) need exact normals, else every node becomes a fold.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::geometry::base;
use super::section::Section;
use crate::dofs::Dof;
use crate::element::ElementError;
use crate::element::shell4::{Axes, MassKind, MembraneShear, Shell4};
use crate::model::Builder;
use crate::shape::quad4;

/// Normals that differ by less belong to one smooth surface [rad].
pub const FOLD_ANGLE: f64 = 15.0 * std::f64::consts::PI / 180.0;

/// Drilling factor k_d: stresses of the Z-cantilever change by less than 0.1 % between 10⁻⁶ and 10⁻².
pub const DRILLING: f64 = 1e-3;

/// Where the normals at the corners come from.
#[derive(Clone, Copy)]
pub enum Normals<'a> {
    /// From the bilinear cells.
    Cells,
    /// The unit normal of the geometry at (number of the cell, number of the node).
    Exact(&'a dyn Fn(usize, usize) -> Vector3<f64>),
}

/// Kind of a node of a shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NodeKind {
    /// One director for all cells.
    Smooth(Vector3<f64>),
    /// Several.
    Fold,
}

/// Directors of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Directors {
    /// Unit directors at the four corners of each cell.
    pub corners: Vec<[Vector3<f64>; 4]>,
    /// Kind of each node.
    pub nodes: BTreeMap<usize, NodeKind>,
}

/// A corner of a cell at a node.
struct CornerNormal {
    cell: usize,
    corner: usize,
    normal: Vector3<f64>,
    /// Angle that the cell spans there.
    angle: f64,
}

/// Directors of `cells` (node numbers counter-clockwise seen against the normal) with nodes at `position(node)`.
///
/// Errors: a degenerate corner; neighbours whose normals are opposite.
pub fn directors(
    position: impl Fn(usize) -> [f64; 3],
    cells: &[[usize; 4]],
    normals: Normals<'_>,
) -> Result<Directors, ElementError> {
    let mut around: BTreeMap<usize, Vec<CornerNormal>> = BTreeMap::new();
    for (cell, nodes) in cells.iter().enumerate() {
        let x = nodes.map(|n| Vector3::from(position(n)));
        for (corner, &node) in nodes.iter().enumerate() {
            let [r, s] = quad4::CORNERS[corner];
            let [g_r, g_s] = base(&x, r, s);
            let own = g_r.cross(&g_s);
            let area = own.norm();
            if area <= 1e-12 * (g_r.norm_squared() + g_s.norm_squared()) || area.is_nan() {
                return Err(ElementError::Jacobian { kind: "shell4", determinant: area, nodes: nodes.to_vec() });
            }
            let normal = match normals {
                Normals::Cells => own / area,
                Normals::Exact(normal) => normal(cell, node).normalize(),
            };
            // g_r and g_s point along the edges, inwards or outwards: the sine of the angle is the same.
            let (before, after) = (x[(corner + 3) % 4] - x[corner], x[(corner + 1) % 4] - x[corner]);
            around.entry(node).or_default().push(CornerNormal { cell, corner, normal, angle: before.angle(&after) });
        }
    }
    let mut out = Directors { corners: vec![[Vector3::zeros(); 4]; cells.len()], nodes: BTreeMap::new() };
    for (&node, list) in &around {
        let mut group: Vec<usize> = (0..list.len()).collect();
        for i in 0..list.len() {
            for j in 0..i {
                let cosine = list[i].normal.dot(&list[j].normal);
                if cosine < -0.9999 {
                    return Err(ElementError::NoAnswer {
                        kind: "shell4",
                        reason: format!(
                            "cells {:?} and {:?} meet at node {node} with opposite normals: number both in one sense",
                            cells[list[i].cell], cells[list[j].cell]
                        ),
                    });
                }
                if cosine > FOLD_ANGLE.cos() {
                    let (old, new) = (group[i], group[j]);
                    group.iter_mut().filter(|g| **g == old).for_each(|g| *g = new);
                }
            }
        }
        let mean = |g: usize| -> Vector3<f64> {
            let members = list.iter().zip(&group).filter(|(_, own)| **own == g);
            let sum: Vector3<f64> = members.map(|(c, _)| c.normal * c.angle).sum();
            sum.normalize()
        };
        for (c, &g) in list.iter().zip(&group) {
            out.corners[c.cell][c.corner] = mean(g);
        }
        let kind = if group.iter().all(|&g| g == group[0]) { NodeKind::Smooth(mean(group[0])) } else { NodeKind::Fold };
        out.nodes.insert(node, kind);
    }
    Ok(out)
}

/// Rotation frame of a smooth node: rows e_1 by `axes` (else the x or y axis, projected), director × e_1, director.
///
/// On an upright cylinder with [`Axes::HOOP_Z`] and outward director the rows are e_φ, e_z, e_r: `Dof::Rx` turns the
/// meridian, `Dof::Ry` the parallel.
pub fn rotation_frame(axes: &Axes, position: [f64; 3], director: Vector3<f64>) -> Matrix3<f64> {
    let fallback = || {
        // The projection of x is long enough unless the director is within 45 degrees of it.
        let wish = if director.x.abs() < 0.7 { Vector3::x() } else { Vector3::y() };
        (wish - director * director.dot(&wish)).normalize()
    };
    let first = axes.first(position.into(), director).unwrap_or_else(fallback);
    let second = director.cross(&first);
    Matrix3::from_rows(&[first.transpose(), second.transpose(), director.transpose()])
}

/// One cell of a surface.
#[derive(Clone)]
pub struct ShellCell {
    /// Nodes, counter-clockwise seen against the normal (from outside on a wall).
    pub nodes: [usize; 4],
    /// Section of its course.
    pub section: Arc<dyn Section>,
    /// Name of its group.
    pub group: String,
}

/// A mesh of shells on its way into a model.
///
/// ```text
/// let wall = ShellSurface { normals: Normals::Exact(&outwards), axes: Axes::HOOP_Z, ..ShellSurface::new(cells) };
/// let placed = wall.place(&mut builder)?;
/// ```
pub struct ShellSurface<'a> {
    /// Cells; all that share nodes.
    pub cells: Vec<ShellCell>,
    /// Where the normals come from; default: the cells.
    pub normals: Normals<'a>,
    /// Frame of the resultants, and of the rotations at smooth nodes.
    pub axes: Axes,
    /// Default: at the centre.
    pub membrane_shear: MembraneShear,
    /// Default: consistent.
    pub mass: MassKind,
    /// Drilling factor k_d at folds; default [`DRILLING`].
    pub drilling: f64,
}

/// Where a surface went.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedShell {
    /// Number of the element of each cell.
    pub elements: Vec<usize>,
    /// Directors, and which nodes are smooth.
    pub directors: Directors,
}

impl<'a> ShellSurface<'a> {
    /// A surface with the defaults.
    pub fn new(cells: Vec<ShellCell>) -> ShellSurface<'a> {
        ShellSurface {
            cells,
            normals: Normals::Cells,
            axes: Axes::Element,
            membrane_shear: MembraneShear::default(),
            mass: MassKind::default(),
            drilling: DRILLING,
        }
    }

    /// Finds the directors, gives smooth nodes their rotation frame and holds [`Dof::Rz`] there, adds the elements.
    ///
    /// Supports are the caller's: at a smooth node `Dof::Rx` and `Dof::Ry` are the rotations about the first two rows of
    /// [`rotation_frame`].
    ///
    /// Errors: those of [`directors`] and [`Shell4::new`].
    pub fn place(&self, builder: &mut Builder) -> Result<PlacedShell, ElementError> {
        let cells: Vec<[usize; 4]> = self.cells.iter().map(|c| c.nodes).collect();
        let directors = directors(|n| builder.position(n), &cells, self.normals)?;
        let mut elements = Vec::with_capacity(cells.len());
        for (cell, corners) in self.cells.iter().zip(&directors.corners) {
            let positions = cell.nodes.map(|n| builder.position(n));
            let fold = cell.nodes.map(|n| directors.nodes[&n] == NodeKind::Fold);
            let element = Shell4::new(cell.nodes, positions, *corners, cell.section.clone())?
                .with_membrane_shear(self.membrane_shear)
                .with_mass(self.mass)
                .with_axes(self.axes)
                .with_drilling(fold, self.drilling)?;
            elements.push(builder.element(&cell.group, element));
        }
        for (&node, kind) in &directors.nodes {
            if let NodeKind::Smooth(director) = kind {
                builder.rotation_frame(node, rotation_frame(&self.axes, builder.position(node), *director));
                builder.hold(node, Dof::Rz);
            }
        }
        Ok(PlacedShell { elements, directors })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gutter: two coplanar cells, one at a right angle.
    #[test]
    fn folds_are_told_from_smooth_nodes() {
        let p = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [2.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [2.0, 0.0, 1.0],
            [2.0, 1.0, 1.0],
        ];
        let cells = [[0, 1, 4, 5], [1, 2, 3, 4], [2, 6, 7, 3]];
        let found = directors(|n| p[n], &cells, Normals::Cells).unwrap();
        assert_eq!(found.nodes[&1], NodeKind::Smooth(Vector3::z()));
        assert_eq!(found.nodes[&2], NodeKind::Fold);
        assert!((found.corners[1][1] - Vector3::z()).norm() < 1e-15);
        assert!((found.corners[2][0] + Vector3::x()).norm() < 1e-15);
        let flipped = [[0, 1, 4, 5], [1, 4, 3, 2]];
        assert!(directors(|n| p[n], &flipped, Normals::Cells).is_err());
    }
}
