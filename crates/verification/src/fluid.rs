//! The displacement liquid: rank, patch tests, self-weight, sloshing, impulsive mass, acoustic modes.
//!
//! Units are those of the sources: m, t, kN, s (so kPa and t/m³) for the dissertation's examples, SI for Code_Aster's.

use crate::{Reference, Row};

pub(crate) mod cylinder;
pub(crate) mod disc;
pub(crate) mod impulsive;
pub(crate) mod large_wave;
pub(crate) mod patch;
pub(crate) mod rank;
pub(crate) mod rectangle;
mod sloshing;
pub(crate) mod sloshing_box;
mod tank;
pub(crate) mod weight;

/// g of the dissertation's examples [m/s²].
const GRAVITY: f64 = 9.81;

/// K of the dissertation's water [kPa].
const BULK_MODULUS: f64 = 2.06e6;

/// Source and kind of the reference of several rows.
struct Source {
    source: &'static str,
    kind: Reference,
}

impl Source {
    fn row(
        &self,
        id: &str,
        what: impl Into<String>,
        (reference, computed): (f64, f64),
        tolerance: f64,
        unit: &'static str,
    ) -> Row {
        let reference = (reference, self.source, self.kind);
        Row::new(id, what, reference, computed, (tolerance, unit))
    }
}
