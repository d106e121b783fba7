//! Solids, and the pressure on their faces.

use fem::element::Element;
use fem::element::shell::load::FollowerPressure;
use fem::element::solid8::{Elastic, Kinematics, Solid8};
use nalgebra::UnitQuaternion;

use super::{turned, volume};
use crate::specimen::{Mass, Rotations, Specimen, Tangent};

/// A distorted brick, counter-clockwise below, then above.
pub(crate) const BRICK: [[f64; 3]; 8] = [
    [0.03, -0.02, 0.06],
    [1.15, 0.04, -0.05],
    [1.22, 0.83, 0.07],
    [0.02, 0.76, 0.01],
    [-0.04, 0.03, 0.95],
    [1.26, -0.05, 1.08],
    [1.19, 0.80, 1.02],
    [0.05, 0.85, 0.97],
];

const DENSITY: f64 = 2.5;

fn brick(what: &'static str, kinematics: Kinematics, material: Elastic) -> Specimen {
    let build = move |turn: &UnitQuaternion<f64>| -> Box<dyn Element> {
        let corners = BRICK.map(|x| turned(turn, x));
        Box::new(Solid8::new([0, 1, 2, 3, 4, 5, 6, 7], corners, material, kinematics).unwrap())
    };
    Specimen {
        rotations: match kinematics {
            Kinematics::GreenLagrange => Rotations::Finite,
            Kinematics::Linear => Rotations::Small("its kinematics is the linear one"),
        },
        mass: Mass::Of(DENSITY * volume(&BRICK, |_| 1.0)),
        ..Specimen::new("Solid8", what, &BRICK, build)
    }
}

fn pressure(what: &'static str, dead: bool) -> Specimen {
    const FACE: [[f64; 3]; 4] = [[0.0, 0.1, 0.0], [1.2, 0.0, 0.1], [1.1, 0.9, -0.1], [-0.1, 1.0, 0.2]];
    let build = move |turn: &UnitQuaternion<f64>| -> Box<dyn Element> {
        let load = FollowerPressure::varying([0, 1, 2, 3], FACE.map(|x| turned(turn, x)), [3.0, 4.0, 6.0, 5.0]);
        Box::new(if dead { load } else { load.without_dead_part() })
    };
    Specimen {
        tangent: Tangent::SymmetricPart("the edges of the face are free: the load has no potential"),
        rotations: match dead {
            true => Rotations::Finite,
            false => Rotations::Small("the load on the undeformed face is taken off"),
        },
        load: dead.then_some("it is a load"),
        resists: (
            &[0, 1, 2, 3, 4, 5],
            "the symmetric part of its tangent feels the free edges, and the load turns with the face",
        ),
        mass: Mass::None("it is a load"),
        ..Specimen::new("FollowerPressure", what, &FACE, build)
    }
}

pub(crate) fn all() -> Vec<Specimen> {
    let isotropic = Elastic::isotropic(100.0, 0.3, DENSITY).with_damping(0.3, 0.02);
    vec![
        brick("linear", Kinematics::Linear, isotropic),
        brick("Green-Lagrange", Kinematics::GreenLagrange, isotropic),
        brick("layer stiff along its normal", Kinematics::GreenLagrange, Elastic::normal_only(80.0, DENSITY)),
        brick("layer without tension", Kinematics::GreenLagrange, Elastic::pressed_only(80.0, DENSITY)),
        brick("core of a sandwich", Kinematics::GreenLagrange, Elastic::core(80.0, 30.0, DENSITY)),
        brick("layer stiff in its plane", Kinematics::GreenLagrange, Elastic::transverse([80.0, 30.0, 50.0], DENSITY)),
        pressure("whole", true),
        pressure("without its dead part", false),
    ]
}
