//! Direct integration against closed relations, other forms of the same scheme and single oscillators.

use std::sync::Arc;

use oscillator::newmark::Newmark;

use super::*;
use crate::analysis::damping::{Damping, Rayleigh};
use crate::analysis::statics::Statics;
use crate::linalg::{Matrix, Ordering, Pattern, Symmetric, generalized_eigen};
use crate::progress::Silent;

/// Chain of n masses and springs on the ground, which vary along it; moves along x.
fn chain(n: usize) -> System {
    let cliques: Vec<Vec<usize>> = (0..n.max(2) - 1).map(|i| vec![i, (i + 1).min(n - 1)]).collect();
    let pattern = Arc::new(Pattern::from_cliques(n, cliques.iter().map(Vec::as_slice)));
    let (mut m, mut k) = (Symmetric::zeros(pattern.clone()), Symmetric::zeros(pattern.clone()));
    let put = |a: &mut Symmetric, i: usize, j: usize, v: f64| {
        let place = pattern.place(i, j).expect("neighbours are in the pattern");
        a.values[place] += v;
    };
    for i in 0..n {
        let (mass, spring) = (2.0 + (i as f64).sin(), 400.0 + 100.0 * (1.3 * i as f64).cos());
        put(&mut m, i, i, mass);
        put(&mut k, i, i, spring);
        if i > 0 {
            put(&mut m, i, i - 1, 0.2);
            put(&mut k, i, i - 1, -spring);
            put(&mut k, i - 1, i - 1, spring);
        }
    }
    System::from_matrices(m, k, [vec![1.0; n], vec![0.0; n], vec![0.0; n]])
}

fn symbolic(system: &System) -> Arc<Symbolic> {
    Arc::new(Symbolic::new(system.mass.pattern.clone(), &Ordering::MinimumDegree).unwrap())
}

/// A record that begins and ends with a jump.
fn record(samples: usize, phase: f64) -> Vec<f64> {
    (0..samples)
        .map(|k| {
            let t = k as f64;
            (0.31 * t + phase).sin() + 0.5 * (0.83 * t + 2.0 * phase).cos()
        })
        .collect()
}

fn displacement(i: usize) -> Observable {
    Observable { displacement: vec![(i, 1.0)], ..Observable::default() }
}

fn dampings(system: &System) -> Vec<Damping> {
    let eigen = generalized_eigen(&system.stiffness.to_dense(), &system.mass.to_dense(), None).unwrap();
    let rayleigh = Rayleigh { mass: 0.3, stiffness: 0.002 };
    let mut dashpot = Symmetric::zeros(system.mass.pattern.clone());
    let place = dashpot.pattern.place(2, 2).unwrap();
    dashpot.values[place] = 7.0;
    let mut mixed = Damping::modal(&system.mass, &eigen, &[0.05, 0.02, 0.3], rayleigh).unwrap();
    mixed.add_sparse(dashpot.clone());
    vec![
        Damping::none(),
        Damping::rayleigh(rayleigh),
        Damping { sparse: Some(dashpot), ..Damping::default() },
        Damping::modal(&system.mass, &eigen, &[0.05, 0.02, 0.3], Rayleigh::NONE).unwrap(),
        mixed,
    ]
}

fn dense_times(a: &Matrix, x: &[f64]) -> nalgebra::DVector<f64> {
    nalgebra::DVector::from_vec(a.times(x))
}

