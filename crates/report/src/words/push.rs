//! The page of a pushover and its summary on the terminal.

use tank::units::Dimension;

use crate::number::{fixed, significant, with_unit};
use results::{PushJoint, PushShell};

/// Heads of the table of capacities.
pub mod heads {
    /// Angle of the buckle.
    pub const ANGLE: &str = "and at the angle";
    /// Stress at the buckle.
    pub const COMPRESSION: &str = "Axial compression at that height";
    /// Moment of the strips.
    pub const STRIPS: &str = "Moment of the strips";
    /// The same of the strips.
    pub const OF_STRIPS: &str = "of the strips";
    /// Stress of beam theory.
    pub const BEAM: &str = "of beam theory at the base";
}

/// Displacement of the compressed meridian that the path is drawn over.
pub const BULGE: &str = "bulge of the compressed meridian";
/// Stress that the path is drawn over.
pub const COMPRESSION: &str = "largest axial compression";
/// Caption of a path.
pub const PATH: &str = "Marked: the strongest state.";
/// Caption of a meridian.
pub const MERIDIAN: &str = "Outwards to the right.";
/// Description of a meridian.
pub const MERIDIAN_DESCRIPTION: &str =
    "Radial displacement of the compressed meridian over the height: static, strongest and last state.";
/// Caption of a map.
pub const MAP: &str = "Half of the developed wall, compressed at θ = 0.";

/// Description of a path.
pub fn path(title: &str) -> String {
    format!("Acceleration over: {title}.")
}

/// Title of a meridian.
pub fn meridian(shell: &PushShell) -> String {
    format!("Compressed meridian, {}", shell_name(shell))
}

/// `perfect shell`, `0.50 t outwards at 0.35 m`, `0.50 t, buckling mode`.
pub fn shell_name(shell: &PushShell) -> String {
    shell.imperfection.as_ref().map_or("perfect shell".into(), |i| {
        if i.factor.is_some() {
            return format!("{} t, buckling mode", fixed(i.over_thickness, 2));
        }
        let side = if i.amplitude > 0.0 { "outwards" } else { "inwards" };
        format!(
            "{} t {side} at {}",
            fixed(i.over_thickness.abs(), 2),
            with_unit(i.height, Dimension::Length)
        )
    })
}

/// Acceleration at which a formula is reached that governs below 10 g nowhere.
pub const BEYOND: &str = "beyond 10 g";

/// The joint of wall and bottom plate against its limit; `gravity` in m/s².
pub fn joint(joint: &PushJoint, gravity: f64) -> String {
    let (limit, source) = (fixed(joint.limit, 2), &joint.source);
    let largest = fixed(joint.largest, 3);
    match joint.passed {
        Some(at) => format!(
            "joint of wall and bottom plate: its plastic rotation passes {limit} rad ({source}) at {} g; the largest of the path is \
             {largest} rad",
            significant(at / gravity, 3)
        ),
        None => format!(
            "joint of wall and bottom plate: the largest plastic rotation of the path is {largest} rad; {limit} rad ({source}) is not reached"
        ),
    }
}

/// How the path of a shell ends, and its imperfection.
pub fn end(shell: &PushShell) -> String {
    let bound = match shell.capacity.limit {
        true => "",
        false => " No maximum was passed: the capacity is a lower bound.",
    };
    let imperfection = shell.imperfection.as_ref().map_or(String::new(), |i| {
        format!(
            " Imperfection of {} ({}).",
            with_unit(i.amplitude.abs(), Dimension::Length),
            i.source
        )
    });
    format!("{}: {}.{bound}{imperfection}", shell_name(shell), shell.end)
}
