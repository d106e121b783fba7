//! The two-mass model: its input and its values.

use super::coefficients::Coefficients;
use tank::case::Combination;

/// Input of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// a: radius R, or half length L in the direction of motion [m].
    pub half_length: f64,
    /// Liquid depth H [m].
    pub depth: f64,
    /// Liquid mass m [kg].
    pub mass: f64,
    /// Peak ground acceleration a_B [m/s²].
    pub ground_acceleration: f64,
    /// g [m/s²].
    pub gravity: f64,
    /// Constants of the convective part; they also determine whether the tank is circular or rectangular.
    pub coefficients: Coefficients,
}

/// A value the model cannot work with.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum InputError {
    /// A length, mass or gravity that must be positive is not.
    #[error("{what} is {value}; it must be positive and finite")]
    NotPositive {
        /// Which.
        what: &'static str,
        /// Found.
        value: f64,
    },
    /// An acceleration or spectral ordinate is negative.
    #[error("{what} is {value}; it must be zero or positive and finite")]
    Negative {
        /// Which.
        what: &'static str,
        /// Found.
        value: f64,
    },
}

/// Whether the base pressure takes part in a moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arms {
    /// Wall pressure only (EBP): bending moment of the wall just above the base.
    Wall,
    /// Wall and base pressure (IBP): overturning moment below the base plate.
    WallAndBase,
}

/// Forces and moments of one part of the liquid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Horizontal force [N].
    pub force: f64,
    /// Moment of the wall pressure at the base (EBP) [N·m].
    pub wall_moment: f64,
    /// Moment of wall and base pressure (IBP) [N·m].
    pub base_moment: f64,
}

/// Highest point of the surface at the wall.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// `g/(ω² θ_h a)`; Housner's formula has a solution if it is above 1.
    pub ratio: f64,
    /// Housner's `d_max` with the finite-angle term [m]; none outside his theory (`ratio ≤ 1`).
    pub finite: Option<f64>,
    /// Linear value [m].
    pub linear: f64,
}

impl Wave {
    /// Housner's value, or the linear one outside his theory [m].
    pub fn height(&self) -> f64 {
        self.finite.unwrap_or(self.linear)
    }
}

/// All values of the model. Levers are heights above the bottom of the part that can slosh, which lies `rigid_depth`
/// above the tank bottom (0 in a squat tank).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// True for H/a > 1.5.
    pub slender: bool,
    /// Depth of the part that can slosh, H_b = min(H, 1.5 a) [m].
    pub sloshing_depth: f64,
    /// Its mass m_b [kg].
    pub sloshing_mass: f64,
    /// Depth of the constrained lower part H_r [m].
    pub rigid_depth: f64,
    /// Mass of the constrained lower part m_r [kg].
    pub rigid_mass: f64,
    /// q = √3 a/H_b.
    pub q: f64,
    /// r = tanh(q)/q.
    pub r: f64,
    /// x = k H_b/a.
    pub x: f64,
    /// Sloshing frequency ω [rad/s].
    pub omega: f64,
    /// Sloshing period T [s].
    pub period: f64,
    /// Impulsive mass of the upper part m_i = m_b r [kg].
    pub impulsive_mass: f64,
    /// Convective mass m_k [kg].
    pub convective_mass: f64,
    /// Spectral displacement A₁ [m].
    pub displacement: f64,
    /// Pseudo-acceleration S_a = ω² A₁ [m/s²].
    pub acceleration: f64,
    /// Amplitude of the surface angle θ_h [rad].
    pub angle: f64,
    /// h_i = 3/8 H_b [m].
    pub impulsive_lever: f64,
    /// h_i′ with base pressure [m].
    pub impulsive_lever_with_base: f64,
    /// h_k [m].
    pub convective_lever: f64,
    /// h_k′ with base pressure [m].
    pub convective_lever_with_base: f64,
    /// P_i, force of the impulsive mass of the upper part [N].
    pub impulsive_force: f64,
    /// P_r, force of the constrained lower part [N].
    pub rigid_force: f64,
    /// P_k, convective force [N].
    pub convective_force: f64,
    /// Impulsive part with the constrained lower part.
    pub impulsive: Resultant,
    /// Convective part.
    pub convective: Resultant,
    /// Wave.
    pub wave: Wave,
}

impl Response {
    /// Base shear [N].
    pub fn base_shear(&self, combination: Combination) -> f64 {
        combine(self.impulsive.force, self.convective.force, combination)
    }

    /// Moment at the base [N·m].
    pub fn moment(&self, arms: Arms, combination: Combination) -> f64 {
        match arms {
            Arms::Wall => combine(self.impulsive.wall_moment, self.convective.wall_moment, combination),
            Arms::WallAndBase => combine(self.impulsive.base_moment, self.convective.base_moment, combination),
        }
    }
}

/// Sum of absolute values, or square root of the sum of squares.
pub fn combine(impulsive: f64, convective: f64, combination: Combination) -> f64 {
    match combination {
        Combination::Abs => impulsive.abs() + convective.abs(),
        Combination::Srss => impulsive.hypot(convective),
    }
}

/// Ratio H/a above which the lower part is constrained.
pub const SLENDER_LIMIT: f64 = 1.5;

/// Whether the tank and its motion can be computed with.
pub(super) fn check(input: &Input) -> Result<(), InputError> {
    for (what, value) in [
        ("the radius or half length", input.half_length),
        ("the liquid depth", input.depth),
        ("the liquid mass", input.mass),
        ("gravity", input.gravity),
    ] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(InputError::NotPositive { what, value });
        }
    }
    not_negative("the peak ground acceleration", input.ground_acceleration)
}

/// Whether an acceleration is zero or positive and finite.
pub(super) fn not_negative(what: &'static str, value: f64) -> Result<(), InputError> {
    if value >= 0.0 && value.is_finite() { Ok(()) } else { Err(InputError::Negative { what, value }) }
}
