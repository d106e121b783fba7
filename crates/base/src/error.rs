//! What can go wrong.

/// A base that cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BaseError {
    /// A parameter without meaning.
    #[error("{name} = {value}: {allowed}")]
    Parameter {
        /// Its name.
        name: &'static str,
        /// What was found.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// No equilibrium at the smallest step.
    #[error("the bottom plate finds no equilibrium at an uplift of {uplift:.6} m (smallest step {step:.1e} m)")]
    NoEquilibrium {
        /// Uplift of the rim that was sought [m].
        uplift: f64,
        /// Smallest step tried [m].
        step: f64,
    },
    /// A rotation beyond the computed uplift.
    #[error(
        "a rotation of {rotation:.3e} rad moves the rim by {wanted:.4} m, the strip is known between {from:.4} and {to:.4} m"
    )]
    BeyondCurve {
        /// Rotation of the base [rad].
        rotation: f64,
        /// Displacement of the rim [m].
        wanted: f64,
        /// Lowest displacement of the curve [m].
        from: f64,
        /// Highest displacement of the curve [m].
        to: f64,
    },
}

/// Refuses what is not positive and finite.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, BaseError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(BaseError::Parameter { name, value, allowed: "a positive number" })
}
