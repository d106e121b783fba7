//! Pushover of an anchored cylinder: the state at rest, then inertia forces and impulsive pressure of a growing horizontal
//! acceleration through the limit point.
//!
//! ```text
//! f_int(u) = weight + p_hydrostatic(u) + a M_s ι + max(a M_f ι, −p_hydrostatic)         a [m/s²]
//! ```
//!
//! Load steps up to the last equilibrium, then an arc through the limit point in the pattern reached (the liquid does not pull,
//! node by node). Large rotations, steel that yields, the hydrostatic pressure turns with the wall; see `load` for the pattern, `model` for
//! mesh and supports, `imperfection` for what is wrong with the shell. A static capacity: neither the duration of the peak nor
//! the cycles before it count.

mod imperfection;
mod limits;
mod load;
mod model;
mod path;

use codes::Case;
use codes::units::Dimension;
use fem::progress::Progress;

pub use imperfection::{Amplitude, Quality};

use super::NonlinearOptions;
use crate::fe::FeError;
use crate::results::{Fact, Imperfection, PushLimit, PushShell};
use imperfection::{Depression, half_wave};
use model::Plan;

/// What a pushover is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PushOptions {
    /// Amplitude of the imperfect shell; `None`: the perfect shell alone.
    pub imperfection: Option<Amplitude>,
    /// Its height [m]; `None`: where the perfect shell buckles.
    pub height: Option<f64>,
}

/// What a pushover found.
#[derive(Clone, Debug, PartialEq)]
pub struct Pushed {
    /// The model in numbers.
    pub model: Vec<Fact>,
    /// What was assumed.
    pub assumptions: Vec<String>,
    /// The perfect shell and the imperfect one.
    pub shells: Vec<PushShell>,
    /// Formulas beside it.
    pub limits: Vec<PushLimit>,
    /// Whether the user stopped it.
    pub incomplete: bool,
}

/// Pushes the perfect shell, and the imperfect one if there is one.
///
/// Errors: a tank, a wall or an option that a pushover does not know; a state at rest that the wall does not carry.
pub fn pushover(
    case: &Case,
    options: &NonlinearOptions,
    push: &PushOptions,
    progress: &dyn Progress,
) -> Result<Pushed, FeError> {
    let plan = Plan::new(case, options)?;
    let height = case.tank.wall_height();
    if let Some(z) = push.height.filter(|z| !(0.0..=height).contains(z)) {
        return Err(FeError::Option {
            option: "height of the imperfection".into(),
            found: format!("{z} m"),
            allowed: format!("0 to {height} m, the height of the wall"),
        });
    }
    let perfect = path::follow(&plan, None, "perfect shell", progress)?;
    let mut shells = vec![perfect];
    if let Some(amplitude) = push.imperfection.filter(|_| !progress.interrupted()) {
        let z = push.height.unwrap_or(shells[0].capacity.height);
        let course = case.tank.course_at(z);
        let (t, nu) = (course.thickness, course.material.poisson_ratio);
        let shape = Depression {
            amplitude: amplitude.of_wall(t, plan.radius),
            height: z,
            half_wave: half_wave(plan.radius, t, nu),
        };
        let mut shell = path::follow(&plan, Some(&shape), "imperfect shell", progress)?;
        shell.imperfection = Some(Imperfection {
            amplitude: shape.amplitude,
            over_thickness: shape.amplitude / t,
            height: z,
            half_wave: shape.half_wave,
            source: amplitude.source(),
        });
        shells.push(shell);
    }
    Ok(Pushed {
        model: facts(&plan),
        assumptions: assumptions(case, options),
        shells,
        limits: limits::limits(&plan),
        incomplete: progress.interrupted(),
    })
}

fn facts(plan: &Plan) -> Vec<Fact> {
    let fact = |name: &str, value: f64, dimension| Fact {
        name: name.into(),
        value,
        dimension,
    };
    let number = Dimension::Dimensionless;
    let lowest = &plan.case.tank.courses[0];
    let bending = (plan.radius * lowest.thickness).sqrt();
    let (mass, moment) = plan.impulsive.above(0.0);
    let masses = limits::masses(plan, 0.0);
    vec![
        fact("R/t of the lowest course", plan.radius / lowest.thickness, number),
        fact("elements over the height", (plan.levels.len() - 1) as f64, number),
        fact("elements around the half", (plan.angles.len() - 1) as f64, number),
        fact(
            "lowest element over √(R t)",
            (plan.levels[1] - plan.levels[0]) / bending,
            number,
        ),
        fact(
            "smallest element along the circumference over √(R t)",
            plan.radius * plan.angles[1] / bending,
            number,
        ),
        fact("impulsive mass of the liquid", mass, Dimension::Mass),
        fact("its height", moment / mass, Dimension::Length),
        fact("mass of wall and roof", masses.0, Dimension::Mass),
    ]
}

fn assumptions(case: &Case, options: &NonlinearOptions) -> Vec<String> {
    let mut out = vec![
        "Static: the load grows once, in one direction, from the state at rest under weight and liquid; no cycles, no duration. The \
         acceleration is that of ground and impulsive liquid together: with the impulsive response spectrum the abscissa is S_a, not \
         the peak ground acceleration."
            .to_owned(),
        "Inertia of the wall and impulsive pressure in the pattern of a rigid tank, the sloshing at rest; no vertical motion. The \
         liquid does not pull: on the side away from the compression impulsive and hydrostatic pressure together are never below \
         zero, so that shear and moment grow slower than the acceleration. The formulas are compared without that."
            .into(),
        "Half the wall between planes of symmetry, clamped at its base, free at its top: a roof is mass without stiffness.".into(),
        "Steel of the material's nominal strength; the elements carry transverse shear elastically and know no tearing.".into(),
        "Waves shorter than about eight elements around the circumference are too stiff: the axisymmetric bulge at the base is \
         resolved, diamond buckles of an elastic wall are only as far as the element size in the table allows."
            .into(),
    ];
    if case.tank.roof.mass > 0.0 {
        out.push(
            "The mass of the roof stands on the edge of the wall, its lever as a pair of forces along the edge.".into(),
        );
    }
    if !options.follower_pressure {
        out.push("The hydrostatic pressure does not turn with the wall, as asked for.".into());
    }
    if !options.self_weight {
        out.push("The wall has no weight, as asked for.".into());
    }
    out
}
