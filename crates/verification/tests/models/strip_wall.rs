//! Source:    Euler-Bernoulli cantilever (β₁ L = 1.875104, Blevins 1979 table 8-1); plane strain E/(1 − ν²)
//! Goal:      plane strips: wall frequencies without liquid, masses, and reactions of a rectangle with side walls
//! Model:     example 8.4: 5.0 m × 2.57 m, concrete wall 0.3 m, per metre of breadth
//! Tolerance: 0.01 % for two modes with 30 cubic elements; masses 1e-9

use engines::harmonic::build;
use engines::modes::{Kind, solve};
use engines::{FeError, Options};
use fem::linalg::dot;

use crate::tanks::{assert_close, case, material};
use tank::Case;
use tank::Shape;

fn strip(density: f64) -> Case {
    let shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    case(shape, &[(3.0, 0.3)], &material(30e9, 0.2, 2500.0), (density, 2.57))
}

#[test]
fn dry_cantilever() {
    let coupled = build(&strip(1e-6), &Options::default(), 1).unwrap();
    let modes = solve(&coupled, Some(20)).unwrap();
    let rigidity = 30e9 * 0.3_f64.powi(3) / (12.0 * 0.96);
    for (n, root) in [1.87510407, 4.69409113].into_iter().enumerate() {
        let exact = (root / 3.0_f64).powi(2) * (rigidity / (2500.0 * 0.3)).sqrt();
        let mode = modes.iter().find(|m| m.kind == Kind::Structural && m.number == n + 1).unwrap();
        assert_close("omega", mode.omega, exact, 1e-4);
    }
}

#[test]
fn masses_and_side_walls() {
    let coupled = build(&strip(1000.0), &Options::default(), 1).unwrap();
    let shear = coupled.probes.iter().find(|p| p.channel.id() == "base_shear").unwrap();
    let free = dot(&coupled.influence, &coupled.mass.times(&coupled.influence));
    let expected = 1000.0 * 5.0 * 2.57 + 2.0 * 3.0 * 0.3 * 2500.0;
    assert_close("mass", free + shear.ground_acceleration, expected, 1e-9);

    // A box of the same breadth carries two side walls more, which follow the ground.
    let mut tank = strip(1000.0);
    tank.tank.shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: false };
    let closed = build(&tank, &Options::default(), 1).unwrap();
    let shear_closed = closed.probes.iter().find(|p| p.channel.id() == "base_shear").unwrap();
    let side = 2.0 * 5.0 * 3.0 * 0.3 * 2500.0;
    assert_close("side", shear_closed.ground_acceleration - shear.ground_acceleration, side, 1e-9);
    let moment = |c: &engines::coupled::Coupled| {
        c.probes.iter().find(|p| p.channel.id() == "base_moment").unwrap().ground_acceleration
    };
    assert_close("side moment", moment(&closed) - moment(&coupled), 1.5 * side, 1e-9);
}

#[test]
fn a_rectangle_has_two_harmonics() {
    let error = build(&strip(1000.0), &Options::default(), 2).unwrap_err();
    assert!(matches!(error, FeError::Unsupported(_)), "{error}");
}
