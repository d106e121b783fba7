//! Hash of everything a march depends on.

use super::{Problem, Settings};
use crate::analysis::checkpoint::Hash;
use crate::analysis::motion::Motion;
use crate::analysis::transient::Load;
use crate::dofs::Dof;
use crate::element::{Element, Motion as Movement, Response, Want, local_size};
use crate::linalg::Symmetric;

/// Parts of an element's size that its nodes are moved by to see what it answers.
const PARTS: [f64; 5] = [1e-5, -3e-4, 3e-3, -2e-2, 0.1];

pub(super) fn fingerprint(problem: Problem<'_>, load: &Load, settings: &Settings) -> u64 {
    let mut hash = Hash::default();
    let model = problem.model;
    for (node, position) in model.nodes().iter().enumerate() {
        hash.numbers(position);
        for dof in Dof::ALL {
            let equation = model.dofs().equation(node, dof).map_or(usize::MAX, |e| e);
            hash.count(equation);
            hash.count(usize::from(model.is_held(node, dof)));
        }
        for frame in [model.frame(node), model.rotation_frame(node)].into_iter().flatten() {
            hash.numbers(frame.as_slice());
        }
    }
    for group in model.groups() {
        hash.text(group);
    }
    for (e, element) in model.elements().iter().enumerate() {
        hash.text(element.kind());
        hash.count(model.group_of(e));
        element.nodes().iter().for_each(|&n| hash.count(n));
        ask(model.nodes(), &**element, &mut hash);
    }
    let system = problem.system;
    let mut matrix = |m: &Symmetric| hash.numbers(&m.values);
    matrix(&system.mass);
    matrix(&system.stiffness);
    if let Some(c) = &system.damping.sparse {
        matrix(c);
    }
    hash.numbers(&[system.damping.rayleigh.mass, system.damping.rayleigh.stiffness]);
    system.inertia.iter().for_each(|i| hash.numbers(i));
    hash.text(&format!(
        "{:?} {:?} {:?}",
        settings.scheme, settings.grid, settings.newton
    ));
    hash.numbers(&settings.constant);
    for count in [settings.load_steps, settings.halvings as usize, settings.recovery] {
        hash.count(count);
    }
    if let Some(start) = &settings.start {
        hash.numbers(&start.committed.u);
        hash.numbers(&start.old);
    }
    let mut motion = |m: &Motion| (0..=m.last()).for_each(|i| hash.numbers(&[m.at(i)]));
    load.ground.iter().flatten().for_each(&mut motion);
    load.forces.iter().for_each(|(_, m)| motion(m));
    load.forces.iter().for_each(|(p, _)| hash.numbers(p));
    hash.text(settings.checkpoint.as_ref().map_or("", |c| &c.key));
    hash.value()
}

/// What an element answers to a few motions of its nodes: laws have no name here, but they have an answer.
fn ask(nodes: &[[f64; 3]], element: &dyn Element, hash: &mut Hash) {
    if element.is_linear() {
        // In the matrices.
        return;
    }
    let own: Vec<[f64; 3]> = element.nodes().iter().map(|&n| nodes[n]).collect();
    let mut size = 0.0_f64;
    for i in 0..3 {
        let of = own.iter().map(|p| p[i]);
        let (low, high) = of.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        size = size.max(high - low);
    }
    let size = if size > 0.0 { size } else { 1.0 };
    let n = local_size(element);
    let mut old = vec![0.0; element.history_len()];
    element.init_history(&mut old);
    hash.numbers(&old);
    let mut new = old.clone();
    let mut response = Response::sized(n);
    let rotations = vec![nalgebra::UnitQuaternion::identity(); own.len()];
    for part in PARTS {
        let mut values = Vec::with_capacity(n);
        for a in 0..own.len() {
            for dof in element.dofs(a) {
                let unit = if dof.index() < 3 { size } else { 1.0 };
                let wave = ((7 * values.len() + 3) as f64).sin();
                values.push(part * unit * wave);
            }
        }
        response.reset(n);
        let motion = Movement {
            values: &values,
            rotations: &rotations,
        };
        match element.respond(motion, &old, &mut new, Want::FORCE, &mut response) {
            Ok(()) => hash.numbers(&response.force),
            Err(error) => hash.text(&error.to_string()),
        }
    }
}
