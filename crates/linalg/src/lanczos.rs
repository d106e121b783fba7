//! Some eigenpairs of K x = λ M x, λ = ω²: shift-invert block Lanczos (Grimes, Lewis & Simon 1994) with full
//! M-orthogonalisation and thick restarts (Wu & Simon 2000).
//!
//! ```text
//! A = (K + s M)⁻¹ M        A x = θ x        λ = 1/θ − s
//! ```
//!
//! The eigenvalues nearest −s are the largest |θ| and appear first. Every pair is checked explicitly, and Sylvester's
//! law of inertia proves that all were found: K − σ M, factored beyond the last pair, must have as many negative
//! pivots as pairs were found. If it has more, the iteration continues with new random directions. **Limits of the
//! check of a pair.** ‖K x − λ M x‖ ≤ 10⁻⁸ ‖K x‖ cannot hold where K x itself is the small difference of large terms
//! (the sloshing modes of a liquid with a volume stiffness 10⁸ times larger). The residual that bounds the error is
//! that of A: |λ − λ_exact| ≤ (λ + s) ‖x − (λ + s) A x‖_M for xᵀ M x = 1. Both are returned; the second must be at
//! most 10⁻⁸, the first at most 10⁻⁸ or the rounding of the terms of K x.

use super::basis::Basis;
use super::eigen::{orient, symmetric_eigen};
use super::noise::Noise;
use super::pencil::{Pencil, Shifted};
use super::{LinalgError, Matrix, dot};

/// Estimated residual, relative to θ, at which a pair counts as converged.
const CONVERGED: f64 = 1e-10;
/// Largest allowed ‖x − (λ + s) A x‖_M of a pair that is returned, and largest ‖K x − λ M x‖/‖K x‖.
const ALLOWED: f64 = 1e-8;
/// Rounding of a sum, relative to the sum of its terms' sizes: 10⁻¹⁶ per term, rows of a solid have about 10² terms,
/// plus the error of the solve.
const ROUNDING: f64 = 1e-12;
/// Relative distance of two eigenvalues between which a shift can be placed.
const GAP: f64 = 1e-6;
/// Restarts before the solver gives up.
const RESTARTS: usize = 40;

/// Request to the eigenvalue solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Number of pairs.
    pub count: usize,
    /// Shift s [rad²/s²]: pairs with λ nearest −s are found. Zero or positive for the lowest: positive if K is singular.
    pub shift: f64,
    /// Vectors in a block. Multiple eigenvalues need not be known in advance; a block costs less than its vectors one
    /// by one.
    pub block: usize,
    /// Whether to make the inertia count.
    pub prove: bool,
}

impl Search {
    /// The `count` lowest modes; K must be positive definite.
    pub fn lowest(count: usize) -> Search {
        Search { count, shift: 0.0, block: 4, prove: true }
    }

    /// The `count` modes with ω² nearest `omega`² [rad/s].
    pub fn around(omega: f64, count: usize) -> Search {
        Search { shift: -omega * omega, ..Search::lowest(count) }
    }
}

/// Modes by ascending frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// λ = ω² [rad²/s²].
    pub lambda: Vec<f64>,
    /// Modes x_j column by column, x_jᵀ M x_j = 1.
    pub vectors: Matrix,
    /// ‖x − (λ + s) A x‖_M of each: bounds the relative error of λ + s.
    pub inverse_residual: Vec<f64>,
    /// ‖K x − λ M x‖/‖K x‖ of each.
    pub residual: Vec<f64>,
    /// Interval (from, to) of λ [rad²/s²] in which an inertia count has proved that there are exactly the modes found
    /// (`from` is −∞ for the lowest); `None` if not requested.
    pub complete_in: Option<(f64, f64)>,
    /// Vectors multiplied by A.
    pub products: usize,
}

impl Modes {
    /// ω [rad/s]; zero where rounding left λ slightly negative.
    pub fn omega(&self) -> Vec<f64> {
        self.lambda.iter().map(|l| l.max(0.0).sqrt()).collect()
    }
}

