//! The worked example of the tests: an oil tank, R = 15 m, H = 12 m, six courses, fixed roof.

use oscillator::record::Record;
use tank::assessment::Assessment;
use tank::case::{Case, Damping, GroundMotion, ProcedureOptions, Site};
use tank::{Bottom, Course, Liquid, Material, Roof, Shape, Support, Tank};

use super::ground_motion::tests::site;

/// Steel with E = 210 GPa, F_y = F_ty = 235 MPa; S_d = 157 MPa serves the hoop check only.
pub fn steel() -> Material {
    Material {
        name: "steel".into(),
        youngs_modulus: 210e9,
        poisson_ratio: 0.3,
        density: 7850.0,
        yield_strength: Some(235e6),
        allowable_stress: Some(157e6),
        behaviour: Default::default(),
    }
}

/// The tank with g = 9.81 m/s², self-anchored, site of [`site`], no record.
pub fn case() -> Case {
    Case {
        name: "worked example".into(),
        tank: Tank {
            shape: Shape::Cylinder { radius: 15.0 },
            support: Support::Unanchored,
            courses: [0.014, 0.012, 0.010, 0.008, 0.008, 0.008]
                .map(|thickness| Course {
                    height: 2.4,
                    thickness,
                    material: steel(),
                    layers: Vec::new(),
                })
                .to_vec(),
            roof: Roof {
                mass: 35_000.0,
                height: Some(15.2),
            },
            bottom: Some(Bottom {
                thickness: 0.010,
                material: steel(),
            }),
            anchors: None,
        },
        liquid: Liquid {
            density: 900.0,
            fill_height: 12.0,
        },
        gravity: 9.81,
        ground_motion: None,
        damping: Damping {
            sloshing: 0.005,
            impulsive: 0.02,
        },
        site: Site {
            ec8: None,
            api650: Some(site()),
        },
        procedures: ProcedureOptions::default(),
        measured: vec![],
        published: vec![],
    }
}

/// The case with a decaying oscillation of 0.3 g around 2.5 Hz as its record.
pub fn with_record(mut case: Case) -> Case {
    let acceleration = (0..1000)
        .map(|i| f64::from(i) * 0.02)
        .map(|t| 0.3 * 9.81 * (15.7 * t).sin() * (-0.2 * t).exp() + 0.1 * 9.81 * (1.1 * t).sin() * (-0.1 * t).exp())
        .collect();
    let horizontal = Record {
        name: "burst".into(),
        dt: 0.02,
        acceleration,
        processing: vec![],
    };
    case.ground_motion = Some(GroundMotion {
        horizontal,
        vertical: None,
    });
    case
}

/// Value of the first line with this symbol.
pub fn line(out: &Assessment, symbol: &str) -> f64 {
    out.steps
        .iter()
        .find(|s| s.symbol == symbol)
        .unwrap_or_else(|| panic!("no line {symbol}"))
        .value
}

/// Fails unless `value` is within half the last printed digit.
pub fn close(value: f64, printed: f64, half_digit: f64, what: &str) {
    assert!(
        (value - printed).abs() <= half_digit,
        "{what}: {value} instead of {printed}"
    );
}
