//! Seismic action of one assessment: accelerations at the tank's periods from a design spectrum or a record's spectrum.

mod ordinate;

pub(crate) use ordinate::long_period;

use super::design_spectrum;
use super::directions;
use super::spectrum::{
    Branch, EN_HORIZONTAL, EN_VERTICAL, ENV_HORIZONTAL, ENV_VERTICAL, ElasticSpectrum, EnvSpectrum, LONGEST_PERIOD,
    damping_correction, damping_correction_env, vertical_elastic,
};
use super::tabulated::{EN_CORRECTION, ENV_CORRECTION, Tabulated};
use super::vertical::BREATHING_DAMPING;
use crate::hazard::{self, CLAUSE};
use crate::ordinates::psa;
use crate::procedure::CodeError;
use crate::sheet::{Sheet, Term, number, with_unit};
use oscillator::record::Record;
use tank::Shape;
use tank::assessment::{Excitation, NotApplicable};
use tank::case::{Case, Components, Ec8Site};
use tank::hazard::{SiteSpectrum, SpectrumForm};
use tank::units::Dimension;

/// Edition of part 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edition {
    /// EN 1998-4:2006, annex A, with EN 1998-1:2004.
    En2006,
    /// ENV 1998-4:1998, annex B, with ENV 1998-1-1:1994.
    Env1998,
}

impl Edition {
    /// Clause of the annex, `2.1.2` → `EN 1998-4:2006 A.2.1.2`. The pre-standard numbers its annex alike.
    pub fn clause(self, number: &str) -> String {
        match self {
            Edition::En2006 => format!("EN 1998-4:2006 A.{number}"),
            Edition::Env1998 => format!("ENV 1998-4:1998 B.{number}"),
        }
    }

    /// A clause of the edition of 2006 in this one.
    pub(super) fn alike(self, clause: &str) -> String {
        let own = |number: &str| match number.strip_prefix("A.") {
            Some(number) => self.clause(number),
            None => self.main(number),
        };
        (clause.strip_prefix("EN 1998-4:2006 ")).map_or(clause.into(), own)
    }

    /// Clause of the main text.
    pub fn main(self, number: &str) -> String {
        match self {
            Edition::En2006 => format!("EN 1998-4:2006 {number}"),
            Edition::Env1998 => format!("ENV 1998-4:1998 {number}"),
        }
    }
}

/// Where accelerations come from.
#[derive(Clone, Copy, Debug)]
enum Source<'a> {
    En(ElasticSpectrum),
    Env(EnvSpectrum),
    Table(Tabulated<'a>),
    Record { horizontal: &'a Record, vertical: Option<&'a Record> },
}

impl<'a> Source<'a> {
    /// The user's spectrum with the damping rule and the importance factor of an edition.
    fn of_user(user: &'a SiteSpectrum, site: &Ec8Site, edition: Edition) -> Source<'a> {
        let importance = site.importance;
        let (correction, correction_formula, clause): (fn(f64) -> f64, _, _) = match edition {
            Edition::En2006 => (damping_correction, EN_CORRECTION, EN_HORIZONTAL),
            Edition::Env1998 => (damping_correction_env, ENV_CORRECTION, ENV_HORIZONTAL),
        };
        match &user.form {
            SpectrumForm::Table { damping, horizontal, vertical } => Source::Table(Tabulated {
                horizontal,
                vertical: vertical.as_ref(),
                damping: *damping,
                vertical_ratio: user.vertical_ratio,
                importance,
                correction,
                correction_formula,
                clause,
            }),
            SpectrumForm::Parameters(given) => match edition {
                Edition::En2006 => Source::En(ElasticSpectrum::of_parameters(given, user.vertical_ratio, importance)),
                Edition::Env1998 => Source::Env(EnvSpectrum::of_parameters(given, importance)),
            },
        }
    }
}

/// The seismic action of one assessment.
#[derive(Clone, Copy, Debug)]
pub struct Demand<'a> {
    source: Source<'a>,
    /// Site data, where the case has them.
    pub site: Option<Ec8Site>,
    /// Behaviour factor q of the impulsive part; 1 with a record.
    pub behaviour_factor: f64,
    /// Whether vertical motion is considered.
    pub vertical: bool,
    /// Spectrum of the user, if it is the source.
    pub user: Option<&'a SiteSpectrum>,
    /// Horizontal components that act together; one with a record and on rectangles.
    pub components: Components,
}

/// Largest behaviour factor of the impulsive part of tanks on the ground.
const LARGEST_BEHAVIOUR_FACTOR: f64 = 1.5;

