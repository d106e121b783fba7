use linalg::{LinalgError, Matrix, dot, generalized_eigen};

/// Chain of n unit masses and springs, fixed at one end: ω_j = 2 sin((2j−1)π/(2(2n+1))) (Rayleigh 1894).
fn chain(n: usize, stiffness: f64) -> (Matrix, Matrix) {
    let (mut k, mut m) = (Matrix::zeros(n, n), Matrix::zeros(n, n));
    for i in 0..n {
        m.add(i, i, 1.0);
        k.add(i, i, if i + 1 < n { 2.0 * stiffness } else { stiffness });
        if i > 0 {
            k.add(i, i - 1, -stiffness);
            k.add(i - 1, i, -stiffness);
        }
    }
    (k, m)
}

#[test]
fn chain_frequencies() {
    let n = 40;
    let (k, m) = chain(n, 1.0);
    let eigen = generalized_eigen(&k, &m, None).unwrap();
    assert_eq!(eigen.omega.len(), n);
    for (j, omega) in eigen.omega.iter().enumerate() {
        let exact = 2.0 * ((2 * j + 1) as f64 * std::f64::consts::FRAC_PI_2 / (2 * n + 1) as f64).sin();
        assert!((omega / exact - 1.0).abs() < 1e-12, "mode {}: {omega} {exact}", j + 1);
        for i in 0..=j {
            let product = dot(eigen.vectors.column(i), &m.times(eigen.vectors.column(j)));
            assert!((product - f64::from(i == j)).abs() < 1e-11);
        }
    }
}

/// A soft chain and one 10¹² times stiffer: the soft frequencies keep their digits.
#[test]
fn low_modes_survive_a_stiff_neighbour() {
    let n = 20;
    let (soft, unit) = chain(n, 10.0);
    let (stiff, _) = chain(n, 1e13);
    let (mut k, mut m) = (Matrix::zeros(2 * n, 2 * n), Matrix::zeros(2 * n, 2 * n));
    for j in 0..n {
        for i in 0..n {
            k.add(i, j, soft.get(i, j));
            k.add(n + i, n + j, stiff.get(i, j));
            m.add(i, j, unit.get(i, j));
            m.add(n + i, n + j, unit.get(i, j));
        }
        // Weak inertial coupling keeps the two from being solved apart.
        m.add(j, n + j, 0.1);
        m.add(n + j, j, 0.1);
    }
    let eigen = generalized_eigen(&k, &m, Some(5)).unwrap();
    // The stiff chain moves as if held, so the low modes are those of the soft chain alone.
    let alone = generalized_eigen(&soft, &unit, Some(5)).unwrap();
    for (found, expected) in eigen.omega.iter().zip(&alone.omega) {
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    }
}

/// Two chains 10¹⁸ apart in stiffness: the stiff one is beyond double precision and is omitted, not returned
/// wrong.
#[test]
fn modes_beyond_double_precision_are_left_out() {
    let n = 6;
    let (soft, unit) = chain(n, 1.0);
    let (stiff, _) = chain(n, 1e18);
    let (mut k, mut m) = (Matrix::zeros(2 * n, 2 * n), Matrix::zeros(2 * n, 2 * n));
    for j in 0..n {
        for i in 0..n {
            k.add(i, j, soft.get(i, j));
            k.add(n + i, n + j, stiff.get(i, j));
            m.add(i, j, unit.get(i, j));
            m.add(n + i, n + j, unit.get(i, j));
        }
        m.add(j, n + j, 0.3);
        m.add(n + j, j, 0.3);
    }
    let eigen = generalized_eigen(&k, &m, Some(2 * n)).unwrap();
    assert!((n..2 * n).contains(&eigen.omega.len()), "{:?}", eigen.omega);
    let alone = generalized_eigen(&soft, &unit, None).unwrap();
    for (found, expected) in eigen.omega.iter().zip(&alone.omega) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }
}

#[test]
fn indefinite_stiffness_is_rejected() {
    let (k, m) = chain(4, -1.0);
    assert!(matches!(generalized_eigen(&k, &m, None), Err(LinalgError::NotPositiveDefinite { .. })));
}
