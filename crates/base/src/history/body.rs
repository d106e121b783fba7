//! A body on a fixed base.

/// A body in its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its modes.
    pub modes: Vec<BodyMode>,
    /// Mass m [kg].
    pub mass: f64,
    /// First moment S of the mass about the base [kg m]: what a unit of ψ̈ adds to the shear.
    pub first_moment: f64,
    /// Second moment J about the base [kg m²].
    pub second_moment: f64,
}

/// A mode of a body on a fixed base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMode {
    /// ω [rad/s].
    pub omega: f64,
    /// Damping ratio ξ.
    pub damping: f64,
    /// Participation Γ in a translation [√kg].
    pub translation: f64,
    /// Participation Γ^ψ in a rotation [√kg m].
    pub rotation: f64,
    /// Bottom pressure at the rim per q̈ [Pa s²/m].
    pub pressure: f64,
}
