//! The modes on a fixed base as the body of [`::soil::body`], a second formulation of the run on soil.

use ::soil::body::{Body, Mode};
use ::soil::disc::Disc;
use fem::linalg::dot;
use tank::Case;
use tank::options::LinearOptions as Options;

use super::Slab;
use super::extend::Rigid;
use crate::FeError;
use crate::harmonic::Places;
use crate::linear::model::Model;

/// The body of a case on its slab, and the disc below it; `None` without a slab on soil.
///
/// Errors: those of the model on a fixed base.
pub fn slab_body(case: &Case, options: &Options) -> Result<Option<(Body, Disc)>, FeError> {
    let Some(slab) = Slab::of(case)? else { return Ok(None) };
    let model = Model::new(case, options, false, Places::Usual)?;
    Ok(body(case, &model, &slab).map(|body| (body, slab.disc)))
}

/// The same of a model; mass and moments of inertia of the slab are among those of the body.
pub(super) fn body(case: &Case, model: &Model, slab: &Slab) -> Option<Body> {
    let held = model.held();
    let rigid = Rigid::of(&held.coupled, case, slab)?;
    let modes = held.modes.iter().map(|mode| Mode {
        omega: mode.omega,
        damping: model.damper.of(mode),
        translation: mode.participation,
        rotation: dot(&mode.vector, &rigid.moment),
    });
    Some(Body {
        modes: modes.collect(),
        mass: rigid.mass,
        first_moment: rigid.first,
        second_moment: rigid.second,
        slab_mass: 0.0,
        slab_inertia: 0.0,
    })
}
