use linalg::{Cholesky, LinalgError, Matrix, product, transposed_product};

fn example() -> Matrix {
    // Entries of a positive definite 3 × 3 matrix with determinant 44 (by hand: 4·(5·3−1) − 2·(2·3−0)).
    Matrix { rows: 3, cols: 3, data: vec![4.0, 2.0, 0.0, 2.0, 5.0, 1.0, 0.0, 1.0, 3.0] }
}

#[test]
fn solves() {
    let a = example();
    let factor = Cholesky::factor(&a).unwrap();
    let x = factor.solve_vector(&a.times(&[1.0, -2.0, 3.0]));
    for (found, expected) in x.iter().zip([1.0, -2.0, 3.0]) {
        assert!((found - expected).abs() < 1e-14);
    }
}

#[test]
fn half_solves_compose() {
    let a = example();
    let factor = Cholesky::factor(&a).unwrap();
    let mut identity = Matrix::zeros(3, 3);
    (0..3).for_each(|i| identity.add(i, i, 1.0));
    let mut l_inverse = identity.clone();
    factor.half_solve(&mut l_inverse);
    // L⁻¹ A L⁻ᵀ = I
    let mut left = a.clone();
    factor.half_solve(&mut left);
    let both = product(&left, &transposed_product(&l_inverse, &identity));
    for (found, expected) in both.data.iter().zip(&identity.data) {
        assert!((found - expected).abs() < 1e-14);
    }
}

#[test]
fn indefinite_is_rejected() {
    let mut a = example();
    a.add(2, 2, -4.0);
    assert!(matches!(Cholesky::factor(&a), Err(LinalgError::NotPositiveDefinite { pivot: 3, size: 3 })));
    a.add(0, 0, f64::NAN);
    assert!(Cholesky::factor(&a).is_err());
}
