//! The ingredients of a quantity that an attribution exchanges one after the other, in their order.

use serde::{Deserialize, Serialize};

use crate::listed;

listed! {
    /// An ingredient whose exchange has a factor. The order of the variants is the order of exchange.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Factor {
        /// Name of its exchange in tables, figures and sentences.
        name: &'static str,
    }
    /// The base that lifts and slides is exchanged for the wall held down.
    Uplift: "wall held down for uplift";
    /// The slab that moves on isolators is exchanged for a fixed base.
    Isolators: "fixed base for isolators";
    /// The slab that moves on soil is exchanged for a fixed base.
    Soil: "fixed base for soil";
    /// The history is exchanged for the maxima of its modes, combined by SRSS.
    TimeHistory: "modal maxima for the history";
    /// All modes are exchanged for the structural mode of the largest mass and the first sloshing mode; in the rows of
    /// masses, the structural mode for all structural modes.
    Modes: "number of modes";
    /// Impulsive mass of an engine that does not separate liquid, wall and roof.
    ImpulsiveMass: "impulsive mass";
    /// Liquid of the impulsive part.
    LiquidMass: "impulsive liquid";
    /// Wall in the impulsive part.
    WallMass: "wall mass";
    /// Roof in the impulsive part.
    RoofMass: "roof mass";
    /// Floor in the impulsive part.
    FloorMass: "floor mass";
    /// Mass of the sloshing mode.
    ConvectiveMass: "sloshing mass";
    /// Heights of the masses.
    LeverArm: "lever arms";
    /// Stress of the impulsive part per acceleration (hoop) or per moment (axial).
    ImpulsiveStress: "impulsive stress formula";
    /// Stress of the convective part per acceleration (hoop) or per moment (axial).
    ConvectiveStress: "sloshing stress formula";
    /// The height of the engine's largest hoop stress is exchanged for that of the procedure's.
    Place: "height of the largest hoop stress";
    /// The impulsive part moves with the ground (period zero).
    RigidWall: "rigid wall";
    /// The impulsive part has the largest ordinate of a range of periods.
    Plateau: "plateau for the period";
    /// Period of the impulsive part.
    ImpulsivePeriod: "impulsive period";
    /// Period of the sloshing mode.
    SloshingPeriod: "sloshing period";
    /// Damping ratios.
    Damping: "damping";
    /// Spectrum of the record against that of the site: the hazard.
    Spectrum: "spectrum of the site";
    /// Factor of a code from the damping of its spectrum to that of sloshing.
    DampingCorrection: "code's damping factor";
    /// The branch of long periods, beyond T_D or T_L, against the branch of 1/T.
    LongPeriod: "long-period branch";
    /// Importance factor.
    Importance: "importance factor";
    /// Behaviour factor 1/q or response modification 1/R_w.
    BehaviourFactor: "behaviour factor";
    /// Least and largest values that a code sets to an acceleration.
    Bounds: "bounds of the code";
    /// Rise of the surface per acceleration of the sloshing mode, with the accelerations of the procedure.
    WaveFormula: "wave formula";
    /// Rule by which impulsive and convective maxima are combined.
    Combination: "combination rule";
    /// Stress of the vertical motion, as the procedure combines it with the horizontal one.
    Vertical: "vertical motion";
    /// Potential flow in a rigid tank, exact.
    RigidTank: "rigid tank";
    /// All sloshing modes as one mass.
    AllSloshingModes: "all sloshing modes as one";
    /// Depth of the liquid that can slosh.
    LiquidDepth: "depth that sloshes";
    /// Clamped shell of the same courses with its liquid, without roof.
    ShellModel: "shell without roof";
    /// The wall has no mass.
    WeightlessWall: "weightless wall";
    /// The wall has one thickness and one modulus.
    UniformWall: "uniform wall";
    /// Formula, table or printed constant of the procedure.
    Formula: "procedure's formula";
}
