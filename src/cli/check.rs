//! `tankcheck check`: the code procedures alone.

use std::path::Path;
use std::time::Instant;

use fem::progress::Silent;

use crate::cli::inputs::{self, Inputs};
use crate::cli::report::LevelArg;
use crate::cli::select::{self, SelectArg};
use crate::cli::style::{self, StyleArg};
use crate::cli::terminal::{print_coloured, say};
use crate::cli::{Format, Global, compare, findings, print, solve, stamp, tanks, wall};
use crate::error::Error;
use crate::pipeline::{self, Outcome};
use files::OutputFolder;
use files::code::Code;
use report;
use results::{self, COMPARE};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck check tank.json                       design spectra of the tank's `site`
  tankcheck check tank.json --quake elcentro.csv  also the spectrum of a record
  tankcheck check tank.json --procedures api650-2020 --format json
  tankcheck check tank.json --format json --select all    results.json instead of its main parts
  tankcheck check tank.json --format junit        a test case a check; also sarif, github
  tankcheck check tank.json --solve fill_height   the largest fill height at which no check fails
  tankcheck check tank.json --solve thickness:1   the smallest thickness of the lowest course
  tankcheck check tank.json --solve ag            the largest ground acceleration of site.ec8 (ss: of site.api650)
  tankcheck check tank.json --table tanks.csv     many tanks, each a row with the values that differ

--solve tries 25 values of the admissible range and the given one, then bisects to a relative 1e-4. The value is rounded to the
side that holds. Limit states that were not checked are listed with the verdict at the value. The exit code is that of this
verdict; 1 if a check fails at every value, 4 if there is no single answer.

--table: each column head is a path of tank.json (tank.radius, liquid.fill_height, tank.courses[0].thickness,
materials[\"A 36\"].yield_strength), each row a tank; an empty cell keeps the value of tank.json, a cell null removes it (tank.anchors of
an unanchored tank). A column tag or id only names the tanks. The answer is the table with
status, governing method and check, utilisation and, with --solve, the solved value. The exit code is that of the worst tank; a row that
is bad input is `refused`, its fault is on standard error, the other rows are computed, and the exit code is 2.

Exit codes: 0 everything required was checked and holds; 1 a check fails; 2 bad input; 3 the computation failed;
4 something required was not checked, or nothing was assessed; with --strict also where a gap is accepted.")]
pub(crate) struct Args {
    #[command(flatten)]
    inputs: Inputs,
    /// Also write a report (without finite elements) into this folder.
    #[arg(long, short, value_name = "FOLDER")]
    out: Option<std::path::PathBuf>,
    #[command(flatten)]
    level: LevelArg,
    #[command(flatten)]
    style: StyleArg,
    #[command(flatten)]
    select: SelectArg,
    /// Solve for the largest fill_height, ag or ss, or the smallest thickness:N (course N from the base), at which no check fails.
    #[arg(long, value_name = "VARIABLE", conflicts_with = "out")]
    solve: Option<String>,
    /// Check the tanks of this CSV table, whose columns are paths of the tank file; prints a CSV table.
    #[arg(long, value_name = "FILE", conflicts_with = "out")]
    table: Option<std::path::PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = CheckFormat::Human)]
    format: CheckFormat,
}

/// Form of the output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum CheckFormat {
    /// A table for people.
    Human,
    /// JSON in SI units.
    Json,
    /// Comma-separated values, in SI units unless `--report-units` or `project.units` asks for others.
    Csv,
    /// JUnit XML: a test case a check of the deciding methods.
    Junit,
    /// SARIF 2.1.0: a result a check that fails or was not made.
    Sarif,
    /// Annotations of GitHub workflows.
    Github,
}

