//! `tankcheck compare`: codes and finite elements side by side.

mod folders;
mod rotation;
mod text;

use std::path::{Path, PathBuf};
use std::time::Instant;

use codes::site_action;
use fem::progress::Progress;
use tank::Case;
use tank::assessment::Excitation;

use crate::cli::budget::{self, MemoryArg};
use crate::cli::inputs::Inputs;
use crate::cli::progress::{self, Watch};
use crate::cli::record_set::SetArgs;
use crate::cli::report::LevelArg;
use crate::cli::select::{self, SelectArg};
use crate::cli::style::{self, StyleArg};
use crate::cli::terminal::{self as stream, say};
use crate::cli::{Format, Global, nonlinear, set_table, solid, stamp};
use crate::error::{EXIT_CHECK_FAILED, EXIT_COMPUTATION, EXIT_NOT_CHECKED, EXIT_OK, Error};
use crate::job::Job;
use crate::pipeline;
use crate::record_set::{self, SetJob};
use engines::estimate::{Estimate, first_plate_frequency, first_wall_frequency, together};
use engines::{FeError, Integrator, Task, engine};
use files::code::{Code, Warning};
use files::kept_complete;
pub(crate) use folders::replaced;
use folders::{Folders, announce_loss};
use report::words::{self, terminal};
use results::compare::unusable;
use results::{self, EngineId, LeftOut, Omittable, Results, Verdict, VerdictStatus, vtu};
use tank::options::linear::LiquidModel;

/// Arguments.
#[derive(clap::Args)]
#[command(group(clap::ArgGroup::new("drawn").args(["vtu", "scene"]).multiple(true)))]
#[command(after_help = "\
Examples:
  tankcheck compare tank.json --quake elcentro.csv --out out/
  tankcheck compare tank.json --out out/          the engine's modes under the design spectrum of the tank's `site`
  tankcheck compare tank.json --quake ns.at2 --vertical up.at2 --out out/
  tankcheck compare tank.json --quake ns.at2 --quake-y ew.at2 --vertical up.at2 --out out/
  tankcheck compare tank.json --quake a.csv --quake b.csv --quake c.csv --out out/      a set: mean or worst of its records
  tankcheck compare tank.json --set set.json --fit --out out/
  tankcheck compare tank.json --quake elcentro.csv --no-report --format json --select quantities,checks --out out/      in about half the time
  tankcheck compare tank.json --quake rec.txt --units g --integrator newmark --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe both --mesh 12x16x20 --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe solid --liquid displacement --vtu paraview/
  tankcheck compare tank.json --quake elcentro.csv --scene --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/ --resume
  tankcheck compare strip.json --quake elcentro.csv --fe nonlinear --liquid displacement --out out/      both walls and liquid elements in one model

Ctrl-C stops a three-dimensional or nonlinear run and keeps the finished part, marked incomplete; a second Ctrl-C
discards everything except the checkpoint of a nonlinear run.

