//! Plane tank of length L and depth H with unit breadth: bilinear potentials, linear elevation of the surface, and a right
//! wall of springs with mass.

use std::sync::Arc;

use fem::linalg::{
    Kind, LinalgError, Matrix, Ordering, Pattern, Pencil, Search, Symbolic, Symmetric, generalized_eigen, modes,
    product, transposed_product,
};
use verification::potential::three_field::ThreeField;

const G: f64 = 9.81;
const RHO: f64 = 1000.0;

struct Tank {
    k: Symmetric,
    m: Symmetric,
    symbolic: Arc<Symbolic>,
    phi: Vec<usize>,
    eta: Vec<usize>,
}

/// `held`: the potential is zero at x = 0 (antisymmetry) instead of a rigid wall there.
fn tank(length: f64, depth: f64, [nx, nz]: [usize; 2], wall: f64, held: bool) -> Tank {
    let (hx, hz) = (length / nx as f64, depth / nz as f64);
    let node = |i: usize, j: usize| i + (nx + 1) * j;
    let mut numbers = 0;
    let mut number = |yes: bool| {
        numbers += usize::from(yes);
        yes.then(|| numbers - 1)
    };
    let (mut phi, mut eta, mut wall_of) = (Vec::new(), Vec::new(), Vec::new());
    let (mut node_of, mut coordinates) = (Vec::new(), Vec::new());
    for j in 0..=nz {
        for i in 0..=nx {
            let own = [number(!(held && i == 0)), number(j == nz), number(i == nx && wall.is_finite())];
            phi.push(own[0]);
            eta.push(own[1]);
            wall_of.push(own[2]);
            node_of.extend(own.iter().flatten().map(|_| node(i, j)));
            coordinates.push([i as f64 * hx, 0.0, j as f64 * hz]);
        }
    }
    let all = |nodes: &[usize]| -> Vec<usize> {
        let mut out: Vec<usize> = nodes.iter().flat_map(|&a| [phi[a], eta[a], wall_of[a]]).flatten().collect();
        out.sort_unstable();
        out
    };
    let mut cliques = Vec::new();
    for j in 0..nz {
        for i in 0..nx {
            cliques.push(all(&[node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)]));
        }
    }
    let pattern = Arc::new(Pattern::from_cliques(numbers, cliques.iter().map(Vec::as_slice)));
    let (mut k, mut m) = (Symmetric::zeros(pattern.clone()), Symmetric::zeros(pattern.clone()));
    let add = |a: &mut Symmetric, i: Option<usize>, j: Option<usize>, v: f64| {
        if let (Some(i), Some(j)) = (i, j)
            && i >= j
        {
            a.values[pattern.place(i, j).unwrap()] += v;
        }
    };
    // One-dimensional mass and stiffness of a linear element of unit length.
    let mass = [[1.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 1.0 / 3.0]];
    let slope = [[1.0, -1.0], [-1.0, 1.0]];
    for j in 0..nz {
        for i in 0..nx {
            for a in 0..4 {
                for b in 0..4 {
                    let h = slope[a % 2][b % 2] * mass[a / 2][b / 2] * hz / hx
                        + mass[a % 2][b % 2] * slope[a / 2][b / 2] * hx / hz;
                    let at = |c: usize| phi[node(i + c % 2, j + c / 2)];
                    add(&mut m, at(a), at(b), -RHO * h);
                }
            }
        }
    }
    let mut boundary = |of: &[Option<usize>], nodes: [usize; 2], h: f64, stiffness: f64, own_mass: f64| {
        for a in 0..2 {
            for b in 0..2 {
                let s = mass[a][b] * h;
                let (x, p) = (of[nodes[a]], phi[nodes[b]]);
                // F acts between two different unknowns; the lower triangle holds it once.
                if x > p {
                    add(&mut m, x, p, RHO * s);
                } else {
                    add(&mut m, p, x, RHO * s);
                }
                add(&mut k, x, of[nodes[b]], stiffness * s);
                add(&mut m, x, of[nodes[b]], own_mass * s);
            }
        }
    };
    for i in 0..nx {
        boundary(&eta, [node(i, nz), node(i + 1, nz)], hx, RHO * G, 0.0);
    }
    if wall.is_finite() {
        for j in 0..nz {
            boundary(&wall_of, [node(nx, j), node(nx, j + 1)], hz, wall, 50.0);
        }
    }
    let ordering = Ordering::best(&pattern, &node_of, &coordinates);
    Tank {
        symbolic: Arc::new(Symbolic::new(pattern, &ordering).unwrap()),
        k,
        m,
        phi: phi.into_iter().flatten().collect(),
        eta: eta.into_iter().flatten().collect(),
    }
}

