//! Source:    EN 1998-1 and ASCE 7 spectra by hand; the model's own tests hold its numbers
//! Goal:      the procedure on whole cases: every line reads back, profiles meet the quantities, limits are reported
//! Tolerance: substitutions carry five digits

use super::*;
use crate::samples::{self, course, steel};
use oscillator::record::Record;
use tank::Support;
use tank::case::{Api650Site, ConvectiveCoefficient, Ec8Site, GroundMotion, GroundType, Site, SiteClass};

/// EN 1998-1, ground A, type 1, a_g = 0.5 g.
fn ec8_site() -> Ec8Site {
    Ec8Site {
        ground: GroundType::A,
        spectrum: 1,
        ag: 0.5 * 9.81,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    }
}

fn case(shape: Shape, depth: f64) -> Case {
    let courses = [4e-3, 3e-3].map(|thickness| course(0.6 * depth, thickness, steel()));
    samples::case(shape, courses.to_vec(), depth, Some(ec8_site()))
}

fn cylinder(depth: f64) -> Case {
    case(Shape::Cylinder { radius: 1.83 }, depth)
}

fn strip() -> Case {
    case(Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true }, 2.57)
}

fn assess(case: &Case) -> Assessment {
    Housner.assess(case, Excitation::Site).expect("the procedure applies")
}

/// EN 1998-1: T between T_C = 0.4 s and T_D = 2 s or beyond; η = √(10/5.5) at 0.5 %; at T > 2 s, S_e = 2.5 a_g η T_C T_D/T².
#[test]
fn site_spectrum_enters_as_in_en_1998_1() {
    let out = assess(&cylinder(1.525));
    let value = |symbol: &str| out.steps.iter().find(|s| s.symbol == symbol).expect("a line").value;
    let t: f64 = out.values[&Quantity::SloshingPeriod];
    assert!((t - 2.0953).abs() < 1e-3, "{t}");
    let by_hand = 2.5 * 4.905 * (10.0_f64 / 5.5).sqrt() * 0.4 * 2.0 / (t * t);
    assert!((value("S_a") - by_hand).abs() < 1e-9);
    assert_eq!(value("a_B"), 4.905);
    assert!(out.assumptions.iter().any(|a| a.contains("EN 1998-1")));
}

/// ASCE 7-10, class B (F = 1), S_s = 0.9, S_1 = 0.3: S_DS = 0.6, S_D1 = 0.2; a_B = 0.4 S_DS g, S_a = 1.5 S_D1/T g.
#[test]
fn asce_spectrum_stands_in_without_ec8() {
    let mut case = cylinder(1.525);
    case.site = Site {
        ec8: None,
        api650: Some(Api650Site {
            bearing_capacity: None,
            ss: 0.9,
            s1: 0.3,
            s0: None,
            site_class: SiteClass::B,
            asce7: 2010,
            fa: None,
            fv: None,
            q: 2.0 / 3.0,
            sug: 1,
            tl: 8.0,
            av: None,
            design_pressure: 0.0,
            joint_efficiency: 1.0,
            friction: 0.4,
            foundation_weight: None,
            zone_factor: None,
            soil_factor: 1.0,
            importance_1993: 1.0,
        }),
        ..Site::default()
    };
    let out = assess(&case);
    let value = |symbol: &str| out.steps.iter().find(|s| s.symbol == symbol).expect("a line").value;
    let g = tank::STANDARD_GRAVITY;
    assert!((value("a_B") - 0.24 * g).abs() < 1e-9);
    assert!((value("S_a") - 1.5 * 0.2 * g / out.values[&Quantity::SloshingPeriod]).abs() < 1e-9);
    assert!(out.assumptions.iter().any(|a| a.contains("ASCE 7")));
}

/// A record that is a step to a constant acceleration: the undamped oscillator doubles its static answer, S_a = 2 a_B.
#[test]
fn record_spectrum_enters_as_pseudo_acceleration() {
    let mut case = cylinder(1.525);
    case.damping.sloshing = 0.0;
    case.ground_motion = Some(GroundMotion {
        horizontal: Record { name: "step".into(), dt: 0.01, acceleration: vec![1.0; 1000], processing: Vec::new() },
        transverse: None,
        vertical: None,
    });
    let out = Housner.assess(&case, Excitation::Record).expect("the procedure applies");
    let value = |symbol: &str| out.steps.iter().find(|s| s.symbol == symbol).expect("a line").value;
    // Peaks lie between samples of the sub-stepped response: cos(2π/128) of the peak at worst.
    assert!((value("S_a") - 2.0).abs() < 2.5e-3);
    assert_eq!(value("a_B"), 1.0);
    assert!((value("P_k") - out.values[&Quantity::ConvectiveMass] * value("S_a")).abs() < 1e-6 * value("P_k"));
}