Exit codes: 0 everything required was checked and holds; 1 a check fails; 2 bad input; 3 the computation failed or was
interrupted, or the tank collapsed; 4 something required was not checked; 130 stopped by a second Ctrl-C.")]
pub(crate) struct Args {
    #[command(flatten)]
    inputs: Inputs,
    #[command(flatten)]
    set: SetArgs,
    /// Folder for report.html, results.json, series.csv and figures/.
    #[arg(long, short, value_name = "FOLDER", default_value = "out")]
    out: PathBuf,
    /// Rotational acceleration of the base about y, positive where the top moves along x: a table under `time_s,rotation_rad_s2`, in place of that of
    /// `analysis.quake_rotation`. Of an anchored tank in the harmonic engine.
    #[arg(long, value_name = "FILE", requires = "quake", conflicts_with = "set")]
    quake_rotation: Option<PathBuf>,
    /// Finite-element engine [default: harmonic; solid for a box less broad than seven heights of its walls].
    #[arg(long, value_enum)]
    fe: Option<Engine>,
    #[command(flatten)]
    solid: solid::SolidArgs,
    #[command(flatten)]
    nonlinear: nonlinear::NonlinearArgs,
    #[command(flatten)]
    memory: MemoryArg,
    /// Write ParaView files (tank.pvd) into this folder, of the last engine that runs.
    #[arg(long, value_name = "FOLDER")]
    vtu: Option<PathBuf>,
    /// Keep the motion of wall, surface and bottom in the results folder (scene.json), of the last engine that runs.
    #[arg(long)]
    scene: bool,
    /// Time between two states [default: a hundredth of the record; with --scene an eighth of the first period of the wall].
    #[arg(long, value_name = "SECONDS", requires = "drawn", allow_negative_numbers = true)]
    vtu_every: Option<f64>,
    /// Time integration [default: modal, or as in the tank file].
    #[arg(long, value_enum)]
    integrator: Option<IntegratorArg>,
    /// Multiply every element count of the default mesh, 0.25 to 16.
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    refine: Option<f64>,
    /// Skip the second mesh that estimates the discretisation error.
    #[arg(long)]
    no_mesh_error: bool,
    #[command(flatten)]
    level: LevelArg,
    #[command(flatten)]
    style: StyleArg,
    /// Write the results alone, without report and figures. With --select, what the named parts do not need is not computed.
    #[arg(long, conflicts_with_all = ["templates", "report", "lang", "report_units"])]
    no_report: bool,
    #[command(flatten)]
    select: SelectArg,
    /// Folder whose files replace the built-in report templates.
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
    /// Form of the summary on standard output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Finite-element engine.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Engine {
    /// One Fourier harmonic at a time: potential liquid and shell of revolution (linear).
    Harmonic,
    /// Three-dimensional elements: shell, liquid, contact between them.
    Solid,
    /// Both, side by side.
    Both,
    /// The codes alone, without an engine.
    None,
    /// The harmonic engine, and a nonlinear run with walls that yield and crack, with large rotations.
    Nonlinear,
}

impl Engine {
    /// The engine that runs where none is asked for: cantilevers do not stand for the walls of a short box, and no engine models a staging, which
    /// the reader warns of.
    fn usual(case: &Case) -> Engine {
        match case.tank.staging {
            Some(_) => Engine::None,
            None if case.tank.bends_as_plates() => Engine::Solid,
            None => Engine::Harmonic,
        }
    }

    /// The engines that run, in this order.
    fn ids(self) -> &'static [EngineId] {
        match self {
            Engine::None => &[],
            Engine::Harmonic => &[EngineId::Harmonic],
            Engine::Solid => &[EngineId::Solid],
            Engine::Both => &[EngineId::Harmonic, EngineId::Solid],
            Engine::Nonlinear => &[EngineId::Harmonic, EngineId::Nonlinear],
        }
    }
}

