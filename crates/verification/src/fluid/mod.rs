//! The displacement liquid: rank, patch tests, self-weight, sloshing, impulsive mass, acoustic modes.
//!
//! Units are those of the sources: m, t, kN, s (so kPa and t/m³) for the dissertation's examples, SI for Code_Aster's.

mod acoustic;
mod disc;
mod impulsive;
mod patch;
mod rank;
mod sloshing;
mod tank;
mod weight;

pub use acoustic::sloshing_box;
pub use disc::degenerate_discs;
pub use impulsive::impulsive_mass;
pub use patch::patch_tests;
pub use rank::rank_table;
pub use sloshing::{chapter_8, cylinders, rectangles};
pub use weight::self_weight;

use super::{Reference, Row, VerifyError};

/// All rows.
///
/// Errors: a model that cannot be made or solved.
pub fn fluid() -> Result<Vec<Row>, VerifyError> {
    let mut rows = rank_table()?;
    rows.extend(patch_tests()?);
    rows.extend(self_weight()?);
    rows.extend(rectangles()?);
    rows.extend(degenerate_discs()?);
    rows.extend(sloshing_box()?);
    rows.extend(cylinders()?);
    rows.extend(chapter_8()?);
    rows.extend(impulsive_mass()?);
    Ok(rows)
}

/// g of the dissertation's examples [m/s²].
const GRAVITY: f64 = 9.81;
/// K of the dissertation's water [kPa].
const BULK_MODULUS: f64 = 2.06e6;

/// What a row of one page has in common.
struct Page {
    name: &'static str,
    source: &'static str,
    kind: Reference,
}

impl Page {
    fn row(
        &self,
        id: &str,
        what: impl Into<String>,
        (reference, computed): (f64, f64),
        tolerance: f64,
        unit: &'static str,
    ) -> Row {
        Row {
            id: id.to_owned(),
            page: self.name,
            what: what.into(),
            reference,
            source: self.source,
            kind: self.kind,
            computed,
            tolerance,
            unit,
            convergence: Vec::new(),
        }
    }
}
