//! The run in words and numbers: mesh, integration, cost, assumptions.

use fem::analysis::march::{Outcome, Run};
use fem::analysis::scheme::TimeScheme;
use tank::Case;
use tank::Support;
use tank::units::{Dimension, display, significant};

use super::super::after_record::Span;
use super::super::lasting;
use super::model::CylinderModel;
use super::watch::Watch;
use crate::fittings;
use results::nonlinear::Count;
use results::{Fact, FactKind, Labelled};
use tank::options::nonlinear::{Contact, Damping, NonlinearOptions};

/// Note on an unanchored tank.
pub(super) const HELD_DOWN: &str = "The tank is unanchored; the nonlinear engine clamps the base of its wall to the ground and \
    does not model uplift here: it does so for half a perfect wall of one shell, bonded to the liquid, on a bottom plate of steel.";

/// Assumptions on a wall that stands on its bottom.
const STANDS: [&str; 3] = [
    "The unanchored wall is welded to its bottom plate, shells from the projection to half of the radius, on a Winkler ground that pushes \
     and does not pull; within half of the radius the plate stays on the ground. Ground and plate have no damping.",
    "The liquid's pressure acts on the plate as on the wall: the hydrostatic one (with vertical motion, times 1 + a_v/g), and that of the motion, \
     linear between five rings from the foot to half of the radius, with the inertia of the liquid above a plate that moves. Within half of the \
     radius the liquid's floor rests.",
    "Base shear and base moment are the forces on the ground, the moment without that of the pressure on the bottom.",
];
const PLANE_FOOT: &str = "The foot of the wall is kept a plane, as under a stiff roof: its uplift is w₀ + ψ R cos θ.";
/// What keeps it in place.
const KEPT: &str = "The tank does not slide: the mean horizontal displacement of the foot is zero. In its plane the plate moves on the ground without \
     friction.";
const FRICTION: &str = "Coulomb friction between plate and ground, of the pressure of the last step: springs as stiff as the ground give way before the \
     plate slips. Within half of the radius plate and liquid slide as one disc.";
const ANCHORS: &str = "Anchors are elastic-plastic springs that pull only, without pretension, spread evenly around the foot; what they stretch beyond their \
     yield force stays as play. The shear at the foot goes into the ground without slip.";

/// Shortest step [s]; 0 if none was taken.
fn shortest(run: &Run) -> f64 {
    if run.shortest.is_finite() { run.shortest } else { 0.0 }
}

pub(super) fn cost(tank: &CylinderModel, watch: &Watch<'_>, run: &Run) -> Vec<Count> {
    let count = |label: &str, value: f64, dimension| Count { label: label.into(), value, dimension };
    let number = Dimension::Dimensionless;
    let mut out = vec![
        count("unknowns", tank.model.dofs().len() as f64, number),
        count("wetted radial displacements", tank.wetted.len() as f64, number),
        count("steps", run.cost.steps as f64, number),
        count("steps cut to half", run.cuts as f64, number),
        count("shortest step", shortest(run), Dimension::Time),
        count("iterations", run.cost.iterations as f64, number),
        count("factorisations", run.cost.factors as f64, number),
        count("evaluations of all elements", run.cost.evaluations as f64, number),
        count("looks at all material points", watch.seen.looks as f64, number),
    ];
    if run.longest > shortest(run) * (1.0 + 1e-9) {
        out.push(count("longest step", run.longest, Dimension::Time));
    }
    if run.refused > 0 {
        out.push(count("long steps taken back", run.refused as f64, number));
    }
    out
}

/// The model in numbers.
pub(super) fn facts(tank: &CylinderModel, step: f64) -> Vec<Fact> {
    let fact = |kind, value: f64, dimension| Fact { kind, value, dimension };
    let number = Dimension::Dimensionless;
    vec![
        fact(FactKind::ShellsAround, tank.cells.columns() as f64, number),
        fact(FactKind::ShellsOverHeight, tank.cells.rows() as f64, number),
        fact(FactKind::SloshingModes, tank.amplitudes.len() as f64, number),
        fact(FactKind::Unknowns, tank.model.dofs().len() as f64, number),
        fact(FactKind::FirstSloshing, tank.sloshing_omega, Dimension::AngularFrequency),
        fact(FactKind::FirstWall, tank.wall_omega, Dimension::AngularFrequency),
        fact(FactKind::WallDamping, tank.wall_ratio, number),
        fact(FactKind::LongestStep, step, Dimension::Time),
    ]
}

fn label(label: &str, text: String) -> Labelled {
    Labelled { label: label.into(), text }
}

pub(super) fn mesh(tank: &CylinderModel) -> Vec<Labelled> {
    let layers = tank.rows.iter().map(|r| r.parts.iter().map(Vec::len).sum::<usize>()).max();
    vec![
        label("shells (around × over the height)", format!("{} × {}", tank.cells.columns(), tank.cells.rows())),
        label(
            "symmetry",
            match tank.cells.half {
                true => "half of the tank, mirrored at the plane of shaking".into(),
                false => "the whole tank".into(),
            },
        ),
        label("layers and bars over the thickness", layers.unwrap_or(0).to_string()),
        label(
            "liquid",
            format!(
                "condensed onto {} radial displacements and {} sloshing modes",
                tank.wetted.len(),
                tank.amplitudes.len()
            ),
        ),
        label("unknowns", tank.model.dofs().len().to_string()),
    ]
}