impl Tank {
    fn pencil(&self) -> ThreeField<'_> {
        ThreeField::new(&self.k, &self.m, self.symbolic.clone(), self.phi.clone()).unwrap()
    }

    /// Dense ZᵀKZ, ZᵀMZ and Z, a basis of the x that keep the volume (by elimination of one unknown).
    fn dense(&self, pencil: &ThreeField<'_>) -> (Matrix, Matrix, Matrix) {
        let (kept, free) = (pencil.kept(), usize::from(pencil.constraints() > 0));
        let (k, m) = (self.k.to_dense(), self.m.to_dense());
        let f = m.select(&self.phi, kept);
        // φ of the first node is zero if it is not fixed otherwise.
        let mut h = m.select(&self.phi[free..], &self.phi[free..]);
        h.data.iter_mut().for_each(|v| *v = -*v);
        let all: Vec<usize> = (0..kept.len()).collect();
        let rows: Vec<usize> = (free..self.phi.len()).collect();
        let f_free = f.select(&rows, &all);
        let mut x = f_free.clone();
        linalg::Cholesky::factor(&h).unwrap().solve(&mut x);
        let mut mass = transposed_product(&f_free, &x);
        for (v, own) in mass.data.iter_mut().zip(&m.select(kept, kept).data) {
            *v += own;
        }
        let mut z = Matrix::zeros(kept.len(), kept.len() - free);
        let c = f.transposed_times(&vec![1.0; self.phi.len()]);
        for j in 0..z.cols {
            z.add(j + free, j, 1.0);
            if free == 1 {
                z.add(0, j, -c[j + 1] / c[0]);
            }
        }
        let reduce = |a: &Matrix| transposed_product(&z, &product(a, &z));
        (reduce(&k.select(kept, kept)), reduce(&mass), z)
    }
}

fn tanks() -> Vec<Tank> {
    vec![
        tank(5.0, 2.57, [12, 6], 4e6, false),
        tank(5.0, 2.57, [7, 5], f64::INFINITY, false),
        tank(2.5, 2.57, [8, 8], 4e6, true),
        tank(2.5, 2.57, [30, 30], 4e6, false),
    ]
}

/// Lowest modes and inertia against the dense pencil with the liquid condensed and one unknown eliminated.
#[test]
fn modes_and_counts_agree_with_the_condensed_pencil() {
    for tank in tanks() {
        let pencil = tank.pencil();
        let (k, m, _) = tank.dense(&pencil);
        let dense = generalized_eigen(&k, &m, Some(12.min(k.rows))).unwrap();
        let found = modes(&pencil, &Search::lowest(dense.omega.len().min(8))).unwrap();
        for (f, e) in found.omega().iter().zip(&dense.omega) {
            assert!((f / e - 1.0).abs() < 1e-9, "{f} {e}");
        }
        for j in 1..dense.omega.len() {
            let sigma = 0.5 * (dense.omega[j - 1].powi(2) + dense.omega[j].powi(2));
            if dense.omega[j] / dense.omega[j - 1] > 1.001 {
                assert_eq!(pencil.count_below(sigma).unwrap(), j);
            }
        }
        let around = modes(&pencil, &Search::around(dense.omega[3] * 1.001, 1)).unwrap();
        assert!((around.omega()[0] / dense.omega[3] - 1.0).abs() < 1e-9);
    }
}

/// Sloshing of a rigid tank: ω² = g k tanh(k H), k = n π/L (fluid between rigid walls, antisymmetric and symmetric modes). Bilinear
/// elements converge with the square of their size: 2 % of the third mode at 16 × 8, a quarter of it with half the size.
#[test]
fn sloshing_converges() {
    let (length, depth) = (5.0, 2.57);
    let mut last = [1.0; 3];
    for n in [8, 16, 32] {
        let tank = tank(length, depth, [n, n / 2], f64::INFINITY, false);
        let found = modes(&tank.pencil(), &Search::lowest(3)).unwrap();
        for j in 0..3 {
            let k = (j + 1) as f64 * std::f64::consts::PI / length;
            let error = (found.omega()[j] / (G * k * (k * depth).tanh()).sqrt() - 1.0).abs();
            assert!(n == 8 || error < 0.3 * last[j], "mode {}: {error:e} after {:e}", j + 1, last[j]);
            last[j] = error;
        }
    }
    assert!(last.iter().all(|&e| e < 6e-3), "{last:?}");
}

