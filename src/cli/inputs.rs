//! Input arguments, shared by `compare` and `check`.

use std::path::PathBuf;

use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::check::Decision;
use tank::refusal::Refusal;

use crate::cli::terminal::{say, warn};
use crate::error::Error;
use crate::input::records::{AccelerationUnit, Columns};
use crate::input::{self, TankFile, records};
use crate::job::{self, Job};
use crate::pipeline::procedures::select_procedures;
use engines::Task;
use engines::nonlinear::NonlinearOptions;
use files::code::Code;
use files::text;
use results::{InputValue, SourceFile};

/// The tank file, the records and how to read them.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct Inputs {
    /// The tank (`-` reads standard input); `tankcheck init` writes one to start from.
    pub tank: PathBuf,
    /// Horizontal ground acceleration, in a format of docs/records.md; FILE#CHANNEL takes a channel of a file with several; `harmonic:amplitude=0.1g,period=1.3,cycles=10` is a burst without a file (or frequency, duration, ramp, dt; amplitude=5mm is a displacement). Three or more make a set (`compare`).
    #[arg(long, value_name = "RECORD")]
    pub quake: Vec<PathBuf>,
    /// Second horizontal ground acceleration, along y (θ = 90°), of a cylinder or of a box with --fe solid; scaled with the factor of --quake.
    #[arg(long, value_name = "RECORD", requires = "quake")]
    pub quake_y: Vec<PathBuf>,
    /// Vertical ground acceleration; scaled with the factor of the horizontal one.
    #[arg(long, value_name = "RECORD", requires = "quake")]
    pub vertical: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: Reading,
    /// Procedures to run, separated by commas [default: all; `aci350-2006` where it is named, `is1893-2014` and `national` where the site has their data].
    #[arg(long, value_delimiter = ',', value_name = "ID")]
    pub procedures: Option<Vec<String>>,
    /// Accept only these gaps of `accepted` in the tank file [default: all]: `not-checked=ID,ID`.
    #[arg(long, value_name = "not-checked=ID,…")]
    pub accept: Option<String>,
    /// Exit with 4 also where the tank holds with accepted gaps.
    #[arg(long)]
    pub strict: bool,
}

