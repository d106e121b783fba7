//! `tankcheck compare`: codes and finite elements side by side.

use std::path::{Path, PathBuf};
use std::time::Instant;

use codes::procedure::Excitation;
use codes::units;

use crate::cli::inputs::Inputs;
use crate::cli::table::Table;
use crate::cli::{Format, Global};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::fe::Integrator;
use crate::pipeline::{self, OutputFolder};
use crate::report;
use crate::results::{self, Method, Results, Series, Status};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck compare tank.json --quake elcentro.csv --out out/
  tankcheck compare tank.json --quake ns.at2 --vertical up.at2 --out out/
  tankcheck compare tank.json --quake rec.txt --units g --integrator newmark --out out/

Exit codes: 0 every check holds; 1 a check fails; 2 bad input; 3 the computation failed.")]
pub struct Args {
    #[command(flatten)]
    inputs: Inputs,
    /// Folder for report.html, results.json, series.csv and figures/.
    #[arg(long, short, value_name = "FOLDER", default_value = "out")]
    out: PathBuf,
    /// Finite-element engine.
    #[arg(long, value_enum, default_value_t = Engine::Harmonic)]
    fe: Engine,
    /// Time integration [default: modal, or as in the tank file].
    #[arg(long, value_enum)]
    integrator: Option<IntegratorArg>,
    /// Multiply every element count of the default mesh, 0.25 to 16.
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    refine: Option<f64>,
    /// Leave out the second, coarser mesh that estimates the discretisation error.
    #[arg(long)]
    no_mesh_error: bool,
    /// Folder whose files replace the built-in report templates.
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
    /// Form of the summary on standard output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Finite-element engine.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Engine {
    /// One Fourier harmonic at a time: potential liquid and shell of revolution (linear).
    Harmonic,
    /// No engine: the codes alone.
    None,
}

/// Time integration.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum IntegratorArg {
    /// Exact piecewise-linear modal integration with missing mass.
    Modal,
    /// Direct Newmark on all unknowns, with energy balance.
    Newmark,
}

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    if args.inputs.quake.is_none() {
        return Err(Error::Input(
            "error: no ground motion\n  help: give a record with --quake, or run `tankcheck check` for the codes alone"
                .into(),
        ));
    }
    let mut job = args.inputs.job()?;
    match (&mut job.fe, args.fe) {
        (fe, Engine::None) => *fe = None,
        (Some(options), Engine::Harmonic) => {
            if let Some(refine) = args.refine {
                options.refine = refine;
            }
            options.mesh_error &= !args.no_mesh_error;
            match args.integrator {
                Some(IntegratorArg::Modal) => options.integrator = Integrator::Modal,
                Some(IntegratorArg::Newmark) => options.integrator = Integrator::Newmark,
                None => {}
            }
        }
        (None, Engine::Harmonic) => {}
    }
    let folder = OutputFolder::prepare(&args.out)?;
    let spinner = super::spinner(global, "codes and finite elements");
    let (mut results, series) = pipeline::run(&job)?;
    stamp(&mut results, started);
    write(&folder, &results, &series, args.templates.as_deref())?;
    folder.commit()?;
    spinner.finish_and_clear();
    print(&results, Some(&args.out), args.format, global)?;
    Ok(if results.verdict.holds {
        EXIT_OK
    } else {
        EXIT_CHECK_FAILED
    })
}

/// Fills in what differs between identical runs.
pub fn stamp(results: &mut Results, started: Instant) {
    results.volatile.created = jiff::Timestamp::now().to_string();
    // The name of the command, not where this machine keeps it.
    let arguments = std::env::args().skip(1);
    results.volatile.command = std::iter::once("tankcheck".to_string())
        .chain(arguments)
        .collect::<Vec<_>>()
        .join(" ");
    results.volatile.seconds = started.elapsed().as_secs_f64();
}

fn write(folder: &OutputFolder, results: &Results, series: &Series, templates: Option<&Path>) -> Result<(), Error> {
    results::write(folder.path(), results, series)?;
    report::render(folder.path(), templates).map(|_| ())
}