/// Finds modes of a pencil. Fewer than requested are returned only if all finite ones were found.
///
/// Errors: K + s M cannot be factored ([`Search::shift`]), no convergence, a pair that fails its check, an inertia count
/// that disagrees.
pub fn modes(pencil: &dyn Pencil, search: &Search) -> Result<Modes, LinalgError> {
    if search.count == 0 {
        return Ok(Modes {
            lambda: Vec::new(),
            vectors: Matrix::zeros(pencil.size(), 0),
            inverse_residual: Vec::new(),
            residual: Vec::new(),
            complete_in: None,
            products: 0,
        });
    }
    let solver = pencil.shifted(search.shift)?;
    let mut lanczos = Lanczos {
        basis: Basis::new(pencil),
        solver: &*solver,
        search: *search,
        t: Vec::new(),
        processed: 0,
        largest: 0.0,
        products: 0,
        noise: Noise::new(),
    };
    lanczos.start(search.block.max(1))?;
    let mut proofs = 0;
    loop {
        let Found { pairs, next, all } = lanczos.converge()?;
        let complete_in = if search.prove && !pairs.is_empty() {
            let interval = interval(search.shift, &pairs, next);
            let counted = count(pencil, interval)?;
            if counted > pairs.len() && !all && proofs < 5 {
                // The directions so far miss a mode.
                proofs += 1;
                lanczos.start(counted - pairs.len() + 1)?;
                continue;
            }
            if counted != pairs.len() {
                return Err(LinalgError::Count { found: pairs.len(), counted, from: interval.0, to: interval.1 });
            }
            Some(interval)
        } else {
            None
        };
        let wanted = pairs.len().min(search.count);
        return lanczos.check(&pairs[..wanted], complete_in);
    }
}

/// A Ritz pair: θ and the coefficients of its vector.
#[derive(Clone, Debug)]
struct Pair {
    theta: f64,
    coefficients: Vec<f64>,
}

struct Found {
    /// Converged pairs, largest |θ| first, ending before a gap.
    pairs: Vec<Pair>,
    /// |θ| of the next pair, or zero.
    next: f64,
    /// Whether all finite eigenvalues were found.
    all: bool,
}

struct Lanczos<'a> {
    basis: Basis<'a>,
    solver: &'a dyn Shifted,
    search: Search,
    /// Projected operator Qᵀ M A Q: column j contains the computed rows.
    t: Vec<Vec<f64>>,
    /// Columns of Q already multiplied by A.
    processed: usize,
    /// Largest ‖A q‖ met: rounding is relative to it.
    largest: f64,
    products: usize,
    noise: Noise,
}

