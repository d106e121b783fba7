//! The design spectrum of annex E for the modes of an engine.

use super::super::ground_motion::DesignSpectrum;
use super::super::site_specific::SiteSpecific;
use super::factors::{K, R_WC, importance, response_modification};
use crate::hazard;
use crate::modal_action::ModalAction;
use crate::procedure::CodeError;
use crate::sheet::number;
use tank::case::{Api650Site, Case};
use tank::{STANDARD_GRAVITY, Support};

/// Period beyond which A_f falls with 1/T² for use groups I and II [s] (E.7.2).
const LONG_WAVE: f64 = 4.0;

/// S_a(T) at 5 % damping and S_DS, both in g.
enum Spectrum {
    Own(SiteSpecific),
    Mapped(DesignSpectrum),
}

impl Spectrum {
    fn acceleration(&self, period: f64) -> f64 {
        match self {
            Spectrum::Own(own) => own.acceleration(period),
            Spectrum::Mapped(design) => design.acceleration(period),
        }
    }

    fn short_period(&self) -> f64 {
        match self {
            Spectrum::Own(own) => own.short_period(),
            Spectrum::Mapped(design) => design.s_ds,
        }
    }

    /// Acceleration for the wave, use groups I and II: S_D1 · 4 s/T² beyond 4 s in place of S_D1/T.
    fn wave(&self, period: f64) -> f64 {
        match self {
            Spectrum::Mapped(design) if period > LONG_WAVE => {
                design.s_ds.min(design.s_d1 * LONG_WAVE / (period * period))
            }
            _ => self.acceleration(period),
        }
    }
}

/// The action of a site, see [`crate::modal_action`].
///
/// * `reduced`: whether by R_wi and R_wc, and limited by S_DS I/R_wi
///
/// Errors: data that the annex does not admit.
pub(super) fn action<'a>(case: &'a Case, annex: &Api650Site, reduced: bool) -> Result<ModalAction<'a>, CodeError> {
    let spectrum = || -> Result<Spectrum, CodeError> {
        Ok(match SiteSpecific::new(&case.site, annex)? {
            Some(own) => Spectrum::Own(own),
            None => Spectrum::Mapped(DesignSpectrum::new(annex)?),
        })
    };
    let i = importance(annex.sug)?;
    let (r_wi, r_wc) = match reduced {
        true => (response_modification(case.tank.support == Support::Anchored), R_WC),
        false => (1.0, 1.0),
    };
    let (structural, sloshing, wave) = (spectrum()?, spectrum()?, spectrum()?);
    let limit = if reduced { structural.short_period() * i / r_wi } else { f64::INFINITY };
    let sug = annex.sug;
    let [r_i, r_c] = [r_wi, r_wc].map(number);
    Ok(ModalAction {
        longest: case.site.spectrum.as_ref().map_or(f64::INFINITY, hazard::longest),
        structural: Box::new(move |period, _| structural.acceleration(period) * i / r_wi * STANDARD_GRAVITY),
        sloshing: Box::new(move |period, _| {
            (K * sloshing.acceleration(period) * i / r_wc).min(limit) * STANDARD_GRAVITY
        }),
        wave: Box::new(move |period, _| {
            let of_wave = match sug {
                3 => wave.acceleration(period),
                _ => wave.wave(period) * i,
            };
            K * of_wave * STANDARD_GRAVITY
        }),
        assumption: format!(
            "Modes of the engine under the design spectrum of annex E, whatever their own damping: structural modes and what follows the \
             ground with S_a(T) I/R_wi at 5 % (R_wi = {r_i}), sloshing modes with K S_a(T) I/R_wc (R_wc = {r_c}), the wave without R_wc."
        ),
        vertical: true,
        upwards: None,
    })
}
