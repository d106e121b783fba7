use std::sync::Arc;

use super::*;
use crate::element::shell::section::ElasticSection;
use crate::element::{Inspect, Motion, Trial, Want, reference_mass, reference_stiffness};

const INNER_FACE: f64 = 0.04;
const OUTER_FACE: f64 = 0.06;

/// A warped wall of two shells of different thickness, its directors apart.
fn wall(material: Elastic, mass: LayerMass) -> (Wall, [[f64; 3]; 8]) {
    let foot = [[0.0, 0.0, 0.05], [1.2, 0.1, -0.05], [1.0, 0.9, 0.1], [-0.1, 1.1, -0.02]];
    let directors =
        [[0.1, 0.05], [-0.1, 0.1], [0.0, -0.1], [0.05, 0.1]].map(|[a, b]| Vector3::new(a, b, 1.0).normalize());
    let outer: [[f64; 3]; 4] = std::array::from_fn(|a| std::array::from_fn(|i| foot[a][i] + 0.35 * directors[a][i]));
    let shell = |nodes, x, e: f64, t| {
        let section = ElasticSection::new(e, 0.3, t, 2.0).unwrap();
        Shell4::new(nodes, x, directors, Arc::new(section)).unwrap()
    };
    let layer = Layer { material, kinematics: Kinematics::GreenLagrange, mass };
    let wall = Wall::new(
        shell([0, 1, 2, 3], foot, 1000.0, 2.0 * INNER_FACE),
        shell([4, 5, 6, 7], outer, 700.0, 2.0 * OUTER_FACE),
        [INNER_FACE, OUTER_FACE],
        &layer,
    )
    .unwrap();
    let all = std::array::from_fn(|a| if a < 4 { foot[a] } else { outer[a - 4] });
    (wall, all)
}

fn respond(wall: &Wall, values: &[f64], rotations: &[UnitQuaternion<f64>; 8]) -> Response {
    let mut out = Response::sized(SIZE);
    wall.respond(Trial { motion: Motion { values, rotations }, old: &[], new: &mut [], want: Want::ALL }, &mut out)
        .unwrap();
    out
}

/// Total mass, its first moment, and the weight, for every assignment of the layer's mass.
#[test]
fn mass_and_weight_agree() {
    for mass in [LayerMass::Halves, LayerMass::Inner, LayerMass::Outer] {
        let (wall, x) = wall(Elastic::normal_only(300.0, 1.5), mass);
        let m = reference_mass(&wall).to_matrix();
        let total = wall.inner.area() * 2.0 * 2.0 * INNER_FACE
            + wall.outer.area() * 2.0 * 2.0 * OUTER_FACE
            + 1.5 * wall.layer.volume();
        let (mut shift, mut weight) = (vec![0.0; SIZE], vec![0.0; SIZE]);
        (0..8).for_each(|a| shift[6 * a] = 1.0);
        let inertia = m.times(&shift);
        let sum: f64 = inertia.iter().zip(&shift).map(|(a, b)| a * b).sum();
        assert!((sum / total - 1.0).abs() < 1e-13, "{sum} {total}");
        wall.body_force([1.0, 0.0, 0.0], &mut weight);
        for (a, b) in inertia.iter().zip(&weight) {
            assert!((a - b).abs() < 1e-13);
        }
        // The layer's mass follows a rigid rotation about its own place: T is that of the faces.
        let spin = Vector3::new(0.3, -0.2, 0.5);
        let mut u = vec![0.0; SIZE];
        for a in 0..8 {
            let v = spin.cross(&Vector3::from(x[a]));
            (0..3).for_each(|i| {
                u[6 * a + i] = v[i];
                u[6 * a + 3 + i] = spin[i];
            });
        }
        let mut face = Vec::new();
        let pull = wall.pull(&wall.directors);
        for a in 0..8 {
            let v = Vector3::from_column_slice(&u[6 * a..6 * a + 3]) + pull[a] * spin;
            let at = Vector3::from(x[a]) + wall.directors[a] * wall.lever[a];
            assert!((v - spin.cross(&at)).norm() < 1e-14);
            face.extend(v.iter().copied());
        }
    }
}

/// Without tension the shells part: only the residual pulls; pressed they are joined.
#[test]
fn layer_without_tension_parts() {
    let (wall, _) = wall(Elastic::pressed_only(300.0, 0.0), LayerMass::Halves);
    let pull = |by: f64| {
        let mut u = vec![0.0; SIZE];
        (4..8).for_each(|a| u[6 * a + 2] = by);
        let force = respond(&wall, &u, &[UnitQuaternion::identity(); 8]).force;
        (4..8).map(|a| force[6 * a + 2]).sum::<f64>()
    };
    let (pressed, parted) = (pull(-1e-6), pull(1e-6));
    assert!(pressed < 0.0 && (parted / pressed + 1e-6).abs() < 1e-9, "{pressed} {parted}");
    let mut switched = Vec::new();
    let rest = vec![0.0; SIZE];
    let motion = Motion { values: &rest, rotations: &[UnitQuaternion::identity(); 8] };
    wall.switches(motion, &[], &mut |on| switched.push(on));
    assert_eq!(switched, [true; 8]);
}

/// Samples are rows over all dofs and show the layer's strain.
#[test]
fn samples_of_all_parts() {
    let (wall, _) = wall(Elastic::normal_only(300.0, 0.0), LayerMass::Halves);
    let samples = wall.samples();
    assert_eq!(samples.len(), 40 + 8 + 40);
    assert!(samples.iter().all(|s| s.row.len() == SIZE));
    let stiffness = reference_stiffness(&wall).unwrap();
    assert_eq!(stiffness.n, SIZE);
    let mut seen = Vec::new();
    let motion = Motion { values: &[0.0; SIZE], rotations: &[UnitQuaternion::identity(); 8] };
    wall.material_points(motion, &[], &mut |p| seen.push(p.point));
    assert!(seen.ends_with(&[8, 9, 10, 11, 12, 13, 14, 15]));
}

#[test]
fn bad_geometry_is_rejected() {
    let (wall, _) = wall(Elastic::normal_only(300.0, 0.0), LayerMass::Halves);
    let layer =
        Layer { material: Elastic::normal_only(300.0, 0.0), kinematics: Kinematics::Linear, mass: LayerMass::Halves };
    let again = |faces| Wall::new(wall.inner.clone(), wall.outer.clone(), faces, &layer);
    assert!(again([0.3, 0.06]).is_err_and(|e| e.to_string().contains("no thickness")));
    assert!(again([f64::NAN, 0.0]).is_err());
    assert!(Wall::new(wall.outer.clone(), wall.inner.clone(), [0.0, 0.0], &layer).is_err());
}
