//! A strip in words and numbers: damping, facts, assumptions.

use fem::analysis::damping::Rayleigh;
use tank::Case;
use tank::units::{Dimension, display, significant};

use super::chain::Chain;
use super::liquid::StripLiquid;
use super::model::StripModel;
use super::parameters::StripTank;
use super::parts::StripDamping;
use crate::FeError;
use crate::fittings;
use crate::nonlinear::after_record::Span;
use crate::nonlinear::lasting;
use results::{Fact, FactKind};
use tank::options::nonlinear::{Contact, Damping, LiquidForm, MassProportionalAt, NonlinearOptions, StripWall};

/// Damping of the strip.
///
/// Errors: negative coefficients that were not allowed.
pub(super) fn damping(damping: Damping, liquid: &StripLiquid) -> Result<StripDamping, FeError> {
    Ok(match damping {
        Damping::ByGroup { wall, sloshing } => StripDamping::ByGroup { wall, sloshing },
        Damping::Rayleigh { first, second, allow_negative } => StripDamping::Rayleigh(
            Rayleigh::fit(first, second, allow_negative)
                .map_err(|e| FeError::option("damping", e.to_string(), "coefficients ≥ 0, or allow_negative"))?,
        ),
        Damping::MassProportional { ratio, at } => {
            let omega = match at {
                MassProportionalAt::FirstSloshing => liquid.sloshing_frequency(0),
                MassProportionalAt::Frequency(omega) => omega,
            };
            StripDamping::Rayleigh(Rayleigh::mass_proportional(omega, ratio))
        }
    })
}

/// Fibres of a section; of shells, layers of the leaf that bends.
pub(super) fn points(tank: &StripTank) -> usize {
    let most = match &tank.shells {
        Some(shells) => shells.rows.iter().map(|r| r.layers).max(),
        None => tank.sections.iter().map(|s| s.fibre_count()).max(),
    };
    most.unwrap_or(0)
}

/// The liquid in words.
pub(super) fn liquid(model: &StripModel) -> String {
    let (Some(mesh), Some(chain)) = (&model.tank.mesh, &model.chain) else {
        return format!("condensed onto the wall in closed form, {} sloshing modes", model.tank.sloshing);
    };
    let rows = chain.heights.len() - 1;
    let rotation = match mesh.rotation_penalty {
        None => "mean dilatation and split rotation penalty".to_owned(),
        Some(k) => format!("volume part at one point and rotation penalty {}", display(k, Dimension::Stress)),
    };
    format!("{} displacement elements between the walls, {} × {rows}; {rotation}", mesh.columns * rows, mesh.columns)
}

/// The joints between elements of the liquid and the walls in words.
pub(super) fn contact(chain: &Chain, tank: &StripTank) -> String {
    let tangential = tank.mesh.map_or(0.0, |mesh| mesh.tangential);
    let along = match tangential {
        0.0 => "free along the wall".to_owned(),
        k => format!("{} N/m³ along the wall", significant(k, 3)),
    };
    let opens = match chain.opens {
        false => "bonded",
        true => "opens, partly closed faces clipped",
    };
    format!("{opens}; contact elements of stiffness {} N/m³, {along}", significant(chain.penalty, 3))
}

/// The model in numbers.
pub(super) fn facts(model: &StripModel, tank: &StripTank, step: f64) -> Vec<Fact> {
    let fact = |kind, value: f64, dimension| Fact { kind, value, dimension };
    let number = Dimension::Dimensionless;
    vec![
        fact(FactKind::ElementsOverWall, (tank.levels.len() - 1) as f64, number),
        fact(FactKind::SectionFibres, points(tank) as f64, number),
        fact(FactKind::SloshingModes, tank.sloshing as f64, number),
        fact(
            FactKind::FirstSloshing,
            model.modes.omega.first().copied().unwrap_or(f64::NAN),
            Dimension::AngularFrequency,
        ),
        fact(FactKind::SloshingDamping, model.ratios[0].ratio, number),
        fact(FactKind::FirstWall, model.wall_frequency(), Dimension::AngularFrequency),
        fact(FactKind::WallDamping, model.wall_ratio(), number),
        fact(FactKind::LongestStep, step, Dimension::Time),
    ]
}

