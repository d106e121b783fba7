//! The lines before the numbers of a table: names of columns, statements of unit and time step.
//!
//! A header names every column, or one of them in words with its unit. A line with `:` or `=` is a statement: `units: m/s2` and `dt = 0.01 s`
//! are taken, every other one (`PGA: 0.25 g`, `Vs30 = 760 m/s`) is metadata and says nothing of the numbers.

use std::ops::Range;

use crate::input::diagnostic::Fault;
use crate::input::records::draft::{choose, printable};
use crate::input::records::head::{Head, head};
use crate::input::records::options::Columns;
use crate::input::records::separator::Separator;
use crate::input::records::unit::{Step, step, with_unit};
use crate::input::records::{AccelerationUnit, ReadOptions};
use files::code::Code;

/// A line before the numbers, without the mark of a comment.
pub(super) struct Title<'a> {
    /// Counted from 1.
    pub number: usize,
    pub start: usize,
    pub text: &'a str,
    pub comment: bool,
}

impl Title<'_> {
    pub(super) fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }
}

/// Where the accelerations stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Values {
    Column(usize),
    /// In every column: values in reading order.
    All,
}

/// Meaning of the columns.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub time: Option<usize>,
    pub values: Values,
    pub columns: usize,
    /// Size of the unit of time [s]; `None` if the header does not name it.
    pub time_unit: Option<f64>,
    pub unit: Option<(AccelerationUnit, String)>,
    pub header: Option<String>,
    /// The column that was chosen of several.
    pub channel: Option<String>,
}

impl Layout {
    /// Without a header.
    pub(super) fn plain(time: Option<usize>, values: Values, columns: usize) -> Layout {
        Layout { time, values, columns, time_unit: None, unit: None, header: None, channel: None }
    }
}

/// What the lines state.
#[derive(Default)]
pub(super) struct Stated {
    pub dt: Option<f64>,
    pub unit: Option<(AccelerationUnit, String)>,
}

/// Key and value of a line such as `dt = 0.01 s`.
fn statement(piece: &str) -> Option<(String, Option<&str>, &str)> {
    let lower = piece.trim_start().to_lowercase();
    if let Some(start) = ["units are ", "the units are ", "units in "].iter().find(|start| lower.starts_with(**start)) {
        return Some(("units".into(), None, piece.trim_start().get(start.len()..)?.trim()));
    }
    let (key, value) = piece.split_once([':', '='])?;
    let (name, unit) = match key.split_once(['(', '[']) {
        Some((name, unit)) => (name, Some(unit.trim_end_matches([')', ']', ' ']))),
        None => (key, None),
    };
    let words: Vec<&str> = name.split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty()).collect();
    Some((words.join(" ").to_lowercase(), unit, value.trim()))
}

const UNIT_KEYS: [&str; 13] = [
    "unit",
    "units",
    "acceleration unit",
    "acceleration units",
    "unit of acceleration",
    "units of acceleration",
    "acc unit",
    "acc units",
    "accel units",
    "data unit",
    "data units",
    "amplitude unit",
    "einheit",
];
const STEP_KEYS: [&str; 11] = [
    "dt",
    "delta",
    "delta t",
    "deltat",
    "time step",
    "timestep",
    "step",
    "sampling interval",
    "sample interval",
    "sampling interval s",
    "time interval",
];
const RATE_KEYS: [&str; 9] = [
    "sampling rate",
    "sample rate",
    "samplerate",
    "samplingrate",
    "sampling frequency",
    "sampling freq",
    "fs",
    "samples per second",
    "rate",
];
const HEADER_KEYS: [&str; 5] = ["columns", "column names", "header", "fields", "data columns"];

