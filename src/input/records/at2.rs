//! PEER `.AT2`: a header of text lines, then accelerations in reading order, several to a line.
//!
//! ```text
//! PEER NGA STRONG MOTION DATABASE RECORD
//! Imperial Valley-02, 5/19/1940, El Centro Array #9, 180
//! ACCELERATION TIME SERIES IN UNITS OF G
//! NPTS=   5372, DT=   .0100 SEC,
//!    .9984852E-03   .9991426E-03   …
//! ```
//!
//! The line with `NPTS` ends the header, if numbers follow that are not a table of times; before NGA it was also written `5372 .0100 NPTS, DT`.
//! `DT` may be followed by its unit: `.0100SEC`, `5.0 MSEC`, `200 HZ`. The unit of acceleration follows the word `UNITS`, or `IN` after the
//! word acceleration. `HP` of `FILTER POINTS` is the corner of the low-cut filter. The last line may be partial. NPTS must equal the number of
//! values, so that truncated files are rejected.

use crate::input::diagnostic::{Fault, Faults};
use crate::input::records::block::lines;
use crate::input::records::draft::{Collector, Draft, printable, settle_dt, settle_unit};
use crate::input::records::filter::corner;
use crate::input::records::header::{plain_step, unknown_time, unknown_unit};
use crate::input::records::number::{parse, split_glued};
use crate::input::records::separator::Separator;
use crate::input::records::unit::{Step, step, with_unit};
use crate::input::records::{AccelerationUnit, MAX_SAMPLES, ReadOptions};
use files::code::Code;

/// The header ends within this many lines.
const HEADER_LINES: usize = 30;

/// Whether one of the first lines is the line with NPTS, and the samples follow it.
pub fn sniff(text: &str) -> bool {
    header_end(text).is_some()
}

/// Number (from 0) of the line with NPTS.
fn header_end(text: &str) -> Option<usize> {
    let place = text.lines().take(HEADER_LINES).position(|line| {
        let named = line.to_ascii_uppercase().contains("NPTS") && line.contains(|c: char| c.is_ascii_digit());
        named && !line.trim_start().starts_with(['#', '%', '!', '/', ';', '|'])
    })?;
    let mut after = text.lines().skip(place + 1).filter(|line| !line.trim().is_empty());
    let numbers = |line: Option<&str>| -> Option<Vec<f64>> {
        Separator::Spaces.cells(line?).iter().map(|(_, cell)| parse(cell).ok()).collect()
    };
    let first = after.next();
    // Times beside the accelerations: a table under a header of words.
    let table = match (numbers(first), numbers(after.next())) {
        (Some(one), Some(two)) => one.len() == 2 && two.len() == 2 && two[0] > one[0] && one[0] >= 0.0,
        _ => false,
    };
    let words = first.is_some_and(|line| {
        numbers(Some(line)).is_none() && line.contains(|c: char| c.is_ascii_alphabetic() && !"eEdDnN".contains(c))
    });
    (!table && !words).then_some(place)
}

/// Reads the text; call [`sniff`] before.
pub(super) fn read(text: &str, options: &ReadOptions) -> Result<Draft, Faults> {
    let lines = lines(text);
    let last = header_end(text).unwrap_or(0);
    let header = &lines[..(last + 1).min(lines.len())];
    let (start, line) = header.last().copied().unwrap_or((0, ""));
    let at = |fault: Fault| fault.at(start..start + line.len());
    let (samples, leading) = counts(line).map_err(at)?;
    let dt = match header.iter().rev().find_map(|(_, line)| dt_of(line)).or(leading.map(Step::Bare)) {
        None => None,
        Some(Step::Seconds(dt)) => Some(dt),
        Some(Step::Bare(dt)) if dt <= 0.0 => Some(dt),
        Some(Step::Bare(dt)) => Some(plain_step(dt).map_err(at)?),
        Some(Step::Unknown(unit)) => return Err(at(unknown_time(&unit)).into()),
    };
    if dt.is_some_and(|dt| !(dt > 0.0 && dt.is_finite())) {
        return Err(at(Fault::new(Code::TimeStep, "DT must be greater than 0").found(line.trim())).into());
    }
    let dt = settle_dt(dt, options)?.ok_or_else(|| {
        at(Fault::new(Code::TimeStep, "the header does not give a time step"))
            .allowed("`NPTS= 4000, DT= .01000 SEC`, or --dt")
    })?;
    acceleration(header)?;
    let (unit, unit_source) = settle_unit(unit_of(header)?, options, "a header line such as `IN UNITS OF G`")?;
    let (values, places) = values(&lines[header.len()..], samples, text)?;
    Ok(Draft {
        title: title(header),
        format: format!("PEER .AT2 (NPTS = {samples}, DT = {dt} s)"),
        unit,
        unit_source,
        dt,
        values,
        places,
        channel: None,
        notes: Vec::new(),
        low_cut: header.iter().find_map(|(_, line)| corner(line)),
    })
}

