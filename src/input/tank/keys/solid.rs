//! `analysis.solid`: options of the three-dimensional engine.

use tank::options::SolidOptions;
use tank::options::solid::{Liquid as LiquidElement, MeshSize};

use crate::input::diagnostic::Faults;
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Object, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Stress, Whole};
use results::InputValue;
use tank::keys::{Limits, default, without};

/// Penalty of rotations: ρ g R is 1 kPa in a model of 0.1 m and 0.5 MPa in a tank of 50 m; ρ c², at which all rotation is gone, is 2 GPa.
const PENALTY: Limits = Limits::from(1.0).to(1e10);

/// Defaults.
const DEFAULT: &SolidOptions = &SolidOptions::DEFAULT;

object! {
    /// Options of the three-dimensional engine.
    Solid {
        /// Numbers of elements over radius (or half length), circumference (or breadth, an even number) and height of the wall.
        mesh: Opt<MeshSize> = without("by the size of the tank"),
        /// Formulation of the liquid.
        liquid: Opt<LiquidElement> = default(DEFAULT.liquid).because("nothing to calibrate"),
        /// Penalty K_rot of the displacement liquid, with the volume part at one point and the full rotation part of its first publication; it
        /// has to be calibrated for each tank and mesh.
        rotation_penalty ("100 kPa"): Opt<Stress> [PENALTY] = without("a split penalty that needs no calibration"),
        /// Largest memory of matrices and factors in MiB.
        memory_limit (8192): Opt<Whole> [Limits::from(1.0)] = default(Whole(DEFAULT.memory_limit_mib as u32)),
    }
}

choice!(LiquidElement);

/// Options of the three-dimensional engine. Defaults are echoed only where the engine runs, by [`solid_defaults`].
pub(super) fn solid(r: &mut Resolver<'_>, given: Option<&Solid>) -> SolidOptions {
    let Some(given) = given else { return DEFAULT.clone() };
    let mut options = DEFAULT.clone();
    if let Some(field) = &given.mesh.given {
        r.echo_given(field);
        options.mesh = field.value;
    }
    if given.liquid.given.is_some() {
        options.liquid = r.or_default(&given.liquid);
    }
    options.rotation_penalty = r.optional(&given.rotation_penalty);
    options.memory_limit_mib = r.or_default(&given.memory_limit).into();
    options
}

/// The echo of the defaults of `mesh` and `liquid`.
pub fn solid_defaults() -> Vec<InputValue> {
    let absent = Solid::absent("analysis.solid");
    let mut faults = Faults::new();
    let mut r = Resolver::new(&mut faults);
    r.not_given(&absent.mesh);
    r.or_default(&absent.liquid);
    r.echo
}
