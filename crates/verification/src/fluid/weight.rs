//! K3: cylinder under its own weight (5.3.2.2), R = H = 5 m, 8 × 8 × 8 elements.
//!
//! Exact: p = ρ g (H − z) + ρ g u_s with u_s = −½ ρ g H²/(K + ρ g H) at the surface, whose spring carries the second
//! term; no horizontal motion. A linear pressure is met at the centre of every element, whatever the mesh.
//!
//! The dissertation blames the Cartesian coordinates for nonsense displacements. Both charts give them when the volume
//! part is taken at one point and the weight is integrated fully, and both are exact when the quadratures match.

use std::sync::Arc;

use super::tank::{Sector, Tank};
use super::{BULK_MODULUS, GRAVITY, Source};
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::chart::Chart;
use fem::element::{Inspect, LiquidProperties, RotationPart, VolumePart};
use fem::linalg::{Kind, Ordering, Symbolic};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-weight",
    title: "Cylinder of liquid under its own weight",
    model: "R = H = 5 m, 8 × 8 × 8 `fluid8` between rigid walls, free surface with its stiffness ρ g.",
    ids: &[("K3", "pressure and settlement under self-weight")],
    parts: &[Part::Fast(self_weight)],
};

const SIZE: f64 = 5.0;

const TANK: Tank = Tank { radius: SIZE, fill: SIZE, counts: [8, 8, 8], grading: 1.0, part: Sector::Whole };

/// Results of a solution under self-weight.
struct Settlement {
    /// Pressure farthest from the exact one, over the exact one.
    pressure: f64,
    /// Greatest horizontal displacement over the exact settlement of the surface.
    horizontal: f64,
    /// Greatest vertical displacement over the same.
    vertical: f64,
}

/// Solves under a weight integrated by `load`.
fn solve(chart: Chart, volume: VolumePart, load: VolumePart) -> Result<Settlement, Failure> {
    let liquid = |volume| LiquidProperties {
        density: 1.0,
        bulk_modulus: BULK_MODULUS,
        volume,
        rotation: RotationPart::split(GRAVITY, SIZE),
    };
    let built = TANK.build(chart, liquid(volume), GRAVITY, true)?;
    let model = &built.model;
    let k = built.assembler.stiffness(model)?;
    // Same nodes and supports, hence the same unknowns.
    let weight = TANK.build(chart, liquid(load), GRAVITY, true)?;
    let force = weight.assembler.body_force(&weight.model, [0.0, 0.0, -GRAVITY]);
    let symbolic = Arc::new(Symbolic::new(k.pattern.clone(), &Ordering::MinimumDegree)?);
    let u = symbolic.factor(&k, Kind::Definite)?.solve_vector(&force)?;
    let settlement = 0.5 * GRAVITY * SIZE * SIZE / (BULK_MODULUS + GRAVITY * SIZE);
    let (mut horizontal, mut vertical) = (0.0_f64, 0.0_f64);
    for node in 0..model.nodes().len() {
        let at = model.at_node(&u, node);
        horizontal = horizontal.max(at[0].hypot(at[1]));
        vertical = vertical.max(at[2].abs());
    }
    let mut worst = 1.0_f64;
    for element in &built.elements {
        let sample = &element.samples()[0];
        let found: f64 = model.spread(element, &sample.row).iter().map(|(&e, c)| c * u[e]).sum();
        let ratio = found / (GRAVITY * (SIZE - sample.position[2] - settlement));
        if (ratio - 1.0).abs() > (worst - 1.0).abs() {
            worst = ratio;
        }
    }
    Ok(Settlement { pressure: worst, horizontal: horizontal / settlement, vertical: vertical / settlement })
}

/// K3, and the quadratures that do not match.
///
/// Tolerance 10⁻⁴ as asked; rounding is far below.
///
/// Errors: none to be expected.
pub(crate) fn self_weight() -> Answer {
    let against = Source { source: "hydrostatics of a compressible column", kind: Reference::ClosedForm };
    let mut rows = Vec::new();
    let charts = [(Chart::Cartesian, "Cartesian"), (Chart::Cylindrical, "cylindrical")];
    for (chart, coordinates) in charts {
        for (name, volume) in [
            ("mean dilatation, full load", VolumePart::MeanDilatation),
            ("one point, one-point load", VolumePart::OnePoint),
        ] {
            let s = solve(chart, volume, volume)?;
            let what = |quantity: &str| format!("{coordinates}, {name}: {quantity}");
            rows.push(against.row("K3", what("pressure/exact"), (1.0, s.pressure), 1e-4, "-"));
            rows.push(against.row("K3", what("u_h/settlement"), (0.0, s.horizontal), 1e-4, "-"));
            rows.push(against.row("K3", what("u_z/settlement"), (1.0, s.vertical), 1e-4, "-"));
        }
        let s = solve(chart, VolumePart::OnePoint, VolumePart::MeanDilatation)?;
        let what = format!("{coordinates}, one point, full load (fails): u_z/settlement");
        rows.push(against.row("K3", what, (1.0, s.vertical), f64::INFINITY, "-"));
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Weight and pressure force that do not match drive circulation far beyond the settlement, in both charts.
    #[test]
    fn mismatched_quadrature_fails_in_both_charts() {
        for chart in [Chart::Cartesian, Chart::Cylindrical] {
            let s = solve(chart, VolumePart::OnePoint, VolumePart::MeanDilatation).unwrap();
            assert!(s.vertical > 10.0, "{chart:?} {}", s.vertical);
        }
    }
}
