//! The liquid of an upright cylinder as added mass of a wall of spatial elements.
//!
//! The wall has its nodes on N equally spaced meridians. The normal displacement w of the wetted nodes is taken apart into
//! the N orthonormal trigonometric functions of θ that the meridians can resolve; each harmonic m is a meridional
//! section ([`Potential`]):
//!
//! ```text
//! w_k = Σ_c F_kc ŵ_c ,   F_kc = √(2/N) cos mθ_k or √(2/N) sin mθ_k (√(1/N) for m = 0 and m = N/2)
//! M_f = (F ⊗ 1) diag(M^(m)) (F ⊗ 1)ᵀ        K_f = diag(ρ g S^(m)) on the elevations
//! ```
//!
//! so that the added mass is block-circulant. Between the meridians the displacement is the trigonometric interpolant: a
//! rigid translation carries the exact liquid mass on every mesh, ιᵀ M_f ι = ρ π R² H, and a breathing wall displaces the
//! exact volume. Along z it is linear between the wall's levels. Rings of a bottom that moves ([`HarmonicLiquid::with_floor`]) follow the levels
//! of the wall as further levels, their displacement upwards.
//!
//! The elevations of the harmonics up to `sloshing` are unknowns; above, the surface is free of pressure (M^(m) with η
//! condensed at φ = 0 on the surface): the neglected term is gravity's, of order g m/(R ω²).
//!
//! For m = 0 the volume is kept by eliminating one elevation, x = T x': K_f then couples wall and elevations.
//!
//! F is applied as a dense N × N matrix: 4 N² L operations for L levels, next to 2 N L² of the products with M^(m). A fast
//! Fourier transform, not tried, may pay where N is much larger than L.

use std::f64::consts::TAU;

use super::{Domain, LiquidMesh, Potential, Trace};
use crate::linalg::{Cholesky, LinalgError, Matrix, product, transposed_product};

/// Liquid whose wall displacement is given at nodes on equally spaced meridians.
#[derive(Clone, Debug)]
pub struct HarmonicLiquid {
    pub(super) sectors: usize,
    pub(super) heights: Vec<f64>,
    /// Radii of the rings of the bottom [m], falling.
    pub(super) floor: Vec<f64>,
    /// F.
    pub(super) fourier: Matrix,
    pub(super) blocks: Vec<Block>,
    elevations: usize,
}

/// One harmonic.
#[derive(Clone, Debug)]
pub struct Block {
    /// Its columns of F: cos, and sin unless m = 0 or N/2; with the first of its elevations among all.
    pub columns: Vec<(usize, usize)>,
    /// M^(m) over (ŵ at the levels, elevations that are unknowns).
    pub mass: Matrix,
    /// K^(m) over the same.
    pub stiffness: Matrix,
    /// Elevation at the wall over the same unknowns; `None` if the elevations are condensed.
    pub rim: Option<Vec<f64>>,
}

impl Block {
    pub(crate) fn elevations(&self, levels: usize) -> usize {
        self.mass.rows - levels
    }
}

impl HarmonicLiquid {
    /// Assembles and condenses all harmonics that `sectors` meridians can resolve.
    ///
    /// * `radius` R [m], `density` ρ [kg/m³], `gravity` g [m/s²]
    /// * `heights`: levels of the wetted wall nodes, from 0 to the surface [m]
    /// * `mesh`: of the meridional section
    /// * `sloshing`: highest harmonic whose elevations are unknowns
    ///
    /// Errors: a singular liquid matrix (degenerate mesh).
    ///
    /// Panics if there are fewer than 3 sectors or 2 levels.
    pub fn new(
        radius: f64,
        density: f64,
        gravity: f64,
        sectors: usize,
        heights: &[f64],
        mesh: &LiquidMesh,
        sloshing: u32,
    ) -> Result<HarmonicLiquid, LinalgError> {
        HarmonicLiquid::with_floor([radius, density, gravity], sectors, [heights, &[]], mesh, sloshing)
    }

