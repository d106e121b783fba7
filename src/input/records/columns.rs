//! CSV and plain text: a table with one column of accelerations, or values in reading order.
//!
//! * Columns are separated by `;`, `,`, tabs or spaces; the first line of numbers decides.
//! * The decimal mark is a point; with `;`, tabs or spaces between columns it may be a comma, one mark throughout the file.
//! * Lines before the numbers are titles and comments (`#`, `%`, `!`, `//`, `;`); module `header` says which of them are read.
//! * The first line of numbers may give their number and the time step.
//! * One column is the acceleration, two without a header are time and acceleration. Of more columns a header or `--columns` tells the meaning;
//!   five or more without both are values in reading order, where the time step is known.
//! * Time is in seconds unless the header has `ms`. Acceleration does not have a default unit.

use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::block::Line;
use crate::input::records::draft::{Collector, Draft, choose, settle_dt, settle_unit, token_at};
use crate::input::records::filter::corner;
use crate::input::records::header::{self, Layout, MILLISECONDS, Stated, Title, Values, stated};
use crate::input::records::leading::{Leading, leading};
use crate::input::records::number::{NotANumber, begins_like_number, parse, resolution};
use crate::input::records::options::Columns;
use crate::input::records::separator::Separator;
use crate::input::records::time::{Stamp, looks_like_time, uniform_step};
use crate::input::records::{MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Beginning of the comment that gives the corner of the low-cut filter: `# low-cut filter: 0.2 Hz`.
pub const LOW_CUT: &str = "low-cut filter";
/// Columns from which a table without a header is not a few components.
const IN_ORDER: usize = 5;
/// Rows that tell whether a column is a time.
const TELLING: usize = 20;

/// Reads the text.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let (titles, rows) = split(text);
    let Some(&first) = rows.first() else {
        return Err(Fault::new(Code::EmptyFile, "the file does not contain numbers")
            .allowed("CSV, two-column text or PEER .AT2")
            .into());
    };
    let said = stated(&titles)?;
    let leading = leading(&rows);
    let rows = &rows[leading.lines..];
    let row = rows.first().copied().unwrap_or(first);
    let separator = match Separator::of(row.1) {
        // The comma is the decimal mark of the only column that the header names.
        Separator::Comma if one_column(&titles, options) => Separator::Spaces,
        separator => separator,
    };
    let columns = separator.cells(row.1).len();
    whole(&titles, separator, columns)?;
    let layout = layout(&titles, separator, rows, (&said, &leading), options)?;
    let mut table = Table::default();
    let mut faults = Collector::new();
    for (i, line) in rows.iter().enumerate() {
        let stop = match table.add(*line, separator, &layout, i + 1 == rows.len()) {
            Ok(()) => table.values.len() > MAX_SAMPLES,
            Err(fault) => faults.push(fault),
        };
        if stop {
            break;
        }
    }
    faults.finish()?;
    if table.values.len() > MAX_SAMPLES {
        return Err(Fault::new(Code::TooLarge, "the record is too long")
            .found(format!("more than {MAX_SAMPLES} samples"))
            .allowed(format!("up to {MAX_SAMPLES} samples (5.5 hours at 100 Hz)"))
            .help("cut the record to the strong motion")
            .into());
    }
    leading.fits(table.values.len(), first)?;
    let low_cut = titles.iter().find_map(|title| corner(title.text));
    let draft = draft(table, separator, layout, (text, options), (&said, &leading))?;
    Ok(Draft { low_cut, ..draft })
}

/// Lines before the first line of numbers, and from there on those that are neither empty nor comments, up to a few more than a record may have.
fn split(text: &str) -> (Vec<Title<'_>>, Vec<Line<'_>>) {
    let (mut titles, mut rows) = (Vec::new(), Vec::new());
    let mut start = 0;
    for (number, raw) in text.split_inclusive('\n').enumerate() {
        let line: Line = (start, raw.trim_end_matches(['\n', '\r']));
        start += raw.len();
        let comment = comment_text(line.1);
        let padding = line.1.chars().all(|c| c.is_whitespace() || matches!(c, ',' | ';'));
        if padding || (comment.is_some() && !rows.is_empty()) {
            continue;
        }
        if rows.is_empty() && (comment.is_some() || !is_row(line.1)) {
            let text = comment.unwrap_or(line.1);
            titles.push(Title {
                number: number + 1,
                start: line.0 + (line.1.len() - text.len()),
                text,
                comment: comment.is_some(),
            });
            continue;
        }
        rows.push(line);
        if rows.len() > MAX_SAMPLES + 2 {
            break;
        }
    }
    (titles, rows)
}

