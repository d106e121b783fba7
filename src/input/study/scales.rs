//! `scales`: levels of an intensity measure, or factors.

use files::code::Code;
use oscillator::intensity::Intensity;
use tank::units::{self, Dimension, Unit};

use super::keys;
use crate::input::tank::read::Opt;
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::unit_code;
use results::EngineId;

/// Damping ratio of a spectral measure that does not give it.
const DAMPING: f64 = 0.05;

/// Period of a spectral measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Period {
    /// The same for all tanks [s].
    Given(f64),
    /// First impulsive period of the tank.
    Impulsive,
    /// First sloshing period of the tank.
    Sloshing,
}

/// An intensity measure, whose period may be that of each tank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// A measure of the record alone.
    Plain(Intensity),
    /// Pseudo-acceleration, or its average.
    Spectral {
        /// Period.
        period: Period,
        /// Damping ratio.
        damping: f64,
        /// Whether the average from 0.2 T to 3 T.
        average: bool,
    },
}

/// Scales of every record.
#[derive(Clone, Debug, PartialEq)]
pub struct Scales {
    /// The measure.
    pub axis: Axis,
    /// Its name, as given.
    pub name: String,
    /// Levels of the measure in SI; empty for factors.
    pub levels: Vec<f64>,
    /// Unit in which all levels are given; none of different units and of factors.
    pub unit: Option<&'static str>,
    /// Factors on the records; empty for levels.
    pub factors: Vec<f64>,
}

impl Axis {
    /// Dimension of its levels.
    pub fn dimension(self) -> Dimension {
        match self {
            Axis::Plain(Intensity::Pgv) => Dimension::Velocity,
            Axis::Plain(Intensity::Pgd) => Dimension::Length,
            _ => Dimension::Acceleration,
        }
    }

    /// Whether it needs periods of the tank.
    pub fn of_the_tank(self) -> bool {
        matches!(self, Axis::Spectral { period: Period::Impulsive | Period::Sloshing, .. })
    }

    /// The measure for a tank.
    ///
    /// * `periods`: impulsive and sloshing period [s], where known
    pub fn intensity(self, periods: [Option<f64>; 2]) -> Option<Intensity> {
        let Axis::Spectral { period, damping, average } = self else {
            let Axis::Plain(plain) = self else { return None };
            return Some(plain);
        };
        let period = match period {
            Period::Given(period) => period,
            Period::Impulsive => periods[0]?,
            Period::Sloshing => periods[1]?,
        };
        Some(if average { Intensity::AverageSa { period, damping } } else { Intensity::Sa { period, damping } })
    }

    /// `PGA`, `Sa(0.3 s)`, `Sa(Ti, 5 %)`, `AvgSa(Tc, 0.5 %)`.
    pub fn parse(text: &str) -> Option<Axis> {
        let bare: String = text.trim().to_owned();
        match bare.to_ascii_lowercase().as_str() {
            "pga" => return Some(Axis::Plain(Intensity::Pga)),
            "pgv" => return Some(Axis::Plain(Intensity::Pgv)),
            "pgd" => return Some(Axis::Plain(Intensity::Pgd)),
            _ => {}
        }
        let (word, rest) = bare.split_once('(')?;
        let average = match word.trim().to_ascii_lowercase().as_str() {
            "sa" => false,
            "avgsa" => true,
            _ => return None,
        };
        let inner = rest.strip_suffix(')')?;
        let (period, damping) = match inner.split_once(',') {
            Some((period, damping)) => {
                let damping = units::parse(damping, Dimension::Dimensionless).ok()?;
                (period, damping)
            }
            None => (inner, DAMPING),
        };
        let period = match period.trim() {
            "Ti" => Period::Impulsive,
            "Tc" => Period::Sloshing,
            given => Period::Given(units::parse(given, Dimension::Time).ok().filter(|t| *t > 0.0 && *t <= 100.0)?),
        };
        (0.0..1.0).contains(&damping).then_some(Axis::Spectral { period, damping, average })
    }
}