/// The step behind the word DT of a line: `DT= .0100 SEC`, `DT(MS)=5`.
fn dt_of(line: &str) -> Option<Step> {
    let upper = line.to_ascii_uppercase();
    let alone = |at: &usize| {
        let (before, after) = (upper[..*at].chars().next_back(), upper[at + 2..].chars().next());
        !before.is_some_and(char::is_alphanumeric) && !after.is_some_and(char::is_alphabetic)
    };
    let at = upper.match_indices("DT").map(|(at, _)| at).find(alone)?;
    let rest = upper.get(at + 2..)?.trim_start();
    let bracketed = rest.strip_prefix(['(', '[']).and_then(|rest| rest.split_once([')', ']']));
    let (unit, rest) = bracketed.map_or((None, rest), |(unit, rest)| (Some(unit), rest));
    match (step(rest.trim_start_matches([' ', '=', ':', '\t'])), unit) {
        (Some(Step::Bare(value)), Some(unit)) => Some(with_unit(value, unit.trim())),
        (found, _) => found,
    }
}

/// NPTS of the line that names it, and the step that may follow a count in front of the word.
fn counts(line: &str) -> Result<(usize, Option<f64>), Fault> {
    let upper = line.to_ascii_uppercase();
    let behind = upper.split_once("NPTS").and_then(|(_, rest)| {
        let rest = rest.trim_start_matches([' ', '=', ':', '\t']);
        parse(rest.split([' ', ',', ';', '\t']).next()?).ok()
    });
    let mut leading = upper.split([' ', ',', ';', '\t']).filter(|t| !t.is_empty()).map_while(|t| parse(t).ok());
    let (npts, dt) = match behind {
        Some(npts) => (Some(npts), None),
        None => (leading.next(), leading.next()),
    };
    let shape = "`NPTS= 4000, DT= .01000 SEC` or `4000 .01000 NPTS, DT`";
    let fault = |code: Code, what: &str| Fault::new(code, what).found(line.trim()).allowed(shape);
    let npts =
        npts.ok_or_else(|| fault(Code::RecordLength, "the line with NPTS does not contain the number of points"))?;
    if npts.fract() != 0.0 || npts < 2.0 {
        return Err(fault(Code::RecordLength, "NPTS must be a whole number of at least 2"));
    }
    if npts > MAX_SAMPLES as f64 {
        return Err(fault(Code::TooLarge, "the record is too long").allowed(format!("up to {MAX_SAMPLES} samples")));
    }
    Ok((npts as usize, dt))
}

/// Rejects the companions of `.AT2`: `.VT2` (velocity) and `.DT2` (displacement).
fn acceleration(header: &[(usize, &str)]) -> Result<(), Fault> {
    for &(start, line) in header {
        let upper = line.to_ascii_uppercase();
        let series = upper.contains("TIME SERIES") || upper.contains("TIME HISTORY");
        if series && !upper.contains("ACC") && (upper.contains("VELOCITY") || upper.contains("DISPLACEMENT")) {
            return Err(Fault::new(Code::NotAcceleration, "this is not an acceleration record")
                .at(start..start + line.len())
                .found(line.trim())
                .allowed("an acceleration time series (.AT2)"));
        }
    }
    Ok(())
}

