//! Reading and writing the results folder.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::channel::{GROUND_COLUMNS, VERTICAL_PREFIX};
use super::digits::{self, rounded};
use super::{FORMAT, Results, Run, Series, layout, previous, scene, transfer};
use files::code::Code;
use files::error::{Error, describe};
use files::{Kind, settle, write_whole};
use tank::units::Dimension;

/// Name of the results file in a results folder.
pub const RESULTS_FILE: &str = "results.json";
/// Name of the time histories in a results folder.
pub const SERIES_FILE: &str = "series.csv";
/// Name of the transfer functions in a results folder.
pub const TRANSFER_FILE: &str = "transfer.csv";
/// Name of the report in a results folder.
pub const REPORT_FILE: &str = "report.html";
/// Folder of the figures in a results folder.
pub const FIGURES_FOLDER: &str = "figures";

/// Files and folders that a verification writes.
pub const OUTPUT: [&str; 6] = [RESULTS_FILE, SERIES_FILE, TRANSFER_FILE, scene::FILE, REPORT_FILE, FIGURES_FOLDER];

/// Results of a verification.
pub const COMPARE: Kind =
    Kind { id: "compare", option: "--out", names: |name| OUTPUT.contains(&name), keeps: |_| false };

/// Other forms of a report that may stand next to it: for print, for a text processor, for a spreadsheet, to look at with scripts.
pub const FORMS: [&str; 4] = ["report.pdf", "report.docx", "report.xlsx", "interactive.html"];

/// The report of a verification, rendered again next to its results.
pub const COMPARE_REPORT: Kind = Kind {
    names: |name| [REPORT_FILE, FIGURES_FOLDER].contains(&name),
    keeps: |name| [RESULTS_FILE, SERIES_FILE, TRANSFER_FILE, scene::FILE].contains(&name) || FORMS.contains(&name),
    option: "a copy of results.json and series.csv",
    ..COMPARE
};

/// Reads `results.json` of a results folder; one of the previous format is converted.
///
/// Errors: missing or unreadable file, text that is not JSON, another format version.
pub fn read(folder: &Path) -> Result<Results, Error> {
    let path = folder.join(RESULTS_FILE);
    let fault = |what: String| Error::File { code: Code::NotResults, path: path.clone(), what };
    let _reading = settle(folder);
    if !folder.is_dir() {
        return Err(Error::File {
            code: Code::NotResults,
            path: folder.into(),
            what: "no such results folder; `tankcheck compare` writes one".into(),
        });
    }
    // Folders of commands whose results are not a comparison.
    for (file, command) in [("ida.json", "ida"), ("push.json", "push")] {
        if !path.exists() && folder.join(file).exists() {
            return Err(Error::File {
                code: Code::NotResults,
                path: folder.into(),
                what: format!(
                    "holds the results of `tankcheck {command}` ({file}), allowed those of `tankcheck compare` or `tankcheck check`; its \
                     report.html is complete in itself"
                ),
            });
        }
    }
    let text = files::read_text(&path).map_err(|e| Error::unreadable(&path, &e))?;
    let no_results = |e: serde_json::Error| fault(format!("not a results file: {e}"));
    #[derive(Deserialize)]
    struct Head {
        format: String,
    }
    let head: Head = serde_json::from_str(&text).map_err(no_results)?;
    match head.format.as_str() {
        FORMAT => serde_json::from_str(&text).map_err(no_results),
        older if previous::FORMATS.contains(&older) => {
            let value = serde_json::from_str(&text).map_err(no_results)?;
            serde_json::from_value(previous::convert(value)).map_err(no_results)
        }
        other => {
            Err(fault(format!("format `{other}`, this version reads `{FORMAT}`, `{}`", previous::FORMATS.join("`, `"))))
        }
    }
}

