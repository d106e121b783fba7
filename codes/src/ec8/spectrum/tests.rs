use super::*;
use crate::samples::close;
use proptest::prelude::*;

fn site(ground: GroundType, spectrum: u8, ag: f64) -> Ec8Site {
    Ec8Site {
        ground,
        spectrum,
        ag,
        importance: 1.0,
        behaviour_factor: 1.0,
        construction_quality: 1.0,
        vertical: false,
        components: Default::default(),
        friction: None,
        reduction_factor: None,
        bearing_capacity: None,
    }
}

fn en(ground: GroundType, spectrum: u8, ag: f64) -> ElasticSpectrum {
    ElasticSpectrum::new(&site(ground, spectrum, ag)).unwrap()
}

/// EN 1998-1:2004 fig. 3.2 (table 3.2 evaluated by hand): a_g = 1, 5 %, type 1. Half the last printed digit.
#[test]
fn horizontal_reference_values() {
    let periods = [0.0, 0.1, 0.5, 1.0, 2.0, 4.0];
    for (ground, expected) in [
        (GroundType::A, [1.0, 2.0, 2.0, 1.0, 0.5, 0.125]),
        (GroundType::C, [1.15, 2.0125, 2.875, 1.725, 0.8625, 0.2156]),
        (GroundType::D, [1.35, 2.3625, 3.375, 2.7, 1.35, 0.3375]),
    ] {
        let spectrum = en(ground, 1, 1.0);
        for (t, s) in periods.iter().zip(expected) {
            close(spectrum.horizontal(*t, 0.05), s, 5e-5);
        }
    }
}

#[test]
fn damping_corrections() {
    close(damping_correction(0.05), 1.0, 1e-15);
    close(damping_correction(0.02), (10.0f64 / 7.0).sqrt(), 1e-15);
    // √(10/33.06) = 0.55: the bound takes over at 28.06 %.
    close(damping_correction(0.30), 0.55, 0.0);
    close(damping_correction_env(0.05), 1.0, 1e-15);
    close(damping_correction_env(0.01), 1.5275, 5e-5);
    close(damping_correction_env(0.30), 0.7, 0.0);
}

/// Dissertation table D.3: ground A, a_g = 0.5 g, ξ = 1 %, T = 2.096 s. Printed: η = 1.5, S_e = 0.36 g, d = 55.0 cm.
#[test]
fn env_table_d3() {
    let g = 9.81;
    let spectrum = EnvSpectrum::new(&site(GroundType::A, 1, 0.5 * g)).unwrap();
    let unrounded = spectrum.horizontal(2.096, 0.01) / g;
    close(unrounded, 0.3644, 5e-5);
    close(0.84 * 1.83 * unrounded, 0.560, 5e-4);
    // As printed, with η rounded to 1.5 and T to 2.09 s: S_e = 0.3589 g, d = 0.5516 m, printed 0.36 and 55.0 cm.
    let printed = 0.5 * 2.5 * 1.5 * 0.4 / 2.09;
    close(printed, 0.3589, 5e-5);
    close(printed, 0.36, 5e-3);
    close(0.84 * 1.83 * printed, 0.5516, 5e-5);
    // The printed 55.0 cm is 55.2 cut: 0.2 cm off, more than rounding, less than any other reading explains.
    close(0.84 * 1.83 * printed, 0.550, 2e-3);
    // The same tank by EN 1998-1:2004, type 1, ground A, 0.5 %: T > T_D.
    let en = en(GroundType::A, 1, 0.5 * g);
    let (se, branch) = en.horizontal_with_branch(2.096, 0.005);
    assert_eq!(branch, Branch::ConstantDisplacement);
    close(se / g, 0.307, 5e-4);
    close(0.84 * 1.83 * se / g, 0.472, 5e-4);
}

/// Ground C, γ_I a_gR = 1.2 × 0.25 g, type 1: values of the worked example of the annex (1/T² branch beyond 4 s).
#[test]
fn worked_example_ordinates() {
    let spectrum = ElasticSpectrum::new(&Ec8Site { importance: 1.2, ..site(GroundType::C, 1, 0.25 * 9.81) }).unwrap();
    close(spectrum.ag, 2.943, 1e-12);
    close(spectrum.horizontal(0.19050, 0.02), 9.7933, 2e-4); // T printed to 5e-6 s: 5e-6/0.2 × 1.99 × 3.38 = 1.7e-4
    close(spectrum.horizontal_continued(6.0935, 0.005), 0.3687, 5e-5);
    close(spectrum.vertical(0.1786, 0.03), 7.463, 2.5e-3); // T printed to 5e-5 s: 5e-5/0.1786 × 7.46 = 2.1e-3
    // Annex A by hand: d_g = 0.025 × 3.38445 × 0.6 × 2 = 0.1015335 m, b = 2.5 √(10/5.5) = 3.370999,
    // S_De = d_g (3.370999 − 0.023375 × 2.370999) = 0.336643 m, times (2π/6.0935)² = 1.063233.
    close(spectrum.horizontal(6.0935, 0.005), 0.35793, 5e-5);
}

