//! Unit tests of the shell: a hand calculation, rejected geometry, sections in their own frame.

use materials::elastic::Elastic;

use crate::element::shell::layered::tests::Springs;
use crate::element::shell::layered::{Bar, LayeredSection, Ply};
use crate::element::shell::rule::Rule;
use crate::element::shell::section::ElasticSection;
use crate::element::{Inspect, Motion, Trial, Want, reference_stiffness};

use super::*;

const SQUARE: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn section() -> Arc<dyn Section> {
    Arc::new(ElasticSection::new(1000.0, 0.25, 0.1, 1.0).expect("valid parameters"))
}

/// Stretch 0.01 along x: n_11 = E t/(1 − ν²) 0.01 = 16/15, n_22 = ν n_11; a pull n_11 · 1 m shared by two nodes.
#[test]
fn uniaxial_stretch_by_hand() {
    let shell = Shell4::new([0, 1, 2, 3], SQUARE, [Vector3::z(); 4], section()).unwrap();
    let mut u = vec![0.0; SIZE];
    (u[6], u[12]) = (0.02, 0.02);
    for sample in shell.samples() {
        let value: f64 = sample.row.iter().zip(&u).map(|(a, b)| a * b).sum();
        let expected = match sample.name {
            "n_11" => 16.0 / 15.0,
            "n_22" => 4.0 / 15.0,
            _ => 0.0,
        };
        assert!((value - expected).abs() < 1e-13, "{}", sample.name);
    }
    let force = reference_stiffness(&shell).unwrap().to_matrix().times(&u);
    assert!((force[6] - 8.0 / 15.0).abs() < 1e-13 && (force[0] + 8.0 / 15.0).abs() < 1e-13);
}

#[test]
fn bad_geometry_is_rejected() {
    let up = [Vector3::z(); 4];
    assert!(Shell4::new([0, 1, 2, 3], SQUARE, [-Vector3::z(); 4], section()).is_err());
    assert!(Shell4::new([0, 1, 2, 3], SQUARE, up.map(|d| d * 1.1), section()).is_err());
    let bow_tie = [SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]];
    assert!(matches!(Shell4::new([0, 1, 2, 3], bow_tie, up, section()), Err(ElementError::Jacobian { .. })));
    let nan = [[f64::NAN, 0.0, 0.0], SQUARE[1], SQUARE[2], SQUARE[3]];
    assert!(Shell4::new([0, 1, 2, 3], nan, up, section()).is_err());
    let shell = Shell4::new([0, 1, 2, 3], SQUARE, up, section()).unwrap();
    assert!(shell.with_drilling([true; 4], -1.0).is_err());
}

const WARPED: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.1, 0.1], [1.8, 1.2, -0.1], [-0.1, 1.0, 0.2]];

/// Steel springs that yield, with bars at `angle`.
fn reinforced(angle: f64) -> Arc<dyn Section> {
    let ply =
        Ply { law: Arc::new(Elastic::new(30e9, 0.2).unwrap()), thickness: 0.1, density: 2500.0, rule: Rule::Gauss(2) };
    let bar = Bar { law: Arc::new(Springs), area: 4e-3, depth: 0.03, angle, density: 7850.0 };
    Arc::new(LayeredSection::new(&[ply], &[bar]).unwrap())
}

fn moved(shell: &Shell4, scale: f64) -> (Response, Vec<f64>) {
    let values: Vec<f64> = (0..SIZE).map(|k| scale * (1.3 * k as f64).sin()).collect();
    let rotations: Vec<_> = (0..4)
        .map(|a| UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.2) * (scale * f64::from(a))))
        .collect();
    let mut old = vec![0.0; shell.history_len()];
    shell.init_history(&mut old);
    let mut new = old.clone();
    let mut out = Response::sized(SIZE);
    let motion = Motion { values: &values, rotations: &rotations };
    shell.respond(Trial { motion, old: &old, new: &mut new, want: Want::ALL }, &mut out).unwrap();
    (out, new)
}

