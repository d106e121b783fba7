//! The last guard before results leave the program: every number in them is finite.
//!
//! JSON cannot express NaN and infinity; `serde_json` writes them as `null`, and a table prints them. [`check`] walks over
//! any serialisable value and names the first number that is not finite by its path. An absent value is an `Option`, which
//! differs from NaN; so is the utilisation of a check without any capacity. Histories of interrupted runs end in NaN
//! in `series.csv`, which is not part of the walk.

use std::fmt::{self, Display};

use serde::ser::{self, Serialize, Serializer};

use super::{Results, Series};
use files::error::Error;

/// Accepts a value in which every number is finite.
///
/// * `what`: name of the value in the message (`modes`)
///
/// Errors: [`Error::NotFinite`] with the path of the first other number.
pub fn check(what: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Error> {
    named(value, |path| match path {
        "" => what.to_owned(),
        path => format!("{what}, `{path}`"),
    })
}

/// Accepts the results of a verification in which every number is finite.
///
/// Errors: [`Error::NotFinite`] with quantity and method, or with the path of the first other number.
pub fn check_results(results: &Results) -> Result<(), Error> {
    named(results, |path| {
        let method = |list: &str| {
            let (index, rest) = path.strip_prefix(list)?.strip_prefix('[')?.split_once(']')?;
            let rest = rest.strip_prefix('.').unwrap_or(rest);
            Some((index.parse::<usize>().ok()?, rest))
        };
        if let Some((index, rest)) = method("methods")
            && let Some(method) = results.methods.get(index)
        {
            return format!("`{rest}` of the method `{}`", method.id);
        }
        if let Some((index, _)) = method("comparison.rows")
            && let Some(row) = results.comparison.rows.get(index)
        {
            return format!("`{}` in the comparison of methods", row.quantity);
        }
        format!("`{path}` of the results")
    })
}

/// Accepts histories in which every number is finite.
///
/// Errors: [`Error::NotFinite`] with the column and the time of the first other number.
pub fn check_series(method: &str, series: &Series) -> Result<(), Error> {
    for (id, column) in series.ids.iter().zip(&series.columns) {
        if let Some(i) = column.iter().position(|v| !v.is_finite()) {
            let time = series.time.get(i).copied().unwrap_or(f64::NAN);
            return Err(Error::NotFinite {
                quantity: format!("the history `{id}` of the method `{method}` at {time:.3} s"),
                value: column[i],
            });
        }
    }
    Ok(())
}

fn named(value: &(impl Serialize + ?Sized), name: impl Fn(&str) -> String) -> Result<(), Error> {
    let mut walk = Walk { place: Vec::new() };
    match value.serialize(&mut walk) {
        Ok(()) => Ok(()),
        Err(Stop::NotFinite(value)) => Err(Error::NotFinite { quantity: name(&walk.path()), value }),
        Err(Stop::Other(reason)) => Err(Error::Report(reason)),
    }
}

/// A serialiser without output that stops at a number that is not finite; `place` then leads from it to the whole.
struct Walk {
    place: Vec<Step>,
}

/// A step into a value.
enum Step {
    Member(String),
    Index(usize),
}

#[derive(Debug)]
enum Stop {
    NotFinite(f64),
    Other(String),
}

impl Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::NotFinite(value) => write!(f, "{value}"),
            Stop::Other(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Stop {}

impl ser::Error for Stop {
    fn custom<T: Display>(reason: T) -> Stop {
        Stop::Other(reason.to_string())
    }
}

impl Walk {
    /// The place of the number, from the whole.
    fn path(&self) -> String {
        self.place.iter().rev().fold(String::new(), |path, step| match step {
            Step::Member(key) if path.is_empty() => key.clone(),
            Step::Member(key) => format!("{path}.{key}"),
            Step::Index(index) => format!("{path}[{index}]"),
        })
    }

    /// Walks into a member. Most numbers are finite: a step is written down only on the way back from one that is not.
    fn inside(&mut self, value: &(impl Serialize + ?Sized), step: impl FnOnce() -> Step) -> Result<(), Stop> {
        let found = value.serialize(&mut *self);
        if found.is_err() {
            self.place.push(step());
        }
        found
    }

    fn member(&mut self, key: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Stop> {
        self.inside(value, || Step::Member(key.to_owned()))
    }
}

/// The members of a list, a map or a struct.
struct Members<'w> {
    walk: &'w mut Walk,
    index: usize,
    key: String,
}

macro_rules! ignored {
    ($($method:ident: $kind:ty,)*) => {$(
        fn $method(self, _: $kind) -> Result<(), Stop> {
            Ok(())
        }
    )*};
}

impl<'w> Serializer for &'w mut Walk {
    type Ok = ();
    type Error = Stop;
    type SerializeSeq = Members<'w>;
    type SerializeTuple = Members<'w>;
    type SerializeTupleStruct = Members<'w>;
    type SerializeTupleVariant = Members<'w>;
    type SerializeMap = Members<'w>;
    type SerializeStruct = Members<'w>;
    type SerializeStructVariant = Members<'w>;

    ignored! {
        serialize_bool: bool, serialize_char: char, serialize_str: &str, serialize_bytes: &[u8],
        serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64,
        serialize_unit_struct: &'static str,
    }

    fn serialize_f32(self, value: f32) -> Result<(), Stop> {
        self.serialize_f64(value.into())
    }
    fn serialize_f64(self, value: f64) -> Result<(), Stop> {
        if value.is_finite() { Ok(()) } else { Err(Stop::NotFinite(value)) }
    }
    fn serialize_none(self) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Stop> {
        value.serialize(self)
    }
    fn serialize_unit(self) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Result<(), Stop> {
        value.serialize(self)
    }
    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Stop> {
        self.member(variant, value)
    }
    fn serialize_seq(self, _: Option<usize>) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_tuple(self, _: usize) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_tuple_variant(self, _: &'static str, _: u32, _: &'static str, _: usize) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_map(self, _: Option<usize>) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
    fn serialize_struct_variant(self, _: &'static str, _: u32, _: &'static str, _: usize) -> Result<Members<'w>, Stop> {
        Ok(Members::of(self))
    }
}

impl<'w> Members<'w> {
    fn of(walk: &'w mut Walk) -> Members<'w> {
        Members { walk, index: 0, key: String::new() }
    }

    fn next(&mut self, value: &(impl Serialize + ?Sized)) -> Result<(), Stop> {
        let index = self.index;
        self.index += 1;
        self.walk.inside(value, || Step::Index(index))
    }
}

macro_rules! lists {
    ($($trait:ident: $method:ident,)*) => {$(
        impl ser::$trait for Members<'_> {
            type Ok = ();
            type Error = Stop;
            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
                self.next(value)
            }
            fn end(self) -> Result<(), Stop> {
                Ok(())
            }
        }
    )*};
}

