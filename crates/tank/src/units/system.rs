//! Systems of units for print: the one table quantity → unit.

use std::cell::Cell;
use std::marker::PhantomData;

use super::print::si_unit_for;
use super::{Dimension as D, Unit};
use crate::words;

words! {
    /// Units of a report.
    pub System: Si {
        /// SI: mm, m, kg, t, kN, MN, kPa, MPa.
        Si = "si",
        /// US customary: in, ft, lb, klb (1000 lb), lbf, kip, psf, psi, ksi.
        Us = "us",
        /// SI with US customary units in brackets.
        Both = "both",
    }
}

/// Units of US customary print: for each dimension in ascending order, each with the value from which on it is
/// chosen, in that unit. Dimensions that are not listed keep SI (time, frequency, angle).
///
/// Lengths below 3 ft are in inches. Pressures are in psf up to 10 psi, stresses in psi up to 1 ksi. Masses are in lb
/// and, from 10 000 lb on, in klb (1000 lb).
const US: &[(D, &[(&str, f64)])] = &[
    (D::Length, &[("in", 0.0), ("ft", 3.0)]),
    (D::Mass, &[("lb", 0.0), ("klb", 10.0)]),
    (D::Density, &[("lb/ft3", 0.0)]),
    (D::Velocity, &[("in/s", 0.0), ("ft/s", 3.0)]),
    (D::Acceleration, &[("ft/s2", 0.0)]),
    (D::Force, &[("lbf", 0.0), ("kip", 1.0)]),
    (D::Moment, &[("lbf*ft", 0.0), ("kip*ft", 1.0)]),
    (D::Stress, &[("psf", 0.0), ("psi", 10.0), ("ksi", 1.0)]),
    (D::LineForce, &[("lbf/ft", 0.0), ("kip/ft", 1.0)]),
    (D::LineMoment, &[("lbf*ft/ft", 0.0), ("kip*ft/ft", 1.0)]),
    (D::Energy, &[("ft*lbf", 0.0), ("ft*kip", 1.0)]),
    (D::LineArea, &[("in2/ft", 0.0)]),
    (D::Temperature, &[("degF", 0.0)]),
    (D::Curvature, &[("rad/ft", 0.0)]),
    (D::Subgrade, &[("lb/in3", 0.0)]),
    (D::RotationalStiffness, &[("lbf*ft/rad", 0.0), ("kip*ft/rad", 1.0)]),
    (D::Dashpot, &[("lbf*s/ft", 0.0), ("kip*s/ft", 1.0)]),
    (D::RotationalDashpot, &[("lbf*ft*s/rad", 0.0), ("kip*ft*s/rad", 1.0)]),
    (D::RotationalInertia, &[("lb*ft2", 0.0), ("klb*ft2", 10.0)]),
    (D::Area, &[("in2", 0.0)]),
    (D::SecondMoment, &[("in4", 0.0)]),
    (D::AreaMass, &[("lb/ft2", 0.0)]),
];

/// The US customary units of a dimension; empty where it keeps SI.
fn us(dimension: D) -> &'static [(&'static str, f64)] {
    US.iter().find(|(d, _)| *d == dimension).map_or(&[], |(_, units)| units)
}

thread_local! {
    static CURRENT: Cell<System> = const { Cell::new(System::Si) };
    static PREFERRED: Cell<Option<&'static Unit>> = const { Cell::new(None) };
}

/// While it lives, print of this thread has one unit for all values of its dimension, in every system; then as before.
///
/// ```
/// use tank::units::{Dimension, Preferred, Unit, display};
/// let g = Preferred::of(Unit::find("g", Dimension::Acceleration));
/// assert_eq!(display(9.80665, Dimension::Acceleration), "1.00 g");
/// drop(g);
/// assert_eq!(display(9.80665, Dimension::Acceleration), "9.81 m/s²");
/// ```
#[derive(Debug)]
pub struct Preferred {
    former: Option<&'static Unit>,
    /// As [`Scope::here`].
    here: PhantomData<*const ()>,
}