#[test]
fn type_2_has_no_annex_a() {
    let spectrum = en(GroundType::D, 2, 1.0);
    assert_eq!(spectrum.horizontal_with_branch(6.0, 0.005).1, Branch::Continued);
    assert_eq!(spectrum.displacement_long(6.0, 0.05), None);
    close(spectrum.horizontal(6.0, 0.05), 1.8 * 2.5 * 0.3 * 1.2 / 36.0, 1e-12);
    // 0.45 a_g on the plateau 3.0 η.
    close(spectrum.vertical(0.1, 0.05), 1.35, 1e-12);
}

/// Table 3.3, type 2, on the plateau: 2.5 S.
#[test]
fn type_2_plateaus() {
    use GroundType::*;
    for (ground, soil) in [(A, 1.0), (B, 1.35), (C, 1.5), (D, 1.8), (E, 1.6)] {
        close(en(ground, 2, 1.0).horizontal(0.2, 0.05), 2.5 * soil, 1e-12);
    }
}

#[test]
fn design_spectrum_has_a_floor_and_two_thirds_at_zero() {
    let spectrum = en(GroundType::C, 1, 1.0);
    close(spectrum.design(0.0, 1.5), 1.15 * 2.0 / 3.0, 1e-12);
    close(spectrum.design(0.4, 1.5), 1.15 * 2.5 / 1.5, 1e-12);
    close(spectrum.design(1.2, 1.0), 1.15 * 2.5 * 0.5, 1e-12);
    close(spectrum.design(20.0, 1.5), 0.2, 1e-12);
}

#[test]
fn faults_are_reported() {
    assert!(ElasticSpectrum::new(&site(GroundType::A, 3, 1.0)).is_err());
    assert!(ElasticSpectrum::new(&site(GroundType::A, 1, f64::NAN)).is_err());
    assert!(matches!(EnvSpectrum::new(&site(GroundType::D, 1, 1.0)), Err(CodeError::NotApplicable(_))));
}

fn ground() -> impl Strategy<Value = GroundType> {
    use GroundType::*;
    prop::sample::select(vec![A, B, C, D, E])
}

proptest! {
    /// Continuous at every control period, but for the documented drop of 1.3 % at 4 s.
    #[test]
    fn continuous_at_corners(ground in ground(), kind in 1u8..=2, damping in 0.001f64..0.4) {
        let s = en(ground, kind, 1.7);
        let near = |f: &dyn Fn(f64) -> f64, t: f64| (f(t * (1.0 + 1e-9)) / f(t * (1.0 - 1e-9)) - 1.0).abs() < 1e-7;
        let mut corners = s.corners.to_vec();
        corners.extend(s.long_corners.into_iter().flatten());
        for t in corners {
            prop_assert!(near(&|t| s.horizontal(t, damping), t));
            prop_assert!(t > LONGEST_PERIOD || near(&|t| s.design(t, 1.5), t));
        }
        for t in ElasticSpectrum::VERTICAL_CORNERS {
            prop_assert!(near(&|t| s.vertical(t, damping), t));
        }
        let jump = s.horizontal(4.0 + 1e-9, damping) / s.horizontal(4.0, damping);
        let expected = if kind == 1 { 0.1 * PI * PI } else { 1.0 };
        prop_assert!((jump - expected).abs() < 1e-7);
        if !matches!(ground, GroundType::D | GroundType::E) {
            let env = EnvSpectrum::new(&site(ground, 1, 1.7)).unwrap();
            for t in env.corners.into_iter().chain([0.15, 0.5]) {
                prop_assert!(near(&|t| env.horizontal(t, damping), t));
                prop_assert!(near(&|t| env.vertical(t, damping), t));
            }
        }
    }

    /// Beyond the plateau the ordinate falls with the period; more damping never raises it; it scales with a_g; and the
    /// continued branch bounds annex A from above.
    #[test]
    fn monotone_and_linear(ground in ground(), kind in 1u8..=2, t in 0.0f64..20.0, dt in 0.0f64..5.0,
                           damping in 0.001f64..0.4, more in 0.0f64..0.3, factor in 0.01f64..10.0) {
        let s = en(ground, kind, 1.0);
        let late = t + s.corners[1];
        prop_assert!(s.horizontal(late + dt, damping) <= s.horizontal(late, damping) * (1.0 + 1e-12));
        prop_assert!(s.horizontal(t, damping + more) <= s.horizontal(t, damping) * (1.0 + 1e-12));
        let scaled = en(ground, kind, factor).horizontal(t, damping);
        prop_assert!((scaled - factor * s.horizontal(t, damping)).abs() <= 1e-12 * scaled);
        prop_assert!(s.horizontal(t, damping) <= s.horizontal_continued(t, damping) * (1.0 + 1e-12));
    }
}
