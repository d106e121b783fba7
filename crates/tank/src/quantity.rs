//! Comparable quantities of the code procedures and the finite-element engines.
//!
//! All quantities are the *seismic* part alone (hydrostatic and self-weight states excluded), absolute maxima over time
//! and circumference. Values combined with the static state appear in checks and profiles, never here; of a base that is free to move the
//! stress at the toe alone includes its state at rest, which changes with the motion.

use serde::{Deserialize, Serialize};

use crate::listed;
use crate::units::Dimension;

listed! {
    /// A comparable quantity. The serde name is its id in `results.json`.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Quantity {
        /// Id as in `results.json`, e.g. `sloshing_height`.
        id: &'static str,
        /// Symbol in messages and pages of the program; procedures use those of their codes.
        symbol: &'static str,
        /// Dimension of the value, which is always stored in SI.
        dimension: Dimension,
        /// Title for tables, e.g. `Sloshing height`.
        title: &'static str,
        /// What it is and how it is counted, in sentences.
        meaning: &'static str,
    }
    /// Period of the first sloshing mode [s].
    SloshingPeriod: "sloshing_period", "T_c", Dimension::Time, "Sloshing period",
        "Period of the first sloshing mode, in which the surface swings from side to side.";
    /// Largest rise of the liquid surface at the wall [m].
    SloshingHeight: "sloshing_height", "d_max", Dimension::Length, "Sloshing height",
        "Largest rise of the liquid surface at the wall above its level at rest, by linear theory where the method is linear.";
    /// Crest at the wall of a wave that is not small [m].
    SloshingCrest: "sloshing_crest", "d_+", Dimension::Length, "Sloshing crest",
        "Largest rise of the surface at the wall with the sharper crest of a wave that is not small: the sloshing height times \
         1 + c d/R, or of a nonlinear liquid.";
    /// Trough at the wall of a wave that is not small [m].
    SloshingTrough: "sloshing_trough", "d_-", Dimension::Length, "Sloshing trough",
        "Largest fall of the surface at the wall with the flatter trough of a wave that is not small: the sloshing height times \
         1 − 0.7 c d/R, or of a nonlinear liquid.";
    /// Period of the first impulsive (structural) mode [s].
    ImpulsivePeriod: "impulsive_period", "T_i", Dimension::Time, "Impulsive period",
        "Period of the first mode in which wall and liquid move together. Zero or absent where a method takes the wall as \
         rigid.";
    /// Liquid that moves with the impulsive mode, or with the rigid wall [kg].
    ImpulsiveMass: "impulsive_mass", "m_i", Dimension::Mass, "Impulsive mass of the liquid",
        "Liquid that moves with the wall: with its first mode, or with a rigid wall.";
    /// Part of the wall that moves with it [kg].
    WallMass: "wall_mass", "m_w", Dimension::Mass, "Wall mass in the impulsive part",
        "Base shear of the wall's inertia in the impulsive part over its spectral acceleration: the wall's mass by the codes, γ Σ m φ \
         of the modes by the engine.";
    /// Part of the roof that moves with it [kg].
    RoofMass: "roof_mass", "m_r", Dimension::Mass, "Roof mass in the impulsive part",
        "Base shear of the roof's inertia in the impulsive part over its spectral acceleration: the roof's mass by the codes, γ m φ of \
         the modes by the engine, which exceeds the mass where the mode moves the top most.";
    /// Mass of the first sloshing mode [kg].
    ConvectiveMass: "convective_mass", "m_c", Dimension::Mass, "Convective mass", "Liquid that moves with the first sloshing mode.";
    /// Horizontal force on the foundation [N].
    BaseShear: "base_shear", "Q", Dimension::Force, "Base shear", "Horizontal force of the tank on its foundation.";
    /// Bending moment of the wall cross-section just above the base [N·m] (excluding base pressure, "EBP").
    BaseMoment: "base_moment", "M", Dimension::Moment, "Base moment (above the base plate)",
        "Bending moment of the wall just above the bottom plate; the pressure on the bottom is excluded (EBP). It loads wall \
         and anchors.";
    /// Moment below the base plate [N·m] (including base pressure, "IBP").
    OverturningMoment: "overturning_moment", "M′", Dimension::Moment, "Overturning moment (below the base plate)",
        "Moment just below the bottom plate; the pressure on the bottom is included (IBP). It loads the foundation.";
    /// Largest circumferential membrane stress of the wall up to the surface at rest [Pa].
    HoopStress: "hoop_stress", "σ_θ", Dimension::Stress, "Hoop stress",
        "Largest circumferential membrane stress of the wall up to the surface at rest, where the liquid presses on it.";
    /// The same of the dry wall above it [Pa].
    RimHoopStress: "rim_hoop_stress", "σ_rim", Dimension::Stress, "Rim hoop stress (above the surface)",
        "Largest circumferential membrane stress of the dry wall above the surface at rest, where a rim without a ring swings with \
         its roof. The procedures know hoop stress from pressure alone and give none.";
    /// Axial membrane stress at the base of the wall [Pa].
    AxialMembraneStress: "axial_membrane_stress", "σ_z", Dimension::Stress, "Axial membrane stress at the base",
        "Largest vertical membrane stress at the foot of the wall.";
    /// Meridional bending stress at the base of the wall [Pa].
    BendingStress: "bending_stress", "σ_b", Dimension::Stress, "Bending stress at the base",
        "Largest vertical bending stress at the foot of the wall, where the bottom clamps it.";
    /// Largest rise of the rim above its place at rest [m].
    Uplift: "uplift", "w", Dimension::Length, "Uplift of the rim",
        "Largest rise of the rim of a tank that is free to lift, above its place at rest.";
    /// Rotation of the base [rad].
    BaseRotation: "base_rotation", "ψ", Dimension::Angle, "Base rotation",
        "Largest rotation of the base of a tank that is free to lift, as a plane through its rim.";
    /// Plastic rotation of the joint of wall and bottom plate [rad].
    PlasticRotation: "plastic_rotation", "θ_p", Dimension::Angle, "Plastic rotation of the bottom joint",
        "Plastic rotation of the joint of wall and bottom plate where the rim lifts most.";
    /// Compression of the wall at its foot where the base turns down, with that at rest [Pa].
    ToeAxialStress: "toe_axial_stress", "σ_toe", Dimension::Stress, "Toe axial stress, with that at rest",
        "Largest vertical compression of the wall at its foot, where a free base turns down. The weight at rest is included.";
    /// Displacement of the tank on the ground [m].
    Slip: "slip", "x_s", Dimension::Length, "Slip on the ground", "Largest displacement on the ground of a tank that is free to slide.";
    /// Force of an anchor [N].
    AnchorForce: "anchor_force", "F_a", Dimension::Force, "Anchor force", "Largest force of an anchor, where anchors stretch in the run.";
    /// Displacement of the isolators [m].
    IsolatorDisplacement: "isolator_displacement", "u_b", Dimension::Length, "Isolator displacement",
        "Largest horizontal displacement of the slab over the ground, on isolators.";
}

impl Quantity {
    /// The quantity with this id.
    pub fn from_id(id: &str) -> Option<Quantity> {
        Quantity::ALL.into_iter().find(|q| q.id() == id)
    }

    /// Whether it is a response to the ground motion: periods and masses are properties of the tank.
    pub fn is_response(self) -> bool {
        !matches!(self.dimension(), Dimension::Time | Dimension::Mass)
    }

    /// Those of a base that is free to move: the last of [`Quantity::ALL`].
    pub const OF_BASE: &'static [Quantity] = Quantity::ALL.split_at(16).1;
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
                "sloshing_crest",
                "sloshing_trough",
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
                "height" | "crest" | "trough" | "uplift" | "slip" | "displacement" => Dimension::Length,
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
