//! Displacement potential of an inviscid, incompressible liquid, condensed to the wall and the free surface.
//!
//! ```text
//! u = ∇φ,  Δφ = 0,  φ,n = u_n (wall),  φ,z = η (surface),  φ,z = u_z (bottom; 0 where it is rigid),  p' = −ρ φ̈
//!
//! H_ij = c ∫ (N_i,r N_j,r + m²/r² N_i N_j + N_i,z N_j,z) r dr dz
//! S_ij = c ∫_surface N_i N_j r dr          B_ij = c R ∫_wall N_i(φ) N_j(w) dz          F = [B S]
//! H φ = F x      X = H⁻¹ F      M_f = ρ Fᵀ X      K_η = ρ g S
//! ```
//!
//! x holds the trace of the wall displacement ([`Trace`]: value and slope at each trace node, cubic Hermite, for a shell of
//! revolution; the value alone, linear, for a wall of flat elements), then the displacement of the bottom at its rings, upwards and linear
//! between them, where it moves ([`Potential::with_floor`]), and then the surface elevations η. The trace nodes need not match the liquid mesh: B is integrated on the union of both partitions, so
//! that every integral is exact but for 1/r.
//!
//! With m = 0 (and the symmetric half of a strip) a constant φ has no energy: one value is held, x must satisfy the
//! balance of volume 1ᵀ F x = 0, and φ is fixed by the surface condition φ̈ + g η = 0 in the mean.
//!
//! Source: Morand & Ohayon 1995, chapter 5 (potential forms). Limits: small waves, upright walls, flat bottom.

use crate::linalg::{LinalgError, Matrix, SparseCholesky, Triplets, transposed_product};
use crate::shape::{gauss, line, quad9};

use super::mesh::locate;
use super::{Domain, LiquidMesh};

/// Coefficients of a linear functional of x: trace first, then the bottom, then η.
pub type Row = Vec<f64>;

/// Interpolation of the wall's normal displacement between the trace nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trace {
    /// Value and slope at each node, cubic Hermite.
    Hermite,
    /// Value at each node, linear.
    Linear,
}

impl Trace {
    /// Columns of x a node.
    pub fn width(self) -> usize {
        match self {
            Trace::Hermite => 2,
            Trace::Linear => 1,
        }
    }

    /// Functions of the two nodes at ξ ∈ [−1, 1] of an interval of length h.
    fn functions(self, xi: f64, h: f64) -> Vec<f64> {
        match self {
            Trace::Hermite => line::hermite(xi, h)[0].to_vec(),
            Trace::Linear => vec![0.5 * (1.0 - xi), 0.5 * (1.0 + xi)],
        }
    }
}

/// The condensed liquid.
#[derive(Clone, Debug)]
pub struct Potential {
    /// Section and harmonic.
    pub domain: Domain,
    /// Mesh.
    pub mesh: LiquidMesh,
    /// Heights of the trace nodes [m], from 0 to H.
    pub trace: Vec<f64>,
    /// Interpolation between them.
    pub interpolation: Trace,
    /// Radii of the rings of a bottom that moves [m], falling; none of a rigid one.
    pub floor: Vec<f64>,
    /// Column of x for the elevation at each surface node of the mesh; `None` on an axis where it vanishes.
    pub surface: Vec<Option<usize>>,
    /// M_f = ρ Fᵀ H⁻¹ F.
    pub mass: Matrix,
    /// S on all of x; zero for the trace.
    pub surface_area: Matrix,
    /// 1ᵀ F: volume that leaves through wall and surface. Zero on x is required of floating domains only.
    pub flux: Row,
    /// X = H⁻¹ F, one row a mesh node.
    potential: Matrix,
    /// Density ρ [kg/m³].
    pub density: f64,
}

