//! Source:    EN 1998-1:2004 tables 3.2, 3.3, 3.4, A.1 (recommended values); ENV 1998-1-1:1994, 4.2.2; EN 1998-4:2006
//!            table A.2
//! Goal:      every cell; the shape of the spectra at every control period by hand
//! Expected:  the cells as printed
//! Tolerance: 1e-12, rounding

use super::simplified;
use super::spectrum::{Branch, ElasticSpectrum, EnvSpectrum};
use tank::case::Ec8Site;
use tank::case::GroundType::{self, A, B, C, D, E};

fn site(ground: GroundType, spectrum: u8) -> Ec8Site {
    Ec8Site {
        ground,
        spectrum,
        ag: 2.0,
        importance: 1.4,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    }
}

fn close(value: f64, expected: f64, what: &str) {
    assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{what}: {value} {expected}");
}

/// The fields hold the cells, and the ordinates at 5 % are those of 3.2.2.2 at and between the control periods.
fn horizontal(ground: GroundType, kind: u8, [s, t_b, t_c, t_d]: [f64; 4], long: Option<[f64; 2]>) {
    let what = format!("type {kind}, ground {ground:?}");
    let spectrum = ElasticSpectrum::new(&site(ground, kind)).expect(&what);
    assert_eq!((spectrum.soil, spectrum.corners), (s, [t_b, t_c, t_d]), "{what}");
    assert_eq!(spectrum.long_corners, long, "{what}");
    // a_g = γ_I a_gR = 1.4·2.0.
    let a_g = 2.8;
    close(spectrum.ag, a_g, &what);
    close(spectrum.peak(), a_g * s, &what);
    use Branch::*;
    for (t, ordinate, branch) in [
        (0.0, 1.0, Rising),
        (0.5 * t_b, 1.75, Rising),
        (t_b, 2.5, Rising),
        (0.5 * (t_b + t_c), 2.5, Plateau),
        (t_c, 2.5, Plateau),
        (0.5 * (t_c + t_d), 5.0 * t_c / (t_c + t_d), ConstantVelocity),
        (t_d, 2.5 * t_c / t_d, ConstantVelocity),
        (3.0, 2.5 * t_c * t_d / 9.0, ConstantDisplacement),
        (4.0, 2.5 * t_c * t_d / 16.0, ConstantDisplacement),
    ] {
        let (found, at) = spectrum.horizontal_with_branch(t, 0.05);
        close(found, a_g * s * ordinate, &format!("{what}, T = {t}"));
        assert_eq!(at, branch, "{what}, T = {t}");
        close(spectrum.horizontal(t, 0.05), found, &what);
    }
}

#[test]
fn en_1998_1_table_3_2_type_1_and_table_a_1() {
    for (ground, cells, t_e) in [
        (A, [1.0, 0.15, 0.4, 2.0], 4.5),
        (B, [1.2, 0.15, 0.5, 2.0], 5.0),
        (C, [1.15, 0.20, 0.6, 2.0], 6.0),
        (D, [1.35, 0.20, 0.8, 2.0], 6.0),
        (E, [1.4, 0.15, 0.5, 2.0], 6.0),
    ] {
        horizontal(ground, 1, cells, Some([t_e, 10.0]));
    }
}

#[test]
fn en_1998_1_table_3_3_type_2() {
    for (ground, cells) in [
        (A, [1.0, 0.05, 0.25, 1.2]),
        (B, [1.35, 0.05, 0.25, 1.2]),
        (C, [1.5, 0.10, 0.25, 1.2]),
        (D, [1.8, 0.10, 0.30, 1.2]),
        (E, [1.6, 0.05, 0.25, 1.2]),
    ] {
        horizontal(ground, 2, cells, None);
    }
}

