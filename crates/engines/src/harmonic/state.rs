//! Static state: hydrostatic pressure and self-weight on the same wall mesh (m = 0, liquid as a given pressure).
//!
//! ```text
//! p = ρ g (H − z) outwards,   −ρ_s t g along the axis,   weights of the roof on the top edge, of rings and attachments at their heights
//! ```
//!
//! The hydrostatic state is never solved through the liquid: its pressure is known.

use tank::Case;

use fem::linalg::{LinalgError, Matrix, SparseCholesky, Triplets};
use fem::shape::gauss;

use super::rings::Fitting;
use super::wall::{LOCAL, LocalRow, NODAL, NODE, Output, U_BUBBLES, Wall, displacements};

/// Solved static state of the wall.
#[derive(Clone, Debug)]
pub struct Static {
    wall: Wall,
    /// Unknowns of each element, bubbles included.
    solution: Vec<LocalRow>,
    /// ρ g [N/m³] and H [m].
    specific_weight: f64,
    depth: f64,
}

impl Static {
    /// Solves the static state; `roof_mass` is the mass of the roof whose weight the meshed wall carries [kg].
    ///
    /// Errors: a stiffness matrix that is not positive definite.
    pub fn solve(case: &Case, refine: f64, roof_mass: f64) -> Result<Static, LinalgError> {
        let depth = case.liquid.fill_height;
        let wall = Wall::new(&case.tank, depth, 0, refine);
        let specific_weight = case.liquid.density * case.gravity;
        let (size, index) = number(&wall);
        let mut k = Triplets::new(size);
        let mut load = Matrix::zeros(size, 1);
        for (element, map) in wall.elements.iter().zip(&index) {
            let weight = element.material.density * element.thickness * case.gravity;
            let local =
                element_load(&wall, element.bottom, element.length, weight, |z| specific_weight * (depth - z).max(0.0));
            for i in 0..LOCAL {
                let Some(p) = map[i] else { continue };
                load.add(p, 0, local[i]);
                for (q, value) in map.iter().zip(element.stiffness[i]) {
                    if let Some(q) = q {
                        k.add(p, *q, value);
                    }
                }
            }
        }
        if let Some(foot) = index[0][2].filter(|_| wall.foot > 0.0) {
            k.add(foot, foot, wall.factor * wall.foot);
        }
        for fitting in Fitting::all(&case.tank) {
            let on = fitting.on(&wall, &case.tank);
            for (i, p) in index[on.element].iter().enumerate() {
                let Some(p) = p else { continue };
                load.add(*p, 0, -on.mass * case.gravity * on.shapes[0][i]);
                for (stiffness, row) in &on.strains {
                    let others = index[on.element].iter().zip(row);
                    others.for_each(|(q, b)| q.iter().for_each(|q| k.add(*p, *q, stiffness * row[i] * b)));
                }
            }
        }
        let top = index[index.len() - 1][NODE].expect("the top of the wall is free to move along the axis");
        load.add(top, 0, -roof_mass * case.gravity);
        SparseCholesky::factor(&k)?.solve(&mut load)?;
        let solution = index.iter().map(|map| std::array::from_fn(|i| map[i].map_or(0.0, |p| load.data[p]))).collect();
        Ok(Static { wall, solution, specific_weight, depth })
    }

    /// An output at ξ of element `e`.
    pub fn value(&self, e: usize, xi: f64, output: Output) -> f64 {
        let row = self.wall.output(e, xi, output);
        row.iter().zip(&self.solution[e]).map(|(a, x)| a * x).sum()
    }

    /// An output at height z, just above (`upper`) or below it.
    pub fn at(&self, z: f64, upper: bool, output: Output) -> f64 {
        let (e, xi) = self.wall.locate(z, upper);
        self.value(e, xi, output)
    }

    /// Hydrostatic pressure at height z [Pa].
    pub fn pressure(&self, z: f64) -> f64 {
        self.specific_weight * (self.depth - z).max(0.0)
    }
}

/// Unknown of each element's local unknowns; those that the base holds have none.
fn number(wall: &Wall) -> (usize, Vec<[Option<usize>; LOCAL]>) {
    let mut next = 0;
    let mut take = |wanted: bool| {
        wanted.then(|| {
            next += 1;
            next - 1
        })
    };
    let mut index = Vec::with_capacity(wall.elements.len());
    let mut lower: [Option<usize>; NODE] = std::array::from_fn(|k| take(wall.active[k] && !wall.held[k]));
    for _ in &wall.elements {
        let mut map = [None; LOCAL];
        map[..NODE].copy_from_slice(&lower);
        // The bubbles of v play no part in an axisymmetric state.
        map[NODAL..NODAL + U_BUBBLES].fill_with(|| take(true));
        for k in 0..NODE {
            map[NODE + k] = take(wall.active[k]);
        }
        lower.copy_from_slice(&map[NODE..NODAL]);
        index.push(map);
    }
    (next, index)
}

/// Consistent load of a weight per area (downwards) and an outward pressure over one element.
fn element_load(wall: &Wall, bottom: f64, length: f64, weight: f64, pressure: impl Fn(f64) -> f64) -> LocalRow {
    let mut out = [0.0; LOCAL];
    for &(xi, gauss_weight) in gauss::FOUR {
        let z = bottom + 0.5 * length * (1.0 + xi);
        let measure = 0.5 * wall.factor * length * gauss_weight;
        let [u, _, w] = displacements(xi, length);
        for (i, value) in out.iter_mut().enumerate() {
            *value += measure * (pressure(z) * w[i] - weight * u[i]);
        }
    }
    out
}
