//! Source:    potential flow in a rigid upright cylinder (Lamb 1932, §191; Veletsos & Yang 1977); zeros of J_m' from
//!            Abramowitz & Stegun 1964, table 9.5
//! Goal:      complements the rows F1 to F8 and F17: the printed digits of their references, higher modes and wave numbers,
//!            balances of mass and flux on any mesh
//! Model:     nine-node potential elements 5 × 8 (r × z), rigid wall
//! Expected:  ω² = g λ/R tanh(λ H/R);  m_c/m = 2 tanh(a)/(a (λ² − 1)), a = λ H/R;  m_i = m − Σ m_c;  levers by series
//! Tolerance: sloshing 0.05, 0.1, 0.3 % for the first three modes and masses as stated below: accuracy of the default mesh
//!            (the rate is asserted in `convergence`); translation of the whole liquid 1e-9, as φ = x is in the space

use engines::liquid::Domain;
use fem::linalg::dot;
use verification::tanks::rigid::RigidTank;

use crate::tanks::{GRAVITY, assert_close};

/// Zeros λ of J₁'.
pub(crate) const ZEROS_1: [f64; 5] = [1.841183781, 5.331442774, 8.536316366, 11.706004903, 14.863588634];
/// Zeros λ of J₀' (but 0).
const ZEROS_0: [f64; 2] = [3.831705970, 7.015586670];
/// First zero λ of J₃'.
const ZERO_3: f64 = 4.201188941;

/// A rigid cylinder on the default mesh, refined by `refine`.
pub(crate) fn tank(radius: f64, depth: f64, harmonic: u32, refine: f64) -> RigidTank {
    RigidTank::new(Domain::Cylinder { radius, harmonic }, depth, GRAVITY, refine).unwrap()
}

/// Sloshing frequencies with a rigid wall [rad/s].
pub(crate) fn sloshing(tank: &RigidTank) -> Vec<f64> {
    tank.sloshing().unwrap()
}

fn exact(radius: f64, depth: f64, zero: f64) -> f64 {
    (GRAVITY * zero / radius * (zero * depth / radius).tanh()).sqrt()
}

/// The closed forms that the rows are compared with give the printed values of the sheet, half a last digit.
#[test]
#[expect(clippy::approx_constant, reason = "3.1415 rad/s is a frequency")]
fn references_have_the_printed_digits() {
    let first = |radius, depth| exact(radius, depth, ZEROS_1[0]);
    for (zero, printed) in ZEROS_1.into_iter().zip([2.9989, 5.3453, 6.7646]) {
        assert!((exact(1.83, 1.525, zero) - printed).abs() < 6e-5);
    }
    let model = [(0.03, 1.5732), (0.06, 1.9744), (0.09, 2.1150), (0.12, 2.1613), (0.15, 2.1762)];
    for (depth, printed) in model {
        assert!((first(0.096, depth) / std::f64::consts::TAU - printed).abs() < 6e-5, "{depth}");
    }
    let slender = [(3.0, 3.1341), (3.5, 3.1389), (4.0, 3.1406), (4.5, 3.1413), (5.0, 3.1415)];
    for (depth, printed) in slender {
        assert!((first(1.83, depth) - printed).abs() < 6e-5, "{depth}");
    }
    for (zero, printed) in ZEROS_1.into_iter().zip([(0.49696, 5e-6), (0.0164, 5e-5), (0.0039, 5e-5)]) {
        let a = zero * 1.525 / 1.83;
        let share = 2.0 * a.tanh() / (a * (zero * zero - 1.0));
        assert!((share - printed.0).abs() < printed.1, "{share}");
    }
    let masses = [
        (1.83, 1.525, [0.4791, 0.4018, 0.8474]),
        (1.83, 5.0, [0.8264, 0.4349, 0.4749]),
        (10.0, 3.0, [0.1762, 0.3995, 2.637]),
    ];
    for (radius, depth, printed) in masses {
        let (mass, lever, below) = exact_impulsive(radius, depth);
        for (series, printed) in [mass, lever, below].into_iter().zip(printed) {
            assert!((series / printed - 1.0).abs() < 2.5e-4, "{series} {printed}");
        }
    }
}

