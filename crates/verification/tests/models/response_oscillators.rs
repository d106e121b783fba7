//! Source:    closed forms; matrix exponential of the first-order system
//! Goal:      modal superposition and direct integration of small systems, whatever their damping
//! Model:     chains of two and three masses with known modes
//! Expected:  the exact solution for ground motion that is linear between samples
//! Tolerance: 1e-12 of the peak for exact methods; second order for Newmark's method, measured by halving the step

use engines::coupled::{Coupled, Part, ShapeRows};
use engines::damping::{Damper, Rayleigh};
use engines::modes::{CoupledMode, Kind, solve};
use engines::probe::Probe;
use engines::response::direct::{self, DirectSystem};
use engines::response::motion::{Grid, Motion};
use engines::response::observe::Observed;
use engines::response::superpose::{self, ModalSystem};
use fem::linalg::Matrix;
use oscillator::record::Record;

use crate::motions::{broad_band, record};

/// A chain of masses on the ground: mass i hangs on mass i − 1 by spring i.
fn chain(masses: &[f64], springs: &[f64]) -> Coupled {
    let n = masses.len();
    let (mut mass, mut stiffness) = (Matrix::zeros(n, n), Matrix::zeros(n, n));
    for i in 0..n {
        mass.add(i, i, masses[i]);
        stiffness.add(i, i, springs[i]);
        if i > 0 {
            stiffness.add(i - 1, i - 1, springs[i]);
            stiffness.add(i, i - 1, -springs[i]);
            stiffness.add(i - 1, i, -springs[i]);
        }
    }
    Coupled {
        harmonic: 1,
        mass,
        stiffness,
        influence: vec![1.0; n],
        surface: Part::block(&Matrix::zeros(0, 0), 0..0),
        rotation: None,
        probes: Vec::new(),
        lines: Vec::new(),
        level: 1.0,
        shear: None,
        structure: None,
        dashpots: Vec::new(),
        liquid_mass: 0.0,
        wall_mass: masses.iter().sum(),
        moment_arm: (1..=n).map(|i| i as f64).collect(),
        mesh: Vec::new(),
        shape_rows: ShapeRows::default(),
    }
}

fn probe(displacement: Vec<f64>, absolute_acceleration: Vec<f64>) -> Probe {
    Probe { displacement, absolute_acceleration, ..Probe::new(results::Channel::BaseShear) }
}

/// Modal superposition with the modes `kept` of all.
fn modal(system: &Coupled, kept: &[usize], damper: &Damper, ground: &Record, grid: Grid, probes: &[Probe]) -> Observed {
    let modes = solve(system, None).unwrap();
    let kept: Vec<&CoupledMode> = kept.iter().map(|&j| &modes[j]).collect();
    let system = ModalSystem::new(system, kept, damper).unwrap();
    let motion = Motion::new(ground, &grid);
    let observables: Vec<_> = probes.iter().map(|p| vec![(0, 1.0, p)]).collect();
    superpose::respond(&[system], &[&motion], grid, &observables, &observables, &fem::progress::Silent).unwrap()
}

/// e^A for a small matrix, by scaling and squaring of the power series.
fn exponential(a: &Matrix) -> Matrix {
    let n = a.rows;
    let norm = (0..n).map(|j| a.column(j).iter().map(|v| v.abs()).sum::<f64>()).fold(0.0, f64::max);
    let squarings = norm.log2().ceil().max(0.0) as i32;
    let scale = 0.5_f64.powi(squarings);
    let times = |x: &Matrix, y: &Matrix| {
        let mut z = Matrix::zeros(n, n);
        for j in 0..n {
            z.column_mut(j).copy_from_slice(&x.times(y.column(j)));
        }
        z
    };
    let mut small = a.clone();
    small.data.iter_mut().for_each(|v| *v *= scale);
    let mut sum = Matrix::zeros(n, n);
    (0..n).for_each(|i| sum.add(i, i, 1.0));
    let mut term = sum.clone();
    for k in 1..28 {
        term = times(&term, &small);
        term.data.iter_mut().for_each(|v| *v /= f64::from(k));
        sum.data.iter_mut().zip(&term.data).for_each(|(s, t)| *s += t);
    }
    for _ in 0..squarings {
        sum = times(&sum, &sum);
    }
    sum
}

