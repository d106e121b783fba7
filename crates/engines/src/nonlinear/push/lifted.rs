//! The base of an unanchored tank at a state of the path.

use std::f64::consts::PI;

use fem::dofs::Dof;
use fem::state::State;
use results::{PushBase, PushPoint, PushShell, PushStrip};

use super::model::{Plan, PushModel};
use crate::FeError;
use crate::error::failed;
use crate::nonlinear::arcs::{cosine_shares, shares};
use crate::nonlinear::bottom;

/// The base at a committed state; `None` of an anchored tank.
///
/// * `toe_stress`: axial compression of the lowest cell at the toe [Pa]
///
/// Errors: a section that fails.
pub(super) fn base(
    plan: &Plan,
    model: &PushModel,
    acceleration: f64,
    toe_stress: f64,
    state: &State,
) -> Result<Option<PushBase>, FeError> {
    let (Some(plate), Some(bottom)) = (&plan.plate, &model.bottom) else { return Ok(None) };
    let angles = &model.angles;
    let up = |node: usize| model.model.at_node(&state.committed.u, node)[Dof::Uz.index()];
    let foot = &bottom.rings[plate.foot];
    let last = foot.len() - 1;
    // The part that is proportional to cos θ: the toe, at θ = 0, goes down.
    let tilt = foot.iter().zip(cosine_shares(angles)).map(|(n, c)| up(*n) * c).sum::<f64>() * 2.0 / PI;
    // Two halves. The ground carries the pressure of the liquid on the plate, too.
    let (mut reaction, mut moment, mut toe) = (0.0, -2.0 * model.on_bottom(acceleration), 0.0);
    let (wet, cosine) = (plate.wet_areas(), cosine_shares(angles)[0]);
    for (i, r) in plate.radii.iter().enumerate() {
        let nodes = bottom.rings[i].iter().zip(&bottom.ground[i]).zip(&bottom.rest[i]);
        for (((&node, &element), rest), angle) in nodes.zip(angles) {
            let force = 2.0 * model.ground_force(element, up(node));
            reaction += force;
            moment += (force - 2.0 * rest) * r * angle.cos();
        }
        let first = model.ground_force(bottom.ground[i][0], up(bottom.rings[i][0]));
        toe += first - bottom.rest[i][0] - acceleration * plate.impulsive[i] * wet[i] * cosine;
    }
    let rim = rim(plan, model, state);
    let toe_reaction = toe / (plan.radius * shares(angles)[0] * plate.base.wall_thickness());
    let inwards: Vec<(f64, f64)> = bottom.rings[plate.foot..]
        .iter()
        .zip(&plate.radii[plate.foot..])
        .map(|(ring, r)| (plate.radii[plate.foot] - r, up(ring[last])))
        .collect();
    let off = inwards.iter().take_while(|(_, w)| *w > 0.0).count();
    let width = match (off.checked_sub(1).map(|i| inwards[i]), inwards.get(off)) {
        // Straight to where it meets the ground.
        (Some((x, w)), Some((next, sunk))) => x + (next - x) * w / (w - sunk),
        (Some((x, _)), None) => x,
        (None, _) => 0.0,
    };
    let wall = model.cells.iter().zip(model.levels.windows(2)).filter_map(|(row, z)| {
        let soft = bottom::hinge::wall_bending(&plan.case.tank, 0.5 * (z[0] + z[1]));
        Some((*row.last()?, soft))
    });
    Ok(Some(PushBase {
        rotation: -tilt / plan.radius,
        moment,
        reaction,
        uplift: up(foot[last]),
        toe: -up(foot[0]),
        lifted_width: width,
        lifted_angle: 2.0 * lifted(angles, &rim),
        plastic_rotation: bottom::hinge::plastic_rotation(&model.model, bottom, plate.foot, true, state)
            .map_err(failed)?
            .abs(),
        wall_rotation: bottom::hinge::wall_rotation(&model.model, wall, state).map_err(failed)?.abs(),
        // The constraint of a plane foot loads the wall there, not the ground.
        toe_stress: if plan.plane { toe_reaction } else { toe_stress },
        toe_reaction,
        strips: None,
        strip: None,
    }))
}

