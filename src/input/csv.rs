//! A table of tanks: the first line names places of the tank file, every other line is a tank.
//!
//! Columns are separated by commas, or by semicolons if the first line has one and no comma. A cell in double quotes may contain
//! separators, line breaks and doubled quotes (RFC 4180).

use std::collections::BTreeSet;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::input::diagnostic::{Fault, Faults, Source};
use crate::input::stdin;
use files::code::Code;
use files::error::Error;
use files::text::uncelled;

/// Largest file that is read [bytes].
const MAX_BYTES: u64 = 1 << 20;
/// Largest number of rows.
const MAX_ROWS: usize = 10_000;
/// Largest number of columns.
const MAX_COLUMNS: usize = 1000;

/// A cell and its place in the file, without quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Text without blanks around it.
    pub text: String,
    /// Bytes of the file.
    pub span: Range<usize>,
}

/// A table whose rows have as many cells as its head.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// The file.
    pub source: Source,
    /// Names of the columns.
    pub head: Vec<Cell>,
    /// Rows, in the order of the file.
    pub rows: Vec<Vec<Cell>>,
}

/// Beginning of the SHA-256 of a file, for the report.
pub(in crate::input) fn short_hash(source: &Source) -> String {
    let hash = Sha256::digest(source.text.as_bytes());
    hash.iter().take(8).map(|b| format!("{b:02x}")).collect()
}

/// Reads a table (`-`: standard input).
///
/// Errors: a file that cannot be read, is larger than 1 MiB or is not UTF-8; the faults of [`parse`].
pub fn read(path: &Path) -> Result<Table, Error> {
    let fault = |what| Error::File { code: Code::FileUnreadable, path: path.into(), what };
    let source = if path == Path::new("-") { limited(stdin::take()?, path) } else { bytes(path) };
    let source = source.map_err(fault)?;
    parse(&source).map_err(|faults| faults.into_error(&source))
}

/// Reads a file that another one names.
///
/// Errors: a file that cannot be read, is not a file, is larger than 1 MiB or is not UTF-8; with its name.
pub(crate) fn text(path: &Path) -> Result<Source, String> {
    let named = |what: String| format!("{}: {what}", path.display());
    bytes(path).map_err(named)
}

/// The text of a file, or why it cannot be read.
fn bytes(path: &Path) -> Result<Source, String> {
    let unreadable = |e: std::io::Error| format!("cannot read the table: {}", files::error::describe(&e));
    if let Some(what) = files::special(path).map_err(unreadable)? {
        return Err(format!("found {what}, expected a CSV file"));
    }
    limited(std::fs::File::open(path).map_err(unreadable)?, path)
}

/// The text that a reader gives, at most as much as is read of a table.
fn limited(reader: impl Read, path: &Path) -> Result<Source, String> {
    let unreadable = |e: std::io::Error| format!("cannot read the table: {}", files::error::describe(&e));
    let mut bytes = Vec::new();
    reader.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err("found a file larger than 1 MiB, expected a table".into());
    }
    let text = String::from_utf8(bytes).map_err(|_| "found bytes that are not UTF-8; save the table as UTF-8")?;
    let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text);
    Ok(Source::at(path, text))
}

/// The lines of a text that are not blank, split into cells. Errors: a quote that is not closed.
pub(crate) fn rows(source: &Source) -> Result<Vec<Vec<Cell>>, String> {
    let mut faults = Faults::new();
    let rows = records(&source.text, &mut faults);
    match faults.list().first() {
        None => Ok(rows),
        Some(fault) => Err(fault.message.clone()),
    }
}