impl Lanczos<'_> {
    /// Appends random directions from the range of A; returns how many are new.
    fn start(&mut self, columns: usize) -> Result<usize, LinalgError> {
        let noise = self.noise.block(self.basis.pencil.size(), columns);
        let mut w = self.basis.pencil.mass(&noise)?;
        self.solver.solve(&mut w)?;
        self.products += columns;
        // Random directions have arbitrary size.
        let mw = self.basis.pencil.mass(&w)?;
        for j in 0..columns {
            let length = dot(w.column(j), mw.column(j)).max(0.0).sqrt();
            if length > 0.0 {
                w.column_mut(j).iter_mut().for_each(|v| *v /= length);
            }
        }
        Ok(self.basis.append(w, 1e-10)?.new.rows)
    }

    /// Multiplies the open columns by A and appends the new directions.
    fn step(&mut self) -> Result<(), LinalgError> {
        let (first, last) = (self.processed, self.basis.len());
        let mut w = self.basis.mass_columns(first);
        self.solver.solve(&mut w)?;
        self.products += w.cols;
        let appended = self.basis.append(w, 1e-15 * self.largest)?;
        for j in 0..last - first {
            let column: Vec<f64> = appended.old.column(j).iter().chain(appended.new.column(j)).copied().collect();
            self.largest = self.largest.max(dot(&column, &column).sqrt());
            self.t.push(column);
        }
        self.processed = last;
        Ok(())
    }

    /// Qᵀ M A Q of the processed columns. If two columns contain the same entry, the later one is newer by a step.
    fn projected(&self) -> Matrix {
        let k = self.processed;
        let mut out = Matrix::zeros(k, k);
        for j in 0..k {
            for i in 0..=j {
                let mut v = self.t[j][i];
                // Columns of the same block share entries.
                if let Some(&other) = self.t[i].get(j).filter(|_| self.t[i].len() == self.t[j].len()) {
                    v = 0.5 * (v + other);
                }
                out.data[i + j * k] = v;
                out.data[j + i * k] = v;
            }
        }
        out
    }

    /// ‖A x − θ x‖_M of x = Q y: the part of A x on the open columns.
    fn estimate(&self, y: &[f64]) -> f64 {
        (self.processed..self.basis.len())
            .map(|row| {
                let sum: f64 = y.iter().zip(&self.t).map(|(y, column)| y * column.get(row).unwrap_or(&0.0)).sum();
                sum * sum
            })
            .sum::<f64>()
            .sqrt()
    }

    /// Iterates until the wanted pairs have converged and end before a gap.
    fn converge(&mut self) -> Result<Found, LinalgError> {
        let n = self.basis.pencil.size();
        let wanted = self.search.count;
        let block = self.search.block.max(1);
        let limit = (3 * wanted + 10 * block + 20).min(n);
        let mut next_look = self.processed + 1;
        let mut restarts = 0;
        let mut dry = 0;
        loop {
            let open = self.basis.len() - self.processed;
            if open > 0 {
                self.step()?;
            } else if self.start(block)? == 0 {
                dry += 1;
            } else {
                continue;
            }
            let exhausted = dry > 0;
            if self.processed < next_look.min(limit) && !exhausted && self.basis.len() > self.processed {
                continue;
            }
            next_look = self.processed + block.max(self.processed / 8);
            if self.processed == 0 {
                return Ok(Found { pairs: Vec::new(), next: 0.0, all: true });
            }
            let pairs = self.ritz()?;
            let residuals: Vec<f64> = pairs.iter().map(|p| self.estimate(&p.coefficients) / p.theta.abs()).collect();
            let good = residuals.iter().take_while(|&&r| r <= CONVERGED).count();
            if exhausted {
                let (mut pairs, mut take) = (pairs, wanted.min(good));
                while take > 0 && take < good && pairs[take - 1].theta.abs() <= (1.0 + GAP) * pairs[take].theta.abs() {
                    take += 1;
                }
                let next = pairs.get(take).map_or(0.0, |p| p.theta.abs());
                let all = take == pairs.len();
                pairs.truncate(take);
                return Ok(Found { pairs, next, all });
            }
            for i in wanted..=good {
                let roughly = residuals.get(i).is_some_and(|&r| r < 0.1 * GAP.sqrt());
                if i > 0 && roughly && pairs[i - 1].theta.abs() > (1.0 + GAP) * pairs[i].theta.abs() {
                    let next = pairs[i].theta.abs();
                    let mut pairs = pairs;
                    pairs.truncate(i);
                    return Ok(Found { pairs, next, all: false });
                }
            }
            // The last step gave no new direction: try others, or stop.
            if self.basis.len() == self.processed {
                continue;
            }
            if self.basis.len() + block > limit.max(good + 6 * block) && self.basis.len() < n {
                restarts += 1;
                if restarts > RESTARTS {
                    let (number, residual) = (good + 1, residuals.get(good).copied().unwrap_or(f64::INFINITY));
                    return Err(LinalgError::Eigen { number, wanted, residual, allowed: CONVERGED });
                }
                let keep = (good.max(wanted) + 2 * block).min(self.processed - 1).min(pairs.len());
                self.restart(&pairs[..keep]);
                next_look = 0;
            }
        }
    }

    /// All Ritz pairs, largest |θ| first.
    fn ritz(&self) -> Result<Vec<Pair>, LinalgError> {
        let (theta, y) = symmetric_eigen(&self.projected())?;
        let mut order: Vec<usize> = (0..theta.len()).collect();
        order.sort_by(|&a, &b| theta[b].abs().total_cmp(&theta[a].abs()));
        // With a definite shift all θ are positive; others are rounding.
        let definite = self.search.shift >= 0.0;
        let keep = order.into_iter().filter(|&j| if definite { theta[j] > 0.0 } else { theta[j] != 0.0 });
        Ok(keep.map(|j| Pair { theta: theta[j], coefficients: y.column(j).to_vec() }).collect())
    }

    /// Keeps the given Ritz vectors and the open columns.
    fn restart(&mut self, pairs: &[Pair]) {
        let open = self.basis.len() - self.processed;
        let mut y = Matrix::zeros(self.processed, pairs.len());
        for (j, pair) in pairs.iter().enumerate() {
            y.column_mut(j).copy_from_slice(&pair.coefficients);
        }
        let mut t = Vec::with_capacity(pairs.len());
        for (j, pair) in pairs.iter().enumerate() {
            let mut column = vec![0.0; pairs.len() + open];
            column[j] = pair.theta;
            for (k, entry) in column[pairs.len()..].iter_mut().enumerate() {
                let row = self.processed + k;
                *entry = (pair.coefficients.iter().zip(&self.t)).map(|(y, old)| y * old.get(row).unwrap_or(&0.0)).sum();
            }
            t.push(column);
        }
        self.basis.combine(self.processed, &y);
        self.t = t;
        self.processed = pairs.len();
    }

    /// Explicit check of the pairs; the result in ascending order.
    fn check(&self, pairs: &[Pair], complete_in: Option<(f64, f64)>) -> Result<Modes, LinalgError> {
        let (pencil, s) = (self.basis.pencil, self.search.shift);
        let lambda_of = |p: &Pair| 1.0 / p.theta - s;
        let mut sorted: Vec<&Pair> = pairs.iter().collect();
        sorted.sort_by(|a, b| lambda_of(a).total_cmp(&lambda_of(b)));
        let lambda: Vec<f64> = sorted.iter().map(|p| lambda_of(p)).collect();
        let mut y = Matrix::zeros(self.processed, pairs.len());
        for (j, pair) in sorted.iter().enumerate() {
            y.column_mut(j).copy_from_slice(&pair.coefficients[..self.processed]);
        }
        let head = |m: &Matrix| Matrix {
            rows: m.rows,
            cols: self.processed,
            data: m.data[..m.rows * self.processed].to_vec(),
        };
        // One more product with A removes components in the null space of M and rounding on stiff unknowns (Ericsson
        // & Ruhe 1980).
        let mut vectors = super::product(&head(&self.basis.mq), &y);
        self.solver.solve(&mut vectors)?;
        let mx = pencil.mass(&vectors)?;
        for j in 0..vectors.cols {
            let length = dot(vectors.column(j), mx.column(j)).sqrt();
            vectors.column_mut(j).iter_mut().for_each(|v| *v /= length);
            orient(vectors.column_mut(j));
        }
        let mx = pencil.mass(&vectors)?;
        let kx = pencil.stiffness(&vectors);
        let mut rest = mx.clone();
        self.solver.solve(&mut rest)?;
        for (j, &l) in lambda.iter().enumerate() {
            for (r, x) in rest.column_mut(j).iter_mut().zip(vectors.column(j)) {
                *r = x - (l + s) * *r;
            }
        }
        let m_rest = pencil.mass(&rest)?;
        let (mut inverse_residual, mut residual) = (Vec::new(), Vec::new());
        for (j, &l) in lambda.iter().enumerate() {
            let inverse = dot(rest.column(j), m_rest.column(j)).max(0.0).sqrt();
            let force: Vec<f64> = kx.column(j).iter().zip(mx.column(j)).map(|(k, m)| k - l * m).collect();
            let terms = pencil.stiffness_terms(vectors.column(j));
            let norm = |v: &[f64]| dot(v, v).sqrt();
            let relative = norm(&force) / norm(kx.column(j)).max(f64::MIN_POSITIVE);
            let floor = ROUNDING * norm(&terms) / norm(kx.column(j)).max(f64::MIN_POSITIVE);
            let worst = inverse.max(if relative <= floor { 0.0 } else { relative });
            if worst > ALLOWED || worst.is_nan() {
                return Err(LinalgError::Eigen {
                    number: j + 1,
                    wanted: self.search.count,
                    residual: worst,
                    allowed: ALLOWED,
                });
            }
            inverse_residual.push(inverse);
            residual.push(relative);
        }
        Ok(Modes { lambda, vectors, inverse_residual, residual, complete_in, products: self.products })
    }
}

/// Interval of λ that holds the pairs and ends in the gap before the next one.
fn interval(s: f64, pairs: &[Pair], next: f64) -> (f64, f64) {
    let last = 1.0 / pairs[pairs.len() - 1].theta.abs();
    let distance = if next > 0.0 { last + 0.5 * (1.0 / next - last).min(0.1 * last) } else { 1.1 * last };
    let from = if s >= 0.0 { f64::NEG_INFINITY } else { -s - distance };
    (from, -s + distance)
}

/// Eigenvalues in an interval, by inertia.
fn count(pencil: &dyn Pencil, (from, to): (f64, f64)) -> Result<usize, LinalgError> {
    let below = if from > 0.0 { pencil.count_below(from)? } else { 0 };
    Ok(pencil.count_below(to)?.saturating_sub(below))
}
