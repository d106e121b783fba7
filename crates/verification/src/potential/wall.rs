//! A wall of spatial elements with the harmonic liquid: K x = ω² M x and solves with K + s M, s = 1/(β Δt²) in direct
//! integration.
//!
//! ```text
//! x = (u, η)        w = R u  (normal displacement of the wetted nodes)
//! K + s M = ⎡ S + Rᵀ E_ww R   Rᵀ E_wη ⎤        S = K_s + s M_s  sparse,  E = K_f + s M_f  ([`Condensed`])
//!           ⎣ E_ηw R          E_ηη    ⎦
//! ```
//!
//! After the elevations are condensed there remains (S + Rᵀ A R) u = f with A dense. With C = R S⁻¹ Rᵀ,
//!
//! ```text
//! (S + RᵀAR)⁻¹ = S⁻¹ − S⁻¹Rᵀ [C⁻¹ − C⁻¹ (C⁻¹ + A)⁻¹ C⁻¹] R S⁻¹
//! In(S + RᵀAR) = In(S) + In(C⁻¹ + A) − In(C⁻¹)
//! ```
//!
//! (C⁻¹ is S condensed to the wetted normal displacements: eliminate the others first, and both lines are those of
//! Woodbury and of Haynsworth.) [`WallPencil`] works so: the sparse factor once, one solve with it a wetted node, then dense
//! factors of the size of the wetted nodes.
//!
//! [`WallSolver`] solves the same for s > 0 by conjugate gradients, preconditioned with the sparse factor of
//! S + Rᵀ diag(A) R, and never forms A. Costs: `docs/theory/potential-elements.md`, 6.

use std::sync::Arc;

use super::condensed::{Condensed, dense_factor};
use fem::linalg::{Factor, Kind, LinalgError, Matrix, Pencil, Shifted, Symbolic, Symmetric, dot};
use fem::liquid::HarmonicLiquid;

/// Row of R: (unknown of the wall, coefficient).
pub type NormalRow = Vec<(usize, f64)>;

/// The pencil of a wall with its liquid.
#[derive(Debug)]
pub struct WallPencil<'a> {
    stiffness: &'a Symmetric,
    mass: &'a Symmetric,
    symbolic: Arc<Symbolic>,
    normals: Vec<NormalRow>,
    liquid: &'a HarmonicLiquid,
}

impl<'a> WallPencil<'a> {
    /// Joins a wall (K_s, M_s on the pattern of `symbolic`) and its liquid.
    ///
    /// `normals[level * sectors + sector]`: outward normal displacement of each wetted node over the wall's unknowns; empty
    /// where it is held. No two rows may depend on each other.
    ///
    /// Panics if there is not one row a wetted node.
    pub fn new(
        stiffness: &'a Symmetric,
        mass: &'a Symmetric,
        symbolic: Arc<Symbolic>,
        normals: Vec<NormalRow>,
        liquid: &'a HarmonicLiquid,
    ) -> WallPencil<'a> {
        assert_eq!(normals.len(), liquid.wall(), "one row a wetted node");
        WallPencil { stiffness, mass, symbolic, normals, liquid }
    }

    /// Number of unknowns of the wall; the elevations follow.
    pub fn wall_size(&self) -> usize {
        self.stiffness.size()
    }

    /// w = R u.
    fn normal(&self, u: &[f64]) -> Vec<f64> {
        self.normals.iter().map(|row| row.iter().map(|&(e, c)| c * u[e]).sum()).collect()
    }

    /// u ← u + factor Rᵀ f.
    fn add_normal(&self, factor: f64, force: &[f64], u: &mut [f64]) {
        for (row, f) in self.normals.iter().zip(force) {
            for &(e, c) in row {
                u[e] += factor * c * f;
            }
        }
    }

    /// The sum of a wall matrix and a liquid operator times x.
    fn sum(&self, wall: &Symmetric, liquid: impl Fn(&Matrix) -> Matrix, x: &Matrix) -> Matrix {
        let n = self.wall_size();
        let mut out = Matrix::zeros(x.rows, x.cols);
        for j in 0..x.cols {
            let (u, eta) = x.column(j).split_at(n);
            let mut local = self.normal(u);
            local.extend_from_slice(eta);
            let force = liquid(&column(local)).data;
            let (own, surface) = out.column_mut(j).split_at_mut(n);
            wall.add_product(1.0, u, own);
            self.add_normal(1.0, &force[..self.normals.len()], own);
            surface.copy_from_slice(&force[self.normals.len()..]);
        }
        out
    }

    fn effective(&self, s: f64) -> Symmetric {
        let mut sum = self.stiffness.clone();
        sum.add(s, self.mass);
        sum
    }
}