/// The text of a comment line.
fn comment_text(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let marked = ["#", "%", "!", "//"].iter().find_map(|mark| line.strip_prefix(mark));
    // A line of cells may begin with an empty one.
    marked.or_else(|| line.strip_prefix(';').filter(|rest| rest.contains(char::is_alphabetic)))
}

/// Whether a line is one of numbers and of nothing else.
fn is_row(line: &str) -> bool {
    let mut numbers = 0;
    for (_, word) in Separator::Spaces.cells(&line.replace([';', '\t', '"'], " ")) {
        for part in word.split(',').filter(|part| !part.is_empty()) {
            match parse(part) {
                Ok(_) | Err(NotANumber::NotFinite) => numbers += 1,
                Err(NotANumber::Overflow) => {}
                Err(NotANumber::Text) => return false,
            }
        }
    }
    numbers > 0
}

/// Whether the header names one column, and none a table.
fn one_column(titles: &[Title], options: &ReadOptions) -> bool {
    let found = |columns: usize| matches!(header::layout(titles, Separator::Semicolon, columns, options), Ok(Some(_)));
    options.columns.is_none() && found(1) && !titles.iter().any(|title| title.text.contains(',')) && !found(2)
}

/// Rejects a damaged line of numbers among the titles, which must not get lost.
fn whole(titles: &[Title], separator: Separator, columns: usize) -> Result<(), Fault> {
    let number = |cell: &str| parse(&cell.replace(',', ".")).is_ok();
    let damaged = titles.iter().find(|title| {
        let cells = separator.cells(title.text);
        let like = !title.comment && begins_like_number(title.text.trim()) && cells.len() == columns;
        like && (columns == 1 || cells.iter().any(|c| number(c.1)))
    });
    let Some(title) = damaged else { return Ok(()) };
    let cells = separator.cells(title.text);
    let cell = cells.iter().find(|c| !number(c.1)).copied().unwrap_or((0, title.text));
    Err(Fault::new(Code::NotANumber, "a number before the record is not a number")
        .at(title.start + cell.0..title.start + cell.0 + cell.1.len())
        .found(cell.1)
        .allowed("finite numbers; lines of text must begin with `#`")
        .help("correct the number, or skip the lines before the record with --skip-lines"))
}

/// Finds the meaning of the columns.
fn layout(
    titles: &[Title],
    separator: Separator,
    rows: &[Line],
    (said, leading): (&Stated, &Leading),
    options: &ReadOptions,
) -> Result<Layout, Fault> {
    let first = rows.first().copied().unwrap_or((0, ""));
    let cells = separator.cells(first.1);
    let columns = cells.len();
    let whole = first.0..first.0 + first.1.len();
    if separator == Separator::Comma && cells.iter().any(|c| c.1.contains(char::is_whitespace)) {
        return Err(Fault::new(Code::RecordFormat, "commas and spaces are mixed")
            .at(whole)
            .found(first.1.trim())
            .allowed("columns separated by `;` or tabs where the comma is the decimal mark"));
    }
    if options.columns.is_some() && options.channel.is_some() {
        return Err(
            Fault::new(Code::OptionConflict, "--columns and --channel name the same thing").help("give one of them")
        );
    }
    if options.columns == Some(Columns::All) {
        let unit = header::layout(titles, Separator::Semicolon, 1, options).ok().flatten().and_then(|l| l.unit);
        return Ok(Layout { unit, ..Layout::plain(None, Values::All, columns) });
    }
    if let Some(named) = header::layout(titles, separator, columns, options)? {
        return Ok(named);
    }
    choose(&[String::from("acceleration")], options)?;
    match columns {
        1 => return Ok(Layout::plain(None, Values::Column(0), 1)),
        2 => return Ok(Layout::plain(Some(0), Values::Column(1), 2)),
        _ => {}
    }
    if let Some(help) = not_in_order(separator, rows, (said, leading), options) {
        let fault = Fault::new(Code::RecordFormat, format!("{columns} columns without a header")).at(whole);
        return Err(fault
            .found(first.1.trim())
            .allowed("one column (acceleration), two (time, acceleration), or a header that names the columns")
            .help(help));
    }
    // The name of all columns.
    let unit = header::layout(titles, Separator::Semicolon, 1, options)?.and_then(|l| l.unit);
    Ok(Layout { unit, ..Layout::plain(None, Values::All, columns) })
}

