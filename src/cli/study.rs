//! `tankcheck study`: many tanks under many records.

mod check;
mod departure;
mod merge;
mod status;

use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

use crate::cli::budget::MemoryArg;
use crate::cli::progress::{self, Watch};
use crate::cli::terminal::say;
use crate::cli::{Global, print};
use crate::error::{EXIT_COMPUTATION, EXIT_OK, Error};
use crate::input::study as input;
use crate::study::pilot::{self, Class};
use crate::study::plan;
use crate::study::rule::RuleFound;
use crate::study::run::{self, Which};
use crate::study::scripts::{self, Scheduler};
use crate::study::{changes, folder, store};
use departure::{study_of, unchanged};
use engines::estimate::span;
use files::text;
use status::size;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck study plan study.json --out farm/
  tankcheck study run farm/ --jobs 8
  tankcheck study status farm/
  tankcheck study check farm/
  tankcheck study merge farm/
  tankcheck study plan study.json --out farm/ --for slurm --scheduler-args \"--account=x --time=2:00:00\"
  tankcheck study run farm/ --shard 3/16

A study is state in files: run it again, anywhere, and only what is missing is computed. A failing check, a collapse and a refused tank are
rows, not errors.

Exit codes: 0 done; 2 bad input, or results missing or damaged at merge; 3 a task could not be computed, results could not be written, the run was
interrupted, or `check` found damage; 130 ended by a second Ctrl-C.")]
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
    /// Count tasks that are done, missing, damaged or failed.
    Status(status::StatusArgs),
    /// Read every result whole and compare it with the plan; `study run` repairs what is damaged.
    Check(status::StatusArgs),
    /// Write rows.csv, tanks.csv, farm.csv, fragility.json and report.html.
    Merge(merge::MergeArgs),
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
    #[arg(long, value_name = "ARGS", default_value = "", allow_hyphen_values = true, requires = "scheduler")]
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
    /// Number of tasks at a time [default: --threads].
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
    #[command(flatten)]
    memory: MemoryArg,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    match args.command {
        Command::Plan(args) => make(&args, global),
        Command::Run(args) => compute(&args, global),
        Command::Status(args) => status::status(&args, global),
        Command::Check(args) => check::check(&args, global),
        Command::Merge(args) => merge::merged(&args, global),
    }
}

fn make(args: &PlanArgs, global: &Global) -> Result<u8, Error> {
    // They become a line of a script.
    if args.scheduler_args.contains(|c: char| c.is_control()) {
        return Err(Error::value(format!(
            "--scheduler-args: found `{}`, expected one line without control characters",
            text::line(&args.scheduler_args)
        )));
    }
    let watch = Watch::new(global, "reading tanks and records");
    let study = input::read(&args.study)?;
    let (plan, tasks) = plan::make(&study, &args.study, &args.out)?;
    let script = |scheduler: Scheduler| (scheduler.file(), scheduler.script(tasks.len(), &args.scheduler_args));
    folder::write(&args.out, &plan, &tasks, args.scheduler.map(script))?;
    watch.finish();
    let mut said = String::new();
    let _ = writeln!(said, "{}", text::line(&plan.name));
    let _ = writeln!(said, "  tanks    {:>9}", plan.tanks.len());
    let _ = writeln!(said, "  samples  {:>9}", plan.samples);
    let _ = writeln!(said, "  records  {:>9}", plan.records.len());
    let _ = writeln!(said, "  scales   {:>9}  of {}", plan.levels.len().max(plan.factors.len()), text::line(&plan.im));
    let _ = writeln!(said, "  rows     {:>9}", plan.rows);
    let done = tasks.iter().filter(|t| store::find(&args.out, &plan, t).whole()).count();
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
        let tasks = if running == 1 { "1 task" } else { &format!("{running} tasks") };
        say!(
            "note: {tasks} of a `study run` are being computed in this folder; that run goes on with the plan it began with"
        );
    }
    if let Some(scheduler) = args.scheduler.filter(|_| !global.quiet) {
        say!("script: {}", args.out.join(scheduler.file()).display());
    }
    if !global.quiet {
        let whole = tasks.iter().all(|t| store::find(&args.out, &plan, t).whole());
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
        let _ = writeln!(said, "  {:<13}{} of {} tasks; {found}", class.name, class.tasks[1], class.tasks[0]);
    }
    let seconds: f64 = classes.iter().map(Class::seconds_left).sum();
    let disk: f64 = classes.iter().filter_map(|class| Some(class.row?[1] * class.rows_left as f64)).sum();
    let cores = fem::cores::available();
    let _ = writeln!(
        said,
        "  left: {} with one task at a time, at best {} with {cores}; {} on disk",
        span(seconds),
        span(seconds / cores as f64),
        size(disk)
    );
    said
}

fn compute(args: &RunArgs, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let (plan, tasks) = folder::read(&args.folder)?;
    let which = which(args, tasks.len())?;
    // A task compares its own input.
    if !matches!(which, Which::One(_)) {
        unchanged(&args.folder, (&plan, &tasks), global.quiet)?;
    }
    let threads = args.jobs.map_or_else(fem::cores::available, usize::from);
    // Tasks run beside each other: a nonlinear run does not take more cores.
    fem::cores::limit(1);
    progress::stop_gracefully("finishing the tasks that run (press Ctrl-C again to leave them; finished tasks stay)");
    let watch = Watch::new(global, "study");
    let study = || -> Result<input::StudyInput, Error> {
        let study = study_of(&args.folder, &plan)?;
        match study.tanks.len() == plan.tanks.len() && study.records.len() == plan.records.len() {
            true => Ok(study),
            false => Err(changes::changed_since("the number of tanks or records of the study file")),
        }
    };
    let done = run::run(
        &args.folder,
        (&plan, &tasks),
        (which, args.retry, threads),
        |given| args.memory.over(given),
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
        if done.damaged > 0 {
            say!("damaged results, computed again: {}", done.damaged);
        }
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
            _ => Err(Error::value(format!("--shard: found `{text}`, expected `i/n` with 1 ≤ i ≤ n, such as 3/16"))),
        };
    }
    let Some(text) = &args.task else { return Ok(Which::All) };
    let number = match text.as_str() {
        "auto" => scripts::of_environment(),
        given => given.parse().ok(),
    };
    match number {
        Some(number) if (1..=tasks).contains(&number) => Ok(Which::One(number)),
        _ => Err(Error::value(format!(
            "--task: found `{text}`, expected a number from 1 to {tasks}, or `auto` under HyperQueue, Slurm or PBS"
        ))),
    }
}
