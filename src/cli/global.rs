//! Shared by the subcommands: global options, form of the output, spinner, JSON, stamp of a run.

use files::text;
use results::{Volatile, finite};

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
    /// Cores for nonlinear runs, shared by those of --jobs; results do not depend on it [default: all].
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

/// Fields that differ between identical runs.
pub(crate) fn stamp(started: std::time::Instant) -> Volatile {
    Volatile {
        version: env!("CARGO_PKG_VERSION").into(),
        created: now(),
        command: std::iter::once("tankcheck".to_owned())
            .chain(std::env::args().skip(1))
            .collect::<Vec<_>>()
            .join(" "),
        seconds: started.elapsed().as_secs_f64(),
    }
}

/// The time of day, UTC, as `2002-10-01T12:00:00Z`.
pub(crate) fn now() -> String {
    humantime::format_rfc3339_seconds(std::time::SystemTime::now()).to_string()
}
