//! The verification manual as a folder: `rows.json`, an index, and a page with its figure a benchmark.
//!
//! `rows.json` stores the computed rows; everything else is a function of it. Rows that a run leaves out (slow ones, those
//! that need a record) keep their last result.

use std::fmt::Write;
use std::path::Path;

use serde_json::json;

use crate::entry::KINDS;
use crate::{ALL, Entry, Error, Manual, Pace, dissertation, find, html};
use files::code::Code;
use files::{Kind, OutputFolder, settle};
use report::template::Templates;
use results::put;

/// Name of the data file.
pub const ROWS: &str = "rows.json";
/// Name of the index.
pub const INDEX: &str = "README.md";

/// Name of the page of the dissertation's tanks on its meshes, which needs three records and minutes.
const TANKS: &str = "dissertation-tanks.md";

/// The manual: which pages it has follows from its rows, so that only those that it always has are known beforehand.
const MANUAL: Kind = Kind {
    id: "verify --write",
    option: "--write",
    names: |name| [ROWS, INDEX].contains(&name),
    keeps: |name| name == TANKS,
};

/// A page: a benchmark with its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Page<'a> {
    /// Id, name of the file.
    pub id: &'a str,
    /// Title.
    pub title: &'a str,
    /// Model, empty if the benchmark is not of this version.
    pub model: &'a str,
    /// Its rows.
    pub rows: Vec<&'a Entry>,
}

/// Rows by page, in the order of their first rows.
pub fn pages(rows: &[Entry]) -> Vec<Page<'_>> {
    let mut all: Vec<Page> = Vec::new();
    for row in rows {
        match all.iter_mut().find(|page| page.id == row.page) {
            Some(page) => page.rows.push(row),
            None => {
                let benchmark = find(&row.page);
                all.push(Page {
                    id: &row.page,
                    title: benchmark.map_or(&row.page, |b| b.title),
                    model: benchmark.map_or("", |b| b.model),
                    rows: vec![row],
                });
            }
        }
    }
    all
}

impl Page<'_> {
    /// The convergence figure, `None` without a study.
    pub fn figure(&self) -> Result<Option<report::figure::Figure>, Error> {
        let studies: Vec<(String, &[(f64, f64)])> = self
            .rows
            .iter()
            .filter(|r| r.convergence.len() > 1)
            .map(|r| (r.what.clone(), r.convergence.as_slice()))
            .collect();
        if studies.is_empty() {
            return Ok(None);
        }
        html::convergence(&format!("convergence-{}", self.id), self.title, &studies).map(Some)
    }
}

/// Rows and benchmarks that did not run, as JSON.
pub fn to_json(manual: &Manual) -> serde_json::Value {
    let row = |row: &Entry| {
        json!({
            "id": row.id, "page": row.page, "what": row.what, "unit": row.unit, "reference": row.reference,
            "reference_kind": row.kind, "reference_source": row.source, "computed": row.computed,
            "error": row.computed.map(|_| row.error()), "tolerance": row.tolerance, "holds": (!row.compares()).then(|| row.holds()),
            "comparison": row.compares(), "counts": row.counts(), "pace": row.pace, "convergence": row.convergence, "remark": row.remark,
            "printed": row.of_dissertation(),
        })
    };
    json!({
        "rows": manual.rows.iter().map(row).collect::<Vec<_>>(),
        "not_run": manual.not_run.iter()
            .map(|n| json!({"id": n.id, "what": n.what, "needs": n.needs})).collect::<Vec<_>>(),
    })
}

/// One line a row: id, what, reference, computed, error, tolerance, kind of the reference.
pub fn cells(row: &Entry) -> [String; 7] {
    [
        row.id.clone(),
        row.what.clone(),
        format!("{} {}", significant(row.reference), unit(&row.unit)).trim_end().to_owned(),
        row.computed.map_or("none".into(), significant),
        deviation(row, row.error(), true),
        row.tolerance.map_or("–".into(), |t| deviation(row, t, false)),
        row.kind.clone(),
    ]
}

/// The number that the dissertation prints, with its unit; a dash without one.
pub(crate) fn printed(row: &Entry) -> String {
    let number = |value| format!("{} {}", significant(value), unit(&row.unit)).trim_end().to_owned();
    row.of_dissertation().map_or("–".into(), number)
}

