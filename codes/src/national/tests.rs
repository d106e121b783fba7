//! The user's data by hand: a table of two slopes, importance and reductions.

use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumTable};
use tank::national::NationalSite;

use super::National;
use crate::ec8::spectrum::damping_correction;
use crate::procedure::Procedure;
use crate::samples::near;
use crate::two_mass::tests::{assessed, basin, line};
use tank::assessment::Excitation;

fn site(rows: Vec<[f64; 2]>) -> SiteSpectrum {
    let table = SpectrumTable::new(rows).unwrap();
    SiteSpectrum { form: SpectrumForm::Table { damping: 0.05, horizontal: table, vertical: None }, vertical_ratio: 0.7 }
}

fn data() -> NationalSite {
    NationalSite {
        code: "a code".into(),
        importance: 1.2,
        impulsive_reduction: 2.0,
        sloshing_reduction: 1.5,
        sloshing_factor: None,
    }
}

/// S_a = 2 g up to 1 s and 0.2 g at 10 s, linear between: at T_c = 6.153 s by hand.
#[test]
fn accelerations_by_hand() {
    let mut case = basin();
    let g = case.gravity;
    case.site.spectrum = Some(site(vec![[0.0, 0.8 * g], [0.05, 2.0 * g], [1.0, 2.0 * g], [10.0, 0.2 * g]]));
    case.site.national = Some(data());
    let out = assessed(&National, &case);
    let s_c = 2.0 - 0.2 * (line(&out, "T_c") - 1.0);
    let k = damping_correction(0.005) / damping_correction(0.05);
    near(line(&out, "A_i"), 1.2 * line(&out, "S_i") / 2.0, 1e-12, "A_i");
    near(line(&out, "A_c"), 1.2 * k * s_c / 1.5, 1e-9, "A_c");
    near(line(&out, "A_w"), 1.2 * k * s_c, 1e-9, "A_w");
    near(line(&out, "A_v"), 0.7 * 1.2 * 0.8, 1e-12, "A_v");
    case.site.national = Some(NationalSite { sloshing_factor: Some(1.75), ..data() });
    near(line(&assessed(&National, &case), "A_c"), 1.2 * 1.75 * s_c / 1.5, 1e-9, "given factor");
    assert!(out.recalled.is_empty());
}

/// A table that ends before the sloshing period is refused, and a site without a spectrum.
#[test]
fn refusals() {
    let mut case = basin();
    let refused = |case: &_| National.assess(case, Excitation::Site).unwrap_err().to_string();
    case.site.national = Some(data());
    assert!(refused(&case).contains("`site.national` with `site.spectrum` is not given"));
    case.site.spectrum = Some(site(vec![[0.0, 1.0], [4.0, 0.5]]));
    assert!(refused(&case).contains("the table ends at 4 s, the sloshing period is 6.15"), "{}", refused(&case));
}