/// Prints the summary.
pub fn print(results: &Results, out: Option<&Path>, format: Format, global: &Global) -> Result<(), Error> {
    match format {
        Format::Json => {
            let text = serde_json::to_string_pretty(results).map_err(|e| Error::Report(e.to_string()))?;
            anstream::println!("{text}");
        }
        Format::Csv => print_csv(results),
        Format::Human => {
            for excitation in [Excitation::Record, Excitation::Site] {
                print_table(results, excitation);
            }
            print_verdict(results);
        }
    }
    if let (Some(out), false) = (out, global.quiet) {
        anstream::eprintln!("report: {}", out.join("report.html").display());
    }
    Ok(())
}

/// Quantity × method for one excitation, values with their ratio to the engine.
fn print_table(results: &Results, excitation: Excitation) {
    let shown = |m: &Method| m.excitation == excitation && !m.quantities.is_empty();
    let columns: Vec<usize> = results
        .methods
        .iter()
        .enumerate()
        .filter(|(_, m)| shown(m))
        .map(|(i, _)| i)
        .collect();
    if columns.is_empty() {
        return;
    }
    let corner = match excitation {
        Excitation::Record => "record spectrum / history (ratio to fe)",
        Excitation::Site => "design spectrum of the site (ratio to fe under the record)",
    };
    let head = std::iter::once(corner).chain(columns.iter().map(|&i| results.methods[i].id.as_str()));
    let mut table = Table::new(head);
    for row in &results.comparison.rows {
        let values: Vec<f64> = columns.iter().filter_map(|&i| row.cells[i].map(|c| c.value)).collect();
        if values.is_empty() {
            continue;
        }
        let unit = units::column_unit(values, row.dimension);
        let cells = columns.iter().map(|&i| match row.cells[i] {
            None => "–".to_string(),
            Some(cell) => {
                let value = units::significant(units::in_unit(cell.value, unit), 3);
                match cell.ratio {
                    Some(ratio) => format!("{value} ({ratio:.2})"),
                    None => value,
                }
            }
        });
        let title = format!("{} [{}]", row.title, unit.symbol);
        table.row(std::iter::once(title).chain(cells));
    }
    anstream::println!("{table}");
    for method in results.methods.iter().filter(|m| m.excitation == excitation) {
        if let Status::NotApplicable { clause, reason } = &method.status {
            anstream::println!("{}: not applicable, {clause}: {reason}", method.id);
        }
    }
}

fn print_csv(results: &Results) {
    anstream::println!("method,excitation,quantity,value,unit,ratio_to_fe");
    for row in &results.comparison.rows {
        for (method, cell) in results.methods.iter().zip(&row.cells) {
            let Some(cell) = cell else { continue };
            let excitation = match method.excitation {
                Excitation::Record => "record",
                Excitation::Site => "site",
            };
            let ratio = cell.ratio.map_or(String::new(), |r| format!("{r:.6}"));
            anstream::println!(
                "{},{excitation},{},{:e},{},{ratio}",
                method.id,
                row.quantity,
                cell.value,
                row.dimension.si_symbol()
            );
        }
    }
}

fn print_verdict(results: &Results) {
    let verdict = &results.verdict;
    if let Some(governing) = &verdict.governing {
        let state = if verdict.holds { "all hold" } else { "NOT all hold" };
        let excitation = match governing.excitation {
            Excitation::Record => "record",
            Excitation::Site => "site",
        };
        anstream::println!(
            "{} checks, {} fail: {state}; governing: {} ({}, {excitation}), utilisation {:.2}",
            verdict.checks,
            verdict.failed,
            governing.check.name,
            governing.method,
            governing.check.utilisation
        );
    }
    if let Some(fe) = &results.fe {
        for limit in fe.limits.iter().filter(|l| !l.holds) {
            anstream::println!("warning: {}: {}", limit.name, limit.note);
        }
    }
}