/// Reads `series.csv` of a results folder; empty if there is none (`check` writes none).
pub fn read_series(folder: &Path) -> Result<Series, Error> {
    let path = folder.join(SERIES_FILE);
    if !path.exists() {
        return Ok(Series::default());
    }
    let fault = |what: String| Error::File { code: Code::NotResults, path: path.clone(), what };
    let damaged = |e: std::io::Error| fault(e.to_string());
    let open = || files::open(&path).map(|file| BufReader::with_capacity(GATHERED, file));
    // Columns that grow side by side leave holes as large as they are.
    let [rows, bytes] = open().and_then(extent).map_err(damaged)?;
    let mut reader = open().map_err(damaged)?;
    let mut line = String::new();
    reader.read_line(&mut line).map_err(damaged)?;
    // Ids are plain words: a quotation mark is damage, and must not swallow the lines after it.
    let mut heads = row(&line).split(',');
    let first = heads.next().unwrap_or("");
    if first != "time_s" {
        return Err(fault(format!("first column is `{first}`, expected `time_s`")));
    }
    let ids: Vec<String> = heads.map(|head| id_of(head).to_owned()).collect();
    // A cell takes two bytes at least.
    let column = || Vec::with_capacity(rows.min(bytes / (2 * ids.len() + 2)));
    let mut series = Series { time: column(), columns: ids.iter().map(|_| column()).collect(), ids };
    for number in 2.. {
        line.clear();
        if reader.read_line(&mut line).map_err(damaged)? == 0 {
            break;
        }
        let line = row(&line);
        if line.is_empty() {
            continue;
        }
        let expected = series.ids.len() + 1;
        let uneven = || fault(format!("line {number}: found {} columns, expected {expected}", line.split(',').count()));
        let mut cells = line.split(',');
        for column in std::iter::once(&mut series.time).chain(&mut series.columns) {
            let text = cells.next().ok_or_else(uneven)?;
            column.push(text.parse().map_err(|_| fault(format!("line {number}: `{text}` is not a number")))?);
        }
        if cells.next().is_some() {
            return Err(uneven());
        }
    }
    Ok(series)
}

/// Numbers of lines and of bytes.
fn extent(mut reader: impl BufRead) -> std::io::Result<[usize; 2]> {
    let (mut lines, mut bytes) = (0, 0);
    loop {
        let part = reader.fill_buf()?;
        if part.is_empty() {
            return Ok([lines, bytes]);
        }
        lines += part.iter().filter(|byte| **byte == b'\n').count();
        let read = part.len();
        bytes += read;
        reader.consume(read);
    }
}

/// A line without its end.
fn row(line: &str) -> &str {
    line.trim_end_matches(['\n', '\r'])
}

/// Writes `results.json`, `series.csv` (unless empty) and `transfer.csv` (of the first run that has one) into an existing folder.
///
/// Numbers of `results.json` are written with 10 significant digits: far below the accuracy of any method, and enough
/// for differences between processors to vanish. Factors of an attribution have 12, so that their product closes to 1e-9.
pub fn write(folder: &Path, results: &Results, series: &Series) -> Result<(), Error> {
    let path = folder.join(RESULTS_FILE);
    let mut value = serde_json::to_value(results).map_err(|e| Error::Report(e.to_string()))?;
    round_numbers(&mut value, DIGITS);
    put(&path, layout::text(&value).as_bytes())?;
    let functions = |run: &Run| Some(transfer::csv(run.part("transfer")?.table("transfer")?));
    if let Some(functions) = results.runs.iter().find_map(functions) {
        put(&folder.join(TRANSFER_FILE), functions.as_bytes())?;
    }
    if series.time.is_empty() {
        return Ok(());
    }
    let path = folder.join(SERIES_FILE);
    let file = std::fs::File::create(&path);
    let written = file.and_then(|file| write_series(&file, series, &units(results)));
    written.map_err(|e| Error::Unwritten { path, what: describe(&e) })
}

