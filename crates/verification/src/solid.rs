//! Solid, joint and layered wall.
//!
//! | rows | model | reference |
//! |---|---|---|
//! | C1-C4 | cantilever of bricks, dissertation figure 6.5 | beam theory, and the locking ratio of the brick |
//! | C5 | the same under large dead loads, bricks and shells | elastica, by shooting |
//! | C6 | the same under a harmonic tip force, three dampings | series of the beam's modes |
//! | C7 | joint partly closed, blocks pressed together | integrals by hand, uniform pressure |
//! | C7 | joint that opens: stiff block beyond the kern, multipliers | equilibrium by hand |
//! | C9 | wall element of shells and layer; sandwich beam | two beams on a layer; Plantema, Allen |
//! | C9 | wall of two beams and a layer, dissertation figure 8.9 | two beams on an elastic layer |
//! | C13 | the same macro wall with concrete that cracks | fibre section of the strips, curvature integrated |
//! | C10 | the same wall alone under liquid pressure and its weight | cantilever |
//!
//! Units of the sources: m, kN, t, s.

use std::sync::Arc;

use crate::Failure;
use fem::analysis::statics::Statics;
use fem::assembly::Assembler;
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::Model;

pub(crate) mod cantilever;
mod column;
mod cracked_wall;
pub(crate) mod elastica;
mod forced;
pub(crate) mod joint;
pub(crate) mod macro_wall;
mod opening;
pub(crate) mod wall;

/// Linear statics: displacements under nodal forces given by equation.
fn solve(model: &Model, assembler: &Assembler, load: &[f64]) -> Result<Vec<f64>, Failure> {
    let stiffness = assembler.stiffness(model)?;
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let statics = Statics::new(&symbolic, &stiffness, Kind::Definite)?;
    let mut found = statics.solve(&stiffness, &[load])?;
    Ok(found.swap_remove(0))
}
