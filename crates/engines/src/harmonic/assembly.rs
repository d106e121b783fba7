//! All unknowns of one harmonic, held ones included: numbering, matrices, rigid translation, loads.
//!
//! Unknowns are the nodal u, v, w, w' of the wall from the base up and then the elevations η.

use tank::Case;
use tank::Shape;

use fem::linalg::Matrix;
use fem::liquid::Potential;

use super::reduce::Reduction;
use super::rings::Fitting;
use super::wall::{NODAL, NODE, Wall};

/// Wall and liquid of one harmonic, joined.
pub(super) struct Assembly {
    pub(super) wall: Wall,
    pub(super) liquid: Potential,
    pub(super) harmonic: u32,
    /// Index of u, v, w, w' of each wall node.
    pub(super) node: Vec<[Option<usize>; NODE]>,
    /// Index of each column of the liquid's x.
    pub(super) column: Vec<usize>,
    /// Number of all unknowns.
    pub(super) size: usize,
    pub(super) mass: Matrix,
    pub(super) stiffness: Matrix,
    /// Rigid translation of the ground in its direction, on all unknowns.
    pub(super) translation: Vec<f64>,
    /// Rigid rotation about the base, on all unknowns (zero unless m = 1).
    pub(super) rotation: Vec<f64>,
    /// Inertia load of a unit ground acceleration, on all unknowns (right-hand side −load a_g).
    pub(super) load: Vec<f64>,
    /// Rows of base shear and base moment of the wall with its rings and attachments, on all unknowns.
    pub(super) wall_inertia: [Vec<f64>; 2],
    /// The same of the roof.
    pub(super) roof_inertia: [Vec<f64>; 2],
    pub(super) reduction: Reduction,
}

/// Mass of the roof on the meshed wall, and its height above the wall's top.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoofShare {
    pub(super) mass: f64,
    pub(super) offset: f64,
}

impl Assembly {
    pub(super) fn new(case: &Case, harmonic: u32, wall: Wall, liquid: Potential, roof: RoofShare) -> Assembly {
        let mut size = 0;
        let mut take = || {
            size += 1;
            size - 1
        };
        let node: Vec<[Option<usize>; NODE]> =
            wall.nodes.iter().map(|_| std::array::from_fn(|k| wall.active[k].then(&mut take))).collect();
        let wetted = liquid.trace.len();
        let trace = node[..wetted].iter().flat_map(|n| [n[2], n[3]]);
        let mut column: Vec<usize> = trace.map(|i| i.expect("w and its slope are unknowns of every wall")).collect();
        column.extend(liquid.surface_columns().map(|_| take()));

        let (mut mass, mut stiffness) = (Matrix::zeros(size, size), Matrix::zeros(size, size));
        add_wall(&wall, &node, &mut mass, &mut stiffness);
        for fitting in Fitting::all(&case.tank) {
            fitting.add_to((&wall, &case.tank), &node, &mut mass, &mut stiffness);
        }
        let bare = mass.clone();
        add_roof(&wall, &node, harmonic, roof, &mut mass);
        let mut assembly = {
            Assembly {
                translation: vec![0.0; size],
                rotation: vec![0.0; size],
                load: vec![0.0; size],
                wall_inertia: Default::default(),
                roof_inertia: Default::default(),
                reduction: Reduction::new(&[], None),
                wall,
                liquid,
                harmonic,
                node,
                column,
                size,
                mass,
                stiffness,
            }
        };
        assembly.set_rigid_motion(case);
        // Vertical motion: the weight of the wall follows from its mass, that of the liquid from its pressure.
        let rigid = [&assembly.translation, &assembly.rotation];
        let of_wall = rigid.map(|motion| bare.times(motion));
        let with_roof = rigid.map(|motion| assembly.mass.times(motion));
        let wall_load = with_roof[0].clone();
        assembly.roof_inertia = std::array::from_fn(|k| {
            let both = with_roof[k].iter().zip(&of_wall[k]);
            both.map(|(all, wall)| all - wall).collect()
        });
        assembly.wall_inertia = of_wall;
        assembly.add_liquid(case.gravity);
        assembly.load = if harmonic == 0 {
            let mut load = wall_load;
            let pressure = assembly.liquid.hydrostatic_load(1.0);
            for (value, &i) in pressure.iter().zip(&assembly.column) {
                load[i] -= value;
            }
            load
        } else {
            assembly.mass.times(&assembly.translation)
        };
        assembly.reduction = assembly.reduce();
        assembly
    }

