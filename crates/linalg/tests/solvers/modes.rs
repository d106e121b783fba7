use super::Box3;
use linalg::{LinalgError, Search, Sparse, dot, modes};

/// A cube has eigenvalues of multiplicity 3 and 6.
#[test]
fn lowest_modes_with_multiplicities() {
    let model = Box3::new([10, 10, 10], 1);
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    let exact = model.exact();
    for count in [1, 2, 17, 40] {
        let found = modes(&pencil, &Search::lowest(count)).unwrap();
        assert_eq!(found.lambda.len(), count);
        let (from, to) = found.complete_in.unwrap();
        assert!(from == f64::NEG_INFINITY && to > exact[count - 1]);
        for (f, e) in found.lambda.iter().zip(&exact) {
            assert!((f / e - 1.0).abs() < 1e-10, "{count}: {f} {e}");
        }
        for i in 0..count {
            for j in 0..=i {
                let product = dot(found.vectors.column(i), found.vectors.column(j));
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-8);
            }
        }
    }
}

/// A block of one vector first finds one mode of a multiple eigenvalue; the count detects the others.
#[test]
fn inertia_reveals_missed_modes() {
    let model = Box3::new([7, 7, 7], 1);
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    let search = Search { block: 1, ..Search::lowest(10) };
    let found = modes(&pencil, &search).unwrap();
    for (f, e) in found.lambda.iter().zip(&model.exact()) {
        assert!((f / e - 1.0).abs() < 1e-9, "{f} {e}");
    }
}

#[test]
fn modes_around_a_frequency() {
    let model = Box3::new([9, 8, 7], 1);
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    let exact = model.exact();
    let omega = 2.0_f64;
    let found = modes(&pencil, &Search::around(omega, 9)).unwrap();
    let mut nearest = exact.clone();
    nearest.sort_by(|a, b| (a - 4.0).abs().total_cmp(&(b - 4.0).abs()));
    nearest.truncate(9);
    nearest.sort_by(f64::total_cmp);
    for (f, e) in found.lambda.iter().zip(&nearest) {
        assert!((f / e - 1.0).abs() < 1e-10, "{f} {e}");
    }
}

/// Nearly all modes: the basis fills the space, and restarts come before that.
#[test]
fn all_modes_of_a_small_system() {
    let model = Box3::new([4, 3, 2], 1);
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    for count in [20, 24, 30] {
        let found = modes(&pencil, &Search::lowest(count)).unwrap();
        assert_eq!(found.lambda.len(), count.min(24));
        for (f, e) in found.lambda.iter().zip(&model.exact()) {
            assert!((f / e - 1.0).abs() < 1e-10, "{f} {e}");
        }
    }
}

/// Unknowns without mass have no modes: those of the rest with the massless part condensed.
#[test]
fn mass_may_be_semidefinite() {
    let mut model = Box3::new([6, 5, 4], 1);
    let massless: Vec<usize> = (0..120).filter(|i| i % 3 == 1).collect();
    for &i in &massless {
        model.mass.values[model.mass.pattern.starts[i]] = 0.0;
    }
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    // Reference: the dense solver.
    let dense = linalg::generalized_eigen(&model.stiffness.to_dense(), &model.mass.to_dense(), Some(12)).unwrap();
    let found = modes(&pencil, &Search::lowest(12)).unwrap();
    for (f, e) in found.omega().iter().zip(&dense.omega) {
        assert!((f / e - 1.0).abs() < 1e-9, "{f} {e}");
    }
    let all = modes(&pencil, &Search::lowest(119)).unwrap();
    assert_eq!(all.lambda.len(), 80);
}

/// A free body has eigenvalue zero: without a shift the factorisation fails, with one the mode is found.
#[test]
fn singular_stiffness_needs_a_shift() {
    let mut model = Box3::new([6, 6, 6], 1);
    // Free ends: the rows of the Laplacian sum to zero.
    let sums = model.stiffness.times(&[1.0; 216]);
    for (j, s) in sums.iter().enumerate() {
        model.stiffness.values[model.stiffness.pattern.starts[j]] -= s;
    }
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    let search = Search { shift: 0.1, ..Search::lowest(4) };
    let found = modes(&pencil, &search).unwrap();
    // 4 sin²(π/12) = 2 − √3, three times.
    let first = 2.0 - 3.0_f64.sqrt();
    for (f, e) in found.lambda.iter().zip([0.0, first, first, first]) {
        assert!((f - e).abs() < 1e-10, "{f} {e}");
    }
}

#[test]
fn indefinite_stiffness_is_rejected() {
    let mut model = Box3::new([6, 6, 6], 1);
    model.stiffness.values.iter_mut().for_each(|v| *v = -*v);
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    assert!(matches!(modes(&pencil, &Search::lowest(3)), Err(LinalgError::NotPositiveDefinite { .. })));
}

/// Soft and 10¹⁰ times stiffer copies side by side: the soft modes keep their digits.
#[test]
fn low_modes_survive_a_stiff_neighbour() {
    let mut model = Box3::new([8, 7, 6], 2);
    let pattern = model.stiffness.pattern.clone();
    for j in (1..pattern.size()).step_by(2) {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            model.stiffness.values[p] *= 1e10;
        }
    }
    let pencil = Sparse::new(&model.stiffness, &model.mass, model.symbolic());
    let found = modes(&pencil, &Search::lowest(8)).unwrap();
    for (f, e) in found.lambda.iter().zip(&model.exact()) {
        assert!((f / e - 1.0).abs() < 1e-10, "{f} {e}");
    }
}
