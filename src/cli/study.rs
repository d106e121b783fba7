//! `tankcheck study`: many tanks under many records.

mod status;

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::cli::compare::stamp;
use crate::cli::progress::{self, Watch};
use crate::cli::style::StyleArg;
use crate::cli::terminal::say;
use crate::cli::{Format, Global, print};
use crate::curves::runs::Method;
use crate::error::{EXIT_COMPUTATION, EXIT_OK, Error};
use crate::input::study as input;
use crate::study::keep;
use crate::study::pilot::{self, Class};
use crate::study::plan::{self, Plan, Task};
use crate::study::rule::RuleFound;
use crate::study::run::{self, Which};
use crate::study::scripts::{self, Scheduler};
use crate::study::store::{self, State};
use crate::study::{merge, rows::RowStatus};
use engines::estimate::span;
use files::code::Code;
use files::{OutputFolder, text, write_whole};
use report::{Level, REPORT_FILE};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck study plan study.json --out farm/
  tankcheck study run farm/ --jobs 8
  tankcheck study status farm/
  tankcheck study merge farm/
  tankcheck study plan study.json --out farm/ --for slurm --scheduler-args \"--account=x --time=2:00:00\"
  tankcheck study run farm/ --shard 3/16

A study is state in files: run it again, anywhere, and only what is missing is computed. A failing check, a collapse and a refused tank are
rows, not errors.

Exit codes: 0 done; 2 bad input, or results missing at merge; 3 a task could not be computed, results could not be written, or the run was
interrupted; 130 ended by a second Ctrl-C.")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Read every tank and record of a study file; write the tasks.
    Plan(PlanArgs),
    /// Compute the tasks that have no result.
    #[command(alias = "resume")]
    Run(RunArgs),
    /// Count tasks that are done, missing, cut off or failed.
    Status(StatusArgs),
    /// Write rows.csv, tanks.csv, farm.csv, fragility.json and report.html.
    Merge(MergeArgs),
}

#[derive(clap::Args)]
struct PlanArgs {
    /// The study file; `tankcheck init --study` writes one to start from.
    #[arg(value_name = "STUDY")]
    study: PathBuf,
    /// Folder of the study.
    #[arg(long, short, value_name = "FOLDER", default_value = "study")]
    out: PathBuf,
    /// Write a submit script.
    #[arg(long = "for", value_name = "ENGINE", value_enum)]
    scheduler: Option<Scheduler>,
    /// Arguments for the scheduler, kept as they are.
    #[arg(
        long,
        value_name = "ARGS",
        default_value = "",
        allow_hyphen_values = true,
        requires = "scheduler"
    )]
    scheduler_args: String,
    /// Compute one task of each class of tanks, and print how long the study will take; the results are kept.
    #[arg(long)]
    pilot: bool,
}

#[derive(clap::Args)]
struct RunArgs {
    /// Folder of the study.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Number of tasks at a time [default: all cores].
    #[arg(long, short, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Every n-th task from the i-th: `i/n`.
    #[arg(long, value_name = "I/N", conflicts_with = "task")]
    shard: Option<String>,
    /// One task by its number from 1, or `auto`: that of HQ_TASK_ID, SLURM_ARRAY_TASK_ID or PBS_ARRAY_INDEX.
    #[arg(long, value_name = "K")]
    task: Option<String>,
    /// Compute failed tasks again.
    #[arg(long)]
    retry: bool,
}

#[derive(clap::Args)]
struct StatusArgs {
    /// Folder of the study.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

#[derive(clap::Args)]
struct MergeArgs {
    /// Folder of the study.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Merge although tasks are missing; shares and curves get bounds.
    #[arg(long)]
    partial: bool,
    /// Run rows again with histories and a report of their own, in `kept/`.
    #[arg(long, value_enum, value_name = "ROWS")]
    keep: Option<Keep>,
    #[command(flatten)]
    style: StyleArg,
}

/// Rows that are kept whole.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Keep {
    /// Of each tank the row with the largest demand over the limit of the worst damage state.
    Worst,
}

/// Folder of the rows that are kept whole.
const KEPT: &str = "kept";

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    match args.command {
        Command::Plan(args) => make(&args, global),
        Command::Run(args) => compute(&args, global),
        Command::Status(args) => status::status(&args, global),
        Command::Merge(args) => merged(&args, global),
    }
}

