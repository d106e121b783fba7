//! Tree of values → typed mirror of the file. All faults are collected; none stops the reader.
//!
//! An object of the file is declared once with [`object!`], a choice of words with [`tank::words!`]; from these follow the
//! reader (known keys, required keys, suggestions for misspelt ones), the limits and defaults for the resolver, and the book
//! from which JSON Schema and reference page are written.
//!
//! ```text
//! object! {
//!     /// Meaning of the object.
//!     Name {
//!         /// Meaning of the key.
//!         key (example): type [limits] = default,
//!     }
//! }
//! ```
//!
//! Example, limits and default are optional. The type is `Field<T>` for a required key, `Opt<T>` for an optional one.

use files::code::Code;
use std::collections::BTreeSet;
use std::ops::{Deref, Range};

use super::hints;
use super::shape::{Book, KeyInfo, Shape};
use super::syntax::{Kind, Member, Node, join};
use crate::input::diagnostic::{Fault, Faults};
use tank::keys::{Key, Limits, list};

/// Faults beyond this number get no suggestion: they are not shown, and the search takes time.
const SUGGESTED_FOR: usize = 1000;

/// A value of the file with its place; `value` is `None` if it is missing or faulty (already reported).
#[derive(Clone, Debug)]
pub(in crate::input) struct Field<T> {
    pub value: Option<T>,
    pub span: Range<usize>,
    pub path: String,
    /// As written, without quotes; empty for lists and objects.
    pub text: String,
    /// Limits of its key; for a list, those of the items.
    pub limits: Limits,
    /// Example of its key, without quotes; may be empty.
    pub example: &'static str,
}

/// An optional key of an object, whose default is a `K`.
#[derive(Debug)]
pub(in crate::input) struct Opt<T: 'static, K: 'static = T> {
    pub key: &'static Key<K>,
    pub path: String,
    /// The value in the file.
    pub given: Option<Field<T>>,
}

/// A type that can be read from a value of the file.
pub(in crate::input) trait FromNode: Sized + 'static {
    /// Reads it; reports its faults and returns `None` if no value can be used.
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self>;
    /// The expected value, for messages.
    fn allowed() -> String;
    /// An example as written in the file, for messages ("\"1.83 m\"").
    fn example() -> String;
    /// Its form, for the schema.
    fn shape(book: &mut Book) -> Shape;
    /// As a user writes it, without quotes; `None` for lists and objects.
    fn written(&self) -> Option<String> {
        None
    }
}

/// An object of the file.
pub(in crate::input) trait Object: FromNode {
    /// The object with all defaults, for a file without it; missing required keys are not reported.
    fn absent(path: &str) -> Self;
}

impl<T: FromNode> Field<T> {
    pub(crate) fn from_node(node: &Node, faults: &mut Faults) -> Field<T> {
        Field {
            value: T::from_node(node, faults),
            span: node.span.clone(),
            path: node.path.clone(),
            text: match &node.kind {
                Kind::Text(text) => text.clone(),
                Kind::Bool(_) | Kind::Number(_) => node.shown(),
                Kind::Null | Kind::List(_) | Kind::Object(_) => String::new(),
            },
            limits: Limits::ANY,
            example: "",
        }
    }
}

impl<T> Field<T> {
    /// A key that is missing at this place.
    pub(crate) fn missing(span: Range<usize>, path: String) -> Field<T> {
        Field { value: None, span, path, text: String::new(), limits: Limits::ANY, example: "" }
    }

    /// The place alone.
    pub(crate) fn place(&self) -> Field<()> {
        Field {
            value: None,
            span: self.span.clone(),
            path: self.path.clone(),
            text: self.text.clone(),
            limits: self.limits,
            example: self.example,
        }
    }
}

impl<T, K> Opt<T, K> {
    /// The value in the file, if it is valid.
    pub(crate) fn value(&self) -> Option<&T> {
        self.given.as_ref().and_then(|field| field.value.as_ref())
    }

    /// The place of the value in the file.
    pub(crate) fn place(&self) -> Option<Field<()>> {
        self.given.as_ref().map(Field::place)
    }
}

