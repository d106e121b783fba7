use std::collections::BTreeMap;

use super::*;
use crate::modal::{ModalStress, REST};
use tank::ingredients::Vertical;

/// S_a = 2 m/s² over T, halved by ξ above 1 %, 3 m/s² of ground.
fn spectrum(period: f64, damping: f64) -> f64 {
    match period {
        0.0 => 3.0,
        t if damping > 0.01 => 1.0 / t,
        t => 2.0 / t,
    }
}

fn inertia(mass: f64, height: f64) -> Inertia {
    Inertia { shear: mass, moment: mass * height, overturning: 2.0 * mass * height }
}

/// 100 kg at 2 m with 0.5 s and 2 %, of which the wall is 20 kg at 2 m; 50 kg at 3 m with 4 s and 0.5 %.
fn modal(split: bool) -> Vec<ModalPart> {
    let part = |kind: &str, period, damping, wave, total, structure| ModalPart {
        kind: kind.into(),
        number: 1,
        period,
        damping,
        wave,
        total,
        structure,
        stress: None,
    };
    let structure = split.then(|| [inertia(20.0, 2.0), Inertia::default()]);
    vec![
        part("sloshing", 4.0, 0.005, 0.2, inertia(50.0, 3.0), None),
        part("structural", 0.5, 0.02, 0.0, inertia(100.0, 2.0), structure),
        part(REST, 0.0, 0.0, 0.0, inertia(10.0, 1.0), None),
    ]
}

fn engine(modal: &[ModalPart]) -> Engine<'_> {
    Engine { modal, liquid_mass: 140.0, spectrum: &spectrum, held: None, hoop_height: None }
}

fn attribute(split: bool, quantity: Quantity, target: Response, value: f64) -> Attribution {
    let modal = modal(split);
    let ingredients = Ingredients::response(quantity, target);
    let made = Made { method: "x", excitation: Excitation::Record, ingredients: &ingredients };
    engine(&modal).attribute(&made, value).unwrap()
}

fn list(attribution: &Attribution) -> Vec<(Factor, f64)> {
    attribution.steps.iter().map(|s| (s.factor_id, s.factor)).collect()
}

/// By hand: a procedure with the engine's ingredients but for a rigid wall and absolute sums.
///
/// ```text
/// history 250 N        SRSS of 100·2 = 200, 50·0.5 = 25, 10·3 = 30: 203.777       factor 0.81511
/// two modes            √(200² + 25²) = 201.556                                    0.98910
/// rigid wall           √(300² + 25²) = 301.040                                    1.49358
/// sum                  325                                                        1.07959
/// ```
#[test]
fn two_exchanges_by_hand() {
    let target = Response {
        impulsive: Some(Part {
            wall: Share::new(20.0, 1.0),
            ..Part::liquid(Ordinate::ground(3.0), Share::new(80.0, 1.0))
        }),
        convective: Some(Part::liquid(Ordinate::at(4.0, 0.005, 0.5), Share::new(50.0, 1.0))),
        combination: Combination::Abs,
        vertical: None,
    };
    let found = attribute(true, Quantity::BaseShear, target, 250.0);
    let expected = [
        (Factor::TimeHistory, 41_525.0_f64.sqrt() / 250.0),
        (Factor::Modes, (40_625.0_f64 / 41_525.0).sqrt()),
        (Factor::RigidWall, (90_625.0_f64 / 40_625.0).sqrt()),
        (Factor::Combination, 325.0 / 90_625.0_f64.sqrt()),
    ];
    let steps = list(&found);
    assert_eq!(steps.len(), expected.len(), "{steps:?}");
    for ((factor, value), (which, by_hand)) in steps.iter().zip(expected) {
        assert_eq!(*factor, which);
        assert!((value - by_hand).abs() < 1e-12, "{which:?}: {value} {by_hand}");
    }
    assert!((found.ratio - 1.3).abs() < 1e-12);
    assert!(found.gap() < 1e-12);
}

fn everything_differs() -> Response {
    let factors = [(Factor::LongPeriod, 0.8), (Factor::Importance, 1.2), (Factor::BehaviourFactor, 1.0 / 1.5)];
    Response {
        impulsive: Some(Part {
            wall: Share::new(30.0, 2.5),
            roof: Share::new(5.0, 6.0),
            floor: Share::new(7.0, 0.5),
            ..Part::liquid(Ordinate::at(0.3, 0.05, 4.0).split(&factors[1..]), Share::new(90.0, 1.5))
        }),
        convective: Some(Part::liquid(Ordinate::at(4.4, 0.02, 0.4).split(&factors[..2]), Share::new(60.0, 3.5))),
        combination: Combination::Abs,
        vertical: None,
    }
}

