//! F5: sloshing between rigid plane walls against potential flow.
//!
//! Tolerances are those of the theory manual for the default mesh (5 × 8 nine-node elements); the observed order of
//! convergence is asserted in `tests/convergence.rs`.

use std::f64::consts::PI;

use super::rigid::RigidTank;
use super::row;
use crate::{Answer, Benchmark, Part};
use engines::liquid::Domain;
use tank::reference::GRAVITY;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "rigid-strip-sloshing",
    title: "Sloshing in a rigid rectangular strip",
    model: "Harmonic engine, plane strip of 5.00 m length, symmetric and antisymmetric half, default mesh, g = \
            9.81 m/s².",
    ids: &[("F5", "sloshing frequencies between plane walls")],
    parts: &[Part::Fast(strips)],
};

/// Potential flow in a rigid rectangle.
const RECTANGLE: &str = "ω² = n π g/L₀ tanh(n π H/L₀) (Lamb 1932)";

fn strips() -> Answer {
    let mut rows = Vec::new();
    for depth in [2.57, 5.0] {
        let modes = |symmetric: bool| {
            let domain = Domain::Strip { half_length: 2.5, breadth: 1.0, symmetric };
            RigidTank::new(domain, depth, GRAVITY, 1.0)?.sloshing()
        };
        let (odd, even) = (modes(false)?, modes(true)?);
        for (n, (computed, tolerance)) in [(odd[0], 0.0005), (even[0], 0.001), (odd[1], 0.003)].into_iter().enumerate()
        {
            let k = (n + 1) as f64 * PI / 5.0;
            let reference = (GRAVITY * k * (k * depth).tanh()).sqrt();
            let what = format!("strip 5.00 × {depth:.2} m, sloshing mode {}", n + 1);
            rows.push(row("F5", what, RECTANGLE, (reference, tolerance), computed, "rad/s"));
        }
    }
    Ok(rows)
}
