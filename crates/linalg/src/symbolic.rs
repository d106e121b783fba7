//! Symbolic phase of a sparse factorisation: size and cost of the factor before any number is computed.

use std::sync::{Arc, OnceLock};

use faer::Side;
use faer::perm::PermRef;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};

use super::factor::{Factor, Kind};
use super::{LinalgError, Ordering, Pattern, Symmetric};

/// The symbolic phase for one pattern: order, elimination tree, places of the factor. It applies to
/// every matrix on the pattern: K, K + s M, the effective matrices of time integration.
#[derive(Debug)]
pub struct Symbolic {
    pub(super) pattern: Arc<Pattern>,
    symbolic: SymbolicCholesky<usize>,
    /// The same with supernodes throughout, as pivoting needs; created on first use.
    pivoting: OnceLock<SymbolicCholesky<usize>>,
}

impl Symbolic {
    /// Analyses a pattern.
    ///
    /// Errors: an order that is not a bijection, not enough memory.
    pub fn new(pattern: Arc<Pattern>, ordering: &Ordering) -> Result<Symbolic, LinalgError> {
        let size = pattern.size();
        let symbolic = match ordering {
            Ordering::MinimumDegree => analyse(&pattern, SymmetricOrdering::Amd, SupernodalThreshold::AUTO)?,
            Ordering::Given(order) => {
                if !Ordering::is_bijection(order, size) {
                    return Err(LinalgError::Order { size });
                }
                let inverse = inverse(order);
                let permutation = PermRef::new_checked(order, &inverse, size);
                analyse(&pattern, SymmetricOrdering::Custom(permutation), SupernodalThreshold::AUTO)?
            }
        };
        Ok(Symbolic { pattern, symbolic, pivoting: OnceLock::new() })
    }

    /// Analyses a pattern whose unknowns are eliminated in their order, with supernodes throughout.
    ///
    /// Errors: not enough memory.
    pub(super) fn supernodal(pattern: Arc<Pattern>) -> Result<Symbolic, LinalgError> {
        let size = pattern.size();
        let all: Vec<usize> = (0..size).collect();
        let order = SymmetricOrdering::Custom(PermRef::new_checked(&all, &all, size));
        let symbolic = analyse(&pattern, order, SupernodalThreshold::FORCE_SUPERNODAL)?;
        Ok(Symbolic { pattern, symbolic, pivoting: OnceLock::new() })
    }

    /// The analysis for a kind of factor.
    pub(super) fn of_kind(&self, kind: Kind) -> Result<&SymbolicCholesky<usize>, LinalgError> {
        if kind != Kind::Indefinite || matches!(self.symbolic.raw(), SymbolicCholeskyRaw::Supernodal(_)) {
            return Ok(&self.symbolic);
        }
        if let Some(found) = self.pivoting.get() {
            return Ok(found);
        }
        // faer's factor without supernodes does not pivot.
        let order = match self.symbolic.perm() {
            Some(permutation) => SymmetricOrdering::Custom(permutation),
            None => SymmetricOrdering::Identity,
        };
        let made = analyse(&self.pattern, order, SupernodalThreshold::FORCE_SUPERNODAL)?;
        Ok(self.pivoting.get_or_init(|| made))
    }

    /// The pattern analysed.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Unknowns in the order of their elimination.
    pub fn order(&self) -> Vec<usize> {
        match self.symbolic.perm() {
            Some(permutation) => permutation.arrays().0.to_vec(),
            None => (0..self.pattern.size()).collect(),
        }
    }

    /// Entries of the factor, with the zeros that supernodes store.
    pub fn entries(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Additions and multiplications of one factorisation: Σ over columns of (entries of the column)².
    pub fn flops(&self) -> f64 {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(s) => s.col_ptr().windows(2).map(|w| ((w[1] - w[0]) as f64).powi(2)).sum(),
            SymbolicCholeskyRaw::Supernodal(s) => (0..s.n_supernodes())
                .map(|k| {
                    let (columns, below) = (s.supernode_end()[k] - s.supernode_begin()[k], s.nnz_per_super()[k]);
                    (1..=columns).map(|c| ((c + below) as f64).powi(2)).sum::<f64>()
                })
                .sum(),
        }
    }

    /// Factors a matrix on the pattern.
    ///
    /// Errors: a pivot that is not positive (`Definite`), a zero pivot, not enough memory.
    pub fn factor(self: &Arc<Self>, matrix: &Symmetric, kind: Kind) -> Result<Factor, LinalgError> {
        Factor::new(self.clone(), matrix, kind)
    }
}

/// `inverse[order[k]] = k`.
fn inverse(order: &[usize]) -> Vec<usize> {
    let mut inverse = vec![0; order.len()];
    for (k, &i) in order.iter().enumerate() {
        inverse[i] = k;
    }
    inverse
}

fn analyse(
    pattern: &Pattern,
    order: SymmetricOrdering<'_, usize>,
    threshold: SupernodalThreshold,
) -> Result<SymbolicCholesky<usize>, LinalgError> {
    let size = pattern.size();
    let view = SymbolicSparseColMatRef::new_checked(size, size, &pattern.starts, None, &pattern.rows);
    let parameters = CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..Default::default() };
    factorize_symbolic_cholesky(view, Side::Lower, order, parameters).map_err(|_| LinalgError::Memory { size })
}
