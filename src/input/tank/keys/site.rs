//! `site`: site data of the codes.

use files::code::Code;
use std::path::Path;

use tank::Tank;
use tank::units::{Dimension, display_in, unit_for};

use tank::case::{self, Api650Site, Components, Ec8Site, GroundType, SiteClass, ZoneSite};

use super::spectrum::{self, Spectrum};
use crate::input::diagnostic::Fault;
use crate::input::tank::key::{Absent, Limits, default, without};
use crate::input::tank::read::{Field, FromNode, Opt, choice, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Acceleration, Force, InG, Number, Seconds, Si, Stress, Whole};

/// Mapped accelerations in g.
const MAPPED: Limits = Limits::from(0.0).to(5.0);
/// Site coefficients; the tables of ASCE 7 have 0.8 to 2.5 and 0.8 to 4.2, and a study at least 0.8 of them.
const FACTOR: Limits = Limits::from(0.4).to(6.0).clause("ASCE 7-16 tables 11.4-1 and 11.4-2");
/// Importance factor: 0.8, 1, 1.2 and 1.6 are recommended, the least and largest national values known are 0.65 and 1.95 (Portugal,
/// recalled). With k = 3, 0.6 and 2 stand for return periods of 100 and 3800 years beside 475.
const IMPORTANCE: Limits = Limits::from(0.6)
    .to(2.0)
    .usual(0.8, 1.6)
    .clause("EN 1998-4:2006 2.1.4, classes I to IV");
/// Share of damage limitation: 0.5 and 0.4 are recommended; a return period of 95 in place of 475 years gives 0.2 with k = 1.
const REDUCTION: Limits = Limits::from(0.2).to(1.0).usual(0.4, 0.5).clause("EN 1998-1:2004 2.2.3");
/// Ground under a tank, from soft clay to rock.
const GROUND: Limits = Limits::from(1e3).to(1e8).usual(50e3, 3e6);
/// From the mapped to the design earthquake: 2/3 of ASCE 7, 1 of maps of the design earthquake; 0.66 is 2/3 rounded.
const SCALING: Limits = Limits::from(0.66)
    .to(1.0)
    .clause("API 650 E.4.6.1: 2/3 with ASCE 7 maps, 1 with others");
/// Long-period transition; the maps of ASCE 7 have 4 to 16 s.
const LONG: Limits = Limits::from(1.0).to(30.0).usual(4.0, 16.0).clause("ASCE 7 maps of T_L");
/// Design pressure: annex F ends at 18 kPa (2.5 psi).
const PRESSURE: Limits = Limits::from(0.0).to(18e3).clause("API 650 annex F");
/// Joint efficiency: 0.85 and 1, 0.7 of annex A; old lap joints of API 653 have at least 0.35.
const JOINT: Limits = Limits::from(0.35)
    .to(1.0)
    .usual(0.7, 1.0)
    .clause("API 650 5.6, annex A; API 653 table 4.2");

object! {
    /// Site data for design spectra.
    Site {
        /// Eurocode 8.
        ec8: Opt<Ec8> = Absent::Without("no design spectrum of this code"),
        /// API 650.
        api650: Opt<Api650> = Absent::Without("no design spectrum of this code"),
        /// The user's spectrum, in place of those of the codes.
        spectrum: Opt<Spectrum> = Absent::Without("the spectra of the codes"),
    }

