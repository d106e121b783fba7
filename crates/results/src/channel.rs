//! Histories and envelopes of engines: each is a [`Channel`], whose id, title, dimension and sign are defined here alone.
//!
//! Signs: tension positive; liquid pressure positive in compression; reactions positive as inertia forces of a positive
//! acceleration; displacements outwards, waves upwards. Values over the height are those at θ = 0.

use tank::Quantity;
use tank::units::{Dimension, display};

/// Columns of `series.csv` that hold the ground motion as computed with: acceleration [m/s²], velocity [m/s],
/// displacement [m]; those of a vertical record carry [`VERTICAL_PREFIX`].
pub const GROUND_COLUMNS: [&str; 3] = ["ground_acceleration", "ground_velocity", "ground_displacement"];
/// Prefix of [`GROUND_COLUMNS`] for the vertical record.
pub const VERTICAL_PREFIX: &str = "vertical_";

/// Beginning of the ids of wave heights.
const WAVE_HEIGHT: &str = "wave_height";
/// Id of the base shear.
const BASE_SHEAR: &str = "base_shear";
/// Id of the moment above the base plate.
const BASE_MOMENT: &str = "base_moment";
/// Id of the moment below the base plate.
const OVERTURNING_MOMENT: &str = "overturning_moment";

/// Beginning of the ids of axial membrane stresses.
const AXIAL_MEMBRANE_STRESS: &str = "axial_membrane_stress";
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

/// A component of the motion of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Acceleration [m/s²].
    Acceleration,
    /// Velocity [m/s].
    Velocity,
    /// Displacement [m].
    Displacement,
}

/// A quantity over the height of the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnWall {
    /// Hydrodynamic pressure [Pa].
    Pressure,
    /// Hoop membrane stress [Pa].
    Hoop,
    /// Axial membrane stress [Pa].
    Axial,
    /// Meridional bending stress at the outer face [Pa].
    Bending,
    /// Radial displacement [m].
    Displacement,
    /// Meridional bending moment [N m/m].
    Moment,
    /// Shear force [N/m].
    Shear,
}

impl Ground {
    /// All components, in the order of [`GROUND_COLUMNS`].
    pub const ALL: [Ground; 3] = [Ground::Acceleration, Ground::Velocity, Ground::Displacement];
}

impl OnWall {
    /// All of them.
    pub const ALL: [OnWall; 7] = [
        OnWall::Pressure,
        OnWall::Hoop,
        OnWall::Axial,
        OnWall::Bending,
        OnWall::Displacement,
        OnWall::Moment,
        OnWall::Shear,
    ];

    /// Id of the envelope.
    pub fn id(self) -> &'static str {
        match self {
            OnWall::Pressure => "pressure",
            OnWall::Hoop => "hoop_stress",
            OnWall::Axial => AXIAL_MEMBRANE_STRESS,
            OnWall::Bending => "bending_stress",
            OnWall::Displacement => "radial_displacement",
            OnWall::Moment => WALL_MOMENT,
            OnWall::Shear => "wall_shear",
        }
    }

    /// Title.
    pub fn title(self) -> &'static str {
        match self {
            OnWall::Pressure => "Hydrodynamic pressure on the wall",
            OnWall::Hoop => "Hoop membrane stress",
            OnWall::Axial => "Axial membrane stress",
            OnWall::Bending => "Meridional bending stress, outer face",
            OnWall::Displacement => "Radial displacement",
            OnWall::Moment => "Meridional bending moment of the wall",
            OnWall::Shear => "Shear force of the wall",
        }
    }

    /// Dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            OnWall::Pressure | OnWall::Hoop | OnWall::Axial | OnWall::Bending => Dimension::Stress,
            OnWall::Displacement => Dimension::Length,
            OnWall::Moment => Dimension::LineMoment,
            OnWall::Shear => Dimension::LineForce,
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
    /// Wave height at the wall.
    Wave(Side),
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
}

impl Channel {
    /// Those that are compared between methods, each under its [`Channel::quantity`].
    pub const COMPARED: [Channel; 8] = [
        Channel::Wave(Side::Front),
        Channel::Wave(Side::Back),
        Channel::BaseShear,
        Channel::BaseMoment,
        Channel::OverturningMoment,
        Channel::Largest {
            what: OnWall::Hoop,
            z: 0.0,
        },
        Channel::Base(OnWall::Axial),
        Channel::Base(OnWall::Bending),
    ];

    /// Id: name of the column in `series.csv`, without the prefix of its engine.
    pub fn id(self) -> String {
        match self {
            Channel::Ground { motion, vertical } => {
                let id = GROUND_COLUMNS[motion as usize];
                let prefix = if vertical { VERTICAL_PREFIX } else { "" };
                format!("{prefix}{id}")
            }
            Channel::Wave(side) => format!("{WAVE_HEIGHT}_{}", side.id()),
            Channel::WaveAt { r } => format!("{WAVE_HEIGHT}_r_{r}"),
            Channel::BaseShear => BASE_SHEAR.into(),
            Channel::BaseMoment => BASE_MOMENT.into(),
            Channel::OverturningMoment => OVERTURNING_MOMENT.into(),
            Channel::Largest { what, .. } => what.id().into(),
            Channel::At { what, z } => format!("{}_z_{z}", what.id()),
            Channel::Base(what) => format!("{}_base", what.id()),
            Channel::BaseOn(what, side) => format!("{}_base_{}", what.id(), side.id()),
            Channel::SectionMoment(side) => format!("{WALL_MOMENT}_section_{}", side.id()),
            Channel::Top => "top_displacement".into(),
            Channel::Belly => "belly_displacement".into(),
            Channel::Deflection(side) => format!("wall_displacement_{}", side.id()),
        }
    }

