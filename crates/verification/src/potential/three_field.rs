//! The pencil of a structure with a potential liquid, whose mass matrix is never formed.
//!
//! Unknowns are x (structure, elevation of the surface) and the displacement potential φ. With the assembled matrices
//!
//! ```text
//! K₃ = ⎡ K  0 ⎤     M₃ = ⎡ Mₓ   Fᵀ ⎤     M = Mₓ + Fᵀ H⁻¹ F     (Schur complement of −H)
//!      ⎣ 0  0 ⎦          ⎣ F   −H  ⎦
//! ```
//!
//! (F and H with the density of the liquid) the pencil is K x = ω² M x. M x costs one solve with the factor of H; for s ≠ 0
//!
//! ```text
//! (K + s M) x = b     ⇔     (K₃ + s M₃) ⎡ x ⎤ = ⎡ b ⎤ ,     quasi-definite for s > 0,
//!                                       ⎣ φ ⎦   ⎣ 0 ⎦
//! ```
//!
//! and for s = 0 the block of φ is replaced by −H alone, so that one symbolic phase serves all. By Sylvester and Haynsworth
//! (1968), with σ = −s > 0: In(K₃ − σ M₃) = In(σ H) + In(K − σ M), so that the negative pivots count the eigenvalues
//! below σ.
//!
//! **Constant potential.** H is singular where φ is not supported: H 1 = 0 for each connected liquid without a
//! support of φ. Then the rows of φ require 1ᵀF x = cᵀx = 0: the volume of the liquid is constant. The pencil is
//! defined on the subspace of these x, and all operations are restricted to it:
//!
//! * products are P K P and P M P with the orthogonal projector P on that subspace; H ψ = F P x is then solvable, and
//!   one node of ψ is fixed to zero (ψ is determined up to a constant, Fᵀ1 = c vanishes under P);
//! * solves with s ≠ 0 obey the constraint by themselves, the constant of φ is its multiplier; for s = 0
//!   x = K⁻¹b − K⁻¹C (Cᵀ K⁻¹ C)⁻¹ Cᵀ K⁻¹ b;
//! * the bordered matrix has one more negative (and positive) pivot per constraint: the count is reduced by their
//!   number.
//!
//! A time integration with K₃ + s M₃, s = 1/(β Δt²), does not need this treatment: the matrix is regular.

use std::sync::Arc;

use fem::linalg::{
    Cholesky, Factor, Kind, LinalgError, Matrix, Ordering, Pencil, Shifted, Symbolic, Symmetric, dot, product,
    transposed_product, trusted,
};

/// A row sum of H below this part of the sum of magnitudes counts as zero: assembly leaves about 10⁻¹⁵.
const CONSTANT: f64 = 1e-10;

/// K₃ and M₃ with the unknowns to be condensed.
#[derive(Debug)]
pub struct ThreeField<'a> {
    stiffness: &'a Symmetric,
    mass: &'a Symmetric,
    symbolic: Arc<Symbolic>,
    /// Unknowns x.
    kept: Vec<usize>,
    /// Unknowns φ.
    condensed: Vec<usize>,
    /// Factor of H, with one row of each unbounded liquid replaced by that of the identity.
    potential: Factor,
    /// Positions in `condensed` of the potentials fixed to zero.
    fixed: Vec<usize>,
    /// c of each unbounded liquid, over x, orthonormal.
    constraints: Matrix,
}

