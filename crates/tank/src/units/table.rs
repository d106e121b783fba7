//! The table of units.

use std::sync::LazyLock;

use super::Dimension as D;
use crate::STANDARD_GRAVITY;

/// Ratio of a unit to the SI unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Scale {
    /// Power of ten.
    Ten(i32),
    /// Any other factor.
    Factor(f64),
    /// A factor, and the value in SI of its zero.
    Shifted(f64, f64),
}

/// A unit of measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Symbol for print (`kN·m`, `kg/m³`).
    pub symbol: &'static str,
    /// Symbol in ASCII, as in input files and messages (`kNm`, `kg/m3`).
    pub text: &'static str,
    /// Other spellings that are read.
    aliases: &'static [&'static str],
    /// Dimension.
    pub dimension: D,
    pub(super) scale: Scale,
    /// Whether [`display`](super::display) may choose it.
    pub(super) shown: bool,
}

const fn unit(symbol: &'static str, text: &'static str, dimension: D, scale: Scale, shown: bool) -> Unit {
    Unit { symbol, text, aliases: &[], dimension, scale, shown }
}

/// A power of ten that [`display`](super::display) may choose.
const fn ten(symbol: &'static str, text: &'static str, dimension: D, exponent: i32) -> Unit {
    unit(symbol, text, dimension, Scale::Ten(exponent), true)
}

/// A power of ten that is read but not chosen.
const fn read(symbol: &'static str, text: &'static str, dimension: D, exponent: i32) -> Unit {
    unit(symbol, text, dimension, Scale::Ten(exponent), false)
}

/// Any other factor, read but not chosen.
const fn by(symbol: &'static str, text: &'static str, dimension: D, factor: f64) -> Unit {
    unit(symbol, text, dimension, Scale::Factor(factor), false)
}

const fn also(unit: Unit, aliases: &'static [&'static str]) -> Unit {
    Unit { aliases, ..unit }
}

// Exact by definition: inch and pound (international yard and pound agreement, 1959), standard gravity (CGPM 1901).
pub(super) const INCH: f64 = 0.0254;
pub(super) const FOOT: f64 = 0.3048;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * STANDARD_GRAVITY;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

