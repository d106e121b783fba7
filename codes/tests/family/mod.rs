//! Tanks, sites and records that between them reach every branch of every procedure: a fixed pseudo-random sequence over
//! shapes, slendernesses, supports, soils, intensities and options.

use oscillator::record::Record;
use tank::Case;
use tank::case::{
    Api650Site, Combination, Components, ConvectiveCoefficient, Damping, Ec8Site, FlexibleImpulsive, GroundMotion,
    GroundType, ProcedureOptions, Site, SiteClass,
};
use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumParameters};
use tank::national::{Is1893Site, NationalSite, Soil, Zone};
use tank::{Anchors, Behaviour, Bottom, Course, Liquid, Material, Pipes, Pressure, Roof, Shape, Support, Tank};

/// Number of cases.
pub(crate) const COUNT: u64 = 240;

/// Number of tanks of concrete after these.
const CONCRETE: u64 = 72;

/// The family.
pub(crate) fn cases() -> impl Iterator<Item = Case> {
    let draw = |number: u64| Draw(number.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1).case();
    (0..COUNT).map(draw).chain((0..CONCRETE).map(move |number| of_concrete(draw(COUNT + number), number as usize)))
}

/// The same tank of concrete, on all joints and under the sites of the codes that cover it.
fn of_concrete(mut case: Case, number: usize) -> Case {
    for course in &mut case.tank.courses {
        course.thickness = course.thickness.max(0.2);
        let (name, family) = ("concrete".into(), Some(tank::Family::Concrete));
        let material = Material { name, family, youngs_modulus: 28e9, poisson_ratio: 0.2, ..course.material.clone() };
        course.material = Material { density: 2400.0, yield_strength: None, ..material };
    }
    let sliding = tank::WallBase::Sliding { stiffness: [None, Some(1e6), Some(50e6)][number % 3], friction: Some(0.5) };
    let bases = [tank::WallBase::Fixed, tank::WallBase::Hinged, sliding];
    case.tank.wall_base = bases[number / 3 % 3];
    let soils = [Soil::Hard, Soil::Medium, Soil::Soft];
    let zones = [Zone::II, Zone::III, Zone::IV, Zone::V];
    case.site.is1893 = Some(Is1893Site {
        zone: zones[number % 4],
        soil: soils[number % 3],
        importance: 1.5,
        response_reduction: [None, Some(2.5)][number % 2],
    });
    if number.is_multiple_of(4) {
        let parameters = SpectrumParameters { ag: 2.0, soil: 1.2, corners: [0.15, 0.5, 2.0], long_corners: None };
        case.site.spectrum = Some(SiteSpectrum { form: SpectrumForm::Parameters(parameters), vertical_ratio: 0.7 });
        case.site.national = Some(NationalSite {
            code: "a code".into(),
            importance: 1.2,
            impulsive_reduction: 2.0,
            sloshing_reduction: 1.0,
            sloshing_factor: [None, Some(1.75)][number / 4 % 2],
        });
    }
    case
}

/// A tank of 20 m diameter with everything given, for a ratio H/R.
pub(crate) fn of_slenderness(slenderness: f64) -> Case {
    let mut case = Draw(1).case();
    let depth = 10.0 * slenderness;
    case.tank.shape = Shape::Cylinder { radius: 10.0 };
    case.tank.courses.truncate(1);
    case.tank.courses[0].height = 1.1 * depth;
    case.tank.courses[0].thickness = 0.02;
    case.tank.courses[0].material.yield_strength = Some(235e6);
    case.liquid.fill_height = depth;
    case.site = Site { ec8: Some(Draw(3).ec8()), api650: Some(Draw(5).api650()), ..Site::default() };
    case
}

