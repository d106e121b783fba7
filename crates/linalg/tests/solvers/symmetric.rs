use std::sync::Arc;

use linalg::{Pattern, Symmetric};

#[test]
fn cliques_make_the_pattern_and_the_product_is_the_dense_one() {
    let cliques: [&[usize]; 3] = [&[0, 2], &[2, 1, 3], &[3, 0]];
    let pattern = Arc::new(Pattern::from_cliques(5, cliques.into_iter()));
    assert_eq!(pattern.rows, vec![0, 2, 3, 1, 2, 3, 2, 3, 3, 4]);
    let mut a = Symmetric::zeros(pattern);
    for (k, v) in a.values.iter_mut().enumerate() {
        *v = (k as f64 + 1.0).sin();
    }
    let x = [1.0, -2.0, 0.5, 3.0, 7.0];
    let expected = a.to_dense().times(&x);
    for (f, e) in a.times(&x).iter().zip(&expected) {
        assert!((f - e).abs() < 1e-14);
    }
    let sub = a.submatrix(&[0, 2, 3]);
    assert_eq!(sub.get(2, 0), a.get(3, 0));
    assert_eq!(a.block(&[0, 1], &[2, 3]).len(), 4);
}
