//! Site-specific spectrum of annex E (E.4.6.2), with the lower limit of ASCE 7 chapter 21.
//!
//! ```text
//! S_a(T) = max(S_u(T), 0.8 S_m(T))                       S_u: the user's spectrum at 5 %, S_m: that of the mapped values
//! S_DS   = max(S_a(0.2 s), 0.9 max S_a(T))               0.2 s ≤ T ≤ 5 s
//! ```
//!
//! The user's spectrum is that of the design earthquake: Q is not applied to it. Without mapped accelerations there is no lower limit.
//! Sources, recalled: API 650:2020 E.4.2.4 and E.4.6.2; ASCE 7-10 and 7-16 21.3 (80 %) and 21.4 (S_DS; 7-10 has the largest ordinate
//! of any period above 0.2 s, 7-16 up to 5 s).

use super::ground_motion::DesignSpectrum;
use crate::hazard;
use crate::procedure::CodeError;
use tank::STANDARD_GRAVITY;
use tank::case::{Api650Site, Site};
use tank::hazard::SpectrumForm;

/// Share of the mapped spectrum below which a site-specific one may not lie.
const FLOOR: f64 = 0.8;
/// Damping ratio of the spectrum.
const DAMPING: f64 = 0.05;
/// Periods between which S_DS is looked for [s].
const SHORT: (f64, f64) = (0.2, 5.0);

/// The user's spectrum under annex E; accelerations in g, 5 % damping.
pub struct SiteSpecific {
    own: Box<dyn Fn(f64) -> f64>,
    /// The spectrum of the mapped values.
    pub mapped: Option<DesignSpectrum>,
    /// Periods at which the user's spectrum has a kink [s].
    kinks: Vec<f64>,
    longest: f64,
}

impl SiteSpecific {
    /// The user's spectrum of a site; none if it is not given.
    ///
    /// Errors: mapped values that are inadmissible, see [`DesignSpectrum::new`].
    pub fn new(site: &Site, annex: &Api650Site) -> Result<Option<SiteSpecific>, CodeError> {
        let Some(own) = &site.spectrum else { return Ok(None) };
        let mapped = if annex.ss > 0.0 || annex.s1 > 0.0 { Some(DesignSpectrum::new(annex)?) } else { None };
        let kinks = match &own.form {
            SpectrumForm::Table { horizontal, .. } => horizontal.rows().iter().map(|row| row[0]).collect(),
            SpectrumForm::Parameters(given) => given.corners.to_vec(),
        };
        Ok(Some(SiteSpecific { own: hazard::elastic(own, 1.0, DAMPING), mapped, kinks, longest: hazard::longest(own) }))
    }

    /// Ordinate of the user's spectrum [g] at a period [s].
    pub fn own(&self, period: f64) -> f64 {
        (self.own)(period) / STANDARD_GRAVITY
    }

    /// Ordinate of the mapped spectrum [g]; zero without mapped values.
    pub fn mapped(&self, period: f64) -> f64 {
        self.mapped.map_or(0.0, |s| s.acceleration(period))
    }

    /// Design acceleration S_a [g] at a period [s].
    pub fn acceleration(&self, period: f64) -> f64 {
        self.own(period).max(FLOOR * self.mapped(period))
    }

    /// Period [s] and ordinate [g] of the largest acceleration from 0.2 s to 5 s. Both spectra are monotonous or linear between their
    /// kinks, so that the largest ordinate is at one of them, or at an end.
    pub fn largest(&self) -> (f64, f64) {
        let (first, last) = (SHORT.0.min(self.longest), SHORT.1.min(self.longest));
        let mut periods = vec![first, last];
        periods.extend(&self.kinks);
        periods.extend(self.mapped.iter().flat_map(|s| [s.t_0, s.t_s, s.t_l]));
        periods.retain(|t| (first..=last).contains(t));
        periods.into_iter().fold((first, 0.0), |best, t| {
            let value = self.acceleration(t);
            if value > best.1 { (t, value) } else { best }
        })
    }

    /// Design acceleration at short periods S_DS [g].
    pub fn short_period(&self) -> f64 {
        self.acceleration(SHORT.0).max(0.9 * self.largest().1)
    }
}