/// The unit after the word UNITS, or after IN or a bracket of a line on accelerations, with its source in words.
///
/// Errors: a unit that is not known.
fn unit_of(header: &[(usize, &str)]) -> Result<Option<(AccelerationUnit, String)>, Fault> {
    for (i, (start, line)) in header.iter().enumerate() {
        let upper = line.to_ascii_uppercase();
        let behind = |word: &str| upper.get(upper.find(word)? + word.len()..);
        let said = match (behind("UNITS").or_else(|| behind("UNIT ")), upper.contains("ACC")) {
            (Some(rest), _) => Some(rest),
            (None, true) => behind(" IN ").or_else(|| behind("(")).or_else(|| behind("[")),
            (None, false) => None,
        };
        let Some(mut rest) = said else { continue };
        while let Some(shorter) =
            ["OF ", "ARE ", "IS ", "IN ", " ", "=", ":", "(", "[", "\t"].iter().find_map(|word| rest.strip_prefix(word))
        {
            rest = shorter;
        }
        let words: Vec<&str> = rest.split([',', ';', ')', ']']).next().unwrap_or("").split_whitespace().collect();
        let unit = (1..=words.len().min(3)).rev().find_map(|n| AccelerationUnit::parse(&words[..n].join(" ")));
        match (unit, words.first()) {
            (Some(unit), _) => return Ok(Some((unit, format!("header, line {} (`{}`)", i + 1, printable(line))))),
            (None, Some(word)) => return Err(unknown_unit(word).at(*start..start + line.len())),
            (None, None) => {}
        }
    }
    Ok(None)
}

/// Event, station and component: the second line of a PEER header.
fn title(header: &[(usize, &str)]) -> Option<String> {
    let peer = header.first()?.1.trim_start().to_ascii_uppercase().starts_with("PEER");
    let title = printable(header.get(1)?.1);
    (peer && header.len() >= 4 && !title.is_empty()).then_some(title)
}

/// All values after the header; their number must be `expected`.
fn values(lines: &[(usize, &str)], expected: usize, text: &str) -> Result<(Vec<f64>, Vec<u32>), Faults> {
    let (mut values, mut places) = (Vec::new(), Vec::new());
    let mut faults = Collector::new();
    let mut surplus = None;
    'file: for &(start, line) in lines {
        // Words after a complete record are a trailer; a further number contradicts NPTS.
        if values.len() == expected && faults.is_empty() && !line.contains(|c: char| c.is_ascii_digit()) {
            continue;
        }
        for (offset, token) in words(line) {
            for (inner, number) in split_glued(token) {
                let place = start + offset + inner;
                match parse(number) {
                    Ok(value) if values.len() < expected => {
                        values.push(value);
                        places.push(u32::try_from(place).unwrap_or(u32::MAX));
                    }
                    Ok(_) => {
                        surplus = Some(place..place + number.len());
                        break 'file;
                    }
                    Err(wrong) => {
                        let fault = Fault::new(wrong.code(), wrong.message("the acceleration"))
                            .at(place..place + number.len())
                            .found(number)
                            .allowed("finite numbers such as -.123E-01");
                        if faults.push(fault) {
                            break 'file;
                        }
                    }
                }
            }
        }
    }
    faults.finish()?;
    if let Some(span) = surplus {
        return Err(Fault::new(Code::RecordLength, "the file contains more values than NPTS")
            .at(span)
            .found(format!("a value after the {expected} of NPTS"))
            .help("correct NPTS, or delete the lines after the record")
            .into());
    }
    if values.len() < expected {
        return Err(Fault::new(Code::CutOff, "the file ends before NPTS values were read")
            .at(text.trim_end().len()..text.trim_end().len())
            .found(format!("{} values, NPTS = {expected}", values.len()))
            .help("complete the file, or correct NPTS")
            .into());
    }
    Ok((values, places))
}

/// Words of a line and where they begin.
fn words(line: &str) -> impl Iterator<Item = (usize, &str)> {
    line.split([' ', '\t', '\u{c}', '\r'])
        .filter(|w| !w.is_empty())
        .map(move |word| (word.as_ptr() as usize - line.as_ptr() as usize, word))
}
