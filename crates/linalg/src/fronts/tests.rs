//! A factor of which some unknowns stay, against that of the whole.

use super::*;
use crate::{Kind, Ordering};

/// A chain of blocks with a coupling of everything to the last unknowns.
fn matrix(size: usize, eliminated: usize) -> Symmetric {
    let mut cliques: Vec<Vec<usize>> = (0..size - 2).map(|i| vec![i, i + 1, i + 2]).collect();
    cliques.push((eliminated - 3..size).collect());
    cliques.push((eliminated..size).chain([0, 5]).collect());
    let pattern = Arc::new(Pattern::from_cliques(size, cliques.iter().map(Vec::as_slice)));
    let mut a = Symmetric::zeros(pattern.clone());
    for j in 0..size {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let i = pattern.rows[p];
            a.values[p] = if i == j { 40.0 + (j as f64).sin() } else { ((3 * i + 7 * j) as f64).cos() };
        }
    }
    a
}

/// A grid of `n` by `n` unknowns in the order of a dissection by halves, the last separator and a dense block behind it.
fn grid(n: usize) -> (Symmetric, usize) {
    fn dissect(x: std::ops::Range<usize>, y: std::ops::Range<usize>, n: usize, order: &mut Vec<usize>) {
        if x.len() * y.len() <= 4 {
            order.extend(x.flat_map(|i| y.clone().map(move |j| i * n + j)));
        } else if x.len() >= y.len() {
            let middle = (x.start + x.end) / 2;
            dissect(x.start..middle, y.clone(), n, order);
            dissect(middle + 1..x.end, y.clone(), n, order);
            order.extend(y.map(|j| middle * n + j));
        } else {
            let middle = (y.start + y.end) / 2;
            dissect(x.clone(), y.start..middle, n, order);
            dissect(x.clone(), middle + 1..y.end, n, order);
            order.extend(x.map(|i| i * n + middle));
        }
    }
    let mut order = Vec::new();
    dissect(0..n, 0..n, n, &mut order);
    let mut at = vec![0; n * n];
    order.iter().enumerate().for_each(|(k, &i)| at[i] = k);
    let (eliminated, size) = (n * n, n * n + n);
    let mut cliques: Vec<Vec<usize>> = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let near = [(i + 1, j), (i, j + 1), (i + 1, j + 1)];
            let near = near.iter().filter(|(a, b)| *a < n && *b < n).map(|(a, b)| at[a * n + b]);
            cliques.push(std::iter::once(at[i * n + j]).chain(near).collect());
        }
        cliques.push(vec![at[i * n], eliminated + i]);
    }
    cliques.push((eliminated..size).collect());
    cliques.iter_mut().for_each(|c| c.sort_unstable());
    let pattern = Arc::new(Pattern::from_cliques(size, cliques.iter().map(Vec::as_slice)));
    let mut a = Symmetric::zeros(pattern.clone());
    for j in 0..size {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            let i = pattern.rows[p];
            a.values[p] = match (i == j, j < eliminated) {
                (true, true) => 9.0 + (j as f64).sin(),
                // A block that is not definite: quasi-definite with the first.
                (true, false) => -50.0,
                _ => ((3 * i + 7 * j) as f64).cos(),
            };
        }
    }
    (a, eliminated)
}

