//! Longer steps in quiet phases.

use std::fs;

use super::*;
use crate::analysis::march::Adaptive;

/// The record of [`shaking`], and forty seconds of free vibration, four nominal steps between two samples.
fn long(amplitude: f64) -> (Grid, Load) {
    let grid = Grid::new(0.08, 6.0, 40.0, 0.02);
    let a: Vec<f64> =
        (0..=75).map(|k| amplitude * ((0.52 * f64::from(k) + 0.7).sin() + 0.5 * (1.24 * f64::from(k)).cos())).collect();
    (grid, Load::ground(0, Motion::sampled(0.08, &a, &grid)))
}

/// A march with its histories.
fn run(parts: &Parts, load: &Load, settings: &Settings) -> (Run, QuantityObserver) {
    let problem = parts.problem();
    let mut seen = QuantityObserver::new(vec![top(problem), base_shear(problem)]);
    let run = march(problem, load, settings, &mut [&mut seen], &Silent).unwrap();
    assert_eq!(run.outcome, Outcome::Completed);
    (run, seen)
}

/// Against nominal steps, an elastic chain and one that yields. Peaks within 1 %: they fall into the strong phase, which is marched in
/// nominal steps, after at most a few long ones of an error of 0.1 % each. Histories within 15 % of the peak: local
/// errors of 0.05 % accumulate as a shift of phase of some tenths of a radian over forty seconds, on a third of the peak. Dissipated
/// energy within 2 %, twice the peaks. Samples at the same times.
#[test]
fn quiet_phases_take_longer_steps() {
    for strength in [f64::INFINITY, 12.0] {
        let parts = Parts::new(chain(strength, 10.0));
        let (grid, load) = long(3.0);
        let mut settings = Settings::new(grid);
        let (fixed, expected) = run(&parts, &load, &settings);
        settings.adaptive = Some(Adaptive::DEFAULT);
        let (found, seen) = run(&parts, &load, &settings);
        assert_eq!(seen.times, expected.times);
        assert!((fixed.longest - grid.h()).abs() < 1e-12 && found.longest > 1.5 * grid.h());
        assert!(
            (found.cost.steps as f64) < 0.9 * fixed.cost.steps as f64,
            "{} of {} steps",
            found.cost.steps,
            fixed.cost.steps
        );
        for (q, (a, b)) in seen.histories.iter().zip(&expected.histories).enumerate() {
            let (peak, other) = (expected.ranges[q].peak().0, seen.ranges[q].peak().0);
            assert!((other / peak - 1.0).abs() < 0.01, "{q}: {other} {peak}");
            let apart = a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(apart < 0.15 * peak, "{q}: {apart} of {peak}");
        }
        let lost = |run: &Run| run.balance.samples.last().unwrap().hysteretic;
        assert!((lost(&found) - lost(&fixed)).abs() <= 0.02 * lost(&fixed), "{} {}", lost(&found), lost(&fixed));
        assert!(found.balance.error() < 1e-6);
    }
}

/// At rest steps grow, and the first one with motion is taken back; nothing is lost of it.
#[test]
fn onset_is_not_missed() {
    let parts = Parts::new(chain(f64::INFINITY, 10.0));
    let grid = Grid::new(0.08, 10.0, 0.0, 0.02);
    let mut a = vec![0.0; 126];
    a[60] = 2.0;
    let load = Load::ground(0, Motion::sampled(0.08, &a, &grid));
    let mut settings = Settings::new(grid);
    let (_, expected) = run(&parts, &load, &settings);
    settings.adaptive = Some(Adaptive::DEFAULT);
    let (found, seen) = run(&parts, &load, &settings);
    assert!(found.refused > 0 && (found.longest - 0.08).abs() < 1e-9);
    let (peak, other) = (expected.ranges[0].peak().0, seen.ranges[0].peak().0);
    // As in the test above.
    assert!((other / peak - 1.0).abs() < 0.01, "{other} {peak}");
}

/// Stops after some nominal steps.
struct Patience(std::sync::atomic::AtomicU64, u64);

impl Progress for Patience {
    fn stage(&self, _: &str, _: u64) {}
    fn advance(&self, steps: u64) {
        self.0.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
    }
    fn interrupted(&self) -> bool {
        self.0.load(std::sync::atomic::Ordering::Relaxed) >= self.1
    }
}

/// Interrupted among long steps and resumed: the same bits. A checkpoint of nominal steps is that of another march.
#[test]
fn resumed_long_steps_are_the_same() {
    let folder = std::env::temp_dir().join(format!("march-adaptive-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let parts = Parts::new(chain(12.0, 10.0));
    let (grid, load) = long(3.0);
    let mut settings = Settings::new(grid);
    settings.adaptive = Some(Adaptive::DEFAULT);
    let (expected, whole) = run(&parts, &load, &settings);
    settings.checkpoint = Some(Checkpoint {
        path: folder.join("march.checkpoint"),
        steps: 100,
        seconds: f64::INFINITY,
        key: "test".into(),
        resume: true,
    });
    let problem = parts.problem();
    let recorder = || QuantityObserver::new(vec![top(problem), base_shear(problem)]);
    for patience in [900, 1700] {
        let patience = Patience(std::sync::atomic::AtomicU64::new(0), patience);
        let run = march(problem, &load, &settings, &mut [&mut recorder()], &patience).unwrap();
        assert_eq!(run.outcome, Outcome::Interrupted);
    }
    let (found, seen) = run(&parts, &load, &settings);
    assert_eq!(found.state, expected.state);
    assert_eq!(found.balance, expected.balance);
    assert_eq!((found.cost, found.refused), (expected.cost, expected.refused));
    assert_eq!(found.longest.to_bits(), expected.longest.to_bits());
    assert_eq!((&seen.histories, &seen.ranges), (&whole.histories, &whole.ranges));
    settings.adaptive = None;
    let refused = march(problem, &load, &settings, &mut [&mut recorder()], &Silent);
    assert!(matches!(refused, Err(AnalysisError::Checkpoint(_))));
    fs::remove_dir_all(&folder).unwrap();
}

/// The estimate against the exact motion of an undamped oscillator: one step from exact values, the acceleration being that of
/// δ h after the instant. The next term of the series is smaller by x = ω h = 0.02 times a number near one; 5 % leaves room for it.
#[test]
fn local_error_of_an_oscillator() {
    let x = 0.02;
    for radius in [0.0, 0.5, 0.9, 1.0] {
        let scheme = TimeScheme::GeneralizedAlpha { radius }.with_step(x).unwrap();
        let delta = scheme.alpha_m - scheme.alpha_f;
        let phase: f64 = 0.8;
        let old = nalgebra::Vector3::new(phase.cos(), -x * phase.sin(), -x * x * (phase + delta * x).cos());
        let new = scheme.amplification(x, 0.0) * old;
        let exact = (phase + x).cos();
        let estimate = scheme.local_error() * (new[2] - old[2]);
        let found = new[0] - exact;
        assert!((found / estimate - 1.0).abs() < 0.05, "ρ {radius}: {found:e} {estimate:e}");
    }
}
