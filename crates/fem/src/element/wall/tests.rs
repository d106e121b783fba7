use std::sync::Arc;

use super::*;
use crate::analysis::march::{Outcome, Problem, Settings, march};
use crate::analysis::motion::Grid;
use crate::analysis::newton::Options;
use crate::analysis::scheme::TimeScheme;
use crate::analysis::system::System;
use crate::analysis::transient::Load;
use crate::assembly::Assembler;
use crate::element::shell::section::ElasticSection;
use crate::element::{Inspect, Motion, Trial, Want, reference_mass, reference_stiffness};
use crate::linalg::{Ordering, Symbolic};
use crate::model::Builder;
use crate::progress::Silent;
use crate::state::State;

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

/// A shell of mass m thrown at its layer, k = E A/t, with the speed v: it comes back with v. In steps h the trapezoidal rule with the
/// mean force, of the whole wall, gives v (1 − 3q)/(1 + q), q = (ω h)²/4, in two coarse steps, three times v; with the force at the end of the
/// step v (1 − 2q)/(1 + 2q), never more than v, and in N fine ones it loses π²/(4N) of v, the work ½ k Δu² of every step.
#[test]
fn a_loose_layer_returns_no_more_than_it_took() {
    let omega = (300.0 / 0.1 / (2.0 * 2.0 * INNER_FACE)).sqrt();
    let q = 100.0_f64;
    let coarse = 2.0 * q.sqrt() / omega;
    // The residual stiffness of the open layer turns v by (ω h)² 1e-6 = 4e-4 a step.
    let exact = [(1.0 - 3.0 * q) / (1.0 + q), (1.0 - 2.0 * q) / (1.0 + 2.0 * q)];
    for (apart, exact) in [false, true].into_iter().zip(exact) {
        let found = thrown(apart, coarse, 2);
        assert!((found / exact - 1.0).abs() < 1e-2, "{found} {exact}");
    }
    // Five steps after it has parted; next order of the loss: 1/N.
    let steps = 400;
    let found = 1.0 + thrown(true, std::f64::consts::PI / omega / steps as f64, steps + 5);
    let exact = std::f64::consts::PI.powi(2) / (4.0 * steps as f64);
    assert!((found / exact - 1.0).abs() < 5e-2, "{found} {exact}");
}

/// Speed of the inner shell after `steps` of `h` [s], thrown at the layer with 1 m/s; its stresses `apart` as an element of their own.
fn thrown(apart: bool, h: f64, steps: usize) -> f64 {
    let foot = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let top = foot.map(|[x, y, _]| [x, y, INNER_FACE + 0.1 + OUTER_FACE]);
    let mut builder = Builder::new();
    let shell = |builder: &mut Builder, x: [[f64; 3]; 4], t: f64, density: f64| {
        let nodes = x.map(|x| builder.node(x));
        let section = Arc::new(ElasticSection::new(1000.0, 0.3, t, density).unwrap());
        Shell4::new(nodes, x, [Vector3::z(); 4], section).unwrap()
    };
    let inner = shell(&mut builder, foot, 2.0 * INNER_FACE, 2.0);
    let outer = shell(&mut builder, top, 2.0 * OUTER_FACE, 2.0);
    let layer =
        Layer { material: Elastic::pressed_only(300.0, 0.0), kinematics: Kinematics::Linear, mass: LayerMass::Halves };
    let wall = Wall::new(inner, outer, [INNER_FACE, OUTER_FACE], &layer).unwrap();
    match apart {
        false => {
            builder.element("wall", wall);
        }
        true => {
            let (wall, layer) = wall.part_loose();
            builder.element("wall", wall);
            builder.element("wall", layer.unwrap());
        }
    }
    for node in 0..8 {
        for dof in Dof::SHELL.iter().filter(|d| node >= 4 || **d != Dof::Uz) {
            builder.hold(node, *dof);
        }
    }
    let model = builder.build().unwrap();
    let assembler = Assembler::new(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let system = System::new(&model, &assembler).unwrap();
    let mut settings = Settings::new(Grid::new(h, h * steps as f64, 0.0, h));
    settings.scheme = TimeScheme::GeneralizedAlpha { radius: 1.0 };
    settings.newton = Options::for_contact();
    let mut start = State::new(&model);
    start.committed.v.fill(1.0);
    settings.start = Some(start);
    let problem = Problem { model: &model, assembler: &assembler, symbolic: &symbolic, system: &system };
    let run = march(problem, &Load::default(), &settings, &mut [], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
    run.state.committed.v[0]
}
