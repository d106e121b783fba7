//! Notes and assumptions of a run on a free base.

use ::base::{Base, Suction, Top, WAVES};
use results::{BaseSpread, MissedBand};
use tank::units::{Dimension, display, significant};

use super::search::{Found, MOST, SETTLED};
use super::setup::{Missed, Setup};

/// The wall is held down although the tank is unanchored.
pub(crate) const HELD_DOWN: &str =
    "The tank is unanchored; the linear engine clamps the wall to the ground and does not model uplift.";
/// Share of the moment below which nothing is lost but rounding.
const ROUNDING: f64 = 1e-6;
/// Note of a run that lifts or slides.
const MOVES: &str = "values, envelopes, histories and limit states are those with uplift. The \
     section on the base has uplift, toe and slip, and the values of the wall held down beside those with uplift. Bending at the foot is not \
     given: the foot is the joint of the bottom plate. Modes, transfer functions and the response-spectrum method are those of the wall held down.";
/// The foot of the wall on the moving base.
pub(super) const FOOT: &str = "The foot of the wall is built into a plane that lifts, turns and slides with the bottom plate; what its foot warps beyond that does not strain it.";
/// Name of the limit of a run that repeats.
pub(super) const SPREAD: &str =
    "Spread of rotation, toe stress and shear of the rocking base under motions 0.1 % apart and half the time step";
/// Name of the limit of an elastic wall.
pub(super) const WALL: &str =
    "Stress of the lowest course at the joint with the bottom plate, elastic, against its yield strength";
/// Name of the limit of anchors that do not break.
pub(super) const ANCHOR_RUPTURE: &str = "Largest elongation of an anchor against that at rupture";

/// What broken anchors mean.
pub(super) fn anchors_break(broken: usize, count: usize) -> String {
    format!(
        "{broken} of {count} anchors break: the engine holds the tank in place along the ground all the same, and does not follow one that \
         slides. Nothing of wall and base holds by this run."
    )
}

/// What a wall that yields means.
pub(super) const WALL_YIELDS: &str = "The lowest course yields at the joint, which the strips leave out: wall and plate share the plastic \
     rotation, of which the value here is the sum. `tankcheck push` and the nonlinear engine model both.";
/// Name of the limit of the pressure of the motion.
pub(super) const SUCTION: &str =
    "Bottom pressure of the motion over that at rest, where the base lifts under a rim of the wall that is not round";

/// Name of the limit of the curves of the strips.
pub(super) const CURVES: &str =
    "Bottom pressure of the motion over that at rest, which the curves of the strips follow";
/// What a pressure beyond the curves means.
pub(super) const CURVES_END: &str = "The strips keep the pressure at which their curves end: of a squat tank under a round rim their moment was 16 to 46 % too large. Take the \
     nonlinear engine (`--fe nonlinear`), whose wall and bottom are shells.";

/// Strips that do not hold, and what to take instead.
pub(super) fn softened(suction: &Suction) -> String {
    format!(
        "Uplift, moment and toe stress do not hold: {}: shells of a squat tank had 1.1 to 1.5 times the stress at the toe. Take the nonlinear engine \
         (`--fe nonlinear`), whose wall and bottom are shells.",
        suction.reason()
    )
}

/// Inertia on the foot is asked for, and no foot lifts.
pub(super) const NO_HEAVE: &str = "`analysis.heave` has no effect: in this engine's run the foot does not lift.";
/// The model lacks rows.
pub(super) const NO_ROWS: &str = "The tank is unanchored; its model has no rows of base moment or pressure, and uplift is not computed: the wall is held down.";

/// What the spread of a run that does not repeat means.
pub(super) fn does_not_repeat(spread: &BaseSpread) -> String {
    let range =
        |[low, high]: [f64; 2], dimension| format!("{} to {}", display(low, dimension), display(high, dimension));
    format!(
        "The run does not repeat: motions 0.1 % weaker and stronger and half the time step give {} of uplift, {} at the toe and {} of base \
         shear. Its values are one draw of many; no limit state but the wave's may hold, and the joint is judged by the largest.",
        range(spread.uplift, Dimension::Length),
        range(spread.toe_axial_stress, Dimension::Stress),
        range(spread.base_shear, Dimension::Force)
    )
}

