//! E(s) = K_f + s M_f of the harmonic liquid with its elevations condensed, for solves with a wall:
//!
//! ```text
//! A(s) = E_ww − E_wη E_ηη⁻¹ E_ηw          η = E_ηη⁻¹ (h − E_ηw w)
//! ```
//!
//! harmonic by harmonic; A is block-circulant like M_f.

use std::sync::Arc;

use fem::linalg::{
    Factor, Kind, LinalgError, Matrix, Ordering, Pattern, Symbolic, Symmetric, product, transposed_product,
};
use fem::liquid::{Block, HarmonicLiquid};

/// A(s) and the factors of E_ηη.
#[derive(Debug)]
pub struct Condensed<'a> {
    liquid: &'a HarmonicLiquid,
    /// A of each harmonic.
    wall: Vec<Matrix>,
    /// E_ηw and the factor of E_ηη of each harmonic with elevations.
    surface: Vec<Option<(Matrix, Factor)>>,
}

impl<'a> Condensed<'a> {
    /// Condenses K_f + s M_f.
    ///
    /// Errors: E_ηη singular, that is −s an eigenvalue ω² of the liquid in a rigid tank.
    pub fn new(liquid: &'a HarmonicLiquid, s: f64) -> Result<Condensed<'a>, LinalgError> {
        let levels = liquid.levels();
        let (mut wall, mut surface) = (Vec::new(), Vec::new());
        for block in liquid.blocks() {
            let mut e = block.mass.clone();
            for (v, k) in e.data.iter_mut().zip(&block.stiffness.data) {
                *v = s * *v + k;
            }
            let (w, eta): (Vec<usize>, Vec<usize>) = ((0..levels).collect(), (levels..e.rows).collect());
            let mut a = e.select(&w, &w);
            if eta.is_empty() {
                surface.push(None);
            } else {
                let coupling = e.select(&eta, &w);
                let factor = dense_factor(&e.select(&eta, &eta))?;
                let mut follow = coupling.clone();
                factor.solve(&mut follow)?;
                let part = transposed_product(&coupling, &follow);
                for (v, p) in a.data.iter_mut().zip(&part.data) {
                    *v -= p;
                }
                surface.push(Some((coupling, factor)));
            }
            wall.push(a);
        }
        Ok(Condensed { liquid, wall, surface })
    }

    /// Number of negative eigenvalues of E_ηη.
    pub fn negative(&self) -> usize {
        let count = |(block, surface): (&Block, &Option<(Matrix, Factor)>)| {
            surface.as_ref().map_or(0, |(_, f)| f.inertia().negative * block.columns.len())
        };
        self.liquid.blocks().iter().zip(&self.surface).map(count).sum()
    }

    /// A as a matrix over all wall nodes.
    pub fn matrix(&self) -> Matrix {
        let liquid = self.liquid;
        let (levels, n) = (liquid.levels(), liquid.sectors());
        let mut out = Matrix::zeros(liquid.wall(), liquid.wall());
        for l in 0..levels {
            for p in 0..levels {
                // Circulant: the first row defines it.
                let mut row = vec![0.0; n];
                for (block, a) in liquid.blocks().iter().zip(&self.wall) {
                    for &(column, _) in &block.columns {
                        let value = liquid.fourier().get(0, column) * a.get(l, p);
                        for (k, v) in row.iter_mut().enumerate() {
                            *v += value * liquid.fourier().get(k, column);
                        }
                    }
                }
                for k in 0..n {
                    for q in 0..n {
                        out.add(l * n + k, p * n + q, row[(q + n - k) % n]);
                    }
                }
            }
        }
        out
    }

    /// A w, without forming the matrix.
    pub fn times(&self, w: &[f64]) -> Vec<f64> {
        let liquid = self.liquid;
        let levels = liquid.levels();
        let waves = transposed_product(liquid.fourier(), &rows_of(liquid, w));
        let mut image = Matrix::zeros(liquid.sectors(), levels);
        for (block, a) in liquid.blocks().iter().zip(&self.wall) {
            for &(column, _) in &block.columns {
                let local: Vec<f64> = (0..levels).map(|l| waves.get(column, l)).collect();
                for (l, force) in a.times(&local).into_iter().enumerate() {
                    image.add(column, l, force);
                }
            }
        }
        product(liquid.fourier(), &image).data
    }

    /// η = E_ηη⁻¹ (h − E_ηw w).
    ///
    /// Errors: not enough memory.
    pub fn elevations(&self, w: &[f64], h: &[f64]) -> Result<Vec<f64>, LinalgError> {
        let liquid = self.liquid;
        let levels = liquid.levels();
        let waves = transposed_product(liquid.fourier(), &rows_of(liquid, w));
        let mut eta = vec![0.0; liquid.elevations()];
        for (block, surface) in liquid.blocks().iter().zip(&self.surface) {
            let Some((coupling, factor)) = surface else { continue };
            for &(column, first) in &block.columns {
                let local: Vec<f64> = (0..levels).map(|l| waves.get(column, l)).collect();
                let mut right = coupling.times(&local);
                for (v, h) in right.iter_mut().zip(&h[first..]) {
                    *v = h - *v;
                }
                let found = factor.solve_vector(&right)?;
                eta[first..first + found.len()].copy_from_slice(&found);
            }
        }
        Ok(eta)
    }

    /// E_wη η: the wall forces of elevations.
    pub fn wall_forces(&self, eta: &[f64]) -> Vec<f64> {
        let liquid = self.liquid;
        let levels = liquid.levels();
        let mut image = Matrix::zeros(liquid.sectors(), levels);
        for (block, surface) in liquid.blocks().iter().zip(&self.surface) {
            let Some((coupling, factor)) = surface else { continue };
            for &(column, first) in &block.columns {
                let force = coupling.transposed_times(&eta[first..first + factor.size()]);
                for (l, f) in force.into_iter().enumerate() {
                    image.add(column, l, f);
                }
            }
        }
        product(liquid.fourier(), &image).data
    }
}

/// Factor of a dense symmetric matrix of any inertia.
pub(super) fn dense_factor(a: &Matrix) -> Result<Factor, LinalgError> {
    let all: Vec<usize> = (0..a.rows).collect();
    let pattern = Arc::new(Pattern::from_cliques(a.rows, std::iter::once(all.as_slice())));
    let mut sparse = Symmetric::zeros(pattern.clone());
    let mut next = 0;
    for j in 0..a.rows {
        for i in j..a.rows {
            sparse.values[next] = a.get(i, j);
            next += 1;
        }
    }
    Arc::new(Symbolic::new(pattern, &Ordering::Given(all))?).factor(&sparse, Kind::Indefinite)
}

/// Values at the nodes of the wall as sectors × levels.
fn rows_of(liquid: &HarmonicLiquid, w: &[f64]) -> Matrix {
    Matrix { rows: liquid.sectors(), cols: liquid.levels(), data: w.to_vec() }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use fem::linalg::dot;
    use fem::liquid::LiquidMesh;

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

    /// A breathing wall lifts the surface by the displaced volume: 2πR H w = πR² η in the mean, stiffness ρ g (2πRHw)²/(πR²)
    /// when the elevation is that mean everywhere.
    #[test]
    fn breathing_keeps_the_volume() {
        let liquid = liquid(1);
        let x = vector(&liquid, |_, _| 1.0);
        let condensed = Condensed::new(&liquid, 0.0).unwrap();
        let w = &x.data[..liquid.wall()];
        let stiffness = dot(w, &condensed.times(w));
        let exact = 9810.0 * (TAU * RADIUS * DEPTH).powi(2) / (PI * RADIUS * RADIUS);
        assert!((stiffness / exact - 1.0).abs() < 1e-9, "{stiffness} {exact}");
    }

    /// The operator, its matrix and the condensation agree, and the matrix is symmetric.
    #[test]
    fn condensed_forms_agree() {
        let liquid = liquid(2);
        let s = 40.0;
        let condensed = Condensed::new(&liquid, s).unwrap();
        let a = condensed.matrix();
        let w: Vec<f64> = (0..liquid.wall()).map(|i| ((i * 7 % 13) as f64 - 6.0) / 6.0).collect();
        let times = condensed.times(&w);
        let scale = times.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for (x, y) in a.times(&w).iter().zip(&times) {
            assert!((x - y).abs() < 1e-11 * scale);
        }
        // (K + s M)(w, η) with the η that follows from no force on the surface.
        let eta = condensed.elevations(&w, &vec![0.0; liquid.elevations()]).unwrap();
        let mut x = w.clone();
        x.extend(&eta);
        let n = x.len();
        let x = Matrix { rows: n, cols: 1, data: x };
        let (k, m) = (liquid.stiffness(&x), liquid.mass(&x));
        for i in 0..n {
            let force = k.data[i] + s * m.data[i];
            let expected = times.get(i).copied().unwrap_or(0.0);
            assert!((force - expected).abs() < 1e-10 * scale, "{i}: {force} {expected}");
        }
        for i in 0..a.rows {
            for j in 0..i {
                assert!((a.get(i, j) - a.get(j, i)).abs() < 1e-12 * scale);
            }
        }
    }
}
