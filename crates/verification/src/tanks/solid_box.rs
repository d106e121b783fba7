//! Rectangular tanks in the three-dimensional engine: waves in both directions, plates, static pressure.
//!
//! ```text
//! waves            ω² = g k tanh k h,  k² = (iπ/L)² + (jπ/B)²
//! convective mass  m_1/m = 8 tanh(α h)/(α h π²),  α = π/L                       (EN 1998-4 A.4, Graham and Rodriguez)
//! dry plates       ω a² √(ρ t/D): C-S-F-S 12.687, C-C-F-C 24.020, a/b = 1, ν = 0.3                   (Leissa 1973)
//! base moment      over ρ g H³ of three clamped edges, top free, B/H = 1 and 2: 0.035, 0.086, ν = 0.2         (PCA)
//! ```
//!
//! In a square box neighbouring walls in opposite phase turn their corner freely, walls in phase keep it by symmetry: a simply supported
//! and a clamped edge.

use std::f64::consts::PI;

use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::modes::Kind;
use engines::solid::model::TankModel;
use engines::solid::spectrum::{self, TankMode};
use engines::solid::system::System;
use engines::solid::{self, MeshSize, SolidOptions};
use engines::{FeError, Options};
use fem::progress::Silent;
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::reference::{GRAVITY, case, material};
use tank::{Case, Quantity, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "solid-box",
    title: "Rectangular tanks in three dimensions",
    model: "Boxes of four plates with monolithic corners, clamped at the base, free at the top; four-node shells, potential liquid on \
            hexahedra, uniform meshes of as many elements over half the length, half the breadth and the height as stated. Waves and \
            masses with walls of 3·10¹³ Pa, plates with a liquid of a millionth of their mass.",
    ids: &[
        ("box-waves", "rigid box of 10 × 6 m, 4 m of water: waves in both directions, convective mass"),
        ("box-plates", "square box of 5 m without liquid, walls of 5 cm: frequencies of plates"),
        ("box-pressure", "full square boxes 4 m high: moment in the middle of the base of a wall"),
    ],
    parts: &[Part::Fast(rows)],
};

const POTENTIAL: &str = "potential flow";
const LEISSA: &str = "Leissa 1973";
const PCA: &str = "PCA, Rectangular Concrete Tanks";

fn options() -> Options {
    Options { mesh_error: false, ..Options::default() }
}

/// A box of length, breadth, height, thickness and depth [m] under a short ground motion.
fn tank([length, breadth, height, thickness, depth]: [f64; 5], material: &tank::Material, density: f64) -> Case {
    let shape = Shape::Rectangle { length, breadth, strip: false };
    let mut case = case(shape, &[(height, thickness)], material, (density, depth));
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "pulse".into(),
            dt: 0.02,
            acceleration: vec![0.0, 0.5, 1.0, 0.5, 0.0],
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    case
}

fn mesh(length: usize, breadth: usize, height: usize) -> SolidOptions {
    SolidOptions {
        mesh: Some(MeshSize { radial: length, sectors: 2 * breadth, vertical: height }),
        ..SolidOptions::default()
    }
}

/// Modes of the parts `parts`, `most` of each kind, near ω [rad/s].
fn modes(case: &Case, mesh: &SolidOptions, omega: f64, parts: &[u32], most: usize) -> Result<Vec<TankMode>, FeError> {
    let tank = TankModel::new(case, &options(), mesh)?;
    let poles = [omega * omega, 6.25 * omega * omega];
    let system = System::new(&tank.model, &tank.assembler, &poles, 1 << 32)?;
    let mut found = Vec::new();
    for &part in parts {
        found.extend(spectrum::of_harmonic(&tank, &system, part, (72, most), &Silent)?);
    }
    Ok(found)
}

/// The frequency of a kind in a part that is nearest to `expected`, relative to it.
fn nearest(found: &[TankMode], kind: Kind, part: u32, expected: f64) -> f64 {
    let of_part = found.iter().filter(|m| m.kind == kind && m.harmonic == part);
    let ratios = of_part.map(|m| m.omega / expected);
    ratios.fold(f64::NAN, |best, r| if (best - 1.0).abs() < (r - 1.0).abs() { best } else { r })
}

