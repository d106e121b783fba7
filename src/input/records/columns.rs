//! CSV and plain text: one column (acceleration) or two (time and acceleration).
//!
//! * Columns are separated by `;`, `,`, tabs or spaces; the first line of numbers decides.
//! * The decimal mark is a point; with `;` or tabs between columns it may be a comma, one mark throughout the file.
//! * Lines in front of the numbers that do not begin with a number are titles; one of them may name the columns and
//!   their units: `time_s,acceleration_m_s2`, `t [s]; a [g]`, `Time(s) Accel(g)`. Lines that begin with `#`, `%`, `!`
//!   or `//` are comments; they too may name the columns.
//! * Time is in seconds unless the header has `ms`. Acceleration does not have a default unit.

use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::draft::{Collector, Draft, printable, settle_dt, settle_unit, token_at};
use crate::input::records::number::{begins_like_number, parse, resolution};
use crate::input::records::time::{Stamp, uniform_step};
use crate::input::records::unit::{Head, head};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// Step from which a time column without a unit is not read as seconds.
const MILLISECONDS: f64 = 0.5;

/// Separator of the columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Semicolon,
    Comma,
    Tab,
    Spaces,
}

impl Separator {
    /// Decides by a line of numbers.
    fn of(line: &str) -> Separator {
        if line.contains(';') {
            Separator::Semicolon
        } else if line.trim().contains('\t') {
            Separator::Tab
        } else if line.contains(',') {
            Separator::Comma
        } else {
            Separator::Spaces
        }
    }

    fn name(self) -> &'static str {
        match self {
            Separator::Semicolon => "`;`",
            Separator::Comma => "`,`",
            Separator::Tab => "tabs",
            Separator::Spaces => "spaces",
        }
    }

    /// Cells and the byte at which each begins; an empty cell at the end of a line is ignored.
    fn cells<'a>(self, line: &'a str) -> Vec<(usize, &'a str)> {
        let place = |cell: &'a str| {
            let bare = cell.trim();
            let start = bare.as_ptr() as usize - line.as_ptr() as usize;
            match bare.strip_prefix('"').and_then(|c| c.strip_suffix('"')) {
                Some(inner) => (start + 1, inner.trim()),
                None => (start, bare),
            }
        };
        let mut cells: Vec<(usize, &str)> = match self {
            Separator::Semicolon => line.split(';').map(place).collect(),
            Separator::Comma => line.split(',').map(place).collect(),
            Separator::Tab => line
                .trim()
                .split('\t')
                .filter(|c| !c.trim().is_empty())
                .map(place)
                .collect(),
            Separator::Spaces => line.split_whitespace().map(place).collect(),
        };
        if cells.len() > 1 && cells.last().is_some_and(|c| c.1.is_empty()) {
            cells.pop();
        }
        cells
    }
}

/// Meaning of the columns.
#[derive(Clone, Debug)]
struct Layout {
    time: Option<usize>,
    acceleration: usize,
    columns: usize,
    /// Size of the unit of time [s]; `None` if the header does not name it.
    time_unit: Option<f64>,
    unit: Option<(AccelerationUnit, String)>,
    header: Option<String>,
}

/// Beginning of the comment that gives the corner of the low-cut filter: `# low-cut filter: 0.2 Hz`.
pub const LOW_CUT: &str = "low-cut filter";

/// A line of text with the byte at which it begins.
type Line<'a> = (usize, &'a str);

/// Reads the text.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let mut titles: Vec<(usize, Line)> = Vec::new();
    let mut data: Option<(Separator, Layout)> = None;
    let mut table = Table::default();
    let mut faults = Collector::new();
    let mut start = 0;
    for (number, raw) in text.split_inclusive('\n').enumerate() {
        let line: Line = (start, raw.trim_end_matches(['\n', '\r']));
        start += raw.len();
        let bare = line.1.trim();
        let comment = comment_text(bare);
        if bare.is_empty() || (comment.is_some() && data.is_some()) {
            continue;
        }
        if data.is_none() && (comment.is_some() || !begins_like_number(bare)) {
            titles.push((number + 1, (line.0, comment.unwrap_or(line.1))));
            continue;
        }
        if data.is_none() {
            let separator = Separator::of(line.1);
            data = Some((separator, layout(&titles, separator, line)?));
        }
        if let Some((separator, layout)) = &data {
            let stop = match table.add(line, *separator, layout) {
                Ok(()) => table.values.len() > MAX_SAMPLES,
                Err(fault) => faults.push(fault),
            };
            if stop {
                break;
            }
        }
    }
    faults.finish()?;
    let Some((separator, layout)) = data else {
        return Err(Fault::new(Code::EmptyFile, "the file does not contain numbers")
            .allowed("CSV, two-column text or PEER .AT2")
            .into());
    };
    if table.values.len() > MAX_SAMPLES {
        return Err(Fault::new(Code::TooLarge, "the record is too long")
            .found(format!("more than {MAX_SAMPLES} samples"))
            .allowed(format!("up to {MAX_SAMPLES} samples (5.5 hours at 100 Hz)"))
            .help("cut the record to the strong motion")
            .into());
    }
    let corner = titles.iter().find_map(|(_, line)| low_cut(line.1));
    let draft = draft(table, separator, layout, text, options)?;
    Ok(Draft {
        low_cut: corner,
        ..draft
    })
}