#[test]
fn higher_modes_and_wave_numbers() {
    let axisymmetric = sloshing(&tank(1.83, 1.525, 0, 1.0));
    assert_close("m = 0, second", axisymmetric[1], exact(1.83, 1.525, ZEROS_0[1]), 0.003);
    let third = sloshing(&tank(1.83, 1.525, 3, 1.0));
    assert_close("m = 3", third[0], exact(1.83, 1.525, ZERO_3), 0.001);
}

#[test]
fn f6_rigid_translation_carries_the_whole_liquid() {
    for (radius, depth) in [(1.83, 1.525), (10.0, 3.0), (0.096, 0.15), (20.0, 15.0)] {
        let tank = tank(radius, depth, 1, 1.0);
        let mass = tank.translated_mass();
        let exact = 1000.0 * std::f64::consts::PI * radius * radius * depth;
        assert_close("mass", mass, exact, 1e-9);
    }
}

/// m_i/m, h_i/H, h_i'/H from total translation minus the convective series (Veletsos & Yang 1977), with
///
/// ```text
/// h_n/H  = 1 − (cosh a − 1)/(a sinh a)          h_n'/H = 1 − (cosh a − 2)/(a sinh a)
/// m H/2 = Σ m_n h_n + m_i h_i                   m (H/2 + R²/(4 H)) = Σ m_n h_n' + m_i h_i'
/// ```
fn exact_impulsive(radius: f64, depth: f64) -> (f64, f64, f64) {
    let (mut mass, mut moment, mut below) = (1.0, 0.5, 0.5 + radius * radius / (4.0 * depth * depth));
    for n in 0..4000 {
        let zero = zero_of_derivative(n);
        let a = zero * depth / radius;
        let share = 2.0 * a.tanh() / (a * (zero * zero - 1.0));
        mass -= share;
        moment -= share * (1.0 - (1.0 - 1.0 / a.cosh()) / (a * a.tanh()));
        below -= share * (1.0 - (1.0 - 2.0 / a.cosh()) / (a * a.tanh()));
    }
    (mass, moment / mass, below / mass)
}

/// Zero number n (from 0) of J₁': table, then McMahon's expansion (A&S 9.5.13), μ = 4.
fn zero_of_derivative(n: usize) -> f64 {
    if let Some(zero) = ZEROS_1.get(n) {
        return *zero;
    }
    let b = (n as f64 + 1.0 - 0.25) * std::f64::consts::PI;
    b - 7.0 / (8.0 * b) - 4.0 * (7.0 * 16.0 + 82.0 * 4.0 - 9.0) / (3.0 * (8.0 * b).powi(3))
}

#[test]
fn impulsive_and_convective_masses_make_the_whole() {
    for (radius, depth) in [(1.83, 1.525), (1.83, 5.0), (10.0, 3.0)] {
        let tank = tank(radius, depth, 1, 1.0);
        let total = 1000.0 * std::f64::consts::PI * radius * radius * depth;
        let sum = tank.impulsive().unwrap().mass + tank.convective_masses().unwrap().iter().sum::<f64>();
        assert_close("m_i + Σ m_c", sum, total, 1e-9);
    }
}

/// S and B do not depend on the liquid's mesh: Σ S is the area's share, Σ F the volume that leaves the tank.
#[test]
fn flux_is_exact_on_any_mesh() {
    for refine in [0.5, 1.0, 1.7] {
        let liquid = tank(1.83, 1.525, 0, refine).liquid;
        let area = std::f64::consts::PI * 1.83_f64.powi(2);
        let elevation: f64 = liquid.surface_columns().map(|c| liquid.flux[c]).sum();
        assert_close("surface", elevation, area, 1e-12);
        let wall = dot(&liquid.flux, &liquid.rigid_translation());
        assert_close("wall", wall, 2.0 * std::f64::consts::PI * 1.83 * 1.525, 1e-12);
    }
}
