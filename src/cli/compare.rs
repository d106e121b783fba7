//! `tankcheck compare`: codes and finite elements side by side.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use codes::site_action;
use fem::progress::Progress;
use tank::Case;
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::outside::Outside;
use tank::units;

use crate::cli::budget::{self, MemoryArg};
use crate::cli::inputs::Inputs;
use crate::cli::progress::{self, Watch};
use crate::cli::record_set::SetArgs;
use crate::cli::report::LevelArg;
use crate::cli::select::{self, SelectArg};
use crate::cli::style::{self, StyleArg};
use crate::cli::table::Table;
use crate::cli::terminal::{self as stream, say};
use crate::cli::{Format, Global, checks, nonlinear, now, set_table, solid};
use crate::error::{EXIT_CHECK_FAILED, EXIT_COMPUTATION, EXIT_NOT_CHECKED, EXIT_OK, Error};
use crate::job::Job;
use crate::pipeline::{self, Outcome};
use crate::record_set;
use engines::estimate::Estimate;
use engines::{FeError, Integrator, Task, engine};
use files::code::{Code, Warning};
use files::{OutputFolder, kept_complete};
use report::words::{self, terminal};
use report::{self, Level};
use results::compare::unusable;
use results::nonlinear::End;
use results::{
    self, Channel, ComparisonRow, EngineId, Limit, Method, Results, Run, Series, SeriesInfo, Verdict, VerdictStatus,
    vtu,
};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck compare tank.json --quake elcentro.csv --out out/
  tankcheck compare tank.json --out out/          the engine's modes under the design spectrum of the tank's `site`
  tankcheck compare tank.json --quake ns.at2 --vertical up.at2 --out out/
  tankcheck compare tank.json --quake ns.at2 --quake-y ew.at2 --vertical up.at2 --out out/
  tankcheck compare tank.json --quake a.csv --quake b.csv --quake c.csv --out out/      a set: mean or worst of its records
  tankcheck compare tank.json --set set.json --fit --out out/
  tankcheck compare tank.json --quake elcentro.csv --no-report --format json --select quantities,checks --out out/
  tankcheck compare tank.json --quake rec.txt --units g --integrator newmark --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe both --mesh 12x16x20 --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe solid --liquid displacement --vtu paraview/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/ --resume

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
    /// Finite-element engine [default: harmonic; solid for a box less broad than seven heights of its walls].
    #[arg(long, value_enum)]
    fe: Option<Engine>,
    #[command(flatten)]
    solid: solid::SolidArgs,
    #[command(flatten)]
    nonlinear: nonlinear::NonlinearArgs,
    #[command(flatten)]
    memory: MemoryArg,
    /// Write ParaView files (tank.pvd) into this folder: of the three-dimensional or the nonlinear run, else of the bottom plate that lifts.
    #[arg(long, value_name = "FOLDER")]
    vtu: Option<PathBuf>,
    /// Time between two states in the ParaView files [default: a hundredth of the record].
    #[arg(long, value_name = "SECONDS", requires = "vtu", allow_negative_numbers = true)]
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
    /// Write the results alone, without report and figures.
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
    /// The engine that runs where none is asked for: cantilevers do not stand for the walls of a short box.
    fn usual(case: &Case) -> Engine {
        match case.tank.bends_as_plates() {
            true => Engine::Solid,
            false => Engine::Harmonic,
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
    let engines = |case: &Case| args.fe.unwrap_or_else(|| Engine::usual(case)).ids();
    let refuses = |task: &Task<'_>| {
        let all = engines(task.case).iter();
        all.flat_map(|&id| engine(id).refuses(task)).collect()
    };
    let missing = || {
        Error::input(
            Code::MissingInput,
            "the ground motion is missing\n  help: give a record with --quake, or run `tankcheck check` for the codes alone; \
             the linear engines run without a record under the design spectrum of `site`"
                .into(),
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
    let spectral = || site_action::of(&job.case, None, true).is_some();
    if job.case.ground_motion.is_none() && !spectral() {
        return Err(missing());
    }
    choose(&mut job, &args)?;
    if let Some(set) = &mut set {
        set.adopt(&job)?;
    }
    if job.engines.iter().any(|&id| engine(id).stops()) {
        progress::stop_gracefully();
    }
    // All of them before any is announced.
    let estimates = job.engines.iter().map(|&id| engine(id).estimate(&job.task()));
    for (id, estimate) in job
        .engines
        .iter()
        .zip(estimates.collect::<Result<Vec<Estimate>, FeError>>()?)
    {
        let always = matches!(id, EngineId::Solid | EngineId::Nonlinear);
        budget::admit(&estimate, job.solid.memory_limit_mib, always, global)?;
    }
    nonlinear::announce(&job, global);
    if args.vtu.as_ref() == Some(&args.out) {
        return Err(Error::input(
            Code::OptionConflict,
            format!(
                "--vtu and --out are the same folder, `{}`\n  help: use a separate folder for each",
                args.out.display()
            ),
        ));
    }
    let folder = match job.checkpoint {
        Some(_) => OutputFolder::prepare_alone(&args.out, results::COMPARE)?,
        None => OutputFolder::prepare(&args.out, results::COMPARE)?,
    };
    let vtu = match &args.vtu {
        Some(target) => Some(OutputFolder::prepare(target, vtu::FOLDER)?),
        None => None,
    };
    let watch = Watch::new(global, "codes and finite elements");
    let Outcome {
        mut results,
        series,
        snapshots,
    } = match &set {
        None => pipeline::run(&job, &watch)?,
        Some(set) => record_set::run(set, &watch)?,
    };
    stamp(&mut results, started);
    let interrupted = watch.interrupted() && results.verdict.unfinished;
    let mut stale = Vec::new();
    if interrupted && results::read(&args.out).is_ok_and(|earlier| !earlier.verdict.unfinished) {
        watch.warn(&kept_complete(&args.out));
    } else {
        let report = (!args.no_report).then(|| (args.templates.as_deref(), args.level.level()));
        if report.is_some() {
            pipeline::draw(&job, &mut results)?;
        }
        write(&folder, &results, &series, report)?;
        if let (Some(vtu), Some(snapshots)) = (&vtu, &snapshots) {
            vtu::write(&vtu.path(), snapshots)?;
        }
        stale = folder.stale();
        folder.commit()?;
        // Without a state the folder is not changed.
        vtu.filter(|_| snapshots.is_some())
            .map_or(Ok(()), OutputFolder::commit)?;
        nonlinear::tidy(&job, &results);
    }
    watch.finish();
    let out = (!args.no_report).then_some(args.out.as_path());
    print(&results, out, (args.format, &args.select, &select::WHOLE), global)?;
    late_warnings(&job, &results);
    replaced(&args.out, &stale);
    for line in words::record_set::beyond(&results) {
        stream::warn("", &Warning::new(Code::UnusualRecord, line));
    }
    for found in unusable(&results) {
        stream::warn("", &Warning::new(Code::Unusable, words::verdict::unusable(&found)));
    }
    for line in terminal::apart(&results.comparison.measured_apart) {
        say!("note: {line}");
    }
    nonlinear::advise(&job, &results, global);
    match (&args.vtu, &snapshots) {
        (Some(folder), Some(_)) if !global.quiet => {
            say!("ParaView: {}", folder.join(vtu::COLLECTION).display());
        }
        (Some(_), None) if interrupted => {
            say!("ParaView: no files written; the run was interrupted before the first state");
        }
        (Some(_), None) => say!("ParaView: no files written; the base neither lifts nor slides in this run"),
        _ => {}
    }
    Ok(exit_code(&results.verdict))
}

/// Exit code of a verdict; an unfinished run counts before all else.
pub(crate) fn exit_code(verdict: &Verdict) -> u8 {
    match verdict.status {
        _ if verdict.unfinished => EXIT_COMPUTATION,
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
    if args.vtu.is_some() {
        if !draws(job) {
            return Err(Error::input(
                Code::OptionConflict,
                "--vtu: there is nothing to draw; the harmonic engine has states of a steel bottom plate under a cylinder alone\n  help: \
                 add --fe solid, --fe both or, for a cylinder, --fe nonlinear; or give `tank.bottom`"
                    .into(),
            ));
        }
        job.solid.snapshot_interval = Some(interval(job, args.vtu_every)?);
    }
    // After the interval, which is part of what a checkpoint is of.
    args.nonlinear.apply(job, &args.out)?;
    if job.engines.contains(&EngineId::Solid) {
        args.solid.apply(job);
    } else if let Some(option) = args.solid.given() {
        return Err(Error::input(
            Code::OptionConflict,
            format!("{option} applies to the three-dimensional engine only\n  help: add --fe solid or --fe both"),
        ));
    }
    Ok(())
}

/// Whether an engine may have states for ParaView.
fn draws(job: &Job) -> bool {
    let round = matches!(job.case.tank.shape, tank::Shape::Cylinder { .. });
    let lifts = || base::Base::of(&job.case).is_ok();
    job.engines.iter().any(|engine| match engine {
        EngineId::Solid => true,
        EngineId::Nonlinear => round,
        EngineId::Harmonic => lifts(),
    })
}

/// Default number of states in the ParaView files: enough for a smooth animation.
const STATES: f64 = 100.0;

/// Time between two states in the ParaView files [s].
fn interval(job: &Job, given: Option<f64>) -> Result<f64, Error> {
    let Some(motion) = &job.case.ground_motion else {
        return Err(Error::Fe(FeError::NoRecord));
    };
    let record = &motion.horizontal;
    let duration = record.dt * record.acceleration.len() as f64;
    match given {
        None => Ok((duration / STATES).max(record.dt)),
        Some(every) if every >= record.dt && every.is_finite() => Ok(every),
        Some(every) => Err(Error::input(
            Code::OptionValue,
            format!(
                "--vtu-every: found `{every}`, expected a time [s] of at least the time step of the record, {}",
                record.dt
            ),
        )),
    }
}

/// Fills in the fields that differ between identical runs.
pub(crate) fn stamp(results: &mut Results, started: Instant) {
    results.volatile.created = now();
    // The name of the command, without the path on this machine.
    let arguments = std::env::args().skip(1);
    results.volatile.command = std::iter::once("tankcheck".to_string())
        .chain(arguments)
        .collect::<Vec<_>>()
        .join(" ");
    results.volatile.seconds = started.elapsed().as_secs_f64();
}

fn write(
    folder: &OutputFolder,
    results: &Results,
    series: &Series,
    report: Option<(Option<&Path>, Level)>,
) -> Result<(), Error> {
    results::write(&folder.path(), results, series)?;
    if let Some((templates, level)) = report {
        report::render(&folder.path(), templates, level)?;
    }
    Ok(())
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
        Format::Csv => stream::print(&csv(results))?,
        Format::Human => {
            let mut text = String::new();
            for excitation in [Excitation::Record, Excitation::Site] {
                text.push_str(&table(results, excitation));
            }
            text.push_str(&set_table::of(results));
            text.push_str(&verdict(results));
            stream::print_marked(&text)?;
        }
    }
    if let (Some(out), false) = (out, global.quiet) {
        say!("report: {}", out.join("report.html").display());
    }
    Ok(())
}

/// Names what of an earlier run is gone.
///
/// * `stale`: of [`OutputFolder::stale`], before its commit
pub(crate) fn replaced(out: &Path, stale: &[String]) {
    if !stale.is_empty() {
        let text = format!(
            "{}: {} of the earlier results removed, of which the new ones have none",
            out.display(),
            stale.join(", ")
        );
        stream::warn("", &Warning::new(Code::Replaced, text));
    }
}

/// Warnings that follow from the results; those about the input were printed before the run.
pub(crate) fn late_warnings(job: &Job, results: &Results) {
    for warning in results.warnings.iter().filter(|w| !job.warnings.contains(w)) {
        stream::warn("", warning);
    }
}

/// Quantity × method for one excitation, values with their ratio to the engine.
fn table(results: &Results, excitation: Excitation) -> String {
    let shown = |m: &Method| m.excitation == excitation && !m.quantities.is_empty();
    let columns: Vec<usize> = results
        .methods
        .iter()
        .enumerate()
        .filter(|(_, m)| shown(m))
        .map(|(i, _)| i)
        .collect();
    if columns.is_empty() {
        return String::new();
    }
    let fe_here = columns.iter().any(|&i| results.methods[i].id == results::FE);
    let head = std::iter::once(terminal::corner(excitation, results.reference().is_some(), fe_here))
        .chain(columns.iter().map(|&i| results.methods[i].id.as_str()));
    let later = Later::of(results).filter(|_| excitation == Excitation::Record);
    let mut table = Table::new(head);
    for row in &results.comparison.rows {
        let values: Vec<f64> = columns.iter().filter_map(|&i| row.cells[i].map(|c| c.value)).collect();
        if values.is_empty() {
            continue;
        }
        let unit = units::column_unit(values, row.dimension);
        let cells = columns.iter().map(|&i| match row.cells[i] {
            None => "–".to_string(),
            Some(cell) => {
                let value = units::significant(units::in_unit(cell.value, unit), 3);
                let nonlinear = results.methods[i].id == EngineId::Nonlinear.beside();
                let mark = match later
                    .as_ref()
                    .is_some_and(|l| nonlinear && l.peaks.contains_key(&row.quantity))
                {
                    true => "*",
                    false => "",
                };
                let unusable = if cell.unusable { terminal::UNUSABLE } else { "" };
                let outside = if cell.outside { terminal::OUTSIDE } else { "" };
                let mark = format!("{mark}{unusable}{outside}");
                match cell.ratio {
                    Some(ratio) => format!("{value} ({ratio:.2}){mark}"),
                    None => format!("{value}{mark}"),
                }
            }
        });
        let title = format!("{} [{}]", row.title, unit.symbol);
        table.row(std::iter::once(title).chain(cells));
    }
    let mut text = format!("{}\n", table.fitted(stream::width()));
    let marked = |mark: fn(&results::Cell) -> bool| {
        let of = |row: &ComparisonRow| columns.iter().any(|&i| row.cells[i].as_ref().is_some_and(mark));
        results.comparison.rows.iter().any(of)
    };
    if marked(|c| c.unusable) {
        let _ = writeln!(text, "{}", terminal::unusable());
    }
    let open = |why: &Outside| {
        let of = |i: &usize| results.methods[*i].checks.iter();
        let is = |c: &Check| c.status == CheckStatus::NotChecked && c.limit_state == why.limit_state();
        columns.iter().flat_map(of).any(is)
    };
    // The column of the engine under the site's spectrum has no checks that give the reason.
    let plates = results.tank.tank.bends_as_plates();
    let alone = |why: &Outside| excitation == Excitation::Site && plates == (*why == Outside::Plates);
    for why in Outside::ALL
        .into_iter()
        .filter(|why| marked(|c| c.outside) && (open(why) || alone(why)))
    {
        let _ = writeln!(text, "{}", terminal::outside(why));
    }
    let together = results
        .reference()
        .and_then(|run| terminal::components(&run.directions));
    if let Some(line) = together.filter(|_| excitation == Excitation::Record && fe_here) {
        let _ = writeln!(text, "{line}");
    }
    if let Some(later) = later {
        let _ = writeln!(text, "{}", terminal::later(&later.peaks, later.end, later.completed));
    }
    for method in results.methods.iter().filter(|m| m.excitation == excitation) {
        if let Some(line) = terminal::not_applicable(method) {
            let _ = writeln!(text, "{line}");
        }
    }
    // Before what follows; the table has a line of its own after it.
    if !text.ends_with("\n\n") {
        text.push('\n');
    }
    text
}

/// Peaks of the linear run after the end of the nonlinear one.
struct Later {
    /// End of the nonlinear run [s].
    end: f64,
    /// Whether that is the end of the record.
    completed: bool,
    /// Quantity → time of the linear peak [s].
    peaks: BTreeMap<String, f64>,
}

impl Later {
    /// `None` if there is none.
    fn of(results: &Results) -> Option<Later> {
        let (linear, nonlinear) = (results.reference()?, results.beside(EngineId::Nonlinear)?);
        let run = nonlinear.nonlinear.as_ref()?;
        let end = *run.energies.time.last()?;
        let mut peaks = BTreeMap::new();
        for row in &results.comparison.rows {
            let own = |s: &&SeriesInfo| Channel::compared(&s.id).is_some_and(|q| q.id() == row.quantity);
            let histories = linear.histories.iter().filter(own);
            if let Some(highest) = histories.max_by(|a, b| a.peak.abs().total_cmp(&b.peak.abs()))
                && highest.time > end
            {
                peaks.insert(row.quantity.clone(), highest.time);
            }
        }
        let completed = nonlinear.end == End::Completed;
        (!peaks.is_empty()).then_some(Later { end, completed, peaks })
    }
}

fn csv(results: &Results) -> String {
    let mut text = String::from("method,excitation,quantity,value,unit,ratio_to_fe,usable\n");
    for row in &results.comparison.rows {
        for (method, cell) in results.methods.iter().zip(&row.cells) {
            let Some(cell) = cell else { continue };
            let excitation = terminal::excitation(method.excitation);
            let ratio = cell.ratio.map_or(String::new(), |r| format!("{r:.6}"));
            let usable = if cell.unusable || cell.outside { "no" } else { "yes" };
            let unit = style::unit(results, cell.value, row.dimension);
            let (value, unit) = style::in_csv(cell.value, unit);
            let _ = writeln!(
                text,
                "{},{excitation},{},{value:e},{unit},{ratio},{usable}",
                method.id, row.quantity
            );
        }
    }
    text.push_str(&checks::csv(results));
    text
}

fn verdict(results: &Results) -> String {
    let mut text = String::new();
    let verdict = &results.verdict;
    text.push_str(&checks::tables(results));
    let _ = writeln!(text, "{}", words::verdict::headline(verdict));
    let _ = writeln!(text, "  deciding: {}", words::verdict::deciding(verdict));
    if let Some(governing) = &verdict.governing {
        let _ = writeln!(text, "  governing: {}", terminal::governing(governing));
    }
    if let Some(aside) = &verdict.record {
        let governing = aside.governing.as_ref().map(terminal::governing);
        let governing = governing.map(|g| format!("; governing: {g}")).unwrap_or_default();
        let _ = writeln!(
            text,
            "{}{governing}",
            words::verdict::record(aside, results.record_set.is_some())
        );
    }
    // A limit that several engines exceed is printed once.
    let mut told: Vec<&str> = Vec::new();
    for run in &results.runs {
        let exceeded: Vec<&Limit> = run.limits.iter().filter(|l| !l.holds).collect();
        for limit in exceeded.iter().filter(|l| !told.contains(&l.id.as_str())) {
            let _ = writeln!(text, "{}: {}", Code::LimitExceeded.head(), terminal::exceeded(limit));
        }
        told.extend(exceeded.iter().map(|l| l.id.as_str()));
    }
    if results.runs.iter().any(Run::parted) {
        let _ = writeln!(text, "{}: {}", Code::LiquidParted.head(), words::verdict::LIQUID_PARTED);
    }
    text
}
