//! Two horizontal components against one, and against each other turned.

use fem::progress::Silent;
use results::Directional;
use results::nonlinear::End;
use tank::case::GroundMotion;
use tank::{Case, Quantity};

use super::super::super::{scope, simulate};
use super::{cracking, elastic, options, shaken};
use crate::Simulation;
use tank::options::nonlinear::{NonlinearOptions, WallElements};

/// The case with the record along x times `x`, along y times `y`.
fn both(case: &Case, x: f64, y: f64) -> Case {
    let motion = case.ground_motion.as_ref().unwrap();
    let scaled = |factor: f64| {
        let mut record = motion.horizontal.clone();
        record.acceleration.iter_mut().for_each(|a| *a *= factor);
        record
    };
    Case {
        ground_motion: Some(GroundMotion { horizontal: scaled(x), transverse: Some(scaled(y)), vertical: None }),
        ..case.clone()
    }
}

fn whole(case: &Case, height: u32, circumference: u32) -> NonlinearOptions {
    NonlinearOptions { symmetry: false, ..options(case, height, circumference) }
}

fn column<'a>(s: &'a Simulation, id: &str) -> &'a [f64] {
    &s.series.columns[s.series.ids.iter().position(|c| c == id).unwrap()]
}

fn direction<'a>(s: &'a Simulation, id: &str) -> &'a Directional {
    s.result.directions.iter().find(|d| d.id == id).unwrap()
}

/// Largest difference over the largest value.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

/// Nothing along y is the run with one component on the whole tank: its loads are those, plus zeros. Sums of other zeros round to the
/// same bits but for the sign of zero: 1e-12 of the largest value, over 25 steps of a tank that cracks.
#[test]
fn nothing_along_y_is_one_component() {
    let case = shaken(cracking(), 12.0, 25);
    let own = whole(&case, 6, 16);
    let one = simulate(&case, &own, None, &Silent).unwrap();
    let two = simulate(&both(&case, 1.0, 0.0), &own, None, &Silent).unwrap();
    for id in &one.series.ids {
        assert!(apart(column(&two, id), column(&one, id)) <= 1e-12, "{id}");
    }
    assert_eq!(one.result.events, two.result.events);
    assert!(one.result.directions.is_empty());
    let shear = direction(&two, "base_shear");
    assert!(shear.x > 0.0 && shear.y < 1e-3 * shear.x, "{shear:?}");
    assert!((shear.resultant / shear.x - 1.0).abs() < 1e-6);
}