/// What a run that moves is.
pub(super) fn moves(anchored: bool) -> String {
    match anchored {
        true => format!(
            "With the wall held down an anchor yields, so that the tank stands on its anchors as springs: {MOVES}"
        ),
        false => format!("The tank is unanchored and lifts or slides: {MOVES}"),
    }
}

/// Anchors yield, but the run with them is not possible.
pub(super) fn anchors_not_computed(force: f64, yields: f64, reason: &str) -> String {
    format!(
        "With the wall held down an anchor carries {}, above the {} at which it yields; {reason}: all values are those of the wall held down.",
        display(force, Dimension::Force),
        display(yields, Dimension::Force)
    )
}

/// What the run cannot have, in words.
pub(super) fn unsupported(two: bool, dashpots: bool) -> Option<String> {
    let reason = match (two, dashpots) {
        (true, _) => "uplift under two horizontal components is not computed",
        (_, true) => "uplift with `analysis.damping.dashpots`, which couple the modes, is not computed",
        _ => return None,
    };
    Some(format!("The tank is unanchored; {reason}: the linear engine clamps the wall to the ground."))
}

/// Nothing moves.
pub(super) fn rests(moment: f64, lifting: f64, friction: bool) -> String {
    format!(
        "The tank is unanchored: its base moment of {} stays below {}, at which the rim leaves the ground{}. It moves as if held down.",
        display(moment, Dimension::Moment),
        display(lifting, Dimension::Moment),
        if friction { ", and its shear below friction" } else { "" }
    )
}

/// Why there is no run, a clause.
pub(super) fn reason(missed: &Missed) -> String {
    match missed {
        Missed::Base(error) => error.to_string(),
        Missed::TooFar(angle, time) => format!(
            "the base turns by {} rad, more than the {MOST} rad of the model, which it passes at {}: the tank overturns or lifts beyond \
             small rotations",
            significant(*angle, 3),
            display(*time, Dimension::Time)
        ),
    }
}

/// Name of the limit of a base that turns too far.
pub(super) const TURNS: &str = "Rotation of the base, of a run that was given up";

/// There is no run.
pub(super) fn missed(missed: &Missed) -> String {
    format!(
        "The tank is unanchored and lifts, but there is no run with uplift: {}. All values are those of the wall held down.",
        reason(missed)
    )
}

/// There is no run on a ground of the band, modulus [N/m³].
pub(super) fn missed_band(modulus: f64, missed: &Missed) -> MissedBand {
    MissedBand { modulus, reason: reason(missed) }
}

/// The same as a note of the engine.
pub(super) fn band_note(missed: &MissedBand) -> String {
    format!(
        "The uplift on ground of {} under the rim, part of the band of a third to three times the modulus, is not computed: {}.",
        display(missed.modulus, Dimension::Subgrade),
        missed.reason
    )
}

/// Thicknesses of a tank that corrodes.
const AS_BUILT: &str = "Bottom plate and wall are those as built: the sheets of the codes take them less corrosion, and their uplift is larger for that.";

/// The waves of a foot that lifts a mass.
const WAVES_AT_ONCE: &str =
    "The waves of the foot follow at once: the inertia of the liquid that ovals with the wall is left out.";

/// The waves of a rim that is not round.
fn waves(base: &Base, setup: &Setup, found: &Found) -> Option<String> {
    if matches!(base.top(), None | Some(Top::Round)) {
        return None;
    }
    if found.laws.waves.is_none() {
        return Some(WAVES_AT_ONCE.into());
    }
    Some(format!(
        "Above its foot the wall ovals in time with the liquid, without strain of its membrane but for that between foot and wall: waves 2 to {} with {} % of \
         critical damping.",
        WAVES + 1,
        significant(100.0 * setup.damping, 2)
    ))
}

