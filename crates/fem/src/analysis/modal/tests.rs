//! Modal superposition against direct integration and its own limits, on a frame that moves along two axes.

use std::sync::Arc;

use super::*;
use crate::analysis::damping::{Damping, Rayleigh};
use crate::analysis::frequency::{Reduced, Window};
use crate::analysis::motion::Motion;
use crate::analysis::spectrum::{Component, DirectionRule, ModalRule, combined, peaks};
use crate::analysis::transient::{Settings, integrate};
use crate::linalg::{Cholesky, Eigen, Ordering, Pattern, Symbolic, Symmetric, generalized_eigen};
use crate::progress::Silent;

/// Three floors with two coupled displacements each: x on even, y on odd unknowns.
fn frame() -> (System, Eigen) {
    let n = 6;
    let everything: Vec<usize> = (0..n).collect();
    let pattern = Arc::new(Pattern::from_cliques(n, std::iter::once(everything.as_slice())));
    let fill = |f: &dyn Fn(usize, usize) -> f64| Symmetric {
        values: (0..n).flat_map(|j| (j..n).map(move |i| (i, j))).map(|(i, j)| f(i, j)).collect(),
        pattern: pattern.clone(),
    };
    let mass = fill(&|i, j| if i == j { 2.0 + 0.1 * i as f64 } else { 0.0 });
    let stiffness = fill(&|i, j| match i - j {
        0 => 900.0 - 60.0 * i as f64,
        1 => 40.0,
        2 => -300.0,
        _ => 0.0,
    });
    let axis = |k: usize| (0..n).map(|i| f64::from(i % 2 == k)).collect();
    let system = System::from_matrices(mass, stiffness, [axis(0), axis(1), vec![0.0; n]]);
    let eigen = generalized_eigen(&system.stiffness.to_dense(), &system.mass.to_dense(), None).unwrap();
    assert_eq!(eigen.omega.len(), n);
    (system, eigen)
}

fn shaking(grid: &Grid) -> Load {
    let record = |phase: f64| -> Vec<f64> {
        (0..200).map(|k| (0.4 * f64::from(k) + phase).sin() * (0.02 * f64::from(k)).sin()).collect()
    };
    let mut load = Load::default();
    for (k, g) in load.ground.iter_mut().enumerate().take(2) {
        *g = Some(Motion::sampled(grid.dt, &record(k as f64), grid));
    }
    load
}

fn statics(system: &System) -> Vec<Vec<f64>> {
    let factor = Cholesky::factor(&system.stiffness.to_dense()).unwrap();
    system.inertia.iter().map(|m| factor.solve_vector(m)).collect()
}

fn observables() -> Vec<Observable> {
    vec![
        Observable { displacement: vec![(4, 1.0), (5, -0.5)], ..Observable::default() },
        Observable { displacement: vec![(0, 2.0)], velocity: vec![(3, 0.3)], ..Observable::default() },
        Observable { acceleration: vec![(4, 1.0), (1, 0.2)], ground: [0.5, 0.0, 0.0], ..Observable::default() },
    ]
}

