//! The ingredients of a quantity that an attribution exchanges one after the other, in their order.

use serde::{Deserialize, Serialize};

/// An ingredient whose exchange has a factor. The order of the variants is the order of exchange.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Factor {
    /// The base that lifts and slides is exchanged for the wall held down.
    Uplift,
    /// The slab that moves on isolators is exchanged for a fixed base.
    Isolators,
    /// The slab that moves on soil is exchanged for a fixed base.
    Soil,
    /// The history is exchanged for the maxima of its modes, combined by SRSS.
    TimeHistory,
    /// All modes are exchanged for the structural mode of the largest mass and the first sloshing mode; in the rows of
    /// masses, the structural mode for all structural modes.
    Modes,
    /// Impulsive mass of an engine that does not separate liquid, wall and roof.
    ImpulsiveMass,
    /// Liquid of the impulsive part.
    LiquidMass,
    /// Wall in the impulsive part.
    WallMass,
    /// Roof in the impulsive part.
    RoofMass,
    /// Floor in the impulsive part.
    FloorMass,
    /// Mass of the sloshing mode.
    ConvectiveMass,
    /// Heights of the masses.
    LeverArm,
    /// Stress of the impulsive part per acceleration (hoop) or per moment (axial).
    ImpulsiveStress,
    /// Stress of the convective part per acceleration (hoop) or per moment (axial).
    ConvectiveStress,
    /// The height of the engine's largest hoop stress is exchanged for that of the procedure's.
    Place,
    /// The impulsive part moves with the ground (period zero).
    RigidWall,
    /// The impulsive part has the largest ordinate of a range of periods.
    Plateau,
    /// Period of the impulsive part.
    ImpulsivePeriod,
    /// Period of the sloshing mode.
    SloshingPeriod,
    /// Damping ratios.
    Damping,
    /// Spectrum of the record against that of the site: the hazard.
    Spectrum,
    /// Factor of a code from the damping of its spectrum to that of sloshing.
    DampingCorrection,
    /// The branch of long periods, beyond T_D or T_L, against the branch of 1/T.
    LongPeriod,
    /// Importance factor.
    Importance,
    /// Behaviour factor 1/q or response modification 1/R_w.
    BehaviourFactor,
    /// Least and largest values that a code sets to an acceleration.
    Bounds,
    /// Rise of the surface per acceleration of the sloshing mode, with the accelerations of the procedure.
    WaveFormula,
    /// Rule by which impulsive and convective maxima are combined.
    Combination,
    /// Stress of the vertical motion, as the procedure combines it with the horizontal one.
    Vertical,
    /// Potential flow in a rigid tank, exact.
    RigidTank,
    /// All sloshing modes as one mass.
    AllSloshingModes,
    /// Depth of the liquid that can slosh.
    LiquidDepth,
    /// Clamped shell of the same courses with its liquid, without roof.
    ShellModel,
    /// The wall has no mass.
    WeightlessWall,
    /// The wall has one thickness and one modulus.
    UniformWall,
    /// Formula, table or printed constant of the procedure.
    Formula,
}

impl Factor {
    /// All of them in the order of exchange.
    pub const ALL: [Factor; 36] = [
        Factor::Uplift,
        Factor::Isolators,
        Factor::Soil,
        Factor::TimeHistory,
        Factor::Modes,
        Factor::ImpulsiveMass,
        Factor::LiquidMass,
        Factor::WallMass,
        Factor::RoofMass,
        Factor::FloorMass,
        Factor::ConvectiveMass,
        Factor::LeverArm,
        Factor::ImpulsiveStress,
        Factor::ConvectiveStress,
        Factor::Place,
        Factor::RigidWall,
        Factor::Plateau,
        Factor::ImpulsivePeriod,
        Factor::SloshingPeriod,
        Factor::Damping,
        Factor::Spectrum,
        Factor::DampingCorrection,
        Factor::LongPeriod,
        Factor::Importance,
        Factor::BehaviourFactor,
        Factor::Bounds,
        Factor::WaveFormula,
        Factor::Combination,
        Factor::Vertical,
        Factor::RigidTank,
        Factor::AllSloshingModes,
        Factor::LiquidDepth,
        Factor::ShellModel,
        Factor::WeightlessWall,
        Factor::UniformWall,
        Factor::Formula,
    ];
}
