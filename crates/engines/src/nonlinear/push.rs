//! Pushover of a cylinder, anchored or on its bottom plate: the static state, then inertia forces and impulsive pressure of a growing horizontal
//! acceleration through the limit point.
//!
//! ```text
//! f_int(u) = weight + p_hydrostatic(u) + a M_s ι + max(a M_f ι, −p_hydrostatic)         a [m/s²]
//! ```
//!
//! Load steps up to the last equilibrium, then arc-length steps through the limit point with the pattern reached (no suction of
//! the liquid, node by node). Large rotations, yielding steel, hydrostatic pressure that rotates with the wall; see `load` for
//! the pattern, `model` for mesh and supports, `imperfection` for the imperfect shell. A static capacity: neither the duration
//! of the peak nor the cycles before it count.

mod buckling;
mod continuation;
mod estimate;
mod imperfection;
mod keep;
mod lifted;
mod limits;
mod load;
mod model;
mod path;
#[cfg(test)]
mod rim_study;
mod seen;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod uplift_study;
#[cfg(test)]
mod uplift_tests;

use fem::analysis::checkpoint::Reader;
use fem::progress::Progress;
use tank::Case;
use tank::refusal::Refusal;
use tank::units::{Dimension, significant};

pub use estimate::estimate;
pub use imperfection::{Amplitude, Form, Quality};
pub use limits::{Capacity, Formula};
pub use model::NoSteel;

use super::CheckpointFile;
use super::scope::{Purpose, refusals};
use crate::FeError;
use crate::engine::Task;
use crate::fittings;
use buckling::Mode;
use imperfection::{Dent, Depression, half_wave};
use keep::{Keeper, Kept};
use model::Plan;
use path::Followed;
use results::{Fact, FactKind, Imperfection, PushLimit, PushShell};
use tank::options::nonlinear::NonlinearOptions;

/// Options of a pushover.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct PushOptions {
    /// Amplitude of the imperfect shell; `None`: the perfect shell alone.
    pub imperfection: Option<Amplitude>,
    /// Its form.
    pub form: Form,
    /// Height of a weld [m]; `None`: where the perfect shell buckles. A mode has its own.
    pub height: Option<f64>,
    /// Whether the foot of an unanchored tank stays a plane, as in the strips of the fast engine and under a stiff roof.
    pub plane_foot: bool,
}

/// Results of a pushover.
#[derive(Clone, Debug, PartialEq)]
pub struct Pushed {
    /// The model in numbers.
    pub model: Vec<Fact>,
    /// Assumptions, one sentence each.
    pub assumptions: Vec<String>,
    /// Doubts about it, one sentence each.
    pub doubts: Vec<String>,
    /// The perfect shell and the imperfect one.
    pub shells: Vec<PushShell>,
    /// Formulas for comparison.
    pub limits: Vec<PushLimit>,
    /// The missing part of an interrupted run, in words; empty if complete.
    pub interruption: String,
}

/// Everything that a pushover refuses of a case; empty if it can run.
pub fn refuses(task: &Task<'_>) -> Vec<Refusal> {
    let mut all = refusals(task.case, task.nonlinear, Purpose::Pushover);
    all.extend(crate::registry::elevated(task));
    all
}

