//! Shells, walls of two shells, beams.

use std::sync::Arc;

use fem::element::Element;
use fem::element::beam_section::FibreSection;
use fem::element::fibre_beam::{FibreBeam, Options, Points};
use fem::element::shell::layered::{Bar, LayeredSection, Ply};
use fem::element::shell::rule::Rule;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell4::{Axes, MassKind, MembraneShear, Shell4};
use fem::element::solid8::{Elastic as Solid, Kinematics};
use fem::element::wall::{Layer, LayerMass, Wall};
use materials::elastic::Elastic;
use materials::von_mises::VonMises;
use nalgebra::{UnitQuaternion, Vector3};

use super::{area, turned, volume};
use crate::specimen::{Mass, Rotations, Specimen, Tangent, Turns};

type Turn = UnitQuaternion<f64>;

const WARPED: [[f64; 3]; 4] = [[0.0, 0.0, 0.05], [1.2, 0.1, -0.05], [1.0, 0.9, 0.1], [-0.1, 1.1, -0.02]];

/// Unit vectors that are not parallel.
fn directors() -> [Vector3<f64>; 4] {
    [[0.1, 0.05], [-0.1, 0.1], [0.0, -0.1], [0.05, 0.1]].map(|[a, b]| Vector3::new(a, b, 1.0).normalize())
}

const TURNED_NODES: &str = "rotations of the nodes have no order: the derivative is symmetric at equilibrium alone";

fn elastic(young: f64, thickness: f64) -> Arc<dyn Section> {
    Arc::new(ElasticSection::new(young, 0.3, thickness, 2.0).unwrap())
}

/// Steel 2 cm thick that yields at 0.2 %, with bars across.
fn reinforced() -> Arc<dyn Section> {
    let steel = Arc::new(VonMises::new(200e9, 0.3, 400e6, 4e9, 0.5).unwrap());
    let ply = Ply { law: steel.clone(), thickness: 0.02, density: 7850.0, rule: Rule::Gauss(3) };
    let bar = Bar { law: steel, area: 1e-3, depth: 0.005, angle: 0.4, density: 7850.0 };
    Arc::new(LayeredSection::new(&[ply], &[bar]).unwrap())
}

fn shell(what: &'static str, per_area: f64, make: impl Fn(&Turn) -> Shell4 + 'static) -> Specimen {
    Specimen {
        tangent: Tangent::SymmetricPart(TURNED_NODES),
        rotations: Rotations::Finite,
        // The mass is integrated with the points of the stiffness.
        mass: Mass::Of(per_area * area(&WARPED, 2)),
        ..Specimen::new("Shell4", what, &WARPED, move |turn| Box::new(make(turn)) as Box<dyn Element>)
    }
}

fn bare(turn: &Turn, section: Arc<dyn Section>) -> Shell4 {
    let corners = WARPED.map(|x| turned(turn, x));
    Shell4::new([0, 1, 2, 3], corners, directors().map(|d| turn * d), section).unwrap()
}

fn shells() -> Vec<Specimen> {
    let along = |turn: &Turn| Axes::Along(turned(turn, [1.0, 0.2, 0.0]));
    vec![
        shell("elastic", 0.16, |t| bare(t, elastic(1000.0, 0.08))),
        shell("plain MITC4, lumped mass", 0.16, |t| {
            bare(t, elastic(1000.0, 0.08)).with_membrane_shear(MembraneShear::Full).with_mass(MassKind::Lumped)
        }),
        shell("with drilling", 0.16, |t| bare(t, elastic(1000.0, 0.08)).with_drilling([true; 4], 0.1).unwrap()),
        Specimen {
            // Strains of 1 %: steel yields.
            amplitude: 0.01,
            ..shell("of yielding layers and bars", 7850.0 * 0.021, move |t| bare(t, reinforced()).with_axes(along(t)))
        },
    ]
}

/// A wall, or a part of one whose layer is loose.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Whole,
    Shells,
    Layer,
}

