//! Time of the parts of a linear analysis: ordering, symbolic phase, factor, solves, 20 modes, assembly. Each checks its
//! answer. `cargo bench -p fem`; numbers in docs/performance.md.

use std::hint::black_box;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use fem::assembly::{Assembler, order};
use fem::linalg::{Kind, Matrix, Search, Sparse, Symbolic, Symmetric, modes};

#[allow(dead_code, reason = "the comparison with peers uses the rest")]
mod models;

/// ‖b − A x‖∞/‖b‖∞ of the first column.
fn misfit(a: &Symmetric, x: &Matrix, b: &Matrix) -> f64 {
    let largest = |v: &mut dyn Iterator<Item = f64>| v.fold(0.0_f64, |m, v| m.max(v.abs()));
    let product = a.times(x.column(0));
    let rest = largest(&mut product.iter().zip(b.column(0)).map(|(p, b)| p - b));
    rest / largest(&mut b.column(0).iter().copied())
}

fn solver(c: &mut Criterion) {
    let bricks = [12, 16, 20];
    let model = models::solid(bricks);
    let assembler = Assembler::new(&model);
    let name = |what: &str| format!("{what}, 12 x 16 x 20 bricks, 3 unknowns a node");
    let pattern = assembler.pattern().clone();
    let ordering = order(&model, &pattern);
    let symbolic = Arc::new(Symbolic::new(pattern.clone(), &ordering).expect("memory"));
    let (k, m) = assembler.stiffness_and_mass(&model).expect("the bricks are regular");

    let mut group = c.benchmark_group("solver");
    group.sample_size(10);
    group.bench_function(name("pattern and places"), |b| b.iter(|| Assembler::new(black_box(&model))));
    group.bench_function(name("assembly of K and M"), |b| {
        b.iter(|| assembler.stiffness_and_mass(black_box(&model)));
    });
    group.bench_function(name("ordering"), |b| b.iter(|| order(&model, black_box(&pattern))));
    group.bench_function(name("symbolic phase"), |b| {
        b.iter(|| Symbolic::new(black_box(pattern.clone()), &ordering));
    });
    group.bench_function(name("LLT factor"), |b| b.iter(|| symbolic.factor(black_box(&k), Kind::Definite)));
    let mut factor = symbolic.factor(&k, Kind::Definite).expect("positive definite");
    group.bench_function(name("LLT factor into the same memory"), |b| b.iter(|| factor.refactor(black_box(&k))));
    for columns in [1, 8] {
        let mut right = Matrix::zeros(k.size(), columns);
        for (i, v) in right.data.iter_mut().enumerate() {
            *v = ((i * 7919) % 101) as f64 - 50.0;
        }
        let mut x = right.clone();
        factor.solve(&mut x).expect("memory");
        assert!(misfit(&k, &x, &right) < 1e-10);
        group.bench_function(name(&format!("solve, {columns} right-hand sides")), |b| {
            b.iter(|| factor.solve(black_box(&mut x)));
        });
    }
    let pencil = Sparse::new(&k, &m, symbolic);
    group.bench_function(name("20 modes with their proof"), |b| {
        b.iter(|| modes(&pencil, &Search::lowest(20)).expect("the checks of every pair hold"));
    });
    group.finish();
}

criterion_group!(benches, solver);
criterion_main!(benches);
