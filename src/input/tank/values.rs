//! Types of values in the file: quantities, numbers, words, lists.

use files::code::Code;
use tank::options::AfterRecord;
use tank::options::nonlinear::ThicknessRule;
use tank::options::solid::MeshSize;
use tank::units::{self, Dimension, UnitError};

pub(in crate::input) use tank::keys::{
    Acceleration, Angle, Area, AreaMass, Density, Force, InG, Length, LineArea, LineForce, Mass, Number, Pitch,
    SecondMoment, Seconds, Stress, Subgrade, Temperature, Time, Velocity, Whole,
};

use super::read::{Field, FromNode, other_kind, text_of, wrong_kind, wrong_value};
use super::resolver::{Resolved, Resolver, Si};
use super::shape::{Book, Shape};
use super::syntax::{Kind, Node};
use tank::keys::written;

use crate::input::diagnostic::{Fault, Faults};

/// Reads a quantity of a dimension; a bare number is one only where there is no unit.
pub(in crate::input) fn quantity(node: &Node, dimension: Dimension, faults: &mut Faults) -> Option<f64> {
    let text = match &node.kind {
        Kind::Text(text) | Kind::Number(text) => text,
        _ => {
            faults.push(wrong_kind(node, &dimension.allowed()));
            return None;
        }
    };
    match units::parse(text, dimension) {
        Ok(value) => Some(value),
        Err(error) => {
            faults.push(quantity_fault(node, &error, &dimension.allowed()));
            None
        }
    }
}

/// The kind of fault of a text that is not a quantity.
pub(in crate::input) fn unit_code(error: &UnitError) -> Code {
    match error {
        UnitError::Empty | UnitError::NotANumber { .. } | UnitError::Fraction { .. } => Code::NotANumber,
        UnitError::NotFinite { .. } => Code::NotFinite,
        UnitError::MissingUnit { .. } => Code::UnitMissing,
        UnitError::UnknownUnit { .. } => Code::UnitUnknown,
        UnitError::WrongDimension { .. } => Code::UnitOfOther,
    }
}

pub(in crate::input) fn quantity_fault(node: &Node, error: &UnitError, allowed: &str) -> Fault {
    let fault = Fault::new(unit_code(error), error.to_string())
        .at(node.span.clone())
        .path(node.path.clone())
        .found(node.shown())
        .allowed(allowed);
    match error.help().or_else(|| weight(node, error)) {
        Some(help) => fault.help(help),
        None => fault,
    }
}

/// The density of a weight per volume (`25 kN/m3`), for who writes that.
fn weight(node: &Node, error: &UnitError) -> Option<String> {
    let (UnitError::WrongDimension { expected, .. }, Kind::Text(text)) = (error, &node.kind) else { return None };
    // A subgrade modulus has the same unit.
    let weight = units::parse(text, Dimension::Subgrade).ok()?;
    let density = weight / tank::STANDARD_GRAVITY;
    (*expected == Dimension::Density && density.is_finite())
        .then(|| format!("a weight per volume is g times the density: \"{density:.0} kg/m3\""))
}

/// Pattern of the texts that are quantities of a dimension.
pub(in crate::input) fn pattern(dimension: Dimension) -> String {
    let mut spellings: Vec<String> = Vec::new();
    for spelling in dimension.units().flat_map(|u| u.spellings().collect::<Vec<_>>()) {
        let mut regex = String::new();
        for c in spelling.chars() {
            match c {
                '/' => regex.push_str(" ?/ ?"),
                '2' | '²' => regex.push_str("\\^?[2²]"),
                '3' | '³' => regex.push_str("\\^?[3³]"),
                '4' | '⁴' => regex.push_str("\\^?[4⁴]"),
                '·' | '*' => regex.push_str("[·*]"),
                c => regex.push(c),
            }
        }
        if !spellings.contains(&regex) {
            spellings.push(regex);
        }
    }
    let unit = spellings.join("|");
    let optional = if dimension == Dimension::Dimensionless { "?" } else { "" };
    format!("^[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)? ?({unit}){optional}$")
}

/// Numbers: NaN stands for a faulty one.
macro_rules! resolved {
    ($name:ident, $dimension:expr) => {
        impl Si for $name {
            const DIMENSION: Dimension = $dimension;
            fn si(self) -> f64 {
                self.0
            }
        }

        impl Resolved for $name {
            fn resolve(field: &Field<Self>, r: &mut Resolver<'_>) -> Option<f64> {
                Some(r.number(field))
            }
        }
    };
}

