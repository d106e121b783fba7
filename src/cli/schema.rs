//! `tankcheck schema`: the JSON Schema of the tank file.

use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck schema > tank.schema.json

With \"$schema\": \"./tank.schema.json\" in tank.json an editor completes and explains the keys.")]
pub struct Args {}

/// Runs the subcommand; returns the exit code.
pub fn run(_: Args, _: &Global) -> Result<u8, Error> {
    print(&format!("{:#}\n", crate::input::tank::json_schema()))?;
    Ok(EXIT_OK)
}