/// Assumptions, one sentence each.
pub(super) fn assumptions(setup: &Setup, base: &Base, found: &Found) -> Vec<String> {
    let mut list: Vec<String> = [
        base.foot(),
        "Strips of the bottom plate stand side by side without hoop forces.",
        "Wall and liquid follow the acceleration and the rotation of the base as its march finds them. Displacements of the wall are those relative \
         to the base.",
        "Axial stress in the lowest course: at the toe and at the lifted side that of the strips, with its excess over the part with cos θ constant \
         over the height of the course. Higher courses have the part with cos θ alone, as the envelope has above the foot.",
        "Mesh errors are the relative ones of the wall held down.",
        "The toe's stress contains the weight of wall and roof; it is the force per length over the thickness of the lowest course.",
        "The suction on the lifted side acts on the strips and on the foot of the wall; the pressure of a vertical motion does not.",
        "The liquid above the lifted crescent adds no inertia, and the liquid's floor stays at rest.",
    ]
    .map(String::from)
    .to_vec();
    list.extend(waves(base, setup, found));
    list.extend(setup.corrodes.then(|| AS_BUILT.into()));
    if let Some(heave) = &found.laws.heave {
        list.push(format!(
            "The foot lifts and drops the mass of wall and roof, {}; its bounce has {} % of critical damping while all of the rim is on the \
             ground. Strips come down with the pull of their way up, so that moment and stress at the toe just after a landing are too large.",
            display(heave.mass(), Dimension::Mass),
            significant(100.0 * heave.damping_ratio(), 2)
        ));
    }
    if setup.shortened {
        list.push(format!(
            "The base has steps of {}: with longer ones its energy does not close within 0.1 % of the input.",
            display(setup.step, Dimension::Time)
        ));
    }
    list.extend(joint(base, found));
    list.push(held(setup, found));
    if let Some(friction) = setup.friction.as_ref().filter(|_| setup.assumed) {
        list.push(format!(
            "`tank.foundation.friction` is not given: {} is assumed.",
            significant(friction.coefficient, 3)
        ));
    }
    list.push(ground(setup.ground_damping[0]));
    list.push(if setup.soil.is_some() {
        "The soil under the rim radiates energy where it is in contact.".into()
    } else {
        "The soil radiates no energy: `tank.foundation.shear_wave_velocity` is not given.".into()
    });
    list
}

/// What the closed ground loses.
fn ground(ratio: f64) -> String {
    if ratio == 0.0 {
        return "`analysis.ground_damping` is 0: the ground under the rim loses no energy.".into();
    }
    format!(
        "The ground under the rim has {} % of critical damping at the impulsive mode while it is in contact, and none off it (`analysis.ground_damping`).",
        significant(100.0 * ratio, 2)
    )
}

/// What the joint of plate and wall loses.
fn joint(base: &Base, found: &Found) -> Vec<String> {
    if !base.yields() {
        return vec!["The material of the bottom plate has no yield strength: the joint loses no energy.".into()];
    }
    if found.hysteretic < ROUNDING {
        let text =
            "The bottom plate does not yield beyond its first uplift: no share of the base's moment is hysteretic.";
        return vec![text.into()];
    }
    let mut list = vec![format!(
        "A share of {} of the base's moment is hysteretic, so that a cycle to the largest rotation loses what the strips lose in \
         their second cycle; the share of the largest rotation of the run differs by {}.",
        significant(found.hysteretic, 3),
        significant(found.settled, 2)
    )];
    if found.settled > SETTLED {
        list.push("The hysteretic share does not settle: the largest rotation jumps between two shares; the smaller one, which loses less, is taken.".into());
    }
    list
}

/// What holds the tank in place along the ground.
fn held(setup: &Setup, found: &Found) -> String {
    if let Some(anchors) = &setup.anchors {
        let rupture = if anchors.rupture.is_some() { " until they break" } else { ", and do not break" };
        let slides =
            if found.history.bolts.broken.contains(&true) { ", also where they break" } else { ": it does not slide" };
        return format!(
            "{} anchors, elastic-plastic springs without pretension that pull only{rupture}; what they stretch beyond {} stays as play. They hold the \
             tank in place{slides}.",
            anchors.count,
            display(anchors.yield_force, Dimension::Force),
        );
    }
    let Some(friction) = &setup.friction else {
        return "`tank.foundation.friction` is 0: the tank does not slide, and the bottom plate does not give way along the ground.".into();
    };
    format!(
        "Coulomb friction of {} under the weight of tank and liquid{}; lifting does not change the weight. The foot of the wall drags the \
         bottom plate along ground that is as stiff along its surface as across it; the plate slips from the wall inwards.",
        significant(friction.coefficient, 3),
        if setup.vertical { ", with the vertical acceleration" } else { "" }
    )
}
