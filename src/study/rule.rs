//! Whether the records of a study stand for a spectrum: EN 1998-1:2004 3.2.3.1.2(4), see `codes::record_set`.
//!
//! The records are taken as read, along x. Levels scale them one by one later; the factor says by how much the set as it is falls short.

use codes::record_set::{self, Asked};
use files::code::Code;
use oscillator::record::Record;
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

/// Asks the rule for every tank.
///
/// * `tanks`: name and tank without sampling
/// * `records`: along x, as read
///
/// Errors: those of [`elastic`] and [`periods`], with the name of the tank; a table that ends before twice a period.
pub fn ask(rule: &Rule, tanks: &[(String, TankFile)], records: &[Record]) -> Result<RuleFound, Error> {
    let mut rows = Vec::new();
    for (id, tank) in tanks {
        let of_tank = |error: Error| {
            let text = error.to_string();
            Error::input(
                error.code().unwrap_or(Code::MissingInput),
                format!("{}\n  tank: {id}", text.trim_end()),
            )
        };
        let (alone, wanted) = match rule.periods {
            RulePeriods::Given(period) => {
                let wanted = Wanted {
                    which: "given",
                    period,
                    damping: FIVE,
                };
                (rule.table.is_some(), vec![wanted])
            }
            other => {
                let kept = |w: &Wanted| match other {
                    RulePeriods::Impulsive => w.which == "impulsive",
                    RulePeriods::Sloshing => w.which == "sloshing",
                    _ => true,
                };
                let all = periods(tank).map_err(of_tank)?;
                (false, all.into_iter().filter(kept).collect())
            }
        };
        let curve = |damping: f64| -> Result<Curve, Error> {
            match &rule.table {
                Some(table) => {
                    let table = table.clone();
                    // Beyond the last row nothing is asked.
                    Ok(Box::new(move |period| table.at(period).unwrap_or(f64::NAN)))
                }
                None => elastic(tank, damping).map_err(of_tank),
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
            let asked = Asked {
                period: wanted.period,
                damping: wanted.damping,
                target: &*target,
            };
            let smallest = record_set::ratios(records, &asked).smallest.0;
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
        if alone {
            break;
        }
    }
    Ok(RuleFound {
        clause: record_set::CLAUSE.into(),
        target: rule.target.clone(),
        holds: !rows.is_empty() && rows.iter().all(|row| row.holds),
        rows,
    })
}
