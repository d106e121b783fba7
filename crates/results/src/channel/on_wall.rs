//! Quantities over the height of the wall.

use tank::units::Dimension;

use super::WALL_MOMENT;

/// Beginning of the ids of axial membrane stresses.
const AXIAL_MEMBRANE_STRESS: &str = "axial_membrane_stress";

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
    /// Horizontal bending moment of a plate in its middle [N m/m].
    HorizontalMoment,
    /// The same at a corner of two plates.
    CornerMoment,
    /// Meridional membrane force n_s [N/m].
    AxialForce,
    /// Hoop membrane force n_θ [N/m].
    HoopForce,
    /// Bending moment along the circumference m_θ [N m/m].
    HoopMoment,
    /// Twisting moment m_sθ [N m/m].
    Twist,
}

impl OnWall {
    /// All of them.
    pub const ALL: [OnWall; 13] = [
        OnWall::Pressure,
        OnWall::Hoop,
        OnWall::Axial,
        OnWall::Bending,
        OnWall::Displacement,
        OnWall::Moment,
        OnWall::Shear,
        OnWall::HorizontalMoment,
        OnWall::CornerMoment,
        OnWall::AxialForce,
        OnWall::HoopForce,
        OnWall::HoopMoment,
        OnWall::Twist,
    ];

    /// Internal forces of a cylinder at a station: membrane forces, then moments.
    pub const FORCES: [OnWall; 6] =
        [OnWall::AxialForce, OnWall::HoopForce, OnWall::Shear, OnWall::Moment, OnWall::HoopMoment, OnWall::Twist];

    /// Id of the envelope.
    pub fn id(self) -> &'static str {
        self.named().0
    }

    /// Title.
    pub fn title(self) -> &'static str {
        self.named().1
    }

    /// Dimension.
    pub fn dimension(self) -> Dimension {
        self.named().2
    }

    fn named(self) -> (&'static str, &'static str, Dimension) {
        match self {
            OnWall::Pressure => ("pressure", "Hydrodynamic pressure on the wall", Dimension::Stress),
            OnWall::Hoop => ("hoop_stress", "Hoop membrane stress", Dimension::Stress),
            OnWall::Axial => (AXIAL_MEMBRANE_STRESS, "Axial membrane stress", Dimension::Stress),
            OnWall::Bending => ("bending_stress", "Meridional bending stress, outer face", Dimension::Stress),
            OnWall::Displacement => ("radial_displacement", "Radial displacement", Dimension::Length),
            OnWall::Moment => (WALL_MOMENT, "Meridional bending moment of the wall", Dimension::LineMoment),
            OnWall::Shear => ("wall_shear", "Shear force of the wall", Dimension::LineForce),
            OnWall::HorizontalMoment => {
                ("horizontal_moment", "Horizontal bending moment in the middle of the wall", Dimension::LineMoment)
            }
            OnWall::CornerMoment => {
                ("corner_moment", "Horizontal bending moment of the wall at its corner", Dimension::LineMoment)
            }
            OnWall::AxialForce => ("axial_force", "Meridional membrane force", Dimension::LineForce),
            OnWall::HoopForce => ("hoop_force", "Hoop membrane force", Dimension::LineForce),
            OnWall::HoopMoment => ("hoop_moment", "Bending moment along the circumference", Dimension::LineMoment),
            OnWall::Twist => ("twisting_moment", "Twisting moment of the wall", Dimension::LineMoment),
        }
    }
}
