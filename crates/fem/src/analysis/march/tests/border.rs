//! A chain on a base that moves: with the base as a node of the chain, and relative to it.

use super::*;
use crate::analysis::border::Border;
use crate::element::super_element::SuperElement;
use crate::linalg::Matrix;

/// Mass of the base, less than that of the chain, and the stiffness below.
const BASE: (f64, f64) = (1.5, 200.0);

/// The chain of [`chain`] on the base; `relative`: its motion is relative to the base, which is an unknown beside.
fn parts(relative: bool) -> Parts {
    let mut builder = Builder::new();
    let x = Direction::Translation([1.0, 0.0, 0.0]);
    for k in 0..=MASSES {
        let node = builder.node([k as f64, 0.0, 0.0]);
        builder.hold(node, Dof::Uy);
        builder.hold(node, Dof::Uz);
        if k > 0 {
            let stiffness = 400.0 + 100.0 * (1.3 * k as f64).cos();
            let hardening = 0.05 * stiffness;
            builder.element("links", Link { nodes: [k - 1, k], stiffness, strength: 12.0, hardening, brittle: 10.0 });
            builder.element("masses", PointMass::new(node, 2.0 + (k as f64).sin()).unwrap());
        }
    }
    let mut base = None;
    if relative {
        builder.hold(0, Dof::Ux);
        let node = builder.node([0.0; 3]);
        let stiffness = Matrix { rows: 1, cols: 1, data: vec![BASE.1] };
        let spring = SuperElement::over(&[(node, Dof::Amplitude)]).unwrap().with_stiffness(stiffness).unwrap();
        builder.element("base", spring);
        base = Some(node);
    } else {
        builder.element("base", PointMass::new(0, BASE.0).unwrap());
        builder.element("base", Spring::to_ground(0, x, BASE.1).unwrap());
    }
    let model = builder.build().unwrap();
    let z = base.map(|node| model.dofs().equation(node, Dof::Amplitude).unwrap());
    let mut parts = Parts::new(model);
    parts.system.damping = Damping::rayleigh(Rayleigh { mass: 0.0, stiffness: 0.002 });
    if let Some(z) = z {
        let column = parts.system.inertia[0].clone();
        let mass = BASE.0 + column.iter().sum::<f64>();
        let own = Matrix { rows: 1, cols: 1, data: vec![mass] };
        parts.system.inertia[0][z] = mass;
        parts.system.border = Some(Border { unknowns: vec![z], columns: vec![column], own });
    }
    parts
}

/// Both have one solution, u = u_rel + z, and the balance of energy closes: through steps that yield, jumps of the record at its start and end, and
/// every way of Newton's method. Converged to 1e-10 of the work of a step, 1e-5 of its motion, over some hundred plastic steps: 1e-4, as in
/// [`hysteresis_and_balance`].
#[test]
fn a_moving_base_is_a_node_of_the_chain() {
    let (whole, relative) = (parts(false), parts(true));
    let at = |parts: &Parts, node: usize, dof: Dof| Quantity::Linear(Observable::displacement(&parts.model, node, dof));
    for (modified, search) in [(false, false), (true, true)] {
        let mut settings = Settings::new(grid());
        settings.newton.modified = modified;
        settings.newton.line_search = search;
        let run = |parts: &Parts, quantities: Vec<Quantity>| {
            let mut recorder = QuantityObserver::new(quantities);
            let run = march(parts.problem(), &shaking(3.0), &settings, &mut [&mut recorder], &Silent).unwrap();
            assert_eq!(run.outcome, Outcome::Completed);
            assert!(run.balance.error() < 1e-5, "{}", run.balance.error());
            let last = *run.balance.samples.last().unwrap();
            assert!(last.hysteretic > 0.05 * last.input, "{last:?}");
            (recorder.histories, last)
        };
        let (expected, energy) = run(&whole, vec![at(&whole, MASSES, Dof::Ux), at(&whole, 0, Dof::Ux)]);
        let top = at(&relative, MASSES, Dof::Ux);
        let (found, own) = run(&relative, vec![top, at(&relative, MASSES + 1, Dof::Amplitude)]);
        let peak = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let apart = |a: &mut dyn Iterator<Item = f64>, b: &[f64]| {
            a.zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / peak(b)
        };
        assert!(peak(&expected[1]) > 0.1 * peak(&expected[0]));
        let top = apart(&mut found[0].iter().zip(&found[1]).map(|(u, z)| u + z), &expected[0]);
        let base = apart(&mut found[1].iter().copied(), &expected[1]);
        assert!(top < 1e-4 && base < 1e-4, "{top} {base}");
        for (a, b) in [(own.input, energy.input), (own.hysteretic, energy.hysteretic)] {
            assert!((a - b).abs() < 1e-4 * energy.input.abs(), "{own:?} {energy:?}");
        }
    }
}
