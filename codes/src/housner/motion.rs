//! What shakes the tank: peak ground acceleration and the spectral ordinate of the sloshing mode.

use crate::api650::ground_motion::DesignSpectrum;
use crate::ec8::spectrum::ElasticSpectrum;
use crate::procedure::CodeError;
use oscillator::spectrum;
use tank::STANDARD_GRAVITY;
use tank::assessment::{Excitation, NotApplicable};
use tank::case::Case;

/// Clause that all limits of this procedure are cited under.
pub const SOURCE: &str = "Housner 1957; TID-7024 (1963) ch. 6";

/// Factor from 5 % to 0.5 % damping that API 650 E.4.6.1 applies to the sloshing mode.
const API_SLOSHING_FACTOR: f64 = 1.5;

/// Ground motion as Housner's procedure uses it.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Peak ground acceleration a_B [m/s²].
    pub ground: f64,
    /// Pseudo-acceleration S_a of the sloshing mode [m/s²].
    pub sloshing: f64,
    /// Where a_B comes from, for the sheet.
    pub ground_source: String,
    /// Where S_a comes from, for the sheet.
    pub sloshing_source: String,
    /// What was assumed, one sentence.
    pub assumption: String,
}

/// Whether the case has what the excitation needs.
pub fn available(case: &Case, excitation: Excitation) -> Result<(), NotApplicable> {
    let missing = match excitation {
        Excitation::Record if case.ground_motion.is_none() => "no record given",
        Excitation::Site if case.site.ec8.is_none() && case.site.api650.is_none() => {
            "neither `site.ec8` nor `site.api650` is given, so there is no design spectrum"
        }
        _ => return Ok(()),
    };
    Err(NotApplicable {
        clause: SOURCE.into(),
        reason: missing.into(),
    })
}

/// The motion of a case at the sloshing period [s]. Housner's procedure has no design spectrum of its own: under the
/// site's excitation it takes the elastic spectrum of EN 1998-1 where `site.ec8` is given, else that of ASCE 7.
pub fn motion(case: &Case, excitation: Excitation, period: f64) -> Result<Motion, CodeError> {
    available(case, excitation)?;
    let damping = case.damping.sloshing;
    let percent = 100.0 * damping;
    if let (Excitation::Record, Some(ground)) = (excitation, &case.ground_motion) {
        let record = &ground.horizontal;
        return Ok(Motion {
            ground: record.pga(),
            sloshing: spectrum::ordinates(record, period, damping).psa,
            ground_source: format!("record `{}`", record.name),
            sloshing_source: format!("spectrum of the record, {percent} % damping"),
            assumption: format!(
                "Peak ground acceleration and spectral ordinate are those of the record `{}` at {percent} % damping.",
                record.name
            ),
        });
    }
    if let Some(site) = &case.site.ec8 {
        let elastic = ElasticSpectrum::new(site)?;
        let (sloshing, branch) = elastic.horizontal_with_branch(period, damping);
        return Ok(Motion {
            ground: elastic.peak(),
            sloshing,
            ground_source: "EN 1998-1:2004 3.2.2.2, S_e(0) = a_g·S".into(),
            sloshing_source: format!("EN 1998-1:2004 3.2.2.2, {percent} % damping, {}", branch.describe()),
            assumption: format!(
                "Housner gives no design spectrum: the elastic spectrum of EN 1998-1 at {percent} % damping is used \
                 (behaviour factor 1), with its value at T = 0 as ground acceleration."
            ),
        });
    }
    match &case.site.api650 {
        Some(site) => {
            let design = DesignSpectrum::new(site)?;
            Ok(Motion {
                ground: design.acceleration(0.0) * STANDARD_GRAVITY,
                sloshing: API_SLOSHING_FACTOR * design.acceleration(period) * STANDARD_GRAVITY,
                ground_source: "ASCE 7 11.4.5, S_a(0) = 0.4 S_DS".into(),
                sloshing_source: "ASCE 7 11.4.5 times 1.5 for 0.5 % damping (API 650 E.4.6.1)".into(),
                assumption: "Housner gives no design spectrum: the elastic design spectrum of ASCE 7 is used, without \
                             response modification; times 1.5 for the sloshing mode (0.5 % damping, API 650 E.4.6.1), \
                             with its value at T = 0 as ground acceleration."
                    .into(),
            })
        }
        None => Err(CodeError::Data {
            clause: SOURCE.into(),
            reason: "no site data".into(),
        }),
    }
}
