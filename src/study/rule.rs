//! Whether the records of a study stand for a spectrum: EN 1998-1:2004 3.2.3.1.2(4), see `codes::record_set`.
//!
//! The records are taken as read, along x. Levels scale them one by one later; the factor says by how much the set as it is falls short.

use codes::record_set;
use files::code::Code;
use oscillator::record::Record;
use oscillator::spectrum::{Method, spectrum};
use serde::{Deserialize, Serialize};
use tank::Quantity;
use tank::case::Site;

use crate::error::Error;
use crate::input::TankFile;
use crate::input::study::{Rule, RulePeriods};
use crate::job::Job;
use crate::pipeline;

/// Damping ratio of the clause.
pub const FIVE: f64 = 0.05;

/// A period at which the rule is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// `impulsive`, `sloshing` or `given`.
    pub which: &'static str,
    /// Period [s].
    pub period: f64,
    /// Damping ratio.
    pub damping: f64,
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

/// The elastic spectrum of EN 1998 of a tank's site at a damping.
///
/// Errors: a tank file without `site.ec8`.
pub fn elastic(tank: &TankFile, damping: f64) -> Result<Curve, Error> {
    let site = Site {
        api650: None,
        zone: None,
        ..tank.case.site.clone()
    };
    let mut curves = codes::ALL.iter().flat_map(|p| p.design_curves(&site, &[damping]));
    let found = curves.next();
    found.map(|curve| curve.acceleration).ok_or_else(|| {
        Error::input(
            Code::MissingInput,
            "the tank file has no `site.ec8`, whose elastic spectrum the rule compares with\n  help: add it, or give a table of the \
             spectrum"
                .into(),
        )
    })
}

/// The impulsive and the sloshing period of a tank, by the first procedure that gives them under its site.
///
/// Errors: a tank without a procedure that gives one.
pub fn periods(tank: &TankFile) -> Result<Vec<Wanted>, Error> {
    let job = Job {
        case: tank.case.clone(),
        project: None,
        procedures: pipeline::select_procedures(&[])?,
        decision: tank::check::Decision::default(),
        engines: Vec::new(),
        linear: tank.fe.clone(),
        solid: tank.solid.clone(),
        nonlinear: tank.nonlinear.clone(),
        checkpoint: None,
        echo: Vec::new(),
        files: Vec::new(),
        warnings: Vec::new(),
        raw_records: Vec::new(),
    };
    let (methods, _) = pipeline::decide(&job)?;
    let of = |quantity: Quantity| {
        methods
            .iter()
            .find_map(|m| m.quantities.get(quantity.id()).map(|v| v.value))
    };
    let found = [
        ("impulsive", Quantity::ImpulsivePeriod, FIVE),
        ("sloshing", Quantity::SloshingPeriod, tank.case.damping.sloshing),
    ];
    let wanted: Vec<Wanted> = found
        .into_iter()
        .filter_map(|(which, quantity, damping)| {
            Some(Wanted {
                which,
                period: of(quantity)?,
                damping,
            })
        })
        .collect();
    match wanted.is_empty() {
        true => Err(Error::input(
            Code::MissingInput,
            "no procedure gives a period of this tank\n  help: give the period, and `site.ec8` in the tank file".into(),
        )),
        false => Ok(wanted),
    }
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
        RulePeriods::Given(period) => Ok(vec![Wanted {
            which: "given",
            period,
            damping: FIVE,
        }]),
        _ => Ok(periods(tank)?.into_iter().filter(kept).collect()),
    }
}