/// All units. Within a dimension the units chosen by print ascend.
pub const UNITS: &[Unit] = &[
    ten("", "", D::Dimensionless, 0),
    read("%", "%", D::Dimensionless, -2),
    // length
    ten("mm", "mm", D::Length, -3),
    read("cm", "cm", D::Length, -2),
    ten("m", "m", D::Length, 0),
    also(by("in", "in", D::Length, INCH), &["inch", "inches", "″"]),
    also(by("ft", "ft", D::Length, FOOT), &["foot", "feet", "′"]),
    // time
    read("ms", "ms", D::Time, -3),
    also(ten("s", "s", D::Time, 0), &["sec"]),
    // mass
    read("g", "g", D::Mass, -3),
    ten("kg", "kg", D::Mass, 0),
    also(ten("t", "t", D::Mass, 3), &["Mg", "tonne", "tonnes"]),
    also(by("lb", "lb", D::Mass, POUND), &["lbm", "lbs"]),
    by("klb", "klb", D::Mass, 1000.0 * POUND),
    // density
    ten("kg/m³", "kg/m3", D::Density, 0),
    read("t/m³", "t/m3", D::Density, 3),
    also(read("g/cm³", "g/cm3", D::Density, 3), &["g/ml", "kg/l", "kg/L", "kg/dm3"]),
    // Specific gravity: over that of water, 1000 kg/m³, the G of API 650.
    read("SG", "SG", D::Density, 3),
    also(by("lb/ft³", "lb/ft3", D::Density, POUND / (FOOT * FOOT * FOOT)), &["lbm/ft3", "pcf"]),
    // velocity
    read("mm/s", "mm/s", D::Velocity, -3),
    read("cm/s", "cm/s", D::Velocity, -2),
    ten("m/s", "m/s", D::Velocity, 0),
    by("in/s", "in/s", D::Velocity, INCH),
    by("ft/s", "ft/s", D::Velocity, FOOT),
    // acceleration
    also(ten("m/s²", "m/s2", D::Acceleration, 0), &["m/s/s"]),
    also(read("cm/s²", "cm/s2", D::Acceleration, -2), &["cm/s/s"]),
    also(read("gal", "gal", D::Acceleration, -2), &["Gal"]),
    also(read("mm/s²", "mm/s2", D::Acceleration, -3), &["mm/s/s"]),
    by("g", "g", D::Acceleration, STANDARD_GRAVITY),
    by("in/s²", "in/s2", D::Acceleration, INCH),
    by("ft/s²", "ft/s2", D::Acceleration, FOOT),
    // frequency, circular frequency, angle
    ten("Hz", "Hz", D::Frequency, 0),
    read("kHz", "kHz", D::Frequency, 3),
    ten("rad/s", "rad/s", D::AngularFrequency, 0),
    ten("rad", "rad", D::Angle, 0),
    also(by("°", "deg", D::Angle, std::f64::consts::PI / 180.0), &["degree", "degrees"]),
    // force
    ten("N", "N", D::Force, 0),
    ten("kN", "kN", D::Force, 3),
    ten("MN", "MN", D::Force, 6),
    by("lbf", "lbf", D::Force, POUND_FORCE),
    also(by("kip", "kip", D::Force, 1000.0 * POUND_FORCE), &["kips"]),
    by("kgf", "kgf", D::Force, STANDARD_GRAVITY),
    // moment
    ten("N·m", "Nm", D::Moment, 0),
    ten("kN·m", "kNm", D::Moment, 3),
    ten("MN·m", "MNm", D::Moment, 6),
    read("N·mm", "Nmm", D::Moment, -3),
    also(by("lbf·ft", "lbf*ft", D::Moment, POUND_FORCE * FOOT), &["ft·lbf"]),
    also(by("kip·ft", "kip*ft", D::Moment, 1000.0 * POUND_FORCE * FOOT), &["ft·kip"]),
    // stress
    also(ten("Pa", "Pa", D::Stress, 0), &["N/m2"]),
    ten("kPa", "kPa", D::Stress, 3),
    read("kN/m²", "kN/m2", D::Stress, 3),
    read("mbar", "mbar", D::Stress, 2),
    ten("MPa", "MPa", D::Stress, 6),
    also(read("N/mm²", "N/mm2", D::Stress, 6), &["MN/m2"]),
    read("kN/cm²", "kN/cm2", D::Stress, 7),
    ten("GPa", "GPa", D::Stress, 9),
    read("kN/mm²", "kN/mm2", D::Stress, 9),
    read("bar", "bar", D::Stress, 5),
    also(by("psi", "psi", D::Stress, PSI), &["lbf/in2", "lb/in2"]),
    also(by("ksi", "ksi", D::Stress, 1000.0 * PSI), &["kip/in2"]),
    also(by("psf", "psf", D::Stress, POUND_FORCE / (FOOT * FOOT)), &["lbf/ft2"]),
    // per length
    ten("N/m", "N/m", D::LineForce, 0),
    also(ten("kN/m", "kN/m", D::LineForce, 3), &["N/mm"]),
    ten("MN/m", "MN/m", D::LineForce, 6),
    also(by("lbf/ft", "lbf/ft", D::LineForce, POUND_FORCE / FOOT), &["plf"]),
    by("kip/ft", "kip/ft", D::LineForce, 1000.0 * POUND_FORCE / FOOT),
    also(by("lbf/in", "lbf/in", D::LineForce, POUND_FORCE / INCH), &["pli"]),
    by("kip/in", "kip/in", D::LineForce, 1000.0 * POUND_FORCE / INCH),
    ten("N·m/m", "Nm/m", D::LineMoment, 0),
    ten("kN·m/m", "kNm/m", D::LineMoment, 3),
    by("lbf·ft/ft", "lbf*ft/ft", D::LineMoment, POUND_FORCE),
    by("kip·ft/ft", "kip*ft/ft", D::LineMoment, 1000.0 * POUND_FORCE),
    // energy
    ten("J", "J", D::Energy, 0),
    ten("kJ", "kJ", D::Energy, 3),
    ten("MJ", "MJ", D::Energy, 6),
    by("ft·lbf", "ft*lbf", D::Energy, POUND_FORCE * FOOT),
    by("ft·kip", "ft*kip", D::Energy, 1000.0 * POUND_FORCE * FOOT),
    // area per length
    read("mm²/m", "mm2/m", D::LineArea, -6),
    ten("cm²/m", "cm2/m", D::LineArea, -4),
    ten("m²/m", "m2/m", D::LineArea, 0),
    by("in²/ft", "in2/ft", D::LineArea, INCH * INCH / FOOT),
    // temperature
    also(ten("°C", "degC", D::Temperature, 0), &["C"]),
    also(unit("K", "K", D::Temperature, Scale::Shifted(1.0, -273.15), false), &["kelvin"]),
    also(unit("°F", "degF", D::Temperature, Scale::Shifted(5.0 / 9.0, -160.0 / 9.0), false), &["F"]),
    // curvature
    ten("rad/km", "rad/km", D::Curvature, -3),
    ten("rad/m", "rad/m", D::Curvature, 0),
    by("rad/ft", "rad/ft", D::Curvature, 1.0 / FOOT),
    // subgrade modulus
    ten("N/m³", "N/m3", D::Subgrade, 0),
    ten("kN/m³", "kN/m3", D::Subgrade, 3),
    ten("MN/m³", "MN/m3", D::Subgrade, 6),
    also(by("lb/in³", "lb/in3", D::Subgrade, POUND_FORCE / (INCH * INCH * INCH)), &["pci", "lbf/in3"]),
    // rotational stiffness
    ten("N·m/rad", "Nm/rad", D::RotationalStiffness, 0),
    ten("kN·m/rad", "kNm/rad", D::RotationalStiffness, 3),
    ten("MN·m/rad", "MNm/rad", D::RotationalStiffness, 6),
    ten("GN·m/rad", "GNm/rad", D::RotationalStiffness, 9),
    by("lbf·ft/rad", "lbf*ft/rad", D::RotationalStiffness, POUND_FORCE * FOOT),
    by("kip·ft/rad", "kip*ft/rad", D::RotationalStiffness, 1000.0 * POUND_FORCE * FOOT),
    // dashpots
    ten("N·s/m", "Ns/m", D::Dashpot, 0),
    ten("kN·s/m", "kNs/m", D::Dashpot, 3),
    ten("MN·s/m", "MNs/m", D::Dashpot, 6),
    by("lbf·s/ft", "lbf*s/ft", D::Dashpot, POUND_FORCE / FOOT),
    by("kip·s/ft", "kip*s/ft", D::Dashpot, 1000.0 * POUND_FORCE / FOOT),
    ten("N·m·s/rad", "Nms/rad", D::RotationalDashpot, 0),
    ten("kN·m·s/rad", "kNms/rad", D::RotationalDashpot, 3),
    ten("MN·m·s/rad", "MNms/rad", D::RotationalDashpot, 6),
    by("lbf·ft·s/rad", "lbf*ft*s/rad", D::RotationalDashpot, POUND_FORCE * FOOT),
    by("kip·ft·s/rad", "kip*ft*s/rad", D::RotationalDashpot, 1000.0 * POUND_FORCE * FOOT),
    // moment of inertia of a mass
    ten("kg·m²", "kgm2", D::RotationalInertia, 0),
    ten("t·m²", "tm2", D::RotationalInertia, 3),
    by("lb·ft²", "lb*ft2", D::RotationalInertia, POUND * FOOT * FOOT),
    by("klb·ft²", "klb*ft2", D::RotationalInertia, 1000.0 * POUND * FOOT * FOOT),
    // sections
    ten("mm²", "mm2", D::Area, -6),
    ten("cm²", "cm2", D::Area, -4),
    ten("m²", "m2", D::Area, 0),
    by("in²", "in2", D::Area, INCH * INCH),
    ten("mm⁴", "mm4", D::SecondMoment, -12),
    ten("cm⁴", "cm4", D::SecondMoment, -8),
    ten("m⁴", "m4", D::SecondMoment, 0),
    by("in⁴", "in4", D::SecondMoment, INCH * INCH * INCH * INCH),
    // mass per area
    ten("kg/m²", "kg/m2", D::AreaMass, 0),
    also(by("lb/ft²", "lb/ft2", D::AreaMass, POUND / (FOOT * FOOT)), &["lbm/ft2"]),
];

