//! `measured`, `published`: measured and published values; their unit follows from the quantity.

use files::code::Code;
use tank::Quantity;
use tank::case::{self, NamedMotion};
use tank::units::Dimension;

use crate::input::diagnostic::{Fault, Faults};
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, FromNode, Opt, nearest, object, other_kind, text_of, wrong_kind};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::shape::{Book, Shape};
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Pitch, quantity};
use tank::keys::list;

object! {
    /// A measured value.
    Reported {
        /// The value with its unit; a period may also be given as a frequency ("3.02 rad/s", "1.916 Hz").
        value: Field<Raw>,
        /// Author and publication.
        source ("Manos and Clough 1982"): Field<String>,
        /// Remark.
        note ("peak at the wall"): Opt<String>,
        /// Ground motion under which it was measured. Without it, or under another record, the value is listed apart and not
        /// compared; periods and masses belong to no ground motion and need none.
        motion: Opt<Given<NamedMotion>>,
    }

    /// A published value.
    Published {
        /// Quantity.
        quantity: Field<QuantityId>,
        /// The value with its unit.
        value ("0.42 m"): Field<Raw>,
        /// Author and publication.
        source ("Manos and Clough 1982"): Field<String>,
        /// Remark.
        note ("belongs to the record as recorded"): Opt<String>,
        /// Ground motion to which it belongs. There is a ratio to it under this motion only, and of periods and masses.
        motion: Opt<Given<NamedMotion>>,
    }
}

/// A value as written; it is read when its quantity is known.
#[derive(Debug)]
pub(crate) struct Raw(pub Node);

impl FromNode for Raw {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if let Kind::Text(_) | Kind::Number(_) = node.kind {
            return Some(Raw(node.clone()));
        }
        other_kind(node, faults)
    }
    fn allowed() -> String {
        "a value with its unit such as \"13.4 cm\"".into()
    }
    fn example() -> String {
        "\"13.4 cm\"".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Pattern { noun: "a value with its unit".into(), patterns: Vec::new(), examples: &[] }
    }
}

/// Id of a comparable quantity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuantityId(pub Quantity);

/// Ids of all comparable quantities.
fn quantity_ids() -> Vec<&'static str> {
    Quantity::ALL.into_iter().map(Quantity::id).collect()
}

impl FromNode for QuantityId {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let text = text_of::<Self>(node, faults)?;
        let quantity = Quantity::from_id(text);
        if quantity.is_none() {
            faults.push(unknown_quantity(text, node));
        }
        quantity.map(QuantityId)
    }
    fn allowed() -> String {
        list(&quantity_ids(), "or")
    }
    fn example() -> String {
        "\"sloshing_height\"".into()
    }
    fn shape(book: &mut Book) -> Shape {
        let words = Quantity::ALL.into_iter().map(|q| (q.id(), q.title().to_owned())).collect();
        book.choice("Quantity", &["A comparable quantity."], words)
    }
}

fn unknown_quantity(text: &str, node: &Node) -> Fault {
    let fault = Fault::new(Code::UnknownChoice, format!("unknown quantity `{text}`"))
        .at(node.span.clone())
        .path(node.path.clone())
        .found(text)
        .allowed(QuantityId::allowed());
    match nearest(text, quantity_ids()) {
        Some(near) => fault.help(format!("did you mean `{near}`?")),
        None => fault,
    }
}

/// Measured values by quantity, in the order of the file.
#[derive(Debug)]
pub(crate) struct Measured(pub Vec<(Quantity, Field<Reported>)>);

impl FromNode for Measured {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let Kind::Object(members) = &node.kind else {
            faults.push(wrong_kind(node, &Self::allowed()));
            return None;
        };
        let mut values = Vec::new();
        for member in members {
            let reported = Field::from_node(&member.value, faults);
            match Quantity::from_id(&member.key) {
                Some(quantity) => values.push((quantity, reported)),
                None => faults.push(Fault {
                    span: Some(member.key_span.clone()),
                    ..unknown_quantity(&member.key, &member.value)
                }),
            }
        }
        Some(Measured(values))
    }
    fn allowed() -> String {
        "an object { \"sloshing_height\": { \"value\": …, \"source\": … } }".into()
    }
    fn example() -> String {
        "{ … }".into()
    }
    fn shape(book: &mut Book) -> Shape {
        Reported::shape(book);
        Shape::Measured("Reported")
    }
}

/// A value of this quantity, positive.
fn value(r: &mut Resolver<'_>, field: &Field<Raw>, what: Quantity) -> f64 {
    let value = field.value.as_ref().and_then(|raw| match what.dimension() {
        // A period is often published as a frequency.
        Dimension::Time => Pitch::from_node(&raw.0, r.faults).map(|p| 2.0 * std::f64::consts::PI / p.0),
        dimension => quantity(&raw.0, dimension, r.faults),
    });
    r.echo_given(field);
    match value {
        Some(value) if (0.0..=1e18).contains(&value) => value,
        Some(_) => {
            let message = "out of range";
            let allowed = "values are absolute maxima, 0 or greater";
            r.refuse(Code::OutOfRange, field, message, allowed);
            f64::NAN
        }
        None => f64::NAN,
    }
}

/// The ground motion that a value names.
fn motion(r: &mut Resolver<'_>, option: &Opt<Given<NamedMotion>>) -> Option<NamedMotion> {
    let field = option.given.as_ref()?;
    let given = field.value.as_ref()?;
    let mut named = given.resolve(r)?;
    if let (Some(field), Some(text)) = (&given.sha256.given, &named.sha256) {
        let hash = text.len() == 64 && text.bytes().all(|b| b.is_ascii_hexdigit());
        if !hash {
            let message = "not a SHA-256";
            let allowed = "64 hexadecimal digits, as sha256sum prints them";
            r.refuse(Code::BadForm, field, message, allowed);
        }
        named.sha256 = hash.then(|| text.to_lowercase());
    }
    if given.sha256.given.is_none() && (given.peak.given.is_none() || given.step.given.is_none()) {
        let message = "the ground motion is not named";
        let allowed = "`sha256` of the record file, or `peak` and `step` of the record";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
    Some(named)
}

/// Measured values.
pub(super) fn measured(r: &mut Resolver<'_>, option: &Opt<Measured>) -> Vec<case::Reported> {
    let mut all = Vec::new();
    for (quantity, field) in option.value().iter().flat_map(|m| &m.0) {
        let Some(given) = &field.value else { continue };
        all.push(case::Reported {
            quantity: *quantity,
            value: value(r, &given.value, *quantity),
            source: r.text(&given.source).unwrap_or_default(),
            note: given.note.given.as_ref().and_then(|n| r.text(n)),
            motion: motion(r, &given.motion),
        });
    }
    all
}

/// Published values.
pub(super) fn published(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Published>>>) -> Vec<case::Reported> {
    let mut all = Vec::new();
    for given in option.value().into_iter().flatten().filter_map(|p| p.value.as_ref()) {
        r.echo_given(&given.quantity);
        let Some(quantity) = given.quantity.value else { continue };
        all.push(case::Reported {
            quantity: quantity.0,
            value: value(r, &given.value, quantity.0),
            source: r.text(&given.source).unwrap_or_default(),
            note: given.note.given.as_ref().and_then(|n| r.text(n)),
            motion: motion(r, &given.motion),
        });
    }
    all
}
