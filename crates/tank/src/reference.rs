//! The tanks of [B02, chapter 8] (docs/references.md) for tests, examples and the verification rows.

use crate::Case;
use crate::case::{Damping, ProcedureOptions, Site};
use crate::{Course, Liquid, Material, Roof, Shape, Support, Tank};

/// Acceleration of free fall of all rows [m/s²], as in [B02].
pub const GRAVITY: f64 = 9.81;

/// `manos_clough_broad` [B02, 8.1], tested by Manos & Clough (1982); liquid of this density [kg/m³], 1.525 m deep.
pub fn broad(density: f64) -> Case {
    let aluminium = material(69e9, 0.32, 2750.0);
    case(Shape::Cylinder { radius: 1.83 }, &[(0.915, 2.03e-3), (0.915, 1.27e-3)], &aluminium, (density, 1.525))
}

/// `slender_steel` [B02, 8.3]: wall 5.5 m, 2 mm; liquid of this density [kg/m³] and depth [m].
pub fn slender(density: f64, depth: f64) -> Case {
    let steel = material(210e9, 0.3, 7850.0);
    case(Shape::Cylinder { radius: 1.83 }, &[(5.5, 2e-3)], &steel, (density, depth))
}

/// A material without strengths: E [Pa], ν, ρ_s [kg/m³].
pub fn material(youngs_modulus: f64, poisson_ratio: f64, density: f64) -> Material {
    Material {
        family: crate::Family::inferred(youngs_modulus, density),
        name: "wall".into(),
        youngs_modulus,
        poisson_ratio,
        density,
        yield_strength: None,
        allowable_stress: None,
        behaviour: Default::default(),
        volume_change: Default::default(),
    }
}

/// A case without ground motion: courses as (height, thickness) [m], liquid as (density [kg/m³], depth [m]).
pub fn case(shape: Shape, courses: &[(f64, f64)], material: &Material, liquid: (f64, f64)) -> Case {
    let course = |&(height, thickness): &(f64, f64)| Course {
        height,
        thickness,
        corrosion: 0.0,
        material: material.clone(),
        layers: Vec::new(),
    };
    Case {
        name: "verification".into(),
        tank: Tank {
            details: crate::Details::default(),
            shape,
            support: Support::Anchored,
            courses: courses.iter().map(course).collect(),
            roof: Roof::default(),
            bottom: None,
            wall_base: crate::tank::WallBase::Fixed,
            foundation: None,
            isolators: None,
            staging: None,
            rings: Vec::new(),
            attachments: Vec::new(),
            subsoil: crate::Subsoil::default(),
            insulation: None,
            anchors: None,
            pressure: Default::default(),
            pipes: None,
        },
        liquid: Liquid { density: liquid.0, fill_height: liquid.1, bulk_modulus: None },
        gravity: GRAVITY,
        ground_motion: None,
        damping: Damping { sloshing: 0.005, impulsive: 0.02 },
        site: Site::default(),
        procedures: ProcedureOptions::default(),
        measured: Vec::new(),
        published: Vec::new(),
    }
}
