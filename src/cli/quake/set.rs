//! `tankcheck quake set`: whether a set of records stands for a spectrum.

use std::path::PathBuf;

use codes::record_set::standard::Standard;
use codes::record_set::{Horizontal, Ratios};
use oscillator::record::Record;
use serde::Serialize;
use tank::STANDARD_GRAVITY;
use tank::case::Site;
use tank::units::{self, Dimension};

use super::target::Target;
use crate::cli::inputs::Reading;
use crate::cli::table::Table;
use crate::cli::{Format, no_csv, show};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::input::{self, records};
use crate::study::rule::{self, FIVE, Question, Wanted};
use files::text;

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake set a.csv b.csv c.csv --target tank.json
  tankcheck quake set set/*.at2 --target spectrum.csv --period 0.225s --period 6.4s --format json

Rule asce7-16 (not compared with the printed text): at least eleven records, their mean spectrum not below 90 % of the design spectrum of `site.api650`.
Rule en1998-1: at least three records, the mean of their peaks not below a_g S of the target, and their mean spectrum not below 90 % of the
target from 0.2 T to 2 T. Of a tank, T are the impulsive period (5 %) and the sloshing period (damping of sloshing), by the procedure that decides. A spectrum.csv has the
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
pub(crate) enum Rule {
    /// EN 1998-1:2004 3.2.3.1.2(4).
    #[value(name = "en1998-1")]
    En1998,
    /// ASCE/SEI 7-16 chapter 16 (recalled): 11 records.
    #[value(name = "asce7-16")]
    Asce716,
}

impl Rule {
    /// Its code.
    pub(crate) fn code(self) -> Standard {
        match self {
            Rule::En1998 => Standard::En1998,
            Rule::Asce716 => Standard::Asce716,
        }
    }
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
    /// Mean of the peaks over the target at T = 0, where the rule asks for it.
    mean_zero_period_ratio: Option<f64>,
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
    /// What gives the period; none where the user does.
    #[serde(skip_serializing_if = "Option::is_none")]
    period_of: Option<&'static str>,
    damping: f64,
    range: [f64; 2],
    smallest_ratio: f64,
    at_period: f64,
    holds: bool,
}

impl Set {
    /// Prints the outcome; returns the exit code.
    pub(super) fn run(&self) -> Result<u8, Error> {
        let given = self.period.iter().map(|text| period(text)).collect::<Result<Vec<f64>, Error>>()?;
        let target = Target::read(&self.target, &self.reading)?;
        let wanted = self.wanted(&target, &given)?;
        let code = self.rule.code();
        let name = self.target.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let nowhere = Site::default();
        let question = Question {
            code,
            table: target.table(),
            target: &name,
            site: target.site().unwrap_or(&nowhere),
            wanted: &wanted,
        };
        rule::reaches(&question)?;
        let mut set: Vec<Record> = Vec::new();
        let mut rows = Vec::new();
        let mut broken = Vec::new();
        for path in &self.records {
            match records::read(path, &self.reading.options()) {
                Ok(read) => {
                    rows.push(OfRecord { name: read.record.name.clone(), pga: read.record.pga(), sha256: read.sha256 });
                    set.push(read.record);
                }
                Err(error) => broken.push(error),
            }
        }
        if !broken.is_empty() {
            return Err(Error::Files(input::study::together(broken)));
        }
        let horizontal: Vec<Horizontal<'_>> = set.iter().map(Horizontal::from).collect();
        let answer = rule::answer(&question, &horizontal)?;
        let of_period = |(wanted, ratios): &(Wanted, Ratios)| OfPeriod {
            which: wanted.which,
            period: wanted.period,
            period_of: Some(wanted.of).filter(|of| !of.is_empty()),
            damping: wanted.damping,
            range: code.range().map(|r| r * wanted.period),
            smallest_ratio: ratios.smallest.0,
            at_period: ratios.smallest.1,
            holds: ratios.smallest.0 >= code.share(),
        };
        let found = Found {
            rule: code.id(),
            clause: code.clause(),
            target: name.clone(),
            smallest_ratio: answer.smallest,
            factor: answer.factor,
            mean_zero_period_ratio: answer.zero,
            holds: answer.holds,
            fewest_records: code.fewest(),
            share: code.share(),
            records: rows,
            periods: answer.periods.iter().map(of_period).collect(),
        };
        show(self.format, || human(&found), || &found, no_csv)?;
        Ok(if found.holds { EXIT_OK } else { EXIT_CHECK_FAILED })
    }

    /// The periods that are asked.
    ///
    /// Errors: none given and no tank; a tank without them.
    fn wanted(&self, target: &Target, given: &[f64]) -> Result<Vec<Wanted>, Error> {
        let mut wanted: Vec<Wanted> =
            given.iter().map(|&period| Wanted { which: "given", period, damping: FIVE, of: "" }).collect();
        match target {
            Target::Tank(tank) if wanted.is_empty() => wanted = rule::periods(&tank.case, &tank.decision)?,
            Target::Table(_) if wanted.is_empty() => {
                return Err(Error::missing(
                    "--period is missing\n  help: a table does not know the periods of the tank; add --period 0.225s",
                ));
            }
            _ => {}
        }
        Ok(wanted)
    }
}

/// A period with its unit.
fn period(given: &str) -> Result<f64, Error> {
    match units::parse(given, Dimension::Time) {
        Ok(period) if period > 0.0 && period <= 100.0 => Ok(period),
        _ => Err(Error::value(format!(
            "--period: found `{given}`, expected a time with its unit such as 0.225s, at most 100 s"
        ))),
    }
}

fn human(found: &Found) -> String {
    let mut records = Table::new(["record", "peak [g]"]);
    for record in &found.records {
        records.row([text::line(&record.name).into_owned(), format!("{:.4}", record.pga / STANDARD_GRAVITY)]);
    }
    let mut periods = Table::new(["period", "T [s]", "of", "damping", "smallest mean/target", "at [s]", ""]);
    for period in &found.periods {
        periods.row([
            period.which.to_owned(),
            format!("{:.4}", period.period),
            period.period_of.unwrap_or_default().to_owned(),
            format!("{:.1} %", 100.0 * period.damping),
            format!("{:.4}", period.smallest_ratio),
            format!("{:.4}", period.at_period),
            if period.holds { "holds" } else { "fails" }.to_owned(),
        ]);
    }
    let mut said = format!("{records}\n{periods}\n");
    let few = found.records.len() < found.fewest_records;
    said.push_str(&format!("{}: {}\n", found.clause, if found.holds { "holds" } else { "does not hold" }));
    said.push_str(&format!(
        "  records            {}, at least {}{}\n",
        found.records.len(),
        found.fewest_records,
        if few { ": too few" } else { "" }
    ));
    if let Some(zero) = found.mean_zero_period_ratio {
        said.push_str(&format!("  mean peak/target   {zero:.4}, at least 1\n"));
    }
    said.push_str(&format!("  mean/target        {:.4}, at least {}\n", found.smallest_ratio, found.share));
    said.push_str(&format!("  factor of the set  {:.4}, with which the rule just holds\n", found.factor));
    said
}
