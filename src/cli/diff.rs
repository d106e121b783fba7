//! `tankcheck diff`: two results folders, number by number.

mod apart;

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::json;

use crate::cli::findings::{self, Finding, Outcome};
use crate::cli::table::{Mark, Table};
use crate::cli::terminal::{print_coloured, print_marked, say, width};
use crate::cli::{Global, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use apart::{Apart, differing};
use files::code::Code;
use files::text as visible;
use files::{Kind, OutputFolder, write_whole};
use report::words;
use results::numdiff::{self, Options, Report};
use results::{
    self, COMPARE, Changes, Deciding, Ending, LeftOut, MovedCheck, MovedQuantity, OUTPUT, Results, Side, describe,
};
use tank::Quantity;
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
const BLESSED: Kind = Kind { option: "OLD", ..COMPARE };

/// Copies the files of a results folder into another one.
fn copy(from: &Path, to: &Path) -> Result<(), Error> {
    let fault = |path: &Path, e: std::io::Error| {
        Error::Files(files::error::Error::Unwritten { path: path.into(), what: describe(&e) })
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
            return Err(Error::value(format!("{name}: found {value}, expected a number ≥ 0")));
        }
    }
    if args.reason.as_ref().is_some_and(|reason| reason.trim().is_empty()) {
        return Err(Error::value(
            "--reason: found an empty text, expected a sentence\n  help: state why the numbers may move",
        ));
    }
    let options = Options { rtol: args.rtol, time_tolerance: args.time_tolerance };
    if args.bless {
        // Only results of this form are copied; those of `ida` and `push` can only be compared.
        results::read(&args.new)?;
    }
    if args.bless && !args.old.exists() {
        bless(&args, &Report::default())?;
        return Ok(EXIT_OK);
    }
    let report = numdiff::folders(&args.old, &args.new, &options)?;
    if args.bless {
        keeps_parts(&args)?;
    }
    let changes = changes(&args, &options)?;
    let only = || changes.as_ref().map(|told| &told.changes);
    let findings = || findings(only());
    let place = || args.new.join(results::RESULTS_FILE).to_string_lossy().into_owned();
    match args.format {
        DiffFormat::Json => print(&json(&report, changes.as_ref()))?,
        DiffFormat::Human => print_marked(&human(&report, changes.as_ref(), (args.most, args.all)))?,
        DiffFormat::Csv => print(&csv(&report))?,
        DiffFormat::Junit => print(&findings::junit("tankcheck diff", &findings()))?,
        DiffFormat::Sarif => print(&findings::sarif(&place(), &findings())?)?,
        DiffFormat::Github => print_coloured(&findings::github(&place(), &findings()))?,
    }
    // These forms say both in their text.
    if !matches!(args.format, DiffFormat::Json | DiffFormat::Human) {
        if let Some(apart) = changes.as_ref().and_then(|told| told.apart.as_ref()) {
            say!("note: {}", apart.words());
        }
        if !report.not_compared.is_empty() {
            say!("{}", not_compared(&report));
        }
    }
    if args.bless {
        bless(&args, &report)?;
        if !global.quiet {
            say!("accepted: {} now contains the new results", args.old.display());
        }
        return Ok(EXIT_OK);
    }
    Ok(if report.moved.is_empty() { EXIT_OK } else { EXIT_CHECK_FAILED })
}

/// Errors: NEW has not computed what OLD has.
fn keeps_parts(args: &Args) -> Result<(), Error> {
    if !args.old.join(results::RESULTS_FILE).is_file() {
        return Ok(());
    }
    let (old, new) = (results::read(&args.old)?, results::read(&args.new)?);
    let lost: Vec<&str> =
        (new.not_computed.iter()).filter(|left| old.has(left.part)).map(|left| left.part.name()).collect();
    if lost.is_empty() {
        return Ok(());
    }
    Err(Error::conflict(format!(
        "--bless: NEW holds selected parts alone; it would replace {} of OLD\n  help: run `tankcheck compare` without --select",
        lost.join(", ")
    )))
}

fn not_compared(report: &Report) -> String {
    format!("not compared, because one of the two folders does not have it: {}", LeftOut::names(&report.not_compared))
}

/// Verdict, quantities and checks of both folders; none of `ida` and `push`, which have others.
fn changes(args: &Args, options: &Options) -> Result<Option<Told>, Error> {
    let compared = |folder: &Path| folder.join(results::RESULTS_FILE).is_file();
    if !(compared(&args.old) && compared(&args.new)) {
        return Ok(None);
    }
    let (old, new) = (results::read(&args.old)?, results::read(&args.new)?);
    Ok(Some(Told::between(&old, &new, options.rtol)))
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
            outcome: if failed || c.turned() { Outcome::Fails } else { Outcome::Warns },
            message: format!("{} -> {}", ending(c.old), ending(c.new)),
        }
    };
    changes.checks.iter().map(check).chain(changes.quantities.iter().map(quantity)).collect()
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