impl Preferred {
    /// Print in `unit` from here on; none for the usual unit.
    #[must_use]
    pub fn of(unit: Option<&'static Unit>) -> Preferred {
        Preferred { former: PREFERRED.replace(unit), here: PhantomData }
    }
}

impl Drop for Preferred {
    fn drop(&mut self) {
        PREFERRED.set(self.former);
    }
}

/// The unit that print prefers for a dimension.
fn preferred(dimension: D) -> Option<&'static Unit> {
    PREFERRED.get().filter(|unit| unit.dimension == dimension)
}

/// While it lives, print of this thread is in its system; then in the former one.
///
/// ```
/// use tank::units::{Dimension, Scope, System, display};
/// assert_eq!(display(0.3048, Dimension::Length), "305 mm");
/// let scope = Scope::of(System::Us);
/// assert_eq!(display(0.3048, Dimension::Length), "12.0 in");
/// drop(scope);
/// assert_eq!(display(0.3048, Dimension::Length), "305 mm");
/// ```
#[derive(Debug)]
pub struct Scope {
    former: System,
    /// A scope ends in the thread that it began in.
    here: PhantomData<*const ()>,
}

impl Scope {
    /// Print in `system` from here on.
    #[must_use]
    pub fn of(system: System) -> Scope {
        Scope { former: CURRENT.replace(system), here: PhantomData }
    }
}

impl Drop for Scope {
    fn drop(&mut self) {
        CURRENT.set(self.former);
    }
}

impl System {
    /// The system that print of this thread is in.
    pub fn current() -> System {
        CURRENT.get()
    }

    /// The system of the numbers before the brackets: SI or US.
    pub fn first(self) -> System {
        match self {
            System::Both => System::Si,
            one => one,
        }
    }

    /// The system within the brackets, if there are any.
    pub fn second(self) -> Option<System> {
        (self == System::Both).then_some(System::Us)
    }

    /// Whether values of this dimension have other units than in SI.
    pub fn differs(self, dimension: D) -> bool {
        self != System::Si && !us(dimension).is_empty() && preferred(dimension).is_none()
    }

