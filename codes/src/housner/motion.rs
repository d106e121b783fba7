//! Excitation of the tank: peak ground acceleration and the spectral ordinate of the sloshing mode.

use super::lines::Ordinate;
use crate::api650::ground_motion::DesignSpectrum;
use crate::ec8::demand::long_period;
use crate::ec8::spectrum::ElasticSpectrum;
use crate::hazard;
use crate::ordinates::psa;
use crate::procedure::CodeError;
use oscillator::record::Record;
use tank::STANDARD_GRAVITY;
use tank::assessment::{Excitation, NotApplicable};
use tank::case::Case;
use tank::factor::Factor;
use tank::hazard::SiteSpectrum;
use tank::ingredients;

/// Clause that all limits of this procedure are cited under.
pub const SOURCE: &str = "Housner 1957; TID-7024 (1963) ch. 6";

/// Factor from 5 % to 0.5 % damping that API 650 E.4.6.1 applies to the sloshing mode.
const API_SLOSHING_FACTOR: f64 = 1.5;

/// Ground motion as Housner's procedure uses it.
#[derive(Clone, Debug)]
pub struct Motion<'a> {
    spectrum: Spectrum<'a>,
    /// Importance factor in the site's spectrum.
    importance: f64,
    /// Damping ratio of the sloshing mode.
    damping: f64,
    /// Peak ground acceleration a_B [m/s²].
    pub ground: f64,
    /// Where a_B comes from, for the sheet.
    pub ground_source: String,
    /// The assumption, one sentence.
    pub assumption: String,
}

