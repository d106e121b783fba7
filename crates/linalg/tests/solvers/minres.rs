use linalg::{Matrix, gmres, minres};

/// An indefinite matrix with known solution, with and without a preconditioner; as many steps as there are different
/// eigenvalues.
#[test]
fn indefinite_systems() {
    let n = 40;
    let mut a = Matrix::zeros(n, n);
    for i in 0..n {
        a.add(i, i, if i < 3 { -2.0 - i as f64 } else { 1.0 + (i % 5) as f64 });
        if i > 0 {
            a.add(i, i - 1, 0.1);
            a.add(i - 1, i, 0.1);
        }
    }
    let exact: Vec<f64> = (0..n).map(|i| (0.7 * i as f64).sin()).collect();
    let b = a.times(&exact);
    for scaled in [false, true] {
        let mut x = vec![0.0; n];
        let found = minres(
            &mut |x, y| y.copy_from_slice(&a.times(x)),
            &mut |r, z| {
                for i in 0..n {
                    z[i] = if scaled { r[i] / a.get(i, i).abs() } else { r[i] };
                }
                Ok(())
            },
            &b,
            &mut x,
            1e-13,
            200,
        )
        .unwrap();
        assert!(found.residual <= 1e-13, "{found:?}");
        for (a, b) in x.iter().zip(&exact) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }
    // Three different eigenvalues: three steps.
    let mut x = vec![0.0; 9];
    let b = vec![1.0; 9];
    let found = minres(
        &mut |x, y| (0..9).for_each(|i| y[i] = [1.0, -2.0, 3.0][i % 3] * x[i]),
        &mut |r, z| {
            z.copy_from_slice(r);
            Ok(())
        },
        &b,
        &mut x,
        1e-12,
        100,
    )
    .unwrap();
    assert_eq!(found.count, 3);
    assert!((x[1] + 0.5).abs() < 1e-12);
}

/// An indefinite matrix with an indefinite preconditioner from which it differs in two unknowns: P⁻¹ A has three different eigenvalues, and
/// three products solve, 1 and those of two ranks. A limit of one product leaves what the best multiple of P⁻¹ b leaves.
#[test]
fn indefinite_preconditioners() {
    let n = 30;
    let p: Vec<f64> = (0..n).map(|i| if i % 4 == 0 { -1.0 } else { 2.0 + i as f64 }).collect();
    let change = |i: usize| [(3, 5.0), (8, -0.4)].iter().find(|(k, _)| *k == i).map_or(0.0, |(_, c)| *c);
    let b: Vec<f64> = (0..n).map(|i| (0.9 * i as f64).cos()).collect();
    let solve = |limit: usize| {
        let mut x = vec![0.0; n];
        let found = gmres(
            &mut |x, y| (0..n).for_each(|i| y[i] = (p[i] + change(i)) * x[i]),
            &mut |r, z| {
                (0..n).for_each(|i| z[i] = r[i] / p[i]);
                Ok(())
            },
            &b,
            &mut x,
            1e-12,
            limit,
        )
        .unwrap();
        (x, found)
    };
    let (x, found) = solve(10);
    assert!(found.count == 3 && found.residual < 1e-12, "{found:?}");
    for (i, x) in x.iter().enumerate() {
        assert!((x - b[i] / (p[i] + change(i))).abs() < 1e-12);
    }
    let (x, found) = solve(1);
    let image: Vec<f64> = (0..n).map(|i| (p[i] + change(i)) * b[i] / p[i]).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let best = dot(&b, &image) / dot(&image, &image);
    assert!((x[1] - best * b[1] / p[1]).abs() < 1e-12 && found.residual < 1.0);
}
