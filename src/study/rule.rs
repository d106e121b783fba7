//! Whether a set of records stands for a spectrum: [`answer`] asks the rule of a code (`codes::record_set`) for `quake set`, for `compare` and for
//! a study.
//!
//! A study takes its records as read, along x. Levels scale them one by one later; the factor says by how much the set as it is falls short.

use std::f64::consts::TAU;

use codes::record_set::standard::Standard;
use codes::record_set::{self, Asked, Horizontal, Ratios};
use files::code::Code;
use oscillator::record::Record;
use oscillator::spectrum::{Method, spectrum};
use results::Method as Column;
use serde::{Deserialize, Serialize};
use tank::case::Site;
use tank::check::Decision;
use tank::hazard::SpectrumTable;
use tank::{Bearing, Case, Quantity};

use crate::error::Error;
use crate::input::TankFile;
use crate::input::study::{Rule, RulePeriods};
use crate::job::Job;
use crate::pipeline::procedures::{decide, select_procedures};

/// The rule of a study.
const RULE: Standard = Standard::En1998;
/// Damping ratio of the clause.
pub const FIVE: f64 = 0.05;

/// A period at which the rule is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// `impulsive`, `sloshing`, `isolators` or `given`.
    pub which: &'static str,
    /// Period [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Short name of the procedure or engine that gives the period; empty where it is given.
    pub of: &'static str,
}

/// A spectrum: acceleration [m/s²] over the period [s].
pub type Curve = Box<dyn Fn(f64) -> f64>;

/// The outcome at a period of a tank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuleRow {
    /// Tank; empty where the period and the target are the same for all.
    pub tank: String,
    /// Which period.
    pub which: String,
    /// Period [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Smallest mean over target from 0.2 T to 2 T.
    pub smallest_ratio: f64,
    /// Mean of the peaks over the target at T = 0.
    pub mean_zero_period_ratio: f64,
    /// The one factor for the set with which the rule just holds.
    pub factor: f64,
    /// Whether it holds for the set as it is.
    pub holds: bool,
}

/// The outcome for a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuleFound {
    /// Clause.
    pub clause: String,
    /// Target: `site`, or the name of a table.
    pub target: String,
    /// Whether it holds at every row.
    pub holds: bool,
    /// Tank by tank, period by period.
    pub rows: Vec<RuleRow>,
}

/// A question to the rule of a code: its target, and the periods.
pub struct Question<'a> {
    /// The code.
    pub code: Standard,
    /// Target; none for the elastic spectrum of the site.
    pub table: Option<&'a SpectrumTable>,
    /// Name of the target, for messages.
    pub target: &'a str,
    /// Site of the tank.
    pub site: &'a Site,
    /// Periods.
    pub wanted: &'a [Wanted],
}

impl Question<'_> {
    /// The target at a damping.
    ///
    /// Errors: those of [`elastic`].
    fn curve(&self, damping: f64) -> Result<Curve, Error> {
        match self.table {
            Some(table) => {
                let table = table.clone();
                // Beyond the last row nothing is asked.
                Ok(Box::new(move |period| table.at(period).unwrap_or(f64::NAN)))
            }
            None => elastic(self.site, self.code, damping),
        }
    }
}

/// What the rule says of a set as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Mean of the peaks over the target at T = 0, where the code asks for it.
    pub zero: Option<f64>,
    /// Period by period.
    pub periods: Vec<(Wanted, Ratios)>,
    /// Smallest mean/target of all periods.
    pub smallest: f64,
    /// The one factor for the set with which the rule just holds.
    pub factor: f64,
    /// Whether it holds for the set as it is.
    pub holds: bool,
}

/// The elastic spectrum of a site at a damping: that of EN 1998, or the design spectrum of ASCE 7 under API 650, whose ordinates below 5 % damping
/// are times 1.5 (API 650 E.4.6.1, ASCE/SEI 7-16 15.7.6.1, recalled: for the 0.5 % of sloshing).
///
/// Errors: a tank file without the site of the code.
pub fn elastic(site: &Site, code: Standard, damping: f64) -> Result<Curve, Error> {
    let (own, key, of) = match code {
        Standard::En1998 => (Site { api650: None, zone: None, ..site.clone() }, "site.ec8", "elastic"),
        Standard::Asce716 => (Site { ec8: None, zone: None, ..site.clone() }, "site.api650", "design"),
    };
    let mut curves = codes::ALL.iter().flat_map(|p| p.design_curves(&own, &[damping]));
    let Some(found) = curves.next() else {
        return Err(Error::missing(format!(
            "the tank file has no `{key}`, whose {of} spectrum the rule compares with\n  help: add it, or give a table of the spectrum"
        )));
    };
    let factor = if damping < 0.99 * found.damping { 1.5 } else { 1.0 };
    Ok(match code {
        Standard::En1998 => found.acceleration,
        Standard::Asce716 => {
            let curve = found.acceleration;
            Box::new(move |period| factor * curve(period))
        }
    })
}

