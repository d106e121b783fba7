//! Comparable quantities of the code procedures and the finite-element engines.
//!
//! All quantities are the *seismic* part alone (hydrostatic and self-weight states excluded), absolute maxima over time
//! and circumference. Values combined with the static state appear in checks and profiles, never here; of a base that is free to move the
//! stress at the toe alone includes its state at rest, which changes with the motion.

use serde::{Deserialize, Serialize};

use crate::units::Dimension;

/// A comparable quantity. The serde name is its id in `results.json`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Period of the first sloshing mode [s].
    SloshingPeriod,
    /// Largest rise of the liquid surface at the wall [m].
    SloshingHeight,
    /// Period of the first impulsive (structural) mode [s].
    ImpulsivePeriod,
    /// Liquid that moves with the impulsive mode, or with the rigid wall [kg].
    ImpulsiveMass,
    /// Part of the wall that moves with it [kg].
    WallMass,
    /// Part of the roof that moves with it [kg].
    RoofMass,
    /// Mass of the first sloshing mode [kg].
    ConvectiveMass,
    /// Horizontal force on the foundation [N].
    BaseShear,
    /// Bending moment of the wall cross-section just above the base [N·m] (excluding base pressure, "EBP").
    BaseMoment,
    /// Moment below the base plate [N·m] (including base pressure, "IBP").
    OverturningMoment,
    /// Largest circumferential membrane stress of the wall up to the surface at rest [Pa].
    HoopStress,
    /// The same of the dry wall above it [Pa].
    RimHoopStress,
    /// Axial membrane stress at the base of the wall [Pa].
    AxialMembraneStress,
    /// Meridional bending stress at the base of the wall [Pa].
    BendingStress,
    /// Largest rise of the rim above its place at rest [m].
    Uplift,
    /// Rotation of the base [rad].
    BaseRotation,
    /// Plastic rotation of the joint of wall and bottom plate [rad].
    PlasticRotation,
    /// Compression of the wall at its foot where the base turns down, with that at rest [Pa].
    ToeAxialStress,
    /// Displacement of the tank on the ground [m].
    Slip,
    /// Force of an anchor [N].
    AnchorForce,
    /// Displacement of the isolators [m].
    IsolatorDisplacement,
}

impl Quantity {
    /// All quantities in report order.
    pub const ALL: [Quantity; 21] = [
        Quantity::SloshingPeriod,
        Quantity::SloshingHeight,
        Quantity::ImpulsivePeriod,
        Quantity::ImpulsiveMass,
        Quantity::WallMass,
        Quantity::RoofMass,
        Quantity::ConvectiveMass,
        Quantity::BaseShear,
        Quantity::BaseMoment,
        Quantity::OverturningMoment,
        Quantity::HoopStress,
        Quantity::RimHoopStress,
        Quantity::AxialMembraneStress,
        Quantity::BendingStress,
        Quantity::Uplift,
        Quantity::BaseRotation,
        Quantity::PlasticRotation,
        Quantity::ToeAxialStress,
        Quantity::Slip,
        Quantity::AnchorForce,
        Quantity::IsolatorDisplacement,
    ];

