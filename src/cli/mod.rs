//! The command line: one file a subcommand.
//!
//! Results go to standard output, messages and progress to standard error. Exit codes: see [`crate::error`].

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use crate::error::Error;
use crate::results::Volatile;

mod check;
mod compare;
mod completions;
mod diff;
mod ida;
mod init;
mod inputs;
mod modes;
mod nonlinear;
mod progress;
mod push;
mod quake;
mod report;
mod schema;
mod solid;
mod spectrum;
mod table;
mod verify;
mod wall;

/// Seismic verification of liquid storage tanks.
#[derive(Parser)]
#[command(name = "tankcheck", version, about, after_help = EXAMPLES, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    global: Global,
}

/// Options of every subcommand.
#[derive(clap::Args, Clone, Debug)]
pub struct Global {
    /// When to colour messages.
    #[arg(long, global = true, value_enum, default_value_t = When::Auto)]
    pub color: When,
    /// No progress and no hints on standard error.
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

/// When to colour.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// Form of the output on standard output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table for people.
    Human,
    /// JSON in SI units.
    Json,
    /// Comma-separated values in SI units, where the result is a table.
    Csv,
}

#[derive(Subcommand)]
enum Command {
    /// Codes and finite elements side by side: the verification report.
    Compare(compare::Args),
    /// The code procedures alone.
    Check(check::Args),
    /// Incremental dynamic analysis: nonlinear runs at rising scales of a record.
    Ida(ida::Args),
    /// Pushover of an anchored cylinder until its wall buckles.
    Push(push::Args),
    /// Coupled modes of tank and liquid.
    Modes(modes::Args),
    /// Response spectra of a record.
    Spectrum(spectrum::Args),
    /// Look at an accelerogram.
    Quake(quake::Args),
    /// Render the report of a results folder again.
    Report(report::Args),
    /// Compare two results folders number by number.
    Diff(diff::Args),
    /// Run the benchmarks of the verification manual.
    Verify(verify::Args),
    /// Write a commented tank.json to start from.
    Init(init::Args),
    /// Print the JSON Schema of tank.json.
    Schema(schema::Args),
    /// Print shell completions or the manual page.
    Completions(completions::Args),
}

const EXAMPLES: &str = "\
Examples:
  tankcheck init > tank.json
  tankcheck compare tank.json --quake elcentro.csv --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe both --mesh 12x16x20 --vtu paraview/ --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/
  tankcheck ida tank.json --quake elcentro.csv --scale 0..1.1 --steps 12 --out ida/
  tankcheck push tank.json --imperfection 0.5t --out push/
  tankcheck check tank.json
  tankcheck modes tank.json --format json
  tankcheck spectrum elcentro.csv --damping 0.5%,2%,5% --periods 0.02..20
  tankcheck quake info elcentro.csv
  tankcheck diff golden/ out/

Exit codes: 0 done and every check holds; 1 a check fails or diff found a change; 2 bad input or usage;
3 the computation failed or was interrupted, or the tank collapsed.";

/// A spinner on standard error while `what` is computed; invisible unless a person watches a terminal.
pub(crate) fn spinner(global: &Global, what: &'static str) -> indicatif::ProgressBar {
    if global.quiet {
        return indicatif::ProgressBar::hidden();
    }
    // `new_spinner` draws to standard error and hides itself where that is no terminal.
    let spinner = indicatif::ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(std::time::Duration::from_millis(100));
    spinner
}

/// The command line as data, for completions and the manual page.
pub(crate) fn command() -> clap::Command {
    Cli::command()
}

/// Writes a result to standard output. A reader that has seen enough (`| head`) is no failure.
pub(crate) fn print(text: &str) -> Result<(), Error> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Error::File {
            path: "<stdout>".into(),
            what: format!("cannot be written ({error})"),
        }),
        _ => Ok(()),
    }
}

/// What differs between identical runs.
pub(crate) fn stamp(started: std::time::Instant) -> Volatile {
    Volatile {
        version: env!("CARGO_PKG_VERSION").into(),
        created: jiff::Timestamp::now().to_string(),
        command: std::iter::once("tankcheck".to_owned())
            .chain(std::env::args().skip(1))
            .collect::<Vec<_>>()
            .join(" "),
        seconds: started.elapsed().as_secs_f64(),
    }
}

/// Entry point of the binary.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    match cli.global.color {
        When::Auto => {}
        When::Always => anstream::ColorChoice::Always.write_global(),
        When::Never => anstream::ColorChoice::Never.write_global(),
    }
    let outcome: Result<u8, Error> = match cli.command {
        Command::Compare(args) => compare::run(args, &cli.global),
        Command::Check(args) => check::run(args, &cli.global),
        Command::Ida(args) => ida::run(args, &cli.global),
        Command::Push(args) => push::run(args, &cli.global),
        Command::Modes(args) => modes::run(args, &cli.global),
        Command::Spectrum(args) => spectrum::run(args, &cli.global),
        Command::Quake(args) => quake::run(args, &cli.global),
        Command::Report(args) => report::run(args, &cli.global),
        Command::Diff(args) => diff::run(args, &cli.global),
        Command::Verify(args) => verify::run(args, &cli.global),
        Command::Init(args) => init::run(args, &cli.global),
        Command::Schema(args) => schema::run(args, &cli.global),
        Command::Completions(args) => completions::run(args, &cli.global),
    };
    match outcome {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            match &error {
                Error::Input(rendered) => anstream::eprintln!("{}", rendered.trim_end()),
                other => anstream::eprintln!("error: {other}"),
            }
            ExitCode::from(error.exit_code())
        }
    }
}
