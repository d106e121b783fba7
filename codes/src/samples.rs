//! Shared by the tests of several procedures: materials, tanks, records.

use std::f64::consts::PI;

use oscillator::record::Record;
use tank::case::{Case, Damping, Ec8Site, ProcedureOptions, Site};
use tank::{Bottom, Course, Liquid, Material, Roof, Shape, Support, Tank};

/// A material without strengths; modulus [Pa], density [kg/m³].
pub(crate) fn material(name: &str, youngs_modulus: f64, poisson_ratio: f64, density: f64) -> Material {
    Material {
        family: tank::Family::inferred(youngs_modulus, density),
        name: name.into(),
        youngs_modulus,
        poisson_ratio,
        density,
        yield_strength: None,
        allowable_stress: None,
        behaviour: Default::default(),
        volume_change: Default::default(),
    }
}

/// Steel, E = 210 GPa, ν = 0.3, 7850 kg/m³.
pub(crate) fn steel() -> Material {
    material("steel", 210e9, 0.3, 7850.0)
}

/// A bottom plate of 10 mm, on ground that is not given.
pub(crate) fn bottom_plate(material: Material) -> Bottom {
    Bottom {
        thickness: 0.010,
        sketch: None,
        projection: 0.0,
        corrosion: 0.0,
        width: None,
        subgrade_modulus: None,
        material,
    }
}

/// A course; height and thickness [m].
pub(crate) fn course(height: f64, thickness: f64, material: Material) -> Course {
    Course { height, thickness, corrosion: 0.0, material, layers: Vec::new() }
}

/// The dissertation's broad aluminium tank, 8.1, filled to 1.525 m.
pub(crate) fn broad_tank(site: Ec8Site) -> Case {
    let aluminium = material("aluminium", 69e9, 0.32, 2750.0);
    let courses = [0.00203, 0.00127].map(|thickness| course(0.915, thickness, aluminium.clone()));
    case(Shape::Cylinder { radius: 1.83 }, courses.to_vec(), 1.525, Some(site))
}

/// A rectangle 2L = 5 m long, H = 2.5 m of water, concrete walls 0.3 m thick and 3 m high.
pub(crate) fn concrete_rectangle(breadth: f64, strip: bool, site: Ec8Site) -> Case {
    let concrete = material("concrete", 30e9, 0.2, 2500.0);
    let shape = Shape::Rectangle { length: 5.0, breadth, strip };
    case(shape, vec![course(3.0, 0.3, concrete)], 2.5, Some(site))
}

/// An anchored tank without roof, filled with water to a depth [m]; g = 9.81 m/s², no record.
pub(crate) fn case(shape: Shape, courses: Vec<Course>, depth: f64, ec8: Option<Ec8Site>) -> Case {
    Case {
        name: "test".into(),
        tank: Tank {
            details: tank::Details::default(),
            shape,
            support: Support::Anchored,
            courses,
            roof: Roof::default(),
            bottom: None,
            wall_base: tank::WallBase::Fixed,
            foundation: None,
            isolators: None,
            staging: None,
            rings: Vec::new(),
            attachments: Vec::new(),
            subsoil: tank::Subsoil::default(),
            insulation: None,
            anchors: None,
            pressure: Default::default(),
            pipes: None,
        },
        liquid: Liquid { density: 1000.0, fill_height: depth, bulk_modulus: None },
        gravity: 9.81,
        ground_motion: None,
        damping: Damping { sloshing: 0.005, impulsive: 0.02 },
        site: Site { ec8, ..Site::default() },
        procedures: ProcedureOptions::default(),
        measured: Vec::new(),
        published: Vec::new(),
    }
}

/// Two seconds of sine at 2 Hz with the amplitude `a` [m/s²].
pub(crate) fn record(a: f64) -> Record {
    Record {
        name: "sine".into(),
        dt: 0.01,
        acceleration: (0..200).map(|i| a * (4.0 * PI * 0.01 * f64::from(i)).sin()).collect(),
        processing: vec![],
    }
}

/// Fails unless a value is within a tolerance of its reference.
#[track_caller]
pub(crate) fn close(value: f64, expected: f64, tolerance: f64) {
    near(value, expected, tolerance, "value");
}

/// As [`close`], with the name of the value.
#[track_caller]
pub(crate) fn near(value: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((value - expected).abs() <= tolerance, "{what}: {value} instead of {expected} ± {tolerance}");
}
