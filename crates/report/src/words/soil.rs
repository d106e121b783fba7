//! A tank on a slab on soil, in the section of that name.

use tank::units::{Dimension, display};

use crate::number::{fixed, percent, with_unit};
use results::{EffectiveMode, SoilRun};

/// Titles of the tables: cones, periods, motion of the slab, values beside those on a fixed base.
pub const TABLES: [&str; 4] = [
    "Springs and dashpots of the soil",
    "Period and damping of the impulsive mode",
    "Largest motion of the slab",
    "Values on soil and on a fixed base",
];
/// Heads of the table of the cones.
pub const CONES: [&str; 4] = ["Impedance", "Spring k", "Dashpot c", "Inertia"];
/// Heads of the table of periods.
pub const EFFECTIVE: [&str; 4] = ["Impulsive mode", "Period", "over fixed base", "Damping"];
/// Its first row.
pub const FIXED: &str = "fixed base";
/// Heads of the table of the slab's motion.
pub const MOTION: [&str; 3] = ["Slab", "Largest", "Time"];
/// Heads of the table beside the fixed base.
pub const BESIDE: [&str; 4] = ["Quantity", "On soil", "Fixed base", "Ratio"];
/// No number.
pub const NONE: &str = "–";
/// Titles of the figures.
pub const FIGURES: [&str; 2] = ["Translation of the slab over time", "Rotation of the slab over time"];
/// Axes.
pub const AXES: [&str; 2] = ["Translation", "Rotation"];

/// A definition of period and damping.
pub fn definition(mode: &EffectiveMode) -> &str {
    match mode.id.as_str() {
        "cones" => "on soil, complex stiffness with cones (effective_period, effective_damping)",
        "veletsos" => "on soil, complex stiffness after Veletsos and Verbic",
        "complex_mode" => "on soil, complex mode on cones, with the slab",
        "static" => "on soil, static springs",
        other => other,
    }
}

/// Springs, dashpots and inertia of the cones.
pub fn cones(run: &SoilRun) -> Vec<[String; 4]> {
    let number = |value: f64, dimension: Dimension| match value > 0.0 {
        true => with_unit(value, dimension),
        false => NONE.into(),
    };
    vec![
        [
            "translation".into(),
            number(run.horizontal, Dimension::LineForce),
            number(run.horizontal_dashpot, Dimension::Dashpot),
            NONE.into(),
        ],
        [
            "rocking".into(),
            number(run.rocking, Dimension::RotationalStiffness),
            NONE.into(),
            number(run.trapped_inertia, Dimension::RotationalInertia),
        ],
        [
            "internal rotation, joined to the rocking slab by its dashpot".into(),
            NONE.into(),
            number(run.rocking_dashpot, Dimension::RotationalDashpot),
            number(run.internal_inertia, Dimension::RotationalInertia),
        ],
    ]
}

/// Title of a quantity.
pub fn quantity(id: &str) -> &str {
    match id {
        "base_translation" => "Translation relative to the free field",
        "base_rotation" => "Rotation",
        other => other,
    }
}

/// Slab, soil, stiffness.
pub fn ground(run: &SoilRun) -> String {
    let slab = if run.thickness > 0.0 {
        format!(
            "Slab {} in radius, {} thick, {}",
            display(run.radius, Dimension::Length),
            display(run.thickness, Dimension::Length),
            display(run.slab_mass, Dimension::Mass)
        )
    } else {
        format!(
            "Slab {} in radius, without mass",
            display(run.radius, Dimension::Length)
        )
    };
    let stiffness = [
        with_unit(run.horizontal, Dimension::LineForce),
        with_unit(run.rocking, Dimension::RotationalStiffness),
    ];
    format!(
        "{slab}. Soil with V_s = {}, {}, Poisson's ratio {}: static stiffness {} and {}. Impulsive mode {} at {} above the \
         underside of the slab, damping {} on a fixed base.",
        display(run.shear_wave_velocity, Dimension::Velocity),
        display(run.density, Dimension::Density),
        fixed(run.poisson_ratio, 3),
        stiffness[0],
        stiffness[1],
        display(run.impulsive_mass, Dimension::Mass),
        display(run.impulsive_arm, Dimension::Length),
        percent(run.fixed_damping)
    )
}
