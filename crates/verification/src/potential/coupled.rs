//! Anchored cylinders of `shell4` with the potential liquid: on hexahedra, or harmonic by harmonic.

use std::sync::Arc;

use materials::von_mises::VonMises;
use nalgebra::Vector3;

use super::condensed_mesh::of_mesh;
use super::rigid::{DENSITY, GRAVITY, fill, uniform};
use super::three_field::ThreeField;
use super::wall::{NormalRow, WallPencil};
use crate::Failure;
use fem::assembly::{Assembler, order};
use fem::chart::Chart;
use fem::dofs::{Dof, KINDS};
use fem::element::WetFace;
use fem::element::shell::layered::{LayeredSection, Ply};
use fem::element::shell::rule::Rule;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
use fem::element::shell4::{Axes, MembraneShear};
use fem::linalg::{Matrix, Pencil, Symbolic, Symmetric, dot};
use fem::liquid::{HarmonicLiquid, LiquidMesh};
use fem::mesh::{Cylinder, Volume, Wall};
use fem::model::{Builder, Model};

/// An anchored upright cylinder, partly filled.
#[derive(Clone, Debug)]
pub struct Tank {
    /// Radius R [m].
    pub radius: f64,
    /// Depth of the liquid H [m].
    pub depth: f64,
    /// Density of the liquid [kg/m³].
    pub liquid_density: f64,
    /// E [Pa], ν, density [kg/m³] of the wall.
    pub material: [f64; 3],
    /// (upper edge [m], thickness [m]) of the courses, from below.
    pub courses: Vec<(f64, f64)>,
    /// Yield stress and tangent modulus [Pa] of a wall that yields.
    pub yields: Option<[f64; 2]>,
}

impl Tank {
    /// Tank 8.1 of the dissertation (Manos & Clough 1982): aluminium, R = 1.83 m, H = 1.525 m, courses of 2.03 and 1.27 mm.
    pub fn broad() -> Tank {
        Tank {
            radius: 1.83,
            depth: 1.525,
            liquid_density: DENSITY,
            material: [69e9, 0.32, 2750.0],
            courses: vec![(0.915, 2.03e-3), (1.83, 1.27e-3)],
            yields: None,
        }
    }

    /// Tank 8.3 of the dissertation: steel, R = 1.83 m, wall 5.5 m high and 2 mm thick.
    pub fn slender(depth: f64, liquid_density: f64) -> Tank {
        Tank {
            radius: 1.83,
            depth,
            liquid_density,
            material: [210e9, 0.3, 7850.0],
            courses: vec![(5.5, 2e-3)],
            yields: None,
        }
    }
}

/// Divisions of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Division {
    /// Sectors of wall and liquid.
    pub sectors: usize,
    /// Levels of the wall [m]; courses and surface must be among them.
    pub wall: Vec<f64>,
    /// Radii of the liquid's nodes [m].
    pub radii: Vec<f64>,
    /// Levels of the liquid's nodes [m].
    pub liquid: Vec<f64>,
    /// How the wall takes its membrane shear.
    pub membrane_shear: MembraneShear,
}

impl Division {
    /// 8 k sectors, 4 k × 5 k elements of liquid (radius × height); the wall with ⌈3k/2⌉ elements in the lowest 2.5 √(Rt),
    /// where it bends, and about 5 k above.
    pub fn refined(tank: &Tank, k: usize) -> Division {
        let layer = 2.5 * (tank.radius * tank.courses[0].1).sqrt();
        let top = tank.courses[tank.courses.len() - 1].0;
        let mut breaks = vec![0.0, layer, tank.depth];
        breaks.extend(tank.courses.iter().map(|c| c.0));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * top);
        let mut wall = vec![0.0];
        for pair in breaks.windows(2) {
            let size = if pair[0] == 0.0 { layer / (3 * k).div_ceil(2) as f64 } else { top / (5 * k) as f64 };
            let count = ((pair[1] - pair[0]) / size).round().max(1.0) as usize;
            wall.extend((1..=count).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64));
        }
        Division {
            sectors: 8 * k,
            wall,
            radii: uniform(tank.radius, 4 * k),
            liquid: uniform(tank.depth, 5 * k),
            membrane_shear: MembraneShear::default(),
        }
    }
}

/// Global components of a unit translation along x.
pub fn along_x(_position: [f64; 3]) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    out[0] = 1.0;
    out
}

