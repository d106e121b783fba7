//! `tankcheck schema`: the JSON Schema of the tank, study or set file, or the reference page.

use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use crate::input::{set, study, tank};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck schema > tank.schema.json
  tankcheck schema --markdown > input.md
  tankcheck schema --study > study.schema.json
  tankcheck schema --set > set.schema.json

Add \"$schema\": \"./tank.schema.json\" to tank.json for completion and checks in an editor.")]
pub(crate) struct Args {
    /// Write the reference page of all keys in Markdown instead.
    #[arg(long)]
    markdown: bool,
    /// Write the schema of study.json.
    #[arg(long, conflicts_with_all = ["markdown", "set"])]
    study: bool,
    /// Write the schema of set.json.
    #[arg(long, conflicts_with = "markdown")]
    set: bool,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    match (args.markdown, args.study, args.set) {
        (true, _, _) => print(&tank::markdown())?,
        (_, true, _) => print(&format!("{:#}\n", study::json_schema()))?,
        (_, _, true) => print(&format!("{:#}\n", set::json_schema()))?,
        (false, false, false) => print(&format!("{:#}\n", tank::json_schema()))?,
    }
    Ok(EXIT_OK)
}
