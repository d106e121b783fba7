//! Load-dependent reduction: a rational Krylov basis (Ruhe 1984) for the motion that given loads excite.
//!
//! ```text
//! span{ (K + s M)⁻¹ f,  (K + s M)⁻¹ M (K + s M)⁻¹ f,  … }   for real poles s ≥ 0,        Qᵀ M Q = I
//! ```
//!
//! With s = 0 among the poles the first vector is the static response, so that the basis contains it exactly and
//! missing mass need not be added (load-dependent Ritz vectors, Wilson, Yuan & Dickens 1982). A pole s = ω² speeds up
//! the modes near ω. Every pole s matches moments of the transfer function at the imaginary frequency i√s.
//!
//! A displacement liquid has hundreds of rotational modes between the sloshing and the bulging modes. An eigenvalue
//! solver must find all of them; the loads do not excite them, and they do not enter this basis.
//!
//! The pencil projected on Q is solved for its Ritz pairs, so that the result can be used like modes: K and M are
//! diagonal in it.

use super::basis::Basis;
use super::eigen::{orient, symmetric_eigen};
use super::pencil::{Pencil, Shifted};
use super::{LinalgError, Matrix, dot, product, transposed_product};

/// Ritz vectors with less than this share of a load's effective mass need not be modes.
const SHARE: f64 = 1e-3;
/// Smallest new fraction of a direction; less is rounding.
const NOISE: f64 = 1e-11;

/// Options of a reduction.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction {
    /// Poles s ≥ 0 [rad²/s²]. Start with 0 unless K is singular.
    pub poles: Vec<f64>,
    /// Blocks (one vector per load) at each pole; the last pole continues until the accuracy is reached.
    pub blocks: usize,
    /// Ritz pairs up to this frequency that carry more than 0.1 % of a load's effective mass have to converge [rad/s].
    pub band: f64,
    /// Residual ‖x − (λ + s)(K + s M)⁻¹ M x‖_M they have to reach; the error of λ is at most that, commonly its square.
    pub accuracy: f64,
    /// Largest number of vectors.
    pub largest: usize,
}

impl Reduction {
    /// Poles at 0, (ω/3)² and ω² for a band up to ω = `band` [rad/s].
    pub fn up_to(band: f64) -> Reduction {
        Reduction {
            poles: vec![0.0, band * band / 9.0, band * band],
            blocks: 10,
            band,
            accuracy: 1e-3,
            largest: 400,
        }
    }
}

/// A pencil reduced to the motion that loads excite: M = I and K = diag(λ) in the vectors.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduced {
    /// λ = ω² of the Ritz pairs, ascending [rad²/s²].
    pub lambda: Vec<f64>,
    /// Ritz vectors x column by column, x_iᵀ M x_j = δ_ij.
    pub vectors: Matrix,
    /// xᵀ f, one row per Ritz vector, one column per load.
    pub participation: Matrix,
    /// Residual of each Ritz pair in the band with more than 0.1 % of some load's effective mass; `None` for the others.
    pub residual: Vec<Option<f64>>,
    /// Whether all those residuals reach the required accuracy.
    pub converged: bool,
}

impl Reduced {
    /// Share of Ritz vector j in the effective mass of load l: (xᵀf)²/Σ (xᵀf)².
    pub fn share(&self, j: usize, load: usize) -> f64 {
        let column = self.participation.column(load);
        let total = dot(column, column);
        if total > 0.0 { column[j].powi(2) / total } else { 0.0 }
    }

    /// ω [rad/s]; zero where rounding left λ slightly negative.
    pub fn omega(&self) -> Vec<f64> {
        self.lambda.iter().map(|l| l.max(0.0).sqrt()).collect()
    }
}

