//! Source:    API 650, 9th edition, appendix E (tables E-2, E-3; figures E-2, E-3, E-4); 12th and 13th edition, annex E
//!            (figure E.1, tables E.4, E.5, E.7; E.6.1.4)
//! Goal:      figures and tables, both branches of each, the values on either side of a limit
//! Expected:  the cells as printed; the closed forms of the figures evaluated outside this program, six digits
//! Tolerance: half the last digit of the expected value, 1e-12 where it is exact

use super::edition1993::convective_coefficient;
use super::edition2020::accelerations::acceleration_lines;
use super::edition2020::factors::{importance, response_modification};
use super::ground_motion::{DesignSpectrum, tests::site};
use super::hoop::hoop_forces;
use super::masses::{
    effective_masses, impulsive_coefficient, sloshing_coefficient, sloshing_coefficient_1993, sloshing_period,
    sloshing_period_1993,
};
use crate::samples::near as close;
use crate::sheet::Sheet;
use tank::case::{Api650Site, SiteClass};

/// Figures E-2, E-3, E-4 (k) of 1993, which are E.6.1.1, E.6.1.2 and E.4.5.2 (K_s) of 2020:
/// D/H, W_i/W_p, W_c/W_p, X_i/H, X_c/H, X_is/H, X_cs/H, k, K_s.
#[test]
fn effective_masses_heights_and_sloshing_coefficients() {
    for (d_over_h, [w_i, w_c, x_i, x_c, x_is, x_cs, k, k_s]) in [
        // Slender: D/H below 1.333.
        (0.8, [0.825600, 0.183962, 0.424800, 0.786409, 0.548000, 0.790567, 0.578060, 0.578058]),
        (1.0, [0.782000, 0.229702, 0.406000, 0.741059, 0.560000, 0.754077, 0.578375, 0.578368]),
        (1.2, [0.738400, 0.274785, 0.387200, 0.702360, 0.572000, 0.731202, 0.579276, 0.579255]),
        // Squat.
        (1.5, [0.663176, 0.339866, 0.375000, 0.656416, 0.628884, 0.723234, 0.582349, 0.582291]),
        (2.0, [0.542316, 0.437144, 0.375000, 0.605061, 0.796866, 0.772328, 0.592918, 0.592767]),
        (3.0, [0.380671, 0.580038, 0.375000, 0.554251, 1.188266, 1.047730, 0.630412, 0.630046]),
        (5.0, [0.230867, 0.719332, 0.375000, 0.521301, 2.040334, 2.113614, 0.730823, 0.730113]),
    ] {
        let m = effective_masses(d_over_h);
        for (symbol, value, expected) in [
            ("W_i", m.w_i, w_i),
            ("W_c", m.w_c, w_c),
            ("X_i", m.x_i, x_i),
            ("X_c", m.x_c, x_c),
            ("X_is", m.x_is, x_is),
            ("X_cs", m.x_cs, x_cs),
            ("k", sloshing_coefficient_1993(d_over_h), k),
            ("K_s", sloshing_coefficient(d_over_h), k_s),
        ] {
            close(value, expected, 5e-7, &format!("{symbol} at D/H = {d_over_h}"));
        }
        // T = k √D[ft]: 30 m are 98.4252 ft. T_c = 1.8 K_s √D[m].
        let d = 30.0;
        close(sloshing_period_1993(d, d_over_h), k * 98.425_196_85_f64.sqrt(), 5e-6, "T");
        close(sloshing_period(d, d_over_h), 1.8 * k_s * 30.0_f64.sqrt(), 5e-6, "T_c");
    }
}

/// The threshold is D/H = 1.333, itself on the squat branch: there X_i jumps from 0.374698 to 0.375.
#[test]
fn charts_change_their_branch_at_1_333() {
    close(effective_masses(1.333).x_i, 0.375, 0.0, "X_i at 1.333");
    close(effective_masses(1.333 - 1e-12).x_i, 0.500 - 0.094 * 1.333, 1e-9, "X_i below");
}

