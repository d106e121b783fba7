//! What the program prints: the list of benchmarks, and rows as a table, JSON, CSV or a page.

use files::code::Code;
use serde_json::json;
use verification::{Choice, Entry, Error, Manual, Pace, html, manual};

use crate::Form;

/// The chosen benchmarks: page, pace of its rows, ids, title.
///
/// Errors: a form that a list does not have.
pub(crate) fn list(choice: Choice, form: Form) -> Result<String, Error> {
    let words = |paces: &[Pace]| paces.iter().map(|p| p.id()).collect::<Vec<_>>().join(" ");
    let all: Vec<_> = choice.benchmarks().collect();
    let mut text = String::new();
    match form {
        Form::Json => {
            let each = all.iter().map(|b| {
                let ids = b.ids.iter().map(|(id, what)| json!({"id": id, "what": what}));
                json!({
                    "page": b.id, "title": b.title, "model": b.model,
                    "paces": b.paces().iter().map(|p| p.id()).collect::<Vec<_>>(), "ids": ids.collect::<Vec<_>>(),
                })
            });
            text = format!("{:#}\n", json!({"benchmarks": each.collect::<Vec<_>>()}));
        }
        Form::Csv => {
            text.push_str("id,page,pace,what\n");
            for b in all {
                for (id, what) in b.ids {
                    text.push_str(&format!("{id},{},{},{}\n", b.id, words(&b.paces()), quoted(what)));
                }
            }
        }
        Form::Html => {
            let what = "--list: found --format html, expected human, json or csv\n  help: leave --list out to get the rows as a page";
            return Err(files::error::Error::Input(Code::OptionConflict, what.into()).into());
        }
        Form::Human => {
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
        }
    }
    Ok(text)
}

/// The rows of a run.
///
/// Errors: a page that cannot be rendered.
pub(crate) fn rows(found: &Manual, form: Form) -> Result<String, Error> {
    Ok(match form {
        Form::Json => format!("{:#}\n", manual::to_json(found)),
        Form::Csv => csv(found),
        Form::Html => html::html(found)?,
        Form::Human => human(found),
    })
}

fn human(found: &Manual) -> String {
    let head = ["row", "what", "reference", "computed", "error", "tolerance", "kind", ""];
    let mut lines = vec![head.map(str::to_owned)];
    for row in &found.rows {
        let state = match (row.fails(), row.compares()) {
            (true, _) => "OUTSIDE",
            (_, true) => "comparison",
            _ => "ok",
        };
        let [id, what, reference, computed, error, tolerance, kind] = manual::cells(row);
        lines.push([id, what, reference, computed, error, tolerance, kind, state.into()]);
    }
    let mut text = format!("{}\n", table(&lines));
    let mut needs: Vec<&str> = found.not_run.iter().map(|n| n.needs.as_str()).collect();
    needs.sort_unstable();
    needs.dedup();
    for need in needs {
        let lacking = found.not_run.iter().filter(|n| n.needs == need).map(|n| n.id.as_str());
        let lacking = lacking.collect::<Vec<_>>().join(", ");
        text.push_str(&format!("not run without {need}: {lacking}\n"));
    }
    let counted = found.rows.iter().filter(|r| r.counts()).count();
    let failed = found.rows.iter().filter(|r| r.fails()).count();
    text.push_str(&format!(
        "{} rows ({counted} count as verification), {failed} outside their tolerance\n",
        found.rows.len()
    ));
    text
}

/// Lines with their cells below each other, the first column on the left and all others on the right; the first line is the head.
fn table(lines: &[[String; 8]]) -> String {
    let widths: [usize; 8] = std::array::from_fn(|c| {
        let cells = lines.iter().map(|cells| cells[c].chars().count());
        cells.max().unwrap_or(0)
    });
    let mut text = String::new();
    for (i, cells) in lines.iter().enumerate() {
        let mut line = format!("{:<w$}", cells[0], w = widths[0]);
        for (cell, width) in cells.iter().zip(widths).skip(1) {
            line.push_str(&format!("  {cell:>width$}"));
        }
        text.push_str(line.trim_end());
        text.push('\n');
        if i == 0 {
            text.push_str(&"─".repeat(widths.iter().sum::<usize>() + 2 * (widths.len() - 1)));
            text.push('\n');
        }
    }
    text
}

fn csv(found: &Manual) -> String {
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
    let line = |row: &Entry| {
        format!(
            "{},{},{:e},{},{},{},{},{}\n",
            row.id,
            quoted(&row.what),
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

/// Text as a cell in quotes.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
