//! Modes of a tank harmonic by harmonic, named by their wave numbers.
//!
//! On a cyclic mesh a mode belongs to one circumferential wave number n and, but for n = 0, has a twin turned by a quarter
//! wave. The modes symmetric about the plane y = 0 of each n are found on their own, as Ritz pairs of the Krylov space of
//! a load that belongs to n,
//!
//! ```text
//! K x = ω² M x          accepted if ‖x − (ω² + s) (K + s M)⁻¹ M x‖_M ≤ ε ‖x‖_M
//!                       cylinder: s = 0, ε = 10⁻⁶; rectangle: s the pole nearest to ω², ε = 2·10⁻³
//! ```
//!
//! so that no two of them have one frequency and hundreds of waves of the surface do not stand before the first mode of
//! the wall.

use fem::linalg::{Symmetric, dot, generalized_eigen};
use fem::progress::Progress;

use super::mirror::PARTS;
use super::model::{SURFACE, TankModel};
use super::ritz::reduce;
use super::symmetry::Symmetry;
use super::system::System;
use super::wall::{LOADED, WALL};
use super::waves::{Waves, classify};
use crate::FeError;
use crate::error::{failed, failure};
use crate::modes::Kind;

/// Largest residual of a mode of a cylinder.
const RESIDUAL: f64 = 1e-6;
/// The same of a rectangle, whose waves in both directions fill the space. It bounds the relative error of ω² + s, and with s the pole
/// nearest to ω² that of ω² by two or three times as much ((K + s M)⁻¹ M is self-adjoint in M); that of a Ritz value is of its square.
const RESIDUAL_OF_PLATES: f64 = 2e-3;
/// Least number of sectors in a wave that can still be called one.
const SECTORS_PER_WAVE: usize = 6;

/// A mode of the whole tank.
#[derive(Clone, Debug)]
pub struct TankMode {
    /// Kind.
    pub kind: Kind,
    /// Wave number n of the search.
    pub harmonic: u32,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Wave numbers of the wall.
    pub waves: Option<Waves>,
    /// Unknowns of the model, φᵀ M φ = 1.
    pub vector: Vec<f64>,
}

/// Largest circumferential wave number a division can show; of a rectangle the last number of its four parts.
pub fn most_waves(tank: &TankModel) -> u32 {
    if !tank.is_round() {
        return PARTS - 1;
    }
    (tank.division.sectors / SECTORS_PER_WAVE).max(1) as u32
}

/// Converged modes of wave number n from `vectors` Ritz vectors, at most `most` of each kind, by ascending frequency.
///
/// Errors: a matrix that is not positive definite; not enough memory.
pub fn of_harmonic(
    tank: &TankModel,
    system: &System,
    n: u32,
    (vectors, most): (usize, usize),
    progress: &dyn Progress,
) -> Result<Vec<TankMode>, FeError> {
    let symmetry = Symmetry::new(tank, n);
    let loads = symmetry.loads(system.poles());
    let loads: Vec<(usize, &[f64])> = loads.iter().map(|(pole, load)| (*pole, load.as_slice())).collect();
    let space = reduce(system, &loads, vectors, &|x| symmetry.project(x), progress)?;
    let eigen =
        generalized_eigen(&space.stiffness, &space.mass, None).map_err(failure("the reduced stiffness matrix"))?;
    let gravity = tank.assembler.stiffness_of(&tank.model, |e| tank.is_in(e, &[SURFACE])).map_err(failed)?;
    let wall = tank.assembler.stiffness_of(&tank.model, |e| tank.is_in(e, &[WALL, LOADED])).map_err(failed)?;
    // Where the potential energy is; a displacement liquid keeps some in its rotation penalty.
    let kind_of = |vector: &[f64], omega: f64| -> Kind {
        let share = |part: &Symmetric| dot(vector, &part.times(vector)) / (omega * omega);
        if share(&gravity) > 0.5 {
            Kind::Sloshing
        } else if share(&wall) > 0.5 {
            Kind::Structural
        } else {
            Kind::Rotational
        }
    };
    let residual = if tank.is_round() { RESIDUAL } else { RESIDUAL_OF_PLATES };
    let mut found: Vec<TankMode> = Vec::new();
    for (j, &omega) in eigen.omega.iter().enumerate() {
        let vector = space.basis.times(eigen.vectors.column(j));
        let kind = kind_of(&vector, omega);
        if found.iter().filter(|m| m.kind == kind).count() >= most {
            continue;
        }
        let error = {
            // The pole nearest to ω²; in a cylinder always s = 0.
            let distance = |pole: &usize| (system.place(*pole) - omega * omega).abs();
            let poles = if tank.is_round() { 0..1 } else { 0..system.poles() };
            let pole = poles.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
            let factor = omega * omega + system.place(pole);
            let mut rest = system.solve_at(pole, &system.mass_times(&vector))?;
            for (r, v) in rest.iter_mut().zip(&vector) {
                *r = v - factor * *r;
            }
            symmetry.project(&mut rest);
            system.complete(&mut rest)?;
            dot(&rest, &system.mass_times(&rest)).max(0.0).sqrt()
        };
        if error > residual {
            continue;
        }
        found.push(TankMode { kind, harmonic: n, omega, waves: waves(tank, &vector), vector });
    }
    Ok(found)
}

/// Wave numbers of the wall of a cylinder.
pub(super) fn waves(tank: &TankModel, x: &[f64]) -> Option<Waves> {
    classify(&radial(tank, x), &tank.wall.z).filter(|_| tank.is_round())
}

/// Radial displacement of the wall, level by level and sector by sector.
pub fn radial(tank: &TankModel, x: &[f64]) -> Vec<Vec<f64>> {
    let nodes = tank.model.nodes();
    let at = |&node: &usize| {
        let (u, p) = (tank.model.at_node(x, node), nodes[node]);
        (u[0] * p[0] + u[1] * p[1]) / p[0].hypot(p[1])
    };
    tank.wall.rows.iter().map(|row| row.iter().map(at).collect()).collect()
}