    /// Id as in `results.json`, e.g. `sloshing_height`.
    pub fn id(self) -> &'static str {
        match self {
            Quantity::SloshingPeriod => "sloshing_period",
            Quantity::SloshingHeight => "sloshing_height",
            Quantity::ImpulsivePeriod => "impulsive_period",
            Quantity::ImpulsiveMass => "impulsive_mass",
            Quantity::WallMass => "wall_mass",
            Quantity::RoofMass => "roof_mass",
            Quantity::ConvectiveMass => "convective_mass",
            Quantity::BaseShear => "base_shear",
            Quantity::BaseMoment => "base_moment",
            Quantity::OverturningMoment => "overturning_moment",
            Quantity::HoopStress => "hoop_stress",
            Quantity::RimHoopStress => "rim_hoop_stress",
            Quantity::AxialMembraneStress => "axial_membrane_stress",
            Quantity::BendingStress => "bending_stress",
            Quantity::Uplift => "uplift",
            Quantity::BaseRotation => "base_rotation",
            Quantity::PlasticRotation => "plastic_rotation",
            Quantity::ToeAxialStress => "toe_axial_stress",
            Quantity::Slip => "slip",
            Quantity::AnchorForce => "anchor_force",
            Quantity::IsolatorDisplacement => "isolator_displacement",
        }
    }

    /// The quantity with this id.
    pub fn from_id(id: &str) -> Option<Quantity> {
        Quantity::ALL.into_iter().find(|q| q.id() == id)
    }

    /// Title for tables, e.g. `Sloshing height`.
    pub fn title(self) -> &'static str {
        match self {
            Quantity::SloshingPeriod => "Sloshing period",
            Quantity::SloshingHeight => "Sloshing height",
            Quantity::ImpulsivePeriod => "Impulsive period",
            Quantity::ImpulsiveMass => "Impulsive mass of the liquid",
            Quantity::WallMass => "Wall mass in the impulsive part",
            Quantity::RoofMass => "Roof mass in the impulsive part",
            Quantity::ConvectiveMass => "Convective mass",
            Quantity::BaseShear => "Base shear",
            Quantity::BaseMoment => "Base moment (above the base plate)",
            Quantity::OverturningMoment => "Overturning moment (below the base plate)",
            Quantity::HoopStress => "Hoop stress",
            Quantity::RimHoopStress => "Rim hoop stress (above the surface)",
            Quantity::AxialMembraneStress => "Axial membrane stress at the base",
            Quantity::BendingStress => "Bending stress at the base",
            Quantity::Uplift => "Uplift of the rim",
            Quantity::BaseRotation => "Base rotation",
            Quantity::PlasticRotation => "Plastic rotation of the bottom joint",
            Quantity::ToeAxialStress => "Toe axial stress, with that at rest",
            Quantity::Slip => "Slip on the ground",
            Quantity::AnchorForce => "Anchor force",
            Quantity::IsolatorDisplacement => "Isolator displacement",
        }
    }

    /// Symbol in messages and pages of the program; procedures use those of their codes.
    pub fn symbol(self) -> &'static str {
        match self {
            Quantity::SloshingPeriod => "T_c",
            Quantity::SloshingHeight => "d_max",
            Quantity::ImpulsivePeriod => "T_i",
            Quantity::ImpulsiveMass => "m_i",
            Quantity::WallMass => "m_w",
            Quantity::RoofMass => "m_r",
            Quantity::ConvectiveMass => "m_c",
            Quantity::BaseShear => "Q",
            Quantity::BaseMoment => "M",
            Quantity::OverturningMoment => "M′",
            Quantity::HoopStress => "σ_θ",
            Quantity::RimHoopStress => "σ_rim",
            Quantity::AxialMembraneStress => "σ_z",
            Quantity::BendingStress => "σ_b",
            Quantity::Uplift => "w",
            Quantity::BaseRotation => "ψ",
            Quantity::PlasticRotation => "θ_p",
            Quantity::ToeAxialStress => "σ_toe",
            Quantity::Slip => "x_s",
            Quantity::AnchorForce => "F_a",
            Quantity::IsolatorDisplacement => "u_b",
        }
    }

    /// What it is and how it is counted, in sentences.
    pub fn meaning(self) -> &'static str {
        match self {
            Quantity::SloshingPeriod => {
                "Period of the first sloshing mode, in which the surface swings from side to side."
            }
            Quantity::SloshingHeight => "Largest rise of the liquid surface at the wall above its level at rest.",
            Quantity::ImpulsivePeriod => {
                "Period of the first mode in which wall and liquid move together. Zero or absent where a method takes the wall as \
                 rigid."
            }
            Quantity::ImpulsiveMass => "Liquid that moves with the wall: with its first mode, or with a rigid wall.",
            Quantity::WallMass => {
                "Base shear of the wall's inertia in the impulsive part over its spectral acceleration: the wall's mass by the codes, γ Σ m φ \
                 of the modes by the engine."
            }
            Quantity::RoofMass => {
                "Base shear of the roof's inertia in the impulsive part over its spectral acceleration: the roof's mass by the codes, γ m φ of \
                 the modes by the engine, which exceeds the mass where the mode moves the top most."
            }
            Quantity::ConvectiveMass => "Liquid that moves with the first sloshing mode.",
            Quantity::BaseShear => "Horizontal force of the tank on its foundation.",
            Quantity::BaseMoment => {
                "Bending moment of the wall just above the bottom plate; the pressure on the bottom is excluded (EBP). It loads wall \
                 and anchors."
            }
            Quantity::OverturningMoment => {
                "Moment just below the bottom plate; the pressure on the bottom is included (IBP). It loads the foundation."
            }
            Quantity::HoopStress => {
                "Largest circumferential membrane stress of the wall up to the surface at rest, where the liquid presses on it."
            }
            Quantity::RimHoopStress => {
                "Largest circumferential membrane stress of the dry wall above the surface at rest, where a rim without a ring swings with \
                 its roof. The procedures know hoop stress from pressure alone and give none."
            }
            Quantity::AxialMembraneStress => "Largest vertical membrane stress at the foot of the wall.",
            Quantity::BendingStress => {
                "Largest vertical bending stress at the foot of the wall, where the bottom clamps it."
            }
            Quantity::Uplift => "Largest rise of the rim of a tank that is free to lift, above its place at rest.",
            Quantity::BaseRotation => {
                "Largest rotation of the base of a tank that is free to lift, as a plane through its rim."
            }
            Quantity::PlasticRotation => {
                "Plastic rotation of the joint of wall and bottom plate where the rim lifts most."
            }
            Quantity::ToeAxialStress => {
                "Largest vertical compression of the wall at its foot, where a free base turns down. The weight at rest is included."
            }
            Quantity::Slip => "Largest displacement on the ground of a tank that is free to slide.",
            Quantity::AnchorForce => "Largest force of an anchor, where anchors stretch in the run.",
            Quantity::IsolatorDisplacement => {
                "Largest horizontal displacement of the slab over the ground, on isolators."
            }
        }
    }

    /// Whether it is a response to the ground motion: periods and masses are properties of the tank.
    pub fn is_response(self) -> bool {
        !matches!(self.dimension(), Dimension::Time | Dimension::Mass)
    }

    /// Those of a base that is free to move: the last of [`Quantity::ALL`].
    pub const OF_BASE: &'static [Quantity] = Quantity::ALL.split_at(14).1;

    /// Dimension of the value, which is always stored in SI.
    pub fn dimension(self) -> Dimension {
        match self {
            Quantity::SloshingPeriod | Quantity::ImpulsivePeriod => Dimension::Time,
            Quantity::SloshingHeight | Quantity::Uplift | Quantity::Slip | Quantity::IsolatorDisplacement => {
                Dimension::Length
            }
            Quantity::BaseRotation | Quantity::PlasticRotation => Dimension::Angle,
            Quantity::ImpulsiveMass | Quantity::WallMass | Quantity::RoofMass | Quantity::ConvectiveMass => {
                Dimension::Mass
            }
            Quantity::BaseShear | Quantity::AnchorForce => Dimension::Force,
            Quantity::BaseMoment | Quantity::OverturningMoment => Dimension::Moment,
            Quantity::HoopStress
            | Quantity::RimHoopStress
            | Quantity::AxialMembraneStress
            | Quantity::BendingStress
            | Quantity::ToeAxialStress => Dimension::Stress,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ids are part of the file formats (`reported` in the tank file, `results.json`) of earlier versions.
    #[test]
    fn ids_of_the_file_formats() {
        let ids = Quantity::ALL.map(Quantity::id);
        assert_eq!(
            ids,
            [
                "sloshing_period",
                "sloshing_height",
                "impulsive_period",
                "impulsive_mass",
                "wall_mass",
                "roof_mass",
                "convective_mass",
                "base_shear",
                "base_moment",
                "overturning_moment",
                "hoop_stress",
                "rim_hoop_stress",
                "axial_membrane_stress",
                "bending_stress",
                "uplift",
                "base_rotation",
                "plastic_rotation",
                "toe_axial_stress",
                "slip",
                "anchor_force",
                "isolator_displacement",
            ]
        );
        assert_eq!(ids.map(Quantity::from_id), Quantity::ALL.map(Some));
        assert_eq!(Quantity::OF_BASE.first(), Some(&Quantity::Uplift));
        assert_eq!(Quantity::from_id("xyzzy"), None);
    }

    /// A title begins with the words of the id, and no two are the same.
    #[test]
    fn titles_name_the_id() {
        for q in Quantity::ALL {
            let words = q.id().replace('_', " ");
            assert!(q.title().to_lowercase().starts_with(&words), "{}", q.title());
            assert_eq!(Quantity::ALL.iter().filter(|o| o.title() == q.title()).count(), 1);
        }
    }

    #[test]
    fn dimensions_by_name() {
        for q in Quantity::ALL {
            let dimension = match q.id().rsplit('_').next().unwrap() {
                "period" => Dimension::Time,
                "height" | "uplift" | "slip" | "displacement" => Dimension::Length,
                "rotation" => Dimension::Angle,
                "mass" => Dimension::Mass,
                "shear" | "force" => Dimension::Force,
                "moment" => Dimension::Moment,
                "stress" => Dimension::Stress,
                other => panic!("{other}"),
            };
            assert_eq!(q.dimension(), dimension, "{q:?}");
        }
    }
}