/// On a plane element one bar may be named by its angle from the element's first axis, or by 0 in axes laid along it; a wrong
/// angle shows.
#[test]
fn bars_follow_the_axes_of_the_shell() {
    let shell = |angle: f64, axes: Axes| {
        Shell4::new([0, 1, 2, 3], SQUARE, [Vector3::z(); 4], reinforced(angle)).unwrap().with_axes(axes)
    };
    let angle = 0.4_f64;
    let along = Axes::Along([angle.cos(), angle.sin(), 0.0]);
    let (by_angle, history) = moved(&shell(angle, Axes::Element), 1e-2);
    let (by_axes, _) = moved(&shell(0.0, along), 1e-2);
    let (wrong, _) = moved(&shell(0.0, Axes::Element), 1e-2);
    let size = by_angle.force.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    let difference = |other: &Response| {
        let pairs = by_angle.force.iter().zip(&other.force);
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
    };
    assert!(difference(&by_axes) < 1e-12 && difference(&wrong) > 1e-3);
    let stiffness = by_angle.tangent.data.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    for (a, b) in by_angle.tangent.data.iter().zip(&by_axes.tangent.data) {
        assert!((a - b).abs() < 1e-12 * stiffness);
    }
    // Some bars have yielded: energy over the area.
    let own = shell(angle, Axes::Element);
    assert!(own.dissipated(&history) > 0.0);
    let mean = history[0] * 0.5
        + history[history.len() / 4] * 0.5
        + history[history.len() / 2] * 0.5
        + history[3 * history.len() / 4] * 0.5;
    assert!((own.dissipated(&history) / mean - 1.0).abs() < 1e-12, "four points of 0.5 m²");
}

/// A warped element with bars in hoop direction under finite rotations: bars, layers and sections are shown along the axes.
#[test]
fn layered_shell_in_hoop_axes() {
    let normal = |a: usize| {
        let x = WARPED.map(Vector3::from);
        (x[(a + 1) % 4] - x[a]).cross(&(x[(a + 3) % 4] - x[a])).normalize()
    };
    let hoop = Axes::Hoop { origin: [5.0, -3.0, 0.0], axis: [0.0, 0.0, 1.0] };
    let shell = Shell4::new([0, 1, 2, 3], WARPED, [0, 1, 2, 3].map(normal), reinforced(0.3)).unwrap().with_axes(hoop);
    let rotations = [0.0, 0.02, 0.01, -0.03].map(|a| UnitQuaternion::from_scaled_axis(Vector3::new(a, 0.01, -a)));
    let values: Vec<f64> = (0..SIZE).map(|k| 0.01 * (1.3 * k as f64).sin()).collect();
    let mut old = vec![0.0; shell.history_len()];
    shell.init_history(&mut old);
    let motion = Motion { values: &values, rotations: &rotations };
    let mut history = old.clone();
    shell
        .respond(Trial { motion, old: &old, new: &mut history, want: Want::FORCE }, &mut Response::sized(SIZE))
        .unwrap();
    let mut bars = 0;
    shell.material_points(motion, &history, &mut |i| {
        let radius = Vector3::new(i.position[0] - 5.0, i.position[1] + 3.0, 0.0);
        let along = Vector3::z().cross(&radius).normalize();
        if i.layer == 2 {
            bars += 1;
            assert!(i.stress[0].abs() > 1.0 && i.stress[1] == 0.0);
            // Nearly flat: projection on the tangent plane costs the square of the slope.
            assert!((i.axes[0].dot(&along) - 0.3_f64.cos()).abs() < 0.05);
        } else {
            assert!(i.axes[0].dot(&along) > 0.95 && i.axes[0].dot(&i.axes[1]).abs() < 1e-14);
        }
    });
    assert_eq!(bars, 4);
    let sections = shell.sections(motion, &history).unwrap();
    assert_eq!(sections.len(), 4);
    assert!(sections.iter().all(|s| s.resultants.iter().all(|n| n.is_finite() && *n != 0.0)));
}
