//! Static tilt test of the harmonic engine against statics.
//!
//! A tank on a base tilted by α carries, in its own axes, the gravity g sin α across its axis:
//!
//! ```text
//! V = (m_l + m_w + m_r) g sin α        M = (m_l H/2 + m_w z_w + m_r z_r) g sin α        M' = M + m_l R²/(4 H) g sin α
//! p(z, θ) = ρ g [cos α (H − z) + sin α R cos θ]        η(r) = r tan α        n_x(0, θ = 0) = M/(π R²) in compression
//! ```
//!
//! In three dimensions the wall is a polygon of N flat faces, on which the liquid presses: with nodes on the circle its faces have
//! sin(π/N)/(π/N) of the circle's surface, and V of the liquid that part of statics: an error of second order, (π/N)²/6.
//!
//! M above and M' below the base plate; R²/4H is the shift of the liquid's centre of pressure on the bottom. Source: statics.

use std::f64::consts::PI;

use super::row;
use crate::{Answer, Benchmark, Part, Row};
use engines::solid::{MeshSize, SolidOptions};
use engines::{FeError, Options, simulate, solid};
use fem::progress::Silent;
use oscillator::record::Record;
use results::channel::OnWall;
use tank::case::GroundMotion;
use tank::reference::broad;
use tank::{Case, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "tilt-test",
    title: "Static tilt test",
    model: "Harmonic engine, default mesh: tank 8.1 (ρ = 1 t/m³) with a roof of 120 kg, and a concrete strip of 8 m with 3 m of water, \
            at rest on a base tilted by 0.12 rad. Three-dimensional engine: the cylinder without a roof with 12, 24 and 48 sectors, 4 \
            rings and 12 levels.",
    ids: &[
        ("tilt-1", "resultants on the base of the cylinder"),
        ("tilt-2", "pressure, surface and force of the wall of the cylinder"),
        ("tilt-3", "shear of a plane strip"),
        (
            "tilt-4",
            "shear and moments of the three-dimensional engine, and their order of convergence with its sectors",
        ),
    ],
    parts: &[Part::Fast(rows), Part::Fast(polygon)],
};

/// Angle of the base [rad].
const ANGLE: f64 = 0.12;
const SOURCE: &str = "statics";

/// Errors: a failure of the engine.
fn rows() -> Answer {
    let mut case = broad(1000.0);
    case.tank.roof.mass = 120.0;
    let found = tilted(&case)?;
    let (depth, radius) = (1.525, 1.83);
    let across = case.gravity * ANGLE.sin();
    // By hand: cylinders of liquid and of two courses of 0.915 m.
    let liquid = 1000.0 * PI * radius * radius * depth;
    let [lower, upper] = [2.03e-3, 1.27e-3].map(|t| 2750.0 * 2.0 * PI * radius * t * 0.915);
    let arm = liquid * 0.5 * depth + lower * 0.4575 + upper * 1.3725 + 120.0 * 1.83;
    let shear = across * (liquid + lower + upper + 120.0);
    let moment = across * arm;
    let below = moment + across * liquid * radius * radius / (4.0 * depth);
    // Equilibrium holds for any mesh: rounding of condensed systems with stiffnesses 10⁵ apart. The bottom's moment is an integral of the
    // liquid's elements over r² (cubic with nine nodes), exact too, with less digits.
    let mut rows = vec![
        row("tilt-1", "base shear".into(), SOURCE, (shear, 1e-8), value(&found, "base_shear"), "N"),
        row(
            "tilt-1",
            "moment above the base plate".into(),
            SOURCE,
            (moment, 1e-8),
            value(&found, "base_moment"),
            "N m",
        ),
        row(
            "tilt-1",
            "moment below the base plate".into(),
            SOURCE,
            (below, 1e-6),
            value(&found, "overturning_moment"),
            "N m",
        ),
    ];
    let weight = 1000.0 * case.gravity;
    for (what, side) in [("low", 1.0), ("high", -1.0)] {
        if let Some(values) = found.line(OnWall::Pressure.id(), what) {
            let expected = weight * (ANGLE.cos() * depth + side * ANGLE.sin() * radius);
            rows.push(row(
                "tilt-2",
                format!("pressure at the base, {what} side"),
                SOURCE,
                (expected, 1e-6),
                values.first().map_or(f64::NAN, |point| point[0]),
                "Pa",
            ));
        }
    }
    let surface = found.table("surface").map(|table| table.column("rise"));
    // The surface moves with the wall, which bulges by 1e-5 of its radius.
    rows.push(row(
        "tilt-2",
        "rise of the surface at the wall".into(),
        SOURCE,
        (radius * ANGLE.tan(), 1e-4),
        surface.and_then(|rise| rise.last().copied()).unwrap_or(f64::NAN),
        "m",
    ));
    let axial = |side: &str| found.line(OnWall::Axial.id(), side).and_then(|points| points.first());
    if let (Some(low), Some(high)) = (axial("low"), axial("high")) {
        // The middle surface is at R in the model; fluxes at a clamped node err by the mesh: half a percent, as in the wall's statics.
        let amplitude = 0.5 * (high[0] - low[0]) * 2.03e-3;
        rows.push(row(
            "tilt-2",
            "amplitude of the axial force at the base".into(),
            SOURCE,
            (moment / (PI * radius * radius), 5e-3),
            amplitude,
            "N/m",
        ));
    }
    rows.push(strip()?);
    Ok(rows)
}

