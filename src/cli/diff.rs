//! `tankcheck diff`: two results folders, number by number.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::cli::findings::{self, Finding, Outcome};
use crate::cli::table::Table;
use crate::cli::terminal::say;
use crate::cli::{Global, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use files::code::Code;
use files::text as visible;
use files::{Kind, OutputFolder, write_whole};
use report::words;
use results::numdiff::{self, Options, Report};
use results::{self, COMPARE, Changes, Ending, MovedCheck, MovedQuantity, OUTPUT, Side, describe};
use tank::assessment::CheckStatus;
use tank::units;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck diff reports/01_broad_tank out/
  tankcheck diff golden/ out/ --rtol 1e-4 --format json
  tankcheck diff golden/ out/ --all               also calculation lines, profiles and histories
  tankcheck diff golden/ out/ --format junit > diff.xml
  tankcheck diff golden/ out/ --bless --reason \"finer mesh at the base by default\"

Exit codes: 0 equal within tolerance; 1 a value moved; 2 bad input.")]
pub(crate) struct Args {
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
    /// Reason why the numbers may move.
    #[arg(long)]
    reason: Option<String>,
    /// Largest number of rows of each table.
    #[arg(long, default_value_t = 30)]
    most: usize,
    /// List every value that moved: calculation lines, profiles, histories, input.
    #[arg(long)]
    all: bool,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = DiffFormat::Human)]
    format: DiffFormat,
}

/// Form of the output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum DiffFormat {
    /// Tables for people: verdict, quantities and checks.
    Human,
    /// JSON in SI units.
    Json,
    /// Every value that moved, comma-separated.
    Csv,
    /// JUnit XML: a test case a check and quantity that moved.
    Junit,
    /// SARIF 2.1.0.
    Sarif,
    /// Annotations of GitHub workflows.
    Github,
}

/// The results folder that is overwritten.
const BLESSED: Kind = Kind {
    option: "OLD",
    ..COMPARE
};

/// Copies the files of a results folder into another one.
fn copy(from: &Path, to: &Path) -> Result<(), Error> {
    let fault = |path: &Path, e: std::io::Error| {
        Error::Files(files::error::Error::Unwritten {
            path: path.into(),
            what: describe(&e),
        })
    };
    for entry in OUTPUT {
        let (source, target) = (from.join(entry), to.join(entry));
        if source.is_dir() {
            std::fs::create_dir_all(&target).map_err(|e| fault(&target, e))?;
            for file in std::fs::read_dir(&source).map_err(|e| fault(&source, e))? {
                let file = file.map_err(|e| fault(&source, e))?;
                let copy = target.join(file.file_name());
                std::fs::copy(file.path(), &copy).map_err(|e| fault(&copy, e))?;
            }
        } else if source.is_file() {
            std::fs::copy(&source, &target).map_err(|e| fault(&target, e))?;
        }
    }
    Ok(())
}

/// File of a golden folder with the reasons for acceptance.
const ACCEPTED_FILE: &str = "accepted.json";

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    for (name, value) in [("--rtol", args.rtol), ("--time-tolerance", args.time_tolerance)] {
        if !(value.is_finite() && value >= 0.0) {
            return Err(Error::input(
                Code::OptionValue,
                format!("{name}: found {value}, expected a number ≥ 0"),
            ));
        }
    }
    if args.reason.as_ref().is_some_and(|reason| reason.trim().is_empty()) {
        return Err(Error::input(
            Code::OptionValue,
            "--reason: found an empty text, expected a sentence\n  help: state why the numbers may move".into(),
        ));
    }
    let options = Options {
        rtol: args.rtol,
        time_tolerance: args.time_tolerance,
    };
    if args.bless {
        // Only results of this form are copied; those of `ida` and `push` can only be compared.
        results::read(&args.new)?;
    }
    if args.bless && !args.old.exists() {
        bless(&args, &Report::default())?;
        return Ok(EXIT_OK);
    }
    let report = numdiff::folders(&args.old, &args.new, &options)?;
    let changes = changes(&args, &options)?;
    let findings = || findings(changes.as_ref());
    let place = || args.new.join(results::RESULTS_FILE).to_string_lossy().into_owned();
    match args.format {
        DiffFormat::Json => print(&json(&report, changes.as_ref()))?,
        DiffFormat::Human => print(&human(&report, changes.as_ref(), (args.most, args.all)))?,
        DiffFormat::Csv => print(&csv(&report))?,
        DiffFormat::Junit => print(&findings::junit("tankcheck diff", &findings()))?,
        DiffFormat::Sarif => print(&findings::sarif(&place(), &findings())?)?,
        DiffFormat::Github => print(&findings::github(&place(), &findings()))?,
    }
    if args.bless {
        bless(&args, &report)?;
        if !global.quiet {
            say!("accepted: {} now contains the new results", args.old.display());
        }
        return Ok(EXIT_OK);
    }
    Ok(if report.moved.is_empty() {
        EXIT_OK
    } else {
        EXIT_CHECK_FAILED
    })
}

