//! F1 to F8 and F17: the liquid in a rigid tank against potential flow.
//!
//! Tolerances are those of the theory manual for the default mesh (5 × 8 nine-node elements); the observed order of
//! convergence is asserted in `tests/verification`.

use std::f64::consts::PI;

use codes::mechanical::{self, Plan};

use super::rigid::RigidTank;
use super::{Reference, Row};
use engines::FeError;
use engines::liquid::{Domain, LiquidMesh};
use tank::reference::GRAVITY;

/// Potential flow in a rigid upright cylinder.
const CYLINDER: &str = "ω² = g λ/R tanh(λ H/R), J_m'(λ) = 0 (Lamb 1932)";
/// Potential flow in a rigid rectangle.
const RECTANGLE: &str = "ω² = n π g/L₀ tanh(n π H/L₀) (Lamb 1932)";
/// Masses of potential flow.
const MASSES: &str = "series of Veletsos & Yang 1977";

fn cylinder(radius: f64, depth: f64, harmonic: u32, refine: f64) -> Result<RigidTank, FeError> {
    RigidTank::new(Domain::Cylinder { radius, harmonic }, depth, GRAVITY, refine)
}

fn exact(radius: f64, depth: f64, zero: f64) -> f64 {
    (GRAVITY * zero / radius * (zero * depth / radius).tanh()).sqrt()
}

fn row(
    id: &str,
    what: String,
    source: &'static str,
    (reference, tolerance): (f64, f64),
    computed: f64,
    unit: &'static str,
) -> Row {
    Row {
        id: id.into(),
        page: match id {
            "F6" | "F7" | "F8" => "rigid-tank-masses",
            "F5" => "rigid-strip-sloshing",
            _ => "rigid-tank-sloshing",
        },
        what,
        reference,
        source,
        kind: Reference::ClosedForm,
        tolerance,
        computed,
        unit,
        convergence: Vec::new(),
    }
}

/// All rows of this file.
pub fn rows() -> Result<Vec<Row>, FeError> {
    let mut rows = Vec::new();
    sloshing(&mut rows)?;
    strips(&mut rows)?;
    masses(&mut rows)?;
    Ok(rows)
}

fn sloshing(rows: &mut Vec<Row>) -> Result<(), FeError> {
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
    for harmonic in [0, 2] {
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
        rows.push(row(
            "F17",
            what,
            "similarity, ω ∝ 1/√length",
            (0.1 * omega[n], 1e-6),
            large[n],
            "rad/s",
        ));
    }
    Ok(())
}

fn strips(rows: &mut Vec<Row>) -> Result<(), FeError> {
    for depth in [2.57, 5.0] {
        let modes = |symmetric: bool| {
            let domain = Domain::Strip {
                half_length: 2.5,
                breadth: 1.0,
                symmetric,
            };
            RigidTank::new(domain, depth, GRAVITY, 1.0)?.sloshing()
        };
        let (odd, even) = (modes(false)?, modes(true)?);
        for (n, (computed, tolerance)) in [(odd[0], 0.0005), (even[0], 0.001), (odd[1], 0.003)]
            .into_iter()
            .enumerate()
        {
            let k = (n + 1) as f64 * PI / 5.0;
            let reference = (GRAVITY * k * (k * depth).tanh()).sqrt();
            let what = format!("strip 5.00 × {depth:.2} m, sloshing mode {}", n + 1);
            rows.push(row("F5", what, RECTANGLE, (reference, tolerance), computed, "rad/s"));
        }
    }
    Ok(())
}

fn masses(rows: &mut Vec<Row>) -> Result<(), FeError> {
    let total = |radius: f64, depth: f64| RigidTank::DENSITY * PI * radius * radius * depth;
    let tank = cylinder(1.83, 1.525, 1, 1.0)?;
    let mass = total(1.83, 1.525);
    let what = "tank 8.1, mass moved by a rigid translation / liquid mass".to_string();
    rows.push(row(
        "F6",
        what,
        "identity, φ = x lies in the space",
        (1.0, 1e-9),
        tank.translated_mass() / mass,
        "1",
    ));
    let convective = tank.convective_masses()?;
    for (n, tolerance) in [0.001, 0.005, 0.03].into_iter().enumerate() {
        let reference = mechanical::convective(Plan::Circle, 1.525 / 1.83, n + 1).mass;
        let what = format!("tank 8.1, convective mass {} / liquid mass", n + 1);
        rows.push(row(
            "F7",
            what,
            MASSES,
            (reference, tolerance),
            convective[n] / mass,
            "1",
        ));
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
    Ok(())
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