    /// Site data of Eurocode 8. Without it the Eurocode procedures run on the record's spectrum only.
    Ec8 {
        /// Ground type of EN 1998-1 table 3.1. Needed unless `site.spectrum` is given.
        ground ("B"): Opt<GroundType>,
        /// Type of the elastic spectrum. Needed unless `site.spectrum` is given.
        spectrum (1): Opt<Whole> [Limits::one_of(&[1.0, 2.0])],
        /// Reference peak ground acceleration a_gR on rock. Needed unless `site.spectrum` is given.
        ag ("0.25 g"): Opt<Acceleration>
            [Limits::from(1e-3).to(3.0 * tank::STANDARD_GRAVITY).usual(0.02 * tank::STANDARD_GRAVITY, 0.6 * tank::STANDARD_GRAVITY)],
        /// Importance factor.
        importance (1.2): Opt<Number> [IMPORTANCE]
            = default(Number(1.0)).shown("1.0").because("EN 1998-4:2006 2.1.4, class II"),
        /// Behaviour factor q of the impulsive part; at most 1.5 for a tank on the ground, EN 1998-4:2006 4.4.
        behaviour_factor (1.5): Opt<Number> [Limits::from(1.0).to(1.5).clause("EN 1998-4:2006 4.4")] = default(Number(1.0))
            .shown("1.0")
            .because("elastic response of the wall, on the safe side of EN 1998-4:2006 4.4"),
        /// Fabrication quality of EN 1998-4 A.10: 1 normal, 1.5 quality, 2.5 very high quality construction.
        construction_quality (1.5): Opt<Number> [Limits::one_of(&[1.0, 1.5, 2.5])]
            = default(Number(1.0)).because("normal construction, EN 1998-4:2006 A.10"),
        /// Whether the vertical design spectrum is applied.
        vertical (false): Opt<bool> = default(true).because("EN 1998-4:2006 A.2.2 and A.3.3, on the safe side"),
        /// Horizontal components that act together on a cylinder.
        components: Opt<Components> = default(Components::One).because("EN 1998-4:2006 3.2: enough for an axisymmetric tank"),
        /// Design friction coefficient of the foundation, tan δ divided by its partial factor γ_M, against sliding.
        friction (0.4): Opt<Number> [Limits::from(1e-3).to(1.0).usual(0.2, 0.6)] = without("sliding is not checked, EN 1998-5:2004 5.4.1.1"),
        /// Reduction factor ν of the seismic action for damage limitation; EN 1998-1:2004 2.2.3 recommends 0.5 for importance classes I
        /// and II, 0.4 for III and IV.
        reduction_factor (0.5): Opt<Number> [REDUCTION]
            = without("damage limitation is not checked, EN 1998-4:2006 2.1.3"),
        /// Design bearing resistance of the ground under the tank in the seismic situation, as a pressure.
        bearing_capacity ("300 kPa"): Opt<Stress> [GROUND]
            = without("bearing of the ground is not checked, EN 1998-5:2004 5.4.1.1"),
    }

