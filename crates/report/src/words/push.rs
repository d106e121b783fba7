//! The page of a pushover and its summary on the terminal.

use tank::units::Dimension;

use super::capital;
use crate::number::{fixed, significant, with_unit};
use results::{Push, PushJoint, PushShell};

/// Parts of the page: id and title.
pub const PARTS: [(&str, &str); 4] = [
    ("model", "Model and assumptions"),
    ("capacity", "Capacity"),
    ("base", "Base"),
    ("pictures", "Path, buckle and yielding"),
];

/// Axes of the figure of the foot.
pub const FOOT_AXES: [&str; 2] = ["angle from the toe [°]", "uplift of the foot"];

/// Heads of the table of capacities.
pub mod heads {
    /// Angle of the buckle.
    pub const ANGLE: &str = "and at the angle";
    /// Stress at the buckle.
    pub const COMPRESSION: &str = "Axial compression at that height";
    /// Moment of the strips.
    pub const STRIPS: &str = "Moment of the strips";
    /// The same of the strips.
    pub use super::OF_STRIPS;
    /// Rotation of the joint by the plate.
    pub const PLATE: &str = "Plastic rotation of the plate";
    /// Rotation of the joint by the wall.
    pub const WALL: &str = "Plastic rotation of the wall";
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
/// Caption of a foot.
pub const FOOT: &str = "Compressed at 0°, lifted at 180°; above 0 the ground carries nothing.";
/// Description of a foot.
pub const FOOT_DESCRIPTION: &str =
    "Uplift of the foot of the wall around half of the circumference, of shells and strips.";
/// Head of the uplift of the strips.
pub const OF_STRIPS: &str = "of the strips";
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

/// Title of a foot.
pub fn foot(shell: &PushShell) -> String {
    format!("Foot of the wall, {}", shell_name(shell))
}

/// The strips at a state.
pub fn strips_of(state: &str) -> String {
    format!("strips, {state}")
}

/// `perfect shell`, `0.50 t outwards at 0.35 m`, `0.50 t, buckling mode`.
pub fn shell_name(shell: &PushShell) -> String {
    shell.imperfection.as_ref().map_or("perfect shell".into(), |i| {
        if i.factor.is_some() {
            return format!("{} t, buckling mode", fixed(i.over_thickness, 2));
        }
        let side = if i.amplitude > 0.0 { "outwards" } else { "inwards" };
        format!("{} t {side} at {}", fixed(i.over_thickness.abs(), 2), with_unit(i.height, Dimension::Length))
    })
}

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
    let bound = if shell.capacity.limit { "" } else { " No maximum was passed: the capacity is a lower bound." };
    let imperfection = shell.imperfection.as_ref().map_or(String::new(), |i| {
        format!(" Imperfection of {} ({}).", with_unit(i.amplitude.abs(), Dimension::Length), i.source)
    });
    format!("{}: {}.{bound}{imperfection}", shell_name(shell), shell.end)
}

/// The weakest shell.
fn weakest(push: &Push) -> Option<&PushShell> {
    let most = |shell: &&PushShell| shell.capacity.state.acceleration;
    push.shells.iter().min_by(|a, b| most(a).total_cmp(&most(b)))
}

/// `perfect shell, ≥ 0.312 g`.
pub fn capacity(push: &Push, shell: &PushShell) -> String {
    format!("{}, {}", shell_name(shell), strength(push, shell))
}

/// `≥ 0.312 g`: its strongest state, or a lower bound of it.
fn strength(push: &Push, shell: &PushShell) -> String {
    let bound = if shell.capacity.limit { "" } else { "≥ " };
    format!("{bound}{} g", significant(shell.capacity.state.acceleration / push.gravity, 3))
}

/// The least capacity.
pub fn headline(push: &Push) -> String {
    if push.incomplete {
        return format!("Incomplete: {}", push.interruption);
    }
    match weakest(push) {
        Some(shell) => format!("Capacity {}: {}", strength(push, shell), shell_name(shell)),
        None => "No shell was loaded".into(),
    }
}

/// The other shells, the joint, and what the page is not.
pub fn lines(push: &Push) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let least = weakest(push).filter(|_| !push.incomplete);
    for shell in push.shells.iter().filter(|shell| least != Some(shell)) {
        lines.push(format!("{}.", capital(&capacity(push, shell))));
    }
    lines.extend(push.joint.as_ref().map(|j| format!("{}.", capital(&joint(j, push.gravity)))));
    lines.push(
        "Horizontal acceleration of ground and impulsive liquid. A pushover finds the strength of the wall; `tankcheck compare` checks \
         the limit states of the codes."
            .into(),
    );
    lines
}

/// Key figures at the least capacity.
pub fn facts(push: &Push) -> Vec<(&'static str, String)> {
    let Some(shell) = weakest(push) else { return Vec::new() };
    let state = &shell.capacity.state;
    vec![
        ("Base shear", with_unit(state.base_shear, Dimension::Force)),
        ("Overturning moment", with_unit(state.base_moment, Dimension::Moment)),
        ("Buckle at", with_unit(shell.capacity.height, Dimension::Length)),
    ]
}
