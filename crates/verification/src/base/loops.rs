//! Loops of a bottom plate that yields.
//!
//! Source:    an independent program; Masing's rule, Iwan 1966
//! Model:     `base::Lifted` of a strip, `base::Law`, `base::history`
//! Reference: work of a strip by an independent program; strips along the path of a turning base, integrated around the rim;
//!            η (8 ∫ M dψ − 4 M ψ) of springs with friction
//! Tolerance: 10 %, as was set for loops of strips that lift 50 mm. Shown for comparison only: rotations that lift less than 20 mm, where the
//!            law's straight line between the uplifts at which it knows the loss is above a loss of less than 0.1 % of critical; and the loss
//!            with that of the plate pressed into soft ground under the toe, which yields too: the law leaves it out, so that its loops are
//!            narrower than those of the strips

use std::f64::consts::{PI, TAU};

use ::base::history::{Body, BodyMode, Run, march};
use ::base::{Base, Law, Lifted, Plan, Rocking};

use super::{TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::soil::IMPULSIVE;
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-loops",
    title: "Loops of a bottom plate that yields",
    model: "Tanks B, C and D with bottom plates that yield, k = 10⁸ N/m³: a strip lifted by 50 mm from rest and set down; the base turned to \
            both sides; tank C shaken by a harmonic motion until its loops repeat.",
    ids: &[
        ("U18", "work and loss of a strip"),
        ("U19", "loss of a cycle of the base against its strips"),
        ("U20", "loss of a cycle of the time history against Masing's rule"),
    ],
    parts: &[Part::Fast(strips), Part::Tested(turned), Part::Fast(shaken)],
};

/// Moves a strip and returns its work [J/m].
fn work(state: &mut Lifted<'_>, to: f64, steps: u32) -> Result<f64, Failure> {
    let from = state.uplift();
    let mut before = state.point().hold_down;
    let mut work = 0.0;
    for i in 1..=steps {
        state.lift_to(from + (to - from) * f64::from(i) / f64::from(steps)).map_err(failure)?;
        let force = state.point().hold_down;
        work += 0.5 * (before + force) * (to - from) / f64::from(steps);
        before = force;
    }
    Ok(work)
}

fn strips() -> Answer {
    let other = |value| (value, "independent program", Reference::SecondFormulation);
    let mut rows = Vec::new();
    for (i, up, losses) in [(1, None, [1096.0, 764.0]), (2, Some(2600.0), [1117.0, 793.0]), (3, None, [611.0, 369.0])] {
        let tank = &TANKS[i];
        let strip = tank.strip(true, 1e8, Plan::Strip).map_err(failure)?;
        let mut state = Lifted::at_rest(&strip, tank.weight).map_err(failure)?;
        let rest = state.uplift();
        for (cycle, lost) in ["first", "second"].into_iter().zip(losses) {
            let lifting = work(&mut state, 0.05, 200)?;
            let setting = work(&mut state, rest, 200)?;
            if let (Some(up), "first") = (up, cycle) {
                let what = format!("work of lifting, tank {}", tank.name);
                rows.push(Row::new("U18", what, other(up), lifting, (0.1, "J/m")));
            }
            let what = format!("loss of the {cycle} cycle, tank {}", tank.name);
            rows.push(Row::new("U18", what, other(lost), lifting + setting, (0.1, "J/m")));
        }
    }
    Ok(rows)
}

/// ∮ M dψ of the second cycle between ±ψ on the law.
fn traced(law: &Law, share: f64, psi: f64) -> f64 {
    const STEPS: i32 = 400;
    let mut slips = vec![0.0; law.springs().len()];
    let (mut last, mut before, mut loss) = (0.0, 0.0, 0.0);
    for i in 1..=8 * STEPS {
        let quarter = f64::from(i) / f64::from(STEPS);
        let turn = psi * triangle(quarter);
        let moment = law.respond(turn, 0.0, share, &slips).moment;
        if i > 4 * STEPS {
            loss += 0.5 * (before + moment) * (turn - last);
        }
        law.commit(turn, &mut slips);
        (last, before) = (turn, moment);
    }
    loss
}

/// 0 → 1 → −1 → 0 in four quarters.
fn triangle(quarter: f64) -> f64 {
    match quarter.rem_euclid(4.0) {
        q if q <= 1.0 => q,
        q if q <= 3.0 => 2.0 - q,
        q => q - 4.0,
    }
}

