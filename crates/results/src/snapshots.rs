//! States of a model at moments, for files that other programs draw: `--vtu` ([`super::vtu`]) and `--scene` ([`super::scene`]).
//!
//! They are too large for `results.json` and are not read back.

/// Mesh and states at moments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshots {
    /// Positions of the nodes [m], global Cartesian.
    pub nodes: Vec<[f64; 3]>,
    /// Hexahedra of the liquid, eight indices into `nodes`: lower quadrilateral counter-clockwise, then the upper one.
    /// A wedge at the axis repeats nodes.
    pub liquid: Vec<[usize; 8]>,
    /// Quadrilaterals of the wall, four indices into `nodes`.
    pub wall: Vec<[usize; 4]>,
    /// Thickness of the wall in every one of them [m].
    pub thickness: Vec<f64>,
    /// Quadrilaterals of the free surface, four indices into `nodes`; one at the axis repeats its node.
    pub surface: Vec<[usize; 4]>,
    /// Quadrilaterals of the bottom plate of a tank that lifts, four indices into `nodes`; one at the axis repeats its node.
    pub bottom: Vec<[usize; 4]>,
    /// Quadrilaterals of walls that are drawn without values, four indices into `nodes`.
    pub sides: Vec<[usize; 4]>,
    /// Whether the resultants are whole ones, with the static state; else seismic ones.
    pub whole: bool,
    /// Whether the model is the half y ≥ 0 of a tank that is symmetric about y = 0.
    pub half: bool,
    /// Modes on the same nodes.
    pub modes: Vec<DrawnMode>,
    /// States by ascending time.
    pub states: Vec<Snapshot>,
}

/// A mode to be drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnMode {
    /// What it is.
    pub title: String,
    /// Frequency [Hz].
    pub frequency: f64,
    /// Shape at every node, the longest displacement 1.
    pub displacement: Vec<[f64; 3]>,
}

impl DrawnMode {
    /// A mode of any scale.
    pub fn new(title: String, omega: f64, mut displacement: Vec<[f64; 3]>) -> DrawnMode {
        let length = |u: &[f64; 3]| u.iter().map(|c| c * c).sum::<f64>().sqrt();
        let longest = displacement.iter().map(length).fold(0.0, f64::max);
        if longest > 0.0 {
            displacement.as_flattened_mut().iter_mut().for_each(|c| *c /= longest);
        }
        DrawnMode { title, frequency: omega / std::f64::consts::TAU, displacement }
    }
}

/// One moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Time [s].
    pub time: f64,
    /// Displacement of every node relative to the ground [m]: of a linear engine from the position at rest, of a nonlinear run and of a bottom
    /// plate from the tank without load.
    pub displacement: Vec<[f64; 3]>,
    /// Seismic pressure in the middle of every hexahedron [Pa], compression positive.
    pub pressure: Vec<f64>,
    /// Seismic pressure of the liquid in the middle of every quadrilateral of the wall [Pa], compression positive; empty where it is not computed.
    pub on_wall: Vec<f64>,
    /// Resultants in the middle of every quadrilateral of the wall, not a number where an engine does not compute them; empty without any.
    pub resultants: Vec<Resultants>,
    /// Opening strain of the widest open crack in every quadrilateral of the wall; empty where it is not computed.
    pub cracks: Vec<f64>,
    /// Pressure of the ground on the bottom plate at every node [Pa], 0 where the plate is off the ground; empty without a bottom.
    pub ground: Vec<f64>,
    /// Plastic rotation across every quadrilateral of the bottom, along the radius [rad]: its sum from the wall inwards is that of the joint.
    pub plastic: Vec<f64>,
}

/// Stress resultants of a shell in the frame (φ around, v along the meridian).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultants {
    /// Hoop force n_φ [N/m].
    pub n_phi: f64,
    /// Meridional force n_v [N/m].
    pub n_v: f64,
    /// Membrane shear n_φv [N/m].
    pub n_phi_v: f64,
    /// Hoop moment m_φ [N].
    pub m_phi: f64,
    /// Meridional moment m_v [N].
    pub m_v: f64,
    /// Twisting moment m_φv [N].
    pub m_phi_v: f64,
    /// Transverse shear on the face across the meridian, q_v [N/m].
    pub q_v: f64,
}
