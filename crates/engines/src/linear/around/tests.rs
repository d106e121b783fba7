//! Two horizontal components against one: the response to a motion along x alone, turned, scaled and projected.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2};

use oscillator::record::Record;
use tank::Case;

use super::super::simulate;
use super::*;
use crate::Simulation;
use crate::harmonic::test_tanks::broad;

/// A swept sine; the two used here differ in frequency, so that the resultant turns.
fn swept(amplitude: f64, frequency: f64) -> Record {
    Record {
        name: "swept".into(),
        dt: 0.01,
        acceleration: (0..300)
            .map(|k| {
                let t = 0.01 * f64::from(k);
                amplitude * (frequency * t * (1.0 + t)).sin()
            })
            .collect(),
        processing: Vec::new(),
    }
}

fn rest() -> Record {
    swept(0.0, 1.0)
}

/// A coarse mesh: turned, scaled and projected motions are the same on every one.
fn options() -> LinearOptions {
    LinearOptions { mesh_error: false, refine: 0.25, stations: vec![0.3], ..LinearOptions::default() }
}

fn run(x: Record, y: Option<Record>, vertical: Option<Record>, options: &LinearOptions) -> Simulation {
    let mut case: Case = broad();
    case.ground_motion = Some(GroundMotion { horizontal: x, transverse: y, vertical });
    simulate(&case, options).unwrap()
}

fn column<'a>(run: &'a Simulation, id: &str) -> &'a [f64] {
    let place = run.series.ids.iter().position(|i| i == id).unwrap();
    &run.series.columns[place]
}

/// A second component of zero changes no bit of the first: values, histories, limits, demands.
#[test]
fn a_component_of_zero_changes_nothing() {
    for integrator in [Integrator::Modal, Integrator::Newmark] {
        let options = LinearOptions { integrator, ..options() };
        let alone = run(swept(2.0, 9.0), None, None, &options);
        let both = run(swept(2.0, 9.0), Some(rest()), None, &options);
        assert!(alone.result.directions.is_empty());
        assert_eq!(alone.values, both.values);
        for (id, values) in alone.series.ids.iter().zip(&alone.series.columns) {
            assert_eq!(values, column(&both, id), "{id}");
        }
        assert_eq!(alone.result.limits, both.result.limits);
        assert_eq!(alone.result.envelopes, both.result.envelopes);
        let wave = |run: &Simulation| run.demands.as_ref().and_then(|d| d.wave).map(|w| (w.value, w.time, w.theta));
        assert_eq!(wave(&alone), wave(&both));
        for found in &both.result.directions {
            assert_eq!((found.resultant, found.y), (found.x, 0.0), "{}", found.id);
            assert!(found.theta == 0.0 || found.theta == PI, "{}", found.id);
        }
    }
}

/// Equal components are one along the diagonal, √2 times as strong: 1e-10 for the rounding of the sums.
#[test]
fn equal_components_act_along_the_diagonal() {
    let run = run(swept(2.0, 9.0), Some(swept(2.0, 9.0)), Some(swept(1.0, 13.0)), &options());
    for found in &run.result.directions {
        let turned = (found.theta - FRAC_PI_4).rem_euclid(PI);
        assert!(turned.min(PI - turned) < 1e-10, "{} {}", found.id, found.theta);
        // The vertical motion moves wave and wall stresses as well, and is not scaled.
        if found.id.starts_with("base_") || found.id == "overturning_moment" {
            assert!((found.resultant / found.x / SQRT_2 - 1.0).abs() < 1e-10, "{}", found.id);
            assert!((found.resultant / found.srss() - 1.0).abs() < 1e-10, "{}", found.id);
        }
    }
    let shear = column(&run, "base_shear");
    assert_eq!(shear, column(&run, "base_shear_y"));
    let peak = shear.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    for (x, resultant) in shear.iter().zip(column(&run, "base_shear_resultant")) {
        assert!((SQRT_2 * x.abs() - resultant).abs() < 1e-10 * peak);
    }
}

/// The same record along y instead of x: the same response, turned by 90°.
#[test]
fn a_motion_along_y_is_one_along_x_turned() {
    let x = run(swept(2.0, 9.0), Some(rest()), None, &options());
    let y = run(rest(), Some(swept(2.0, 9.0)), None, &options());
    for (along, turned) in [
        ("base_shear", "base_shear_y"),
        ("base_moment", "base_moment_y"),
        ("wave_height_theta_0", "wave_height_theta_90"),
        ("wave_height_theta_180", "wave_height_theta_270"),
        ("axial_membrane_stress_base", "axial_membrane_stress_base_theta_90"),
        ("hoop_stress_z_0.3", "hoop_stress_z_0.3_theta_90"),
        ("ground_velocity", "ground_velocity_y"),
        ("wave_height_largest", "wave_height_largest"),
    ] {
        assert_eq!(column(&x, along), column(&y, turned), "{along}");
    }
    for (a, b) in x.result.directions.iter().zip(&y.result.directions) {
        assert_eq!((&a.id, a.x, a.resultant, a.time), (&b.id, b.y, b.resultant, b.time));
        let turned = (b.theta - a.theta).rem_euclid(2.0 * PI);
        assert!((turned - FRAC_PI_2).abs() < 1e-12, "{}", a.id);
    }
}

/// At any angle the tank feels the components' projection: a run with one record a_x cos θ + a_y sin θ has at θ = 0 what this one
/// has at θ. Largest of 12 angles: at most the resultant, and at least cos(7.5°) = 0.9914 of it; the sub-steps may lose 0.3 % more
/// of the resultant.
#[test]
fn the_resultant_is_the_largest_of_all_projections() {
    let (x, y, up) = (swept(2.0, 9.0), swept(1.5, 7.0), swept(1.0, 13.0));
    for vertical in [None, Some(up)] {
        let both = run(x.clone(), Some(y.clone()), vertical.clone(), &options());
        let mut largest = vec![0.0_f64; both.result.directions.len()];
        for k in 0..12 {
            let (s, c) = (PI * f64::from(k) / 12.0).sin_cos();
            let projected = Record {
                acceleration: x.acceleration.iter().zip(&y.acceleration).map(|(x, y)| c * x + s * y).collect(),
                ..x.clone()
            };
            // Its own second component is zero: extremes at θ = 0 and 180°.
            let one = run(projected, Some(rest()), vertical.clone(), &options());
            for (largest, found) in largest.iter_mut().zip(&one.result.directions) {
                *largest = largest.max(found.resultant);
            }
        }
        for (found, largest) in both.result.directions.iter().zip(largest) {
            let ratio = largest / found.resultant;
            assert!((0.9914..1.003).contains(&ratio), "{} {ratio}", found.id);
            // The estimate of the codes is at least the resultant of a motion whose components do not peak together.
            assert!(found.resultant <= found.srss() * (1.0 + 1e-9) || vertical.is_some(), "{}", found.id);
        }
    }
}