/// Exact displacements and absolute accelerations at the samples: d/dt (x, v, a, s) with a linear ground acceleration of
/// slope s as states of their own.
fn reference(system: &Coupled, damping: &Matrix, ground: &Record, samples: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let n = system.influence.len();
    let inverse: Vec<f64> = (0..n).map(|i| 1.0 / system.mass.get(i, i)).collect();
    let mut a = Matrix::zeros(2 * n + 2, 2 * n + 2);
    for (i, inverse) in inverse.iter().enumerate() {
        a.add(i, n + i, 1.0);
        for j in 0..n {
            a.add(n + i, j, -inverse * system.stiffness.get(i, j));
            a.add(n + i, n + j, -inverse * damping.get(i, j));
        }
        a.add(n + i, 2 * n, -1.0);
    }
    a.add(2 * n, 2 * n + 1, 1.0);
    let mut scaled = a.clone();
    scaled.data.iter_mut().for_each(|v| *v *= ground.dt);
    let step = exponential(&scaled);
    let mut state = vec![0.0; 2 * n + 2];
    let (mut x, mut acceleration) = (Vec::new(), Vec::new());
    let value = |k: usize| ground.acceleration.get(k).copied().unwrap_or(0.0);
    let last = ground.acceleration.len() - 1;
    for k in 0..samples {
        // ẍ + a_g = −M⁻¹ (C v + K x): independent of a_g.
        state[2 * n] = 0.0;
        let rate = a.times(&state);
        x.push(state[..n].to_vec());
        acceleration.push(rate[n..2 * n].to_vec());
        state[2 * n] = if k < last { value(k) } else { 0.0 };
        state[2 * n + 1] = if k < last { (value(k + 1) - value(k)) / ground.dt } else { 0.0 };
        state = step.times(&state);
    }
    (x, acceleration)
}

/// Two masses of the textbook: m = 1, k = 100 each: ω² = 100 (3 ∓ √5)/2.
#[test]
fn two_masses_have_their_modes() {
    let system = chain(&[1.0, 1.0], &[100.0, 100.0]);
    let modes = solve(&system, None).unwrap();
    let root = 5.0_f64.sqrt();
    for (mode, square) in modes.iter().zip([50.0 * (3.0 - root), 50.0 * (3.0 + root)]) {
        assert!((mode.omega / square.sqrt() - 1.0).abs() < 1e-12);
        assert_eq!(mode.kind, Kind::Structural);
    }
    // Golden ratio g: shapes (1, g) and (g, −1) over √(1 + g²); effective masses (1 + g)²/(1 + g²), (g − 1)²/(1 + g²).
    let g = (1.0 + root) / 2.0;
    let norm = 1.0 + g * g;
    for (mode, mass) in modes.iter().zip([(1.0 + g).powi(2) / norm, (g - 1.0).powi(2) / norm]) {
        assert!((mode.effective_mass() - mass).abs() < 1e-12, "{}", mode.effective_mass());
    }
    // First mode: moment (1 + 2g)/(1 + g) over shear, with arms 1 and 2.
    assert!((modes[0].effective_height - (1.0 + 2.0 * g) / (1.0 + g)).abs() < 1e-12);
}