/// Pseudo-random choices (a linear congruential generator; any sequence does that repeats).
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() as usize) % choices.len()]
    }

    fn yes(&mut self) -> bool {
        self.next().is_multiple_of(2)
    }

    fn within(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * (self.next() as f64 / (1_u64 << 31) as f64)
    }

    fn material(&mut self) -> Material {
        let (youngs_modulus, density) = (self.of(&[210e9, 206e9, 69e9]), self.of(&[7850.0, 2700.0]));
        Material {
            family: tank::Family::inferred(youngs_modulus, density),
            name: "steel".into(),
            youngs_modulus,
            poisson_ratio: 0.3,
            density,
            yield_strength: self.of(&[Some(235e6), Some(235e6), Some(60e6), None]),
            allowable_stress: self.of(&[Some(160e6), Some(160e6), None]),
            behaviour: Behaviour::default(),
            volume_change: Default::default(),
        }
    }

    fn tank(&mut self) -> (Tank, f64) {
        let half = self.of(&[0.5, 1.83, 5.0, 15.0, 40.0]);
        let slenderness = self.of(&[0.1, 0.29, 0.31, 0.5, 0.79, 0.81, 1.0, 1.4, 1.6, 2.5, 3.1, 3.9, 4.5, 8.0]);
        let depth = half * slenderness;
        let freeboard = self.of(&[1.001, 1.1, 1.4]);
        let count = self.of(&[1, 2, 5]);
        let thickest = half * self.of(&[2e-4, 6e-4, 1.2e-3, 4e-3]);
        let material = self.material();
        let courses = (0..count)
            .map(|i| Course {
                height: depth * freeboard / f64::from(count),
                thickness: thickest * (1.0 - 0.12 * f64::from(i)),
                corrosion: 0.0,
                material: material.clone(),
                layers: Vec::new(),
            })
            .collect();
        let shape = match self.next() % 6 {
            0 => Shape::Rectangle { length: 2.0 * half, breadth: self.of(&[0.7, 1.3]) * half, strip: false },
            1 => Shape::Rectangle { length: 2.0 * half, breadth: 1.0, strip: true },
            _ => Shape::Cylinder { radius: half },
        };
        let support = self.of(&[Support::Anchored, Support::Unanchored]);
        let plate = Bottom {
            thickness: thickest * self.of(&[0.3, 0.8, 1.5]),
            sketch: None,
            projection: 0.0,
            corrosion: 0.0,
            width: self.of(&[None, Some(0.6)]),
            subgrade_modulus: self.of(&[None, Some(5e8)]),
            material: self.material(),
        };
        let tank = Tank {
            details: tank::Details::default(),
            shape,
            support,
            courses,
            roof: Roof { mass: self.of(&[0.0, 5.0, 60.0]) * half * half, height: None, ..Roof::default() },
            bottom: self.of(&[true, true, true, false]).then_some(plate),
            wall_base: tank::WallBase::Fixed,
            foundation: None,
            isolators: None,
            staging: None,
            rings: Vec::new(),
            attachments: Vec::new(),
            subsoil: tank::Subsoil::default(),
            insulation: None,
            anchors: self.yes().then(|| Anchors {
                count: 40,
                capacity: self.yes().then_some(200e3),
                attachment_capacity: self.yes().then_some(500e3),
                ..Anchors::default()
            }),
            pressure: Pressure { internal: self.of(&[0.0, 0.0, 5e3]), vacuum: self.of(&[0.0, 0.0, 1e3]) },
            pipes: self.yes().then(|| Pipes {
                support_distance: self.of(&[None, Some(10.0)]),
                allowable_displacement: self.of(&[None, Some(0.05)]),
                ..Pipes::default()
            }),
        };
        (tank, depth)
    }

    fn ec8(&mut self) -> Ec8Site {
        use GroundType::{A, B, C, D, E};
        Ec8Site {
            ground: self.of(&[A, B, C, D, E]),
            spectrum: self.of(&[1, 1, 2]),
            ag: self.of(&[0.2, 1.0, 3.5]),
            importance: self.of(&[1.0, 1.4]),
            behaviour_factor: self.of(&[1.0, 1.5]),
            construction_quality: self.of(&[1.0, 1.5, 2.5]),
            vertical: self.yes(),
            components: self.of(&[Components::One, Components::HundredThirty]),
            friction: self.yes().then_some(0.4),
            reduction_factor: self.of(&[None, Some(0.4), Some(0.5)]),
            bearing_capacity: self.of(&[None, Some(250e3)]),
        }
    }

    fn api650(&mut self) -> Api650Site {
        use SiteClass::{A, B, C, D, E, F};
        let site_class = self.of(&[A, B, C, D, E, F]);
        let study = site_class == F || self.yes();
        Api650Site {
            bearing_capacity: None,
            ss: self.of(&[0.1, 0.5, 1.4]),
            s1: self.of(&[0.03, 0.2, 0.6]),
            s0: self.of(&[None, Some(0.05), Some(0.8)]),
            site_class,
            asce7: self.of(&[2010, 2016]),
            fa: study.then_some(1.1),
            fv: study.then_some(1.6),
            q: self.of(&[1.0, 2.0 / 3.0]),
            sug: self.of(&[1, 2, 3]),
            tl: self.of(&[2.0, 4.0, 8.0]),
            av: self.of(&[None, Some(0.0), Some(0.3)]),
            design_pressure: self.of(&[0.0, 2e3]),
            joint_efficiency: self.of(&[0.85, 1.0]),
            friction: self.of(&[0.3, 0.5]),
            foundation_weight: self.of(&[None, Some(2e6)]),
            zone_factor: self.of(&[Some(0.075), Some(0.2), Some(0.4), None]),
            soil_factor: self.of(&[1.0, 1.5]),
            importance_1993: self.of(&[1.0, 1.25]),
        }
    }

    fn record(&mut self, name: &str, peak: f64) -> Record {
        let (fast, slow) = (self.within(8.0, 60.0), self.within(0.5, 3.0));
        Record {
            name: name.into(),
            dt: 0.02,
            acceleration: (0..500)
                .map(|i| f64::from(i) * 0.02)
                .map(|t| peak * ((fast * t).sin() * (-0.3 * t).exp() + 0.3 * (slow * t).sin()))
                .collect(),
            processing: Vec::new(),
        }
    }

    fn case(mut self) -> Case {
        for _ in 0..8 {
            self.next();
        }
        let (tank, fill_height) = self.tank();
        let peak = self.of(&[0.02, 0.5, 3.0]);
        let horizontal = self.record("horizontal", peak);
        let vertical = self.yes().then(|| self.record("vertical", 0.6 * peak));
        Case {
            name: "family".into(),
            tank,
            liquid: Liquid { density: self.of(&[1000.0, 850.0]), fill_height, bulk_modulus: None },
            gravity: self.of(&[9.80665, 9.81]),
            ground_motion: Some(GroundMotion { horizontal, transverse: None, vertical }),
            damping: Damping { sloshing: 0.005, impulsive: self.of(&[0.02, 0.05]) },
            site: Site {
                ec8: self.of(&[true, true, true, false]).then(|| self.ec8()),
                api650: self.of(&[true, true, true, false]).then(|| self.api650()),
                ..Site::default()
            },
            procedures: ProcedureOptions {
                housner_convective: self.of(&[ConvectiveCoefficient::Exact, ConvectiveCoefficient::Housner1957]),
                housner_combination: self.of(&[Combination::Abs, Combination::Srss]),
                ec8_combination: self.of(&[Combination::Abs, Combination::Srss]),
                ec8_impulsive: self.of(&[FlexibleImpulsive::Simplified, FlexibleImpulsive::Iterative]),
                ..ProcedureOptions::DEFAULT
            },
            measured: Vec::new(),
            published: Vec::new(),
        }
    }
}