/// Global components of a unit radial displacement.
pub fn radial(position: [f64; 3]) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    let r = position[0].hypot(position[1]);
    if r > 0.0 {
        (out[0], out[1]) = (position[0] / r, position[1] / r);
    }
    out
}

/// A mode and its participation in a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Participating {
    /// ω [rad/s].
    pub omega: f64,
    /// (φᵀ M ι)² [kg].
    pub mass: f64,
}

/// The assembled wall, with or without liquid elements.
pub struct Assembled {
    /// Model.
    pub model: Model,
    /// Assembler.
    pub assembler: Assembler,
    /// M.
    pub mass: Symmetric,
    /// K.
    pub stiffness: Symmetric,
    /// Symbolic factor.
    pub symbolic: Arc<Symbolic>,
    /// Wall nodes: `rows[level][sector]`.
    pub rows: Vec<Vec<usize>>,
}

impl Assembled {
    fn new(builder: Builder, rows: Vec<Vec<usize>>) -> Result<Assembled, Failure> {
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let pattern = assembler.pattern().clone();
        Ok(Assembled {
            mass: assembler.mass(&model),
            stiffness: assembler.stiffness(&model)?,
            symbolic: Arc::new(Symbolic::new(pattern.clone(), &order(&model, &pattern))?),
            model,
            assembler,
            rows,
        })
    }

    /// M ι of a field, held dofs included.
    pub fn inertia(&self, field: fn([f64; 3]) -> [f64; KINDS]) -> Vec<f64> {
        self.assembler.inertia(&self.model, |node| field(self.model.nodes()[node]))
    }
}

/// Nodes and faces of the wall.
fn place_nodes(builder: &mut Builder, tank: &Tank, division: &Division) -> Result<Wall, Failure> {
    let mesh = Cylinder { radii: vec![0.0, tank.radius], sectors: division.sectors, heights: division.wall.clone() };
    let mut wall = mesh.wall()?;
    let first = builder.nodes(&wall.nodes);
    wall.cells.iter_mut().for_each(|c| c.nodes.iter_mut().for_each(|n| *n += first));
    wall.rows.iter_mut().flatten().for_each(|n| *n += first);
    Ok(wall)
}