/// Table 3.4: a_vg/a_g 0.90 and 0.45, T_B, T_C, T_D = 0.05, 0.15, 1.0 s; eq. (3.8) to (3.11): 3.0 instead of 2.5, no S.
#[test]
fn en_1998_1_table_3_4_vertical() {
    for (kind, ratio) in [(1, 0.90), (2, 0.45)] {
        for ground in [A, B, C, D, E] {
            let what = format!("type {kind}, ground {ground:?}");
            let spectrum = ElasticSpectrum::new(&site(ground, kind)).unwrap();
            let a_vg = ratio * 2.8;
            close(spectrum.vertical_peak(), a_vg, &what);
            for (t, ordinate) in [
                (0.0, 1.0),
                (0.025, 2.0),
                (0.05, 3.0),
                (0.10, 3.0),
                (0.15, 3.0),
                (0.30, 1.5),
                (1.0, 0.45),
                (2.0, 3.0 * 0.15 / 4.0),
            ] {
                close(spectrum.vertical(t, 0.05), a_vg * ordinate, &format!("{what}, T_v = {t}"));
            }
        }
    }
}

/// Annex A of EN 1998-1, type 1, at 5 %: S_De/(0.025 a_g S T_C T_D) = 2.5 up to T_E, 1.75 midway to T_F = 10 s, 1 above.
#[test]
fn en_1998_1_annex_a_displacement() {
    for (ground, t_c, t_e) in [(A, 0.4, 4.5), (B, 0.5, 5.0), (C, 0.6, 6.0), (D, 0.8, 6.0), (E, 0.5, 6.0)] {
        let spectrum = ElasticSpectrum::new(&site(ground, 1)).unwrap();
        let d_g = 0.025 * 2.8 * spectrum.soil * t_c * 2.0;
        for (t, factor) in [
            (4.0, 2.5),
            (0.5 * (4.0 + t_e), 2.5),
            (t_e, 2.5),
            (0.5 * (t_e + 10.0), 1.75),
            (0.75 * t_e + 2.5, 2.125),
            (10.0, 1.0),
            (15.0, 1.0),
        ] {
            let what = format!("ground {ground:?}, T = {t}");
            let found = spectrum.displacement_long(t, 0.05).unwrap();
            close(found, d_g * factor, &what);
            let omega = std::f64::consts::TAU / t;
            if t > 4.0 {
                let (acceleration, branch) = spectrum.horizontal_with_branch(t, 0.05);
                close(acceleration, d_g * factor * omega * omega, &what);
                assert_eq!(branch, Branch::AnnexA, "{what}");
            }
        }
    }
}

/// Design spectrum 3.2.2.5, q = 1.5, ground B, type 1: 2/3 at T = 0, 2.5/q on the plateau, β = 0.2 of a_g (not a_g S).
#[test]
fn en_1998_1_3_2_2_5_design_spectrum() {
    let spectrum = ElasticSpectrum::new(&site(B, 1)).unwrap();
    let peak = 2.8 * 1.2;
    for (t, expected) in [
        (0.0, peak * 2.0 / 3.0),
        (0.075, peak * (2.0 / 3.0 + 2.5 / 1.5) / 2.0),
        (0.15, peak * 2.5 / 1.5),
        (0.5, peak * 2.5 / 1.5),
        (1.0, peak * 2.5 / 1.5 * 0.5),
        (2.0, peak * 2.5 / 1.5 * 0.25),
        (2.5, peak * 2.5 / 1.5 * 0.5 * 2.0 / 6.25),
        // 2.5/1.5·1.2/16 = 0.125 of a_g lies below β = 0.2.
        (4.0, 0.2 * 2.8),
        (20.0, 0.2 * 2.8),
    ] {
        close(spectrum.design(t, 1.5), expected, &format!("T = {t}"));
    }
    // The bound acts on the branch of constant velocity too: q = 1.5, T = 2.0 on ground A, type 2 is beyond T_D = 1.2; at
    // 1.2 s 2.5/1.5·0.25/1.2 = 0.347 stays, with q = 4 0.130 does not.
    let spectrum = ElasticSpectrum::new(&site(A, 2)).unwrap();
    close(spectrum.design(1.2, 1.5), 2.8 * 2.5 / 1.5 * 0.25 / 1.2, "above the bound");
    close(spectrum.design(1.2, 4.0), 0.2 * 2.8, "at the bound");
}

