//! The command `base`.

use tank::units::{Dimension, display};

/// Heads of the table of the strip.
pub const STRIP_HEAD: [&str; 7] = [
    "uplift [mm]",
    "hold-down [kN/m]",
    "θ rim [rad]",
    "M rim [kNm/m]",
    "N [kN/m]",
    "lifted width [m]",
    "θ plastic [rad]",
];

/// Heads of the table of the whole base; three numbers a cell.
pub const TURN_HEAD: [&str; 4] = [
    "ψ [1e-3]",
    "moment [MNm]: k/3 / k / 3k",
    "lift [mm]",
    "toe stress [MPa]",
];

/// A number that was not found.
pub const NONE: &str = "–";

/// The plate has no yield stress.
pub const ELASTIC: &str =
    "the material of the bottom plate has no yield_strength: the plate stays elastic, and lifts less than it would";

/// Why there is nothing to lift, and what to do.
pub fn absent(cylinder: bool, plate: bool) -> (&'static str, &'static str) {
    match (cylinder, plate) {
        (true, _) => (
            "the base of a rectangle is not computed",
            "uplift of a bottom plate is for cylinders",
        ),
        (_, true) => (
            "`tank.bottom` is missing: without a bottom plate there is nothing to lift",
            "give its thickness and material",
        ),
        _ => (
            "the bottom is a slab, not a metal plate that lifts: it turns as a whole",
            "give a bottom plate of metal",
        ),
    }
}

/// The strip in a line.
pub fn strip(thickness: f64, pressure: f64, weight: f64, yields: bool) -> String {
    format!(
        "bottom plate {}{} under {}, wall and roof {}",
        display(thickness, Dimension::Length),
        if yields { "" } else { " (elastic)" },
        display(pressure, Dimension::Stress),
        display(weight, Dimension::LineForce)
    )
}

/// The ground in a line.
pub fn ground(modulus: f64, assumed: bool, waves: bool) -> String {
    let origin = match (assumed, waves) {
        (true, _) => "assumed: `tank.foundation` gives no stiffness",
        (_, true) => "from the velocity of shear waves, after Vesic",
        _ => "given",
    };
    format!(
        "ground under the rim {} ({origin})",
        display(modulus, Dimension::Subgrade)
    )
}
