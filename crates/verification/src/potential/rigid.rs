//! Rigid tanks filled with `potential8`.

use std::sync::Arc;

use super::three_field::ThreeField;
use crate::Failure;
use fem::assembly::{Assembler, order};
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{Potential8, PotentialSurface, WetFace};
use fem::linalg::{Kind, Matrix, Ordering, Search, Symbolic, Symmetric, dot, modes};
use fem::mesh::{Cylinder, Face, Hexahedron};
use fem::model::{Builder, Model};

/// Density ρ [kg/m³].
pub const DENSITY: f64 = 1000.0;

/// Gravity g [m/s²], of the sheets.
pub const GRAVITY: f64 = 9.81;

/// A rigid tank: matrices of (η, φ) and the load of a ground motion along x.
pub struct RigidTank {
    model: Model,
    mass: Symmetric,
    stiffness: Symmetric,
    symbolic: Arc<Symbolic>,
    /// M ι: ρ B ι in the rows of φ.
    inertia: Vec<f64>,
}

/// A sloshing mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sloshing {
    /// ω [rad/s].
    pub omega: f64,
    /// Effective mass along x [kg].
    pub mass: f64,
}

/// `count` equal parts of [0, length].
pub fn uniform(length: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|k| length * k as f64 / count as f64).collect()
}

