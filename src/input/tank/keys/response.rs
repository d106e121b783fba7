//! `analysis.spectrum`: options of the response-spectrum method.

use codes::modal_action;
use tank::options::linear::{ModalCombination, PartCombination, SpectrumOptions};

use crate::input::tank::key::{Absent, default};
use crate::input::tank::read::{Opt, choice, object};
use crate::input::tank::resolver::Resolver;

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
        code: Opt<SpectrumCode> = Absent::Follows("ec8-2006, api650-2020, housner: the first that site gives the data of"),
    }
}

choice! {
    /// How the largest responses of modes are combined.
    ModalCombination {
        /// Complete quadratic combination.
        Cqc = "cqc",
        /// Square root of the sum of squares.
        Srss = "srss",
        /// Sum of absolute values.
        Abs = "abs",
    }

    /// How the impulsive and the convective part are combined.
    PartCombination {
        /// All modes together, by `combination`.
        Modal = "modal",
        /// Square root of the sum of squares of the two parts.
        Srss = "srss",
        /// Sum of the two parts.
        Abs = "abs",
    }

    /// The procedure whose design spectrum the modes see.
    SpectrumCode {
        /// EN 1998: max(S_e/q, S_d) for structural modes, S_e for sloshing ones.
        Ec8 = "ec8-2006",
        /// Annex E of API 650: S_a I/R_wi for structural modes, K S_a I/R_wc for sloshing ones.
        Api650 = "api650-2020",
        /// The user's spectrum, elastic.
        Housner = "housner",
    }
}

/// The procedure whose design spectrum the modes see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SpectrumCode {
    Ec8,
    Api650,
    Housner,
}

impl SpectrumCode {
    fn id(self) -> &'static str {
        modal_action::ids()[self as usize]
    }
}

/// Options of the response-spectrum method.
pub(super) fn response(r: &mut Resolver<'_>, given: Option<&ResponseSpectrum>) -> SpectrumOptions {
    let Some(given) = given else {
        return DEFAULT;
    };
    let code = given.code.given.as_ref().and_then(|field| {
        r.echo_given(field);
        field.value
    });
    SpectrumOptions {
        combination: r.choice(&given.combination),
        parts: r.choice(&given.parts),
        missing_mass: r.choice(&given.missing_mass),
        reduced: r.choice(&given.reduced),
        code: code.map(|code| code.id().to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_have_the_ids_of_their_procedures() {
        let all = [SpectrumCode::Ec8, SpectrumCode::Api650, SpectrumCode::Housner];
        assert_eq!(all.map(SpectrumCode::id), ["ec8-2006", "api650-2020", "housner"]);
    }
}
