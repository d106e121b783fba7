//! Marches of a linear chain against direct integration, and of one with elastic-plastic links.

mod adaptive;
mod border;
mod resume;

use std::cell::RefCell;

use std::sync::Arc;

use super::*;
use crate::analysis::damping::{Damping, Rayleigh};
use crate::analysis::motion::Motion;
use crate::analysis::observable::Observable;
use crate::analysis::system::System;
use crate::analysis::transient::{self, integrate};
use crate::assembly::Assembler;
use crate::element::spring::{Direction, PointMass, Spring};
use crate::element::{Element, ElementError, Inspect, Response, Trial};
use crate::linalg::Ordering;
use crate::linalg::Symbolic;
use crate::model::Builder;
use crate::model::Model;
use crate::progress::Silent;

/// Elastic-plastic link along x between two nodes (or a node and itself held) with linear hardening; history: plastic
/// elongation, energy dissipated. Beyond `brittle` it fails.
struct Link {
    nodes: [usize; 2],
    stiffness: f64,
    strength: f64,
    hardening: f64,
    brittle: f64,
}

impl Element for Link {
    crate::answers!("link", nodes, Dof::slice(0..1); massless inspect);

    fn history_len(&self) -> usize {
        2
    }

    fn respond(&self, Trial { motion, old, new, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let e = motion.values[1] - motion.values[0];
        if e.abs() > self.brittle {
            let reason = format!("elongation {e}");
            return Err(ElementError::NoAnswer { kind: "link", reason });
        }
        let (k, h) = (self.stiffness, self.hardening);
        let trial = k * (e - old[0]);
        let over = (trial - h * old[0]).abs() - self.strength;
        let (mut f, mut tangent) = (trial, k);
        new.copy_from_slice(old);
        if over > 0.0 {
            let flow = over / (k + h) * (trial - h * old[0]).signum();
            new[0] = old[0] + flow;
            f = k * (e - new[0]);
            // Work on the plastic elongation less the energy stored by hardening.
            new[1] = old[1] + self.strength * flow.abs();
            tangent = k * h / (k + h);
        }
        for (i, si) in [-1.0, 1.0].into_iter().enumerate() {
            out.force[i] += si * f;
            for (j, sj) in [-1.0, 1.0].into_iter().enumerate() {
                out.tangent.add(i, j, si * sj * tangent);
            }
        }
        Ok(())
    }
}

impl Inspect for Link {
    fn dissipated(&self, history: &[f64]) -> f64 {
        history[1]
    }
}

const MASSES: usize = 6;

/// Chain of masses; `strength` infinite: linear springs instead of links.
fn chain(strength: f64, brittle: f64) -> Model {
    chain_of(MASSES, strength, brittle)
}

fn chain_of(masses: usize, strength: f64, brittle: f64) -> Model {
    let mut builder = Builder::new();
    for k in 0..=masses {
        let node = builder.node([k as f64, 0.0, 0.0]);
        builder.hold(node, Dof::Uy);
        builder.hold(node, Dof::Uz);
        if k == 0 {
            builder.hold(node, Dof::Ux);
            continue;
        }
        builder.element("masses", PointMass::new(node, 2.0 + (k as f64).sin()).unwrap());
        let stiffness = 400.0 + 100.0 * (1.3 * k as f64).cos();
        if strength.is_infinite() {
            let x = Direction::Translation([1.0, 0.0, 0.0]);
            builder.element("links", Spring::between(k - 1, k, x, stiffness).unwrap());
        } else {
            let link = Link { nodes: [k - 1, k], stiffness, strength, hardening: 0.05 * stiffness, brittle };
            builder.element("links", link);
        }
    }
    builder.build().unwrap()
}

struct Parts {
    model: Model,
    assembler: Assembler,
    symbolic: Arc<Symbolic>,
    system: System,
}

impl Parts {
    fn new(model: Model) -> Parts {
        let assembler = Assembler::new(&model);
        let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).unwrap();
        let damping = Damping::rayleigh(Rayleigh { mass: 0.05, stiffness: 0.002 });
        let system = System::new(&model, &assembler).unwrap().with_damping(damping);
        Parts { symbolic: Arc::new(symbolic), model, assembler, system }
    }

