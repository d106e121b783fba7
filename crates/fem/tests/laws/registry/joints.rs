//! Springs, masses, contact, and matrices from elsewhere.

use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::Element;
use fem::element::anchor::Anchor;
use fem::element::contact8::{Contact8, ContactLaw, Opening};
use fem::element::ground::Ground;
use fem::element::liquid_joint::{JointPoint, LiquidJoint};
use fem::element::spring::{Direction, PointMass, Spring};
use fem::element::super_element::SuperElement;
use fem::linalg::Matrix;
use fem::liquid::{CircularLiquid, HarmonicLiquid, LiquidMesh};
use fem::mesh::Face;
use nalgebra::UnitQuaternion;

use super::turned;
use crate::specimen::{Mass, Rotations, Specimen, Tangent, Turns};

type Turn = UnitQuaternion<f64>;

/// A unit vector and two points on its line.
const ALONG: [f64; 3] = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
const LINE: [[f64; 3]; 2] = [[0.5, 0.2, 0.1], [0.9, 0.0, 0.5]];

const MASSLESS: Mass = Mass::None("it is given no mass");
const OWN_AXES: Turns = Turns::None("its components are along the axes of the nodes' own frames");
const NO_FRAME: Rotations = Rotations::Small("its directions are fixed");

fn springs() -> Vec<Specimen> {
    let translation = |turn: &Turn| Direction::Translation(turned(turn, ALONG));
    let rotation = |turn: &Turn| Direction::Rotation(turned(turn, ALONG));
    let ground = (&[0, 1, 2, 3, 4, 5][..], "it is held by the ground");
    let massless = |specimen: Specimen| Specimen { mass: MASSLESS, rotations: NO_FRAME, ..specimen };
    vec![
        massless(Specimen::new("Spring", "between two nodes", &LINE, move |t| {
            Box::new(Spring::between(0, 1, translation(t), 7.0).unwrap()) as Box<dyn Element>
        })),
        massless(Specimen::new("Spring", "of rotations", &LINE, move |t| {
            Box::new(Spring::between(0, 1, rotation(t), 7.0).unwrap())
        })),
        massless(Specimen {
            resists: ground,
            ..Specimen::new("Spring", "to the ground", &LINE[..1], move |t| {
                Box::new(Spring::to_ground(0, translation(t), 7.0).unwrap())
            })
        }),
        Specimen {
            mass: Mass::Of(3.5),
            rotations: NO_FRAME,
            ..Specimen::new("PointMass", "of a node", &LINE[..1], |_| Box::new(PointMass::new(0, 3.5).unwrap()))
        },
    ]
}

const ARCS: Tangent = Tangent::Near(
    1e-3,
    "chords replace the arcs along which a face parts: the gaps on them are of third order of the chord's height",
);

fn contact(what: &'static str, law: ContactLaw) -> Specimen {
    const CORNERS: [[f64; 3]; 4] = [[-1.0, -1.0, 0.0], [1.0, -0.8, 0.1], [1.1, 1.0, 0.0], [-1.0, 0.9, 0.1]];
    let build = move |turn: &Turn| -> Box<dyn Element> {
        let face = Face { nodes: [0, 1, 2, 3], chart: CORNERS.map(|x| turned(turn, x)) };
        let normals = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.28, 0.96], [0.0, 0.0, 1.0]].map(|n| turned(turn, n));
        Box::new(Contact8::new(&face, Chart::Cartesian, [0, 1, 2, 3], [4, 5, 6, 7], normals, law).unwrap())
    };
    // Both sides lie on each other.
    let positions: Vec<[f64; 3]> = CORNERS.into_iter().chain(CORNERS).collect();
    Specimen {
        tangent: match law.opening {
            Opening::Bonded => Tangent::Derivative,
            Opening::Unilateral { .. } => ARCS,
        },
        mass: Mass::None("it is an interface"),
        rotations: Rotations::Small("its normals are those of the reference state"),
        ..Specimen::new("Contact8", what, &positions, build)
    }
}

/// Wall nodes at x = 1 m, heights 0 and 0.5 m, against a liquid whose amplitude rests in rigid motions.
fn liquid_joint(what: &'static str, opens: bool) -> Specimen {
    let build = move |_: &Turn| -> Box<dyn Element> {
        let point = |closing: [f64; 3], relief: f64| JointPoint {
            closing: closing.into_iter().enumerate().collect(),
            relief: vec![(2, relief)],
            stiffness: 40.0,
        };
        let points = vec![point([-0.8, -0.2, 0.5], 3.0), point([-0.3, -0.7, -0.6], -2.0)];
        let unknowns = [(0, Dof::Ux), (1, Dof::Ux), (2, Dof::Amplitude)];
        Box::new(LiquidJoint::new(&unknowns, points, opens).unwrap())
    };
    Specimen {
        turns: OWN_AXES,
        rotations: NO_FRAME,
        resists: (&[0, 4], "the liquid rests where the wall moves against it"),
        mass: Mass::None("the mass is that of the liquid's amplitudes"),
        ..Specimen::new("LiquidJoint", what, &[[1.0, 0.0, 0.0], [1.0, 0.0, 0.5], [0.0; 3]], build)
    }
}