    /// The channel of an id; the height of a [`Channel::Largest`], which is not part of its id, is 0.
    pub fn from_id(id: &str) -> Option<Channel> {
        let plain = Channel::plain().find(|channel| channel.id() == id);
        let number = |prefix: &str| id.strip_prefix(prefix)?.parse().ok();
        let wave = || {
            Some(Channel::WaveAt {
                r: number(&format!("{WAVE_HEIGHT}_r_"))?,
            })
        };
        let at = |&what: &OnWall| {
            Some(Channel::At {
                what,
                z: number(&format!("{}_z_", what.id()))?,
            })
        };
        plain.or_else(wave).or_else(|| OnWall::ALL.iter().find_map(at))
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
            ]
        });
        let others = [
            Channel::BaseShear,
            Channel::BaseMoment,
            Channel::OverturningMoment,
            Channel::Top,
            Channel::Belly,
        ];
        ground.chain(on_wall).chain(sides).chain(others)
    }

    /// Title.
    pub fn title(self) -> String {
        match self {
            Channel::Ground { motion, vertical } => {
                let title = match motion {
                    Ground::Acceleration => "Ground acceleration",
                    Ground::Velocity => "Ground velocity",
                    Ground::Displacement => "Ground displacement",
                };
                let direction = if vertical { ", vertical" } else { "" };
                format!("{title}{direction}")
            }
            Channel::Wave(side) => format!("Wave height at the wall, {}", side.title()),
            Channel::WaveAt { r } => format!("Wave height at {r} m from the centre"),
            Channel::BaseShear => "Base shear".into(),
            Channel::BaseMoment => "Moment above the base plate".into(),
            Channel::OverturningMoment => "Moment below the base plate".into(),
            Channel::Largest { what, z } => format!(
                "{} at z = {} (largest over the height)",
                what.title(),
                display(z, Dimension::Length)
            ),
            Channel::At { what, z } => format!("{} at z = {z} m", what.title()),
            Channel::Base(what) => format!("{} at the base", what.title()),
            Channel::BaseOn(what, side) => format!("{}, {}", Channel::Base(what).title(), side.title()),
            Channel::SectionMoment(side) => {
                format!("Bending moment of the lowest section of the wall, {}", side.title())
            }
            Channel::Top => "Radial displacement of the top of the wall, θ = 0°".into(),
            Channel::Belly => "Radial displacement at a third of the levels of the wall, θ = 0°".into(),
            Channel::Deflection(side) => format!("Deflection of the top of the wall, {}", side.title()),
        }
    }

    /// Dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Channel::Ground { motion, .. } => match motion {
                Ground::Acceleration => Dimension::Acceleration,
                Ground::Velocity => Dimension::Velocity,
                Ground::Displacement => Dimension::Length,
            },
            Channel::BaseShear => Dimension::Force,
            Channel::BaseMoment | Channel::OverturningMoment => Dimension::Moment,
            Channel::Largest { what, .. }
            | Channel::At { what, .. }
            | Channel::Base(what)
            | Channel::BaseOn(what, _) => what.dimension(),
            Channel::SectionMoment(_) => Dimension::LineMoment,
            Channel::Wave(_) | Channel::WaveAt { .. } | Channel::Top | Channel::Belly | Channel::Deflection(_) => {
                Dimension::Length
            }
        }
    }

    /// Whether it is a wave height.
    pub fn is_wave(self) -> bool {
        matches!(self, Channel::Wave(_) | Channel::WaveAt { .. })
    }

    /// Its value of the wall, if it is one.
    pub fn on_wall(self) -> Option<OnWall> {
        match self {
            Channel::Largest { what, .. }
            | Channel::At { what, .. }
            | Channel::Base(what)
            | Channel::BaseOn(what, _) => Some(what),
            Channel::SectionMoment(_) => Some(OnWall::Moment),
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
mod tests {
    use super::*;

    /// Names of columns that scripts of users rely on.
    #[test]
    fn ids() {
        let vertical = Channel::Ground {
            motion: Ground::Velocity,
            vertical: true,
        };
        for (channel, id) in [
            (vertical, "vertical_ground_velocity"),
            (Channel::Wave(Side::Back), "wave_height_theta_180"),
            (Channel::WaveAt { r: -0.5 }, "wave_height_r_-0.5"),
            (
                Channel::At {
                    what: OnWall::Hoop,
                    z: 0.05,
                },
                "hoop_stress_z_0.05",
            ),
            (Channel::Base(OnWall::Axial), "axial_membrane_stress_base"),
            (
                Channel::BaseOn(OnWall::Moment, Side::Back),
                "wall_moment_base_theta_180",
            ),
        ] {
            assert_eq!(channel.id(), id);
            assert_eq!(Channel::from_id(id), Some(channel));
        }
        for channel in Channel::plain() {
            assert_eq!(Channel::from_id(&channel.id()), Some(channel));
        }
        assert_eq!(Channel::from_id("hoop_stress_z_high"), None);
        assert_eq!(Channel::compared("hoop_stress"), Some(Quantity::HoopStress));
        assert_eq!(Channel::compared("hoop_stress_z_0.05"), None);
        assert!(Channel::COMPARED.iter().all(|c| c.quantity().is_some()));
    }
}