    /// A row of the liquid's x as a row of all unknowns.
    pub(super) fn liquid_row(&self, row: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.size];
        for (value, &i) in row.iter().zip(&self.column) {
            out[i] += value;
        }
        out
    }

    /// A row on the nodal unknowns of element `e`, times `factor`, added to the row `out` of all unknowns.
    pub(super) fn add_nodal_row(&self, e: usize, row: &[f64; NODAL], factor: f64, out: &mut [f64]) {
        for (i, value) in element_unknowns(&self.node, e).into_iter().zip(row) {
            if let Some(i) = i {
                out[i] += factor * value;
            }
        }
    }

    /// First elevation among all unknowns.
    pub(super) fn surface_start(&self) -> usize {
        self.size - self.liquid.surface_columns().len()
    }

    fn add_liquid(&mut self, gravity: f64) {
        let weight = self.liquid.density * gravity;
        for (j, &q) in self.column.iter().enumerate() {
            for (i, &p) in self.column.iter().enumerate() {
                self.mass.add(p, q, self.liquid.mass.get(i, j));
                let area = self.liquid.surface_area.get(i, j);
                if area != 0.0 {
                    self.stiffness.add(p, q, weight * area);
                }
            }
        }
    }

    /// ι: w = 1, v = −1 (m = 1) or u = 1 (m = 0). κ: w = z, v = −z, w' = 1, u = −R (m = 1).
    fn set_rigid_motion(&mut self, case: &Case) {
        let radius = match case.tank.shape {
            Shape::Cylinder { radius } => radius,
            // The axial force of a strip's walls is not an unknown of its antisymmetric half.
            Shape::Rectangle { .. } => 0.0,
        };
        for (z, index) in self.wall.nodes.iter().zip(&self.node) {
            let (translation, rotation) = match self.harmonic {
                0 => ([1.0, 0.0, 0.0, 0.0], [0.0; NODE]),
                1 => ([0.0, -1.0, 1.0, 0.0], [-radius, -z, *z, 1.0]),
                _ => ([0.0; NODE], [0.0; NODE]),
            };
            for k in 0..NODE {
                if let Some(i) = index[k] {
                    self.translation[i] = translation[k];
                    self.rotation[i] = rotation[k];
                }
            }
        }
    }

    /// The base holds the foot of the wall; a floating liquid keeps its volume.
    fn reduce(&self) -> Reduction {
        let mut held = vec![false; self.size];
        for (i, by_base) in self.node[0].iter().zip(self.wall.held) {
            if let Some(i) = i {
                held[*i] = by_base;
            }
        }
        let flux = self.liquid.domain.is_floating().then(|| self.liquid_row(&self.liquid.flux));
        Reduction::new(&held, flux.as_deref().map(|q| (q, self.surface_start()..self.size)))
    }
}

/// Unknowns of the two nodes of element `e`.
pub(super) fn element_unknowns(node: &[[Option<usize>; NODE]], e: usize) -> [Option<usize>; NODAL] {
    std::array::from_fn(|i| node[e + i / NODE][i % NODE])
}

fn add_wall(wall: &Wall, node: &[[Option<usize>; NODE]], mass: &mut Matrix, stiffness: &mut Matrix) {
    for (e, element) in wall.elements.iter().enumerate() {
        let unknowns = element_unknowns(node, e);
        let (k, m) = (element.condensed(&element.stiffness), element.condensed(&element.mass));
        for i in 0..NODAL {
            for j in 0..NODAL {
                if let (Some(p), Some(q)) = (unknowns[i], unknowns[j]) {
                    stiffness.add(p, q, k[i][j]);
                    mass.add(p, q, m[i][j]);
                }
            }
        }
    }
    if let Some(w) = node[0][2].filter(|_| wall.foot > 0.0) {
        stiffness.add(w, w, wall.factor * wall.foot);
    }
}

/// The roof is a ring of mass on the top edge; for m = 1 its centre may lie above the edge, joined rigidly.
///
/// ```text
/// cylinder, m ≥ 1: 2 T = m_r/2 (u̇² + v̇² + ẇ²),  m = 0: m_r (u̇² + ẇ²)
/// centre of mass d above the edge (m = 1): its translation is U − d u/R with U = (w − v)/2, which adds
///         m_r (−2 U̇ d u̇/R + d² u̇²/R²)
/// strip (both walls together): m_r (u̇² + ẇ²)
/// ```
fn add_roof(wall: &Wall, node: &[[Option<usize>; NODE]], harmonic: u32, roof: RoofShare, mass: &mut Matrix) {
    let [u, v, w, _] = node[node.len() - 1];
    let cylinder = wall.curvature > 0.0;
    let share = if cylinder && harmonic > 0 { 0.5 * roof.mass } else { roof.mass };
    [u, v, w].into_iter().flatten().for_each(|i| mass.add(i, i, share));
    if let (true, 1, Some(u), Some(v), Some(w)) = (cylinder, harmonic, u, v, w) {
        let lever = roof.offset * wall.curvature;
        mass.add(u, u, roof.mass * lever * lever);
        for (i, sign) in [(w, -0.5), (v, 0.5)] {
            mass.add(u, i, sign * roof.mass * lever);
            mass.add(i, u, sign * roof.mass * lever);
        }
    }
}
