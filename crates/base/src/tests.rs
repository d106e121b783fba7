//! Strips and bases against closed forms.

use crate::*;

const PRESSURE: f64 = 128e3;

fn plate(thickness: f64) -> Plate {
    Plate { thickness, young_modulus: 2.05e11, poisson_ratio: 0.3, yield_stress: None }
}

/// On nearly rigid ground: the sinking length (4 D/k)^(1/4) is 17 mm, 1/40 of the lifted length.
fn rigid(rim: Rim, plate: Plate) -> Strip {
    let strip = Strip::new(Bands::uniform(plate), rim, 3.0, 1e12, PRESSURE, Plan::Strip).unwrap();
    strip.refined(2.0)
}

fn lifted(strip: &Strip, uplift: f64) -> Point {
    let mut state = Lifted::at_rest(strip, 0.0).unwrap();
    state.lift_to(uplift).unwrap();
    state.point()
}

/// The ground gives way over the sinking length, whose ratio to l is 0.024; what it lets the touch-down move is of a higher order.
/// Within 1e-3.
#[test]
fn a_hinged_strip_lifts_as_its_closed_form() {
    let expected = closed::hinged(&plate(0.01), PRESSURE, 0.7);
    let found = lifted(&rigid(Rim::Hinged, plate(0.01)), expected.uplift);
    assert!((found.hold_down / expected.hold_down - 1.0).abs() < 3e-3, "{found:?} {expected:?}");
    assert!(found.rim_moment.abs() < 1e-6 * PRESSURE);
    assert!(found.axial_force.abs() < 1e-6 * PRESSURE);
}

#[test]
fn a_clamped_strip_lifts_as_its_closed_form() {
    let expected = closed::clamped(&plate(0.01), PRESSURE, 0.7);
    let found = lifted(&rigid(Rim::Clamped, plate(0.01)), expected.uplift);
    assert!((found.hold_down / expected.hold_down - 1.0).abs() < 3e-3, "{found:?} {expected:?}");
    assert!((found.rim_moment / expected.rim_moment - 1.0).abs() < 1e-2, "{found:?} {expected:?}");
}

/// Where membrane and rotation are negligible a round plate on a rim that is free has the four constants of its closed form.
#[test]
fn a_round_plate_lifts_as_its_closed_form() {
    let (w, f) = closed::round(&plate(0.01), PRESSURE, 3.0, 2.3);
    let strip = Strip::new(Bands::uniform(plate(0.01)), Rim::Hinged, 3.0, 1e12, PRESSURE, Plan::Round).unwrap();
    let point = lifted(&strip.refined(2.0), 1e-2 * w);
    // The rim of a round plate cannot move inwards without hoop forces, so only a small uplift is free of membrane forces; there the
    // lifted width follows from w ~ l⁴ and is found again by the closed form.
    let contact = (0..60).fold((1.0, 2.999), |(low, high), _| {
        let middle = 0.5 * (low + high);
        if closed::round(&plate(0.01), PRESSURE, 3.0, middle).0 > 1e-2 * w { (middle, high) } else { (low, middle) }
    });
    let (_, expected) = closed::round(&plate(0.01), PRESSURE, 3.0, contact.0);
    assert!(expected < f);
    assert!((point.hold_down / expected - 1.0).abs() < 2e-2, "{point:?} {expected}");
}

/// A yielding rim and span: F = 2 √(p M_p) where no membrane force helps; hardening adds up to a tenth.
#[test]
fn two_hinges_hold_what_the_code_says() {
    let steel = Plate { yield_stress: Some(205e6), ..plate(0.01) };
    let strip = rigid(Rim::Clamped, steel);
    let expected = closed::two_hinges(&steel, PRESSURE).unwrap();
    let found = lifted(&strip, 0.05).hold_down / expected;
    assert!((1.0..1.1).contains(&found), "{found}");
}

fn rocking(modulus: f64, weight: f64, radius: f64) -> Rocking {
    let edge = Edge {
        radius,
        thickness: 0.025,
        young_modulus: 2.05e11,
        poisson_ratio: 0.3,
        pressure: PRESSURE,
        gradient: 870.0 * 9.81,
    };
    let strip =
        Strip::new(Bands::uniform(plate(0.01)), Rim::Wall(edge), radius, modulus, PRESSURE, Plan::Strip).unwrap();
    let curve = Curve::of(&strip, weight, -0.05, 0.1).unwrap();
    Rocking::new(radius, weight, vec![(PRESSURE, curve)]).unwrap()
}

