//! `tankcheck spectrum`.

use crate::cli::Global;
use crate::error::{EXIT_COMPUTATION, Error};

/// Arguments.
#[derive(clap::Args)]
pub struct Args {}

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let _ = (args, global);
    Ok(EXIT_COMPUTATION)
}