fn ground(what: &'static str, friction: Option<f64>) -> Specimen {
    let build = move |_: &Turn| -> Box<dyn Element> {
        let ground = Ground::new(0, 40.0, 0.5).unwrap();
        Box::new(match friction {
            Some(mu) => ground.with_friction(mu).unwrap(),
            None => ground,
        })
    };
    Specimen {
        turns: Turns::AboutZ("the ground is level"),
        rotations: NO_FRAME,
        resists: (&[2, 3, 4], "it is pressed where the plate goes down"),
        mass: MASSLESS,
        ..Specimen::new("Ground", what, &LINE[..1], build)
    }
}

fn anchor() -> Specimen {
    let build = move |_: &Turn| -> Box<dyn Element> { Box::new(Anchor::new(0, 40.0, 0.5).unwrap()) };
    Specimen {
        turns: Turns::AboutZ("the ground is level"),
        rotations: NO_FRAME,
        resists: (&[2, 3, 4], "it pulls where its node goes up"),
        mass: MASSLESS,
        ..Specimen::new("Anchor", "elastic-plastic", &LINE[..1], build)
    }
}

/// A bar along x with an amplitude.
fn super_element() -> Specimen {
    let build = move |_: &Turn| -> Box<dyn Element> {
        let matrix = |rows: [[f64; 3]; 3]| Matrix { rows: 3, cols: 3, data: rows.into_iter().flatten().collect() };
        let element = SuperElement::over(&[(0, Dof::Ux), (1, Dof::Ux), (1, Dof::Amplitude)])
            .and_then(|e| e.with_stiffness(matrix([[5.0, -5.0, 0.0], [-5.0, 5.0, 0.0], [0.0, 0.0, 3.0]])))
            .and_then(|e| e.with_mass(matrix([[2.0, 1.0, 0.4], [1.0, 2.0, 0.3], [0.4, 0.3, 1.0]])))
            .and_then(|e| e.with_damping(matrix([[0.1, -0.1, 0.0], [-0.1, 0.1, 0.0], [0.0, 0.0, 0.2]])))
            .unwrap();
        Box::new(element)
    };
    Specimen {
        turns: OWN_AXES,
        rotations: NO_FRAME,
        mass: Mass::Weightless(6.0, "its weight is among the loads that it is given"),
        ..Specimen::new("SuperElement", "matrices alone", &[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], build)
    }
}

/// Four nodes of a ring with an amplitude of harmonic 1, the half from 0 to π.
fn circular() -> Specimen {
    let build = move |_: &Turn| -> Box<dyn Element> {
        let heights = [0.0, 1.0];
        let mesh = LiquidMesh::graded(1.0, 1.0, 1.0);
        let liquid = HarmonicLiquid::new(1.0, 2.0, 9.81, 4, &heights, &mesh, 1).unwrap();
        let liquid = CircularLiquid::new(&liquid, true, 1).unwrap();
        let wall: Vec<(usize, Dof)> = (0..6).map(|n| (n, Dof::Ux)).collect();
        Box::new(liquid.element(&wall, &[(6, Dof::Amplitude)], 0.005).unwrap())
    };
    let nodes = [0.0, 1.0].map(|z| [[1.0, 0.0, z], [0.0, 1.0, z], [-1.0, 0.0, z]]);
    let mut nodes: Vec<[f64; 3]> = nodes.into_iter().flatten().collect();
    nodes.push([0.0; 3]);
    Specimen {
        turns: OWN_AXES,
        rotations: NO_FRAME,
        mass: Mass::Elsewhere("its frames are not those of the suite; translations are tested with the liquid"),
        resists: (
            &[0, 4, 5],
            "without frames these breathe, and the surface of the waves left out rises with the wall",
        ),
        ..Specimen::new("CircularElement", "a liquid in half a cylinder", &nodes, build)
    }
}

pub(crate) fn all() -> Vec<Specimen> {
    let mut all = springs();
    all.extend([
        contact("bonded", ContactLaw::bonded(50.0).with_tangential(8.0)),
        contact("pressure only", ContactLaw::unilateral(50.0)),
        contact("pressure only, with multipliers", ContactLaw::unilateral(50.0).with_tangential(8.0).augmented()),
        liquid_joint("bonded", false),
        liquid_joint("opens", true),
        ground("smooth", None),
        ground("with friction", Some(0.4)),
        anchor(),
        super_element(),
        circular(),
    ]);
    all
}
