//! What is observed: linear functionals of the unknowns.

use tank::units::Dimension;

/// A scalar output y(t) = d·x(t) + a·ẍ_total(t) + b a_g(t), where x are the unknowns relative to the ground and
/// ẍ_total = ẍ + ι a_g their absolute acceleration.
///
/// Wall displacements and stresses use `displacement` only; pressures and base reactions `absolute_acceleration` and
/// `ground_acceleration`. With m = 0 pressures also use `displacement` (the surface sinks when the wall bulges), and axial
/// stresses the accelerations (the wall's weight within an element).
/// Vectors have the length of the model's unknowns; an empty vector stands for zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Id, unique within the model (`base_shear`, `hoop_stress@0.135`).
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension of y.
    pub dimension: Dimension,
    /// Coefficients d.
    pub displacement: Vec<f64>,
    /// Coefficients a.
    pub absolute_acceleration: Vec<f64>,
    /// Coefficient b of the ground acceleration: what moves rigidly with the ground and is no unknown, such as the
    /// clamped edge of the wall, rigid side walls or, with vertical motion, the bottom.
    pub ground_acceleration: f64,
    /// Value in the static state (hydrostatic pressure and self-weight), 0 if it has none.
    pub static_value: f64,
    /// Which modes count.
    pub modes: ModeSelection,
}

/// Which modes count for a probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeSelection {
    /// All computed modes, plus the missing mass.
    All,
    /// The first n sloshing modes only (wave heights: more modes chase the logarithmic corner singularity).
    FirstSloshing(usize),
}

/// Probes along the height that together make an envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeLine {
    /// Id of the envelope (`hoop_stress`).
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Heights [m], ascending.
    pub z: Vec<f64>,
    /// One probe a height.
    pub probes: Vec<Probe>,
}
