//! The elements under check: an entry for each way in which an element works.

use fem::chart::Chart;
use fem::element::{Element, LiquidProperties, RotationPart, VolumePart};
use fem::mesh::Face;
use nalgebra::{UnitQuaternion, Vector3};
use verification::elements::beam2::{Beam2, BeamSection};
use verification::elements::{Fluid4, FreeSurfaceLine};

use crate::specimen::{Least, Mass, Specimen, Turns};

type Turn = UnitQuaternion<f64>;

const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 9.81;
const HELD: &str = "K_rot resists rotations";

/// All of them.
pub(crate) fn all() -> Vec<Specimen> {
    let mean = liquid(VolumePart::MeanDilatation, RotationPart::Split { centre: 1e5, rest: 1e3 });
    let point = liquid(VolumePart::OnePoint, RotationPart::OnePoint(1e4));
    vec![
        beam(),
        fluid4("plane", Chart::Cartesian, mean),
        fluid4("plane, one point", Chart::Cartesian, point),
        fluid4("sector", Chart::Cylindrical, mean),
        line(),
    ]
}

/// They are linear: none has a history, a mixed tangent or a geometric stiffness.
pub(crate) fn least() -> Least {
    Least { dissipate: 0, mixed: 0, buckle: 0, change: 0 }
}

fn beam() -> Specimen {
    const ENDS: [[f64; 3]; 2] = [[0.2, -0.1, 0.3], [1.1, 0.7, 1.2]];
    let length = (Vector3::from(ENDS[1]) - Vector3::from(ENDS[0])).norm();
    let build = |turn: &Turn| -> Box<dyn Element> {
        let section = BeamSection {
            axial: 100.0,
            bending_2: 3.0,
            bending_3: 5.0,
            torsion: 2.0,
            shear: [30.0, 40.0],
            mass: 1.7,
            polar_inertia: 0.2,
        };
        Box::new(
            Beam2::new(
                [0, 1],
                ENDS.map(|x| (turn * Vector3::from(x)).into()),
                (turn * Vector3::new(0.0, 1.0, 0.2)).into(),
                section,
            )
            .unwrap(),
        )
    };
    Specimen { mass: Mass::Of(1.7 * length), ..Specimen::new("Beam2", "in space", &ENDS, build) }
}

fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: DENSITY, bulk_modulus: 2e6, volume, rotation }
}

fn fluid4(what: &'static str, chart: Chart, liquid: LiquidProperties) -> Specimen {
    const CORNERS: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [1.9, 0.0, 0.1], [2.0, 0.0, 0.8], [0.9, 0.0, 0.7]];
    const BREADTH: f64 = 0.7;
    let build = move |_: &Turn| -> Box<dyn Element> {
        let face = Face { nodes: [0, 1, 2, 3], chart: CORNERS };
        Box::new(Fluid4::new(&face, chart, BREADTH, liquid).unwrap())
    };
    // Area of the section, or its first moment about the axis: sums over its sides.
    let sides = CORNERS.iter().zip(CORNERS.iter().cycle().skip(1));
    let section: f64 = sides
        .map(|([x, _, z], [x2, _, z2])| {
            let twice = x * z2 - x2 * z;
            match chart {
                Chart::Cartesian => twice / 2.0,
                Chart::Cylindrical => twice * (x + x2) / 6.0,
            }
        })
        .sum();
    let total = DENSITY * BREADTH * section;
    Specimen {
        resists: match chart {
            Chart::Cartesian => (&[4], HELD),
            Chart::Cylindrical => (&[0, 4], "moved outwards all around, the liquid expands; K_rot resists rotations"),
        },
        turns: Turns::None("it lies in the plane x–z with z upwards"),
        mass: match chart {
            Chart::Cartesian => Mass::Of(total),
            Chart::Cylindrical => Mass::Along(2, total, "a motion along r is not a translation"),
        },
        ..Specimen::new("Fluid4", what, &CORNERS, build)
    }
}

fn line() -> Specimen {
    let ends = [[0.4, 0.0, 1.0], [1.3, 0.0, 1.0]];
    Specimen {
        resists: (&[2, 4], "raised liquid has weight"),
        turns: Turns::None("it is the surface of a liquid in the plane x–z"),
        ..Specimen::new("FreeSurfaceLine", "of a sector", &ends, |_| {
            let made = FreeSurfaceLine::new([0, 1], [0.4, 1.3], Chart::Cylindrical, 0.7, DENSITY * GRAVITY);
            Box::new(made.unwrap())
        })
    }
}
