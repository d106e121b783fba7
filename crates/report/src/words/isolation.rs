//! A tank on isolators, in the section of that name.

use tank::units::{Dimension, display};

use crate::number::percent;
use results::IsolationRun;

/// Titles of the tables: values, band of the properties, energies.
pub const TABLES: [&str; 3] = [
    "Largest values on isolators",
    "Values with upper and lower properties",
    "Energies of the isolated tank",
];
/// Heads of the table of values.
pub const VALUES: [&str; 5] = ["Quantity", "On isolators", "Time", "Fixed base", "Ratio"];
/// Heads of the table of bounds.
pub const BAND: [&str; 7] = [
    "Properties",
    "Displacement",
    "Force",
    "Effective period",
    "Effective damping",
    "Base shear",
    "Wave height",
];
/// Labels of the energies.
pub const ENERGIES: [&str; 4] = [
    "Input of the ground",
    "Damping of wall and liquid",
    "Isolators, stored and lost",
    "Kinetic and stored in wall and liquid",
];
/// Head of the shares.
pub const SHARE: &str = "Share of the input";
/// No number.
pub const NONE: &str = "–";
/// Titles of the figures.
pub const FIGURES: [&str; 2] = [
    "Displacement of the isolators over time",
    "Force of the isolators against their displacement",
];
/// Axes.
pub const AXES: [&str; 2] = ["Displacement", "Force"];
/// Legend of both components.
pub const COMPONENTS: [&str; 2] = ["x", "y"];

/// Title of a quantity.
pub fn quantity(id: &str) -> &str {
    match id {
        "isolator_displacement" => "Largest displacement of the isolators",
        "isolator_residual" => "Their displacement at the end",
        "isolator_force" => "Largest force of the isolators",
        "effective_stiffness" => "Effective stiffness at the largest displacement",
        "effective_period" => "Effective period there",
        "effective_damping" => "Effective damping there",
        "bearing_share" => "Smallest force of the outermost bearing over that at rest",
        "sloshing_height" => "Wave height",
        "base_shear" => "Base shear of the tank",
        "base_moment" => "Moment above the base plate",
        "overturning_moment" => "Overturning moment",
        "hoop_stress" => "Largest hoop stress up to the surface at rest",
        "rim_hoop_stress" => "Largest hoop stress of the rim above it",
        "axial_membrane_stress" => "Axial stress at the base",
        "bending_stress" => "Bending stress at the base",
        other => other,
    }
}

/// A share below 0: tension.
pub fn tension(value: &str) -> String {
    format!("{value} (tension, not modelled)")
}

/// A bound of the properties.
pub fn bound(factor: f64) -> String {
    match factor {
        1.0 => "nominal".into(),
        _ => format!("× {factor}"),
    }
}

/// Isolators, masses and time step.
pub fn isolators(run: &IsolationRun) -> String {
    let kind = match run.kind.as_str() {
        "friction_pendulum" => "Friction pendulums",
        "lead_rubber" => "Lead-rubber bearings",
        _ => "Linear bearings",
    };
    format!(
        "{kind}{} under a slab of {}; {} on them in all. Time step {}.",
        if run.dampers { " and viscous dampers" } else { "" },
        display(run.slab_mass, Dimension::Mass),
        display(run.mass, Dimension::Mass),
        display(run.step, Dimension::Time)
    )
}

/// Error of the energy balance.
pub fn balance(run: &IsolationRun) -> String {
    format!(
        "The balance of energy closes within {:.0e} of the input. Force of the isolators from the superposed modes, whose values are reported, \
         and from the march agree within {}.",
        run.energy.error.max(1e-16),
        percent(run.superposition)
    )
}