/// A deviation or tolerance: in percent, or as a bare number where the reference is 0 or it is very small.
fn deviation(row: &Entry, value: f64, sign: bool) -> String {
    let plus = if sign && value > 0.0 { "+" } else { "" };
    match value {
        v if v.is_nan() => "–".into(),
        0.0 => "0".into(),
        v if row.reference == 0.0 || v.abs() < 1e-5 => format!("{plus}{v:.1e}"),
        v if sign => format!("{plus}{:.3} %", 100.0 * v),
        v => format!("{} %", significant_short(100.0 * v)),
    }
}

fn unit(unit: &str) -> &str {
    if matches!(unit, "1" | "-") { "" } else { unit }
}

/// Six significant digits, a power of ten where that is shorter.
fn significant(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        size if !(1e-4..1e9).contains(&size) => format!("{x:.4e}"),
        _ => tank::units::significant(x, 6),
    }
}

/// The fewest digits that agree to three.
fn significant_short(x: f64) -> String {
    format!("{x:.2e}").parse::<f64>().map_or_else(|_| x.to_string(), |v| v.to_string())
}

/// Text in a cell of a Markdown table.
pub(crate) fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// A page as Markdown; `figure`: whether it has a convergence figure.
fn page(page: &Page, figure: bool) -> String {
    let mut text = format!("# {}\n\n", page.title);
    if !page.model.is_empty() {
        let _ = writeln!(text, "**Model.** {}\n", page.model);
    }
    text.push_str("**Sources of the references.**\n\n");
    let mut sources: Vec<(&str, &str)> = Vec::new();
    for row in &page.rows {
        let source = (row.kind.as_str(), row.source.as_str());
        if !sources.contains(&source) {
            sources.push(source);
        }
    }
    for (kind, source) in sources {
        let _ = writeln!(text, "- {kind}: {source}");
    }
    text.push_str("\n| id | what | reference | computed | error | tolerance | reference is | run by | |\n|---|---|---:|---:|---:|---:|---|---|---|\n");
    for row in &page.rows {
        let cells = cells(row).map(|c| cell(&c)).join(" | ");
        let _ = writeln!(text, "| {cells} | {} | {} |", row.pace.command(), remark(row));
    }
    if figure {
        let _ = writeln!(
            text,
            "\n## Convergence\n\nRelative error over the number of elements (or the mesh size) of each study.\n\n![relative error over the mesh]({}.svg)\n",
            page.id
        );
        text.push_str("| what | number of elements or mesh size: relative error |\n|---|---|\n");
        for row in page.rows.iter().filter(|r| r.convergence.len() > 1) {
            let study = row.convergence.iter().map(|(n, e)| format!("{n}: {e:.2e}"));
            let _ = writeln!(text, "| {} | {} |", cell(&row.what), study.collect::<Vec<_>>().join(", "));
        }
    }
    text
}

/// Remark on a row.
pub(crate) fn remark(row: &Entry) -> String {
    let state = match (row.fails(), row.compares()) {
        (true, _) => "**outside**",
        (_, true) => "comparison only",
        _ => "",
    };
    let printed = row.printed.map_or(String::new(), |_| format!("printed: {}", printed(row)));
    let all = [state, printed.as_str(), row.remark.as_str()];
    cell(&all.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join("; "))
}

/// The index: how many rows of each kind, the pages, the ids.
fn index(rows: &[Entry]) -> String {
    let mut text = String::from(
        "# Verification manual\n\n\
         Generated from `rows.json` by `cargo run --release -p verification -- --write docs/verification`; do not edit. Each row holds a \
         computed value, a reference that was not made by this program, and the kind of the reference. \
         A row without a tolerance is for comparison only: it cannot fail. The column *run by* names the \
         command that asserts a row: `cargo test` (`crates/verification/tests/benchmarks.rs`); `verification --slow`, which \
         takes minutes; or `verification --records FOLDER`, which needs an accelerogram that may not be redistributed \
         (`imperial-valley-1940-el-centro-ns.csv`: El Centro 1940 NS, Caltech Vol. II, 0.348 g, columns \
         `time_s,acceleration_m_s2`). A run without these options keeps the last result. `cargo test` asserts that this \
         manual is fresh. `verification` stands for `cargo run --release -p verification --`; followed by a page or an id it runs these rows.\n\n\
         | reference | meaning | rows | within tolerance | for comparison only |\n|---|---|---:|---:|---:|\n",
    );
    for (kind, meaning) in KINDS {
        let of: Vec<&Entry> = rows.iter().filter(|r| r.kind == kind).collect();
        let held = of.iter().filter(|r| r.holds()).count();
        let shown = of.iter().filter(|r| r.compares()).count();
        let _ = writeln!(text, "| {kind} | {meaning} | {} | {held} | {shown} |", of.len());
    }
    let counted = rows.iter().filter(|r| r.counts()).count();
    let failed = rows.iter().filter(|r| r.fails()).count();
    let by = |pace: &[Pace]| rows.iter().filter(|r| !r.compares() && pace.contains(&r.pace)).count();
    let _ = writeln!(
        text,
        "\nOf the rows with a tolerance `cargo test` asserts {}, `verification --slow` {} more, and `verification \
         --records` {} more.",
        by(&[Pace::Fast, Pace::Tested]),
        by(&[Pace::Slow]),
        by(&[Pace::Record]),
    );
    let _ = writeln!(
        text,
        "\n{counted} rows count as verification (neither regressions nor rows for comparison only); {failed} rows are \
         outside their tolerance.\n\n| benchmark | rows | references | largest error / tolerance |\n|---|---:|---|---:|"
    );
    for page in pages(rows) {
        text.push_str(&index_line(&page));
    }
    text.push_str(&ids());
    text
}