/// A spelling of a unit, written once: a file has thousands of quantities.
pub(super) struct Spelling {
    pub unit: &'static Unit,
    /// [`canonical`].
    pub text: String,
    /// In lower case.
    pub folded: String,
}

/// All spellings, in the order of the table.
pub(super) static SPELLINGS: LazyLock<Vec<Spelling>> = LazyLock::new(|| {
    let of = |unit: &'static Unit| unit.spellings().map(move |text| (unit, canonical(text)));
    let spelled = UNITS.iter().flat_map(of).map(|(unit, text)| Spelling { unit, folded: text.to_lowercase(), text });
    spelled.collect()
});

impl Unit {
    /// The unit of this dimension with this spelling.
    pub fn find(spelling: &str, dimension: D) -> Option<&'static Unit> {
        let wanted = canonical(spelling);
        let found = SPELLINGS.iter().find(|s| s.unit.dimension == dimension && s.text == wanted);
        found.map(|s| s.unit)
    }

    /// Value of one such unit in SI.
    pub fn factor(&self) -> f64 {
        match self.scale {
            Scale::Ten(exponent) => power_of_ten(exponent),
            Scale::Factor(factor) | Scale::Shifted(factor, _) => factor,
        }
    }

    /// Value of zero such units in SI: 0 of all but temperatures.
    pub fn zero(&self) -> f64 {
        match self.scale {
            Scale::Shifted(_, zero) => zero,
            Scale::Ten(_) | Scale::Factor(_) => 0.0,
        }
    }

    /// Whether it is a power of ten of the SI unit.
    pub fn is_power_of_ten(&self) -> bool {
        matches!(self.scale, Scale::Ten(_))
    }

    /// All spellings that are read, ASCII first.
    pub fn spellings(&self) -> impl Iterator<Item = &'static str> {
        [self.text, self.symbol].into_iter().chain(self.aliases.iter().copied()).filter(|s| !s.is_empty())
    }

    /// The value in SI of `number` of these units; `number` is a decimal literal.
    pub(super) fn to_si(self, number: &str) -> Option<f64> {
        let value: f64 = match self.scale {
            Scale::Ten(0) => number.parse().ok()?,
            Scale::Ten(shift) => {
                let (mantissa, exponent) = match number.split_once(['e', 'E']) {
                    Some((m, e)) => (m, e.parse::<i32>().ok()?),
                    None => (number, 0),
                };
                format!("{mantissa}e{}", exponent.checked_add(shift)?).parse().ok()?
            }
            Scale::Factor(_) | Scale::Shifted(..) => number.parse::<f64>().ok()? * self.factor() + self.zero(),
        };
        value.is_finite().then_some(value)
    }
}

