//! `analysis.spectrum`: options of the response-spectrum method.

use codes::{ALL, site_action};
use tank::options::linear::{ModalCombination, PartCombination, SpectrumOptions};

use crate::input::diagnostic::Faults;
use crate::input::tank::key::{Absent, default};
use crate::input::tank::read::{FromNode, Opt, choice, object, one_of_words, quoted};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::Node;

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

/// The procedure whose design spectrum the modes see.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpectrumCode(&'static str);

/// Ids of the procedures that have one.
fn codes() -> Vec<(&'static str, SpectrumCode)> {
    site_action::ids().iter().map(|id| (*id, SpectrumCode(id))).collect()
}

impl FromNode for SpectrumCode {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        one_of_words(node, &codes(), faults)
    }
    fn allowed() -> String {
        quoted(site_action::ids())
    }
    fn example() -> String {
        format!("\"{}\"", site_action::ids()[0])
    }
    fn shape(book: &mut Book) -> Shape {
        let title = |id: &str| ALL.iter().find(|p| p.id() == id).map_or("", |p| p.label().title);
        let words = site_action::ids()
            .iter()
            .map(|id| (*id, format!("{}.", title(id))))
            .collect();
        book.choice("SpectrumCode", &["A code procedure with a design spectrum."], words)
    }
    fn written(&self) -> Option<String> {
        Some(self.0.into())
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
        code: code.map(|code| code.0.to_owned()),
    }
}
