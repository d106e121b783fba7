//! A zone against the factor of the whole, and its Newton's method against the full one.

use super::solver::ZoneSolver;
use super::*;
use crate::analysis::checkpoint::{Reader, Writer};
use crate::analysis::march::{Instant, Outcome, Problem, Settings, march};
use crate::analysis::motion::{Grid, Motion};
use crate::analysis::newton::{Cost, Inertia, Newton, Options};
use crate::analysis::scheme::TimeScheme;
use crate::analysis::system::System;
use crate::analysis::transient::Load;
use crate::dofs::Dof;
use crate::element::ground::Ground;
use crate::element::solid8::{Elastic, Kinematics, Solid8};
use crate::linalg::{Kind, Symbolic};
use crate::model::Builder;
use crate::progress::Silent;
use crate::state::State;

const LENGTH: usize = 12;
const GROUND: &str = "ground";
const NEAR: &str = "near";

/// A beam of bricks along x, held sideways, on ground under every node of its lower edge; the third of it at the far end is of another group.
fn beam() -> (Model, Assembler) {
    let mut builder = Builder::new();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for level in 0..=LENGTH {
        for [y, z] in corners {
            let node = builder.node([level as f64, y, z]);
            builder.hold(node, Dof::Uy);
            if level == 0 {
                builder.hold(node, Dof::Ux);
            }
        }
    }
    for level in 0..LENGTH {
        let nodes: [usize; 8] = std::array::from_fn(|a| 4 * level + a);
        let at = nodes.map(|n| [(n / 4) as f64, corners[n % 4][0], corners[n % 4][1]]);
        let stiff = Elastic::isotropic(4e5, 0.2, 10.0);
        let brick = Solid8::new(nodes, at, stiff, Kinematics::GreenLagrange).unwrap();
        builder.element(if level < LENGTH / 3 { NEAR } else { "far" }, brick);
    }
    for level in 0..=LENGTH {
        for lower in [0, 1] {
            let ground = Ground::new(4 * level + lower, 2e4, 0.5).unwrap();
            builder.element(GROUND, ground);
        }
    }
    let model = builder.build().unwrap();
    let assembler = Assembler::new(&model);
    (model, assembler)
}

fn zone(model: &Model, assembler: &Assembler) -> Arc<Zone> {
    let own = |e: usize| [GROUND, NEAR].contains(&model.groups()[model.group_of(e)].as_str());
    Arc::new(Zone::new(model, assembler, own).unwrap())
}

/// ‖r_E‖ over ‖r‖ of a residual of 3 outside and 4 within, on one unknown each: 3/5.
#[test]
fn the_share_outside_is_that_of_its_unknowns() {
    let (model, assembler) = beam();
    let zone = zone(&model, &assembler);
    let unknown = |node: usize| model.dofs().equation(node, Dof::Uz).unwrap();
    let mut r = vec![0.0; model.dofs().len()];
    r[unknown(4 * LENGTH + 3)] = 3.0;
    assert_eq!(zone.share_outside(&r), 1.0);
    r[unknown(4)] = 4.0;
    assert!((zone.share_outside(&r) - 0.6).abs() < 1e-15);
}

/// Both factors together solve as that of the whole, after one of both and after one of the zone alone, on one thread and on two:
/// rounding at a condition of about 1e6.
#[test]
fn two_factors_are_one() {
    let (model, assembler) = beam();
    let zone = zone(&model, &assembler);
    let within = zone.elements();
    let mass = assembler.mass(&model);
    let base = {
        let mut base = assembler.stiffness_of(&model, |e| !within[e]).unwrap();
        base.add(300.0, &mass);
        base
    };
    let own = assembler.stiffness_of(&model, |e| within[e]).unwrap();
    let symbolic = Arc::new(Symbolic::new(base.pattern.clone(), &Ordering::MinimumDegree).unwrap());
    let b: Vec<f64> = (0..base.size()).map(|i| (0.7 * i as f64).cos()).collect();
    // Rounded to single precision: a hundred times 6e-8.
    let kept = [(Keep::Double, 1, 1e-10), (Keep::Double, 2, 1e-10), (Keep::Single, 1, 6e-6)];
    for ((keep, threads, allowed), factor) in kept.into_iter().flat_map(|k| [1.0, 0.3, 2.0].map(|f| (k, f))) {
        let mut solver = ZoneSolver::new(&zone, keep, threads).unwrap();
        solver.renew(&base, Some((0.0, &own)), &[]).unwrap();
        let mut whole = base.clone();
        whole.add(factor, &own);
        let expected = symbolic.factor(&whole, Kind::Definite).unwrap().solve_vector(&b).unwrap();
        let mut found = Vec::new();
        solver.renew_zone(Some((factor, &own))).unwrap();
        solver.solve(&b, &mut found);
        let size = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (x, e) in found.iter().zip(&expected) {
            assert!((x - e).abs() < allowed * size, "{x} {e}");
        }
    }
}