impl RigidTank {
    /// An upright cylinder, equal divisions.
    ///
    /// Errors: no mesh.
    pub fn cylinder(
        radius: f64,
        depth: f64,
        rings: usize,
        sectors: usize,
        levels: usize,
    ) -> Result<RigidTank, Failure> {
        let mesh = Cylinder { radii: uniform(radius, rings), sectors, heights: uniform(depth, levels) };
        let volume = mesh.volume()?;
        let mut builder = Builder::new();
        builder.nodes(&volume.nodes);
        fill(&mut builder, &volume.cells, &volume.surface, Chart::Cylindrical, DENSITY)?;
        for face in &volume.wall {
            let normals = face.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0]);
            hold(&mut builder, face, Chart::Cylindrical, normals)?;
        }
        RigidTank::new(builder)
    }

    /// A box of length × breadth × depth with counts of elements along them. `shift(node) -> displacement` moves inner nodes.
    ///
    /// Errors: no mesh.
    pub fn cuboid(
        size: [f64; 3],
        counts: [usize; 3],
        shift: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Result<RigidTank, Failure> {
        let at = [0, 1, 2].map(|k| uniform(size[k], counts[k]));
        let number = |i: usize, j: usize, k: usize| i + (counts[0] + 1) * (j + (counts[1] + 1) * k);
        let mut builder = Builder::new();
        let mut nodes = Vec::new();
        for z in &at[2] {
            for y in &at[1] {
                for x in &at[0] {
                    let d = shift([*x, *y, *z]);
                    nodes.push([x + d[0], y + d[1], z + d[2]]);
                }
            }
        }
        builder.nodes(&nodes);
        let face = |n: [usize; 4]| Face { nodes: n, chart: n.map(|n| nodes[n]) };
        let (mut cells, mut surface, mut walls) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..counts[2] {
            for j in 0..counts[1] {
                for i in 0..counts[0] {
                    let corner = |a: usize, b: usize, c: usize| number(i + a, j + b, k + c);
                    let n = [
                        corner(0, 0, 0),
                        corner(1, 0, 0),
                        corner(1, 1, 0),
                        corner(0, 1, 0),
                        corner(0, 0, 1),
                        corner(1, 0, 1),
                        corner(1, 1, 1),
                        corner(0, 1, 1),
                    ];
                    cells.push(Hexahedron { nodes: n, chart: n.map(|n| nodes[n]) });
                    if k + 1 == counts[2] {
                        surface.push(face([n[4], n[5], n[6], n[7]]));
                    }
                    if k == 0 {
                        walls.push((face([n[0], n[3], n[2], n[1]]), [0.0, 0.0, -1.0]));
                    }
                    if i == 0 {
                        walls.push((face([n[0], n[4], n[7], n[3]]), [-1.0, 0.0, 0.0]));
                    }
                    if i + 1 == counts[0] {
                        walls.push((face([n[1], n[2], n[6], n[5]]), [1.0, 0.0, 0.0]));
                    }
                }
            }
        }
        fill(&mut builder, &cells, &surface, Chart::Cartesian, DENSITY)?;
        for (wall, normal) in &walls {
            hold(&mut builder, wall, Chart::Cartesian, [*normal; 4])?;
        }
        RigidTank::new(builder)
    }

    fn new(builder: Builder) -> Result<RigidTank, Failure> {
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let pattern = assembler.pattern().clone();
        let symbolic = Arc::new(Symbolic::new(pattern.clone(), &order(&model, &pattern))?);
        let mut unit = [0.0; fem::dofs::KINDS];
        unit[Dof::Ux.index()] = 1.0;
        Ok(RigidTank {
            mass: assembler.mass(&model),
            stiffness: assembler.stiffness(&model)?,
            inertia: assembler.inertia(&model, |_| unit),
            symbolic,
            model,
        })
    }

    /// The lowest sloshing modes with their effective masses along x.
    ///
    /// Errors: those of the eigenvalue solver.
    pub fn sloshing(&self, count: usize) -> Result<Vec<Sloshing>, Failure> {
        let phi = self.model.dofs().of_kind(Dof::Phi);
        let pencil = ThreeField::new(&self.stiffness, &self.mass, self.symbolic.clone(), phi)?;
        let found = modes(&pencil, &Search::lowest(count))?;
        let all = pencil.expand(&found.vectors)?;
        Ok(found
            .omega()
            .into_iter()
            .enumerate()
            .map(|(j, omega)| Sloshing { omega, mass: dot(all.column(j), &self.inertia).powi(2) })
            .collect())
    }

    /// Sloshing modes that a motion along x excites: multiple frequencies count once, modes below 10⁻⁶ of the mass are ignored.
    ///
    /// Errors: those of the eigenvalue solver.
    pub fn excited(&self, count: usize) -> Result<Vec<Sloshing>, Failure> {
        let total = self.total_mass()?;
        let mut out: Vec<Sloshing> = Vec::new();
        for mode in self.sloshing(count)? {
            match out.last_mut() {
                // The two modes of a harmonic are an arbitrary pair of directions.
                Some(last) if (mode.omega / last.omega - 1.0).abs() < 1e-7 => last.mass += mode.mass,
                _ => out.push(mode),
            }
        }
        out.retain(|m| m.mass > 1e-6 * total);
        Ok(out)
    }

    /// ιᵀ M_f ι along x [kg].
    ///
    /// Errors: a singular matrix.
    pub fn total_mass(&self) -> Result<f64, Failure> {
        // φ is determined but for a constant, which the load does not see: one value is left out.
        let phi = self.model.dofs().of_kind(Dof::Phi);
        self.added_mass(&phi[1..])
    }

    /// Impulsive mass along x: the surface free of pressure, φ = 0 there [kg].
    ///
    /// Errors: a singular matrix.
    pub fn impulsive_mass(&self) -> Result<f64, Failure> {
        let dofs = self.model.dofs();
        let inner = |&e: &usize| dofs.equation(dofs.unknown(e).0, Dof::Eta).is_none();
        let phi: Vec<usize> = dofs.of_kind(Dof::Phi).into_iter().filter(inner).collect();
        self.added_mass(&phi)
    }

    /// Unit vertical acceleration of the ground from rest: M₃ ẍ = −M₃ ι with u = e_z and η = 1 in ι. Returns the largest
    /// difference of p' = −ρ φ̈ from ρ (H − z), over ρ H, and the largest |η̈| relative to the tank.
    ///
    /// M₃ + K₃/s with s = 10¹² stands for M₃, which the factorisation without pivoting wants quasi-definite.
    ///
    /// Errors: a singular matrix.
    pub fn vertical(&self) -> Result<(f64, f64), Failure> {
        let mut unit = [0.0; fem::dofs::KINDS];
        unit[Dof::Uz.index()] = 1.0;
        unit[Dof::Eta.index()] = 1.0;
        let assembler = Assembler::new(&self.model);
        let load = assembler.inertia(&self.model, |_| unit);
        let mut effective = self.mass.clone();
        effective.add(1e-12, &self.stiffness);
        let mut x = Matrix { rows: load.len(), cols: 1, data: load.iter().map(|v| -v).collect() };
        self.symbolic.factor(&effective, Kind::QuasiDefinite)?.solve(&mut x)?;
        let dofs = self.model.dofs();
        let depth = self.model.nodes().iter().fold(0.0_f64, |m, p| m.max(p[2]));
        let (mut pressure, mut elevation) = (0.0_f64, 0.0_f64);
        for (e, value) in x.data.iter().enumerate() {
            let (node, dof) = dofs.unknown(e);
            match dof {
                Dof::Phi => {
                    let expected = DENSITY * (depth - self.model.nodes()[node][2]);
                    pressure = pressure.max((-DENSITY * value - expected).abs() / (DENSITY * depth));
                }
                _ => elevation = elevation.max(value.abs()),
            }
        }
        Ok((pressure, elevation))
    }

    /// bᵀ (ρH)⁻¹ b with b = ρ B ι on some potentials.
    fn added_mass(&self, phi: &[usize]) -> Result<f64, Failure> {
        let mut h = self.mass.submatrix(phi);
        h.values.iter_mut().for_each(|v| *v = -*v);
        let nodes: Vec<usize> = phi.iter().map(|&e| self.model.dofs().unknown(e).0).collect();
        let ordering: Ordering = Ordering::best(&h.pattern, &nodes, self.model.nodes());
        let symbolic = Arc::new(Symbolic::new(h.pattern.clone(), &ordering)?);
        let load: Vec<f64> = phi.iter().map(|&e| self.inertia[e]).collect();
        let mut x = Matrix { rows: load.len(), cols: 1, data: load.clone() };
        symbolic.factor(&h, Kind::Definite)?.solve(&mut x)?;
        Ok(dot(&load, &x.data))
    }
}

/// Adds liquid and free surface.
///
/// Errors: those of the elements.
pub fn fill(
    builder: &mut Builder,
    cells: &[Hexahedron],
    surface: &[Face],
    chart: Chart,
    density: f64,
) -> Result<(), Failure> {
    for cell in cells {
        builder.element("liquid", Potential8::new(cell, chart, density)?);
    }
    for face in surface {
        builder.element("surface", PotentialSurface::new(face, chart, density, GRAVITY)?);
    }
    Ok(())
}

/// A face that follows the ground: its own nodes, displacements held.
fn hold(builder: &mut Builder, face: &Face, chart: Chart, normals: [[f64; 3]; 4]) -> Result<(), Failure> {
    builder.element("ground", WetFace::new(face, chart, face.nodes, normals, DENSITY)?);
    for node in face.nodes {
        for dof in Dof::TRANSLATIONS {
            builder.hold(node, *dof);
        }
    }
    Ok(())
}
