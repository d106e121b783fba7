//! Every procedure's ingredients give its values, and what they name as a factor is one.

use tank::Shape;
use tank::assessment::Excitation;
use tank::case::{Case, Combination, ConvectiveCoefficient, Ec8Site, FlexibleImpulsive, GroundMotion, GroundType};
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Ordinate, Part, Recipe, Rule};
use tank::national::{Is1893Site, Soil, Zone};
use tank::quantity::Quantity;

use crate::api650::ground_motion::tests::site as api_site;
use crate::samples::{case, course, near, record, steel};

/// Rounding of some twenty products and sums, with room.
const TOLERANCE: f64 = 1e-9;

fn ec8_site(spectrum: u8, vertical: bool) -> Ec8Site {
    Ec8Site {
        bearing_capacity: None,
        components: Default::default(),
        ground: GroundType::B,
        spectrum,
        ag: 2.0,
        importance: 1.2,
        behaviour_factor: 1.5,
        construction_quality: 25.0,
        vertical,
        friction: None,
        reduction_factor: None,
    }
}

/// Tanks from shallow to slender, with roofs, graded walls, boxes and strips.
fn tanks() -> Vec<Case> {
    let mut all = Vec::new();
    for (radius, depth) in [(20.0, 5.0), (10.0, 8.0), (5.0, 6.0), (3.0, 8.0), (2.0, 7.0)] {
        let courses = [0.012, 0.009, 0.006].map(|t| course(1.1 * depth / 3.0, t, steel()));
        all.push(case(Shape::Cylinder { radius }, courses.to_vec(), depth, None));
    }
    for (length, breadth, depth, strip) in [(5.0, 3.0, 2.5, false), (5.0, 1.0, 2.5, true), (4.0, 4.0, 6.0, false)] {
        let shape = Shape::Rectangle { length, breadth, strip };
        all.push(case(shape, vec![course(depth + 0.5, 0.3, steel())], depth, None));
    }
    all
}

/// The tanks under record and sites, with all options of the procedures.
fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    for (number, mut case) in tanks().into_iter().enumerate() {
        case.ground_motion = Some(GroundMotion { horizontal: record(3.0), transverse: None, vertical: None });
        case.site.ec8 = Some(ec8_site(1 + (number % 2) as u8, number % 3 == 0));
        let mut api = api_site();
        api.sug = 1 + (number % 3) as u8;
        api.tl = [4.0, 8.0][number % 2];
        case.site.api650 = Some(api);
        case.tank.roof.mass = [0.0, 5000.0][number % 2];
        all.push(case.clone());
        case.procedures.housner_convective = ConvectiveCoefficient::Housner1957;
        case.procedures.housner_combination = Combination::Srss;
        case.procedures.ec8_combination = Combination::Srss;
        case.procedures.ec8_impulsive = FlexibleImpulsive::Iterative;
        case.site.ec8 = None;
        all.push(case);
    }
    all.extend(of_concrete());
    all
}

/// Tanks of concrete under the sites of the codes that cover them.
fn of_concrete() -> Vec<Case> {
    let cylinder = crate::two_mass::tests::tank(Shape::Cylinder { radius: 8.0 }, 5.0, (6.0, 0.3), 28e9);
    let broad = crate::two_mass::tests::tank(Shape::Cylinder { radius: 30.0 }, 5.0, (6.0, 0.3), 28e9);
    let mut all = vec![crate::two_mass::tests::basin(), cylinder, broad];
    for (number, case) in all.iter_mut().enumerate() {
        case.ground_motion = Some(GroundMotion { horizontal: record(3.0), transverse: None, vertical: None });
        case.tank.roof.mass = [0.0, 20e3][number % 2];
        case.site.api650 = Some(api_site());
        case.site.is1893 =
            Some(Is1893Site { zone: Zone::V, soil: Soil::Medium, importance: 1.5, response_reduction: None });
    }
    all
}

fn each(mut look: impl FnMut(&str, &Case, Excitation, &Ingredients, &std::collections::BTreeMap<Quantity, f64>)) {
    for case in cases() {
        for excitation in [Excitation::Record, Excitation::Site] {
            for procedure in crate::ALL {
                if let Ok(out) = procedure.assess(&case, excitation) {
                    for ingredients in &out.ingredients {
                        look(procedure.id(), &case, excitation, ingredients, &out.values);
                    }
                }
            }
        }
    }
}