/// Time integration.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum IntegratorArg {
    /// Exact piecewise-linear modal integration with missing mass.
    Modal,
    /// Direct Newmark on all unknowns, with energy balance.
    Newmark,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let _style = args.style.apply();
    args.select.admit(args.format)?;
    let (job, set) = jobs(&args)?;
    if job.engines.iter().any(|&id| engine(id).stops()) {
        progress::stop_gracefully(progress::FINISHED_PART);
    }
    afford(&job, set.is_some(), global)?;
    nonlinear::announce(&job, global);
    let folders = Folders::prepare(&args, &job)?;
    announce_loss(&args.out, &folders.out, &job);
    let watch = Watch::new(global, "codes and finite elements");
    let mut outcome = match &set {
        None => pipeline::run(&job, &watch)?,
        Some(set) => record_set::run(set, &watch)?,
    };
    outcome.results.volatile = stamp(started);
    let interrupted = watch.interrupted() && outcome.results.verdict.unfinished;
    let mut stale = Vec::new();
    if interrupted && results::read(&args.out).is_ok_and(|earlier| !earlier.verdict.unfinished) {
        watch.warn(&kept_complete(&args.out));
    } else {
        stale = folders.write(&args, &job, &mut outcome)?;
    }
    watch.finish();
    let results = &outcome.results;
    if !global.quiet {
        not_computed(results);
    }
    let out = (!args.no_report).then_some(args.out.as_path());
    print(results, out, (args.format, &args.select, &select::WHOLE), global)?;
    late_warnings(&job, results);
    replaced(&args.out, &stale);
    remarks(results);
    nonlinear::advise(&job, results, global);
    let drawn = outcome.snapshots.is_some();
    if args.scene && !drawn {
        say!("scene: no file written; {}", without_states(&job, set.is_some(), interrupted));
    }
    match (&args.vtu, &outcome.snapshots) {
        (Some(folder), Some(_)) if !global.quiet => {
            say!("ParaView: {}", folder.join(vtu::COLLECTION).display());
        }
        (Some(_), None) => {
            say!("ParaView: no files written; {}", without_states(&job, set.is_some(), interrupted));
        }
        _ => {}
    }
    Ok(exit_code(&results.verdict, args.inputs.strict))
}

/// Why a run has no states.
fn without_states(job: &Job, of_set: bool, interrupted: bool) -> &'static str {
    match job.case.ground_motion {
        _ if interrupted => "the run was interrupted before the first state",
        _ if of_set => "states are those of one record, not of a set",
        _ if job.engines.is_empty() => "states are those of an engine",
        None => "states are those of a run under a record",
        Some(_) => "the engine has no states",
    }
}

/// The job, and the set of records of which it has the longest.
fn jobs(args: &Args) -> Result<(Job, Option<SetJob>), Error> {
    let engines = |case: &Case| args.fe.unwrap_or_else(|| Engine::usual(case)).ids();
    let refuses = |task: &Task<'_>| {
        let solid = args.solid.over(task.solid);
        let task = Task { solid: &solid, ..*task };
        let all = engines(task.case).iter();
        all.flat_map(|&id| engine(id).refuses(&task)).collect()
    };
    let missing = || {
        Error::missing(
            "the ground motion is missing\n  help: give a record with --quake, or run `tankcheck check` for the codes alone; \
             the linear engines run without a record under the design spectrum of `site`",
        )
    };
    let given = args.set.given(&args.inputs)?;
    if given.is_none() && args.inputs.quake.is_empty() && matches!(args.fe, Some(Engine::None | Engine::Nonlinear)) {
        return Err(missing());
    }
    let (mut job, mut set) = match given {
        None => (args.inputs.job(refuses)?, None),
        Some(given) => {
            let (job, processing) = args.inputs.without_records(refuses)?;
            let set = given.job(job, &processing)?;
            for warning in &set.job.warnings {
                stream::warn("", warning);
            }
            (set.longest(), Some(set))
        }
    };
    job.engines = engines(&job.case).to_vec();
    if job.case.ground_motion.is_none() && site_action::of(&job.case, None, true).is_none() {
        return Err(missing());
    }
    choose(&mut job, args)?;
    if let Some(path) = &args.quake_rotation {
        rotation::add(&mut job, path)?;
    }
    rotation::check(&job, set.is_some())?;
    match &mut set {
        None => leave_out(&mut job, args),
        Some(set) => set.adopt(&job)?,
    }
    Ok((job, set))
}

