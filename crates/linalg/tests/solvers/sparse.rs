use linalg::{Cholesky, Matrix, SparseCholesky, Triplets};

/// Five-point Laplacian on a 30 × 20 grid: the sparse factor must agree with the dense factor.
#[test]
fn agrees_with_the_dense_factor() {
    let (nx, ny) = (30, 20);
    let mut a = Triplets::new(nx * ny);
    for y in 0..ny {
        for x in 0..nx {
            let i = x + y * nx;
            a.add(i, i, 2.0);
            a.add(i, i, 2.0 + 0.01 * x as f64);
            if x > 0 {
                a.add(i, i - 1, -1.0);
            }
            if y > 0 {
                a.add(i, i - nx, -1.0);
                a.add(i - nx, i, -1.0);
            }
        }
    }
    let mut b = Matrix::zeros(nx * ny, 3);
    for (i, value) in b.data.iter_mut().enumerate() {
        *value = ((i * 7919) % 101) as f64 - 50.0;
    }
    let mut reference = b.clone();
    Cholesky::factor(&a.to_dense()).unwrap().solve(&mut reference);
    SparseCholesky::factor(&a).unwrap().solve(&mut b).unwrap();
    let scale = reference.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    for (found, expected) in b.data.iter().zip(&reference.data) {
        assert!((found - expected).abs() < 1e-11 * scale);
    }
}

#[test]
fn singular_is_rejected() {
    let mut a = Triplets::new(2);
    for (i, j, v) in [(0, 0, 1.0), (1, 0, -1.0), (1, 1, 1.0)] {
        a.add(i, j, v);
    }
    assert!(SparseCholesky::factor(&a).is_err());
}
