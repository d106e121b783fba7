//! `tankcheck study merge`: results to tables and a report.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::departure::{study_of, unchanged};
use crate::cli::progress::Watch;
use crate::cli::style::StyleArg;
use crate::cli::terminal::say;
use crate::cli::{Global, print, stamp};
use crate::curves::runs::Method;
use crate::error::{EXIT_OK, Error};
use crate::study::plan::Plan;
use crate::study::rows::RowStatus;
use crate::study::{folder, keep, merge, merged};
use files::{OutputFolder, text, write_whole};
use report::{Level, REPORT_FILE};

#[derive(clap::Args)]
pub(super) struct MergeArgs {
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
    /// The row of each tank with the largest demand over the limit of the worst damage state.
    Worst,
}

/// Folder of the rows that are kept whole.
const KEPT: &str = "kept";

pub(super) fn merged(args: &MergeArgs, global: &Global) -> Result<u8, Error> {
    let _style = args.style.apply();
    let (plan, tasks) = folder::read(&args.folder)?;
    unchanged(&args.folder, (&plan, &tasks), global.quiet)?;
    let watch = Watch::new(global, "merging");
    let out = OutputFolder::prepare(&args.folder, folder::MERGED)?;
    let found = merge::merge(&args.folder, (&plan, &tasks), args.partial, &out.path(), &watch)?;
    if let Some(study) = &found.study {
        let page = report::study::report(study)?;
        write_whole(&out.path().join(REPORT_FILE), page.html.as_bytes())?;
    }
    out.commit()?;
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
        let _ = writeln!(said, "  {} tasks have no result: the curves are of the others, with bounds", found.missing);
    }
    if found.damaged > 0 {
        let _ = writeln!(said, "  {} of them have a damaged one, which `study check` names", found.damaged);
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
fn curves(found: &merged::Merged) -> [[usize; 2]; 2] {
    let count = |curves: &[results::StudyCurve]| {
        let fitted = curves.iter().filter(|curve| curve.fit.is_some());
        [fitted.count(), curves.len()]
    };
    let study = found.study.as_ref();
    [study.map_or([0; 2], |study| count(&study.curves)), study.map_or([0; 2], |study| count(&study.system))]
}

/// Runs the worst row of each tank again, with all that `compare` writes.
fn keep_worst(folder: &Path, plan: &Plan, found: &merged::Merged, global: &Global) -> Result<(), Error> {
    let study = study_of(folder, plan)?;
    for (tank, row) in &found.worst {
        let started = Instant::now();
        let watch = Watch::new(global, "worst rows");
        let mut outcome = keep::run(&study, plan, tank, row, &watch)?;
        outcome.results.volatile = stamp(started);
        let home = folder.join(KEPT);
        std::fs::create_dir_all(&home).map_err(|e| {
            Error::Files(files::error::Error::Unwritten { path: home.clone(), what: files::error::describe(&e) })
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