/// (K + s M)⁻¹ on the subspace, M X and the effective matrix of a time step against the dense ones.
#[test]
fn solves_and_products_agree_with_the_condensed_pencil() {
    for tank in tanks() {
        let pencil = tank.pencil();
        let (k, m, z) = tank.dense(&pencil);
        let n = pencil.size();
        let mut b = Matrix::zeros(n, 2);
        for (i, v) in b.data.iter_mut().enumerate() {
            *v = ((i * 7919) % 101) as f64 - 50.0;
        }
        for s in [0.0, 3.0, 1e4, -200.0] {
            let mut sum = k.clone();
            for (a, m) in sum.data.iter_mut().zip(&m.data) {
                *a += s * m;
            }
            let mut x = b.clone();
            pencil.shifted(s).unwrap().solve(&mut x).unwrap();
            // Residual within the subspace: Zᵀ(b − (K + s M) x) = 0, where x = Z y.
            let y = x.select(&(n - z.cols..n).collect::<Vec<_>>(), &[0, 1]);
            let (left, right) = (product(&sum, &y), transposed_product(&z, &b));
            let scale = right.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (l, r) in left.data.iter().zip(&right.data) {
                assert!((l - r).abs() < 1e-8 * scale, "{s}: {l} {r}");
            }
            // x keeps the volume.
            let expected = product(&z, &y);
            let size = x.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (f, e) in x.data.iter().zip(&expected.data) {
                assert!((f - e).abs() < 1e-10 * size);
            }
            // Mass product, tested within the subspace.
            let mx = transposed_product(&z, &pencil.mass(&x).unwrap());
            let reference = product(&m, &y);
            let size = reference.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (f, e) in mx.data.iter().zip(&reference.data) {
                assert!((f - e).abs() < 1e-9 * size, "{s}: {f} {e}");
            }
        }
        // Direct integration: K₃ + s M₃ is regular without any support of φ.
        let mut effective = tank.k.clone();
        effective.add(1e4, &tank.m);
        let factor = tank.symbolic.factor(&effective, Kind::QuasiDefinite).unwrap();
        assert_eq!(factor.inertia().negative, tank.phi.len());
        let mut rest = vec![0.0; tank.k.size()];
        rest[tank.eta[1]] = 1.0;
        let found = factor.solve_vector(&rest).unwrap();
        effective.add_product(-1.0, &found, &mut rest);
        assert!(rest.iter().all(|r| r.abs() < 1e-10));
    }
}

/// The potential that belongs to a motion fulfils its own rows of the equations: F x = H φ.
#[test]
fn expansion_fulfils_the_rows_of_the_potential() {
    for tank in tanks() {
        let pencil = tank.pencil();
        let found = modes(&pencil, &Search::lowest(2)).unwrap();
        let all = pencil.expand(&found.vectors).unwrap();
        let image = tank.m.times(all.column(1));
        let terms = tank.m.terms(all.column(1));
        let scale = terms.iter().fold(0.0_f64, |m, v| m.max(*v));
        for &i in &tank.phi {
            assert!(image[i].abs() < 1e-9 * scale, "{} {}", image[i], scale);
        }
        assert_eq!(pencil.restrict(all.column(0)), {
            let mut x = found.vectors.clone();
            pencil.project(&mut x);
            x.column(0).to_vec()
        });
    }
}

#[test]
fn liquids_that_cannot_be_condensed_are_rejected() {
    let mut tank = tank(5.0, 2.0, [4, 2], 1e6, false);
    let place = tank.k.pattern.starts[tank.phi[1]];
    tank.k.values[place] = 1.0;
    let refused = ThreeField::new(&tank.k, &tank.m, tank.symbolic.clone(), tank.phi.clone());
    assert!(matches!(refused, Err(LinalgError::NotCondensable { .. })));
    tank.k.values[place] = 0.0;
    // A liquid without a moving boundary.
    for j in 0..tank.m.size() {
        for p in tank.m.pattern.starts[j]..tank.m.pattern.starts[j + 1] {
            let i = tank.m.pattern.rows[p];
            if tank.phi.contains(&i) != tank.phi.contains(&j) {
                tank.m.values[p] = 0.0;
            }
        }
    }
    let refused = ThreeField::new(&tank.k, &tank.m, tank.symbolic.clone(), tank.phi.clone());
    assert!(matches!(refused, Err(LinalgError::UncoupledLiquid { .. })), "{:?}", refused.err());
}