impl Potential {
    /// Assembles and condenses the liquid, with a cubic trace.
    ///
    /// * `trace`: heights of the wall nodes from 0 to the surface [m]
    /// * `density`: ρ [kg/m³]
    ///
    /// Errors: H not positive definite (degenerate mesh) or too large.
    pub fn new(domain: Domain, mesh: LiquidMesh, trace: Vec<f64>, density: f64) -> Result<Potential, LinalgError> {
        Potential::with_trace(domain, mesh, trace, Trace::Hermite, density)
    }

    /// The same with another interpolation of the trace.
    ///
    /// Errors: as [`Potential::new`].
    pub fn with_trace(
        domain: Domain,
        mesh: LiquidMesh,
        trace: Vec<f64>,
        interpolation: Trace,
        density: f64,
    ) -> Result<Potential, LinalgError> {
        Potential::with_floor(domain, mesh, (trace, interpolation), &[], density)
    }

    /// The same over a bottom that moves between its rings and rests elsewhere.
    ///
    /// * `floor`: radii of the rings, falling [m]
    ///
    /// Errors: as [`Potential::new`].
    pub fn with_floor(
        domain: Domain,
        mesh: LiquidMesh,
        (trace, interpolation): (Vec<f64>, Trace),
        floor: &[f64],
        density: f64,
    ) -> Result<Potential, LinalgError> {
        let columns_w = interpolation.width() * trace.len();
        let mut columns = columns_w + floor.len();
        let surface: Vec<Option<usize>> = (0..mesh.r.len())
            .map(|i| {
                let free = i > 0 || !domain.vanishes_on_axis();
                free.then(|| {
                    columns += 1;
                    columns - 1
                })
            })
            .collect();

        let unknown = number_nodes(&domain, &mesh);
        let h = stiffness(&domain, &mesh, &unknown);
        let mut f = Matrix::zeros(mesh.nodes(), columns);
        couple_wall(&domain, &mesh, &trace, interpolation, &mut f);
        couple_floor(&domain, &mesh, floor, columns_w, &mut f);
        let mut surface_area = Matrix::zeros(columns, columns);
        couple_surface(&domain, &mesh, &surface, &mut f, &mut surface_area);

        let free: Vec<usize> = (0..mesh.nodes()).filter(|&n| unknown[n].is_some()).collect();
        let all: Vec<usize> = (0..columns).collect();
        let mut x = f.select(&free, &all);
        let f_free = x.clone();
        SparseCholesky::factor(&h)?.solve(&mut x)?;
        let mut mass = transposed_product(&f_free, &x);
        mass.data.iter_mut().for_each(|v| *v *= density);
        symmetrise(&mut mass);

        let mut potential = Matrix::zeros(mesh.nodes(), columns);
        for j in 0..columns {
            for (row, &n) in free.iter().enumerate() {
                potential.add(n, j, x.get(row, j));
            }
        }
        let flux = (0..columns).map(|j| f.column(j).iter().sum()).collect();
        Ok(Potential {
            domain,
            mesh,
            trace,
            interpolation,
            floor: floor.to_vec(),
            surface,
            mass,
            surface_area,
            flux,
            potential,
            density,
        })
    }

    /// Length of x.
    pub fn columns(&self) -> usize {
        self.mass.rows
    }

    /// Columns of x that are surface elevations.
    pub fn surface_columns(&self) -> std::ops::Range<usize> {
        self.interpolation.width() * self.trace.len() + self.floor.len()..self.columns()
    }

    /// Pressure p' = −ρ φ̈ on the wall at height z: coefficients of ẍ, and of x (floating domains only).
    pub fn wall_pressure(&self, z: f64, gravity: f64) -> (Row, Option<Row>) {
        let (e, xi) = locate(&self.mesh.z, z);
        let shape = line::quadratic(xi);
        let last = self.mesh.r.len() - 1;
        let nodes: Vec<(usize, f64)> = (0..3).map(|k| (last + (2 * e + k) * self.mesh.r.len(), shape[k])).collect();
        let mut row = self.potential_row(&nodes);
        row.iter_mut().for_each(|v| *v *= -self.density);
        if !self.domain.is_floating() {
            return (row, None);
        }
        // p' = −ρ (φ̈ − mean of φ̈ over the surface) + ρ g (mean of η over the surface)
        let (mean, mut elevation) = self.surface_means();
        for (v, m) in row.iter_mut().zip(&mean) {
            *v += self.density * m;
        }
        elevation.iter_mut().for_each(|v| *v *= self.density * gravity);
        (row, Some(elevation))
    }

