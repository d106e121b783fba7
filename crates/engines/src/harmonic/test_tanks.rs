//! Tanks of the unit tests.

use tank::{Case, Shape, reference};

/// A case without ground motion; the material as (E [Pa], ν, ρ_s [kg/m³]).
pub(crate) fn case(shape: Shape, courses: &[(f64, f64)], material: (f64, f64, f64), liquid: (f64, f64)) -> Case {
    let (youngs_modulus, poisson_ratio, density) = material;
    Case {
        name: "test".into(),
        ..reference::case(shape, courses, &reference::material(youngs_modulus, poisson_ratio, density), liquid)
    }
}

/// The broad aluminium tank of Manos & Clough 1982.
pub(crate) fn broad() -> Case {
    Case { name: "test".into(), ..reference::broad(1000.0) }
}
