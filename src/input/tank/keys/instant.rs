//! Instants of `analysis.snapshots`: a time, or the peak of a history by name.

use files::code::Code;
use tank::options::linear::{Instant, Peak};
use tank::units::Dimension;

use crate::input::diagnostic::Faults;
use crate::input::tank::choice::{one_of_words, quoted};
use crate::input::tank::read::{Field, FromNode, Opt};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Time, pattern};

/// An instant as the file gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moment(Instant);

/// First word of the names of peaks.
const PEAK: &str = "peak";

fn names() -> [&'static str; 4] {
    Peak::ALL.map(Peak::name)
}

impl FromNode for Moment {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if matches!(&node.kind, Kind::Text(text) if text.trim_start().starts_with(PEAK)) {
            let peak = one_of_words(node, &Peak::ALL.map(|peak| (peak.name(), peak)), faults)?;
            return Some(Moment(Instant::Peak(peak)));
        }
        let Time(time) = Time::from_node(node, faults)?;
        Some(Moment(Instant::At(time)))
    }
    fn allowed() -> String {
        format!("{}, or {}", Time::allowed(), quoted(&names()))
    }
    fn example() -> String {
        format!("\"{}\"", Peak::Wave.name())
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Pattern {
            noun: format!("a time, or {}", quoted(&names())),
            patterns: vec![pattern(Dimension::Time), format!("^({})$", names().join("|"))],
            examples: &["12.5 s", "peak wave"],
        }
    }
}

/// Instants of snapshots.
pub(super) fn instants(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Moment>>>) -> Vec<Instant> {
    let Some((field, list)) = option.given.as_ref().and_then(|f| Some((f, f.value.as_ref()?))) else {
        return Vec::new();
    };
    r.at_most(field, "times");
    let mut found = Vec::new();
    for one in list {
        r.echo_given(one);
        let Some(Moment(instant)) = one.value else { continue };
        if let Instant::At(time) = instant
            && !field.limits.hold(time)
        {
            let allowed = field.limits.describe(Dimension::Time);
            r.refuse(Code::OutOfRange, one, field.limits.message(time), &allowed);
        }
        found.push(instant);
    }
    found
}