/// The chain ends at the procedure's value whatever differs, and its order is that of the list.
#[test]
fn closes_and_keeps_its_order() {
    for split in [true, false] {
        for quantity in [Quantity::BaseMoment, Quantity::OverturningMoment] {
            let found = attribute(split, quantity, everything_differs(), 777.0);
            assert!(found.gap() < 1e-12);
            let value = found.steps.last().unwrap().value;
            assert!((value / everything_differs().value() - 1.0).abs() < 1e-12);
            let order: Vec<Factor> = list(&found).iter().map(|s| s.0).collect();
            assert!(order.windows(2).all(|pair| pair[0] < pair[1]), "{order:?}");
            assert_eq!(order.contains(&Factor::WallMass), split);
            assert_eq!(order.contains(&Factor::ImpulsiveMass), !split);
        }
    }
}

/// A wave: its formula comes after the accelerations, where Housner's denominator is that of the procedure.
#[test]
fn a_wave_by_hand() {
    let target = Response {
        impulsive: None,
        convective: Some(Part {
            finite_angle: 1.0,
            ..Part::liquid(Ordinate::at(5.0, 0.005, 0.4), Share::new(0.3, 1.0))
        }),
        combination: Combination::Abs,
        vertical: None,
    };
    let found = attribute(true, Quantity::SloshingHeight, target, 0.08);
    // SRSS of one sloshing mode is that mode, 0.2·0.5 = 0.1 m; at 5 s 0.08 m; 0.3·0.4/(1 − 0.4) = 0.2 m.
    let expected = [(Factor::TimeHistory, 1.25), (Factor::SloshingPeriod, 0.8), (Factor::WaveFormula, 2.5)];
    for ((factor, value), (which, by_hand)) in list(&found).into_iter().zip(expected) {
        assert_eq!(factor, which);
        assert!((value - by_hand).abs() < 1e-12, "{which:?}: {value}");
    }
    assert_eq!(found.steps.len(), 3);
}

/// Mass of the liquid: 140 kg less 50 kg of sloshing is what all structural modes move.
#[test]
fn a_ladder_by_hand() {
    let modal = modal(true);
    let rungs = [(Factor::RigidTank, 85.0), (Factor::Formula, 95.0)];
    let ingredients = Ingredients::ladder(Quantity::ImpulsiveMass, &rungs);
    let made = Made { method: "x", excitation: Excitation::Record, ingredients: &ingredients };
    let found = engine(&modal).attribute(&made, 80.0).unwrap();
    let values: Vec<f64> = found.steps.iter().map(|s| s.value).collect();
    assert_eq!(values, [90.0, 85.0, 95.0]);
    assert!((found.ratio - 95.0 / 80.0).abs() < 1e-15);
}

/// Without an acceleration there is no factor.
#[test]
fn no_factor_of_zero() {
    let modal = modal(true);
    let mut target = everything_differs();
    for part in [&mut target.impulsive, &mut target.convective] {
        part.as_mut().unwrap().ordinate.base = 0.0;
    }
    let ingredients = Ingredients::response(Quantity::BaseShear, target);
    let made = Made { method: "x", excitation: Excitation::Site, ingredients: &ingredients };
    assert_eq!(engine(&modal).attribute(&made, 100.0), None);
}

/// The modes with hoop stresses of 4, 10 and 1 per acceleration, and axial stresses of a hundredth of the moments.
fn stressed() -> Vec<ModalPart> {
    let mut modal = modal(true);
    for (part, hoop) in modal.iter_mut().zip([4.0, 10.0, 1.0]) {
        let axial = 0.01 * part.total.moment;
        part.stress = Some(ModalStress { hoop, axial });
    }
    modal
}

fn of_stress(modal: &[ModalPart], ingredients: &Ingredients, value: f64) -> Option<Attribution> {
    let made = Made { method: "x", excitation: Excitation::Record, ingredients };
    engine(modal).attribute(&made, value)
}

/// By hand: a hoop stress of a procedure with 12 and 3 per acceleration, a rigid wall, and 9 of vertical motion.
///
/// ```text
/// history 21        SRSS of 10·2, 4·0.5, 1·3: √413
/// two modes         √(20² + 2²)
/// stresses          √(24² + 2²), √(24² + 1.5²)
/// rigid wall        √(36² + 1.5²)
/// vertical          + 9
/// ```
#[test]
fn a_hoop_stress_by_hand() {
    let at = |period, damping, base, scale| (Ordinate::at(period, damping, base), scale);
    let target = Response {
        vertical: Some(Vertical { horizontal: 1.0, value: 9.0, combination: Combination::Abs }),
        ..Response::hoop((Ordinate::ground(3.0), 12.0), at(4.0, 0.005, 0.5, 3.0), Combination::Srss)
    };
    let ingredients = Ingredients::response(Quantity::HoopStress, target);
    let found = of_stress(&stressed(), &ingredients, 21.0).unwrap();
    let values = [413.0_f64, 404.0, 580.0, 578.25, 1298.25].map(f64::sqrt);
    let expected = [
        (Factor::TimeHistory, values[0] / 21.0),
        (Factor::Modes, values[1] / values[0]),
        (Factor::ImpulsiveStress, values[2] / values[1]),
        (Factor::ConvectiveStress, values[3] / values[2]),
        (Factor::RigidWall, values[4] / values[3]),
        (Factor::Vertical, 1.0 + 9.0 / values[4]),
    ];
    let steps = list(&found);
    assert_eq!(steps.len(), expected.len(), "{steps:?}");
    for ((factor, value), (which, by_hand)) in steps.into_iter().zip(expected) {
        assert_eq!(factor, which);
        assert!((value - by_hand).abs() < 1e-12, "{which:?}: {value} {by_hand}");
    }
    // An engine without the stresses of its modes attributes none.
    assert_eq!(of_stress(&modal(true), &ingredients, 21.0), None);
}

