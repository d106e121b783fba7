//! Load-dependent Ritz vectors: the space that a load excites, orthonormal in M.
//!
//! ```text
//! x₁ = (K + s M)⁻¹ f      x_{k+1} = (K + s M)⁻¹ M x_k      each orthogonalised to all before, xᵢᵀ M x_j = δ_ij
//! ```
//!
//! for one pole s after the other. With s = 0 this is the Krylov space of K⁻¹ M with the static response to the load as
//! its first vector: static response exact, the modes that the load excites converge from the lowest up, those it does
//! not excite never appear. A displacement liquid has hundreds of rotational modes between the sloshing and the wall's
//! modes, which the load hardly excites; a pole s = ω² leaps over them. Source: Wilson, Yuan & Dickens 1982; Ruhe 1984.
//!
//! A cyclic mesh keeps the symmetry of its load; `purify` removes from every vector the rounding in other symmetries.

use fem::linalg::{Matrix, dot, transposed_product};
use fem::progress::Progress;

use super::system::{System, columns};
use crate::FeError;

/// A vector of which orthogonalisation leaves less than this part (in the norm of M) lies in the space already.
const EXHAUSTED: f64 = 1e-8;
/// Largest share of an older vector that may be left in a new one: more is rounding of an exhausted space, and the Gram
/// matrix becomes indefinite.
const OVERLAP: f64 = 1e-6;

/// A vector and M times it.
type WithImage = (Vec<f64>, Vec<f64>);

/// The reduced system.
pub(super) struct Ritz {
    /// Basis over all unknowns, potentials included, column by column.
    pub basis: Matrix,
    /// Vᵀ M V.
    pub mass: Matrix,
    /// Vᵀ K V.
    pub stiffness: Matrix,
}

/// At most `count` Ritz vectors of `system`, the same number for each pole with its load.
///
/// Errors: not enough memory; loads of zero.
pub(super) fn reduce(
    system: &System,
    loads: &[(usize, &[f64])],
    count: usize,
    purify: &dyn Fn(&mut [f64]),
    progress: &dyn Progress,
) -> Result<Ritz, FeError> {
    let mut space = Growing::new(system);
    for (k, load) in loads.iter().enumerate() {
        let most = (k + 1) * count / loads.len();
        space.grow_at(*load, most, purify, progress)?;
    }
    space.finish()
}

/// A basis under way.
pub(super) struct Growing<'a> {
    system: &'a System,
    basis: Vec<Vec<f64>>,
    /// M times them.
    images: Vec<Vec<f64>>,
    /// Whether φ of every vector is solved for once more after orthogonalisation. The difference of nearly parallel vectors magnifies the
    /// error of φ from vector to vector, xᵢᵀ M x_j and x_jᵀ M xᵢ differ, and after thirty vectors a new one counts as exhausted. Then
    /// the modes of one harmonic have long converged, but the next harmonic has none.
    renewed: bool,
}

impl<'a> Growing<'a> {
    /// Without a vector.
    pub(super) fn new(system: &'a System) -> Growing<'a> {
        Growing { system, basis: Vec::new(), images: Vec::new(), renewed: false }
    }

    /// Without a vector, for more than one harmonic: φ is solved for once more after orthogonalisation.
    pub(super) fn renewed(system: &'a System) -> Growing<'a> {
        Growing { renewed: true, ..Growing::new(system) }
    }

    /// Number of vectors.
    pub(super) fn len(&self) -> usize {
        self.basis.len()
    }

    /// The first vector.
    pub(super) fn first(&self) -> Option<&[f64]> {
        self.basis.first().map(Vec::as_slice)
    }

    /// Adds at most `count` vectors for the load `load`.
    ///
    /// Errors: not enough memory.
    pub(super) fn grow(
        &mut self,
        load: &[f64],
        count: usize,
        purify: &dyn Fn(&mut [f64]),
        progress: &dyn Progress,
    ) -> Result<(), FeError> {
        let before = self.basis.len();
        for pole in 0..self.system.poles() {
            let most = before + (pole + 1) * count / self.system.poles();
            self.grow_at((pole, load), most, purify, progress)?;
        }
        Ok(())
    }

    /// Grows to at most `most` vectors with the load at a pole.
    ///
    /// Errors: not enough memory.
    fn grow_at(
        &mut self,
        (pole, load): (usize, &[f64]),
        most: usize,
        purify: &dyn Fn(&mut [f64]),
        progress: &dyn Progress,
    ) -> Result<(), FeError> {
        let mut right = load.to_vec();
        while self.basis.len() < most {
            let mut x = self.system.solve_at(pole, &right)?;
            purify(&mut x);
            self.system.complete(&mut x)?;
            let Some((x, image)) = self.orthogonal(x)? else { break };
            right.clone_from(&image);
            self.basis.push(x);
            self.images.push(image);
            progress.advance(1);
        }
        Ok(())
    }

    /// `x` without its shares in the basis, of unit norm, and M x; `None` if nothing new is left.
    ///
    /// Errors: not enough memory.
    fn orthogonal(&self, mut x: Vec<f64>) -> Result<Option<WithImage>, FeError> {
        let norm = |x: &[f64]| dot(x, &self.system.mass_times(x)).max(0.0).sqrt();
        let before = norm(&x);
        // Twice is enough (Parlett 1998, section 6.9).
        for _ in 0..2 {
            for (v, m) in self.basis.iter().zip(&self.images) {
                let share = dot(m, &x);
                for (x, v) in x.iter_mut().zip(v) {
                    *x -= share * v;
                }
            }
        }
        let after = norm(&x);
        if after.is_nan() || after <= EXHAUSTED * before {
            return Ok(None);
        }
        x.iter_mut().for_each(|v| *v /= after);
        if self.renewed {
            self.system.complete(&mut x)?;
        }
        let image = self.system.mass_times(&x);
        let left = self.basis.iter().map(|v| dot(v, &image).abs()).fold(0.0, f64::max);
        Ok((left <= OVERLAP).then_some((x, image)))
    }

    /// The reduced system.
    ///
    /// Errors: no vector.
    pub(super) fn finish(self) -> Result<Ritz, FeError> {
        if self.basis.is_empty() {
            return Err(FeError::Analysis("the ground motion does not load the model".into()));
        }
        let elastic: Vec<Vec<f64>> = self.basis.iter().map(|x| self.system.stiffness_times(x)).collect();
        let basis = columns(&self.basis);
        Ok(Ritz {
            mass: symmetric(transposed_product(&basis, &columns(&self.images))),
            stiffness: symmetric(transposed_product(&basis, &columns(&elastic))),
            basis,
        })
    }
}

/// The mean of a matrix and its transpose.
pub(super) fn symmetric(mut a: Matrix) -> Matrix {
    for j in 0..a.cols {
        for i in 0..j {
            let mean = 0.5 * (a.get(i, j) + a.get(j, i));
            a.data[i + j * a.rows] = mean;
            a.data[j + i * a.rows] = mean;
        }
    }
    a
}