/// Holds the engines against the memory limit, all of them together before any is announced.
///
/// * `of_set`: whether the run is one of a set, which has its second mesh after the runs, not beside them
fn afford(job: &Job, of_set: bool, global: &Global) -> Result<(), Error> {
    let mut asked = job.task();
    let alone = engines::Options { mesh_error: false, ..job.linear.clone() };
    if of_set {
        asked.linear = &alone;
    }
    let estimates = job.engines.iter().map(|&id| engine(id).estimate(&asked));
    let estimates = estimates.collect::<Result<Vec<Estimate>, FeError>>()?;
    let limit = job.solid.memory_limit_mib;
    if let Some(all) = together(&estimates) {
        all.hold(limit)?;
    }
    for (id, estimate) in job.engines.iter().zip(estimates) {
        let always = matches!(id, EngineId::Solid | EngineId::Nonlinear);
        budget::admit(&estimate, limit, always, global)?;
    }
    Ok(())
}

/// Names the parts that no selected part needs.
fn not_computed(results: &Results) {
    let parts = &results.not_computed;
    if !parts.is_empty() {
        say!("not computed, because no selected part needs it: {}", LeftOut::names(parts));
        // What it means for checks, which are printed beside it.
        for left in parts.iter().filter(|left| left.part == Omittable::MeshError) {
            say!("note: {}", left.text);
        }
    }
}

/// Warnings and notes on records, quantities and measured values.
fn remarks(results: &Results) {
    for line in words::record_set::beyond(results) {
        stream::warn("", &Warning::new(Code::UnusualRecord, line));
    }
    for found in unusable(results) {
        stream::warn("", &Warning::new(Code::Unusable, words::verdict::unusable(&found)));
    }
    for line in terminal::apart(&results.comparison.measured_apart) {
        say!("note: {line}");
    }
}

/// Exit code of a verdict; an unfinished run counts before all else.
///
/// * `strict`: whether an accepted gap is one that was not checked
pub(crate) fn exit_code(verdict: &Verdict, strict: bool) -> u8 {
    match verdict.status {
        _ if verdict.unfinished => EXIT_COMPUTATION,
        VerdictStatus::Holds if strict && !verdict.complete() => EXIT_NOT_CHECKED,
        VerdictStatus::Holds => EXIT_OK,
        VerdictStatus::Fails => EXIT_CHECK_FAILED,
        VerdictStatus::Incomplete | VerdictStatus::NotAssessed => EXIT_NOT_CHECKED,
    }
}

/// Applies the options of the command line over those of the tank file.
fn choose(job: &mut Job, args: &Args) -> Result<(), Error> {
    job.solid.memory_limit_mib = args.memory.over(job.solid.memory_limit_mib);
    let options = &mut job.linear;
    if let Some(refine) = args.refine {
        options.refine = refine;
    }
    options.mesh_error &= !args.no_mesh_error;
    match args.integrator {
        Some(IntegratorArg::Modal) => options.integrator = Integrator::Modal,
        Some(IntegratorArg::Newmark) => options.integrator = Integrator::Newmark,
        None => {}
    }
    if args.solid.is_nonlinear() {
        options.liquid = LiquidModel::Nonlinear;
        if job.engines.is_empty() {
            return Err(Error::conflict(
                "--liquid nonlinear: there is no liquid without an engine\n  help: remove --fe none",
            ));
        }
        if job.case.ground_motion.is_none() {
            return Err(Error::conflict(
                "--liquid nonlinear: its waves are those of a record\n  help: add --quake FILE",
            ));
        }
    }
    if args.vtu.is_some() && job.engines.is_empty() {
        return Err(Error::conflict("--vtu: there is nothing to draw without an engine\n  help: remove --fe none"));
    }
    // The states of a scene are left out where there are none.
    if args.vtu.is_some() || (args.scene && job.case.ground_motion.is_some()) {
        job.solid.snapshot_interval = Some(interval(job, args)?);
        job.solid.snapshot_inside = args.vtu.is_some();
        job.solid.snapshot_close = args.vtu.is_none() && args.vtu_every.is_none();
    }
    let chain = args.solid.apply_to_strip(job);
    // After the interval and the liquid, which are part of what a checkpoint is of.
    args.nonlinear.apply(job, &args.out)?;
    if job.engines.contains(&EngineId::Solid) {
        args.solid.apply(job);
    } else if let Some(option) = args.solid.given().filter(|option| !(chain && *option == "--liquid")) {
        return Err(Error::conflict(format!(
            "{option} applies to the three-dimensional engine only\n  help: add --fe solid or --fe both"
        )));
    }
    Ok(())
}