fn draft(
    table: Table,
    separator: Separator,
    layout: Layout,
    text: &str,
    options: &ReadOptions,
) -> Result<Draft, Fault> {
    let mut notes = Vec::new();
    let named_dt = match layout.time {
        Some(_) => Some(uniform_step(&table.stamps, text)?),
        None => None,
    };
    if let (Some(step), None, Some(first)) = (named_dt, layout.time_unit, table.stamps.get(1))
        && step >= MILLISECONDS
    {
        return Err(Fault::new(
            Code::TimeStep,
            "the time column does not have a unit, and its step looks like milliseconds",
        )
        .at(token_at(text, first.place as usize))
        .found(format!("a step of {step}"))
        .allowed("steps below 0.5 s in a time column without a unit; usual values are 0.002 to 0.02 s")
        .help("give the unit in a header: `time_ms,…`, or `time_s,…` if the step is in seconds"));
    }
    if layout.time.is_some() && layout.time_unit.is_none() {
        notes.push("the time column names no unit; this format takes it in seconds".to_string());
    }
    if let Some(first) = table.stamps.first().filter(|s| s.time != 0.0) {
        notes.push(format!(
            "the time column begins at {} s; the record is taken to begin at 0",
            first.time
        ));
    }
    let dt = settle_dt(named_dt, options)?.ok_or_else(|| {
        Fault::new(
            Code::TimeStep,
            "a single column of accelerations does not have a time step",
        )
        .allowed("--dt SECONDS, or a first column with the time")
    })?;
    let example = "a header such as `time_s,acceleration_m_s2` or `t [s]; a [g]`";
    let (unit, unit_source) = settle_unit(layout.unit, options, example)?;
    let columns = if layout.time.is_some() {
        "time and acceleration"
    } else {
        "acceleration"
    };
    let kind = if matches!(separator, Separator::Semicolon | Separator::Comma) {
        "CSV"
    } else {
        "text"
    };
    let header = layout.header.map_or("no header".into(), |h| format!("header `{h}`"));
    let format = match layout.columns {
        1 => format!("{kind}, {columns}, {header}"),
        _ => format!("{kind}, {columns} separated by {}, {header}", separator.name()),
    };
    Ok(Draft {
        title: None,
        format,
        unit,
        unit_source,
        dt,
        values: table.values,
        places: table.places,
        notes,
        low_cut: None,
    })
}

/// The corner [Hz] in a comment of `quake convert`.
fn low_cut(comment: &str) -> Option<f64> {
    let value = comment
        .trim()
        .strip_prefix(LOW_CUT)?
        .strip_prefix(':')?
        .trim()
        .strip_suffix("Hz")?;
    parse(value).ok().filter(|corner| *corner > 0.0)
}

/// The text of a comment line.
fn comment_text(line: &str) -> Option<&str> {
    ["#", "%", "!", "//"].iter().find_map(|mark| line.strip_prefix(mark))
}

/// Finds the meaning of the columns from the first line of numbers and the lines before it.
fn layout(titles: &[(usize, Line)], separator: Separator, first: Line) -> Result<Layout, Fault> {
    let cells = separator.cells(first.1);
    let whole = first.0..first.0 + first.1.len();
    let decimal_comma = separator == Separator::Comma && cells.iter().any(|c| c.1.contains(char::is_whitespace));
    if decimal_comma {
        return Err(Fault::new(Code::RecordFormat, "commas and spaces are mixed")
            .at(whole)
            .found(first.1.trim())
            .allowed("columns separated by `;` or tabs where the comma is the decimal mark"));
    }
    if cells.len() > 2 {
        return Err(Fault::new(Code::RecordFormat, format!("{} columns", cells.len()))
            .at(whole)
            .found(first.1.trim())
            .allowed("one column (acceleration) or two (time, acceleration)")
            .help("write one component per file; values in reading order need a PEER header with NPTS and DT"));
    }
    let plain = Layout {
        time: (cells.len() == 2).then_some(0),
        acceleration: cells.len() - 1,
        columns: cells.len(),
        time_unit: None,
        unit: None,
        header: None,
    };
    // The line nearest to the numbers that names columns is the header.
    for (number, line) in titles.iter().rev() {
        let heads = header_cells(line.1, separator).into_iter().find(|cells| {
            cells.iter().any(|c| !matches!(head(c), Head::Unknown)) && cells.len() <= cells_limit(cells, plain.columns)
        });
        let Some(heads) = heads else { continue };
        return named(&heads, &plain, *number, *line);
    }
    Ok(plain)
}

/// A header may have a wrong number of cells only if every cell names something.
fn cells_limit(cells: &[String], columns: usize) -> usize {
    if cells.iter().all(|c| !matches!(head(c), Head::Unknown)) {
        usize::MAX
    } else {
        columns
    }
}

