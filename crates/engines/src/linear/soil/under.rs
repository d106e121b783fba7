//! The system of a tank on its slab on soil.

use ::soil::body::Mode;
use fem::linalg::dot;
use tank::Case;

use super::Slab;
use super::extend::{Rigid, on_soil};
use super::ground::Ground;
use crate::FeError;
use crate::damping::Damper;
use crate::harmonic::Places;
use crate::linear::model::Model;
use crate::linear::system::Harmonic;
use tank::options::LinearOptions as Options;

/// The system of m = 1 on its slab, and that on a fixed base, where there is soil under the slab.
///
/// Errors: as [`Slab::of`], [`Ground::of`] and [`on_soil`].
pub(crate) fn under(case: &Case, damper: &Damper, held: Harmonic) -> Result<(Harmonic, Option<Harmonic>), FeError> {
    let Some(slab) = Slab::of(case)? else { return Ok((held, None)) };
    let ground = Ground::of(&slab, impulsive(case, &held, damper, &slab))?;
    let (coupled, modes) = on_soil((&held.coupled, &held.modes), case, damper, (&slab, &ground))?;
    Ok((Harmonic { coupled, modes }, Some(held)))
}

/// The slab of a case and the ground below it, for another model of the tank; `None` without soil under a slab.
///
/// Errors: as [`under`]; those of the model on a fixed base, whose impulsive mode chooses the springs of layers.
pub(crate) fn founded(case: &Case) -> Result<Option<(Slab, Ground)>, FeError> {
    let Some(slab) = Slab::of(case)? else { return Ok(None) };
    let mode = match slab.embedded {
        None => None,
        Some(_) => fixed(case, &slab)?,
    };
    let ground = Ground::of(&slab, mode)?;
    Ok(Some((slab, ground)))
}

/// The impulsive mode of the model on a fixed base.
///
/// Errors: those of the model.
pub(super) fn fixed(case: &Case, slab: &Slab) -> Result<Option<Mode>, FeError> {
    let model = Model::new(case, &Options::default(), false, Places::Usual)?;
    Ok(impulsive(case, model.held(), &model.damper, slab))
}

/// The impulsive mode as a structure of one mass, with the arm about the underside of the slab; `None` without such a mode.
pub(crate) fn impulsive(case: &Case, held: &Harmonic, damper: &Damper, slab: &Slab) -> Option<Mode> {
    let omega = held.impulsive()?.dominant.omega;
    let mode = held.modes.iter().find(|mode| mode.omega == omega)?;
    let rigid = Rigid::of(&held.coupled, case, slab)?;
    Some(Mode {
        omega,
        damping: damper.of(mode),
        translation: mode.participation,
        rotation: dot(&mode.vector, &rigid.moment),
    })
}
