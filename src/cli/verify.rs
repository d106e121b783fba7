//! `tankcheck verify`: the benchmarks of the verification manual.

use files::code::Code;
use std::path::{Path, PathBuf};

use fem::progress::Progress;
use serde_json::json;
use verification::records::{EL_CENTRO, PACOIMA, PARKFIELD};
use verification::{Choice, Entry, Manual, Pace, Pattern, Records, html, manual, tanks};

use crate::cli::progress::Watch;
use crate::cli::table::Table;
use crate::cli::{Global, print};
use crate::error::{EXIT_CHECK_FAILED, EXIT_OK, Error};
use crate::input::records::{ReadOptions, read};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck verify
  tankcheck verify --list                       the benchmarks: page, pace, ids of rows
  tankcheck verify shell-cook                   one page
  tankcheck verify 'F1?' --format json          rows F10 to F17
  tankcheck verify elephant --slow              pages and ids with `elephant` in them, fine meshes too
  tankcheck verify --format html > verification.html
  tankcheck verify --records ~/records          also rows with records that may not be redistributed
  tankcheck verify --slow                       also the rows that take minutes
  tankcheck verify --write docs/verification    write the manual: index, and one page and figure per benchmark

Exit codes: 0 every row that ran is within its tolerance; 1 a row is not; 2 bad input; 3 the computation failed.")]
pub(crate) struct Args {
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

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, global: &Global) -> Result<u8, Error> {
    let pattern = args.pattern.as_deref().map(pattern).transpose()?;
    let records = records(&args)?;
    let choice = Choice {
        pattern: pattern.as_ref(),
        slow: args.slow,
        records: records.as_ref(),
    };
    if args.list {
        print(&list(choice, args.format)?)?;
        return Ok(EXIT_OK);
    }
    let watch = Watch::new(global, "benchmarks");
    watch.stage("benchmarks", choice.parts());
    let mut found = verification::run(choice, &|title| {
        watch.name(title);
        watch.advance(1);
    })?;
    watch.finish();
    if let Some(folder) = &args.write {
        write(folder, &found, choice)?;
    }
    // The manual gets all rows that ran, the output only the requested ones.
    found.rows.retain(|row| pattern.as_ref().is_none_or(|p| p.selects(row)));
    let failed = found.rows.iter().filter(|r| r.fails()).count();
    match args.format {
        Form::Json => print(&format!("{:#}\n", manual::to_json(&found)))?,
        Form::Csv => print(&csv(&found))?,
        Form::Html => print(&html::html(&found)?)?,
        Form::Human => print(&human(&found, failed))?,
    }
    Ok(if failed == 0 { EXIT_OK } else { EXIT_CHECK_FAILED })
}

/// The pattern of the command line; one without a match is an error.
fn pattern(text: &str) -> Result<Pattern, Error> {
    Pattern::new(text).ok_or_else(|| {
        let near = nearest(text);
        let meant = match near.is_empty() {
            true => String::new(),
            false => format!("did you mean {}? ", near.join(" or ")),
        };
        let shown = files::text::line(text);
        Error::input(
            Code::UnknownId,
            format!(
                "PATTERN: found `{shown}`, expected an id of rows or a page, a part of one, or a glob\n  \
             help: {meant}list them with `tankcheck verify --list`"
            ),
        )
    })
}

/// The ids and pages nearest to a misspelt one, three at most; the words of a page count, too.
fn nearest(text: &str) -> Vec<String> {
    let text = text.to_lowercase();
    let length = text.chars().count();
    let distance = |name: &str| {
        let words = name.split('-').chain([name]);
        words
            .map(|word| strsim::damerau_levenshtein(&text, &word.to_lowercase()))
            .min()
            .unwrap_or(usize::MAX)
    };
    let pages = verification::ALL.iter().map(|benchmark| benchmark.id);
    let ids = verification::ALL
        .iter()
        .flat_map(|benchmark| benchmark.ids)
        .map(|id| id.0);
    let mut near: Vec<(usize, &str)> = pages
        .chain(ids)
        .map(|name| (distance(name), name))
        .filter(|(distance, _)| distance * 3 <= length)
        .collect();
    near.sort_unstable();
    near.dedup();
    near.iter().take(3).map(|(_, name)| format!("`{name}`")).collect()
}

/// The accelerograms that the chosen rows need.
fn records(args: &Args) -> Result<Option<Records>, Error> {
    let Some(folder) = &args.records else {
        return Ok(None);
    };
    if !folder.is_dir() {
        return Err(Error::Files(files::error::Error::File {
            code: Code::FileUnreadable,
            path: folder.clone(),
            what: "folder not found, expected a folder with accelerograms".into(),
        }));
    }
    let mut names = vec![EL_CENTRO];
    if writes_dissertation(args) {
        names.extend([PARKFIELD, PACOIMA]);
    }
    let records = Records::read(&names, |name| {
        read(&folder.join(name), &ReadOptions::default()).map(|found| found.record)
    })?;
    Ok(Some(records))
}