    fn problem(&self) -> Problem<'_> {
        Problem { model: &self.model, assembler: &self.assembler, symbolic: &self.symbolic, system: &self.system }
    }

    fn weight(&self) -> Vec<f64> {
        self.system.inertia[0].iter().map(|m| 1.5 * m).collect()
    }
}

fn grid() -> Grid {
    Grid::new(0.02, 6.0, 2.0, 0.02)
}

/// A record that begins and ends with a jump.
fn shaking(amplitude: f64) -> Load {
    let a: Vec<f64> = (0..=300)
        .map(|k| amplitude * ((0.13 * f64::from(k) + 0.7).sin() + 0.5 * (0.31 * f64::from(k)).cos()))
        .collect();
    Load::ground(0, Motion::sampled(0.02, &a, &grid()))
}

fn base_shear(problem: Problem<'_>) -> Quantity {
    let along_x = |_| crate::analysis::system::unit(0);
    let damping = problem.system.damping.rayleigh;
    Quantity::Reaction(Reaction::new(problem, "base shear", along_x, |_| damping).unwrap())
}

fn top(problem: Problem<'_>) -> Quantity {
    Quantity::Linear(Observable::displacement(problem.model, MASSES, Dof::Ux))
}

/// A linear model: the histories of direct integration, its energies, and a balance that closes for every scheme.
#[test]
fn linear_march_is_direct_integration() {
    let parts = Parts::new(chain(f64::INFINITY, 1.0));
    let problem = parts.problem();
    let load = shaking(1.0);
    let along_x = |_| crate::analysis::system::unit(0);
    let damping = problem.system.damping.rayleigh;
    let rows = [
        Observable::displacement(problem.model, MASSES, Dof::Ux),
        Observable::reaction(problem.model, "base shear", along_x, |_| damping).unwrap(),
    ];
    for scheme in [
        TimeScheme::Trapezoidal,
        TimeScheme::Hht { alpha: -0.1 },
        TimeScheme::GeneralizedAlpha { radius: 0.8 },
        TimeScheme::Newmark { beta: 0.3, gamma: 0.6 },
    ] {
        let mut linear = transient::Settings::new(grid());
        linear.scheme = scheme;
        let direct =
            integrate(problem.system, problem.symbolic, std::slice::from_ref(&load), &linear, &rows, &[], &Silent)
                .unwrap()
                .remove(0);
        let mut settings = Settings::new(grid());
        settings.scheme = scheme;
        let mut recorder = QuantityObserver::new(vec![top(problem), base_shear(problem)]);
        let run = march(problem, &load, &settings, &mut [&mut recorder], &Silent).unwrap();
        assert_eq!(run.outcome, Outcome::Completed);
        for (found, expected) in recorder.histories.iter().zip(&direct.observed.scalars) {
            let peak = expected.extreme.peak().0;
            assert_eq!(found.len(), grid().samples);
            for (a, b) in found.iter().zip(&expected.values) {
                assert!((a - b).abs() < 1e-10 * peak, "{scheme:?}: {a} {b}");
            }
        }
        // D9: rounding alone, less the dissipation of the scheme.
        assert!(run.balance.error() < 1e-10, "{scheme:?}: {}", run.balance.error());
        let last = run.balance.samples.last().unwrap();
        let kinetic = direct.energy.kinetic.last().unwrap();
        assert!((last.kinetic - kinetic).abs() < 1e-10 * run.balance.largest);
        let dissipates = !matches!(scheme, TimeScheme::Trapezoidal);
        assert_eq!(last.numerical.abs() > 1e-6 * run.balance.largest, dissipates, "{last:?}");
        // One factor serves all steps.
        assert_eq!(run.cost.factors, 1);
    }
}

/// Without ground motion a structure that has yielded under its weight stays at rest (D2).
#[test]
fn rest_stays_rest() {
    let parts = Parts::new(chain(12.0, 10.0));
    let mut settings = Settings::new(Grid::new(0.02, 20.0, 0.0, 0.02));
    settings.constant = parts.weight();
    let start = RefCell::new(None);
    let mut moved = 0.0_f64;
    let mut watch = |now: &Instant<'_>| {
        let u = &now.state.committed.u;
        let mut start = start.borrow_mut();
        let start = start.get_or_insert_with(|| u.clone());
        moved = u.iter().zip(start.iter()).fold(moved, |m, (a, b)| m.max((a - b).abs()));
    };
    let run = march(parts.problem(), &Load::default(), &settings, &mut [&mut watch], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
    assert_eq!(run.cost.steps, 1005);
    assert!(moved < 1e-9, "{moved}");
    // Σ W k⁻¹ from the top and the links that yield: more than elastic.
    assert!(run.state.old.iter().any(|h| h.abs() > 1e-3));
}