/// Quantities of one dimension.
macro_rules! quantity {
    ($($name:ident: $dimension:expr;)*) => {$(
        impl FromNode for $name {
            fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
                quantity(node, $dimension, faults).map($name)
            }
            fn allowed() -> String {
                $dimension.allowed()
            }
            fn example() -> String {
                match $dimension {
                    Dimension::Dimensionless => $dimension.example().into(),
                    dimension => format!("\"{}\"", dimension.example()),
                }
            }
            fn shape(_: &mut Book) -> Shape {
                Shape::Quantity($dimension)
            }
            fn written(&self) -> Option<String> {
                Some(written(self.0, $dimension))
            }
        }

        resolved!($name, $dimension);
    )*};
}

quantity! {
    Number: Dimension::Dimensionless;
    Length: Dimension::Length;
    Angle: Dimension::Angle;
    Time: Dimension::Time;
    Mass: Dimension::Mass;
    Density: Dimension::Density;
    Velocity: Dimension::Velocity;
    Subgrade: Dimension::Subgrade;
    Temperature: Dimension::Temperature;
    Acceleration: Dimension::Acceleration;
    Force: Dimension::Force;
    Stress: Dimension::Stress;
    LineForce: Dimension::LineForce;
    LineArea: Dimension::LineArea;
    Area: Dimension::Area;
    SecondMoment: Dimension::SecondMoment;
    AreaMass: Dimension::AreaMass;
}

/// Quantities that may also be a bare number in one conventional unit.
macro_rules! conventional {
    ($($name:ident: $dimension:expr, $unit:literal, $factor:expr, $example:literal;)*) => {$(
        impl FromNode for $name {
            fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
                let factor: f64 = $factor;
                match &node.kind {
                    Kind::Number(_) => quantity(node, Dimension::Dimensionless, faults).map($name),
                    _ => quantity(node, $dimension, faults).map(|si| $name(si / factor)),
                }
            }
            fn allowed() -> String {
                format!("a number in {} such as {}, or {}", $unit, $example, $dimension.allowed())
            }
            fn example() -> String {
                $example.into()
            }
            fn shape(_: &mut Book) -> Shape {
                Shape::Conventional($dimension, $unit)
            }
            fn written(&self) -> Option<String> {
                Some(self.0.to_string())
            }
        }

        resolved!($name, Dimension::Dimensionless);
    )*};
}

conventional! {
    InG: Dimension::Acceleration, "units of g", tank::STANDARD_GRAVITY, "0.5";
    Seconds: Dimension::Time, "seconds", 1.0, "4.0";
}

/// What a place on the frequency axis may be given as.
const PITCH: [Dimension; 3] = [Dimension::AngularFrequency, Dimension::Frequency, Dimension::Time];
/// Frequencies of any mode of a tank [rad/s], and far beyond.
const PITCH_RANGE: std::ops::RangeInclusive<f64> = 1e-6..=1e6;

impl FromNode for Pitch {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let text = text_of::<Self>(node, faults)?;
        let mut results = PITCH.map(|d| units::parse(text, d)).into_iter().zip(PITCH);
        let two_pi = 2.0 * std::f64::consts::PI;
        let Some((value, dimension)) = results.find_map(|(r, d)| r.ok().map(|v| (v, d))) else {
            let error = match units::parse(text, Dimension::AngularFrequency) {
                Err(error) => error,
                Ok(_) => UnitError::Empty,
            };
            faults.push(quantity_fault(node, &error, &Self::allowed()));
            return None;
        };
        let omega = match dimension {
            Dimension::AngularFrequency => value,
            Dimension::Frequency => two_pi * value,
            _ => two_pi / value,
        };
        if PITCH_RANGE.contains(&omega) {
            return Some(Pitch(omega));
        }
        let (message, allowed) = match value > 0.0 {
            true => ("a frequency or period out of range", "1e-6 to 1e6 rad/s".to_owned()),
            false => ("a frequency or period must be positive", Self::allowed()),
        };
        faults.push(wrong_value(Code::OutOfRange, node, message, &allowed));
        None
    }
    fn allowed() -> String {
        "a circular frequency, frequency or period such as \"3 rad/s\", \"0.48 Hz\" or \"2.1 s\"".into()
    }
    fn example() -> String {
        "\"3 rad/s\"".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Pattern {
            noun: "a circular frequency, a frequency or a period".into(),
            patterns: PITCH.map(pattern).into(),
            examples: &["3 rad/s", "0.48 Hz", "2.1 s"],
        }
    }
}