/// Longest period that the spectrum of a site covers [s].
pub fn longest(site: &Site) -> f64 {
    site.spectrum.as_ref().map_or(f64::INFINITY, codes::hazard::longest)
}

/// The impulsive and the sloshing period of a tank under its site: that of a procedure that decides, in report order; where none gives one, that of
/// the first procedure that does.
///
/// Errors: a tank without a procedure that gives one.
pub fn periods(case: &Case, decision: &Decision) -> Result<Vec<Wanted>, Error> {
    let still = Case { ground_motion: None, ..case.clone() };
    let job = Job::of_case(still, select_procedures(&[], &decision.decide, &case.site)?, decision.clone());
    let (methods, verdict) = decide(&job)?;
    let decides = |m: &&Column| verdict.deciding.iter().any(|d| d.method == m.id && d.excitation == m.excitation);
    let in_force = |m: &&Column| codes::ALL.iter().any(|p| p.id() == m.id && p.decides(&case.site));
    let (first, rest): (Vec<&Column>, Vec<&Column>) = methods.iter().partition(decides);
    let (second, superseded): (Vec<&Column>, Vec<&Column>) = rest.into_iter().partition(in_force);
    let of = |quantity: Quantity| {
        first.iter().chain(&second).chain(&superseded).find_map(|m| {
            let name = codes::ALL.iter().find(|p| p.id() == m.id)?.label().short;
            Some((m.quantities.get(quantity.id())?.value, name))
        })
    };
    let wanted = both(case, [of(Quantity::ImpulsivePeriod), of(Quantity::SloshingPeriod)]);
    match wanted.is_empty() {
        true => Err(Error::missing(
            "no procedure gives a period of this tank\n  help: give the period, and `site.ec8` in the tank file",
        )),
        false => Ok(wanted),
    }
}

