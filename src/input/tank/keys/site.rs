//! `site`: site data of the codes.

use tank::Tank;
use tank::case::{self, Api650Site, Ec8Site, GroundType, SiteClass};
use tank::units::{Dimension, display_in, unit_for};

use crate::input::tank::key::{Absent, Limits, default, without};
use crate::input::tank::read::{Field, Opt, choice, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::values::{Acceleration, Force, InG, Number, Seconds, Stress, Whole};

/// Mapped accelerations in g.
const MAPPED: Limits = Limits::from(0.0).to(5.0);
/// Site coefficients.
const FACTOR: Limits = Limits::above(0.0).to(10.0);

object! {
    /// Site data for design spectra.
    Site {
        /// Eurocode 8.
        ec8: Opt<Ec8> = Absent::Without("no design spectrum of this code"),
        /// API 650.
        api650: Opt<Api650> = Absent::Without("no design spectrum of this code"),
    }

    /// Site data of Eurocode 8. Without it the Eurocode procedures run on the record's spectrum only.
    Ec8 {
        /// Ground type of EN 1998-1 table 3.1.
        ground ("B"): Field<GroundType>,
        /// Type of the elastic spectrum.
        spectrum (1): Field<Whole> [Limits::one_of(&[1.0, 2.0])],
        /// Reference peak ground acceleration a_gR on rock.
        ag ("0.25 g"): Field<Acceleration> [Limits::above(0.0).to(3.0 * tank::STANDARD_GRAVITY)],
        /// Importance factor.
        importance (1.2): Opt<Number> [Limits::above(0.0).to(3.0)]
            = default(Number(1.0)).shown("1.0").because("EN 1998-4:2006 2.1.4, class II"),
        /// Behaviour factor q of the impulsive part; at most 1.5 for a tank on the ground, EN 1998-4:2006 4.4.
        behaviour_factor (1.5): Opt<Number> [Limits::from(1.0).to(1.5)] = default(Number(1.0))
            .shown("1.0")
            .because("elastic response of the wall, on the safe side of EN 1998-4:2006 4.4"),
        /// Fabrication quality of EN 1998-4 A.10: 1 normal, 1.5 quality, 2.5 very high quality construction.
        construction_quality (1.5): Opt<Number> [Limits::one_of(&[1.0, 1.5, 2.5])]
            = default(Number(1.0)).because("normal construction, EN 1998-4:2006 A.10"),
        /// Whether the vertical design spectrum is applied.
        vertical (false): Opt<bool> = default(true).because("EN 1998-4:2006 A.2.2 and A.3.3, on the safe side"),
        /// Design friction coefficient of the foundation, tan δ divided by its partial factor γ_M, against sliding.
        friction (0.4): Opt<Number> [Limits::above(0.0).to(1.0)] = without("sliding is not checked, EN 1998-5:2004 5.4.1.1"),
        /// Reduction factor ν of the seismic action for damage limitation; EN 1998-1:2004 2.2.3 recommends 0.5 for importance classes I
        /// and II, 0.4 for III and IV.
        reduction_factor (0.5): Opt<Number> [Limits::above(0.0).to(1.0)]
            = without("damage limitation is not checked, EN 1998-4:2006 2.1.3"),
        /// Design bearing resistance of the ground under the tank in the seismic situation, as a pressure.
        bearing_capacity ("300 kPa"): Opt<Stress> [Limits::above(0.0).to(1e9)]
            = without("bearing of the ground is not checked, EN 1998-5:2004 5.4.1.1"),
    }

    /// Site data of API 650: annex E of the 13th edition, and the zone method of appendix E, 9th edition. Without it the API
    /// procedures run on the record's spectrum only.
    Api650 {
        /// Mapped short-period acceleration S_s in g.
        ss (1.0): Field<InG> [MAPPED],
        /// Mapped one-second acceleration S_1 in g.
        s1 (0.4): Field<InG> [MAPPED],
        /// Peak ground acceleration S_0 in g.
        s0 (0.4): Opt<InG> [MAPPED] = without("0.4 S_s, API 650 E.4.2"),
        /// Site class of ASCE 7.
        site_class ("D"): Field<SiteClass>,
        /// Edition of the site-coefficient tables; those of 2010 are printed in annex E.
        asce7 (2016): Opt<Whole> [Limits::one_of(&[2010.0, 2016.0])]
            = default(Whole(2010)).because("site-coefficient tables printed in API 650 annex E"),
        /// Site coefficient F_a of a site study, instead of the table's; together with fv. Site class F needs both.
        fa (1.1): Opt<Number> [FACTOR] = without("from the table of the site class"),
        /// Site coefficient F_v of a site study, instead of the table's; together with fa.
        fv (1.6): Opt<Number> [FACTOR] = without("from the table of the site class"),
        /// Factor Q from the mapped to the design earthquake; 2/3 with ASCE 7 maps, 1 with other maps.
        q (1): Opt<Number> [Limits::above(0.0).to(1.0)]
            = default(Number(2.0 / 3.0)).shown("0.6667 (2/3)").because("API 650 E.4.6.1 with ASCE 7 maps"),
        /// Seismic use group.
        sug (1): Field<Whole> [Limits::one_of(&[1.0, 2.0, 3.0])],
        /// Long-period transition T_L in seconds.
        tl (4.0): Field<Seconds> [Limits::above(0.0).to(100.0)],
        /// Vertical acceleration A_v in g.
        av (0.3): Opt<InG> [MAPPED] = without("0.47 S_DS, API 650 E.6.1.3"),
        /// Design pressure above the liquid.
        design_pressure ("2 kPa"): Opt<Stress> [Limits::from(0.0).to(1e6)]
            = Absent::Follows("tank.pressure.internal"),
        /// Joint efficiency of the shell.
        joint_efficiency (0.85): Opt<Number> [Limits::above(0.0).to(1.0)]
            = default(Number(1.0)).shown("1.0").because("fully radiographed butt joints"),
        /// Friction coefficient against sliding.
        friction (0.3): Opt<Number> [Limits::above(0.0).to(0.4)]
            = default(Number(0.4)).because("API 650 E.7.6, the largest value allowed"),
        /// Weight of the foundation and of the soil on it, W_fd + W_g, against overturning.
        foundation_weight ("3 MN"): Opt<Force> [Limits::from(0.0).to(1e10)]
            = without("overturning of the foundation is not checked, API 650 E.6.2.3"),
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

choice! {
    /// Ground type of EN 1998-1 table 3.1.
    GroundType {
        /// Rock.
        A = "A",
        /// Very dense sand, gravel or very stiff clay.
        B = "B",
        /// Deep dense or medium-dense sand, gravel or stiff clay.
        C = "C",
        /// Loose-to-medium cohesionless soil or soft-to-firm cohesive soil.
        D = "D",
        /// A surface layer of type C or D over type A.
        E = "E",
    }

    /// Site class of ASCE 7.
    SiteClass {
        /// Hard rock.
        A = "A",
        /// Rock.
        B = "B",
        /// Very dense soil and soft rock.
        C = "C",
        /// Stiff soil.
        D = "D",
        /// Soft clay soil.
        E = "E",
        /// Soils that need a site study; give fa and fv.
        F = "F",
    }
}

/// Site data, each code's where it is given.
///
/// * `tank`: gives the design pressure where `api650` does not
pub(super) fn site(r: &mut Resolver<'_>, option: &Opt<Site>, tank: Option<&Tank>) -> case::Site {
    let internal = tank.map_or(0.0, |tank| tank.pressure.internal);
    let given = option.or_absent();
    case::Site {
        ec8: given.as_ref().and_then(|s| match &s.ec8.given {
            Some(field) => field.value.as_ref().and_then(|s| ec8(r, s)),
            None => {
                r.not_given(&s.ec8);
                None
            }
        }),
        api650: given.as_ref().and_then(|s| match &s.api650.given {
            Some(field) => field.value.as_ref().and_then(|s| api650(r, s, internal)),
            None => {
                r.not_given(&s.api650);
                None
            }
        }),
    }
}

fn ec8(r: &mut Resolver<'_>, s: &Ec8) -> Option<Ec8Site> {
    r.echo_given(&s.ground);
    let ground = s.ground.value;
    let spectrum = r.count(&s.spectrum);
    let ag = r.number(&s.ag);
    let importance = r.or_default(&s.importance);
    let behaviour_factor = r.or_default(&s.behaviour_factor);
    let construction_quality = r.or_default(&s.construction_quality);
    let vertical = r.choice(&s.vertical);
    let friction = r.optional(&s.friction);
    let reduction_factor = r.optional(&s.reduction_factor);
    let bearing_capacity = r.optional(&s.bearing_capacity);
    Some(Ec8Site {
        ground: ground?,
        spectrum: spectrum? as u8,
        ag,
        importance,
        behaviour_factor,
        construction_quality,
        vertical,
        friction,
        reduction_factor,
        bearing_capacity,
    })
}

fn api650(r: &mut Resolver<'_>, s: &Api650, internal: f64) -> Option<Api650Site> {
    let ss = r.number(&s.ss);
    let s1 = r.number(&s.s1);
    let s0 = r.optional(&s.s0);
    r.echo_given(&s.site_class);
    let site_class = s.site_class.value;
    let asce7 = r.count_or_default(&s.asce7);
    let fa = r.optional(&s.fa);
    let fv = r.optional(&s.fv);
    if let (Some(given), None) | (None, Some(given)) = (&s.fa.given, &s.fv.given) {
        r.faults.push(range_fault(
            given,
            "one site coefficient without the other",
            "fa and fv together, or neither",
        ));
    }
    if site_class == Some(SiteClass::F) && s.fa.given.is_none() && s.fv.given.is_none() {
        r.faults.push(range_fault(
            &s.site_class,
            "site class F needs a site study",
            "fa and fv from the study, or another class",
        ));
    }
    let q = r.or_default(&s.q);
    let sug = r.count(&s.sug);
    let tl = r.number(&s.tl);
    let av = r.optional(&s.av);
    let text = display_in(internal, unit_for(internal, Dimension::Stress), 4);
    let design_pressure = r.or_else(&s.design_pressure, internal, &text, "tank.pressure.internal");
    let joint_efficiency = r.or_default(&s.joint_efficiency);
    let friction = r.or_default(&s.friction);
    let foundation_weight = r.optional(&s.foundation_weight);
    let zone_factor = r.optional(&s.zone_factor);
    let soil_factor = r.or_default(&s.soil_factor);
    let importance_1993 = r.or_default(&s.importance_1993);
    Some(Api650Site {
        ss,
        s1,
        s0,
        site_class: site_class?,
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