/// Symbols of the units of the columns by id, of all runs and of the ground.
fn units(results: &Results) -> BTreeMap<String, &'static str> {
    let mut units = BTreeMap::new();
    for (number, run) in results.runs.iter().enumerate() {
        let prefix = if number == 0 { "" } else { run.engine.prefix() };
        for history in &run.histories {
            units.insert(format!("{prefix}{}", history.id), history.dimension.si_symbol());
        }
    }
    let ground = [Dimension::Acceleration, Dimension::Velocity, Dimension::Length];
    for (id, dimension) in GROUND_COLUMNS.into_iter().zip(ground) {
        for prefix in ["", VERTICAL_PREFIX] {
            units.insert(format!("{prefix}{id}"), dimension.si_symbol());
        }
    }
    units
}

/// Head of a column: `base_shear [N]`; without a unit the id alone.
fn head(id: &str, units: &BTreeMap<String, &'static str>) -> String {
    match units.get(id) {
        Some(unit) if !unit.is_empty() => format!("{id} [{unit}]"),
        _ => id.to_owned(),
    }
}

/// The id in the head of a column; earlier versions wrote no units.
fn id_of(head: &str) -> &str {
    head.split_once(" [").map_or(head, |(id, _)| id)
}

/// Significant digits in `series.csv`: of times, and of all else.
const DIGITS_OF_SERIES: [usize; 2] = [9, 7];

impl Series {
    /// The histories as [`read_series`] finds them in the file.
    pub fn as_written(mut self) -> Series {
        let [of_time, of_columns] = DIGITS_OF_SERIES;
        self.time.iter_mut().for_each(|t| *t = rounded(*t, of_time));
        self.columns.iter_mut().flatten().for_each(|x| *x = rounded(*x, of_columns));
        self
    }
}

/// Bytes of `series.csv` that are written or read at once.
const GATHERED: usize = 1 << 20;

/// Writes `series.csv`.
///
/// * `units`: symbols of units by id
fn write_series(
    mut file: &std::fs::File,
    series: &Series,
    units: &BTreeMap<String, &'static str>,
) -> std::io::Result<()> {
    let [of_time, of_columns] = DIGITS_OF_SERIES;
    let mut text = b"time_s".to_vec();
    for id in &series.ids {
        text.push(b',');
        text.extend_from_slice(head(id, units).as_bytes());
    }
    text.push(b'\n');
    for (i, t) in series.time.iter().enumerate() {
        write!(text, "{}", rounded(*t, of_time))?;
        for column in &series.columns {
            text.push(b',');
            digits::append(&mut text, column[i], of_columns);
        }
        text.push(b'\n');
        if text.len() >= GATHERED {
            file.write_all(&text)?;
            text.clear();
        }
    }
    file.write_all(&text)
}

/// Reads a JSON document of this `format` from `path`; `what` names it in messages.
///
/// Errors: an unreadable file, text that is not JSON, another format version.
pub(super) fn read_document<T: DeserializeOwned>(path: &Path, format: &str, what: &str) -> Result<T, Error> {
    let fault = |what: String| Error::File { code: Code::NotResults, path: path.into(), what };
    let text = files::read_text(path).map_err(|e| Error::unreadable(path, &e))?;
    let value: serde_json::Value =
        serde_json::from_str(&text).map_err(|e| fault(format!("not the results of {what}: {e}")))?;
    match value.get("format").and_then(serde_json::Value::as_str) {
        Some(found) if found == format => {}
        Some(other) => return Err(fault(format!("format `{other}`, this version reads `{format}`"))),
        None => return Err(fault(format!("not the results of {what}: no format"))),
    }
    serde_json::from_value(value).map_err(|e| fault(format!("not the results of {what}: {e}")))
}

/// Writes a file of a folder of results.
///
/// Errors: [`Error::Unwritten`].
pub fn put(path: &Path, text: &[u8]) -> Result<(), Error> {
    std::fs::write(path, text).map_err(|e| Error::Unwritten { path: path.into(), what: describe(&e) })
}

