//! C10: the strip at rest.

use super::{DEPTH, HALF_WIDTH, HEIGHT, PLANE_MODULUS, THICKNESS, elastic_section, tank};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::strip::{StripDamping, StripError, StripModel};
use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::newton::{Criteria, Newton, StepFailure};
use fem::analysis::scheme::LoadStep;
use fem::element::fibre_beam::Options;
use fem::state::State;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-at-rest",
    title: "Strip 8.4 at rest",
    model: "Fibre beams and the liquid condensed onto them in closed form: L = 5 m, H = 2.57 m, wall 3.00 m × \
            0.30 m in plane strain, bars of 7.0 cm²/m on each face.",
    ids: &[("C10", "strip 8.4 of fibres at rest")],
    parts: &[Part::Fast(statics)],
};

const CANTILEVER: &str = "cantilever under hydrostatic pressure";

/// The state at rest under weight and pressure.
pub(super) fn at_rest(strip: &StripModel) -> Result<State, StripError> {
    let mut newton = Newton::new(&strip.model, &strip.assembler, &strip.symbolic, None, Criteria::default())?;
    let mut state = State::new(&strip.model);
    let load = strip.at_rest();
    let zero = vec![0.0; load.len()];
    newton.step(&LoadStep, &mut state, &zero, &load).map_err(|failure: StepFailure| AnalysisError::Option {
        option: "strip at rest",
        found: failure.to_string(),
        allowed: "equilibrium".into(),
    })?;
    Ok(state)
}

/// Rows C10: reactions, deflection of the top, settlement of the surface.
///
/// Errors: those of the model.
pub(crate) fn statics() -> Answer {
    let exact_bending = PLANE_MODULUS * THICKNESS.powi(3) / 12.0;
    let gamma = 1e4;
    let top = gamma * DEPTH.powi(5) / (30.0 * exact_bending)
        + (HEIGHT - DEPTH) * gamma * DEPTH.powi(4) / (24.0 * exact_bending);
    let settlement = gamma * DEPTH.powi(6) / (72.0 * exact_bending * HALF_WIDTH);
    let references = [
        ("moment at the base", gamma * DEPTH.powi(3) / 6.0, 2e-3, "Nm/m"),
        ("shear force at the base", gamma * DEPTH * DEPTH / 2.0, 2e-3, "N/m"),
        ("normal force at the base", -25e3 * THICKNESS * HEIGHT, 2e-3, "N/m"),
        ("deflection of the top", top, 5e-3, "m"),
        ("settlement of the surface", settlement, 1e-2, "m"),
    ];
    let mut found = Vec::new();
    for wet in [2, 4, 10] {
        let strip = StripModel::new(
            &tank(elastic_section()?, wet, 1.0, Options::default())?,
            StripDamping::Rayleigh(Rayleigh::NONE),
        )?;
        let state = at_rest(&strip)?;
        let [shear, axial, moment] = strip.base_reaction(&state, [0.0; 3])?.total();
        let deflection = state.committed.u[strip.top()];
        found.push((wet as f64, [moment.abs(), shear.abs(), -axial, deflection, strip.settlement(&state.committed.u)]));
    }
    let finest = found[found.len() - 1].1;
    let rows = references.iter().enumerate().map(|(i, &(what, reference, tolerance, unit))| Row {
        convergence: found.iter().map(|(n, values)| (*n, values[i] / reference - 1.0)).collect(),
        ..Row::new(
            "C10",
            format!("strip 8.4 at rest, fibre wall: {what}"),
            (reference, CANTILEVER, Reference::ClosedForm),
            finest[i],
            (tolerance, unit),
        )
    });
    Ok(rows.collect())
}
