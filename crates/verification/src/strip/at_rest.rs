//! C10: the strip at rest.

use std::sync::Arc;

use super::{DEPTH, HALF_WIDTH, HEIGHT, PLANE_MODULUS, THICKNESS, elastic_section, tank};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::strip::{StripDamping, StripError, StripModel, StripTank};
use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::newton::{Criteria, Newton, StepFailure};
use fem::analysis::scheme::LoadStep;
use fem::element::Inspect;
use fem::element::fibre_beam::Options;
use fem::state::{Gather, State};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-at-rest",
    title: "Strip 8.4 at rest",
    model: "Fibre beams and the liquid condensed onto them in closed form: L = 5 m, H = 2.57 m, wall 3.00 m × \
            0.30 m in plane strain, bars of 7.0 cm²/m on each face.",
    ids: &[
        ("C10", "strip 8.4 of fibres at rest, dissertation table 8.13"),
        ("table-8.12", "section forces of the lowest element, dissertation table 8.12"),
    ],
    parts: &[Part::Fast(statics), Part::Fast(lowest_element)],
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
        let [shear, axial, moment] = strip.base_reaction(&strip.walls[0], &state, [0.0; 3])?.total();
        let deflection = state.committed.u[strip.top(&strip.walls[0])];
        found.push((wet as f64, [moment.abs(), shear.abs(), -axial, deflection, strip.settlement(&state.committed.u)]));
    }
    let finest = found[found.len() - 1].1;
    let rows = references.iter().enumerate().map(|(i, &(what, reference, tolerance, unit))| {
        let row = Row {
            convergence: found.iter().map(|(n, values)| (*n, values[i] / reference - 1.0)).collect(),
            ..Row::new(
                "C10",
                format!("strip 8.4 at rest, fibre wall: {what}"),
                (reference, CANTILEVER, Reference::ClosedForm),
                finest[i],
                (tolerance, unit),
            )
        };
        match PRINTED[i] {
            Some((printed, reason)) => row.printed(printed, reason),
            None => row,
        }
    });
    Ok(rows.collect())
}

/// Table 8.13 beside the rows of C10.
const PRINTED: [Option<(f64, &str)>; 5] = [
    None,
    None,
    None,
    Some((5.60e-3, "a slip of ten: table 8.16 has 0.56 mm at 0 %; the last 1.2 % are open")),
    Some((1.47e-3, "open: seven times what the deflections of both walls let the surface fall")),
];

/// Table 8.12: the lowest of 16 equal beams. Its forces are those of its middle, 9.4 cm above the base, where moment and shear are 25.3 and 30.7
/// of the 28.3 kNm/m and 33.0 kN/m at the base.
///
/// Tolerance: the table has whole numbers, rounded or cut (table 8.11 has 0.55 m for 0.556): one of the last digit.
fn lowest_element() -> Answer {
    let section = Arc::new(elastic_section()?);
    let sections = (0..16).map(|_| Arc::clone(&section)).collect();
    let levels = (0..=16).map(|i| HEIGHT * f64::from(i) / 16.0).collect();
    let tank = StripTank { levels, sections, ..tank(elastic_section()?, 10, 1.0, Options::default())? };
    let strip = StripModel::new(&tank, StripDamping::Rayleigh(Rayleigh::NONE))?;
    let state = at_rest(&strip)?;
    let element = &*strip.model.elements()[0];
    let mut gather = Gather::default();
    let motion = gather.motion(&strip.model, &state.committed, element);
    let found = element.sections(motion, &state.old[state.history(0)])?;
    let [below, above] =
        [found.first(), found.last()].map(|s| s.map_or([f64::NAN; 2], |s| [s.resultants[0], s.resultants[3]]));
    // Gauss' points: the moment of a cubic beam is linear between them.
    let between = HEIGHT / 16.0 / 3.0_f64.sqrt();
    let forces = [
        ("moment", 25e3, 0.5 * (below[1] + above[1]), 1.0 / 25.0, "Nm/m"),
        ("shear force", 30e3, (below[1] - above[1]) / between, 1.0 / 30.0, "N/m"),
        ("normal force", -22e3, 0.5 * (below[0] + above[0]), 1.0 / 22.0, "N/m"),
    ];
    let row = |(what, printed, found, tolerance, unit): (&str, f64, f64, f64, &'static str)| {
        // The sign of the table says on which side the wall is in tension.
        let found = if what == "normal force" { found } else { found.abs() };
        let reference = (printed, "dissertation, table 8.12", Reference::Dissertation);
        Row::new(
            "table-8.12",
            format!("strip 8.4 at rest, lowest of 16 beams: {what}"),
            reference,
            found,
            (tolerance, unit),
        )
    };
    Ok(forces.into_iter().map(row).collect())
}