/// All modes: direct integration with short steps, and the frequency domain on modes and on all unknowns, give the same
/// histories, of displacements, velocities and total accelerations under two components.
#[test]
fn methods_agree() {
    let (system, eigen) = frame();
    let grid = Grid::new(0.02, 3.98, 1.0, 0.02 / 32.0);
    let load = shaking(&grid);
    let ratios = [0.02, 0.05, 0.01, 0.03, 0.05, 0.02];
    let basis = ModalBasis::new(&system, &eigen.omega, &eigen.vectors, [None; 3]).unwrap();
    let rows = observables();
    let (modal, complete) = basis.respond(&ratios, &load, grid, &rows, &[], &Silent).unwrap();
    assert!(complete);
    let damping = Damping::modal(&system.mass, &eigen, &ratios, Rayleigh::NONE).unwrap();
    let table = damping.ratios(&system.mass, &system.stiffness, &eigen);
    for (found, given) in table.iter().zip(&ratios) {
        assert!((found.ratio - given).abs() < 1e-12);
    }
    let damped = system.clone().with_damping(damping);
    let symbolic = Arc::new(Symbolic::new(system.mass.pattern.clone(), &Ordering::MinimumDegree).unwrap());
    let settings = Settings::new(grid);
    let direct = integrate(&damped, &symbolic, std::slice::from_ref(&load), &settings, &rows, &[], &Silent).unwrap();
    let window = Window::Exponential(6.0);
    let on_modes = Reduced::modal(&basis, &ratios, &[0.0; 6]).unwrap();
    let on_modes = on_modes.respond(&load, grid, window, &rows).unwrap();
    let full = Reduced::full(&damped, 0.0).unwrap().respond(&load, grid, window, &rows).unwrap();
    for (k, exact) in modal.scalars.iter().enumerate() {
        let peak = exact.extreme.peak().0;
        for (i, value) in exact.values.iter().enumerate() {
            let others = [&direct[0].observed.scalars[k].values, &on_modes[k].values, &full[k].values];
            // Where the record ends with a jump, its last sample counts in the transform with the mean of both sides.
            let jump = k == 2 && i == 199;
            for (other, allowed) in others.into_iter().zip([1e-3, 2e-3, 2e-3]).take(if jump { 1 } else { 3 }) {
                // Period error of the trapezoidal rule, ω t (ω h)²/12 = 30·5·(30·6e-4)²/12 = 4e-4; transform: the corners of
                // the record between its samples.
                assert!((other[i] - value).abs() < allowed * peak, "{k} {i}: {} {value} of {peak}", other[i]);
            }
            assert!((on_modes[k].values[i] - full[k].values[i]).abs() < 1e-9 * peak);
        }
    }
    // Fields at an instant give the observables there.
    let at = [0, 77 * 32, 120 * 32];
    for (snapshot, i) in basis.fields(&ratios, &load, grid, &at).unwrap().iter().zip([0, 77, 120]) {
        for (row, history) in rows.iter().zip(&modal.scalars) {
            let total = |i: usize| {
                let carried: f64 = (0..3).map(|k| system.influence[k][i] * snapshot.ground[k]).sum();
                snapshot.a[i] + carried
            };
            let on_ground: f64 = row.ground.iter().zip(&snapshot.ground).map(|(b, a)| b * a).sum();
            let accelerations: f64 = row.acceleration.iter().map(|&(i, c)| c * total(i)).sum();
            let y =
                apply(&row.displacement, &snapshot.u) + apply(&row.velocity, &snapshot.v) + accelerations + on_ground;
            assert!((y - history.values[i]).abs() < 1e-12, "{y} {}", history.values[i]);
        }
    }
}

/// Without any mode the missing mass is the static response to the ground acceleration.
#[test]
fn missing_mass_alone_is_static() {
    let (system, eigen) = frame();
    let grid = Grid::new(0.02, 3.98, 0.0, 0.02);
    let load = shaking(&grid);
    let still = statics(&system);
    let given = [Some(still[0].as_slice()), Some(still[1].as_slice()), None];
    let empty = crate::linalg::Matrix::zeros(6, 0);
    let basis = ModalBasis::new(&system, &[], &empty, given).unwrap();
    assert!(basis.is_empty());
    let (found, _) = basis.respond(&[], &load, grid, &observables()[..1], &[], &Silent).unwrap();
    for (i, value) in found.scalars[0].values.iter().enumerate() {
        let a = load.acceleration(i);
        let expected: f64 = -(0..2).map(|k| a[k] * (still[k][4] - 0.5 * still[k][5])).sum::<f64>();
        assert!((value - expected).abs() < 1e-14);
    }
    // With all modes the result is complete.
    let all = ModalBasis::new(&system, &eigen.omega, &eigen.vectors, given).unwrap();
    assert!(all.residual[0].iter().all(|r| r.abs() < 1e-14));
    let mass: f64 = (0..6).map(|j| all.effective_mass(j)[0]).sum();
    assert!((mass - (2.0 + 2.2 + 2.4)).abs() < 1e-12, "{mass}");
}

