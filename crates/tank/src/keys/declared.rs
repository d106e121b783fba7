//! Objects of the file that are domain types: one declaration, from which a reader derives the rest.
//!
//! This crate knows no file. A [`Reader`] says what it keeps of a key ([`Reads`]); [`keys!`](crate::keys) puts that together to an object, so
//! that checks by hand find each key with its place, and resolves it to the domain type.

use std::marker::PhantomData;

use super::Key;
use crate::value::Value;

/// How a key is given, and what the tank has of it.
pub trait Form {
    /// Its value in the file.
    type Value: 'static;
    /// What the tank has of it.
    type Domain;
}

/// A key that an object needs.
#[derive(Debug)]
pub struct Field<T>(PhantomData<T>);

/// A key that may be absent, and is then absent in the tank.
#[derive(Debug)]
pub struct Opt<T>(PhantomData<T>);

/// A key with a default.
#[derive(Debug)]
pub struct Or<T>(PhantomData<T>);

/// A key that some objects need, as the reader checks; of an object that does not, its value is that of [`Default`].
#[derive(Debug)]
pub struct Needed<T>(PhantomData<T>);

/// A key of this form that the tank has as another type of number.
#[derive(Debug)]
pub struct As<F, D>(PhantomData<(F, D)>);

/// A key with an object that the reader declares and resolves by hand, to a `D`.
#[derive(Debug)]
pub struct Within<D>(PhantomData<D>);

/// A key of this form that the reader resolves by hand, to a `D`.
#[derive(Debug)]
pub struct ByHand<F, D>(PhantomData<(F, D)>);

impl<T: Value> Form for Field<T> {
    type Value = T;
    type Domain = T::Domain;
}

impl<T: Value> Form for Opt<T> {
    type Value = T;
    type Domain = Option<T::Domain>;
}

impl<T: Value> Form for Or<T> {
    type Value = T;
    type Domain = T::Domain;
}

impl<T: Value> Form for Needed<T> {
    type Value = T;
    type Domain = T::Domain;
}

impl<F: Form, D> Form for As<F, D> {
    type Value = F::Value;
    type Domain = D;
}

impl<D> Form for Within<D> {
    type Value = ();
    type Domain = D;
}

impl<F: Form, D> Form for ByHand<F, D> {
    type Value = F::Value;
    type Domain = D;
}

/// A reader of files.
pub trait Reader {
    /// Where it finds the keys of an object.
    type From<'a>;
    /// Where it reports what it resolves.
    type Into<'a>;
    /// Where it describes keys.
    type Book;
    /// Description of a key.
    type Info;
}

