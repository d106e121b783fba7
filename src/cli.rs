//! The command line: one file per subcommand.
//!
//! Results go to standard output, messages and progress to standard error. Exit codes: see [`crate::error`].

use std::io::Write;
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use crate::error::{EXIT_INPUT, EXIT_OK, Error};
use files::code::Code;
use files::text;
use terminal::say;

mod base;
mod browser;
mod budget;
mod check;
mod checks;
mod compare;
mod completions;
mod desk;
mod diff;
mod explain;
mod fault;
mod findings;
mod fragility;
mod global;
mod ida;
mod init;
mod inputs;
mod modes;
mod nonlinear;
mod outfile;
mod pdf;
mod progress;
mod push;
mod quake;
mod record_set;
mod report;
mod schema;
mod select;
mod set_table;
mod solid;
mod solve;
mod spectrum;
mod study;
mod style;
mod table;
mod tanks;
mod templates;
mod terminal;
mod verify;
mod wall;

pub use global::{Format, Global, When};
pub(crate) use global::{json, no_csv, show, spinner, stamp};
pub(crate) use terminal::print;

/// Seismic verification of liquid storage tanks.
#[derive(Parser)]
#[command(name = "tankcheck", version, about, after_help = EXAMPLES, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    global: Global,
}

#[derive(Subcommand)]
enum Command {
    /// Compare codes and finite elements; write the verification report.
    Compare(Box<compare::Args>),
    /// Run the code procedures without finite elements.
    Check(check::Args),
    /// Run an incremental dynamic analysis: nonlinear runs at increasing scales of a record.
    Ida(ida::Args),
    /// Push a cylinder until its wall buckles or its base turns over.
    Push(push::Args),
    /// Many tanks under many records: plan, run, merge.
    Study(study::Args),
    /// Fit fragility curves to data, and compute the risk that follows.
    Fragility(fragility::Args),
    /// Compute uplift of the bottom plate and the moment that the base of a tank holds, statically.
    Base(base::Args),
    /// Compute the coupled modes of tank and liquid.
    Modes(modes::Args),
    /// Compute the response spectra of a record.
    Spectrum(spectrum::Args),
    /// Accelerograms: properties, conversion, sets, synthetic and harmonic motion.
    Quake(quake::Args),
    /// Open a page in the browser to enter, check, run and look at tanks.
    Desk(desk::Args),
    /// Render the report of a results folder again.
    Report(report::Args),
    /// Write the templates of the report, to change them.
    Templates(templates::Args),
    /// Compare two results folders number by number.
    Diff(diff::Args),
    /// Self-test: a row for each code and engine against values from elsewhere.
    Verify(verify::Args),
    /// Explain a code of an error or warning, a quantity, a check or a procedure.
    Explain(explain::Args),
    /// Write a commented tank.json to start from.
    Init(init::Args),
    /// Print the JSON Schema of tank.json, or its reference page.
    Schema(schema::Args),
    /// Print shell completions or the manual page.
    Completions(completions::Args),
}

const EXAMPLES: &str = "\
Examples:
  tankcheck init > tank.json
  tankcheck desk tank.json
  tankcheck compare tank.json --quake elcentro.csv --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe both --mesh 12x16x20 --vtu paraview/ --out out/
  tankcheck compare tank.json --quake elcentro.csv --fe nonlinear --out out/
  tankcheck ida tank.json --quake elcentro.csv --scale 0..1.1 --steps 12 --out ida/
  tankcheck push tank.json --imperfection 0.5t --out push/
  tankcheck check tank.json
  tankcheck check tank.json --solve fill_height
  tankcheck check tank.json --table tanks.csv
  tankcheck base tank.json --uplift 10mm,50mm --rotation 5e-4,1e-3
  tankcheck modes tank.json --format json
  tankcheck spectrum elcentro.csv --damping 0.5%,2%,5% --periods 0.02..20
  tankcheck quake info elcentro.csv
  tankcheck study plan study.json --out farm/
  tankcheck fragility --stripes stripes.csv --hazard hazard.csv
  tankcheck diff golden/ out/
  tankcheck explain T0206

Exit codes: 0 done, and everything required was checked and holds; 1 a check fails or diff found a change; 2 bad input or
usage; 3 the computation failed or was interrupted, its results could not be written, or the tank collapsed; 4 something
required was not checked, or nothing was assessed; 130 ended by Ctrl-C without results.";

/// The command line as data, for completions and the manual page.
pub(crate) fn command() -> clap::Command {
    Cli::command()
}

/// Entry point of the binary.
pub fn main() -> ExitCode {
    fault::install();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(answer) => return ExitCode::from(refused(&answer)),
    };
    match cli.global.color {
        When::Auto => {}
        When::Always => anstream::ColorChoice::Always.write_global(),
        When::Never => anstream::ColorChoice::Never.write_global(),
    }
    fem::cores::limit(cli.global.threads.map_or(0, usize::from));
    progress::listen(&cli.global);
    match cli.run() {
        Ok(code) => ExitCode::from(code),
        Err(error) => ExitCode::from(terminal::report_failure(&error)),
    }
}

impl Cli {
    fn run(self) -> Result<u8, Error> {
        global::fixed_time()?;
        match self.command {
            Command::Compare(args) => compare::run(*args, &self.global),
            Command::Check(args) => check::run(args, &self.global),
            Command::Ida(args) => ida::run(args, &self.global),
            Command::Push(args) => push::run(args, &self.global),
            Command::Study(args) => study::run(args, &self.global),
            Command::Fragility(args) => fragility::run(&args, &self.global),
            Command::Base(args) => base::run(args, &self.global),
            Command::Modes(args) => modes::run(args, &self.global),
            Command::Spectrum(args) => spectrum::run(args, &self.global),
            Command::Quake(args) => quake::run(args, &self.global),
            Command::Desk(args) => desk::run(args, command(), &self.global),
            Command::Report(args) => report::run(args, &self.global),
            Command::Templates(args) => templates::run(args, &self.global),
            Command::Diff(args) => diff::run(args, &self.global),
            Command::Verify(args) => verify::run(args, &self.global),
            Command::Explain(args) => explain::run(args, &self.global),
            Command::Init(args) => init::run(args, &self.global),
            Command::Schema(args) => schema::run(args, &self.global),
            Command::Completions(args) => completions::run(args, &self.global),
        }
    }
}

/// Prints the output of clap for help, version or bad usage; returns the exit code. Help and version are results.
fn refused(answer: &clap::Error) -> u8 {
    let text = answer.render();
    let coded = |text: String| match answer.use_stderr() {
        true => text.replacen("error:", &format!("{}:", Code::Usage.head()), 1),
        false => text,
    };
    // Colours of clap cannot be distinguished from escapes in an argument: print without colours.
    if std::env::args_os().any(|a| a.to_string_lossy().chars().any(text::hostile)) {
        say!("{}", coded(text.to_string()).trim_end());
        return EXIT_INPUT;
    }
    if answer.use_stderr() {
        let _ = anstream::stderr().lock().write_all(text::without_commands(&coded(text.ansi().to_string())).as_bytes());
        return EXIT_INPUT;
    }
    let styled = anstream::AutoStream::choice(&std::io::stdout()) != anstream::ColorChoice::Never;
    let text = if styled { text.ansi().to_string() } else { text.to_string() };
    match terminal::print_coloured(&text) {
        Ok(()) => EXIT_OK,
        Err(error) => terminal::report_failure(&error),
    }
}
