//! Keys whose object may be `"none"`: a part that is said not to be there, in place of one of which nothing is said.

use std::ops::Deref;

use super::read::{Field, FromNode, ObjectReader, Opt, Property, wrong_kind};
use super::shape::{Book, KeyInfo, Shape};
use super::syntax::Kind;
use crate::input::diagnostic::Faults;
use tank::keys::Key;

/// The word for a part that is not there.
pub(in crate::input) const NONE: &str = "none";

/// An optional key with an object, or [`NONE`].
#[derive(Debug)]
pub(in crate::input) struct Stated<T: 'static> {
    object: Opt<T>,
    /// The place of `none`.
    pub none: Option<Field<()>>,
}

impl<T> Deref for Stated<T> {
    type Target = Opt<T>;
    fn deref(&self) -> &Opt<T> {
        &self.object
    }
}

impl<T: FromNode> Property for Stated<T> {
    type Inner = T;
    type Default = T;
    const REQUIRED: bool = false;
    fn read(object: &ObjectReader<'_>, key: &'static Key<T>, faults: &mut Faults) -> Self {
        let absent = Stated::absent(object.path(), key);
        let Some(member) = object.take(key.name) else { return absent };
        match &member.value.kind {
            Kind::Text(word) if word == NONE => Stated {
                none: Some(Field {
                    text: NONE.into(),
                    ..Field::missing(member.value.span.clone(), member.value.path.clone())
                }),
                ..absent
            },
            Kind::Object(_) => Stated { object: Property::read(object, key, faults), none: None },
            _ => {
                faults.push(wrong_kind(&member.value, &format!("\"{NONE}\" or {}", T::allowed())));
                // Said, if not in a way that can be read.
                Stated {
                    object: Opt {
                        given: Some(Field::missing(member.value.span.clone(), member.value.path.clone())),
                        ..absent.object
                    },
                    none: None,
                }
            }
        }
    }
    fn absent(path: &str, key: &'static Key<T>) -> Self {
        Stated { object: Opt::absent(path, key), none: None }
    }
    fn written(default: &T) -> Option<String> {
        default.written()
    }
    fn info(key: &'static Key<T>, book: &mut Book) -> KeyInfo {
        let info = <Opt<T> as Property>::info(key, book);
        KeyInfo { shape: Shape::Either(NONE, Box::new(info.shape)), example: NONE.into(), ..info }
    }
}
