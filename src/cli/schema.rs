//! `tankcheck schema`: the JSON Schema of the tank file or the study file, or the reference page.

use crate::cli::Global;
use crate::cli::outfile::OutFile;
use crate::error::{EXIT_OK, Error};
use crate::input::{study, tank};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck schema --out tank.schema.json
  tankcheck schema --markdown > input.md
  tankcheck schema --study > study.schema.json

Add \"$schema\": \"./tank.schema.json\" to tank.json for completion and checks in an editor.")]
pub(crate) struct Args {
    /// Write the reference page of all keys in Markdown instead.
    #[arg(long)]
    markdown: bool,
    /// Write the schema of study.json.
    #[arg(long, conflicts_with = "markdown")]
    study: bool,
    #[command(flatten)]
    out: OutFile,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let text = match (args.markdown, args.study) {
        (true, _) => tank::markdown(),
        (false, true) => format!("{:#}\n", study::json_schema()),
        (false, false) => format!("{:#}\n", tank::json_schema()),
    };
    args.out.put(&text)?;
    Ok(EXIT_OK)
}
