//! `tankcheck diff`: two results folders, number by number.

use std::path::{Path, PathBuf};

use serde_json::json;

use crate::cli::{Format, Global};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::numdiff::{self, Options, Report};
use crate::results::{self, describe};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck diff reports/01_broad_tank out/
  tankcheck diff golden/ out/ --rtol 1e-4 --format json
  tankcheck diff golden/ out/ --bless --reason \"finer mesh at the base by default\"

Exit codes: 0 the same within tolerance; 1 something moved; 2 bad input.")]
pub struct Args {
    /// The accepted results folder.
    old: PathBuf,
    /// The new results folder.
    new: PathBuf,
    /// Tolerance relative to the peak of each quantity.
    #[arg(long, default_value_t = Options::default().rtol)]
    rtol: f64,
    /// Tolerance for the time of a maximum [s].
    #[arg(long, default_value_t = Options::default().time_tolerance)]
    time_tolerance: f64,
    /// Accept NEW: copy it over OLD and keep the reason in OLD/accepted.json.
    #[arg(long, requires = "reason")]
    bless: bool,
    /// Why the numbers may move.
    #[arg(long)]
    reason: Option<String>,
    /// Most rows to print.
    #[arg(long, default_value_t = 30)]
    most: usize,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// File of a golden folder that keeps why it was accepted.
const ACCEPTED_FILE: &str = "accepted.json";

/// Runs the subcommand; returns the exit code.
pub fn run(args: Args, global: &Global) -> Result<u8, Error> {
    for (name, value) in [("--rtol", args.rtol), ("--time-tolerance", args.time_tolerance)] {
        if !(value.is_finite() && value >= 0.0) {
            return Err(Error::Input(format!(
                "error: {name}: found {value}, allowed a number ≥ 0"
            )));
        }
    }
    let options = Options {
        rtol: args.rtol,
        time_tolerance: args.time_tolerance,
    };
    if args.bless && !args.old.exists() {
        results::read(&args.new)?;
        bless(&args, &Report::default())?;
        return Ok(EXIT_OK);
    }
    let report = numdiff::folders(&args.old, &args.new, &options)?;
    match args.format {
        Format::Json => print_json(&report),
        Format::Human => print_human(&report, args.most),
        Format::Csv => print_csv(&report),
    }
    if args.bless {
        bless(&args, &report)?;
        if !global.quiet {
            anstream::eprintln!("accepted: {} now holds the new results", args.old.display());
        }
        return Ok(EXIT_OK);
    }
    Ok(if report.moved.is_empty() {
        EXIT_OK
    } else {
        EXIT_CHECK_FAILED
    })
}

fn print_human(report: &Report, most: usize) {
    let outcome = match (report.moved.len(), report.drifted) {
        (0, 0) => "same".to_string(),
        (0, drifted) => format!(
            "same within tolerance: {drifted} drifted, at most {:.1e}",
            report.largest_drift
        ),
        (moved, _) => format!("{moved} moved"),
    };
    anstream::println!("{outcome} ({} values compared)", report.compared);
    for d in report.moved.iter().take(most) {
        if d.change.is_finite() {
            anstream::println!("  {}: {} -> {} ({:.2e} of its peak)", d.path, d.old, d.new, d.change);
        } else {
            anstream::println!("  {}: {} -> {}", d.path, d.old, d.new);
        }
    }
    if report.moved.len() > most {
        anstream::println!(
            "  (+{} more; --most {} shows all)",
            report.moved.len() - most,
            report.moved.len()
        );
    }
}

fn print_json(report: &Report) {
    let moved: Vec<_> = report
        .moved
        .iter()
        .map(
            |d| json!({"path": d.path, "old": d.old, "new": d.new, "change": d.change.is_finite().then_some(d.change)}),
        )
        .collect();
    anstream::println!(
        "{:#}",
        json!({"compared": report.compared, "drifted": report.drifted, "largest_drift": report.largest_drift, "moved": moved})
    );
}

fn print_csv(report: &Report) {
    anstream::println!("path,old,new,change");
    for d in &report.moved {
        let quote = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        anstream::println!("{},{},{},{:e}", quote(&d.path), quote(&d.old), quote(&d.new), d.change);
    }
}

/// Copies NEW over OLD and appends the reason with what moved to `accepted.json`.
fn bless(args: &Args, report: &Report) -> Result<(), Error> {
    let file = |path: &Path, e: std::io::Error| Error::File {
        path: path.into(),
        what: describe(&e),
    };
    let accepted = args.old.join(ACCEPTED_FILE);
    let mut history: Vec<serde_json::Value> = match std::fs::read_to_string(&accepted) {
        Ok(text) => serde_json::from_str(&text).map_err(|e| Error::File {
            path: accepted.clone(),
            what: format!("not a list of acceptances: {e}"),
        })?,
        Err(_) => Vec::new(),
    };
    history.push(json!({
        "reason": args.reason,
        "moved": report.moved.len(),
        "largest": report.moved.iter().take(5)
            .map(|d| format!("{}: {} -> {}", d.path, d.old, d.new)).collect::<Vec<_>>(),
    }));
    std::fs::create_dir_all(&args.old).map_err(|e| file(&args.old, e))?;
    crate::pipeline::copy_results(&args.new, &args.old)?;
    let text = format!("{:#}\n", serde_json::Value::Array(history));
    std::fs::write(&accepted, text).map_err(|e| file(&accepted, e))
}