    /// Site data of API 650: annex E of the 13th edition, and the zone method of appendix E, 9th edition. Without it the API
    /// procedures run on the record's spectrum only. Annex E needs ss, s1, site_class, tl and sug; under `site.spectrum` sug alone, the
    /// others for its lower limit. The zone method needs zone_factor alone.
    Api650 {
        /// Mapped short-period acceleration S_s in g.
        ss (1.0): Opt<InG> [MAPPED.usual(0.0, 3.0)],
        /// Mapped one-second acceleration S_1 in g.
        s1 (0.4): Opt<InG> [MAPPED.usual(0.0, 1.5)],
        /// Peak ground acceleration S_0 in g.
        s0 (0.4): Opt<InG> [MAPPED.usual(0.0, 1.5)] = without("0.4 S_s, API 650 E.4.2"),
        /// Site class of ASCE 7.
        site_class ("D"): Opt<SiteClass>,
        /// Edition of the site-coefficient tables; those of 2010 are printed in annex E.
        asce7 (2016): Opt<Whole> [Limits::one_of(&[2010.0, 2016.0])]
            = default(Whole(2010)).because("site-coefficient tables printed in API 650 annex E"),
        /// Site coefficient F_a of a site study, instead of the table's; together with fv. Site class F needs both.
        fa (1.1): Opt<Number> [FACTOR.usual(0.8, 2.5)] = without("from the table of the site class"),
        /// Site coefficient F_v of a site study, instead of the table's; together with fa.
        fv (1.6): Opt<Number> [FACTOR.usual(0.8, 4.2)] = without("from the table of the site class"),
        /// Factor Q from the mapped to the design earthquake; 2/3 with ASCE 7 maps, 1 with other maps.
        q (1): Opt<Number> [SCALING]
            = default(Number(2.0 / 3.0)).shown("0.6667 (2/3)").because("API 650 E.4.6.1 with ASCE 7 maps"),
        /// Seismic use group.
        sug (1): Opt<Whole> [Limits::one_of(&[1.0, 2.0, 3.0])],
        /// Long-period transition T_L in seconds.
        tl (4.0): Opt<Seconds> [LONG],
        /// Vertical acceleration A_v in g.
        av (0.3): Opt<InG> [MAPPED.usual(0.0, 1.0)] = without("0.47 S_DS, API 650 E.6.1.3"),
        /// Design pressure above the liquid.
        design_pressure ("2 kPa"): Opt<Stress> [PRESSURE]
            = Absent::Follows("tank.pressure.internal"),
        /// Joint efficiency of the shell.
        joint_efficiency (0.85): Opt<Number> [JOINT]
            = default(Number(1.0)).shown("1.0").because("fully radiographed butt joints"),
        /// Friction coefficient against sliding.
        friction (0.3): Opt<Number> [Limits::from(1e-3).to(0.4).usual(0.2, 0.4).clause("API 650 E.7.6")]
            = default(Number(0.4)).because("API 650 E.7.6, the largest value allowed"),
        /// Weight of the foundation and of the soil on it, W_fd + W_g, against overturning.
        foundation_weight ("3 MN"): Opt<Force> [Limits::from(0.0).to(1e10)]
            = without("overturning of the foundation is not checked, API 650 E.6.2.3"),
        /// Allowable pressure on the ground in the seismic combination.
        bearing_capacity ("250 kPa"): Opt<Stress> [GROUND]
            = without("bearing of the ground is not checked, API 650 E.6.2.3"),
        /// 9th edition: zone factor Z.
        zone_factor (0.3): Opt<Number> [Limits::one_of(&[0.0, 0.075, 0.15, 0.2, 0.3, 0.4])]
            = without("the zone method of the 9th edition is not run"),
        /// 9th edition: site amplification S.
        soil_factor (1.2): Opt<Number> [Limits::one_of(&[1.0, 1.2, 1.5, 2.0])]
            = default(Number(1.5)).because("soil profile S3, API 650 9th edition, soil not known"),
        /// 9th edition: importance factor I.
        importance_1993 (1.25): Opt<Number> [Limits::one_of(&[1.0, 1.25])]
            = default(Number(1.0)).shown("1.0").because("API 650 9th edition E.3.1, ordinary tank"),
    }
}

choice!(GroundType, Components, SiteClass);

/// Site data, each code's where it is given.
///
/// * `tank`: gives the design pressure where `api650` does not
/// * `folder`: of the tank file
pub(super) fn site(r: &mut Resolver<'_>, option: &Opt<Site>, tank: Option<&Tank>, folder: &Path) -> case::Site {
    let internal = tank.map_or(0.0, |tank| tank.pressure.internal);
    let Some(given) = option.or_absent() else {
        return case::Site::default();
    };
    r.not_given(&given.spectrum);
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
            Some(s) => api650(r, field, s, (own, internal)),
            None => (None, None),
        },
        None => {
            r.not_given(&given.api650);
            (None, None)
        }
    };
    case::Site {
        ec8,
        api650,
        spectrum,
        zone,
    }
}