/// The ways to cut a header line into cells: like the numbers, then like any other table.
fn header_cells(line: &str, separator: Separator) -> Vec<Vec<String>> {
    let mut ways = Vec::new();
    for way in [separator, Separator::Semicolon, Separator::Tab, Separator::Comma] {
        if way != Separator::Spaces {
            ways.push(way.cells(line).iter().map(|c| c.1.to_string()).collect::<Vec<_>>());
        }
    }
    // Words; a word that begins with a bracket belongs to the one before.
    let mut words: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match words.last_mut() {
            Some(last) if word.starts_with(['[', '(']) => last.push_str(word),
            _ => words.push(word.to_string()),
        }
    }
    ways.insert(usize::from(separator != Separator::Spaces) * ways.len(), words);
    // Ways with the right number of columns first; the sort is stable.
    ways.sort_by_key(|cells| cells.len() == 1);
    ways
}

/// The layout that a header names.
fn named(heads: &[String], plain: &Layout, number: usize, line: Line) -> Result<Layout, Fault> {
    let span = line.0..line.0 + line.1.len();
    let fault = |code: Code, what: &str| Fault::new(code, what).at(span.clone()).found(line.1.trim());
    if heads.len() != plain.columns {
        return Err(
            fault(Code::RecordFormat, "the header does not match the numbers").allowed(format!(
                "{} name(s), as there are {} column(s) of numbers",
                plain.columns, plain.columns
            )),
        );
    }
    let mut layout = Layout {
        header: Some(printable(line.1)),
        ..plain.clone()
    };
    let mut roles = [None, None];
    for (i, cell) in heads.iter().enumerate() {
        match head(cell) {
            Head::Time(unit) => {
                roles[i] = Some(true);
                layout.time_unit = unit;
            }
            Head::Acceleration(unit) => {
                roles[i] = Some(false);
                layout.unit = unit.map(|u| {
                    (
                        u,
                        format!("header, line {number}, column {} (`{}`)", i + 1, printable(cell)),
                    )
                });
            }
            Head::OtherMotion => {
                return Err(
                    fault(Code::NotAcceleration, "a column is neither time nor acceleration")
                        .allowed("acceleration against time; velocities and displacements are not read"),
                );
            }
            Head::Unknown => {}
        }
    }
    match (plain.columns, roles) {
        (1, [Some(true), _]) => {
            return Err(fault(Code::NotAcceleration, "the only column is the time").allowed("accelerations"));
        }
        (2, [Some(a), Some(b)]) if a == b => {
            return Err(fault(Code::RecordFormat, "both columns have the same name")
                .allowed("one column of time, one of acceleration"));
        }
        (2, [Some(false), _] | [_, Some(true)]) => (layout.time, layout.acceleration) = (Some(1), 0),
        _ => {}
    }
    Ok(layout)
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
    /// Adds a line of numbers.
    fn add(&mut self, line: Line, separator: Separator, layout: &Layout) -> Result<(), Fault> {
        let cells = separator.cells(line.1);
        if cells.len() != layout.columns {
            return Err(Fault::new(Code::RecordFormat, "the line does not match the others")
                .at(line.0..line.0 + line.1.len())
                .found(format!("{} column(s)", cells.len()))
                .allowed(format!(
                    "{} column(s) separated by {}",
                    layout.columns,
                    separator.name()
                )));
        }
        // Both cells are parsed before either is stored, so that the columns have the same length.
        let value = self.number(line.0, cells[layout.acceleration], separator, "the acceleration")?;
        if let Some(column) = layout.time {
            let cell = cells[column];
            let unit = layout.time_unit.unwrap_or(1.0);
            let time = self.number(line.0, cell, separator, "the time")? * unit;
            let rounding = 0.5 * unit * resolution(&cell.1.replace(',', "."));
            self.stamps.push(Stamp {
                time,
                rounding,
                place: place(line.0 + cell.0),
            });
        }
        self.values.push(value);
        self.places.push(place(line.0 + cells[layout.acceleration].0));
        Ok(())
    }

    fn number(&mut self, start: usize, cell: (usize, &str), separator: Separator, what: &str) -> Result<f64, Fault> {
        let span = start + cell.0..start + cell.0 + cell.1.len();
        let comma = matches!(separator, Separator::Semicolon | Separator::Tab) && cell.1.contains(',');
        let mark = if comma {
            Some(true)
        } else {
            cell.1.contains('.').then_some(false)
        };
        if let (Some(mark), Some(known)) = (mark, self.comma)
            && mark != known
        {
            return Err(
                Fault::new(Code::RecordFormat, "decimal point and decimal comma in the same file")
                    .at(span)
                    .found(cell.1)
                    .allowed("one decimal mark, no thousands separators"),
            );
        }
        self.comma = self.comma.or(mark);
        let parsed = if comma {
            parse(&cell.1.replace(',', "."))
        } else {
            parse(cell.1)
        };
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