    /// The same over a bottom that moves between its rings and rests elsewhere.
    ///
    /// * `floor`: radii of the rings [m], falling
    ///
    /// Errors, panics: as [`HarmonicLiquid::new`].
    pub fn with_floor(
        [radius, density, gravity]: [f64; 3],
        sectors: usize,
        [heights, floor]: [&[f64]; 2],
        mesh: &LiquidMesh,
        sloshing: u32,
    ) -> Result<HarmonicLiquid, LinalgError> {
        let levels = heights.len() + floor.len();
        assert!(sectors >= 3 && heights.len() >= 2, "a wall has 3 or more meridians and 2 or more levels");
        let mut fourier = Matrix::zeros(sectors, sectors);
        let mut blocks = Vec::new();
        let (mut column, mut elevations) = (0, 0);
        for m in 0..=sectors / 2 {
            let single = m == 0 || 2 * m == sectors;
            let square = if single { 1.0 } else { 2.0 } / sectors as f64;
            let domain = Domain::Cylinder { radius, harmonic: m as u32 };
            let wall = (heights.to_vec(), Trace::Linear);
            let potential = Potential::with_floor(domain, mesh.clone(), wall, floor, density)?;
            let (mut mass, mut stiffness, rim) = matrices(&potential, gravity, m as u32 <= sloshing)?;
            mass.data.iter_mut().chain(&mut stiffness.data).for_each(|v| *v *= square);
            let mut block = Block { columns: Vec::new(), mass, stiffness, rim };
            for part in 0..if single { 1 } else { 2 } {
                for k in 0..sectors {
                    let angle = TAU * ((m * k) % sectors) as f64 / sectors as f64;
                    let value = if part == 0 { angle.cos() } else { angle.sin() };
                    fourier.add(k, column, square.sqrt() * value);
                }
                block.columns.push((column, elevations));
                elevations += block.elevations(levels);
                column += 1;
            }
            blocks.push(block);
        }
        Ok(HarmonicLiquid { sectors, heights: heights.to_vec(), floor: floor.to_vec(), fourier, blocks, elevations })
    }

    /// Number of meridians.
    pub fn sectors(&self) -> usize {
        self.sectors
    }

    /// Levels of the wetted wall nodes [m].
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Number of levels of the wall and of rings of the bottom, which follow them.
    pub fn levels(&self) -> usize {
        self.heights.len() + self.floor.len()
    }

    /// F.
    pub fn fourier(&self) -> &Matrix {
        &self.fourier
    }

    /// The harmonics.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Number of nodes of wall and bottom; node (level, sector) has the index `level * sectors + sector`.
    pub fn wall(&self) -> usize {
        self.sectors * self.levels()
    }

    /// Number of elevations.
    pub fn elevations(&self) -> usize {
        self.elevations
    }

    /// M_f x for x = (w, elevations), column by column.
    pub fn mass(&self, x: &Matrix) -> Matrix {
        self.apply(x, |b| &b.mass)
    }

    /// K_f x for x = (w, elevations), column by column.
    pub fn stiffness(&self, x: &Matrix) -> Matrix {
        self.apply(x, |b| &b.stiffness)
    }

    fn apply(&self, x: &Matrix, of: impl Fn(&Block) -> &Matrix) -> Matrix {
        let levels = self.levels();
        let mut out = Matrix::zeros(x.rows, x.cols);
        for j in 0..x.cols {
            // Node (level, sector) is entry (sector, level) of a sectors × levels matrix.
            let (wall, eta) = x.column(j).split_at(self.wall());
            let waves = transposed_product(&self.fourier, &matrix(self.sectors, levels, wall));
            let mut image = Matrix::zeros(self.sectors, levels);
            for block in &self.blocks {
                let n = block.elevations(levels);
                let mut local = Matrix::zeros(levels + n, block.columns.len());
                for (k, &(column, first)) in block.columns.iter().enumerate() {
                    let entries = local.column_mut(k);
                    for l in 0..levels {
                        entries[l] = waves.get(column, l);
                    }
                    entries[levels..].copy_from_slice(&eta[first..first + n]);
                }
                let force = product(of(block), &local);
                for (k, &(column, first)) in block.columns.iter().enumerate() {
                    for l in 0..levels {
                        image.add(column, l, force.get(l, k));
                    }
                    let start = self.wall() + first;
                    out.column_mut(j)[start..start + n].copy_from_slice(&force.column(k)[levels..]);
                }
            }
            let back = product(&self.fourier, &image);
            out.column_mut(j)[..self.wall()].copy_from_slice(&back.data);
        }
        out
    }
}

/// M, K and the elevation at the wall over (w, elevations) of one harmonic, elevations condensed unless they are unknowns.
fn matrices(
    potential: &Potential,
    gravity: f64,
    sloshing: bool,
) -> Result<(Matrix, Matrix, Option<Vec<f64>>), LinalgError> {
    let weight = potential.density * gravity;
    let mut mass = potential.mass.clone();
    let mut stiffness = potential.surface_area.clone();
    stiffness.data.iter_mut().for_each(|v| *v *= weight);
    let surface = potential.surface_columns();
    let wall: Vec<usize> = (0..surface.start).collect();
    let mut rim = vec![0.0; surface.end];
    if let Some(Some(column)) = potential.surface.last() {
        rim[*column] = 1.0;
    }
    if potential.domain.is_floating() {
        let q = &potential.flux;
        let last = surface.clone().max_by(|&a, &b| q[a].abs().total_cmp(&q[b].abs())).expect("the surface has nodes");
        let keep: Vec<usize> = (0..surface.end).filter(|&i| i != last).collect();
        let mut t = Matrix::zeros(surface.end, keep.len());
        for (j, &i) in keep.iter().enumerate() {
            t.add(i, j, 1.0);
            t.add(last, j, -q[i] / q[last]);
        }
        mass = transposed_product(&t, &product(&mass, &t));
        stiffness = transposed_product(&t, &product(&stiffness, &t));
        rim = (0..t.cols).map(|j| crate::linalg::dot(&rim, t.column(j))).collect();
    }
    if sloshing {
        return Ok((mass, stiffness, Some(rim)));
    }
    let free: Vec<usize> = (surface.start..mass.rows).collect();
    let coupling = mass.select(&free, &wall);
    let mut follow = coupling.clone();
    Cholesky::factor(&mass.select(&free, &free))?.solve(&mut follow);
    let part = transposed_product(&coupling, &follow);
    let mut added = mass.select(&wall, &wall);
    added.data.iter_mut().zip(&part.data).for_each(|(v, p)| *v -= p);
    Ok((added, Matrix::zeros(wall.len(), wall.len()), None))
}

