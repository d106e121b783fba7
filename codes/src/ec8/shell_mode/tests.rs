use super::*;
use crate::samples::{self, steel};

fn course(height: f64, thickness: f64) -> Course {
    samples::course(height, thickness, steel())
}

/// First mode under the mass of the wall alone.
fn first_mode(shell: &DryShell) -> Mode {
    let mass = |p: &Point| Inertia::isotropic(p.density * p.thickness);
    let inertia: Vec<Inertia> = shell.points().iter().map(mass).collect();
    shell.first_mode(&inertia, |w| vec![0.0; w.len()], None).unwrap()
}

/// A slender tube is Timoshenko's cantilever: ω = 3.51602 √(EI/(ρA))/L² with A = 2πRs, I = πR³s; rotary inertia and
/// shear (k = 1/2 for a thin ring) lower it by about ½(1 + E/(kG)) (r/L)² × 4.65², r² = R²/2 (Thomson's correction for the
/// first mode): 0.0018 × … at L/R = 40. Tolerance: a third of the correction (1.2 %), its own error being of second order.
#[test]
fn slender_tube_is_a_cantilever() {
    let (radius, length, s) = (1.0, 40.0, 0.01);
    let shell = DryShell::new(radius, &[course(length, s)], 0.0, Base::Clamped);
    let mode = first_mode(&shell);
    let bernoulli = 3.516_02 * (210e9f64 * radius * radius / 2.0 / 7850.0).sqrt() / (length * length);
    let correction = 0.5 * (1.0 + 2.0 * 2.6) * 0.5 * (radius / length).powi(2) * 4.648;
    let expected = bernoulli * (1.0 - correction);
    assert!(correction < 0.006);
    assert!(
        (mode.omega / expected - 1.0).abs() < correction / 2.0,
        "{} {expected} {correction}",
        mode.omega / expected
    );
}

/// Rigid motions cost no energy: K r = 0 for an element.
#[test]
fn rigid_motions_are_free_of_strain() {
    let k = stiffness(3.0, 0.7, &course(0.7, 0.02));
    let (z0, z1) = (0.4, 1.1);
    let translation = [0.0, -1.0, 1.0, 0.0, 0.0, -1.0, 0.0, -1.0, 1.0, 0.0];
    let rotation = [-3.0, -z0, z0, 1.0, -3.0, -0.75, -3.0, -z1, z1, 1.0];
    for motion in [translation, rotation] {
        for row in &k {
            let force: f64 = row.iter().zip(motion).map(|(a, b)| a * b).sum();
            let size: f64 = row.iter().zip(motion).map(|(a, b)| (a * b).abs()).sum();
            assert!(force.abs() <= 1e-12 * size);
        }
    }
}

/// A course split in two, and an element end at the liquid surface, change the mode by no more than discretisation (1e-5 observed).
#[test]
fn splitting_a_course_changes_nothing() {
    let whole = DryShell::new(10.0, &[course(10.0, 0.01)], 0.0, Base::Clamped);
    let split = DryShell::new(10.0, &[course(3.7, 0.01), course(6.3, 0.01)], 8.05, Base::Clamped);
    let a = first_mode(&whole).omega;
    let b = first_mode(&split).omega;
    assert!((a / b - 1.0).abs() < 1e-4, "{}", a / b - 1.0);
}
