//! Objects that [`tank::keys`] declares as domain types: how they are read, described and resolved.

use std::fmt::{self, Debug, Formatter};
use std::ops::Deref;

use tank::keys::{self, Declared, Form, Key, Reader, Reads};

use super::read::{Field, FromNode, Object, ObjectReader, Opt, Property};
use super::resolver::{Resolved, Resolver};
use super::shape::{Book, KeyInfo, Shape};
use super::syntax::Node;
use crate::input::diagnostic::Faults;
use tank::keys::list;

/// The reader of JSON.
#[derive(Debug)]
pub(in crate::input) struct Json;

/// Where it finds the keys of an object.
pub(in crate::input) enum Keys<'a> {
    /// In the file.
    Of(ObjectReader<'a>, &'a mut Faults),
    /// Nowhere: the object at this path is absent.
    Absent(&'a str),
}

impl Keys<'_> {
    /// A key.
    pub(crate) fn key<P: Property>(&mut self, key: &'static Key<P::Default>) -> P {
        match self {
            Keys::Of(object, faults) => P::read(object, key, faults),
            Keys::Absent(path) => P::absent(path, key),
        }
    }
}

impl Reader for Json {
    type From<'a> = Keys<'a>;
    type Into<'a> = Resolver<'a>;
    type Book = Book;
    type Info = KeyInfo;
}

/// What the reader keeps of a key, and how it reads and describes it.
macro_rules! kept {
    ($given:ty, $value:ty) => {
        type Given = $given;
        fn read(
            from: &mut $crate::input::tank::given::Keys<'_>,
            key: &'static ::tank::keys::Key<$value>,
        ) -> Self::Given {
            from.key(key)
        }
        fn describe(
            key: &'static ::tank::keys::Key<$value>,
            book: &mut $crate::input::tank::shape::Book,
        ) -> $crate::input::tank::shape::KeyInfo {
            <$given as $crate::input::tank::read::Property>::info(key, book)
        }
    };
}

impl<T: Resolved> Reads<keys::Field<T>> for Json {
    kept!(Field<T>, T);
    fn resolve(given: &Field<T>, r: &mut Resolver<'_>) -> Option<T::Domain> {
        T::resolve(given, r).or_else(T::stand_in)
    }
}

impl<T: Resolved> Reads<keys::Opt<T>> for Json {
    kept!(Opt<T>, T);
    fn resolve(given: &Opt<T>, r: &mut Resolver<'_>) -> Option<Option<T::Domain>> {
        Some(r.optional(given))
    }
}

impl<T: Resolved + Copy> Reads<keys::Or<T>> for Json {
    kept!(Opt<T>, T);
    fn resolve(given: &Opt<T>, r: &mut Resolver<'_>) -> Option<T::Domain> {
        Some(r.or_default(given))
    }
}

impl<T: Resolved<Domain: Default>> Reads<keys::Needed<T>> for Json {
    kept!(Opt<T>, T);
    fn resolve(given: &Opt<T>, r: &mut Resolver<'_>) -> Option<T::Domain> {
        let value = given.given.as_ref().and_then(|field| T::resolve(field, r));
        Some(value.unwrap_or_default())
    }
}

/// What the reader keeps of a key, and how it reads and describes it, as that of the form `F`.
macro_rules! kept_as {
    ($form:ident) => {
        type Given = <Json as Reads<$form>>::Given;
        fn read(from: &mut Keys<'_>, key: &'static Key<$form::Value>) -> Self::Given {
            <Json as Reads<$form>>::read(from, key)
        }
        fn describe(key: &'static Key<$form::Value>, book: &mut Book) -> KeyInfo {
            <Json as Reads<$form>>::describe(key, book)
        }
    };
}

impl<F: Form, D: TryFrom<F::Domain> + Default> Reads<keys::As<F, D>> for Json
where
    Json: Reads<F>,
{
    kept_as!(F);
    fn resolve(given: &Self::Given, r: &mut Resolver<'_>) -> Option<D> {
        let value = <Json as Reads<F>>::resolve(given, r)?;
        Some(D::try_from(value).unwrap_or_default())
    }
}

/// What a key of the form `F` is resolved to by hand.
pub(in crate::input) trait Hand<F: Form>: Sized
where
    Json: Reads<F>,
{
    /// The value; `None` if there is none that an object could have.
    fn by_hand(given: &<Json as Reads<F>>::Given, r: &mut Resolver<'_>) -> Option<Self>;
}

impl<F: Form, D: Hand<F>> Reads<keys::ByHand<F, D>> for Json
where
    Json: Reads<F>,
{
    kept_as!(F);
    fn resolve(given: &Self::Given, r: &mut Resolver<'_>) -> Option<D> {
        D::by_hand(given, r)
    }
}

/// Objects within objects of [`tank::keys`]: the domain type, the object, and the function that resolves one to the other.
macro_rules! within {
    ($($domain:ty => $object:ty, $resolve:path;)+) => {$(
        impl ::tank::keys::Reads<::tank::keys::Within<$domain>> for $crate::input::tank::given::Json {
            $crate::input::tank::given::kept!($crate::input::tank::read::Opt<$object, ()>, ());
            fn resolve(given: &Self::Given, r: &mut $crate::input::tank::resolver::Resolver<'_>) -> Option<$domain> {
                Some($resolve(r, given))
            }
        }
    )+};
}

pub(in crate::input) use {kept, within};

/// The keys of an object that is a domain type.
pub(in crate::input) struct Given<T: Declared<Json>>(T::Given);

impl<T: Declared<Json>> Given<T> {
    /// The domain type.
    pub(crate) fn resolve(&self, r: &mut Resolver<'_>) -> Option<T> {
        T::resolve(&self.0, r)
    }
}

impl<T: Declared<Json>> Deref for Given<T> {
    type Target = T::Given;
    fn deref(&self) -> &T::Given {
        &self.0
    }
}

impl<T: Declared<Json>> Debug for Given<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(T::NAME)
    }
}

impl<T: Declared<Json>> FromNode for Given<T> {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let reader = ObjectReader::new(node, T::KEYS, faults)?;
        Some(Given(T::read(&mut Keys::Of(reader, faults))))
    }
    fn allowed() -> String {
        format!("an object with {}", list(T::KEYS, "and"))
    }
    fn example() -> String {
        "{ … }".into()
    }
    fn shape(book: &mut Book) -> Shape {
        book.object(T::NAME, T::HELP, T::describe)
    }
}

impl<T: Declared<Json>> Object for Given<T> {
    fn absent(path: &str) -> Self {
        Given(T::read(&mut Keys::Absent(path)))
    }
}
