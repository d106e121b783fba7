//! Names of channels.

use super::*;

/// Names of columns that scripts of users rely on.
#[test]
fn ids() {
    let vertical = Channel::Ground { motion: Ground::Velocity, vertical: true };
    for (channel, id) in [
        (vertical, "vertical_ground_velocity"),
        (Channel::Wave(Side::Back), "wave_height_theta_180"),
        (Channel::WaveAt { r: -0.5 }, "wave_height_r_-0.5"),
        (Channel::At { what: OnWall::Hoop, z: 0.05 }, "hoop_stress_z_0.05"),
        (Channel::Base(OnWall::Axial), "axial_membrane_stress_base"),
        (Channel::GroundY(Ground::Acceleration), "ground_acceleration_y"),
        (Channel::Y(OnBase::Shear), "base_shear_y"),
        (Channel::Resultant(OnBase::Overturning), "overturning_moment_resultant"),
        (Channel::WaveAround { degrees: 90.0 }, "wave_height_theta_90"),
        (Channel::AtAngle { what: OnWall::Hoop, z: 0.5, degrees: 22.5 }, "hoop_stress_z_0.5_theta_22.5"),
        (Channel::BaseAtAngle { what: OnWall::Axial, degrees: 90.0 }, "axial_membrane_stress_base_theta_90"),
        (Channel::BaseOn(OnWall::Moment, Side::Back), "wall_moment_base_theta_180"),
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
