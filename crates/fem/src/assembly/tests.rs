//! Large models are assembled in halves, and evaluated on several threads.

use super::*;
use crate::dofs::Dof;
use crate::element::solid8::{Elastic, Kinematics, Solid8};
use crate::element::{ElementError, Response, Trial, Want, reference_mass, reference_stiffness};
use crate::linalg::Symmetric;
use crate::model::Builder;
use crate::state::State;

/// The matrices of a model large enough to be assembled in halves, times a vector, against the sum over the elements. With
/// the elements in shuffled order both halves write everywhere.
#[test]
fn halves_add_up() {
    let n = 13;
    let node = |x: usize, y: usize, z: usize| x + (n + 1) * (y + (n + 1) * z);
    for stride in [1, 997] {
        let mut builder = Builder::new();
        for k in 0..(n + 1).pow(3) {
            builder.node([k % (n + 1), k / (n + 1) % (n + 1), k / (n + 1).pow(2)].map(|i| i as f64));
        }
        for k in 0..n.pow(3) {
            // 997 is a prime, so that every brick comes once.
            let k = k * stride % n.pow(3);
            let (x, y, z) = (k % n, k / n % n, k / n / n);
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
            let nodes = std::array::from_fn(|a| node(x + corners[a % 4].0, y + corners[a % 4].1, z + a / 4));
            let positions =
                nodes.map(|k: usize| [k % (n + 1), k / (n + 1) % (n + 1), k / (n + 1).pow(2)].map(|i| i as f64));
            let material = Elastic::isotropic(3.0 + (k % 7) as f64, 0.3, 2.0 + (k % 5) as f64);
            builder.element("solid", Solid8::new(nodes, positions, material, Kinematics::Linear).unwrap());
        }
        builder.hold(3, Dof::Uy);
        let model = builder.build().unwrap();
        assert!(model.elements().len() >= HALVED);
        let assembler = Assembler::new(&model);
        let (stiffness, mass) = assembler.stiffness_and_mass(&model).unwrap();
        assert_eq!(stiffness, assembler.stiffness(&model).unwrap());
        assert_eq!(mass, assembler.mass(&model));
        let x: Vec<f64> = (0..model.dofs().len()).map(|i| ((i * 7919) % 101) as f64 - 50.0).collect();
        let (mut kx, mut mx) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        for (e, element) in model.elements().iter().enumerate() {
            let own = local_values(&model, &**element, &x);
            let matrices = [reference_stiffness(&**element).unwrap(), reference_mass(&**element)];
            for (local, out) in matrices.iter().zip([&mut kx, &mut mx]) {
                assembler.scatter_vector(&model, e, &mut local.to_matrix().times(&own), out);
            }
        }
        for (found, expected) in [(stiffness.times(&x), kx), (mass.times(&x), mx)] {
            for (f, e) in found.iter().zip(&expected) {
                // Some 10² terms of up to 10³.
                assert!((f - e).abs() < 1e-9, "{f} {e}");
            }
        }
    }
}

/// A spring between two nodes whose force grows with the cube of its stretch; remembers the largest one. Its stiffness is not a
/// number if it is to fail.
struct Cubic {
    nodes: [usize; 2],
    stiffness: f64,
}

impl Element for Cubic {
    crate::answers!("cubic", nodes, Dof::TRANSLATIONS);

    fn history_len(&self) -> usize {
        1
    }

    fn respond(&self, Trial { motion, old, new, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if self.stiffness.is_nan() {
            return Err(ElementError::NoAnswer { kind: "cubic", reason: "no stiffness".into() });
        }
        new[0] = old[0];
        for i in 0..3 {
            let stretch = motion.values[3 + i] - motion.values[i];
            new[0] = new[0].max(stretch.abs());
            let force = self.stiffness * (stretch + stretch.powi(3));
            let slope = self.stiffness * (1.0 + 3.0 * stretch * stretch);
            out.force[i] -= force;
            out.force[3 + i] += force;
            out.tangent.add(i, i, slope);
            out.tangent.add(3 + i, 3 + i, slope);
            out.tangent.add_symmetric(i, 3 + i, -slope);
        }
        Ok(())
    }
}

/// Springs between random nodes, some of them in turned frames; those of `faults` fail.
fn net(faults: &[usize]) -> Model {
    let mut builder = Builder::new();
    let nodes = 97;
    for k in 0..nodes {
        builder.node([k as f64, 0.0, 0.0]);
        if k % 3 == 0 {
            let turn = nalgebra::Rotation3::from_euler_angles(0.1 * k as f64, 0.3, 0.0);
            builder.frame(k, *turn.matrix());
        }
    }
    builder.hold(3, Dof::Uy);
    for e in 0..1000 {
        let stiffness = if faults.contains(&e) { f64::NAN } else { 1.0 + (e % 11) as f64 / 3.0 };
        let nodes = [e % nodes, (e * 31 + 1 + e / nodes) % nodes];
        builder.element("net", Cubic { nodes, stiffness });
    }
    builder.build().unwrap()
}

/// Forces, tangent and history are, bit by bit, those of one thread.
#[test]
fn threads_change_no_bit() {
    let model = net(&[]);
    let assembler = Assembler::new(&model);
    let run = |threads: usize, want: Want| {
        let mut state = State::new(&model);
        for (i, u) in state.trial.u.iter_mut().enumerate() {
            *u = (i as f64 * 0.37).sin();
        }
        let ask = Ask { threads, ..Ask::now(want, None) };
        let (mut tangent, mut forces) = (Symmetric::zeros(assembler.pattern().clone()), Forces::default());
        let asked = assembler.answer(&model, &mut state, ask, &mut tangent, &mut forces, None);
        asked.unwrap();
        state.commit();
        (forces, tangent, state)
    };
    for want in [Want::ALL, Want::FORCE, Want::TANGENT] {
        let one = run(1, want);
        assert!(one.2.old.iter().any(|h| *h > 0.0));
        for threads in [2, 3, 8] {
            assert!(run(threads, want) == one, "{threads} threads, {want:?}");
        }
    }
}

/// Of several elements that fail the first is reported, by any number of threads.
#[test]
fn the_first_failure_is_reported() {
    let model = net(&[977, 613, 640]);
    let assembler = Assembler::new(&model);
    for threads in [1, 2, 3, 8] {
        let ask = Ask { threads, ..Ask::now(Want::ALL, None) };
        let mut state = State::new(&model);
        let mut tangent = Symmetric::zeros(assembler.pattern().clone());
        let asked = assembler.answer(&model, &mut state, ask, &mut tangent, &mut Forces::default(), None);
        assert_eq!(asked.unwrap_err().0, 613, "{threads} threads");
    }
}
