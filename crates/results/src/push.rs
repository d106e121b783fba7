//! `push.json`: a pushover of a cylinder.

use files::code::Warning;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::store::{read_document, write_document};
use super::{Fact, SourceFile, TankSummary, Volatile, WallMap};
use files::error::Error;

/// Version of the format; a reader refuses any other.
pub const PUSH_FORMAT: &str = "tankcheck-push/1";
/// Name of the results.
pub const PUSH_FILE: &str = "push.json";

/// Everything in `push.json`. Values are SI; compression is positive.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Push {
    /// Format version, [`PUSH_FORMAT`].
    pub format: String,
    /// Fields that may differ between identical runs.
    pub volatile: Volatile,
    /// Title of the case.
    pub name: String,
    /// Cover of the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub project: Option<tank::Project>,
    /// Geometry for the sketch; none in results of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tank: Option<TankSummary>,
    /// Acceleration of free fall [m/s²].
    pub gravity: f64,
    /// Files read, with hashes.
    pub files: Vec<SourceFile>,
    /// The model in numbers.
    pub model: Vec<Fact>,
    /// Assumptions of the engine, one sentence each.
    pub assumptions: Vec<String>,
    /// Reasons to doubt the results, one sentence each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub doubts: Vec<Warning>,
    /// The perfect shell, then the imperfect ones.
    pub shells: Vec<PushShell>,
    /// Limits of formulas at the lower edges of the courses.
    pub limits: Vec<PushLimit>,
    /// The joint of wall and bottom plate of an unanchored tank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<PushJoint>,
    /// Whether the user stopped it before all was done.
    pub incomplete: bool,
    /// The missing part in words; empty if it is complete.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub interruption: String,
}

/// One shell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushShell {
    /// Its imperfection; `None` for the perfect one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub imperfection: Option<Imperfection>,
    /// States of equilibrium, the first static.
    pub path: Vec<PushPoint>,
    /// The strongest state.
    pub capacity: Capacity,
    /// Why the path ends, in words.
    pub end: String,
    /// Whether the user stopped it there.
    #[serde(default)]
    pub interrupted: bool,
    /// Radial displacement of the compressed meridian.
    pub meridians: Vec<PushMeridian>,
    /// The foot of an unanchored tank at the states that are drawn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub feet: Vec<PushFoot>,
    /// Accumulated plastic strain, the largest through the thickness, at the last state.
    pub plastic: WallMap,
}

/// An imperfection: a depression around the tank, or a buckling mode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Imperfection {
    /// Largest deviation [m], outwards positive.
    pub amplitude: f64,
    /// The same over the thickness there.
    pub over_thickness: f64,
    /// Height of its largest deviation [m].
    pub height: f64,
    /// Angle of that from the compressed meridian [rad]; `None` of one that goes around.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Half-wave of bending λ [m] of a weld depression.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_wave: Option<f64>,
    /// Multiple of the load of the perfect shell's capacity at which the elastic wall buckles in this mode.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// The deviation of a mode over the wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<WallMap>,
    /// Where shape and amplitude come from.
    pub source: String,
}

/// The foot of the wall of an unanchored tank around half of the circumference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushFoot {
    /// Which state.
    pub title: String,
    /// Acceleration [m/s²].
    pub acceleration: f64,
    /// Angles from the toe [rad].
    pub theta: Vec<f64>,
    /// Uplift of the foot there [m].
    pub w: Vec<f64>,
    /// The same of the strips at the same rotation and acceleration; empty where they have no equilibrium.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub strips: Vec<f64>,
}

/// A state of equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushPoint {
    /// Horizontal acceleration of ground and impulsive liquid [m/s²].
    pub acceleration: f64,
    /// Shear at the base [N].
    pub base_shear: f64,
    /// Overturning moment at the base, of the wall's pressure and mass [N m].
    pub base_moment: f64,
    /// Mean horizontal displacement of the top [m].
    pub top: f64,
    /// Radial displacement of the compressed meridian beyond the static state, where it is largest below the middle of the
    /// liquid [m].
    pub bulge: f64,
    /// Largest axial membrane compression of the compressed meridian [Pa].
    pub compression: f64,
    /// Its height [m].
    pub compression_height: f64,
    /// Largest accumulated plastic strain of the wall.
    pub plastic_strain: f64,
    /// The base of an unanchored tank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<PushBase>,
}

/// The base of an unanchored tank at a state; the toe is at θ = 0, the largest uplift at π.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushBase {
    /// Rotation ψ of the foot: the part of its deflection that is proportional to cos θ, over R [rad].
    pub rotation: f64,
    /// Moment that the wall exerts on the base, from the reactions of the ground less the pressure on the plate [N m].
    pub moment: f64,
    /// Reaction of the ground on the plates that are modelled [N].
    pub reaction: f64,
    /// Uplift of the foot at π [m].
    pub uplift: f64,
    /// Settlement of the foot at the toe [m].
    pub toe: f64,
    /// Width of the plate that is off the ground at π [m].
    pub lifted_width: f64,
    /// Angle over which the foot is off the ground, which carries nothing there [rad]: 2π of a foot that is off all around.
    pub lifted_angle: f64,
    /// Plastic rotation of the plate at its joint with the wall, at π [rad].
    pub plastic_rotation: f64,
    /// Plastic rotation of the wall at that joint, at π [rad].
    #[serde(default)]
    pub wall_rotation: f64,
    /// Axial membrane compression of the wall at the toe [Pa]: that of the lowest row of cells; where the foot is kept a plane, the constraint
    /// loads the wall there, and this is `toe_reaction`.
    #[serde(default)]
    pub toe_stress: f64,
    /// Reaction of the ground on the meridian of the toe less the pressure on the plate there, over the thickness of the lowest course [Pa]: that
    /// stress where the foot is free to warp.
    #[serde(default)]
    pub toe_reaction: f64,
    /// Moment of the strips at the same rotation and acceleration [N m]; `None` where they have no equilibrium.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strips: Option<f64>,
    /// The strips there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strip: Option<PushStrip>,
}

