//! Fields of the three-dimensional engine, for the report's pictures.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// Pictures of the three-dimensional engine: its mesh, modes, deformed shapes and maps of the wall.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Fields {
    /// Positions of the drawn nodes [m], global Cartesian: wall and free surface.
    pub nodes: Vec<[f64; 3]>,
    /// Quadrilaterals of the wall, four indices into `nodes` each.
    pub wall: Vec<[usize; 4]>,
    /// Quadrilaterals of the free surface (a collapsed corner repeats its neighbour).
    pub surface: Vec<[usize; 4]>,
    /// Mode shapes.
    pub modes: Vec<Picture>,
    /// Deformed shapes at the moments of extreme response.
    pub moments: Vec<DeformedShape>,
    /// Maps over the developed wall (θ, z).
    pub maps: Vec<WallMap>,
}

/// A mode shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Title, with the circumferential (n) and axial (m) wave number where there is one.
    pub title: String,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Circumferential wave number.
    pub circumferential: u32,
    /// Displacement of every drawn node, scaled so that the largest is 1.
    pub displacement: Vec<[f64; 3]>,
}

/// A deformed shape at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DeformedShape {
    /// The extreme at that moment (`largest base moment`).
    pub title: String,
    /// Time [s].
    pub time: f64,
    /// Displacement of every drawn node [m], relative to the ground.
    pub displacement: Vec<[f64; 3]>,
}

/// A quantity over the developed wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WallMap {
    /// Id (`pressure`, `hoop_stress`).
    pub id: String,
    /// Title, with the moment.
    pub title: String,
    /// Time [s]; `None` where the map does not change.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
    /// Dimension of the values.
    pub dimension: Dimension,
    /// Angles [rad], ascending.
    pub theta: Vec<f64>,
    /// Heights [m], ascending.
    pub z: Vec<f64>,
    /// Values in SI, `values[i z.len() + j]` at `theta[i]`, `z[j]`.
    pub values: Vec<f64>,
}
