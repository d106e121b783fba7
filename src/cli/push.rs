//! `tankcheck push`: pushover of a cylinder, anchored or on its bottom plate.

use std::path::PathBuf;
use std::time::Instant;

use crate::cli::budget::{self, MemoryArg};
use crate::cli::inputs::{Inputs, Reading};
use crate::cli::progress::{self, Watch};
use crate::cli::style::StyleArg;
use crate::cli::table::Table;
use crate::cli::terminal::{say, warn};
use crate::cli::{Format, Global, nonlinear, show, stamp};
use crate::error::{EXIT_COMPUTATION, EXIT_OK, Error};
use crate::job::PushJob;
use crate::push;
use engines::FeError;
use engines::nonlinear::push::{Amplitude, Form, NoSteel, PushOptions, Quality, estimate, refuses};
use files::code::Code;
use files::text;
use report;
use report::number::with_unit;
use report::words;
use tank::units::{self, Dimension};

/// Largest amplitude of an imperfection, in thicknesses.
const MAX_THICKNESSES: f64 = 10.0;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck push tank.json -o push/
  tankcheck push tank.json --imperfection 0.5t -o push/
  tankcheck push tank.json --imperfection class-b --imperfection-at 2m -o push/
  tankcheck push tank.json --imperfection 1t --imperfection-shape mode -o push/
  tankcheck push tank.json --imperfection 1t --imperfection-shape mode -o push/ --resume

A weld depression runs around the tank. The mode is the lowest linear buckling mode under the load at the capacity of the
perfect shell; its amplitude is its largest deviation. Both are outward; a negative amplitude is inward
(--imperfection=-0.5t).

Ctrl-C stops the run and keeps the finished part, marked incomplete; a second Ctrl-C discards everything except the
checkpoint.

Exit codes: 0 done; 2 bad input; 3 the computation failed or was interrupted, or results could not be
written; 130 stopped by a second Ctrl-C.")]
pub(crate) struct Args {
    /// The tank (`-` reads standard input).
    tank: PathBuf,
    /// Amplitude of an imperfect shell, run after the perfect one: in thicknesses `0.5t`, as a length `6mm`, or by
    /// the fabrication quality of EN 1993-1-6 `class-a`, `class-b`, `class-c`.
    #[arg(long, value_name = "AMPLITUDE", allow_hyphen_values = true)]
    imperfection: Option<String>,
    /// Shape of the imperfection.
    #[arg(long, value_enum, value_name = "SHAPE", requires = "imperfection", default_value_t = Shape::Weld)]
    imperfection_shape: Shape,
    /// Height of a weld depression above the base, `2m` [default: where the perfect shell buckles].
    #[arg(long, value_name = "HEIGHT", requires = "imperfection", allow_hyphen_values = true)]
    imperfection_at: Option<String>,
    /// Keeps the foot of an unanchored tank a plane, as the strips of the fast engine have it and a stiff roof does.
    #[arg(long)]
    plane_foot: bool,
    /// Folder for the results.
    #[arg(long, short, value_name = "FOLDER", default_value = "push")]
    out: PathBuf,
    #[command(flatten)]
    style: StyleArg,
    #[command(flatten)]
    kept: nonlinear::NonlinearArgs,
    #[command(flatten)]
    memory: MemoryArg,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Shape of an imperfection.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// The depression of a circumferential weld.
    Weld,
    /// The lowest linear buckling mode of the loaded tank.
    Mode,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let _style = args.style.apply();
    let job = args.job()?;
    progress::stop_gracefully(progress::FINISHED_PART);
    let estimate = estimate(&job.job.case, &job.job.nonlinear, &job.options)?;
    let limit = args.memory.over(job.job.solid.memory_limit_mib);
    budget::admit(&estimate, limit, true, global)?;
    let watch = Watch::new(global, "pushover");
    if let Some(file) = &job.checkpoint {
        nonlinear::announce_start("pushover", file, job.job.nonlinear.checkpoint, global);
    }
    let advise = || {
        if let Some(file) = &job.checkpoint {
            nonlinear::advise_resume(file, global);
        }
    };
    let found = push::run(&job, || stamp(started), &watch).inspect_err(|error| {
        // Interrupted, or the results could not be written; a failure of the analysis would repeat.
        if error.exit_code() == EXIT_COMPUTATION && !matches!(error, Error::Fe(FeError::Analysis(_))) {
            advise();
        }
    })?;
    watch.finish();
    let human = || {
        // One row per quantity: eleven columns are too wide for a terminal.
        let summary = Table::turned(&report::push::summary(&found));
        let limits = Table::of(&report::push::limits(&found));
        format!("{}\n\n{summary}\n{limits}", text::line(&found.name))
    };
    show(args.format, human, || &found, || Ok(report::push::csv(&found)))?;
    if !global.quiet {
        for line in found.shells.iter().flat_map(words::terminal::path) {
            say!("{line}");
        }
        if let Some(joint) = &found.joint {
            say!("{}", words::push::joint(joint, found.gravity));
        }
        // Warnings about the input were printed before the run.
        for doubt in found.doubts.iter().filter(|d| !job.job.warnings.contains(d)) {
            warn("", doubt);
        }
        if found.incomplete {
            say!("incomplete: {}", found.interruption);
            advise();
        }
        say!("report: {}", job.out.join("report.html").display());
    }
    Ok(if found.incomplete { EXIT_COMPUTATION } else { EXIT_OK })
}