/// The scales of the file; none if they are faulty.
pub(super) fn scales(r: &mut Resolver<'_>, option: &Opt<keys::Scales>) -> Option<Scales> {
    let given = option.or_absent()?;
    let (mut axis, mut name) = (Axis::Plain(Intensity::Pga), "PGA".to_owned());
    if let Some(field) = &given.im.given {
        name = r.text(field)?;
        let Some(found) = Axis::parse(&name) else {
            let allowed = "PGA, PGV, PGD, Sa(T), Sa(T, xi), AvgSa(T) or AvgSa(T, xi), with T such as 0.3 s, Ti or Tc";
            r.refuse(Code::UnknownChoice, field, "an unknown intensity measure", allowed);
            return None;
        };
        axis = found;
    }
    let (mut levels, mut factors) = (Vec::new(), Vec::new());
    let mut written = Vec::new();
    match (&given.levels.given, &given.factors.given) {
        (Some(levels), Some(_)) => {
            let message = "levels and factors exclude each other";
            r.refuse(Code::Exclusive, levels, message, "one of them");
            return None;
        }
        (Some(field), None) => {
            r.sized(field, "levels");
            let dimension = axis.dimension();
            for item in field.value.iter().flatten() {
                let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+');
                written.push(Unit::find(item.text.trim().trim_start_matches(number), dimension).map(|unit| unit.text));
                match units::parse(&r.text(item)?, dimension) {
                    Ok(level) if level > 0.0 => ascending(r, item, &mut levels, level),
                    Ok(_) => r.refuse(Code::OutOfRange, item, "a level of 0 or less", &dimension.allowed()),
                    Err(error) => r.refuse(unit_code(&error), item, &error.to_string(), &dimension.allowed()),
                }
            }
        }
        (None, Some(field)) => {
            r.sized(field, "factors");
            for item in field.value.iter().flatten() {
                let factor = r.within(item, field.limits);
                ascending(r, item, &mut factors, factor);
            }
        }
        (None, None) => factors.push(1.0),
    }
    Some(Scales {
        axis,
        name,
        levels,
        unit: match written.as_slice() {
            [Some(first), rest @ ..] if rest.iter().all(|unit| *unit == Some(*first)) => Some(*first),
            _ => None,
        },
        factors,
    })
}

fn ascending<T>(r: &mut Resolver<'_>, item: &crate::input::tank::read::Field<T>, all: &mut Vec<f64>, value: f64) {
    if all.last().is_some_and(|last| *last >= value) {
        let message = "not in ascending order";
        r.refuse(Code::Repeated, item, message, "each value once, ascending");
    }
    all.push(value);
}

/// Reports a measure at periods of the tank without the engine that gives them.
pub(super) fn admit(r: &mut Resolver<'_>, option: &Opt<keys::Scales>, engine: Option<EngineId>) {
    let field = option.value().and_then(|scales| scales.im.given.as_ref());
    if let Some(field) = field
        && field.value.as_ref().and_then(|text| Axis::parse(text)).is_some_and(Axis::of_the_tank)
        && engine != Some(EngineId::Harmonic)
    {
        let message = "Ti and Tc are periods of the harmonic engine";
        let allowed = "\"engine\": \"harmonic\", or a period in seconds";
        r.refuse(Code::DoesNotApply, field, message, allowed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures() {
        let sa = |period, damping, average| Some(Axis::Spectral { period, damping, average });
        assert_eq!(Axis::parse("pgv"), Some(Axis::Plain(Intensity::Pgv)));
        assert_eq!(Axis::parse("Sa(0.3 s)"), sa(Period::Given(0.3), 0.05, false));
        assert_eq!(Axis::parse("Sa(Tc, 0.5 %)"), sa(Period::Sloshing, 0.005, false));
        assert_eq!(Axis::parse("AvgSa(Ti)"), sa(Period::Impulsive, 0.05, true));
        for wrong in ["", "Sa", "Sa()", "Sa(0.3)", "Sa(-1 s)", "Sv(1 s)", "Sa(1 s, 120 %)"] {
            assert_eq!(Axis::parse(wrong), None, "{wrong}");
        }
    }
}