/// While the rim stays on the ground the strip is a spring near its rest: M = π R³ F′(w) ψ. Under a heavy wall F is linear within
/// the range of a small rotation, so the tolerance is that of the secant, 1 %.
#[test]
fn a_small_rotation_meets_the_spring_of_the_rim() {
    let (radius, weight) = (20.0, 200e3);
    let base = rocking(1e8, weight, radius);
    let psi = 1e-6;
    let rest = base.at(0.0, 0.0).unwrap();
    let step = psi * radius;
    let spring =
        (base.curve().hold_down(rest.centre + step) - base.curve().hold_down(rest.centre - step)) / (2.0 * step);
    let expected = std::f64::consts::PI * radius.powi(3) * spring * psi;
    let found = base.at(psi, 0.0).unwrap().moment;
    assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
    assert!((rest.toe_force / weight - 1.0).abs() < 1e-9);
    assert!(rest.moment.abs() < 1e-6 * radius * radius * weight);
}

/// A rigid ring on the ground turns about its toe in the limit: M < W R. With the plate's hold-down it carries more.
#[test]
fn the_plate_adds_to_the_weight() {
    let base = rocking(1e10, 21e3, 20.0);
    let weight_alone = std::f64::consts::TAU * 20.0_f64.powi(2) * 21e3;
    assert!(base.at(1e-3, 0.0).unwrap().moment > weight_alone);
}

/// Suction on the lifted side and pressure on the other take from the moment that the base holds.
#[test]
fn suction_on_the_lifted_side_lowers_the_moment() {
    let radius = 20.0;
    let edge = Edge {
        radius,
        thickness: 0.025,
        young_modulus: 2.05e11,
        poisson_ratio: 0.3,
        pressure: PRESSURE,
        gradient: 870.0 * 9.81,
    };
    let strip = Strip::new(Bands::uniform(plate(0.01)), Rim::Wall(edge), radius, 1e8, PRESSURE, Plan::Strip).unwrap();
    let curves = [1.0, 0.75, 0.5].map(|share| {
        let strip = strip.under(share * PRESSURE).unwrap();
        (share * PRESSURE, Curve::of(&strip, 21e3, -0.05, 0.1).unwrap())
    });
    let base = Rocking::new(radius, 21e3, curves.to_vec()).unwrap();
    let still = base.at(1e-3, 0.0).unwrap();
    let sucked = base.at(1e-3, 0.4 * PRESSURE).unwrap();
    assert!(sucked.moment < still.moment, "{still:?} {sucked:?}");
}

/// The moment of a rotation leads back to it: bisection to 1e-10 of the moment, which grows with ψ^(1/4) at least.
#[test]
fn a_moment_leads_back_to_its_rotation() {
    let base = rocking(1e8, 21e3, 20.0);
    for psi in [1e-6, 1e-4, 1e-3, 1.3e-3] {
        let turn = base.at(psi, 0.0).unwrap();
        let found = base.under(turn.moment, 0.0).unwrap();
        assert!((found.rotation / psi - 1.0).abs() < 1e-7, "{found:?} {psi}");
    }
    let most = base.at(1.3e-3, 0.0).unwrap().moment;
    assert_eq!(base.under(2.0 * most, 0.0), None);
    assert!(base.under(0.0, 0.0).unwrap().rotation < 1e-12);
}

#[test]
fn a_rotation_beyond_the_curve_is_told() {
    let base = rocking(1e8, 21e3, 20.0);
    assert!(matches!(base.at(0.02, 0.0), Err(BaseError::BeyondCurve { .. })));
}

#[test]
fn parameters_without_meaning_are_refused() {
    let bands = || Bands::uniform(plate(0.01));
    for (modulus, pressure) in [(0.0, 1.0), (f64::NAN, 1.0), (1e8, -1.0)] {
        assert!(Strip::new(bands(), Rim::Hinged, 1.0, modulus, pressure, Plan::Strip).is_err());
    }
    let steel = Plate { yield_stress: Some(235e6), ..plate(0.01) };
    assert!(Strip::new(Bands::uniform(steel), Rim::Hinged, 1.0, 1e8, 1e5, Plan::Round).is_err());
    for wrong in [
        plate(0.0),
        Plate { young_modulus: f64::NAN, ..steel },
        Plate { poisson_ratio: 0.5, ..steel },
        Plate { yield_stress: Some(0.0), ..steel },
    ] {
        for bands in [Bands::uniform(wrong), Bands::annular(steel, 0.5, wrong)] {
            assert!(Strip::new(bands, Rim::Hinged, 1.0, 1e8, 1e5, Plan::Strip).is_err());
        }
    }
}

/// An element belongs to the plate on which both of its nodes lie.
#[test]
fn elements_have_the_plate_of_their_place() {
    let bands = Bands::annular(plate(0.01), 0.7123, plate(0.006));
    let strip = Strip::new(bands, Rim::Hinged, 3.0, 1e8, 1e5, Plan::Strip).unwrap();
    for (i, ends) in strip.nodes.windows(2).enumerate() {
        let wanted = if 3.0 - ends[0] < 0.7123 + 1e-9 { 0.01 } else { 0.006 };
        assert_eq!(strip.plate(i).thickness, wanted, "{ends:?}");
    }
}