/// Pushes the perfect shell, and the imperfect one if there is one.
///
/// * `formulas`: formulas to compare the capacity with
/// * `checkpoint`: written every [`NonlinearOptions::checkpoint`] seconds and on interruption; the caller removes it
///
/// Errors: an unsupported tank, wall or option; a static load that the wall does not carry; a checkpoint of another run. A
/// checkpoint that cannot be written is a warning of `progress`, not an error.
pub fn pushover(
    case: &Case,
    options: &NonlinearOptions,
    push: &PushOptions,
    formulas: &[Formula],
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<Pushed, FeError> {
    let plan = Plan::new(case, options, push.plane_foot || options.plane_foot)?;
    let height = case.tank.wall_height();
    if let Some(z) = push.height.filter(|z| !(0.0..=height).contains(z)) {
        return Err(FeError::option(
            "height of the imperfection",
            format!("{z} m"),
            format!("0 to {height} m, the height of the wall"),
        ));
    }
    if push.height.is_some() && push.form == Form::Mode {
        return Err(FeError::option(
            "height of the imperfection",
            "a height together with the buckling mode",
            "a height for a weld only; a mode determines its height",
        ));
    }
    if plan.plate.is_some() && push.imperfection.is_some() && push.form == Form::Mode {
        return Err(FeError::option(
            "form of the imperfection",
            "the buckling mode of an unanchored tank, whose base has no linear state",
            "a weld depression, or \"support\": \"anchored\"",
        ));
    }
    if plan.plate.is_none() && push.plane_foot {
        return Err(FeError::option(
            "plane foot",
            "a wall that is clamped at its base",
            "a plane foot for an unanchored tank alone",
        ));
    }
    let mut keeper = Keeper::new(checkpoint, &plan);
    let kept = keeper.resume(&plan)?;
    let (mut shells, missing) = shells(&plan, push, kept, &mut keeper, progress).inspect_err(|error| {
        // It would fail there again.
        if matches!(error, FeError::Analysis(_)) {
            keeper.discard();
        }
    })?;
    lifted::compare(&plan, &mut shells);
    Ok(Pushed {
        model: facts(&plan),
        assumptions: assumptions(&plan),
        doubts: doubts(&plan, &shells),
        interruption: interruption(&shells, missing),
        shells,
        limits: limits::limits(&plan, formulas),
    })
}

/// The shells, and whether one is missing that was asked for.
fn shells(
    plan: &Plan,
    push: &PushOptions,
    kept: Kept<'_>,
    keeper: &mut Keeper<'_>,
    progress: &dyn Progress,
) -> Result<(Vec<PushShell>, bool), FeError> {
    let Kept { perfect, mode, path } = kept;
    let (perfect, path) = match perfect {
        Some((seen, end)) => (seen.shell(end), path),
        None => {
            let found = path::follow(plan, None, "perfect shell", path, keeper, progress)?;
            if let Some(end) = &found.end {
                keeper.finished(&found.seen, end);
            }
            (found.shell(), None)
        }
    };
    let Some(amplitude) = push.imperfection else { return Ok((vec![perfect], false)) };
    if perfect.interrupted {
        return Ok((vec![perfect], true));
    }
    let imperfect = if progress.interrupted() {
        // While a path is under way the file is up to date.
        if path.is_none() {
            keeper.save(None, progress);
        }
        None
    } else {
        match imperfect(plan, amplitude, push, &perfect, (mode, path), keeper, progress) {
            Ok(shell) => Some(shell),
            // The perfect shell is kept.
            Err(FeError::Interrupted { .. }) => None,
            Err(error) => return Err(error),
        }
    };
    let missing = imperfect.is_none();
    Ok((std::iter::once(perfect).chain(imperfect).collect(), missing))
}

/// Longest element on which a bulge is one, over √(R t): its half wave is 1.7 √(R t) and more, three elements then.
const COARSE: f64 = 0.6;

/// Doubts about a pushover.
fn doubts(plan: &Plan, shells: &[PushShell]) -> Vec<String> {
    let lowest = &plan.case.tank.courses[0];
    let length = (plan.levels[1] - plan.levels[0]) / (plan.radius * lowest.thickness).sqrt();
    let mut out = Vec::new();
    if length > COARSE {
        out.push(format!(
            "The mesh is too coarse for a bulge, whose half wave is 1.7 to 2.4 √(R t): the lowest element is {} √(R t) long, \
             expected at most {COARSE}. Capacities may be far too high.",
            significant(length, 3)
        ));
    }
    out.extend(lifted::doubt(plan, shells));
    if let [perfect, imperfect] = shells
        && imperfect.capacity.state.acceleration > 1.01 * perfect.capacity.state.acceleration
    {
        out.push(
            "The imperfect shell carries more than the perfect one: the imperfection stiffens the place where the perfect shell \
             buckles, or the mesh does not resolve the buckle. Its capacity is not valid."
                .into(),
        );
    }
    out
}

/// The missing part, in words.
fn interruption(shells: &[PushShell], missing: bool) -> String {
    let capacity = |shell: &PushShell| match shell.capacity.limit {
        true => "beyond its maximum",
        false => "whose capacity is a lower bound",
    };
    match shells {
        [perfect] if perfect.interrupted => {
            let rest = if missing { ", and the imperfect one was not run" } else { "" };
            format!("interrupted in the perfect shell, {}{rest}", capacity(perfect))
        }
        [_] if missing => "the perfect shell is complete; interrupted before the imperfect one".into(),
        [_, imperfect] if imperfect.interrupted => {
            format!("the perfect shell is complete; interrupted in the imperfect one, {}", capacity(imperfect))
        }
        _ => String::new(),
    }
}

impl Followed<'_> {
    fn shell(&self) -> PushShell {
        let end = self.end.clone().unwrap_or_else(|| "interrupted".into());
        PushShell { interrupted: self.end.is_none(), ..self.seen.shell(end) }
    }
}