/// What the walls are.
fn walls(wall: StripWall) -> &'static str {
    match wall {
        StripWall::Fibre => {
            "Walls as fibre beams with plane sections and small deflections: no shear failure, no bond slip."
        }
        StripWall::Shell => {
            "Walls as layered shells, one element across: plane sections of each leaf, flexible in shear; no shear failure, \
             no bond slip."
        }
    }
}

/// What the liquid is, and how it is joined to the walls.
fn liquid_between(contact: Contact, liquid: LiquidForm) -> &'static str {
    match (contact, liquid) {
        (Contact::Bonded, LiquidForm::Displacement) => {
            "Liquid of displacement elements between both walls, joined to them by contact elements and bonded; both walls and the \
             liquid are one model and one run. Modes are those of the condensed liquid."
        }
        (Contact::Opening, LiquidForm::Displacement) => {
            "Liquid of displacement elements between both walls, joined to them by contact elements that transfer pressure only: \
             the liquid separates where the pressure of the displaced particle falls below atmospheric pressure. Both walls and \
             the liquid are one model and one run. Modes are those of the condensed liquid."
        }
        (Contact::Bonded, _) => {
            "Liquid of linear potential theory, condensed onto the wall and bonded to it. Both walls are run: with the \
             record and with the reversed record."
        }
        (Contact::Opening, _) => {
            "Liquid of linear potential theory, condensed onto a separate face; the contact transfers pressure only: the \
             liquid separates where the pressure of the displaced particle falls below atmospheric pressure. Both walls are \
             run: with the record and with the reversed record."
        }
    }
}

/// Assumptions of the strip, one sentence each.
pub(super) fn assumptions(case: &Case, options: &NonlinearOptions, span: &Span) -> Vec<String> {
    let mut out = vec![
        "Strip of 1 m breadth in plane strain; corners of the tank are outside the model; rigid base, clamped walls.".to_owned(),
        walls(options.wall).to_owned(),
        liquid_between(options.contact, options.liquid).to_owned(),
        "Every run starts from equilibrium under the weight of the walls and the hydrostatic pressure. An unconverged step is \
         never accepted: it is halved until it converges, or the run ends as a collapse and its numbers are lower bounds."
            .to_owned(),
        span.assumption(),
        format!(
            "A wall counts as collapsed when its top has moved by {} of its height, the limit of small-deflection theory.",
            super::LARGEST_DEFLECTION
        ),
    ];
    if options.liquid == LiquidForm::Displacement {
        out.push(
            "Sloshing modes above the first are too fast in displacement elements: with 240 of them the wave under El Centro was 4 to 10 % \
             higher than with the condensed liquid, and a finer mesh is not always nearer."
                .into(),
        );
    }
    if options.liquid == LiquidForm::Displacement && matches!(options.damping, Damping::ByGroup { .. }) {
        out.push(
            "Damping of the liquid is proportional to its mass: the ratio is that of the first sloshing mode, and falls with the \
             frequency."
                .into(),
        );
    }
    out.extend(lasting::assumptions(case, options));
    out.extend(fittings::assumptions(&case.tank, true));
    if case.tank.courses.iter().any(|c| c.layers.len() > 1) {
        out.push(
            match options.wall {
                StripWall::Fibre => {
                    "Layered wall: the stiffest leaf bends; the interlayer passes no shear and what stands on its other side \
                     counts for mass alone."
                }
                StripWall::Shell => {
                    "Layered wall: both leaves are shells with the interlayer between their faces; cracks, bars and the moment \
                     of the section are those of the stiffest leaf."
                }
            }
            .into(),
        );
    }
    if !options.self_weight {
        out.push("The weight of the walls is ignored, as requested.".into());
    }
    if options.spectral_radius < 1.0 {
        out.push(format!(
            "Generalised-α method with ρ∞ = {}: its numerical dissipation is part of the energy balance.",
            options.spectral_radius
        ));
    }
    out
}
