//! The user's spectrum under annex E, and the zone method alone.
//!
//! Source:    the design spectrum of ASCE 7 of the worked example as the user's; E.4.6.2 and ASCE 7 21.3, 21.4 by hand
//! Goal:      the same accelerations from the table as from the mapped values; the lower limit of 80 % where the table is low
//! Model:     the oil tank of `example`, S_s = 0.9, S_1 = 0.4, class D: S_DS = 0.684 g, T_S = 0.624 s, T_c below T_L = 8 s
//! Tolerance: chords of 10 ms above 1/T: 0.25 (0.01/0.624)² = 6.4e-5

use super::edition1993::Api6501993;
use super::edition2020::Api6502020;
use super::example::{case, line};
use super::ground_motion::DesignSpectrum;
use super::ground_motion::tests::site;
use crate::procedure::{CodeError, Procedure};
use tank::STANDARD_GRAVITY;
use tank::assessment::{Assessment, Excitation};
use tank::case::{Api650Site, Case, ZoneSite};
use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumTable};

/// The oil tank under `share` of its ASCE 7 spectrum, as a table at 5 %.
fn under(share: f64, annex: Api650Site, until: f64) -> Case {
    let design = DesignSpectrum::new(&site()).unwrap();
    let mut periods: Vec<f64> = (0..=(until * 100.0) as u32).map(|i| f64::from(i) / 100.0).collect();
    periods.extend([design.t_0, design.t_s]);
    periods.sort_by(f64::total_cmp);
    let rows = periods.iter().map(|t| [*t, share * STANDARD_GRAVITY * design.acceleration(*t)]);
    let mut case = case();
    case.site.api650 = Some(annex);
    case.site.spectrum = Some(SiteSpectrum {
        form: SpectrumForm::Table {
            damping: 0.05,
            horizontal: SpectrumTable::new(rows.collect()).unwrap(),
            vertical: None,
        },
        vertical_ratio: 0.9,
    });
    case
}

fn assess(case: &Case) -> Assessment {
    Api6502020.assess(case, Excitation::Site).expect("the example is admissible")
}

/// Without mapped values, for the use group.
fn unmapped(sug: u8) -> Api650Site {
    Api650Site { ss: 0.0, s1: 0.0, sug, ..site() }
}

/// Use group III, because I and II have another branch of A_f beyond 4 s.
#[test]
fn the_spectrum_of_the_mapped_values_gives_the_same() {
    let mut mapped = case();
    mapped.site.api650 = Some(Api650Site { sug: 3, ..site() });
    let expected = assess(&mapped);
    for (share, annex, ratio) in [
        (1.0, Api650Site { sug: 3, ..site() }, 1.0),
        (1.0, unmapped(3), 1.0),
        (0.5, unmapped(3), 0.5),
        // 80 % of the mapped spectrum is more than half of it.
        (0.5, Api650Site { sug: 3, ..site() }, 0.8),
        (2.0, Api650Site { sug: 3, ..site() }, 2.0),
    ] {
        let found = assess(&under(share, annex, 9.0));
        for symbol in ["S_DS", "A_i", "A_c", "A_v", "A_f"] {
            let error = line(&found, symbol) / line(&expected, symbol) / ratio - 1.0;
            assert!(error.abs() < 6.4e-5, "{symbol} at {share}: {error}");
        }
    }
}

/// S_DS = 0.9·1.0 g of the peak at 0.6 s, which is more than S_a(0.2 s) = 0.5 g; use group II then needs 0.7 δ_s of freeboard.
#[test]
fn a_peak_above_the_short_period() {
    let mut case = under(1.0, unmapped(2), 9.0);
    let rows = vec![[0.0, 0.3], [0.2, 0.5], [0.6, 1.0], [9.0, 0.05]];
    let rows = rows.into_iter().map(|[t, a]| [t, a * STANDARD_GRAVITY]);
    if let Some(SiteSpectrum { form: SpectrumForm::Table { horizontal, .. }, .. }) = &mut case.site.spectrum {
        *horizontal = SpectrumTable::new(rows.collect()).unwrap();
    }
    let found = assess(&case);
    assert!((line(&found, "S_DS") - 0.9).abs() < 1e-14);
    assert!(found.checks.iter().any(|c| c.id == "freeboard" && c.compared()));
}

#[test]
fn a_table_that_ends_below_the_sloshing_period_is_refused() {
    let error = Api6502020.assess(&under(1.0, site(), 4.0), Excitation::Site).unwrap_err();
    assert!(matches!(&error, CodeError::Data { reason, .. } if reason.contains("ends at 4 s")), "{error}");
}

#[test]
fn the_zone_method_needs_no_mapped_accelerations() {
    let expected = Api6501993.assess(&case(), Excitation::Site).unwrap();
    let mut zone = case();
    zone.site.api650 = None;
    zone.site.zone = Some(ZoneSite { zone_factor: 0.30, soil_factor: 1.5, importance: 1.0 });
    let found = Api6501993.assess(&zone, Excitation::Site).unwrap();
    assert_eq!(found.values, expected.values);
    assert!(Api6502020.applies(&zone, Excitation::Site).is_err());
}