/// Elastic-plastic links: converged steps whatever the scheme, dissipation that never falls, an elastic rest that is positive.
#[test]
fn hysteresis_and_balance() {
    let parts = Parts::new(chain(12.0, 10.0));
    let mut tops = Vec::new();
    for (modified, search) in [(false, false), (true, true)] {
        let mut settings = Settings::new(grid());
        settings.constant = parts.weight();
        settings.newton.modified = modified;
        settings.newton.line_search = search;
        let mut recorder = QuantityObserver::new(vec![top(parts.problem()), base_shear(parts.problem())]);
        let run = march(parts.problem(), &shaking(3.0), &settings, &mut [&mut recorder], &Silent).unwrap();
        assert_eq!(run.outcome, Outcome::Completed);
        let balance = &run.balance;
        // D9 asks 1e-3; Newton's criterion leaves far less.
        assert!(balance.error() < 1e-5, "{}", balance.error());
        assert!(balance.samples.windows(2).all(|w| w[1].hysteretic >= w[0].hysteretic));
        let last = balance.samples.last().unwrap();
        assert!(last.hysteretic > 0.3 * last.input, "{last:?}");
        // At the start the links hold elastic energy, which is counted from there.
        let stored = balance.samples.iter().map(|e| e.internal - e.hysteretic);
        assert!(stored.fold(f64::INFINITY, f64::min) > -0.5 * 6.0 * 12.0 * 12.0 / 300.0);
        tops.push(recorder.histories.swap_remove(0));
    }
    let peak = tops[0].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let apart = tops[0].iter().zip(&tops[1]).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    // |δu·r| ≤ 1e-10 of a step: 1e-5 of its increment, over some hundred plastic steps.
    assert!(apart < 1e-4 * peak, "{apart} {peak}");
}

/// A link that breaks: the march stops with the last equilibrium and everything recorded; as does a static start.
#[test]
fn collapse_is_an_outcome() {
    let parts = Parts::new(chain(12.0, 1.0));
    let mut settings = Settings::new(grid());
    settings.constant = parts.weight();
    let mut recorder = QuantityObserver::new(vec![top(parts.problem())]);
    let run = march(parts.problem(), &shaking(12.0), &settings, &mut [&mut recorder], &Silent).unwrap();
    let Outcome::Collapsed(collapse) = &run.outcome else { panic!("{:?}", run.outcome) };
    assert!(collapse.time > 0.0 && collapse.time < 6.0 && collapse.load_factor.is_none());
    assert!(collapse.element.is_some() && run.cuts >= 6);
    assert_eq!(recorder.times.len(), recorder.histories[0].len());
    assert!(run.time == collapse.time && run.shortest <= 0.02);
    assert!(recorder.ranges[0].max > 0.1);
    settings.constant.iter_mut().for_each(|p| *p *= 10.0);
    let run = march(parts.problem(), &shaking(12.0), &settings, &mut [], &Silent).unwrap();
    let Outcome::Collapsed(collapse) = &run.outcome else { panic!("{:?}", run.outcome) };
    let factor = collapse.load_factor.unwrap();
    assert!(factor > 0.1 && factor < 1.0 && collapse.time == 0.0, "{factor}");
}

/// A link that fails for elongations that change by more than `most` in a step; history: its elongation.
struct Hurried {
    nodes: [usize; 2],
    most: f64,
}

impl Element for Hurried {
    crate::answers!("hurried", nodes, Dof::slice(0..1); massless);

    fn history_len(&self) -> usize {
        1
    }

    fn respond(&self, Trial { motion, old, new, .. }: Trial<'_>, _out: &mut Response) -> Result<(), ElementError> {
        new[0] = motion.values[1] - motion.values[0];
        let change = (new[0] - old[0]).abs();
        if change > self.most {
            let reason = format!("changed by {change} in a step");
            return Err(ElementError::NoAnswer { kind: "hurried", reason });
        }
        Ok(())
    }
}

