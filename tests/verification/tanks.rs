//! Cases of the verification tests.

use codes::Case;
use codes::case::{Damping, ProcedureOptions, Site};
use codes::tank::{Course, Liquid, Material, Roof, Shape, Support, Tank};

/// Acceleration of free fall of all verification cases [m/s²].
pub const GRAVITY: f64 = 9.81;

/// Aluminium of example 8.1.
pub fn aluminium() -> Material {
    material(69e9, 0.32, 2750.0)
}

/// Steel.
pub fn steel() -> Material {
    material(210e9, 0.3, 7850.0)
}

/// A material without strengths.
pub fn material(youngs_modulus: f64, poisson_ratio: f64, density: f64) -> Material {
    Material {
        name: "wall".into(),
        youngs_modulus,
        poisson_ratio,
        density,
        yield_strength: None,
        allowable_stress: None,
    }
}

/// A case without ground motion: courses as (height, thickness), liquid as (density, depth).
pub fn case(shape: Shape, courses: &[(f64, f64)], material: &Material, liquid: (f64, f64)) -> Case {
    let course = |&(height, thickness): &(f64, f64)| Course {
        height,
        thickness,
        material: material.clone(),
    };
    Case {
        name: "verification".into(),
        tank: Tank {
            shape,
            support: Support::Anchored,
            courses: courses.iter().map(course).collect(),
            roof: Roof::default(),
            bottom: None,
            anchors: None,
        },
        liquid: Liquid {
            density: liquid.0,
            fill_height: liquid.1,
        },
        gravity: GRAVITY,
        ground_motion: None,
        damping: Damping {
            sloshing: 0.005,
            impulsive: 0.02,
        },
        site: Site::default(),
        procedures: ProcedureOptions::default(),
        measured: Vec::new(),
        published: Vec::new(),
    }
}

/// Example 8.1: the broad aluminium tank of Manos & Clough 1982; wall 1.83 m, liquid 1.525 m.
pub fn broad(density: f64) -> Case {
    case(
        Shape::Cylinder { radius: 1.83 },
        &[(0.915, 2.03e-3), (0.915, 1.27e-3)],
        &aluminium(),
        (density, 1.525),
    )
}

/// Example 8.3: slender steel tank, wall 5.5 m, 2 mm.
pub fn slender(density: f64, depth: f64) -> Case {
    case(
        Shape::Cylinder { radius: 1.83 },
        &[(5.5, 2e-3)],
        &steel(),
        (density, depth),
    )
}

/// |value/reference − 1| ≤ tolerance, with a message that shows both.
pub fn assert_close(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = value / reference - 1.0;
    assert!(
        error.abs() <= tolerance,
        "{what}: found {value}, expected {reference}, error {:+.3} %, allowed {:.3} %",
        100.0 * error,
        100.0 * tolerance
    );
}