/// Unit and time step that the lines state.
///
/// Errors: a unit that is not known, two statements that differ.
pub(super) fn stated(titles: &[Title]) -> Result<Stated, Fault> {
    let mut found = Stated::default();
    for title in titles {
        let pieces: Vec<&str> = title.text.split([',', ';']).collect();
        let apart = title.text.contains('=') || pieces.iter().all(|piece| piece.contains(':'));
        let pieces = if apart { pieces } else { vec![title.text] };
        for piece in pieces {
            let source = || format!("line {} (`{}`)", title.number, printable(title.text));
            let Some((key, key_unit, value)) = statement(piece) else { continue };
            if UNIT_KEYS.contains(&key.as_str()) {
                let unit = unit_of_statement(value).ok_or_else(|| unknown_unit(value).at(title.span()))?;
                match &found.unit {
                    Some((other, _)) if *other != unit => return Err(contradiction("units", title)),
                    _ => found.unit = Some((unit, source())),
                }
            }
            let rate = RATE_KEYS.contains(&key.as_str());
            if rate || STEP_KEYS.contains(&key.as_str()) {
                let dt = stated_step(value, key_unit, rate).map_err(|fault| fault.at(title.span()))?;
                match found.dt {
                    Some(other) if (other - dt).abs() > 1e-6 * dt => return Err(contradiction("time steps", title)),
                    _ => found.dt = Some(dt),
                }
            }
        }
    }
    Ok(found)
}

fn contradiction(what: &str, title: &Title) -> Fault {
    Fault::new(Code::Contradiction, format!("the header states two {what}"))
        .at(title.span())
        .found(printable(title.text))
        .help("correct the header, or skip it with --skip-lines")
}

/// The unit of `units: s, m/s2`.
fn unit_of_statement(value: &str) -> Option<AccelerationUnit> {
    if value.trim().eq_ignore_ascii_case("si") {
        return Some(AccelerationUnit::MetrePerSecondSquared);
    }
    AccelerationUnit::parse(value.trim_end_matches('.')).or_else(|| {
        let mut units = value.split([',', ';', ' ']).filter_map(AccelerationUnit::parse);
        units.next().filter(|_| units.next().is_none())
    })
}

fn stated_step(value: &str, unit: Option<&str>, rate: bool) -> Result<f64, Fault> {
    let found = match (step(value), unit) {
        (Some(Step::Bare(bare)), Some(unit)) => Some(with_unit(bare, unit)),
        (found, _) => found,
    };
    let fault = || Fault::new(Code::TimeStep, "the stated time step cannot be read").found(value);
    let dt = match found {
        Some(Step::Seconds(dt)) => dt,
        Some(Step::Bare(hertz)) if rate => 1.0 / hertz,
        Some(Step::Bare(dt)) => return plain_step(dt),
        Some(Step::Unknown(unit)) => return Err(unknown_time(&unit)),
        None => return Err(fault()),
    };
    if dt.is_finite() && dt > 0.0 { Ok(dt) } else { Err(fault()) }
}

/// Step from which a number without a unit is not read as seconds.
pub(super) const MILLISECONDS: f64 = 0.5;

/// A step without a unit.
///
/// Errors: a step that looks like milliseconds.
pub(super) fn plain_step(dt: f64) -> Result<f64, Fault> {
    match dt > 0.0 && dt < MILLISECONDS {
        true => Ok(dt),
        false => Err(Fault::new(Code::TimeStep, "the time step does not have a unit, and does not look like seconds")
            .found(format!("a step of {dt}"))
            .allowed("steps below 0.5 s without a unit; usual values are 0.002 to 0.02 s")
            .help("give the unit behind the step: SEC, MSEC or HZ")),
    }
}

/// The fault of a unit of time.
pub(super) fn unknown_time(unit: &str) -> Fault {
    Fault::new(Code::RecordUnit, format!("the unit of time `{unit}` is not read"))
        .found(unit)
        .allowed("s, ms, µs, or Hz for a rate")
}

/// The fault of a unit of acceleration.
pub(super) fn unknown_unit(unit: &str) -> Fault {
    Fault::new(Code::RecordUnit, format!("the unit `{}` is not read", printable(unit)))
        .found(printable(unit))
        .allowed(AccelerationUnit::ALLOWED)
        .help("convert the numbers, or correct the unit in the header")
}

