//! Newton's method on closed forms, and on a linear model against the linear analyses.

use super::*;
use crate::analysis::damping::Rayleigh;
use crate::analysis::motion::{Grid, Motion};
use crate::analysis::scheme::TimeScheme;
use crate::analysis::statics::Statics;
use crate::analysis::system::System;
use crate::analysis::transient::{Load, Settings, integrate};
use crate::dofs::Dof;
use crate::element::solid8::{Elastic, Kinematics, Solid8};
use crate::linalg::Ordering;
use crate::model::Builder;
use crate::progress::Silent;

/// Bar of `count` bricks 1 × 1 × 1 along z without Poisson effect, on rollers; unknowns of the end are equal by symmetry.
fn bar(count: usize, kinematics: Kinematics) -> Model {
    let mut builder = Builder::new();
    for level in 0..=count {
        for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            let node = builder.node([x, y, level as f64]);
            builder.hold(node, Dof::Ux);
            builder.hold(node, Dof::Uy);
            if level == 0 {
                builder.hold(node, Dof::Uz);
            }
        }
    }
    for level in 0..count {
        let nodes: [usize; 8] = std::array::from_fn(|a| 4 * level + a);
        let corners = nodes.map(|n| {
            let [x, y] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]][n % 4];
            [x, y, (n / 4) as f64]
        });
        let brick = Solid8::new(nodes, corners, Elastic::isotropic(100.0, 0.0, 2.0), kinematics).unwrap();
        builder.element("bar", brick);
    }
    builder.build().unwrap()
}

fn parts(model: &Model) -> (Assembler, Arc<Symbolic>) {
    let assembler = Assembler::new(model);
    let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap();
    (assembler, Arc::new(symbolic))
}

fn end_load(model: &Model, total: f64) -> Vec<f64> {
    let mut p = vec![0.0; model.dofs().len()];
    for node in model.nodes().len() - 4..model.nodes().len() {
        p[model.dofs().equation(node, Dof::Uz).unwrap()] = 0.25 * total;
    }
    p
}

/// St. Venant-Kirchhoff bar: P = E A λ (λ² − 1)/2. Converges quadratically.
#[test]
fn stretched_bar() {
    let model = bar(3, Kinematics::GreenLagrange);
    let (assembler, symbolic) = parts(&model);
    let mut newton = Newton::new(&model, &assembler, &symbolic, None, Criteria::default()).unwrap();
    let mut state = State::new(&model);
    let stretch = 1.4_f64;
    let load = end_load(&model, 100.0 * stretch * (stretch * stretch - 1.0) / 2.0);
    let zero = vec![0.0; load.len()];
    let mut seen = 0;
    let path = load_path(&mut newton, &mut state, &zero, &load, 2, &Silent, |_, _| seen += 1).unwrap();
    assert_eq!((path.factor, path.failure, seen), (1.0, None, path.steps.len()));
    for node in 4..16 {
        let expected = (stretch - 1.0) * (node / 4) as f64;
        let u = model.at_node(&state.committed.u, node)[2];
        // |δu·r| ≤ 1e-10 leaves an error of its root, 1e-5, before the last and quadratic step.
        assert!((u - expected).abs() < 1e-8, "{u} {expected}");
    }
}

/// Linear elements: one iteration a step, statics and every scheme of time integration as the linear analyses have them.
#[test]
fn linear_is_a_special_case() {
    let model = bar(5, Kinematics::Linear);
    let (assembler, symbolic) = parts(&model);
    let system = System::new(&model, &assembler)
        .unwrap()
        .with_damping(Damping::rayleigh(Rayleigh { mass: 0.05, stiffness: 0.01 }));
    let load = end_load(&model, 3.0);
    let mut newton = Newton::new(&model, &assembler, &symbolic, None, Criteria::default()).unwrap();
    let mut state = State::new(&model);
    let report = newton.step(&LoadStep, &mut state, &load, &load).unwrap();
    assert!(report.iterations <= 2);
    let statics = Statics::new(&symbolic, &system.stiffness, Kind::Definite).unwrap();
    let u = statics.solve(&system.stiffness, &[&load]).unwrap().remove(0);
    for (a, b) in state.committed.u.iter().zip(&u) {
        assert!((a - b).abs() < 1e-13);
    }
    let grid = Grid::new(0.02, 1.0, 0.0, 0.02);
    let force: Vec<f64> = (0..grid.samples).map(|k| (0.2 * k as f64).sin()).collect();
    for scheme in
        [TimeScheme::Trapezoidal, TimeScheme::Hht { alpha: -0.1 }, TimeScheme::GeneralizedAlpha { radius: 0.7 }]
    {
        let mut settings = Settings::new(grid);
        settings.scheme = scheme;
        let loads = [Load { forces: vec![(load.clone(), Motion::sampled(0.02, &force, &grid))], ..Load::default() }];
        let linear = integrate(&system, &symbolic, &loads, &settings, &[], &[], &Silent).unwrap().remove(0);
        let inertia = Inertia::from(&system);
        let mut newton = Newton::new(&model, &assembler, &symbolic, Some(inertia), Criteria::default()).unwrap();
        let mut state = State::new(&model);
        let step = scheme.with_step(0.02).unwrap();
        for pair in force.windows(2) {
            let at = |f: f64| -> Vec<f64> { load.iter().map(|p| f * p).collect() };
            newton.step(&step, &mut state, &at(pair[0]), &at(pair[1])).unwrap();
        }
        let largest = linear.u.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
        for (a, b) in state.committed.u.iter().zip(&linear.u) {
            // The energy criterion stops after the first correction, exact to rounding.
            assert!((a - b).abs() < 1e-10 * largest, "{a} {b}");
        }
    }
}

#[test]
fn failures_leave_the_state_alone() {
    let model = bar(2, Kinematics::GreenLagrange);
    let (assembler, symbolic) = parts(&model);
    let criteria = Criteria { iterations: 1, ..Criteria::default() };
    let mut newton = Newton::new(&model, &assembler, &symbolic, None, criteria).unwrap();
    let mut state = State::new(&model);
    let before = state.clone();
    let load = end_load(&model, 50.0);
    let failure = newton.step(&LoadStep, &mut state, &load, &load).unwrap_err();
    assert!(matches!(failure, StepFailure::NoConvergence { iterations: 1, .. }));
    assert_eq!(state, before);
}
