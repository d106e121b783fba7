//! `tankcheck ida`: incremental dynamic analysis, one nonlinear run for each scale of a record.

use std::path::PathBuf;
use std::time::Instant;

use crate::cli::budget::{self, MemoryArg};
use crate::cli::inputs::{Inputs, Reading};
use crate::cli::progress::{self, Watch};
use crate::cli::style::StyleArg;
use crate::cli::table::Table;
use crate::cli::terminal::say;
use crate::cli::{Format, Global, show, stamp};
use crate::error::{EXIT_COMPUTATION, EXIT_OK, Error};
use crate::ida;
use crate::input::records::plausible;
use crate::job::IdaJob;
use engines::{engine, nonlinear};
use files::text;
use report::words;
use results::{EngineId, ida_csv};

/// Largest number of runs of one analysis.
const MAX_RUNS: usize = 1000;
/// Largest factor on a record.
const MAX_SCALE: f64 = 100.0;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck ida tank.json --quake elcentro.csv --scale 0..1.1 --steps 12 -o ida/
  tankcheck ida tank.json --quake elcentro.csv --scale 0.5,0.85,0.9,1 --jobs 2 -o ida/
  tankcheck ida tank.json --quake elcentro.csv --scale 0..1.1 --steps 12 -o ida/ --resume
  tankcheck ida cylinder.json --quake elcentro.csv --scale 0.2,0.4,0.6 --memory-limit 2048 -o ida/

A strip of a rectangular tank or a cylinder; analysis.nonlinear holds elements, contact and the free vibration after the
record. Scales that exceed a limit of validity (small waves, freeboard, displacement, crack width, suction) are marked.

Exit codes: 0 done; 2 bad input; 3 the computation failed or was interrupted, or results could not be
written; 130 stopped by a second Ctrl-C.")]
pub(crate) struct Args {
    /// The tank (`-` reads standard input).
    tank: PathBuf,
    /// Horizontal ground acceleration: CSV, two-column text or PEER .AT2.
    #[arg(long, value_name = "RECORD")]
    quake: PathBuf,
    /// Vertical ground acceleration; scaled with the factor of the horizontal one.
    #[arg(long, value_name = "RECORD")]
    vertical: Option<PathBuf>,
    #[command(flatten)]
    reading: Reading,
    /// Factors on the record after the scaling of the tank file: a range `0..1.1`, both ends included, or a list
    /// `0.5,0.9,1`.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    scale: String,
    /// Number of factors in a range, evenly spaced.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    steps: Option<String>,
    /// Number of parallel runs.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
    /// Folder for the results of all runs.
    #[arg(long, short, value_name = "FOLDER", default_value = "ida")]
    out: PathBuf,
    #[command(flatten)]
    style: StyleArg,
    /// Keep all finished runs of the folder, of any scale, and continue with the missing ones; start from the
    /// beginning if there are none.
    #[arg(long)]
    resume: bool,
    #[command(flatten)]
    memory: MemoryArg,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let _style = args.style.apply();
    let job = args.job()?;
    progress::stop_gracefully(progress::FINISHED_PART);
    let estimate = nonlinear::estimate_incremental(&job.job.case, &job.job.nonlinear, job.jobs, job.scales.len())?;
    let limit = args.memory.over(job.job.solid.memory_limit_mib);
    budget::admit(&estimate, limit, true, global)?;
    let watch = Watch::new(global, "incremental dynamic analysis");
    let found = ida::run(&job, || stamp(started), &watch)?;
    watch.finish();
    let human = || format!("{}\n\n{}", text::line(&found.name), Table::of(&report::ida::table(&found)));
    show(args.format, human, || &found, || Ok(ida_csv(&found)))?;
    for line in words::record_set::beyond_of_ida(&found) {
        say!("warning: {line}");
    }
    if !global.quiet {
        for run in &found.runs {
            if let Some(line) = words::terminal::collapse(run) {
                say!("{line}");
            }
        }
        for sentence in words::ida::departures(&found) {
            say!("outside the model: {sentence}");
        }
        for sentence in words::ida::outside(&found) {
            say!("limit of validity: {sentence}");
        }
        for sentence in words::ida::partings(&found) {
            say!("note: {sentence}");
        }
        if found.incomplete {
            say!("{}", words::terminal::RESUME);
        }
        say!("report: {}", job.out.join("report.html").display());
    }
    Ok(if found.incomplete { EXIT_COMPUTATION } else { EXIT_OK })
}