/// Response-spectrum method: SRSS of well-separated single modes by hand, limits of both rules, components.
#[test]
fn spectra_combine() {
    let (system, eigen) = frame();
    let still = statics(&system);
    let given = [Some(still[0].as_slice()), Some(still[1].as_slice()), None];
    let basis = ModalBasis::new(&system, &eigen.omega, &eigen.vectors, given).unwrap();
    let flat = |_: usize, _: f64, _: f64| 2.0;
    let components: Vec<Component> = (0..2).map(|axis| Component { axis, spectrum: &flat, zero_period: 2.0 }).collect();
    let rows = &observables()[..1];
    let ratios = [0.05; 6];
    let peak = |components: &[Component], modal, direction, ratios: &[f64]| {
        peaks(&basis, ratios, components, modal, direction, rows).unwrap().remove(0)
    };
    let srss = peak(&components, ModalRule::Srss, DirectionRule::Srss, &ratios);
    let by_hand: f64 = (0..6)
        .flat_map(|j| (0..2).map(move |k| (j, k)))
        .map(|(j, k)| {
            let phi = basis.vectors.column(j);
            ((phi[4] - 0.5 * phi[5]) * basis.participation[j][k] * 2.0 / basis.omega[j].powi(2)).powi(2)
        })
        .sum::<f64>()
        .sqrt();
    assert!((srss.value - by_hand).abs() < 1e-12 * by_hand, "{} {by_hand}", srss.value);
    // Nearly undamped modes are uncorrelated: both rules agree.
    let faint = [1e-7; 6];
    let cqc = peak(&components, ModalRule::Cqc, DirectionRule::Srss, &faint);
    assert!((cqc.value - srss.value).abs() < 1e-6 * srss.value);
    let [a, b] = [srss.components[0], srss.components[1]];
    let rule = peak(&components, ModalRule::Srss, DirectionRule::HundredThirty, &ratios);
    assert!((rule.value - (a.max(b) + 0.3 * a.min(b))).abs() < 1e-12);
    // Few modes: the rest is the static response to the zero-period acceleration, within a component algebraically.
    let all: Vec<usize> = (0..6).collect();
    let few = eigen.vectors.select(&all, &[0]);
    let basis = ModalBasis::new(&system, &eigen.omega[..1], &few, given).unwrap();
    let found = peaks(&basis, &ratios[..1], &components[..1], ModalRule::Cqc, DirectionRule::Srss, rows).unwrap();
    let total = -2.0 * (still[0][4] - 0.5 * still[0][5]);
    // Under a flat spectrum the first mode is static too, with the sign of the ground acceleration turned.
    assert!((found[0].missing[0] - found[0].modes[0][0] - total).abs() < 1e-12);
    // What follows the ground in all: modes and rest of an observable of displacements are −d·K⁻¹ M ι.
    let (units, rest) = basis.per_acceleration(&rows[0], 0);
    assert!((units.iter().sum::<f64>() + rest - 0.5 * total).abs() < 1e-12);
    assert!((2.0 * rest - found[0].missing[0]).abs() < 1e-12);
    let velocity = &observables()[1..2];
    assert!(peaks(&basis, &ratios[..1], &components, ModalRule::Cqc, DirectionRule::Srss, velocity).is_err());
}

/// 3, −4 and a rest of 1: by hand. Modes of one frequency are fully correlated: |3 − 4|.
#[test]
fn rules_by_hand() {
    let (apart, same) = ([(1.0, 1e-9), (3.0, 1e-9)], [(2.0, 0.05); 2]);
    let of = |rule, modes: &[(f64, f64)]| combined(rule, modes, &[3.0, -4.0], 1.0);
    assert_eq!(of(ModalRule::Absolute, &apart), 8.0);
    assert!((of(ModalRule::Srss, &apart) - 26.0_f64.sqrt()).abs() < 1e-14);
    assert!((of(ModalRule::Cqc, &apart) - 26.0_f64.sqrt()).abs() < 1e-6);
    assert!((of(ModalRule::Cqc, &same) - 2.0_f64.sqrt()).abs() < 1e-12);
}

/// Hysteretic damping: at resonance the amplitude is that of the same viscous ratio; a harmonic far below is static.
#[test]
fn hysteretic_damping_at_resonance() {
    let (system, eigen) = frame();
    let basis =
        ModalBasis::new(&system, &eigen.omega[..1], &eigen.vectors.select(&[0, 1, 2, 3, 4, 5], &[0]), [None; 3]);
    let basis = basis.unwrap();
    let omega = eigen.omega[0];
    let dt = std::f64::consts::TAU / omega / 40.0;
    let record: Vec<f64> = (0..40 * 120).map(|k| (omega * dt * f64::from(k)).sin()).collect();
    let grid = Grid::new(dt, dt * (record.len() - 1) as f64, 0.0, dt);
    let load = Load::ground(0, Motion::sampled(dt, &record, &grid));
    let row = Observable { displacement: vec![(4, 1.0)], ..Observable::default() };
    let steady = |viscous: f64, hysteretic: f64| {
        let reduced = Reduced::modal(&basis, &[viscous], &[hysteretic]).unwrap();
        let found = reduced.respond(&load, grid, Window::zeros_for(0.05, omega), std::slice::from_ref(&row)).unwrap();
        let last = &found[0].values[record.len() - 80..];
        last.iter().fold(0.0, |m: f64, v| m.max(v.abs()))
    };
    let closed = basis.vectors.get(4, 0).abs() * basis.participation[0][0].abs() / (2.0 * 0.05 * omega * omega);
    // 40 samples a period miss at most 1 − cos(π/40) = 0.3 % of the crest.
    assert!((steady(0.05, 0.0) / closed - 1.0).abs() < 5e-3);
    assert!((steady(0.0, 0.05) / closed - 1.0).abs() < 5e-3);
}

