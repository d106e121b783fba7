//! The user's spectrum in the procedures of Eurocode 8, and S_d beside S_e/q.
//!
//! Source:    the recommended spectra of EN 1998-1:2004 (tables 3.2 to 3.4) as the user's; equations (3.13) to (3.16) by hand
//! Goal:      own parameters and own tables take the place of ground type, spectrum type and a_gR and change nothing else
//! Model:     the oil tank of `example`, ground C, vertical motion included
//! Tolerance: parameters: none. Tables: chords of a step h lie above 1/T² by at most 0.75 (h/T)², above 1/T by 0.25 (h/T)²; with
//!            h = 2 ms that is 4e-5 at the shortest such period (0.15 s, vertical spectrum)

use super::example::{line, oil_tank, site};
use super::spectrum::{ElasticSpectrum, EnvSpectrum};
use super::*;
use crate::procedure::CodeError;
use crate::sheet::Sheet;
use tank::case::{Ec8Site, GroundType};
use tank::hazard::{SiteSpectrum, SpectrumParameters, SpectrumTable};

/// The oil tank with vertical motion.
fn tank() -> Case {
    let mut case = oil_tank();
    case.site.ec8 = Some(Ec8Site { vertical: true, behaviour_factor: 1.5, ..site() });
    case
}

/// The same under a spectrum of the user; ground and a_gR of the site would give another.
fn under(form: SpectrumForm) -> Case {
    let mut case = tank();
    case.site.ec8 = case.site.ec8.map(|site| Ec8Site { ground: GroundType::A, spectrum: 2, ag: 0.01, ..site });
    case.site.spectrum = Some(SiteSpectrum { form, vertical_ratio: 0.9 });
    case
}

/// Parameters of ground C, type 1 and its pre-standard counterpart.
fn parameters(soil: f64, corners: [f64; 3]) -> SpectrumForm {
    SpectrumForm::Parameters(SpectrumParameters { ag: site().ag, soil, corners, long_corners: Some([6.0, 10.0]) })
}

/// Rows every 2 ms up to a period [s].
fn sampled(until: f64, spectrum: impl Fn(f64) -> f64) -> SpectrumTable {
    let rows = (0..=(until * 500.0) as u32).map(|i| {
        let period = f64::from(i) / 500.0;
        [period, spectrum(period)]
    });
    SpectrumTable::new(rows.collect()).unwrap()
}

/// The recommended spectra as tables at 5 %, importance taken out.
fn table(until: f64) -> SpectrumForm {
    let spectrum = ElasticSpectrum::new(&Ec8Site { importance: 1.0, ..site() }).unwrap();
    SpectrumForm::Table {
        damping: 0.05,
        horizontal: sampled(until, |t| spectrum.horizontal(t, 0.05)),
        vertical: Some(sampled(until, |t| spectrum.vertical(t, 0.05))),
    }
}

/// Demands of all comparisons and all values.
fn numbers(assessment: &Assessment) -> Vec<(String, f64)> {
    let values = assessment.values.iter().map(|(quantity, value)| (quantity.id().to_owned(), *value));
    let demands = assessment.checks.iter().filter_map(|c| Some((c.id.clone(), c.demand?)));
    values.chain(demands).collect()
}

#[test]
fn own_parameters_of_a_ground_type_change_no_number() {
    for (procedure, soil, corners) in
        [(&En2006 as &dyn Procedure, 1.15, [0.2, 0.6, 2.0]), (&Env1998, 0.9, [0.2, 0.8, 3.0])]
    {
        let expected = procedure.assess(&tank(), Excitation::Site).unwrap();
        let found = procedure.assess(&under(parameters(soil, corners)), Excitation::Site).unwrap();
        assert_eq!(numbers(&found), numbers(&expected));
        let clauses = found.steps.iter().filter(|s| s.clause.contains("ground A"));
        assert_eq!(clauses.count(), 0);
    }
    let site = Ec8Site { importance: 1.0, ..site() };
    let SpectrumForm::Parameters(given) = parameters(0.9, [0.2, 0.8, 3.0]) else { unreachable!() };
    assert_eq!(EnvSpectrum::of_parameters(&given, 1.0), EnvSpectrum::new(&site).unwrap());
}

