//! A column of displacement liquid that leans on a wall through the joint.
//!
//! Source:    hydrostatics
//! Model:     liquid 1.0 × 0.5 × 2.0 m of 4 × 1 × 8 fluid8 with its surface, held at its other sides; wall of bricks 0.2 m
//!            thick (E 30 GPa), held at its outer face; joints between them, normals along x
//! Reference: force on the wall γ b H²/2; penetration at the foot near γ H/k_n
//! Tolerance: see the rows; the liquid's pressure is constant in an element, γ (H − z) at its centre

use super::solve;
use crate::{Answer, Failure, Reference, Row};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::contact8::{Contact8, ContactLaw};
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use fem::element::{Fluid8, FreeSurface, LiquidProperties};
use fem::mesh::{Face, Hexahedron};
use fem::model::{Builder, Model};

const LENGTH: f64 = 1.0;

const BREADTH: f64 = 0.5;

const DEPTH: f64 = 2.0;

const THICKNESS: f64 = 0.2;

const GRAVITY: f64 = 9.81;

const DENSITY: f64 = 1000.0;

const BULK: f64 = 2.06e9;

const MODULUS: f64 = 3e10;

const CELLS: [usize; 2] = [4, 8];

pub(super) struct Column {
    model: Model,
    assembler: Assembler,
    /// First wall element, number of wall elements.
    wall: std::ops::Range<usize>,
    outer: Vec<usize>,
    /// Liquid and wall node at the foot of the joint.
    foot: [usize; 2],
    surface: Vec<usize>,
}

impl Column {
    /// k_n = `factor` K/h with h the length of a liquid cell.
    pub(super) fn new(factor: f64) -> Result<Column, Failure> {
        // More than 80 lines: assembles one system block by block.
        let [nx, nz] = CELLS;
        let mut builder = Builder::new();
        let place = |i: usize, k: usize| [LENGTH * i as f64 / nx as f64, DEPTH * k as f64 / nz as f64];
        let liquid = |i: usize, j: usize, k: usize| (k * 2 + j) * (nx + 1) + i;
        for k in 0..=nz {
            for j in 0..2 {
                for i in 0..=nx {
                    let [x, z] = place(i, k);
                    let node = builder.node([x, BREADTH * j as f64, z]);
                    builder.hold(node, Dof::Uy);
                    if i == 0 {
                        builder.hold(node, Dof::Ux);
                    }
                    if k == 0 {
                        builder.hold(node, Dof::Uz);
                    }
                }
            }
        }
        let first = (nz + 1) * 2 * (nx + 1);
        let wall_node = |i: usize, j: usize, k: usize| first + (k * 2 + j) * 2 + i;
        let mut outer = Vec::new();
        for k in 0..=nz {
            for j in 0..2 {
                for i in 0..2 {
                    let [_, z] = place(0, k);
                    let node = builder.node([LENGTH + THICKNESS * i as f64, BREADTH * j as f64, z]);
                    builder.hold(node, Dof::Uy);
                    if i == 1 {
                        builder.hold(node, Dof::Ux);
                        builder.hold(node, Dof::Uz);
                        outer.push(node);
                    }
                }
            }
        }
        let properties = LiquidProperties::new(DENSITY, BULK, GRAVITY, LENGTH);
        for k in 0..nz {
            for i in 0..nx {
                let level = |k: usize| [liquid(i, 0, k), liquid(i + 1, 0, k), liquid(i + 1, 1, k), liquid(i, 1, k)];
                let (low, high) = (level(k), level(k + 1));
                let nodes: [usize; 8] = std::array::from_fn(|a| if a < 4 { low[a] } else { high[a - 4] });
                let cell = Hexahedron { nodes, chart: nodes.map(|n| builder.position(n)) };
                builder.element("liquid", Fluid8::new(&cell, Chart::Cartesian, properties)?);
                if k + 1 == nz {
                    let face = Face { nodes: high, chart: high.map(|n| builder.position(n)) };
                    let surface = FreeSurface::new(&face, Chart::Cartesian, DENSITY * GRAVITY)?;
                    builder.element("surface", surface);
                }
            }
        }
        let material = Elastic::isotropic(MODULUS, 0.2, 0.0);
        let mut wall = 0..0;
        for k in 0..nz {
            let level = |k: usize| [wall_node(0, 0, k), wall_node(1, 0, k), wall_node(1, 1, k), wall_node(0, 1, k)];
            let (low, high) = (level(k), level(k + 1));
            let nodes: [usize; 8] = std::array::from_fn(|a| if a < 4 { low[a] } else { high[a - 4] });
            let corners = nodes.map(|n| builder.position(n));
            let brick = Solid8::new(nodes, corners, material, Kinematics::Linear)?;
            let number = builder.element("wall", brick);
            wall = if k == 0 { number..number + 1 } else { wall.start..number + 1 };
        }
        let law = ContactLaw::bonded(factor * BULK / (LENGTH / nx as f64));
        for k in 0..nz {
            let bottom = [liquid(nx, 0, k), liquid(nx, 1, k), liquid(nx, 1, k + 1), liquid(nx, 0, k + 1)];
            let top = [wall_node(0, 0, k), wall_node(0, 1, k), wall_node(0, 1, k + 1), wall_node(0, 0, k + 1)];
            let face = Face { nodes: bottom, chart: bottom.map(|n| builder.position(n)) };
            let joint = Contact8::new(&face, Chart::Cartesian, top, bottom, [[1.0, 0.0, 0.0]; 4], law)?;
            builder.element("joint", joint);
        }
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        Ok(Column {
            model,
            assembler,
            wall,
            outer,
            foot: [liquid(nx, 0, 0), wall_node(0, 0, 0)],
            surface: (0..=nx).map(|i| liquid(i, 0, nz)).collect(),
        })
    }