fn column(data: Vec<f64>) -> Matrix {
    Matrix { rows: data.len(), cols: 1, data }
}

impl Pencil for WallPencil<'_> {
    fn size(&self) -> usize {
        self.wall_size() + self.liquid.elevations()
    }

    fn stiffness(&self, x: &Matrix) -> Matrix {
        self.sum(self.stiffness, |local| self.liquid.stiffness(local), x)
    }

    fn stiffness_terms(&self, x: &[f64]) -> Vec<f64> {
        let (u, eta) = x.split_at(self.wall_size());
        let mut out = self.stiffness.terms(u);
        let mut local = vec![0.0; self.normals.len()];
        local.extend_from_slice(eta);
        let own = self.liquid.stiffness(&column(local)).data;
        out.extend(own[self.normals.len()..].iter().map(|v| v.abs()));
        out
    }

    fn mass(&self, x: &Matrix) -> Result<Matrix, LinalgError> {
        Ok(self.sum(self.mass, |local| self.liquid.mass(local), x))
    }

    fn shifted(&self, s: f64) -> Result<Box<dyn Shifted + '_>, LinalgError> {
        Ok(Box::new(DenseWet::new(self, s)?))
    }
}

/// K + s M by the dense block of the wetted nodes.
struct DenseWet<'a> {
    pencil: &'a WallPencil<'a>,
    condensed: Condensed<'a>,
    wall: Factor,
    /// Wetted nodes whose normal displacement is free.
    free: Vec<usize>,
    flexibility: Factor,
    /// Factor of C⁻¹ + A.
    joined: Factor,
}

impl<'a> DenseWet<'a> {
    fn new(pencil: &'a WallPencil<'a>, s: f64) -> Result<DenseWet<'a>, LinalgError> {
        let kind = if s >= 0.0 { Kind::Definite } else { Kind::Indefinite };
        let wall = pencil.symbolic.factor(&pencil.effective(s), kind)?;
        let condensed = Condensed::new(pencil.liquid, s)?;
        let free: Vec<usize> = (0..pencil.normals.len()).filter(|&i| !pencil.normals[i].is_empty()).collect();
        let size = free.len();
        let mut c = Matrix::zeros(size, size);
        // In blocks: solves with many right-hand sides are cheaper, but all at once needs too much memory.
        for block in free.chunks(32) {
            let first = free.binary_search(&block[0]).expect("a chunk of the list");
            let mut right = Matrix::zeros(pencil.wall_size(), block.len());
            for (k, &i) in block.iter().enumerate() {
                for &(e, v) in &pencil.normals[i] {
                    right.column_mut(k)[e] += v;
                }
            }
            wall.solve(&mut right)?;
            for k in 0..block.len() {
                let w = pencil.normal(right.column(k));
                for (entry, &i) in c.column_mut(first + k).iter_mut().zip(&free) {
                    *entry = w[i];
                }
            }
        }
        let flexibility = dense_factor(&c)?;
        let mut joined = Matrix::zeros(size, size);
        (0..size).for_each(|i| joined.add(i, i, 1.0));
        flexibility.solve(&mut joined)?;
        let a = condensed.matrix();
        for j in 0..size {
            for i in 0..size {
                joined.add(i, j, a.get(free[i], free[j]));
            }
        }
        Ok(DenseWet { pencil, condensed, wall, free, flexibility, joined: dense_factor(&joined)? })
    }

    /// b ← (S + RᵀAR)⁻¹ b.
    fn solve_wall(&self, b: &mut [f64]) -> Result<(), LinalgError> {
        let solved = self.wall.solve_vector(b)?;
        let w = self.pencil.normal(&solved);
        let own: Vec<f64> = self.free.iter().map(|&i| w[i]).collect();
        let y = self.flexibility.solve_vector(&own)?;
        let z = self.flexibility.solve_vector(&self.joined.solve_vector(&y)?)?;
        let mut force = vec![0.0; self.pencil.normals.len()];
        for (k, &i) in self.free.iter().enumerate() {
            force[i] = y[k] - z[k];
        }
        self.pencil.add_normal(-1.0, &force, b);
        b.copy_from_slice(&self.wall.solve_vector(b)?);
        Ok(())
    }
}

