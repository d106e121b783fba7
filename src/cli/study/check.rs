//! `tankcheck study check`: what is damaged, and what is not.

use std::fmt::Write;

use super::status::StatusArgs;
use crate::cli::progress::Watch;
use crate::cli::{Format, Global, json, print};
use crate::error::{EXIT_COMPUTATION, EXIT_OK, Error};
use crate::study::check::{self, Checked};
use crate::study::folder;
use files::text;

/// Damaged files that are printed.
const PRINTED: usize = 50;

pub(super) fn check(args: &StatusArgs, global: &Global) -> Result<u8, Error> {
    if args.format == Format::Csv {
        return Err(Error::conflict("--format: found csv, expected human or json"));
    }
    let (plan, tasks) = folder::read(&args.folder)?;
    let watch = Watch::new(global, "checking");
    let found = check::check(&args.folder, (&plan, &tasks), &watch);
    watch.finish();
    match args.format {
        Format::Json => print(&json(&found)?)?,
        _ => print(&human(&plan.name, &found))?,
    }
    Ok(if found.damaged.is_empty() { EXIT_OK } else { EXIT_COMPUTATION })
}

fn human(name: &str, found: &Checked) -> String {
    let mut said = format!("{}\n", text::line(name));
    for (what, count, remark) in [
        ("tasks", found.tasks, ""),
        ("sound", found.sound, "read whole, and the rows of the plan"),
        ("missing", found.missing, ""),
        ("failed", found.failed, "`study run --retry` computes them again"),
        ("damaged", found.damaged.len(), "`study run` computes results again, `study merge` tables"),
        ("earlier", found.of_earlier_plans, "results of no task of this plan, which nothing reads"),
    ] {
        let remark = if count > 0 { remark } else { "" };
        let _ = writeln!(said, "  {}", format!("{what:<9}{count:>9}  {remark}").trim_end());
    }
    for damage in found.damaged.iter().take(PRINTED) {
        let task = damage.task.map_or(String::new(), |task| format!("task {task}: "));
        let _ = writeln!(said, "  {task}{} {}", text::line(&damage.file), text::line(&damage.what));
    }
    if found.damaged.len() > PRINTED {
        let _ = writeln!(said, "  and {} more", found.damaged.len() - PRINTED);
    }
    for folder in &found.unmarked {
        let _ = writeln!(
            said,
            "  {} has no marker of tankcheck, and stays: remove it if it is not yours",
            text::line(folder)
        );
    }
    said
}
