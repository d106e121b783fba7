//! `tankcheck report`: render the report of a results folder again, without computing.

use std::path::PathBuf;

use crate::cli::style::StyleArg;
use crate::cli::terminal::say;
use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use files::{self, OutputFolder};
use report::{self, Level};
use results::{COMPARE_REPORT, REPORT_FILE};

/// Arguments.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  tankcheck report out/\n  tankcheck report out/ --report full\n  tankcheck report out/ --lang de --report-units both\n  tankcheck report out/ --templates our-letterhead/"
)]
pub(crate) struct Args {
    /// Results folder written by `tankcheck compare` or `tankcheck check`.
    folder: PathBuf,
    #[command(flatten)]
    level: LevelArg,
    #[command(flatten)]
    style: StyleArg,
    /// Folder of templates that replace the built-in ones of the same name (report.html, style.css, sections/….html).
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
}

/// Option `--report`, of all commands that write one.
#[derive(clap::Args, Clone, Copy, Debug)]
pub(crate) struct LevelArg {
    /// How much the report says.
    #[arg(long, value_enum, default_value_t, value_name = "LEVEL")]
    report: ReportLevel,
}

impl LevelArg {
    /// The level.
    pub(crate) fn level(self) -> Level {
        match self.report {
            ReportLevel::Summary => Level::Summary,
            ReportLevel::Standard => Level::Standard,
            ReportLevel::Full => Level::Full,
        }
    }
}

/// How much a report says.
#[derive(clap::ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
enum ReportLevel {
    /// Cover, verdict, what was not checked, headline figures.
    Summary,
    /// Also model, limits, checks, differences, main figures, sheets of the deciding procedures.
    #[default]
    Standard,
    /// Also all sheets and checks, the input, modes, more figures.
    Full,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _global: &Global) -> Result<u8, Error> {
    let _style = args.style.apply();
    for name in files::edited(&args.folder, COMPARE_REPORT) {
        say!("warning: {name} has changed since tankcheck wrote it; the report shows the changed file");
    }
    let report = report::of_folder(&args.folder, args.templates.as_deref(), args.level.level())?;
    let folder = OutputFolder::prepare(&args.folder, COMPARE_REPORT)?;
    report.write(&folder.path())?;
    folder.commit()?;
    print(&format!("{}\n", args.folder.join(REPORT_FILE).display()))?;
    Ok(EXIT_OK)
}
