//! `tankcheck schema`: the JSON Schema of the tank file, or its reference page.

use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use crate::input::tank;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck schema > tank.schema.json
  tankcheck schema --markdown > input.md

Add \"$schema\": \"./tank.schema.json\" to tank.json for completion and checks in an editor.")]
pub(crate) struct Args {
    /// Write the reference page of all keys in Markdown instead.
    #[arg(long)]
    markdown: bool,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    match args.markdown {
        true => print(&tank::markdown())?,
        false => print(&format!("{:#}\n", tank::json_schema()))?,
    }
    Ok(EXIT_OK)
}