pub(super) fn integration(
    tank: &CylinderModel,
    options: &NonlinearOptions,
    span: &Span,
    watch: &Watch<'_>,
    run: &Run,
) -> Vec<Labelled> {
    let scheme = TimeScheme::GeneralizedAlpha { radius: options.spectral_radius };
    let method = match scheme {
        TimeScheme::GeneralizedAlpha { radius } => format!(
            "generalised-α method, ρ∞ = {}, {}",
            significant(radius, 3),
            match (&tank.joints, &tank.zone) {
                (Some(_), _) => "full Newton iteration",
                (None, Some(_)) => {
                    "Newton iteration with the tangent of plate and ground, that of the wall renewed where it is slow"
                }
                (None, None) => "modified Newton iteration with line search",
            }
        ),
        _ => "implicit".into(),
    };
    let damping = match options.damping {
        Damping::ByGroup { wall, sloshing } => format!(
            "wall {} % at the first mode of wall and liquid, proportional to the initial stiffness of the wall; sloshing modes \
             {} % each",
            significant(100.0 * wall, 3),
            significant(100.0 * sloshing, 3)
        ),
        Damping::Rayleigh { .. } => "Rayleigh damping on the initial stiffness of the wall".into(),
        Damping::MassProportional { ratio, .. } => {
            format!("proportional to the mass, {} %", significant(100.0 * ratio, 3))
        }
    };
    let mut out = vec![
        label("method", method),
        label("time step", format!("{} steps; the shortest {} s", run.cost.steps, significant(shortest(run), 3))),
        label(
            "duration",
            match run.outcome {
                Outcome::Completed => span.text(),
                _ => format!("{:.2} s of {}", run.time, span.text()),
            },
        ),
        label("damping", damping),
        label(
            "damping of the first mode of wall and liquid",
            format!(
                "{} % at {} rad/s, initial stiffness{}",
                significant(100.0 * tank.wall_ratio, 3),
                significant(tank.wall_omega, 4),
                if tank.standing.is_some() { ", foot held" } else { "" }
            ),
        ),
    ];
    if let (Some(joints), Some(openings)) = (&tank.joints, &watch.openings) {
        out.push(label(
            "contact of liquid and wall",
            format!(
                "opens; a joint at every wetted node, stiffness {} N/m³, penetration at most {}; its force is evaluated at the \
                 end of the step",
                significant(joints.penalty, 3),
                display(openings.penetration(), Dimension::Length)
            ),
        ));
    }
    out
}

pub(super) fn assumptions(case: &Case, options: &NonlinearOptions, tank: &CylinderModel, span: &Span) -> Vec<String> {
    let mut out = vec![
        "Wall of four-node shells with finite rotations, plane sections in each shell, layers and bars with the laws of the \
         input"
            .to_owned()
            + match tank.standing {
                None => "; clamped at its base, rigid bottom.",
                Some(_) => ".",
            },
        match options.contact {
            Contact::Bonded => {
                "Liquid of linear potential theory on the undeformed tank, condensed onto the radial displacements of the wall; \
                 gravity acts on the surface in the circumferential waves 0 and 1. It stays in contact with the wall; the \
                 report states where the pressure of the displaced particle falls below zero."
            }
            Contact::Opening => {
                "Liquid of linear potential theory on the undeformed tank, condensed onto the radial displacements of a \
                 separate face; gravity acts on the surface in the circumferential waves 0 and 1. The contact transfers \
                 pressure only: the liquid separates where the pressure of the displaced particle falls below atmospheric pressure."
            }
        }
        .to_owned(),
        "The run starts from equilibrium under weight and hydrostatic pressure. An unconverged step is never accepted: it is \
         halved until it converges, or the run ends as a collapse and its numbers are lower bounds."
            .to_owned(),
        span.assumption(),
        "Damping of the wall is proportional to its initial stiffness; where the wall softens, the damping force remains, and \
         its energy is reported."
            .to_owned(),
    ];
    out.extend(lasting::assumptions(case, options));
    out.extend(fittings::assumptions(&case.tank, true));
    if let Some(standing) = &tank.standing {
        out.extend(STANDS.map(String::from));
        if options.plane_foot {
            out.push(PLANE_FOOT.into());
        }
        let kept = match (standing.slides(), case.tank.support) {
            (true, _) => FRICTION,
            (false, Support::Anchored) => ANCHORS,
            (false, Support::Unanchored) => KEPT,
        };
        out.push(kept.into());
    } else if case.tank.support == Support::Unanchored {
        out.push(HELD_DOWN.into());
    }
    if options.follower_pressure {
        out.push("The hydrostatic pressure rotates with the deformed wall; the dynamic pressure does not.".into());
    }
    if !options.self_weight {
        out.push("The weight of the wall is ignored, as requested.".into());
    }
    if !tank.imperfections.is_empty() {
        out.push(
            "The wall is imperfect (analysis.imperfections): its nodes lie on the deviating surface, which is free of stress when empty. \
             The liquid stays that of the perfect cylinder: its dynamic pressure acts along the perfect radius. The damping of the \
             wall is fitted at the first mode of the perfect tank."
                .into(),
        );
    }
    if case.ground_motion.as_ref().is_some_and(|m| m.transverse.is_some()) {
        out.push(super::two::ASSUMPTION.into());
    }
    if tank.cells.half {
        out.push(
            "Motion is symmetric about the plane of shaking: buckles that break this symmetry are not modelled.".into(),
        );
    }
    if case.tank.courses.iter().any(|c| c.build_up().iter().any(|l| !l.reinforcement.is_empty())) {
        out.push(
            "Bars are smeared into layers and perfectly bonded; their mass and the concrete they displace are ignored."
                .into(),
        );
    }
    out
}