impl CheckFormat {
    /// As written on the command line.
    fn word(self) -> String {
        let value = clap::ValueEnum::to_possible_value(&self);
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// The form that other commands have too.
    fn plain(self) -> Option<Format> {
        match self {
            CheckFormat::Human => Some(Format::Human),
            CheckFormat::Json => Some(Format::Json),
            CheckFormat::Csv => Some(Format::Csv),
            _ => None,
        }
    }
}

impl Args {
    /// Errors: a form of the output that --table or --solve does not have.
    fn fits(&self) -> Result<(), Error> {
        let conflict = |text: String| Err(Error::conflict(text));
        let (option, forms) = match (&self.table, &self.solve) {
            (Some(_), _) => ("--table", "human or csv"),
            (None, Some(_)) => ("--solve", "human, json or csv"),
            (None, None) => return Ok(()),
        };
        if self.format.plain().is_none() {
            return conflict(format!(
                "{option}: found --format {}, expected {forms}\n  help: a test report is that of one tank; leave --format or {option} out",
                self.format.word()
            ));
        }
        if self.table.is_some() && self.format == CheckFormat::Json {
            return conflict("--table: found --format json, expected csv\n  help: leave --format out".into());
        }
        Ok(())
    }
}

/// Errors: a folder with the results of finite elements, which those of the codes alone would replace.
fn keeps_runs(out: &Path) -> Result<(), Error> {
    let histories = out.join(results::SERIES_FILE);
    if !histories.is_file() {
        return Ok(());
    }
    Err(Error::input(
        Code::FileTaken,
        format!(
            "{}: contains the results of `tankcheck compare` with finite elements, and `check` has none\n  help: name another folder with \
             --out, or remove this one",
            files::text::line(&out.display().to_string())
        ),
    ))
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let started = Instant::now();
    let _style = args.style.apply();
    // A test report has no parts to select.
    args.select.admit(args.format.plain().unwrap_or(Format::Csv))?;
    args.fits()?;
    if let Some(table) = &args.table {
        return tanks::run(&args.inputs, table, args.solve.as_deref());
    }
    let job = args.inputs.job(|_| Vec::new())?;
    inputs::shaken(&job)?;
    if let Some(variable) = &args.solve {
        return solve::run(&job, variable, (args.format.plain().unwrap_or(Format::Human), args.inputs.strict), global);
    }
    if let Some(out) = &args.out {
        keeps_runs(out)?;
    }
    let folder = args.out.as_deref().map(|out| OutputFolder::prepare(out, COMPARE)).transpose()?;
    let Outcome { mut results, series, .. } = pipeline::run(&job, &Silent)?;
    results.volatile = stamp(started);
    if let Some(folder) = folder {
        pipeline::draw(&job, &mut results)?;
        results::write(&folder.path(), &results, &series)?;
        report::render(&folder.path(), None, args.level.level())?;
        let stale = folder.stale();
        folder.commit()?;
        compare::replaced(args.out.as_deref().unwrap_or(Path::new("")), &stale);
    }
    if args.format == CheckFormat::Human {
        let _units = style::terminal(results.project.as_ref());
        for line in wall::lines(&job.case.tank) {
            print(&format!("{line}\n"))?;
        }
    }
    let found = || findings::of_checks(&results, args.inputs.strict);
    let place = args.inputs.tank.to_string_lossy();
    match (args.format, args.format.plain()) {
        (_, Some(plain)) => {
            compare::print(&results, args.out.as_deref(), (plain, &args.select, &select::USUAL), global)?
        }
        (CheckFormat::Junit, _) => print(&findings::junit(&results.name, &found()))?,
        (CheckFormat::Sarif, _) => print(&findings::sarif(&place, &found())?)?,
        _ => print_coloured(&findings::github(&place, &found()))?,
    }
    compare::late_warnings(&job, &results);
    if let Some(run) = results.verdict.silent.iter().find(|d| d.method.starts_with(results::FE)) {
        say!(
            "note: procedures.decide names `{}`, a finite-element run; `check` has none, `tankcheck compare --quake` has",
            run.method
        );
    }
    Ok(compare::exit_code(&results.verdict, args.inputs.strict))
}