/// By hand: the same procedure has 6 and 1.5 at 2 m, where the modes of the engine have their hoop stresses: half of the stresses there, and twice
/// them from there to its own place.
#[test]
fn stresses_are_exchanged_at_the_same_height() {
    let modal = stressed();
    let target = Response::hoop((Ordinate::ground(3.0), 12.0), (Ordinate::at(4.0, 0.005, 0.5), 3.0), Combination::Srss);
    let target = target.along(&[(0.0, 12.0, 3.0), (2.0, 6.0, 1.5), (4.0, 0.0, 4.0)]);
    let ingredients = Ingredients::response(Quantity::HoopStress, target);
    let made = Made { method: "x", excitation: Excitation::Record, ingredients: &ingredients };
    let found = |hoop_height| {
        let engine = Engine { hoop_height, ..engine(&modal) };
        let steps = list(&engine.attribute(&made, 21.0).unwrap());
        let of = |which: Factor| steps.iter().find(|s| s.0 == which).map_or(1.0, |s| s.1);
        [Factor::ImpulsiveStress, Factor::ConvectiveStress, Factor::Place].map(of)
    };
    let near = |found: [f64; 3], expected: [f64; 3]| {
        for (a, b) in found.into_iter().zip(expected) {
            assert!((a - b).abs() < 1e-12, "{found:?} {expected:?}");
        }
    };
    let there = [(148.0_f64 / 404.0).sqrt(), (144.5625_f64 / 148.0).sqrt(), (578.25_f64 / 144.5625).sqrt()];
    near(found(Some(2.0)), there);
    let own = [(580.0_f64 / 404.0).sqrt(), (578.25_f64 / 580.0).sqrt(), 1.0];
    near(found(None), own);
    // Where it gives no impulsive stress it is taken at its own place: the sloshing part alone is exchanged there.
    // Sloshing there: 4 x 0.5 = 2, as the engine's.
    near(found(Some(4.0)), [own[0], 1.0, (578.25_f64 / 580.0).sqrt()]);
}

/// An engine whose axial stresses are its moments over one section modulus has the factors of the base moment; a procedure with
/// half of that modulus doubles both parts, one after the other.
#[test]
fn an_axial_stress_has_the_factors_of_its_moment() {
    let moment = Ingredients::response(Quantity::BaseMoment, everything_differs());
    let of_moment = list(&of_stress(&stressed(), &moment, 500.0).unwrap());
    let axial = |scale| moment.scaled(Quantity::AxialMembraneStress, scale).unwrap();
    let same = list(&of_stress(&stressed(), &axial(0.01), 5.0).unwrap());
    assert_eq!(same.len(), of_moment.len());
    for (a, b) in same.iter().zip(&of_moment) {
        assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-12, "{a:?} {b:?}");
    }
    let twice = list(&of_stress(&stressed(), &axial(0.02), 5.0).unwrap());
    let stress = |f: &&(Factor, f64)| matches!(f.0, Factor::ImpulsiveStress | Factor::ConvectiveStress);
    let product: f64 = twice.iter().filter(stress).map(|f| f.1).product();
    assert!((product - 2.0).abs() < 1e-12, "{product}");
}

/// A run whose base moves: the first factor leads to that with its base held, the others are those of its attribution.
#[test]
fn a_moving_base_is_the_first_factor() {
    let modal = modal(false);
    let ingredients = Ingredients::response(Quantity::BaseShear, everything_differs());
    let made = Made { method: "x", excitation: Excitation::Record, ingredients: &ingredients };
    let plain = list(&engine(&modal).attribute(&made, 250.0).unwrap());
    for factor in [Factor::Uplift, Factor::Isolators, Factor::Soil] {
        let values = BTreeMap::from([("base_shear".to_owned(), 250.0)]);
        let moves = Engine { held: Some(Held { factor, values }), ..engine(&modal) };
        let moved = list(&moves.attribute(&made, 200.0).unwrap());
        assert_eq!(moved[0].0, factor);
        assert!((moved[0].1 - 1.25).abs() < 1e-12);
        assert_eq!(moved[1..], plain[..]);
    }
}
