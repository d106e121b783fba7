//! A foot that stays plane, on strips side by side.
//!
//! Source:    Malhotra & Veletsos 1994; API 650 figure E-5; an independent program
//! Model:     `base::plane_section`, `base::Rocking`
//! Reference: closed forms of a linear ground, of constant hold-down with linear compression, of bolts that yield; M(ψ) of an
//!            independent program
//! Tolerance: closed forms 1e-6 (the arc is split where the rim leaves the ground), bolts 1 % (the ground gives a little);
//!            independent program 2 %, its printed digits 3 %; against a whole plate of von Karman 3 %, as strips neglect its hoop
//!            forces

use std::f64::consts::{PI, TAU};

use ::base::{Curve, Plan, Rocking, plane_section};

use super::{Sample, TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-rocking",
    title: "Moment against rotation of a base",
    model: "The foot of the wall stays plane and turns by ψ. Each metre of the rim is held by its own strip; the sum of all equals the weight \
            of wall and roof.",
    ids: &[
        ("U4", "closed forms of plane feet on simple laws"),
        ("U5", "moment, lift and toe stress of tanks B, C, D against an independent program"),
        ("U6", "moment of tank C against the whole plate of von Karman in harmonics 0 to 6"),
    ],
    parts: &[Part::Fast(closed_forms), Part::Fast(tanks), Part::Fast(whole_plate)],
};

fn closed_forms() -> Answer {
    let mut rows = Vec::new();
    let (radius, weight) = (20.0_f64, 21e3);
    let range = (-1.0, 1.0);
    // Springs that push and pull.
    let k = 5e6;
    let psi = 1e-3;
    let turn = plane_section(radius, weight, range, psi, &|w, _| k * w).map_err(failure)?;
    rows.push(Row::new(
        "U4",
        "moment on a linear spring",
        (PI * radius.powi(3) * k * psi, "π R³ k ψ", Reference::ClosedForm),
        turn.moment,
        (1e-6, "N*m"),
    ));
    // Figure E-5: compression linear over an arc 2α, constant hold-down over the rest.
    let hold = 50e3;
    for alpha in [0.3, 1.0, 2.0] {
        let (sin, cos) = (f64::sin(alpha), f64::cos(alpha));
        let force = TAU * radius * weight + 2.0 * radius * (PI - alpha) * hold;
        let toe = force * (1.0 - cos) / (2.0 * radius * (sin - alpha * cos));
        let bending = radius * radius * toe / (1.0 - cos) * (alpha - sin * cos);
        let expected = bending + 2.0 * hold * radius * radius * sin;
        let stiffness = toe / (psi * radius * (1.0 - cos));
        let law = |w: f64, _| if w > 0.0 { hold } else { stiffness * w };
        let turn = plane_section(radius, weight, range, psi, &law).map_err(failure)?;
        rows.push(Row::new(
            "U4",
            format!("moment of figure E-5, half angle of compression {alpha} rad"),
            (expected, "linear compression and constant hold-down, integrated", Reference::ClosedForm),
            turn.moment,
            (1e-6, "N*m"),
        ));
        rows.push(Row::new(
            "U4",
            format!("compression at the toe, half angle {alpha} rad"),
            (toe, "equilibrium of the same", Reference::ClosedForm),
            turn.toe_force,
            (1e-6, "N/m"),
        ));
    }
    // Bolts that yield, on ground so hard that the foot turns about its toe.
    let (count, bolt) = (36.0, 120e3);
    let law = |w: f64, _| {
        if w > 0.0 { count * bolt / (TAU * radius) } else { 1e13 * w }
    };
    let turn = plane_section(radius, weight, range, psi, &law).map_err(failure)?;
    rows.push(Row::new(
        "U4",
        "moment of a ring of 36 yielding bolts about its toe",
        (radius * (count * bolt + TAU * radius * weight), "M = R (n N_y + W)", Reference::ClosedForm),
        turn.moment,
        (0.01, "N*m"),
    ));
    Ok(rows)
}

const OTHER: &str = "independent program, strips side by side";

pub(super) fn rocking(tank: &Sample, yields: bool, modulus: f64) -> Result<Rocking, Failure> {
    let strip = tank.strip(yields, modulus, Plan::Strip).map_err(failure)?;
    let curve = Curve::of(&strip, tank.weight, -0.06, 0.25).map_err(failure)?;
    Rocking::new(tank.radius, tank.weight, vec![(tank.pressure(), curve)]).map_err(failure)
}

/// Tank, whether it yields, modulus, and for each ψ [1e-3] the moment [MNm], lift [mm] and toe stress [MPa].
type Table = (usize, bool, f64, &'static [(f64, f64, f64, f64)]);
const TABLES: [Table; 6] = [
    (2, false, 1e8, &[(0.5, 125.0, 8.1, 5.6), (1.0, 163.0, 24.0, 8.3), (2.0, 207.0, 57.0, 12.1)]),
    (2, false, 1e10, &[(0.5, 187.0, 18.0, 22.5), (1.0, 215.0, 38.0, 30.9), (2.0, 252.0, 77.0, 43.1)]),
    (2, true, 1e8, &[(0.5, 116.0, 8.0, 5.1), (1.0, 141.0, 23.0, 6.7), (2.0, 166.0, 56.0, 8.8)]),
    (1, false, 1e8, &[(0.5, 44.6, 3.5, 5.5), (1.0, 61.7, 13.5, 8.2), (2.0, 80.7, 36.0, 12.2)]),
    (1, true, 1e8, &[(0.5, 43.1, 3.5, 5.2), (1.0, 55.0, 13.0, 7.1), (2.0, 66.7, 35.0, 9.4)]),
    (3, true, 1e8, &[(1.0, 4.94, 4.5, 6.9), (2.0, 6.51, 14.0, 10.0)]),
];

fn tanks() -> Answer {
    let mut rows = Vec::new();
    for (i, yields, modulus, table) in TABLES {
        let tank = &TANKS[i];
        let base = rocking(tank, yields, modulus)?;
        let kind = if yields { "yielding" } else { "elastic" };
        for &(psi, moment, lift, stress) in table {
            let turn = base.at(1e-3 * psi, 0.0).map_err(failure)?;
            let place = format!("tank {}, {kind}, k = {modulus:e} N/m3, ψ = {psi}e-3", tank.name);
            let mut row = |what: &str, reference: f64, computed: f64, tolerance: f64, unit: &'static str| {
                rows.push(Row::new(
                    "U5",
                    format!("{what}, {place}"),
                    (reference, OTHER, Reference::SecondFormulation),
                    computed,
                    (tolerance, unit),
                ));
            };
            row("moment", moment, turn.moment / 1e6, 0.02, "MN*m");
            // Two digits are printed.
            row("lift", lift, 1e3 * turn.uplift, 0.03, "mm");
            row("stress at the toe", stress, turn.toe_force / tank.wall / 1e6, 0.03, "MPa");
        }
    }
    Ok(rows)
}

fn whole_plate() -> Answer {
    let tank = &TANKS[2];
    let base = rocking(tank, false, 1e8)?;
    let mut rows = Vec::new();
    for (psi, moment) in [(0.5, 123.3), (1.0, 160.7), (2.0, 203.4), (3.0, 234.1)] {
        let turn = base.at(1e-3 * psi, 0.0).map_err(failure)?;
        rows.push(Row::new(
            "U6",
            format!("moment at ψ = {psi}e-3"),
            (moment, "whole plate, harmonics 0 to 6, independent program", Reference::SecondFormulation),
            turn.moment / 1e6,
            (0.03, "MN*m"),
        ));
    }
    Ok(rows)
}
