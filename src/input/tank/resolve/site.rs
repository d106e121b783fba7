//! Site data of the codes.

use tank::case::{Api650Site, Ec8Site, GroundType, Site, SiteClass};

use super::{Limits, Resolver, range_fault};
use crate::input::tank::read::Field;
use crate::input::tank::schema;
use crate::input::tank::values::{Number, Stress, Whole};

/// Site data, each code's where it is given.
pub(super) fn site(r: &mut Resolver<'_>, field: &Option<Field<schema::Site>>) -> Site {
    let given = field.as_ref().and_then(|f| f.value.as_ref());
    let part = "no design spectrum of this code";
    let ec8 = match given.map(|s| &s.ec8) {
        Some(Some(field)) => field.value.as_ref().and_then(|s| ec8(r, s)),
        _ => {
            r.echo_default("site.ec8", "not given", part);
            None
        }
    };
    let api650 = match given.map(|s| &s.api650) {
        Some(Some(field)) => field.value.as_ref().and_then(|s| api650(r, s)),
        _ => {
            r.echo_default("site.api650", "not given", part);
            None
        }
    };
    Site { ec8, api650 }
}

/// A whole number of a few.
fn whole(r: &mut Resolver<'_>, field: &Field<Whole>, allowed: &[u32]) -> Option<u32> {
    r.echo_given(field);
    let value = field.value?.0;
    if allowed.contains(&value) {
        return Some(value);
    }
    let words: Vec<String> = allowed.iter().map(u32::to_string).collect();
    let words = crate::input::tank::read::list(&words.iter().map(String::as_str).collect::<Vec<_>>(), "or");
    r.faults
        .push(range_fault(field, "not one of the values the code knows", &words));
    None
}

fn ec8(r: &mut Resolver<'_>, s: &schema::Ec8) -> Option<Ec8Site> {
    r.echo_given(&s.ground);
    let ground = s.ground.value.map(|g| match g {
        schema::Ground::A => GroundType::A,
        schema::Ground::B => GroundType::B,
        schema::Ground::C => GroundType::C,
        schema::Ground::D => GroundType::D,
        schema::Ground::E => GroundType::E,
    });
    let spectrum = whole(r, &s.spectrum, &[1, 2]);
    let ag = r.number(&s.ag, Limits::above(0.0).to(3.0 * tank::STANDARD_GRAVITY));
    let importance = r.or_default(
        "site.ec8.importance",
        &s.importance,
        Limits::above(0.0).to(3.0),
        Number(1.0),
        "1.0",
        "EN 1998-4:2006 2.1.4, class II",
    );
    let behaviour_factor = r.or_default(
        "site.ec8.behaviour_factor",
        &s.behaviour_factor,
        Limits::from(1.0).to(5.0),
        Number(1.0),
        "1.0",
        "elastic response of the wall, on the safe side of EN 1998-4:2006 4.4",
    );
    let construction_quality = match &s.construction_quality {
        Some(field) => r.one_of(field, &[1.0, 1.5, 2.5]),
        None => {
            r.echo_default(
                "site.ec8.construction_quality",
                "1",
                "normal construction, EN 1998-4:2006 A.10",
            );
            1.0
        }
    };
    let vertical = r.choice(
        "site.ec8.vertical",
        &s.vertical,
        true,
        "true",
        "EN 1998-4:2006 A.2.2 and A.3.3, on the safe side",
    );
    Some(Ec8Site {
        ground: ground?,
        spectrum: spectrum? as u8,
        ag,
        importance,
        behaviour_factor,
        construction_quality,
        vertical,
    })
}

