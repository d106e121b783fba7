//! The symmetry that a load keeps on a cyclic mesh: horizontal motion along x stays in cos θ, vertical motion in cos 0 θ,
//! and a load with cos mθ in cos mθ.
//!
//! ```text
//! scalars, u_r, u_z      (2 − δ_m0)/N Σ_s f_s cos mθ_s · cos mθ
//! u_θ                    (2 − δ_m0)/N Σ_s f_s sin mθ_s · sin mθ
//! rotation vector        as an axial vector: about e_θ like cos, about e_r and e_z like sin
//! ```

use fem::dofs::{Dof, KINDS};

use super::mirror::Mirrored;
use super::model::TankModel;

/// Symmetry of the motions of one harmonic: of a cylinder, or of the part of this number of a rectangle.
pub(super) enum Symmetry<'a> {
    /// A cyclic mesh.
    Cyclic(Harmonic<'a>),
    /// A mesh with two planes of symmetry.
    Mirrored(Mirrored<'a>),
}

impl<'a> Symmetry<'a> {
    /// That of harmonic `harmonic`.
    pub(super) fn new(tank: &'a TankModel, harmonic: u32) -> Symmetry<'a> {
        match &tank.mirrors {
            Some(images) => Symmetry::Mirrored(Mirrored::new(&tank.model, images, harmonic)),
            None => Symmetry::Cyclic(Harmonic::new(tank, harmonic)),
        }
    }

    /// Loads that excite all modes of the harmonic, each with the pole it is for.
    ///
    /// The modes of one part of a rectangle may have one frequency in pairs, which one load cannot tell apart. At the poles beyond 0 the
    /// walls are loaded alone: they are where the modes of the walls are sought.
    pub(super) fn loads(&self, poles: usize) -> Vec<(usize, Vec<f64>)> {
        match self {
            Symmetry::Cyclic(harmonic) => (0..poles).map(|pole| (pole, harmonic.load())).collect(),
            Symmetry::Mirrored(part) => {
                (0..poles).flat_map(|pole| [1, 2].map(|seed| (pole, part.load(seed, pole == 0)))).collect()
            }
        }
    }

    /// Removes from `x` the parts that do not belong to the harmonic.
    pub(super) fn project(&self, x: &mut [f64]) {
        match self {
            Symmetry::Cyclic(harmonic) => harmonic.project(x),
            Symmetry::Mirrored(part) => part.project(x),
        }
    }
}

/// Projection on the motions of harmonic m that are symmetric about the plane y = 0.
pub(super) struct Harmonic<'a> {
    tank: &'a TankModel,
    rings: Vec<Vec<usize>>,
    axis: Vec<usize>,
    harmonic: u32,
    /// Whether the twins turned by a quarter wave belong to it, too.
    twins: bool,
}

impl<'a> Harmonic<'a> {
    /// The projection for harmonic `harmonic`.
    pub(super) fn new(tank: &'a TankModel, harmonic: u32) -> Harmonic<'a> {
        let (rings, axis) = tank.rings();
        Harmonic { tank, rings, axis, harmonic, twins: false }
    }

    /// The same with the motions that are antisymmetric about the plane y = 0.
    pub(super) fn with_twins(self, twins: bool) -> Harmonic<'a> {
        Harmonic { twins, ..self }
    }

    /// A load of the harmonic that excites all its modes: forces of irregular size on every ring, all directions.
    pub(super) fn load(&self) -> Vec<f64> {
        // A linear congruential generator: the same numbers every time.
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            0.5 + (state >> 40) as f64 / (1_u64 << 24) as f64
        };
        let model = &self.tank.model;
        let mut field = vec![[0.0; KINDS]; model.nodes().len()];
        let m = f64::from(self.harmonic);
        for ring in &self.rings {
            let step = std::f64::consts::TAU / ring.len() as f64;
            let mut own = [0.0; KINDS];
            for dof in [Dof::Ux, Dof::Uz, Dof::Eta] {
                own[dof.index()] = next();
            }
            for (s, &node) in ring.iter().enumerate() {
                let cosine = (m * step * s as f64).cos();
                field[node] = cylindrical(&own.map(|v| v * cosine), -step * s as f64);
            }
        }
        model.vector(|node| field[node])
    }

    /// Removes from `x` the parts that do not belong to the harmonic.
    pub(super) fn project(&self, x: &mut [f64]) {
        let model = &self.tank.model;
        let mut field = vec![[0.0; KINDS]; model.nodes().len()];
        let m = f64::from(self.harmonic);
        for ring in &self.rings {
            let step = std::f64::consts::TAU / ring.len() as f64;
            let (mut amplitude, mut twin) = ([0.0; KINDS], [0.0; KINDS]);
            for (s, &node) in ring.iter().enumerate() {
                let own = cylindrical(&model.at_node(x, node), step * s as f64);
                let (sine, cosine) = (m * step * s as f64).sin_cos();
                for (k, a) in amplitude.iter_mut().enumerate() {
                    *a += own[k] * if is_odd(k) { sine } else { cosine };
                }
                if self.twins {
                    for (k, a) in twin.iter_mut().enumerate() {
                        *a += own[k] * if is_odd(k) { cosine } else { sine };
                    }
                }
            }
            let alone = self.harmonic == 0 || 2 * self.harmonic as usize == ring.len();
            let factor = if alone { 1.0 } else { 2.0 } / ring.len() as f64;
            for (s, &node) in ring.iter().enumerate() {
                let (sine, cosine) = (m * step * s as f64).sin_cos();
                let own: [f64; KINDS] = std::array::from_fn(|k| match is_odd(k) {
                    true => factor * amplitude[k] * sine + factor * twin[k] * cosine,
                    false => factor * amplitude[k] * cosine + factor * twin[k] * sine,
                });
                field[node] = cylindrical(&own, -step * s as f64);
            }
        }
        for &node in &self.axis {
            let own = model.at_node(x, node);
            for (k, value) in own.into_iter().enumerate() {
                let kept = match (self.harmonic, Dof::ALL[k]) {
                    (0, Dof::Uz | Dof::Phi | Dof::Eta) | (1, Dof::Ux | Dof::Ry) => true,
                    (1, Dof::Uy | Dof::Rx) => self.twins,
                    _ => false,
                };
                field[node][k] = if kept { value } else { 0.0 };
            }
        }
        x.copy_from_slice(&model.vector(|node| field[node]));
    }
}