fn matrix(rows: usize, cols: usize, data: &[f64]) -> Matrix {
    Matrix { rows, cols, data: data.to_vec() }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::linalg::dot;

    const RADIUS: f64 = 1.83;
    const DEPTH: f64 = 1.525;
    const SECTORS: usize = 9;

    fn liquid(sloshing: u32) -> HarmonicLiquid {
        let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
        let heights: Vec<f64> = [0.0, 0.1, 0.4, 1.0, 1.525].to_vec();
        HarmonicLiquid::new(RADIUS, 1000.0, 9.81, SECTORS, &heights, &mesh, sloshing).unwrap()
    }

    fn vector(liquid: &HarmonicLiquid, w: impl Fn(f64, usize) -> f64) -> Matrix {
        let mut x: Vec<f64> = Vec::new();
        for (l, _) in liquid.heights().iter().enumerate() {
            x.extend((0..SECTORS).map(|k| w(TAU * k as f64 / SECTORS as f64, l)));
        }
        x.resize(liquid.wall() + liquid.elevations(), 0.0);
        Matrix { rows: x.len(), cols: 1, data: x }
    }

    /// F6 on any mesh: a translation in any direction carries the mass of the liquid. (φ = x is in the space; 10⁻⁹ as the
    /// sheet asks.)
    #[test]
    fn translation_carries_the_liquid() {
        let liquid = liquid(1);
        let exact = 1000.0 * PI * RADIUS * RADIUS * DEPTH;
        for direction in [0.0, 0.7] {
            let x = vector(&liquid, |theta, _| (theta - direction).cos());
            let mass = dot(&x.data, &liquid.mass(&x).data);
            assert!((mass / exact - 1.0).abs() < 1e-9, "{mass} {exact}");
        }
    }

    /// A bottom that rises as a whole lifts all of the liquid, if the surface rises with it: φ = z is in the space.
    #[test]
    fn a_rising_bottom_lifts_the_liquid() {
        let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
        let domain = Domain::Cylinder { radius: RADIUS, harmonic: 0 };
        let wall = (vec![0.0, 0.4, DEPTH], Trace::Linear);
        let potential = Potential::with_floor(domain, mesh, wall, &[RADIUS, 1.1, 0.3, 0.0], 1000.0).unwrap();
        let mut x = vec![1.0; potential.columns()];
        x[..3].fill(0.0);
        let mass = dot(&x, &potential.mass.times(&x));
        let exact = 1000.0 * PI * RADIUS * RADIUS * DEPTH;
        assert!((mass / exact - 1.0).abs() < 1e-9, "{mass} {exact}");
        assert!(dot(&x, &potential.flux).abs() < 1e-12 * exact);
    }

    /// A bottom that turns, u_z = r cos θ, and the moment of the bottom pressure are reciprocal: the force on the rings under motions of wall and
    /// surface is that moment, turned about. Both are exact integrals of the same potential.
    #[test]
    fn a_turning_bottom_feels_the_moment_of_the_pressure() {
        let mesh = LiquidMesh::graded(RADIUS, DEPTH, 1.0);
        let domain = Domain::Cylinder { radius: RADIUS, harmonic: 1 };
        let floor = [RADIUS, 1.5, 0.8, 0.0];
        let wall = || (vec![0.0, 0.4, DEPTH], Trace::Linear);
        let moving = Potential::with_floor(domain, mesh.clone(), wall(), &floor, 1000.0).unwrap();
        let rigid = Potential::with_floor(domain, mesh, wall(), &[], 1000.0).unwrap();
        let moment = rigid.bottom_moment();
        let largest = moment.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for (i, expected) in moment.iter().enumerate() {
            // Wall first, then the surface, which follows the rings.
            let j = if i < 3 { i } else { i + floor.len() };
            let found: f64 = (0..floor.len()).map(|k| floor[k] * moving.mass.get(3 + k, j)).sum();
            assert!((found + expected).abs() < 1e-9 * largest, "{i}: {found} {expected}");
        }
    }
}
