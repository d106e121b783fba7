//! The symmetry that a load keeps in a rectangular tank, whose mesh is symmetric about the planes x = 0 and y = 0.
//!
//! A motion is the sum of four parts, even or odd about each plane. The part of signs (s_x, s_y) is the mean over the reflections,
//!
//! ```text
//! P = ¼ (1 + s_x R_x)(1 + s_y R_y)          (R_x f)(x, y, z) = r_x f(−x, y, z)
//! r_x: u_x, ψ_y, ψ_z change sign (rotations are axial vectors); u_y, u_z, ψ_x, φ, η do not
//! ```
//!
//! | number | s_x | s_y | excited by |
//! |---|---|---|---|
//! | 0 | + | + | motion along z |
//! | 1 | − | + | motion along x |
//! | 2 | + | − | motion along y |
//! | 3 | − | − | nothing uniform |

use fem::dofs::{Dof, KINDS};
use fem::model::Model;

/// Numbers of the parts.
pub(super) const PARTS: u32 = 4;

/// Projection on one part.
pub(super) struct Mirrored<'a> {
    model: &'a Model,
    images: &'a [Vec<usize>; 2],
    part: u32,
}

impl<'a> Mirrored<'a> {
    /// The projection on part `part`; `images` are the mirror images of the nodes at x = 0 and y = 0.
    pub(super) fn new(model: &'a Model, images: &'a [Vec<usize>; 2], part: u32) -> Mirrored<'a> {
        Mirrored { model, images, part }
    }

    /// A load of the part that excites all its modes, different for every `seed`: forces of irregular size on every node of the walls, and of
    /// the `surface` if asked for.
    pub(super) fn load(&self, seed: u64, surface: bool) -> Vec<f64> {
        // A linear congruential generator: the same numbers every time.
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
        };
        let mut field = vec![[0.0; KINDS]; self.model.nodes().len()];
        for own in &mut field {
            for dof in [Dof::Ux, Dof::Uy, Dof::Uz, Dof::Eta] {
                own[dof.index()] = next();
            }
            if !surface {
                own[Dof::Eta.index()] = 0.0;
            }
        }
        let mut load = self.model.vector(|node| field[node]);
        self.project(&mut load);
        load
    }

    /// Removes from `x` the other parts.
    pub(super) fn project(&self, x: &mut [f64]) {
        let mut field: Vec<[f64; KINDS]> =
            (0..self.model.nodes().len()).map(|node| self.model.at_node(x, node)).collect();
        for (axis, images) in self.images.iter().enumerate() {
            let sign = if (self.part >> axis) & 1 == 1 { -1.0 } else { 1.0 };
            let mean = |node: usize| -> [f64; KINDS] {
                let (own, other) = (&field[node], &field[images[node]]);
                std::array::from_fn(|k| 0.5 * (own[k] + sign * reflected(axis, k) * other[k]))
            };
            field = (0..field.len()).map(mean).collect();
        }
        x.copy_from_slice(&self.model.vector(|node| field[node]));
    }
}

/// Sign of a component under the reflection at the plane across `axis`.
fn reflected(axis: usize, component: usize) -> f64 {
    let odd =
        matches!((axis, Dof::ALL[component]), (0, Dof::Ux | Dof::Ry | Dof::Rz) | (1, Dof::Uy | Dof::Rx | Dof::Rz));
    if odd { -1.0 } else { 1.0 }
}