/// A motion of harmonic 1, symmetric about the plane y = 0, turned by 90° about the axis of the tank: cos θ becomes sin θ, sin θ
/// becomes −cos θ.
pub(super) fn turned(tank: &TankModel, x: &[f64]) -> Vec<f64> {
    let model = &tank.model;
    let (rings, axis) = tank.rings();
    let mut field = vec![[0.0; KINDS]; model.nodes().len()];
    for ring in &rings {
        let step = std::f64::consts::TAU / ring.len() as f64;
        let mut amplitude = [0.0; KINDS];
        for (s, &node) in ring.iter().enumerate() {
            let own = cylindrical(&model.at_node(x, node), step * s as f64);
            let (sine, cosine) = (step * s as f64).sin_cos();
            for (k, a) in amplitude.iter_mut().enumerate() {
                *a += own[k] * if is_odd(k) { sine } else { cosine };
            }
        }
        let factor = 2.0 / ring.len() as f64;
        for (s, &node) in ring.iter().enumerate() {
            let (sine, cosine) = (step * s as f64).sin_cos();
            let own: [f64; KINDS] =
                std::array::from_fn(|k| factor * amplitude[k] * if is_odd(k) { -cosine } else { sine });
            field[node] = cylindrical(&own, -step * s as f64);
        }
    }
    for &node in &axis {
        let own = model.at_node(x, node);
        let (ux, ry) = (own[Dof::Ux.index()], own[Dof::Ry.index()]);
        field[node][Dof::Uy.index()] = ux;
        field[node][Dof::Rx.index()] = -ry;
    }
    model.vector(|node| field[node])
}

/// Components of displacement and rotation along (e_r, e_θ, e_z) at the angle θ; with −θ back to (x, y, z).
fn cylindrical(global: &[f64; KINDS], theta: f64) -> [f64; KINDS] {
    let (s, c) = theta.sin_cos();
    let mut own = *global;
    for first in [0, 3] {
        own[first] = c * global[first] + s * global[first + 1];
        own[first + 1] = -s * global[first] + c * global[first + 1];
    }
    own
}

/// Whether a component changes sign by reflection at the plane y = 0: u_θ, and rotations about e_r and e_z.
fn is_odd(k: usize) -> bool {
    matches!(Dof::ALL[k], Dof::Uy | Dof::Rx | Dof::Rz)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::test_tanks::broad;
    use tank::options::LinearOptions;
    use tank::options::solid::{MeshSize, SolidOptions};

    /// A motion with cos θ turned by 90° is the same at the node a quarter of the circle on. The sums over a ring of 8 nodes
    /// round in the last digits: 1e-12.
    #[test]
    fn a_quarter_turn() {
        let mesh = MeshSize { radial: 2, sectors: 8, vertical: 3 };
        let solid = SolidOptions { mesh: Some(mesh), ..SolidOptions::DEFAULT };
        let tank = TankModel::new(&broad(), &LinearOptions::default(), &solid).unwrap();
        let mut x = Harmonic::new(&tank, 1).load();
        Harmonic::new(&tank, 1).project(&mut x);
        let once = turned(&tank, &x);
        let (rings, _) = tank.rings();
        for ring in &rings {
            for s in 0..8 {
                let old = cylindrical(&tank.model.at_node(&x, ring[s]), std::f64::consts::TAU * s as f64 / 8.0);
                let angle = std::f64::consts::TAU * ((s + 2) % 8) as f64 / 8.0;
                let new = cylindrical(&tank.model.at_node(&once, ring[(s + 2) % 8]), angle);
                for (a, b) in old.iter().zip(&new) {
                    assert!((a - b).abs() < 1e-12, "{old:?} {new:?}");
                }
            }
        }
    }
}
