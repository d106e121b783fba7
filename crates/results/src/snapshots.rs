//! States of a model at moments, for files that other programs draw (`--vtu`): of the three-dimensional engine, of a nonlinear cylinder, and of
//! the bottom plate that lifts in the harmonic engine.
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
    /// Quadrilaterals of the bottom plate of a tank that lifts, four indices into `nodes`; one at the axis repeats its node.
    pub bottom: Vec<[usize; 4]>,
    /// States by ascending time.
    pub states: Vec<Snapshot>,
}

/// One moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Time [s].
    pub time: f64,
    /// Displacement of every node relative to the ground [m]; of a nonlinear run and of a bottom plate from the tank without load.
    pub displacement: Vec<[f64; 3]>,
    /// Seismic pressure in the middle of every hexahedron [Pa], compression positive.
    pub pressure: Vec<f64>,
    /// Resultants in the middle of every quadrilateral of the wall: of a linear engine the seismic ones, of a nonlinear run the whole ones.
    pub resultants: Vec<Resultants>,
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
