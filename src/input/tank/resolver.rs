//! Typed mirror → values in SI: ranges, defaults with their source, the echo, remarks and warnings.
//!
//! A faulty value becomes NaN, so that no later check reports it again; a file with any fault does not give a case.

use files::code::{Code, Warning};
use tank::Shape;
use tank::case::Damping;
use tank::units::{Dimension, display_in, unit_for};

use super::read::{Field, FromNode, Opt, unit_of};
use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::AccelerationUnit;
use results::InputValue;
use tank::keys::{Absent, Limits, Whole};
use tank::value::Value;

/// A number with a dimension.
pub(in crate::input) trait Si: Copy {
    const DIMENSION: Dimension;
    /// Value in SI.
    fn si(self) -> f64;
}

/// How a value of a key is resolved: echoed, and within the limits of its key.
pub(in crate::input) trait Resolved: FromNode + Value {
    /// The value; `None` if it is faulty.
    fn resolve(field: &Field<Self>, r: &mut Resolver<'_>) -> Option<Self::Domain>;
    /// What stands for a faulty value that an object needs, so that the object is checked all the same.
    fn stand_in() -> Option<Self::Domain> {
        None
    }
}

/// Collects echo, remarks, warnings and faults.
pub(in crate::input) struct Resolver<'f> {
    pub faults: &'f mut Faults,
    pub echo: Vec<InputValue>,
    pub remarks: Vec<String>,
    pub warnings: Vec<Warning>,
    /// What keys resolved before say of others.
    pub known: Known,
}

/// What keys resolved before say of others.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::input) struct Known {
    /// Plan of the tank.
    pub shape: Option<Shape>,
    /// Overpressure in the tank [Pa].
    pub internal_pressure: f64,
    /// Damping ratios of the case.
    pub ratios: Option<Damping>,
}