    /// ρ c ∫ φ r² dr (strip: ρ c ∫ φ x dx) over the bottom: coefficients of ẍ in the moment of the bottom pressure, of
    /// the same sign as the moment κᵀ M ẍ of the wall pressure. Zero for m ≠ 1.
    pub fn bottom_moment(&self) -> Row {
        let turns = match self.domain {
            Domain::Cylinder { harmonic, .. } => harmonic == 1,
            Domain::Strip { symmetric, .. } => !symmetric,
        };
        if !turns {
            return vec![0.0; self.columns()];
        }
        let mut nodes = Vec::new();
        for e in 0..self.mesh.elements().0 {
            let (a, b) = (self.mesh.r[2 * e], self.mesh.r[2 * e + 2]);
            for &(xi, w) in gauss::FOUR {
                let r = 0.5 * (a + b) + 0.5 * (b - a) * xi;
                let measure = self.density * self.domain.factor() * r * self.domain.weight(r) * 0.5 * (b - a) * w;
                nodes.extend((0..3).map(|k| (2 * e + k, measure * line::quadratic(xi)[k])));
            }
        }
        self.potential_row(&nodes)
    }

    /// Elevation η at r (or x); the sign follows the harmonic for negative r.
    pub fn elevation(&self, r: f64) -> Row {
        let (e, xi) = locate(&self.mesh.r, r.abs());
        let sign = match self.domain {
            Domain::Cylinder { harmonic, .. } if r < 0.0 && harmonic % 2 == 1 => -1.0,
            Domain::Strip { symmetric: false, .. } if r < 0.0 => -1.0,
            _ => 1.0,
        };
        let mut row = vec![0.0; self.columns()];
        for (k, n) in line::quadratic(xi).into_iter().enumerate() {
            if let Some(column) = self.surface[2 * e + k] {
                row[column] += sign * n;
            }
        }
        row
    }

    /// Rigid translation along x (m = 1, antisymmetric half): w = 1 at the wall, η = 0.
    pub fn rigid_translation(&self) -> Row {
        let mut row = vec![0.0; self.columns()];
        (0..self.trace.len()).for_each(|k| row[self.interpolation.width() * k] = 1.0);
        row
    }

    /// Load of the hydrostatic pressure on the trace: ∫ ρ g (H − z) N_w dA.
    pub fn hydrostatic_load(&self, gravity: f64) -> Row {
        let mut load = vec![0.0; self.columns()];
        let depth = self.trace[self.trace.len() - 1];
        let c = self.domain.factor() * self.domain.weight(self.domain.half_length());
        for k in 0..self.trace.len() - 1 {
            let (a, b) = (self.trace[k], self.trace[k + 1]);
            for &(xi, w) in gauss::THREE {
                let z = 0.5 * (a + b) + 0.5 * (b - a) * xi;
                let force = self.density * gravity * (depth - z) * c * 0.5 * (b - a) * w;
                for (i, n) in self.interpolation.functions(xi, b - a).into_iter().enumerate() {
                    load[self.interpolation.width() * k + i] += force * n;
                }
            }
        }
        load
    }

    /// Combination of rows of X: Σ weight × X(node, ·).
    fn potential_row(&self, nodes: &[(usize, f64)]) -> Row {
        (0..self.columns())
            .map(|j| {
                let column = self.potential.column(j);
                nodes.iter().map(|&(n, weight)| weight * column[n]).sum()
            })
            .collect()
    }