/// Source of the ordinate of the sloshing mode.
#[derive(Clone, Debug)]
enum Spectrum<'a> {
    Record(&'a Record),
    Ec8(ElasticSpectrum),
    Asce7(DesignSpectrum),
    User(&'a SiteSpectrum, f64),
}

/// Whether the case has the data of the excitation.
pub fn available(case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
    let missing = match excitation {
        Excitation::Record if case.ground_motion.is_none() => "no record given",
        Excitation::Site if case.site.ec8.is_none() && case.site.api650.is_none() && case.site.spectrum.is_none() => {
            "none of `site.ec8`, `site.api650` and `site.spectrum` is given, so there is no design spectrum"
        }
        _ => return Ok(()),
    };
    Err(NotApplicable { clause: SOURCE.into(), reason: missing.into() })
}

impl<'a> Motion<'a> {
    /// The motion of a case. Housner's procedure does not define a design spectrum: under the site's excitation it takes
    /// the user's spectrum, else the elastic spectrum of EN 1998-1 where `site.ec8` is given, else that of ASCE 7.
    pub fn new(case: &'a Case, excitation: Excitation) -> Result<Motion<'a>, CodeError> {
        available(case, excitation)?;
        let damping = case.damping.sloshing;
        let percent = 100.0 * damping;
        if let (Excitation::Record, Some(ground)) = (excitation, &case.ground_motion) {
            let record = &ground.horizontal;
            return Ok(Motion {
                ground: record.pga(),
                ground_source: format!("record `{}`", record.name),
                assumption: format!(
                    "Peak ground acceleration and spectral ordinate are those of the record `{}` at {percent} % damping.",
                    record.name
                ),
                spectrum: Spectrum::Record(record),
                importance: 1.0,
                damping,
            });
        }
        if let Some(own) = &case.site.spectrum {
            let importance = case.site.ec8.map_or(1.0, |site| site.importance);
            return Ok(Motion {
                ground: hazard::elastic(own, importance, damping)(0.0),
                ground_source: format!("{}, T = 0", hazard::CLAUSE),
                assumption: format!(
                    "Housner gives no design spectrum: the user's spectrum at {percent} % damping (η of EN 1998-1 3.2.2.2) is used, \
                     times the importance factor of `site.ec8`, if any, with its value at T = 0 as ground acceleration."
                ),
                spectrum: Spectrum::User(own, importance),
                importance,
                damping,
            });
        }
        if let Some(site) = &case.site.ec8 {
            let elastic = ElasticSpectrum::new(site)?;
            return Ok(Motion {
                ground: elastic.peak(),
                ground_source: "EN 1998-1:2004 3.2.2.2, S_e(0) = a_g·S".into(),
                assumption: format!(
                    "Housner gives no design spectrum: the elastic spectrum of EN 1998-1 at {percent} % damping is used \
                     (behaviour factor 1), with its value at T = 0 as ground acceleration."
                ),
                spectrum: Spectrum::Ec8(elastic),
                importance: site.importance,
                damping,
            });
        }
        let Some(site) = &case.site.api650 else {
            return Err(CodeError::Data { clause: SOURCE.into(), reason: "no site data".into() });
        };
        let design = DesignSpectrum::new(site)?;
        Ok(Motion {
            ground: design.acceleration(0.0) * STANDARD_GRAVITY,
            ground_source: "ASCE 7 11.4.5, S_a(0) = 0.4 S_DS".into(),
            assumption: "Housner gives no design spectrum: the elastic design spectrum of ASCE 7 is used, without response \
                         modification; times 1.5 for the sloshing mode (0.5 % damping, API 650 E.4.6.1), with its value at \
                         T = 0 as ground acceleration."
                .into(),
            spectrum: Spectrum::Asce7(design),
            importance: 1.0,
            damping,
        })
    }

    /// The ground acceleration with its factors.
    pub(super) fn ground_ordinate(&self) -> ingredients::Ordinate {
        ingredients::Ordinate::ground(self.ground).split(&[(Factor::Importance, self.importance)])
    }

    /// The acceleration [m/s²] of the sloshing mode at its period [s] with its factors.
    pub(super) fn sloshing_ordinate(&self, period: f64, value: f64) -> ingredients::Ordinate {
        let ordinate = ingredients::Ordinate::at(period, self.damping, value);
        match &self.spectrum {
            Spectrum::Record(_) => ordinate,
            Spectrum::Ec8(elastic) => ordinate.split(&[
                (Factor::LongPeriod, long_period(elastic, period, self.damping)),
                (Factor::Importance, self.importance),
            ]),
            Spectrum::User(_, importance) => ordinate.split(&[(Factor::Importance, *importance)]),
            Spectrum::Asce7(design) => ingredients::Ordinate {
                damping: 0.05,
                ..ordinate.split(&[
                    (Factor::LongPeriod, (design.t_l / period).min(1.0)),
                    (Factor::DampingCorrection, API_SLOSHING_FACTOR),
                ])
            },
        }
    }

    /// Errors: a sloshing period [s] beyond the user's table.
    pub(super) fn covers(&self, period: f64) -> Result<(), CodeError> {
        match &self.spectrum {
            Spectrum::User(own, _) => hazard::covers(Some(own), "sloshing", period),
            _ => Ok(()),
        }
    }

    /// Pseudo-acceleration of the sloshing mode at its period [s].
    pub(super) fn sloshing(&self, period: f64) -> Ordinate {
        let percent = 100.0 * self.damping;
        match &self.spectrum {
            Spectrum::Record(record) => Ordinate {
                value: psa(record, period, self.damping),
                look_up: "spectrum of the record at T".into(),
                clause: format!("spectrum of the record, {percent} % damping"),
            },
            Spectrum::Ec8(elastic) => {
                let (value, branch) = elastic.horizontal_with_branch(period, self.damping);
                Ordinate {
                    value,
                    look_up: "elastic spectrum of the site at T".into(),
                    clause: format!("EN 1998-1:2004 3.2.2.2, {percent} % damping, {}", branch.describe()),
                }
            }
            Spectrum::User(own, importance) => Ordinate {
                value: hazard::elastic(own, *importance, self.damping)(period),
                look_up: "the user's spectrum at T".into(),
                clause: format!("{}, {percent} % damping by η of EN 1998-1:2004 3.2.2.2", hazard::CLAUSE),
            },
            Spectrum::Asce7(design) => Ordinate {
                value: API_SLOSHING_FACTOR * design.acceleration(period) * STANDARD_GRAVITY,
                look_up: "1.5 times the design spectrum of the site at T".into(),
                clause: "ASCE 7 11.4.5 times 1.5 for 0.5 % damping (API 650 E.4.6.1)".into(),
            },
        }
    }
}
