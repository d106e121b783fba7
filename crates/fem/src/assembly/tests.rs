//! Large models are assembled in halves.

use super::*;
use crate::element::solid8::{Elastic, Kinematics, Solid8};
use crate::element::{reference_mass, reference_stiffness};
use crate::model::Builder;

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
            builder.element(
                "solid",
                Solid8::new(nodes, positions, material, Kinematics::Linear).unwrap(),
            );
        }
        builder.hold(3, Dof::Uy);
        let model = builder.build().unwrap();
        assert!(model.elements().len() >= HALVED);
        let assembler = Assembler::new(&model);
        let (stiffness, mass) = assembler.stiffness_and_mass(&model).unwrap();
        assert_eq!(stiffness, assembler.stiffness(&model).unwrap());
        assert_eq!(mass, assembler.mass(&model));
        let x: Vec<f64> = (0..model.dofs().len())
            .map(|i| ((i * 7919) % 101) as f64 - 50.0)
            .collect();
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