fn point(uplift: f64, hold_down: f64) -> Point {
    Point {
        uplift,
        hold_down,
        rotation: 10.0 * uplift,
        rim_moment: 3.0 - uplift,
        axial_force: 2.0 * uplift,
        lifted_width: 4.0 * uplift,
        plastic_rotation: 1.0 + uplift,
    }
}

/// What is linear in the uplift is that between the points, too.
#[test]
fn a_curve_is_linear_between_its_points() {
    let curve = Curve::through(vec![point(-0.1, -5.0), point(0.1, 5.0), point(0.5, 25.0)]);
    for uplift in [-0.1, 0.04, 0.2, 0.5] {
        let (found, wanted) = (curve.at(uplift), point(uplift, 50.0 * uplift));
        for (a, b) in [
            (found.hold_down, wanted.hold_down),
            (found.rotation, wanted.rotation),
            (found.rim_moment, wanted.rim_moment),
            (found.axial_force, wanted.axial_force),
            (found.lifted_width, wanted.lifted_width),
            (found.plastic_rotation, wanted.plastic_rotation),
        ] {
            assert!((a - b).abs() < 1e-12, "{uplift}: {found:?}");
        }
    }
}

/// A rim that holds F = c p w under every pressure p: with p − s cos φ, w₀ + ψ R cos φ the sums are 2π R c (p w₀ − s ψ R/2) and
/// π R² c (p ψ R − s w₀).
#[test]
fn a_rim_in_proportion_to_the_pressure_has_closed_sums() {
    let (radius, p, c) = (4.0, 1e5, 30.0);
    let curve = |pressure: f64| {
        let at = |w: f64| point(w, c * pressure * w);
        (pressure, Curve::through([-1.0, -0.3, 0.0, 0.4, 1.0].map(at).to_vec()))
    };
    let base = Rocking::new(radius, 1e3, [p, 1.5 * p, 0.5 * p].map(curve).to_vec()).unwrap();
    for (psi, centre, s) in [(0.0, 0.2, 4e4), (0.05, 0.1, 0.0), (0.05, -0.3, 2e4), (0.08, 0.5, -3e4)] {
        let (force, moment) = base.sums(8, (psi, centre), s, &mut [0.0; crate::WAVES]).unwrap();
        let wanted = std::f64::consts::TAU * radius * c * (p * centre - 0.5 * s * psi * radius);
        assert!((force - wanted).abs() < 1e-6 * p, "{force} {wanted}");
        let wanted = std::f64::consts::PI * radius * radius * c * (p * psi * radius - s * centre);
        assert!((moment - wanted).abs() < 1e-6 * p, "{moment} {wanted}");
        for side in [1.0, -1.0] {
            let found = base.moved((side * psi, centre), [0.0; crate::WAVES], side * 7.0, side * s);
            let (up, toe) = (centre + psi * radius, centre - psi * radius);
            // A base that does not turn has no other side.
            let s = if psi == 0.0 { side * s } else { s };
            assert!((found.uplift - up).abs() < 1e-12);
            assert!((found.pull - c * (p - s) * up).abs() < 1e-6 * p, "{found:?}");
            assert!((found.toe_force + c * (p + s) * toe).abs() < 1e-6 * p, "{found:?}");
            assert!(psi == 0.0 || found.moment == 7.0);
        }
    }
}

/// Vesic's modulus satisfies its own equation, and stiffer soil is stiffer.
#[test]
fn the_ground_under_the_rim_is_found_with_its_width() {
    let soil = |e| Soil { young_modulus: e, poisson_ratio: 0.3 };
    let k = subgrade_modulus(soil(40e6), &plate(0.01)).unwrap();
    let d = plate(0.01).bending_stiffness();
    let b = 2.0 * (4.0 * d / k).powf(0.25);
    let again = 0.65 * 40e6 / (b * 0.91) * (40e6 * b.powi(3) / d).powf(1.0 / 12.0);
    assert!((again / k - 1.0).abs() < 1e-9);
    assert!(subgrade_modulus(soil(320e6), &plate(0.01)).unwrap() > 8.0 * k);
}

/// A plate that projects rests on the ground outside the wall, too: the rim sinks less, and the uplift far from rest hardly feels it.
#[test]
fn a_projecting_plate_carries_outside_the_wall() {
    let edge = Edge {
        radius: 20.0,
        thickness: 0.025,
        young_modulus: 2.05e11,
        poisson_ratio: 0.3,
        pressure: PRESSURE,
        gradient: 870.0 * 9.81,
    };
    let flush = Strip::new(Bands::uniform(plate(0.01)), Rim::Wall(edge), 20.0, 1e8, PRESSURE, Plan::Strip).unwrap();
    let projecting = flush.clone().projecting(0.05);
    let rest = |s: &Strip| Lifted::at_rest(s, 21e3).unwrap().uplift();
    assert!(rest(&projecting) > rest(&flush));
    assert!((lifted(&projecting, 0.1).hold_down / lifted(&flush, 0.1).hold_down - 1.0).abs() < 1e-3);
}