    /// Means of φ and of η over the surface, as rows of x.
    fn surface_means(&self) -> (Row, Row) {
        let top = (self.mesh.z.len() - 1) * self.mesh.r.len();
        let mut weights = vec![0.0; self.mesh.r.len()];
        let mut area = 0.0;
        for e in 0..self.mesh.elements().0 {
            let (a, b) = (self.mesh.r[2 * e], self.mesh.r[2 * e + 2]);
            for &(xi, w) in gauss::FOUR {
                let measure = self.domain.weight(0.5 * (a + b) + 0.5 * (b - a) * xi) * 0.5 * (b - a) * w;
                area += measure;
                for (k, n) in line::quadratic(xi).into_iter().enumerate() {
                    weights[2 * e + k] += measure * n;
                }
            }
        }
        weights.iter_mut().for_each(|w| *w /= area);
        let nodes: Vec<(usize, f64)> = weights.iter().enumerate().map(|(i, &w)| (top + i, w)).collect();
        let mut elevation = vec![0.0; self.columns()];
        for (column, w) in self.surface.iter().zip(&weights) {
            if let Some(column) = column {
                elevation[*column] += w;
            }
        }
        (self.potential_row(&nodes), elevation)
    }
}

/// Unknown of each node; nodes on the axis (m ≥ 1), or one node of a floating domain, are held at φ = 0.
fn number_nodes(domain: &Domain, mesh: &LiquidMesh) -> Vec<Option<usize>> {
    let mut next = 0;
    (0..mesh.nodes())
        .map(|n| {
            let held = if domain.is_floating() { n == 0 } else { n % mesh.r.len() == 0 };
            (!held).then(|| {
                next += 1;
                next - 1
            })
        })
        .collect()
}

/// H of the free nodes.
fn stiffness(domain: &Domain, mesh: &LiquidMesh, unknown: &[Option<usize>]) -> Triplets {
    let size = unknown.iter().flatten().count();
    let mut h = Triplets::new(size);
    let (na, nb) = mesh.elements();
    for b in 0..nb {
        for a in 0..na {
            let (half_r, half_z) =
                (0.5 * (mesh.r[2 * a + 2] - mesh.r[2 * a]), 0.5 * (mesh.z[2 * b + 2] - mesh.z[2 * b]));
            let mut local = [[0.0; 9]; 9];
            for &(xi, wx) in gauss::FOUR {
                let r = mesh.r[2 * a + 1] + half_r * xi;
                let (weight, angular) = (domain.factor() * domain.weight(r) * half_r * half_z, domain.angular(r));
                for &(eta, wy) in gauss::THREE {
                    let s = quad9::shape(xi, eta);
                    let measure = weight * wx * wy;
                    for (i, row) in local.iter_mut().enumerate() {
                        for (j, entry) in row.iter_mut().enumerate().take(i + 1) {
                            *entry += measure
                                * (s.dxi[i] * s.dxi[j] / (half_r * half_r)
                                    + s.deta[i] * s.deta[j] / (half_z * half_z)
                                    + angular * s.n[i] * s.n[j]);
                        }
                    }
                }
            }
            let nodes = mesh.element_nodes(a, b);
            for i in 0..9 {
                for j in 0..=i {
                    if let (Some(p), Some(q)) = (unknown[nodes[i]], unknown[nodes[j]]) {
                        h.add(p.max(q), p.min(q), local[i][j]);
                    }
                }
            }
        }
    }
    h
}

