//! Tanks of the unit tests.

use tank::Case;
use tank::case::{Damping, ProcedureOptions, Site};
use tank::{Course, Liquid, Material, Roof, Shape, Support, Tank};

/// A case without ground motion.
pub(crate) fn case(shape: Shape, courses: &[(f64, f64)], material: (f64, f64, f64), liquid: (f64, f64)) -> Case {
    let material = Material {
        family: tank::Family::inferred(material.0, material.2),
        name: "wall".into(),
        youngs_modulus: material.0,
        poisson_ratio: material.1,
        density: material.2,
        yield_strength: None,
        allowable_stress: None,
        behaviour: Default::default(),
    };
    Case {
        name: "test".into(),
        tank: Tank {
            details: tank::Details::default(),
            shape,
            support: Support::Anchored,
            courses: courses
                .iter()
                .map(|&(height, thickness)| Course {
                    height,
                    thickness,
                    corrosion: 0.0,
                    material: material.clone(),
                    layers: Vec::new(),
                })
                .collect(),
            roof: Roof::default(),
            bottom: None,
            wall_base: tank::WallBase::Fixed,
            foundation: None,
            isolators: None,
            anchors: None,
            pressure: Default::default(),
            pipes: None,
        },
        liquid: Liquid {
            density: liquid.0,
            fill_height: liquid.1,
        },
        gravity: 9.81,
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

/// The broad aluminium tank of Manos & Clough 1982.
pub(crate) fn broad() -> Case {
    case(
        Shape::Cylinder { radius: 1.83 },
        &[(0.915, 2.03e-3), (0.915, 1.27e-3)],
        (69e9, 0.32, 2750.0),
        (1000.0, 1.525),
    )
}
