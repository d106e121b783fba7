//! Histories and envelopes of engines: each is a [`Channel`], whose id, title, dimension and sign are defined here alone.
//!
//! Signs: tension positive; liquid pressure positive in compression; reactions positive as inertia forces of a positive
//! acceleration; displacements outwards, waves upwards. Values over the height are those at θ = 0.

mod ground;
mod on_wall;

use tank::Quantity;
use tank::units::{Dimension, display};

pub use ground::{GROUND_COLUMNS, Ground, VERTICAL_PREFIX};
pub use on_wall::OnWall;

/// Beginning of the ids of open shares.
const OPEN: &str = "open_share";
/// Beginning of the ids of wave heights.
const WAVE_HEIGHT: &str = "wave_height";
/// Id of the base shear.
const BASE_SHEAR: &str = "base_shear";
/// Id of the moment above the base plate.
const BASE_MOMENT: &str = "base_moment";
/// End of the ids of components along y.
const ALONG_Y: &str = "_y";
/// Before the angle in ids.
const ANGLE: &str = "_theta_";
/// Id of the moment below the base plate.
const OVERTURNING_MOMENT: &str = "overturning_moment";

/// Beginning of the ids of bending moments of the wall.
const WALL_MOMENT: &str = "wall_moment";

/// A side of the tank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// θ = 0.
    Front,
    /// θ = 180°.
    Back,
}

impl Side {
    /// Both sides.
    pub const BOTH: [Side; 2] = [Side::Front, Side::Back];

    /// As a suffix of ids.
    pub fn id(self) -> &'static str {
        match self {
            Side::Front => "theta_0",
            Side::Back => "theta_180",
        }
    }

    /// As titles have it.
    fn title(self) -> &'static str {
        match self {
            Side::Front => "θ = 0°",
            Side::Back => "θ = 180°",
        }
    }
}

/// A horizontal force or a moment on the base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnBase {
    /// Base shear.
    Shear,
    /// Moment above the base plate.
    Moment,
    /// Moment below the base plate.
    Overturning,
}

impl OnBase {
    /// All of them.
    pub const ALL: [OnBase; 3] = [OnBase::Shear, OnBase::Moment, OnBase::Overturning];

    /// The channel of its component along x.
    pub fn along(self) -> Channel {
        match self {
            OnBase::Shear => Channel::BaseShear,
            OnBase::Moment => Channel::BaseMoment,
            OnBase::Overturning => Channel::OverturningMoment,
        }
    }
}

/// A scalar that an engine records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Channel {
    /// Motion of the ground.
    Ground {
        /// Which component.
        motion: Ground,
        /// That of the vertical record.
        vertical: bool,
    },
    /// Motion of the ground along y.
    GroundY(Ground),
    /// Wave height at the wall.
    Wave(Side),
    /// Wave height at the wall at an angle.
    WaveAround {
        /// θ [°].
        degrees: f64,
    },
    /// Largest wave height around the wall.
    WaveLargest,
    /// Wave height at a gauge.
    WaveAt {
        /// Radius (or x) in the direction of shaking [m].
        r: f64,
    },
    /// Base shear.
    BaseShear,
    /// Moment above the base plate.
    BaseMoment,
    /// Moment below the base plate.
    OverturningMoment,
    /// Component along y of a force or moment on the base.
    Y(OnBase),
    /// Resultant of both horizontal components of a force or moment on the base.
    Resultant(OnBase),
    /// The largest over the height.
    Largest {
        /// The quantity.
        what: OnWall,
        /// Where it is largest [m].
        z: f64,
    },
    /// At a station.
    At {
        /// The quantity.
        what: OnWall,
        /// Height above the base [m].
        z: f64,
    },
    /// At a station and an angle.
    AtAngle {
        /// The quantity.
        what: OnWall,
        /// Height above the base [m].
        z: f64,
        /// θ [°].
        degrees: f64,
    },
    /// At the base at an angle.
    BaseAtAngle {
        /// The quantity.
        what: OnWall,
        /// θ [°].
        degrees: f64,
    },
    /// At the base.
    Base(OnWall),
    /// At the base of one side.
    BaseOn(OnWall, Side),
    /// Bending moment of the lowest section of a strip's wall, the integral of its stresses.
    SectionMoment(Side),
    /// Radial displacement of the top of a cylinder's wall at θ = 0.
    Top,
    /// Radial displacement of a cylinder's wall at a third of its levels at θ = 0.
    Belly,
    /// Deflection of the top of a strip's wall.
    Deflection(Side),
    /// Share of the wetted wall of a cylinder that the liquid has left.
    Open,
    /// Share of the wetted wall of one side of a strip that the liquid has left.
    OpenOn(Side),
    /// Displacement of the isolators along x.
    IsolatorDisplacement,
    /// Displacement of the isolators along y.
    IsolatorDisplacementY,
    /// Force of the isolators along x.
    IsolatorForce,
    /// Force of the isolators along y.
    IsolatorForceY,
    /// Rotation of the base.
    BaseRotation,
    /// Displacement of the rim upwards, from the ground without load.
    Uplift(Side),
    /// Plastic rotation of the joint between wall and bottom plate, positive where the plate lifts.
    PlasticRotation(Side),
    /// Axial stress of the wall at the toe, compression.
    ToeStress,
    /// Slip of the base against the ground.
    Slip,
    /// Force of the anchor that pulls most.
    AnchorForce,
    /// Translation of a slab on soil, relative to the free field.
    FoundationTranslation,
    /// Rotation of a slab on soil.
    FoundationRotation,
}

