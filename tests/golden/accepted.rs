//! Accepted results: compared with those of a run, and replaced by them.
//!
//! | folder | holds |
//! |---|---|
//! | `reports/NN` | `results.json`, `ida.json` or `push.json`; `report.html` of one run of each example, of `ida` and of `push` |
//! | `tests/golden/histories/NN` | `series.csv` of `reports/NN`, with 50 of its rows |
//! | `tests/golden/short/NN` | numbers and whole histories of a short run |
//!
//! `TANKCHECK_BLESS="reason"` replaces what moved and leaves the rest as it is; the reason goes into the commit message.

use std::path::{Path, PathBuf};

use results::numdiff::{self, Options};

/// Files that hold the numbers of a run.
pub(crate) const NUMBERS: [&str; 3] = ["results.json", "ida.json", "push.json"];
const PAGE: &str = "report.html";
const SERIES: &str = "series.csv";
/// Rows that are kept of a table of histories, evenly spaced.
const ROWS: usize = 50;

/// Root of the repository.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Differences between the results in `out` and the accepted ones; with `TANKCHECK_BLESS` those that remain after acceptance.
///
/// * `golden`: folder of the accepted results, below the root
/// * `page`: whether the report is kept
pub(crate) fn check(golden: &str, out: &Path, page: bool) -> Vec<String> {
    let mut faults = differences(golden, out);
    if std::env::var_os("TANKCHECK_BLESS").is_some() {
        let moved = !faults.is_empty();
        if moved {
            accept_numbers(golden, out);
            faults = differences(golden, out);
        }
        if page && (moved || page_differs(golden, out)) {
            copy(PAGE, out, golden);
        }
    }
    faults.into_iter().map(|fault| format!("{golden}: {fault}")).collect()
}

/// The most of them: ten numbers and ten rows.
fn differences(golden: &str, out: &Path) -> Vec<String> {
    let folder = root().join(golden);
    let report = match numdiff::folders(&folder, out, &Options::default()) {
        Ok(report) => report,
        Err(error) => return vec![error.to_string()],
    };
    assert!(report.compared > 100, "{golden}: {} values", report.compared);
    let moved = report.moved.iter().take(10);
    let mut faults: Vec<String> =
        moved.map(|m| format!("{}: {} -> {} ({:.1e})", m.path, m.old, m.new, m.change)).collect();
    match histories(golden) {
        Some(kept) => faults.extend(moved_rows(&kept, out).into_iter().take(10)),
        // Whole ones are compared above.
        None if out.join(SERIES).exists() && !folder.join(SERIES).exists() => {
            faults.push(format!("{SERIES} is not kept"))
        }
        None => {}
    }
    faults
}

/// Folder of the kept rows of the histories; none of a short run, which keeps all of them beside its numbers.
fn histories(golden: &str) -> Option<PathBuf> {
    let name = golden.strip_prefix("reports/")?;
    Some(root().join("tests/golden/histories").join(name))
}

/// Indices of the rows that are kept of a table of `length` rows, the first and the last among them.
fn rows(length: usize) -> Vec<usize> {
    if length > ROWS { (0..ROWS).map(|i| i * (length - 1) / (ROWS - 1)).collect() } else { (0..length).collect() }
}

/// Values of the kept rows that moved, relative to the peak of the whole column.
fn moved_rows(kept: &Path, out: &Path) -> Vec<String> {
    let [old, new] = [kept, out].map(|folder| results::read_series(folder).expect("a table of histories"));
    let rows = rows(new.time.len());
    if old.ids != new.ids || old.time.len() != rows.len() {
        let size = |rows: usize, ids: &[String]| format!("{rows} rows of {}", ids.join(","));
        let (old, new) = (size(old.time.len(), &old.ids), size(rows.len(), &new.ids));
        return vec![format!("{SERIES}: {old} -> {new}")];
    }
    let rtol = Options::default().rtol;
    let mut moved = Vec::new();
    let mut column = |id: &str, old: &[f64], new: &[f64]| {
        let allowed = rtol * new.iter().fold(0.0_f64, |peak, x| peak.max(x.abs()));
        for (a, row) in old.iter().zip(&rows) {
            let b = new[*row];
            // Histories of a run that stopped early end in NaN.
            if !((a - b).abs() <= allowed || (a.is_nan() && b.is_nan())) {
                moved.push(format!("{SERIES}:{id}[{row}]: {a} -> {b}"));
            }
        }
    };
    column("time_s", &old.time, &new.time);
    for (id, (old, new)) in old.ids.iter().zip(old.columns.iter().zip(&new.columns)) {
        column(id, old, new);
    }
    moved
}

