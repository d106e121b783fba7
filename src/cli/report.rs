//! `tankcheck report`: render the report of a results folder again, without computing.

use std::path::PathBuf;

use crate::cli::terminal::say;
use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use files::{self, OutputFolder};
use report;
use results::{COMPARE_REPORT, REPORT_FILE};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  tankcheck report out/\n  tankcheck report out/ --templates our-letterhead/")]
pub(crate) struct Args {
    /// Results folder written by `tankcheck compare` or `tankcheck check`.
    folder: PathBuf,
    /// Folder of templates that replace the built-in ones of the same name (report.html, style.css, sections/….html).
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _global: &Global) -> Result<u8, Error> {
    for name in files::edited(&args.folder, COMPARE_REPORT) {
        say!("warning: {name} has changed since tankcheck wrote it; the report shows the changed file");
    }
    let report = report::of_folder(&args.folder, args.templates.as_deref())?;
    let folder = OutputFolder::prepare(&args.folder, COMPARE_REPORT)?;
    report.write(&folder.path())?;
    folder.commit()?;
    print(&format!("{}\n", args.folder.join(REPORT_FILE).display()))?;
    Ok(EXIT_OK)
}
