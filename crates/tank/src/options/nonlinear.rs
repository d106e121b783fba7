//! Options of the nonlinear engine.

use serde::{Deserialize, Serialize};

use super::after_record::AfterRecord;
use crate::case;
use crate::imperfection::Imperfections;
use crate::keys::{Number, Opt, Or, Subgrade, Time, Whole, Within, keys};
use crate::{WallTemperature, words};

/// Most elements over the height of a wall.
pub const MOST_ROWS: u32 = 1000;
/// Most elements around a tank.
pub const MOST_SECTORS: u32 = 4000;

/// Defaults. The damping ratios are placeholders: those of the case replace them.
const DEFAULT: &NonlinearOptions = &NonlinearOptions::new(case::Damping { sloshing: f64::NAN, impulsive: f64::NAN });

keys! {
    /// Options of the nonlinear engine: walls that yield and crack, large rotations, liquid of linear theory.
    pub NonlinearOptions as Nonlinear {
        /// Numbers of elements of the wall.
        elements: Within<Option<WallElements>> = Absent::Without("by the size of the wall and its materials"),
        /// Whether only the half of the tank on one side of the plane of shaking is computed; not for a strip.
        symmetry (false): Or<bool>
            = default(DEFAULT.symmetry).because("half of the tank is computed, the other is its mirror image"),
        /// Spectral radius of the time integration at high frequencies; 1 is the trapezoidal rule (generalised-alpha method
        /// of Chung and Hulbert).
        spectral_radius (0.8): Or<Number> [Limits::from(0.0).to(1.0)] = default(Number(DEFAULT.spectral_radius))
            .because("next to no numerical damping of the modes that count (Chung and Hulbert 1993)"),
        /// Time step.
        time_step ("0.0025 s"): Opt<Time> [Limits::from(1e-6).to(1.0)]
            = without("a twentieth of the impulsive period, at most half the step of the record"),
        /// Whether quiet phases of a cylinder with bonded liquid are marched in longer steps: several time steps at once, at most
        /// the step of the record, as long as the local error of the displacements stays below 0.1 % of the largest so far.
        @"StepLength::is_fixed" step ("adaptive"): Or<StepLength> = default(DEFAULT.step).because("every time step is resolved"),
        /// Damping model.
        damping: Within<Damping> = Absent::Follows("by_group with the ratios of damping"),
        /// Contact of liquid and wall.
        contact: Or<Contact> = default(DEFAULT.contact).because("the liquid stays at the wall"),
        /// Elements of the walls of a strip; not for a cylinder, whose walls are shells.
        @(default) wall ("shell"): Or<StripWall>
            = default(DEFAULT.wall).because("one leaf bends, and fibres take a sixth of the time of shells"),
        /// Liquid of a strip; not for a cylinder, whose liquid is condensed.
        @"LiquidForm::is_condensed" liquid ("displacement"): Or<LiquidForm> = default(DEFAULT.liquid),
        /// Elements of a displacement liquid over half the length of the strip; their rows are those of the wall.
        @"Option::is_none" liquid_elements (10): Opt<Whole> [Limits::count(1, MOST_ROWS)] = Absent::Follows("nearly square elements"),
        /// Stiffness along the wall of the contact elements of a displacement liquid, open or closed.
        @"is_zero" contact_tangential ("10 MN/m3"): Or<Subgrade> [Limits::from(0.0).to(1e12)] = default(Subgrade(DEFAULT.contact_tangential)),
        /// Temperature of a wall of shells at rest before the record; not of its rings, its base and an interlayer.
        @"Option::is_none" temperature: Within<Option<WallTemperature>>
            = Absent::Follows("the wall has the temperature at which it is free of stress"),
        /// Whether the weight of the wall acts.
        self_weight (false): Or<bool> = default(DEFAULT.self_weight).because("the wall has weight"),
        /// Whether the pressure turns with the wall.
        follower_pressure (false): Or<bool>
            = default(DEFAULT.follower_pressure).because("pressure stands on the deformed wall"),
        /// Points through the thickness, by kind of material.
        integration: Within<Integration>,
        /// Refinement of the rings of the bottom plate of an unanchored cylinder: 2 makes them half as wide.
        @(default = "one", skip_serializing_if = "is_one") bottom_mesh (2): Or<Number> [Limits::from(0.5).to(8.0)] = default(Number(DEFAULT.bottom_mesh))
            .because("rings of two thicknesses at the foot resolve the hinge of the plate"),
        /// Whether the foot of a cylinder on its bottom plate stays a plane, as it does in the strips of the harmonic engine and under a stiff roof; of
        /// no account where the foot is clamped.
        @"std::ops::Not::not" plane_foot (true): Or<bool>
            = default(DEFAULT.plane_foot).because("the mass of the roof is modelled, not its stiffness: the foot may warp"),
        /// Free vibration after the record: periods of the first sloshing mode, a time, or none. A long wave often peaks there.
        @(default) after_record ("2 periods"): Or<AfterRecord> = default(DEFAULT.after_record)
            .because("as the linear engines: two periods of the first sloshing mode"),
        /// Computing time between two checkpoints from which a run can be resumed.
        checkpoint ("300 s"): Or<Time> [Limits::from(1.0).to(1e6)]
            = default(Time(DEFAULT.checkpoint)).because("at most a minute of computing is lost"),
    } with {
        /// Deviations of the wall from the perfect cylinder, those of `analysis.imperfections`.
        @"Imperfections::is_empty" imperfections: Imperfections = Imperfections::NONE,
        /// Penalty K_rot of a displacement liquid [Pa], that of `analysis.solid`.
        @"Option::is_none" rotation_penalty: Option<f64> = None,
    }
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
            damping: Damping::ByGroup { wall: damping.impulsive, sloshing: damping.sloshing },
            contact: Contact::Bonded,
            wall: StripWall::Fibre,
            liquid: LiquidForm::Condensed,
            liquid_elements: None,
            contact_tangential: 0.0,
            temperature: None,
            self_weight: true,
            follower_pressure: true,
            integration: Integration::DEFAULT,
            bottom_mesh: 1.0,
            plane_foot: false,
            after_record: AfterRecord::DEFAULT,
            checkpoint: 60.0,
            imperfections: Imperfections::NONE,
            rotation_penalty: None,
        }
    }
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
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

words! {
    /// Liquid of a strip.
    pub LiquidForm: Condensed {
        /// Condensed onto each wall in closed form; the walls are run one by one.
        Condensed = "condensed",
        /// Displacement elements between both walls, joined to them by contact elements, in one model.
        Displacement = "displacement",
    }
}

impl LiquidForm {
    /// Whether it is the default.
    pub fn is_condensed(&self) -> bool {
        *self == LiquidForm::Condensed
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

keys! {
    /// Points through the thickness of a layer, by kind of material.
    pub Integration as Integrations (Copy, Eq) {
        /// Elastic layers.
        elastic ("gauss 2"): Or<ThicknessRule> = default(Integration::DEFAULT.elastic),
        /// Steel.
        steel ("gauss 5"): Or<ThicknessRule> = default(Integration::DEFAULT.steel),
        /// Concrete.
        concrete ("midpoint 20"): Or<ThicknessRule> = default(Integration::DEFAULT.concrete),
    }
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

crate::value::own!(ThicknessRule);
