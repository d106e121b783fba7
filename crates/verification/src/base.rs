//! The base of a tank that is not held down.
//!
//! | rows | model | reference |
//! |---|---|---|
//! | U1 | strip on nearly rigid ground, rim hinged, clamped, yielding | closed forms |
//! | U2 | strip with the edge of the wall, elastic and yielding, four tanks | an independent program |
//! | U3 | round plate lifted evenly | four constants; an independent program |
//! | U4 | foot that stays plane: linear ground, constant hold-down, bolts | closed forms |
//! | U5 | moment against rotation of three tanks | an independent program |
//! | U6 | strip of shells on nearly rigid ground | closed forms |
//! | U7 | strip of shells with the edge of the wall, four tanks | the strips |
//! | U8 | sector of wall and bottom plate as shells, lifted evenly | an independent program |
//! | U9 to U13 | rocking in time | springs in series, quadrature, an independent program, the run held down |
//! | U14 to U17 | sliding in time | closed forms, an independent program |
//! | U18 to U20 | loops of plates that yield | an independent program, strips around the rim, Masing's rule |
//! | U21 to U23 | anchors that yield | closed forms |
//! | U24 to U26 | bottom plate dragged along the ground | closed forms |
//! | U30 to U34 | joint of wall and plate, either of which yields | the strips |
//! | U35 to U37 | strips under a rim that is free, held by a girder, round | shells of wall and plate |

use ::base::{Bands, Base, BaseError, Edge, Plan, Plate, Rim, Strip};
use tank::reference::{case, material};
use tank::{Bottom, Case, Foundation, FoundationKind, Material, Shape, Support};

use crate::Failure;

pub(crate) mod anchors;
pub(crate) mod drag;
pub(crate) mod history;
pub(crate) mod joint;
pub(crate) mod loops;
pub(crate) mod rims;
pub(crate) mod rocking;
pub(crate) mod round;
pub(crate) mod sector;
pub(crate) mod shells;
pub(crate) mod sliding;
pub(crate) mod strip;

const GRAVITY: f64 = 9.81;

/// A tank of the rows.
pub(crate) struct Sample {
    pub(crate) name: &'static str,
    pub(crate) radius: f64,
    pub(crate) fill: f64,
    pub(crate) density: f64,
    /// Lowest course and bottom plate [m].
    pub(crate) wall: f64,
    pub(crate) plate: f64,
    pub(crate) yield_stress: f64,
    pub(crate) young_modulus: f64,
    /// Wall and roof [N/m].
    pub(crate) weight: f64,
}

/// A: the aluminium tank of Manos & Clough; B: 27.8 m in diameter, of Vathi & Karamanos; C: crude oil, 40 m; D: slender.
pub(crate) const TANKS: [Sample; 4] = [
    sample("A", [1.83, 1.525, 1000.0], [2.03e-3, 2.03e-3], [240e6, 70e9], 81.0),
    sample("B", [13.9, 15.7, 1000.0], [17.7e-3, 8e-3], [235e6, 210e9], 16822.0),
    sample("C", [20.0, 15.0, 870.0], [25e-3, 10e-3], [205e6, 205e9], 21350.0),
    sample("D", [6.1, 11.3, 1000.0], [8e-3, 6.35e-3], [235e6, 210e9], 7284.0),
];

const fn sample(
    name: &'static str,
    [radius, fill, density]: [f64; 3],
    [wall, plate]: [f64; 2],
    [yield_stress, young_modulus]: [f64; 2],
    weight: f64,
) -> Sample {
    Sample { name, radius, fill, density, wall, plate, yield_stress, young_modulus, weight }
}

impl Sample {
    fn pressure(&self) -> f64 {
        self.density * GRAVITY * self.fill
    }

    /// Anchored, without ground motion: the upper of two courses is so thick that the wall has its weight.
    pub(crate) fn case(&self) -> Case {
        const DENSITY: f64 = 7850.0;
        let steel = Material { yield_strength: Some(self.yield_stress), ..material(self.young_modulus, 0.3, DENSITY) };
        let (lower, upper) = (0.3 * self.fill, 0.75 * self.fill);
        let section = self.weight / (DENSITY * GRAVITY);
        let courses = [(lower, self.wall), (upper, (section - lower * self.wall) / upper)];
        let shape = Shape::Cylinder { radius: self.radius };
        case(shape, &courses, &steel, (self.density, self.fill))
    }

    /// The base of the tank where it stands on soil of 10⁸ N/m³.
    fn standing(&self) -> Result<Base, Failure> {
        let mut case = self.case();
        let steel = case.tank.courses[0].material.clone();
        case.tank.support = Support::Unanchored;
        case.tank.bottom = Some(Bottom {
            thickness: self.plate,
            corrosion: 0.0,
            width: None,
            sketch: None,
            projection: 0.0,
            subgrade_modulus: None,
            material: steel,
        });
        case.tank.foundation = Some(Foundation {
            width: None,
            kind: FoundationKind::Soil,
            stiffness: Some(1e8),
            shear_wave_velocity: None,
            soil_density: 1900.0,
            soil_poisson_ratio: 1.0 / 3.0,
            thickness: None,
            friction: None,
        });
        Base::of(&case).map_err(|missing| Failure::from(format!("{missing:?}")))
    }

    fn strip(&self, yields: bool, modulus: f64, plan: Plan) -> Result<Strip, BaseError> {
        let plate = Plate {
            thickness: self.plate,
            young_modulus: self.young_modulus,
            poisson_ratio: 0.3,
            yield_stress: yields.then_some(self.yield_stress),
        };
        let edge = Edge {
            radius: self.radius,
            thickness: self.wall,
            young_modulus: self.young_modulus,
            poisson_ratio: 0.3,
            pressure: self.pressure(),
            gradient: self.density * GRAVITY,
        };
        let bands = Bands::uniform(plate);
        Strip::new(bands, Rim::Wall(edge), self.radius, modulus, self.pressure(), plan)
    }
}

fn failure(error: BaseError) -> Failure {
    Failure::from(error.to_string())
}