impl Channel {
    /// Those that are compared between methods, each under its [`Channel::quantity`].
    pub const COMPARED: [Channel; 8] = [
        Channel::Wave(Side::Front),
        Channel::Wave(Side::Back),
        Channel::BaseShear,
        Channel::BaseMoment,
        Channel::OverturningMoment,
        Channel::Largest { what: OnWall::Hoop, z: 0.0 },
        Channel::Base(OnWall::Axial),
        Channel::Base(OnWall::Bending),
    ];

    /// Whether it is the wave at the wall, of either side.
    pub fn is_wave_at_wall(self) -> bool {
        matches!(self, Channel::Wave(_))
    }

    /// Id: name of the column in `series.csv`, without the prefix of its engine.
    pub fn id(self) -> String {
        match self {
            Channel::Ground { motion, vertical } => {
                let prefix = if vertical { VERTICAL_PREFIX } else { "" };
                format!("{prefix}{}", motion.id())
            }
            Channel::GroundY(motion) => format!("{}{ALONG_Y}", motion.id()),
            Channel::Y(what) => format!("{}{ALONG_Y}", what.along().id()),
            Channel::Resultant(what) => format!("{}_resultant", what.along().id()),
            Channel::Wave(side) => format!("{WAVE_HEIGHT}_{}", side.id()),
            Channel::WaveAround { degrees } => format!("{WAVE_HEIGHT}{ANGLE}{degrees}"),
            Channel::WaveLargest => format!("{WAVE_HEIGHT}_largest"),
            Channel::WaveAt { r } => format!("{WAVE_HEIGHT}_r_{r}"),
            Channel::BaseShear => BASE_SHEAR.into(),
            Channel::BaseMoment => BASE_MOMENT.into(),
            Channel::OverturningMoment => OVERTURNING_MOMENT.into(),
            Channel::Largest { what, .. } => what.id().into(),
            Channel::At { what, z } => format!("{}_z_{z}", what.id()),
            Channel::AtAngle { what, z, degrees } => format!("{}_z_{z}{ANGLE}{degrees}", what.id()),
            Channel::BaseAtAngle { what, degrees } => format!("{}_base{ANGLE}{degrees}", what.id()),
            Channel::Base(what) => format!("{}_base", what.id()),
            Channel::BaseOn(what, side) => format!("{}_base_{}", what.id(), side.id()),
            Channel::SectionMoment(side) => format!("{WALL_MOMENT}_section_{}", side.id()),
            Channel::Top => "top_displacement".into(),
            Channel::Belly => "belly_displacement".into(),
            Channel::Deflection(side) => format!("wall_displacement_{}", side.id()),
            Channel::Open => OPEN.into(),
            Channel::OpenOn(side) => format!("{OPEN}_{}", side.id()),
            Channel::IsolatorDisplacement => "isolator_displacement".into(),
            Channel::IsolatorDisplacementY => "isolator_displacement_y".into(),
            Channel::IsolatorForce => "isolator_force".into(),
            Channel::IsolatorForceY => "isolator_force_y".into(),
            Channel::BaseRotation => "base_rotation".into(),
            Channel::Uplift(side) => format!("uplift_{}", side.id()),
            Channel::PlasticRotation(side) => format!("plastic_rotation_{}", side.id()),
            Channel::ToeStress => "toe_axial_stress".into(),
            Channel::Slip => "slip".into(),
            Channel::AnchorForce => "anchor_force".into(),
            Channel::FoundationTranslation => "foundation_translation".into(),
            Channel::FoundationRotation => "foundation_rotation".into(),
        }
    }