/// Verdict, quantities and checks of both folders; none of `ida` and `push`, which have others.
fn changes(args: &Args, options: &Options) -> Result<Option<Changes>, Error> {
    let compared = |folder: &Path| folder.join(results::RESULTS_FILE).is_file();
    if !(compared(&args.old) && compared(&args.new)) {
        return Ok(None);
    }
    let (old, new) = (results::read(&args.old)?, results::read(&args.new)?);
    Ok(Some(Changes::between(&old, &new, options.rtol)))
}

/// What moved, for test reports.
fn findings(changes: Option<&Changes>) -> Vec<Finding> {
    let Some(changes) = changes else { return Vec::new() };
    let quantity = |q: &MovedQuantity| Finding {
        group: q.method.clone(),
        id: q.id.clone(),
        outcome: Outcome::Fails,
        message: format!("{} -> {} {}", q.old, q.new, percent(q.change)),
    };
    let check = |c: &MovedCheck| {
        let failed = c.new.is_some_and(|e| e.status == CheckStatus::Fails);
        Finding {
            group: c.method.clone(),
            id: c.id.clone(),
            outcome: if failed || c.turned() {
                Outcome::Fails
            } else {
                Outcome::Warns
            },
            message: format!("{} -> {}", ending(c.old), ending(c.new)),
        }
    };
    changes
        .checks
        .iter()
        .map(check)
        .chain(changes.quantities.iter().map(quantity))
        .collect()
}

fn percent(change: Option<f64>) -> String {
    change.map_or("–".into(), |c| format!("{:+.2} %", 100.0 * c))
}

fn ending(ending: Option<Ending>) -> String {
    let Some(ending) = ending else { return "–".into() };
    let status = words::verdict::status(ending.status);
    match ending.utilisation {
        Some(utilisation) => format!("{utilisation:.3} {status}"),
        None => status.into(),
    }
}

/// The first screen: verdict, quantities, checks.
fn summary(changes: &Changes, most: usize) -> String {
    let mut text = String::new();
    let [old, new] = &changes.verdict;
    let governing = |side: &Side| match &side.governing {
        Some((method, check, Some(utilisation))) => format!(", {check} of {method} {utilisation:.3}"),
        Some((method, check, None)) => format!(", {check} of {method}"),
        None => String::new(),
    };
    let word = |side: &Side| crate::cli::solve::word(side.status);
    if old == new {
        let _ = writeln!(text, "verdict  {}{} as before", word(new), governing(new));
    } else {
        let _ = writeln!(
            text,
            "verdict  {}{}  ->  {}{}",
            word(old),
            governing(old),
            word(new),
            governing(new)
        );
    }
    let more = |text: &mut String, all: usize| {
        if all > most {
            let _ = writeln!(text, "  (+{} more; --most {all} shows all)", all - most);
        }
    };
    if !changes.quantities.is_empty() {
        let mut table = Table::new(["quantity", "method", "old", "new", "change"]);
        for q in changes.quantities.iter().take(most) {
            let unit = units::column_unit([q.old, q.new], q.dimension);
            let value = |v: f64| units::significant(units::in_unit(v, unit), 4);
            let name = match unit.symbol.is_empty() {
                true => q.id.clone(),
                false => format!("{} [{}]", q.id, unit.symbol),
            };
            table.row([name, q.method.clone(), value(q.old), value(q.new), percent(q.change)]);
        }
        let _ = write!(text, "\n{table}");
        more(&mut text, changes.quantities.len());
    }
    if !changes.checks.is_empty() {
        let mut table = Table::new(["check", "method", "old", "new", ""]);
        for c in changes.checks.iter().take(most) {
            let remark = match (c.old, c.new) {
                (None, _) => "appeared",
                (_, None) => "vanished",
                _ if c.turned() => "changed",
                _ => "",
            };
            table.row([
                c.id.clone(),
                c.method.clone(),
                ending(c.old),
                ending(c.new),
                remark.to_owned(),
            ]);
        }
        let _ = write!(text, "\n{table}");
        more(&mut text, changes.checks.len());
    }
    for (methods, side) in [(&changes.vanished, "old"), (&changes.appeared, "new")] {
        if !methods.is_empty() {
            let _ = writeln!(text, "\nonly in the {side} results: {}", methods.join(", "));
        }
    }
    text
}

