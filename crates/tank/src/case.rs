//! Complete input of a procedure for one verification.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::hazard::SiteSpectrum;
use crate::keys::{
    Acceleration, As, ByHand, Force, InG, Limits, Needed, Number, Opt, Or, Seconds, Stress, Time, Whole, keys,
};
use crate::national::{Is1893Site, NationalSite};
use crate::quantity::Quantity;
use crate::words;
use crate::{Liquid, Tank};
use oscillator::record::Record;

/// One verification: a tank, its liquid, the ground motion and the site.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// Title for the report.
    pub name: String,
    /// The tank.
    pub tank: Tank,
    /// The liquid.
    pub liquid: Liquid,
    /// Acceleration of free fall g [m/s²].
    pub gravity: f64,
    /// Horizontal and vertical ground motion, scaled and stretched; absent in `check` without a record.
    pub ground_motion: Option<GroundMotion>,
    /// Damping ratios.
    pub damping: Damping,
    /// Site data for design spectra.
    pub site: Site,
    /// Choices within the code procedures.
    pub procedures: ProcedureOptions,
    /// Measured values for comparison.
    pub measured: Vec<Reported>,
    /// Published values of others for this tank, with remarks.
    pub published: Vec<Reported>,
}

/// Recorded ground motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroundMotion {
    /// Along x, the direction of shaking.
    pub horizontal: Record,
    /// Along y (θ = 90°), at the same time; absent for one horizontal component.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transverse: Option<Record>,
    /// Upwards; absent if not considered.
    pub vertical: Option<Record>,
}

impl GroundMotion {
    /// Duration of the longest record [s].
    pub fn duration(&self) -> f64 {
        let others = [&self.transverse, &self.vertical].into_iter().flatten();
        others.map(Record::duration).fold(self.horizontal.duration(), f64::max)
    }
}

/// Modal damping ratios, as fractions of critical.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Damping {
    /// Sloshing modes.
    pub sloshing: f64,
    /// Structural (impulsive) modes.
    pub impulsive: f64,
}

/// Site data; each is needed only for the design-spectrum column of its code.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Site {
    /// Eurocode 8.
    pub ec8: Option<Ec8Site>,
    /// API 650 / ASCE 7.
    pub api650: Option<Api650Site>,
    /// Spectrum of the user, in place of those of the codes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spectrum: Option<SiteSpectrum>,
    /// Zone method of API 650, 9th edition, where the data of annex E are not given; else they stand in `api650`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zone: Option<ZoneSite>,
    /// IS 1893-2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub is1893: Option<Is1893Site>,
    /// Data of another national code, beside its spectrum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub national: Option<NationalSite>,
}

/// Data of the zone method of API 650, 9th edition.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ZoneSite {
    /// Zone factor Z (0, 0.075, 0.15, 0.20, 0.30, 0.40).
    pub zone_factor: f64,
    /// Site amplification S (1.0, 1.2, 1.5, 2.0).
    pub soil_factor: f64,
    /// Importance I (1.0 or 1.25).
    pub importance: f64,
}

impl Site {
    /// Whether it gives a design spectrum or a zone.
    pub fn is_given(&self) -> bool {
        let coded = self.ec8.is_some() || self.api650.is_some() || self.zone.is_some() || self.is1893.is_some();
        coded || self.spectrum.is_some()
    }

    /// Data of the zone method, alone or beside those of annex E.
    pub fn zone(&self) -> Option<ZoneSite> {
        let beside = |site: &Api650Site| {
            Some(ZoneSite {
                zone_factor: site.zone_factor?,
                soil_factor: site.soil_factor,
                importance: site.importance_1993,
            })
        };
        self.zone.or_else(|| self.api650.as_ref().and_then(beside))
    }
}