impl<T: Object, K> Opt<T, K> {
    /// The object in the file, or one without keys; `None` if it is faulty.
    pub(crate) fn or_absent(&self) -> Option<Part<'_, T>> {
        match &self.given {
            Some(field) => field.value.as_ref().map(Part::Given),
            None => Some(Part::Absent(Box::new(T::absent(&self.path)))),
        }
    }
}

/// An object in the file, or one without keys.
pub(in crate::input) enum Part<'a, T> {
    Given(&'a T),
    Absent(Box<T>),
}

impl<T> Deref for Part<'_, T> {
    type Target = T;
    fn deref(&self) -> &T {
        match self {
            Part::Given(object) => object,
            Part::Absent(object) => object,
        }
    }
}

/// A member of an object: required as [`Field`], optional as [`Opt`].
pub(in crate::input) trait Property: Sized {
    type Inner: FromNode;
    /// Type of its default.
    type Default: 'static;
    const REQUIRED: bool;
    /// Reads it; reports a missing required one.
    fn read(object: &ObjectReader<'_>, key: &'static Key<Self::Default>, faults: &mut Faults) -> Self;
    /// Its value if the whole object at `path` is missing.
    fn absent(path: &str, key: &'static Key<Self::Default>) -> Self;
    /// A default as a user writes it, without quotes.
    fn written(default: &Self::Default) -> Option<String>;
    /// Its entry in the schema.
    fn info(key: &'static Key<Self::Default>, book: &mut Book) -> KeyInfo {
        let shape = Self::Inner::shape(book);
        // The example of a type is written as in the file.
        let example = match shape {
            Shape::List(_) | Shape::Named(_) | Shape::Object(_) | Shape::Measured(_) => String::new(),
            // Its dimension depends on another key.
            Shape::Pattern { ref patterns, .. } if patterns.is_empty() => String::new(),
            Shape::Either(word, _) => word.to_owned(),
            _ => Self::Inner::example().trim_matches('"').to_owned(),
        };
        KeyInfo::new(key, Self::REQUIRED, shape, example, Self::written)
    }
}

/// The unit of an example such as `8 mm`.
pub(in crate::input) fn unit_of(example: &str) -> Option<&str> {
    example.split_once(' ').map(|(_, unit)| unit).filter(|unit| !unit.is_empty())
}

fn read_member<T: FromNode, K>(member: &Member, key: &Key<K>, faults: &mut Faults) -> Field<T> {
    let node = &member.value;
    let before = faults.count();
    let field = Field::from_node(node, faults);
    // The unit of the key's own example is likelier than that of its dimension: mm for a plate, m for a tank.
    if let Kind::Text(number) | Kind::Number(number) = &node.kind
        && faults.count() > before
    {
        let number = number.trim();
        let written = |unit: &str| {
            format!("write the unit in which {number} is meant, for example \"{number} {unit}\" if it is {unit}")
        };
        let help = hints::specific_gravity(number, &node.path).or_else(|| unit_of(key.example).map(written));
        if let Some(help) = help {
            faults.help_last(Code::UnitMissing, &node.path, &help);
        }
    }
    Field { limits: key.limits, example: key.example, ..field }
}

impl<T: FromNode> Property for Field<T> {
    type Inner = T;
    type Default = T;
    const REQUIRED: bool = true;
    fn read(object: &ObjectReader<'_>, key: &'static Key<T>, faults: &mut Faults) -> Self {
        let name = key.name;
        if let Some(member) = object.take(name) {
            return read_member(member, key, faults);
        }
        // A misspelt key was already reported with this one as the suggestion.
        if !object.meant.contains(name) {
            let help = match hints::missing(&object.node.path, name, |key| object.text(key)) {
                Some(help) => help.to_owned(),
                None => format!("add \"{name}\": {}", T::example()),
            };
            faults.push(
                Fault::new(Code::MissingKey, format!("the key `{name}` is missing"))
                    .at(object.head.clone())
                    .path(join(&object.node.path, name))
                    .allowed(T::allowed())
                    .help(help),
            );
        }
        Field::missing(object.head.clone(), join(&object.node.path, name))
    }
    fn absent(path: &str, key: &'static Key<T>) -> Self {
        Field::missing(0..0, join(path, key.name))
    }
    fn written(default: &T) -> Option<String> {
        default.written()
    }
}

impl<T: FromNode, K> Opt<T, K> {
    fn of(object: &ObjectReader<'_>, key: &'static Key<K>, faults: &mut Faults) -> Self {
        Opt {
            given: object.take(key.name).map(|member| read_member(member, key, faults)),
            ..Opt::none(&object.node.path, key)
        }
    }