/// Pushes the imperfect shell.
///
/// * `kept`: buckling mode and path that a checkpoint has
///
/// Errors: as [`pushover`]; an interruption before there is anything to show.
fn imperfect(
    plan: &Plan,
    amplitude: Amplitude,
    push: &PushOptions,
    perfect: &PushShell,
    kept: (Option<Mode>, Option<Reader>),
    keeper: &mut Keeper<'_>,
    progress: &dyn Progress,
) -> Result<PushShell, FeError> {
    let course = |z: f64| plan.case.tank.course_at(z);
    let (dent, imperfection) = match push.form {
        Form::Weld => {
            let z = push.height.unwrap_or(perfect.capacity.height);
            let (t, nu) = (course(z).thickness, course(z).material.poisson_ratio);
            let shape = Depression {
                radius: plan.radius,
                amplitude: amplitude.of_wall(t, plan.radius),
                height: z,
                half_wave: half_wave(plan.radius, t, nu),
            };
            let imperfection = Imperfection {
                amplitude: shape.amplitude,
                over_thickness: shape.amplitude / t,
                height: z,
                angle: None,
                half_wave: Some(shape.half_wave),
                factor: None,
                map: None,
                source: amplitude.source("shape of a weld depression (Rotter & Teng 1989, type A)"),
            };
            (Dent::Weld(shape), imperfection)
        }
        Form::Mode => {
            let acceleration = perfect.capacity.state.acceleration;
            let mode = match kept.0 {
                Some(mode) => mode,
                None => {
                    if keeper.due() {
                        keeper.save(None, progress);
                    }
                    progress.stage("buckling mode", 1);
                    let mode = buckling::mode(plan, acceleration)?;
                    progress.advance(1);
                    keeper.found(&mode);
                    mode
                }
            };
            let t = course(mode.place.0).thickness;
            let delta = amplitude.of_wall(t, plan.radius);
            let shape = format!(
                "shape of the lowest linear buckling mode, which the elastic wall has under {} times the load at {} g",
                significant(mode.factor, 3),
                significant(acceleration / plan.case.gravity, 3)
            );
            let imperfection = Imperfection {
                amplitude: delta,
                over_thickness: delta / t,
                height: mode.place.0,
                angle: Some(mode.place.1),
                half_wave: None,
                factor: Some(mode.factor),
                map: Some(mode.map(plan, delta)),
                source: amplitude.source(&shape),
            };
            (Dent::Mode(mode.scaled(delta)), imperfection)
        }
    };
    let found = path::follow(plan, Some(&dent), "imperfect shell", kept.1, keeper, progress)?;
    Ok(PushShell { imperfection: Some(imperfection), ..found.shell() })
}

