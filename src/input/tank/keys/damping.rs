//! `damping`: damping ratios of sloshing and of the wall.

use tank::Tank;
use tank::case;

use crate::input::tank::key::{Absent, Limits, default};
use crate::input::tank::read::{Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::Number;

/// Damping ratios.
pub(super) const RATIO: Limits = Limits::from(0.0).below(1.0);
/// Young's modulus [Pa] below which a wall counts as concrete or plastic, not metal.
const METAL: f64 = 60e9;

object! {
    /// Damping ratios, as fractions of critical damping.
    Damping {
        /// Of sloshing modes.
        sloshing (0.005): Opt<Number> [RATIO]
            = default(Number(0.005)).because("EN 1998-4:2006 2.3.3: water and other liquids 0.5 %"),
        /// Of structural (impulsive) modes.
        impulsive (0.02): Opt<Number> [RATIO] = Absent::Follows(
            "0.02 for steel and aluminium, 0.05 for walls with a Young's modulus below 60 GPa such as concrete"
        ),
    }
}

/// Damping ratios; the default of the wall follows from its material.
pub(super) fn damping(r: &mut Resolver<'_>, option: &Opt<Damping>, tank: Option<&Tank>) -> case::Damping {
    let Some(given) = option.or_absent() else {
        return case::Damping {
            sloshing: f64::NAN,
            impulsive: f64::NAN,
        };
    };
    let softest = tank.map_or(f64::NAN, |t| {
        t.courses
            .iter()
            .map(|c| c.material.youngs_modulus)
            .fold(f64::INFINITY, f64::min)
    });
    let (ratio, text, why) = if softest < METAL {
        (
            0.05,
            "0.05",
            "EN 1998-4:2006 2.3.3 and EN 1998-1: concrete 5 % (Young's modulus of the wall below 60 GPa)",
        )
    } else {
        (
            0.02,
            "0.02",
            "EN 1998-4:2006 2.3.3: welded steel 2 % (Young's modulus of the wall 60 GPa or more)",
        )
    };
    case::Damping {
        sloshing: r.or_default(&given.sloshing),
        impulsive: r.or_else(&given.impulsive, ratio, text, why),
    }
}