/// The line of a page in the index.
fn index_line(page: &Page) -> String {
    let mut kinds: Vec<&str> = Vec::new();
    for row in &page.rows {
        if !kinds.contains(&row.kind.as_str()) {
            kinds.push(&row.kind);
        }
    }
    let worst = page
        .rows
        .iter()
        .filter_map(|r| Some((r.error().abs(), r.tolerance?)))
        .map(|(e, t)| if e == 0.0 { 0.0 } else { e / t })
        .fold(0.0, f64::max);
    format!("| [{}]({}.md) | {} | {} | {worst:.2} |\n", cell(page.title), page.id, page.rows.len(), kinds.join(", "))
}

/// The letters that begin ids.
const SERIES: &str = "\n## Ids\n\nAn id names what is compared; rows of one id differ in the quantity or the mesh. C: solid \
elements, joints, layered walls and strip 8.4. D: dynamics. F: the liquid with its tank. K: the displacement liquid. M: stress \
laws. S: shells. X: tanks of other programs and tests. All others are named after the table, figure or example of their source.\n\n\
| id | what it compares | page |\n|---|---|---|\n";

/// The table of ids: letter, then number, then all others.
fn ids() -> String {
    let mut all: Vec<_> =
        ALL.iter().flat_map(|benchmark| benchmark.ids.iter().map(move |&(id, what)| (id, what, *benchmark))).collect();
    all.sort_by_key(|(id, ..)| {
        let number = id.get(1..).and_then(|digits| digits.parse::<u32>().ok());
        let letter = number.and(id.chars().next());
        (letter.is_none(), letter, number)
    });
    let mut text = String::from(SERIES);
    for (id, what, benchmark) in all {
        let _ = writeln!(text, "| {id} | {} | [{}]({}.md) |", cell(what), cell(benchmark.title), benchmark.id);
    }
    text
}

/// All files of the manual but `rows.json`: name and text.
pub fn files(rows: &[Entry]) -> Result<Vec<(String, String)>, Error> {
    let mut files = vec![(INDEX.to_owned(), index(rows))];
    let templates = Templates::new(None)?;
    let css = templates.css("figure.css");
    for found in pages(rows) {
        let figure = found.figure()?;
        let mut text = page(&found, figure.is_some());
        if found.id == dissertation::ID {
            text.push_str(&dissertation::page::gathered(rows));
        }
        files.push((format!("{}.md", found.id), text));
        if let Some(figure) = figure {
            files.push((format!("{}.svg", found.id), figure.standalone(css)));
        }
    }
    Ok(files)
}

/// Reads the rows of a manual.
///
/// Errors: a file that cannot be read or holds no rows.
pub fn read(folder: &Path) -> Result<Vec<Entry>, Error> {
    settle(folder);
    let path = folder.join(ROWS);
    let fault =
        |what: String| Error::Files(files::error::Error::File { code: Code::NotResults, path: path.clone(), what });
    let text = std::fs::read_to_string(&path).map_err(|e| files::error::Error::unreadable(&path, &e))?;
    serde_json::from_str(&text).map_err(|e| fault(format!("not the rows of a verification manual: {e}")))
}