    /// The channel of an id; the height of a [`Channel::Largest`], which is not part of its id, is 0.
    pub fn from_id(id: &str) -> Option<Channel> {
        let plain = Channel::plain().find(|channel| channel.id() == id);
        let number = |prefix: &str| id.strip_prefix(prefix)?.parse().ok();
        let wave = || Some(Channel::WaveAt { r: number(&format!("{WAVE_HEIGHT}_r_"))? });
        let at = |&what: &OnWall| Some(Channel::At { what, z: number(&format!("{}_z_", what.id()))? });
        let around = || Some(Channel::WaveAround { degrees: number(&format!("{WAVE_HEIGHT}{ANGLE}"))? });
        let at_angle = |&what: &OnWall| {
            let (before, degrees) = id.split_once(ANGLE)?;
            let degrees = degrees.parse().ok()?;
            if before.strip_prefix(what.id())? == "_base" {
                return Some(Channel::BaseAtAngle { what, degrees });
            }
            let z = before.strip_prefix(&format!("{}_z_", what.id()))?.parse().ok()?;
            Some(Channel::AtAngle { what, z, degrees })
        };
        plain
            .or_else(wave)
            .or_else(|| OnWall::ALL.iter().find_map(at))
            .or_else(around)
            .or_else(|| OnWall::ALL.iter().find_map(at_angle))
    }

    /// All channels whose id has no number.
    fn plain() -> impl Iterator<Item = Channel> {
        let ground = [false, true]
            .into_iter()
            .flat_map(|vertical| Ground::ALL.map(|motion| Channel::Ground { motion, vertical }));
        let on_wall = OnWall::ALL.into_iter().flat_map(|what| {
            let [front, back] = Side::BOTH.map(|side| Channel::BaseOn(what, side));
            [Channel::Largest { what, z: 0.0 }, Channel::Base(what), front, back]
        });
        let sides = Side::BOTH.into_iter().flat_map(|side| {
            [
                Channel::Wave(side),
                Channel::SectionMoment(side),
                Channel::Deflection(side),
                Channel::OpenOn(side),
                Channel::Uplift(side),
                Channel::PlasticRotation(side),
            ]
        });
        let across = Ground::ALL.map(Channel::GroundY);
        let on_base = OnBase::ALL.into_iter().flat_map(|what| [Channel::Y(what), Channel::Resultant(what)]);
        let others = [
            Channel::WaveLargest,
            Channel::BaseShear,
            Channel::BaseMoment,
            Channel::OverturningMoment,
            Channel::Top,
            Channel::Belly,
            Channel::Open,
            Channel::IsolatorDisplacement,
            Channel::IsolatorDisplacementY,
            Channel::IsolatorForce,
            Channel::IsolatorForceY,
            Channel::BaseRotation,
            Channel::ToeStress,
            Channel::Slip,
            Channel::AnchorForce,
            Channel::FoundationTranslation,
            Channel::FoundationRotation,
        ];
        ground.chain(on_wall).chain(sides).chain(others).chain(across).chain(on_base)
    }

    /// Title.
    pub fn title(self) -> String {
        match self {
            Channel::Ground { motion, vertical } => {
                let direction = if vertical { ", vertical" } else { "" };
                format!("{}{direction}", motion.title())
            }
            Channel::GroundY(motion) => format!("{}, y", motion.title()),
            Channel::Y(what) => format!("{}, y", what.along().title()),
            Channel::Resultant(what) => format!("{}, resultant of x and y", what.along().title()),
            Channel::Wave(side) => format!("Wave height at the wall, {}", side.title()),
            Channel::WaveAround { degrees } => format!("Wave height at the wall, θ = {degrees}°"),
            Channel::WaveLargest => "Wave height at the wall, largest around the circumference".into(),
            Channel::WaveAt { r } => format!("Wave height at {r} m from the centre"),
            Channel::BaseShear => "Base shear".into(),
            Channel::BaseMoment => "Moment above the base plate".into(),
            Channel::OverturningMoment => "Moment below the base plate".into(),
            Channel::Largest { what, z } => {
                format!("{} at z = {} (largest over the height)", what.title(), display(z, Dimension::Length))
            }
            Channel::At { what, z } => format!("{} at z = {z} m", what.title()),
            Channel::AtAngle { what, z, degrees } => format!("{} at z = {z} m, θ = {degrees}°", what.title()),
            Channel::BaseAtAngle { what, degrees } => format!("{} at the base, θ = {degrees}°", what.title()),
            Channel::Base(what) => format!("{} at the base", what.title()),
            Channel::BaseOn(what, side) => format!("{}, {}", Channel::Base(what).title(), side.title()),
            Channel::SectionMoment(side) => {
                format!("Bending moment of the lowest section of the wall, {}", side.title())
            }
            Channel::Top => "Radial displacement of the top of the wall, θ = 0°".into(),
            Channel::Belly => "Radial displacement at a third of the levels of the wall, θ = 0°".into(),
            Channel::Deflection(side) => format!("Deflection of the top of the wall, {}", side.title()),
            Channel::Open => "Share of the wetted wall that the liquid has left".into(),
            Channel::OpenOn(side) => format!("Share of the wetted wall that the liquid has left, {}", side.title()),
            Channel::IsolatorDisplacement => "Displacement of the isolators".into(),
            Channel::IsolatorDisplacementY => "Displacement of the isolators, y".into(),
            Channel::IsolatorForce => "Force of the isolators".into(),
            Channel::IsolatorForceY => "Force of the isolators, y".into(),
            Channel::BaseRotation => "Rotation of the base, with uplift".into(),
            Channel::Uplift(side) => format!("Uplift of the rim, {}", side.title()),
            Channel::PlasticRotation(side) => format!("Plastic rotation of the joint, {}", side.title()),
            Channel::ToeStress => "Axial stress at the toe, compression, with uplift".into(),
            Channel::Slip => "Slip of the base".into(),
            Channel::AnchorForce => "Force of the anchor that pulls most".into(),
            Channel::FoundationTranslation => "Translation of the slab on soil".into(),
            Channel::FoundationRotation => "Rotation of the slab on soil".into(),
        }
    }