/// Sloshing at 5 %: between T_E and T_F annex A is not proportional to η, so a table at 5 % cannot give 0.5 % there.
#[test]
fn a_sampled_table_gives_the_same_assessment() {
    let at_5 = |mut case: Case| {
        case.damping.sloshing = 0.05;
        En2006.assess(&case, Excitation::Site).unwrap()
    };
    let (expected, found) = (at_5(tank()), at_5(under(table(12.0))));
    for ((id, value), (_, exact)) in numbers(&found).iter().zip(numbers(&expected)) {
        assert!((value / exact - 1.0).abs() < 4e-5, "{id}: {value} {exact}");
    }
    assert_eq!(numbers(&found).len(), numbers(&expected).len());
    assert!(found.assumptions.iter().any(|a| a.contains("linear between its rows")));
}

/// T_c1 of the oil tank is 6.0 s.
#[test]
fn a_table_that_ends_below_the_sloshing_period_is_refused() {
    let error = En2006.assess(&under(table(4.0)), Excitation::Site).unwrap_err();
    let text = error.to_string();
    assert!(matches!(error, CodeError::Data { .. }), "{text}");
    assert!(text.contains("ends at 4 s") && text.contains("sloshing period"), "{text}");
}

/// Without a vertical table a_vg = 0.9 γ_I S_t(0): S = 1.15 of the ground is in S_t(0), so 1.15 times the recommended value.
#[test]
fn vertical_motion_without_a_vertical_table() {
    let mut case = under(table(12.0));
    if let Some(SiteSpectrum { form: SpectrumForm::Table { vertical, .. }, .. }) = &mut case.site.spectrum {
        *vertical = None;
    }
    let expected = En2006.assess(&tank(), Excitation::Site).unwrap();
    let found = En2006.assess(&case, Excitation::Site).unwrap();
    for symbol in ["a_vg", "S_ve(T_vd)"] {
        let ratio = line(&found, symbol) / line(&expected, symbol);
        assert!((ratio - 1.15).abs() < 1e-12, "{symbol}: {ratio}");
    }
}

/// (3.13) to (3.16) for a_g = 2 m/s², S = 1.2, T_B = 0.15 s, T_C = 0.5 s, T_D = 2 s, q = 1.5: at 0: 2/3·2.4 = 1.6; T_B and T_C:
/// 2.4·2.5/1.5 = 4; T_D: 4·0.5/2 = 1; 5 s: 4·0.5·2/25 = 0.16 is below 0.2·2 = 0.4.
#[test]
fn design_spectrum_by_hand() {
    let spectrum =
        ElasticSpectrum { ag: 2.0, soil: 1.2, corners: [0.15, 0.5, 2.0], long_corners: None, vertical_ratio: 0.9 };
    for (period, value) in [(0.0, 1.6), (0.075, 2.8), (0.15, 4.0), (0.5, 4.0), (2.0, 1.0), (5.0, 0.4)] {
        let found = design_spectrum::line(&mut Sheet::new(), &spectrum, "S_d", period, 1.5);
        assert!((found - value).abs() < 1e-14, "{period}: {found}");
        assert!((spectrum.design(period, 1.5) - value).abs() < 1e-14);
    }
}

/// On the plateau S_e/q = 2.5 a η/q and S_d = 2.5 a/q: at 2 % η = √(10/7), S_e governs; at 10 % η = √(10/15), S_d governs; at 5 % both
/// are the same, and so they are on the rising branch with q = 1.5. On ground A the plateau is from 0.15 s to 0.4 s.
#[test]
fn the_larger_one_of_both_spectra_acts() {
    for (damping, ratio, governs) in [
        (0.02, (10.0_f64 / 7.0).sqrt(), "S_e/q at ξ = 2 % governs"),
        (0.05, 1.0, "S_e/q at ξ = 5 % governs"),
        (0.10, 1.0, "S_d governs"),
    ] {
        let mut case = tank();
        case.damping.impulsive = damping;
        case.site.ec8 = case.site.ec8.map(|site| Ec8Site { ground: GroundType::A, ..site });
        let found = En2006.assess(&case, Excitation::Site).unwrap();
        let a_i = found.steps.iter().find(|s| s.symbol == "A_i").expect("a line");
        let design = line(&found, "S_d(T_i)");
        assert!((a_i.value / design - ratio).abs() < 1e-12, "{damping}: {}", a_i.value);
        assert!(a_i.name.contains(governs), "{}", a_i.name);
        let on_plateau = 2.5 * 1.2 * site().ag / 1.5;
        assert!((design - on_plateau).abs() < 1e-12, "T_i of the oil tank lies on the plateau");
    }
}
