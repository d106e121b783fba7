//! Names of the ingredients that an attribution exchanges.

use tank::factor::Factor;

/// The name of an exchange in tables, figures and sentences.
pub fn name(factor: Factor) -> &'static str {
    match factor {
        Factor::Uplift => "wall held down for uplift",
        Factor::Isolators => "fixed base for isolators",
        Factor::Soil => "fixed base for soil",
        Factor::TimeHistory => "modal maxima for the history",
        Factor::Modes => "number of modes",
        Factor::ImpulsiveMass => "impulsive mass",
        Factor::LiquidMass => "impulsive liquid",
        Factor::WallMass => "wall mass",
        Factor::RoofMass => "roof mass",
        Factor::FloorMass => "floor mass",
        Factor::ConvectiveMass => "sloshing mass",
        Factor::LeverArm => "lever arms",
        Factor::ImpulsiveStress => "impulsive stress formula",
        Factor::ConvectiveStress => "sloshing stress formula",
        Factor::Place => "height of the largest hoop stress",
        Factor::RigidWall => "rigid wall",
        Factor::Plateau => "plateau for the period",
        Factor::ImpulsivePeriod => "impulsive period",
        Factor::SloshingPeriod => "sloshing period",
        Factor::Damping => "damping",
        Factor::Spectrum => "spectrum of the site",
        Factor::DampingCorrection => "code's damping factor",
        Factor::LongPeriod => "long-period branch",
        Factor::Importance => "importance factor",
        Factor::BehaviourFactor => "behaviour factor",
        Factor::Bounds => "bounds of the code",
        Factor::WaveFormula => "wave formula",
        Factor::Combination => "combination rule",
        Factor::Vertical => "vertical motion",
        Factor::RigidTank => "rigid tank",
        Factor::AllSloshingModes => "all sloshing modes as one",
        Factor::LiquidDepth => "depth that sloshes",
        Factor::ShellModel => "shell without roof",
        Factor::WeightlessWall => "weightless wall",
        Factor::UniformWall => "uniform wall",
        Factor::Formula => "procedure's formula",
    }
}

/// Caption of a waterfall.
pub const CAPTION: &str = "Factor by factor.";

/// Title of a waterfall.
pub fn title(quantity: &str, site: bool) -> String {
    match site {
        true => format!("{quantity}: from the finite elements to the site's design values"),
        false => format!("{quantity}: from the finite elements to the procedures"),
    }
}

/// Description of a waterfall.
pub fn description(title: &str, ends: &str) -> String {
    format!("{title}, factor by factor. Ratios to the finite elements: {ends}.")
}

/// The row of factors within `percent` of 1.
pub fn rest(count: usize) -> String {
    match count {
        1 => "1 smaller factor".into(),
        _ => format!("{count} smaller factors"),
    }
}

/// Head of the column of factors' names.
pub const FACTOR: &str = "Exchanged for the procedure's";
/// Last row of a table of factors.
pub const PRODUCT: &str = "product = ratio to FE under the record";

/// Title within a waterfall.
pub fn short_title(quantity: &str, site: bool) -> String {
    match site {
        true => format!("{quantity}, site against record"),
        false => format!("{quantity}, record"),
    }
}
