//! The command `base`.

use tank::units::{Dimension, display, significant};

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
pub const TURN_HEAD: [&str; 4] = ["ψ [1e-3]", "moment [MNm]: k/3 / k / 3k", "lift [mm]", "toe stress [MPa]"];

/// What the heads of the table of the strip mean.
pub const STRIP_HEADS: &str = "uplift of the rim from the unloaded ground; hold-down: pull of the plate on the wall; θ rim, M rim and N: rotation, bending \
     moment and membrane force of the plate at the rim; lifted width: from the rim to the ground; θ plastic: rotation of the plastic joint\n\
     θ rim is that of the foot of the wall, positive where the plate rises outwards: M rim turns it outwards, N and the pressure on the wall turn it inwards, \
     so that it rises with the first uplift and falls once the joint has yielded";

/// What the heads of the table of the base mean.
pub const TURN_HEADS: &str = "ψ: rotation of the base in 1e-3 rad; moment: overturning moment that turns it so far, on ground of k/3, k and 3k, as in \
     every cell; lift: uplift of the lifted side; toe stress: axial compression of the lowest course on the other side";

/// Corrosion takes part of the plates or of the wall.
pub const AS_BUILT: &str =
    "plates and wall are those as built; the sheets of `check` and the report take them less corrosion, and lift more";

/// The tank has anchors.
pub const ANCHORS: &str = "`tank.anchors` are left out: this is the base without its anchors";

/// Why an uplift [m] has no row.
pub fn no_uplift(uplift: f64, error: &str) -> String {
    format!("{NONE} uplift {}: {error}", display(uplift, Dimension::Length))
}

/// Why rotations from this one [rad] have no numbers on a ground of this modulus [N/m³].
pub fn no_turn(rotation: f64, modulus: f64, error: &str) -> String {
    format!(
        "{NONE} on ground of {} from ψ = {} rad: {error}",
        display(modulus, Dimension::Subgrade),
        significant(rotation, 3)
    )
}

/// A number that was not found.
pub const NONE: &str = "–";

/// Strips that do not hold, for this reason.
pub fn softened(reason: &str) -> String {
    format!("moment, lift and toe stress of the rotations do not hold: {reason}; `tankcheck push` has shells")
}

/// The plate has no yield stress.
pub const ELASTIC: &str =
    "the material of the bottom plate has no yield_strength: the plate stays elastic, and lifts less than it would";

/// A tank on a staging.
pub const ELEVATED: (&str, &str) =
    ("not applicable: the tank stands on a staging and has no base on the ground", "remove tank.staging");

/// Why there is nothing to lift, and what to do.
pub fn absent(cylinder: bool, plate: bool) -> (&'static str, &'static str) {
    match (cylinder, plate) {
        (true, _) => ("the base of a rectangle is not computed", "uplift of a bottom plate is for cylinders"),
        (_, true) => (
            "`tank.bottom` is missing: without a bottom plate there is nothing to lift",
            "give its thickness and material",
        ),
        _ => {
            ("the bottom is a slab, not a metal plate that lifts: it turns as a whole", "give a bottom plate of metal")
        }
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
    format!("ground under the rim {} ({origin})", display(modulus, Dimension::Subgrade))
}
