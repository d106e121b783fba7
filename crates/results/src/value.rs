//! A value with its unit.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// A value with its SI unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Value {
    /// Value in SI.
    pub value: f64,
    /// Dimension; its SI symbol is the unit.
    #[serde(rename = "unit", with = "unit_symbol")]
    pub dimension: Dimension,
}

/// Writes a dimension as its SI symbol.
pub(crate) mod unit_symbol {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};
    use tank::units::Dimension;

    pub(crate) fn serialize<S: Serializer>(d: &Dimension, s: S) -> Result<S::Ok, S::Error> {
        s.serialize_str(d.si_symbol())
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<Dimension, D::Error> {
        let text = String::deserialize(d)?;
        Dimension::from_si_symbol(&text).ok_or_else(|| D::Error::custom(format!("unknown unit `{text}`")))
    }
}
