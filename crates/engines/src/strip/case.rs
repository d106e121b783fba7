//! From a case to the strip of the nonlinear engine: walls of fibres or shells, liquid condensed onto them.

use std::sync::Arc;

use fem::analysis::newton::Options;
use fem::analysis::scheme::TimeScheme;
use fem::element::fibre_beam;
use tank::Case;
use tank::Shape;

use super::describe::{assumptions, damping, facts};
use super::liquid::StripLiquid;
use super::model::StripModel;
use super::parameters::{self, LiquidMesh, StripTank};
use super::run::StripQuake;
use super::section::{course_at, levels, section};
use super::shells;
use crate::FeError;
use crate::nonlinear::after_record::Span;
use crate::nonlinear::laws::unsupported;
use results::Fact;
use tank::options::nonlinear::{Contact, LiquidForm, NonlinearOptions, StripWall};

/// Sloshing modes of the condensed liquid: the tenth holds 1e-4 of the liquid's mass.
const SLOSHING_MODES: usize = 12;
/// Default number of elements over the wall.
pub(crate) const ELEMENTS: u32 = 40;
/// Steps of the time integration in a period of the first mode of wall and liquid.
pub(super) const STEPS_PER_PERIOD: f64 = 20.0;

/// Elements of a displacement liquid; without a number of them over half the length as long as the rows next to them are high.
fn mesh(case: &Case, options: &NonlinearOptions) -> Option<LiquidMesh> {
    if options.liquid == LiquidForm::Condensed {
        return None;
    }
    let Shape::Rectangle { length, .. } = case.tank.shape else { return None };
    let levels = levels(case, options.elements.map_or(ELEMENTS, |e| e.height));
    let wet = levels.iter().filter(|z| **z < case.liquid.fill_height * (1.0 - 1e-9)).count().max(1);
    let square = (0.5 * length * wet as f64 / case.liquid.fill_height).round().max(1.0) as usize;
    let half = options.liquid_elements.map_or(square, |n| n as usize);
    Some(LiquidMesh {
        rotation_penalty: options.rotation_penalty,
        tangential: options.contact_tangential,
        ..LiquidMesh::new(2 * half, case.liquid.compression_modulus())
    })
}

/// A strip with its ground motion.
pub(crate) struct Strip {
    pub model: StripModel,
    pub quake: StripQuake,
    /// The case, without its records.
    pub case: Case,
    /// End of the records and of a run.
    pub span: Span,
    /// Computing time between two checkpoints [s].
    pub seconds: f64,
    /// The model in numbers.
    pub facts: Vec<Fact>,
    /// Assumptions, one sentence each.
    pub assumptions: Vec<String>,
}

impl Strip {
    /// The strip of a case with its record.
    ///
    /// Errors: no record; a tank that is not a strip; an unsupported wall, law or option; parameters out of range.
    pub(crate) fn new(case: &Case, options: &NonlinearOptions) -> Result<Strip, FeError> {
        let Some(motion) = &case.ground_motion else { return Err(FeError::NoRecord) };
        let Shape::Rectangle { length, strip: true, .. } = case.tank.shape else {
            return unsupported(
                "the tank is not a strip; the nonlinear engine runs strips of long rectangular tanks (shape rectangle, strip true)",
            );
        };
        if case.tank.roof.mass > 0.0 {
            return unsupported("the strip engine does not support a roof mass; remove `roof`");
        }
        let levels = levels(case, options.elements.map_or(ELEMENTS, |e| e.height));
        let mut sections = Vec::new();
        let shells = match options.wall {
            StripWall::Fibre => None,
            StripWall::Shell => Some(shells::wall(case, &levels, options)?),
        };
        for ends in levels.windows(2) {
            let mut layers = course_at(case, 0.5 * (ends[0] + ends[1])).build_up();
            if shells.is_some() {
                layers = shells::elastic(&layers);
            }
            sections.push(Arc::new(section(&layers, ends[1] - ends[0], options)?));
        }
        let liquid = StripLiquid {
            half_width: 0.5 * length,
            depth: case.liquid.fill_height,
            density: case.liquid.density,
            gravity: case.gravity,
        };
        let tank = StripTank {
            levels,
            sections,
            shells,
            options: fibre_beam::Options::default(),
            carried: case.tank.carried().map(|(mass, height)| (mass / case.tank.perimeter(), height)).collect(),
            base_spring: None,
            liquid,
            sloshing: SLOSHING_MODES,
            contact: match options.contact {
                Contact::Bonded => parameters::Contact::Bonded,
                Contact::Opening => parameters::Contact::Joined { opens: true, penalty: None },
            },
            mesh: mesh(case, options),
        };
        let mut model = StripModel::new(&tank, damping(options.damping, &liquid)?)?;
        if !options.self_weight {
            model.weight.fill(0.0);
        }
        let record = &motion.horizontal;
        let period = std::f64::consts::TAU / model.wall_frequency();
        let step = options.time_step.unwrap_or_else(|| (period / STEPS_PER_PERIOD).min(0.5 * record.dt));
        let mut quake = StripQuake::new(record.clone(), step);
        quake.vertical.clone_from(&motion.vertical);
        quake.scheme = TimeScheme::GeneralizedAlpha { radius: options.spectral_radius };
        // Joints that open, and a loose layer.
        if model.assembler.acts_at_end() {
            quake.newton = Options::for_contact();
        }
        let sloshing = model.modes.omega.first().copied().unwrap_or(0.0);
        let span = Span::new(motion, options.after_record, sloshing)?;
        quake.until = Some(span.end());
        let facts = facts(&model, &tank, step);
        Ok(Strip {
            model,
            quake,
            case: Case { ground_motion: None, ..case.clone() },
            span,
            seconds: options.checkpoint,
            facts,
            assumptions: assumptions(case, options, &span),
        })
    }
}