/// Writes a JSON document to `path`, whole or not at all; 10 significant digits.
///
/// Errors: a file that cannot be written.
pub(super) fn write_document(path: &Path, document: &impl Serialize) -> Result<(), Error> {
    let mut value = serde_json::to_value(document).map_err(|e| Error::Report(e.to_string()))?;
    round_numbers(&mut value, DIGITS);
    write_whole(path, layout::text(&value).as_bytes())
}

/// Significant digits of numbers in JSON.
const DIGITS: usize = 10;
/// Those of attributions: thirty factors, each rounded to 5e-12, close to 1.5e-10.
const DIGITS_OF_FACTORS: usize = 12;

/// Rounds every number of a JSON value to this many significant digits.
fn round_numbers(value: &mut serde_json::Value, digits: usize) {
    use serde_json::Value;
    match value {
        Value::Number(number) if number.is_f64() => {
            if let Some(rounded) = number.as_f64().and_then(|x| serde_json::Number::from_f64(rounded(x, digits))) {
                *number = rounded;
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| round_numbers(item, digits)),
        Value::Object(map) => {
            for (key, member) in map {
                let own = if key == "attribution" { DIGITS_OF_FACTORS } else { digits };
                round_numbers(member, own);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heads_have_units_and_old_heads_none() {
        let units = BTreeMap::from([("base_shear".to_owned(), "N"), ("open_share".to_owned(), "")]);
        assert_eq!(head("base_shear", &units), "base_shear [N]");
        assert_eq!((head("open_share", &units), head("other", &units)), ("open_share".into(), "other".into()));
        assert_eq!((id_of("base_shear [N]"), id_of("base_shear")), ("base_shear", "base_shear"));
    }

    #[test]
    fn histories_as_written_are_those_that_are_read() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let values = [0.0, -0.0, 1.0 / 3.0, -2e9 / 7.0, 9.99999951e-7, 1e-320, 4.2e300, f64::INFINITY];
        let time = (0..values.len()).map(|i| i as f64 / 300.0).collect();
        let series = Series { time, ids: vec!["a".into()], columns: vec![values.to_vec()] };
        let file = std::fs::File::create(folder.path().join(SERIES_FILE)).expect("writable");
        write_series(&file, &series, &BTreeMap::new()).expect("written");
        assert_eq!(read_series(folder.path()).expect("readable"), series.as_written());
    }

    #[test]
    fn uneven_lines_and_words_are_refused_with_their_line() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let read = |text: &str| {
            std::fs::write(folder.path().join(SERIES_FILE), text).expect("writable");
            read_series(folder.path()).map_err(|e| e.to_string())
        };
        for (line, what) in [
            ("0.5,3", "line 3: found 2 columns, expected 3"),
            ("0.5,3,4,5", "line 3: found 4 columns, expected 3"),
            ("0.5,x,4", "line 3: `x` is not a number"),
        ] {
            let found = read(&format!("time_s,a,b\n0,1,2\n{line}\n")).expect_err(what);
            assert!(found.contains(what), "{found}");
        }
        assert_eq!(read("time_s,a\r\n0,1\r\n\r\n1,NaN").expect("readable").time, [0.0, 1.0]);
        assert!(read("a,b\n").expect_err("another table").contains("expected `time_s`"));
    }

    /// A quotation mark is part of its column's name; the lines after it are still read.
    #[test]
    fn a_quotation_mark_does_not_swallow_the_table() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(folder.path().join(SERIES_FILE), "time_s,\"a,b\n0,1,2\n0.5,3,4\n").expect("writable");
        let series = read_series(folder.path()).expect("readable");
        assert_eq!(series.ids, ["\"a", "b"]);
        assert_eq!((series.time, series.columns), (vec![0.0, 0.5], vec![vec![1.0, 3.0], vec![2.0, 4.0]]));
    }
}
