//! F1 to F4 and F17: sloshing in a rigid cylinder against potential flow.
//!
//! Tolerances are those of the theory manual for the default mesh (5 × 8 nine-node elements); the observed order of
//! convergence is asserted in `tests/convergence.rs`.

use std::f64::consts::PI;

use super::{cylinder, exact, row};
use crate::{Answer, Benchmark, Part, Row};
use engines::FeError;
use engines::liquid::LiquidMesh;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "rigid-tank-sloshing",
    title: "Sloshing in a rigid cylinder",
    model: "Harmonic engine, wall held: displacement potential on nine-node elements over (r, z), default mesh 5 \
            × 8 graded towards wall and surface. Tanks 8.1 (R = 1.83 m, H = 1.525 m), 8.2 (R = 9.6 cm) and 8.3 \
            (R = 1.83 m, H = 3 to 5 m) of the dissertation, g = 9.81 m/s².",
    ids: &[
        ("F1", "first three sloshing frequencies of tank 8.1, m = 1"),
        ("F2", "sloshing frequencies of other wave numbers around"),
        ("F3", "model tank 8.2 at five depths"),
        ("F4", "slender tank 8.3 at five depths"),
        ("F17", "similarity: a hundred times the size, a tenth of the frequency"),
    ],
    parts: &[Part::Fast(sloshing)],
};

/// Potential flow in a rigid upright cylinder.
const CYLINDER: &str = "ω² = g λ/R tanh(λ H/R), J_m'(λ) = 0 (Lamb 1932)";

fn sloshing() -> Answer {
    let mut rows = Vec::new();
    let zero = codes::bessel::j_prime_zero;
    let omega = cylinder(1.83, 1.525, 1, 1.0)?.sloshing()?;
    let mut studies = convergence()?;
    for (n, tolerance) in [0.0005, 0.001, 0.003].into_iter().enumerate() {
        let reference = exact(1.83, 1.525, zero(1, n + 1));
        let what = format!("tank 8.1, m = 1, sloshing mode {}", n + 1);
        rows.push(Row {
            convergence: std::mem::take(&mut studies[n]),
            ..row("F1", what, CYLINDER, (reference, tolerance), omega[n], "rad/s")
        });
    }
    for harmonic in [0, 2, 3, 4] {
        let computed = cylinder(1.83, 1.525, harmonic, 1.0)?.sloshing()?[0];
        let reference = exact(1.83, 1.525, zero(harmonic, 1));
        let what = format!("tank 8.1, m = {harmonic}, sloshing mode 1");
        rows.push(row("F2", what, CYLINDER, (reference, 0.001), computed, "rad/s"));
    }
    for depth in [0.03, 0.06, 0.09, 0.12, 0.15] {
        let computed = cylinder(0.096, depth, 1, 1.0)?.sloshing()?[0] / (2.0 * PI);
        let reference = exact(0.096, depth, zero(1, 1)) / (2.0 * PI);
        let what = format!("tank 8.2, H = {:.0} cm, first frequency", depth * 100.0);
        rows.push(row("F3", what, CYLINDER, (reference, 0.0005), computed, "Hz"));
    }
    for depth in [3.0, 3.5, 4.0, 4.5, 5.0] {
        let computed = cylinder(1.83, depth, 1, 1.0)?.sloshing()?[0];
        let reference = exact(1.83, depth, zero(1, 1));
        let what = format!("tank 8.3, H = {depth:.1} m, first frequency");
        rows.push(row("F4", what, CYLINDER, (reference, 0.0005), computed, "rad/s"));
    }
    let large = cylinder(183.0, 152.5, 1, 1.0)?.sloshing()?;
    for n in 0..3 {
        let what = format!("tank 8.1 × 100, sloshing mode {}: 0.1 of F1", n + 1);
        rows.push(row("F17", what, "similarity, ω ∝ 1/√length", (0.1 * omega[n], 1e-6), large[n], "rad/s"));
    }
    Ok(rows)
}

/// (elements, relative error) of the first three sloshing frequencies of tank 8.1 on refined meshes.
fn convergence() -> Result<[Vec<(f64, f64)>; 3], FeError> {
    let mut studies = [const { Vec::new() }; 3];
    for refine in [0.5, 1.0, 2.0, 4.0] {
        let (radial, vertical) = LiquidMesh::graded(1.83, 1.525, refine).elements();
        let omega = cylinder(1.83, 1.525, 1, refine)?.sloshing()?;
        for (n, study) in studies.iter_mut().enumerate() {
            let error = omega[n] / exact(1.83, 1.525, codes::bessel::j_prime_zero(1, n + 1)) - 1.0;
            study.push(((radial * vertical) as f64, error));
        }
    }
    Ok(studies)
}
