//! Ids of methods that a file may name.

use codes::{ALL, site_action};
use results::EngineId;
use tank::value::Value;

use crate::input::diagnostic::Faults;
use crate::input::tank::choice::{one_of_words, quoted};
use crate::input::tank::read::FromNode;
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::Node;
use crate::input::tank::values::echoed;

/// Declares ids by the ids that are allowed, each with its meaning.
macro_rules! ids {
    ($($(#[doc = $doc:literal])+ $name:ident = $ids:expr;)+) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name(&'static str);

        impl FromNode for $name {
            fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
                let ids: Vec<_> = $ids.into_iter().map(|(id, _)| (id, $name(id))).collect();
                one_of_words(node, &ids, faults)
            }
            fn allowed() -> String {
                quoted(&$ids.into_iter().map(|(id, _)| id).collect::<Vec<_>>())
            }
            fn example() -> String {
                format!("\"{}\"", $ids[0].0)
            }
            fn shape(book: &mut Book) -> Shape {
                book.choice(stringify!($name), &[$($doc),+], $ids)
            }
            fn written(&self) -> Option<String> {
                Some(self.0.into())
            }
        }

        impl Value for $name {
            type Domain = &'static str;
            fn domain(self) -> &'static str {
                self.0
            }
        }

        echoed!($name);
    )+};
}

ids! {
    /// A code procedure.
    ProcedureId = procedures();
    /// A method that can decide.
    DecidingId = deciding();
    /// A code procedure with a design spectrum.
    SpectrumCode = with_spectrum();
}

fn procedures() -> Vec<(&'static str, String)> {
    ALL.iter().map(|p| (p.id(), format!("{}.", p.label().title))).collect()
}

/// Code procedures and columns of engines.
fn deciding() -> Vec<(&'static str, String)> {
    let engines = EngineId::ALL.map(|e| (e.beside(), format!("The {} engine, as a second run.", e.name())));
    let first = (results::FE, "The first engine that runs.".to_owned());
    procedures().into_iter().chain([first]).chain(engines).collect()
}

fn with_spectrum() -> Vec<(&'static str, String)> {
    let all = procedures();
    let title = |id: &&'static str| all.iter().find(|(known, _)| known == id).cloned();
    site_action::ids().iter().filter_map(title).collect()
}
