//! Mirror of the file → case in SI: ranges, references, cross-checks, defaults with their source, and the echo.
//!
//! A faulty value is NaN from there on: no check objects to it a second time, and a file with any fault gives no case.

mod grades;
mod materials;
mod nonlinear;
mod options;
mod places;
mod plausible;
mod site;
mod tank;
mod wall;

use ::tank::case::Case;
use ::tank::units::{Dimension, display_in, in_unit, unit_for};

pub use places::Places;

use super::read::Field;
use super::schema;
use super::values::{Acceleration, Si};
use crate::input::TankFile;
use crate::input::diagnostic::{Fault, Faults, Source};
use results::InputValue;

/// Resolves the file; `None` (or any fault) if it gives no case.
pub(super) fn resolve(file: &schema::TankFile, faults: &mut Faults) -> Option<TankFile> {
    let mut r = Resolver {
        faults,
        echo: Vec::new(),
        remarks: Vec::new(),
        warnings: Vec::new(),
    };
    let name = r.text(&file.name);
    if let Some(notes) = &file.notes {
        r.echo_given(notes);
    }
    let gravity = r.or_default(
        "gravity",
        &file.gravity,
        Limits::from(0.1).to(100.0),
        Acceleration(::tank::STANDARD_GRAVITY),
        "9.80665 m/s2",
        "standard gravity, ISO 80000-3",
    );
    let materials = materials::materials(&mut r, &file.materials);
    let tank = tank::tank(&mut r, &file.tank, &materials);
    let liquid = tank::liquid(&mut r, &file.liquid);
    tank::cross_checks(&mut r, file, tank.as_ref(), liquid);
    plausible::tank(&mut r, file, tank.as_ref(), liquid);
    tank::unused(&mut r, file);
    let record = options::record(&mut r, &file.record);
    let damping = options::damping(&mut r, &file.damping, tank.as_ref());
    let site = site::site(&mut r, &file.site);
    let (procedures, run) = options::procedures(&mut r, &file.procedures);
    let fe = options::analysis(&mut r, &file.analysis, tank.as_ref());
    let solid = options::solid(&mut r, &file.analysis);
    let nonlinear = nonlinear::nonlinear(&mut r, &file.analysis, tank.as_ref(), damping);
    let measured = options::measured(&mut r, &file.measured);
    let published = options::published(&mut r, &file.published);
    let (echo, remarks, warnings) = (r.echo, r.remarks, r.warnings);
    Some(TankFile {
        case: Case {
            name: name?,
            tank: tank?,
            liquid: liquid?,
            gravity,
            ground_motion: None,
            damping,
            site,
            procedures,
            measured,
            published,
        },
        record,
        echo,
        procedures: run,
        fe,
        solid,
        nonlinear,
        remarks,
        warnings,
        sha256: String::new(),
        source: Source::new("", ""),
        places: Places::of(file),
    })
}

/// Collects the echo, the remarks, the warnings and the faults on the way.
struct Resolver<'f> {
    faults: &'f mut Faults,
    echo: Vec<InputValue>,
    remarks: Vec<String>,
    warnings: Vec<String>,
}

impl Resolver<'_> {
    /// Echo of a value that the file gives.
    fn echo_given<T>(&mut self, field: &Field<T>) {
        if field.value.is_some() {
            self.echo.push(InputValue {
                path: field.path.clone(),
                text: field.text.clone(),
                default: false,
                source: String::new(),
            });
        }
    }

    /// Echo of a value that the file does not give.
    fn echo_default(&mut self, path: &str, text: &str, source: &str) {
        self.echo.push(InputValue {
            path: path.into(),
            text: text.into(),
            default: true,
            source: source.into(),
        });
    }

    /// A required number within limits, NaN if faulty.
    fn number<T: Si>(&mut self, field: &Field<T>, limits: Limits) -> f64 {
        self.echo_given(field);
        let Some(value) = field.value else {
            return f64::NAN;
        };
        if limits.hold(value.si()) {
            return value.si();
        }
        self.faults.push(range_fault(
            field,
            limits.message(value.si()),
            &limits.describe(T::DIMENSION),
        ));
        f64::NAN
    }

    /// A number within limits, or what holds if the file does not give it.
    fn or_default<T: Si>(
        &mut self,
        path: &str,
        field: &Option<Field<T>>,
        limits: Limits,
        default: T,
        text: &str,
        source: &str,
    ) -> f64 {
        match field {
            Some(field) => self.number(field, limits),
            None => {
                self.echo_default(path, text, source);
                default.si()
            }
        }
    }

    /// A number within limits, if the file gives it; `absent` says what its absence means.
    fn optional<T: Si>(&mut self, path: &str, field: &Option<Field<T>>, limits: Limits, absent: &str) -> Option<f64> {
        match field {
            Some(field) => Some(self.number(field, limits)),
            None => {
                self.echo_default(path, "not given", absent);
                None
            }
        }
    }

    /// One of a few numbers.
    fn one_of<T: Si>(&mut self, field: &Field<T>, allowed: &[f64]) -> f64 {
        self.echo_given(field);
        let Some(value) = field.value else {
            return f64::NAN;
        };
        // Decimal literals of the same number are the same double; the slack is for percentages.
        if let Some(found) = allowed.iter().find(|a| (*a - value.si()).abs() <= 1e-12) {
            return *found;
        }
        let words: Vec<String> = allowed.iter().map(f64::to_string).collect();
        let words = super::read::list(&words.iter().map(String::as_str).collect::<Vec<_>>(), "or");
        self.faults
            .push(range_fault(field, "not one of the values the code knows", &words));
        f64::NAN
    }

    /// A text that is not blank.
    fn text(&mut self, field: &Field<String>) -> Option<String> {
        self.echo_given(field);
        let text = field.value.as_ref()?;
        if text.trim().is_empty() {
            self.faults.push(range_fault(field, "an empty text", "a text"));
            return None;
        }
        Some(text.clone())
    }

    /// A choice, or what holds if the file does not give it.
    fn choice<T: Copy>(&mut self, path: &str, field: &Option<Field<T>>, default: T, text: &str, source: &str) -> T {
        match field {
            Some(field) => {
                self.echo_given(field);
                field.value.unwrap_or(default)
            }
            None => {
                self.echo_default(path, text, source);
                default
            }
        }
    }
}