/// Whether the page of the dissertation's examples is recomputed: it takes minutes and all records.
fn writes_dissertation(args: &Args) -> bool {
    args.slow && args.write.is_some() && args.records.is_some() && args.pattern.is_none()
}

/// Writes the manual: rows that ran, and the last results of the others.
fn write(folder: &Path, found: &Manual, choice: Choice) -> Result<(), Error> {
    let kept = match folder.join(manual::ROWS).exists() {
        true => manual::read(folder)?,
        false => Vec::new(),
    };
    let merged = manual::merge(&found.rows, &kept, |page, pace| choice.runs(page, pace));
    let dissertation = match (choice.pattern, choice.slow, choice.records) {
        (None, true, Some(records)) => Some(tanks::dissertation::page(records)?),
        _ => None,
    };
    Ok(manual::write(folder, &merged, dissertation)?)
}

/// The chosen benchmarks: page, pace of its rows, ids, title.
fn list(choice: Choice, form: Form) -> Result<String, Error> {
    let words = |paces: &[Pace]| paces.iter().map(|p| p.id()).collect::<Vec<_>>().join(" ");
    let all: Vec<_> = choice.benchmarks().collect();
    match form {
        Form::Json => {
            let each = all.iter().map(|b| {
                let ids = b.ids.iter().map(|(id, what)| json!({"id": id, "what": what}));
                json!({
                    "page": b.id, "title": b.title, "model": b.model,
                    "paces": b.paces().iter().map(|p| p.id()).collect::<Vec<_>>(), "ids": ids.collect::<Vec<_>>(),
                })
            });
            Ok(format!("{:#}\n", json!({"benchmarks": each.collect::<Vec<_>>()})))
        }
        Form::Csv => {
            let mut text = String::from("id,page,pace,what\n");
            for b in all {
                for (id, what) in b.ids {
                    text.push_str(&format!(
                        "{id},{},{},\"{}\"\n",
                        b.id,
                        words(&b.paces()),
                        what.replace('"', "\"\"")
                    ));
                }
            }
            Ok(text)
        }
        Form::Html => Err(Error::input(
            Code::OptionConflict,
            "--list: found --format html, expected human, json or csv\n  help: leave --list out to get the rows as a page"
                .into(),
        )),
        Form::Human => {
            let mut text = String::new();
            for b in &all {
                text.push_str(&format!("{} ({}): {}\n", b.id, words(&b.paces()), b.title));
                for (id, what) in b.ids {
                    text.push_str(&format!("    {id:<16} {what}\n"));
                }
            }
            let ids: usize = all.iter().map(|b| b.ids.len()).sum();
            text.push_str(&format!(
                "{} benchmarks, {ids} ids; fast ones run always, tested and slow ones with --slow, record with --records FOLDER\n",
                all.len()
            ));
            Ok(text)
        }
    }
}

fn human(found: &Manual, failed: usize) -> String {
    let mut table = Table::new(["row", "what", "reference", "computed", "error", "tolerance", "kind", ""]);
    for row in &found.rows {
        let state = match (row.fails(), row.compares()) {
            (true, _) => "OUTSIDE",
            (_, true) => "comparison",
            _ => "ok",
        };
        table.row(manual::cells(row).into_iter().chain([state.to_string()]));
    }
    let mut text = format!("{table}\n");
    let mut needs: Vec<&str> = found.not_run.iter().map(|n| n.needs.as_str()).collect();
    needs.sort_unstable();
    needs.dedup();
    for need in needs {
        let lacking = found.not_run.iter().filter(|n| n.needs == need).map(|n| n.id.as_str());
        text.push_str(&format!(
            "not run without {need}: {}\n",
            lacking.collect::<Vec<_>>().join(", ")
        ));
    }
    let counted = found.rows.iter().filter(|r| r.counts()).count();
    text.push_str(&format!(
        "{} rows ({counted} count as verification), {failed} outside their tolerance\n",
        found.rows.len()
    ));
    text
}

fn csv(found: &Manual) -> String {
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
    let line = |row: &Entry| {
        format!(
            "{},\"{}\",{:e},{},{},{},{},{}\n",
            row.id,
            row.what.replace('"', "\"\""),
            row.reference,
            number(row.computed),
            number(row.computed.map(|_| row.error())),
            number(row.tolerance),
            row.unit,
            row.kind
        )
    };
    let lines = found.rows.iter().map(line).collect::<String>();
    format!("id,what,reference,computed,error,tolerance,unit,kind\n{lines}")
}
