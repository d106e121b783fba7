//! Plausibility of a yield strength.

use files::code::Code;
use tank::units::{Dimension, display_in, unit_for};

use crate::input::tank::read::Field;
use crate::input::tank::resolver::{Resolver, like_unit};
use crate::input::tank::values::Stress;

/// Largest usual yield strength [Pa]: prestressing steel has 1.9 GPa.
const STRONGEST: f64 = 2e9;
/// Largest usual strain at yielding of metals, and Young's modulus [Pa] from which on a material is one.
const METAL: (f64, f64) = (0.01, 20e9);
/// Largest usual strain at yielding of plastics.
const PLASTIC: f64 = 0.05;
/// Share of Young's modulus at which the bonds of any solid fail.
const THEORETICAL: f64 = 0.1;
/// Slack for quotients of decimal fractions.
const ROUNDING: f64 = 1e-9;

/// Checks a yield strength [Pa] against Young's modulus [Pa] (NaN: unknown or faulty).
pub(super) fn check(r: &mut Resolver<'_>, field: &Field<Stress>, strength: f64, e: f64) {
    let show = |stress: f64| display_in(stress, unit_for(stress, Dimension::Stress), 3);
    if strength > THEORETICAL * e * (1.0 + ROUNDING) {
        let allowed =
            format!("at most {}, a tenth of Young's modulus", like_unit(field, THEORETICAL * e, Dimension::Stress));
        let message = "the yield strength is larger than any material's";
        r.refuse(Code::OutOfRange, field, message, &allowed);
        return;
    }
    let strain = if e >= METAL.1 { METAL.0 } else { PLASTIC };
    let usual = if e.is_nan() { STRONGEST } else { STRONGEST.min(strain * e) };
    if strength > usual * (1.0 + ROUNDING) {
        let why = if usual < STRONGEST { format!(" ({} % of Young's modulus)", 100.0 * strain) } else { String::new() };
        r.warn(
            Code::UnusualTank,
            format!(
                "{}: unusual yield strength; found {}, usual is up to {}{why}",
                field.path,
                field.text,
                show(usual)
            ),
        );
    }
}
