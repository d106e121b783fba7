//! The solvers on models with known solutions, from outside: a harness within the crate would compile faer once more.

use std::sync::Arc;

use linalg::{Ordering, Pattern, Symbolic, Symmetric};

mod dense;
mod eigen;
mod factors;
mod minres;
mod modes;
mod sparse;
mod symmetric;

/// Brick pattern on a grid of nx × ny × nz nodes with the seven-point Laplacian of unit spacing (zero beyond the grid) as
/// stiffness and the unit matrix as mass, `dofs` uncoupled copies a node.
///
/// Eigenvalues: 4 Σ sin²(i π/(2 (n + 1))) over the three directions, i = 1 … n.
struct Box3 {
    n: [usize; 3],
    stiffness: Symmetric,
    mass: Symmetric,
    node_of: Vec<usize>,
    coordinates: Vec<[f64; 3]>,
}

impl Box3 {
    fn new(n: [usize; 3], dofs: usize) -> Box3 {
        let node = |x: usize, y: usize, z: usize| x + n[0] * (y + n[1] * z);
        let mut cliques = Vec::new();
        for z in 0..n[2] - 1 {
            for y in 0..n[1] - 1 {
                for x in 0..n[0] - 1 {
                    let corners = (0..8).map(|c| node(x + c % 2, y + c / 2 % 2, z + c / 4));
                    cliques.push(corners.flat_map(|k| (0..dofs).map(move |d| k * dofs + d)).collect::<Vec<_>>());
                }
            }
        }
        let size = n[0] * n[1] * n[2] * dofs;
        let pattern = Arc::new(Pattern::from_cliques(size, cliques.iter().map(Vec::as_slice)));
        let (mut stiffness, mut mass) = (Symmetric::zeros(pattern.clone()), Symmetric::zeros(pattern.clone()));
        for e in 0..size {
            stiffness.values[pattern.starts[e]] = 6.0;
            mass.values[pattern.starts[e]] = 1.0;
        }
        for z in 0..n[2] {
            for y in 0..n[1] {
                for x in 0..n[0] {
                    let mut join = |other: usize| {
                        for d in 0..dofs {
                            let place = pattern.place(other * dofs + d, node(x, y, z) * dofs + d);
                            stiffness.values[place.expect("neighbours share a brick")] = -1.0;
                        }
                    };
                    if x + 1 < n[0] {
                        join(node(x + 1, y, z));
                    }
                    if y + 1 < n[1] {
                        join(node(x, y + 1, z));
                    }
                    if z + 1 < n[2] {
                        join(node(x, y, z + 1));
                    }
                }
            }
        }
        let place = |k: usize| [k % n[0], k / n[0] % n[1], k / n[0] / n[1]].map(|i| i as f64);
        Box3 {
            n,
            stiffness,
            mass,
            node_of: (0..size).map(|e| e / dofs).collect(),
            coordinates: (0..size / dofs).map(place).collect(),
        }
    }

    /// Eigenvalues of one copy, ascending.
    fn exact(&self) -> Vec<f64> {
        let line = |n: usize| {
            (1..=n).map(move |i| 4.0 * (i as f64 * std::f64::consts::PI / (2 * (n + 1)) as f64).sin().powi(2))
        };
        let mut all = Vec::new();
        for a in line(self.n[0]) {
            for b in line(self.n[1]) {
                all.extend(line(self.n[2]).map(|c| a + b + c));
            }
        }
        all.sort_by(f64::total_cmp);
        all
    }

    fn symbolic(&self) -> Arc<Symbolic> {
        let pattern = self.stiffness.pattern.clone();
        let ordering = Ordering::best(&pattern, &self.node_of, &self.coordinates);
        Arc::new(Symbolic::new(pattern, &ordering).unwrap())
    }
}
