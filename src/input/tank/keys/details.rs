//! Answers about the construction: what the codes ask for and no other key describes.

use files::code::Code;
use tank::units::Dimension;
use tank::value::Value;
use tank::{BottomConnections, Joint, Presence, ShellSupport};

use crate::input::diagnostic::Faults;
use crate::input::tank::choice::choice;
use crate::input::tank::read::{FromNode, wrong_value};
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Length, echoed};
use tank::keys::Limits;

choice!(Presence, ShellSupport, Joint);

/// Distances from the shell.
const DISTANCE: Limits = Limits::from(0.0).to(1000.0);

/// Connections through the bottom, as written: `"none"`, or a distance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Connections(BottomConnections);

impl Value for Connections {
    type Domain = BottomConnections;
    fn domain(self) -> BottomConnections {
        self.0
    }
}

echoed!(Connections);

impl FromNode for Connections {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if matches!(&node.kind, Kind::Text(text) if text == "none") {
            return Some(Connections(BottomConnections::None));
        }
        let Length(distance) = Length::from_node(node, faults)?;
        if !DISTANCE.hold(distance) {
            let message = DISTANCE.message(distance);
            faults.push(wrong_value(Code::OutOfRange, node, message, &Self::allowed()));
            return None;
        }
        Some(Connections(BottomConnections::Within(distance)))
    }
    fn allowed() -> String {
        format!("\"none\", or {}", DISTANCE.describe(Dimension::Length))
    }
    fn example() -> String {
        "\"1.5 m\"".into()
    }
    fn shape(book: &mut Book) -> Shape {
        Shape::Either("none", Box::new(Length::shape(book)))
    }
}
