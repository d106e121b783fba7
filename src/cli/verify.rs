//! `tankcheck verify`: the benchmarks of the verification manual.

use std::path::PathBuf;

use crate::cli::table::Table;
use crate::cli::{Format, Global};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::results::describe;
use crate::verify::{self, manual};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck verify
  tankcheck verify --records ~/records       also the rows that need records which may not be redistributed
  tankcheck verify --out docs/verification   write the manual and its figure

Exit codes: 0 every row that ran is within its tolerance; 1 one is not; 2 bad input; 3 the computation failed.")]
pub struct Args {
    /// Folder with accelerograms (imperial-valley-1940-el-centro-ns.csv, …).
    #[arg(long, value_name = "FOLDER")]
    records: Option<PathBuf>,
    /// Write manual.md and convergence.svg into this folder.
    #[arg(long, short, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Name of the convergence figure.
const FIGURE: &str = "convergence.svg";

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    if let Some(folder) = args.records.as_ref().filter(|folder| !folder.is_dir()) {
        return Err(Error::File {
            path: folder.clone(),
            what: "no such folder, expected one with accelerograms".into(),
        });
    }
    let spinner = super::spinner(global, "benchmarks");
    let found = verify::run(args.records.as_deref())?;
    spinner.finish_and_clear();
    if let Some(folder) = &args.out {
        let fault = |e: std::io::Error| Error::File {
            path: folder.clone(),
            what: describe(&e),
        };
        std::fs::create_dir_all(folder).map_err(fault)?;
        std::fs::write(folder.join("manual.md"), manual::to_markdown(&found, FIGURE)).map_err(fault)?;
        std::fs::write(folder.join(FIGURE), manual::convergence_figure(&found)?).map_err(fault)?;
    }
    match args.format {
        Format::Json => anstream::println!("{:#}", manual::to_json(&found)),
        Format::Csv => {
            anstream::println!("id,what,reference,computed,error,tolerance,unit");
            for row in &found.rows {
                let m = &row.measured;
                anstream::println!(
                    "{},\"{}\",{:e},{:e},{:e},{:e},{}",
                    m.id,
                    m.what,
                    m.reference,
                    m.computed,
                    m.error(),
                    m.tolerance,
                    m.unit
                );
            }
        }
        Format::Human => {
            let mut table = Table::new(["row", "what", "reference", "computed", "error", "tolerance", "kind", ""]);
            for row in &found.rows {
                let state = if row.measured.holds() { "ok" } else { "OUTSIDE" };
                table.row(manual::cells(row).into_iter().chain([state.to_string()]));
            }
            anstream::println!("{table}");
            for n in &found.not_run {
                anstream::println!("{}: not run: {} (needs {})", n.id, n.what, n.needs);
            }
        }
    }
    let failed = found.rows.iter().filter(|r| !r.measured.holds()).count();
    if args.format == Format::Human {
        anstream::println!(
            "{} rows, {failed} outside their tolerance, {} not run",
            found.rows.len(),
            found.not_run.len()
        );
    }
    Ok(if failed == 0 { EXIT_OK } else { EXIT_CHECK_FAILED })
}
