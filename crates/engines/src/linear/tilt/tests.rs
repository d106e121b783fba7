//! A tilted tank against statics.

use std::f64::consts::PI;

use tank::options::LinearOptions;
use tank::{Case, Shape};

use super::*;
use crate::harmonic::{Places, build_observed, test_tanks};

const ANGLE: f64 = 0.12;

fn harmonic(case: &Case) -> Part {
    tilt(case, ANGLE, |tilted| build_observed(tilted, &LinearOptions::default(), 1, Places::Usual)).unwrap()
}

/// Values and heights of both sides, the low one first.
fn sides(tilt: &Part, what: OnWall) -> [&[[f64; 2]]; 2] {
    ["low", "high"].map(|side| tilt.line(what.id(), side).unwrap())
}

fn value(tilt: &Part, id: &str) -> f64 {
    tilt.value(id).unwrap().value.value
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} {expected}");
}

/// Weight across the axis: V = M g sin α at the heights of the centres of liquid, wall and roof, and the shift of the liquid's centre on
/// the bottom, R² tan α/(4 H): exact, and so is the level surface. Rounding of a condensed system with 10⁵ between its stiffnesses: 1e-8.
#[test]
fn resultants_are_those_of_statics() {
    let mut case = test_tanks::broad();
    case.tank.roof.mass = 120.0;
    let found = harmonic(&case);
    let (g, depth, radius) = (case.gravity * ANGLE.sin(), case.liquid.fill_height, case.tank.shape.half_length());
    let (liquid, wall) = (case.liquid_mass(), case.tank.wall_mass());
    let roof = case.tank.roof.mass;
    let arm = liquid * 0.5 * depth + wall * case.tank.wall_centroid() + roof * case.tank.roof_height();
    close(value(&found, "base_shear"), g * (liquid + wall + roof), 1e-8);
    close(value(&found, "base_moment"), g * arm, 1e-8);
    close(value(&found, "overturning_moment"), g * (arm + liquid * radius * radius / (4.0 * depth)), 1e-6);
    let [low, high] = sides(&found, OnWall::Pressure);
    for ([low, z], [high, _]) in low.iter().zip(high) {
        let level = case.liquid.density * case.gravity * ANGLE.cos() * (depth - z);
        let across = case.liquid.density * g * radius;
        assert!((low - level - across).abs() < 1e-6 * across && (high - level + across).abs() < 1e-6 * across);
    }
    // The elements of surface and liquid hold a straight line: 1e-8; the level surface moves with the wall, which bulges 1e-5 of it.
    let surface = found.table("surface").unwrap();
    for (r, eta) in surface.column("r").iter().zip(&surface.column("rise")) {
        assert!((eta - r * ANGLE.tan()).abs() < 1e-4 * radius, "{r} {eta}");
    }
}

/// A strip: ρ H L b g sin α.
#[test]
fn a_strip_has_its_weight() {
    let shape = Shape::Rectangle { length: 8.0, breadth: 1.0, strip: true };
    let case = test_tanks::case(shape, &[(4.0, 0.3)], (30e9, 0.2, 2500.0), (1000.0, 3.0));
    let found = harmonic(&case);
    let mass = case.liquid_mass() + case.tank.wall_mass();
    close(value(&found, "base_shear"), mass * case.gravity * ANGLE.sin(), 1e-8);
}

/// Axial membrane stress at the base of a tilted cylinder: the moment of the weight across the axis above the base plate over π R² t,
/// with that of the membrane: the clamped edge does not change its amplitude, which is equilibrium of cos θ. 1e-3 for the thickness: R is
/// that of the middle surface or the inner one.
#[test]
fn the_base_carries_the_moment() {
    let case = test_tanks::broad();
    let found = harmonic(&case);
    let [low, high] = sides(&found, OnWall::Axial);
    let amplitude = 0.5 * (low[0][0] - high[0][0]);
    let (radius, t) = (case.tank.shape.half_length(), case.tank.courses[0].thickness);
    close(-amplitude, value(&found, "base_moment") / (PI * radius * radius * t), 5e-3);
}
