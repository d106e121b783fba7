//! Notes and assumptions of a run on soil.

use results::EngineId;
use tank::{Case, FoundationKind, Shape, Support};

use super::Slab;

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
    if engine == EngineId::Harmonic && round && case.tank.support == Support::Unanchored {
        return Some(UNANCHORED.into());
    }
    let on_soil = moves && engine == EngineId::Harmonic && round;
    Some(if on_soil { ON_SOIL } else { RIGID_GROUND }.into())
}

/// Assumptions, one sentence each.
pub(super) fn assumptions(slab: &Slab) -> Vec<String> {
    let mut list: Vec<String> = [
        "The slab is rigid and rests on the surface of a uniform half-space; the free field moves it without kinematic interaction.",
        "Soil as cones of Meek and Wolf with the stiffness of `shear_wave_velocity`, the value at the strains of the earthquake; its \
         hysteresis is left out.",
        "The bottom pressure turns the slab, and the liquid on the turning floor has its inertia; the weight of liquid and wall has no moment \
         in the turned position.",
        "Modal damping is that of the tank on a fixed base; the soil adds its dashpots.",
        "Vertical motion is that of a fixed base.",
    ]
    .map(String::from)
    .to_vec();
    list.push(if slab.thickness > 0.0 {
        "The slab is a disc of reinforced concrete of 2500 kg/m³ with the radius of the bottom plate.".into()
    } else {
        "Without `tank.foundation.thickness` the slab has no mass.".into()
    });
    list
}