/// The layout that the lines and the options name; `None` without a header.
///
/// Errors: a header that contradicts the numbers, several channels without a choice, a unit that is not known.
pub(super) fn layout(
    titles: &[Title],
    separator: Separator,
    columns: usize,
    options: &ReadOptions,
) -> Result<Option<Layout>, Fault> {
    let found = find(titles, separator, columns)?;
    if let Some(Columns::Table { time, acceleration }) = options.columns {
        return chosen(found, columns, (time, acceleration)).map(Some);
    }
    match found {
        None => Ok(None),
        Some((title, cells)) => named(title, &cells, options).map(Some),
    }
}

/// The header line and its cells.
fn find<'t>(
    titles: &'t [Title<'t>],
    separator: Separator,
    columns: usize,
) -> Result<Option<(&'t Title<'t>, Vec<String>)>, Fault> {
    let candidates = || {
        titles.iter().enumerate().rev().filter_map(|(i, title)| {
            let text = match statement(title.text) {
                Some((key, _, value)) if HEADER_KEYS.contains(&key.as_str()) => value,
                Some(_) => return None,
                None => title.text,
            };
            let last = i + 1 == titles.len() && !title.comment;
            Some((title, ways(text, separator), last))
        })
    };
    let heads = |cells: &[String]| cells.iter().map(|c| head(c)).collect::<Vec<_>>();
    // Lines of which every cell names a column go before those of which one does.
    for every in [true, false] {
        for (title, ways, last) in candidates() {
            for cells in &ways {
                let heads = heads(cells);
                let known = heads.iter().all(|h| *h != Head::Unknown);
                let one = heads.iter().zip(cells).any(|(h, cell)| h.is_named(cell));
                if cells.len() != columns {
                    // A header of another table.
                    if every && known && one && cells.len() > 1 {
                        return Err(Fault::new(Code::RecordFormat, "the header does not match the numbers")
                            .at(title.span())
                            .found(printable(title.text))
                            .allowed(format!("{columns} name(s), as there are {columns} column(s) of numbers")));
                    }
                    continue;
                }
                let alone = columns > 1 || last || is_column(&cells[0], &heads[0]);
                if alone && (if every { known } else { one }) {
                    return Ok(Some((title, cells.clone())));
                }
            }
        }
    }
    Ok(None)
}

/// Whether a comment names the only column, and not a fact with a unit.
fn is_column(cell: &str, head: &Head) -> bool {
    match head {
        Head::OtherMotion => Head::is_motion(cell),
        Head::Time(_) | Head::Unknown | Head::Component(None) | Head::Acceleration(None) => false,
        Head::Component(Some(_)) => true,
        Head::Acceleration(Some(_)) => Head::is_acceleration(cell) || AccelerationUnit::parse(cell).is_some(),
        // A word behind the name of a comment may be anything.
        Head::UnknownUnit(_) => Head::is_acceleration(cell) && cell.contains(['(', '[', '_', '/', '^', '²', '%']),
    }
}

/// The ways to cut a header line into cells: like the numbers, then like any other table.
fn ways(line: &str, separator: Separator) -> Vec<Vec<String>> {
    let mut ways = Vec::new();
    for way in [separator, Separator::Semicolon, Separator::Tab, Separator::Comma] {
        if way != Separator::Spaces {
            ways.push(way.cells(line).iter().map(|c| c.1.to_string()).collect::<Vec<_>>());
        }
    }
    // Words; a word that begins with a bracket, and one within it, belongs to the one before.
    let mut words: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match words.last_mut() {
            Some(last) if word.starts_with(['[', '(']) => last.push_str(word),
            Some(last) if last.contains(['[', '(']) && !last.contains([']', ')']) => {
                last.push(' ');
                last.push_str(word);
            }
            _ => words.push(word.to_string()),
        }
    }
    let closed = line.split_inclusive([')', ']']).map(|c| c.trim().to_string()).filter(|c| !c.is_empty()).collect();
    ways.insert(usize::from(separator != Separator::Spaces) * ways.len(), words);
    ways.push(closed);
    // The whole line is the last way but for a single column, of which it is the name.
    ways.sort_by_key(|cells| cells.len() == 1);
    ways
}

