//! Lines with their places, and blocks of numbers in columns of fixed width, as Fortran programs write them: fields may touch.

use files::code::Code;
use std::ops::{Range, RangeInclusive};

use super::draft::Collector;
use super::number::parse;
use crate::input::diagnostic::{Fault, Faults};

/// A line and the byte at which it begins.
pub(super) type Line<'a> = (usize, &'a str);

/// Lines and the byte at which each begins, without their ends.
pub(super) fn lines(text: &str) -> Vec<Line<'_>> {
    let mut start = 0;
    text.split_inclusive('\n')
        .map(|line| {
            let place = start;
            start += line.len();
            (place, line.trim_end_matches(['\n', '\r']))
        })
        .collect()
}

/// Bytes of a line.
pub(super) fn place((start, line): Line<'_>) -> Range<usize> {
    start..start + line.len()
}

/// A line that has to be there.
pub(super) fn line<'a>(lines: &[Line<'a>], number: usize, what: &str) -> Result<Line<'a>, Fault> {
    lines.get(number).copied().ok_or_else(|| {
        let fault =
            Fault::new(Code::CutOff, format!("the file ends before {what}")).found(format!("{} lines", lines.len()));
        at_end(fault, lines).help("the file may have been cut off")
    })
}

/// The fault at the last line that is not empty.
pub(super) fn at_end(fault: Fault, lines: &[Line<'_>]) -> Fault {
    let last = lines.iter().rev().find(|line| !line.1.trim().is_empty());
    match last {
        Some(line) => fault.at(place(*line)),
        None => fault,
    }
}

/// The first `count` numbers of the lines from `first` on, in fields of `width` characters; the values, their places, and the number of
/// the line after the last one.
///
/// * `what`: a number of them, in words
///
/// Errors: fields that are not numbers; lines that end before the last of them.
pub(super) fn fields(
    lines: &[Line<'_>],
    first: usize,
    (count, width): (usize, usize),
    what: &str,
) -> Result<(Vec<f64>, Vec<u32>, usize), Faults> {
    let (mut values, mut places) = (Vec::with_capacity(count.min(1 << 20)), Vec::new());
    let mut faults = Collector::new();
    let mut next = first;
    while values.len() < count {
        let Some(&(start, text)) = lines.get(next) else {
            let message = format!("the file ends before {what} that its header counts");
            let fault = Fault::new(Code::CutOff, message)
                .found(format!("{} of {count} numbers", values.len()))
                .help("the file may have been cut off");
            let fault = at_end(fault, lines);
            // With the faults before it.
            let _ = faults.push(fault);
            return Err(faults.finish().err().unwrap_or_default());
        };
        next += 1;
        let bytes = text.len();
        let mut at = 0;
        while at < bytes && values.len() < count {
            let end = at.saturating_add(width).min(bytes);
            // A field that ends within a character is text, not a number.
            let field = text.get(at..end).unwrap_or("?");
            if field.trim().is_empty() {
                at = end;
                continue;
            }
            let blank = field.len() - field.trim_start().len();
            match parse(field) {
                Ok(value) => {
                    values.push(value);
                    places.push((start + at + blank) as u32);
                }
                Err(why) => {
                    let fault = Fault::new(why.code(), why.message(what)).at(start + at + blank..start + end);
                    if faults.push(fault.found(field.trim())) {
                        return Err(faults.finish().err().unwrap_or_default());
                    }
                    values.push(0.0);
                    places.push((start + at) as u32);
                }
            }
            at = end;
        }
    }
    faults.finish()?;
    Ok((values, places, next))
}

/// The number after a word of a line, such as `.020` in `SPACED AT  .020 SEC`.
pub(super) fn after(line: &str, word: &str) -> Option<f64> {
    let upper = line.to_ascii_uppercase();
    let rest = upper.get(upper.find(word)? + word.len()..)?;
    let token = rest.trim_start_matches([' ', '=', ':', '\t']);
    let end = token.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+'))).unwrap_or(token.len());
    parse(token.get(..end)?.trim_end_matches('.')).ok()
}

/// A whole number of a header within a range.
pub(super) fn whole(value: f64, range: RangeInclusive<usize>) -> Option<usize> {
    (value >= 0.0 && value.fract() == 0.0).then_some(value as usize).filter(|n| range.contains(n))
}

/// Count and width of a Fortran format such as `(8F10.5)`.
pub(super) fn fortran(text: &str) -> Option<(usize, usize)> {
    let upper = text.to_ascii_uppercase();
    let open = upper.rfind('(')?;
    let inner = upper.get(open + 1..)?.split(')').next()?;
    let letter = inner.find(['F', 'E', 'I', 'G'])?;
    let count = inner.get(..letter)?.trim().parse().ok()?;
    let width = inner.get(letter + 1..)?.split('.').next()?.trim().parse().ok()?;
    (count > 0 && width > 0).then_some((count, width))
}