/// Reads the text of a table. All faults are returned at once: a table without columns or rows or with too many, a name that is empty or occurs twice,
/// a row with another number of cells, a quote that is not closed.
pub fn parse(source: &Source) -> Result<Table, Faults> {
    let mut faults = Faults::new();
    let mut lines = records(&source.text, &mut faults).into_iter();
    let head = lines.next().unwrap_or_default();
    let mut seen = BTreeSet::new();
    for cell in &head {
        if cell.text.is_empty() {
            faults.push(
                Fault::new(Code::TableColumn, "a column without a name")
                    .at(cell.span.clone())
                    .allowed("a name; in a table of tanks a path of the tank file, such as liquid.fill_height"),
            );
        } else if !seen.insert(cell.text.as_str()) {
            faults.push(
                Fault::new(Code::TableColumn, format!("the column `{}` occurs twice", cell.text))
                    .at(cell.span.clone())
                    .allowed("each path once"),
            );
        }
    }
    if head.len() > MAX_COLUMNS {
        let fault = Fault::new(Code::TableShape, "too many columns").found(format!("{} columns", head.len()));
        return Err(fault.allowed(format!("at most {MAX_COLUMNS} columns")).into());
    }
    let rows: Vec<Vec<Cell>> = lines.collect();
    for row in rows.iter().filter(|row| row.len() != head.len()) {
        faults.push(
            Fault::new(Code::TableShape, "a row with another number of cells than the head")
                .at(span(row))
                .found(format!("{} cells", row.len()))
                .allowed(format!("{} cells", head.len())),
        );
    }
    if rows.is_empty() || rows.len() > MAX_ROWS {
        faults.push(
            Fault::new(Code::TableShape, "too few or too many rows")
                .found(format!("{} rows", rows.len()))
                .allowed(format!("a line of column names, then 1 to {MAX_ROWS} rows")),
        );
    }
    if faults.is_empty() { Ok(Table { source: source.clone(), head, rows }) } else { Err(faults) }
}

/// Bytes of a row from its first to its last cell.
pub fn span(row: &[Cell]) -> Range<usize> {
    let start = row.first().map_or(0, |c| c.span.start);
    start..row.last().map_or(start, |c| c.span.end)
}

/// The lines that are not blank, split into cells.
fn records(text: &str, faults: &mut Faults) -> Vec<Vec<Cell>> {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let separator = if first.contains(';') && !first.contains(',') { ';' } else { ',' };
    let mut records = Vec::new();
    let mut row: Vec<Cell> = Vec::new();
    let mut start = 0;
    let mut quoted = false;
    for (at, c) in text.char_indices().chain([(text.len(), '\n')]) {
        let end = at == text.len();
        match c {
            '"' => quoted = !quoted,
            _ if quoted && !end => {}
            _ if c == separator || c == '\n' => {
                row.push(cell(text, start..at));
                start = at + 1;
                if c == '\n' {
                    let blank = row.len() == 1 && row.iter().all(|cell| cell.text.is_empty());
                    let done = std::mem::take(&mut row);
                    if !blank {
                        records.push(done);
                    }
                }
            }
            _ => {}
        }
    }
    if quoted {
        let open = text.rfind('"').unwrap_or_default();
        faults.push(
            Fault::new(Code::CutOff, "this quote is not closed")
                .at(open..open + 1)
                .help("the file may have been cut off"),
        );
    }
    records
}

/// The cell at this place, without blanks and quotes around it.
fn cell(text: &str, place: Range<usize>) -> Cell {
    let raw = &text[place.clone()];
    let start = place.start + (raw.len() - raw.trim_start().len());
    let bare = raw.trim();
    let span = start..start + bare.len();
    let text = match bare.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
        Some(inner) => uncelled(&inner.replace("\"\"", "\"")).to_owned(),
        None => uncelled(bare).to_owned(),
    };
    Cell { text, span }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(row: &[Cell]) -> Vec<&str> {
        row.iter().map(|c| c.text.as_str()).collect()
    }

    #[test]
    fn quotes_blanks_and_separators() {
        let text = "name, tank.radius\r\n\"a, \"\"b\"\"\" , 5 m\n\n  c,\"6 m\"\n";
        let table = parse(&Source::new("t.csv", text)).unwrap();
        assert_eq!(texts(&table.head), ["name", "tank.radius"]);
        assert_eq!(texts(&table.rows[0]), ["a, \"b\"", "5 m"]);
        assert_eq!(texts(&table.rows[1]), ["c", "6 m"]);
        assert_eq!(&text[table.rows[1][1].span.clone()], "\"6 m\"");
        let table = parse(&Source::new("t.csv", "name;tank.radius\na,b;5 m")).unwrap();
        assert_eq!(texts(&table.rows[0]), ["a,b", "5 m"]);
    }

    #[test]
    fn faults() {
        let message = |text: &str| {
            let source = Source::new("t.csv", text);
            parse(&source).unwrap_err().render(&source, false)
        };
        assert!(message("").contains("too few"));
        assert!(message("name\n").contains("0 rows"));
        assert!(message("name,name\na,b\n").contains("occurs twice"));
        assert!(message("name,\na,b\n").contains("without a name"));
        let short = message("name,tank.radius\na\n");
        assert!(short.contains("t.csv:2:1") && short.contains("found 1 cells"), "{short}");
        assert!(message("name\n\"a\n").contains("not closed"));
    }
}