impl Args {
    /// Reads and checks everything.
    fn job(&self) -> Result<IdaJob, Error> {
        let scales = scales(&self.scale, self.steps.as_deref())?;
        let inputs = Inputs {
            accept: None,
            strict: false,
            tank: self.tank.clone(),
            quake: vec![self.quake.clone()],
            quake_y: Vec::new(),
            vertical: self.vertical.clone().into_iter().collect(),
            reading: self.reading.clone(),
            procedures: None,
        };
        let job = inputs.job(|task| engine(EngineId::Nonlinear).refuses(task))?;
        if let (Some(motion), Some(largest)) = (&job.case.ground_motion, scales.last()) {
            let peak = motion.horizontal.pga() * largest;
            let origin = format!("--scale: the factor {largest}");
            plausible::check_peak(peak, origin, self.reading.allow_implausible)?;
        }
        Ok(IdaJob { job, scales, jobs: self.jobs.into(), out: self.out.clone(), resume: self.resume })
    }
}

/// A fault of `--scale` or `--steps`.
fn refuse<T>(what: String, help: &str) -> Result<T, Error> {
    Err(Error::value(format!("{what}\n  help: {help}")))
}

/// The factors of `--scale` and `--steps`, ascending.
fn scales(text: &str, steps: Option<&str>) -> Result<Vec<f64>, Error> {
    match text.split_once("..") {
        Some(ends) => range(text, ends, steps),
        None => list(text, steps),
    }
}

fn number(part: &str) -> Option<f64> {
    part.trim().parse().ok()
}

fn sound(scale: f64) -> bool {
    (0.0..=MAX_SCALE).contains(&scale)
}

/// The factors of a list.
fn list(text: &str, steps: Option<&str>) -> Result<Vec<f64>, Error> {
    let expected = format!("expected factors from 0 to {MAX_SCALE}");
    let Some(list) = text.split(',').map(number).collect::<Option<Vec<f64>>>() else {
        return refuse(
            format!("--scale: found `{text}`, {expected}"),
            "write a range `0..1.1` with --steps 12, or a list `0.5,0.9,1`",
        );
    };
    if let Some(bad) = list.iter().find(|s| !sound(**s)) {
        return refuse(
            format!("--scale: found `{bad}`, {expected}"),
            "use factors ≥ 0; to reverse the motion, change the sign of the record",
        );
    }
    if list.windows(2).any(|w| w[1] <= w[0]) {
        return refuse(
            format!("--scale: found `{text}`, expected an ascending list"),
            "sort the factors and remove duplicates",
        );
    }
    if let Some(steps) = steps {
        return refuse(
            format!("--steps: found `{steps}` with the list `{text}`, expected a range only"),
            "remove --steps, or give a range `0..1.1`",
        );
    }
    if list.len() > MAX_RUNS {
        return refuse(
            format!("--scale: found {} factors, expected at most {MAX_RUNS}", list.len()),
            "give fewer factors",
        );
    }
    Ok(list)
}

