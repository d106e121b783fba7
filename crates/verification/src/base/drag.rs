//! The bottom plate dragged along the ground by the foot of the wall.
//!
//! Source:    plane stress of a disc on an elastic ground; Masing's rule, Iwan 1966
//! Model:     `base::Drag`, `base::history` of a rigid body on it
//! Reference: stiffness from modified Bessel functions; friction of the whole weight; 8 ∫ V ds − 4 V s of a cycle
//! Tolerance: 0.5 % for elements of second order, the first of them a hundredth of the decay length; 1 % for the curve's end, which is drawn to
//!            0.995 of friction; 1 % for a cycle of a thousand steps

use std::f64::consts::{PI, TAU};

use ::base::history::{Body, Friction, Run, march};
use ::base::{Base, Drag};

use super::{Sample, TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-drag",
    title: "Bottom plate dragged along the ground",
    model: "Tanks B, C and D on soil of 10⁸ N/m³: the foot of the wall moves along the ground, which is as stiff along its surface as across it and \
            holds μ p; a rigid body on the plate of tank C, shaken until its loops repeat.",
    ids: &[
        ("U24", "stiffness before anything slips"),
        ("U25", "shear under which all of the plate slips"),
        ("U26", "loss of a cycle"),
    ],
    parts: &[Part::Fast(plates), Part::Fast(shaken)],
};

const FRICTION: f64 = 0.4;

/// I₁ and its derivative by their series.
fn bessel(x: f64) -> [f64; 2] {
    let (mut value, mut slope, mut term) = (0.0, 0.0, 0.5 * x);
    for k in 0..200_u32 {
        value += term;
        slope += term * f64::from(2 * k + 1) / x;
        term *= 0.25 * x * x / (f64::from(k + 1) * f64::from(k + 2));
    }
    [value, slope]
}

/// u = ∇φ + ∇ × ψ with φ = A I₁(αr) cos θ, ψ = B I₁(βr) sin θ, α² = k/(t E′), β² = k/(t G): displacement 1 of the foot along itself, the wall's edge
/// against it across, k₁₁ = 4 β_w³ D_w; V = π ∫ k (U + W) r dr.
fn closed(tank: &Sample, base: &Base) -> f64 {
    let (nu, t, r, k) = (0.3, tank.plate, base.radius, base.modulus);
    let normal = t * tank.young_modulus / (1.0 - nu * nu);
    let shear = t * tank.young_modulus / (2.0 * (1.0 + nu));
    let wall = (3.0 * (1.0 - nu * nu)).powf(0.25) / (r * tank.wall).sqrt();
    let edge = 4.0 * wall.powi(3) * tank.young_modulus * tank.wall.powi(3) / (12.0 * (1.0 - nu * nu));
    let (alpha, beta) = ((k / normal).sqrt(), (k / shear).sqrt());
    // U and W of A = 1, of B = 1.
    let at = |r: f64| {
        let ([a, da], [b, db]) = (bessel(alpha * r), bessel(beta * r));
        [[alpha * da, a / r], [b / r, beta * db]]
    };
    let h = 1e-5 * r;
    let (before, after, own) = (at(r - h), at(r + h), at(r));
    let across = |i: usize| {
        let [u, w] = own[i];
        normal * ((after[i][0] - before[i][0]) / (2.0 * h) + nu * (u - w) / r) + edge * u
    };
    // A U + B U and A W + B W at the rim: force across and displacement along.
    let (f, g) = (across(0), across(1));
    let det = own[0][1] * g - own[1][1] * f;
    let (a, b) = ((g - own[1][1] * edge) / det, (own[0][1] * edge - f) / det);
    let n = 4000;
    let each = (0..n).map(|i| r * (f64::from(i) + 0.5) / f64::from(n));
    each.map(|x| {
        let [p, q] = at(x);
        PI * k * (a * (p[0] + p[1]) + b * (q[0] + q[1])) * x * r / f64::from(n)
    })
    .sum()
}

fn plates() -> Answer {
    let mut rows = Vec::new();
    for tank in &TANKS[1..] {
        let base = tank.standing()?;
        let drag = Drag::of(&base, FRICTION).map_err(failure)?;
        let source = (closed(tank, &base), "modified Bessel functions", Reference::ClosedForm);
        let what = format!("tank {}, dV/ds at rest", tank.name);
        rows.push(Row::new("U24", what, source, drag.stiffness(), (5e-3, "N/m")));
        let held = FRICTION * (PI * base.radius.powi(2) * base.pressure + TAU * base.radius * base.weight);
        let what = format!("tank {}, V at 1 m, μ = {FRICTION}", tank.name);
        let source = (held, "μ (p π R² + w_t 2 π R)", Reference::ClosedForm);
        rows.push(Row::new("U25", what, source, drag.shear(1.0), (1e-2, "N")));
    }
    Ok(rows)
}

/// Amplitude of the steady slip [m] and loss of its last cycle [J] of a mass on the plate, forced at half of its frequency before it slips.
fn cycle(drag: &Drag, mass: f64, peak: f64) -> Result<[f64; 2], Failure> {
    const STEPS: usize = 1000;
    let omega = 0.5 * (drag.stiffness() / mass).sqrt();
    let step = TAU / omega / STEPS as f64;
    let run = |cycles: usize| {
        let ground: Vec<f64> = (0..=cycles * STEPS).map(|i| peak * (omega * step * i as f64).sin()).collect();
        march(&Run {
            body: &Body { modes: Vec::new(), mass, first_moment: 0.0, second_moment: 0.0 },
            law: None,
            ring: None,
            heave: None,
            waves: None,
            hysteretic: 0.0,
            dashpot: 0.0,
            friction: Some(Friction {
                coefficient: FRICTION,
                weight: drag.limit() / FRICTION,
                vertical: Vec::new(),
                springs: drag.springs(),
                delay: 0.0,
            }),
            rigid_pressure: [0.0; 2],
            step,
            ground: &ground,
        })
        .map_err(failure)
    };
    let (before, after) = (run(100)?, run(101)?);
    let (low, high) = after.slip[100 * STEPS..].iter().fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(*s), h.max(*s)));
    Ok([0.5 * (high - low), after.energy.friction - before.energy.friction])
}

fn shaken() -> Answer {
    let drag = Drag::of(&TANKS[2].standing()?, FRICTION).map_err(failure)?;
    let mass = drag.limit() / (FRICTION * super::GRAVITY);
    let mut rows = Vec::new();
    for peak in [0.5, 1.0] {
        let [s, found] = cycle(&drag, mass, peak)?;
        // Of the chain the march is given.
        let force = |x: f64| -> f64 { drag.springs().iter().map(|p| (p.stiffness * x).min(p.limit)).sum() };
        let n = 2000;
        let work: f64 = (0..n).map(|i| force(s * (f64::from(i) + 0.5) / f64::from(n)) * s / f64::from(n)).sum();
        let what = format!("tank C, {peak} m/s²");
        let source = (8.0 * work - 4.0 * force(s) * s, "8 ∫ V ds − 4 V s", Reference::ClosedForm);
        rows.push(Row::new("U26", what, source, found, (1e-2, "J")));
    }
    Ok(rows)
}