words! {
    /// Ground type of EN 1998-1 table 3.1.
    pub GroundType: A {
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
}

words! {
    /// Horizontal components of the seismic action.
    pub Components: One in "snake_case" {
        /// One; two equal ones by SRSS give the same on an axisymmetric tank.
        One = "one",
        /// E_x with 0.3 E_y, and 0.3 of both beside the vertical one; EN 1998-1:2004 4.3.3.5.
        HundredThirty = "100-30",
    }
}

/// Mapped accelerations in g.
const MAPPED: Limits = Limits::from(0.0).to(5.0);
/// Site coefficients; the tables of ASCE 7 have 0.8 to 2.5 and 0.8 to 4.2, and a study at least 0.8 of them.
const FACTOR: Limits = Limits::from(0.4).to(6.0).clause("ASCE 7-16 tables 11.4-1 and 11.4-2");
/// Importance factor: 0.8, 1, 1.2 and 1.6 are recommended, the least and largest national values known are 0.65 and 1.95 (Portugal,
/// recalled). With k = 3, 0.6 and 2 stand for return periods of 100 and 3800 years beside 475.
const IMPORTANCE: Limits = Limits::from(0.6).to(2.0).usual(0.8, 1.6).clause("EN 1998-4:2006 2.1.4, classes I to IV");
/// Share of damage limitation: 0.5 and 0.4 are recommended; a return period of 95 in place of 475 years gives 0.2 with k = 1.
const REDUCTION: Limits = Limits::from(0.2).to(1.0).usual(0.4, 0.5).clause("EN 1998-1:2004 2.2.3");
/// Ground under a tank, from soft clay to rock.
const GROUND: Limits = Limits::from(1e3).to(1e8).usual(50e3, 3e6);
/// From the mapped to the design earthquake: 2/3 of ASCE 7, 1 of maps of the design earthquake; 0.66 is 2/3 rounded.
const SCALING: Limits = Limits::from(0.66).to(1.0).clause("API 650 E.4.6.1: 2/3 with ASCE 7 maps, 1 with others");
/// Long-period transition; the maps of ASCE 7 have 4 to 16 s.
const LONG: Limits = Limits::from(1.0).to(30.0).usual(4.0, 16.0).clause("ASCE 7 maps of T_L");
/// Design pressure: annex F ends at 18 kPa (2.5 psi).
const PRESSURE: Limits = Limits::from(0.0).to(18e3).clause("API 650 annex F");
/// Joint efficiency: 0.85 and 1, 0.7 of annex A; old lap joints of API 653 have at least 0.35.
const JOINT: Limits = Limits::from(0.35).to(1.0).usual(0.7, 1.0).clause("API 650 5.6, annex A; API 653 table 4.2");

keys! {
    /// Site data of Eurocode 8. Without it the Eurocode procedures run on the record's spectrum only.
    pub Ec8Site as Ec8 (Copy) {
        /// Ground type of EN 1998-1 table 3.1. Needed unless `site.spectrum` is given.
        ground ("B"): Needed<GroundType>,
        /// Type of the elastic spectrum. Needed unless `site.spectrum` is given.
        spectrum (1): As<Needed<Whole>, u8> [Limits::one_of(&[1.0, 2.0])],
        /// Reference peak ground acceleration a_gR on rock. Needed unless `site.spectrum` is given.
        ag ("0.25 g"): Needed<Acceleration>
            [Limits::from(1e-3).to(3.0 * crate::STANDARD_GRAVITY).usual(0.02 * crate::STANDARD_GRAVITY, 0.6 * crate::STANDARD_GRAVITY)],
        /// Importance factor.
        importance (1.2): Or<Number> [IMPORTANCE]
            = default(Number(1.0)).shown("1.0").because("EN 1998-4:2006 2.1.4, class II"),
        /// Behaviour factor q of the impulsive part; at most 1.5 for a tank on the ground, EN 1998-4:2006 4.4.
        behaviour_factor (1.5): Or<Number> [Limits::from(1.0).to(1.5).clause("EN 1998-4:2006 4.4")] = default(Number(1.0))
            .shown("1.0")
            .because("elastic response of the wall, on the safe side of EN 1998-4:2006 4.4"),
        /// Fabrication quality of EN 1998-4 A.10: 1 normal, 1.5 quality, 2.5 very high quality construction.
        construction_quality (1.5): Or<Number> [Limits::one_of(&[1.0, 1.5, 2.5])]
            = default(Number(1.0)).because("normal construction, EN 1998-4:2006 A.10"),
        /// Whether the vertical design spectrum is applied.
        vertical (false): Or<bool> = default(true).because("EN 1998-4:2006 A.2.2 and A.3.3, on the safe side"),
        /// Horizontal components that act together on a cylinder.
        @(default) components: Or<Components> = default(Components::One).because("EN 1998-4:2006 3.2: enough for an axisymmetric tank"),
        /// Design friction coefficient of the foundation, tan δ divided by its partial factor γ_M, against sliding.
        @"Option::is_none" friction (0.4): Opt<Number> [Limits::from(1e-3).to(1.0).usual(0.2, 0.6)] = without("sliding is not checked, EN 1998-5:2004 5.4.1.1"),
        /// Reduction factor ν of the seismic action for damage limitation; EN 1998-1:2004 2.2.3 recommends 0.5 for importance classes I
        /// and II, 0.4 for III and IV.
        @"Option::is_none" reduction_factor (0.5): Opt<Number> [REDUCTION]
            = without("damage limitation is not checked, EN 1998-4:2006 2.1.3"),
        /// Design bearing resistance of the ground under the tank in the seismic situation, as a pressure.
        @"Option::is_none" bearing_capacity ("300 kPa"): Opt<Stress> [GROUND]
            = without("bearing of the ground is not checked, EN 1998-5:2004 5.4.1.1"),
    }
}

words! {
    /// Site class of ASCE 7.
    pub SiteClass: D {
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

keys! {
    /// Site data of API 650: annex E of the 13th edition, and the zone method of appendix E, 9th edition. Without it the API
    /// procedures run on the record's spectrum only. Annex E needs ss, s1, site_class, tl and sug; under `site.spectrum` sug alone, the
    /// others for its lower limit. The zone method needs zone_factor alone.
    pub Api650Site as Api650 (Copy) {
        /// Mapped short-period acceleration S_s in g.
        ss (1.0): Needed<InG> [MAPPED.usual(0.0, 3.0)],
        /// Mapped one-second acceleration S_1 in g.
        s1 (0.4): Needed<InG> [MAPPED.usual(0.0, 1.5)],
        /// Peak ground acceleration S_0 in g.
        s0 (0.4): Opt<InG> [MAPPED.usual(0.0, 1.5)] = without("0.4 S_s, API 650 E.4.2"),
        /// Site class of ASCE 7.
        site_class ("D"): Needed<SiteClass>,
        /// Edition of the site-coefficient tables; those of 2010 are printed in annex E.
        asce7 (2016): As<Or<Whole>, u16> [Limits::one_of(&[2010.0, 2016.0])]
            = default(Whole(2010)).because("site-coefficient tables printed in API 650 annex E"),
        /// Site coefficient F_a of a site study, instead of the table's; together with fv. Site class F needs both.
        fa (1.1): Opt<Number> [FACTOR.usual(0.8, 2.5)] = without("from the table of the site class"),
        /// Site coefficient F_v of a site study, instead of the table's; together with fa.
        fv (1.6): Opt<Number> [FACTOR.usual(0.8, 4.2)] = without("from the table of the site class"),
        /// Factor Q from the mapped to the design earthquake; 2/3 with ASCE 7 maps, 1 with other maps.
        q (1): ByHand<Or<Number>, f64> [SCALING]
            = default(Number(2.0 / 3.0)).shown("0.6667 (2/3)").because("API 650 E.4.6.1 with ASCE 7 maps"),
        /// Seismic use group.
        sug (1): As<Needed<Whole>, u8> [Limits::one_of(&[1.0, 2.0, 3.0])],
        /// Long-period transition T_L in seconds.
        tl (4.0): Needed<Seconds> [LONG],
        /// Vertical acceleration A_v in g.
        av (0.3): Opt<InG> [MAPPED.usual(0.0, 1.0)] = without("0.47 S_DS, API 650 E.6.1.3"),
        /// Design pressure above the liquid.
        design_pressure ("2 kPa"): ByHand<Opt<Stress>, f64> [PRESSURE]
            = Absent::Follows("tank.pressure.internal"),
        /// Joint efficiency of the shell.
        joint_efficiency (0.85): Or<Number> [JOINT]
            = default(Number(1.0)).shown("1.0").because("fully radiographed butt joints"),
        /// Friction coefficient against sliding.
        friction (0.3): Or<Number> [Limits::from(1e-3).to(0.4).usual(0.2, 0.4).clause("API 650 E.7.6")]
            = default(Number(0.4)).because("API 650 E.7.6, the largest value allowed"),
        /// Weight of the foundation and of the soil on it, W_fd + W_g, against overturning.
        @"Option::is_none" foundation_weight ("3 MN"): Opt<Force> [Limits::from(0.0).to(1e10)]
            = without("overturning of the foundation is not checked, API 650 E.6.2.3"),
        /// Allowable pressure on the ground in the seismic combination.
        @"Option::is_none" bearing_capacity ("250 kPa"): Opt<Stress> [GROUND]
            = without("bearing of the ground is not checked, API 650 E.6.2.3"),
        /// 9th edition: zone factor Z.
        zone_factor (0.3): Opt<Number> [Limits::one_of(&[0.0, 0.075, 0.15, 0.2, 0.3, 0.4])]
            = without("the zone method of the 9th edition is not run"),
        /// 9th edition: site amplification S.
        soil_factor (1.2): Or<Number> [Limits::one_of(&[1.0, 1.2, 1.5, 2.0])]
            = default(Number(1.5)).because("soil profile S3, API 650 9th edition, soil not known"),
        /// 9th edition: importance factor I.
        importance_1993 (1.25): Or<Number> [Limits::one_of(&[1.0, 1.25])]
            = default(Number(1.0)).shown("1.0").because("API 650 9th edition E.3.1, ordinary tank"),
    }
}

/// A value that somebody measured or published, in SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reported {
    /// The quantity.
    pub quantity: Quantity,
    /// Value in SI.
    pub value: f64,
    /// Source.
    pub source: String,
    /// Remark ("belongs to the record as recorded, not to the stated scaling").
    pub note: Option<String>,
    /// Ground motion of the value, if the file names it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<NamedMotion>,
}

keys! {
    /// A ground motion: the record as recorded, before `record` of this file processes it, by `sha256` or by `peak` and `step`; and
    /// what shook the tank. Numbers count as equal within 1 %, the accuracy of three printed digits.
    pub NamedMotion as Motion (Default) {
        /// SHA-256 of the record file.
        @"Option::is_none" sha256 ("787e5172cebfd464c7a91e776fabe476afbedab5018f501e2028b285549f95ee"): Opt<String>,
        /// Peak ground acceleration of the record as recorded.
        @"Option::is_none" peak ("0.348 g"): Opt<Acceleration> [Limits::above(0.0).to(1000.0 * crate::STANDARD_GRAVITY)] = without("not named"),
        /// Time step of the record as recorded.
        @"Option::is_none" step ("0.02 s"): Opt<Time> [Limits::above(0.0).to(10.0)] = without("not named"),
        /// Duration of the record as recorded.
        @"Option::is_none" duration ("53.74 s"): Opt<Time> [Limits::above(0.0).to(1e6)] = without("not named"),
        /// Peak of the motion that shook the tank, after scaling.
        @"Option::is_none" applied_peak ("0.5 g"): Opt<Acceleration> [Limits::above(0.0).to(1000.0 * crate::STANDARD_GRAVITY)] = without("not named"),
        /// Time step of the motion that shook the tank, after stretching the time axis.
        @"Option::is_none" applied_step ("0.01155 s"): Opt<Time> [Limits::above(0.0).to(10.0)] = without("not named"),
    }
}

words! {
    /// How the maxima of two parts are added.
    pub Combination {
        /// Sum of absolute values.
        Abs = "abs",
        /// Square root of the sum of squares.
        Srss = "srss",
    }
}

words! {
    /// Convective coefficients of Housner's procedure.
    pub ConvectiveCoefficient {
        /// The exact first-mode coefficients of potential flow.
        Exact = "exact",
        /// Housner 1957: 0.318 (circular) and 0.527 (rectangular).
        Housner1957 = "1957",
    }
}

words! {
    /// The flexible impulsive part of EN 1998-4.
    pub FlexibleImpulsive {
        /// A.3.2.2 with the coefficients of table A.2.
        Simplified = "simplified",
        /// A.3.1 with the iterated mode shape.
        Iterative = "iterative",
    }
}

/// Choices within the code procedures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProcedureOptions {
    /// Housner: convective coefficients.
    pub housner_convective: ConvectiveCoefficient,
    /// Housner: combination (absolute sum by default).
    pub housner_combination: Combination,
    /// EC8: combination (absolute sum by default).
    pub ec8_combination: Combination,
    /// EC8: flexible impulsive part.
    pub ec8_impulsive: FlexibleImpulsive,
    /// EN 1992: walls of concrete.
    #[serde(default)]
    pub concrete: ConcreteOptions,
}

keys! {
    /// Choices for walls of concrete in the Eurocode procedures.
    pub ConcreteOptions (Copy) {
        /// Partial factor of concrete.
        gamma_c (1.2): Or<Number> [Limits::from(1.0).to(2.0)]
            = default(Number(ConcreteOptions::DEFAULT.gamma_c)).because("EN 1992-1-1 table 2.1N, EN 1998-1 5.2.4"),
        /// Partial factor of reinforcement.
        gamma_s (1.0): Or<Number> [Limits::from(1.0).to(2.0)]
            = default(Number(ConcreteOptions::DEFAULT.gamma_s)).because("EN 1992-1-1 table 2.1N, EN 1998-1 5.2.4"),
        /// Tightness class, EN 1992-3 table 7.105. Classes 2 and 3 are not checked.
        tightness_class (1): As<Or<Whole>, u8> [Limits::one_of(&[0.0, 1.0, 2.0, 3.0])]
            = default(Whole(ConcreteOptions::DEFAULT.tightness_class as u32)).because("EN 1992-3 7.3.1: leakage limited to a small amount"),
    }
}

impl ConcreteOptions {
    /// The defaults.
    pub const DEFAULT: ConcreteOptions = ConcreteOptions { gamma_c: 1.5, gamma_s: 1.15, tightness_class: 1 };
}

impl Default for ConcreteOptions {
    fn default() -> Self {
        ConcreteOptions::DEFAULT
    }
}

impl ProcedureOptions {
    /// The defaults.
    pub const DEFAULT: ProcedureOptions = ProcedureOptions {
        housner_convective: ConvectiveCoefficient::Exact,
        housner_combination: Combination::Abs,
        ec8_combination: Combination::Abs,
        ec8_impulsive: FlexibleImpulsive::Simplified,
        concrete: ConcreteOptions::DEFAULT,
    };
}

impl Default for ProcedureOptions {
    fn default() -> Self {
        ProcedureOptions::DEFAULT
    }
}

impl Case {
    /// Height of the wall above the still liquid [m].
    pub fn freeboard(&self) -> f64 {
        self.tank.wall_height() - self.liquid.fill_height - self.tank.roof.rim
    }

    /// The case with this share of the snow load in the mass of its roof, in place of any other.
    pub fn with_snow(&self, share: f64) -> Cow<'_, Case> {
        let (roof, area) = (self.tank.roof, self.tank.shape.plan_area());
        let snowed = roof.with_snow(share, area, self.gravity);
        if snowed == roof {
            return Cow::Borrowed(self);
        }
        let mut case = self.clone();
        case.tank.roof = snowed;
        Cow::Owned(case)
    }

    /// Mass of the liquid [kg].
    pub fn liquid_mass(&self) -> f64 {
        self.liquid.mass(self.tank.shape)
    }
}