impl Inputs {
    /// Reads all input files; the job gets the options of the tank file and no engines yet.
    ///
    /// * `refuses`: the refusals of the analysis for the tank file
    pub(crate) fn job(&self, refuses: impl Fn(&Task<'_>) -> Vec<Refusal>) -> Result<Job, Error> {
        Ok(self.with_processing(refuses)?.0)
    }

    /// The same without records, which are read later: the job without ground motion, and the processing that the tank file asks for.
    pub(crate) fn without_records(
        &self,
        refuses: impl Fn(&Task<'_>) -> Vec<Refusal>,
    ) -> Result<(Job, records::Processing), Error> {
        let bare = Inputs { quake: Vec::new(), quake_y: Vec::new(), vertical: Vec::new(), ..self.clone() };
        bare.with_processing(refuses)
    }

    fn with_processing(
        &self,
        refuses: impl Fn(&Task<'_>) -> Vec<Refusal>,
    ) -> Result<(Job, records::Processing), Error> {
        let tank = input::read_tank(&self.tank)?;
        let faults = job::refused(&tank, refuses);
        if !faults.is_empty() {
            return Err(faults.into_error(&tank.source).into());
        }
        for remark in &tank.remarks {
            say!("note: {}", text::line(remark));
        }
        let processing = tank.record;
        let job = self.resolved(tank)?;
        warned(&job, "");
        Ok((job, processing))
    }

    /// The job of a tank file, with the records and options of the command line.
    pub(crate) fn resolved(&self, tank: TankFile) -> Result<Job, Error> {
        let options = [("--quake", &self.quake), ("--quake-y", &self.quake_y), ("--vertical", &self.vertical)];
        if let Some((option, paths)) = options.into_iter().find(|(_, paths)| paths.len() > 1) {
            return Err(Error::conflict(format!(
                "{option}: found {} records, expected one; `tankcheck compare` takes a set",
                paths.len()
            )));
        }
        let named = self.procedures.as_ref().unwrap_or(&tank.procedures);
        let selected = select_procedures(named, &tank.decision.decide, &tank.case.site)?;
        let decision = self.decision(tank.decision.clone(), &selected)?;
        let given = tank.record;
        let file = source("tank", &self.tank, &tank.sha256);
        let mut job = Job { decision, files: vec![file], ..Job::of(tank, selected) };
        if let Some(path) = self.quake.first() {
            let options = self.reading.options();
            let horizontal = records::read(path, &options)?;
            job.files.push(source("record", path, &horizontal.sha256));
            let processed = records::process(&horizontal.record, &given)?;
            let allow = self.reading.allow_implausible;
            let factor = format!("record.{}", given.scaled_by());
            records::plausible::check(&processed, &factor, allow)?;
            job.warnings.extend(records::plausible::doubts(&processed, &given));
            // One earthquake has one scale: its other components follow the factor of the first.
            let factor = processed.pga() / horizontal.record.pga().max(f64::MIN_POSITIVE);
            let processing = records::Processing { scale_to: None, scale_by: Some(factor), ..given };
            job.usable_periods.push(horizontal.usable_after(&given));
            job.raw_records.push(horizontal.record);
            let mut component = |path: Option<&PathBuf>, role: &str| -> Result<Option<Record>, Error> {
                let Some(path) = path else { return Ok(None) };
                let read = records::read(path, &options)?;
                job.files.push(source(role, path, &read.sha256));
                let processed = records::process(&read.record, &processing)?;
                records::plausible::check(&processed, role, allow)?;
                job.warnings.extend(records::plausible::doubts(&processed, &records::Processing::default()));
                job.usable_periods.push(read.usable_after(&processing));
                job.raw_records.push(read.record);
                Ok(Some(processed))
            };
            let transverse = component(self.quake_y.first(), "record along y")?;
            let vertical = component(self.vertical.first(), "vertical record")?;
            if transverse.is_some() {
                whole_tank(&mut job.nonlinear, &mut job.echo);
            }
            job.case.ground_motion = Some(GroundMotion { horizontal: processed, transverse, vertical });
        }
        Ok(job)
    }

    /// Who decides and which gaps are accepted: those of the tank file, as far as `--accept` names them.
    ///
    /// Errors: a deciding procedure that does not run; `--accept` in another form, or without a reason in the tank file.
    fn decision(&self, file: Decision, procedures: &[String]) -> Result<Decision, Error> {
        let code = |id: &str| codes::ALL.iter().any(|p| p.id() == id);
        if let Some(absent) = file.decide.iter().find(|id| code(id) && !procedures.contains(id)) {
            return Err(Error::input(
                Code::UnknownId,
                format!(
                    "procedures.decide: `{absent}` does not run\n  help: add it to the procedures to run, or remove it \
                 from `decide`"
                ),
            ));
        }
        let Some(accept) = &self.accept else { return Ok(file) };
        let Some(ids) = accept.strip_prefix("not-checked=") else {
            return Err(Error::value(format!(
                "--accept: found `{accept}`, expected `not-checked=ID,ID`\n  help: the ids are those of `accepted` in \
                 the tank file"
            )));
        };
        let mut decision = Decision { accepted: Vec::new(), ..file };
        for id in ids.split(',') {
            let Some(gap) = file.accepted.iter().find(|gap| gap.check == id) else {
                return Err(Error::input(
                    Code::UnknownId,
                    format!(
                        "--accept: `{id}` has no reason in the tank file\n  help: add {{ \"check\": \"{id}\", \"reason\": \
                     \"…\", \"by\": \"…\", \"date\": \"…\" }} to `accepted`"
                    ),
                ));
            };
            decision.accepted.push(gap.clone());
        }
        Ok(decision)
    }
}

/// Writes the warnings of a job to standard error.
///
/// * `origin`: beginning of the lines ("tanks.csv:3: "), may be empty
pub(crate) fn warned(job: &Job, origin: &str) {
    for warning in &job.warnings {
        warn(origin, warning);
    }
}

/// Two horizontal components have no plane of symmetry: the default of half a tank becomes the whole; a half that the file asks for is
/// left to the engine, which refuses it.
fn whole_tank(options: &mut NonlinearOptions, echo: &mut [InputValue]) {
    let line = echo.iter_mut().find(|line| line.path == "analysis.nonlinear.symmetry");
    if line.as_ref().is_some_and(|line| !line.default) {
        return;
    }
    options.symmetry = false;
    if let Some(line) = line {
        line.text = "false".into();
        line.source = "two horizontal components (--quake-y) have no plane of symmetry".into();
    }
}

/// Errors: a job without a ground motion and without a design spectrum.
pub(crate) fn shaken(job: &Job) -> Result<(), Error> {
    if job.case.ground_motion.is_none() && !job.case.site.is_given() {
        return Err(Error::missing(
            "the ground motion is missing\n  help: add `site` to the tank file (design spectra), or give a record \
             with --quake",
        ));
    }
    Ok(())
}

/// Options for accelerograms whose format is ambiguous.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct Reading {
    /// Unit of the accelerations, if the file does not give it: g, %g, mg, m/s2, gal (cm/s2), mm/s2, in/s2, ft/s2.
    #[arg(long, value_name = "UNIT")]
    pub units: Option<AccelerationUnit>,
    /// Time step [s] of a file without a time column.
    #[arg(long, value_name = "SECONDS")]
    pub dt: Option<f64>,
    /// Channel of a file with several: its number, from 1, or a part of its name (`N-S`). FILE#CHANNEL goes first.
    #[arg(long, value_name = "CHANNEL")]
    pub channel: Option<String>,
    /// Lines at the beginning of the file that are not read.
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub skip_lines: usize,
    /// Columns of a table, from 1: `1,3` for time and acceleration, `3` for the acceleration alone (with --dt), `all` for values in reading order (with
    /// --dt).
    #[arg(long, value_name = "COLUMNS")]
    pub columns: Option<Columns>,
    /// Accept a peak ground acceleration above 5 g, before and after scaling; never above 1000 g.
    #[arg(long)]
    pub allow_implausible: bool,
}

impl Reading {
    /// In the vocabulary of the readers.
    pub(crate) fn options(&self) -> records::ReadOptions {
        records::ReadOptions {
            unit: self.units,
            dt: self.dt,
            allow_implausible: self.allow_implausible,
            channel: self.channel.clone(),
            skip_lines: self.skip_lines,
            columns: self.columns,
        }
    }
}

/// A file with its hash.
pub(crate) fn source(role: &str, path: &std::path::Path, sha256: &str) -> SourceFile {
    let whole = || path.display().to_string();
    let name = match path.file_name() {
        Some(name) if !records::Harmonic::is(path) => name.to_string_lossy().into_owned(),
        _ => whole(),
    };
    SourceFile { role: role.into(), name, sha256: sha256.into() }
}
