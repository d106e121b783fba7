//! Common to the displacement liquids: properties, choices of quadrature, the split penalty.
//!
//! ```text
//! ½ ∫ K e² dV + ½ ∫ K_rot ω_ij ω^ij dV + ½ ∫ ρ g u_z² dA        e = g^ij u_i|_j        ω_ij = ½ (u_i,j − u_j,i)
//! ```
//!
//! (dissertation, chapter 5 and appendix C). The sum over ij runs over both 12 and 21: in the plane the rotation term is
//! K_rot ω₁₂² = ½ (K_rot/2)(curl u)², so that rotational waves run at √(K_rot/2ρ). Christoffel symbols cancel in ω_ij.
//!
//! The dissertation integrates the volume part at one point and the rotation part fully, with a K_rot that is calibrated
//! tank by tank. Here the defaults are the mean dilatation (Flanagan & Belytschko 1981), which passes the patch test the
//! dissertation's element fails, and the split penalty
//!
//! ```text
//! R = R_1pt(K₁) + [R_full − R_1pt](K₂)        K₁ = 10 ρ g R        K₂ = 0.1 ρ g R
//! ```
//!
//! which keeps the mean rotation of an element stiff without locking its bending or needing calibration. Derivation and
//! measurements: `docs/theory/fluid-elements.md`.
//!
//! The element's pressure is that of its centre. It is **not** the pressure on the wall, which lies half an element away:
//! on 12 elements along the radius of a tank it is 7 % less. Take wall pressures from nodal reactions over nodal areas.

use super::{ElementError, not_negative, positive, require};

/// Quadrature of ½ ∫ K e² dV.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VolumePart {
    /// 2 points a direction: locks, for comparison only (variant 1 of table 5.2).
    Full,
    /// One point, as in the dissertation: fails the patch test on distorted hexahedra.
    OnePoint,
    /// The mean of e over the element, ē = (1/V) ∫ e dV, with full quadrature.
    MeanDilatation,
}

/// Quadrature and size of the rotation penalty K_rot [Pa].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RotationPart {
    /// No rotation part: most modes have zero energy.
    None,
    /// One point.
    OnePoint(f64),
    /// 2 points a direction, as in the dissertation.
    Full(f64),
    /// Different penalties for the rotation at the centre and for the rest.
    Split {
        /// K₁, of the rotation at the centre.
        centre: f64,
        /// K₂, of the rest, at most K₁.
        rest: f64,
    },
}

impl RotationPart {
    /// The default: K₁ = 10 ρ g R, K₂ = 0.1 ρ g R.
    ///
    /// * `weight_density`: ρ g [N/m³]
    /// * `half_width`: R, radius or half length [m]
    pub fn split(weight_density: f64, half_width: f64) -> RotationPart {
        RotationPart::Split { centre: 10.0 * weight_density * half_width, rest: 0.1 * weight_density * half_width }
    }

    /// (K of the full quadrature, K of the one-point quadrature).
    pub fn penalties(self) -> (f64, f64) {
        match self {
            RotationPart::None => (0.0, 0.0),
            RotationPart::OnePoint(k) => (0.0, k),
            RotationPart::Full(k) => (k, 0.0),
            RotationPart::Split { centre, rest } => (rest, centre - rest),
        }
    }
}

/// Properties of a displacement liquid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiquidProperties {
    /// ρ [kg/m³].
    pub density: f64,
    /// K [Pa].
    pub bulk_modulus: f64,
    /// Volume part.
    pub volume: VolumePart,
    /// Rotation part.
    pub rotation: RotationPart,
}

impl LiquidProperties {
    /// Mean dilatation and split penalty.
    ///
    /// * `gravity`: g [m/s²]
    /// * `half_width`: radius or half length of the tank [m]
    pub fn new(density: f64, bulk_modulus: f64, gravity: f64, half_width: f64) -> LiquidProperties {
        LiquidProperties {
            density,
            bulk_modulus,
            volume: VolumePart::MeanDilatation,
            rotation: RotationPart::split(density * gravity, half_width),
        }
    }

    /// Rejects values that are not positive, in the name of the element `kind`.
    ///
    /// Errors: density or bulk modulus not positive, a negative penalty, a rest above the centre.
    pub fn check(&self, kind: &'static str) -> Result<(), ElementError> {
        for (parameter, value) in [("density", self.density), ("bulk modulus", self.bulk_modulus)] {
            require(positive(value), kind, parameter, value, "a positive number")?;
        }
        let (first, second) = match self.rotation {
            RotationPart::None => (0.0, 0.0),
            RotationPart::OnePoint(k) | RotationPart::Full(k) => (k, 0.0),
            RotationPart::Split { centre, rest } => (centre, rest),
        };
        for value in [first, second] {
            require(not_negative(value), kind, "rotation penalty", value, "a number ≥ 0")?;
        }
        let found = format_args!("{second} next to {first} at the centre");
        require(first >= second, kind, "rotation penalty of the rest", found, "at most that of the centre")
    }
}