/// Base shear and moments of polygons.
///
/// Errors: a failure of the engine.
fn polygon() -> Answer {
    let case = broad(1000.0);
    let (depth, radius) = (1.525, 1.83);
    let liquid = 1000.0 * PI * radius * radius * depth;
    let [lower, upper] = [2.03e-3, 1.27e-3].map(|t| 2750.0 * 2.0 * PI * radius * t * 0.915);
    let across = case.gravity * ANGLE.sin();
    let shear = across * (liquid + lower + upper);
    let moment = across * (liquid * 0.5 * depth + lower * 0.4575 + upper * 1.3725);
    let mut rows = Vec::new();
    let mut errors = Vec::new();
    for sectors in [12, 24, 48] {
        let mesh = MeshSize { radial: 4, sectors, vertical: 12 };
        let solid = SolidOptions { mesh: Some(mesh), ..SolidOptions::default() };
        let options = Options { mesh_error: false, ..Options::default() };
        let found = solid::tilted(&case, ANGLE, &options, &solid, &Silent)?;
        errors.push((sectors as f64, (value(&found, "base_shear") / shear - 1.0).abs()));
        if sectors != 48 {
            continue;
        }
        // 48 sectors: 7e-4 of the polygon; 1e-3 is asked for.
        for (what, expected, value, unit) in [
            ("base shear", shear, value(&found, "base_shear"), "N"),
            ("moment above the base plate", moment, value(&found, "base_moment"), "N m"),
        ] {
            rows.push(row("tilt-4", format!("{sectors} sectors: {what}"), SOURCE, (expected, 1e-3), value, unit));
        }
    }
    let order = (errors[0].1 / errors[2].1).ln() / 4.0_f64.ln();
    let mut order = row(
        "tilt-4",
        "order of convergence of the base shear from 12 to 48 sectors".into(),
        "polygon in a circle",
        (2.0, 0.1),
        order,
        "–",
    );
    order.convergence = errors;
    rows.push(order);
    Ok(rows)
}

/// ρ H L b and the walls, times g sin α.
fn strip() -> Result<Row, FeError> {
    let shape = Shape::Rectangle { length: 8.0, breadth: 1.0, strip: true };
    let concrete = tank::reference::material(30e9, 0.2, 2500.0);
    let case = tank::reference::case(shape, &[(4.0, 0.3)], &concrete, (1000.0, 3.0));
    let found = tilted(&case)?;
    let mass = 1000.0 * 8.0 * 3.0 + 2.0 * 2500.0 * 4.0 * 0.3;
    Ok(row(
        "tilt-3",
        "base shear of the strip, a metre of it".into(),
        SOURCE,
        (mass * case.gravity * ANGLE.sin(), 1e-8),
        value(&found, "base_shear"),
        "N",
    ))
}

/// The tilt test beside a history that is of no account.
fn tilted(case: &Case) -> Result<results::Part, FeError> {
    let mut case = case.clone();
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "short".into(),
            dt: 0.01,
            acceleration: vec![0.0, 0.1, 0.0],
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    let options = Options { tilt: Some(ANGLE), mesh_error: false, ..Options::default() };
    let found = simulate(&case, &options)?.result.part("tilt").cloned();
    found.ok_or_else(|| FeError::Analysis("the tilt test has no result".into()))
}

fn value(tilt: &results::Part, id: &str) -> f64 {
    tilt.value(id).map_or(f64::NAN, |found| found.value.value)
}