/// B, on the union of the partitions of liquid and trace.
fn couple_wall(domain: &Domain, mesh: &LiquidMesh, trace: &[f64], interpolation: Trace, f: &mut Matrix) {
    let depth = mesh.z[mesh.z.len() - 1];
    let mut cuts: Vec<f64> = mesh.z.iter().step_by(2).chain(trace).copied().collect();
    cuts.sort_by(f64::total_cmp);
    let c = domain.factor() * domain.weight(domain.half_length());
    let last = mesh.r.len() - 1;
    for pair in cuts.windows(2) {
        let (a, b) = (pair[0], pair[1].min(depth));
        if b - a <= 1e-12 * depth {
            continue;
        }
        let middle = 0.5 * (a + b);
        let (e, _) = locate(&mesh.z, middle);
        let k = (0..trace.len() - 2).find(|&k| middle < trace[k + 1]).unwrap_or(trace.len() - 2);
        let (z0, z1, t0, t1) = (mesh.z[2 * e], mesh.z[2 * e + 2], trace[k], trace[k + 1]);
        for &(xi, w) in gauss::THREE {
            let z = middle + 0.5 * (b - a) * xi;
            let shape = line::quadratic((2.0 * z - z0 - z1) / (z1 - z0));
            let wall = interpolation.functions((2.0 * z - t0 - t1) / (t1 - t0), t1 - t0);
            let measure = c * 0.5 * (b - a) * w;
            for (i, n) in shape.into_iter().enumerate() {
                let node = last + (2 * e + i) * mesh.r.len();
                for (j, v) in wall.iter().enumerate() {
                    f.add(node, interpolation.width() * k + j, measure * n * v);
                }
            }
        }
    }
}

/// −∫ N_i N_j r dr over the bottom, whose normal points downwards, on the union of the partitions of liquid and rings.
fn couple_floor(domain: &Domain, mesh: &LiquidMesh, floor: &[f64], first: usize, f: &mut Matrix) {
    for (ring, radii) in floor.windows(2).enumerate() {
        let [outer, inner] = [radii[0], radii[1]];
        let within = mesh.r.iter().step_by(2).copied().filter(|r| *r > inner && *r < outer);
        let mut cuts: Vec<f64> = within.chain([inner, outer]).collect();
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
            let (e, _) = locate(&mesh.r, middle);
            let (r0, r1) = (mesh.r[2 * e], mesh.r[2 * e + 2]);
            for &(xi, w) in gauss::THREE {
                let r = middle + half * xi;
                let shape = line::quadratic((2.0 * r - r0 - r1) / (r1 - r0));
                let at_inner = (outer - r) / (outer - inner);
                let measure = domain.factor() * domain.weight(r) * half * w;
                for (i, n) in shape.into_iter().enumerate() {
                    f.add(2 * e + i, first + ring, -measure * n * (1.0 - at_inner));
                    f.add(2 * e + i, first + ring + 1, -measure * n * at_inner);
                }
            }
        }
    }
}

/// S into F and on its own.
fn couple_surface(
    domain: &Domain,
    mesh: &LiquidMesh,
    surface: &[Option<usize>],
    f: &mut Matrix,
    surface_area: &mut Matrix,
) {
    let top = (mesh.z.len() - 1) * mesh.r.len();
    for e in 0..mesh.elements().0 {
        let half = 0.5 * (mesh.r[2 * e + 2] - mesh.r[2 * e]);
        for &(xi, w) in gauss::FOUR {
            let r = mesh.r[2 * e + 1] + half * xi;
            let measure = domain.factor() * domain.weight(r) * half * w;
            let shape = line::quadratic(xi);
            for i in 0..3 {
                for j in 0..3 {
                    if let Some(column) = surface[2 * e + j] {
                        f.add(top + 2 * e + i, column, measure * shape[i] * shape[j]);
                        if let Some(row) = surface[2 * e + i] {
                            surface_area.add(row, column, measure * shape[i] * shape[j]);
                        }
                    }
                }
            }
        }
    }
}

fn symmetrise(a: &mut Matrix) {
    for j in 0..a.cols {
        for i in 0..j {
            let mean = 0.5 * (a.get(i, j) + a.get(j, i));
            a.data[i + j * a.rows] = mean;
            a.data[j + i * a.rows] = mean;
        }
    }
}
