//! Modes of a tank harmonic by harmonic, named by their wave numbers.
//!
//! On a cyclic mesh a mode belongs to one circumferential wave number n and, but for n = 0, has a twin turned by a quarter
//! wave. The modes symmetric about the plane y = 0 of each n are found on their own, as Ritz pairs of the Krylov space of
//! a load that belongs to n,
//!
//! ```text
//! K x = ω² M x          accepted if ‖x − ω² K⁻¹ M x‖_M ≤ 10⁻⁶ ‖x‖_M
//! ```
//!
//! so that no two of them have one frequency and hundreds of waves of the surface do not stand before the first mode of
//! the wall.

use fem::linalg::{Symmetric, dot, generalized_eigen};
use fem::progress::Progress;

use super::model::{SURFACE, TankModel, WALL};
use super::ritz::reduce;
use super::symmetry::Harmonic;
use super::system::System;
use super::waves::{Waves, classify};
use crate::FeError;
use crate::error::{failed, failure};
use crate::modes::Kind;

/// Largest residual of a mode.
const RESIDUAL: f64 = 1e-6;
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

/// Largest circumferential wave number a division can show.
pub fn most_waves(tank: &TankModel) -> u32 {
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
    let symmetry = Harmonic::new(tank, n);
    let load = symmetry.load();
    let space = reduce(system, &load, vectors, &|x| symmetry.project(x), progress)?;
    let eigen =
        generalized_eigen(&space.stiffness, &space.mass, None).map_err(failure("the reduced stiffness matrix"))?;
    let gravity = tank
        .assembler
        .stiffness_of(&tank.model, |e| tank.is_in(e, &[SURFACE]))
        .map_err(failed)?;
    let wall = tank
        .assembler
        .stiffness_of(&tank.model, |e| tank.is_in(e, &[WALL]))
        .map_err(failed)?;
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
    let mut found: Vec<TankMode> = Vec::new();
    for (j, &omega) in eigen.omega.iter().enumerate() {
        let vector = space.basis.times(eigen.vectors.column(j));
        let kind = kind_of(&vector, omega);
        if found.iter().filter(|m| m.kind == kind).count() >= most {
            continue;
        }
        let image = system.mass_times(&vector);
        let mut rest = system.solve(&image)?;
        for (r, v) in rest.iter_mut().zip(&vector) {
            *r = v - omega * omega * *r;
        }
        symmetry.project(&mut rest);
        system.complete(&mut rest)?;
        let error = dot(&rest, &system.mass_times(&rest)).max(0.0).sqrt();
        if error > RESIDUAL {
            continue;
        }
        found.push(TankMode {
            kind,
            harmonic: n,
            omega,
            waves: classify(&radial(tank, &vector), &tank.wall.z),
            vector,
        });
    }
    Ok(found)
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