    fn none(path: &str, key: &'static Key<K>) -> Self {
        Opt { key, path: join(path, key.name), given: None }
    }
}

/// Keys that may be absent, by the type of their default.
macro_rules! optional {
    ($($default:ty, $value:ident => $written:expr;)+) => {$(
        impl<T: FromNode> Property for Opt<T, $default> {
            type Inner = T;
            type Default = $default;
            const REQUIRED: bool = false;
            fn read(object: &ObjectReader<'_>, key: &'static Key<$default>, faults: &mut Faults) -> Self {
                Opt::of(object, key, faults)
            }
            fn absent(path: &str, key: &'static Key<$default>) -> Self {
                Opt::none(path, key)
            }
            fn written($value: &$default) -> Option<String> {
                $written
            }
        }
    )+};
}

optional! {
    T, value => value.written();
    (), _value => None;
}

/// Hands out the members of an object; unknown keys are noted when it is made.
pub(in crate::input) struct ObjectReader<'a> {
    node: &'a Node,
    members: &'a [Member],
    /// Known keys suggested for misspelt ones.
    meant: BTreeSet<&'static str>,
    /// Place to underline for a missing key: the opening brace.
    head: Range<usize>,
}

impl<'a> ObjectReader<'a> {
    pub(crate) fn new(node: &'a Node, known: &[&'static str], faults: &mut Faults) -> Option<Self> {
        let Kind::Object(members) = &node.kind else {
            faults.push(wrong_kind(node, &format!("an object with {}", list(known, "and"))));
            return None;
        };
        let mut meant = BTreeSet::new();
        let present: BTreeSet<&str> = members.iter().map(|m| m.key.as_str()).collect();
        let free: Vec<&'static str> = known.iter().copied().filter(|k| !present.contains(k)).collect();
        for member in members.iter().filter(|m| !known.contains(&m.key.as_str())) {
            let near = if faults.count() < SUGGESTED_FOR { nearest(&member.key, free.iter().copied()) } else { None };
            let mut fault = Fault::new(Code::UnknownKey, format!("unknown key `{}`", member.key))
                .at(member.key_span.clone())
                .path(member.value.path.clone())
                .allowed(list(known, "or"));
            if let Some(hint) = hints::looked_for(&member.key, &node.path) {
                if let Some(key) = free.iter().copied().find(|key| *key == hint.meant) {
                    meant.insert(key);
                    faults.asks_for(key);
                }
                fault = fault.help(hint.help);
            } else if let Some(near) = near {
                meant.insert(near);
                fault = fault.help(format!("did you mean `{near}`?"));
            }
            faults.push(fault);
        }
        let head = node.span.start..node.span.end.min(node.span.start + 1);
        Some(ObjectReader { node, members, meant, head })
    }

    /// Where the object stands.
    pub(super) fn path(&self) -> &str {
        &self.node.path
    }

    /// The member of a key.
    pub(super) fn take(&self, key: &str) -> Option<&'a Member> {
        self.members.iter().find(|m| m.key == key)
    }

    /// The text of a key; empty if it is missing or not a text.
    fn text(&self, key: &str) -> &'a str {
        match self.take(key).map(|member| &member.value.kind) {
            Some(Kind::Text(text)) => text,
            _ => "",
        }
    }
}

/// The known word nearest to a misspelt one, if it is near enough.
pub(in crate::input) fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    let folded = word.to_lowercase().replace(['-', ' '], "_");
    let length = folded.chars().count();
    let known: Vec<&str> = known.into_iter().collect();
    // An id without its edition.
    let edition = |k: &&&str| k.strip_prefix(word).is_some_and(|rest| rest.starts_with('-'));
    if let Some(whole) = known.iter().find(edition) {
        return Some(whole);
    }
    known
        .into_iter()
        // The distance is at least the difference of the lengths, so long texts are not compared.
        .filter(|k| {
            let other = k.chars().count();
            length.abs_diff(other) * 3 <= length.max(other)
        })
        .map(|k| (strsim::damerau_levenshtein(&folded, &k.to_lowercase().replace('-', "_")), k))
        .filter(|(distance, k)| distance * 3 <= length.max(k.chars().count()))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, k)| k)
}