    /// Dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Channel::Y(what) | Channel::Resultant(what) => what.along().dimension(),
            Channel::Ground { motion, .. } | Channel::GroundY(motion) => motion.dimension(),
            Channel::BaseShear => Dimension::Force,
            Channel::BaseMoment | Channel::OverturningMoment => Dimension::Moment,
            Channel::Largest { what, .. }
            | Channel::At { what, .. }
            | Channel::AtAngle { what, .. }
            | Channel::BaseAtAngle { what, .. }
            | Channel::Base(what)
            | Channel::BaseOn(what, _) => what.dimension(),
            Channel::IsolatorForce | Channel::IsolatorForceY | Channel::AnchorForce => Dimension::Force,
            Channel::IsolatorDisplacement | Channel::IsolatorDisplacementY => Dimension::Length,
            Channel::SectionMoment(_) => Dimension::LineMoment,
            Channel::WaveAround { .. } | Channel::WaveLargest => Dimension::Length,
            Channel::Open | Channel::OpenOn(_) => Dimension::Dimensionless,
            Channel::BaseRotation | Channel::PlasticRotation(_) | Channel::FoundationRotation => Dimension::Angle,
            Channel::ToeStress => Dimension::Stress,
            Channel::Uplift(_) | Channel::Slip | Channel::FoundationTranslation => Dimension::Length,
            Channel::Wave(_) | Channel::WaveAt { .. } | Channel::Top | Channel::Belly | Channel::Deflection(_) => {
                Dimension::Length
            }
        }
    }

    /// Whether it is a wave height.
    pub fn is_wave(self) -> bool {
        matches!(self, Channel::Wave(_) | Channel::WaveAt { .. } | Channel::WaveAround { .. } | Channel::WaveLargest)
    }

    /// Its value of the wall, if it is one.
    pub fn on_wall(self) -> Option<OnWall> {
        match self {
            Channel::Largest { what, .. }
            | Channel::At { what, .. }
            | Channel::AtAngle { what, .. }
            | Channel::BaseAtAngle { what, .. }
            | Channel::Base(what)
            | Channel::BaseOn(what, _) => Some(what),
            Channel::SectionMoment(_) => Some(OnWall::Moment),
            _ => None,
        }
    }

    /// The quantity, height [m] and angle [°] of an internal force at a station.
    pub fn force_at(self) -> Option<(OnWall, f64, f64)> {
        match self {
            Channel::AtAngle { what, z, degrees } if OnWall::FORCES.contains(&what) => Some((what, z, degrees)),
            _ => None,
        }
    }

    /// The quantity of the comparison whose extreme it has.
    pub fn quantity(self) -> Option<Quantity> {
        Some(match self {
            Channel::Wave(_) => Quantity::SloshingHeight,
            Channel::BaseShear => Quantity::BaseShear,
            Channel::BaseMoment => Quantity::BaseMoment,
            Channel::OverturningMoment => Quantity::OverturningMoment,
            Channel::Largest { what: OnWall::Hoop, .. } => Quantity::HoopStress,
            Channel::Base(OnWall::Axial) | Channel::BaseOn(OnWall::Axial, _) => Quantity::AxialMembraneStress,
            Channel::Base(OnWall::Bending) => Quantity::BendingStress,
            _ => return None,
        })
    }

    /// The quantity of the comparison that the history of this id shows, if it is one of [`Channel::COMPARED`].
    pub fn compared(id: &str) -> Option<Quantity> {
        let found = Channel::COMPARED.iter().find(|channel| channel.id() == id)?;
        found.quantity()
    }
}

#[cfg(test)]
mod tests;