/// The periods of a tank at which a rule is asked: impulsive and sloshing [s], each with the short name of what gives it, and that of its isolators.
pub fn both(case: &Case, periods: [Option<(f64, &'static str)>; 2]) -> Vec<Wanted> {
    let [impulsive, sloshing] = periods;
    let found = [("impulsive", impulsive, FIVE), ("sloshing", sloshing, case.damping.sloshing)];
    let wanted = found.into_iter().filter_map(|(which, period, damping)| {
        let (period, of) = period?;
        Some(Wanted { which, period, damping, of })
    });
    wanted.chain(isolated(case)).collect()
}

/// The period of a tank on its bearings after they yield or slide: the longest that its motion has on them. Below a fifth of it the rule is asked around
/// the impulsive period.
fn isolated(case: &Case) -> Option<Wanted> {
    let own = case.tank.isolators?;
    let mass = case.liquid_mass() + case.tank.wall_mass() + case.tank.roof.mass + own.slab_mass;
    let omega = match own.bearing {
        Bearing::FrictionPendulum { radius, .. } => (case.gravity / radius).sqrt(),
        Bearing::LeadRubber { yielded, .. } => (yielded / mass).sqrt(),
        Bearing::Elastomer { stiffness, .. } => (stiffness / mass).sqrt(),
    };
    Some(Wanted { which: "isolators", period: TAU / omega, damping: FIVE, of: "isolators" })
}

/// Whether the target reaches twice every period.
///
/// Errors: one that ends before.
pub fn reaches(question: &Question<'_>) -> Result<(), Error> {
    let &Question { code, table, site, .. } = question;
    let [_, far] = code.range();
    let end = table.map_or_else(|| longest(site), SpectrumTable::longest);
    if let Some(wanted) = question.wanted.iter().find(|w| far * w.period > end * (1.0 + 1e-9)) {
        let (what, help) = match table {
            Some(_) => ("the table", "add rows"),
            None => ("the spectrum of the site", "give more of it, or a table"),
        };
        return Err(Error::input(
            Code::OutOfRange,
            format!(
                "target `{}`: {what} ends at {end} s, before 2 T = {} s\n  help: {help}; it is not continued",
                question.target,
                far * wanted.period
            ),
        ));
    }
    Ok(())
}

impl Answer {
    /// In what a set of `count` records misses the rule; none where it holds.
    pub fn misses(&self, code: Standard, count: usize) -> Option<String> {
        if self.holds {
            return None;
        }
        let mut reasons = Vec::new();
        if count < code.fewest() {
            reasons.push(format!("{count} records of at least {}", code.fewest()));
        }
        let failing = |(wanted, ratios): &(Wanted, Ratios)| {
            (ratios.smallest.0 < code.share() * (1.0 - 1e-9)).then_some((*wanted, ratios.smallest.0))
        };
        for (wanted, ratio) in self.periods.iter().filter_map(failing) {
            reasons.push(format!(
                "smallest ratio of the mean spectra {ratio:.3} of {} around the {} period, {:.3} s",
                code.share(),
                wanted.which,
                wanted.period,
            ));
        }
        if let Some(peaks) = self.zero.filter(|ratio| *ratio < 1.0) {
            reasons.push(format!("mean of the peaks {peaks:.3} of the target"));
        }
        Some(format!(
            "the set of records does not hold for its target spectrum ({}): {}",
            code.clause(),
            reasons.join(", ")
        ))
    }
}

/// Asks the rule of a set as it is.
///
/// Errors: a tank without the site of the code; a target that ends before twice a period.
pub fn answer(question: &Question<'_>, set: &[Horizontal<'_>]) -> Result<Answer, Error> {
    let code = question.code;
    reaches(question)?;
    let zero = record_set::zero_period(code, set, &*question.curve(FIVE)?);
    let mut periods = Vec::new();
    for wanted in question.wanted {
        let target = question.curve(wanted.damping)?;
        let asked = Asked { period: wanted.period, damping: wanted.damping, target: &*target };
        periods.push((*wanted, record_set::ratios(code, set, &asked)));
    }
    let smallest = periods.iter().map(|(_, r)| r.smallest.0).fold(f64::INFINITY, f64::min);
    Ok(Answer {
        factor: record_set::factor(code, smallest, zero),
        holds: record_set::holds(code, set.len(), smallest, zero),
        zero,
        periods,
        smallest,
    })
}

/// First line of an error, without its word.
pub fn reason(error: &Error) -> String {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    first.trim_start_matches("error: ").to_owned()
}

/// The periods at which the rule is asked for a tank.
///
/// Errors: those of [`periods`].
fn wanted(rule: &Rule, tank: &TankFile) -> Result<Vec<Wanted>, Error> {
    let kept = |w: &Wanted| match rule.periods {
        RulePeriods::Impulsive => w.which == "impulsive",
        RulePeriods::Sloshing => w.which == "sloshing",
        _ => true,
    };
    match rule.periods {
        RulePeriods::Given(period) => Ok(vec![Wanted { which: "given", period, damping: FIVE, of: "" }]),
        _ => Ok(periods(&tank.case, &tank.decision)?.into_iter().filter(kept).collect()),
    }
}

/// An error with the name of its tank.
fn of_tank(id: &str, error: &Error) -> Error {
    Error::input(error.code().unwrap_or(Code::MissingInput), format!("{}\n  tank: {id}", error.to_string().trim_end()))
}

/// Periods of the spectra in a decade, evenly spaced in ln T, as in [`record_set::ratios`].
const A_DECADE: i32 = 400;
/// Periods that differ less than this, relatively, are one.
const SAME: f64 = 1e-9;

/// The mean spectra of the records, by damping: the ranges of different tanks overlap, and each period is integrated once.
struct Means(Vec<(f64, Vec<[f64; 2]>)>);

impl Means {
    /// Over the ranges of all wanted periods, with the ends of each.
    fn new<'a>(records: &[Record], wanted: impl Iterator<Item = &'a Wanted>) -> Means {
        let mut by_damping: Vec<(f64, Vec<f64>)> = Vec::new();
        for one in wanted {
            match by_damping.iter_mut().find(|(damping, _)| *damping == one.damping) {
                Some((_, all)) => all.push(one.period),
                None => by_damping.push((one.damping, vec![one.period])),
            }
        }
        let spectra = by_damping.into_iter().map(|(damping, all)| {
            let periods = grid(&all);
            let mut mean = vec![0.0; periods.len()];
            for record in records {
                let found = spectrum(record, &periods, &[damping], Method::Exact);
                for (sum, ordinates) in mean.iter_mut().zip(&found.ordinates[0]) {
                    *sum += ordinates.psa / records.len() as f64;
                }
            }
            (damping, periods.into_iter().zip(mean).map(<[f64; 2]>::from).collect())
        });
        Means(spectra.collect())
    }

    /// The smallest mean over target around a period.
    fn smallest(&self, wanted: &Wanted, target: &dyn Fn(f64) -> f64) -> f64 {
        let [low, high] = RULE.range().map(|r| r * wanted.period);
        let spectrum = self.0.iter().find(|(damping, _)| *damping == wanted.damping);
        let points = spectrum.into_iter().flat_map(|(_, points)| points);
        points
            .filter(|[t, _]| (low * (1.0 - SAME)..=high * (1.0 + SAME)).contains(t))
            .map(|[t, mean]| mean / target(*t))
            .fold(f64::INFINITY, f64::min)
    }
}