#[test]
fn profiles_meet_the_quantities() {
    for case in [cylinder(1.525), cylinder(4.0), strip()] {
        let out = assess(&case);
        let find = |id: &str| out.profiles.iter().find(|p| p.id == id);
        for profile in &out.profiles {
            assert_eq!(profile.z.len(), profile.values.len());
            assert!(profile.z.windows(2).all(|w| w[0] < w[1]));
            // From the bottom to the surface; the wall continues above it.
            let top = profile.z[profile.z.len() - 1];
            assert!(profile.z[0] == 0.0 && (top / case.liquid.fill_height - 1.0).abs() < 1e-12);
            assert!(profile.values.iter().all(|v| *v >= 0.0 && v.is_finite()));
        }
        let near =
            |value: f64, reference: f64| assert!((value - reference).abs() < 1e-9 * reference, "{value} {reference}");
        match case.tank.shape {
            Shape::Cylinder { .. } => {
                near(find("axial_membrane_stress").unwrap().values[0], out.values[&Quantity::AxialMembraneStress]);
                let highest = find("hoop_stress").unwrap().values.iter().fold(0.0, |m: f64, v| m.max(*v));
                near(highest, out.values[&Quantity::HoopStress]);
                // M = W sigma.
                let modulus = stress::section_modulus_circle(3.66, 4e-3);
                near(out.values[&Quantity::AxialMembraneStress] * modulus, out.values[&Quantity::BaseMoment]);
            }
            Shape::Rectangle { .. } => {
                near(find("bending_stress").unwrap().values[0], out.values[&Quantity::BendingStress]);
                assert!(!out.values.contains_key(&Quantity::HoopStress));
            }
        }
    }
}

/// Each line names its source: the table of the plan, and whose constants.
#[test]
fn clauses_name_plan_and_constants() {
    for (mut case, plan) in [(cylinder(1.525), "Brüggemann 2002 D.1"), (strip(), "Brüggemann 2002 8.4.2")] {
        for (choice, constants) in
            [(ConvectiveCoefficient::Exact, "potential flow"), (ConvectiveCoefficient::Housner1957, "TID-7024")]
        {
            case.procedures.housner_convective = choice;
            let out = assess(&case);
            for (symbol, part) in [("x", plan), ("T", plan), ("k", constants), ("c_m", constants)] {
                let step = out.steps.iter().find(|s| s.symbol == symbol).unwrap();
                assert!(step.clause.contains(part), "{symbol}: {}", step.clause);
            }
        }
    }
}

/// Walls of 4 and 3 mm weigh 3.6 % of the liquid, a tenth of that 0.36 %; a roof of 200 kg is another 1.2 %.
#[test]
fn wall_and_roof_are_mentioned_from_one_per_cent_on() {
    let mentioned = |case: &Case| assess(case).notes.iter().any(|n| n.starts_with("Wall and roof"));
    let mut case = cylinder(1.525);
    assert!(mentioned(&case));
    for course in &mut case.tank.courses {
        course.thickness *= 0.1;
    }
    assert!(!mentioned(&case));
    case.tank.roof.mass = 200.0;
    assert!(mentioned(&case));
}

#[test]
fn what_is_missing_or_outside_is_said() {
    let mut case = cylinder(1.525);
    let error = Housner.applies(&case, Excitation::Record).expect_err("no record");
    assert!(error.reason.contains("no record"));
    assert!(Housner.assess(&case, Excitation::Record).is_err());
    // Ten times the acceleration: no wave by Housner's formula, the linear one stands in and is announced.
    if let Some(site) = &mut case.site.ec8 {
        site.ag *= 10.0;
    }
    let out = assess(&case);
    assert!(out.notes.iter().any(|n| n.contains("outside Housner's theory")));
    assert!(out.values[&Quantity::SloshingHeight].is_finite());
    case.site = Site::default();
    assert!(Housner.applies(&case, Excitation::Site).is_err());
    // Published constants announce their error, unanchored tanks their limit.
    let mut case = cylinder(1.525);
    case.procedures.housner_convective = ConvectiveCoefficient::Housner1957;
    case.tank.support = Support::Unanchored;
    let out = assess(&case);
    assert!(out.notes.iter().any(|n| n.contains("0.318")));
    assert!(out.notes.iter().any(|n| n.contains("uplift")));
}

/// The user's parameters of ground A give what `site.ec8` gives, with its importance factor; alone the factor is 1.
#[test]
fn own_spectrum_stands_in_for_that_of_the_code() {
    use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumParameters};
    let mut case = cylinder(1.525);
    case.site.ec8 = Some(Ec8Site { importance: 1.2, ..ec8_site() });
    let expected = assess(&case);
    let own =
        SpectrumParameters { ag: ec8_site().ag, soil: 1.0, corners: [0.15, 0.4, 2.0], long_corners: Some([4.5, 10.0]) };
    case.site.spectrum = Some(SiteSpectrum { form: SpectrumForm::Parameters(own), vertical_ratio: 0.9 });
    assert_eq!(assess(&case).values, expected.values);
    case.site.ec8 = None;
    let alone = assess(&case).values[&Quantity::BaseShear];
    let ground = |out: &Assessment| out.steps.iter().find(|s| s.symbol == "a_B").expect("a line").value;
    assert!((1.2 * ground(&assess(&case)) / ground(&expected) - 1.0).abs() < 1e-12);
    assert!(alone < expected.values[&Quantity::BaseShear]);
}