impl<'a> ThreeField<'a> {
    /// K₃ and M₃ on the pattern of `symbolic`; `condensed` are the unknowns φ, ascending.
    ///
    /// Errors: K₃ has an entry in a row of φ; a liquid without support and without moving boundary; −M₃ not positive
    /// definite on φ (except for the constants).
    pub fn new(
        stiffness: &'a Symmetric,
        mass: &'a Symmetric,
        symbolic: Arc<Symbolic>,
        condensed: Vec<usize>,
    ) -> Result<ThreeField<'a>, LinalgError> {
        let size = stiffness.size();
        let mut is_condensed = vec![false; size];
        for &i in &condensed {
            is_condensed[i] = true;
        }
        let kept: Vec<usize> = (0..size).filter(|&i| !is_condensed[i]).collect();
        for j in 0..size {
            for p in stiffness.pattern.starts[j]..stiffness.pattern.starts[j + 1] {
                let i = stiffness.pattern.rows[p];
                if (is_condensed[i] || is_condensed[j]) && stiffness.values[p] != 0.0 {
                    return Err(LinalgError::NotCondensable { row: i, column: j });
                }
            }
        }
        let mut h = mass.submatrix(&condensed);
        h.values.iter_mut().for_each(|v| *v = -*v);
        let liquids = unbounded(&h);
        let mut constraints = Matrix::zeros(kept.len(), liquids.len());
        for (l, liquid) in liquids.iter().enumerate() {
            let mut constant = vec![0.0; size];
            for &k in liquid {
                constant[condensed[k]] = 1.0;
            }
            let all = mass.times(&constant);
            let scale: f64 = liquid.iter().map(|&k| h.values[h.pattern.starts[k]]).sum();
            for (c, &i) in constraints.column_mut(l).iter_mut().zip(&kept) {
                *c = all[i];
            }
            let length = dot(constraints.column(l), constraints.column(l)).sqrt();
            if length.is_nan() || length <= f64::EPSILON * scale.abs() {
                return Err(LinalgError::UncoupledLiquid { unknown: condensed[liquid[0]] });
            }
            constraints.column_mut(l).iter_mut().for_each(|c| *c /= length);
        }
        orthonormalise(&mut constraints);
        let fixed: Vec<usize> = liquids.iter().map(|liquid| liquid[0]).collect();
        for &k in &fixed {
            pin(&mut h, k);
        }
        let order = Ordering::Given(suborder(&symbolic, &condensed, size));
        let h_symbolic = Arc::new(Symbolic::new(h.pattern.clone(), &order)?);
        let potential = h_symbolic.factor(&h, Kind::Definite)?;
        Ok(ThreeField { stiffness, mass, symbolic, kept, condensed, potential, fixed, constraints })
    }

    /// Unknowns x, by number in K₃.
    pub fn kept(&self) -> &[usize] {
        &self.kept
    }

    /// Number of liquids with a volume constraint.
    pub fn constraints(&self) -> usize {
        self.constraints.cols
    }

    /// The part of a vector over all unknowns that belongs to x (loads, influence vectors).
    pub fn restrict(&self, all: &[f64]) -> Vec<f64> {
        self.kept.iter().map(|&i| all[i]).collect()
    }

    /// x and its potential, φ = H⁻¹ F x, over all unknowns. In a liquid without support φ is zero at one node: its
    /// constant is the multiplier of the constraint and is not determined by x alone.
    ///
    /// Errors: not enough memory.
    pub fn expand(&self, x: &Matrix) -> Result<Matrix, LinalgError> {
        let mut admissible = x.clone();
        self.project(&mut admissible);
        let potential = self.potential_of(&admissible)?;
        let mut out = self.spread(&admissible);
        for j in 0..x.cols {
            for (&i, &v) in self.condensed.iter().zip(potential.column(j)) {
                out.column_mut(j)[i] = v;
            }
        }
        Ok(out)
    }

    /// X ← P X.
    pub fn project(&self, x: &mut Matrix) {
        if self.constraints.cols > 0 && x.cols > 0 {
            let along = transposed_product(&self.constraints, x);
            let part = product(&self.constraints, &along);
            for (v, p) in x.data.iter_mut().zip(&part.data) {
                *v -= p;
            }
        }
    }

    /// X over all unknowns, zero for φ.
    fn spread(&self, x: &Matrix) -> Matrix {
        let mut out = Matrix::zeros(self.stiffness.size(), x.cols);
        for j in 0..x.cols {
            for (&i, &v) in self.kept.iter().zip(x.column(j)) {
                out.column_mut(j)[i] = v;
            }
        }
        out
    }

    fn rows(from: &Matrix, rows: &[usize]) -> Matrix {
        let columns: Vec<usize> = (0..from.cols).collect();
        from.select(rows, &columns)
    }

    /// H⁻¹ F X.
    fn potential_of(&self, x: &Matrix) -> Result<Matrix, LinalgError> {
        let mut right = Self::rows(&self.mass.times_block(&self.spread(x)), &self.condensed);
        for j in 0..right.cols {
            for &k in &self.fixed {
                right.column_mut(j)[k] = 0.0;
            }
        }
        self.potential.solve(&mut right)?;
        Ok(right)
    }

    /// K₃ + s M₃, with −H in the rows of φ if s = 0.
    fn effective(&self, s: f64) -> Symmetric {
        let mut sum = self.stiffness.clone();
        if s != 0.0 {
            sum.add(s, self.mass);
            return sum;
        }
        let mut place = vec![None; self.stiffness.size()];
        for (k, &i) in self.condensed.iter().enumerate() {
            place[i] = Some(k);
        }
        for j in 0..sum.size() {
            for p in sum.pattern.starts[j]..sum.pattern.starts[j + 1] {
                if let (Some(a), Some(b)) = (place[j], place[sum.pattern.rows[p]]) {
                    let pinned = self.fixed.contains(&a) || self.fixed.contains(&b);
                    sum.values[p] = if pinned { -f64::from(a == b) } else { self.mass.values[p] };
                }
            }
        }
        sum
    }
}