    /// Force on the wall over γ b H²/2, penetration at the foot [m], mean settlement of the surface [m].
    pub(super) fn lean(&self) -> Result<[f64; 3], Failure> {
        let load = self.assembler.body_force(&self.model, [0.0, 0.0, -GRAVITY]);
        let u = solve(&self.model, &self.assembler, &load)?;
        let forces = self.assembler.nodal_forces(&self.model, &u, |e| self.wall.contains(&e))?;
        let reaction: f64 = self.outer.iter().map(|&n| forces[n][0]).sum();
        let [liquid, wall] = self.foot.map(|n| self.model.at_node(&u, n)[0]);
        let settlement: f64 = self.surface.iter().map(|&n| -self.model.at_node(&u, n)[2]).sum();
        Ok([
            -reaction / (0.5 * DENSITY * GRAVITY * BREADTH * DEPTH * DEPTH),
            liquid - wall,
            settlement / self.surface.len() as f64,
        ])
    }
}

/// The liquid's thrust reaches the wall, whatever the penalty.
pub(super) fn rows() -> Answer {
    let [force, ..] = Column::new(100.0)?.lean()?;
    Ok(vec![Row::new(
        "C7",
        "liquid column against a wall: thrust over γ b H²/2",
        (1.0, "hydrostatics", Reference::ClosedForm),
        force,
        // The surface settles by s = 1e-5 m, and its stiffness ρ g takes 2 s/H of the thrust over.
        (1e-3, ""),
    )])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table of docs/theory/solid-and-contact.md, 2.3: the joint gives way by p/k_n; the surface settles by s and takes 2 s/H
    /// of the thrust over (H = 2 m); the condition number grows with the penalty beyond the 2e8 of the liquid's own.
    #[test]
    fn penalty_on_a_column() {
        let at_one = Column::new(1.0).unwrap().lean().unwrap()[1];
        for power in -2..=9 {
            let factor = 10_f64.powi(power);
            let column = Column::new(factor).unwrap();
            let k = column.assembler.stiffness(&column.model).unwrap().to_dense();
            let values = nalgebra::DMatrix::from_column_slice(k.rows, k.rows, &k.data).symmetric_eigenvalues();
            let condition = values.max() / values.min();
            let [force, gap, settlement] = column.lean().unwrap();
            println!("1e{power}: {:.2e} {gap:.3e} {settlement:.6e} {condition:.1e}", force - 1.0);
            // The settlement, 2.5e-4 m at most, changes the pressure at the foot by as much as the thrust.
            assert!((gap * factor / at_one - 1.0).abs() < 1e-3, "{power}: {gap}");
            assert!(((1.0 - force) / settlement - 1.0).abs() < 2e-3, "{power}: {force} {settlement}");
            assert!(power < 3 || (condition / (2e7 * factor) - 1.0).abs() < 0.1, "{power}: {condition}");
        }
    }
}
