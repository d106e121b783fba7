//! Impedances of a rigid disc.
//!
//! Source:    Veletsos & Verbic 1973; Meek & Wolf 1992; Gazetas 1983
//! Model:     `soil::disc`, `soil::chain`
//! Reference: closed forms; the published constants; matrices of the chain solved by another program's elimination
//! Tolerance: closed forms 1e-12 (rounding); the high-frequency limit of translation, ρ_s V_s π R², against the fitted b₁: 2 %, the
//!            fit is printed with two digits; matrices against the series of springs 1e-10 (rounding of a 4 × 4 solution whose entries
//!            differ by 1e4)

use std::f64::consts::{PI, TAU};

use ::soil::C64;
use ::soil::chain::Chain;
use ::soil::disc::{Disc, Impedance, Soil};
use nalgebra::{Matrix4, Vector4};

use super::{IMPULSIVE, failure, on_soil, soil};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "soil-impedances",
    title: "Impedances of a rigid disc on soil",
    model: "A rigid disc of 10 m on a half-space or a layer, ρ_s = 1900 kg/m³, V_s = 250 m/s; springs, dashpots and an internal rotation \
            (cones) with constant coefficients.",
    ids: &[
        ("G1", "static stiffness, layers"),
        ("G2", "internal rotation of the rocking cone against the closed impedance"),
        ("G3", "cones and fitted functions of Veletsos & Verbic"),
        ("G4", "steady deformation of tank B on cones: matrices against springs in series"),
    ],
    parts: &[Part::Fast(statics), Part::Fast(internal_rotation), Part::Fast(published), Part::Fast(sweep)],
};

const RADIUS: f64 = 10.0;

fn disc(soil: Soil) -> Result<Disc, Failure> {
    Disc::new(RADIUS, soil).map_err(failure)
}

fn row(id: &str, what: String, reference: f64, computed: f64, tolerance: f64, unit: &'static str) -> Row {
    let source = "closed form";
    Row::new(id, what, (reference, source, Reference::ClosedForm), computed, (tolerance, unit))
}

fn statics() -> Answer {
    let mut rows = Vec::new();
    // By hand: G = 1900 · 250² = 118.75 MPa, ν = 0.25.
    let s = disc(soil(250.0, 0.25))?.stiffness();
    let by_hand = [
        ("horizontal", 9.5e9 / 1.75, s.horizontal, "N/m"),
        ("rocking", 9.5e11 / 2.25, s.rocking, "N*m"),
        ("vertical", 4.75e9 / 0.75, s.vertical, "N/m"),
        ("torsional", 1.9e12 / 3.0, s.torsional, "N*m"),
    ];
    for (what, reference, computed, unit) in by_hand {
        rows.push(row("G1", format!("{what} stiffness, ν = 0.25"), reference, computed, 1e-12, unit));
    }
    let layer = |depth| Soil { depth: Some(depth), ..soil(250.0, 0.25) };
    let thin = disc(layer(20.0))?.stiffness();
    let factors = [
        ("horizontal", 1.25, thin.horizontal / s.horizontal),
        ("rocking", 13.0 / 12.0, thin.rocking / s.rocking),
        ("vertical", 1.64, thin.vertical / s.vertical),
    ];
    for (what, reference, computed) in factors {
        let what = format!("{what} stiffness of a layer of d = 2 R over that of a half-space");
        rows.push(row("G1", what, reference, computed, 1e-12, "1"));
    }
    let deep = disc(layer(1e9))?.stiffness();
    let what = "horizontal stiffness of a layer of 10⁹ m".to_owned();
    rows.push(row("G1", what, s.horizontal, deep.horizontal, 1e-7, "N/m"));
    Ok(rows)
}

/// The impedance with the internal rotation eliminated, against 1 − b₀²/(3 (1 + b₀²)) + i b₀³/(3 (1 + b₀²)).
fn internal_rotation() -> Answer {
    let mut rows = Vec::new();
    for nu in [0.0, 1.0 / 3.0, 0.45] {
        let (_, radius, tank) = IMPULSIVE[0];
        let mut on = on_soil(radius, tank, 250.0)?;
        on.disc.soil.poisson_ratio = nu;
        let cones = on.disc.cones();
        for b0 in [0.1, 1.0, 3.0] {
            let chain = Chain::rocking_impedance(&on, b0 / cones.travel_time) / cones.stiffness.rocking;
            // C²/M = K_θ/3 for every ν with the apex of the cone.
            let share = b0 * b0 / (1.0 + b0 * b0) / 3.0;
            let closed = C64::new(1.0 - share, b0 * share);
            for (part, reference, computed) in [("real", closed.re, chain.re), ("imaginary", closed.im, chain.im)] {
                let what = format!("{part} part over K_θ, ν = {nu:.2}, b₀ = {b0}");
                rows.push(row("G2", what, reference, computed, 1e-12, "1"));
            }
        }
    }
    Ok(rows)
}

