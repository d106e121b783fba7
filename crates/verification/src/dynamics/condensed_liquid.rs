//! D10: mass of the condensed liquid.

use super::strip::*;
use crate::{Answer, Benchmark, Part, Reference, Row};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "condensed-liquid",
    title: "Condensed liquid",
    model: "Strip 8.4: the liquid in closed form on a wall that translates.",
    ids: &[("D10", "liquid mass of strip 8.4 in a rigid translation")],
    parts: &[Part::Fast(mass)],
};

fn mass() -> Answer {
    // Twelve sloshing modes leave out 0.05 % of the mass; the series converges with 1/n².
    Ok(vec![Row::new(
        "D10",
        format!("strip 8.4: liquid mass moved by a translation, {SLOSHING} sloshing modes"),
        (LIQUID_DENSITY * HALF_WIDTH * DEPTH, "ρ L H", Reference::ClosedForm),
        liquid().translated_mass(SLOSHING),
        (1e-3, "kg/m"),
    )])
}