impl<'f> Resolver<'f> {
    /// Without an echo.
    pub(crate) fn new(faults: &'f mut Faults) -> Resolver<'f> {
        Resolver { faults, echo: Vec::new(), remarks: Vec::new(), warnings: Vec::new(), known: Known::default() }
    }

    /// Echoes a value of the file.
    pub(crate) fn echo_given<T>(&mut self, field: &Field<T>) {
        if field.value.is_some() {
            self.echo_text(field);
        }
    }

    /// Echoes that a part is not there.
    pub(crate) fn echo_none(&mut self, field: &Field<()>) {
        self.echo_text(field);
    }

    fn echo_text<T>(&mut self, field: &Field<T>) {
        self.echo.push(InputValue {
            path: field.path.clone(),
            text: field.text.clone(),
            default: false,
            source: String::new(),
        });
    }

    /// Echoes a default.
    pub(crate) fn echo_default(&mut self, path: &str, text: &str, source: &str) {
        self.echo.push(InputValue { path: path.into(), text: text.into(), default: true, source: source.into() });
    }

    /// A number of the file, within the limits of its key; NaN if faulty.
    pub(crate) fn number<T: Si>(&mut self, field: &Field<T>) -> f64 {
        self.within(field, field.limits)
    }

    /// A number of the file, within these limits; NaN if faulty.
    pub(crate) fn within<T: Si>(&mut self, field: &Field<T>, limits: Limits) -> f64 {
        self.echo_given(field);
        let Some(value) = field.value else { return f64::NAN };
        if limits.values.is_empty() {
            if limits.hold(value.si()) {
                if let Some(usual) = limits.unusual(value.si(), T::DIMENSION) {
                    self.unusual(&field.path, &field.text, &usual);
                }
                return value.si();
            }
            let allowed = limits.describe(T::DIMENSION);
            let fault = range_fault(Code::OutOfRange, field, limits.message(value.si()), &allowed);
            self.faults.push(match meant_unit(field, limits, T::DIMENSION) {
                Some(meant) => fault.help(format!("did you mean \"{meant}\"?")),
                None => fault,
            });
            return f64::NAN;
        }
        // Equal decimal literals give equal doubles; the tolerance is for percentages.
        if let Some(found) = limits.values.iter().find(|a| (*a - value.si()).abs() <= 1e-12) {
            return *found;
        }
        let message = "not one of the values in the code";
        self.refuse(Code::OutOfRange, field, message, &limits.words());
        f64::NAN
    }

    /// Reports a fault about the value of a field.
    pub(in crate::input) fn refuse<T>(&mut self, code: Code, field: &Field<T>, message: &str, allowed: &str) {
        self.faults.push(range_fault(code, field, message, allowed));
    }

    /// Reports a key that an object does not have and needs.
    ///
    /// * `why`: rest of the message, or empty
    /// * `example`: what to add
    pub(in crate::input) fn missing<T, U, K>(
        &mut self,
        object: &Field<T>,
        option: &Opt<U, K>,
        why: &str,
        allowed: &str,
        example: &str,
    ) {
        let key = option.key.name;
        // A misspelt key was already reported with this one as the suggestion.
        if self.faults.suggest(&format!("did you mean `{key}`?")) {
            return;
        }
        let place = object.span.start..object.span.end.min(object.span.start + 1);
        let missing = Field::<()>::missing(place, option.path.clone());
        let message = format!("the key `{key}` is missing{why}");
        let fault = range_fault(Code::MissingKey, &missing, &message, allowed);
        self.faults.push(fault.help(format!("add \"{key}\": {example}")));
    }

    /// Reports a key that is given and does not apply.
    pub(in crate::input) fn inapplicable<T, K>(&mut self, option: &Opt<T, K>, message: &str, allowed: &str) {
        if let Some(given) = &option.given {
            self.refuse(Code::DoesNotApply, given, message, allowed);
        }
    }

    /// Adds a warning.
    pub(crate) fn warn(&mut self, code: Code, text: impl Into<String>) {
        self.warnings.push(Warning::new(code, text));
    }

    /// Warns of a value that is allowed and unusual.
    ///
    /// * `usual`: what is usual, in words
    pub(crate) fn unusual(&mut self, path: &str, found: &str, usual: &str) {
        self.warn(Code::UnusualInput, format!("{path}: unusual input; found {found}, {usual}"));
    }

    /// Warns of values of the file that contradict each other.
    pub(crate) fn inconsistent(&mut self, text: String) {
        self.warn(Code::Inconsistent, text);
    }

    /// A value, or its default; the default in place of a faulty one, but NaN of a number.
    pub(crate) fn or_default<T: Resolved + Copy>(&mut self, option: &Opt<T>) -> T::Domain {
        match &option.given {
            Some(field) => T::resolve(field, self).unwrap_or_else(|| default(option).domain()),
            None => self.default(option).domain(),
        }
    }

    /// A number of the file, or else this one.
    pub(crate) fn or_else<T: Si>(&mut self, option: &Opt<T>, value: f64, text: &str, source: &str) -> f64 {
        match &option.given {
            Some(field) => self.number(field),
            None => {
                self.echo_default(&option.path, text, source);
                value
            }
        }
    }

    /// A value, if it is in the file.
    pub(crate) fn optional<T: Resolved>(&mut self, option: &Opt<T>) -> Option<T::Domain> {
        match &option.given {
            Some(field) => T::resolve(field, self),
            None => {
                self.not_given(option);
                None
            }
        }
    }

    /// A whole number within the limits of its key.
    pub(crate) fn count(&mut self, field: &Field<Whole>) -> Option<u32> {
        self.echo_given(field);
        let Whole(n) = field.value?;
        let (limits, value) = (field.limits, f64::from(n));
        if limits.values.contains(&value) || (limits.values.is_empty() && limits.hold(value)) {
            return Some(n);
        }
        let fault = match limits.values {
            [] if limits.high.is_finite() => {
                let allowed = format!("a whole number from {} to {}", limits.low, limits.high);
                range_fault(Code::OutOfRange, field, "out of range", &allowed)
            }
            [] => range_fault(
                Code::OutOfRange,
                field,
                "out of range",
                &format!("a whole number of at least {}", limits.low),
            ),
            _ => range_fault(Code::OutOfRange, field, "not one of the values in the code", &limits.words()),
        };
        self.faults.push(fault);
        None
    }

    /// A text that is not blank.
    pub(crate) fn text(&mut self, field: &Field<String>) -> Option<String> {
        self.echo_given(field);
        let text = field.value.as_ref()?;
        if text.trim().is_empty() {
            self.refuse(Code::BadForm, field, "an empty text", "a text");
            return None;
        }
        Some(text.clone())
    }

    /// Echoes the absence of a key without a default.
    pub(crate) fn not_given<T, K>(&mut self, option: &Opt<T, K>) {
        if let Absent::Without(meaning) = &option.key.absent {
            self.echo_default(&option.path, "not given", meaning);
        }
    }

    /// The default of a key, echoed if its declaration gives a reason.
    fn default<T: FromNode + Copy>(&mut self, option: &Opt<T>) -> T {
        if let Absent::Value { value, shown, why } = option.key.absent
            && !why.is_empty()
        {
            match shown {
                "" => self.echo_default(&option.path, &value.written().unwrap_or_default(), why),
                shown => self.echo_default(&option.path, shown, why),
            }
        }
        default(option)
    }

    /// Reports a list with too many items.
    ///
    /// * `what`: items in words ("places")
    pub(crate) fn at_most<T>(&mut self, field: &Field<Vec<T>>, what: &str) {
        let (_, most) = field.limits.items;
        let found = field.value.as_ref().map_or(0, Vec::len);
        if found > most {
            let message = format!("too many {what}");
            let fault = range_fault(Code::ItemCount, field, &message, &format!("at most {most}"));
            self.faults.push(fault.found(format!("{found} {what}")));
        }
    }

    /// Whether a list has an allowed number of items; reports one that has not.
    ///
    /// * `what`: items in words ("courses")
    pub(crate) fn sized<T>(&mut self, field: &Field<Vec<T>>, what: &str) -> bool {
        let (fewest, most) = field.limits.items;
        let found = field.value.as_ref().map_or(fewest, Vec::len);
        let sound = (fewest..=most).contains(&found);
        if !sound {
            let message = format!("too few or too many {what}");
            let allowed = format!("{fewest} to {most} {what}");
            let fault = range_fault(Code::ItemCount, field, &message, &allowed);
            self.faults.push(fault.found(format!("{found} {what}")));
        }
        sound
    }
}

/// The default of a key.
fn default<T: FromNode + Copy>(option: &Opt<T>) -> T {
    match option.key.absent {
        Absent::Value { value, .. } => value,
        _ => unreachable!("`{}` is resolved as a key with a default and declared without one", option.path),
    }
}

/// The unit of the accelerations of records, as `--units` takes it.
pub(in crate::input) fn record_unit(r: &mut Resolver<'_>, option: &Opt<String>) -> Option<AccelerationUnit> {
    let field = option.given.as_ref()?;
    let unit = AccelerationUnit::parse(&r.text(field)?);
    if unit.is_none() {
        r.refuse(Code::UnitUnknown, field, "an unknown unit", AccelerationUnit::ALLOWED);
    }
    unit
}

/// A fault about the value of a field.
pub(in crate::input) fn range_fault<T>(code: Code, field: &Field<T>, message: &str, allowed: &str) -> Fault {
    let bare = field.text.is_empty() || field.text.parse::<f64>().is_ok() || field.text.parse::<bool>().is_ok();
    let found = if bare { field.text.clone() } else { format!("\"{}\"", field.text) };
    Fault::new(code, message).at(field.span.clone()).path(&field.path).found(found).allowed(allowed)
}

/// The same number in the unit of the key's example (of its dimension without one), if that is within the limits.
fn meant_unit<T>(field: &Field<T>, limits: Limits, dimension: Dimension) -> Option<String> {
    let unit = unit_of(field.example).or_else(|| unit_of(dimension.example()))?;
    let number = field.text.trim().trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.');
    let end = number.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '+' | '-')));
    let meant = format!("{} {unit}", number[..end.unwrap_or(number.len())].trim_end());
    let value = tank::units::parse(&meant, dimension).ok()?;
    (limits.hold(value) && meant != field.text.trim()).then_some(meant)
}

/// A length in the unit of a field, for messages that compare the two.
pub(in crate::input) fn like_field<T>(field: &Field<T>, length: f64) -> String {
    like_unit(field, length, Dimension::Length)
}

/// A value of this dimension in the unit of a field.
pub(in crate::input) fn like_unit<T>(field: &Field<T>, value: f64, dimension: Dimension) -> String {
    // The unit begins after the number and its exponent.
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-');
    let mut written = field.text.trim().trim_start_matches(number);
    if let Some(exponent) = written.strip_prefix(['e', 'E'])
        && exponent.starts_with(number)
    {
        written = exponent.trim_start_matches(number);
    }
    let unit = tank::units::Unit::find(written.trim(), dimension);
    display_in(value, unit.unwrap_or_else(|| unit_for(value, dimension)), 4)
}
