//! What stands in the fields of the nonlinear engine: the behaviour of a material, rules of quadrature.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::read::{FromNode, wrong_kind, wrong_value};
use super::schema::BehaviourKinds;
use super::syntax::{Kind, Node};
use crate::input::diagnostic::Faults;
use tank::options::nonlinear::ThicknessRule;

/// The word `"elastic"`, or an object with the parameters of another behaviour.
#[derive(Clone, Debug)]
pub(super) enum Behaviour {
    Elastic,
    Kinds(Box<BehaviourKinds>),
}

impl FromNode for Behaviour {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Text(text) if text == "elastic" => Some(Behaviour::Elastic),
            Kind::Object(_) => BehaviourKinds::from_node(node, faults).map(|kinds| Behaviour::Kinds(Box::new(kinds))),
            Kind::Text(text) => {
                let mut fault = wrong_value(node, &format!("unknown behaviour `{text}`"), &Self::allowed());
                if ["steel", "concrete", "reinforcement", "interlayer"].contains(&text.as_str()) {
                    fault = fault.help(format!("write {{ \"{text}\": {{ … }} }}"));
                }
                faults.push(fault);
                None
            }
            _ => {
                faults.push(wrong_kind(node, &Self::allowed()));
                None
            }
        }
    }
    fn allowed() -> String {
        "\"elastic\", or an object with steel, concrete, reinforcement or interlayer".into()
    }
    fn example() -> String {
        "{ \"steel\": { … } }".into()
    }
}

impl JsonSchema for Behaviour {
    fn schema_name() -> Cow<'static, str> {
        "Behaviour".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "const": "elastic" }, generator.subschema_for::<BehaviourKinds>()] })
    }
}

/// Quadrature through the thickness: a rule and its number of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rule(pub ThicknessRule);

/// Name of a rule, the rule, and the fewest and the most points it has.
type Known = (&'static str, fn(u32) -> ThicknessRule, u32, u32);

/// The rules.
const RULES: [Known; 5] = [
    ("gauss", ThicknessRule::Gauss, 2, 64),
    ("lobatto", ThicknessRule::Lobatto, 3, 64),
    ("midpoint", ThicknessRule::MidPoint, 2, 200),
    ("simpson", ThicknessRule::Simpson, 3, 199),
    ("trapezoid", ThicknessRule::Trapezoid, 2, 200),
];

impl FromNode for Rule {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let Kind::Text(text) = &node.kind else {
            faults.push(wrong_kind(node, &Self::allowed()));
            return None;
        };
        let mut words = text.split_whitespace();
        let name = words.next().unwrap_or_default().to_lowercase();
        let count: Option<u32> = words.next().and_then(|n| n.parse().ok());
        let message = match (RULES.iter().find(|(rule, ..)| *rule == name), count, words.next()) {
            (Some((_, rule, least, most)), Some(n), None) if (*least..=*most).contains(&n) => match rule(n) {
                ThicknessRule::Simpson(n) if n % 2 == 0 => "Simpson's rule needs an odd number of points",
                rule => return Some(Rule(rule)),
            },
            (Some(_), Some(_), None) => "too few or too many points",
            _ => "not a rule with its number of points",
        };
        faults.push(wrong_value(node, message, &Self::allowed()));
        None
    }
    fn allowed() -> String {
        "a rule with its number of points such as \"gauss 5\" (2 to 64), \"lobatto 7\" (3 to 64), \"midpoint 20\" (2 to 200), \
         \"simpson 9\" (3 to 199, odd) or \"trapezoid 9\" (2 to 200)"
            .into()
    }
    fn example() -> String {
        "\"gauss 5\"".into()
    }
}

impl JsonSchema for Rule {
    fn schema_name() -> Cow<'static, str> {
        "ThicknessRule".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "pattern": "^(gauss|lobatto|midpoint|simpson|trapezoid) +[1-9][0-9]{0,2}$",
                       "examples": ["gauss 5", "midpoint 20"] })
    }
}