#[test]
fn env_1998_1_1_4_2_2_parameters() {
    for (ground, soil, corners) in
        [(A, 1.0, [0.10, 0.40, 3.0]), (B, 1.0, [0.15, 0.60, 3.0]), (C, 0.9, [0.20, 0.80, 3.0])]
    {
        let what = format!("subsoil class {ground:?}");
        let spectrum = EnvSpectrum::new(&site(ground, 1)).unwrap();
        assert_eq!((spectrum.soil, spectrum.corners), (soil, corners), "{what}");
        let peak = 2.8 * soil;
        let [t_b, t_c, t_d] = corners;
        close(spectrum.peak(), peak, &what);
        for (t, ordinate) in [
            (0.0, 1.0),
            (0.5 * t_b, 1.75),
            (t_b, 2.5),
            (t_c, 2.5),
            (2.0 * t_c, 1.25),
            (t_d, 2.5 * t_c / t_d),
            (2.0 * t_d, 2.5 * t_c / t_d / 4.0),
        ] {
            close(spectrum.horizontal(t, 0.05), peak * ordinate, &format!("{what}, T = {t}"));
        }
        // Vertical: 0.7 up to 0.15 s, 0.5 from 0.5 s, linear between (0.6 at 0.325 s).
        close(spectrum.vertical_peak(), 0.7 * peak, &what);
        for (t, factor) in [(0.0, 0.7), (0.05, 0.7), (0.15, 0.7), (0.325, 0.6), (0.5, 0.5), (3.0, 0.5)] {
            let vertical = spectrum.vertical(t, 0.05) / spectrum.horizontal(t, 0.05);
            assert!((vertical - factor).abs() < 1e-12, "{what}, T = {t}: {vertical}");
        }
    }
}

/// Columns H/R, C_i, C_c, m_i/m, m_c/m, h_i/H, h_c/H, h_i′/H, h_c′/H.
#[test]
fn en_1998_4_table_a_2() {
    let cells = [
        [0.3, 9.28, 2.09, 0.176, 0.824, 0.400, 0.521, 2.640, 3.414],
        [0.5, 7.74, 1.74, 0.300, 0.700, 0.400, 0.543, 1.460, 1.517],
        [0.7, 6.97, 1.60, 0.414, 0.586, 0.401, 0.571, 1.009, 1.011],
        [1.0, 6.36, 1.52, 0.548, 0.452, 0.419, 0.616, 0.721, 0.785],
        [1.5, 6.06, 1.48, 0.686, 0.314, 0.439, 0.690, 0.555, 0.734],
        [2.0, 6.21, 1.48, 0.763, 0.237, 0.448, 0.751, 0.500, 0.764],
        [2.5, 6.56, 1.48, 0.810, 0.190, 0.452, 0.794, 0.480, 0.796],
        [3.0, 7.03, 1.48, 0.842, 0.158, 0.453, 0.825, 0.472, 0.825],
    ];
    let found = |slenderness: f64| {
        let row = simplified::table(slenderness).unwrap();
        [
            row.impulsive_period,
            row.convective_period,
            row.impulsive_mass,
            row.convective_mass,
            row.impulsive_lever,
            row.convective_lever,
            row.impulsive_lever_with_base,
            row.convective_lever_with_base,
        ]
    };
    for row in cells {
        for (value, cell) in found(row[0]).iter().zip(&row[1..]) {
            close(*value, *cell, &format!("H/R = {}", row[0]));
        }
    }
    // Straight between the rows.
    for pair in cells.windows(2) {
        let at = 0.25 * pair[0][0] + 0.75 * pair[1][0];
        for (i, value) in found(at).iter().enumerate() {
            let expected = 0.25 * pair[0][i + 1] + 0.75 * pair[1][i + 1];
            close(*value, expected, &format!("H/R = {at}, column {}", i + 1));
        }
    }
    assert_eq!(simplified::LIMITS, (0.3, 3.0));
    assert!(simplified::table(0.3 - 1e-9).is_none() && simplified::table(3.0 + 1e-9).is_none());
}
