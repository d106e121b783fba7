//! `tankcheck quake set`: whether a set of records stands for a spectrum.

use std::path::PathBuf;

use codes::record_set::{self, Asked, CLAUSE, FEWEST, RANGE, SHARE};
use oscillator::record::Record;
use serde::Serialize;
use tank::STANDARD_GRAVITY;
use tank::units::{self, Dimension};

use super::target::Target;
use crate::cli::inputs::Reading;
use crate::cli::table::Table;
use crate::cli::{Format, json, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::input::{self, records};
use crate::study::rule::{self, FIVE, Wanted};
use files::code::Code;
use files::text;

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake set a.csv b.csv c.csv --target tank.json
  tankcheck quake set set/*.at2 --target spectrum.csv --period 0.225s --period 6.4s --format json

Rule en1998-1: at least three records, the mean of their peaks not below a_g S of the target, and their mean spectrum not below 90 % of the
target from 0.2 T to 2 T. Of a tank, T are the impulsive period (5 %) and the sloshing period (damping of sloshing). A spectrum.csv has the
columns period_s and acceleration_g or acceleration_m_s2, is 5 % damped, and begins at T = 0.

Exit codes: 0 the rule holds for the set as it is; 1 it does not; 2 bad input.")]
pub(super) struct Set {
    /// The records.
    #[arg(value_name = "RECORD", required = true)]
    records: Vec<PathBuf>,
    /// Rule.
    #[arg(long, value_enum, default_value_t = Rule::En1998)]
    rule: Rule,
    /// Target: a tank file with the site of EN 1998, or a CSV table.
    #[arg(long, value_name = "TANK|FILE")]
    target: PathBuf,
    /// Fundamental period with its unit; may be repeated [default: the two periods of the tank].
    #[arg(long, value_name = "PERIOD")]
    period: Vec<String>,
    #[command(flatten)]
    reading: Reading,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// A rule for sets of records.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Rule {
    /// EN 1998-1:2004 3.2.3.1.2(4).
    #[value(name = "en1998-1")]
    En1998,
}

/// What is printed.
#[derive(Serialize)]
struct Found {
    rule: &'static str,
    clause: &'static str,
    target: String,
    /// Smallest mean/target over all periods.
    smallest_ratio: f64,
    /// One factor for the set with which the rule just holds.
    factor: f64,
    /// Mean of the peaks over the target at T = 0.
    mean_zero_period_ratio: f64,
    /// Whether the rule holds for the set as it is.
    holds: bool,
    fewest_records: usize,
    share: f64,
    records: Vec<OfRecord>,
    periods: Vec<OfPeriod>,
}

#[derive(Serialize)]
struct OfRecord {
    name: String,
    pga: f64,
    sha256: String,
}

#[derive(Serialize)]
struct OfPeriod {
    which: &'static str,
    period: f64,
    damping: f64,
    range: [f64; 2],
    smallest_ratio: f64,
    at_period: f64,
    holds: bool,
}

impl Set {
    /// Prints the outcome; returns the exit code.
    pub(super) fn run(&self) -> Result<u8, Error> {
        let given = self
            .period
            .iter()
            .map(|text| period(text))
            .collect::<Result<Vec<f64>, Error>>()?;
        let target = Target::read(&self.target, &self.reading)?;
        let wanted = self.wanted(&target, &given)?;
        let mut set: Vec<Record> = Vec::new();
        let mut rows = Vec::new();
        let mut broken = Vec::new();
        for path in &self.records {
            match records::read(path, &self.reading.options()) {
                Ok(read) => {
                    rows.push(OfRecord {
                        name: read.record.name.clone(),
                        pga: read.record.pga(),
                        sha256: read.sha256,
                    });
                    set.push(read.record);
                }
                Err(error) => broken.push(error),
            }
        }
        if !broken.is_empty() {
            return Err(Error::Files(input::study::together(broken)));
        }
        let ground = target.curve(FIVE)?;
        let zero = record_set::zero_period(&set, &ground);
        let mut periods = Vec::new();
        for wanted in &wanted {
            let curve = target.curve(wanted.damping)?;
            let ratios = record_set::ratios(
                &set,
                &Asked {
                    period: wanted.period,
                    damping: wanted.damping,
                    target: &curve,
                },
            );
            periods.push(OfPeriod {
                which: wanted.which,
                period: wanted.period,
                damping: wanted.damping,
                range: RANGE.map(|r| r * wanted.period),
                smallest_ratio: ratios.smallest.0,
                at_period: ratios.smallest.1,
                holds: ratios.smallest.0 >= SHARE,
            });
        }
        let smallest = periods.iter().map(|p| p.smallest_ratio).fold(f64::INFINITY, f64::min);
        let found = Found {
            rule: "en1998-1",
            clause: CLAUSE,
            target: self
                .target
                .file_name()
                .map_or_else(String::new, |n| n.to_string_lossy().into_owned()),
            smallest_ratio: smallest,
            factor: record_set::factor(smallest, zero),
            mean_zero_period_ratio: zero,
            holds: record_set::holds(set.len(), smallest, zero),
            fewest_records: FEWEST,
            share: SHARE,
            records: rows,
            periods,
        };
        match self.format {
            Format::Human => print(&human(&found))?,
            Format::Json => print(&json(&found)?)?,
            Format::Csv => {
                return Err(Error::input(
                    Code::OptionConflict,
                    "--format: found csv, expected human or json".into(),
                ));
            }
        }
        Ok(if found.holds { EXIT_OK } else { EXIT_CHECK_FAILED })
    }

    /// The periods that are asked.
    ///
    /// Errors: none given and no tank; a tank without them; a table that ends before twice a period.
    fn wanted(&self, target: &Target, given: &[f64]) -> Result<Vec<Wanted>, Error> {
        let mut wanted: Vec<Wanted> = given
            .iter()
            .map(|&period| Wanted {
                which: "given",
                period,
                damping: FIVE,
            })
            .collect();
        match target {
            Target::Tank(tank) if wanted.is_empty() => wanted = rule::periods(tank)?,
            Target::Table(_) if wanted.is_empty() => {
                return Err(Error::input(
                    Code::MissingInput,
                    "--period is missing\n  help: a table does not know the periods of the tank; add --period 0.225s"
                        .into(),
                ));
            }
            _ => {}
        }
        if let Target::Table(table) = target
            && let Some(far) = wanted
                .iter()
                .find(|w| RANGE[1] * w.period > table.longest() * (1.0 + 1e-9))
        {
            return Err(Error::input(
                Code::OutOfRange,
                format!(
                    "{}: the table ends at {} s, before 2 T = {} s\n  help: add rows; the table is not continued",
                    self.target.display(),
                    table.longest(),
                    RANGE[1] * far.period
                ),
            ));
        }
        Ok(wanted)
    }
}

/// A period with its unit.
fn period(given: &str) -> Result<f64, Error> {
    match units::parse(given, Dimension::Time) {
        Ok(period) if period > 0.0 && period <= 100.0 => Ok(period),
        _ => Err(Error::input(
            Code::OptionValue,
            format!("--period: found `{given}`, expected a time with its unit such as 0.225s, at most 100 s"),
        )),
    }
}

fn human(found: &Found) -> String {
    let mut records = Table::new(["record", "peak [g]"]);
    for record in &found.records {
        records.row([
            text::line(&record.name).into_owned(),
            format!("{:.4}", record.pga / STANDARD_GRAVITY),
        ]);
    }
    let mut periods = Table::new(["period", "T [s]", "damping", "smallest mean/target", "at [s]", ""]);
    for period in &found.periods {
        periods.row([
            period.which.to_owned(),
            format!("{:.4}", period.period),
            format!("{:.1} %", 100.0 * period.damping),
            format!("{:.4}", period.smallest_ratio),
            format!("{:.4}", period.at_period),
            if period.holds { "holds" } else { "fails" }.to_owned(),
        ]);
    }
    let mut said = format!("{records}\n{periods}\n");
    let few = found.records.len() < found.fewest_records;
    said.push_str(&format!(
        "{}: {}\n",
        found.clause,
        if found.holds { "holds" } else { "does not hold" }
    ));
    said.push_str(&format!(
        "  records            {}, at least {}{}\n",
        found.records.len(),
        found.fewest_records,
        if few { ": too few" } else { "" }
    ));
    said.push_str(&format!(
        "  mean peak/target   {:.4}, at least 1\n",
        found.mean_zero_period_ratio
    ));
    said.push_str(&format!(
        "  mean/target        {:.4}, at least {}\n",
        found.smallest_ratio, found.share
    ));
    said.push_str(&format!(
        "  factor of the set  {:.4}, with which peaks and spectrum just hold\n",
        found.factor
    ));
    said
}