/// Unit of a column, with its source in words.
fn unit_of(title: &Title, cells: &[String], column: usize) -> Option<(AccelerationUnit, String)> {
    match head(cells.get(column)?) {
        Head::Acceleration(Some(unit)) | Head::Component(Some(unit)) => Some((
            unit,
            format!("header, line {}, column {} (`{}`)", title.number, column + 1, printable(&cells[column])),
        )),
        _ => None,
    }
}

/// The layout that a header names.
fn named(title: &Title, cells: &[String], options: &ReadOptions) -> Result<Layout, Fault> {
    let fault = |code: Code, what: &str| Fault::new(code, what).at(title.span()).found(printable(title.text));
    let heads: Vec<Head> = cells.iter().map(|c| head(c)).collect();
    let those = |which: fn(&Head) -> bool| -> Vec<usize> { (0..heads.len()).filter(|i| which(&heads[*i])).collect() };
    if let Some(Head::UnknownUnit(unit)) = heads.iter().find(|h| matches!(h, Head::UnknownUnit(_))) {
        return Err(unknown_unit(unit)
            .at(title.span())
            .allowed(format!("of time: s, ms; of acceleration: {}", AccelerationUnit::ALLOWED)));
    }
    let times = those(|h| matches!(h, Head::Time(_)));
    if times.len() > 1 {
        return Err(fault(Code::RecordFormat, "two columns have the name of the time")
            .allowed("one column of time")
            .help("--columns with the numbers of the columns of time and acceleration, such as --columns 1,3"));
    }
    let mut candidates = those(|h| matches!(h, Head::Acceleration(_) | Head::Component(_)));
    if candidates.is_empty() {
        candidates = those(|h| matches!(h, Head::Unknown));
        candidates.retain(|i| !cells[*i].is_empty());
    }
    if candidates.is_empty() {
        return Err(match cells.len() {
            1 if !times.is_empty() => {
                fault(Code::NotAcceleration, "the only column is the time").allowed("accelerations")
            }
            _ => fault(Code::NotAcceleration, "a column is neither time nor acceleration")
                .allowed("acceleration against time; velocities and displacements are not read"),
        });
    }
    let names: Vec<String> = candidates.iter().map(|i| printable(&cells[*i])).collect();
    let choice = choose(&names, options).map_err(|f| f.at(title.span()))?;
    let column = candidates[choice];
    Ok(Layout {
        time_unit: times.first().and_then(|t| match heads[*t] {
            Head::Time(unit) => unit,
            _ => None,
        }),
        unit: unit_of(title, cells, column),
        header: Some(printable(title.text)),
        channel: (names.len() > 1).then(|| names[choice].clone()),
        ..Layout::plain(times.first().copied(), Values::Column(column), cells.len())
    })
}

/// The layout of `--columns`.
fn chosen(
    found: Option<(&Title, Vec<String>)>,
    columns: usize,
    (time, acceleration): (Option<usize>, usize),
) -> Result<Layout, Fault> {
    if let Some(beyond) = [Some(acceleration), time].into_iter().flatten().find(|c| *c >= columns) {
        return Err(Fault::new(Code::OptionValue, "--columns names a column that is not there")
            .found(format!("column {} of {columns}", beyond + 1))
            .allowed(format!("1 to {columns}")));
    }
    let plain = Layout::plain(time, Values::Column(acceleration), columns);
    let Some((title, cells)) = found else { return Ok(plain) };
    let of_time = time.and_then(|t| cells.get(t)).map_or(Head::Unknown, |cell| head(cell));
    match (head(&cells[acceleration]), of_time) {
        (Head::UnknownUnit(unit), _) | (_, Head::UnknownUnit(unit)) => Err(unknown_unit(&unit).at(title.span())),
        (Head::Time(_) | Head::OtherMotion, _) => {
            Err(Fault::new(Code::NotAcceleration, "--columns names a column that is not an acceleration")
                .at(title.span())
                .found(printable(&cells[acceleration])))
        }
        (_, of_time) => Ok(Layout {
            time_unit: match of_time {
                Head::Time(unit) => unit,
                _ => None,
            },
            unit: unit_of(title, &cells, acceleration),
            header: Some(printable(title.text)),
            ..plain
        }),
    }
}