pub(in crate::input) fn wrong_kind(node: &Node, allowed: &str) -> Fault {
    Fault::new(Code::WrongKind, format!("{} is not allowed here", node.noun()))
        .at(node.span.clone())
        .path(node.path.clone())
        .found(node.shown())
        .allowed(allowed)
}

/// Reports a value of a kind that a `T` does not have.
pub(in crate::input) fn other_kind<T: FromNode>(node: &Node, faults: &mut Faults) -> Option<T> {
    faults.push(wrong_kind(node, &T::allowed()));
    None
}

/// The text of a value; reports one that is not a text.
pub(in crate::input) fn text_of<'n, T: FromNode>(node: &'n Node, faults: &mut Faults) -> Option<&'n str> {
    let Kind::Text(text) = &node.kind else {
        other_kind::<T>(node, faults)?;
        return None;
    };
    Some(text)
}

/// A fault about a value of the right kind with the wrong content.
pub(in crate::input) fn wrong_value(code: Code, node: &Node, message: &str, allowed: &str) -> Fault {
    Fault::new(code, message).at(node.span.clone()).path(node.path.clone()).found(node.shown()).allowed(allowed)
}

/// Declares objects of the file; see the head of this module.
macro_rules! object {
    ($(
        $(#[doc = $doc:literal])+
        $name:ident { $(
            $(#[doc = $fdoc:literal])+
            $field:ident $(($example:literal))? : $ty:ty $([$limits:expr])? $(= $absent:expr)?,
        )+ }
    )*) => {$(
        $(#[doc = $doc])+
        #[derive(Debug)]
        pub(crate) struct $name { $($(#[doc = $fdoc])+ pub $field: $ty,)+ }

        #[allow(non_upper_case_globals, reason = "named as the key")]
        impl $name {
            $(const $field: &'static ::tank::keys::Key<<$ty as $crate::input::tank::read::Property>::Default> =
                &::tank::keys::Key {
                    name: $crate::input::tank::read::word(stringify!($field)),
                    help: &[$($fdoc),+],
                    example: ::tank::either!(""; $(concat!($example))?),
                    limits: ::tank::either!(::tank::keys::Limits::ANY; $($limits)?),
                    absent: ::tank::either!(::tank::keys::Absent::Silent; $($absent)?),
                };)+
        }

        impl $crate::input::tank::read::FromNode for $name {
            fn from_node(node: &$crate::input::tank::syntax::Node, faults: &mut $crate::input::diagnostic::Faults) -> Option<Self> {
                use $crate::input::tank::read::{ObjectReader, Property};
                let reader = ObjectReader::new(node, &[$($crate::input::tank::read::word(stringify!($field))),+], faults)?;
                Some($name { $($field: Property::read(&reader, Self::$field, faults),)+ })
            }
            fn allowed() -> String {
                format!("an object with {}", ::tank::keys::list(&[$($crate::input::tank::read::word(stringify!($field))),+], "and"))
            }
            fn example() -> String {
                "{ … }".into()
            }
            fn shape(book: &mut $crate::input::tank::shape::Book) -> $crate::input::tank::shape::Shape {
                use $crate::input::tank::read::Property;
                book.object(stringify!($name), &[$($doc),+], |book| {
                    vec![$(<$ty as Property>::info(Self::$field, book)),+]
                })
            }
        }

        impl $crate::input::tank::read::Object for $name {
            fn absent(path: &str) -> Self {
                use $crate::input::tank::read::Property;
                $name { $($field: Property::absent(path, Self::$field),)+ }
            }
        }
    )*};
}

/// A key as a file has it: a keyword of the language is written `r#type` here.
pub(in crate::input) const fn word(name: &'static str) -> &'static str {
    match name.as_bytes() {
        [b'r', b'#', ..] => name.split_at(2).1,
        _ => name,
    }
}

pub(in crate::input) use object;