fn facts(plan: &Plan) -> Vec<Fact> {
    let fact = |kind, value: f64, dimension| Fact { kind, value, dimension };
    let number = Dimension::Dimensionless;
    let lowest = &plan.case.tank.courses[0];
    let bending = (plan.radius * lowest.thickness).sqrt();
    let (mass, moment) = plan.impulsive.above(0.0);
    let masses = limits::masses(plan, 0.0);
    vec![
        fact(FactKind::RadiusOverThickness, plan.radius / lowest.thickness, number),
        fact(FactKind::ElementsOverHeight, (plan.levels.len() - 1) as f64, number),
        fact(FactKind::ElementsAround, (plan.angles.len() - 1) as f64, number),
        fact(FactKind::LowestElement, (plan.levels[1] - plan.levels[0]) / bending, number),
        fact(FactKind::SmallestAround, plan.radius * plan.angles[1] / bending, number),
        fact(FactKind::ImpulsiveMass, mass, Dimension::Mass),
        fact(FactKind::ImpulsiveHeight, moment / mass, Dimension::Length),
        fact(FactKind::WallAndRoofMass, masses.0, Dimension::Mass),
    ]
}

fn assumptions(plan: &Plan) -> Vec<String> {
    let (case, options) = (plan.case, plan.options);
    let foot = match plan.plate {
        Some(_) => "on its bottom plate",
        None => "clamped at its base",
    };
    let mut out = vec![
        "Static: the load grows once, in one direction, from equilibrium under weight and liquid; no cycles, no duration. The \
         acceleration is that of ground and impulsive liquid together: with the impulsive response spectrum it is S_a, not the \
         peak ground acceleration."
            .to_owned(),
        "Inertia of the wall and impulsive pressure in the pattern of a rigid tank, without sloshing; no vertical motion. No \
         suction: on the side away from the compression the sum of impulsive and hydrostatic pressure is never below zero, so \
         that shear and moment grow more slowly than the acceleration. The formulas do not include this."
            .into(),
        match case.tank.rings.is_empty() && case.tank.roof.holds.is_free() {
            true => format!(
                "Half the wall between planes of symmetry, {foot}, free at its top: a roof is mass without stiffness. A buckle of the edge \
                 on the side away from the compression, above the liquid, is that of a wall without ring or roof; a ring can be given as a \
                 separate course."
            ),
            false if case.tank.roof.holds.is_free() => format!(
                "Half the wall between planes of symmetry, {foot}, held by its stiffening rings alone: a roof is mass without stiffness."
            ),
            false => format!("Half the wall between planes of symmetry, {foot}."),
        },
        "Steel of nominal strength; transverse shear of the elements is elastic, and tearing is not modelled.".into(),
        "Waves shorter than about eight elements around the circumference are too stiff: the axisymmetric bulge at the base is \
         resolved; diamond buckles of an elastic wall are resolved only as far as the element size in the table allows."
            .into(),
    ];
    if let Some(plate) = &plan.plate {
        let shown = |value: f64, dimension| tank::units::display(value, dimension);
        let along = match plate.friction {
            Some(friction) => format!("with friction of {}", significant(friction, 2)),
            None => "without friction, the foot held along it".into(),
        };
        out.push(format!(
            "Bottom plate as yielding shells over the outer {} of the radius on ground of {} that pushes and does not pull, {along}; the \
             plate within stays where it is: the tank does not slide. Every particle of wall and plate keeps its hydrostatic pressure. \
             Plates as built; the ground is elastic.",
            shown(plate.width(), Dimension::Length),
            shown(plate.base.modulus, Dimension::Subgrade),
        ));
        out.push(
            match plan.plane {
                true => {
                    "The foot of the wall is kept a plane, as in the strips: its uplift is w₀ + ψ R cos θ. A tank with a free top lifts more \
                     at the same moment."
                }
                false if !case.tank.roof.holds.is_free() => {
                    "The rim stays round, which leaves a foot that warps next to nothing, as in the strips."
                }
                false => "The foot warps under a rim that is free but for `tank.rings`, as in the strips.",
            }
            .into(),
        );
    }
    out.extend(fittings::assumptions(&case.tank, true));
    if case.tank.roof.mass > 0.0 {
        out.push("The mass of the roof acts on the edge of the wall, its lever arm as a couple along the edge.".into());
    }
    if !options.follower_pressure {
        out.push("The hydrostatic pressure does not rotate with the wall, as requested.".into());
    }
    if !options.self_weight {
        out.push("The weight of the wall is ignored, as requested.".into());
    }
    out
}