/// Cut steps grow again: by doubling, after `recovery` steps that converged, onto the grid of the doubled length; the quiet end
/// is marched in whole steps, and every instant of the nominal grid is met.
#[test]
fn cut_steps_grow_again() {
    let mut builder = Builder::new();
    let [ground, mass] = [0.0, 1.0].map(|x| builder.node([x, 0.0, 0.0]));
    for (node, dof) in [(ground, Dof::Ux), (ground, Dof::Uy), (ground, Dof::Uz), (mass, Dof::Uy), (mass, Dof::Uz)] {
        builder.hold(node, dof);
    }
    builder.element("mass", PointMass::new(mass, 2.0).unwrap());
    let x = Direction::Translation([1.0, 0.0, 0.0]);
    builder.element("spring", Spring::between(ground, mass, x, 200.0).unwrap());
    let nodes = [ground, mass];
    builder.element("hurried", Hurried { nodes, most: 4e-3 });
    let parts = Parts::new(builder.build().unwrap());
    let h = 0.02;
    // A second of shaking at resonance, up to 2 m/s: ten times the change allowed in a whole step; then a decay of 1.25 %.
    let a: Vec<f64> = (0..=50).map(|k| 4.0 * (10.0 * h * f64::from(k)).sin()).collect();
    let grid = Grid::new(h, 1.0, 39.0, h);
    let load = Load::ground(0, Motion::sampled(h, &a, &grid));
    let mut settings = Settings::new(grid);
    settings.recovery = 7;
    let mut steps: Vec<(f64, f64)> = Vec::new();
    let mut watch = |now: &Instant<'_>| steps.push((now.time, now.step));
    let run = march(parts.problem(), &load, &settings, &mut [&mut watch], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
    assert!(run.cuts > 0 && run.shortest <= h / 4.0);
    steps.remove(0);
    let mut since = 0;
    let mut grown = 0;
    for (i, &(time, step)) in steps.iter().enumerate() {
        let parts = h / step;
        assert!((parts - parts.round()).abs() < 1e-9 && (parts.round() as u64).is_power_of_two());
        // Every step ends on the grid of its own length.
        assert!((time / step - (time / step).round()).abs() < 1e-6, "{time} {step}");
        let before = if i == 0 { h } else { steps[i - 1].1 };
        if step > before * 1.5 {
            assert!((step / before - 2.0).abs() < 1e-9, "{before} {step}");
            assert!(since >= settings.recovery, "{since} at {time}");
            grown += 1;
        }
        since = if (step / before - 1.0).abs() < 1e-9 { since + 1 } else { 1 };
    }
    assert!(grown >= 2);
    assert!(steps.iter().rev().take(200).all(|s| (s.1 - h).abs() < 1e-12));
    let whole = steps.iter().filter(|s| (s.0 / h - (s.0 / h).round()).abs() < 1e-9);
    assert_eq!(whole.count(), grid.steps());
    let sum: f64 = steps.iter().map(|s| s.1).sum();
    assert!((sum - grid.time(grid.steps())).abs() < 1e-9);
}

#[test]
fn bad_input_is_rejected() {
    let parts = Parts::new(chain(12.0, 10.0));
    let run = |settings: &Settings, load: Load| march(parts.problem(), &load, settings, &mut [], &Silent).unwrap_err();
    let mut settings = Settings::new(grid());
    settings.constant = vec![1.0];
    assert!(run(&settings, Load::default()).to_string().contains("1 entries"));
    let mut settings = Settings::new(grid());
    settings.scheme = TimeScheme::GeneralizedAlpha { radius: 1.5 };
    assert!(run(&settings, Load::default()).to_string().contains("ρ_∞ = 1.5"));
    let mut settings = Settings::new(grid());
    settings.newton.tangent_damping = vec![-1.0];
    assert!(run(&settings, Load::default()).to_string().contains("tangent damping"));
    let broken = Load::ground(0, Motion::sampled(0.02, &[0.0, f64::NAN], &grid()));
    let settings = Settings::new(grid());
    assert!(matches!(run(&settings, broken), AnalysisError::NotFinite { .. }));
}
