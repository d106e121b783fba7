//! Options of the nonlinear engine.

use serde::{Deserialize, Serialize};

use super::after_record::AfterRecord;
use crate::case;
use crate::imperfection::Imperfections;
use crate::words;

/// Most elements over the height of a wall.
pub const MOST_ROWS: u32 = 1000;
/// Most elements around a tank.
pub const MOST_SECTORS: u32 = 4000;

/// Options of the nonlinear engine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NonlinearOptions {
    /// Numbers of elements of the wall; `None` lets the engine choose.
    pub elements: Option<WallElements>,
    /// Whether only the half of the tank on one side of the plane of shaking is computed; of no account for a strip.
    pub symmetry: bool,
    /// Spectral radius ρ∞ at infinite frequency of the generalised-α method, 0 to 1 (1: trapezoidal rule).
    pub spectral_radius: f64,
    /// Time step [s]; `None`: T_imp/20, at most half the step of the record.
    pub time_step: Option<f64>,
    /// Whether quiet phases are marched in longer steps.
    #[serde(default, skip_serializing_if = "StepLength::is_fixed")]
    pub step: StepLength,
    /// Damping.
    pub damping: Damping,
    /// Contact of liquid and wall.
    pub contact: Contact,
    /// Elements of the walls of a strip; of no account for a cylinder, whose walls are shells.
    #[serde(default)]
    pub wall: StripWall,
    /// Whether the weight of the wall acts.
    pub self_weight: bool,
    /// Whether the pressure turns with the wall.
    pub follower_pressure: bool,
    /// Points through the thickness of each layer.
    pub integration: Integration,
    /// Refinement of the rings of the bottom plate of an unanchored cylinder: 2 makes them half as wide.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub bottom_mesh: f64,
    /// Whether the foot of a cylinder on its bottom plate stays a plane, as under a stiff roof; of no account where the foot is clamped.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub plane_foot: bool,
    /// Free vibration after the record.
    #[serde(default)]
    pub after_record: AfterRecord,
    /// Computing time between two checkpoints [s].
    pub checkpoint: f64,
    /// Deviations of the wall from the perfect cylinder.
    #[serde(default, skip_serializing_if = "Imperfections::is_empty")]
    pub imperfections: Imperfections,
}

impl NonlinearOptions {
    /// The defaults, with the damping ratios of the case.
    ///
    /// * `damping`: of wall (impulsive) and sloshing
    pub const fn new(damping: case::Damping) -> NonlinearOptions {
        NonlinearOptions {
            elements: None,
            symmetry: true,
            spectral_radius: 0.9,
            time_step: None,
            step: StepLength::Fixed,
            damping: Damping::ByGroup {
                wall: damping.impulsive,
                sloshing: damping.sloshing,
            },
            contact: Contact::Bonded,
            wall: StripWall::Fibre,
            self_weight: true,
            follower_pressure: true,
            integration: Integration::DEFAULT,
            bottom_mesh: 1.0,
            plane_foot: false,
            after_record: AfterRecord::DEFAULT,
            checkpoint: 60.0,
            imperfections: Imperfections::NONE,
        }
    }
}

const fn one() -> f64 {
    1.0
}

fn is_one(value: &f64) -> bool {
    *value == 1.0
}

/// Numbers of elements of the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct WallElements {
    /// Over its height.
    pub height: u32,
    /// Around the tank, the whole perimeter even where half of it is computed; 1 for a strip.
    pub circumference: u32,
}

words! {
    /// Length of the steps.
    pub StepLength: Fixed {
        /// The time step throughout.
        Fixed = "fixed",
        /// Several time steps at once where little moves.
        Adaptive = "adaptive",
    }
}

impl StepLength {
    /// Whether it is the default.
    pub fn is_fixed(&self) -> bool {
        *self == StepLength::Fixed
    }
}

words! {
    /// Contact of liquid and wall.
    pub Contact: Bonded {
        /// The liquid stays at the wall.
        Bonded = "bonded",
        /// The liquid separates from the wall where its pressure drops below zero.
        Opening = "opening",
    }
}

words! {
    /// Elements of the walls of a strip.
    pub StripWall: Fibre {
        /// Beams with sections of fibres: the stiffest leaf bends, the others count for mass.
        Fibre = "fibre",
        /// Layered shells, flexible in shear: every leaf, with the interlayer between two; the liquid is bonded.
        Shell = "shell",
    }
}

/// Damping.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Damping {
    /// C = (2 ξ_w/ω_imp) K_wall in the wall, a ratio for every sloshing mode.
    ByGroup {
        /// ξ_w of the first mode of wall and liquid.
        wall: f64,
        /// Ratio of every sloshing mode.
        sloshing: f64,
    },
    /// C = a_M M + a_K K through two (circular frequency [rad/s], ratio) pairs.
    Rayleigh {
        /// First pair.
        first: (f64, f64),
        /// Second pair.
        second: (f64, f64),
        /// Accept a negative coefficient (to repeat published runs), with a warning.
        allow_negative: bool,
    },
    /// C = 2 ξ ω M.
    MassProportional {
        /// ξ.
        ratio: f64,
        /// Where it holds.
        at: MassProportionalAt,
    },
}

/// Where a mass-proportional ratio holds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MassProportionalAt {
    /// At the first sloshing mode.
    FirstSloshing,
    /// At this circular frequency [rad/s].
    Frequency(f64),
}

/// Points through the thickness of a layer, by kind of material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Integration {
    /// Elastic layers.
    pub elastic: ThicknessRule,
    /// Steel.
    pub steel: ThicknessRule,
    /// Concrete.
    pub concrete: ThicknessRule,
}

impl Integration {
    /// Exact for elastic layers; 5 % of the moment of a yielding plate, 2 % of the compression of a cracked one.
    pub const DEFAULT: Integration = Integration {
        elastic: ThicknessRule::Gauss(2),
        steel: ThicknessRule::Gauss(5),
        concrete: ThicknessRule::MidPoint(20),
    };
}

impl Default for Integration {
    fn default() -> Self {
        Integration::DEFAULT
    }
}

/// Quadrature through the thickness of a layer, with its number of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ThicknessRule {
    /// Gauss-Legendre.
    Gauss(u32),
    /// Gauss-Lobatto.
    Lobatto(u32),
    /// Middles of equal layers, stretched.
    MidPoint(u32),
    /// Simpson (Newton-Cotes, quadratic), an odd number.
    Simpson(u32),
    /// Trapezoidal (Newton-Cotes, linear).
    Trapezoid(u32),
}