/// Reduces a pencil to the motion that the loads (columns) excite.
///
/// A reduction that misses its accuracy at its largest size is returned with `converged` false.
///
/// Errors: no pole, K + s M not positive definite, not enough memory.
pub fn reduce(pencil: &dyn Pencil, loads: &Matrix, reduction: &Reduction) -> Result<Reduced, LinalgError> {
    let mut basis = Basis::new(pencil);
    let full = reduction.largest.min(pencil.size());
    let mut result = None;
    for (p, &pole) in reduction.poles.iter().enumerate() {
        let solver = pencil.shifted(pole)?;
        let last = p + 1 == reduction.poles.len();
        let mut right = loads.clone();
        let mut look = reduction.blocks;
        for block in 1.. {
            let first = basis.len();
            solver.solve(&mut right)?;
            normalise(pencil, &mut right)?;
            basis.append(right, NOISE)?;
            right = basis.mass_columns(first);
            let over = right.cols == 0 || basis.len() + right.cols > full;
            if !last && (over || block >= reduction.blocks) {
                break;
            }
            if last && (over || block >= look) {
                let reduced = project(&basis, loads, reduction, &*solver, pole)?;
                let enough = over || reduced.converged;
                result = Some(reduced);
                if enough {
                    break;
                }
                // The projection costs as much as a few blocks.
                look = block + reduction.blocks.div_ceil(2).max(1);
            }
        }
    }
    result.ok_or(LinalgError::Poles)
}

/// Columns of unit M-norm; zero columns stay.
fn normalise(pencil: &dyn Pencil, w: &mut Matrix) -> Result<(), LinalgError> {
    let mw = pencil.mass(w)?;
    for j in 0..w.cols {
        let length = dot(w.column(j), mw.column(j)).max(0.0).sqrt();
        if length > 0.0 {
            w.column_mut(j).iter_mut().for_each(|v| *v /= length);
        }
    }
    Ok(())
}

fn project(
    basis: &Basis<'_>,
    loads: &Matrix,
    reduction: &Reduction,
    solver: &dyn Shifted,
    pole: f64,
) -> Result<Reduced, LinalgError> {
    let pencil = basis.pencil;
    let mut stiffness = transposed_product(&basis.q, &pencil.stiffness(&basis.q));
    for j in 0..stiffness.rows {
        for i in 0..j {
            let mean = 0.5 * (stiffness.get(i, j) + stiffness.get(j, i));
            stiffness.data[i + j * stiffness.rows] = mean;
            stiffness.data[j + i * stiffness.rows] = mean;
        }
    }
    let (lambda, y) = symmetric_eigen(&stiffness)?;
    let mut vectors = product(&basis.q, &y);
    for j in 0..vectors.cols {
        orient(vectors.column_mut(j));
    }
    let participation = transposed_product(&vectors, loads);
    let mut reduced = Reduced {
        residual: vec![None; lambda.len()],
        lambda,
        vectors,
        participation,
        converged: true,
    };
    let limit = reduction.band * reduction.band;
    let marked: Vec<usize> = (0..reduced.lambda.len())
        .filter(|&j| reduced.lambda[j] <= limit && (0..loads.cols).any(|l| reduced.share(j, l) > SHARE))
        .collect();
    let rows: Vec<usize> = (0..pencil.size()).collect();
    let x = reduced.vectors.select(&rows, &marked);
    let mut rest = pencil.mass(&x)?;
    solver.solve(&mut rest)?;
    for (k, &j) in marked.iter().enumerate() {
        let factor = reduced.lambda[j] + pole;
        for (r, x) in rest.column_mut(k).iter_mut().zip(x.column(k)) {
            *r = x - factor * *r;
        }
    }
    let m_rest = pencil.mass(&rest)?;
    for (k, &j) in marked.iter().enumerate() {
        let residual = dot(rest.column(k), m_rest.column(k)).max(0.0).sqrt();
        reduced.converged &= residual <= reduction.accuracy;
        reduced.residual[j] = Some(residual);
    }
    Ok(reduced)
}
