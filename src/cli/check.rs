//! `tankcheck check`: the code procedures alone.

use std::time::Instant;

use fem::progress::Silent;

use crate::cli::inputs::Inputs;
use crate::cli::{Format, Global, compare, print, wall};
use crate::error::Error;
use crate::pipeline::{self, Outcome};
use files::OutputFolder;
use report;
use results::{self, COMPARE};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck check tank.json                       design spectra of the tank's `site`
  tankcheck check tank.json --quake elcentro.csv  also the spectrum of a record
  tankcheck check tank.json --procedures api650-2020 --format json

Exit codes: 0 everything required was checked and holds; 1 a check fails; 2 bad input; 3 the computation failed;
4 something required was not checked, or nothing was assessed.")]
pub(crate) struct Args {
    #[command(flatten)]
    inputs: Inputs,
    /// Also write a report (without finite elements) into this folder.
    #[arg(long, short, value_name = "FOLDER")]
    out: Option<std::path::PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let job = args.inputs.job(|_| Vec::new())?;
    let site = &job.case.site;
    if job.case.ground_motion.is_none() && site.ec8.is_none() && site.api650.is_none() {
        return Err(Error::input(
            "error: the ground motion is missing\n  help: add `site` to the tank file (design spectra), or give a record \
             with --quake"
                .into(),
        ));
    }
    let folder = args
        .out
        .as_deref()
        .map(|out| OutputFolder::prepare(out, COMPARE))
        .transpose()?;
    let Outcome {
        mut results, series, ..
    } = pipeline::run(&job, &Silent)?;
    compare::stamp(&mut results, started);
    if let Some(folder) = folder {
        results::write(&folder.path(), &results, &series)?;
        report::render(&folder.path(), None)?;
        folder.commit()?;
    }
    if args.format == Format::Human {
        for line in wall::lines(&job.case.tank) {
            print(&format!("{line}\n"))?;
        }
    }
    compare::print(&results, args.out.as_deref(), args.format, global)?;
    Ok(compare::exit_code(&results.verdict))
}
