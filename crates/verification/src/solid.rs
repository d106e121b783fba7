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
//! | C10 | the same wall alone under liquid pressure and its weight | cantilever |
//!
//! Units of the sources: m, kN, t, s.

use std::sync::Arc;

use super::{Reference, Row};
use fem::analysis::statics::Statics;
use fem::assembly::Assembler;
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::Model;

mod cantilever;
mod column;
mod elastica;
mod joint;
mod macro_wall;
mod opening;
mod wall;

/// Failure of a model that should have an answer.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// Rows that take seconds.
///
/// Errors: a model without an answer.
pub fn solid() -> Result<Vec<Row>, Failure> {
    let mut rows = cantilever::statics()?;
    rows.extend(cantilever::frequencies()?);
    rows.extend(cantilever::harmonic()?);
    rows.extend(joint::rows()?);
    rows.extend(opening::rows()?);
    rows.extend(column::rows()?);
    rows.extend(wall::layered()?);
    rows.extend(wall::alone()?);
    rows.extend(macro_wall::rows()?);
    rows.extend(elastica::rows(&[100, 200, 400])?);
    Ok(rows)
}

/// A row of one of the pages of this topic.
fn row(
    id: &str,
    page: &'static str,
    what: impl Into<String>,
    reference: (f64, &'static str, Reference),
    computed: f64,
    (tolerance, unit): (f64, &'static str),
) -> Row {
    Row {
        id: id.to_owned(),
        page,
        what: what.into(),
        reference: reference.0,
        source: reference.1,
        kind: reference.2,
        computed,
        tolerance,
        unit,
        convergence: Vec::new(),
    }
}

/// Linear statics: displacements under nodal forces given by equation.
fn solve(model: &Model, assembler: &Assembler, load: &[f64]) -> Result<Vec<f64>, Failure> {
    let stiffness = assembler.stiffness(model)?;
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let statics = Statics::new(&symbolic, &stiffness, Kind::Definite)?;
    let mut found = statics.solve(&stiffness, &[load])?;
    Ok(found.swap_remove(0))
}