/// Reports a key that is missing although this file needs it.
fn needed<T, U: FromNode>(r: &mut Resolver<'_>, object: &Field<T>, option: &Opt<U>, why: &str) {
    let name = option.key.name;
    // A key that another one stands for was already reported with this one as the suggestion.
    if option.given.is_some() || r.faults.suggest(&format!("did you mean `{name}`?")) {
        return;
    }
    let head = object.span.start..object.span.end.min(object.span.start + 1);
    let fault = Fault::new(Code::MissingKey, format!("the key `{name}` is missing{why}"))
        .at(head)
        .path(option.path.clone())
        .allowed(U::allowed())
        .help(format!("add \"{name}\": {}", U::example()));
    r.faults.push(fault);
}

fn ec8(r: &mut Resolver<'_>, object: &Field<Ec8>, s: &Ec8, own: bool) -> Option<Ec8Site> {
    if own {
        for place in [s.ground.place(), s.spectrum.place(), s.ag.place()]
            .into_iter()
            .flatten()
        {
            let message = "this and site.spectrum exclude each other";
            let allowed = "neither ground, spectrum nor ag beside site.spectrum";
            r.refuse(Code::Exclusive, &place, message, allowed);
        }
    } else {
        needed(r, object, &s.ground, "");
        needed(r, object, &s.spectrum, "");
        needed(r, object, &s.ag, "");
    }
    if let Some(ground) = &s.ground.given {
        r.echo_given(ground);
    }
    let ground = s.ground.value().copied();
    let spectrum = s.spectrum.given.as_ref().and_then(|field| r.count(field));
    let ag = s.ag.given.as_ref().map(|field| r.number(field));
    let importance = r.or_default(&s.importance);
    let behaviour_factor = r.or_default(&s.behaviour_factor);
    let construction_quality = r.or_default(&s.construction_quality);
    let vertical = r.choice(&s.vertical);
    let components = r.choice(&s.components);
    let friction = r.optional(&s.friction);
    let reduction_factor = r.optional(&s.reduction_factor);
    let bearing_capacity = r.optional(&s.bearing_capacity);
    // Not used beside the user's spectrum.
    let (ground, spectrum, ag) = match own {
        true => (GroundType::A, 1, 0.0),
        false => (ground?, spectrum?, ag?),
    };
    Some(Ec8Site {
        ground,
        spectrum: spectrum as u8,
        ag,
        importance,
        behaviour_factor,
        construction_quality,
        vertical,
        components,
        friction,
        reduction_factor,
        bearing_capacity,
    })
}

