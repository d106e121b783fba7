//! Anchors that yield.
//!
//! Source:    M = R (n N_y + W) of a ring that turns about its toe
//! Model:     `base::Anchors`, `base::Ring`, `base::history`
//! Reference: closed forms
//! Tolerance: 1e-9 for a cycle of one anchor, which is arithmetic; 1 % for the ring, whose toe is an arc of 6° at most: β²/10 of its lever arm
//!            are 0.1 %, chords of the pull between its levels a few times that; 1e-3 of the input for the balance

use std::f64::consts::TAU;

use ::base::history::{Body, BodyMode, Run, march};
use ::base::{Anchors, Curve, Law, Point, Ring, Rocking};

use super::failure;
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-anchors",
    title: "Anchors that yield",
    model: "24 anchors of 80 MN/m that yield at 60 kN, with a play of 1 mm for the cycle; on a rim of 10 m radius and 15 kN/m that nothing but its \
            anchors holds down, on ground of 10 GN/m² per length.",
    ids: &[
        ("U21", "force of one anchor over a cycle"),
        ("U22", "moment of the ring"),
        ("U23", "energy of anchors that yield in time"),
    ],
    parts: &[Part::Fast(cycle), Part::Fast(ring), Part::Fast(shaken)],
};

const RADIUS: f64 = 10.0;
const WEIGHT: f64 = 15e3;
const ANCHORS: Anchors = Anchors { count: 24, stiffness: 80e6, yield_force: 60e3, gap: 0.0, rupture: None };

/// A rim that the ground carries and nothing holds down.
fn bare(largest: f64) -> Result<(Rocking, Law), Failure> {
    let point = |uplift: f64| Point {
        uplift,
        hold_down: 1e10 * uplift.min(0.0),
        rotation: 0.0,
        rim_moment: 0.0,
        axial_force: 0.0,
        lifted_width: 0.0,
        plastic_rotation: 0.0,
    };
    let pressed = (0..=60).map(|i| -0.05 * 0.8_f64.powi(i));
    let curve = Curve::through(pressed.chain([0.0, 0.1, 0.3, 0.6]).map(point).collect());
    let rocking = Rocking::new(RADIUS, WEIGHT, vec![(1e3, curve)]).map_err(failure)?;
    let law = Law::new(&rocking, largest).map_err(failure)?;
    Ok((rocking, law))
}

fn cycle() -> Answer {
    let anchors = Anchors { gap: 1e-3, ..ANCHORS };
    let elastic = anchors.yield_force / anchors.stiffness;
    let closed = |value| (value, "closed form", Reference::ClosedForm);
    let row = |what: &str, expected: f64, (elongation, plastic): (f64, f64)| {
        let found = anchors.force(anchors.gap + elongation * elastic, plastic * elastic, false).0;
        Row::new("U21", what, closed(expected), found, (1e-9, "N"))
    };
    let n = anchors.yield_force;
    Ok(vec![
        row("half of the play", 0.0, (-0.5 * anchors.gap / elastic, 0.0)),
        row("half of the yield elongation δ_y", 0.5 * n, (0.5, 0.0)),
        row("5 δ_y", n, (5.0, 0.0)),
        row("back to 4.25 δ_y", 0.25 * n, (4.25, 4.0)),
        row("back to 3.9 δ_y", 0.0, (3.9, 4.0)),
        row("again to 7 δ_y", n, (7.0, 4.0)),
    ])
}

fn ring() -> Answer {
    let (rocking, law) = bare(0.02)?;
    let weight = TAU * RADIUS * WEIGHT;
    let mut rows = Vec::new();
    for (count, force) in [(24, 60e3), (24, 150e3), (60, 60e3)] {
        let anchors = Anchors { count, yield_force: force, ..ANCHORS };
        let ring = Ring::new(anchors, &rocking, &law).map_err(failure)?;
        for psi in [5e-3, 0.015] {
            let pull = ring.pull(psi, 0.0, &ring.unstretched());
            let found = law.respond(psi, 0.0, 0.0, &[]).moment + pull.response.moment;
            let expected = RADIUS * (count as f64 * force + weight);
            rows.push(Row::new(
                "U22",
                format!("{count} anchors of {:.0} kN, ψ = {psi}", force / 1e3),
                (expected, "R (n N_y + W)", Reference::ClosedForm),
                found,
                (1e-2, "N m"),
            ));
        }
    }
    Ok(rows)
}

fn shaken() -> Answer {
    let (rocking, law) = bare(0.02)?;
    let ring = Ring::new(ANCHORS, &rocking, &law).map_err(failure)?;
    let (mass, height) = (1.2e6_f64, 5.0);
    let body = Body {
        modes: vec![BodyMode {
            omega: 25.0,
            damping: 0.02,
            translation: mass.sqrt(),
            rotation: height * mass.sqrt(),
            pressure: 0.0,
        }],
        mass,
        first_moment: mass * height,
        second_moment: mass * height * height,
    };
    // A bare rim on rock asks for short steps.
    let step = 2.5e-4;
    let ground: Vec<f64> =
        (0..24_000).map(|i| f64::from(i) * step).map(|t| 2.5 * ((15.0 * t).sin() + (23.0 * t).sin())).collect();
    let history = march(&Run {
        body: &body,
        law: Some(&law),
        ring: Some(&ring),
        heave: None,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: None,
        rigid_pressure: [0.0; 2],
        step,
        ground: &ground,
    })
    .map_err(failure)?;
    let stretched: f64 = (ring.places().iter().zip(&history.bolts.plastic))
        .map(|((_, number), plastic)| number * plastic * ANCHORS.yield_force)
        .sum();
    let most = history.anchor_force.iter().copied().fold(0.0, f64::max);
    let closed = |value, what| (value, what, Reference::ClosedForm);
    Ok(vec![
        Row::new("U23", "largest force", closed(ANCHORS.yield_force, "N_y"), most, (1e-9, "N")),
        Row::new("U23", "loss of the anchors", closed(stretched, "Σ N_y e^p"), history.energy.anchors, (1e-9, "J")),
        Row::new(
            "U23",
            "sum of the energies at the end",
            closed(history.energy.input, "input"),
            history.energy.input * (1.0 + history.balance),
            (1e-3, "J"),
        ),
    ])
}
