//! D9: energy balance of a linear run.

use super::strip::*;
use crate::{Answer, Benchmark, Part, Reference, Row};
use fem::analysis::scheme::TimeScheme;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "energy-balance",
    title: "Energy balance",
    model: "Strip 8.4, linear, with modal damping: work done against the sum of energies.",
    ids: &[("D9", "energy balance of a linear run")],
    parts: &[Part::Fast(balance)],
};

fn balance() -> Answer {
    let (grid, load) = shaking(32.0);
    let run = strip()?.direct(TimeScheme::Trapezoidal, &load, grid)?;
    let source = "closes to rounding whatever the step";
    Ok(vec![Row::new(
        "D9",
        "strip 8.4: residual of the energy balance, trapezoidal rule",
        (0.0, source, Reference::ClosedForm),
        run.energy.error(),
        (1e-10, "of the work done"),
    )])
}
