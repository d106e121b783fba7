//! `tankcheck report`: render the report of a results folder again, without computing.

use std::path::PathBuf;

use crate::cli::Global;
use crate::error::{EXIT_OK, Error};
use crate::report;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  tankcheck report out/\n  tankcheck report out/ --templates our-letterhead/")]
pub struct Args {
    /// Results folder, as `tankcheck compare` or `tankcheck check` wrote it.
    folder: PathBuf,
    /// Folder of templates that replace the built-in ones of the same name (report.html, style.css, sections/….html).
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
}

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, _global: &Global) -> Result<u8, Error> {
    let path = report::render(&args.folder, args.templates.as_deref())?;
    anstream::println!("{}", path.display());
    Ok(EXIT_OK)
}