/// The same record along x and y shakes an elastic tank along θ = 45°: histories of both are equal by the symmetry of the mesh about that
/// plane, resultants √2 times as large, the direction 45° or 225°. A step ends with a residual of up to 1e-4 of the forces: 1e-3. Along x it
/// moves as under the one record alone, but for large rotations, which the amplitudes of 0.05 m/s² do not have: 1e-3 as well.
#[test]
fn equal_components_shake_the_diagonal() {
    let case = shaken(elastic(), 0.05, 60);
    let own = whole(&case, 8, 16);
    let one = simulate(&case, &own, None, &Silent).unwrap();
    let two = simulate(&both(&case, 1.0, 1.0), &own, None, &Silent).unwrap();
    assert_eq!(two.result.end, End::Completed);
    for (x, y) in [
        ("base_shear", "base_shear_y"),
        ("base_moment", "base_moment_y"),
        ("wave_height_theta_0", "wave_height_theta_90"),
        ("wave_height_theta_180", "wave_height_theta_270"),
    ] {
        assert!(apart(column(&two, y), column(&two, x)) < 1e-3, "{y}");
        assert!(apart(column(&two, x), column(&one, x)) < 1e-3, "{x}");
    }
    for (id, both) in [("base_shear", "base_shear_resultant"), ("base_moment", "base_moment_resultant")] {
        let diagonal: Vec<f64> = column(&one, id).iter().map(|v| 2.0_f64.sqrt() * v.abs()).collect();
        assert!(apart(column(&two, both), &diagonal) < 1e-3, "{both}");
    }
    // The wave has a part that is the same around the tank: none of linear theory, next to none here.
    for (id, tolerance) in [("base_shear", 1e-3), ("base_moment", 1e-3), ("wave_height", 1e-3), ("hoop_stress", 5e-3)] {
        let found = direction(&two, id);
        assert!((found.x / found.y - 1.0).abs() < tolerance, "{found:?}");
        assert!((found.resultant / found.srss() - 1.0).abs() < tolerance, "{found:?}");
        // Stresses are those of the two cells next to the diagonal.
        let off = (found.theta.to_degrees().rem_euclid(180.0) - 45.0).abs();
        let cell = if id == "hoop_stress" { 11.25 } else { 0.0 };
        assert!((off - cell).abs() < 0.1, "{found:?}");
    }
    for quantity in [Quantity::BaseShear, Quantity::SloshingHeight, Quantity::HoopStress] {
        assert!((two.values[&quantity] / one.values[&quantity] - 1.0).abs() < 2e-3, "{quantity:?}");
    }
    // Limit states meet the diagonal: its meridian has √2 times the stress at θ = 0.
    let demands = two.demands.unwrap();
    let hoop = |turned: f64| {
        let places = demands.places.iter().filter(|p| (p.turned - turned).abs() < 1e-9 && p.z > 0.0);
        let swing = |p: &tank::demand::Place| demands.history(&p.hoop.odd).iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        places.map(swing).fold(0.0, f64::max)
    };
    // Cells from 0° to 22.5°, and from 45° to 67.5°: cos 11.25° + sin 11.25°, cos 56.25° + sin 56.25°.
    let ratio = [56.25_f64, 11.25].map(|a| a.to_radians().cos() + a.to_radians().sin());
    let found = hoop(std::f64::consts::FRAC_PI_4) / hoop(0.0);
    assert!((found / (ratio[0] / ratio[1]) - 1.0).abs() < 5e-3, "{found} {ratio:?}");
    let transverse = demands.transverse(demands.base_shear.as_ref().unwrap()).unwrap();
    assert!(apart(&transverse, &demands.history(demands.base_shear.as_ref().unwrap())) < 1e-3);
}

/// A tank that cracks under the record along y is the one under that along x turned by 90°: 1e-3 of the largest value, as between half
/// a tank and the whole.
#[test]
fn along_y_is_along_x_turned() {
    let case = shaken(cracking(), 12.0, 25);
    let own = whole(&case, 6, 16);
    let along = simulate(&both(&case, 1.0, 0.0), &own, None, &Silent).unwrap();
    let across = simulate(&both(&case, 0.0, 1.0), &own, None, &Silent).unwrap();
    for (x, y) in [
        ("base_shear", "base_shear_y"),
        ("base_moment", "base_moment_y"),
        ("wave_height_theta_0", "wave_height_theta_90"),
        ("wave_height_theta_180", "wave_height_theta_270"),
    ] {
        assert!(apart(column(&across, y), column(&along, x)) < 1e-3, "{y}");
    }
    let [a, b] = [&along, &across].map(|s| direction(s, "hoop_stress"));
    assert!((a.resultant / b.resultant - 1.0).abs() < 1e-2, "{a:?} {b:?}");
}

/// Half of a tank does not move along y, and θ = 90° must be a meridian.
#[test]
fn half_a_tank_is_refused() {
    let case = both(&shaken(elastic(), 0.05, 4), 1.0, 1.0);
    let refused = |own: &NonlinearOptions| -> Vec<String> {
        let all = scope::refusals(&case, own, scope::Purpose::History);
        all.into_iter().map(|r| r.message).collect()
    };
    let own = whole(&case, 6, 16);
    assert!(refused(&own).is_empty());
    let half = NonlinearOptions { symmetry: true, ..own.clone() };
    assert!(refused(&half)[0].contains("half of a tank"));
    let odd = NonlinearOptions { elements: Some(WallElements { height: 6, circumference: 18 }), ..own };
    assert!(refused(&odd)[0].contains("multiple of four"));
}