/// Figure E.1 against H/D; it ends at H/D = 0.15 and 1.5.
#[test]
fn figure_e_1_impulsive_coefficient() {
    for (h_over_d, c_i) in
        [(0.15, 9.28), (0.25, 7.74), (0.35, 6.97), (0.50, 6.36), (0.75, 6.06), (1.00, 6.21), (1.25, 6.56), (1.50, 7.03)]
    {
        let found = impulsive_coefficient(h_over_d);
        close(found.unwrap(), c_i, 1e-9, &format!("H/D = {h_over_d}"));
    }
    assert_eq!(impulsive_coefficient(0.15 - 1e-6), None);
    assert_eq!(impulsive_coefficient(1.50 + 1e-6), None);
}

/// 1993: C_2 = 0.75 S/T up to 4.5 s, 3.375 S/T² above, for the four soils of table E-3.
#[test]
fn table_e_3_and_c_2_of_1993() {
    for s in [1.0, 1.2, 1.5, 2.0] {
        for (t, expected) in [(0.75, s), (3.0, 0.25 * s), (4.5, s / 6.0), (6.0, 0.09375 * s)] {
            close(convective_coefficient(s, t), expected, 1e-12, &format!("S = {s}, T = {t}"));
        }
    }
}

/// Table E.5: importance of the seismic use groups. Table E.4: R_wi 3.5 self-anchored, 4.0 mechanically anchored.
#[test]
fn tables_e_4_and_e_5() {
    for (sug, i) in [(1, 1.0), (2, 1.25), (3, 1.5)] {
        assert_eq!(importance(sug), Ok(i));
    }
    for sug in [0, 4, 255] {
        let message = importance(sug).unwrap_err().to_string();
        assert!(message.contains("allowed are 1, 2 and 3"), "{message}");
    }
    assert_eq!((response_modification(false), response_modification(true)), (3.5, 4.0));
}

/// E.4.6.1, E.6.1.3, E.7.2 by hand: Q = 1, F_a S_s = 1.2, F_v S_1 = 0.6, T_L = 6 s, K = 1.5, R_wc = 2.
#[test]
fn accelerations_of_each_use_group_and_branch() {
    for (sug, i) in [(1, 1.0), (2, 1.25), (3, 1.5)] {
        let s = Api650Site { ss: 1.0, s1: 0.4, fa: Some(1.2), fv: Some(1.5), q: 1.0, tl: 6.0, sug, ..site() };
        let spectrum = DesignSpectrum::new(&s).unwrap();
        for (t_c, a_c, a_f) in [
            // 1/T_c; A_f of SUG I and II with I, of SUG III without.
            (3.0, 1.5 * 0.6 / 3.0 * i / 2.0, 1.5 * 0.6 / 3.0 * if sug == 3 { 1.0 } else { i }),
            // Between 4 s and T_L: A_f of SUG I and II falls with 4/T².
            (5.0, 1.5 * 0.6 / 5.0 * i / 2.0, if sug == 3 { 1.5 * 0.6 / 5.0 } else { 1.5 * 0.6 * i * 4.0 / 25.0 }),
            // Beyond T_L.
            (
                8.0,
                1.5 * 0.6 * 6.0 / 64.0 * i / 2.0,
                if sug == 3 { 1.5 * 0.6 * 6.0 / 64.0 } else { 1.5 * 0.6 * i * 4.0 / 64.0 },
            ),
        ] {
            for (anchored, r_wi) in [(false, 3.5), (true, 4.0)] {
                let a = acceleration_lines(&mut Sheet::new(), &s, &spectrum, t_c, anchored).unwrap();
                let what = format!("SUG {sug}, T_c = {t_c}, R_wi = {r_wi}");
                close(a.a_i, 1.2 * i / r_wi, 1e-12, &what);
                close(a.a_c, a_c.min(a.a_i), 1e-12, &what);
                close(a.a_f, a_f, 1e-12, &what);
                close(a.a_v, 0.47 * 1.2, 1e-12, &what);
            }
        }
    }
    // Soft ground only: A_i ≥ 0.5 S_1 I/R_wi.
    for (site_class, a_i) in
        [(SiteClass::A, 0.1 / 3.5), (SiteClass::D, 0.1 / 3.5), (SiteClass::E, 0.4 / 3.5), (SiteClass::F, 0.4 / 3.5)]
    {
        let s = Api650Site { ss: 0.1, s1: 0.8, fa: Some(1.0), fv: Some(1.0), q: 1.0, sug: 1, site_class, ..site() };
        let a = acceleration_lines(&mut Sheet::new(), &s, &DesignSpectrum::new(&s).unwrap(), 5.0, false).unwrap();
        close(a.a_i, a_i, 1e-12, &format!("class {site_class:?}"));
    }
}

