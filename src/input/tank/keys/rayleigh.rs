//! Rayleigh damping fitted to two ratios, for the linear engines and the nonlinear one.

use super::damping::RATIO;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::values::{Number, Pitch};
use ::tank::keys::default;
use files::code::Code;

object! {
    /// Rayleigh damping C = a_M M + a_K K fitted to two ratios.
    Rayleigh {
        /// First pair.
        first: Field<RatioAt>,
        /// Second pair.
        second: Field<RatioAt>,
        /// Accept a negative coefficient (to repeat published runs).
        allow_negative (true): Opt<bool> = default(false),
    }

    /// A damping ratio at a frequency.
    RatioAt {
        /// Circular frequency, frequency or period.
        at ("2 Hz"): Field<Pitch>,
        /// Damping ratio.
        ratio (0.02): Field<Number> [RATIO],
    }
}

/// A (circular frequency [rad/s], ratio) pair.
type Pair = (f64, f64);

/// A pair; NaN where it is faulty.
pub(super) fn ratio_at(r: &mut Resolver<'_>, field: &Field<RatioAt>) -> Pair {
    let Some(pair) = &field.value else { return (f64::NAN, f64::NAN) };
    r.echo_given(&pair.at);
    (pair.at.value.map_or(f64::NAN, |p| p.0), r.number(&pair.ratio))
}

/// Both pairs of Rayleigh damping, and whether a negative coefficient is accepted.
pub(super) fn rayleigh(r: &mut Resolver<'_>, rayleigh: &Rayleigh) -> (Pair, Pair, bool) {
    let (first, second) = (ratio_at(r, &rayleigh.first), ratio_at(r, &rayleigh.second));
    if (first.0 - second.0).abs() <= 1e-9 * first.0 {
        let message = "both pairs have the same frequency";
        r.refuse(Code::Repeated, &rayleigh.second, message, "two frequencies");
    }
    let allow_negative = r.or_default(&rayleigh.allow_negative);
    // ζ = a_M/(2ω) + a_K ω/2 through both pairs.
    let denominator = second.0.powi(2) - first.0.powi(2);
    let stiffness = 2.0 * (second.1 * second.0 - first.1 * first.0) / denominator;
    let mass = 2.0 * first.1 * first.0 - stiffness * first.0.powi(2);
    if !allow_negative && (stiffness < 0.0 || mass < 0.0) {
        r.faults.push(
            range_fault(
                Code::Contradiction,
                &rayleigh.second,
                "these pairs require a negative coefficient",
                "both coefficients ≥ 0",
            )
            .found(format!("a_M = {mass:.4e} 1/s, a_K = {stiffness:.4e} s"))
            .help("choose other pairs, or set allow_negative to repeat a published run"),
        );
    }
    (first, second, allow_negative)
}