/// Displacements and absolute accelerations at the samples against the matrix exponential, for light, over-critical and
/// (one mode) negative damping; the record ends with a jump.
#[test]
fn superposition_is_exact() {
    let system = chain(&[2.0, 1.0, 0.5], &[300.0, 200.0, 400.0]);
    let mut motion = broad_band(0.02, 8.0);
    *motion.acceleration.last_mut().unwrap() = 2.0;
    let dampers = [
        (0.0, 0.002),
        (0.4, 0.0),
        (0.0, 0.4), // ξ = 1.6, 4.2, 6.2: over-critical
        (-0.1, 0.004),
    ];
    for (mass, stiffness) in dampers {
        let mut damping = Matrix::zeros(3, 3);
        for (c, (m, k)) in damping.data.iter_mut().zip(system.mass.data.iter().zip(&system.stiffness.data)) {
            *c = mass * m + stiffness * k;
        }
        let grid = Grid::new(0.02, motion.duration(), 2.0, 0.007);
        let (x, a) = reference(&system, &damping, &motion, grid.samples);
        let unit = |i: usize| (0..3).map(|j| if i == j { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let probes: Vec<Probe> =
            (0..3).map(|i| probe(unit(i), Vec::new())).chain((0..3).map(|i| probe(Vec::new(), unit(i)))).collect();
        let damper = Damper::Rayleigh(Rayleigh { mass, stiffness });
        let found = modal(&system, &[0, 1, 2], &damper, &motion, grid, &probes);
        for i in 0..6 {
            let expected: Vec<f64> = (0..grid.samples).map(|k| if i < 3 { x[k][i] } else { a[k][i - 3] }).collect();
            let peak = expected.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (k, (f, e)) in found.scalars[i].values.iter().zip(&expected).enumerate() {
                assert!(
                    (f - e).abs() <= 1e-12 * peak,
                    "damping ({mass}, {stiffness}), output {i}, sample {k}: {f} {e}"
                );
            }
            assert_eq!(found.scalars[i].values.len(), grid.samples);
            assert!(found.scalars[i].extreme.peak().0 >= peak * (1.0 - 1e-12));
        }
    }
}

/// A single oscillator under a = sin 2t, sampled at 0.01 s: the closed solution within 1.0e-5, which is the
/// interpolation of a alone (theory sheet on spectra: amplitude 0.3077 and that error).
#[test]
fn harmonic_motion_meets_its_closed_form() {
    let (w, xi, f) = (3.0_f64, 0.01_f64, 2.0_f64);
    let system = chain(&[1.0], &[w * w]);
    let motion = record(0.01, (0..=6000).map(|k| (f * f64::from(k) * 0.01).sin()).collect());
    let grid = Grid::new(0.01, motion.duration(), 0.0, 0.01);
    let damper = Damper::ByKind { sloshing: 0.5, structural: xi };
    let found = modal(&system, &[0], &damper, &motion, grid, &[probe(vec![1.0], Vec::new())]);
    // u = A sin ft + B cos ft + e^{−ξωt}(C cos ω_d t + D sin ω_d t)
    let d = (w * w - f * f).powi(2) + (2.0 * xi * w * f).powi(2);
    let (a, b) = (-(w * w - f * f) / d, 2.0 * xi * w * f / d);
    let wd = w * (1.0 - xi * xi).sqrt();
    let (c, e) = (-b, (-xi * w * b - a * f) / wd);
    let mut worst = 0.0_f64;
    for (k, value) in found.scalars[0].values.iter().enumerate() {
        let t = k as f64 * 0.01;
        let free = (-xi * w * t).exp() * (c * (wd * t).cos() + e * (wd * t).sin());
        worst = worst.max((value - a * (f * t).sin() - b * (f * t).cos() - free).abs());
    }
    assert!(worst < 1.05e-5, "{worst}");
}

/// A stiff third mass moves with the second: two modes and the missing mass give forces and displacements, two modes
/// alone miss a third of the shear.
#[test]
fn missing_mass_follows_the_ground() {
    // Mass 1 on a spring so stiff that its mode (1000 rad/s) follows the ground; masses 2 and 3 swing on it.
    let system = chain(&[3.0, 1.0, 1.0], &[3e6, 400.0, 100.0]);
    let motion = broad_band(0.01, 15.0);
    let grid = Grid::new(0.01, motion.duration(), 1.0, 2e-4);
    let damper = Damper::ByKind { sloshing: 0.01, structural: 0.02 };
    let shear = probe(Vec::new(), vec![3.0, 1.0, 1.0]);
    let spring = probe(vec![3e6, 0.0, 0.0], Vec::new());
    let all = modal(&system, &[0, 1, 2], &damper, &motion, grid, &[shear.clone(), spring.clone()]);
    let some = modal(&system, &[0, 1], &damper, &motion, grid, &[shear, spring]);
    for (a, s) in all.scalars.iter().zip(&some.scalars) {
        let (a, s) = (a.extreme.peak().0, s.extreme.peak().0);
        // The dropped mode is 8 times faster than the fastest wave of the motion: amplification below 1/(1 − 1/64).
        assert!((s / a - 1.0).abs() < 0.01, "{a} {s}");
    }
    // Without it: the shear of the two modes alone, from a system without the third mass.
    let modes = solve(&system, None).unwrap();
    let carried: f64 = modes[..2].iter().map(CoupledMode::effective_mass).sum();
    assert!((carried / 5.0 - 0.4).abs() < 0.01, "{carried}");
}

fn newmark(system: &Coupled, damper: &Damper, motion: &Record, grid: Grid, probes: &[Probe]) -> (Observed, f64) {
    let modes = solve(system, None).unwrap();
    let direct = DirectSystem::new(system, &modes, damper);
    let ground = Motion::new(motion, &grid);
    let observables: Vec<_> = probes.iter().map(|p| vec![(0, 1.0, p)]).collect();
    let (observed, energy) =
        direct::respond(&[direct], &[&ground], grid, &observables, &observables, &fem::progress::Silent).unwrap();
    assert!(energy.input > 0.0 && energy.damping > 0.0);
    assert!(energy.damping <= energy.input * (1.0 + 1e-9));
    (observed, energy.error)
}

/// Newmark's method converges to the exact solution with the second order, and its energy balance closes to rounding
/// (theory sheet on dynamics, D9: 1e-10), for both damping models, with a jump at both ends of the record.
#[test]
fn direct_integration_converges_to_superposition() {
    let system = chain(&[2.0, 1.0, 0.5], &[300.0, 200.0, 400.0]);
    let mut motion = broad_band(0.02, 8.0);
    motion.acceleration[0] = -1.0;
    *motion.acceleration.last_mut().unwrap() = 2.0;
    let outputs = [probe(vec![0.0, 1.0, -1.0], Vec::new()), probe(Vec::new(), vec![2.0, 1.0, 0.5])];
    let dampers =
        [Damper::ByKind { sloshing: 0.0, structural: 0.03 }, Damper::Rayleigh(Rayleigh { mass: 0.1, stiffness: 0.01 })];
    for damper in dampers {
        let error = |sub_steps: usize| -> f64 {
            let grid = Grid { dt: 0.02, sub_steps, samples: 501 };
            let exact = modal(&system, &[0, 1, 2], &damper, &motion, grid, &outputs);
            let (found, balance) = newmark(&system, &damper, &motion, grid, &outputs);
            assert!(balance < 1e-10, "{balance}");
            let relative = |(e, f): (&engines::response::observe::History, &engines::response::observe::History)| {
                // The record's last sample: absolute acceleration on both sides of the jump is the same.
                let worst = e.values.iter().zip(&f.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                worst / e.extreme.peak().0
            };
            exact.scalars.iter().zip(&found.scalars).map(relative).fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(8), error(16));
        let order = (coarse / fine).log2();
        assert!((order - 2.0).abs() < 0.05, "{damper:?}: order {order}, {coarse} {fine}");
        assert!(fine < 5e-3, "{fine}");
    }
}

/// Growth without bound is reported with its time, not returned as infinity.
#[test]
fn growth_without_bound_is_an_error() {
    let system = chain(&[1.0], &[100.0]);
    let modes = solve(&system, None).unwrap();
    let damper = Damper::Rayleigh(Rayleigh {
        mass: -18.0, // ξ = −0.9: e^{9t}, beyond the range of numbers after 78 s
        stiffness: 0.0,
    });
    let motion = broad_band(0.02, 100.0);
    let grid = Grid::new(0.02, motion.duration(), 0.0, 0.02);
    let ground = Motion::new(&motion, &grid);
    let output = probe(vec![1.0], Vec::new());
    let observables = [vec![(0, 1.0, &output)]];
    let modal = ModalSystem::new(&system, modes.iter().collect(), &damper).unwrap();
    let message = superpose::respond(&[modal], &[&ground], grid, &observables, &[], &fem::progress::Silent)
        .unwrap_err()
        .to_string();
    assert!(message.contains("not finite at t = 7") || message.contains("not finite at t = 8"), "{message}");
    let direct = DirectSystem::new(&system, &modes, &damper);
    assert!(direct::respond(&[direct], &[&ground], grid, &observables, &[], &fem::progress::Silent).is_err());
}
