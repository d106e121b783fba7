//! Values that somebody measured or published: their unit follows from the quantity they belong to.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use tank::Quantity;
use tank::units::Dimension;

use super::read::{Field, FromNode, list, nearest, wrong_kind};
use super::schema::Reported;
use super::syntax::{Kind, Node};
use super::values::{Pitch, quantity_schema};
use crate::input::diagnostic::{Fault, Faults};

/// A value as written, to be read when its quantity is known.
#[derive(Clone, Debug)]
pub(super) struct Raw(pub Node);

impl FromNode for Raw {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if let Kind::Text(_) | Kind::Number(_) = node.kind {
            return Some(Raw(node.clone()));
        }
        faults.push(wrong_kind(node, &Self::allowed()));
        None
    }
    fn allowed() -> String {
        "a value with its unit such as \"13.4 cm\"".into()
    }
    fn example() -> String {
        "\"13.4 cm\"".into()
    }
}

impl JsonSchema for Raw {
    fn schema_name() -> Cow<'static, str> {
        "Value".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "examples": ["13.4 cm", "1.9 MPa"] })
    }
}

/// Id of a comparable quantity.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuantityId(pub Quantity);

/// Ids of all comparable quantities.
fn quantity_ids() -> Vec<&'static str> {
    Quantity::ALL.into_iter().map(Quantity::id).collect()
}

impl FromNode for QuantityId {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let Kind::Text(text) = &node.kind else {
            faults.push(wrong_kind(node, &Self::allowed()));
            return None;
        };
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
}

fn unknown_quantity(text: &str, node: &Node) -> Fault {
    let fault = Fault::new(format!("unknown quantity `{text}`"))
        .at(node.span.clone())
        .path(node.path.clone())
        .found(text)
        .allowed(QuantityId::allowed());
    match nearest(text, quantity_ids()) {
        Some(near) => fault.help(format!("did you mean `{near}`?")),
        None => fault,
    }
}

impl JsonSchema for QuantityId {
    fn schema_name() -> Cow<'static, str> {
        "Quantity".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let all: Vec<Schema> = Quantity::ALL
            .into_iter()
            .map(|q| json_schema!({ "const": q.id(), "description": q.title() }))
            .collect();
        json_schema!({ "oneOf": all })
    }
}

/// Measured values by quantity, in the order of the file.
#[derive(Clone, Debug)]
pub(super) struct Measured(pub Vec<(Quantity, Field<Reported>)>);

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
}

impl JsonSchema for Measured {
    fn schema_name() -> Cow<'static, str> {
        "Measured".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut properties = serde_json::Map::new();
        for quantity in Quantity::ALL {
            let mut schema = generator.subschema_for::<Reported>();
            schema.insert("description".into(), quantity.title().into());
            let value = match quantity.dimension() {
                Dimension::Time => generator.subschema_for::<Pitch>(),
                dimension => quantity_schema(dimension),
            };
            schema.insert("properties".into(), serde_json::json!({ "value": value }));
            properties.insert(quantity.id().into(), schema.into());
        }
        json_schema!({ "type": "object", "properties": properties, "additionalProperties": false })
    }
}
