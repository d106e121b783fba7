//! Contact with a fixed roof by hand, and modes under a floating one.

use tank::{Case, RoofKind, Shape};

use super::*;
use crate::samples;

fn tank(kind: RoofKind, rise: Option<f64>, mass: f64) -> Case {
    let steel = samples::steel();
    let courses = vec![samples::course(11.0, 0.01, steel)];
    let mut case = samples::case(Shape::Cylinder { radius: 10.0 }, courses, 10.0, None);
    case.liquid.density = 1000.0;
    case.gravity = 9.81;
    case.tank.roof.kind = kind;
    case.tank.roof.rise = rise;
    case.tank.roof.mass = mass;
    case
}

fn close(found: f64, wanted: f64) {
    assert!((found / wanted - 1.0).abs() < 1e-3, "{found} {wanted}");
}

/// By hand: R = H = 10 m, 1 m of freeboard, a crest of 2 m. ω² = 1.8412·0.981·tanh 1.8412 = 1.7172, ω = 1.3104 rad/s;
/// V = 1.3104·2·√0.75 = 2.2697 m/s, ½ρV² = 2576 Pa; b = arctan 0.2 = 11.31°, π²/(4·0.04) = 61.69.
#[test]
fn a_flat_roof_by_hand() {
    let found = contact(&tank(RoofKind::Fixed, None, 1e4), 2.0).unwrap();
    close(found.from, 5.0);
    close(found.pressure, 9810.0);
    close(found.share, 0.5);
    close(found.speed, 2.2697);
    close(found.angle.to_degrees(), 11.31);
    close(found.impact[0], 2576.0);
    close(found.impact[1], 158_900.0);
    assert!(contact(&tank(RoofKind::Fixed, None, 1e4), 0.999).is_none());
    assert!(contact(&tank(RoofKind::Open, None, 0.0), 2.0).is_none());
    assert!(contact(&tank(RoofKind::Fixed, None, 0.0), 2.0).is_none());
}

/// By hand: the wave 2 r/10 meets the cone 1 + 2 (1 − r/10) at r = 7.5; a dome of a rise of 2 m has the radius 26 m and tan a = 10/24. A flat
/// roof just above a small wave has the wedge of 4°: π²/(4 tan² 4°) = 504.6.
#[test]
fn cones_domes_and_flat_angles() {
    let cone = contact(&tank(RoofKind::Cone, Some(2.0), 1e4), 2.0).unwrap();
    close(cone.from, 7.5);
    close(cone.angle.to_degrees(), 22.62);
    let dome = contact(&tank(RoofKind::Dome, Some(2.0), 1e4), 2.0).unwrap();
    close(dome.angle.to_degrees(), (10.0_f64 / 24.0).atan().to_degrees() + 11.31);
    let mut full = tank(RoofKind::Fixed, None, 1e4);
    full.liquid.fill_height = 10.9;
    let flat = contact(&full, 0.2).unwrap();
    close(flat.impact[1] / flat.impact[0], 504.6);
}

/// A roof as heavy as a layer of liquid of the thickness e lowers the frequency as much as a deck of that mass on the surface of deep liquid,
/// where the surface alone moves as a mass of the thickness 1/k: ω² = g/(1/k + e).
#[test]
fn a_floating_roof_is_a_mass_on_the_wave() {
    let mut case = tank(RoofKind::Floating, None, 0.0);
    case.liquid.fill_height = 100.0;
    case.tank.roof.afloat = 0.2 * 1000.0 * std::f64::consts::PI * 100.0;
    for n in [1, 2] {
        let found = afloat(&case, n).unwrap();
        close(found.loaded.powi(2), 9.81 / (1.0 / found.wave_number + 0.2));
        close(found.free.powi(2), 9.81 * found.wave_number);
    }
    case.tank.roof.afloat = 0.0;
    assert!(afloat(&case, 1).is_none());
}

/// Curvature and shortening against differences of the mode itself: η = J₁(5.3314 r/R)/J₁(5.3314).
#[test]
fn the_second_mode_bends_the_deck() {
    let case = tank(RoofKind::Floating, None, 0.0);
    let found = bent(&case, 0.1).unwrap();
    let eta = |r: f64| 0.1 * j(1, 5.331_443 * r / 10.0) / j(1, 5.331_443);
    let h = 1e-3;
    let second = (eta(10.0 + h) - 2.0 * eta(10.0) + eta(10.0 - h)) / (h * h);
    close(-second, found.curvature);
    // Length of the deck along a radius less the radius.
    let steps = 20_000;
    let length: f64 = (0..steps)
        .map(|i| {
            let [a, b] = [i, i + 1].map(|i| eta(10.0 * f64::from(i) / f64::from(steps)));
            (10.0 / f64::from(steps)).hypot(b - a)
        })
        .sum();
    assert!(
        ((length - 10.0) / 10.0 / found.shortening - 1.0).abs() < 0.002,
        "{} {}",
        length / 10.0 - 1.0,
        found.shortening
    );
}
