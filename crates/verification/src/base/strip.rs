//! A strip of the bottom plate, lifted at its rim.
//!
//! Source:    Timoshenko's beam; Wozniak & Mitchell 1978 (two hinges); an independent program of the same strip
//! Model:     `base::Strip`: beams with the membrane force of von Karman, fibres, ground without tension, edge of a long cylinder
//! Reference: closed forms on rigid ground; F(w) of an independent program (beams of another discretisation, ground at nodes)
//! Tolerance: closed forms 1e-3: the ground gives way over a sinking length of 17 mm, a fortieth of the lifted length, in cube;
//!            independent program 1 % elastic, 4 % yielding (other fibres and ground points), plastic rotations 4 %, the smallest
//!            of them 0.001 rad

use ::base::{Bands, Lifted, Plan, Plate, Point, Rim, Strip, closed};

use super::{TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-strip",
    title: "Strip of a bottom plate, lifted at its rim",
    model: "A metre of the bottom plate from the rim to the centre, under the pressure of the liquid, on ground that pushes but does not \
            pull, at its rim the edge of a long cylinder. Tank A is the aluminium tank of Manos & Clough, B a tank 27.8 m in diameter \
            of Vathi & Karamanos, C example 05, D a slender one.",
    ids: &[
        ("U1", "closed forms on nearly rigid ground (k = 10¹² N/m³), without the wall's edge"),
        ("U2", "hold-down force against uplift on k = 10⁸ N/m³, with the wall's edge"),
    ],
    parts: &[Part::Fast(closed_forms), Part::Fast(tanks)],
};

const OTHER: &str = "independent program of the same strip";

fn lifted(strip: &Strip, weight: f64, uplifts: &[f64]) -> Result<Vec<Point>, Failure> {
    let mut state = Lifted::at_rest(strip, weight).map_err(failure)?;
    let mut points = Vec::new();
    for &w in uplifts {
        state.lift_to(w).map_err(failure)?;
        points.push(state.point());
    }
    Ok(points)
}

fn closed_forms() -> Answer {
    let plate = Plate { thickness: 0.01, young_modulus: 205e9, poisson_ratio: 0.3, yield_stress: None };
    let (pressure, length) = (128e3, 0.7);
    let mut rows = Vec::new();
    for (name, rim, expected) in [
        ("hinged", Rim::Hinged, closed::hinged(&plate, pressure, length)),
        ("clamped", Rim::Clamped, closed::clamped(&plate, pressure, length)),
    ] {
        let strip = Strip::new(Bands::uniform(plate), rim, 3.0, 1e12, pressure, Plan::Strip).map_err(failure)?;
        let point = lifted(&strip.refined(2.0), 0.0, &[expected.uplift])?[0];
        let source = "beam on rigid ground with a line reaction at the touch-down";
        rows.push(Row::new(
            "U1",
            format!("hold-down force, rim {name}"),
            (expected.hold_down, source, Reference::ClosedForm),
            point.hold_down,
            (1e-3, "N/m"),
        ));
    }
    let steel = Plate { yield_stress: Some(205e6), ..plate };
    let two = closed::two_hinges(&steel, pressure).unwrap_or(f64::NAN);
    let strip = Strip::new(Bands::uniform(steel), Rim::Clamped, 3.0, 1e12, pressure, Plan::Strip).map_err(failure)?;
    let point = lifted(&strip, 0.0, &[0.04])?[0];
    rows.push(Row::new(
        "U1",
        "hold-down force at 40 mm, rim yielding; hardening of 1 % and membrane force raise it",
        (two, "two plastic hinges, 2 √(p M_p)", Reference::ClosedForm),
        point.hold_down,
        (0.1, "N/m"),
    ));
    Ok(rows)
}

/// Uplifts [m] of the table, and F [kN/m] of the independent program.
const UPLIFTS: [f64; 5] = [1e-3, 10e-3, 20e-3, 50e-3, 100e-3];
const ELASTIC: [[f64; 5]; 4] = [
    [1.15, 2.19, 2.88, 4.90, 8.65],
    [36.6, 51.2, 60.0, 77.5, 99.7],
    [38.4, 52.9, 61.6, 78.4, 98.4],
    [19.4, 30.4, 36.7, 50.0, 69.0],
];
const YIELDING: [[f64; 5]; 4] = [
    [1.15, 2.19, 2.88, 4.81, 7.92],
    [35.8, 44.1, 49.0, 58.2, 72.7],
    [37.7, 46.0, 50.8, 59.6, 71.2],
    [19.4, 28.9, 32.4, 39.6, 52.8],
];
/// Plastic rotations at 50 and 100 mm [rad].
const PLASTIC: [[f64; 2]; 4] = [[0.026, 0.233], [0.142, 0.267], [0.111, 0.211], [0.135, 0.279]];
/// Uplift at rest [mm].
const REST: [f64; 4] = [-0.26, -4.08, -3.94, -2.48];

fn tanks() -> Answer {
    let mut rows = Vec::new();
    for (i, tank) in TANKS.iter().enumerate() {
        for (yields, table, tolerance) in [(false, &ELASTIC[i], 0.01), (true, &YIELDING[i], 0.04)] {
            let strip = tank.strip(yields, 1e8, Plan::Strip).map_err(failure)?;
            let kind = if yields { "yielding" } else { "elastic" };
            let points = lifted(&strip, tank.weight, &UPLIFTS)?;
            for (point, force) in points.iter().zip(table) {
                rows.push(Row::new(
                    "U2",
                    format!("tank {}, {kind}: hold-down force at {} mm", tank.name, 1e3 * point.uplift),
                    (*force, OTHER, Reference::SecondFormulation),
                    point.hold_down / 1e3,
                    (tolerance, "kN/m"),
                ));
            }
            if yields {
                for (point, rotation) in points[3..].iter().zip(PLASTIC[i]) {
                    rows.push(Row::new(
                        "U2",
                        format!("tank {}: plastic rotation of the joint at {} mm", tank.name, 1e3 * point.uplift),
                        (rotation, OTHER, Reference::SecondFormulation),
                        point.plastic_rotation,
                        (0.04, "rad"),
                    ));
                }
            } else {
                let rest = Lifted::at_rest(&strip, tank.weight).map_err(failure)?;
                rows.push(Row::new(
                    "U2",
                    format!("tank {}: rim at rest", tank.name),
                    (REST[i], OTHER, Reference::SecondFormulation),
                    1e3 * rest.uplift(),
                    (0.01, "mm"),
                ));
            }
        }
    }
    Ok(rows)
}