impl Args {
    /// Reads and checks everything.
    fn job(&self) -> Result<PushJob, Error> {
        let imperfection = self.imperfection.as_deref().map(amplitude).transpose()?;
        let height = self.imperfection_at.as_deref().map(height).transpose()?;
        if self.imperfection_shape == Shape::Mode && height.is_some() {
            return refuse(
                Code::OptionConflict,
                "--imperfection-at: does not apply to a buckling mode".into(),
                "remove --imperfection-at, or choose --imperfection-shape weld",
            );
        }
        let form = match self.imperfection_shape {
            Shape::Weld => Form::Weld,
            Shape::Mode => Form::Mode,
        };
        let inputs = Inputs {
            accept: None,
            strict: false,
            tank: self.tank.clone(),
            quake: Vec::new(),
            quake_y: Vec::new(),
            vertical: Vec::new(),
            reading: Reading::default(),
            procedures: None,
        };
        let job = inputs.job(refuses)?;
        if let (tank::Shape::Cylinder { .. }, Some(no_steel)) = (job.case.tank.shape, NoSteel::of(&job.case)) {
            let file = job.files.first().map_or("tank", |f| f.name.as_str());
            return refuse(
                Code::Unsupported,
                format!("{file}: {no_steel}"),
                "for a steel wall add \"behaviour\": { \"steel\": { \"yield_strength\": \"235 MPa\" } } to its material; run walls of \
                 concrete with compare --fe nonlinear",
            );
        }
        if self.plane_foot && job.case.tank.support != tank::Support::Unanchored {
            return refuse(
                Code::OptionConflict,
                "--plane-foot: found an anchored tank, expected an unanchored one with a bottom plate".into(),
                "remove --plane-foot: the foot of an anchored wall does not move",
            );
        }
        let mut job = PushJob {
            job,
            options: PushOptions { imperfection, form, height, plane_foot: self.plane_foot },
            out: self.out.clone(),
            checkpoint: None,
        };
        job.checkpoint = Some(self.kept.file(&self.out, job.key())?);
        Ok(job)
    }
}

fn refuse<T>(code: Code, what: String, help: &str) -> Result<T, Error> {
    Err(Error::input(code, format!("{what}\n  help: {help}")))
}

/// `0.5t`, `6mm`, `class-b`.
fn amplitude(text: &str) -> Result<Amplitude, Error> {
    const HELP: &str = "give thicknesses `0.5t`, a length `6mm`, or a quality class `class-b`";
    let plain = text.trim().to_ascii_lowercase();
    if let Some(class) = plain.strip_prefix("class-") {
        return match class {
            "a" => Ok(Amplitude::Quality(Quality::A)),
            "b" => Ok(Amplitude::Quality(Quality::B)),
            "c" => Ok(Amplitude::Quality(Quality::C)),
            _ => refuse(
                Code::OptionValue,
                format!("--imperfection: found `{text}`, expected class-a, class-b or class-c"),
                HELP,
            ),
        };
    }
    if let Some(number) = plain.strip_suffix('t').and_then(|n| n.trim().parse::<f64>().ok()) {
        if number == 0.0 || number.is_nan() || number.abs() > MAX_THICKNESSES {
            return refuse(
                Code::OptionValue,
                format!(
                    "--imperfection: found `{text}`, expected up to {MAX_THICKNESSES} thicknesses inward or outward, not zero"
                ),
                "remove --imperfection; the perfect shell is always run",
            );
        }
        return Ok(Amplitude::Thicknesses(number));
    }
    match units::parse(&plain, Dimension::Length) {
        Ok(value) if value != 0.0 && value.is_finite() => {
            if value.abs() > 1.0 {
                return refuse(
                    Code::OptionValue,
                    format!("--imperfection: found {}, expected up to 1 m", with_unit(value, Dimension::Length)),
                    HELP,
                );
            }
            Ok(Amplitude::Length(value))
        }
        _ => refuse(
            Code::OptionValue,
            format!("--imperfection: found `{text}`, expected an amplitude with its unit, not zero"),
            HELP,
        ),
    }
}

fn height(text: &str) -> Result<f64, Error> {
    match units::parse(text.trim(), Dimension::Length) {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        _ => refuse(
            Code::OptionValue,
            format!("--imperfection-at: found `{text}`, expected a height above the base with its unit"),
            "write for example 2m",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amplitudes() {
        assert_eq!(amplitude("0.5t").unwrap(), Amplitude::Thicknesses(0.5));
        assert_eq!(amplitude("-0.5 T").unwrap(), Amplitude::Thicknesses(-0.5));
        assert_eq!(amplitude("6mm").unwrap(), Amplitude::Length(0.006));
        assert_eq!(amplitude("-6 mm").unwrap(), Amplitude::Length(-0.006));
        assert_eq!(amplitude("class-B").unwrap(), Amplitude::Quality(Quality::B));
        for text in ["", "0", "0t", "0.5", "class-d", "11t", "2 m", "NaNt", "half", "5 s", "inf t"] {
            let Err(Error::Files(files::error::Error::Input(_, message))) = amplitude(text) else {
                panic!("{text}");
            };
            assert!(message.contains("--imperfection") && message.contains("help"), "{message}");
        }
        assert_eq!(height("2 m").unwrap(), 2.0);
        assert!(height("-2m").is_err() && height("2").is_err());
    }
}
