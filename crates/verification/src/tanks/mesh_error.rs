//! The estimated discretisation error of the harmonic engine against the true one.
//!
//! The estimate compares two meshes: the run's and one with elements half as long. The true error is the distance to a third mesh with
//! elements a quarter as long, whose own error is at most a sixteenth of the run's (h²). Estimates that are right within a factor of
//! 2 serve as an error bar; a factor is a distance in log₂. Errors below 0.2 % are not told apart: the peak of a history wanders
//! as much with the last digit of a frequency.

use crate::tanks::solid_against_harmonic::artificial;
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::{Options, simulate};
use tank::case::GroundMotion;
use tank::reference::{broad, case, material, slender};
use tank::{Case, Quantity, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "mesh-error",
    title: "Estimated mesh error against the true one",
    model: "Tanks 8.1 (ρ = 1 t/m³) and 8.3 (H = 5 m), a steel tank of 24 m in diameter with two courses, and a strip of concrete under \
            an artificial accelerogram of 6 s. Harmonic engine, default mesh; true error: distance to refinement 4. A row is \
            log₂ of the estimated over the true error, 0 where they are equal, within ±1 for a factor of 2; errors below 0.2 % count as \
            0.2 %.",
    ids: &[
        ("mesh-01", "tank of example 01"),
        ("mesh-03", "tank of example 03"),
        ("mesh-steel", "steel tank, R = 12 m, 12 m of water, 12 and 8 mm"),
        ("mesh-strip", "concrete strip, 5 m long, 2.57 m of water"),
    ],
    parts: &[Part::Fast(rows)],
};

/// Errors below this are not told apart.
const FLOOR: f64 = 2e-3;
/// Refinement of the mesh that stands for the truth.
const TRUTH: f64 = 4.0;

/// Estimated and true error of a quantity.
///
/// Errors: a failure of the engine.
fn errors(tank: Case, omega: f64) -> Result<Vec<(Quantity, f64, f64)>, engines::FeError> {
    let mut shaken = tank;
    shaken.ground_motion = Some(GroundMotion { horizontal: artificial(omega), transverse: None, vertical: None });
    let run = |refine: f64, mesh_error: bool| {
        let options = Options { refine, mesh_error, ..Options::default() };
        simulate(&shaken, &options)
    };
    let (found, truth) = (run(1.0, true)?, run(TRUTH, false)?);
    Ok(found
        .values
        .iter()
        // Crest and trough are the wave times a factor.
        .filter(|(quantity, _)| {
            !matches!(quantity, Quantity::RimHoopStress | Quantity::SloshingCrest | Quantity::SloshingTrough)
        })
        .map(|(quantity, value)| {
            let estimate = found.result.mesh_error.get(quantity.id()).copied();
            let distance = truth.values.get(quantity).map(|limit| (value / limit - 1.0).abs());
            (*quantity, estimate.unwrap_or(f64::NAN), distance.unwrap_or(f64::NAN))
        })
        .collect())
}

/// Estimated over true errors of all quantities of four tanks.
///
/// Errors: a failure of the engine.
pub(crate) fn rows() -> Answer {
    let steel = case(
        Shape::Cylinder { radius: 12.0 },
        &[(6.0, 12e-3), (7.0, 8e-3)],
        &material(210e9, 0.3, 7850.0),
        (1000.0, 12.0),
    );
    let strip = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    let concrete = case(strip, &[(3.0, 0.3)], &material(34e9, 0.2, 2950.0), (1000.0, 2.57));
    let mut rows = Vec::new();
    for (id, tank, omega) in [
        ("mesh-01", broad(1000.0), 3.0),
        ("mesh-03", slender(1000.0, 5.0), 3.1),
        ("mesh-steel", steel, 1.2),
        ("mesh-strip", concrete, 2.4),
    ] {
        for (quantity, estimate, distance) in errors(tank, omega)? {
            let floored = |error: f64| if error < FLOOR { FLOOR } else { error };
            rows.push(Row::new(
                id,
                quantity.title(),
                (0.0, "harmonic engine, refinement 4", Reference::SecondFormulation),
                (floored(estimate) / floored(distance)).log2(),
                (1.0, "log₂"),
            ));
        }
    }
    Ok(rows)
}