/// Periods from the lowest to the highest of the ranges around all periods [s], in ascending order; the ends of each range among them.
fn grid(all: &[f64]) -> Vec<f64> {
    let Some(&first) = all.first() else { return Vec::new() };
    let [low, high] = RULE.range().map(|r| r * first);
    let step = (high / low).ln() / f64::from(A_DECADE);
    let place = |t: f64| (t / low).ln() / step;
    let lowest = all.iter().map(|t| place(RULE.range()[0] * t)).fold(0.0, f64::min);
    let highest = all.iter().map(|t| place(RULE.range()[1] * t)).fold(0.0, f64::max);
    let even = (lowest.ceil() as i32..=(highest - SAME).ceil() as i32).map(|k| low * (step * f64::from(k)).exp());
    let mut periods: Vec<f64> = even.collect();
    let ends = all.iter().flat_map(|t| RULE.range().map(|r| r * t));
    periods.extend(ends.filter(|t| (place(*t) - place(*t).round()).abs() * step > SAME));
    periods.sort_by(f64::total_cmp);
    periods.dedup_by(|later, earlier| *later / *earlier - 1.0 < SAME);
    periods
}

/// Asks the rule for every tank.
///
/// * `tanks`: name and tank without sampling
/// * `records`: along x, as read
///
/// Errors: those of [`answer`] and [`periods`], with the name of the tank.
pub fn ask(rule: &Rule, tanks: &[(String, TankFile)], records: &[Record]) -> Result<RuleFound, Error> {
    // A given period and a table are the same for all tanks: one row.
    let alone = rule.table.is_some() && matches!(rule.periods, RulePeriods::Given(_));
    let asked: Vec<(&String, &TankFile, Vec<Wanted>)> = tanks
        .iter()
        .take(if alone { 1 } else { tanks.len() })
        .map(|(id, tank)| Ok((id, tank, wanted(rule, tank).map_err(|error| of_tank(id, &error))?)))
        .collect::<Result<_, Error>>()?;
    let means = Means::new(records, asked.iter().flat_map(|(_, _, wanted)| wanted));
    let set: Vec<Horizontal<'_>> = records.iter().map(Horizontal::from).collect();
    let mut rows = Vec::new();
    for (id, tank, wanted) in asked {
        let question = Question {
            code: RULE,
            table: rule.table.as_ref(),
            target: &rule.target,
            site: &tank.case.site,
            wanted: &wanted,
        };
        let of_tank = |error: Error| of_tank(id, &error);
        reaches(&question).map_err(of_tank)?;
        let zero = record_set::zero_period(RULE, &set, &*question.curve(FIVE).map_err(of_tank)?);
        for wanted in &wanted {
            let smallest = means.smallest(wanted, &*question.curve(wanted.damping).map_err(of_tank)?);
            rows.push(RuleRow {
                tank: if alone { String::new() } else { id.clone() },
                which: wanted.which.into(),
                period: wanted.period,
                damping: wanted.damping,
                smallest_ratio: smallest,
                // This code asks for the peaks.
                mean_zero_period_ratio: zero.unwrap_or(f64::INFINITY),
                factor: record_set::factor(RULE, smallest, zero),
                holds: record_set::holds(RULE, records.len(), smallest, zero),
            });
        }
    }
    Ok(RuleFound {
        clause: RULE.clause().into(),
        target: rule.target.clone(),
        holds: !rows.is_empty() && rows.iter().all(|row| row.holds),
        rows,
    })
}