/// Fresh rows with the last results of those that did not run this time, in the order of [`ALL`]; `ran(page, pace)`.
/// Rows of removed benchmarks are left out.
pub fn merge(fresh: &[Entry], kept: &[Entry], ran: impl Fn(&str, Pace) -> bool) -> Vec<Entry> {
    let old = kept.iter().filter(|row| !ran(&row.page, row.pace));
    let place = |row: &Entry| ALL.iter().position(|benchmark| benchmark.id == row.page);
    let mut rows: Vec<Entry> = fresh.iter().chain(old).filter(|r| place(r).is_some()).cloned().collect();
    // Stable: rows keep their order within a page.
    rows.sort_by_key(place);
    rows
}

/// Writes the manual: rows, index, pages and figures, and the page of the dissertation's tanks if there is a new one; removes pages
/// of benchmarks that are gone.
///
/// Errors: a folder that cannot be written, a drawing that fails.
pub fn write(folder: &Path, rows: &[Entry], tanks: Option<String>) -> Result<(), Error> {
    // Everything is made before anything is written.
    let mut files = files(rows)?;
    let lines: Result<Vec<String>, _> = rows.iter().map(serde_json::to_string).collect();
    let lines = lines.map_err(|e| files::error::Error::Report(e.to_string()))?;
    files.push((ROWS.into(), format!("[\n{}\n]\n", lines.join(",\n"))));
    files.extend(tanks.map(|text| (TANKS.to_owned(), text)));
    let output = OutputFolder::prepare(folder, MANUAL)?;
    for (name, text) in &files {
        put(&output.path().join(name), text.as_bytes())?;
    }
    Ok(output.commit()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Reference, Row};

    fn entry(page: &'static str, kind: Reference, computed: f64, tolerance: f64, pace: Pace) -> Entry {
        let row = Row {
            id: "X1".into(),
            what: "a | b".into(),
            reference: 2.0,
            source: "by hand",
            kind,
            computed,
            tolerance,
            unit: "m",
            convergence: vec![(10.0, 0.1), (20.0, 0.05)],
            remark: String::new(),
            printed: None,
        };
        Entry::of(&row, page, pace)
    }

    #[test]
    fn regressions_and_rows_without_tolerance_do_not_count() {
        let rows = [
            entry("p", Reference::ClosedForm, 2.001, 0.01, Pace::Fast),
            entry("p", Reference::Regression, 2.0, 0.01, Pace::Fast),
            entry("q", Reference::Dissertation, 3.0, f64::INFINITY, Pace::Fast),
            entry("q", Reference::Published, f64::NAN, 0.01, Pace::Slow),
        ];
        assert_eq!(rows.iter().filter(|r| r.counts()).count(), 2);
        assert_eq!(
            rows.iter().map(Entry::holds).collect::<Vec<_>>(),
            [true, true, false, false],
            "a row for comparison is never counted as within its tolerance"
        );
        assert_eq!(rows.iter().map(Entry::fails).collect::<Vec<_>>(), [false, false, false, true]);
        let text = index(&rows);
        assert!(text.contains("\n2 rows count as verification") && text.contains("1 rows are outside"), "{text}");
        assert!(page(&pages(&rows)[0], true).contains("a \\| b"));
    }

    #[test]
    fn what_did_not_run_keeps_its_last_result() {
        let slow = entry("shell-cook", Reference::Published, 2.0, 0.01, Pace::Slow);
        let old = entry("fluid-rank", Reference::ClosedForm, 2.5, 0.01, Pace::Fast);
        let new = entry("fluid-rank", Reference::ClosedForm, 2.0, 0.01, Pace::Fast);
        let gone = entry("a-benchmark-of-the-past", Reference::Published, 2.0, 0.01, Pace::Slow);
        let rows = merge(std::slice::from_ref(&new), &[old, gone, slow.clone()], |_, pace| pace == Pace::Fast);
        // In the order of the registry: the shell comes first.
        assert_eq!(rows, [slow, new]);
    }

    #[test]
    fn a_manual_is_read_as_it_was_written() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let rows = vec![
            entry("p", Reference::ClosedForm, 2.001, 0.01, Pace::Fast),
            entry("q", Reference::Dissertation, 3.0, f64::INFINITY, Pace::Fast),
        ];
        write(home.path(), &rows, None).expect("writable");
        assert_eq!(read(home.path()).expect("readable"), rows);
        assert!(home.path().join("p.svg").exists());
        // A benchmark that is gone takes its page along.
        write(home.path(), &rows[1..], None).expect("writable");
        assert!(!home.path().join("p.md").exists() && home.path().join("q.md").exists());
    }
}
