//! `tankcheck study status`: what is done, and what is not.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use super::departure::departure;
use crate::cli::{Format, Global, no_csv, show};
use crate::error::{EXIT_OK, Error};
use crate::study::folder;
use crate::study::plan::{Plan, Task};
use crate::study::store::{self, Found};
use files::text;

#[derive(clap::Args)]
pub(super) struct StatusArgs {
    /// Folder of the study.
    #[arg(value_name = "FOLDER")]
    pub(super) folder: PathBuf,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub(super) format: Format,
}

#[derive(serde::Serialize)]
struct Status {
    tasks: usize,
    done: usize,
    /// Without a result; those that run are among them.
    missing: usize,
    running: usize,
    /// Marked by another machine, which may have ended.
    running_elsewhere: usize,
    /// There, and not their result.
    damaged: usize,
    failed: usize,
    rows: usize,
    rows_done: usize,
    /// Size of the results, of this plan and of earlier ones.
    bytes: u64,
    /// Size of those of this plan.
    bytes_of_plan: u64,
    failures: Vec<store::Failure>,
    /// Input that changed, or is faulty, since the plan.
    changed: Option<String>,
}

pub(super) fn status(args: &StatusArgs, global: &Global) -> Result<u8, Error> {
    let (plan, tasks) = folder::read(&args.folder)?;
    let survey = store::survey(&args.folder);
    let mut found = Status {
        tasks: tasks.len(),
        done: 0,
        missing: 0,
        damaged: 0,
        failed: 0,
        running: 0,
        running_elsewhere: 0,
        bytes: survey.bytes,
        bytes_of_plan: tasks.iter().map(|task| store::size(&args.folder, &task.key)).sum(),
        rows: plan.rows,
        rows_done: 0,
        failures: Vec::new(),
        changed: departure(&args.folder, (&plan, &tasks), global.quiet).map(|found| found.clause()),
    };
    for task in &tasks {
        found.running += usize::from(survey.here.contains(&task.key));
        found.running_elsewhere += usize::from(survey.elsewhere.contains(&task.key));
        match store::find(&args.folder, &plan, task) {
            Found::Whole(_) => {
                found.done += 1;
                found.rows_done += task.rows;
            }
            Found::Missing => found.missing += 1,
            Found::Damaged(_) => found.damaged += 1,
            Found::Failed => found.failed += 1,
        }
        found.failures.extend(failure(&args.folder, task));
    }
    show(args.format, || human(&plan, &found), || &found, no_csv)?;
    Ok(EXIT_OK)
}

fn failure(folder: &Path, task: &Task) -> Option<store::Failure> {
    store::failure(folder, &task.key).map(|failure| store::Failure { task: task.task, ..failure })
}

fn human(plan: &Plan, found: &Status) -> String {
    let mut said = format!("{}\n", text::line(&plan.name));
    let mut row = |name: &str, count: usize, remark: &str| {
        let _ = writeln!(said, "  {name:<9}{count:>9}  {remark}");
    };
    row("tasks", found.tasks, "");
    row("done", found.done, &format!("{} of {} rows", found.rows_done, found.rows));
    let elsewhere = found.running_elsewhere;
    let marked = [
        (found.running > 0).then(|| format!("{} of them running", found.running)),
        (elsewhere > 0).then(|| format!("{elsewhere} of them marked by other machines, running or killed")),
    ];
    let marked: Vec<String> = marked.into_iter().flatten().collect();
    row("missing", found.missing, &marked.join(", "));
    if found.damaged > 0 {
        row("damaged", found.damaged, "`study check` names them, `study run` computes them again");
    }
    if found.failed > 0 {
        row("failed", found.failed, "`study run --retry` computes them again");
    }
    let earlier = found.bytes.saturating_sub(found.bytes_of_plan);
    let remark = match earlier {
        0 => String::new(),
        _ => format!("{} of it not of this plan: earlier plans, or half-written", size(earlier as f64)),
    };
    let _ = writeln!(said, "  disk     {:>9}  {remark}", size(found.bytes as f64));
    if let Some(clause) = &found.changed {
        let _ = writeln!(said, "  {clause}\n  `merge` refuses it, and so do tasks without a result");
    }
    for failure in found.failures.iter().take(10) {
        let message = text::line(&failure.message);
        let _ = writeln!(said, "  task {} on {}: {message}", failure.task, text::line(&failure.host));
    }
    said
}

/// A size of files.
pub(super) fn size(bytes: f64) -> String {
    match bytes {
        b if b < 1e6 => format!("{:.0} KB", b / 1e3),
        b if b < 1e9 => format!("{:.1} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}