/// 10ⁿ for small n, correctly rounded: powers up to 10²² are exact, so their reciprocal rounds once.
pub(super) fn power_of_ten(exponent: i32) -> f64 {
    let power = 10_f64.powi(exponent.abs());
    if exponent < 0 { 1.0 / power } else { power }
}

/// One spelling for all: superscripts as digits, no `^`, `·` for every product sign, no blanks around operators.
pub(super) fn canonical(spelling: &str) -> String {
    let mut out = String::with_capacity(spelling.len());
    for c in spelling.trim().chars() {
        match c {
            '²' => out.push('2'),
            '³' => out.push('3'),
            '⁴' => out.push('4'),
            '^' => {}
            '*' | '·' | '⋅' | '×' => join(&mut out, '·'),
            '/' | '∕' => join(&mut out, '/'),
            c if c.is_whitespace() => {
                if !out.ends_with(['·', '/', ' ']) {
                    out.push(' ');
                }
            }
            c => out.push(c),
        }
    }
    if !out.contains(['·', ' ']) {
        return out;
    }
    // "kN m" and "kN·m" are "kNm"; "m s" is not changed and is not a unit.
    for force in ["N", "lbf", "kip"] {
        for arm in ["m", "ft"] {
            for sign in ['·', ' '] {
                let written = format!("{force}{sign}{arm}");
                out = out.replace(&written, &format!("{force}{arm}"));
            }
        }
    }
    out
}

fn join(out: &mut String, operator: char) {
    while out.ends_with(' ') {
        out.pop();
    }
    out.push(operator);
}