impl Shifted for DenseWet<'_> {
    fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        let n = self.pencil.wall_size();
        let still = vec![0.0; self.pencil.normals.len()];
        for j in 0..b.cols {
            let (own, surface) = b.column_mut(j).split_at_mut(n);
            let free_surface = self.condensed.elevations(&still, surface)?;
            self.pencil.add_normal(-1.0, &self.condensed.wall_forces(&free_surface), own);
            self.solve_wall(own)?;
            surface.copy_from_slice(&self.condensed.elevations(&self.pencil.normal(own), surface)?);
        }
        Ok(())
    }

    fn below(&self) -> usize {
        let negative = |f: &Factor| f.inertia().negative;
        self.condensed.negative() + negative(&self.wall) + negative(&self.joined) - negative(&self.flexibility)
    }
}

/// K + s M, s > 0, by conjugate gradients.
#[derive(Debug)]
pub struct WallSolver<'a> {
    pencil: &'a WallPencil<'a>,
    condensed: Condensed<'a>,
    matrix: Symmetric,
    preconditioner: Factor,
    tolerance: f64,
}

/// Iterations after which the solver gives up.
const ITERATIONS: usize = 1000;

impl<'a> WallSolver<'a> {
    /// Prepares solves to ‖residual‖ ≤ `tolerance` ‖right-hand side‖, both in the norm of the preconditioner.
    ///
    /// Errors: S not positive definite.
    pub fn new(pencil: &'a WallPencil<'a>, s: f64, tolerance: f64) -> Result<WallSolver<'a>, LinalgError> {
        let condensed = Condensed::new(pencil.liquid, s)?;
        let matrix = pencil.effective(s);
        let mut near = matrix.clone();
        let a = condensed.matrix();
        for (i, row) in pencil.normals.iter().enumerate() {
            for &(e, v) in row {
                for &(f, u) in row.iter().filter(|&&(f, _)| f <= e) {
                    if let Some(place) = near.pattern.place(e, f) {
                        near.values[place] += a.get(i, i) * v * u;
                    }
                }
            }
        }
        let preconditioner = pencil.symbolic.factor(&near, Kind::Definite)?;
        Ok(WallSolver { pencil, condensed, matrix, preconditioner, tolerance })
    }

    fn times(&self, u: &[f64]) -> Vec<f64> {
        let mut out = self.matrix.times(u);
        let force = self.condensed.times(&self.pencil.normal(u));
        self.pencil.add_normal(1.0, &force, &mut out);
        out
    }

    /// (K + s M)⁻¹ b, starting from `guess` (the last step's solution), and the number of iterations.
    ///
    /// Errors: no convergence.
    pub fn solve(&self, b: &[f64], guess: &[f64]) -> Result<(Vec<f64>, usize), LinalgError> {
        let n = self.pencil.wall_size();
        let (own, surface) = b.split_at(n);
        let still = vec![0.0; self.pencil.normals.len()];
        let mut r = own.to_vec();
        let free_surface = self.condensed.elevations(&still, surface)?;
        self.pencil.add_normal(-1.0, &self.condensed.wall_forces(&free_surface), &mut r);
        let size = dot(&r, &self.preconditioner.solve_vector(&r)?);
        let mut x = guess[..n].to_vec();
        for (r, a) in r.iter_mut().zip(self.times(&x)) {
            *r -= a;
        }
        let mut z = self.preconditioner.solve_vector(&r)?;
        let mut p = z.clone();
        let mut rz = dot(&r, &z);
        let mut iterations = 0;
        while rz > self.tolerance * self.tolerance * size {
            if iterations == ITERATIONS {
                let residual = (rz / size).sqrt();
                return Err(LinalgError::Iteration { iterations, residual, allowed: self.tolerance });
            }
            let ap = self.times(&p);
            let step = rz / dot(&p, &ap);
            for i in 0..n {
                x[i] += step * p[i];
                r[i] -= step * ap[i];
            }
            z = self.preconditioner.solve_vector(&r)?;
            let next = dot(&r, &z);
            for (p, z) in p.iter_mut().zip(&z) {
                *p = z + next / rz * *p;
            }
            rz = next;
            iterations += 1;
        }
        let eta = self.condensed.elevations(&self.pencil.normal(&x), surface)?;
        x.extend(eta);
        Ok((x, iterations))
    }
}
