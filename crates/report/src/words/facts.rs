//! Names of the numbers of a model.

use results::FactKind;

/// Name of a number.
pub fn name(kind: FactKind) -> &'static str {
    match kind {
        FactKind::ElementsOverWall => "elements over a wall",
        FactKind::SectionFibres => "fibres in a section",
        FactKind::ShellsAround => "shells around",
        FactKind::ShellsOverHeight => "shells over the height",
        FactKind::SloshingModes => "sloshing modes of the liquid",
        FactKind::Unknowns => "unknowns",
        FactKind::FirstSloshing => "first sloshing mode",
        FactKind::SloshingDamping => "damping of the first sloshing mode",
        FactKind::FirstWall => "first mode of wall and liquid",
        FactKind::WallDamping => "damping of the first mode of wall and liquid",
        FactKind::LongestStep => "longest time step",
        FactKind::RadiusOverThickness => "R/t of the lowest course",
        FactKind::ElementsOverHeight => "elements over the height",
        FactKind::ElementsAround => "elements around the half",
        FactKind::LowestElement => "lowest element over √(R t)",
        FactKind::SmallestAround => "smallest element along the circumference over √(R t)",
        FactKind::ImpulsiveMass => "impulsive mass of the liquid",
        FactKind::ImpulsiveHeight => "its height",
        FactKind::WallAndRoofMass => "mass of wall and roof",
    }
}
