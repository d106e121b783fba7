use std::sync::Arc;

use super::Box3;
use linalg::{Inertia, Kind, LinalgError, Matrix, Ordering, Symbolic, Symmetric};

fn right(size: usize, columns: usize) -> Matrix {
    let mut b = Matrix::zeros(size, columns);
    for (i, v) in b.data.iter_mut().enumerate() {
        *v = ((i * 7919) % 101) as f64 - 50.0;
    }
    b
}

/// Largest ‖b − A x‖∞ over ‖b‖∞.
fn misfit(a: &Symmetric, x: &Matrix, b: &Matrix) -> f64 {
    let product = a.times_block(x);
    let largest = |v: &[f64]| v.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let rest: Vec<f64> = product.data.iter().zip(&b.data).map(|(p, b)| p - b).collect();
    largest(&rest) / largest(&b.data)
}

#[test]
fn dissection_is_a_bijection_and_saves_operations() {
    let model = Box3::new([14, 13, 12], 3);
    let pattern = &model.stiffness.pattern;
    let mut flops = Vec::new();
    for ordering in [
        Ordering::dissection(pattern, &model.node_of, &model.coordinates),
        Ordering::best(pattern, &model.node_of, &model.coordinates),
        Ordering::minimum_degree_of_nodes(pattern, &model.node_of).unwrap(),
    ] {
        let Ordering::Given(order) = &ordering else { panic!("an order is given") };
        assert!(Ordering::is_bijection(order, pattern.size()));
        flops.push(Symbolic::new(pattern.clone(), &ordering).unwrap().flops());
    }
    // The better of the two is used. Nested dissection wins on every grid of this size (George 1973).
    assert!(flops[0] < flops[2], "{flops:?}");
    assert_eq!(flops[1], flops[0]);
}

/// Nodes with equal positions, and disconnected parts.
#[test]
fn dissection_survives_coinciding_and_separate_nodes() {
    let model = Box3::new([6, 5, 4], 2);
    let pattern = &model.stiffness.pattern;
    let nodes = model.coordinates.len();
    for coordinates in [vec![[1.0, 2.0, 3.0]; nodes], model.coordinates.clone()] {
        let Ordering::Given(order) = Ordering::dissection(pattern, &model.node_of, &coordinates) else {
            panic!("an order is given")
        };
        assert!(Ordering::is_bijection(&order, pattern.size()));
    }
}

#[test]
fn bad_orders_are_rejected() {
    let model = Box3::new([3, 3, 3], 1);
    for order in [vec![0; 27], (0..26).collect(), (1..28).collect()] {
        let found = Symbolic::new(model.stiffness.pattern.clone(), &Ordering::Given(order));
        assert!(matches!(found, Err(LinalgError::Order { size: 27 })));
    }
}

#[test]
fn kinds_of_factors_solve_the_same_system() {
    let model = Box3::new([9, 8, 7], 2);
    let symbolic = model.symbolic();
    let b = right(symbolic.pattern().size(), 5);
    for kind in [Kind::Definite, Kind::QuasiDefinite, Kind::Indefinite] {
        let factor = symbolic.factor(&model.stiffness, kind).unwrap();
        let mut x = b.clone();
        factor.solve(&mut x).unwrap();
        // The condition number is below 4·12/(3·0.1) = 160.
        assert!(misfit(&model.stiffness, &x, &b) < 1e-13, "{kind:?}");
        assert_eq!(factor.inertia().negative, 0);
        // A narrower solve reuses the space of the first.
        let narrow = factor.solve_vector(b.column(2)).unwrap();
        for (n, w) in narrow.iter().zip(x.column(2)) {
            assert!((n - w).abs() < 1e-11 * w.abs().max(1.0));
        }
    }
}

/// The inertia of K − σ M counts the known eigenvalues below σ, small (without supernodes) and large.
#[test]
fn inertia_counts_eigenvalues() {
    for n in [[4, 3, 2], [11, 10, 9]] {
        let model = Box3::new(n, 1);
        let exact = model.exact();
        let symbolic = model.symbolic();
        for sigma in [0.5, 2.05, 6.1, 9.05, 13.0] {
            let mut shifted = model.stiffness.clone();
            shifted.add(-sigma, &model.mass);
            let factor = symbolic.factor(&shifted, Kind::Indefinite).unwrap();
            let negative = exact.iter().filter(|&&l| l < sigma).count();
            let expected = Inertia { positive: exact.len() - negative, negative };
            assert_eq!(factor.inertia(), expected, "{n:?} {sigma}");
            let b = right(exact.len(), 2);
            let mut x = b.clone();
            factor.solve(&mut x).unwrap();
            let rest = misfit(&shifted, &x, &b);
            // The shift is at least 1e-3 from every eigenvalue: ‖A⁻¹‖ ‖A‖ ε is about 1e-12.
            assert!(rest < 1e-9, "{rest}");
        }
    }
}

/// Zero diagonals, which no factor without pivots of two rows can pass, as Lagrange multipliers have them: both unknowns of a
/// node are in one supernode.
#[test]
fn indefinite_factor_passes_zero_diagonals() {
    let model = Box3::new([6, 6, 6], 2);
    let mut a = model.stiffness.clone();
    let pattern = a.pattern.clone();
    for j in (0..a.size()).step_by(2) {
        a.values[pattern.starts[j]] = 0.0;
        a.values[pattern.starts[j + 1]] = 0.0;
        a.values[pattern.place(j + 1, j).unwrap()] = 8.0;
    }
    // Eigenvalues ±8 + (−2 Σ cos) with |2 Σ cos| < 6: as many positive as negative ones, none within 2 of zero.
    let factor = model.symbolic().factor(&a, Kind::Indefinite).unwrap();
    assert_eq!(factor.inertia(), Inertia { positive: 216, negative: 216 });
    let b = right(a.size(), 1);
    let mut x = b.clone();
    factor.solve(&mut x).unwrap();
    assert!(misfit(&a, &x, &b) < 1e-13);
}

#[test]
fn matrices_that_are_not_definite_are_rejected() {
    let model = Box3::new([8, 8, 8], 1);
    let symbolic = model.symbolic();
    let mut shifted = model.stiffness.clone();
    shifted.add(-1.0, &model.mass);
    assert!(matches!(
        symbolic.factor(&shifted, Kind::Definite),
        Err(LinalgError::NotPositiveDefinite { size: 512, .. })
    ));
    let zero = Symmetric::zeros(model.stiffness.pattern.clone());
    for kind in [Kind::Definite, Kind::QuasiDefinite, Kind::Indefinite] {
        assert!(symbolic.factor(&zero, kind).is_err(), "{kind:?}");
    }
}

/// One symbolic phase and one memory serve the matrices of a whole run.
#[test]
fn refactoring_replaces_the_values() {
    let model = Box3::new([7, 6, 5], 3);
    let symbolic = model.symbolic();
    let mut factor = symbolic.factor(&model.stiffness, Kind::Definite).unwrap();
    let mut other = model.stiffness.clone();
    other.add(3.0, &model.mass);
    factor.refactor(&other).unwrap();
    let b = right(factor.size(), 1);
    let mut x = b.clone();
    factor.solve(&mut x).unwrap();
    assert!(misfit(&other, &x, &b) < 1e-13);
    assert!(Arc::ptr_eq(factor.symbolic(), &symbolic));
}
