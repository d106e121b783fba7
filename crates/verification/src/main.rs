//! The verification program: runs the benchmarks and writes the verification manual.

mod output;

use std::cell::Cell;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use files::code::Code;
use files::error::{EXIT_CHECK_FAILED, EXIT_COMPUTATION, EXIT_INTERRUPTED, EXIT_OK};
use verification::records::{EL_CENTRO, EL_CENTRO_NGA, PACOIMA, PARKFIELD};
use verification::{Choice, Error, Manual, Pattern, Records, manual, nearest, tanks};

/// Runs the benchmarks of the verification manual.
#[derive(Parser)]
#[command(
    name = "verification",
    version,
    about,
    max_term_width = 110,
    after_help = "\
Examples:
  cargo run --release -p verification
  cargo run --release -p verification -- --list                       the benchmarks: page, pace, ids of rows
  cargo run --release -p verification -- shell-cook                   one page
  cargo run --release -p verification -- 'F1?' --format json          rows F10 to F17
  cargo run --release -p verification -- dissertation                 every row that stands beside a number of the dissertation
  cargo run --release -p verification -- elephant --slow              pages and ids with `elephant` in them, fine meshes too
  cargo run --release -p verification -- --format html > verification.html
  cargo run --release -p verification -- --records ~/records          also rows with records that may not be redistributed
  cargo run --release -p verification -- --slow                       also the rows that take minutes
  cargo run --release -p verification -- --write docs/verification    write the manual: index, a page and figure per benchmark

Exit codes: 0 every row that ran is within its tolerance; 1 a row is not; 2 bad input; 3 the computation failed."
)]
struct Args {
    /// Id of rows, page, a part of either, or a glob with * and ?; all benchmarks without it.
    #[arg(value_name = "PATTERN")]
    pattern: Option<String>,
    /// List the benchmarks and run none.
    #[arg(long, conflicts_with_all = ["records", "slow", "write"])]
    list: bool,
    /// Folder with accelerograms (imperial-valley-1940-el-centro-ns.csv, …).
    #[arg(long, value_name = "FOLDER")]
    records: Option<PathBuf>,
    /// Also run the rows that take minutes.
    #[arg(long)]
    slow: bool,
    /// Write the manual into this folder; rows that do not run keep their last result there.
    #[arg(long, short, alias = "out", value_name = "FOLDER")]
    write: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
    /// No progress on standard error.
    #[arg(long, short)]
    quiet: bool,
    /// Cores; results do not depend on it [default: all].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// Form of the output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// A table for people.
    Human,
    /// JSON.
    Json,
    /// Comma-separated values.
    Csv,
    /// One page with one sheet per benchmark.
    Html,
}

fn main() -> ExitCode {
    let args = Args::parse();
    // Ctrl-C removes a half-written manual; where the manual is already in place, only the messages are missing.
    let _ = ctrlc::set_handler(|| {
        std::process::exit(i32::from(if files::discard_unfinished() { EXIT_COMPUTATION } else { EXIT_INTERRUPTED }));
    });
    fem::cores::limit(args.threads.map_or(0, usize::from));
    ExitCode::from(run(&args).unwrap_or_else(|error| {
        let head = error.code().map_or("error".into(), Code::head);
        let text = format!("{head}: {error}\n");
        let _ = std::io::stderr().write_all(files::text::visible(&text).as_bytes());
        error.exit_code()
    }))
}

/// Runs the chosen benchmarks; returns the exit code.
fn run(args: &Args) -> Result<u8, Error> {
    let pattern = args.pattern.as_deref().map(pattern).transpose()?;
    let records = records(args)?;
    let choice = Choice { pattern: pattern.as_ref(), slow: args.slow, records: records.as_ref() };
    if args.list {
        print(&output::list(choice, args.format)?)?;
        return Ok(EXIT_OK);
    }
    let (begun, parts) = (Cell::new(0), choice.parts());
    let shown = !args.quiet && std::io::stderr().is_terminal();
    let mut found = verification::run(choice, &|title| {
        begun.set(begun.get() + 1);
        if shown {
            let _ = writeln!(std::io::stderr(), "{}/{parts} {title}", begun.get());
        }
    })?;
    if let Some(folder) = &args.write {
        write(folder, &found, choice)?;
    }
    // The manual gets all rows that ran, the output only the requested ones.
    found.rows.retain(|row| pattern.as_ref().is_none_or(|p| p.selects(row)));
    print(&output::rows(&found, args.format)?)?;
    let failed = found.rows.iter().any(|row| row.fails());
    Ok(if failed { EXIT_CHECK_FAILED } else { EXIT_OK })
}

/// Writes to standard output. A reader that closes early (`| head`) is not a failure.
fn print(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(files::text::printed(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(files::error::Error::Output(files::error::describe(&error)).into())
        }
        _ => Ok(()),
    }
}

/// The pattern of the command line; one without a match is an error.
fn pattern(text: &str) -> Result<Pattern, Error> {
    Pattern::new(text).ok_or_else(|| {
        let near: Vec<String> = nearest(text).iter().map(|name| format!("`{name}`")).collect();
        let meant = if near.is_empty() { String::new() } else { format!("did you mean {}? ", near.join(" or ")) };
        let shown = files::text::line(text);
        let text = format!(
            "PATTERN: found `{shown}`, expected an id of rows or a page, a part of one, or a glob\n  help: {meant}list them with \
             --list"
        );
        files::error::Error::Input(Code::UnknownId, text).into()
    })
}

/// The accelerograms that the chosen rows need.
fn records(args: &Args) -> Result<Option<Records>, Error> {
    let Some(folder) = &args.records else { return Ok(None) };
    // The page of the dissertation's examples takes minutes and all records.
    let whole = args.slow && args.write.is_some() && args.pattern.is_none();
    let names: &[&str] = if whole { &[EL_CENTRO, PARKFIELD, PACOIMA] } else { &[EL_CENTRO] };
    Ok(Some(Records::read(folder, names)?.and(folder, &[PARKFIELD, PACOIMA, EL_CENTRO_NGA])?))
}

/// Writes the manual: rows that ran, and the last results of the others.
fn write(folder: &Path, found: &Manual, choice: Choice) -> Result<(), Error> {
    let kept = if folder.join(manual::ROWS).exists() { manual::read(folder)? } else { Vec::new() };
    let merged = manual::merge(&found.rows, &kept, |page, pace| choice.runs(page, pace));
    let tanks = match (choice.pattern, choice.slow, choice.records) {
        (None, true, Some(records)) => Some(tanks::dissertation::page(records)?),
        _ => None,
    };
    manual::write(folder, &merged, tanks)
}