/// What to do about three or more columns without a header that are not values in reading order; none where they are.
fn not_in_order(
    separator: Separator,
    rows: &[Line],
    (said, leading): (&Stated, &Leading),
    options: &ReadOptions,
) -> Option<&'static str> {
    let cells = |row: &Line<'_>| separator.cells(row.1).len();
    let columns = rows.first().map_or(0, cells);
    let first = |row: &Line| {
        let cells = separator.cells(row.1);
        cells.first().and_then(|c| parse(&c.1.replace(',', ".")).ok())
    };
    let times: Vec<f64> = rows.iter().take(TELLING).map_while(first).collect();
    let order: Vec<f64> = rows
        .iter()
        .take(TELLING)
        .flat_map(|row| separator.cells(row.1))
        .step_by(2)
        .map_while(|c| parse(c.1).ok())
        .collect();
    let short = rows.last().is_some_and(|row| cells(row) < columns);
    if looks_like_time(&order) {
        Some("the values look like pairs of time and acceleration: write one pair a line")
    } else if looks_like_time(&times) {
        Some("the first column looks like a time: give the columns of time and acceleration, such as --columns 1,2")
    } else if columns < IN_ORDER && !short && leading.count.is_none() {
        Some("--columns 2 reads the second of several components, --columns all reads values in reading order")
    } else if options.dt.or(said.dt).or(leading.dt).is_none() {
        Some("values in reading order need --dt; of a table, name the columns in a header or with --columns 1,2")
    } else {
        None
    }
}

/// The record of a table.
fn draft(
    table: Table,
    separator: Separator,
    layout: Layout,
    (text, options): (&str, &ReadOptions),
    (said, leading): (&Stated, &Leading),
) -> Result<Draft, Fault> {
    let mut notes = Vec::new();
    let named_dt = match layout.time {
        Some(_) => Some(uniform_step(&table.stamps, text, options.dt.or(leading.dt))?),
        None => leading.dt.or(said.dt),
    };
    if let (Some(step), None, Some(first)) = (named_dt, layout.time_unit, table.stamps.get(1))
        && step >= MILLISECONDS
    {
        let message = "the time column does not have a unit, and its step looks like milliseconds";
        return Err(Fault::new(Code::TimeStep, message)
            .at(token_at(text, first.place as usize))
            .found(format!("a step of {step}"))
            .allowed("steps below 0.5 s in a time column without a unit; usual values are 0.002 to 0.02 s")
            .help("give the unit in a header: `time_ms,…`, or `time_s,…` if the step is in seconds"));
    }
    if layout.time.is_some() && layout.time_unit.is_none() {
        notes.push("the time column names no unit; this format takes it in seconds".to_string());
    }
    if let Some(first) = table.stamps.first().filter(|s| s.time != 0.0) {
        notes.push(format!("the time column begins at {} s; the record is taken to begin at 0", first.time));
    }
    let dt = settle_dt(named_dt, options)?.ok_or_else(|| {
        Fault::new(Code::TimeStep, "accelerations without a column of times do not have a time step")
            .allowed("--dt SECONDS, or a first column with the time")
    })?;
    let example = "a header such as `time_s,acceleration_m_s2` or `t [s]; a [g]`";
    if let (Some((unit, source)), Some((other, line))) = (&layout.unit, &said.unit)
        && unit != other
    {
        return Err(Fault::new(Code::RecordUnit, "the header gives two units")
            .found(format!("{unit} in the {source}, {other} in {line}")));
    }
    let (unit, unit_source) = settle_unit(layout.unit.clone().or_else(|| said.unit.clone()), options, example)?;
    Ok(Draft {
        title: None,
        format: format(separator, &layout),
        channel: layout.channel,
        unit,
        unit_source,
        dt,
        values: table.values,
        places: table.places,
        notes,
        low_cut: None,
    })
}