impl FromNode for MeshSize {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        let text = text_of::<Self>(node, faults)?;
        match text.parse() {
            Ok(mesh) => Some(mesh),
            Err(_) => {
                faults.push(wrong_value(Code::BadForm, node, "not a mesh", &Self::allowed()));
                None
            }
        }
    }
    fn allowed() -> String {
        MeshSize::ALLOWED.into()
    }
    fn example() -> String {
        "\"12x16x20\"".into()
    }
    fn shape(_: &mut Book) -> Shape {
        let count = "(1000|[1-9][0-9]{0,2})";
        Shape::Pattern {
            noun: "three whole numbers from 1 to 1000".into(),
            patterns: vec![format!("^ *{count} *[xX×] *{count} *[xX×] *{count} *$")],
            examples: &["12x16x20"],
        }
    }
    fn written(&self) -> Option<String> {
        Some(self.to_string())
    }
}

impl Resolved for Whole {
    fn resolve(field: &Field<Self>, r: &mut Resolver<'_>) -> Option<u32> {
        r.count(field)
    }
    fn stand_in() -> Option<u32> {
        Some(0)
    }
}

impl Resolved for String {
    fn resolve(field: &Field<Self>, r: &mut Resolver<'_>) -> Option<String> {
        r.text(field)
    }
}

/// Values without limits.
macro_rules! echoed {
    ($($name:ty),+) => {$(
        impl $crate::input::tank::resolver::Resolved for $name {
            fn resolve(
                field: &$crate::input::tank::read::Field<Self>,
                r: &mut $crate::input::tank::resolver::Resolver<'_>,
            ) -> Option<<$name as ::tank::value::Value>::Domain> {
                r.echo_given(field);
                field.value.map(::tank::value::Value::domain)
            }
        }
    )+};
}

pub(in crate::input) use echoed;

echoed!(bool, MeshSize, Pitch, AfterRecord, ThicknessRule);

impl FromNode for Whole {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        if let Kind::Number(text) = &node.kind
            && let Ok(value) = text.parse()
        {
            return Some(Whole(value));
        }
        faults.push(wrong_value(Code::OutOfRange, node, "not a whole number", &Self::allowed()));
        None
    }
    fn allowed() -> String {
        "a whole number without quotes such as 1".into()
    }
    fn example() -> String {
        "1".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Whole
    }
    fn written(&self) -> Option<String> {
        Some(self.0.to_string())
    }
}

impl FromNode for String {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Text(text) => Some(text.clone()),
            _ => other_kind(node, faults),
        }
    }
    fn allowed() -> String {
        "a text in quotes".into()
    }
    fn example() -> String {
        "\"…\"".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Text
    }
}

impl FromNode for bool {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Bool(value) => Some(*value),
            _ => other_kind(node, faults),
        }
    }
    fn allowed() -> String {
        "true or false, without quotes".into()
    }
    fn example() -> String {
        "true".into()
    }
    fn shape(_: &mut Book) -> Shape {
        Shape::Bool
    }
    fn written(&self) -> Option<String> {
        Some(self.to_string())
    }
}

/// A list.
impl<T: FromNode> FromNode for Vec<Field<T>> {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::List(nodes) => Some(nodes.iter().map(|n| Field::from_node(n, faults)).collect()),
            _ => other_kind(node, faults),
        }
    }
    fn allowed() -> String {
        "a list [ … ]".into()
    }
    fn example() -> String {
        format!("[{}]", T::example())
    }
    fn shape(book: &mut Book) -> Shape {
        Shape::List(Box::new(T::shape(book)))
    }
}

/// Objects of one kind under names of the user's choice, in the order of the file.
#[derive(Clone, Debug)]
pub(in crate::input) struct Named<T>(pub Vec<(String, Field<T>)>);

impl<T: FromNode> FromNode for Named<T> {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        match &node.kind {
            Kind::Object(members) => {
                Some(Named(members.iter().map(|m| (m.key.clone(), Field::from_node(&m.value, faults))).collect()))
            }
            _ => other_kind(node, faults),
        }
    }
    fn allowed() -> String {
        "an object { \"name\": { … } }".into()
    }
    fn example() -> String {
        "{ … }".into()
    }
    fn shape(book: &mut Book) -> Shape {
        Shape::Named(Box::new(T::shape(book)))
    }
}
