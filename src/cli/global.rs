//! Shared by the subcommands: global options, form of the output, spinner, JSON, stamp of a run.

use std::time::{Duration, Instant, SystemTime};

use files::text;
use results::{Volatile, finite};

use crate::cli::terminal::print;
use crate::error::Error;

/// Options of every subcommand.
#[derive(clap::Args, Clone, Debug)]
pub struct Global {
    /// When to colour messages.
    #[arg(long, global = true, value_enum, default_value_t = When::Auto)]
    pub color: When,
    /// No progress and no hints on standard error.
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Cores that computations share; results do not depend on it [default: all].
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
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
    /// Comma-separated values, where the result is a table; in SI units unless `--report-units` or `project.units` asks for others.
    Csv,
}

/// A spinner on standard error while `what` is computed; hidden unless standard error is a terminal.
pub(crate) fn spinner(global: &Global, what: &'static str) -> indicatif::ProgressBar {
    if global.quiet {
        return indicatif::ProgressBar::hidden();
    }
    // `new_spinner` draws to standard error and hides itself where that is not a terminal.
    let spinner = indicatif::ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(std::time::Duration::from_millis(100));
    spinner
}

/// A result as JSON for standard output. Control characters of a terminal are written as `\u009b`, which is the same
/// value.
///
/// Errors: a number that is not finite.
pub(crate) fn json(value: &impl serde::Serialize) -> Result<String, Error> {
    finite::check("the result", value)?;
    let text = serde_json::to_string_pretty(value).map_err(|e| Error::report(e.to_string()))?;
    Ok(format!("{}\n", text::json(&text)))
}

/// Prints a result in the form that was asked for.
///
/// * `csv`: [`no_csv`] of a result that is not a table
///
/// Errors: a number that is not finite; an output that cannot be written.
pub(crate) fn show<V: serde::Serialize>(
    format: Format,
    human: impl FnOnce() -> String,
    value: impl FnOnce() -> V,
    csv: impl FnOnce() -> Result<String, Error>,
) -> Result<(), Error> {
    print(&match format {
        Format::Human => human(),
        Format::Json => json(&value())?,
        Format::Csv => csv()?,
    })
}

/// Rejects `--format csv`.
pub(crate) fn no_csv() -> Result<String, Error> {
    Err(Error::conflict("--format: found csv, expected human or json"))
}

/// Variable with the time that stands for the time of the run, in seconds since 1970 (<https://reproducible-builds.org/specs/source-date-epoch/>):
/// with it the files of two runs of the same command are equal, wherever they are written.
const SOURCE_DATE_EPOCH: &str = "SOURCE_DATE_EPOCH";

/// Options that say where results go, how a run is watched and how it is divided, but not what is computed: with or without a value.
const OF_THE_RUN: ([&str; 6], [&str; 4]) =
    (["--out", "-o", "--vtu", "--threads", "--color", "--checkpoint"], ["--quiet", "-q", "--force", "--resume"]);

/// The fixed time of [`SOURCE_DATE_EPOCH`], if it is set.
///
/// Errors: another text than a number of seconds, or one after the year 9999.
pub(crate) fn fixed_time() -> Result<Option<SystemTime>, Error> {
    let Some(given) = std::env::var_os(SOURCE_DATE_EPOCH).filter(|text| !text.is_empty()) else { return Ok(None) };
    let given = given.to_string_lossy();
    match given.parse::<u64>() {
        Ok(seconds) if seconds <= 253_402_300_799 => Ok(Some(SystemTime::UNIX_EPOCH + Duration::from_secs(seconds))),
        _ => Err(Error::value(format!(
            "{SOURCE_DATE_EPOCH}: found `{}`, expected whole seconds since 1970, up to the year 9999",
            text::line(&given)
        ))),
    }
}

/// Fields that differ between identical runs, but for a fixed time.
pub(crate) fn stamp(started: Instant) -> Volatile {
    // It was read before the run.
    let fixed = fixed_time().unwrap_or_default();
    let created = humantime::format_rfc3339_seconds(fixed.unwrap_or_else(SystemTime::now));
    Volatile {
        version: env!("CARGO_PKG_VERSION").into(),
        created: created.to_string(),
        command: command(std::env::args().skip(1), fixed.is_some()),
        seconds: match fixed {
            Some(_) => 0.0,
            None => started.elapsed().as_secs_f64(),
        },
    }
}

/// The command without the path of the program on this machine.
///
/// * `fixed`: also without the options [`OF_THE_RUN`]
fn command(arguments: impl Iterator<Item = String>, fixed: bool) -> String {
    let mut said = String::from("tankcheck");
    let mut value_follows = false;
    for argument in arguments {
        let name = argument.split('=').next().unwrap_or_default();
        let valued = OF_THE_RUN.0.contains(&name);
        let left_out = fixed && (value_follows || valued || OF_THE_RUN.1.contains(&name));
        value_follows = valued && !argument.contains('=');
        if !left_out {
            said.push(' ');
            said.push_str(&argument);
        }
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_cores_are_not_part_of_a_fixed_command() {
        let words = "compare t.json --out a/b -q --quake r.csv --threads=2 -o c --color never --refine 2";
        let told = |fixed| command(words.split(' ').map(str::to_owned), fixed);
        assert_eq!(told(false), format!("tankcheck {words}"));
        assert_eq!(told(true), "tankcheck compare t.json --quake r.csv --refine 2");
    }
}