/// Uplift of the foot at the angles of the model [m]; empty of an anchored tank.
pub(super) fn rim(plan: &Plan, model: &PushModel, state: &State) -> Vec<f64> {
    let (Some(plate), Some(bottom)) = (&plan.plate, &model.bottom) else { return Vec::new() };
    let up = |node: &usize| model.model.at_node(&state.committed.u, *node)[Dof::Uz.index()];
    bottom.rings[plate.foot].iter().map(up).collect()
}

/// Part of the angles over which the foot is off the ground [rad], straight between nodes.
fn lifted(angles: &[f64], rim: &[f64]) -> f64 {
    let part = |(at, w): (&[f64], &[f64])| {
        let (high, low) = (w[0].max(w[1]), w[0].min(w[1]));
        let share = if low >= 0.0 && high > 0.0 { 1.0 } else { high.max(0.0) / (high - low).max(f64::MIN_POSITIVE) };
        share * (at[1] - at[0])
    };
    angles.windows(2).zip(rim.windows(2)).map(part).sum()
}

/// Strips beyond the pressure down to which their curves are drawn.
const CURVES_END: &str = "The strips beside the shells do not hold at the largest acceleration: the bottom pressure of the motion exceeds half of that at rest, where \
     their curves end; their moment is too large.";

/// Why the strips beside the shells do not hold up to the largest acceleration at which the foot is lifted.
pub(super) fn doubt(plan: &Plan, shells: &[PushShell]) -> Option<String> {
    let plate = plan.plate.as_ref().filter(|_| !plan.plane)?;
    let lifted = |p: &&PushPoint| p.base.is_some_and(|base| base.uplift > 0.0 && base.strips.is_some());
    let states = shells.iter().flat_map(|shell| shell.path.iter().filter(lifted));
    let most = states.map(|p| p.acceleration).fold(0.0, f64::max);
    let pressure = plate.suction() * most;
    let Some(suction) = plate.base.suction(pressure).filter(|suction| !suction.holds()) else {
        return (pressure > ::base::FOLLOWED * plate.base.pressure).then(|| CURVES_END.to_owned());
    };
    Some(format!(
        "The strips beside the shells do not hold at the largest acceleration: {}; they lift too far in the middle of the lifted side.",
        suction.reason()
    ))
}

/// Adds what the strips have at the rotations and accelerations of the paths.
pub(super) fn compare(plan: &Plan, shells: &mut [PushShell]) {
    let Some(plate) = &plan.plate else { return };
    let bases = || shells.iter().flat_map(|s| &s.path).filter_map(|p| p.base);
    let uplift = bases().map(|b| b.uplift).fold(0.0, f64::max);
    let toe = bases().map(|b| b.toe).fold(0.0, f64::max);
    let base = if plan.plane { plate.base.clone().plane() } else { plate.base.clone() };
    // Strips lift and sink otherwise than shells.
    let Ok(rocking) = base.rocking(-0.02 - 3.0 * toe, 0.02 + 2.0 * uplift, true) else { return };
    let at = |p: &mut PushPoint| {
        let acceleration = p.acceleration;
        if let Some(base) = p.base.as_mut().filter(|b| b.rotation > 0.0) {
            let turn = rocking.at(base.rotation, plate.suction() * acceleration);
            let Ok(turn) = turn else { return };
            let wall = plate.base.wall_thickness();
            base.strips = Some(turn.moment);
            base.strip = Some(PushStrip {
                uplift: turn.uplift,
                toe_stress: turn.toe_force / wall,
                settled: -rocking.curve().hold_down(-base.toe) / wall,
                plastic_rotation: rocking.curve().at(turn.uplift).plastic_rotation,
            });
        }
    };
    for shell in shells {
        for foot in &mut shell.feet {
            let state = shell.path.iter().find(|p| p.acceleration == foot.acceleration).and_then(|p| p.base);
            let turn = state.and_then(|b| rocking.at(b.rotation, plate.suction() * foot.acceleration).ok());
            if let Some(turn) = turn {
                // The lifted side is at π.
                foot.strips = foot.theta.iter().map(|theta| turn.rim(plan.radius, PI - theta)).collect();
            }
        }
        shell.path.iter_mut().for_each(at);
        at(&mut shell.capacity.state);
    }
}
