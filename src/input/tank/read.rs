//! Tree of values → typed mirror of the file, every fault noted and none fatal.
//!
//! A mirror struct is declared once with [`object!`]; from that one declaration follow its reader (known keys, required
//! keys, suggestions for misspelt ones) and its JSON Schema (the doc comments become the descriptions).

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::syntax::{Kind, Member, Node, join};
use crate::input::diagnostic::{Fault, Faults};

/// Faults beyond this number come without a suggestion: they are not shown, and to look for one takes time.
const SUGGESTED_FOR: usize = 1000;

/// Something of the file with its place: `value` is `None` if it is missing or faulty, which has been noted already.
#[derive(Clone, Debug)]
pub(super) struct Field<T> {
    pub value: Option<T>,
    pub span: Range<usize>,
    pub path: String,
    /// As written, without quotes; empty for lists and objects.
    pub text: String,
}

/// What can be read from a value of the file.
pub(super) trait FromNode: Sized {
    /// Reads it; notes what is wrong and returns `None` if there is nothing to go on with.
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self>;
    /// What is allowed, for messages.
    fn allowed() -> String;
    /// How it is written, for messages ("\"1.83 m\"").
    fn example() -> String;
}

impl<T: FromNode> Field<T> {
    pub fn from_node(node: &Node, faults: &mut Faults) -> Field<T> {
        Field {
            value: T::from_node(node, faults),
            span: node.span.clone(),
            path: node.path.clone(),
            text: match &node.kind {
                Kind::Text(text) => text.clone(),
                Kind::Bool(_) | Kind::Number(_) => node.shown(),
                Kind::Null | Kind::List(_) | Kind::Object(_) => String::new(),
            },
        }
    }
}

impl<T> Field<T> {
    /// The place alone.
    pub fn place(&self) -> Field<()> {
        Field {
            value: None,
            span: self.span.clone(),
            path: self.path.clone(),
            text: self.text.clone(),
        }
    }
}

/// A member of an object: required as [`Field`], optional as `Option<Field>`.
pub(super) trait Property: Sized {
    type Inner: FromNode + JsonSchema;
    const REQUIRED: bool;
    fn read(object: &mut ObjectReader<'_>, key: &'static str, faults: &mut Faults) -> Self;
}

impl<T: FromNode + JsonSchema> Property for Field<T> {
    type Inner = T;
    const REQUIRED: bool = true;
    fn read(object: &mut ObjectReader<'_>, key: &'static str, faults: &mut Faults) -> Self {
        if let Some(member) = object.take(key) {
            return Field::from_node(&member.value, faults);
        }
        // A misspelt key has been noted already, with this one as the suggestion.
        if !object.meant.contains(key) {
            faults.push(
                Fault::new(format!("the key `{key}` is missing"))
                    .at(object.head.clone())
                    .path(join(&object.node.path, key))
                    .allowed(T::allowed())
                    .help(format!("add \"{key}\": {}", T::example())),
            );
        }
        Field {
            value: None,
            span: object.head.clone(),
            path: join(&object.node.path, key),
            text: String::new(),
        }
    }
}

impl<T: FromNode + JsonSchema> Property for Option<Field<T>> {
    type Inner = T;
    const REQUIRED: bool = false;
    fn read(object: &mut ObjectReader<'_>, key: &'static str, faults: &mut Faults) -> Self {
        object.take(key).map(|member| Field::from_node(&member.value, faults))
    }
}

/// Hands out the members of an object; unknown keys are noted when it is made.
pub(super) struct ObjectReader<'a> {
    node: &'a Node,
    members: &'a [Member],
    /// Known keys that misspelt ones probably mean.
    meant: BTreeSet<&'static str>,
    /// Place to underline for what is missing: the opening brace.
    head: Range<usize>,
}

impl<'a> ObjectReader<'a> {
    pub fn new(node: &'a Node, known: &[&'static str], faults: &mut Faults) -> Option<Self> {
        let Kind::Object(members) = &node.kind else {
            faults.push(wrong_kind(node, &format!("an object with {}", list(known, "and"))));
            return None;
        };
        let mut meant = BTreeSet::new();
        let present: BTreeSet<&str> = members.iter().map(|m| m.key.as_str()).collect();
        let free: Vec<&'static str> = known.iter().copied().filter(|k| !present.contains(k)).collect();
        for member in members.iter().filter(|m| !known.contains(&m.key.as_str())) {
            let near = match faults.count() < SUGGESTED_FOR {
                true => nearest(&member.key, free.iter().copied()),
                false => None,
            };
            let mut fault = Fault::new(format!("unknown key `{}`", member.key))
                .at(member.key_span.clone())
                .path(member.value.path.clone())
                .allowed(list(known, "or"));
            if let Some(near) = near {
                meant.insert(near);
                fault = fault.help(format!("did you mean `{near}`?"));
            }
            faults.push(fault);
        }
        let head = node.span.start..node.span.end.min(node.span.start + 1);
        Some(ObjectReader {
            node,
            members,
            meant,
            head,
        })
    }

    fn take(&self, key: &str) -> Option<&'a Member> {
        self.members.iter().find(|m| m.key == key)
    }

    pub fn property<P: Property>(&mut self, key: &'static str, faults: &mut Faults) -> P {
        P::read(self, key, faults)
    }
}

