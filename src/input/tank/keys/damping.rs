//! `damping`: damping ratios of sloshing and of the wall.

use tank::Tank;
use tank::case;

use crate::input::tank::read::{Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::Number;
use tank::keys::{Absent, Limits, default};

/// Ratios of Rayleigh damping and of single modes.
pub(super) const RATIO: Limits = Limits::from(0.0).below(1.0);
/// Ratios of sloshing: baffles and thick liquids have some per cent.
const SLOSHING: Limits =
    Limits::from(0.0).to(0.05).usual(0.001, 0.01).clause("EN 1998-4:2006 2.3.3 has 0.005 for liquids");
/// Largest usual ratio of any wall.
pub(super) const USUAL: f64 = 0.1;
/// Ratios of the wall: from 0.28 on the factor η of EN 1998-1 stays at 0.55.
const IMPULSIVE: Limits =
    Limits::from(0.0).to(0.28).usual(0.001, USUAL).clause("EN 1998-1:2004 3.2.2.2, where η ends at 0.55");

object! {
    /// Damping ratios, as fractions of critical damping.
    Damping {
        /// Ratio of sloshing modes.
        sloshing (0.005): Opt<Number> [SLOSHING]
            = default(Number(0.005)).because("EN 1998-4:2006 2.3.3: water and other liquids 0.5 %"),
        /// Ratio of structural (impulsive) modes.
        impulsive (0.02): Opt<Number> [IMPULSIVE] = Absent::Follows(
            "0.02 for walls of metal, 0.05 for others such as concrete"
        ),
    }
}

/// Damping ratios; the default of the wall follows from its material.
pub(super) fn damping(r: &mut Resolver<'_>, option: &Opt<Damping>, tank: Option<&Tank>) -> case::Damping {
    let Some(given) = option.or_absent() else { return case::Damping { sloshing: f64::NAN, impulsive: f64::NAN } };
    let soft = tank.is_some_and(|t| !t.wall_materials().all(|m| m.is_metal()));
    let (ratio, text, why) = match soft {
        true => (0.05, "0.05", "EN 1998-4:2006 2.3.3 and EN 1998-1: concrete 5 %; the wall is not of metal"),
        false => (0.02, "0.02", "EN 1998-4:2006 2.3.3: welded steel 2 %; the wall is of metal"),
    };
    case::Damping { sloshing: r.or_default(&given.sloshing), impulsive: r.or_else(&given.impulsive, ratio, text, why) }
}
