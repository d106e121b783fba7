//! Isolators between a slab under the tank and the ground.

use serde::{Deserialize, Serialize};

/// Bearings and dampers under a rigid slab; forces and stiffnesses are those of all of them together (of a strip, per metre of breadth).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Isolators {
    /// Law of the bearings.
    pub bearing: Bearing,
    /// Viscous dampers, C [N (s/m)^α] and α.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damper: Option<[f64; 2]>,
    /// Mass of the slab on the isolators [kg].
    pub slab_mass: f64,
    /// Thickness of the slab [m].
    pub slab_thickness: f64,
    /// Factors of the lower and the upper bound of the properties.
    pub bounds: [f64; 2],
    /// Displacement that bearings and their surroundings have room for [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement_capacity: Option<f64>,
}

/// Law of the bearings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Bearing {
    /// Friction pendulums.
    FrictionPendulum {
        /// Radius R_c of the concave surface [m].
        radius: f64,
        /// Coefficient of friction of fast sliding.
        friction: f64,
        /// Coefficient of friction at rest.
        slow: f64,
        /// Rate a of the friction with the velocity [s/m].
        rate: f64,
        /// Distance of elastic slip before sliding [m].
        slip: f64,
    },
    /// Lead-rubber bearings.
    LeadRubber {
        /// Characteristic strength Q [N].
        strength: f64,
        /// Stiffness K₁ before yielding [N/m].
        initial: f64,
        /// Stiffness K₂ after yielding [N/m].
        yielded: f64,
    },
    /// Elastomeric bearings.
    Elastomer {
        /// Stiffness K [N/m].
        stiffness: f64,
        /// Damping ratio ξ at the period of the mass above on K.
        damping: f64,
    },
}
