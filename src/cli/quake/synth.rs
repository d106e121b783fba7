//! `tankcheck quake synth`: synthetic records whose spectrum follows a target.

use std::fmt::Write;
use std::path::PathBuf;

use ::fragility::draw::Draw;
use oscillator::record::Record;
use oscillator::synthetic::{Wanted, synthetic};

use super::target::Target;
use crate::cli::inputs::{Reading, Unit};
use crate::cli::print;
use crate::error::{EXIT_OK, Error};
use files::code::Code;
use files::{Kind, OutputFolder};

/// Most samples of a record.
const MOST_SAMPLES: f64 = 2e5;
/// Damping ratio of the targets.
const DAMPING: f64 = 0.05;

/// A set of records.
const RECORDS: Kind = Kind {
    id: "records",
    option: "--out",
    names: |name| name.starts_with("synthetic-") && name.ends_with(".csv"),
    keeps: |_| false,
};

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck quake synth --target tank.json --n 7 --seed 1 --out set/
  tankcheck quake synth --target spectrum.csv --duration 30 --strong 15 --n 3 --out set/
  tankcheck quake set set/*.csv --target tank.json

Cosines of random phase under an envelope, their amplitudes corrected until the 5 % spectrum follows the target (Gasparini & Vanmarcke 1976). The
ground ends at rest. The same seed gives the same records. Such records have more cycles than real ones of the same spectrum, and no pulses.")]
pub(super) struct Synth {
    /// Target: a tank file with the site of EN 1998, or a CSV table of the 5 % spectrum.
    #[arg(long, value_name = "TANK|FILE")]
    target: PathBuf,
    /// Number of records.
    #[arg(long, value_name = "N", default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    n: u16,
    /// Seed of the first; the others follow.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Duration [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 25.0)]
    duration: f64,
    /// Duration of the strong part [s]; EN 1998-1 asks for at least 10 s.
    #[arg(long, value_name = "SECONDS", default_value_t = 12.0)]
    strong: f64,
    /// Time step [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 0.01)]
    dt: f64,
    /// Longest period that follows the target [s] [default: that of the target, at most half of the duration].
    #[arg(long, value_name = "SECONDS")]
    longest: Option<f64>,
    /// Folder of the records.
    #[arg(long, short, value_name = "FOLDER", default_value = "records")]
    out: PathBuf,
    /// Unit of the accelerations of a table that does not say it.
    #[arg(long, value_enum, value_name = "UNIT")]
    units: Option<Unit>,
}

impl Synth {
    /// Writes the records; returns the exit code.
    pub(super) fn run(&self) -> Result<u8, Error> {
        let within = |option: &str, value: f64, low: f64, high: f64| match value >= low && value <= high {
            true => Ok(value),
            false => Err(Error::input(
                Code::OptionValue,
                format!("{option}: found `{value}`, expected {low} to {high}"),
            )),
        };
        let duration = within("--duration", self.duration, 1.0, 1000.0)?;
        let strong = within("--strong", self.strong, 0.1, 0.95 * duration)?;
        let dt = within("--dt", self.dt, duration / MOST_SAMPLES, 0.05)?;
        let reading = Reading {
            units: self.units,
            ..Reading::default()
        };
        let target = Target::read(&self.target, &reading)?;
        let covered = target.longest().min(0.5 * duration);
        let longest = match self.longest {
            Some(longest) => within("--longest", longest, 0.1, covered)?,
            None => covered,
        };
        let curve = target.curve(DAMPING)?;
        let folder = OutputFolder::prepare(&self.out, RECORDS)?;
        let mut said = String::new();
        for k in 0..self.n {
            let wanted = Wanted {
                duration,
                strong,
                dt,
                damping: DAMPING,
                longest,
                steps: 12,
            };
            let mut draw = Draw::new(self.seed.wrapping_add(u64::from(k)));
            let name = format!("synthetic-{:03}", k + 1);
            let record = synthetic(&name, &wanted, &curve, || draw.unit()).ok_or_else(|| {
                Error::input(
                    Code::OptionValue,
                    "--target: a spectrum that is not positive everywhere".into(),
                )
            })?;
            results::put(&folder.path().join(format!("{name}.csv")), csv(&record).as_bytes())?;
            let _ = writeln!(said, "{name}.csv  peak {:.4} m/s²", record.pga());
        }
        folder.commit()?;
        print(&said)?;
        Ok(EXIT_OK)
    }
}

/// A record as a table; nine digits, of which the last differ between machines by nothing that matters.
fn csv(record: &Record) -> String {
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for (k, a) in record.acceleration.iter().enumerate() {
        let rounded: f64 = format!("{a:.8e}").parse().unwrap_or(*a);
        let _ = writeln!(text, "{:.4},{rounded}", k as f64 * record.dt);
    }
    text
}