/// The known word nearest to a misspelt one, if any is near enough to be meant.
pub(super) fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    let folded = word.to_lowercase().replace(['-', ' '], "_");
    let length = folded.chars().count();
    known
        .into_iter()
        // The distance is at least the difference of the lengths: long texts are not compared at all.
        .filter(|k| {
            let other = k.chars().count();
            length.abs_diff(other) * 3 <= length.max(other)
        })
        .map(|k| {
            (
                strsim::damerau_levenshtein(&folded, &k.to_lowercase().replace('-', "_")),
                k,
            )
        })
        .filter(|(distance, k)| distance * 3 <= length.max(k.chars().count()))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, k)| k)
}

/// `a, b or c`.
pub(super) fn list(words: &[&str], conjunction: &str) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).into(),
        [all @ .., last] => format!("{} {conjunction} {last}", all.join(", ")),
    }
}

pub(super) fn wrong_kind(node: &Node, allowed: &str) -> Fault {
    Fault::new(format!("{} does not belong here", node.noun()))
        .at(node.span.clone())
        .path(node.path.clone())
        .found(node.shown())
        .allowed(allowed)
}

/// A fault about a value of the right place but the wrong content.
pub(super) fn wrong_value(node: &Node, message: &str, allowed: &str) -> Fault {
    Fault::new(message)
        .at(node.span.clone())
        .path(node.path.clone())
        .found(node.shown())
        .allowed(allowed)
}

impl<T: JsonSchema> JsonSchema for Field<T> {
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn schema_id() -> Cow<'static, str> {
        T::schema_id()
    }
    fn inline_schema() -> bool {
        T::inline_schema()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        T::json_schema(generator)
    }
}

/// Declares a closed choice of words.
macro_rules! choice {
    ($($(#[doc = $doc:literal])+ $name:ident { $($(#[doc = $vdoc:literal])+ $variant:ident = $word:literal,)+ })*) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(in crate::input::tank) enum $name {
            $($(#[doc = $vdoc])+ $variant,)+
        }

        impl $name {
            const WORDS: &'static [&'static str] = &[$($word),+];
        }

        impl FromNode for $name {
            fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
                match &node.kind {
                    Kind::Text(text) => match text.as_str() {
                        $($word => Some($name::$variant),)+
                        other => {
                            let mut fault = wrong_value(node, &format!("unknown choice `{other}`"), &Self::allowed());
                            if let Some(near) = nearest(other, Self::WORDS.iter().copied()) {
                                fault = fault.help(format!("did you mean \"{near}\"?"));
                            }
                            faults.push(fault);
                            None
                        }
                    },
                    _ => {
                        faults.push(wrong_kind(node, &Self::allowed()));
                        None
                    }
                }
            }
            fn allowed() -> String {
                let quoted: Vec<String> = Self::WORDS.iter().map(|w| format!("\"{w}\"")).collect();
                list(&quoted.iter().map(String::as_str).collect::<Vec<_>>(), "or")
            }
            fn example() -> String {
                format!("\"{}\"", Self::WORDS[0])
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "oneOf": [$({ "const": $word, "description": prose(&[$($vdoc),+]) }),+] })
            }
        }
    )*};
}

/// Declares a mirror struct, its reader and its schema.
macro_rules! object {
    ($(
        $(#[doc = $doc:literal])+
        $name:ident { $($(#[doc = $fdoc:literal])+ $field:ident : $ty:ty,)+ }
    )*) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Debug)]
        pub(in crate::input::tank) struct $name { $($(#[doc = $fdoc])+ pub $field: $ty,)+ }

        impl FromNode for $name {
            fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
                let mut reader = ObjectReader::new(node, &[$(stringify!($field)),+], faults)?;
                Some($name { $($field: reader.property(stringify!($field), faults),)+ })
            }
            fn allowed() -> String {
                format!("an object with {}", list(&[$(stringify!($field)),+], "and"))
            }
            fn example() -> String {
                "{ … }".into()
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                let mut schema = ObjectSchema::new(&[$($doc),+]);
                $(schema.property::<$ty>(stringify!($field), &[$($fdoc),+], generator);)+
                schema.finish()
            }
        }
    )*};
}

pub(super) use {choice, object};

/// Doc comment lines as one text: lines joined, paragraphs kept.
pub(super) fn prose(lines: &[&str]) -> String {
    let paragraphs: Vec<String> = lines
        .split(|l| l.trim().is_empty())
        .map(|p| p.iter().map(|l| l.trim()).collect::<Vec<_>>().join(" "))
        .filter(|p| !p.is_empty())
        .collect();
    paragraphs.join("\n\n")
}

/// Puts the schema of an object together.
pub(super) struct ObjectSchema {
    description: String,
    properties: serde_json::Map<String, serde_json::Value>,
    required: Vec<&'static str>,
}

impl ObjectSchema {
    pub fn new(doc: &[&str]) -> Self {
        ObjectSchema {
            description: prose(doc),
            properties: serde_json::Map::new(),
            required: Vec::new(),
        }
    }

    pub fn property<P: Property>(&mut self, key: &'static str, doc: &[&str], generator: &mut SchemaGenerator) {
        let mut schema = generator.subschema_for::<P::Inner>();
        schema.insert("description".into(), prose(doc).into());
        self.properties.insert(key.into(), schema.into());
        if P::REQUIRED {
            self.required.push(key);
        }
    }

    pub fn finish(self) -> Schema {
        json_schema!({
            "description": self.description,
            "type": "object",
            "properties": self.properties,
            "required": self.required,
            "additionalProperties": false,
        })
    }
}