fn waves() -> Answer {
    let stiff = material(3e13, 0.2, 2500.0);
    let (length, breadth, depth) = (10.0, 6.0, 4.0);
    let case = tank([length, breadth, 4.5, 1.0, depth], &stiff, 1000.0);
    let wanted = [(1, 0), (0, 1), (1, 1), (3, 0)];
    let found = [4, 8]
        .into_iter()
        .map(|n| Ok((n, modes(&case, &mesh(n, n, 2 * n), 1e4, &[1, 2, 3], 3)?)))
        .collect::<Result<Vec<(usize, Vec<TankMode>)>, FeError>>()?;
    let mut rows = Vec::new();
    for (i, j) in wanted {
        let k = PI * (f64::from(i) / length).hypot(f64::from(j) / breadth);
        let exact = (GRAVITY * k * (k * depth).tanh()).sqrt();
        let part = i % 2 + 2 * (j % 2);
        let ratio = |modes: &[TankMode]| nearest(modes, Kind::Sloshing, part, exact);
        let last = found.last().map_or(f64::NAN, |(_, modes)| ratio(modes));
        // Linear elements of length h overestimate k² by (k h)²/12 along each direction; twice the half of it.
        let step = PI / 16.0 * f64::from(i.max(j));
        rows.push(Row {
            remark: String::new(),
            printed: None,
            id: "box-waves".into(),
            what: format!("ω of wave ({i}, {j}), 8 elements over each half side"),
            reference: exact,
            source: POTENTIAL,
            kind: Reference::ClosedForm,
            computed: exact * last,
            tolerance: step * step / 12.0,
            unit: "rad/s",
            convergence: found.iter().map(|(n, modes)| (1.0 / *n as f64, (ratio(modes) - 1.0).abs())).collect(),
        });
    }
    let run = solid::respond(&case, &options(), &mesh(8, 4, 12), &Silent)?;
    let x = PI / length * depth;
    let convective = 8.0 * x.tanh() / (x * PI * PI);
    let value = run.values.get(&Quantity::ConvectiveMass).copied().unwrap_or(f64::NAN);
    // (π/16)²/24 in the frequency, and some times that in the mass.
    let reference = (convective, POTENTIAL, Reference::ClosedForm);
    let what = "first convective mass over that of the liquid".to_owned();
    rows.push(Row::new("box-waves", what, reference, value / case.liquid_mass(), (0.01, "–")));
    Ok(rows)
}

fn plates() -> Answer {
    let (side, thickness, nu) = (5.0_f64, 0.05_f64, 0.3_f64);
    let dry = tank([side, side, side, thickness, 4.0], &material(30e9, nu, 2500.0), 1e-4);
    let rigidity = 30e9 * thickness.powi(3) / (12.0 * (1.0 - nu * nu));
    let unit = (rigidity / (2500.0 * thickness)).sqrt() / (side * side);
    let found = modes(&dry, &mesh(8, 8, 16), 15.0 * unit, &[0], 3)?;
    let row = |(what, expected): (&str, f64)| {
        let computed = expected * nearest(&found, Kind::Structural, 0, expected * unit);
        // (π/16)²/12 = 0.3 % for a half wave, some times that beside clamped edges.
        let reference = (expected, LEISSA, Reference::Published);
        Row::new("box-plates", what.to_owned(), reference, computed, (0.015, "–"))
    };
    let phases = [("ω a² √(ρ t/D), neighbours in opposite phase", 12.687), ("the same, all in phase", 24.020)];
    Ok(phases.map(row).into())
}

fn pressure() -> Answer {
    let mut rows = Vec::new();
    for (ratio, expected) in [(1.0, 0.035), (2.0, 0.086)] {
        let height = 4.0_f64;
        let side = ratio * height;
        let case = tank([side, side, height, 0.2, height], &material(30e9, 0.2, 2500.0), 1000.0);
        let run = solid::respond(&case, &options(), &mesh(8, 8, 20), &Silent)?;
        let base = run.result.histories.iter().find(|s| s.id == "wall_moment_base");
        let moment = base.map_or(f64::NAN, |s| s.static_value.abs()) / (1000.0 * GRAVITY * height.powi(3));
        // Half a digit of the table, 3 % for its unstated method and the elements beside the clamped edge.
        let tolerance = 0.0005 / expected + 0.03;
        let reference = (expected, PCA, Reference::Published);
        let what = format!("moment over ρ g H³, breadth over height {ratio}");
        rows.push(Row::new("box-pressure", what, reference, moment, (tolerance, "–")));
    }
    Ok(rows)
}

/// All rows.
///
/// Errors: a failure of the engine.
pub(crate) fn rows() -> Answer {
    Ok([waves()?, plates()?, pressure()?].concat())
}