    /// The usual unit of this value (SI) in the system; [`System::Both`] has that of SI.
    pub fn unit_for(self, value: f64, dimension: D) -> &'static Unit {
        if let Some(unit) = preferred(dimension) {
            return unit;
        }
        let units = us(dimension);
        if self != System::Us || units.is_empty() {
            return si_unit_for(value, dimension);
        }
        let find = |text: &str| Unit::find(text, dimension).unwrap_or_else(|| dimension.si_unit());
        let reached = |(text, from): &&(&str, f64)| {
            let threshold = from * find(text).factor();
            value.is_finite() && value.abs() >= threshold * (1.0 - 1e-12)
        };
        let chosen = units.iter().rev().find(reached).or(units.first());
        chosen.map_or_else(|| dimension.si_unit(), |(text, _)| find(text))
    }

    /// One unit for a whole column of values (SI): that of its largest absolute value.
    pub fn column_unit(self, values: impl IntoIterator<Item = f64>, dimension: D) -> &'static Unit {
        let peak = values.into_iter().filter(|v| v.is_finite()).fold(0.0_f64, |m, v| m.max(v.abs()));
        self.unit_for(peak, dimension)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{UNITS, display, in_unit};
    use super::*;

    /// Definitions: international yard and pound agreement of 1959, standard gravity 9.80665 m/s²; NIST SP 811, appendix B.
    #[test]
    fn factors_by_definition() {
        let (inch, foot, pound, lbf): (f64, f64, f64, f64) = (0.0254, 0.3048, 0.453_592_37, 4.448_221_615_260_5);
        for (text, dimension, factor) in [
            ("in", D::Length, inch),
            ("ft", D::Length, foot),
            ("lb", D::Mass, pound),
            ("klb", D::Mass, 453.592_37),
            ("lb/ft3", D::Density, pound / foot.powi(3)),
            ("in/s", D::Velocity, inch),
            ("ft/s", D::Velocity, foot),
            ("ft/s2", D::Acceleration, foot),
            ("lbf", D::Force, lbf),
            ("kip", D::Force, 4_448.221_615_260_5),
            ("lbf*ft", D::Moment, 1.355_817_948_331_400_4),
            ("kip*ft", D::Moment, 1_355.817_948_331_400_4),
            ("psf", D::Stress, lbf / foot.powi(2)),
            ("psi", D::Stress, lbf / inch.powi(2)),
            ("ksi", D::Stress, 1e3 * lbf / inch.powi(2)),
            ("lbf/ft", D::LineForce, lbf / foot),
            ("kip/ft", D::LineForce, 1e3 * lbf / foot),
            ("lbf*ft/ft", D::LineMoment, lbf),
            ("kip*ft/ft", D::LineMoment, 1e3 * lbf),
            ("ft*lbf", D::Energy, 1.355_817_948_331_400_4),
            ("ft*kip", D::Energy, 1_355.817_948_331_400_4),
            ("in2/ft", D::LineArea, inch * inch / foot),
            ("degF", D::Temperature, 5.0 / 9.0),
            ("rad/ft", D::Curvature, 1.0 / foot),
            ("lb/in3", D::Subgrade, lbf / inch.powi(3)),
            ("lbf*ft/rad", D::RotationalStiffness, 1.355_817_948_331_400_4),
            ("kip*ft/rad", D::RotationalStiffness, 1_355.817_948_331_400_4),
            ("lbf*s/ft", D::Dashpot, lbf / foot),
            ("kip*s/ft", D::Dashpot, 1e3 * lbf / foot),
            ("lbf*ft*s/rad", D::RotationalDashpot, 1.355_817_948_331_400_4),
            ("kip*ft*s/rad", D::RotationalDashpot, 1_355.817_948_331_400_4),
            ("lb*ft2", D::RotationalInertia, pound * foot * foot),
            ("klb*ft2", D::RotationalInertia, 1e3 * pound * foot * foot),
            ("in2", D::Area, inch * inch),
            ("in4", D::SecondMoment, inch.powi(4)),
            ("lb/ft2", D::AreaMass, pound / (foot * foot)),
        ] {
            let unit = Unit::find(text, dimension).unwrap();
            // Products of a few factors: a few units in the last place.
            assert!((unit.factor() / factor - 1.0).abs() < 1e-15, "{text}: {}", unit.factor());
        }
        // All of the table are among them, by its own spelling.
        for (dimension, units) in US {
            for (text, _) in *units {
                assert!(UNITS.iter().any(|u| u.text == *text && u.dimension == *dimension), "{text}");
            }
        }
    }

    /// Numbers of API 650 practice: a 200 ft tank, a plate of 1¼ in, 36 ksi steel, 62.4 lb/ft³ water.
    #[test]
    fn us_print() {
        let _scope = Scope::of(System::Us);
        for (value, dimension, text) in [
            (60.96, D::Length, "200 ft"),
            (0.031_75, D::Length, "1.25 in"),
            (0.9, D::Length, "35.4 in"),
            (0.9144, D::Length, "3.00 ft"),
            (1000.0, D::Density, "62.4 lb/ft³"),
            (248.2e6, D::Stress, "36.0 ksi"),
            (20e3, D::Stress, "418 psf"),
            (93.333_333_333_333_33, D::Temperature, "200 °F"),
            (0.0, D::Temperature, "32.0 °F"),
            (100e3, D::Stress, "14.5 psi"),
            (4_448.221_615_260_5, D::Force, "1.00 kip"),
            (9.806_65, D::Acceleration, "32.2 ft/s²"),
            (0.5, D::Time, "0.500 s"),
            (0.0, D::Force, "0 lbf"),
        ] {
            assert_eq!(display(value, dimension), text);
        }
    }

    #[test]
    fn both_in_brackets_where_they_differ() {
        let _scope = Scope::of(System::Both);
        assert_eq!(display(0.137, D::Length), "137 mm (5.39 in)");
        assert_eq!(display(2.0, D::Time), "2.00 s");
        assert_eq!(System::Us.column_unit([0.1, -3.0, f64::NAN], D::Length).text, "ft");
        assert_eq!(in_unit(0.3048, System::Us.unit_for(3.0, D::Length)), 1.0);
    }
}
