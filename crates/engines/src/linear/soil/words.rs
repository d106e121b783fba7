//! Notes of a run on soil.

use results::EngineId;
use tank::{Case, FoundationKind, Shape, Support};

/// Another engine, or plane walls.
const RIGID_GROUND: &str =
    "The tank stands on a slab on soil; this run leaves the soil and the mass of the slab out: its ground is rigid.";
/// Note of a run on soil.
const ON_SOIL: &str = "The tank moves on its slab and the soil below it: waves, forces and stresses of this run contain the motion of the slab. \
     Modes, their part in design spectra and the impulsive period and mass are those on a fixed base.";
/// A tank that is not anchored.
const UNANCHORED: &str = "The tank is not anchored: translation and rocking of its slab on the soil are left out, so that the soil is not \
     counted twice. `tank.foundation.shear_wave_velocity` acts on the ground under the rim alone, where it lifts; while nothing lifts the base \
     is rigid, and periods and damping are those of a rigid base. The mass of the slab is not used.";

/// What is said of soil under a slab.
pub(crate) fn note(case: &Case, engine: EngineId, moves: bool) -> Option<String> {
    let foundation = case.tank.foundation?;
    if foundation.kind != FoundationKind::Slab || foundation.shear_wave_velocity.is_none() {
        return None;
    }
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    if engine != EngineId::Nonlinear && round && case.tank.support == Support::Unanchored {
        return Some(UNANCHORED.into());
    }
    Some(if moves { ON_SOIL } else { RIGID_GROUND }.into())
}