/// Every quantity of every method that moved, in one list.
fn quantities(text: &mut String, changes: &Changes, most: usize) {
    if changes.quantities.is_empty() {
        return;
    }
    let mut table = Table::new(["quantity", "method", "old", "new", "change"]);
    for q in changes.quantities.iter().take(most) {
        let (name, [old, new]) = shown(q);
        table.row([name, q.method.clone(), old, new, percent(q.change)]);
    }
    let _ = write!(text, "\n{}", table.fitted(width()));
    more(text, changes.quantities.len(), most);
}

/// Says how many rows `--most` leaves out.
fn more(text: &mut String, all: usize, most: usize) {
    if all > most {
        let _ = writeln!(text, "  (+{} more; --most {all} shows all)", all - most);
    }
}

/// Name with its unit, and both values in it.
fn shown(q: &MovedQuantity) -> (String, [String; 2]) {
    let unit = units::column_unit([q.old, q.new], q.dimension);
    let name = if unit.symbol.is_empty() { q.id.clone() } else { format!("{} [{}]", q.id, unit.symbol) };
    (name, [q.old, q.new].map(|v| units::significant(units::in_unit(v, unit), 4)))
}

/// A row a quantity for each excitation: the values of the engine, or of the first method, and the change of every method.
fn together(text: &mut String, changes: &Changes) {
    for excitation in ["site", "record"] {
        let of = |q: &&MovedQuantity| q.method.split_once('/').is_some_and(|(_, under)| under == excitation);
        let moved: Vec<&MovedQuantity> = changes.quantities.iter().filter(of).collect();
        let methods: BTreeSet<&str> = moved.iter().map(|q| q.method.as_str()).collect();
        let fe = format!("{}/{excitation}", results::FE);
        let Some(main) = methods.get(fe.as_str()).or_else(|| methods.first()).copied() else { continue };
        let short = |method: &str| method.split('/').next().unwrap_or_default().to_owned();
        let others: Vec<&str> = methods.iter().copied().filter(|method| *method != main).collect();
        let head =
            [format!("change under the {excitation}"), format!("{}, old", short(main)), "new".into(), short(main)];
        let mut table = Table::new(head.into_iter().chain(others.iter().map(|method| short(method))));
        let order = |id: &str| Quantity::ALL.iter().position(|q| q.id() == id);
        let mut ids: Vec<&str> = moved.iter().map(|q| q.id.as_str()).collect();
        ids.sort_by_key(|id| order(id));
        ids.dedup();
        for id in ids {
            let find = |method: &str| moved.iter().find(|q| q.id == id && q.method == method);
            let dash = || "–".to_owned();
            let (name, [old, new]) = find(main).map_or_else(|| (id.to_owned(), [dash(), dash()]), |q| shown(q));
            let change = |method: &str| find(method).map_or_else(dash, |q| percent(q.change));
            let cells = [name, old, new, change(main)];
            table.row(cells.into_iter().chain(others.iter().map(|method| change(method))));
        }
        let _ = write!(text, "\n{}", table.fitted(width()));
    }
}

/// What both results have beside their numbers.
struct Told {
    /// The tanks, where they are not the same.
    apart: Option<Apart>,
    changes: Changes,
    /// Input that differs, a line each.
    input: Vec<String>,
    /// Methods that decide in either, with their excitation.
    deciding: BTreeSet<String>,
}

/// Most lines of input.
const INPUT: usize = 8;

impl Told {
    fn between(old: &Results, new: &Results, rtol: f64) -> Told {
        let key = |d: &Deciding| format!("{}/{}", d.method, d.excitation.word());
        let deciding = old.verdict.deciding.iter().chain(&new.verdict.deciding).map(key);
        Told {
            apart: Apart::between(old, new),
            changes: Changes::between(old, new, rtol),
            input: input(old, new),
            deciding: deciding.collect(),
        }
    }
}

/// Input that differs in lines, the first of many.
fn input(old: &Results, new: &Results) -> Vec<String> {
    let text = |side: Option<String>| side.unwrap_or_else(|| "–".to_owned());
    let mut lines: Vec<String> = differing(old, new)
        .into_iter()
        .map(|(path, [old, new])| format!("{path}: {} -> {}", text(old), text(new)))
        .collect();
    if lines.len() > INPUT {
        let more = lines.len() - INPUT;
        lines.truncate(INPUT);
        lines.push(format!("and {more} more"));
    }
    lines
}

