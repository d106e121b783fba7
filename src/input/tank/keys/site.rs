//! `site`: site data of the codes.

use files::code::Code;
use std::path::Path;

use tank::units::{Dimension, display_in, unit_for};
use tank::{Tank, keys};

use tank::case::{self, Api650Site, Components, Ec8Site, GroundType, SiteClass, ZoneSite};
use tank::national::{Is1893Site, NationalSite, Soil, Zone};

use super::spectrum::{self, Spectrum};
use crate::input::diagnostic::Fault;
use crate::input::tank::choice::choice;
use crate::input::tank::given::{Given, Hand};
use crate::input::tank::read::{Field, FromNode, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Number, Stress};
use tank::keys::Absent;

object! {
    /// Site data for design spectra.
    Site {
        /// Eurocode 8.
        ec8: Opt<Given<Ec8Site>> = Absent::Without("no design spectrum of this code"),
        /// API 650; ACI 350.3 takes its data of ASCE 7 from here too.
        api650: Opt<Given<Api650Site>> = Absent::Without("no design spectrum of this code"),
        /// The user's spectrum, in place of those of the codes.
        spectrum: Opt<Spectrum> = Absent::Without("the spectra of the codes"),
        /// IS 1893-2, liquid retaining tanks.
        is1893: Opt<Given<Is1893Site>>,
        /// Factors of another national code, beside its spectrum in `spectrum`.
        national: Opt<Given<NationalSite>>,
    }
}

choice!(GroundType, Components, SiteClass, Soil, Zone);

/// Site data, each code's where it is given.
///
/// * `tank`: gives the design pressure where `api650` does not
/// * `folder`: of the tank file
pub(super) fn site(r: &mut Resolver<'_>, option: &Opt<Site>, tank: Option<&Tank>, folder: &Path) -> case::Site {
    r.known.internal_pressure = tank.map_or(0.0, |tank| tank.pressure.internal);
    let Some(given) = option.or_absent() else { return case::Site::default() };
    if given.spectrum.given.is_none() {
        r.not_given(&given.spectrum);
    }
    let spectrum = spectrum::spectrum(r, &given.spectrum, folder);
    let own = given.spectrum.given.is_some();
    let ec8 = match &given.ec8.given {
        Some(field) => field.value.as_ref().and_then(|s| ec8(r, field, s, own)),
        None => {
            r.not_given(&given.ec8);
            None
        }
    };
    let (api650, zone) = match &given.api650.given {
        Some(field) => match &field.value {
            Some(s) => api650(r, field, s, own),
            None => (None, None),
        },
        None => {
            r.not_given(&given.api650);
            (None, None)
        }
    };
    let is1893 = given.is1893.value().and_then(|s| s.resolve(r));
    let national = given.national.value().and_then(|s| s.resolve(r));
    if let (Some(site), Some(_)) = (&option.given, &given.national.given) {
        needed(r, site, &given.spectrum, " for the factors of site.national");
    }
    case::Site { ec8, api650, spectrum, zone, is1893, national }
}

/// Reports a key that is missing although this file needs it.
fn needed<T, U: FromNode>(r: &mut Resolver<'_>, object: &Field<T>, option: &Opt<U>, why: &str) {
    if option.given.is_none() {
        r.missing(object, option, why, &U::allowed(), &U::example());
    }
}

fn ec8(r: &mut Resolver<'_>, object: &Field<Given<Ec8Site>>, s: &Given<Ec8Site>, own: bool) -> Option<Ec8Site> {
    if own {
        for place in [s.ground.place(), s.spectrum.place(), s.ag.place()].into_iter().flatten() {
            let message = "this and site.spectrum exclude each other";
            let allowed = "neither ground, spectrum nor ag beside site.spectrum";
            r.refuse(Code::Exclusive, &place, message, allowed);
        }
    } else {
        needed(r, object, &s.ground, "");
        needed(r, object, &s.spectrum, "");
        needed(r, object, &s.ag, "");
    }
    let mut site = s.resolve(r)?;
    if own {
        // Not used beside the user's spectrum.
        (site.ground, site.spectrum, site.ag) = (GroundType::A, 1, 0.0);
    }
    Some(site)
}

