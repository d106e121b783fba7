//! Quantities over the height of the wall.

use tank::listed;
use tank::units::Dimension;

use super::WALL_MOMENT;

listed! {
    /// A quantity over the height of the wall.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum OnWall {
        /// Id of the envelope.
        id: &'static str,
        /// Title.
        title: &'static str,
        /// Dimension.
        dimension: Dimension,
    }
    /// Hydrodynamic pressure [Pa].
    Pressure: "pressure", "Hydrodynamic pressure on the wall", Dimension::Stress;
    /// Hoop membrane stress [Pa].
    Hoop: "hoop_stress", "Hoop membrane stress", Dimension::Stress;
    /// Axial membrane stress [Pa].
    Axial: "axial_membrane_stress", "Axial membrane stress", Dimension::Stress;
    /// Meridional bending stress at the outer face [Pa].
    Bending: "bending_stress", "Meridional bending stress, outer face", Dimension::Stress;
    /// Radial displacement [m].
    Displacement: "radial_displacement", "Radial displacement", Dimension::Length;
    /// Meridional bending moment [N m/m].
    Moment: WALL_MOMENT, "Meridional bending moment of the wall", Dimension::LineMoment;
    /// Shear force [N/m].
    Shear: "wall_shear", "Shear force of the wall", Dimension::LineForce;
    /// Horizontal bending moment of a plate in its middle [N m/m].
    HorizontalMoment: "horizontal_moment", "Horizontal bending moment in the middle of the wall", Dimension::LineMoment;
    /// The same at a corner of two plates.
    CornerMoment: "corner_moment", "Horizontal bending moment of the wall at its corner", Dimension::LineMoment;
    /// Meridional membrane force n_s [N/m].
    AxialForce: "axial_force", "Meridional membrane force", Dimension::LineForce;
    /// Hoop membrane force n_θ [N/m].
    HoopForce: "hoop_force", "Hoop membrane force", Dimension::LineForce;
    /// Bending moment along the circumference m_θ [N m/m].
    HoopMoment: "hoop_moment", "Bending moment along the circumference", Dimension::LineMoment;
    /// Twisting moment m_sθ [N m/m].
    Twist: "twisting_moment", "Twisting moment of the wall", Dimension::LineMoment;
}

impl OnWall {
    /// Internal forces of a cylinder at a station: membrane forces, then moments.
    pub const FORCES: [OnWall; 6] =
        [OnWall::AxialForce, OnWall::HoopForce, OnWall::Shear, OnWall::Moment, OnWall::HoopMoment, OnWall::Twist];
}
