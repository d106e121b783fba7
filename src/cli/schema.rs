//! `tankcheck schema`: the JSON Schema of the tank, study or set file, or the reference page.

use crate::cli::Global;
use crate::cli::outfile::OutFile;
use crate::error::{EXIT_OK, Error};
use crate::input::{set, study, tank};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck schema --out tank.schema.json
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
    #[command(flatten)]
    out: OutFile,
    /// Write the schema of set.json.
    #[arg(long, conflicts_with = "markdown")]
    set: bool,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let text = match (args.markdown, args.study, args.set) {
        (true, _, _) => tank::markdown(),
        (_, true, _) => format!("{:#}\n", study::json_schema()),
        (_, _, true) => format!("{:#}\n", set::json_schema()),
        (false, false, false) => format!("{:#}\n", tank::json_schema()),
    };
    args.out.put(&text)?;
    Ok(EXIT_OK)
}
