//! Source:    equilibrium by hand, in each test
//! Goal:      M_Rd with N of a wall 25 cm thick, C30/37 (f_cd = 20 MPa), B500 (f_yd = 434.78 MPa), bars 5 cm from the faces
//! Tolerance: 1e-9 against closed forms (bisection to rounding), half the last digit against printed numbers

use super::*;
use proptest::prelude::*;

const F_YD: f64 = 500e6 / 1.15;

fn bars(depth: f64, area: f64) -> Bars {
    Bars { depth, area, diameter: Some(0.016), yield_strength: 500e6, modulus: 200e9 }
}

fn section(bars: Vec<Bars>) -> Section {
    Section { thickness: 0.25, strength: 30e6, modulus: 33e9, bars, factors: (1.5, 1.15) }
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} instead of {expected}");
}

/// Pure bending, one layer: λx = A f_yd/f_cd = 1000·434.78/(20·1000) = 21.74 mm, M = 434.78 kN (200 − 10.87) mm = 82.23 kNm/m.
#[test]
fn pure_bending_of_one_layer() {
    let s = section(vec![bars(0.05, 1e-3)]);
    let m = s.bending_resistance(0.0, Face::Inner).unwrap();
    let block = 1e-3 * F_YD / 20e6;
    near(m, 1e-3 * F_YD * (0.2 - 0.5 * block));
    assert!((m - 82.23e3).abs() < 5.0, "{m}");
}

/// Pure tension: A f_yd, without a moment where the bars are symmetric, with that of their eccentricity otherwise.
#[test]
fn pure_tension() {
    let s = section(vec![bars(0.05, 1e-3), bars(0.2, 1e-3)]);
    near(s.tension_resistance(), 2e-3 * F_YD);
    near(s.utilisation(0.3e6, 0.0), 0.3e6 / (2e-3 * F_YD));
    let one_sided = section(vec![bars(0.05, 2e-3), bars(0.2, 1e-3)]);
    let whole = one_sided.tension_resistance();
    // More steel inside: at full tension the only moment resisted pulls on the inner face, 0.075 m × 1000 mm² × f_yd.
    let moment = 0.075 * 1e-3 * F_YD;
    assert!((one_sided.bending_resistance(whole, Face::Inner).unwrap() - moment).abs() < 1e-3 * moment);
    assert!((one_sided.bending_resistance(whole, Face::Outer).unwrap() + moment).abs() < 1e-3 * moment);
    assert!(one_sided.resists(0.999 * whole, moment) && !one_sided.resists(0.999 * whole, 0.0));
}

/// Tension with a moment: both layers yield while x < 50 mm · 3.5/(3.5 + 2.174), so that the block balances C = 2 A f_yd − N alone and
/// M = C (h − λx)/2. Without the block, N/2 + M/z = A f_yd would give less.
#[test]
fn tension_with_a_moment() {
    let s = section(vec![bars(0.05, 1e-3), bars(0.2, 1e-3)]);
    let n = 0.6e6;
    let block = 2e-3 * F_YD - n;
    let found = s.bending_resistance(n, Face::Inner).unwrap();
    near(found, 0.5 * block * (0.25 - block / 20e6));
    assert!(found > 0.15 * (1e-3 * F_YD - 0.5 * n));
}

/// Compression with one layer: N = A f_yd − f_cd λx gives λx directly; M about the middle.
#[test]
fn interaction_points() {
    let s = section(vec![bars(0.05, 1e-3)]);
    for n in [-0.5e6, -0.1e6, 0.2e6] {
        let block = (1e-3 * F_YD - n) / 20e6;
        let expected = 1e-3 * F_YD * 0.075 + 20e6 * block * (0.125 - 0.5 * block);
        near(s.bending_resistance(n, Face::Inner).unwrap(), expected);
    }
    // Balanced point: steel yields as the concrete crushes, x = d 3.5/(3.5 + f_yd/E_s) = 0.2 · 0.61687.
    let x: f64 = 0.2 * 3.5e-3 / (3.5e-3 + F_YD / 200e9);
    let n = 1e-3 * F_YD - 20e6 * 0.8 * x;
    let expected = 1e-3 * F_YD * 0.075 + 20e6 * 0.8 * x * (0.125 - 0.4 * x);
    near(s.bending_resistance(n, Face::Inner).unwrap(), expected);
    assert_eq!(s.bending_resistance(-6e6, Face::Inner), None);
    assert_eq!(s.bending_resistance(0.5e6, Face::Inner), None);
}

/// Bars near the inner face do not help where the outer one pulls.
#[test]
fn the_face_counts() {
    let s = section(vec![bars(0.05, 1e-3)]);
    let (inner, outer) = (s.bending_resistance(0.0, Face::Inner), s.bending_resistance(0.0, Face::Outer));
    assert!(inner > outer.map(|m| 4.0 * m));
    assert!(s.utilisation(0.0, 50e3) < 1.0 && s.utilisation(0.0, -50e3) > 1.0);
    assert_eq!(section(Vec::new()).utilisation(1e3, 0.0), f64::INFINITY);
    assert_eq!(section(Vec::new()).utilisation(0.0, 1e3), f64::INFINITY);
}

/// Above C50: λ = 0.8 − 20/400, η = 1 − 20/200, ε_cu3 = 2.6 + 35·0.2⁴ = 2.656 ‰ for C70 (EN 1992-1-1 table 3.1: 2.7).
#[test]
fn strong_concrete() {
    let s = Section { strength: 70e6, ..section(Vec::new()) };
    let (lambda, eta, crushing) = s.block();
    assert!((lambda - 0.75).abs() < 1e-12 && (eta - 0.9).abs() < 1e-12);
    assert!((crushing * 1e3 - 2.7).abs() <= 0.05);
}

proptest! {
    /// The domain is convex and contains the origin: what is resisted stays resisted when it shrinks.
    #[test]
    fn shrinking_keeps_the_resistance(a in 2e-4f64..4e-3, b in 2e-4f64..4e-3, n in -1e6f64..1e6, m in -2e5f64..2e5, k in 0.0f64..1.0) {
        let s = section(vec![bars(0.05, a), bars(0.2, b)]);
        prop_assert!(!s.resists(n, m) || s.resists(k * n, k * m));
        // Both measures agree on what is resisted.
        if n > 0.0 {
            prop_assert_eq!(s.utilisation(n, m) <= 1.0 + 1e-9, s.resists(n * (1.0 - 1e-9), m * (1.0 - 1e-9)));
        }
    }
}