/// An error with the name of its tank.
fn of_tank(id: &str, error: &Error) -> Error {
    Error::input(
        error.code().unwrap_or(Code::MissingInput),
        format!("{}\n  tank: {id}", error.to_string().trim_end()),
    )
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
        let [low, high] = record_set::RANGE.map(|r| r * wanted.period);
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
    let [low, high] = record_set::RANGE.map(|r| r * first);
    let step = (high / low).ln() / f64::from(A_DECADE);
    let place = |t: f64| (t / low).ln() / step;
    let lowest = all.iter().map(|t| place(record_set::RANGE[0] * t)).fold(0.0, f64::min);
    let highest = all.iter().map(|t| place(record_set::RANGE[1] * t)).fold(0.0, f64::max);
    let even = (lowest.ceil() as i32..=(highest - SAME).ceil() as i32).map(|k| low * (step * f64::from(k)).exp());
    let mut periods: Vec<f64> = even.collect();
    let ends = all.iter().flat_map(|t| record_set::RANGE.map(|r| r * t));
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
/// Errors: those of [`elastic`] and [`periods`], with the name of the tank; a table that ends before twice a period.
pub fn ask(rule: &Rule, tanks: &[(String, TankFile)], records: &[Record]) -> Result<RuleFound, Error> {
    // A given period and a table are the same for all tanks: one row.
    let alone = rule.table.is_some() && matches!(rule.periods, RulePeriods::Given(_));
    let asked: Vec<(&String, &TankFile, Vec<Wanted>)> = tanks
        .iter()
        .take(if alone { 1 } else { tanks.len() })
        .map(|(id, tank)| Ok((id, tank, wanted(rule, tank).map_err(|error| of_tank(id, &error))?)))
        .collect::<Result<_, Error>>()?;
    let means = Means::new(records, asked.iter().flat_map(|(_, _, wanted)| wanted));
    let mut rows = Vec::new();
    for (id, tank, wanted) in asked {
        let curve = |damping: f64| -> Result<Curve, Error> {
            match &rule.table {
                Some(table) => {
                    let table = table.clone();
                    // Beyond the last row nothing is asked.
                    Ok(Box::new(move |period| table.at(period).unwrap_or(f64::NAN)))
                }
                None => elastic(tank, damping).map_err(|error| of_tank(id, &error)),
            }
        };
        let zero = record_set::zero_period(records, &*curve(FIVE)?);
        for wanted in wanted {
            if let Some(table) = &rule.table
                && record_set::RANGE[1] * wanted.period > table.longest() * (1.0 + 1e-9)
            {
                return Err(Error::input(
                    Code::OutOfRange,
                    format!(
                        "the target `{}` ends at {} s, before 2 T = {} s of the tank `{id}`\n  help: add rows; the table is not continued",
                        rule.target,
                        table.longest(),
                        record_set::RANGE[1] * wanted.period
                    ),
                ));
            }
            let target = curve(wanted.damping)?;
            let smallest = means.smallest(&wanted, &*target);
            rows.push(RuleRow {
                tank: if alone { String::new() } else { id.clone() },
                which: wanted.which.into(),
                period: wanted.period,
                damping: wanted.damping,
                smallest_ratio: smallest,
                mean_zero_period_ratio: zero,
                factor: record_set::factor(smallest, zero),
                holds: record_set::holds(records.len(), smallest, zero),
            });
        }
    }
    Ok(RuleFound {
        clause: record_set::CLAUSE.into(),
        target: rule.target.clone(),
        holds: !rows.is_empty() && rows.iter().all(|row| row.holds),
        rows,
    })
}

#[cfg(test)]
mod tests {
    use codes::record_set::{Asked, ratios};

    use super::*;

    /// Spectra shared by tanks against those of each tank alone: the same number where one period is asked. Of several the points of the grid are
    /// others, equally dense: two neighbours are 0.6 % apart, between which a spectrum of 5 % changes by less than 1 %.
    #[test]
    fn shared_spectra_are_those_of_each_tank() {
        let of = |k: i32| Record {
            name: format!("r{k}"),
            dt: 0.01,
            acceleration: (0..1200)
                .map(|i| (0.31 * f64::from(i + k)).sin() + 0.7 * (0.07 * f64::from(i * k)).cos())
                .collect(),
            processing: Vec::new(),
        };
        let records: Vec<Record> = [1, 2, 3].map(of).into();
        let target = |t: f64| 1.0 / (0.3 + t);
        let wanted = [0.21, 0.4, 0.25, 0.4].map(|period| Wanted {
            which: "given",
            period,
            damping: 0.05,
        });
        let alone = |period: f64| {
            let asked = Asked {
                period,
                damping: 0.05,
                target: &target,
            };
            ratios(&records, &asked).smallest.0
        };
        let one = Means::new(&records, wanted[..1].iter());
        assert_eq!(one.smallest(&wanted[0], &target).to_bits(), alone(0.21).to_bits());
        let all = Means::new(&records, wanted.iter());
        for one in &wanted {
            assert!((all.smallest(one, &target) / alone(one.period) - 1.0).abs() < 0.01);
        }
        let periods = grid(&[0.21, 0.4, 0.25, 0.4]);
        assert!((periods[0] / 0.042 - 1.0).abs() < 1e-12 && (periods[periods.len() - 1] / 0.8 - 1.0).abs() < 0.01);
        assert!(periods.iter().any(|t| (t / 0.08 - 1.0).abs() < 1e-9) && periods.len() < 530);
    }
}