/// Leaves out what is neither selected nor written: of the harmonic engine under a record. Others compute all they have.
fn leave_out(job: &mut Job, args: &Args) {
    let alone = args.no_report && args.vtu.is_none() && !args.scene && job.engines == [EngineId::Harmonic];
    if !alone || job.case.ground_motion.is_none() {
        return;
    }
    job.without = args.select.needless();
    if !job.linear.mesh_error {
        job.without.retain(|part| *part != Omittable::MeshError);
    }
    job.linear.mesh_error &= !job.without.contains(&Omittable::MeshError);
}

/// Default number of states in the ParaView files: enough for a smooth animation.
const STATES: f64 = 100.0;
/// Frames of a scene in the first period of the wall, and most of them: of linear engines, and of a nonlinear run, whose checkpoint has them all.
const FRAMES: (f64, [f64; 2]) = (8.0, [800.0, 400.0]);

/// Time between two states [s].
fn interval(job: &Job, args: &Args) -> Result<f64, Error> {
    let Some(motion) = &job.case.ground_motion else { return Err(Error::Fe(FeError::NoRecord)) };
    let record = &motion.horizontal;
    let duration = record.dt * record.acceleration.len() as f64;
    match args.vtu_every {
        None if args.scene => {
            let (in_a_period, [linear, nonlinear]) = FRAMES;
            let most = if job.engines.contains(&EngineId::Nonlinear) { nonlinear } else { linear };
            let frequency = match job.case.tank.shape {
                tank::Shape::Rectangle { breadth, strip: false, .. } => first_plate_frequency(&job.case, breadth),
                _ => first_wall_frequency(&job.case),
            };
            let period = std::f64::consts::TAU / frequency;
            Ok((period / in_a_period).max(duration / most).max(record.dt))
        }
        None => Ok((duration / STATES).max(record.dt)),
        Some(every) if every >= record.dt && every.is_finite() => Ok(every),
        Some(every) => Err(Error::value(format!(
            "--vtu-every: found `{every}`, expected a time [s] of at least the time step of the record, {}",
            record.dt
        ))),
    }
}

/// Prints the summary.
///
/// * `select`: parts of the JSON, and those that are usual
pub(crate) fn print(
    results: &Results,
    out: Option<&Path>,
    (format, select, usual): (Format, &SelectArg, &[&str]),
    global: &Global,
) -> Result<(), Error> {
    match format {
        Format::Json => {
            stream::print(&select.json(results, usual)?)?;
        }
        Format::Csv => stream::print(&text::csv(results))?,
        Format::Human => {
            let _units = style::terminal(results.project.as_ref());
            let mut out = text::accepted(results);
            for excitation in [Excitation::Record, Excitation::Site] {
                out.push_str(&text::table(results, excitation));
            }
            out.push_str(&set_table::of(results));
            out.push_str(&text::verdict(results));
            stream::print_marked(&out)?;
        }
    }
    if let (Some(out), false) = (out, global.quiet) {
        say!("report: {}", out.join("report.html").display());
    }
    Ok(())
}

/// Warnings that follow from the results; those about the input were printed before the run.
pub(crate) fn late_warnings(job: &Job, results: &Results) {
    for warning in results.warnings.iter().filter(|w| !job.warnings.contains(w)) {
        stream::warn("", warning);
    }
    for text in report::words::verdict::dated_ahead(results) {
        stream::warn("", &Warning::new(Code::Inconsistent, text));
    }
    for line in report::words::terminal::roof(results) {
        say!("note: {line}");
    }
}