/// The wall, clamped at its base.
fn place_wall(builder: &mut Builder, tank: &Tank, division: &Division) -> Result<Wall, Failure> {
    let wall = place_nodes(builder, tank, division)?;
    let [e, nu, density] = tank.material;
    let sections = tank
        .courses
        .iter()
        .map(|&(_, t)| -> Result<Arc<dyn Section>, Failure> {
            let Some([strength, tangent]) = tank.yields else {
                return Ok(Arc::new(ElasticSection::new(e, nu, t, density)?));
            };
            let ply = Ply {
                law: Arc::new(VonMises::new(e, nu, strength, tangent, 1.0)?),
                thickness: t,
                density,
                rule: Rule::Gauss(5),
            };
            Ok(Arc::new(LayeredSection::new(&[ply], &[])?))
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    let cells = wall
        .cells
        .iter()
        .map(|cell| {
            let middle = 0.5 * (cell.chart[0][2] + cell.chart[2][2]);
            let course = tank.courses.iter().position(|c| middle < c.0).unwrap_or(tank.courses.len() - 1);
            ShellCell { nodes: cell.nodes, section: sections[course].clone(), group: "wall".to_owned() }
        })
        .collect();
    let first = wall.rows.iter().flatten().copied().min().unwrap_or(0);
    let positions: Vec<[f64; 3]> = wall.nodes.clone();
    let outwards = |_: usize, node: usize| Vector3::new(positions[node - first][0], positions[node - first][1], 0.0);
    ShellSurface {
        normals: Normals::Exact(&outwards),
        axes: Axes::HOOP_Z,
        membrane_shear: division.membrane_shear,
        ..ShellSurface::new(cells)
    }
    .place(builder)?;
    for &node in &wall.rows[0] {
        for dof in Dof::SHELL {
            builder.hold(node, *dof);
        }
    }
    Ok(wall)
}

/// Nodes, hexahedra and surface of the liquid.
fn place_liquid(builder: &mut Builder, tank: &Tank, division: &Division, elements: bool) -> Result<Volume, Failure> {
    let mesh = Cylinder { radii: division.radii.clone(), sectors: division.sectors, heights: division.liquid.clone() };
    let volume = mesh.volume()?;
    builder.nodes(&volume.nodes);
    if elements {
        fill(builder, &volume.cells, &volume.surface, Chart::Cylindrical, tank.liquid_density)?;
    }
    Ok(volume)
}

/// Joins the liquid to the wall.
fn join(builder: &mut Builder, tank: &Tank, volume: &Volume, wall: &Wall) -> Result<(), Failure> {
    // Only faces of one sector can overlap; they stand in the order of the sectors.
    for own in &volume.wall {
        for other in &wall.cells {
            if (own.chart[0][1] - other.chart[0][1]).abs() > 1e-9 {
                continue;
            }
            let normals = other.chart.map(|c| [c[1].cos(), c[1].sin(), 0.0]);
            let face = WetFace::overlapping(own, other, Chart::Cylindrical, normals, tank.liquid_density)?;
            if let Some(face) = face {
                builder.element("wet", face);
            }
        }
    }
    Ok(())
}

/// Wall and hexahedra.
///
/// Errors: no mesh, an element out of range.
pub fn with_hexahedra(tank: &Tank, division: &Division) -> Result<Assembled, Failure> {
    let mut builder = Builder::new();
    let volume = place_liquid(&mut builder, tank, division, true)?;
    let wall = place_wall(&mut builder, tank, division)?;
    join(&mut builder, tank, &volume, &wall)?;
    Assembled::new(builder, wall.rows)
}

/// The same with the hexahedra condensed into one element over the radial displacements of the wetted nodes, which have
/// frames, and the elevations, or the lowest sloshing modes of the tank at rest. Nodes have the same numbers.
///
/// Errors: as [`with_hexahedra`]; those of the condensation.
pub fn with_condensed(tank: &Tank, division: &Division, sloshing: Option<usize>) -> Result<Assembled, Failure> {
    let turn = |builder: &mut Builder, wall: &Wall| {
        for &node in wall.rows.iter().flatten() {
            let [x, y, _] = builder.position(node);
            let (c, s) = (x / x.hypot(y), y / x.hypot(y));
            builder.frame(node, nalgebra::Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
        }
    };
    let mut liquid = Builder::new();
    let volume = place_liquid(&mut liquid, tank, division, true)?;
    let nodes = place_nodes(&mut liquid, tank, division)?;
    turn(&mut liquid, &nodes);
    join(&mut liquid, tank, &volume, &nodes)?;
    let found = of_mesh(&liquid.build()?)?;
    let mut builder = Builder::new();
    place_liquid(&mut builder, tank, division, false)?;
    let wall = place_wall(&mut builder, tank, division)?;
    turn(&mut builder, &wall);
    let element = match sloshing {
        None => found.element()?,
        Some(count) => {
            let amplitudes: Vec<(usize, Dof)> = (0..count).map(|_| (builder.node([0.0; 3]), Dof::Amplitude)).collect();
            found.liquid.with_sloshing_modes(count)?.element(&found.wall, &amplitudes, 0.0)?
        }
    };
    builder.element("liquid", element);
    Assembled::new(builder, wall.rows)
}

/// The mode nearest `omega` [rad/s] among those of the harmonic of `field`, on hexahedra.
///
/// Errors: no convergence.
pub fn mode_on_hexahedra(
    tank: &Assembled,
    omega: f64,
    field: fn([f64; 3]) -> [f64; KINDS],
) -> Result<Participating, Failure> {
    let phi = tank.model.dofs().of_kind(Dof::Phi);
    let pencil = ThreeField::new(&tank.stiffness, &tank.mass, tank.symbolic.clone(), phi)?;
    let start = tank.model.vector(|node| field(tank.model.nodes()[node]));
    let (omega, vector) = iterate(&pencil, omega, pencil.restrict(&start))?;
    let all = pencil.expand(&vector)?;
    Ok(Participating { omega, mass: dot(&all.data, &tank.inertia(field)).powi(2) })
}

/// Inverse iteration with the shift `omega`². On a cyclic mesh it stays within the harmonic of its start, so that the many
/// shell modes of other harmonics nearby do not disturb it. Returns ω and x with xᵀ M x = 1.
fn iterate(pencil: &dyn Pencil, omega: f64, start: Vec<f64>) -> Result<(f64, Matrix), Failure> {
    let sigma = omega * omega;
    let shifted = pencil.shifted(-sigma)?;
    let mut x = Matrix { rows: start.len(), cols: 1, data: start };
    let mut last = 0.0;
    for _ in 0..60 {
        let image = pencil.mass(&x)?;
        let norm = dot(&x.data, &image.data).sqrt();
        let mut y = image.clone();
        shifted.solve(&mut y)?;
        // θ = xᵀ M A x / xᵀ M x
        let lambda = sigma + norm * norm / dot(&y.data, &image.data);
        x.data.iter_mut().zip(&y.data).for_each(|(x, y)| *x = y / norm);
        if (lambda - last).abs() <= 1e-10 * lambda {
            let image = pencil.mass(&x)?;
            let norm = dot(&x.data, &image.data).sqrt();
            x.data.iter_mut().for_each(|v| *v /= norm);
            return Ok((lambda.sqrt(), x));
        }
        last = lambda;
    }
    Err(format!("no convergence of the mode at {omega} rad/s").into())
}

/// Wall alone, with the harmonic liquid on a meridional section refined by `refine`.
pub struct WithHarmonics {
    /// The wall.
    pub wall: Assembled,
    /// The liquid.
    pub liquid: HarmonicLiquid,
    /// R.
    pub normals: Vec<NormalRow>,
}

/// Wall and harmonic liquid.
///
/// Errors: no mesh, an element out of range.
pub fn with_harmonics(tank: &Tank, division: &Division, refine: f64, sloshing: u32) -> Result<WithHarmonics, Failure> {
    let mut builder = Builder::new();
    let wall = place_wall(&mut builder, tank, division)?;
    let wall = Assembled::new(builder, wall.rows)?;
    let wetted = division.wall.iter().filter(|&&z| z <= tank.depth * (1.0 + 1e-9)).count();
    let mesh = LiquidMesh::graded(tank.radius, tank.depth, refine);
    let liquid = HarmonicLiquid::new(
        tank.radius,
        tank.liquid_density,
        GRAVITY,
        division.sectors,
        &division.wall[..wetted],
        &mesh,
        sloshing,
    )?;
    let mut normals = Vec::new();
    for row in &wall.rows[..wetted] {
        for &node in row {
            let n = radial(wall.model.nodes()[node]);
            let mut entries: NormalRow = Vec::new();
            for (dof, c) in [(Dof::Ux, n[0]), (Dof::Uy, n[1])] {
                entries.extend(wall.model.row(node, dof).into_iter().map(|(e, v)| (e, v * c)));
            }
            normals.push(entries);
        }
    }
    Ok(WithHarmonics { wall, liquid, normals })
}

impl WithHarmonics {
    /// The pencil of wall and liquid.
    pub fn pencil(&self) -> WallPencil<'_> {
        WallPencil::new(
            &self.wall.stiffness,
            &self.wall.mass,
            self.wall.symbolic.clone(),
            self.normals.clone(),
            &self.liquid,
        )
    }

    /// M ι over (u, η): wall with its held dofs, liquid with the rigid motion of all wetted nodes.
    pub fn inertia(&self, field: fn([f64; 3]) -> [f64; KINDS]) -> Vec<f64> {
        let mut load = self.wall.inertia(field);
        let mut motion = vec![0.0; self.liquid.wall() + self.liquid.elevations()];
        for (i, &node) in self.wall.rows.iter().flatten().take(self.liquid.wall()).enumerate() {
            let (at, n) = (field(self.wall.model.nodes()[node]), radial(self.wall.model.nodes()[node]));
            motion[i] = at[0] * n[0] + at[1] * n[1];
        }
        let force = self.liquid.mass(&Matrix { rows: motion.len(), cols: 1, data: motion }).data;
        for (row, f) in self.normals.iter().zip(&force) {
            for &(e, c) in row {
                load[e] += c * f;
            }
        }
        load.extend_from_slice(&force[self.liquid.wall()..]);
        load
    }

    /// The mode nearest `omega` [rad/s] among those of the harmonic of `field`.
    ///
    /// Errors: no convergence.
    pub fn mode(&self, omega: f64, field: fn([f64; 3]) -> [f64; KINDS]) -> Result<Participating, Failure> {
        let pencil = self.pencil();
        let mut start = self.wall.model.vector(|node| field(self.wall.model.nodes()[node]));
        start.resize(pencil.size(), 0.0);
        let (omega, vector) = iterate(&pencil, omega, start)?;
        Ok(Participating { omega, mass: dot(&vector.data, &self.inertia(field)).powi(2) })
    }
}