/// The factors of a range in equal steps.
fn range(text: &str, (from, to): (&str, &str), steps: Option<&str>) -> Result<Vec<f64>, Error> {
    let expected = format!("expected factors from 0 to {MAX_SCALE}");
    let (Some(low), Some(high)) = (number(from), number(to)) else {
        return refuse(
            format!("--scale: found `{text}`, {expected}, such as `0..1.1`"),
            "write both ends of the range with two dots between them",
        );
    };
    if let Some(end) = [low, high].into_iter().find(|end| !sound(*end)) {
        return refuse(format!("--scale: found `{end}` in `{text}`, {expected}"), "write a range such as `0..1.1`");
    }
    if low >= high {
        let (what, help) = if low == high {
            ("an empty range", format!("for one run write --scale {low}"))
        } else {
            ("a reversed range", format!("write {}..{}", to.trim(), from.trim()))
        };
        return refuse(format!("--scale: found `{text}`, {what}, expected an ascending range"), &help);
    }
    let Some(steps) = steps else {
        let missing = format!("--steps is missing; expected the number of factors in `{text}`");
        let text = format!("{missing}\n  help: add for example --steps 12");
        return Err(Error::missing(text));
    };
    let count = match steps.trim().parse::<usize>() {
        Ok(count) if (2..=MAX_RUNS).contains(&count) => count,
        _ => {
            return refuse(
                format!("--steps: found `{steps}`, expected a whole number from 2 to {MAX_RUNS}"),
                "give at least 2 for a range; for one run write --scale 0.9",
            );
        }
    };
    // Weights of the ends instead of sums of steps: the last factor is exactly the upper end.
    let last = (count - 1) as f64;
    Ok((0..count).map(|i| (low * (last - i as f64) + high * i as f64) / last).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str, steps: Option<&str>) -> String {
        match scales(text, steps) {
            Err(Error::Files(files::error::Error::Input(_, message))) => message,
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn ranges_and_lists() {
        let found = scales("0..1.1", Some("12")).unwrap();
        assert_eq!((found.len(), found[0], found[11]), (12, 0.0, 1.1));
        // Tenths, to the rounding of one product and one quotient.
        for (i, scale) in found.iter().enumerate() {
            assert!((scale - i as f64 / 10.0).abs() < 1e-15, "{scale}");
        }
        assert_eq!(scales(" 0.5 .. 1 ", Some("2")).unwrap(), [0.5, 1.0]);
        assert_eq!(scales("0.9", None).unwrap(), [0.9]);
        assert_eq!(scales("0.5, 0.85,1", None).unwrap(), [0.5, 0.85, 1.0]);
    }

    #[test]
    fn invalid_ranges_are_rejected() {
        for (text, steps, parts) in [
            ("", None, vec!["--scale", "found ``"]),
            ("..", Some("3"), vec!["--scale", "`..`", "both ends"]),
            ("0..", Some("3"), vec!["--scale", "`0..`"]),
            ("1.1..0", Some("12"), vec!["reversed", "write 0..1.1"]),
            ("0.5..0.5", Some("3"), vec!["empty range", "--scale 0.5"]),
            ("-0.1..1", Some("3"), vec!["found `-0.1`", "from 0 to 100"]),
            ("0..NaN", Some("3"), vec!["found `NaN`"]),
            ("0..inf", Some("3"), vec!["found `inf`"]),
            ("0..1e3", Some("3"), vec!["found `1000`"]),
            ("0..1", None, vec!["--steps is missing", "--steps 12"]),
            ("0..1", Some("1"), vec!["--steps: found `1`", "from 2 to 1000", "--scale 0.9"]),
            ("0..1", Some("0"), vec!["--steps: found `0`"]),
            ("0..1", Some("-3"), vec!["--steps: found `-3`"]),
            ("0..1", Some("2.5"), vec!["--steps: found `2.5`"]),
            ("0..1", Some("5000"), vec!["--steps: found `5000`"]),
            ("1,0.5", None, vec!["ascending list"]),
            ("0.5,0.5", None, vec!["ascending list"]),
            ("0.5,x", None, vec!["found `0.5,x`"]),
            ("0.5,-1", None, vec!["found `-1`"]),
            ("0.5,1", Some("3"), vec!["--steps", "a range only"]),
        ] {
            let message = refused(text, steps);
            for part in parts {
                assert!(message.contains(part), "`{part}` is missing in {message}");
            }
        }
    }
}