fn accept_numbers(golden: &str, out: &Path) {
    for name in NUMBERS {
        copy(name, out, golden);
    }
    let Some(kept) = histories(golden) else { return copy(SERIES, out, golden) };
    if let Ok(text) = std::fs::read_to_string(out.join(SERIES)) {
        let (head, table) = text.split_once('\n').expect("a head");
        let table: Vec<&str> = table.lines().collect();
        let shown = rows(table.len()).into_iter().map(|row| table[row]);
        let lines: Vec<&str> = std::iter::once(head).chain(shown).collect();
        std::fs::create_dir_all(&kept).expect("writable");
        std::fs::write(kept.join(SERIES), lines.join("\n") + "\n").expect("writable");
    }
}

/// Copies a file if there is one; its command names the accepted folder in place of the temporary one.
fn copy(name: &str, out: &Path, golden: &str) {
    if let Ok(text) = std::fs::read_to_string(out.join(name)) {
        let folder = root().join(golden);
        std::fs::create_dir_all(&folder).expect("writable");
        std::fs::write(folder.join(name), text.replace(&out.display().to_string(), golden)).expect("writable");
    }
}

/// Whether the pages differ in more than version, date and command.
fn page_differs(golden: &str, out: &Path) -> bool {
    let lasting = |folder: &Path| std::fs::read_to_string(folder.join(PAGE)).ok().map(|html| lasting(&html));
    lasting(&root().join(golden)) != lasting(out)
}

/// A page without what differs between two runs.
pub(crate) fn lasting(html: &str) -> String {
    let Some((before, rest)) = html.split_once("<dl class=\"pairs\" id=\"volatile\">") else { return html.to_owned() };
    let after = rest.split_once("</dl>").map_or("", |(_, after)| after);
    format!("{before}{after}")
}

/// A value of a kept row that moved is found, and so are another row and another column.
#[test]
fn a_moved_history_is_found() {
    let [kept, out] = [(); 2].map(|()| tempfile::tempdir().expect("a temporary folder"));
    let table = |rows: &[usize], moved: Option<usize>, head: &str| {
        let value = |i: usize| (i as f64).sin() + if moved == Some(i) { 1e-5 } else { 1e-8 };
        let lines = rows.iter().map(|&i| format!("{},{:e}\n", i as f64 * 0.01, value(i)));
        format!("{head}\n{}", lines.collect::<String>())
    };
    let all: Vec<usize> = (0..1234).collect();
    let some = rows(all.len());
    assert_eq!((some.len(), some[0], some[49]), (ROWS, 0, 1233));
    let head = "time_s,base_shear [N]";
    let moved = |rows: &[usize], place: Option<usize>, head: &str| {
        std::fs::write(kept.path().join(SERIES), table(rows, place, head)).expect("writable");
        moved_rows(kept.path(), out.path()).len()
    };
    std::fs::write(out.path().join(SERIES), table(&all, None, head)).expect("writable");
    assert_eq!(moved(&some, None, head), 0);
    assert_eq!(moved(&some, Some(some[7]), head), 1);
    assert_eq!(moved(&some[1..], None, head), 1);
    assert_eq!(moved(&some, None, "time_s,base_moment [N*m]"), 1);
    let shifted: Vec<usize> = some.iter().map(|i| i + 1).collect();
    assert!(moved(&shifted, None, head) > ROWS);
}