/// The displacement form as the dissertation writes it, (3.7) and (3.8), with dense matrices and all products formed:
/// [K + M/(β h²) + γ/(β h) C] u₁ = P₁ + M(…) + C(…).
fn dissertation(system: &System, beta: f64, gamma: f64, h: f64, force: &[f64], steps: usize) -> Vec<Vec<f64>> {
    let n = system.size();
    let (m, k) = (system.mass.to_dense(), system.stiffness.to_dense());
    let mut c = Matrix::zeros(n, n);
    for j in 0..n {
        let unit: Vec<f64> = (0..n).map(|i| f64::from(i == j)).collect();
        let column = system.damping.times(&system.mass, &system.stiffness, &unit);
        c.column_mut(j).copy_from_slice(&column);
    }
    let effective = nalgebra::DMatrix::from_fn(n, n, |i, j| {
        k.get(i, j) + m.get(i, j) / (beta * h * h) + gamma / (beta * h) * c.get(i, j)
    });
    let lu = effective.lu();
    let (mut u, mut v) = (vec![0.0; n], vec![0.0; n]);
    let mass = nalgebra::DMatrix::from_fn(n, n, |i, j| m.get(i, j));
    let mut a = (mass.lu().solve(&(nalgebra::DVector::from_vec(system.inertia[0].clone()) * -force[0])))
        .unwrap()
        .as_slice()
        .to_vec();
    let mut out = vec![u.clone()];
    for step in 1..=steps {
        let on_m: Vec<f64> = (0..n)
            .map(|i| u[i] / (beta * h * h) + v[i] / (beta * h) + (1.0 - 2.0 * beta) / (2.0 * beta) * a[i])
            .collect();
        let on_c: Vec<f64> = (0..n)
            .map(|i| {
                gamma / (beta * h) * u[i]
                    + (gamma - beta) / beta * v[i]
                    + (gamma - 2.0 * beta) / (2.0 * beta) * h * a[i]
            })
            .collect();
        let p = nalgebra::DVector::from_vec(system.inertia[0].clone()) * -force[step];
        let u1 = lu.solve(&(p + dense_times(&m, &on_m) + dense_times(&c, &on_c))).unwrap();
        for i in 0..n {
            let a1 = (u1[i] - u[i]) / (beta * h * h) - v[i] / (beta * h) - (1.0 - 2.0 * beta) / (2.0 * beta) * a[i];
            v[i] += h * ((1.0 - gamma) * a[i] + gamma * a1);
            (u[i], a[i]) = (u1[i], a1);
        }
        out.push(u.clone());
    }
    out
}

#[test]
fn newmark_is_the_dissertations() {
    let plain = chain(6);
    let grid = Grid::new(0.05, 2.0, 0.0, 0.05);
    let ground = record(grid.samples, 0.4);
    for damping in dampings(&plain) {
        for (beta, gamma) in [(0.25, 0.5), (1.0 / 6.0, 0.5), (0.3025, 0.6)] {
            let system = plain.clone().with_damping(damping.clone());
            let mut settings = Settings::new(grid);
            settings.scheme = TimeScheme::Newmark { beta, gamma };
            let load = Load::ground(0, Motion::sampled(0.05, &ground, &grid));
            let rows: Vec<Observable> = (0..6).map(displacement).collect();
            let symbolic = symbolic(&system);
            let found = integrate(&system, &symbolic, &[load], &settings, &rows, &[], &Silent).unwrap();
            let expected = dissertation(&system, beta, gamma, 0.05, &ground, grid.samples - 1);
            for (i, history) in found[0].observed.scalars.iter().enumerate() {
                for (k, value) in history.values.iter().enumerate() {
                    // The start of the acceleration is refined to (1e-6 h² ω²/4)², all else is rounding.
                    assert!((value - expected[k][i]).abs() < 1e-12, "{beta} {i} {k}: {value} {}", expected[k][i]);
                }
            }
            assert!(found[0].complete && found[0].residual < 1e-13);
        }
    }
}

