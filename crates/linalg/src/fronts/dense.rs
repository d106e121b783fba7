//! Elimination within a front.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltRegularization, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place;
use faer::{Accum, MatMut, MatRef, Par};

/// Columns eliminated at a time, and of one product.
const BLOCK: usize = 128;
/// Multiplications of products from which a second thread is worth its start.
const WORTH: usize = 4_000_000;
/// Buffers kept for the next fronts, and their largest size: fresh pages of larger ones cost little beside their front.
const KEPT: usize = 64;
const LARGEST: usize = 1 << 20;

/// Working memory of one thread.
#[derive(Default)]
pub(super) struct Desk {
    free: Vec<Vec<f64>>,
    scaled: Vec<f64>,
    space: Option<MemBuffer>,
}

/// to −= l rᵀ on a lower trapezoid.
struct Product<'a> {
    to: MatMut<'a, f64>,
    l: MatRef<'a, f64>,
    r: MatRef<'a, f64>,
}

impl Product<'_> {
    fn run(self) {
        let columns = self.to.ncols();
        let (square, rest) = self.to.split_at_row_mut(columns);
        let (upper, lower) = self.l.split_at_row(columns);
        triangular::matmul(
            square,
            BlockStructure::TriangularLower,
            Accum::Add,
            upper,
            BlockStructure::Rectangular,
            self.r.transpose(),
            BlockStructure::Rectangular,
            -1.0,
            Par::Seq,
        );
        if rest.nrows() > 0 {
            matmul(rest, Accum::Add, lower, self.r.transpose(), -1.0, Par::Seq);
        }
    }

    fn size(&self) -> usize {
        self.to.nrows() * self.to.ncols()
    }
}

impl Desk {
    /// Zeros.
    pub(super) fn take(&mut self, size: usize) -> Vec<f64> {
        // The smallest that is large enough, else any.
        let fits = self.free.iter().enumerate().filter(|(_, f)| f.capacity() >= size);
        let at = fits.min_by_key(|(_, f)| f.capacity()).map(|(at, _)| at);
        let mut out = at.map(|at| self.free.swap_remove(at)).unwrap_or_default();
        out.clear();
        out.resize(size, 0.0);
        out
    }

    pub(super) fn give(&mut self, used: Vec<f64>) {
        if self.free.len() < KEPT && used.capacity() <= LARGEST {
            self.free.push(used);
        }
    }

    /// Eliminates `width` columns of `height` rows and subtracts from `update`, lower triangles; whether all pivots are finite and not 0.
    pub(super) fn eliminate(
        &mut self,
        panel: &mut [f64],
        update: &mut [f64],
        [width, height]: [usize; 2],
        threads: usize,
    ) -> bool {
        let below = height - width;
        for k in (0..width).step_by(BLOCK) {
            let n = BLOCK.min(width - k);
            let rest = width - k - n;
            let (done, left) = panel[k * height..].split_at_mut(n * height);
            let block = MatMut::from_column_major_slice_mut(done, height, n);
            let (_, block) = block.split_at_row_mut(k);
            let (mut pivots, mut lower) = block.split_at_row_mut(n);
            if !self.pivots(pivots.as_mut()) {
                return false;
            }
            if lower.nrows() == 0 {
                continue;
            }
            divide(pivots.as_ref(), lower.as_mut(), threads);
            // Y D, and Y in its place.
            self.scaled.clear();
            for j in 0..n {
                let inverse = 1.0 / pivots[(j, j)];
                if let Some(column) = lower.as_mut().col_mut(j).try_as_col_major_mut() {
                    let column = column.as_slice_mut();
                    self.scaled.extend_from_slice(column);
                    column.iter_mut().for_each(|y| *y *= inverse);
                }
            }
            let rows = lower.nrows();
            let scaled = MatRef::from_column_major_slice(&self.scaled, rows, n);
            let y = lower.as_ref();
            let mut products = Vec::new();
            if rest > 0 {
                let to = MatMut::from_column_major_slice_mut(left, height, rest);
                cut(to.split_at_row_mut(k + n).1, y, scaled, 0, &mut products);
            }
            if below > 0 {
                let to = MatMut::from_column_major_slice_mut(&mut *update, below, below);
                cut(to, y, scaled, rest, &mut products);
            }
            run(products, n, threads);
        }
        true
    }

    /// Dense LDLᵀ of a block; whether its pivots are finite and not 0.
    fn pivots(&mut self, mut block: MatMut<'_, f64>) -> bool {
        let n = block.nrows();
        if n == 1 {
            let d = block[(0, 0)];
            return d != 0.0 && d.is_finite();
        }
        let space = self.space.get_or_insert_with(|| {
            MemBuffer::new(cholesky_in_place_scratch::<f64>(BLOCK, Par::Seq, Default::default()))
        });
        let stack = MemStack::new(space);
        let factored =
            cholesky_in_place(block.as_mut(), LdltRegularization::default(), Par::Seq, stack, Default::default());
        factored.is_ok() && (0..n).all(|j| block[(j, j)].is_finite())
    }
}

/// lower ← lower L⁻ᵀ, row by row independent.
fn divide(l: MatRef<'_, f64>, lower: MatMut<'_, f64>, threads: usize) {
    let solve = |rows: MatMut<'_, f64>| solve_unit_lower_triangular_in_place(l, rows.transpose_mut(), Par::Seq);
    // The same halves on one thread: the rows of a block share their products.
    let half = lower.nrows() / 2;
    if lower.nrows() * lower.ncols() * lower.ncols() < 2 * WORTH {
        solve(lower);
        return;
    }
    let (upper, lower) = lower.split_at_row_mut(half);
    if threads < 2 {
        solve(upper);
        solve(lower);
        return;
    }
    rayon::join(|| solve(upper), || solve(lower));
}

/// Products for the columns of a trapezoid whose first one is that of row `from` of `y` and `scaled`.
fn cut<'a>(
    mut to: MatMut<'a, f64>,
    y: MatRef<'a, f64>,
    scaled: MatRef<'a, f64>,
    from: usize,
    products: &mut Vec<Product<'a>>,
) {
    let mut at = from;
    while to.ncols() > 0 {
        let n = BLOCK.min(to.ncols());
        let (own, next) = to.split_at_col_mut(n);
        let r = scaled.subrows(at, n);
        products.push(Product { to: own, l: y.subrows(at, y.nrows() - at), r });
        to = next.split_at_row_mut(n).1;
        at += n;
    }
}

/// All products, each whole on one of the threads.
fn run(products: Vec<Product<'_>>, depth: usize, threads: usize) {
    let work: usize = products.iter().map(Product::size).sum();
    if threads < 2 || products.len() < 2 || work * depth < WORTH {
        products.into_iter().for_each(Product::run);
        return;
    }
    let (mut halves, mut sums) = ([Vec::new(), Vec::new()], [0; 2]);
    for product in products {
        let to = usize::from(sums[1] < sums[0]);
        sums[to] += product.size();
        halves[to].push(product);
    }
    let [own, other] = halves;
    let all = |products: Vec<Product<'_>>| products.into_iter().for_each(Product::run);
    rayon::join(|| all(own), || all(other));
}