/// Whether the file asks for annex E: a key of it is given, or nothing of the zone method.
fn annex_e(s: &Given<Api650Site>) -> bool {
    let numbers = [
        s.fa.given.is_some(),
        s.fv.given.is_some(),
        s.q.given.is_some(),
        s.joint_efficiency.given.is_some(),
        s.friction.given.is_some(),
    ];
    let mapped = [s.ss.given.is_some(), s.s1.given.is_some(), s.s0.given.is_some(), s.av.given.is_some()];
    let others = [
        s.site_class.given.is_some(),
        s.asce7.given.is_some(),
        s.sug.given.is_some(),
        s.tl.given.is_some(),
        s.design_pressure.given.is_some(),
        s.foundation_weight.given.is_some(),
        s.bearing_capacity.given.is_some(),
    ];
    let given = numbers.into_iter().chain(mapped).chain(others).any(|given| given);
    given || s.zone_factor.given.is_none()
}

/// Data of the zone method alone.
fn zone(r: &mut Resolver<'_>, s: &Given<Api650Site>) -> Option<ZoneSite> {
    let zone_factor = r.optional(&s.zone_factor)?;
    Some(ZoneSite {
        zone_factor,
        soil_factor: r.or_default(&s.soil_factor),
        importance: r.or_default(&s.importance_1993),
    })
}

fn api650(
    r: &mut Resolver<'_>,
    object: &Field<Given<Api650Site>>,
    s: &Given<Api650Site>,
    own: bool,
) -> (Option<Api650Site>, Option<ZoneSite>) {
    if !annex_e(s) {
        return (None, zone(r, s));
    }
    needed(r, object, &s.sug, "");
    // Either all or nothing is given of the lower limit of the user's spectrum.
    let mapped = [s.ss.given.is_some(), s.s1.given.is_some(), s.site_class.given.is_some(), s.tl.given.is_some()];
    if !own || mapped.contains(&true) {
        let why = if own { " for the lower limit of site.spectrum" } else { "" };
        needed(r, object, &s.ss, why);
        needed(r, object, &s.s1, why);
        needed(r, object, &s.site_class, why);
        needed(r, object, &s.tl, why);
    }
    let site = s.resolve(r);
    coefficients(r, s);
    (site, None)
}

/// Site coefficients that are incomplete, or missing for site class F.
fn coefficients(r: &mut Resolver<'_>, s: &Given<Api650Site>) {
    if let (Some(given), None) | (None, Some(given)) = (&s.fa.given, &s.fv.given) {
        let message = "one site coefficient without the other";
        r.refuse(Code::Incomplete, given, message, "fa and fv together, or neither");
    }
    if let (Some(SiteClass::F), Some(field), None, None) =
        (s.site_class.value(), &s.site_class.given, &s.fa.given, &s.fv.given)
    {
        let message = "site class F needs a site study";
        let allowed = "fa and fv from the study, or another class";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
}

/// The design pressure, of which that of the tank is the default [Pa].
impl Hand<keys::Opt<Stress>> for f64 {
    fn by_hand(given: &Opt<Stress>, r: &mut Resolver<'_>) -> Option<f64> {
        let internal = r.known.internal_pressure;
        let limits = given.key.limits;
        let text = display_in(internal, unit_for(internal, Dimension::Stress), 4);
        if given.given.is_none() && internal > limits.high {
            let message = format!("tank.pressure.internal is {text}, more than API 650 annex F covers");
            let fault = Fault::new(Code::OutOfRange, message)
                .path("tank.pressure.internal")
                .found(text.clone())
                .allowed(limits.describe(Dimension::Stress));
            r.faults.push(fault.help("leave site.api650 out, or give its design_pressure"));
        }
        Some(r.or_else(given, internal, &text, "tank.pressure.internal"))
    }
}

/// The factor Q, with a warning between its two usual values.
impl Hand<keys::Or<Number>> for f64 {
    fn by_hand(given: &Opt<Number>, r: &mut Resolver<'_>) -> Option<f64> {
        let q = r.or_default(given);
        if let Some(field) = &given.given
            && (q - 2.0 / 3.0).abs() > 0.007
            && q < 1.0
        {
            r.unusual(&field.path, &field.text, "usual are 2/3 with ASCE 7 maps and 1 with others, API 650 E.4.6.1");
        }
        Some(q)
    }
}