#[test]
fn ingredients_give_the_values() {
    let mut count = 0;
    each(|id, case, excitation, ingredients, values| {
        let q = ingredients.quantity;
        let expected = values[&q];
        let what = format!("{id} {excitation:?} {q:?} H/a {}", case.liquid.fill_height / case.tank.shape.half_length());
        let value = ingredients.value().unwrap();
        near(value, expected, TOLERANCE * expected.abs(), &what);
        count += 1;
    });
    assert!(count > 500, "{count}");
}

/// Wave, shear, moments and membrane stresses of every procedure that gives them have ingredients.
#[test]
fn headline_quantities_have_ingredients() {
    for case in cases() {
        for excitation in [Excitation::Record, Excitation::Site] {
            for procedure in crate::ALL {
                let Ok(out) = procedure.assess(&case, excitation) else { continue };
                for q in [
                    Quantity::SloshingHeight,
                    Quantity::BaseShear,
                    Quantity::BaseMoment,
                    Quantity::OverturningMoment,
                    Quantity::HoopStress,
                    Quantity::AxialMembraneStress,
                    Quantity::SloshingPeriod,
                    Quantity::ImpulsivePeriod,
                    Quantity::ImpulsiveMass,
                    Quantity::ConvectiveMass,
                ] {
                    let given = out.values.contains_key(&q);
                    let made = out.ingredients.iter().filter(|i| i.quantity == q).count();
                    assert_eq!(made, usize::from(given), "{} {excitation:?} {q:?}", procedure.id());
                }
            }
        }
    }
}

fn parts(ingredients: &Ingredients) -> Vec<&Part> {
    match &ingredients.recipe {
        Recipe::Response(r) => r.impulsive.iter().chain(&r.convective).collect(),
        _ => Vec::new(),
    }
}

/// Under a record an ordinate is the spectrum of the record at its own period and damping, without factors.
#[test]
fn ordinates_of_a_record_are_its_spectrum() {
    each(|id, case, excitation, ingredients, _| {
        if excitation == Excitation::Record {
            let record = &case.ground_motion.as_ref().unwrap().horizontal;
            for part in parts(ingredients) {
                let Ordinate { rule, period, damping, base, ref factors } = part.ordinate;
                let spectrum = oscillator::spectrum::ordinates(record, period.unwrap(), damping).psa;
                near(base, spectrum, TOLERANCE * spectrum, id);
                assert!(factors.iter().all(|f| f.1 == 1.0));
                assert!(rule != Rule::Ground || period == Some(0.0));
            }
        }
    });
}

/// With another importance factor and behaviour factor the base of an ordinate stays; their own factors follow them.
#[test]
fn importance_and_behaviour_are_factors_alone() {
    for (case, mut other) in cases().into_iter().zip(cases()) {
        let (Some(site), Some(changed)) = (case.site.ec8, other.site.ec8.as_mut()) else { continue };
        (changed.importance, changed.behaviour_factor) = (1.4, 1.25);
        for id in ["ec8-2006", "ec8-env", "housner"] {
            let procedure = crate::ALL.iter().find(|p| p.id() == id).unwrap();
            let assess = |case| procedure.assess(case, Excitation::Site);
            let (Ok(a), Ok(b)) = (assess(&case), assess(&other)) else { continue };
            for (a, b) in a.ingredients.iter().zip(&b.ingredients) {
                for (a, b) in parts(a).into_iter().zip(parts(b)) {
                    let (a, b) = (&a.ordinate, &b.ordinate);
                    near(b.base, a.base, TOLERANCE * a.base, id);
                    near(a.factor(Factor::Importance), site.importance, 1e-12, id);
                    near(b.factor(Factor::Importance), 1.4, 1e-12, id);
                    let q = a.factor(Factor::BehaviourFactor);
                    assert!(q == 1.0 || (q * site.behaviour_factor - 1.0).abs() < 1e-12, "{id} {q}");
                }
            }
        }
    }
}

/// By hand, API 650 with S_DS = 0.6 g·F_a … : the impulsive ordinate is S_DS times I times 1/R_wi, and its bounds are 1 where
/// neither floor nor the form with S_0 governs.
#[test]
fn api_ordinate_by_hand() {
    let mut c = cases().remove(2);
    let mut api = api_site();
    api.sug = 2;
    c.site.api650 = Some(api);
    let out = crate::ALL[4].assess(&c, Excitation::Site).unwrap();
    let shear = out.ingredients.iter().find(|i| i.quantity == Quantity::BaseShear).unwrap();
    let part = parts(shear)[0];
    near(part.ordinate.factor(Factor::Importance), 1.25, 1e-12, "I");
    near(part.ordinate.factor(Factor::BehaviourFactor), 0.25, 1e-12, "1/R_wi, anchored");
    near(part.ordinate.factor(Factor::Bounds), 1.0, 1e-9, "bounds");
}