lists! {
    SerializeSeq: serialize_element,
    SerializeTuple: serialize_element,
    SerializeTupleStruct: serialize_field,
    SerializeTupleVariant: serialize_field,
}

macro_rules! structs {
    ($($trait:ident,)*) => {$(
        impl ser::$trait for Members<'_> {
            type Ok = ();
            type Error = Stop;
            fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Stop> {
                self.walk.member(key, value)
            }
            fn end(self) -> Result<(), Stop> {
                Ok(())
            }
        }
    )*};
}

structs! { SerializeStruct, SerializeStructVariant, }

impl ser::SerializeMap for Members<'_> {
    type Ok = ();
    type Error = Stop;
    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Stop> {
        // Keys of our maps are texts; another key is shown as JSON has it.
        self.key = match serde_json::to_value(key) {
            Ok(serde_json::Value::String(text)) => text,
            Ok(other) => other.to_string(),
            Err(error) => return Err(Stop::Other(error.to_string())),
        };
        Ok(())
    }
    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
        let key = std::mem::take(&mut self.key);
        self.walk.member(&key, value)
    }
    fn end(self) -> Result<(), Stop> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use tank::assessment::Excitation;
    use tank::units::Dimension;

    use super::*;
    use crate::{Method, Value};

    fn message(value: &impl Serialize) -> String {
        check("it", value).err().map_or(String::new(), |e| e.to_string())
    }

    #[test]
    fn absent_is_not_nan() {
        assert_eq!(message(&(1.0, None::<f64>, "NaN", [f64::MAX; 3])), "");
        assert_eq!(message(&f64::NAN), "the computation gave NaN for it");
        assert_eq!(message(&(1, Some(f64::INFINITY))), "the computation gave inf for it, `[1]`");
        let map = BTreeMap::from([("a", vec![(0.0, 1.0)]), ("b", vec![(0.0, 1.0), (0.0, f64::NEG_INFINITY)])]);
        assert_eq!(message(&map), "the computation gave -inf for it, `b[1][1]`");
    }

    #[test]
    fn every_number_of_a_method_is_looked_at() {
        let method = |value| Method {
            quantities: BTreeMap::from([("base_shear".to_string(), Value { value, dimension: Dimension::Force })]),
            ..Method::new("housner", "", Excitation::Record)
        };
        assert_eq!(message(&method(1.0)), "");
        assert_eq!(message(&method(f64::NAN)), "the computation gave NaN for it, `quantities.base_shear.value`");
    }

    #[test]
    fn histories_name_column_and_time() {
        let mut series = Series { time: vec![0.0, 0.5], ids: vec!["base_shear".into()], columns: vec![vec![0.0, 1.0]] };
        assert!(check_series("fe", &series).is_ok());
        series.columns[0][1] = f64::NAN;
        let error = check_series("fe", &series).unwrap_err();
        assert_eq!(error.exit_code(), files::error::EXIT_COMPUTATION);
        let text = error.to_string();
        assert!(text.contains("NaN") && text.contains("`base_shear`") && text.contains("at 0.500 s"), "{text}");
    }
}
