//! Liquids in displacements and in their potential, and their boundaries.

use fem::chart::Chart;
use fem::dofs::{Dof, KINDS};
use fem::element::{
    Element, Fluid8, FreeSurface, LiquidProperties, Potential8, PotentialSurface, RotationPart, VolumePart, WetFace,
};
use fem::mesh::{Face, Hexahedron};
use nalgebra::UnitQuaternion;

use super::solids::BRICK;
use super::{area, spun, turned, volume};
use crate::specimen::{Mass, Specimen, Turns};

type Turn = UnitQuaternion<f64>;

const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 9.81;

/// A distorted sector of a ring: (r, θ, z).
const SECTOR: [[f64; 3]; 8] = [
    [1.0, 0.1, 0.0],
    [1.6, 0.2, 0.1],
    [1.7, 0.7, 0.0],
    [1.1, 0.6, -0.1],
    [0.9, 0.15, 0.8],
    [1.5, 0.1, 0.9],
    [1.8, 0.65, 1.1],
    [1.2, 0.55, 0.9],
];
/// A plane quadrilateral that looks upwards.
const LEVEL: [[f64; 3]; 4] = [[0.0, 0.1, 1.0], [1.2, 0.0, 1.0], [1.1, 0.9, 1.0], [-0.1, 1.0, 1.0]];
/// A sector of a disc that looks upwards, straight along r and θ: (r, θ, z).
const DISC: [[f64; 3]; 4] = [[0.5, 0.2, 1.0], [1.5, 0.2, 1.0], [1.5, 0.8, 1.0], [0.5, 0.8, 1.0]];

const CYLINDER: Turns = Turns::AboutZ("its coordinates are cylindrical");
const LEVELLED: Turns = Turns::AboutZ("gravity acts along z");
const HELD: &str = "K_rot resists rotations";
const CHARTED: &str = "its components along r and θ are interpolated: a motion along x is not in their space";
const HEAVY: &str = "raised liquid has weight";

fn positions(chart: Chart, corners: &[[f64; 3]]) -> Vec<[f64; 3]> {
    corners.iter().map(|&c| chart.position(c)).collect()
}

/// Corners in turned axes.
fn placed<const N: usize>(chart: Chart, corners: [[f64; 3]; N], turn: &Turn) -> [[f64; 3]; N] {
    match chart {
        Chart::Cartesian => corners.map(|x| turned(turn, x)),
        Chart::Cylindrical => corners.map(|x| spun(turn, x)),
    }
}

fn face(chart: Chart, corners: [[f64; 3]; 4], turn: &Turn) -> Face {
    Face { nodes: [0, 1, 2, 3], chart: placed(chart, corners, turn) }
}

fn cell(chart: Chart, corners: [[f64; 3]; 8], turn: &Turn) -> Hexahedron {
    Hexahedron { nodes: std::array::from_fn(|a| a), chart: placed(chart, corners, turn) }
}

fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: DENSITY, bulk_modulus: 2e6, volume, rotation }
}

const SPLIT: RotationPart = RotationPart::Split { centre: 1e5, rest: 1e3 };

fn fluid8(what: &'static str, chart: Chart, corners: [[f64; 3]; 8], liquid: LiquidProperties) -> Specimen {
    let build = move |turn: &Turn| -> Box<dyn Element> {
        Box::new(Fluid8::new(&cell(chart, corners, turn), chart, liquid).unwrap())
    };
    let factor = |x: [f64; 3]| match chart {
        Chart::Cartesian => 1.0,
        Chart::Cylindrical => x[0],
    };
    let total = DENSITY * volume(&corners, factor);
    Specimen {
        resists: match (liquid.rotation, chart) {
            (RotationPart::None, _) => (&[], ""),
            (_, Chart::Cartesian) => (&[3, 4, 5], HELD),
            (_, Chart::Cylindrical) => (&[0, 1, 3, 4, 5], CHARTED),
        },
        turns: match chart {
            Chart::Cartesian => Turns::Any,
            Chart::Cylindrical => CYLINDER,
        },
        mass: match chart {
            Chart::Cartesian => Mass::Of(total),
            Chart::Cylindrical => Mass::Along(2, total, CHARTED),
        },
        ..Specimen::new("Fluid8", what, &positions(chart, &corners), build)
    }
}

