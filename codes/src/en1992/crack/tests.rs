//! Source:    worked example of calculocivil.com (EC2, "fisura"), as kept in the verification tests of xcfem/xc
//!            (`test_crack_control_01.py`); elastic cracked sections by hand
//! Goal:      s_r,max, ε_sm − ε_cm, w_k; neutral axis and stress of the cracked section; the limit of EN 1992-3
//! Tolerance: 1e-3 of the example: its modulus E_cm is that of the formula 22 (f_cm/10)^0.3 GPa, 31.476, printed digits kept below

use super::*;

fn bars(depth: f64, area: f64, diameter: f64) -> Bars {
    Bars { depth, area, diameter: Some(diameter), yield_strength: 500e6, modulus: 200e9 }
}

fn wall(thickness: f64, strength: f64, modulus: f64, bars: Vec<Bars>) -> Section {
    Section { thickness, strength, modulus, bars, factors: (1.5, 1.15) }
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// b = 0.4 m, h = 0.3 m, c = 35 mm, 3 Ø 16 (603.19 mm²), C25, σ_s = 175.74 MPa, h_c,ef taken as 2 (h − d) = 86 mm there:
/// s_r,max = 274.123 mm, ε_sm − ε_cm = 0.553542 ‰, w_k = 0.151738 mm.
#[test]
fn published_example() {
    let area = 3.0 * 0.25 * std::f64::consts::PI * 0.016f64.powi(2);
    let ratio = area / (0.4 * 0.086);
    let s = spacing(0.035, 0.016, ratio, 0.5);
    near(s, 0.274_123_0, 1e-6);
    let e_cm = 22e9 * (33.0f64 / 10.0).powf(0.3);
    let strain = mean_strain(175.74e6, 200e9, e_cm, tensile_strength(25e6), ratio, LASTING);
    near(strain, 0.553_541_5e-3, 1e-3);
    near(s * strain, 0.151_738_5e-3, 1e-3);
}

/// Pure bending, one layer, by the quadratic: x = −α ρ d + √((α ρ d)² + 2 α ρ d²), σ_s = M/(A (d − x/3)).
#[test]
fn bending_of_the_cracked_section() {
    let (a, d, alpha) = (1e-3, 0.2, 200.0 / 33.0);
    let s = wall(0.25, 30e6, 33e9, vec![bars(0.05, a, 0.016)]);
    let aa: f64 = alpha * a;
    let x = -aa + (aa * aa + 2.0 * aa * d).sqrt();
    let (state, face) = cracked(&s, 0.0, 50e3).unwrap();
    assert_eq!(face, Face::Inner);
    near(state.compressed, x, 1e-9);
    let w = width(&s, 0.0, 50e3, 2.9e6, LASTING).unwrap();
    near(w.stress, 50e3 / (a * (d - x / 3.0)), 1e-9);
    near(w.effective, ((0.25 - x) / 3.0).min(0.125), 1e-9);
    assert_eq!(w.distribution, 0.5);
    near(w.cover, 0.042, 1e-12);
    // The outer face pulls: the only bars are in the compressed half.
    assert_eq!(width(&s, 0.0, -50e3, 2.9e6, LASTING), None);
}

/// Pure tension: σ_s = N/ΣA, k_2 = 1; with an eccentricity inside the bars N/2 ± M/z.
#[test]
fn tension_cracked_through() {
    let s = wall(0.25, 30e6, 33e9, vec![bars(0.05, 1e-3, 0.016), bars(0.2, 1e-3, 0.016)]);
    let w = width(&s, 0.3e6, 0.0, 2.9e6, LASTING).unwrap();
    near(w.stress, 150e6, 1e-5);
    near(w.effective, 0.125, 1e-9);
    assert!((w.distribution - 1.0).abs() < 1e-5);
    // s = 3.4·42 + 0.34·16·125/1.0 = 822.8 mm; bars every 201 mm ≤ 5·50 mm.
    near(w.spacing, 3.4 * 0.042 + 0.34 * 0.016 * 0.125 / 1e-3, 1e-5);
    // 0.4·2.9/0.008·(1 + 6.06·0.008) = 152 MPa > 0.4·150 MPa: the lower bound 0.6 σ_s/E_s.
    near(w.strain, 0.6 * 150e6 / 200e9, 1e-5);
    let w = width(&s, 0.3e6, 5e3, 2.9e6, LASTING).unwrap();
    near(w.stress, (0.15e6 + 5e3 / 0.15) / 1e-3, 1e-6);
    assert_eq!(w.compressed, 0.0);
    // The same moment with the other sign: the other face, the same width.
    near(width(&s, 0.3e6, -5e3, 2.9e6, LASTING).unwrap().width, w.width, 1e-9);
}

/// Force and moment of the stress state are those given, over the whole range of eccentricities; equilibrium summed independently.
#[test]
fn equilibrium_of_the_stress_state() {
    let s = wall(0.4, 30e6, 33e9, vec![bars(0.05, 1.5e-3, 0.016), bars(0.35, 0.8e-3, 0.012)]);
    for (n, m) in [(0.2e6, 60e3), (0.05e6, 60e3), (-0.2e6, 60e3), (-0.05e6, 60e3), (0.2e6, -20e3), (0.3e6, 5e3)] {
        let (state, face) = cracked(&s, n, m).unwrap();
        let strain = |y: f64| state.opposite + (state.strain - state.opposite) * y / 0.4;
        let parts = 4000;
        let (mut force, mut moment) = (0.0, 0.0);
        for i in 0..parts {
            let y = 0.4 * (f64::from(i) + 0.5) / f64::from(parts);
            let stress = 33e9 * strain(y).min(0.0) * 0.4 / f64::from(parts);
            force += stress;
            moment += stress * (y - 0.2);
        }
        for b in &s.bars {
            let y = s.effective_depth(b, face);
            force += b.area * 200e9 * strain(y);
            moment += b.area * 200e9 * strain(y) * (y - 0.2);
        }
        // Midpoint rule: 1e-6 of the largest term.
        assert!((force - n).abs() < 1e-4 * m.abs() / 0.4, "{force} {n}");
        let signed = if face == Face::Inner { m } else { -m };
        assert!((moment - signed).abs() < 1e-4 * m.abs(), "{moment} {m}");
    }
    // Pressed without tension: no crack.
    assert_eq!(cracked(&s, -1e6, 1e3), None);
    assert_eq!(width(&s, -1e6, 1e3, 2.9e6, LASTING).unwrap().width, 0.0);
}

/// EN 1992-3 7.3.1: 0.2 mm up to h_D/h = 5, 0.05 mm from 35, linear between; f_ctm = 2.9 MPa of C30, 4.2 of C55.
#[test]
fn limits_of_the_width() {
    for (gradient, limit_mm) in [(1.0, 0.2), (5.0, 0.2), (20.0, 0.125), (35.0, 0.05), (60.0, 0.05)] {
        near(limit(1, gradient * 0.25, 0.25, 0.0), limit_mm * 1e-3, 1e-9);
    }
    assert_eq!((limit(0, 8.0, 0.25, 0.0), limit(1, 8.0, 0.25, 0.05)), (0.3e-3, 0.3e-3));
    assert!((tensile_strength(30e6) / 1e6 - 2.9).abs() < 0.05 && (tensile_strength(55e6) / 1e6 - 4.2).abs() < 0.05);
}