/// Strips side by side with the same rim, or the same plane foot, at the rotation and acceleration of a state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushStrip {
    /// Uplift at π [m].
    pub uplift: f64,
    /// Axial compression at the toe, force of the wall over the thickness of the lowest course [Pa].
    pub toe_stress: f64,
    /// The same where the rim settles as the toe of the shells does, under the pressure at rest [Pa].
    pub settled: f64,
    /// Plastic rotation of the plate at its joint with a wall that stays elastic, at π, under the pressure at rest [rad].
    pub plastic_rotation: f64,
}

/// The plastic rotation of the joint of wall and bottom plate beside the largest that a code allows: the perfect shell, lifted side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushJoint {
    /// Clause of the limit.
    pub source: String,
    /// Largest rotation allowed [rad].
    pub limit: f64,
    /// Largest rotation of the path [rad].
    pub largest: f64,
    /// Acceleration at which the limit is passed [m/s²], linear between states; `None` if the path ends before.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passed: Option<f64>,
}

impl PushBase {
    /// Plastic rotation of the joint of wall and plate, which turns in either [rad].
    pub fn joint_rotation(&self) -> f64 {
        self.plastic_rotation + self.wall_rotation
    }
}

impl PushJoint {
    /// The joint along the path of `shell`; `None` of a tank without a lifting base.
    pub fn of(shell: &PushShell, limit: f64, source: &str) -> Option<PushJoint> {
        let states: Vec<(f64, f64)> =
            shell.path.iter().filter_map(|p| Some((p.acceleration, p.base?.joint_rotation()))).collect();
        states.first()?;
        Some(PushJoint {
            source: source.into(),
            limit,
            largest: states.iter().map(|s| s.1).fold(0.0, f64::max),
            passed: passed(&states, limit),
        })
    }
}

/// Abscissa at which the ordinate of a polygon first passes `limit`.
fn passed(states: &[(f64, f64)], limit: f64) -> Option<f64> {
    if let Some(first) = states.first().filter(|s| s.1 > limit) {
        return Some(first.0);
    }
    states.windows(2).find(|w| w[1].1 > limit).map(|w| {
        let ((a, from), (b, to)) = (w[0], w[1]);
        a + (limit - from) / (to - from) * (b - a)
    })
}

/// The strongest state of a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Capacity {
    /// Whether the path has its maximum here; else it is a lower bound.
    pub limit: bool,
    /// The state.
    pub state: PushPoint,
    /// Height of the buckle [m]: where the plates yield most from here to the end of the path, or, if they do not, the wall moves most.
    pub height: f64,
    /// Its angle from the compressed meridian [rad].
    pub angle: f64,
    /// Thickness there [m].
    pub thickness: f64,
    /// Axial membrane compression of the compressed meridian at that height [Pa].
    pub compression: f64,
    /// Hoop membrane stress of that meridian at that height [Pa], tension positive.
    pub hoop: f64,
    /// Pressure of the liquid on that meridian at that height, static and impulsive [Pa].
    pub pressure: f64,
    /// M/(π R² t) and weight at the base [Pa]: the axial compression of beam theory.
    pub beam: f64,
}

/// Radial displacements along the compressed meridian.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushMeridian {
    /// Which state.
    pub title: String,
    /// Acceleration [m/s²].
    pub acceleration: f64,
    /// Heights [m].
    pub z: Vec<f64>,
    /// Outwards [m].
    pub w: Vec<f64>,
}

/// A formula at the lower edge of a course, under the beam stress of rising acceleration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PushLimit {
    /// Name.
    pub name: String,
    /// Clause or author.
    pub source: String,
    /// Acceleration at which the beam stress reaches the limit at the governing course [m/s²]; `None` if none does below 10 g.
    pub acceleration: Option<f64>,
    /// Governing course, from 1.
    pub course: usize,
    /// Height of its lower edge [m].
    pub height: f64,
    /// The limit there [Pa], at that acceleration.
    pub stress: f64,
}

/// Reads the results of a pushover from `path`.
///
/// Errors: an unreadable file, text that is not JSON, another format version.
pub fn read_push(path: &Path) -> Result<Push, Error> {
    read_document(path, PUSH_FORMAT, "a pushover")
}

/// Writes `push` to `path`, whole or not at all; 10 significant digits.
///
/// Errors: a file that cannot be written.
pub fn write_push(path: &Path, push: &Push) -> Result<(), Error> {
    write_document(path, push)
}

#[cfg(test)]
mod tests {
    use super::passed;

    #[test]
    fn a_limit_is_passed_between_states() {
        let path = [(0.0, 0.0), (1.0, 0.1), (2.0, 0.3), (1.5, 0.4)];
        assert!((passed(&path, 0.2).unwrap() - 1.5).abs() < 1e-12);
        // On the falling branch the acceleration is that of the state, not the larger one before it.
        assert!((passed(&path, 0.35).unwrap() - 1.75).abs() < 1e-12);
        assert_eq!(passed(&path, 0.4), None);
        assert_eq!(passed(&[(0.5, 0.3)], 0.2), Some(0.5));
        assert_eq!(passed(&[], 0.2), None);
    }
}
