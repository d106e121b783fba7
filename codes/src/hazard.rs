//! Ordinates of the user's spectrum at another damping than that of its table, and the periods that it covers.
//!
//! ```text
//! η′  = η(ξ)/η(ξ_t)                                                  η of EN 1998-1:2004 3.2.2.2
//! T ≥ T_p   S_a = S_t(T) η′                                          T_p: period of the largest row, S_p its ordinate
//! T < T_p   S_a = S_t(T) + (η′ − 1) S_p (S_t(T) − S_t(0))/(S_p − S_t(0))
//! ```
//!
//! Damping does not change the ground acceleration, so its influence grows over the rising branch: for the table of a spectrum of
//! EN 1998-1 the second line is exactly that branch at the other damping.
//!
//! A table is not continued beyond its last row: a procedure that needs a longer period is refused ([`covers`]). The 1/T² branch of a
//! constant displacement is unsafe before T_D, and no other rule holds for every spectrum.

use crate::ec8::spectrum::{ElasticSpectrum, damping_correction};
use crate::procedure::CodeError;
use crate::sheet::with_unit;
use tank::hazard::{SiteSpectrum, SpectrumForm, SpectrumTable};
use tank::units::Dimension::Time;

/// Clause of the user's spectrum.
pub const CLAUSE: &str = "site.spectrum, the user's spectrum";

/// Ordinate [m/s²] of a table at another damping (module description); the last row for periods beyond.
///
/// * `ratio`: η′
pub fn scaled(table: &SpectrumTable, period: f64, ratio: f64) -> f64 {
    let ordinate = ordinate(table, period);
    let (at, largest) = table.largest();
    if period >= at {
        return ordinate * ratio;
    }
    let ground = table.peak();
    ordinate + (ratio - 1.0) * largest * (ordinate - ground).max(0.0) / (largest - ground)
}

/// Ordinate of the table [m/s²]; that of the last row for periods beyond.
pub fn ordinate(table: &SpectrumTable, period: f64) -> f64 {
    let last = table.rows().last().map_or(0.0, |row| row[1]);
    table.at(period).unwrap_or(last)
}

/// Longest period [s] of the user's spectrum.
pub fn longest(spectrum: &SiteSpectrum) -> f64 {
    match &spectrum.form {
        SpectrumForm::Table { horizontal, .. } => horizontal.longest(),
        SpectrumForm::Parameters(_) => f64::INFINITY,
    }
}

/// Errors: a period [s] beyond the table.
pub fn covers(spectrum: Option<&SiteSpectrum>, what: &str, period: f64) -> Result<(), CodeError> {
    match spectrum.map(longest) {
        Some(last) if period > last => Err(CodeError::Data {
            clause: CLAUSE.into(),
            reason: format!(
                "the table ends at {}, the {what} period is {}; add rows up to it, the table is not continued",
                with_unit(last, Time),
                with_unit(period, Time)
            ),
        }),
        _ => Ok(()),
    }
}

