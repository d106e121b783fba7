//! Cylinder full of displacement liquid between rigid walls, whole or a quarter, and its modes classified by their energies.

use std::sync::Arc;

use nalgebra::Matrix3;

use crate::Failure;
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{Fluid8, FreeSurface, LiquidProperties, VolumePart};
use fem::linalg::{Matrix, Ordering, Search, Sparse, Symbolic, dot, modes};
use fem::mesh::grading::{geometric, uniform};
use fem::mesh::{Cylinder, Face, Hexahedron};
use fem::model::{Builder, Model};

/// Sector of the circle that is modelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sector {
    /// All of it.
    Whole,
    /// 0 ≤ θ ≤ 90°, motion of cos θ, cos 3θ, … .
    Odd,
    /// 0 ≤ θ ≤ 90°, motion of 1, cos 2θ, … .
    Even,
}

/// A tank and its mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tank {
    /// R [m].
    pub radius: f64,
    /// H [m].
    pub fill: f64,
    /// Elements along radius, circumference and height.
    pub counts: [usize; 3],
    /// Height of the lowest over that of the highest element.
    pub grading: f64,
    /// Sector of the circle.
    pub part: Sector,
}

/// Model of a tank.
pub(super) struct Built {
    pub model: Model,
    pub assembler: Assembler,
    /// Nodes of the wall with their θ.
    pub wall: Vec<(usize, f64)>,
    /// Nodes of the surface's edge with their θ, θ ascending.
    pub edge: Vec<(usize, f64)>,
    /// The liquid elements.
    pub elements: Vec<Fluid8>,
}

impl Built {
    /// Sloshing frequencies of circumferential wave number `m` among the modes of a search, ascending [rad/s].
    ///
    /// The wave number of a mode is the one of greatest amplitude among those of its part, |Σ w u_z cos mθ| along the
    /// edge of the surface with the weights of the trapezoidal rule.
    pub(crate) fn sloshing(&self, m: u32, wanted: &Search) -> Result<Vec<f64>, Failure> {
        let (list, shapes) = search(&self.model, &self.assembler, wanted)?;
        let amplitude = |x: &[f64], harmonic: u32| {
            let last = self.edge.len() - 1;
            let term = |(k, &(node, theta)): (usize, &(usize, f64))| {
                let weight = if k == 0 || k == last { 0.5 } else { 1.0 };
                weight * self.model.at_node(x, node)[2] * (f64::from(harmonic) * theta).cos()
            };
            self.edge.iter().enumerate().map(term).sum::<f64>().abs()
        };
        let number = |x: &[f64]| {
            let all = (m % 2..5).step_by(2).map(|h| (h, amplitude(x, h)));
            all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(h, _)| h)
        };
        Ok(list
            .iter()
            .enumerate()
            .filter(|(j, mode)| mode.surface > 0.5 && number(shapes.column(*j)) == Some(m))
            .map(|(_, mode)| mode.omega)
            .collect())
    }
}

impl Tank {
    /// The model: bottom u_z = 0, axis and planes of symmetry as the part demands, wall u_r = 0 if `rigid`. The wall's
    /// unknowns are along e_r, e_θ, e_z. A Cartesian chart makes straight-sided cells of the same nodes.
    pub(crate) fn build(
        &self,
        chart: Chart,
        liquid: LiquidProperties,
        gravity: f64,
        rigid: bool,
    ) -> Result<Built, Failure> {
        let mesh = Cylinder {
            radii: uniform(0.0, self.radius, self.counts[0])?,
            sectors: self.counts[1],
            heights: geometric(0.0, self.fill, self.counts[2], 1.0 / self.grading)?,
        };
        let volume = mesh.volume()?;
        let quarter = std::f64::consts::FRAC_PI_2;
        // The farthest corner decides: 10⁻⁹ rad is far below a sector.
        let within = |theta: f64| self.part == Sector::Whole || theta < quarter + 1e-9;
        let mut builder = Builder::new();
        builder.nodes(&volume.nodes);
        let own = |node: usize, place: [f64; 3]| match chart {
            Chart::Cartesian => volume.nodes[node],
            Chart::Cylindrical => place,
        };
        let mut elements = Vec::new();
        for cell in volume.cells.iter().filter(|c| c.chart.iter().all(|x| within(x[1]))) {
            let cell =
                Hexahedron { nodes: cell.nodes, chart: std::array::from_fn(|a| own(cell.nodes[a], cell.chart[a])) };
            let element = Fluid8::new(&cell, chart, liquid)?;
            builder.element("liquid", element.clone());
            elements.push(element);
        }
        for face in volume.surface.iter().filter(|f| f.chart.iter().all(|x| within(x[1]))) {
            let face = Face { nodes: face.nodes, chart: std::array::from_fn(|a| own(face.nodes[a], face.chart[a])) };
            let weight = liquid.density * gravity;
            let surface = match liquid.volume {
                VolumePart::OnePoint => FreeSurface::at_one_point(&face, chart, weight)?,
                VolumePart::Full | VolumePart::MeanDilatation => FreeSurface::new(&face, chart, weight)?,
            };
            builder.element("surface", surface);
        }
        volume.bottom_nodes.iter().for_each(|&n| builder.hold(n, Dof::Uz));
        let mut wall = Vec::new();
        for row in &volume.wall_nodes {
            for (sector, &node) in row.iter().enumerate() {
                let theta = mesh.theta(sector);
                if within(theta) {
                    let (s, c) = theta.sin_cos();
                    builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
                    wall.push((node, theta));
                    if rigid {
                        builder.hold(node, Dof::Ux);
                    }
                }
            }
        }
        self.hold_symmetry(&volume.nodes, &wall, &mut builder);
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let top = volume.wall_nodes.last().map_or(&[][..], Vec::as_slice);
        let edge = wall.iter().filter(|w| top.contains(&w.0)).copied().collect();
        Ok(Built { model, assembler, edge, wall, elements })
    }

