//! C11: the linear response of the strip.

use oscillator::record::Record;

use super::at_rest::at_rest;
use super::{elastic_section, tank};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::strip::{StripDamping, StripError, StripModel};
use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::transient::{Load, Settings, integrate};
use fem::element::fibre_beam::Options;
use fem::progress::Silent;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-linear-response",
    title: "Strip 8.4, linear, under El Centro",
    model: "As at rest, under the Caltech record (0.348 g), which may not be redistributed, with the dampings \
            that all read 1 to 2 %.",
    ids: &[("C11", "linear response under six dampings"), ("table-8.14", "dissertation table 8.14")],
    parts: &[Part::Record(linear)],
};

const PROTOTYPE: &str = "independent prototype (theory of the strip)";

/// Largest deflection of the top [m], moment at the base [Nm/m] and elevation at the wall [m], both walls.
pub(super) fn peaks(strip: &StripModel, record: &Record, longest_step: f64) -> Result<[f64; 3], StripError> {
    let state = at_rest(strip)?;
    let [_, _, moment] = strip.base_reaction(&strip.walls[0], &state, [0.0; 3])?.total();
    let offsets = [state.committed.u[strip.top(&strip.walls[0])], moment, 0.0];
    let mut observables = strip.observables();
    observables.insert(1, strip.base_moment());
    let grid = Grid::new(record.dt, record.duration(), 0.0, longest_step);
    let load = Load::ground(0, Motion::new(record, &grid));
    let settings = Settings::new(grid);
    let found =
        integrate(&strip.system, &strip.symbolic, std::slice::from_ref(&load), &settings, &observables, &[], &Silent)?;
    let mut out = [0.0; 3];
    for (i, history) in found[0].observed.scalars.iter().enumerate() {
        let e = history.extreme;
        // The other wall: dynamic part with the opposite sign.
        out[i] = [e.max, -e.min, e.min, -e.max].iter().fold(0.0, |m: f64, d| m.max((offsets[i] + d).abs()));
    }
    Ok(out)
}

/// Table of the response to `record` (El Centro, 0.348 g) under six dampings: rows 1 and 5 are asked for, the others shown.
///
/// Errors: those of the model and of the integration.
pub(crate) fn linear(record: &Record) -> Answer {
    let fit = |first, second| Rayleigh::fit(first, second, true).map_err(AnalysisError::from);
    let (w1, w2) = (2.39, 3.53);
    let cases = [
        ("Rayleigh 1 %/1 %", StripDamping::Rayleigh(fit((w1, 0.01), (w2, 0.01))?), [1.268e-3, 53.7e3, 0.441], 0.02),
        (
            "Rayleigh 1 %/2 % (negative a_M)",
            StripDamping::Rayleigh(fit((w1, 0.01), (w2, 0.02))?),
            [1.22e-3, 51e3, 0.423],
            f64::INFINITY,
        ),
        (
            "mass-proportional 1 %",
            StripDamping::Rayleigh(Rayleigh::mass_proportional(w1, 0.01)),
            [2.21e-3, 85.6e3, 0.464],
            f64::INFINITY,
        ),
        (
            "mass-proportional 3 %",
            StripDamping::Rayleigh(Rayleigh::mass_proportional(w1, 0.03)),
            [2.19e-3, 84.9e3, 0.350],
            f64::INFINITY,
        ),
        (
            "by group: wall 2 %, sloshing 0.5 %",
            StripDamping::ByGroup { wall: 0.02, sloshing: 0.005 },
            [1.76e-3, 70.2e3, 0.494],
            0.02,
        ),
        (
            "by group: wall 5 %, sloshing 0.5 %",
            StripDamping::ByGroup { wall: 0.05, sloshing: 0.005 },
            [1.55e-3, 63.1e3, 0.494],
            f64::INFINITY,
        ),
    ];
    let mut rows = Vec::new();
    for (name, damping, references, tolerance) in cases {
        let strip = StripModel::new(&tank(elastic_section()?, 15, 1.0, Options::default())?, damping)?;
        let found = peaks(&strip, record, 2.5e-3)?;
        for (i, (what, unit)) in OBSERVED.into_iter().enumerate() {
            rows.push(Row::new(
                "C11",
                format!("strip 8.4, {name} (wall mode {:.3} %): {what}", 100.0 * strip.wall_ratio()),
                (references[i], PROTOTYPE, Reference::SecondFormulation),
                found[i],
                (tolerance, unit),
            ));
        }
        if rows.len() == 3 {
            rows.extend(table(name, &found));
        }
    }
    Ok(rows)
}

/// Table 8.14, whose damping is not printed, beside the response under 1 % in both modes. The deflection has two digits, half of the last is
/// 3.8 %; wave and moment are those of the prototype, as in C11.
fn table(damping: &str, found: &[f64; 3]) -> Vec<Row> {
    let place = "a printed moment is that of the middle of the lowest element (table 8.12: 25 of 28.3 kNm/m at rest)";
    let row = |i: usize, reference, tolerance| {
        let (what, unit) = OBSERVED[i];
        Row::new("table-8.14", format!("strip 8.4, {damping}: {what}"), reference, found[i], (tolerance, unit))
    };
    let prototype = |value| (value, PROTOTYPE, Reference::SecondFormulation);
    vec![
        row(0, (1.3e-3, "dissertation, table 8.14", Reference::Dissertation), 0.0385),
        row(1, prototype(53.7e3), 0.02).printed(50.4e3, place),
        row(2, prototype(0.441), 0.02).printed(0.439, "the damping of the table is not printed"),
    ]
}

const OBSERVED: [(&str, &str); 3] =
    [("largest deflection of the top", "m"), ("largest moment at the base", "Nm/m"), ("largest wave at the wall", "m")];

#[cfg(test)]
mod tests {
    use super::*;

    /// ω of strip and tank, theory of the strip 8.4: sloshing 2.3863 rad/s, wall with liquid 100.7, second 557 rad/s.
    #[test]
    fn frequencies() {
        let strip = StripModel::new(
            &tank(elastic_section().unwrap(), 10, 1.0, Options::default()).unwrap(),
            StripDamping::ByGroup { wall: 0.02, sloshing: 0.005 },
        )
        .unwrap();
        assert!((strip.modes.omega[0] / 2.3863 - 1.0).abs() < 1e-3, "{}", strip.modes.omega[0]);
        assert!((strip.wall_frequency() / 100.7 - 1.0).abs() < 5e-3, "{}", strip.wall_frequency());
        assert!((strip.wall_ratio() - 0.02).abs() < 2e-4, "{}", strip.wall_ratio());
        assert!((strip.ratios[0].ratio - 0.005).abs() < 5e-5, "{}", strip.ratios[0].ratio);
    }
}