/// Whether the file asks for annex E: a key of it is given, or nothing of the zone method.
fn annex_e(s: &Api650) -> bool {
    let numbers = [
        s.fa.given.is_some(),
        s.fv.given.is_some(),
        s.q.given.is_some(),
        s.joint_efficiency.given.is_some(),
        s.friction.given.is_some(),
    ];
    let mapped = [
        s.ss.given.is_some(),
        s.s1.given.is_some(),
        s.s0.given.is_some(),
        s.av.given.is_some(),
    ];
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
fn zone(r: &mut Resolver<'_>, s: &Api650) -> Option<ZoneSite> {
    let zone_factor = r.optional(&s.zone_factor)?;
    Some(ZoneSite {
        zone_factor,
        soil_factor: r.or_default(&s.soil_factor),
        importance: r.or_default(&s.importance_1993),
    })
}

fn api650(
    r: &mut Resolver<'_>,
    object: &Field<Api650>,
    s: &Api650,
    (own, internal): (bool, f64),
) -> (Option<Api650Site>, Option<ZoneSite>) {
    if !annex_e(s) {
        return (None, zone(r, s));
    }
    needed(r, object, &s.sug, "");
    // Either all or nothing is given of the lower limit of the user's spectrum.
    let mapped = [
        s.ss.given.is_some(),
        s.s1.given.is_some(),
        s.site_class.given.is_some(),
        s.tl.given.is_some(),
    ];
    if !own || mapped.contains(&true) {
        let why = match own {
            true => " for the lower limit of site.spectrum",
            false => "",
        };
        needed(r, object, &s.ss, why);
        needed(r, object, &s.s1, why);
        needed(r, object, &s.site_class, why);
        needed(r, object, &s.tl, why);
    }
    let site = annex(r, s, (own, internal));
    (site, None)
}

/// A mapped value; zero where only the user's spectrum is given.
fn mapped<T: Si>(r: &mut Resolver<'_>, option: &Opt<T>) -> f64 {
    option.given.as_ref().map_or(0.0, |field| r.number(field))
}

/// Site coefficients that are incomplete, or missing for site class F.
fn coefficients(r: &mut Resolver<'_>, s: &Api650, site_class: Option<SiteClass>) {
    if let (Some(given), None) | (None, Some(given)) = (&s.fa.given, &s.fv.given) {
        let message = "one site coefficient without the other";
        r.refuse(Code::Incomplete, given, message, "fa and fv together, or neither");
    }
    if let (Some(SiteClass::F), Some(field), None, None) = (site_class, &s.site_class.given, &s.fa.given, &s.fv.given) {
        let message = "site class F needs a site study";
        let allowed = "fa and fv from the study, or another class";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
}

/// The design pressure, of which that of the tank is the default [Pa].
fn design_pressure(r: &mut Resolver<'_>, s: &Api650, internal: f64) -> f64 {
    let text = display_in(internal, unit_for(internal, Dimension::Stress), 4);
    let pressure = r.or_else(&s.design_pressure, internal, &text, "tank.pressure.internal");
    if let (None, Some(most)) = (&s.design_pressure.given, Some(PRESSURE.high))
        && internal > most
    {
        let message = format!("tank.pressure.internal is {text}, more than API 650 annex F covers");
        let fault = Fault::new(Code::OutOfRange, message)
            .path("tank.pressure.internal")
            .found(text.clone())
            .allowed(PRESSURE.describe(Dimension::Stress));
        r.faults
            .push(fault.help("leave site.api650 out, or give its design_pressure"));
    }
    pressure
}

fn annex(r: &mut Resolver<'_>, s: &Api650, (own, internal): (bool, f64)) -> Option<Api650Site> {
    let ss = mapped(r, &s.ss);
    let s1 = mapped(r, &s.s1);
    let s0 = r.optional(&s.s0);
    if let Some(class) = &s.site_class.given {
        r.echo_given(class);
    }
    let site_class = s.site_class.value().copied();
    let asce7 = r.count_or_default(&s.asce7);
    let fa = r.optional(&s.fa);
    let fv = r.optional(&s.fv);
    coefficients(r, s, site_class);
    let q = r.or_default(&s.q);
    if let Some(field) = &s.q.given
        && (q - 2.0 / 3.0).abs() > 0.007
        && q < 1.0
    {
        r.unusual(
            &field.path,
            &field.text,
            "usual are 2/3 with ASCE 7 maps and 1 with others, API 650 E.4.6.1",
        );
    }
    let sug = s.sug.given.as_ref().and_then(|field| r.count(field));
    let tl = mapped(r, &s.tl);
    let av = r.optional(&s.av);
    let design_pressure = design_pressure(r, s, internal);
    let joint_efficiency = r.or_default(&s.joint_efficiency);
    let friction = r.or_default(&s.friction);
    let foundation_weight = r.optional(&s.foundation_weight);
    let bearing_capacity = r.optional(&s.bearing_capacity);
    let zone_factor = r.optional(&s.zone_factor);
    let soil_factor = r.or_default(&s.soil_factor);
    let importance_1993 = r.or_default(&s.importance_1993);
    Some(Api650Site {
        bearing_capacity,
        ss,
        s1,
        s0,
        // Not used beside the user's spectrum alone.
        site_class: match own {
            true => site_class.unwrap_or(SiteClass::D),
            false => site_class?,
        },
        asce7: asce7 as u16,
        fa,
        fv,
        q,
        sug: sug? as u8,
        tl,
        av,
        design_pressure,
        joint_efficiency,
        friction,
        foundation_weight,
        zone_factor,
        soil_factor,
        importance_1993,
    })
}