fn surfaces() -> Vec<Specimen> {
    let surface = |what, chart: Chart, corners: [[f64; 3]; 4], one_point: bool| {
        let build = move |turn: &Turn| -> Box<dyn Element> {
            let face = face(chart, corners, turn);
            let make = if one_point { FreeSurface::at_one_point } else { FreeSurface::new };
            Box::new(make(&face, chart, DENSITY * GRAVITY).unwrap())
        };
        Specimen {
            resists: (&[2, 3, 4], HEAVY),
            turns: LEVELLED,
            ..Specimen::new("FreeSurface", what, &positions(chart, &corners), build)
        }
    };
    vec![
        surface("plane", Chart::Cartesian, LEVEL, false),
        surface("plane, one point", Chart::Cartesian, LEVEL, true),
        surface("sector", Chart::Cylindrical, DISC, false),
    ]
}

fn one(dof: Dof) -> [f64; KINDS] {
    let mut out = [0.0; KINDS];
    out[dof.index()] = 1.0;
    out
}

/// φ = z, whose gradient is 1.
fn vertical([_, _, z]: [f64; 3]) -> [f64; KINDS] {
    one(Dof::Phi).map(|x| x * z)
}

fn potentials() -> Vec<Specimen> {
    let liquid = |what, chart: Chart, corners: [[f64; 3]; 8], factor: fn([f64; 3]) -> f64| Specimen {
        turns: if chart == Chart::Cartesian { Turns::Any } else { CYLINDER },
        mass: Mass::Joins { left: vertical, right: vertical, value: -DENSITY * volume(&corners, factor) },
        ..Specimen::new("Potential8", what, &positions(chart, &corners), move |turn| {
            Box::new(Potential8::new(&cell(chart, corners, turn), chart, DENSITY).unwrap()) as Box<dyn Element>
        })
    };
    let surface = |what, chart: Chart, corners: [[f64; 3]; 4], area: f64| Specimen {
        turns: if chart == Chart::Cartesian { LEVELLED } else { CYLINDER },
        mass: Mass::Joins { left: |_| one(Dof::Phi), right: |_| one(Dof::Eta), value: DENSITY * area },
        ..Specimen::new("PotentialSurface", what, &positions(chart, &corners), move |turn| {
            Box::new(PotentialSurface::new(&face(chart, corners, turn), chart, DENSITY, GRAVITY).unwrap())
                as Box<dyn Element>
        })
    };
    vec![
        liquid("Cartesian", Chart::Cartesian, BRICK, |_| 1.0),
        liquid("cylindrical", Chart::Cylindrical, SECTOR, |x| x[0]),
        surface("plane", Chart::Cartesian, LEVEL, area(&LEVEL, 1)),
        // Half the angle times the difference of the squares of the radii.
        surface("sector", Chart::Cylindrical, DISC, 0.5 * 0.6 * (1.5 * 1.5 - 0.5 * 0.5)),
    ]
}

/// A plane wall along y: u_y = 1 displaces its area.
fn wet_faces() -> Vec<Specimen> {
    const WALL: [[f64; 3]; 4] = [[0.0, 1.0, 0.0], [0.0, 1.0, 0.9], [1.3, 1.0, 0.9], [1.3, 1.0, 0.0]];
    let joined = |what, shared: bool| {
        let build = move |turn: &Turn| -> Box<dyn Element> {
            let normals = [turned(turn, [0.0, 1.0, 0.0]); 4];
            let own = face(Chart::Cartesian, WALL, turn);
            if shared {
                let wall = Face { nodes: [4, 5, 6, 7], ..own };
                let found = WetFace::overlapping(&own, &wall, Chart::Cartesian, normals, DENSITY);
                return Box::new(found.unwrap().expect("the faces are one"));
            }
            Box::new(WetFace::new(&own, Chart::Cartesian, [4, 5, 6, 7], normals, DENSITY).unwrap())
        };
        let positions: Vec<[f64; 3]> = WALL.into_iter().chain(WALL).collect();
        Specimen {
            turns: if shared { Turns::None("it joins faces on one coordinate plane") } else { Turns::Any },
            mass: Mass::Joins { left: |_| one(Dof::Phi), right: |_| one(Dof::Uy), value: DENSITY * 1.3 * 0.9 },
            ..Specimen::new("WetFace", what, &positions, build)
        }
    };
    vec![joined("matching nodes", false), joined("overlapping faces", true)]
}

pub(crate) fn all() -> Vec<Specimen> {
    let full = liquid(VolumePart::Full, RotationPart::Full(1e4));
    let mean = liquid(VolumePart::MeanDilatation, SPLIT);
    let free = liquid(VolumePart::MeanDilatation, RotationPart::None);
    let mut all = vec![
        fluid8("full quadrature", Chart::Cartesian, BRICK, full),
        fluid8("mean dilatation", Chart::Cartesian, BRICK, mean),
        fluid8("free rotation", Chart::Cartesian, BRICK, free),
        fluid8("sector", Chart::Cylindrical, SECTOR, mean),
    ];
    all.extend(surfaces());
    all.extend(potentials());
    all.extend(wet_faces());
    all
}
