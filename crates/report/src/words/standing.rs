//! The base of an unanchored tank under the moments of the codes, in the section of that name.

use tank::units::Dimension;

use crate::number::{fixed, with_unit};
use results::{Standing, StandingPlate};

/// Heads of the table of the grounds.
pub const GROUNDS: [&str; 6] = [
    "Ground under the rim",
    "Rotation of the base",
    "Uplift",
    "Lifted width",
    "Plastic rotation",
    "Toe stress",
];
/// Titles of the figures.
pub const FIGURES: [&str; 3] = [
    "Moment of the base against its rotation",
    "Lifted bottom plate",
    "Pressure of the ground under it",
];
/// Axes: rotation, moment, distance, deflection, pressure.
pub const AXES: [&str; 5] = ["Rotation", "Moment", "Distance from the wall", "Deflection", "Pressure"];
/// Legends of the plate and of its yielded parts.
pub const PLATE: [&str; 2] = ["plate", "yielded"];
/// Legend of the ground without load.
pub const LEVEL: &str = "ground";
/// No number.
pub const NONE: &str = "not held";

/// A ground and whether it is for information alone.
pub fn ground(modulus: f64, decides: bool) -> String {
    let modulus = with_unit(modulus, Dimension::Subgrade);
    if decides {
        modulus
    } else {
        format!("{modulus}, for information")
    }
}

/// The moment and where it comes from.
pub fn moment(standing: &Standing, label: &str) -> String {
    let moment = with_unit(standing.moment, Dimension::Moment);
    match standing.weight {
        Some(weight) => {
            let weight = with_unit(weight, Dimension::LineForce);
            format!("Under {moment}, the moment of {label}, with {weight} of wall and roof as on its sheet.")
        }
        None => format!("Under {moment}, the moment of {label}."),
    }
}

/// A rotation in rad.
pub fn rotation(value: f64) -> String {
    format!("{} rad", fixed(value, 5))
}

/// Legend of a curve.
pub fn curve(modulus: f64) -> String {
    with_unit(modulus, Dimension::Subgrade)
}

/// Caption of the figures of the plate.
pub fn plate(plate: &StandingPlate) -> String {
    format!(
        "At the lifted side, on {}; heights are exaggerated.",
        with_unit(plate.modulus, Dimension::Subgrade)
    )
}