/// x = A⁻¹ b by eliminating the first unknowns, solving densely for the others and going back.
fn by_parts(fronts: &mut Fronts, a: &Symmetric, eliminated: usize, b: &[f64], threads: usize) -> Vec<f64> {
    let size = a.size();
    let c = fronts.factor(a, threads).unwrap();
    let mut x = b.to_vec();
    fronts.forward(&mut x, threads);
    let left = size - eliminated;
    if left > 0 {
        let all: Vec<usize> = (0..left).collect();
        let pattern = Arc::new(Pattern::from_cliques(left, std::iter::once(all.as_slice())));
        let mut s = Symmetric::zeros(pattern.clone());
        for j in 0..left {
            for i in j..left {
                let value = a.get(eliminated + i, eliminated + j) + c.get(i, j);
                s.values[pattern.place(i, j).unwrap()] = value;
            }
        }
        let symbolic = Arc::new(Symbolic::new(pattern, &Ordering::Given(all)).unwrap());
        let last = symbolic.factor(&s, Kind::QuasiDefinite).unwrap();
        let solved = last.solve_vector(&x[eliminated..]).unwrap();
        x[eliminated..].copy_from_slice(&solved);
    }
    fronts.backward(&mut x, threads);
    x
}

fn whole(a: &Symmetric, b: &[f64]) -> Vec<f64> {
    let symbolic = Arc::new(Symbolic::new(a.pattern.clone(), &Ordering::MinimumDegree).unwrap());
    symbolic.factor(a, Kind::QuasiDefinite).unwrap().solve_vector(b).unwrap()
}

fn load(size: usize) -> Vec<f64> {
    (0..size).map(|i| (1.7 * i as f64).sin()).collect()
}

fn far(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / size
}

/// Eliminating some unknowns or all, solving for the others and going back is solving the whole: rounding alone. The second time into the
/// same memory.
#[test]
fn substructure_is_the_whole() {
    let (size, kept) = (60, 47);
    let a = matrix(size, kept);
    let expected = whole(&a, &load(size));
    for eliminated in [kept, size, 20] {
        let mut fronts = Fronts::new(&a.pattern, eliminated, Keep::Double).unwrap();
        for _ in 0..2 {
            let x = by_parts(&mut fronts, &a, eliminated, &load(size), 1);
            assert!(far(&x, &expected) < 1e-14, "{eliminated}");
        }
    }
}

/// A tree with two bundles and fronts of more than one block of columns: the same as the whole, and the same bits on one thread and on two.
/// Condition below 100, 14 000 unknowns: 1e-12 for rounding.
#[test]
fn bundles_have_the_same_bits() {
    let (a, eliminated) = grid(120);
    let b = load(a.size());
    let expected = whole(&a, &b);
    let mut fronts = Fronts::new(&a.pattern, eliminated, Keep::Double).unwrap();
    assert!(fronts.tree.bundles.iter().all(|b| b.len() > 100), "two bundles");
    let one = by_parts(&mut fronts, &a, eliminated, &b, 1);
    assert!(far(&one, &expected) < 1e-12, "{}", far(&one, &expected));
    let two = by_parts(&mut fronts, &a, eliminated, &b, 2);
    assert!(one.iter().zip(&two).all(|(a, b)| a.to_bits() == b.to_bits()));
}

/// In single precision: errors of some 6e-8, a hundred times of which is allowed for the condition.
#[test]
fn single_precision_is_near() {
    let (a, eliminated) = grid(40);
    let b = load(a.size());
    let expected = whole(&a, &b);
    let mut fronts = Fronts::new(&a.pattern, eliminated, Keep::Single).unwrap();
    let x = by_parts(&mut fronts, &a, eliminated, &b, 1);
    let error = far(&x, &expected);
    assert!(error < 6e-6 && error > 1e-12, "{error}");
}

/// A pivot that is zero or NaN is an error, after which solving does nothing.
#[test]
fn singular_is_an_error() {
    for value in [0.0, f64::NAN] {
        let mut a = matrix(60, 60 - 5);
        for p in 0..a.values.len() {
            a.values[p] = if value == 0.0 { 0.0 } else { a.values[p] };
        }
        a.values[40] *= value;
        let mut fronts = Fronts::new(&a.pattern, 55, Keep::Double).unwrap();
        assert!(matches!(fronts.factor(&a, 1), Err(LinalgError::Singular { size: 60 })));
        let mut b = load(60);
        fronts.forward(&mut b, 1);
        assert_eq!(b, load(60));
    }
}