    /// Planes y = 0 (mirror) and x = 0 (mirror for even, antimirror for odd motion).
    fn hold_symmetry(&self, nodes: &[[f64; 3]], wall: &[(usize, f64)], builder: &mut Builder) {
        if self.part == Sector::Whole {
            return;
        }
        let small = 1e-9 * self.radius;
        let on_wall: std::collections::BTreeSet<usize> = wall.iter().map(|w| w.0).collect();
        for (node, p) in nodes.iter().enumerate() {
            // At the wall the first unknown is radial, the second tangential.
            let framed = on_wall.contains(&node);
            if p[1].abs() < small && p[0] > -small {
                // θ = 0: e_r = e_x, e_θ = e_y.
                builder.hold(node, Dof::Uy);
            }
            if p[0].abs() < small && p[1] > -small {
                let (along_x, along_y) = if framed { (Dof::Uy, Dof::Ux) } else { (Dof::Ux, Dof::Uy) };
                match self.part {
                    Sector::Odd => {
                        builder.hold(node, along_y);
                        builder.hold(node, Dof::Uz);
                    }
                    _ => builder.hold(node, along_x),
                }
            }
        }
    }
}

/// A mode of a model.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mode {
    /// ω [rad/s].
    pub omega: f64,
    /// Share of the potential energy that is lift of the surface.
    pub surface: f64,
}

/// The lowest modes, proven complete by an inertia count. The stiffness of a group called `surface` is the lift.
pub(super) fn lowest(model: &Model, assembler: &Assembler, count: usize) -> Result<Vec<Mode>, Failure> {
    Ok(search(model, assembler, &Search::lowest(count))?.0)
}

/// Modes of a search with their shapes.
pub(super) fn search(model: &Model, assembler: &Assembler, search: &Search) -> Result<(Vec<Mode>, Matrix), Failure> {
    let k = assembler.stiffness(model)?;
    let m = assembler.mass(model);
    let surface = model.group("surface");
    let s = assembler.stiffness_of(model, |e| Some(model.group_of(e)) == surface)?;
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let found = modes(&Sparse::new(&k, &m, symbolic), search)?;
    let list = found
        .lambda
        .iter()
        .enumerate()
        .map(|(j, lambda)| {
            let x = found.vectors.column(j);
            Mode { omega: lambda.max(0.0).sqrt(), surface: dot(x, &s.times(x)) / dot(x, &k.times(x)) }
        })
        .collect();
    Ok((list, found.vectors))
}

/// The `number`-th sloshing mode (from 0): more than half of its potential energy is lift of the surface.
pub(super) fn sloshing(modes: &[Mode], number: usize) -> Result<f64, Failure> {
    modes
        .iter()
        .filter(|m| m.surface > 0.5)
        .nth(number)
        .map(|m| m.omega)
        .ok_or_else(|| missing(&format!("sloshing mode {}", number + 1), modes.len()))
}

/// ω of the n-th mode of an upright rigid cylinder: ω² = (g λ/R) tanh(λ H/R), J_m'(λ) = 0.
pub(super) fn exact(lambda: f64, radius: f64, fill: f64, gravity: f64) -> f64 {
    (gravity * lambda / radius * (lambda * fill / radius).tanh()).sqrt()
}

/// Zeros λ of J_m' (Abramowitz & Stegun 1964, table 9.5).
pub(super) mod zeros {
    /// m = 0.
    pub(crate) const M0: [f64; 2] = [3.831_705_970_207_512, 7.015_586_669_815_619];
    /// m = 1.
    pub(crate) const M1: [f64; 3] = [1.841_183_781_340_659, 5.331_442_773_525_033, 8.536_316_366_346_286];
    /// m = 2.
    pub(crate) const M2: [f64; 1] = [3.054_236_928_227_14];
}

/// A mode that is not among those computed.
pub(super) fn missing(what: &str, found: usize) -> Failure {
    format!("{what} is not among the {found} modes computed").into()
}