/// ASCE 7 design spectrum by hand: S_DS = 1, S_D1 = 0.5, T_0 = 0.1, T_S = 0.5, T_L = 4 s.
#[test]
fn asce_7_design_spectrum_branches() {
    let s = Api650Site { ss: 1.0, s1: 0.5, fa: Some(1.0), fv: Some(1.0), q: 1.0, tl: 4.0, ..site() };
    let spectrum = DesignSpectrum::new(&s).unwrap();
    close(spectrum.t_0, 0.1, 1e-15, "T_0");
    close(spectrum.t_s, 0.5, 1e-15, "T_S");
    for (t, s_a) in
        [(0.0, 0.4), (0.05, 0.7), (0.1, 1.0), (0.3, 1.0), (0.5, 1.0), (1.0, 0.5), (4.0, 0.125), (8.0, 0.03125)]
    {
        close(spectrum.acceleration(t), s_a, 1e-12, &format!("T = {t}"));
    }
}

/// E.6.1.4 on its three branches by hand, N/m; D = 10 m, G = 0.8, A_i = 0.2.
#[test]
fn e_6_1_4_hoop_forces() {
    let at = |y: f64, d: f64, h: f64| hoop_forces(y, d, h, 0.8, 0.2, 0.1, 0.3);
    // D/H = 2: 8.48·0.2·0.8·10·5·(0.4 − 0.08)·tanh(1.732) N/mm, tanh(1.732) = 0.9392918.
    let n = at(2.0, 10.0, 5.0);
    close(n.impulsive, 1e3 * 8.48 * 0.16 * 50.0 * 0.32 * 0.939_291_8, 2e-2, "squat");
    close(n.hydrostatic, 4.9e3 * 0.8 * 2.0 * 10.0, 1e-6, "N_h");
    close(n.vertical, 0.3 * 4.9e3 * 0.8 * 2.0 * 10.0 / 2.5, 1e-6, "A_v N_h/2.5");
    // cosh(3.68·3/10)/cosh(3.68·5/10) = 1.6738745/3.2276778.
    close(n.convective, 1850.0 * 0.1 * 0.8 * 100.0 * 1.673_874_5 / 3.227_677_8, 1e-2, "N_c");
    // D/H = 0.5: the parabola ends at Y = 0.75 D = 7.5 m.
    close(at(3.0, 10.0, 20.0).impulsive, 5.22e3 * 0.16 * 100.0 * 0.32, 1e-6, "upper part");
    for y in [7.5, 9.0, 20.0] {
        close(at(y, 10.0, 20.0).impulsive, 2.6e3 * 0.16 * 100.0, 1e-6, "lower part");
    }
    // The threshold itself, D/H = 1.333, is squat: at Y = H 4.24·D·H·tanh(1.154378) against 2.6·D².
    let threshold = at(10.0, 13.33, 10.0).impulsive;
    close(threshold, 1e3 * 8.48 * 0.16 * 133.3 * 0.5 * 0.819_199_2, 2e-2, "threshold");
}