/// The format in words.
fn format(separator: Separator, layout: &Layout) -> String {
    let kind = if matches!(separator, Separator::Semicolon | Separator::Comma) { "CSV" } else { "text" };
    let columns = match (layout.values, layout.time, layout.columns) {
        (Values::All, ..) => format!("values in reading order, {} a line", layout.columns),
        (Values::Column(_), None, 1) => "acceleration".into(),
        (Values::Column(_), Some(_), 2) => format!("time and acceleration separated by {}", separator.name()),
        (Values::Column(a), Some(t), n) => {
            format!("columns {} and {} of {n} separated by {}", t + 1, a + 1, separator.name())
        }
        (Values::Column(a), None, n) => format!("column {} of {n} separated by {}", a + 1, separator.name()),
    };
    let header = layout.header.as_ref().map_or("no header".into(), |h| format!("header `{h}`"));
    format!("{kind}, {columns}, {header}")
}

/// Numbers of the file.
#[derive(Default)]
struct Table {
    values: Vec<f64>,
    places: Vec<u32>,
    stamps: Vec<Stamp>,
    /// The decimal mark, once a number had one.
    comma: Option<bool>,
}

impl Table {
    /// Adds a line of numbers; of values in reading order the last line may be shorter.
    fn add(&mut self, line: Line, separator: Separator, layout: &Layout, last: bool) -> Result<(), Fault> {
        let cells = separator.cells(line.1);
        let short = last && layout.values == Values::All && cells.len() < layout.columns;
        if cells.len() != layout.columns && !short {
            return Err(Fault::new(Code::RecordFormat, "the line does not match the others")
                .at(line.0..line.0 + line.1.len())
                .found(format!("{} column(s)", cells.len()))
                .allowed(format!("{} column(s) separated by {}", layout.columns, separator.name())));
        }
        let columns = match layout.values {
            Values::Column(column) => column..column + 1,
            Values::All => 0..cells.len(),
        };
        for column in columns {
            // Time and value are parsed before either is stored, so that the columns have the same length.
            let value = self.number(line.0, cells[column], separator, "the acceleration")?;
            if let Some(time) = layout.time {
                let cell = cells[time];
                let unit = layout.time_unit.unwrap_or(1.0);
                let time = self.number(line.0, cell, separator, "the time")? * unit;
                let rounding = 0.5 * unit * resolution(&cell.1.replace(',', "."));
                self.stamps.push(Stamp { time, rounding, place: place(line.0 + cell.0) });
            }
            self.values.push(value);
            self.places.push(place(line.0 + cells[column].0));
        }
        Ok(())
    }

    fn number(&mut self, start: usize, cell: (usize, &str), separator: Separator, what: &str) -> Result<f64, Fault> {
        let span = start + cell.0..start + cell.0 + cell.1.len();
        let comma = separator != Separator::Comma && cell.1.contains(',');
        let mark = if comma { Some(true) } else { cell.1.contains('.').then_some(false) };
        if let (Some(mark), Some(known)) = (mark, self.comma)
            && mark != known
        {
            return Err(Fault::new(Code::RecordFormat, "decimal point and decimal comma in the same file")
                .at(span)
                .found(cell.1)
                .allowed("one decimal mark, no thousands separators"));
        }
        self.comma = self.comma.or(mark);
        let parsed = if comma { parse(&cell.1.replace(',', ".")) } else { parse(cell.1) };
        parsed.map_err(|wrong| {
            Fault::new(wrong.code(), wrong.message(what))
                .at(span)
                .found(if cell.1.is_empty() { "nothing" } else { cell.1 })
                .allowed("finite numbers; lines of text must begin with `#` or precede the numbers")
        })
    }
}

/// Files are below 4 GB by far, see `MAX_BYTES`.
fn place(byte: usize) -> u32 {
    u32::try_from(byte).unwrap_or(u32::MAX)
}
