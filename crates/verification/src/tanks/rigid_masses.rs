//! F6 to F8: masses and levers of the liquid in a rigid cylinder against potential flow.
//!
//! Tolerances are those of the theory manual for the default mesh (5 × 8 nine-node elements); the observed order of
//! convergence is asserted in `tests/convergence.rs`.

use std::f64::consts::PI;

use codes::mechanical::{self, Plan};

use super::rigid::RigidTank;
use super::{cylinder, row};
use crate::{Answer, Benchmark, Part};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "rigid-tank-masses",
    title: "Masses and levers of the liquid in a rigid cylinder",
    model: "Harmonic engine, wall translated or held: convective masses from the sloshing modes, impulsive mass \
            from the liquid with its surface free of pressure; default mesh.",
    ids: &[
        ("F6", "liquid mass in a rigid translation"),
        ("F7", "convective masses"),
        ("F8", "impulsive mass and its levers"),
    ],
    parts: &[Part::Fast(masses)],
};

/// Masses of potential flow.
const MASSES: &str = "series of Veletsos & Yang 1977";

fn masses() -> Answer {
    let mut rows = Vec::new();
    let total = |radius: f64, depth: f64| RigidTank::DENSITY * PI * radius * radius * depth;
    let tank = cylinder(1.83, 1.525, 1, 1.0)?;
    let mass = total(1.83, 1.525);
    let what = "tank 8.1, mass moved by a rigid translation / liquid mass".to_string();
    rows.push(row("F6", what, "identity, φ = x lies in the space", (1.0, 1e-9), tank.translated_mass() / mass, "1"));
    let convective = tank.convective_masses()?;
    for (n, tolerance) in [0.001, 0.005, 0.03].into_iter().enumerate() {
        let reference = mechanical::convective(Plan::Circle, 1.525 / 1.83, n + 1).mass;
        let what = format!("tank 8.1, convective mass {} / liquid mass", n + 1);
        rows.push(row("F7", what, MASSES, (reference, tolerance), convective[n] / mass, "1"));
    }
    for (radius, depth) in [(1.83, 1.525), (1.83, 5.0), (10.0, 3.0)] {
        let found = cylinder(radius, depth, 1, 1.0)?.impulsive()?;
        let reference = mechanical::impulsive(Plan::Circle, depth / radius);
        let values = [
            ("m_i/m", reference.mass, found.mass / total(radius, depth)),
            ("h_i/H", reference.lever, found.lever / depth),
            ("h_i'/H", reference.lever_with_base, found.lever_below / depth),
        ];
        for (symbol, reference, computed) in values {
            let what = format!("R {radius} m, H {depth} m: {symbol}");
            rows.push(row("F8", what, MASSES, (reference, 0.005), computed, "1"));
        }
    }
    Ok(rows)
}