/// A beam that is thrown off its ground and falls back: the tangents outside of the zone are kept, those of the zone are taken as the ground
/// opens and closes. The same motion as with full Newton: the criterion of contact leaves |δu·r| ≤ 1e-18, a relative error of the
/// displacements of 1e-9 a step; a hundred steps and the multiplication by impacts leave 1e-6.
#[test]
fn a_kept_outside_is_full_newton() {
    let (model, assembler) = beam();
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let system = System::new(&model, &assembler).unwrap();
    let problem = Problem { model: &model, assembler: &assembler, symbolic: &symbolic, system: &system };
    let grid = Grid::new(0.005, 0.5, 0.0, 0.005);
    let shaking: Vec<f64> = (0..=100).map(|k| 25.0 * (25.0 * 0.005 * f64::from(k)).sin()).collect();
    let load = Load::ground(2, Motion::sampled(0.005, &shaking, &grid));
    let tip = model.dofs().equation(4 * LENGTH, Dof::Uz).unwrap();
    let run = |zone: Option<Arc<Zone>>| {
        let mut settings = Settings::new(grid);
        settings.constant = assembler.body_force(&model, [0.0, 0.0, -9.81]);
        settings.newton = Options::for_contact();
        settings.newton.zone = zone;
        let mut seen = Vec::new();
        let mut watch = |now: &Instant<'_>| seen.push(now.state.committed.u[tip]);
        let run = march(problem, &load, &settings, &mut [&mut watch], &Silent).unwrap();
        assert_eq!(run.outcome, Outcome::Completed);
        (seen, run)
    };
    let (expected, full) = run(None);
    let (found, kept) = run(Some(zone(&model, &assembler)));
    let largest = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert!(expected.iter().any(|u| *u > 1e-3), "it leaves the ground");
    for (x, e) in found.iter().zip(&expected) {
        assert!((x - e).abs() < 1e-6 * largest, "{x} {e}");
    }
    assert!(kept.balance.error() < 1e-6, "{}", kept.balance.error());
    // Full Newton factors everything in every iteration.
    assert_eq!(full.cost.wholes, 0);
    assert!(kept.cost.wholes * 5 < full.cost.factors, "{:?} {:?}", kept.cost, full.cost);
}

/// Steps that are halved and come back to their length: the factor of each length is made once and serves again with the present tangents of the
/// zone, the motion is that of full Newton (1e-6, as above), and a run that is stored and taken up at any of these steps goes on with the same bits.
#[test]
fn a_spare_factor_serves_another_length_of_step() {
    let (model, assembler) = beam();
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let system = System::new(&model, &assembler).unwrap();
    let inertia = Inertia::from(&system);
    let begin = |zone: Option<Arc<Zone>>| {
        let options = Options { zone, ..Options::for_contact() };
        Newton::with_options(&model, &assembler, &symbolic, Some(inertia), options).unwrap()
    };
    let parts = [1, 1, 2, 2, 1, 2, 2, 1, 1];
    let weight = assembler.body_force(&model, [0.0, 0.0, -9.81]);
    let at = |t: f64| -> Vec<f64> { weight.iter().map(|w| w * (1.0 + 2.5 * (25.0 * t).sin())).collect() };
    let folder = tempfile::tempdir().unwrap();
    let run = |zone: Option<Arc<Zone>>, stored_after: Option<usize>| -> (Vec<f64>, Cost) {
        let (mut newton, mut state, mut t) = (begin(zone.clone()), State::new(&model), 0.0);
        for (k, part) in parts.iter().cycle().take(54).enumerate() {
            let h = 0.01 / f64::from(*part);
            let scheme = TimeScheme::Trapezoidal.with_step(h).unwrap();
            newton.step(&scheme, &mut state, &at(t), &at(t + h)).unwrap();
            t += h;
            if stored_after == Some(k) {
                let path = folder.path().join(format!("{k}"));
                let mut to = Writer::default();
                to.state(&state);
                newton.save(&mut to);
                to.save(&path, 1).unwrap();
                let mut from = Reader::open(&path, 1).unwrap();
                (newton, state) = (begin(zone.clone()), State::new(&model));
                from.state_into(&mut state).unwrap();
                newton.restore(&mut from, &state).unwrap();
            }
        }
        (state.committed.u, newton.cost())
    };
    let (expected, _) = run(None, None);
    let zone = zone(&model, &assembler);
    let (found, cost) = run(Some(zone.clone()), None);
    let largest = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (x, e) in found.iter().zip(&expected) {
        assert!((x - e).abs() < 1e-6 * largest, "{x} {e}");
    }
    assert_eq!(cost.wholes, 2, "{cost:?}");
    for k in [3, 4, 5, 30] {
        assert!(run(Some(zone.clone()), Some(k)) == (found.clone(), cost), "stored after step {k}");
    }
}
