//! Tanks of the unit tests.

use tank::{Attachment, Ring};
use tank::{Bottom, Case, Foundation, FoundationKind, Material, Shape, Support, reference};

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

/// Puts a tank that is not anchored on a bottom plate of this thickness [m] on soil of this stiffness [N/m³].
pub(crate) fn on_ground(case: &mut Case, thickness: f64, material: Material, stiffness: f64) {
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness,
        corrosion: 0.0,
        width: None,
        sketch: None,
        projection: 0.0,
        subgrade_modulus: None,
        material,
    });
    case.tank.foundation = Some(Foundation {
        width: None,
        kind: FoundationKind::Soil,
        stiffness: Some(stiffness),
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        friction: None,
    });
}

/// Adds a ring of this area [m²] and second moment [m⁴], of the material of the lowest course, and an attachment of this mass [kg], at
/// these heights [m].
pub(crate) fn fit(case: &mut Case, ring: (f64, f64, f64), attachment: (f64, f64)) {
    let material = case.tank.courses[0].material.clone();
    case.tank.rings.push(Ring { height: ring.0, area: ring.1, inertia: ring.2, material });
    case.tank.attachments.push(Attachment { name: "ladder".into(), height: attachment.0, mass: attachment.1 });
}