/// The first screen: verdict, input, checks, quantities.
fn summary(told: &Told, most: usize, all: bool) -> String {
    let changes = &told.changes;
    let mut text = String::new();
    let [old, new] = &changes.verdict;
    let governing = |side: &Side| match &side.governing {
        Some((method, check, Some(utilisation))) => format!(", {check} of {method} {utilisation:.3}"),
        Some((method, check, None)) => format!(", {check} of {method}"),
        None => String::new(),
    };
    let word = |side: &Side| side.status.id();
    if old == new {
        let _ = writeln!(text, "verdict  {}{} as before", word(new), governing(new));
    } else {
        let _ = writeln!(text, "verdict  {}{}  ->  {}{}", word(old), governing(old), word(new), governing(new));
    }
    for line in &told.input {
        let _ = writeln!(text, "input    {line}");
    }
    // What is not required in one and absent in the other is not news.
    let nothing = |end: Option<Ending>| end.is_none_or(|end| end.status == CheckStatus::NotApplicable);
    let news = |c: &&MovedCheck| all || !(nothing(c.old) && nothing(c.new));
    let decides = |c: &&MovedCheck| all || told.deciding.is_empty() || told.deciding.contains(&c.method) || c.turned();
    let first: Vec<&MovedCheck> = changes.checks.iter().filter(news).filter(decides).collect();
    if !first.is_empty() {
        let mut table = Table::new(["check", "method", "old", "new", ""]);
        for c in first.iter().take(most) {
            let remark = match (c.old, c.new) {
                (None, _) => "appeared",
                (_, None) => "vanished",
                _ if c.turned() => "changed",
                _ => "",
            };
            let mark = match c.new.map(|end| end.status) {
                Some(CheckStatus::Fails) => Mark::Fails,
                Some(CheckStatus::NotChecked) => Mark::Open,
                _ => Mark::None,
            };
            table.marked(mark, [c.id.clone(), c.method.clone(), ending(c.old), ending(c.new), remark.to_owned()]);
        }
        let _ = write!(text, "\n{}", table.fitted(width()));
        more(&mut text, first.len(), most);
    }
    let others = changes.checks.iter().filter(news).count() - first.len();
    if others > 0 {
        let _ = writeln!(text, "  (+{others} of methods that do not decide; --all shows them)");
    }
    if all {
        quantities(&mut text, changes, most)
    } else {
        together(&mut text, changes)
    }
    for (methods, side) in [(&changes.vanished, "old"), (&changes.appeared, "new")] {
        if !methods.is_empty() {
            let _ = writeln!(text, "\nonly in the {side} results: {}", methods.join(", "));
        }
    }
    text
}

fn human(report: &Report, changes: Option<&Told>, (most, all): (usize, bool)) -> String {
    let outcome = match (report.moved.len(), report.drifted) {
        (0, 0) => "same".to_string(),
        (0, drifted) => format!("same within tolerance: {drifted} drifted, at most {:.1e}", report.largest_drift),
        (moved, _) => format!("{moved} moved"),
    };
    let apart = changes.and_then(|told| told.apart.as_ref());
    let apart = apart.map_or(String::new(), |apart| format!("{}\n", visible::line(&apart.words())));
    let mut text = format!("{apart}{outcome} ({} values compared)\n", report.compared);
    if !report.not_compared.is_empty() {
        let _ = writeln!(text, "{}", not_compared(report));
    }
    let told = changes.filter(|told| !told.changes.none());
    if let Some(told) = told {
        text.push('\n');
        for line in summary(told, most, all).lines() {
            let _ = writeln!(text, "{}", visible::line(line));
        }
    }
    if told.is_some() && !all {
        let _ = writeln!(
            text,
            "\n{} values moved in all; --all lists them with all methods, calculation lines, profiles and histories",
            report.moved.len()
        );
        return text;
    }
    for d in report.moved.iter().take(most) {
        let [path, old, new] = [&d.path, &d.old, &d.new].map(|part| visible::line(part));
        let _ = write!(text, "  {path}: {old} -> {new}");
        if d.change.is_finite() {
            let _ = write!(text, " ({:.2e} of its peak)", d.change);
        }
        text.push('\n');
    }
    more(&mut text, report.moved.len(), most);
    text
}

fn json(report: &Report, told: Option<&Told>) -> String {
    let changes = told.map(|told| &told.changes);
    let apart = told.and_then(|told| told.apart.as_ref());
    let change = |change: f64| change.is_finite().then_some(change);
    let moved = report.moved.iter();
    let moved: Vec<_> =
        moved.map(|d| json!({"path": d.path, "old": d.old, "new": d.new, "change": change(d.change)})).collect();
    let text = format!(
        "{:#}\n",
        json!({"compared": report.compared, "not_compared": report.not_compared, "drifted": report.drifted,
            "largest_drift": report.largest_drift, "moved": moved, "different_tanks": apart, "changes": changes})
    );
    visible::json(&text).into_owned()
}

fn csv(report: &Report) -> String {
    let mut text = String::from("path,old,new,change\n");
    for d in &report.moved {
        let [path, old, new] = [&d.path, &d.old, &d.new].map(|part| visible::cell(part));
        let _ = writeln!(text, "{path},{old},{new},{:e}", d.change);
    }
    text
}

/// Copies NEW over OLD and appends the reason with what moved to `accepted.json`.
fn bless(args: &Args, report: &Report) -> Result<(), Error> {
    let accepted = args.old.join(ACCEPTED_FILE);
    let mut history: Vec<serde_json::Value> = match files::read_text(&accepted) {
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