fn published() -> Answer {
    const SOURCE: &str = "Veletsos & Verbic 1973";
    let mut rows = Vec::new();
    let source = |value| (value, SOURCE, Reference::Published);
    for (nu, b1) in [(0.0, 0.775), (1.0 / 3.0, 0.65), (0.45, 0.60)] {
        let disc = disc(soil(250.0, nu))?;
        let omega = disc.soil.shear_wave_velocity / RADIUS;
        let k = disc.stiffness().horizontal;
        let what = format!("b₁ of the translational cone, ν = {nu:.2}");
        let cone = disc.horizontal(omega, Impedance::Cone).im / k;
        rows.push(Row::new("G3", what, source(b1), cone, (0.02, "1")));
        let what = format!("b₁ of the fitted function, ν = {nu:.2}");
        let fit = disc.horizontal(omega, Impedance::Veletsos).im / k;
        rows.push(Row::new("G3", what, source(b1), fit, (1e-12, "1")));
    }
    let disc = disc(soil(250.0, 1.0 / 3.0))?;
    let k = disc.stiffness().rocking;
    for a0 in [0.5, 1.0, 2.0] {
        let omega = a0 * disc.soil.shear_wave_velocity / RADIUS;
        let square: f64 = 0.64 * a0 * a0;
        let share = square / (1.0 + square);
        let fit = disc.rocking(omega, Impedance::Veletsos) / k;
        let cone = disc.rocking(omega, Impedance::Cone) / k;
        let expected = C64::new(1.0 - 0.5 * share, 0.4 * a0 * share);
        let parts = [("real", expected.re, fit.re, cone.re), ("imaginary", expected.im, fit.im, cone.im)];
        for (part, reference, fit, cone) in parts {
            let what = format!("{part} part of rocking over K_θ, ν = 1/3, a₀ = {a0}");
            rows.push(Row::new("G3", format!("{what}: fitted function"), source(reference), fit, (1e-12, "1")));
            // The cone has one constant where the fit has two: for comparison.
            rows.push(Row::new("G3", format!("{what}: cone"), source(reference), cone, (f64::INFINITY, "1")));
        }
    }
    // Trapped soil, ν = 0.45.
    let cones = Disc::new(RADIUS, soil(250.0, 0.45)).map_err(failure)?.cones();
    let extra = 0.45 - 1.0 / 3.0;
    let inertia = 0.3 * PI * extra * 1900.0 * 1e5;
    rows.push(row("G3", "trapped moment of inertia, ν = 0.45".into(), inertia, cones.trapped_inertia, 1e-12, "kg*m2"));
    Ok(rows)
}

fn sweep() -> Answer {
    let (_, radius, tank) = IMPULSIVE[0];
    let on = on_soil(radius, tank, 250.0)?;
    let chain = Chain::new(&on, [0.0, 0.0]).map_err(failure)?;
    let mut rows = Vec::new();
    for period in [1.0, 0.3, 0.284, 0.2, 0.1] {
        let omega = TAU / period;
        let dynamic = chain.dynamic(C64::new(0.0, omega));
        let matrix = Matrix4::from_fn(|i, j| nalgebra::Complex::new(dynamic[i][j].re, dynamic[i][j].im));
        let load = Vector4::from_fn(|i, _| nalgebra::Complex::new(if i == 0 { -chain.mass[0][0] } else { 0.0 }, 0.0));
        let x = matrix.lu().solve(&load).ok_or_else(|| Failure::from("singular".to_owned()))?;
        let u = x[0] - x[1] - x[2] * on.structure.height;
        let computed = u.norm() * on.structure.stiffness() / on.structure.mass;
        let what = format!("deformation times ω² over the ground acceleration, tank B, period {period} s");
        let reference = on.deformation(omega, Impedance::Cone);
        rows.push(row("G4", what, reference, computed, 1e-10, "1"));
    }
    Ok(rows)
}
