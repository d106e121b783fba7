//! `tankcheck verify`: the benchmarks of the verification manual.

use std::path::PathBuf;

use fem::progress::Progress;

use crate::cli::progress::Watch;
use crate::cli::table::Table;
use crate::cli::{Global, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::verify::{self, Choice, Entry, Manual, Pace, manual};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck verify
  tankcheck verify --format html > verification.html
  tankcheck verify --records ~/records          also the rows that need records that may not be redistributed
  tankcheck verify --slow                       also the rows that take minutes
  tankcheck verify --write docs/verification    write the manual: index, and one page and figure per benchmark

Exit codes: 0 every row that ran is within its tolerance; 1 one is not; 2 bad input; 3 the computation failed.")]
pub struct Args {
    /// Folder with accelerograms (imperial-valley-1940-el-centro-ns.csv, …).
    #[arg(long, value_name = "FOLDER")]
    records: Option<PathBuf>,
    /// Also run the rows that take minutes.
    #[arg(long)]
    slow: bool,
    /// Write the manual into this folder; rows that do not run keep their last result there.
    #[arg(long, short, alias = "out", value_name = "FOLDER")]
    write: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
}

/// Form of the output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// A table for people.
    Human,
    /// JSON.
    Json,
    /// Comma-separated values.
    Csv,
    /// One page with one sheet per benchmark.
    Html,
}

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    if let Some(folder) = args.records.as_ref().filter(|folder| !folder.is_dir()) {
        return Err(Error::Files(files::error::Error::File {
            path: folder.clone(),
            what: "folder not found, expected a folder with accelerograms".into(),
        }));
    }
    let choice = Choice {
        records: args.records.as_deref(),
        slow: args.slow,
    };
    let watch = Watch::new(global, "benchmarks");
    watch.stage("benchmarks", verify::topics(choice));
    let found = verify::run(choice, &|topic| {
        watch.name(topic);
        watch.advance(1);
    })?;
    watch.finish();
    if let Some(folder) = &args.write {
        let kept = if folder.join(manual::ROWS).exists() {
            manual::read(folder)?
        } else {
            Vec::new()
        };
        let ran = |pace| match pace {
            Pace::Fast => true,
            Pace::Tested | Pace::Slow => choice.slow,
            Pace::Record => choice.records.is_some(),
        };
        let merged = manual::merge(&found.rows, &kept, ran);
        let dissertation = match (args.slow, &args.records) {
            (true, Some(records)) => Some(verify::dissertation::document(records)?),
            _ => None,
        };
        manual::write(folder, &merged, dissertation)?;
    }
    let failed = found.rows.iter().filter(|r| r.fails()).count();
    match args.format {
        Form::Json => print(&format!("{:#}\n", manual::to_json(&found)))?,
        Form::Csv => print(&csv(&found))?,
        Form::Html => print(&verify::html::html(&found)?)?,
        Form::Human => print(&human(&found, failed))?,
    }
    Ok(if failed == 0 { EXIT_OK } else { EXIT_CHECK_FAILED })
}

fn human(found: &Manual, failed: usize) -> String {
    let mut table = Table::new(["row", "what", "reference", "computed", "error", "tolerance", "kind", ""]);
    for row in &found.rows {
        let state = match (row.fails(), row.compares()) {
            (true, _) => "OUTSIDE",
            (_, true) => "comparison",
            _ => "ok",
        };
        table.row(manual::cells(row).into_iter().chain([state.to_string()]));
    }
    let mut text = format!("{table}\n");
    for n in &found.not_run {
        text.push_str(&format!("{}: not run: {} (needs {})\n", n.id, n.what, n.needs));
    }
    let counted = found.rows.iter().filter(|r| r.counts()).count();
    text.push_str(&format!(
        "{} rows ({counted} count as verification), {failed} outside their tolerance, {} not run\n",
        found.rows.len(),
        found.not_run.len()
    ));
    text
}

fn csv(found: &Manual) -> String {
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
    let line = |row: &Entry| {
        format!(
            "{},\"{}\",{:e},{},{},{},{},{}\n",
            row.id,
            row.what.replace('"', "\"\""),
            row.reference,
            number(row.computed),
            number(row.computed.map(|_| row.error())),
            number(row.tolerance),
            row.unit,
            row.kind
        )
    };
    let lines = found.rows.iter().map(line).collect::<String>();
    format!("id,what,reference,computed,error,tolerance,unit,kind\n{lines}")
}
