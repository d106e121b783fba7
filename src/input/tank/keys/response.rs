//! `analysis.spectrum`: options of the response-spectrum method.

use tank::options::linear::{ModalCombination, PartCombination, SpectrumOptions};

use super::ids::SpectrumCode;
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Opt, object};
use crate::input::tank::resolver::Resolver;
use tank::keys::{Absent, default};

/// Defaults.
const DEFAULT: SpectrumOptions = SpectrumOptions::DEFAULT;

object! {
    /// Response-spectrum method: the modes of a linear engine under the design spectrum of `site`.
    ResponseSpectrum {
        /// How the largest responses of modes are combined.
        combination: Opt<ModalCombination> = default(DEFAULT.combination).because("EN 1998-1:2004 4.3.3.3.2: CQC where modes are close"),
        /// How the impulsive part (structural modes, and what follows the ground) and the sloshing modes are combined.
        parts: Opt<PartCombination> = default(DEFAULT.parts).because("their frequencies are far apart: CQC gives their SRSS"),
        /// Whether what is not in the modes follows the ground with the acceleration at T = 0.
        missing_mass: Opt<bool> = default(DEFAULT.missing_mass),
        /// Whether accelerations are divided by the behaviour factor or response modification of the code, as in its own procedure.
        reduced: Opt<bool> = default(DEFAULT.reduced),
        /// The procedure whose design spectrum it is.
        code: Opt<SpectrumCode> = Absent::Follows("the first of the three that site gives the data of"),
    }
}

choice!(ModalCombination, PartCombination);

/// Options of the response-spectrum method.
pub(super) fn response(r: &mut Resolver<'_>, given: Option<&ResponseSpectrum>) -> SpectrumOptions {
    let Some(given) = given else { return DEFAULT };
    let code = r.optional(&given.code);
    SpectrumOptions {
        combination: r.or_default(&given.combination),
        parts: r.or_default(&given.parts),
        missing_mass: r.or_default(&given.missing_mass),
        reduced: r.or_default(&given.reduced),
        code: code.map(str::to_owned),
    }
}