/// What the strips around the rim lose in the second cycle between ±ψ [J]: each follows its own path w₀(ψ) + ψ R cos φ.
///
/// * `pressed`: whether a place also goes below its rest, where the ground gives way under the toe
fn around(base: &Base, rocking: &Rocking, psi: f64, pressed: bool) -> Result<f64, Failure> {
    const PLACES: u32 = 18;
    const STEPS: u32 = 12;
    let strip = base.strip(base.pressure).map_err(failure)?;
    let rest = Lifted::at_rest(&strip, base.weight).map_err(failure)?;
    let path: Vec<[f64; 2]> = (1..=8 * STEPS)
        .map(|i| {
            let turn = psi * triangle(f64::from(i) / f64::from(STEPS));
            let centre = rocking.at(turn.abs(), 0.0).map_err(failure)?.centre;
            Ok([centre, turn])
        })
        .collect::<Result<_, Failure>>()?;
    let mut sum = 0.0;
    // The other half of the rim is the mirror image.
    for place in 0..PLACES {
        let cos = (PI * (f64::from(place) + 0.5) / f64::from(PLACES)).cos();
        let mut state = rest.clone();
        for (i, [centre, turn]) in path.iter().enumerate() {
            let place = centre + turn * base.radius * cos;
            let floor = if pressed { f64::NEG_INFINITY } else { rest.uplift() };
            let done = work(&mut state, place.max(floor), 1)?;
            if i >= 4 * STEPS as usize {
                sum += done;
            }
        }
    }
    Ok(sum * TAU * base.radius / f64::from(PLACES))
}

fn turned() -> Answer {
    let mut rows = Vec::new();
    for (i, rotations) in [(1, [1e-3, 2e-3]), (2, [1e-3, 2e-3]), (3, [2e-3, 4e-3])] {
        let tank = &TANKS[i];
        // Strips around the rim of a foot that stays plane.
        let base = tank.standing()?.plane();
        let rocking = base.rocking(-0.08, 0.25, true).map_err(failure)?;
        for psi in rotations {
            let law = Law::new(&rocking, 1.2 * psi).map_err(failure)?;
            let share = law.hysteretic(&base, psi).map_err(failure)?;
            let traced = traced(&law, share, psi);
            let lifts = law.turn(psi, 0.0).uplift >= 0.02;
            for (what, pressed, tolerance) in [
                ("between rest and uplift", false, if lifts { 0.1 } else { f64::INFINITY }),
                ("with the pressed side", true, f64::INFINITY),
            ] {
                let strips = around(&base, &rocking, psi, pressed)?;
                rows.push(Row::new(
                    "U19",
                    format!("tank {}, ψ = {}e-3, {what}", tank.name, 1e3 * psi),
                    (strips, "strips around the rim", Reference::SecondFormulation),
                    traced,
                    (tolerance, "J"),
                ));
            }
        }
    }
    Ok(rows)
}

fn shaken() -> Answer {
    let tank = &TANKS[2];
    let base = tank.standing()?;
    let law = Law::new(&base.rocking(-0.06, 0.25, true).map_err(failure)?, 3e-3).map_err(failure)?;
    let (_, _, [mass, arm, period]) = IMPULSIVE[1];
    let body = Body {
        modes: vec![BodyMode {
            omega: TAU / period,
            damping: 0.02,
            translation: mass.sqrt(),
            rotation: mass.sqrt() * arm,
            pressure: 0.0,
        }],
        mass,
        first_moment: mass * arm,
        second_moment: mass * arm * arm,
    };
    let mut rows = Vec::new();
    // 0.4 s to a period of the motion, in steps of 1 ms.
    let cycle = 400;
    for (peak, share) in [(1.0, 0.2), (2.0, 0.2)] {
        let run = |cycles: usize| {
            let ground: Vec<f64> = (0..=cycle * cycles).map(|i| peak * (TAU * i as f64 / cycle as f64).sin()).collect();
            march(&Run {
                body: &body,
                law: Some(&law),
                ring: None,
                heave: None,
                waves: None,
                hysteretic: share,
                dashpot: 0.0,
                friction: None,
                rigid_pressure: [0.0; 2],
                step: 1e-3,
                ground: &ground,
            })
            .map_err(failure)
        };
        let (before, after) = (run(60)?, run(61)?);
        let last = &after.rotation[60 * cycle..];
        let (low, high) = last.iter().fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(*s), h.max(*s)));
        let psi = 0.5 * (high - low);
        let moment = law.respond(psi, 0.0, 0.0, &[]).moment;
        let masing = share * (8.0 * law.work(psi) - 4.0 * moment * psi);
        rows.push(Row::new(
            "U20",
            format!("{peak} m/s² at 2.5 Hz, η = {share}"),
            (masing, "η (8 ∫ M dψ − 4 M ψ)", Reference::ClosedForm),
            after.energy.base_hysteretic - before.energy.base_hysteretic,
            (0.1, "J"),
        ));
    }
    Ok(rows)
}
