//! Complete input of a procedure for one verification.

use serde::{Deserialize, Serialize};

use crate::hazard::SiteSpectrum;
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
        self.ec8.is_some() || self.api650.is_some() || self.spectrum.is_some() || self.zone.is_some()
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
    pub GroundType {
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

/// Site data of Eurocode 8. Where [`Site::spectrum`] is given, ground type, spectrum type and a_gR are not used.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ec8Site {
    /// Ground type.
    pub ground: GroundType,
    /// Spectrum type, 1 or 2.
    pub spectrum: u8,
    /// Reference peak ground acceleration a_gR [m/s²].
    pub ag: f64,
    /// Importance factor γ_I.
    pub importance: f64,
    /// Behaviour factor q of the impulsive part (1 unless given).
    pub behaviour_factor: f64,
    /// Fabrication quality of EN 1998-4 A.10: 1 normal, 1.5 quality, 2.5 very high quality construction.
    pub construction_quality: f64,
    /// Whether the vertical design spectrum is applied.
    pub vertical: bool,
    /// Horizontal components of a cylinder.
    #[serde(default)]
    pub components: Components,
    /// Design friction coefficient between foundation and ground (or tank and foundation), divided by its partial factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Reduction factor ν of the seismic action for damage limitation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reduction_factor: Option<f64>,
    /// Design bearing resistance of the ground in the seismic situation [Pa].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bearing_capacity: Option<f64>,
}

words! {
    /// Site class of ASCE 7.
    pub SiteClass {
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

/// Site data of API 650 (annex E of the current, appendix E of the 9th edition). Beside [`Site::spectrum`] the mapped accelerations
/// are zero if they are not given; site class and T_L are not used then.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Api650Site {
    /// Mapped short-period acceleration S_s [g].
    pub ss: f64,
    /// Mapped one-second acceleration S_1 [g].
    pub s1: f64,
    /// Peak ground acceleration S_0 [g]; 0.4 S_s unless given.
    pub s0: Option<f64>,
    /// Site class.
    pub site_class: SiteClass,
    /// Edition of the ASCE 7 site-coefficient tables: 2010 or 2016.
    pub asce7: u16,
    /// Site coefficient F_a of a site study, instead of the table's; with `fv`. Site class F needs both.
    pub fa: Option<f64>,
    /// Site coefficient F_v of a site study, instead of the table's; with `fa`.
    pub fv: Option<f64>,
    /// Scaling factor Q from MCE to design: 2/3 with ASCE 7 maps, 1 otherwise.
    pub q: f64,
    /// Seismic use group, 1 to 3.
    pub sug: u8,
    /// Long-period transition T_L [s].
    pub tl: f64,
    /// Vertical acceleration A_v [g]; 0.47 S_DS unless given.
    pub av: Option<f64>,
    /// Design pressure above the liquid P [Pa].
    pub design_pressure: f64,
    /// Joint efficiency e of the shell.
    pub joint_efficiency: f64,
    /// Friction coefficient μ of sliding, at most 0.4.
    pub friction: f64,
    /// Weight of the foundation and of the soil on it, W_fd + W_g [N].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foundation_weight: Option<f64>,
    /// Allowable pressure on the ground in the seismic combination [Pa].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bearing_capacity: Option<f64>,
    /// 9th edition: zone factor Z (0, 0.075, 0.15, 0.20, 0.30, 0.40); if absent, the zone method is not run.
    pub zone_factor: Option<f64>,
    /// 9th edition: site amplification S (1.0, 1.2, 1.5, 2.0).
    pub soil_factor: f64,
    /// 9th edition: importance I (1.0 or 1.25).
    pub importance_1993: f64,
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

/// What a file says about the ground motion of a measured or published value, in SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NamedMotion {
    /// SHA-256 of the record file, in lower case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
    /// Peak of the record as recorded [m/s²].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak: Option<f64>,
    /// Time step of the record as recorded [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// Duration of the record as recorded [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duration: Option<f64>,
    /// Peak of the motion that shook the tank, after scaling [m/s²].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub applied_peak: Option<f64>,
    /// Time step of the motion that shook the tank, after stretching [s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub applied_step: Option<f64>,
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

/// Choices for walls of concrete, EN 1992.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConcreteOptions {
    /// Partial factor of concrete γ_c.
    pub gamma_c: f64,
    /// Partial factor of reinforcement γ_s.
    pub gamma_s: f64,
    /// Tightness class of EN 1992-3 table 7.105, 0 to 3.
    pub tightness_class: u8,
}

impl ConcreteOptions {
    /// The defaults.
    pub const DEFAULT: ConcreteOptions = ConcreteOptions {
        gamma_c: 1.5,
        gamma_s: 1.15,
        tightness_class: 1,
    };
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

    /// Mass of the liquid [kg].
    pub fn liquid_mass(&self) -> f64 {
        self.liquid.mass(self.tank.shape)
    }
}