/// A dashpot of the frame, c b bᵀ with two entries of b, on all modes: against the frequency domain on all unknowns with the matrix itself, with
/// the tolerance of [`methods_agree`] (corners of the record between its samples); the steady state by modes and by matrices is one and the same.
#[test]
fn dashpots_couple_the_modes() {
    let (system, eigen) = frame();
    let n = system.size();
    let (mut row, coefficient) = (vec![0.0; n], 12.0);
    (row[0], row[4]) = (0.4, 1.0);
    let basis = ModalBasis::new(&system, &eigen.omega, &eigen.vectors, [None; 3])
        .unwrap()
        .with_dashpots([(row.as_slice(), coefficient)]);
    let ratios = vec![0.0; n];
    let mut dashpot = Symmetric::zeros(system.mass.pattern.clone());
    for (i, j) in [(0, 0), (4, 0), (4, 4)] {
        let place = dashpot.pattern.place(i, j).unwrap();
        dashpot.values[place] += coefficient * row[i] * row[j];
    }
    let damped = System::from_matrices(system.mass.clone(), system.stiffness.clone(), system.influence.clone())
        .with_damping(Damping { sparse: Some(dashpot), ..Damping::none() });
    let grid = Grid::new(0.02, 3.98, 1.0, 0.02 / 32.0);
    let load = shaking(&grid);
    let rows = observables();
    let (modal, _) = basis.respond(&ratios, &load, grid, &rows, &[], &Silent).unwrap();
    let exact = Reduced::full(&damped, 0.0).unwrap();
    let exact = exact.respond(&load, grid, Window::Exponential(6.0), &rows).unwrap();
    for (a, b) in modal.scalars.iter().zip(&exact) {
        let largest = b.values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for (i, (a, b)) in a.values.iter().zip(&b.values).enumerate() {
            // The record ends with a jump at 199.
            assert!((a - b).abs() < 2e-3 * largest || i == 199, "{i}: {a} {b} of {largest:e}");
        }
    }
    // The steady state by both, exact for both.
    let omega = [3.0, 12.5, 25.0];
    let by_modes = Reduced::modal(&basis, &ratios, &ratios).unwrap().transfer(&rows, 0, &omega);
    let by_matrix = Reduced::full(&damped, 0.0).unwrap().transfer(&rows, 0, &omega);
    for (a, b) in by_modes.unwrap().iter().flatten().zip(by_matrix.unwrap().iter().flatten()) {
        assert!((a - b).norm() <= 1e-9 * b.norm().max(1e-12), "{a} {b}");
    }
}

/// One mode with a dashpot is a mode with the ratio c b²/(2 ω): the exact recurrence, to rounding of a few hundred steps.
#[test]
fn a_dashpot_on_one_mode_is_its_ratio() {
    let (system, eigen) = frame();
    let first = Matrix { rows: system.size(), cols: 1, data: eigen.vectors.column(0).to_vec() };
    let plain = ModalBasis::new(&system, &eigen.omega[..1], &first, [None; 3]).unwrap();
    let mut row = vec![0.0; system.size()];
    row[2] = 1.0;
    let ratio = 5.0 * first.get(2, 0).powi(2) / (2.0 * eigen.omega[0]);
    let grid = Grid::new(0.02, 4.0, 0.0, 0.005);
    let load = shaking(&grid);
    let rows = observables();
    let (expected, _) = plain.respond(&[ratio], &load, grid, &rows, &rows, &Silent).unwrap();
    let coupled = plain.with_dashpots([(row.as_slice(), 5.0)]);
    let (found, _) = coupled.respond(&[0.0], &load, grid, &rows, &rows, &Silent).unwrap();
    for (a, b) in found.scalars.iter().zip(&expected.scalars) {
        let largest = b.extreme.peak().0;
        assert!((a.extreme.peak().0 - largest).abs() <= 1e-9 * largest);
        assert!(a.values.iter().zip(&b.values).all(|(a, b)| (a - b).abs() <= 1e-9 * largest));
    }
}