fn human(report: &Report, changes: Option<&Changes>, (most, all): (usize, bool)) -> String {
    let outcome = match (report.moved.len(), report.drifted) {
        (0, 0) => "same".to_string(),
        (0, drifted) => format!(
            "same within tolerance: {drifted} drifted, at most {:.1e}",
            report.largest_drift
        ),
        (moved, _) => format!("{moved} moved"),
    };
    let mut text = format!("{outcome} ({} values compared)\n", report.compared);
    let told = changes.filter(|c| !c.none());
    if let Some(changes) = told {
        text.push('\n');
        for line in summary(changes, most).lines() {
            let _ = writeln!(text, "{}", visible::line(line));
        }
    }
    if told.is_some() && !all {
        let _ = writeln!(
            text,
            "\n{} values moved in all; --all lists them with calculation lines, profiles and histories",
            report.moved.len()
        );
        return text;
    }
    for d in report.moved.iter().take(most) {
        if d.change.is_finite() {
            let _ = writeln!(
                text,
                "  {}: {} -> {} ({:.2e} of its peak)",
                visible::line(&d.path),
                visible::line(&d.old),
                visible::line(&d.new),
                d.change
            );
        } else {
            let [path, old, new] = [&d.path, &d.old, &d.new].map(|part| visible::line(part));
            let _ = writeln!(text, "  {path}: {old} -> {new}");
        }
    }
    if report.moved.len() > most {
        let _ = writeln!(
            text,
            "  (+{} more; --most {} shows all)",
            report.moved.len() - most,
            report.moved.len()
        );
    }
    text
}

fn json(report: &Report, changes: Option<&Changes>) -> String {
    let moved: Vec<_> = report
        .moved
        .iter()
        .map(
            |d| json!({"path": d.path, "old": d.old, "new": d.new, "change": d.change.is_finite().then_some(d.change)}),
        )
        .collect();
    let text = format!(
        "{:#}\n",
        json!({"compared": report.compared, "drifted": report.drifted, "largest_drift": report.largest_drift, "moved": moved, "changes": changes})
    );
    visible::json(&text).into_owned()
}

fn csv(report: &Report) -> String {
    let mut text = String::from("path,old,new,change\n");
    for d in &report.moved {
        let quote = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        let _ = writeln!(
            text,
            "{},{},{},{:e}",
            quote(&d.path),
            quote(&d.old),
            quote(&d.new),
            d.change
        );
    }
    text
}

/// Copies NEW over OLD and appends the reason with what moved to `accepted.json`.
fn bless(args: &Args, report: &Report) -> Result<(), Error> {
    let accepted = args.old.join(ACCEPTED_FILE);
    let mut history: Vec<serde_json::Value> = match std::fs::read_to_string(&accepted) {
        Ok(text) => serde_json::from_str(&text).map_err(|e| {
            Error::Files(files::error::Error::File {
                code: Code::NotResults,
                path: accepted.clone(),
                what: format!("found no list of acceptances: {e}"),
            })
        })?,
        Err(_) => Vec::new(),
    };
    history.push(json!({
        "reason": args.reason,
        "moved": report.moved.len(),
        "largest": report.moved.iter().take(5)
            .map(|d| format!("{}: {} -> {}", d.path, d.old, d.new)).collect::<Vec<_>>(),
    }));
    let folder = OutputFolder::prepare(&args.old, BLESSED)?;
    copy(&args.new, &folder.path())?;
    folder.commit()?;
    let text = format!("{:#}\n", serde_json::Value::Array(history));
    Ok(write_whole(&accepted, text.as_bytes())?)
}
