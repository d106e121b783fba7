//! `tankcheck quake synth`: synthetic records whose spectrum follows a target.

use std::fmt::Write;
use std::path::PathBuf;

use ::fragility::draw::Draw;
use codes::record_set::standard::Standard;
use codes::record_set::{Horizontal, Ratios};
use oscillator::record::Record;
use oscillator::synthetic::{Wanted, synthetic};

use super::target::Target;
use crate::cli::inputs::Reading;
use crate::cli::print;
use crate::cli::terminal::warn;
use crate::error::{EXIT_OK, Error};
use crate::input::records::AccelerationUnit;
use crate::study::rule::{self, Answer, Question};
use files::code::{Code, Warning};
use files::{Kind, OutputFolder};

/// Most samples of a record.
const MOST_SAMPLES: f64 = 2e5;
/// Damping ratio of the targets.
const DAMPING: f64 = 0.05;
/// The rule for the set.
const CODE: Standard = Standard::En1998;
/// Duration in periods with which a record follows the target out to twice the period: four for the longest period that follows (half of the
/// duration), and one more, because a spectrum at 0.5 % damping builds up more slowly than the 5 % spectrum that is fitted.
const CYCLES: f64 = 5.0;

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
ground ends at rest. For a tank, the set is compared with the rule of EN 1998-1 at its two periods, as `quake set` does. The same seed gives the same records. Such records have more cycles than real ones of the same spectrum, and no pulses.")]
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
    #[arg(long, value_name = "UNIT")]
    units: Option<AccelerationUnit>,
}

impl Synth {
    /// Writes the records; returns the exit code.
    pub(super) fn run(&self) -> Result<u8, Error> {
        let within = |option: &str, value: f64, low: f64, high: f64| match value >= low && value <= high {
            true => Ok(value),
            false => Err(Error::value(format!("{option}: found `{value}`, expected {low} to {high}"))),
        };
        let duration = within("--duration", self.duration, 1.0, 1000.0)?;
        let strong = within("--strong", self.strong, 0.1, 0.95 * duration)?;
        let dt = within("--dt", self.dt, duration / MOST_SAMPLES, 0.05)?;
        let reading = Reading { units: self.units, ..Reading::default() };
        let target = Target::read(&self.target, &reading)?;
        let covered = target.longest().min(0.5 * duration);
        let longest = match self.longest {
            Some(longest) => within("--longest", longest, 0.1, covered)?,
            None => covered,
        };
        let curve = target.curve(DAMPING)?;
        let folder = OutputFolder::prepare(&self.out, RECORDS)?;
        let mut said = String::new();
        let mut set = Vec::new();
        for k in 0..self.n {
            let wanted = Wanted { duration, strong, dt, damping: DAMPING, longest, steps: 12 };
            let mut draw = Draw::new(self.seed.wrapping_add(u64::from(k)));
            let name = format!("synthetic-{:03}", k + 1);
            let mut record = synthetic(&name, &wanted, &curve, || draw.unit())
                .ok_or_else(|| Error::value("--target: a spectrum that is not positive everywhere"))?;
            record.acceleration.iter_mut().for_each(|a| *a = rounded(*a));
            results::put(&folder.path().join(format!("{name}.csv")), csv(&record).as_bytes())?;
            let _ = writeln!(said, "{name}.csv  peak {:.4} m/s²", record.pga());
            set.push(record);
        }
        folder.commit()?;
        let missed = match self.ask(&target, &set)? {
            None => None,
            Some((answer, name)) => match answer.misses(CODE, set.len()) {
                None => {
                    let _ = writeln!(said, "{}: holds for {name}", CODE.clause());
                    None
                }
                Some(misses) => Some(format!("{misses}; {}", self.way_out(&answer))),
            },
        };
        print(&said)?;
        if let Some(text) = missed {
            warn("", &Warning::new(Code::UnusualRecord, text));
        }
        Ok(EXIT_OK)
    }

    /// The rule for the set at the periods of the tank, and the name of its file; none for a table, and where nothing gives a period.
    ///
    /// Errors: a spectrum of the site that ends before twice a period.
    fn ask(&self, target: &Target, set: &[Record]) -> Result<Option<(Answer, String)>, Error> {
        let Target::Tank(tank) = target else { return Ok(None) };
        let Ok(wanted) = rule::periods(&tank.case, &tank.decision) else { return Ok(None) };
        let name = self.target.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let horizontal: Vec<Horizontal<'_>> = set.iter().map(Horizontal::from).collect();
        let question = Question { code: CODE, table: None, target: &name, site: &tank.case.site, wanted: &wanted };
        let answer = rule::answer(&question, &horizontal)?;
        Ok(Some((answer, name)))
    }

    /// What to change for a set that misses the rule. Few cycles of a long period fit into a short record, and periods beyond half of the duration
    /// do not follow the target at all: where a period fails, the duration that holds [`CYCLES`] of it.
    fn way_out(&self, answer: &Answer) -> String {
        let fewest = CODE.fewest();
        let mut ways = Vec::new();
        if usize::from(self.n) < fewest {
            ways.push(format!("use --n {fewest} or more"));
        }
        let failing = |(_, ratios): &&(_, Ratios)| ratios.smallest.0 < CODE.share();
        let longest = answer.periods.iter().filter(failing).map(|(wanted, _)| wanted.period);
        let needed = 5.0 * (CYCLES * longest.fold(0.0, f64::max) / 5.0).ceil();
        if needed > self.duration {
            ways.push(format!("use --duration {needed}; in {} s the longest period does not build up", self.duration));
        }
        match ways.is_empty() {
            true => format!(
                "scale the set by {:.3} (--fit of `tankcheck compare`), or use another --seed or a larger --n",
                answer.factor
            ),
            false => ways.join("; "),
        }
    }
}

/// An acceleration as written: nine digits, of which the last differ between machines by nothing that matters.
fn rounded(acceleration: f64) -> f64 {
    format!("{acceleration:.8e}").parse().unwrap_or(acceleration)
}

/// A record as a table.
fn csv(record: &Record) -> String {
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for (k, a) in record.acceleration.iter().enumerate() {
        let _ = writeln!(text, "{:.4},{a}", k as f64 * record.dt);
    }
    text
}
