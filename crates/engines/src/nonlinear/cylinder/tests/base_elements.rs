//! The elements of a base that slides and of one on anchors, in models whose answer has a closed form.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use fem::analysis::march::{Outcome, Problem, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::newton::{Newton, Options, load_path};
use fem::analysis::system::System;
use fem::analysis::transient::Load;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::anchor::Anchor;
use fem::element::ground::Ground;
use fem::element::spring::PointMass;
use fem::element::super_element::SuperElement;
use fem::linalg::{Matrix, Ordering, Symbolic};
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;

use crate::nonlinear::arcs::{cosine_shares, shares};
use crate::nonlinear::bottom::hold::keep_plane;

/// A rectangular pulse of 0.5 g over 0.3 s, friction 0.2: the block slips by A² t₀²/(2 μ g) − A t₀²/2 = 0.33097 m in all, 1e-3. Until its spring has
/// grown to the friction, ω = 3160/s, a block gains as much speed as in the time 1/ω: 5e-4 of it. Friction that acts at the end of a step of 0.1 ms is
/// late by half of that, and the pulse rises in 0.2 ms: 2e-4 each.
#[test]
fn a_block_slips_as_far_as_it_should() {
    const GRAVITY: f64 = 9.80665;
    let mut builder = Builder::new();
    let node = builder.node([0.0; 3]);
    builder.hold(node, Dof::Uy);
    builder.element("block", PointMass::new(node, 1000.0).unwrap());
    let ground = Ground::new(node, 1e10, 1.0).unwrap().with_friction(0.2).unwrap();
    builder.element("ground", ground);
    let model = builder.build().unwrap();
    let assembler = Assembler::new(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let system = System::new(&model, &assembler).unwrap();
    let problem = Problem { model: &model, assembler: &assembler, symbolic: &symbolic, system: &system };
    // Straight between samples: half of the acceleration at the end of the pulse keeps its area.
    let acceleration: Vec<f64> = (0..=12_000)
        .map(|i| match i {
            100 | 3100 => 0.25 * GRAVITY,
            101..=3099 => 0.5 * GRAVITY,
            _ => 0.0,
        })
        .collect();
    let grid = Grid::new(1e-4, 1.2, 0.0, 1e-4);
    let load = Load::ground(0, Motion::sampled(1e-4, &acceleration, &grid));
    let mut settings = Settings::new(grid);
    settings.constant = assembler.body_force(&model, [0.0, 0.0, -GRAVITY]);
    settings.newton = Options::for_contact();
    let run = march(problem, &load, &settings, &mut [], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
    let slip = -model.at_node(&run.state.committed.u, node)[0];
    assert!((slip / 0.33097 - 1.0).abs() < 1e-3, "{slip}");
    assert!(run.balance.error().abs() < 1e-3, "{}", run.balance.error());
    // Work of friction on its way.
    let lost = run.balance.samples.last().unwrap().hysteretic;
    assert!((lost / (0.2 * 1000.0 * GRAVITY * slip) - 1.0).abs() < 5e-3, "{lost}");
}

/// Half a ring of anchors that stays plane, on hard ground: turned far enough all anchors yield and it turns about its toe, M = R (n N_y + W).
/// 1 %, as asked: the anchors next to the toe are not stretched, and the toe is as wide as the distance of the nodes.
#[test]
fn a_ring_of_anchors_turns_about_its_toe() {
    const RADIUS: f64 = 5.0;
    let (count, strength, weight) = (24.0, 2e5, 3e6);
    let angles: Vec<f64> = (0..=60).map(|k| PI * f64::from(k) / 60.0).collect();
    let mut builder = Builder::new();
    let foot: Vec<usize> =
        angles.iter().map(|angle| builder.node([RADIUS * angle.cos(), RADIUS * angle.sin(), 0.0])).collect();
    let mut load = fem::element::shell::load::NodalLoads::new();
    for (&node, share) in foot.iter().zip(shares(&angles)) {
        builder.hold(node, Dof::Ux);
        builder.hold(node, Dof::Uy);
        builder.element("ground", Ground::new(node, 1e12, RADIUS * share * 0.1).unwrap());
        let number = count * share / TAU;
        builder.element("anchor", Anchor::new(node, number * 1e8, number * strength).unwrap());
        load.force(node, [0.0, 0.0, -weight * share / TAU]);
    }
    keep_plane(&mut builder, &angles, &foot).unwrap();
    // A spring on ψ = Σ c_i u_i, whose other end turns by the given angle.
    let row: Vec<f64> = cosine_shares(&angles).iter().map(|c| -2.0 * c / (PI * RADIUS)).collect();
    let (stiffness, turned) = (1e10, 0.05);
    let mut matrix = Matrix::zeros(row.len(), row.len());
    for (i, a) in row.iter().enumerate() {
        for (j, b) in row.iter().enumerate() {
            matrix.add(i, j, stiffness * a * b);
        }
    }
    let unknowns: Vec<(usize, Dof)> = foot.iter().map(|n| (*n, Dof::Uz)).collect();
    let drive = SuperElement::over(&unknowns).unwrap().with_stiffness(matrix).unwrap();
    builder.element("drive", drive);
    let model = builder.build().unwrap();
    let assembler = Assembler::new(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap());
    let mut newton = Newton::with_options(&model, &assembler, &symbolic, None, Options::for_contact()).unwrap();
    let mut state = State::new(&model);
    let still = vec![0.0; model.dofs().len()];
    let rest = load.vector(&model);
    let pressed = load_path(&mut newton, &mut state, &still, &rest, 4, &Silent, |_, _| {}).unwrap();
    assert_eq!(pressed.failure, None);
    let mut moved = fem::element::shell::load::NodalLoads::new();
    for (&node, c) in foot.iter().zip(&row) {
        moved.force(node, [0.0, 0.0, stiffness * turned * c]);
    }
    let driven = moved.vector(&model);
    let path = load_path(&mut newton, &mut state, &rest, &driven, 40, &Silent, |_, _| {}).unwrap();
    assert_eq!(path.failure, None);
    let height = |node: usize| model.at_node(&state.committed.u, node)[2];
    let rotation: f64 = foot.iter().zip(&row).map(|(n, c)| c * height(*n)).sum();
    let moment = 2.0 * stiffness * (turned - rotation);
    let expected = RADIUS * (count * strength + weight);
    assert!((moment / expected - 1.0).abs() < 0.01, "{moment} {expected} at {rotation}");
    assert!(rotation > 5e-3 && height(foot[60]) > 0.05);
}