impl Pencil for ThreeField<'_> {
    fn size(&self) -> usize {
        self.kept.len()
    }

    fn stiffness(&self, x: &Matrix) -> Matrix {
        let mut admissible = x.clone();
        self.project(&mut admissible);
        let all = self.stiffness.times_block(&self.spread(&admissible));
        let mut out = Self::rows(&all, &self.kept);
        self.project(&mut out);
        out
    }

    fn stiffness_terms(&self, x: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.stiffness.size()];
        for (&i, &v) in self.kept.iter().zip(x) {
            all[i] = v;
        }
        self.restrict(&self.stiffness.terms(&all))
    }

    fn mass(&self, x: &Matrix) -> Result<Matrix, LinalgError> {
        let mut admissible = x.clone();
        self.project(&mut admissible);
        let potential = self.potential_of(&admissible)?;
        let mut all = self.spread(&admissible);
        for j in 0..x.cols {
            for (&i, &v) in self.condensed.iter().zip(potential.column(j)) {
                all.column_mut(j)[i] = v;
            }
        }
        let mut out = Self::rows(&self.mass.times_block(&all), &self.kept);
        self.project(&mut out);
        Ok(out)
    }

    fn shifted(&self, s: f64) -> Result<Box<dyn Shifted + '_>, LinalgError> {
        let factor = trusted(&self.symbolic, &self.effective(s))?;
        let negative = factor.inertia().negative;
        if s >= 0.0 {
            // K is positive definite if every negative pivot is one of φ.
            if negative != self.condensed.len() {
                return Err(LinalgError::NotPositiveDefinite { pivot: 0, size: self.size() });
            }
            let mut out = ShiftedThreeField { pencil: self, factor, below: 0, static_constraints: None };
            if s == 0.0 && self.constraints.cols > 0 {
                let mut flexibility = self.constraints.clone();
                out.solve_free(&mut flexibility)?;
                let gram = Cholesky::factor(&transposed_product(&self.constraints, &flexibility))?;
                out.static_constraints = Some((flexibility, gram));
            }
            return Ok(Box::new(out));
        }
        let below = negative.checked_sub(self.constraints.cols).ok_or(LinalgError::Singular { size: self.size() })?;
        Ok(Box::new(ShiftedThreeField { pencil: self, factor, below, static_constraints: None }))
    }
}

struct ShiftedThreeField<'a> {
    pencil: &'a ThreeField<'a>,
    factor: Factor,
    below: usize,
    /// K⁻¹C and the factor of CᵀK⁻¹C, for s = 0.
    static_constraints: Option<(Matrix, Cholesky)>,
}

impl ShiftedThreeField<'_> {
    fn solve_free(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        let mut all = self.pencil.spread(b);
        self.factor.solve(&mut all)?;
        *b = ThreeField::rows(&all, &self.pencil.kept);
        Ok(())
    }
}

impl Shifted for ShiftedThreeField<'_> {
    fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        self.solve_free(b)?;
        if let Some((flexibility, gram)) = &self.static_constraints {
            let mut multiplier = transposed_product(&self.pencil.constraints, b);
            gram.solve(&mut multiplier);
            let part = product(flexibility, &multiplier);
            for (v, p) in b.data.iter_mut().zip(&part.data) {
                *v -= p;
            }
        }
        // Rounding only.
        self.pencil.project(b);
        Ok(())
    }

    fn below(&self) -> usize {
        self.below
    }
}

/// Connected parts of H whose rows all sum to zero: their constant is in the null space.
fn unbounded(h: &Symmetric) -> Vec<Vec<usize>> {
    let n = h.size();
    let sums = h.times(&vec![1.0; n]);
    let magnitude = h.terms(&vec![1.0; n]);
    let mut neighbours = vec![Vec::new(); n];
    for j in 0..n {
        for p in h.pattern.starts[j]..h.pattern.starts[j + 1] {
            let i = h.pattern.rows[p];
            if i != j && h.values[p] != 0.0 {
                neighbours[i].push(j);
                neighbours[j].push(i);
            }
        }
    }
    let mut seen = vec![false; n];
    let mut out = Vec::new();
    for first in 0..n {
        if seen[first] {
            continue;
        }
        let mut part = vec![first];
        seen[first] = true;
        let mut next = 0;
        while next < part.len() {
            for &i in &neighbours[part[next]] {
                if !seen[i] {
                    seen[i] = true;
                    part.push(i);
                }
            }
            next += 1;
        }
        if part.iter().all(|&i| sums[i].abs() <= CONSTANT * magnitude[i]) {
            out.push(part);
        }
    }
    out
}

/// Row and column k of the identity.
fn pin(h: &mut Symmetric, k: usize) {
    let pattern = h.pattern.clone();
    for j in 0..h.size() {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let i = pattern.rows[p];
            if i == k || j == k {
                h.values[p] = f64::from(i == j);
            }
        }
    }
}

/// Gram-Schmidt, twice.
fn orthonormalise(c: &mut Matrix) {
    for j in 0..c.cols {
        for _ in 0..2 {
            for i in 0..j {
                let along = dot(c.column(i), c.column(j));
                let other = c.column(i).to_vec();
                for (v, o) in c.column_mut(j).iter_mut().zip(&other) {
                    *v -= along * o;
                }
            }
        }
        let length = dot(c.column(j), c.column(j)).sqrt();
        c.column_mut(j).iter_mut().for_each(|v| *v /= length);
    }
}

/// The order of elimination of the whole, for the condensed unknowns alone.
fn suborder(symbolic: &Symbolic, condensed: &[usize], size: usize) -> Vec<usize> {
    let mut position = vec![usize::MAX; size];
    for (k, &i) in condensed.iter().enumerate() {
        position[i] = k;
    }
    symbolic.order().into_iter().map(|i| position[i]).filter(|&k| k != usize::MAX).collect()
}