fn make(args: &PlanArgs, global: &Global) -> Result<u8, Error> {
    let watch = Watch::new(global, "reading tanks and records");
    let study = input::read(&args.study)?;
    let (plan, tasks) = plan::make(&study, &args.study, &args.out)?;
    plan::write(&args.out, &plan, &tasks)?;
    if let Some(scheduler) = args.scheduler {
        let script = scheduler.script(tasks.len(), &args.scheduler_args);
        write_whole(&args.out.join(scheduler.file()), script.as_bytes())?;
    }
    watch.finish();
    let mut said = String::new();
    let _ = writeln!(said, "{}", text::line(&plan.name));
    let _ = writeln!(said, "  tanks    {:>9}", plan.tanks.len());
    let _ = writeln!(said, "  samples  {:>9}", plan.samples);
    let _ = writeln!(said, "  records  {:>9}", plan.records.len());
    let _ = writeln!(
        said,
        "  scales   {:>9}  of {}",
        plan.levels.len().max(plan.factors.len()),
        text::line(&plan.im)
    );
    let _ = writeln!(said, "  rows     {:>9}", plan.rows);
    let done = tasks
        .iter()
        .filter(|t| store::state(&args.out, &t.key) == State::Done)
        .count();
    let _ = writeln!(said, "  tasks    {:>9}  {done} of them have a result", plan.tasks);
    if let Some(rule) = &plan.rule {
        let _ = writeln!(said, "  {}", kept(rule));
    }
    print(&said)?;
    if args.pilot {
        if !global.quiet {
            say!("pilot: computing one task of each class of tanks");
        }
        let watch = Watch::new(global, "pilot");
        let classes = pilot::run(&args.out, &study, &plan, &tasks)?;
        watch.finish();
        print(&cost(&classes))?;
    }
    let running = store::survey(&args.out).here.len();
    if running > 0 && !global.quiet {
        let tasks = if running == 1 {
            "1 task"
        } else {
            &format!("{running} tasks")
        };
        say!(
            "note: {tasks} of a `study run` are being computed in this folder; that run goes on with the plan it began with"
        );
    }
    if let Some(scheduler) = args.scheduler.filter(|_| !global.quiet) {
        say!("script: {}", args.out.join(scheduler.file()).display());
    }
    if !global.quiet {
        let whole = tasks.iter().all(|t| store::state(&args.out, &t.key) == State::Done);
        let next = if whole { "merge" } else { "run" };
        say!("next: tankcheck study {next} {}", args.out.display());
    }
    Ok(EXIT_OK)
}

/// Whether the records keep the rule of the study.
fn kept(rule: &RuleFound) -> String {
    let rows = rule.rows.len();
    let held = rule.rows.iter().filter(|row| row.holds).count();
    let factor = rule.rows.iter().map(|row| row.factor).fold(0.0, f64::max);
    match rule.holds {
        true => format!("records  {}: holds at all {rows} periods", rule.clause),
        false => format!(
            "records  {}: holds at {held} of {rows} periods; with the factor {factor:.3} on the set it holds at all",
            rule.clause
        ),
    }
}

/// What the pilot found.
fn cost(classes: &[Class]) -> String {
    let mut said = String::from("pilot: one task of each class, one at a time\n");
    for class in classes {
        let found = match class.row {
            Some([seconds, bytes]) => format!(
                "{:.1} ms and {:.1} KB a row, {} rows left: {}",
                1e3 * seconds,
                bytes / 1024.0,
                class.rows_left,
                span(class.seconds_left())
            ),
            None => "every task has a result".into(),
        };
        let _ = writeln!(
            said,
            "  {:<13}{} of {} tasks; {found}",
            class.name, class.tasks[1], class.tasks[0]
        );
    }
    let seconds: f64 = classes.iter().map(Class::seconds_left).sum();
    let disk: f64 = classes
        .iter()
        .filter_map(|class| Some(class.row?[1] * class.rows_left as f64))
        .sum();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let _ = writeln!(
        said,
        "  left: {} with one task at a time, at best {} with {cores}; {} on disk",
        span(seconds),
        span(seconds / cores as f64),
        size(disk)
    );
    said
}

