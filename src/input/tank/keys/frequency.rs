//! `analysis.frequency`: transfer functions of the linear engines.

use files::code::Code;
use tank::options::frequency::{FrequencyDamping, FrequencyOptions};

use crate::input::tank::key::{Absent, Limits, default};
use crate::input::tank::read::{Field, Opt, choice, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Pitch, Whole};

/// Defaults.
const DEFAULT: FrequencyOptions = FrequencyOptions::DEFAULT;

object! {
    /// Transfer functions of a linear engine: wave, base shear and overturning moment per unit of harmonic horizontal acceleration.
    Frequency {
        /// Lowest frequency.
        from ("0.05 Hz"): Opt<Pitch> = Absent::Follows("a fifth of the first sloshing frequency"),
        /// Highest frequency.
        to ("50 Hz"): Opt<Pitch> = Absent::Follows("twice the frequency of the impulsive mode"),
        /// Number of frequencies with equal ratios; those around the peaks of the modes are added.
        points (1000): Opt<Whole> [Limits::count(2, 20_000)] = default(Whole(DEFAULT.points as u32)),
        /// Damping.
        damping: Opt<FrequencyDamping> = default(DEFAULT.damping),
    }
}

choice!(FrequencyDamping);

/// Options of transfer functions; none if they are not asked for.
pub(super) fn frequency(r: &mut Resolver<'_>, given: &Opt<Frequency>) -> Option<FrequencyOptions> {
    let given = given.given.as_ref()?.value.as_ref()?;
    let mut end = |option: &Opt<Pitch>| {
        let field = option.given.as_ref()?;
        r.echo_given(field);
        field.value.map(|pitch| pitch.0)
    };
    let (from, to) = (end(&given.from), end(&given.to));
    let above = |field: &&Field<Pitch>| from.zip(to).is_some_and(|(from, to)| from >= to) && field.value.is_some();
    if let Some(field) = given.to.given.as_ref().filter(above) {
        let message = "the range of frequencies is empty";
        let allowed = "a frequency above `from`";
        r.refuse(Code::Contradiction, field, message, allowed);
    }
    Some(FrequencyOptions {
        from,
        to,
        points: r.count_or_default(&given.points) as usize,
        damping: r.choice(&given.damping),
    })
}