fn wall(what: &'static str, material: Solid, mass: LayerMass, part: Of) -> Specimen {
    const FACES: [f64; 2] = [0.04, 0.06];
    let outer: [[f64; 3]; 4] = std::array::from_fn(|a| (Vector3::from(WARPED[a]) + 0.35 * directors()[a]).into());
    let positions: Vec<[f64; 3]> = WARPED.into_iter().chain(outer).collect();
    let build = move |turn: &Turn| -> Box<dyn Element> {
        let shell = |first: usize, x: [[f64; 3]; 4], young, thickness| {
            let nodes = std::array::from_fn(|a| first + a);
            let corners = x.map(|x| turned(turn, x));
            Shell4::new(nodes, corners, directors().map(|d| turn * d), elastic(young, thickness)).unwrap()
        };
        let layer = Layer { material, kinematics: Kinematics::GreenLagrange, mass };
        let (inner, outer) = (shell(0, WARPED, 1000.0, 0.08), shell(4, outer, 700.0, 0.12));
        let wall = Wall::new(inner, outer, FACES, &layer).unwrap();
        match part {
            Of::Whole => Box::new(wall),
            Of::Shells => Box::new(wall.part_loose().0),
            Of::Layer => Box::new(wall.part_loose().1.unwrap()),
        }
    };
    let face = |a: usize| -> [f64; 3] {
        let (x, out) = if a < 4 { (WARPED[a], FACES[0]) } else { (outer[a - 4], -FACES[1]) };
        (Vector3::from(x) + out * directors()[a % 4]).into()
    };
    let between = volume(&std::array::from_fn(face), |_| 1.0);
    let shells = 0.16 * area(&WARPED, 2) + 0.24 * area(&outer, 2);
    Specimen {
        tangent: Tangent::SymmetricPart(TURNED_NODES),
        rotations: Rotations::Finite,
        mass: match part {
            Of::Layer => Mass::None("its mass is that of the wall"),
            _ => Mass::Of(shells + material.density * between),
        },
        ..Specimen::new(if part == Of::Layer { "LooseLayer" } else { "Wall" }, what, &positions, build)
    }
}

fn fibre_beam(what: &'static str, options: Options, yields: bool) -> Specimen {
    const ENDS: [[f64; 3]; 2] = [[1.0, 0.4, 0.5], [2.2, 0.4, 2.1]];
    let middle = [1.6, 0.4, 1.3];
    let build = move |turn: &Turn| -> Box<dyn Element> {
        let section = FibreSection::new(3.0).unwrap();
        let section = match yields {
            true => {
                let steel = Arc::new(VonMises::new(200e9, 0.3, 400e6, 4e9, 0.5).unwrap());
                section.rectangle(steel, [0.1, 0.2], 0.03, 6)
            }
            false => section.rectangle(Arc::new(Elastic::new(50.0, 0.0).unwrap()), [1.0, 0.3], 0.0, 4),
        };
        let section = section.and_then(|s| s.with_shear(if yields { 1e9 } else { 30.0 })).unwrap();
        Box::new(FibreBeam::new([0, 1, 2], ENDS.map(|x| turned(turn, x)), Arc::new(section), options).unwrap())
    };
    Specimen {
        amplitude: if yields { 0.01 } else { 0.05 },
        turns: Turns::AboutY("it lies in a plane x–z"),
        rotations: Rotations::Small("its rotations are those of linear theory, with P-Δ at most"),
        // Two metres long.
        mass: Mass::Of(3.0 * 2.0),
        ..Specimen::new("FibreBeam", what, &[ENDS[0], ENDS[1], middle], build)
    }
}

pub(crate) fn all() -> Vec<Specimen> {
    let second = |points| Options { points, second_order: true };
    let mut all = shells();
    all.extend([
        wall("isotropic layer", Solid::isotropic(60.0, 0.2, 2.0), LayerMass::Halves, Of::Whole),
        wall("layer without tension", Solid::pressed_only(50.0, 2.0), LayerMass::Inner, Of::Whole),
        wall("shells beside a layer without tension", Solid::pressed_only(50.0, 2.0), LayerMass::Inner, Of::Shells),
        wall("without tension", Solid::pressed_only(50.0, 2.0), LayerMass::Inner, Of::Layer),
        wall("core", Solid::core(50.0, 20.0, 2.0), LayerMass::Outer, Of::Whole),
        fibre_beam("elastic", Options::default(), false),
        fibre_beam("elastic, P-Δ, Lobatto", second(Points::Lobatto3), false),
        fibre_beam("yielding", Options::default(), true),
        fibre_beam("yielding, P-Δ", second(Points::Gauss3), true),
    ]);
    all
}
