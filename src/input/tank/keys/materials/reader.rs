//! Values of a material from the file, or else from its grade.

use files::code::Code;
use tank::units::{display_in, unit_for};

use crate::input::tank::keys::grades::Preset;
use crate::input::tank::read::{Field, FromNode, Opt};
use crate::input::tank::resolver::{Resolver, Si, like_unit, range_fault};
use crate::input::tank::syntax::join;
use crate::input::tank::values::Stress;

/// Relative difference from which a given value is not that of the grade beside it.
const UNLIKE: f64 = 0.1;

/// Young's modulus [Pa], and the yield strength of the material [Pa].
pub(super) type ElasticPart = (f64, Option<f64>);

/// Where the values of a material come from.
pub(super) struct Reader {
    /// Values of the grade, if the material has one.
    pub preset: Option<Preset>,
    /// Path of the object that is read.
    pub path: String,
    /// Place to underline for a missing key.
    pub head: std::ops::Range<usize>,
}

impl Reader {
    /// The same for an object inside this one.
    pub(crate) fn inside(&self, key: &str) -> Reader {
        Reader { preset: self.preset.clone(), path: join(&self.path, key), head: self.head.clone() }
    }

    /// A number from the file or else from the grade; reports a missing one. NaN if it is faulty or missing.
    pub(crate) fn needed<T: Si + FromNode>(
        &self,
        r: &mut Resolver<'_>,
        option: &Opt<T>,
        of: impl Fn(&Preset) -> f64,
    ) -> f64 {
        match (&option.given, &self.preset) {
            (None, None) => self.missing(r, option, ""),
            (_, Some(preset)) => self.supplied(r, option, of(preset)),
            (Some(field), None) => r.number(field),
        }
    }

    /// A number from the file, or else this value of the grade.
    pub(crate) fn supplied<T: Si>(&self, r: &mut Resolver<'_>, option: &Opt<T>, value: f64) -> f64 {
        let source = match &self.preset {
            Some(preset) => format!("grade {}{}: {}", preset.name, preset.range, preset.source),
            None => String::new(),
        };
        let found = r.or_else(option, value, &shown::<T>(value, 4), &source);
        if let (Some(field), Some(preset)) = (&option.given, &self.preset)
            && (found / value - 1.0).abs() > UNLIKE
        {
            r.inconsistent(format!(
                "{} and the grade {} contradict each other: {} and {}",
                field.path,
                preset.name,
                field.text,
                shown::<T>(value, 4)
            ));
        }
        found
    }

    /// Reports a missing key.
    pub(crate) fn missing<T: FromNode>(&self, r: &mut Resolver<'_>, option: &Opt<T>, otherwise: &str) -> f64 {
        let key = option.key.name;
        // A misspelt key was already reported with this one as the suggestion.
        if !r.faults.suggest(&format!("did you mean `{key}`?")) {
            let field = Field::<T>::missing(self.head.clone(), option.path.clone());
            let message = format!("the key `{key}` is missing");
            let fault = range_fault(Code::MissingKey, &field, &message, &T::allowed());
            r.faults.push(fault.help(format!("add \"{key}\": {}{otherwise}", T::example())));
        }
        f64::NAN
    }
}

/// A value with so many digits and an engineer's unit.
pub(super) fn shown<T: Si>(value: f64, digits: usize) -> String {
    display_in(value, unit_for(value, T::DIMENSION), digits)
}

/// A stress in the unit in which a field gives it.
pub(super) fn like(field: &Field<Stress>, stress: f64) -> String {
    like_unit(field, stress, Stress::DIMENSION)
}