/// The trapezoidal rule closes the balance to rounding, whatever the damping and the step, with jumps in the loads, forces
/// and initial states.
#[test]
fn energy_balance_closes() {
    let plain = chain(8);
    let grid = Grid::new(0.04, 4.0, 2.0, 0.02);
    let ground = Motion::sampled(0.04, &record(101, 0.7), &grid);
    let push = Motion::sampled(0.04, &record(60, 1.9), &grid);
    let load =
        Load { ground: [Some(ground), None, None], forces: vec![((0..8).map(|i| f64::from(i) - 2.0).collect(), push)] };
    for damping in dampings(&plain) {
        let system = plain.clone().with_damping(damping);
        let symbolic = symbolic(&system);
        let mut settings = Settings::new(grid);
        settings.initial = Some((vec![0.01; 8], vec![-0.2; 8]));
        settings.constant = Some(vec![0.3; 8]);
        let found = integrate(&system, &symbolic, std::slice::from_ref(&load), &settings, &[], &[], &Silent).unwrap();
        let energy = &found[0].energy;
        assert_eq!(energy.input.len(), grid.samples);
        assert!(energy.error() < 1e-10, "{}", energy.error());
        assert!(energy.damping.windows(2).all(|w| w[1] >= w[0] - 1e-12));
        // A dissipative scheme loses energy and shows it.
        settings.scheme = TimeScheme::GeneralizedAlpha { radius: 0.5 };
        let lossy = integrate(&system, &symbolic, std::slice::from_ref(&load), &settings, &[], &[], &Silent).unwrap();
        assert!(lossy[0].energy.error() > 1e-4, "{}", lossy[0].energy.error());
    }
}

/// Eleven records with one factor give the same results as each alone.
#[test]
fn records_do_not_see_each_other() {
    let system = chain(7);
    let grid = Grid::new(0.03, 1.5, 0.3, 0.015);
    let loads: Vec<Load> =
        (0..11).map(|r| Load::ground(0, Motion::sampled(0.03, &record(40 + r, r as f64), &grid))).collect();
    for damping in dampings(&system) {
        let system = system.clone().with_damping(damping);
        let (symbolic, rows) = (symbolic(&system), [displacement(6)]);
        let mut settings = Settings::new(grid);
        settings.snapshots = vec![SnapshotAt::Peak(0), SnapshotAt::Time(0.6)];
        let run = |loads: &[Load]| integrate(&system, &symbolic, loads, &settings, &rows, &rows, &Silent).unwrap();
        for (together, load) in run(&loads).iter().zip(&loads) {
            let alone = &run(std::slice::from_ref(load))[0];
            for (a, b) in together.u.iter().zip(&alone.u) {
                assert!((a - b).abs() < 1e-13);
            }
            let (a, b) = (&together.observed, &alone.observed);
            assert!((a.scalars[0].extreme.max - b.scalars[0].extreme.max).abs() < 1e-13);
            assert_eq!(a.extremes[0], a.scalars[0].extreme);
            assert_eq!(together.snapshots.len(), 2);
            assert!((together.snapshots[1].time - 0.6).abs() < 1e-9);
            // The peak between the steps exceeds that at them by little.
            let kept = together.snapshots[0].u[6].abs();
            let peak = a.scalars[0].extreme.peak().0;
            assert!(kept <= peak + 1e-12 && kept > 0.97 * peak, "{kept} {peak}");
        }
    }
}

/// Without ground motion a system in equilibrium under its weight stays there (D2).
#[test]
fn equilibrium_stays() {
    let system = chain(9).with_damping(Damping::rayleigh(Rayleigh { mass: 0.1, stiffness: 0.001 }));
    let symbolic = symbolic(&system);
    let weight: Vec<f64> = system.inertia[0].iter().map(|m| -9.81 * m).collect();
    let statics = Statics::new(&symbolic, &system.stiffness, Kind::Definite).unwrap();
    let u = statics.solve(&system.stiffness, &[&weight]).unwrap().remove(0);
    let grid = Grid::new(0.01, 10.0, 0.0, 0.01);
    let mut settings = Settings::new(grid);
    settings.initial = Some((u.clone(), vec![0.0; 9]));
    settings.constant = Some(weight);
    let found = integrate(&system, &symbolic, &[Load::default()], &settings, &[], &[], &Silent).unwrap();
    for (a, b) in found[0].u.iter().zip(&u) {
        assert!((a - b).abs() < 1e-9);
    }
}