impl<'a> Demand<'a> {
    /// The action of a case; not applicable without the data it needs.
    pub fn new(case: &'a Case, excitation: Excitation, edition: Edition) -> Result<Demand<'a>, CodeError> {
        let site = case.site.ec8;
        match excitation {
            Excitation::Record => {
                let motion = case
                    .ground_motion
                    .as_ref()
                    .ok_or_else(|| NotApplicable { clause: edition.main("2.1"), reason: "no record given".into() })?;
                Ok(Demand {
                    source: Source::Record { horizontal: &motion.horizontal, vertical: motion.vertical.as_ref() },
                    site,
                    behaviour_factor: 1.0,
                    vertical: motion.vertical.is_some(),
                    user: None,
                    components: Components::One,
                })
            }
            Excitation::Site => {
                let site = site.ok_or_else(|| NotApplicable {
                    clause: edition.main("2.1"),
                    reason: "`site.ec8` is not given, so there is no design spectrum".into(),
                })?;
                let q = site.behaviour_factor;
                if !(1.0..=LARGEST_BEHAVIOUR_FACTOR).contains(&q) {
                    return Err(CodeError::Data {
                        clause: edition.main("4.4"),
                        reason: format!(
                            "behaviour factor {q} found, allowed for the impulsive part of a tank on the ground is 1 to 1.5"
                        ),
                    });
                }
                let user = case.site.spectrum.as_ref();
                let source = match (user, edition) {
                    (Some(user), _) => Source::of_user(user, &site, edition),
                    (None, Edition::En2006) => Source::En(ElasticSpectrum::new(&site)?),
                    (None, Edition::Env1998) => Source::Env(EnvSpectrum::new(&site)?),
                };
                Ok(Demand {
                    source,
                    site: Some(site),
                    behaviour_factor: q,
                    vertical: site.vertical,
                    user,
                    components: match case.tank.shape {
                        Shape::Cylinder { .. } => site.components,
                        Shape::Rectangle { .. } => Components::One,
                    },
                })
            }
        }
    }

    /// Peak horizontal ground acceleration [m/s²].
    pub fn ground(&self) -> f64 {
        match &self.source {
            Source::En(s) => s.peak(),
            Source::Env(s) => s.peak(),
            Source::Table(s) => s.peak(),
            Source::Record { horizontal, .. } => horizontal.pga(),
        }
    }

    /// Peak vertical ground acceleration [m/s²]; zero if vertical motion is not considered.
    pub fn vertical_ground(&self) -> f64 {
        match &self.source {
            _ if !self.vertical => 0.0,
            Source::En(s) => s.vertical_peak(),
            Source::Env(s) => s.vertical_peak(),
            Source::Table(s) => s.vertical_peak(),
            Source::Record { vertical, .. } => vertical.map_or(0.0, Record::pga),
        }
    }

    /// Adds the lines of the ground motion.
    pub fn describe(&self, sheet: &mut Sheet) {
        sheet.section("Ground motion");
        match &self.source {
            Source::Record { horizontal, vertical } => {
                let source = format!("record {}", horizontal.name);
                sheet.input("PGA", "peak ground acceleration", horizontal.pga(), Dimension::Acceleration, &source);
                if let Some(v) = vertical {
                    let source = format!("record {}", v.name);
                    sheet.input(
                        "PGA_v",
                        "vertical peak ground acceleration",
                        v.pga(),
                        Dimension::Acceleration,
                        &source,
                    );
                }
            }
            Source::En(s) => {
                let vertical = ("k_v·a_g", ("k_v", s.vertical_ratio, Dimension::Dimensionless), EN_VERTICAL);
                self.describe_site(sheet, (s.soil, s.corners), EN_HORIZONTAL, vertical);
            }
            Source::Env(s) => {
                let vertical = ("0.7·a_g·S", ("S", s.soil, Dimension::Dimensionless), ENV_VERTICAL);
                self.describe_site(sheet, (s.soil, s.corners), ENV_HORIZONTAL, vertical);
            }
            Source::Table(s) => {
                s.describe(sheet, self.vertical);
                let (name, source) = ("behaviour factor of the impulsive part", "site.ec8.behaviour_factor");
                sheet.input("q", name, self.behaviour_factor, Dimension::Dimensionless, source);
            }
        }
        directions::describe(sheet, self.components, self.vertical);
    }

    /// Lines of a design spectrum.
    ///
    /// * soil factor, control periods [s], and their clause
    /// * formula of the vertical ground acceleration, its factor and its clause
    fn describe_site(
        &self,
        sheet: &mut Sheet,
        (soil, corners): (f64, [f64; 3]),
        clause: &str,
        (formula, factor, vertical_clause): (&str, Term, &str),
    ) {
        let Some(site) = self.site else { return };
        let (ground, given, clause) = match self.user.map(|user| &user.form) {
            Some(SpectrumForm::Parameters(own)) => (own.ag, CLAUSE.to_string(), CLAUSE),
            _ => (site.ag, format!("site.ec8, ground {:?}", site.ground), clause),
        };
        sheet.input("a_gR", "reference ground acceleration", ground, Dimension::Acceleration, &given);
        sheet.input("γ_I", "importance factor", site.importance, Dimension::Dimensionless, &given);
        sheet.calc("a_g", "design ground acceleration", "γ_I·a_gR", Dimension::Acceleration, clause);
        sheet.input("S", "soil factor", soil, Dimension::Dimensionless, clause);
        for (symbol, value) in ["T_B", "T_C", "T_D"].into_iter().zip(corners) {
            sheet.input(symbol, "control period", value, Dimension::Time, clause);
        }
        let q = self.behaviour_factor;
        sheet.input("q", "behaviour factor of the impulsive part", q, Dimension::Dimensionless, &given);
        if self.vertical {
            sheet.given(&[factor]);
            let name = "vertical ground acceleration";
            sheet.calc("a_vg", name, formula, Dimension::Acceleration, vertical_clause);
        }
    }

    /// Horizontal acceleration of the impulsive part [m/s²]: `S_e(T, ξ)/q`, as `symbol`; of the current edition and under its spectrum
    /// the larger one of that and `S_d(T)`, as `A_i`. Adds their lines.
    pub fn impulsive(
        &self,
        sheet: &mut Sheet,
        notes: &mut Vec<String>,
        symbol: &str,
        period: f64,
        damping: f64,
    ) -> f64 {
        let q = self.behaviour_factor;
        let elastic = self.horizontal(sheet, notes, symbol, "impulsive", period, damping, q);
        let of_design = symbol.replace("S_e", "S_d");
        let design = match &self.source {
            Source::En(s) => design_spectrum::line(sheet, s, &of_design, period, q),
            Source::Table(s) if s.clause == EN_HORIZONTAL => design_spectrum::table_line(sheet, s, &of_design, period),
            Source::Table(_) | Source::Env(_) | Source::Record { .. } => {
                return directions::line(sheet, self.components, "impulsive", elastic);
            }
        };
        let larger = design_spectrum::governing(sheet, elastic, design, damping);
        directions::line(sheet, self.components, "impulsive", larger)
    }

    /// Share of the horizontal accelerations beside the full vertical one.
    pub fn beside_vertical(&self) -> f64 {
        directions::beside_vertical(self.components)
    }

    /// Errors: a period [s] beyond the user's table.
    pub fn covers(&self, what: &str, period: f64) -> Result<(), CodeError> {
        hazard::covers(self.user, what, period)
    }

    /// Horizontal acceleration of a sloshing mode [m/s²]; q = 1 always. Adds its line as `symbol`.
    pub fn convective(
        &self,
        sheet: &mut Sheet,
        notes: &mut Vec<String>,
        symbol: &str,
        period: f64,
        damping: f64,
    ) -> f64 {
        let one = self.horizontal(sheet, notes, symbol, "convective", period, damping, 1.0);
        directions::line(sheet, self.components, "convective", one)
    }

    fn horizontal(
        &self,
        sheet: &mut Sheet,
        notes: &mut Vec<String>,
        symbol: &str,
        part: &str,
        period: f64,
        damping: f64,
        q: f64,
    ) -> f64 {
        let percent = number(100.0 * damping);
        let (branch, eta, corners, ag, soil, clause) = match &self.source {
            Source::Record { horizontal, .. } => {
                let at = with_unit(period, Dimension::Time);
                return sheet.look_up(
                    symbol,
                    &format!("{part} spectral acceleration of the record"),
                    &format!("spectrum of the record at T = {at}, ξ = {percent} %"),
                    psa(horizontal, period, damping),
                    Dimension::Acceleration,
                    "spectrum of the record",
                );
            }
            Source::Table(s) => return s.line(sheet, (symbol, part), (period, damping, q)),
            Source::En(s) => (
                s.horizontal_with_branch(period, damping).1,
                damping_correction(damping),
                s.corners,
                s.ag,
                s.soil,
                EN_HORIZONTAL,
            ),
            Source::Env(s) => (
                s.horizontal_with_branch(period, damping).1,
                damping_correction_env(damping),
                s.corners,
                s.ag,
                s.soil,
                ENV_HORIZONTAL,
            ),
        };
        let formula = match branch {
            Branch::Rising => "a_g·S·(1 + T/T_B·(2.5·η - 1))",
            Branch::Plateau => "a_g·S·2.5·η",
            Branch::ConstantVelocity => "a_g·S·2.5·η·T_C/T",
            Branch::ConstantDisplacement | Branch::Continued => "a_g·S·2.5·η·T_C·T_D/T²",
            Branch::AnnexA => "S_De·(2·π/T)²",
        };
        let formula = if q == 1.0 { formula.to_string() } else { format!("{formula}/q") };
        sheet.given(&[
            ("a_g", ag, Dimension::Acceleration),
            ("S", soil, Dimension::Dimensionless),
            ("η", eta, Dimension::Dimensionless),
            ("T_B", corners[0], Dimension::Time),
            ("T_C", corners[1], Dimension::Time),
            ("T_D", corners[2], Dimension::Time),
            ("T", period, Dimension::Time),
            ("q", q, Dimension::Dimensionless),
        ]);
        if let (Source::En(s), Branch::AnnexA) = (&self.source, branch) {
            long_displacement(sheet, s, part, period);
        }
        let name = format!("{part} spectral acceleration, ξ = {percent} %, {}", branch.describe());
        let value = sheet.calc(symbol, &name, &formula, Dimension::Acceleration, clause);
        if let (Source::En(s), true) = (&self.source, period > LONGEST_PERIOD) {
            notes.push(format!(
                "{symbol}: T = {} lies beyond the 4 s of EN 1998-1:2004 3.2.2.2; {}: {} (the 1/T² branch continued: {}).",
                with_unit(period, Dimension::Time),
                branch.describe(),
                with_unit(value, Dimension::Acceleration),
                with_unit(s.horizontal_continued(period, damping) / q, Dimension::Acceleration),
            ));
        }
        value
    }

    /// Vertical acceleration of the breathing mode [m/s²] at its period and 3 % damping. Adds its line.
    pub fn breathing(&self, sheet: &mut Sheet, period: f64) -> f64 {
        let damping = BREATHING_DAMPING;
        let (value, clause) = self.upwards(period);
        let source = format!(
            "vertical spectrum at T_vd = {}, ξ = {} %",
            with_unit(period, Dimension::Time),
            number(100.0 * damping)
        );
        let name = "vertical spectral acceleration of the breathing mode";
        sheet.look_up("S_ve(T_vd)", name, &source, value, Dimension::Acceleration, clause)
    }

    /// Vertical acceleration at a period [s] and 3 % damping [m/s²], with its clause.
    pub fn upwards(&self, period: f64) -> (f64, &'static str) {
        let damping = BREATHING_DAMPING;
        match &self.source {
            Source::En(s) => (s.vertical(period, damping), EN_VERTICAL),
            Source::Env(s) => (s.vertical(period, damping), ENV_VERTICAL),
            Source::Table(s) => match s.vertical(period, damping) {
                Some(value) => (value, CLAUSE),
                None => (vertical_elastic(s.vertical_peak(), period, damping), EN_VERTICAL),
            },
            Source::Record { vertical, .. } => {
                (vertical.map_or(0.0, |v| psa(v, period, damping)), "spectrum of the vertical record")
            }
        }
    }
}

/// Line of the displacement spectrum of annex A beyond 4 s, at a period [s].
fn long_displacement(sheet: &mut Sheet, s: &ElasticSpectrum, part: &str, period: f64) {
    let [t_e, t_f] = s.long_corners.unwrap_or_default();
    sheet.given(&[("T_E", t_e, Dimension::Time), ("T_F", t_f, Dimension::Time)]);
    let (formula, piece) = if period <= t_e {
        ("0.025·a_g·S·T_C·T_D·2.5·η", "T ≤ T_E")
    } else if period <= t_f {
        ("0.025·a_g·S·T_C·T_D·(2.5·η + (T - T_E)/(T_F - T_E)·(1 - 2.5·η))", "T_E ≤ T ≤ T_F")
    } else {
        ("0.025·a_g·S·T_C·T_D", "T ≥ T_F")
    };
    let name = format!("{part} spectral displacement, {piece}");
    let clause = "EN 1998-1:2004 annex A";
    sheet.calc("S_De", &name, formula, Dimension::Length, clause);
}