/// Elastic spectrum [m/s²] over the period [s] at a damping, times an importance factor.
pub fn elastic(spectrum: &SiteSpectrum, importance: f64, damping: f64) -> Box<dyn Fn(f64) -> f64> {
    match &spectrum.form {
        SpectrumForm::Table { damping: given, horizontal, .. } => {
            let (table, ratio) = (horizontal.clone(), damping_correction(damping) / damping_correction(*given));
            Box::new(move |period| importance * scaled(&table, period, ratio))
        }
        SpectrumForm::Parameters(given) => {
            let own = ElasticSpectrum::of_parameters(given, spectrum.vertical_ratio, importance);
            Box::new(move |period| own.horizontal(period, damping))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::hazard::SpectrumParameters;

    /// Rows of the recommended spectrum of ground C at a damping: every 0.01 s (the control periods are among them) up to 4 s.
    fn sampled(spectrum: &ElasticSpectrum, damping: f64) -> SpectrumTable {
        let rows = (0..=400).map(|i| {
            let period = f64::from(i) / 100.0;
            [period, spectrum.horizontal(period, damping)]
        });
        SpectrumTable::new(rows.collect()).unwrap()
    }

    /// The chord over a step h of 1/T² lies above it by at most h² f″/8 = 0.75 (h/T)² of it, of 1/T by 0.25 (h/T)²: 0.75 (0.01/2)² =
    /// 1.9e-5 beyond T_D = 2 s and 0.25 (0.01/0.6)² = 7e-5 beyond T_C = 0.6 s. The rising branch and the plateau are linear.
    #[test]
    fn a_sampled_spectrum_gives_the_spectrum() {
        let parameters = SpectrumParameters { ag: 1.0, soil: 1.15, corners: [0.2, 0.6, 2.0], long_corners: None };
        let spectrum = ElasticSpectrum::of_parameters(&parameters, 0.9, 1.0);
        for (given, wanted) in [(0.05, 0.05), (0.05, 0.005), (0.05, 0.2), (0.02, 0.05)] {
            let table = sampled(&spectrum, given);
            let ratio = damping_correction(wanted) / damping_correction(given);
            for period in [0.0, 0.013, 0.1, 0.2, 0.3, 0.6, 0.777, 1.234, 2.0, 2.345, 3.999] {
                let (found, exact) = (scaled(&table, period, ratio), spectrum.horizontal(period, wanted));
                let error = found / exact - 1.0;
                assert!((-1e-12..7e-5).contains(&error), "{given} {wanted} {period}: {error}");
            }
        }
    }

    /// The worked number of `docs/theory/site-spectra.md`, by hand: half of its last digit.
    #[test]
    fn worked_number() {
        let rows = vec![[0.0, 0.1], [0.2, 0.25], [0.6, 0.25], [2.0, 0.08]];
        let table = SpectrumTable::new(rows).unwrap();
        let at = |period: f64, damping: f64| scaled(&table, period, damping_correction(damping));
        assert!((at(0.1, 0.05) - 0.175).abs() < 1e-12);
        assert!((at(0.1, 0.02) - 0.1994).abs() < 5e-5);
        assert!((at(1.0, 0.005) - 0.2716).abs() < 5e-5);
        // Damping does not change the ground acceleration.
        assert_eq!(at(0.0, 0.005), 0.1);
    }

    /// At the damping of the table its rows, between them the chord, beyond them the last; an importance factor multiplies all. At
    /// ξ = 0.005 η is √(10/5.5) by the formula.
    #[test]
    fn ordinates_of_a_table() {
        let rows = vec![[0.0, 1.0], [0.2, 2.5], [0.6, 2.5], [2.0, 0.8]];
        let table = SpectrumTable::new(rows).unwrap();
        let site = |damping: f64| SiteSpectrum {
            form: SpectrumForm::Table { damping, horizontal: table.clone(), vertical: None },
            vertical_ratio: 0.9,
        };
        for (period, exact) in [(0.0, 1.0), (0.1, 1.75), (0.2, 2.5), (0.5, 2.5), (1.3, 1.65), (2.0, 0.8), (9.0, 0.8)] {
            assert!((ordinate(&table, period) - exact).abs() < 1e-12, "{period}");
            assert!((elastic(&site(0.05), 1.4, 0.05)(period) - 1.4 * exact).abs() < 1e-12, "{period}");
        }
        assert_eq!(longest(&site(0.05)), 2.0);
        let eta = (10.0_f64 / 5.5).sqrt();
        // From the plateau on all is times η; halfway up the rise half of the plateau's gain.
        for (period, exact) in [(0.1, 1.75 + (eta - 1.0) * 1.25), (0.4, 2.5 * eta), (1.3, 1.65 * eta)] {
            assert!((elastic(&site(0.05), 1.0, 0.005)(period) - exact).abs() < 1e-12, "{period}");
            assert!((elastic(&site(0.005), 1.0, 0.005)(period) - ordinate(&table, period)).abs() < 1e-12);
        }
    }

    /// EN 1998-1 3.2.2.2 at its corners: S a_g at T = 0, 2.5 S a_g on the plateau, T_C/T and T_C T_D/T² beyond.
    #[test]
    fn ordinates_of_parameters() {
        let site = SiteSpectrum {
            form: SpectrumForm::Parameters(SpectrumParameters {
                ag: 2.0,
                soil: 1.2,
                corners: [0.2, 0.6, 2.0],
                long_corners: None,
            }),
            vertical_ratio: 0.9,
        };
        let at = elastic(&site, 1.2, 0.05);
        for (period, share) in [(0.0, 1.0), (0.1, 1.75), (0.4, 2.5), (1.2, 1.25), (3.0, 2.5 * 1.2 / 9.0)] {
            assert!((at(period) / (1.2 * 2.4 * share) - 1.0).abs() < 1e-12, "{period}");
        }
        assert_eq!(longest(&site), f64::INFINITY);
    }

    #[test]
    fn a_table_is_not_continued() {
        let table = SpectrumTable::new(vec![[0.0, 1.0], [4.0, 1.0]]).unwrap();
        let spectrum = SiteSpectrum {
            form: SpectrumForm::Table { damping: 0.05, horizontal: table, vertical: None },
            vertical_ratio: 0.9,
        };
        assert!(covers(Some(&spectrum), "sloshing", 4.0).is_ok() && covers(None, "sloshing", 9.0).is_ok());
        let error = covers(Some(&spectrum), "sloshing", 4.01).unwrap_err().to_string();
        assert!(error.contains("ends at 4 s") && error.contains("add rows"), "{error}");
    }
}