/// One mass: the generalised-α step is its amplification matrix, and the trapezoidal one that of `codes`.
#[test]
fn one_oscillator() {
    let pattern = Arc::new(Pattern::from_cliques(1, std::iter::once(&[0usize][..])));
    let matrix = |value: f64| Symmetric { pattern: pattern.clone(), values: vec![value] };
    let (omega, damping, h): (f64, f64, f64) = (5.0, 0.03, 0.07);
    let one = || [vec![1.0], vec![0.0], vec![0.0]];
    let system = System::from_matrices(matrix(1.0), matrix(omega * omega), one())
        .with_damping(Damping::rayleigh(Rayleigh::mass_proportional(omega, damping)));
    let grid = Grid::new(h, 40.0 * h, 0.0, h);
    let symbolic = symbolic(&system);
    for scheme in
        [TimeScheme::Hht { alpha: -0.1 }, TimeScheme::GeneralizedAlpha { radius: 0.8 }, TimeScheme::Trapezoidal]
    {
        let mut settings = Settings::new(grid);
        settings.scheme = scheme;
        settings.initial = Some((vec![1.0], vec![0.0]));
        let found = integrate(&system, &symbolic, &[Load::default()], &settings, &[displacement(0)], &[], &Silent);
        let found = found.unwrap().remove(0).observed.scalars.remove(0).values;
        let amplification = scheme.with_step(h).unwrap().amplification(omega * h, damping);
        let mut state = nalgebra::Vector3::new(1.0, 0.0, -omega * omega * h * h);
        let newmark = Newmark::average_acceleration(h);
        let mut oscillator = [1.0, 0.0, -omega * omega];
        for value in found {
            // The initial acceleration of the run is right to (ε ω²)² = 1e-15.
            assert!((value - state[0]).abs() < 1e-13, "{value} {}", state[0]);
            if scheme == TimeScheme::Trapezoidal {
                assert!((value - oscillator[0]).abs() < 1e-13);
            }
            state = amplification * state;
            oscillator = newmark.step(omega, damping, oscillator, 0.0);
        }
    }
}

#[test]
fn stops_when_told_to() {
    use std::sync::atomic::{AtomicU64, Ordering as Order};
    struct Patience(AtomicU64);
    impl Progress for Patience {
        fn stage(&self, _: &str, _: u64) {}
        fn advance(&self, steps: u64) {
            self.0.fetch_add(steps, Order::Relaxed);
        }
        fn interrupted(&self) -> bool {
            self.0.load(Order::Relaxed) >= 64
        }
    }
    let system = chain(5);
    let grid = Grid::new(0.01, 10.0, 0.0, 0.01);
    let load = Load::ground(0, Motion::sampled(0.01, &record(1001, 0.1), &grid));
    let patience = Patience(AtomicU64::new(0));
    let rows = [displacement(4)];
    let settings = Settings::new(grid);
    let found = integrate(&system, &symbolic(&system), &[load], &settings, &rows, &[], &patience).unwrap();
    assert!(!found[0].complete);
    assert!((found[0].time - 0.64).abs() < 1e-12);
    assert_eq!(found[0].observed.scalars[0].values.len(), 65);
    assert_eq!(found[0].energy.input.len(), 65);
}

#[test]
fn bad_input_is_rejected() {
    let system = chain(5);
    let grid = Grid::new(0.01, 0.1, 0.0, 0.01);
    let run = |settings: &Settings, load: Load| {
        integrate(&system, &symbolic(&system), &[load], settings, &[], &[], &Silent).unwrap_err()
    };
    let mut settings = Settings::new(grid);
    settings.constant = Some(vec![0.0; 4]);
    assert!(run(&settings, Load::default()).to_string().contains("4 entries"));
    settings = Settings::new(grid);
    settings.scheme = TimeScheme::Newmark { beta: 0.25, gamma: 0.4 };
    assert!(run(&settings, Load::default()).to_string().contains("γ = 0.4"));
    settings = Settings::new(grid);
    settings.snapshots = vec![SnapshotAt::Peak(0)];
    assert!(run(&settings, Load::default()).to_string().contains("observable 0"));
    let broken = Load::ground(0, Motion::sampled(0.01, &[0.0, f64::NAN, 0.0], &grid));
    assert!(matches!(run(&Settings::new(grid), broken), AnalysisError::NotFinite { .. }));
}