/// A fault about the value of a field.
fn range_fault<T>(field: &Field<T>, message: &str, allowed: &str) -> Fault {
    let bare = field.text.is_empty() || field.text.parse::<f64>().is_ok() || field.text.parse::<bool>().is_ok();
    let found = if bare {
        field.text.clone()
    } else {
        format!("\"{}\"", field.text)
    };
    Fault::new(message)
        .at(field.span.clone())
        .path(&field.path)
        .found(found)
        .allowed(allowed)
}

/// Range of a number in SI.
#[derive(Clone, Copy, Debug)]
struct Limits {
    low: f64,
    low_allowed: bool,
    high: f64,
    high_allowed: bool,
}

impl Limits {
    /// Greater than this.
    const fn above(low: f64) -> Limits {
        Limits {
            low,
            low_allowed: false,
            high: f64::INFINITY,
            high_allowed: false,
        }
    }

    /// This or greater.
    const fn from(low: f64) -> Limits {
        Limits {
            low_allowed: true,
            ..Limits::above(low)
        }
    }

    /// And at most this.
    const fn to(self, high: f64) -> Limits {
        Limits {
            high,
            high_allowed: true,
            ..self
        }
    }

    /// And less than this.
    const fn below(self, high: f64) -> Limits {
        Limits {
            high,
            high_allowed: false,
            ..self
        }
    }

    fn hold(self, value: f64) -> bool {
        let low = if self.low_allowed {
            value >= self.low
        } else {
            value > self.low
        };
        let high = if self.high_allowed {
            value <= self.high
        } else {
            value < self.high
        };
        low && high
    }

    /// What is wrong with a value that does not hold.
    fn message(self, value: f64) -> &'static str {
        match (value <= self.low, self.low == 0.0) {
            (true, true) if self.low_allowed => "this must not be negative",
            (true, true) => "this must be positive",
            (true, false) if self.low_allowed && self.low > 0.0 && value <= 0.0 => "this must be positive",
            (true, false) => "too small",
            (false, _) => "too large",
        }
    }

    /// In words: "a length greater than 0, at most 1000 m".
    fn describe(self, dimension: Dimension) -> String {
        let show = |limit: f64| {
            let unit = unit_for(limit, dimension);
            if limit == 0.0 {
                "0".to_string()
            } else {
                plain(in_unit(limit, unit), unit.text)
            }
        };
        let noun = if dimension == Dimension::Dimensionless {
            "a number"
        } else {
            dimension.noun()
        };
        let low = if self.low_allowed { "at least" } else { "greater than" };
        let mut text = format!("{noun} {low} {}", show(self.low));
        if self.high.is_finite() {
            let high = if self.high_allowed { "at most" } else { "less than" };
            text.push_str(&format!(", {high} {}", show(self.high)));
        }
        text
    }
}

/// A number as short as it goes, with its unit.
fn plain(number: f64, unit: &str) -> String {
    let text = format!("{number}");
    if unit.is_empty() {
        text
    } else {
        format!("{text} {unit}")
    }
}

/// A length in the unit in which a field gives it, for messages that compare the two.
fn like_field<T>(field: &Field<T>, length: f64) -> String {
    like_unit(field, length, Dimension::Length)
}

/// A value of this dimension in the unit in which a field gives it.
fn like_unit<T>(field: &Field<T>, value: f64, dimension: Dimension) -> String {
    // The unit begins after the number and its exponent.
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-');
    let mut written = field.text.trim().trim_start_matches(number);
    if let Some(exponent) = written.strip_prefix(['e', 'E'])
        && exponent.starts_with(number)
    {
        written = exponent.trim_start_matches(number);
    }
    let unit = ::tank::units::Unit::find(written.trim(), dimension);
    display_in(value, unit.unwrap_or_else(|| unit_for(value, dimension)), 4)
}
