//! Properties of Housner's model: continuity, bounds, scaling, and how far it lies from potential flow.

use super::*;
use crate::mechanical;
use proptest::prelude::*;

fn coefficients() -> impl Strategy<Value = Coefficients> {
    prop_oneof![
        Just(CIRCLE_1957),
        Just(RECTANGLE_1957),
        Just(Coefficients::exact(Plan::Circle)),
        Just(Coefficients::exact(Plan::Rectangle)),
    ]
}

fn input() -> impl Strategy<Value = Input> {
    (coefficients(), 0.1..50.0, 0.05..6.0, 10.0..2000.0, 0.0..10.0, 0.0..10.0).prop_map(
        |(coefficients, a, ratio, density, ground, s_a)| Input {
            half_length: a,
            depth: a * ratio,
            mass: density * a * a * a * ratio,
            ground_acceleration: ground,
            spectral: Spectral::Acceleration(s_a),
            gravity: G,
            coefficients,
        },
    )
}

proptest! {
    /// The two branches meet at H/a = 1.5: a jump shows as a change far above the step's size.
    #[test]
    fn continuous_at_the_limit_of_slenderness(c in coefficients(), a in 0.1..50.0f64) {
        let at = |ratio: f64| respond(&Input {
            half_length: a, depth: a * ratio, mass: 1000.0 * a.powi(3) * ratio, ground_acceleration: 3.0,
            spectral: Spectral::Acceleration(0.5), gravity: G, coefficients: c,
        }).unwrap();
        let (low, high) = (at(1.5 - 1e-9), at(1.5 + 1e-9));
        prop_assert!(!low.slender && high.slender);
        for (l, h) in [
            (low.omega, high.omega),
            (low.convective_mass, high.convective_mass),
            (low.wave.height(), high.wave.height()),
            (low.base_shear(Abs), high.base_shear(Abs)),
            (low.moment(Arms::Wall, Abs), high.moment(Arms::Wall, Abs)),
            (low.moment(Arms::WallAndBase, Abs), high.moment(Arms::WallAndBase, Abs)),
        ] {
            prop_assert!((l / h - 1.0).abs() < 1e-8, "{l} {h}");
        }
    }

    /// Everything is finite and positive, masses stay within the liquid (Housner's impulsive mass and the exact
    /// convective one add to at most 1.03 m, at H/L = 1.5 of a rectangle), SRSS never exceeds the sum.
    #[test]
    fn positive_and_bounded(input in input()) {
        let r = respond(&input).unwrap();
        for v in [r.omega, r.period, r.impulsive_mass, r.convective_mass, r.impulsive_lever, r.impulsive_lever_with_base,
                  r.convective_lever, r.convective_lever_with_base, r.r, r.x, r.q] {
            prop_assert!(v > 0.0 && v.is_finite());
        }
        for v in [r.wave.height(), r.base_shear(Abs), r.moment(Arms::Wall, Abs), r.rigid_mass, r.angle] {
            prop_assert!(v >= 0.0 && v.is_finite());
        }
        let total = (r.impulsive_mass + r.rigid_mass + r.convective_mass) / input.mass;
        prop_assert!(total > 0.45 && total < 1.06, "{total}");
        prop_assert!((r.sloshing_mass + r.rigid_mass - input.mass).abs() < 1e-9 * input.mass);
        prop_assert!(r.moment(Arms::Wall, Srss) <= r.moment(Arms::Wall, Abs) * (1.0 + 1e-12));
        prop_assert!(r.convective_lever < r.sloshing_depth && r.convective_lever >= 0.5 * r.sloshing_depth * (1.0 - 1e-9));
    }

    /// Froude scaling: lengths × 100 at the same accelerations: periods × 10, forces × 10⁶, moments × 10⁸, heights × 100.
    #[test]
    fn lengths_times_hundred(input in input()) {
        let big = Input {
            half_length: 100.0 * input.half_length, depth: 100.0 * input.depth, mass: 1e6 * input.mass, ..input
        };
        let (r, b) = (respond(&input).unwrap(), respond(&big).unwrap());
        let close = |value: f64, reference: f64| (value - reference).abs() <= 1e-11 * reference.abs();
        prop_assert!(close(b.period, 10.0 * r.period));
        prop_assert!(close(b.base_shear(Abs), 1e6 * r.base_shear(Abs)));
        prop_assert!(close(b.moment(Arms::Wall, Abs), 1e8 * r.moment(Arms::Wall, Abs)));
        prop_assert!(close(b.moment(Arms::WallAndBase, Srss), 1e8 * r.moment(Arms::WallAndBase, Srss)));
        prop_assert!(close(b.wave.linear, 100.0 * r.wave.linear));
        prop_assert_eq!(b.wave.finite.is_some(), r.wave.finite.is_some());
    }

    /// Housner's impulsive mass stays within 3 % (circle) and 7 % (rectangle) of the liquid mass of potential flow, his
    /// levers of the wall pressure within 4 % of H, for squat tanks (table of exact values at 1.5: 0.686, 0.644, 0.413
    /// against 0.7095 and 0.375).
    #[test]
    fn near_potential_flow(ratio in 0.1..1.5f64) {
        for plan in [Plan::Circle, Plan::Rectangle] {
            let r = respond(&Input {
                half_length: 1.0, depth: ratio, mass: 1.0, ground_acceleration: 1.0,
                spectral: Spectral::Acceleration(1.0), gravity: G, coefficients: Coefficients::exact(plan),
            }).unwrap();
            let i = mechanical::impulsive(plan, ratio);
            let c = mechanical::convective(plan, ratio, 1);
            let bound = if plan == Plan::Circle { 0.03 } else { 0.07 };
            prop_assert!((r.impulsive_mass - i.mass).abs() < bound);
            prop_assert!((r.impulsive_lever / ratio - i.lever).abs() < 0.04);
            prop_assert!((r.convective_mass - c.mass).abs() < 1e-12);
            prop_assert!((r.convective_lever / ratio - c.lever).abs() < 1e-12);
            prop_assert!((r.convective_lever_with_base / ratio - c.lever_with_base).abs() < 1e-9);
        }
    }
}
