//! The base of an unanchored tank under the moments of the codes.

use serde::{Deserialize, Serialize};

/// The base on all grounds under the largest moment of the procedures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Standing {
    /// Largest moment just above the bottom plate [N m].
    pub moment: f64,
    /// Id of its method.
    pub method: String,
    /// Weight that holds the wall down, as the sheet of the method takes it [N/m]; none of results of earlier versions, which have that at
    /// rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// The grounds, the softest first.
    pub grounds: Vec<StandingGround>,
    /// The lifted plate on the ground that decides and lifts most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plate: Option<StandingPlate>,
}

/// The base on one ground.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StandingGround {
    /// Modulus k [N/m³].
    pub modulus: f64,
    /// Whether checks are decided on it.
    pub decides: bool,
    /// Rotation [rad] and moment [N m], both rising.
    pub curve: Vec<[f64; 2]>,
    /// What the base does under the moment; none where it does not hold it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub values: Option<StandingValues>,
}

/// A base under a moment.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StandingValues {
    /// Rotation ψ [rad].
    pub rotation: f64,
    /// Uplift of the rim [m].
    pub uplift: f64,
    /// Lifted width [m].
    pub lifted_width: f64,
    /// Plastic rotation of the joint [rad].
    pub plastic_rotation: f64,
    /// Axial stress at the toe, compression [Pa].
    pub toe_axial_stress: f64,
}

/// The plate at the lifted side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StandingPlate {
    /// Modulus of the ground [N/m³].
    pub modulus: f64,
    /// Distance inwards from the rim [m], deflection upwards [m], pressure of the ground [Pa], from the inside outwards.
    pub points: Vec<[f64; 3]>,
    /// Stretches of the plate that have yielded, by their distances from the rim [m].
    pub yielded: Vec<[f64; 2]>,
}