/// A reader of keys of a form.
pub trait Reads<F: Form>: Reader {
    /// What it keeps of a key.
    type Given;
    /// Reads a key.
    fn read(from: &mut Self::From<'_>, key: &'static Key<F::Value>) -> Self::Given;
    /// Resolves a key; `None` if there is no value that an object could have.
    fn resolve(given: &Self::Given, into: &mut Self::Into<'_>) -> Option<F::Domain>;
    /// Describes a key.
    fn describe(key: &'static Key<F::Value>, book: &mut Self::Book) -> Self::Info;
}

/// A domain type that is an object of the file, for a reader of all its keys.
pub trait Declared<R: Reader>: Sized + 'static {
    /// The object as given.
    type Given;
    /// Name in the JSON Schema.
    const NAME: &'static str;
    /// Meaning, line by line.
    const HELP: &'static [&'static str];
    /// Names of its keys.
    const KEYS: &'static [&'static str];
    /// Reads all keys.
    fn read(from: &mut R::From<'_>) -> Self::Given;
    /// Resolves all keys in the order of their declaration.
    fn resolve(given: &Self::Given, into: &mut R::Into<'_>) -> Option<Self>;
    /// Describes all keys.
    fn describe(book: &mut R::Book) -> Vec<R::Info>;
}

/// Declares objects of the file that are domain types.
///
/// ```text
/// keys! {
///     /// Meaning of the object.
///     pub Name as SchemaName (Copy, Default) {
///         /// Meaning of the key.
///         @"serde's skip_serializing_if" @(other arguments of serde) key (example): Form [limits] = default,
///     } with {
///         /// A field that is not a key.
///         field: Type = value,
///     }
/// }
/// ```
///
/// Schema name, further derives, serde's arguments, example, limits, default and the second part are optional. Forms are [`Field`], [`Opt`],
/// [`Or`], [`Needed`], [`As`], [`Within`] and [`ByHand`].
macro_rules! keys {
    ($(
        $(#[doc = $doc:literal])+
        pub $name:ident $(as $schema:ident)? $(($($derive:ident),+))? {
            $(
                $(#[doc = $fdoc:literal])+
                $(@$skip:literal)? $(@($($serde:tt)+))? $field:ident $(($example:literal))? : $form:ty $([$limits:expr])? $(= $absent:expr)?,
            )+
        } $(with { $(
            $(#[doc = $edoc:literal])+
            $(@$eskip:literal)? $extra:ident : $ety:ty = $einit:expr,
        )+ })?
    )*) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize $($(, $derive)+)?)]
        pub struct $name {
            $(
                $(#[doc = $fdoc])+
                $(#[serde(default, skip_serializing_if = $skip)])?
                $(#[serde($($serde)+)])?
                pub $field: <$form as $crate::keys::Form>::Domain,
            )+
            $($(
                $(#[doc = $edoc])+
                $(#[serde(default, skip_serializing_if = $eskip)])?
                pub $extra: $ety,
            )+)?
        }

        const _: () = {
            #[allow(clippy::wildcard_imports, reason = "the words of declarations")]
            use $crate::keys::*;

            /// The keys as given.
            pub struct Given<R: Reader>
            where
                $(R: Reads<$form>,)+
            {
                $($(#[doc = $fdoc])+ pub $field: <R as Reads<$form>>::Given,)+
            }

            #[allow(non_upper_case_globals, reason = "named as the key")]
            impl $name {
                $(const $field: &'static Key<<$form as Form>::Value> = &Key {
                    name: stringify!($field),
                    help: &[$($fdoc),+],
                    example: $crate::either!(""; $(concat!($example))?),
                    limits: $crate::either!(Limits::ANY; $($limits)?),
                    absent: $crate::either!(Absent::Silent; $($absent)?),
                };)+
            }

            impl<R: Reader> Declared<R> for $name
            where
                $(R: Reads<$form>,)+
            {
                type Given = Given<R>;
                const NAME: &'static str = $crate::keys::keys!(@name $name $($schema)?);
                const HELP: &'static [&'static str] = &[$($doc),+];
                const KEYS: &'static [&'static str] = &[$(stringify!($field)),+];
                fn read(from: &mut R::From<'_>) -> Self::Given {
                    Given { $($field: <R as Reads<$form>>::read(from, Self::$field),)+ }
                }
                fn resolve(given: &Self::Given, into: &mut R::Into<'_>) -> Option<Self> {
                    $(let $field = <R as Reads<$form>>::resolve(&given.$field, into);)+
                    Some($name { $($field: $field?,)+ $($($extra: $einit,)+)? })
                }
                fn describe(book: &mut R::Book) -> Vec<R::Info> {
                    vec![$(<R as Reads<$form>>::describe(Self::$field, book)),+]
                }
            }
        };
    )*};
    (@name $name:ident) => { stringify!($name) };
    (@name $name:ident $schema:ident) => { stringify!($schema) };
}

/// The second expression, or the first if there is none.
#[macro_export]
#[doc(hidden)]
macro_rules! either {
    ($default:expr;) => {
        $default
    };
    ($default:expr; $given:expr) => {
        $given
    };
}

pub(crate) use keys;