/// A size of files.
fn size(bytes: f64) -> String {
    match bytes {
        b if b < 1e6 => format!("{:.0} KB", b / 1e3),
        b if b < 1e9 => format!("{:.1} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}

/// How the input of a study departs from its plan.
enum Departure {
    /// What changed.
    Changed(String),
    /// The first fault of input that was right.
    Faulty(String),
}

impl Departure {
    fn clause(&self) -> String {
        match self {
            Departure::Changed(what) => plan::since(what),
            Departure::Faulty(fault) => format!("the input of the study is faulty since the plan: {fault}"),
        }
    }

    fn error(&self) -> Error {
        match self {
            Departure::Changed(what) => plan::changed_since(what),
            Departure::Faulty(_) => Error::input(
                Code::StudyChanged,
                format!(
                    "{}\n  help: correct the file; `tankcheck study plan` lists all faults",
                    self.clause()
                ),
            ),
        }
    }
}

/// What the input of a study has that its plan has not; none where nothing changed, or the input is not here (results that were taken to another machine),
/// which is said. Input that was right when the plan was made and is faulty now has changed.
fn departure(folder: &Path, planned: (&Plan, &[Task]), quiet: bool) -> Option<Departure> {
    let compared = study_of(folder, planned.0).and_then(|study| plan::departure(&study, planned, folder));
    let compared = compared.map(|found| found.map(Departure::Changed));
    compared.unwrap_or_else(|error| {
        let message = error.message();
        let first = message.lines().next().unwrap_or_default();
        let absent = Code::FileUnreadable.head();
        if !first.starts_with(&absent) {
            // The place stands in the line below.
            let place = message.lines().nth(1).and_then(|line| line.trim().strip_prefix("--> "));
            let place = place.map_or(String::new(), |place| format!(", {place}"));
            return Some(Departure::Faulty(format!("{first}{place}")));
        }
        if !quiet {
            say!("note: the input of the study is not compared with its plan: {first}");
        }
        None
    })
}

/// Errors: input that changed since the plan.
fn unchanged(folder: &Path, planned: (&Plan, &[Task]), quiet: bool) -> Result<(), Error> {
    departure(folder, planned, quiet).map_or(Ok(()), |found| Err(found.error()))
}

/// The study file of a plan.
fn study_of(folder: &Path, plan: &Plan) -> Result<input::StudyInput, Error> {
    Ok(input::read(&folder.join(&plan.study))?)
}

fn compute(args: &RunArgs, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let (plan, tasks) = plan::read(&args.folder)?;
    let which = which(args, tasks.len())?;
    // A task compares its own input.
    if !matches!(which, Which::One(_)) {
        unchanged(&args.folder, (&plan, &tasks), global.quiet)?;
    }
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let threads = args.jobs.map_or(cores, usize::from);
    // Tasks run beside each other: a nonlinear run does not take more cores.
    fem::cores::limit(1);
    progress::stop_gracefully("finishing the tasks that run (press Ctrl-C again to leave them; finished tasks stay)");
    let watch = Watch::new(global, "study");
    let study = || -> Result<input::StudyInput, Error> {
        let study = study_of(&args.folder, &plan)?;
        match study.tanks.len() == plan.tanks.len() && study.records.len() == plan.records.len() {
            true => Ok(study),
            false => Err(plan::changed_since("the number of tanks or records of the study file")),
        }
    };
    let done = run::run(
        &args.folder,
        (&plan, &tasks),
        (which, args.retry, threads),
        study,
        &watch,
    )?;
    watch.finish();
    if !global.quiet {
        say!(
            "{} tasks computed, {} kept, {} failed, {} not begun, in {:.1} s",
            done.computed,
            done.kept,
            done.failed + done.failed_before,
            done.left,
            started.elapsed().as_secs_f64()
        );
        if done.left > 0 {
            say!("interrupted: what was computed is kept; the same command goes on from there");
        }
        if done.failed + done.failed_before > 0 {
            say!("help: `tankcheck study status` lists the failures, `--retry` computes them again");
        }
    }
    Ok(match done.failed + done.failed_before + done.left {
        0 => EXIT_OK,
        _ => EXIT_COMPUTATION,
    })
}

fn which(args: &RunArgs, tasks: usize) -> Result<Which, Error> {
    if let Some(text) = &args.shard {
        let parts = text.split_once('/');
        let numbers = parts.and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
        return match numbers {
            Some((number, of)) if of >= 1 && (1..=of).contains(&number) => Ok(Which::Shard { number, of }),
            _ => Err(Error::input(
                Code::OptionValue,
                format!("--shard: found `{text}`, expected `i/n` with 1 ≤ i ≤ n, such as 3/16"),
            )),
        };
    }
    let Some(text) = &args.task else { return Ok(Which::All) };
    let number = match text.as_str() {
        "auto" => scripts::of_environment(),
        given => given.parse().ok(),
    };
    match number {
        Some(number) if (1..=tasks).contains(&number) => Ok(Which::One(number)),
        _ => Err(Error::input(
            Code::OptionValue,
            format!(
                "--task: found `{text}`, expected a number from 1 to {tasks}, or `auto` under HyperQueue, Slurm or PBS"
            ),
        )),
    }
}

fn merged(args: &MergeArgs, global: &Global) -> Result<u8, Error> {
    let _style = args.style.apply();
    let (plan, tasks) = plan::read(&args.folder)?;
    unchanged(&args.folder, (&plan, &tasks), global.quiet)?;
    let watch = Watch::new(global, "merging");
    let found = merge::merge(&args.folder, &plan, &tasks, args.partial, &watch)?;
    if let Some(study) = &found.study {
        let page = report::study::report(study)?;
        write_whole(&args.folder.join(REPORT_FILE), page.html.as_bytes())?;
    }
    watch.finish();
    if args.keep == Some(Keep::Worst) {
        keep_worst(&args.folder, &plan, &found, global)?;
    }
    let mut said = format!("{}\n", text::line(&plan.name));
    let _ = writeln!(said, "  rows      {:>9}", found.rows);
    for (status, count) in &found.by_status {
        if *status != RowStatus::Ok.word() || found.by_status.len() > 1 {
            let _ = writeln!(said, "  {status:<10}{count:>9}");
        }
    }
    if found.missing > 0 {
        let _ = writeln!(
            said,
            "  {} tasks have no result: the curves are of the others, with bounds",
            found.missing
        );
    }
    let (mut all, mut fitted) = (0, 0);
    for (title, [own, of]) in CURVES.into_iter().zip(curves(&found)) {
        if of > 0 {
            let _ = writeln!(said, "  {title:<10}{own:>9}  of {of} identified");
        }
        (all, fitted) = (all + of, fitted + own);
    }
    let _ = writeln!(said, "  sha256    {}", found.sha256);
    print(&said)?;
    if fitted < all && !global.quiet {
        let method = match plan.method {
            Method::Capacities => "",
            Method::Stripes | Method::Cloud => OTHER_METHOD,
        };
        say!("help: {IDENTIFY}{method} identify more");
    }
    if !global.quiet {
        for file in merge::FILES.iter().copied().chain([REPORT_FILE]) {
            say!("{}", args.folder.join(file).display());
        }
    }
    Ok(EXIT_OK)
}

/// What identifies more curves.
const IDENTIFY: &str = "fragility.json and the report say why a curve is not identified; levels that are closer together or reach further, more records";
/// The same, where another method was used.
const OTHER_METHOD: &str = ", or `\"method\": \"capacities\"` in the study file";

/// Titles of [`curves`].
const CURVES: [&str; 2] = ["curves", "of farm"];

/// Curves of the tanks and of the farm: those that the data identify, and all.
fn curves(found: &merge::Merged) -> [[usize; 2]; 2] {
    let count = |curves: &[results::StudyCurve]| {
        let fitted = curves.iter().filter(|curve| curve.fit.is_some());
        [fitted.count(), curves.len()]
    };
    let study = found.study.as_ref();
    [
        study.map_or([0; 2], |study| count(&study.curves)),
        study.map_or([0; 2], |study| count(&study.system)),
    ]
}

/// Runs the worst row of each tank again, with all that `compare` writes.
fn keep_worst(folder: &Path, plan: &Plan, found: &merge::Merged, global: &Global) -> Result<(), Error> {
    let study = study_of(folder, plan)?;
    for (tank, row) in &found.worst {
        let started = Instant::now();
        let watch = Watch::new(global, "worst rows");
        let mut outcome = keep::run(&study, plan, tank, row, &watch)?;
        stamp(&mut outcome.results, started);
        let home = folder.join(KEPT);
        std::fs::create_dir_all(&home).map_err(|e| {
            Error::Files(files::error::Error::Unwritten {
                path: home.clone(),
                what: files::error::describe(&e),
            })
        })?;
        let out = OutputFolder::prepare(&home.join(keep::folder(plan, tank)), results::COMPARE)?;
        results::write(&out.path(), &outcome.results, &outcome.series)?;
        report::render(&out.path(), None, Level::Standard)?;
        out.commit()?;
        watch.finish();
        if !global.quiet {
            say!("{}", home.join(keep::folder(plan, tank)).join(REPORT_FILE).display());
        }
    }
    Ok(())
}
