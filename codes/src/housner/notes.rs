//! Assumptions of the procedure and remarks on its results.

use super::run::Run;
use crate::mechanical::{self, Plan};
use crate::sheet::{number, with_unit};
use tank::case::Combination;
use tank::units::Dimension::{Length, Mass};
use tank::{Shape, Support};

/// Angle of the surface above which waves are no longer small [rad].
const SMALL_ANGLE: f64 = 0.2;

/// One sentence each.
pub(super) fn assumptions(run: &Run) -> Vec<String> {
    let mut list = vec![
        "Rigid wall on a rigid base, horizontal motion along one axis, inviscid liquid with a free surface."
            .to_string(),
        run.motion.assumption.clone(),
        match run.combination {
            Combination::Abs => "Maxima of the impulsive and the convective part are added.".into(),
            Combination::Srss => "Maxima of the impulsive and the convective part are combined by SRSS.".into(),
        },
        if run.exact() {
            "Frequency and mass of the sloshing mode are the exact ones of potential flow; the wave formula keeps \
             Housner's constants, for which its finite-angle term was made."
                .into()
        } else {
            "Convective constants as published (1957/1963).".into()
        },
        match run.case.tank.roof.snow {
            None => "Wall and roof inertia is not counted: Housner's procedure gives the liquid's forces.".into(),
            Some(_) => {
                "Inertia of wall, roof and snow is not counted: Housner's procedure gives the liquid's forces.".into()
            }
        },
        "Brüggemann 2002: M. Brüggemann, Zur nichtlinearen Zeitbereichssimulation flüssigkeitsgefüllter \
         Tankbauwerke unter Erdbebenanregung, Wuppertal 2002."
            .into(),
    ];
    match run.case.tank.shape {
        Shape::Cylinder { .. } => list.push(
            "Pressures vary as cos θ around the circumference; the convective pressure follows cosh(k z/R) over the \
             depth; stresses are those of the thin circular cross-section (beam) and of the ring (membrane), D = 2R."
                .into(),
        ),
        Shape::Rectangle { strip, .. } => {
            list.push(
                "The two walls across the motion carry half the moment each, as cantilevers over their whole breadth."
                    .into(),
            );
            if strip {
                list.push("Strip: masses, forces and moments are those of the strip's breadth.".into());
            }
        }
    }
    list
}

/// One sentence each.
pub(super) fn notes(run: &Run) -> Vec<String> {
    let r = &run.response;
    let mut list = Vec::new();
    if r.wave.finite.is_none() {
        list.push(format!(
            "Sloshing amplitude outside Housner's theory: g/(ω² θ_h a) = {} is not above 1; the linear value {} stands in.",
            number(r.wave.ratio),
            with_unit(r.wave.linear, Length)
        ));
    } else if r.angle > SMALL_ANGLE {
        list.push(format!(
            "The surface angle {} rad exceeds {SMALL_ANGLE} rad: the waves are not small.",
            number(r.angle)
        ));
    }
    let freeboard = run.case.freeboard();
    if r.wave.height() > freeboard {
        list.push(format!(
            "The wave of {} is higher than the freeboard of {}.",
            with_unit(r.wave.height(), Length),
            with_unit(freeboard, Length)
        ));
    }
    if r.slender {
        list.push(
            "Slender tank: the overturning moment with base pressure is an extension, Housner defines it for squat tanks \
             only; below the sloshing part the pressure of its lower end is continued, 6 % above what the force of the \
             constrained liquid needs."
                .into(),
        );
    }
    let share = (r.impulsive_mass + r.rigid_mass + r.convective_mass) / run.input.mass;
    if share > 1.0 {
        list.push(format!(
            "Impulsive and convective mass add to {} of the liquid mass: Housner's impulsive mass is {} times that of \
             potential flow at this depth.",
            number(share),
            number((r.impulsive_mass + r.rigid_mass) / (run.input.mass * exact_share(run)))
        ));
    }
    if !run.exact() && run.plan == Plan::Circle {
        list.push(
            "The published constant 0.318 is 30 % below the convective mass of potential flow (0.4545), and 0.408 gives \
             25 % less than the linear wave."
                .into(),
        );
    }
    let inertia = run.case.tank.wall_mass() + run.case.tank.roof.mass;
    if inertia > 0.01 * run.input.mass {
        list.push(format!(
            "Wall and roof, {}, would add {} % to the mass that moves with the ground.",
            with_unit(inertia, Mass),
            number((1000.0 * inertia / (r.impulsive_mass + r.rigid_mass)).round() / 10.0)
        ));
    }
    if run.case.tank.support == Support::Unanchored {
        list.push(
            "The tank is not anchored: uplift is outside this procedure, values hold while the base stays down.".into(),
        );
    }
    list
}

/// Exact impulsive share of the liquid mass.
fn exact_share(run: &Run) -> f64 {
    mechanical::impulsive(run.plan, run.input.depth / run.input.half_length).mass
}