fn api650(r: &mut Resolver<'_>, s: &schema::Api650) -> Option<Api650Site> {
    const MAPPED: Limits = Limits::from(0.0).to(5.0);
    const FACTOR: Limits = Limits::above(0.0).to(10.0);
    let ss = r.number(&s.ss, MAPPED);
    let s1 = r.number(&s.s1, MAPPED);
    let s0 = r.optional("site.api650.s0", &s.s0, MAPPED, "0.4 S_s, API 650 E.4.2");
    r.echo_given(&s.site_class);
    let site_class = s.site_class.value.map(|c| match c {
        schema::SiteClass::A => SiteClass::A,
        schema::SiteClass::B => SiteClass::B,
        schema::SiteClass::C => SiteClass::C,
        schema::SiteClass::D => SiteClass::D,
        schema::SiteClass::E => SiteClass::E,
        schema::SiteClass::F => SiteClass::F,
    });
    let asce7 = match &s.asce7 {
        Some(field) => whole(r, field, &[2010, 2016]),
        None => {
            r.echo_default(
                "site.api650.asce7",
                "2010",
                "site-coefficient tables printed in API 650 annex E",
            );
            Some(2010)
        }
    };
    let fa = r.optional("site.api650.fa", &s.fa, FACTOR, "from the table of the site class");
    let fv = r.optional("site.api650.fv", &s.fv, FACTOR, "from the table of the site class");
    if let (Some(given), None) | (None, Some(given)) = (&s.fa, &s.fv) {
        r.faults.push(range_fault(
            given,
            "one site coefficient without the other",
            "fa and fv together, or neither",
        ));
    }
    if site_class == Some(SiteClass::F) && s.fa.is_none() && s.fv.is_none() {
        r.faults.push(range_fault(
            &s.site_class,
            "site class F needs a site study",
            "fa and fv from the study, or another class",
        ));
    }
    let q = r.or_default(
        "site.api650.q",
        &s.q,
        Limits::above(0.0).to(1.0),
        Number(2.0 / 3.0),
        "0.6667 (2/3)",
        "API 650 E.4.6.1 with ASCE 7 maps",
    );
    let sug = whole(r, &s.sug, &[1, 2, 3]);
    let tl = r.number(&s.tl, Limits::above(0.0).to(100.0));
    let av = r.optional("site.api650.av", &s.av, MAPPED, "0.47 S_DS, API 650 E.6.1.3");
    let design_pressure = r.or_default(
        "site.api650.design_pressure",
        &s.design_pressure,
        Limits::from(0.0).to(1e6),
        Stress(0.0),
        "0 Pa",
        "atmospheric tank",
    );
    let joint_efficiency = r.or_default(
        "site.api650.joint_efficiency",
        &s.joint_efficiency,
        Limits::above(0.0).to(1.0),
        Number(1.0),
        "1.0",
        "fully radiographed butt joints",
    );
    let friction = r.or_default(
        "site.api650.friction",
        &s.friction,
        Limits::above(0.0).to(0.4),
        Number(0.4),
        "0.4",
        "API 650 E.7.6, the largest value allowed",
    );
    let zone_factor = match &s.zone_factor {
        Some(field) => Some(r.one_of(field, &[0.0, 0.075, 0.15, 0.2, 0.3, 0.4])),
        None => {
            r.echo_default(
                "site.api650.zone_factor",
                "not given",
                "the zone method of the 9th edition is not run",
            );
            None
        }
    };
    let soil_factor = match &s.soil_factor {
        Some(field) => r.one_of(field, &[1.0, 1.2, 1.5, 2.0]),
        None => {
            r.echo_default(
                "site.api650.soil_factor",
                "1.5",
                "soil profile S3, API 650 9th edition, soil not known",
            );
            1.5
        }
    };
    let importance_1993 = match &s.importance_1993 {
        Some(field) => r.one_of(field, &[1.0, 1.25]),
        None => {
            r.echo_default(
                "site.api650.importance_1993",
                "1.0",
                "API 650 9th edition E.3.1, ordinary tank",
            );
            1.0
        }
    };
    Some(Api650Site {
        ss,
        s1,
        s0,
        site_class: site_class?,
        asce7: asce7? as u16,
        fa,
        fv,
        q,
        sug: sug? as u8,
        tl,
        av,
        design_pressure,
        joint_efficiency,
        friction,
        zone_factor,
        soil_factor,
        importance_1993,
    })
}
